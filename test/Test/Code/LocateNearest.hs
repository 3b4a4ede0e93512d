-- | Locating with errors and erasures, against every position and every pattern of errors.
module Test.Code.LocateNearest (spec) where

import Control.Monad (forM_)
import Data.Bits (popCount, shiftL, shiftR, xor, (.&.), (.|.))
import Data.List (foldl', nub, sort)
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Locate
import PraTactile.Locate.Decision
import PraTactile.Locate.Decoder.Codebook
import PraTactile.Locate.Decoder.Nearest
import PraTactile.Window
import PraTactile.Window.Distance
import Test.Code.Decided
import Test.Code.Generators
import Test.Hspec
import Test.QuickCheck
  ( Gen,
    Property,
    choose,
    conjoin,
    counterexample,
    forAll,
    property,
    vectorOf,
    (===),
    (==>),
  )

spec :: Spec
spec = do
  describe
    "every pattern of errors within the guaranteed radius and just beyond it, on the paper's array"
    $ do
      -- The code is linear: adding a codeword moves the received word and every codeword alike, so
      -- that the patterns around one position stand for those around all; only the place that the
      -- zero word would have moves. Likewise the multiples of a pattern stand for each other, so
      -- that at one position only those are tried whose first error adds 1. The smaller windows are
      -- exhausted at all 255 positions none the less.
      forM_
        [(2, 3, 0, 255), (3, 2, 0, 255), (3, 3, 1, 255), (3, 4, 2, 5), (4, 4, 4, 1)]
        $ \(h, w, t, places) ->
          it
            ( show h
                ++ "x"
                ++ show w
                ++ ": "
                ++ show t
                ++ " errors are corrected, and more are refused or decoded as comparing with all \
                   \positions says, at "
                ++ show places
                ++ " positions"
            )
            $ do
              shelf <- paperBook Torus
              guaranteedRadius . distance
                <$> minimumDistance' shelf (Shape h w) `shouldReturn` fromIntegral t
              sums <-
                mapM
                  (patterns shelf (Shape h w) t (t + 1) (places == 1))
                  (take places (everyPosition 7))
              [bad | bad : _ <- sums] `shouldBe` []
      it "3x4: every pattern of at most 2 errors is corrected at all 255 positions" $ do
        shelf <- paperBook Torus
        sums <- mapM (patterns shelf (Shape 3 4) 2 2 False) (everyPosition 0)
        [bad | bad : _ <- sums] `shouldBe` []
      it "4x4: every pattern of at most 2 errors is corrected at 30 positions" $ do
        shelf <- paperBook Torus
        sums <- mapM (patterns shelf (Shape 4 4) 4 2 False) (take 30 (everyPosition 3))
        [bad | bad : _ <- sums] `shouldBe` []
  describe "the linearity that lets one position stand for all" $ do
    it
      "decoding commutes with adding a codeword: around every position an error leads to the same \
      \neighbours"
      $ do
        shelf <- paperBook Torus
        holds 2000 $
          forAll
            ((,,) <$> genOffsets <*> genPlaces <*> vectorOf 16 (genElement :: Gen (GF GF4)))
            $ \(offsets, (p, p'), noise) ->
              let led = neighbours shelf offsets (zipWith (+) noise (contentAt shelf offsets p))
                  led' = neighbours shelf offsets (zipWith (+) noise (contentAt shelf offsets p'))
                  relative place (e, found) =
                    (e, sort (map (map toCode . (`minus` contentAt shelf offsets place)) found))
               in relative p led === relative p' led'
    it
      "decoding commutes with scaling: the multiple of a patch leads to the multiples of its \
      \neighbours"
      $ do
        shelf <- paperBook Torus
        holds 2000 $
          forAll
            ((,,) <$> genOffsets <*> vectorOf 16 (genElement :: Gen (GF GF4)) <*> genElement)
            $ \(offsets, drawn, a) ->
              let received = zipWith const drawn offsets
                  scaled (e, found) = (e, sort (map (map (toCode . (a *))) found))
                  plain (e, found) = (e, sort (map (map toCode) found))
               in a /= 0
                    ==> plain (neighbours shelf offsets (map (a *) received))
                      === scaled (neighbours shelf offsets received)
  describe "any patch with holes and errors" $ do
    it "is decoded as its definition says, on torus and sheet, by any radius" $ do
      forM_ [Torus, Sheet] $ \surface -> do
        shelf <- paperBook surface
        holds 1500 $
          forAll ((,) <$> genDamaged shelf <*> choose (0, 4 :: Int)) $ \(cells, e) ->
            asDefined shelf (fromIntegral e) cells
    it "is located right if 2 e is less than the distance of the cells that were observed" $ do
      shelf <- paperBook Torus
      holds 1500 $
        forAll (genWithin shelf) $ \(place, wrong, cells) -> case patch cells of
          Left e -> counterexample (show e) False
          Right p ->
            let decision = nearest shelf Guaranteed p
             in conjoin
                  [ case decisionOutcome decision of
                      Unique found _ -> found === place
                      other -> counterexample (show other) (decisionDistance decision === 0),
                    if decisionDistance decision == 0
                      then property True
                      else decisionWrong decision === sort wrong
                  ]
    it "has the distance that the rank road finds for the cells observed" $ do
      shelf <- paperBook Torus
      holds 300 $
        forAll genOffsets $ \offsets ->
          either
            (const Nothing)
            (Just . distance)
            ( either
                (const (Left ()))
                (either (const (Left ())) Right . minimumDistance (codebookArray shelf))
                (maskFrom offsets)
            )
            === Just (observedDistance shelf offsets)
  it "the zero word is refused: zero-window" $ do
    shelf <- paperBook Torus
    p <-
      right (patch [[Just 0, Just 0, Just 0], [Just 0, Just 1, Just 0], [Just 0, Just 0, Just 0]])
    decisionOutcome (nearest shelf Guaranteed p) `shouldBe` Refused ZeroWindow
    none <- right (patch [[Nothing, Nothing]])
    decisionOutcome (nearest shelf Guaranteed none) `shouldBe` Refused TooFewCells
  it
    "no distance is promised where the surface is not the array's own, and so nothing is corrected"
    $ do
      array <- right paperPrimitive >>= right . folded Diagonal (Shape 15 17)
      m <- right (rectangle (Shape 2 2))
      shelf <- right (buildCodebook TwistedTorus array m)
      observedDistance shelf (maskOffsets m) `shouldBe` 0
      p <-
        right
          ( patch
              [ [Just 0, Just 1, Just 2, Just 3],
                [Just 0, Just 1, Just 2, Just 2],
                [Just 0, Just 1, Just 2, Just 3],
                [Just 0, Just 1, Just 2, Just 3]
              ]
          )
      decisionRadius (nearest shelf Guaranteed p) `shouldBe` 0

paperBook :: Surface -> IO (Codebook GF4)
paperBook surface = do
  array <- right paperPrimitive >>= right . folded Diagonal (Shape 15 17)
  m <- right (rectangle (Shape 2 2))
  right (buildCodebook surface array m)

minimumDistance' :: Codebook GF4 -> Shape -> IO Distance
minimumDistance' shelf size =
  right (rectangle size) >>= right . minimumDistance (codebookArray shelf)

-- | All positions of the paper's array, in a scattered order.
everyPosition :: Int -> [Position]
everyPosition start =
  [ Position (fromIntegral (i `mod` 15)) (fromIntegral (i `mod` 17))
    | k <- [0 .. 254],
      let i = start + 37 * k
  ]

-- | The patterns of at most so many errors, the second number, around a window whose radius is the
-- first: those whose decision is not what it should be. What it should be is found by other means:
-- two bits a cell, and counting the cells in which two windows differ by bit operations.
patterns ::
  Codebook GF4 ->
  Shape ->
  Int ->
  Int ->
  Bool ->
  Position ->
  IO [([Position], Decision Position)]
patterns shelf size t most upToFactor place = do
  m <- right (rectangle size)
  let offsets = maskOffsets m
      count = length offsets
      array = codebookArray shelf
      content (Position r c) =
        [cellAt array (Position ((r + i) `mod` 15) ((c + j) `mod` 17)) | Position i j <- offsets]
      packed = foldl' (\n a -> n `shiftL` 2 .|. toCode a) (0 :: Int) :: [GF GF4] -> Int
      book' = Primitive.fromList (map (packed . content) positionsInOrder)
      differ a b =
        let x = a `xor` b in popCount ((x .|. (x `shiftR` 1)) .&. (0x5555555555555555 :: Int))
      sent = content place
      errors k = choices upToFactor k (zip [0 ..] sent)
      check (wrong, received) =
        let word = packed received
            near = Primitive.map (differ word) book'
            least = Primitive.minimum near
            spots = [i | (i, n) <- zip [0 ..] (Primitive.toList near), n == least]
            expected
              | length wrong <= t = Unique place []
              | least <= t, [i] <- spots = Unique (positionsInOrder !! i) []
              | differ word 0 <= t = Refused ZeroWindow
              | t == 0 = Refused Contradiction
              | otherwise = Refused BeyondRadius
         in case patch (rowsOf (fromIntegral (columns size)) (map Just received)) of
              Left _ -> []
              Right p ->
                let decision = nearest shelf Guaranteed p
                    outcome = case decisionOutcome decision of
                      Unique found _ -> Unique found []
                      Refused NotInArray -> Refused Contradiction
                      other -> other
                 in [ (map (offsets !!) wrong, decision)
                      | outcome /= expected
                          || decisionNearest decision /= Just (fromIntegral least)
                          || (length wrong <= t && decisionWrong decision /= map (offsets !!) wrong)
                    ]
  pure (concatMap check (concat [errors k | k <- [0 .. min count most]]))
  where
    positionsInOrder = [Position r c | r <- [0 .. 14], c <- [0 .. 16]]
    -- Every way to have exactly k wrong symbols: their indices, and the word.
    choices :: Bool -> Int -> [(Int, GF GF4)] -> [([Int], [GF GF4])]
    choices _ 0 cells = [([], map snd cells)]
    choices _ _ [] = []
    choices first k ((i, a) : rest) =
      [(wrong, a : word) | (wrong, word) <- choices first k rest]
        ++ [ (i : wrong, b : word)
             | b <- if first then [a + 1] else elements,
               b /= a,
               (wrong, word) <- choices False (k - 1) rest
           ]

-- | The least distance of a word from the contents of these cells, and the contents that have it,
-- each once: zero, which stands nowhere, among them, so that they are a linear code.
neighbours :: Codebook GF4 -> [Position] -> [GF GF4] -> (Natural, [[GF GF4]])
neighbours shelf offsets received = case patch
  [[lookup (Position i j) cells | j <- [0 .. 3]] | i <- [0 .. 3]] of
  Left _ -> (0, [])
  Right p ->
    let decision = nearest shelf (UpTo 16) p
        places = case decisionOutcome decision of
          Unique place _ -> [place]
          Ambiguous several _ -> several
          _ -> []
        found = nub (map (contentAt shelf offsets) places)
        weight = fromIntegral (length (filter (/= 0) received)) :: Natural
        zeros = map (const 0) offsets
     in case decisionNearest decision of
          Just e
            | weight < e -> (weight, [zeros])
            | weight == e -> (e, nub (zeros : found))
            | otherwise -> (e, found)
          Nothing -> (weight, [zeros])
  where
    cells = zip offsets received

contentAt :: Codebook GF4 -> [Position] -> Position -> [GF GF4]
contentAt shelf offsets (Position r c) =
  [cellAt (codebookArray shelf) (Position (r + i) (c + j)) | Position i j <- offsets]

minus :: [GF GF4] -> [GF GF4] -> [GF GF4]
minus = zipWith (-)

-- | Two positions of the paper's array.
genPlaces :: Gen (Position, Position)
genPlaces = (,) <$> place <*> place
  where
    place = (\r c -> Position (fromInteger r) (fromInteger c)) <$> choose (0, 14) <*> choose (0, 16)

rowsOf :: Int -> [a] -> [[a]]
rowsOf w cells = case splitAt w cells of
  ([], _) -> []
  (r, rest) -> r : rowsOf w rest

type Cells = [[Maybe (GF GF4)]]

genDamaged :: Codebook GF4 -> Gen Cells
genDamaged shelf = do
  h <- choose (1, 4)
  w <- choose (1, 4)
  r <- choose (0, 14)
  c <- choose (0, 16)
  mapM (mapM damage) (seen shelf (Position (fromInteger r) (fromInteger c)) h w)
  where
    damage a = do
      fate <- choose (0, 99 :: Int)
      b <- genElement
      pure (if fate < 15 then Nothing else if fate < 30 then Just b else Just a)

seen :: Codebook GF4 -> Position -> Integer -> Integer -> [[GF GF4]]
seen shelf (Position r c) h w =
  [ [ cellAt (codebookArray shelf) (Position (r + fromInteger i) (c + fromInteger j))
      | j <- [0 .. w - 1]
    ]
    | i <- [0 .. h - 1]
  ]

-- | A patch with holes and as many errors as are promised to be corrected: its position, the wrong
-- cells, the patch.
genWithin :: Codebook GF4 -> Gen (Position, [Position], Cells)
genWithin shelf = do
  h <- choose (2, 5)
  w <- choose (2, 5)
  r <- choose (0, 14)
  c <- choose (0, 16)
  let place = Position (fromInteger r) (fromInteger c)
      cells = seen shelf place h w
      at i j = Position (fromInteger i) (fromInteger j)
  gone <- vectorOf (fromInteger (h * w)) ((< 25) <$> choose (0, 99 :: Int))
  let observed =
        [at i j | ((i, j), False) <- zip [(i, j) | i <- [0 .. h - 1], j <- [0 .. w - 1]] gone]
      t = fromIntegral (guaranteedRadius (observedDistance shelf observed))
  errors <- choose (0, t :: Int)
  wrong <- pick errors observed
  let damage o a
        | o `notElem` observed = pure Nothing
        | o `elem` wrong = Just . (a +) <$> nonZero
        | otherwise = pure (Just a)
  patched <-
    mapM (\(i, line) -> mapM (\(j, a) -> damage (at i j) a) (zip [0 ..] line)) (zip [0 ..] cells)
  pure (place, wrong, patched)
  where
    nonZero = genElement >>= \a -> if a == 0 then nonZero else pure a
    pick 0 _ = pure []
    pick _ [] = pure []
    pick k from = do
      i <- choose (0, length from - 1)
      (from !! i :) <$> pick (k - 1 :: Int) (take i from ++ drop (i + 1) from)

genOffsets :: Gen [Position]
genOffsets = do
  kept <- vectorOf 16 (choose (0, 99 :: Int))
  let offsets =
        [ Position (fromInteger i) (fromInteger j)
          | (k, (i, j)) <- zip kept [(i, j) | i <- [0 .. 3], j <- [0 .. 3]],
            k < 60
        ]
  if null offsets then genOffsets else pure offsets

-- | Count, at every position, the observed cells that differ.
asDefined :: Codebook GF4 -> Natural -> Cells -> Property
asDefined shelf e cells = case patch cells of
  Left complaint -> counterexample (show complaint) False
  Right p ->
    let decision = nearest shelf (UpTo e) p
        observed = [(i, j, a) | (i, line) <- zip [0 ..] cells, (j, Just a) <- zip [0 ..] line]
        fits (Position r c) =
          codebookSurface shelf /= Sheet || and [r + i < 15 && c + j < 17 | (i, j, _) <- observed]
        differing (Position r c) =
          [ Position i j
            | (i, j, a) <- observed,
              cellAt (codebookArray shelf) (Position (r + i) (c + j)) /= a
          ]
        counted =
          [ (fromIntegral (length (differing place)), place)
            | r <- [0 .. 14],
              c <- [0 .. 16],
              let place = Position r c,
              fits place
          ]
        ordered = sort (map fst counted)
        best = [place | (count, place) <- counted, [count] == take 1 ordered]
        within = take 1 ordered <= [e]
        nearZero = fromIntegral (length [() | (_, _, a) <- observed, a /= 0]) <= e
        -- Where nothing may be corrected, the reasons are the table's: zeros in every complete
        -- window are enough.
        onlyZeroWindows = not (null windows) && all (all (== 0)) windows
        windows =
          [ window
            | (above, below) <- zip cells (drop 1 cells),
              Just window <-
                [ sequence [a, b, c, d]
                  | ((a, b), (c, d)) <- zip (zip above (drop 1 above)) (zip below (drop 1 below))
                ]
          ]
     in counterexample (show decision) $
          if null observed
            then decisionOutcome decision === Refused TooFewCells
            else
              conjoin
                [ decisionNearest decision === (case ordered of a : _ -> Just a; [] -> Nothing),
                  decisionRunnerUp decision === (case ordered of _ : b : _ -> Just b; _ -> Nothing),
                  case decisionOutcome decision of
                    Unique place _ ->
                      conjoin
                        [ property within,
                          best === [place],
                          decisionWrong decision === differing place
                        ]
                    Ambiguous places _ ->
                      conjoin [property (within && length best > 1), places === best]
                    AmbiguousMany _ _ -> property False
                    Refused TooFewCells -> property False
                    Refused ZeroWindow ->
                      property
                        ( not (within && not (null ordered))
                            && (nearZero || (e == 0 && onlyZeroWindows))
                        )
                    Refused BeyondRadius -> property (e > 0 && not (within && not (null ordered)))
                    Refused _ -> property (e == 0 && not (within && not (null ordered)))
                ]
