-- | Locating by the memory table.
module Test.Code.Locate (spec) where

import Control.Monad (forM_)
import Data.List (nub, sort)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Locate
import PraTactile.Polynomial
import PraTactile.Window
import Test.Code.Generators
import Test.Hspec
import Test.QuickCheck hiding (elements)

spec :: Spec
spec = do
  describe "every window is found where it stands" $ do
    it "on the paper's torus, by 2 x 2 windows, under both packings" $
      forM_ [minBound .. maxBound] $ \packing -> do
        array <- paperArray
        m <- right (rectangle (Shape 2 2))
        table <- right (buildTable packing Torus array m)
        forM_ (positions (Shape 15 17)) $ \p -> do
          content <- maybe (fail "no window") pure (windowAt Torus array m p)
          tableLookup table (pack packing 4 (map toCode content)) `shouldBe` [p]
          locateRows table (rowsOf 2 (map Just content)) `shouldBe` Right (Unique p [Position 0 0])
    it "on its sheet, where the 31 windows that straddle the edges are absent" $ do
      array <- paperArray
      m <- right (rectangle (Shape 2 2))
      table <- right (buildTable MostSignificantFirst Sheet array m)
      forM_ (positions (Shape 15 17)) $ \p -> do
        content <- maybe (fail "no window") pure (windowAt Torus array m p)
        let onSheet = row p < 14 && column p < 16
        locateRows table (rowsOf 2 (map Just content))
          `shouldBe` Right (if onSheet then Unique p [Position 0 0] else Refused NotInArray)
      length (tableEntries table) `shouldBe` 224
    it "on 63 x 65 by 3 x 2 windows" $ do
      h <- right (firstPrimitive 6 :: Either PolynomialError (Primitive GF4))
      array <- right (folded Diagonal (Shape 63 65) h)
      m <- right (rectangle (Shape 3 2))
      everyWindowFound Torus array m
    it "on the twisted torus, 15 x 273 row by row, by 2 x 3 windows" $ do
      h <- right (firstPrimitive 6 :: Either PolynomialError (Primitive GF4))
      array <- right (folded RowMajor (Shape 15 273) h)
      m <- right (rectangle (Shape 2 3))
      everyWindowFound TwistedTorus array m
    it "over GF(3), GF(5), GF(9) and GF(16)" $
      forM_ [(3, 1, 3), (5, 1, 3), (9, 1, 3), (16, 1, 2)] $ \(q, k1, k2) ->
        forM_ (lookup q everyField) $ \(SomeField k) -> do
          h <- firstOver k (k1 * k2)
          let n1 = fromIntegral q ^ k1 - 1
          array <- right (folded Diagonal (Shape n1 ((fromIntegral q ^ (k1 * k2) - 1) `div` n1)) h)
          m <- right (rectangle (Shape k1 k2))
          everyWindowFound Torus array m
  describe "patches larger than the window" $ do
    it "of 2 x 3 to 4 x 5 cells are found everywhere on the torus, all their windows agreeing" $ do
      array <- paperArray
      table <- paperTable Torus
      forM_ [(2, 3), (3, 2), (3, 3), (4, 5)] $ \(h, w) -> do
        m <- right (rectangle (Shape h w))
        forM_ (positions (Shape 15 17)) $ \p -> do
          content <- maybe (fail "no window") pure (windowAt Torus array m p)
          locateRows table (rowsOf (fromIntegral w) (map Just content))
            `shouldBe` Right (Unique p [Position i j | i <- [0 .. h - 2], j <- [0 .. w - 2]])
    it
      "with an error in any one of 2 x 3 or 3 x 2 cells contradict themselves: the minimum \
      \distance is 2"
      $ do
        array <- paperArray
        table <- paperTable Torus
        forM_ [(2, 3), (3, 2)] $ \(h, w) -> do
          m <- right (rectangle (Shape h w))
          forM_ (positions (Shape 15 17)) $ \p -> do
            content <- maybe (fail "no window") pure (windowAt Torus array m p)
            forM_ (oneError content) $ \wrong ->
              locateRows table (rowsOf (fromIntegral w) (map Just wrong))
                `shouldSatisfy` (`elem` [Right (Refused Contradiction)])
    it "are answered by their upper left cell, observed or not" $ do
      table <- paperTable Torus
      -- The window of the worked example is at (6, 5); here it is preceded by an unobserved row and
      -- column.
      locateText table ["? ? ?", "? 3 2", "? 3 1"]
        `shouldBe` Right (Unique (Position 5 4) [Position 1 1])
      locateText table ["? 3 2", "? 3 1"] `shouldBe` Right (Unique (Position 6 4) [Position 0 1])
    it "must agree in observed cells outside complete windows, too" $ do
      array <- paperArray
      table <- paperTable Torus
      let next = cellAt array (Position 6 7)
          text a = ["3 2 " ++ show (toCode a), "3 1 ?"]
      locateText table (text next) `shouldBe` Right (Unique (Position 6 5) [Position 0 0])
      forM_ [a | a <- elements, a /= next] $ \a ->
        locateText table (text a) `shouldBe` Right (Refused Contradiction)
  describe "refusals" $ do
    it "zero-window: all complete windows are zero" $ do
      table <- paperTable Torus
      locateText table ["0 0", "0 0"] `shouldBe` Right (Refused ZeroWindow)
      locateText table ["0 0 0", "0 0 0", "0 0 0"] `shouldBe` Right (Refused ZeroWindow)
    it "too-few-cells: no observed cell" $ do
      table <- paperTable Torus
      forM_ [["?"], ["? ?", "? ?"]] $ \cells ->
        locateText table cells `shouldBe` Right (Refused TooFewCells)
    it "no-complete-window: cells, but not those of a window" $ do
      table <- paperTable Torus
      forM_
        [ ["1"],
          ["1 2 3"],
          ["1 2", "3 ?"],
          ["1 ? ?", "? 2 ?", "? ? 3"],
          ["1 2 3 1"],
          ["1", "2", "3", "1", "0"],
          ["1 ? 1", "? 2 ?", "1 ? 3"],
          ["3 2 ?", "? ? 3", "1 2 ?"]
        ]
        $ \cells ->
          locateText table cells `shouldBe` Right (Refused NoCompleteWindow)
    it "contradiction: windows that lie apart" $ do
      table <- paperTable Torus
      locateText table ["3 2 3 2", "3 1 3 1"] `shouldBe` Right (Refused Contradiction)
      locateText table ["3 2 ? 0 0", "3 1 ? 0 0"] `shouldBe` Right (Refused Contradiction)
    it "not-in-array: a window that does not stand on the sheet" $ do
      array <- paperArray
      table <- paperTable Sheet
      let cell r c = toCode (cellAt array (Position r c))
      locateText
        table
        [unwords (map show [cell 14 3, cell 14 4]), unwords (map show [cell 15 3, cell 15 4])]
        `shouldBe` Right (Refused NotInArray)
    it "off-sheet: windows on the sheet in a patch that sticks out of it, on any side" $ do
      array <- paperArray
      table <- paperTable Sheet
      torus <- paperTable Torus
      let cells r c h w =
            [ unwords [show (toCode (cellAt array (Position (r + i) (c + j)))) | j <- [0 .. w - 1]]
              | i <- [0 .. h - 1]
            ]
      -- Rows 13, 14 and, on the torus, 0; rows 14, 0, 1; columns likewise.
      forM_ [(13, 4, 3, 2), (14, 4, 3, 2), (4, 15, 2, 3), (4, 16, 2, 3)] $ \(r, c, h, w) -> do
        fmap place (locateText torus (cells r c h w)) `shouldBe` Right [Position r c]
        locateText table (cells r c h w) `shouldBe` Right (Refused OffSheet)
      -- Nothing observed beyond the lower edge, or the upper left beyond the upper one.
      fmap place (locateText table (cells 13 4 2 2 ++ ["? ?"])) `shouldBe` Right [Position 13 4]
      locateText table ("? ?" : cells 0 4 2 2) `shouldBe` Right (Refused OffSheet)
      fmap place (locateText torus ("? ?" : cells 0 4 2 2)) `shouldBe` Right [Position 14 4]
    it "the names on the wire" $
      [(r, reasonName r) | r <- reasons]
        `shouldBe` [ (ZeroWindow, "zero-window"),
                     (TooFewCells, "too-few-cells"),
                     (NoCompleteWindow, "no-complete-window"),
                     (NotInArray, "not-in-array"),
                     (Contradiction, "contradiction"),
                     (OffSheet, "off-sheet"),
                     (BeyondRadius, "beyond-radius"),
                     (BelowThreshold, "below-threshold")
                   ]
    it "patches without cells or with ragged rows are none" $ do
      noPatch [] `shouldBe` Left PatchEmpty
      noPatch [[], []] `shouldBe` Left PatchEmpty
      noPatch [[Just 1, Nothing], [Just 1]] `shouldBe` Left (PatchRagged 1 1 2)
    it "tables larger than 2^26 entries are none" $ do
      array <- paperArray
      m <- right (rectangle (Shape 2 7))
      (() <$ buildTable MostSignificantFirst Torus array m)
        `shouldBe` Left (TableTooLarge (4 ^ (14 :: Int)) largestTable)
      h <- right (firstPrimitive 14 :: Either PolynomialError (Primitive GF4))
      large <- right (folded RowMajor (Shape 5 (4 ^ (14 :: Int) `div` 5)) h)
      small <- right (rectangle (Shape 2 2))
      (() <$ buildTable MostSignificantFirst Torus large small)
        `shouldBe` Left (TableTooLarge (4 ^ (14 :: Int) - 1) largestTable)
  describe "windows that repeat" $ do
    it "are ambiguous, with all their positions; a second window may decide" $ do
      array <- paperArray
      m <- right (rectangle (Shape 1 2))
      table <- right (buildTable MostSignificantFirst Torus array m)
      case locateText table ["3 2"] of
        Right (Ambiguous places support) -> do
          places
            `shouldBe` [ p
                         | p@(Position r c) <- positions (Shape 15 17),
                           map (toCode . cellAt array) [p, Position r (c + 1)] == [3, 2]
                       ]
          support `shouldBe` [Position 0 0]
          length places `shouldBe` 16
        other -> expectationFailure (show other)
      locateText table ["3 2", "3 1"]
        `shouldBe` Right (Unique (Position 6 5) [Position 0 0, Position 1 0])
    it
      "every entry of the table has all positions of its window, and all positions are in the table"
      $ do
        array <- paperArray
        m <- right (mask [(0, 0), (2, 3)])
        table <- right (buildTable MostSignificantFirst Torus array m)
        sort (concatMap snd (tableEntries table)) `shouldBe` positions (Shape 15 17)
        forM_ (tableEntries table) $ \(packed, places) -> forM_ places $ \p ->
          fmap (pack MostSignificantFirst 4 . map toCode) (windowAt Torus array m p)
            `shouldBe` Just packed
        tableLookup table 16 `shouldBe` []
        tableSize table `shouldBe` 16
  describe "any patch" $
    it "is answered as comparing it with every place answers it" $ do
      array <- paperArray
      forM_ [Torus, Sheet] $ \on -> do
        table <- paperTable on
        result <- quickCheckWithResult stdArgs {chatty = False, maxSuccess = 2000} $
          forAllShrink (genPatch array) shrinkPatch $ \cells -> asByComparing array on table cells
        case result of
          Success {} -> pure ()
          _ -> expectationFailure (output result)

type Cells = [[Maybe (GF GF4)]]

paperArray :: IO (PseudorandomArray GF4)
paperArray = right paperPrimitive >>= right . folded Diagonal (Shape 15 17)

paperTable :: Surface -> IO (Table GF4)
paperTable on = do
  array <- paperArray
  m <- right (rectangle (Shape 2 2))
  right (buildTable MostSignificantFirst on array m)

positions :: Shape -> [Position]
positions (Shape h w) = [Position r c | r <- [0 .. h - 1], c <- [0 .. w - 1]]

place :: Outcome Position -> [Position]
place (Unique p _) = [p]
place _ = []

rowsOf :: Int -> [a] -> [[a]]
rowsOf w cells = case splitAt w cells of
  ([], _) -> []
  (r, rest) -> r : rowsOf w rest

locateRows :: Table k -> [[Maybe (GF k)]] -> Either LocateError (Outcome Position)
locateRows table cells = locatePatch table <$> patch cells

-- | Rows of codes and question marks.
locateText :: KnownField k => Table k -> [String] -> Either LocateError (Outcome Position)
locateText table = locateRows table . map (map cell . words)
  where
    cell "?" = Nothing
    cell text = either (const Nothing) Just (parseElement text)

noPatch :: Cells -> Either LocateError ()
noPatch cells = () <$ patch cells

everyWindowFound :: KnownField k => Surface -> PseudorandomArray k -> Mask -> Expectation
everyWindowFound on array m = do
  table <- right (buildTable MostSignificantFirst on array m)
  let found p = do
        content <- windowAt on array m p
        pure (locateRows table (rowsOf (fromIntegral (columns (maskExtent m))) (map Just content)))
  [p | p <- positions (arrayShape array), found p /= Just (Right (Unique p [Position 0 0]))]
    `shouldBe` []

oneError :: KnownField k => [GF k] -> [[GF k]]
oneError content =
  [ take i content ++ [b] ++ drop (i + 1) content
    | (i, a) <- zip [0 ..] content,
      b <- elements,
      a /= b
  ]

-- | A patch of the array with unobserved cells, often with an error, sometimes across the edges.
genPatch :: PseudorandomArray GF4 -> Gen Cells
genPatch array = do
  h <- choose (1, 5) :: Gen Natural'
  w <- choose (1, 5) :: Gen Natural'
  r <- choose (0, 14) :: Gen Natural'
  c <- choose (0, 16) :: Gen Natural'
  errors <- frequency [(3, pure 0), (2, pure 8), (1, pure 60)] :: Gen Int
  unobserved <- elements' [0, 10, 30, 60] :: Gen Int
  mapM
    (mapM (observe errors unobserved))
    [ [cellAt array (Position (fromInteger (r + i)) (fromInteger (c + j))) | j <- [0 .. w - 1]]
      | i <- [0 .. h - 1]
    ]
  where
    elements' = oneof . map pure
    observe errors unobserved a = do
      wrong <- (< errors) <$> choose (0, 99)
      gone <- (< unobserved) <$> choose (0, 99)
      b <- if wrong then genElement else pure a
      pure (if gone then Nothing else Just b)

type Natural' = Integer

-- | Fewer rows, fewer columns, fewer observed cells.
shrinkPatch :: Cells -> [Cells]
shrinkPatch cells =
  [ fewer
    | fewer <-
        [ drop 1 cells,
          take (length cells - 1) cells,
          map (drop 1) cells,
          map (\r -> take (length r - 1) r) cells
        ],
      not (all null fewer)
  ]
    ++ [ [ [if (i, j) == (i0, j0) then Nothing else a | (j, a) <- zip [0 ..] r]
           | (i, r) <- zip [0 :: Int ..] cells
         ]
         | (i0, r0) <- zip [0 ..] cells,
           (j0, Just _) <- zip [0 :: Int ..] r0
       ]

-- | Compare every observed cell at every place; then the outcome must be what this says. On the
-- sheet, places beyond its edges are tried, too: the patch sticks out where all that lies on the
-- sheet agrees, every window that stands on the sheet among it.
asByComparing :: PseudorandomArray GF4 -> Surface -> Table GF4 -> Cells -> Property
asByComparing array on table cells =
  counterexample (show (outcome, fitting)) $ case outcome of
    Right (Unique p support) -> fitting === [p] .&&. support === offsets
    Right (Refused TooFewCells) -> property (null observed)
    Right (Refused NoCompleteWindow) -> property (null offsets && not (null observed))
    Right (Refused ZeroWindow) ->
      property (not (null offsets) && all (all (== 0)) contents) .&&. fitting === []
    Right (Refused NotInArray) ->
      property (not (null offsets) && all absent contents && any (any (/= 0)) contents)
        .&&. fitting === []
    Right (Refused OffSheet) -> on === Sheet .&&. fitting === [] .&&. length stickingOut === 1
    Right (Refused Contradiction) ->
      property (not (null offsets) && not (all absent contents))
        .&&. fitting === []
        .&&. stickingOut === []
    Right _ -> property False
    Left _ -> property False
  where
    outcome = locateRows table cells
    observed = [(i, j, a) | (i, r) <- zip [0 ..] cells, (j, Just a) <- zip [0 ..] r]
    at i j = [a | (i', j', a) <- observed, (i', j') == (i, j)]
    windows =
      [ (Position i j, content)
        | i <- [0 .. 4],
          j <- [0 .. 4],
          content <- [at i j ++ at i (j + 1) ++ at (i + 1) j ++ at (i + 1) (j + 1)],
          length content == 4
      ]
    offsets = map fst windows
    contents = map snd windows
    fits (Position r c) = and [cellAt array (Position (r + i) (c + j)) == a | (i, j, a) <- observed]
    fitting =
      [ p
        | p@(Position r c) <- positions (Shape 15 17),
          on /= Sheet || and [r + i < 15 && c + j < 17 | (i, j, _) <- observed],
          fits p
      ]
    onSheet r c = 0 <= r && r < 15 && 0 <= c && c < (17 :: Integer)
    stickingOut =
      [ (r, c)
        | on == Sheet,
          r <- [-5 .. 14],
          c <- [-5 .. 16],
          let shifted (i, j) = (r + toInteger i, c + toInteger j)
              onIt cell = uncurry onSheet (shifted cell),
          not (onSheet r c) || or [not (onIt (i, j)) | (i, j, _) <- observed],
          and
            [cellAt array (uncurry at' (shifted (i, j))) == a | (i, j, a) <- observed, onIt (i, j)],
          let present = [o | (o, content) <- windows, not (absent content)],
          not (null present),
          and [onIt (i, j) && onIt (i + 1, j + 1) | Position i j <- present]
      ]
    at' r c = Position (fromInteger r) (fromInteger c)
    standing =
      nub
        [ [cellAt array (Position (r + i) (c + j)) | i <- [0, 1], j <- [0, 1]]
          | Position r c <- positions (Shape 15 17),
            on /= Sheet || (r < 14 && c < 16)
        ]
    absent content = content `notElem` standing
