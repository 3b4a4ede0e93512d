-- | Locating by the memory table.
module Test.Code.Locate.ByMemoryTable (spec) where

import Control.Monad (forM_)
import Data.List (sort)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Locate
import PraTactile.Window
import Test.Code.Generators
import Test.Code.Locate.Reasons
import Test.Hspec
import Test.Paper
import Test.QuickCheck hiding (elements)

spec :: Spec
spec = do
  describe "every window is found where it stands" everyWindowSpec
  describe "patches larger than the window" largerSpec
  describe "refusals" refusalSpec
  describe "windows that repeat" repeatSpec
  describe "any patch" $
    it "is answered as comparing it with every place answers it" $ do
      array <- paperArray
      forM_ [Torus, Sheet] $ \on -> do
        table <- paperTable on
        holds 2000 $ forAllShrink (genPatch array) shrinkPatch $ asByComparing array on table

everyWindowSpec :: Spec
everyWindowSpec = do
  it "on the paper's torus, by 2 x 2 windows, under both packings" $
    forM_ [minBound ..] $ \packing -> do
      array <- paperArray
      m <- paperWindow
      table <- right (buildTable packing (ArrayOn Torus array) m)
      forM_ (windowsOf array m) $ \(p, content) -> do
        tableLookup table (pack packing 4 (map toCode content)) `shouldBe` [p]
        locateRows table (rowsOf 2 (map Just content)) `shouldBe` Right (Unique p [Position 0 0])
  it "on its sheet, where the 31 windows that straddle the edges are absent" $ do
    array <- paperArray
    m <- paperWindow
    table <- paperTable Sheet
    forM_ (windowsOf array m) $ \(p, content) ->
      locateRows table (rowsOf 2 (map Just content))
        `shouldBe` Right
          (if row p < 14 && column p < 16 then Unique p [Position 0 0] else Refused NotInArray)
    length (tableEntries table) `shouldBe` 224
  it "on the torus, and on the twisted torus row by row, over fields of any kind" $
    forM_
      ( [ (4, 6, Diagonal, Shape 63 65, Shape 3 2),
          (4, 6, RowMajor, Shape 15 273, Shape 2 3)
        ]
          ++ [ (q, k1 * k2, Diagonal, Shape n1 ((order ^ (k1 * k2) - 1) `div` n1), Shape k1 k2)
               | (q, k1, k2) <- [(3, 1, 3), (5, 1, 3), (9, 1, 3), (16, 1, 2)],
                 let order = fromIntegral q
                     n1 = order ^ k1 - 1
             ]
      )
      $ \setting@(_, _, folding, _, _) ->
        onArray setting $ \array m -> do
          let on = naturalSurface folding
          table <- right (buildTable MostSignificantFirst (ArrayOn on array) m)
          let found p = do
                content <- windowAt (ArrayOn on array) m p
                pure (locateRows table (rowsOf (columns (maskExtent m)) (map Just content)))
          [p | p <- cellsOf (arrayShape array), found p /= Just (Right (Unique p [Position 0 0]))]
            `shouldBe` []

-- | The windows of an array on the torus.
windowsOf :: KnownField k => PseudorandomArray k -> Mask -> [(Position, [GF k])]
windowsOf array m =
  [ (p, content)
    | p <- cellsOf (arrayShape array),
      Just content <- [windowAt (ArrayOn Torus array) m p]
  ]

largerSpec :: Spec
largerSpec = do
  it "of 2 x 3 to 4 x 5 cells are found everywhere on the torus, all their windows agreeing" $ do
    array <- paperArray
    table <- paperTable Torus
    forM_ [Shape 2 3, Shape 3 2, Shape 3 3, Shape 4 5] $ \size@(Shape h w) ->
      forM_ everywhere $ \p ->
        locateRows table (look array size p)
          `shouldBe` Right (Unique p (cellsOf (Shape (h - 1) (w - 1))))
  it "with one error in 2 x 3 or 3 x 2 cells contradict themselves: the distance is 2" $ do
    array <- paperArray
    table <- paperTable Torus
    forM_ [Shape 2 3, Shape 3 2] $ \size -> do
      m <- right (rectangle size)
      forM_ (windowsOf array m) $ \(_, content) -> forM_ (oneError content) $ \wrong ->
        locateRows table (rowsOf (columns size) (map Just wrong))
          `shouldBe` Right (Refused Contradiction)
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

refusalSpec :: Spec
refusalSpec = do
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
    locateRows table (look array (Shape 2 2) (Position 14 3)) `shouldBe` Right (Refused NotInArray)
  it "off-sheet: windows on the sheet in a patch that sticks out of it, on any side" $ do
    array <- paperArray
    table <- paperTable Sheet
    torus <- paperTable Torus
    -- Rows 13, 14 and, on the torus, 0; rows 14, 0, 1; columns likewise.
    forM_
      [ (Shape 3 2, Position 13 4),
        (Shape 3 2, Position 14 4),
        (Shape 2 3, Position 4 15),
        (Shape 2 3, Position 4 16)
      ]
      $ \(size, p) -> do
        fmap place (locateRows torus (look array size p)) `shouldBe` Right [p]
        locateRows table (look array size p) `shouldBe` Right (Refused OffSheet)
    -- Nothing observed beyond the lower edge, or the upper left beyond the upper one.
    let window r = look array (Shape 2 2) (Position r 4)
        gone = [[Nothing, Nothing]]
    fmap place (locateRows table (window 13 ++ gone)) `shouldBe` Right [Position 13 4]
    locateRows table (gone ++ window 0) `shouldBe` Right (Refused OffSheet)
    fmap place (locateRows torus (gone ++ window 0)) `shouldBe` Right [Position 14 4]
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
    (() <$ buildTable MostSignificantFirst (ArrayOn Torus array) m)
      `shouldBe` Left (TableTooLarge (4 ^ (14 :: Int)) largestTable)
    large <- arrayOver gf4 14 RowMajor (Shape 5 (4 ^ (14 :: Int) `div` 5))
    small <- paperWindow
    (() <$ buildTable MostSignificantFirst (ArrayOn Torus large) small)
      `shouldBe` Left (TableTooLarge (4 ^ (14 :: Int) - 1) largestTable)

repeatSpec :: Spec
repeatSpec = do
  it "are ambiguous, with all their positions; a second window may decide" $ do
    array <- paperArray
    m <- right (rectangle (Shape 1 2))
    table <- right (buildTable MostSignificantFirst (ArrayOn Torus array) m)
    case locateText table ["3 2"] of
      Right (Ambiguous places support) -> do
        places
          `shouldBe` [ p
                       | p@(Position r c) <- everywhere,
                         map (toCode . cellAt array) [p, Position r (c + 1)] == [3, 2]
                     ]
        support `shouldBe` [Position 0 0]
        length places `shouldBe` 16
      other -> expectationFailure (show other)
    locateText table ["3 2", "3 1"]
      `shouldBe` Right (Unique (Position 6 5) [Position 0 0, Position 1 0])
  it "an entry of the table has all positions of its window, and the table has all positions" $
    do
      array <- paperArray
      m <- right (mask [(0, 0), (2, 3)])
      table <- right (buildTable MostSignificantFirst (ArrayOn Torus array) m)
      sort (concatMap snd (tableEntries table)) `shouldBe` everywhere
      forM_ (tableEntries table) $ \(packed, places) -> forM_ places $ \p ->
        fmap (pack MostSignificantFirst 4 . map toCode) (windowAt (ArrayOn Torus array) m p)
          `shouldBe` Just packed
      tableLookup table 16 `shouldBe` []
      tableSize table `shouldBe` 16

place :: Outcome Position -> [Position]
place (Unique p _) = [p]
place _ = []

-- | Rows of codes and question marks.
locateText :: KnownField k => Table k -> [String] -> Either LocateError (Outcome Position)
locateText table = locateRows table . map (map cell . words)
  where
    cell "?" = Nothing
    cell text = either (const Nothing) Just (parseElement text)

noPatch :: Cells -> Either LocateError ()
noPatch cells = () <$ patch cells

oneError :: KnownField k => [GF k] -> [[GF k]]
oneError content =
  [ take i content ++ [b] ++ drop (i + 1) content
    | (i, a) <- zip [0 ..] content,
      b <- elements,
      a /= b
  ]
