-- | Decoding by information sets, on the paper's array and on large ones. On small ones it is
-- compared with the definition in "Test.Code.Locate.EveryDecoderAsDefined".
module Test.Code.Locate.ByInformationSets (spec) where

import Control.Monad (forM, forM_)
import Data.Bits (testBit)
import Data.List (sort)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.DiscreteLog
import PraTactile.Field
import PraTactile.Field.Named (GF4)
import PraTactile.LinearCode.Elimination (rowFromList)
import PraTactile.Locate
import PraTactile.Locate.Decision
import PraTactile.Locate.Decoder.Algebra
import PraTactile.Locate.Decoder.Equations
import PraTactile.Locate.Decoder.InformationSet
import PraTactile.Locate.Decoder.List.Bounds (Bounds (..), allBounds)
import PraTactile.Locate.Decoder.List.Search (positionsOnSheet)
import PraTactile.Locate.Decoder.ObservedCode (observedCode)
import PraTactile.Locate.Patch (patchOf)
import PraTactile.Symmetry (identity)
import PraTactile.Window
import PraTactile.Window.Distance
import PraTactile.Window.Rank
import Test.Code.Generators
import Test.Code.Locate.Scenes
import Test.Effort (byEffort)
import Test.Hspec
import Test.Paper
import Test.QuickCheck hiding (elements)

spec :: Spec
spec = do
  it "on the paper's array, every error pattern within the guaranteed radius is corrected" $ do
    array <- paperArray
    algebra <- paperAlgebra Torus
    -- The code is linear, so that patterns at a few positions stand for those at all, and one of
    -- each pattern's multiples for the others.
    forM_
      [ (Shape 2 3, 0, 255),
        (Shape 3 2, 0, 255),
        (Shape 3 3, 1, 20),
        (Shape 3 4, 2, 2),
        (Shape 4 4, byEffort 2 3, 1)
      ]
      $ \(size, t, places) -> do
        m <- right (rectangle size)
        d <- right (minimumDistance array m)
        guaranteedRadius (distance d) `shouldSatisfy` (>= fromIntegral t)
        ready <- right (decoder standardEffort algebra (maskOffsets m))
        decoderDistance ready `shouldBe` Exactly (distance d)
        let wronged =
              [ (place, wrong, decoded ready Guaranteed word)
                | i <- take places [5, 42 ..],
                  let place = Position (i `mod` 15) (i `mod` 17),
                  k <- [0 .. t],
                  (wrong, word) <-
                    errorPatterns True k (zip (maskOffsets m) (content array place (maskOffsets m)))
              ]
        length wronged `shouldSatisfy` (>= places)
        take
          3
          [ bad
            | bad@(place, wrong, found) <- wronged,
              fmap located found /= Right (Just place, wrong)
          ]
          `shouldBe` []
  describe "on large arrays the answer is the position that the patch was taken from" $ do
    it "GF(4), 2^60 cells: 8x8 cells, 4 missing" $
      foundAgain (4, 30, Diagonal, sides 4 15, Shape 15 2) (Shape 8 8) 4 7 5
    it "GF(2), 2^64 cells: 12x12 cells, 10 missing" $
      foundAgain (2, 64, Diagonal, sides 2 32, Shape 32 2) (Shape 12 12) 10 3 3
    it "GF(3), 3^25 cells: 7x7 cells, 3 missing" $
      foundAgain
        (3, 25, Diagonal, Shape 242 ((3 ^ (25 :: Int) - 1) `div` 242), Shape 5 5)
        (Shape 7 7)
        3
        3
        4
  boundsSpec
  where
    sides q n = Shape (q ^ (n :: Int) - 1) (q ^ n + 1)

boundsSpec :: Spec
boundsSpec = do
  beforeAll ((,) <$> vastArray <*> vastAlgebra)
    . it "an answer lies within the radius, and any other word is refused"
    $ \(array, algebra) ->
      let offsets = cellsOf (Shape 8 8)
          effort' = Effort (2 ^ (17 :: Int)) (2 ^ (22 :: Int))
       in withMaxSuccess 20 . whenRight (decoder effort' algebra offsets) $ \ready ->
            forAll (vectorOf 64 genElement) $ \word ->
              whenRight (decoded ready Guaranteed word) $ \found ->
                let Distances wrong nearest _ _ radius = decisionDistances found
                 in case decisionOutcome found of
                      Refused BeyondRadius -> nearest === Just (AtLeast (radius + 1))
                      Unique place _ ->
                        wrong === differing offsets word (content array place offsets)
                          .&&. property (fromIntegral (length wrong) <= radius)
                      other -> counterexample (show other) False
  it "cells of low rank leave a coset of positions, and its size is given" $ do
    array <- vastArray
    algebra <- vastAlgebra
    p <- right (patch (look array (Shape 1 10) (Position 77 99)))
    decodePatch algebra Guaranteed p
      `shouldBe` Right
        ( Decision
            (AmbiguousMany (4 ^ (20 :: Int)) (Just 20))
            (Distances [] (Just (Exactly 0)) (Just (Exactly 0)) (Exactly 0) 0)
        )
  it "dependent cells of low rank leave a coset, or too many positions if one is wrong" $ do
    -- The 20 rows of a column are a subfield; each of the next 2 follows from them.
    (array, algebra) <- bits40 Torus
    let column' wrong =
          right . patch $
            zipWith
              (\i -> map (fmap (if i == wrong then (+ 1) else id)))
              [0 .. 21 :: Int]
              (look array (Shape 22 1) (Position 123 456))
    windowRank array <$> rectangle (Shape 22 1) `shouldBe` Right 20
    exact <- column' 99
    (decisionOutcome <$> decodePatch algebra Guaranteed exact)
      `shouldBe` Right (AmbiguousMany (2 ^ (20 :: Int)) (Just 20))
    wrong <- column' 7
    (decisionOutcome <$> decodePatch algebra Guaranteed wrong)
      `shouldBe` Right (Refused Contradiction)
    decodePatch algebra (UpTo 1) wrong `shouldBe` Left (DecodingTooMany 1)
  forM_ [0, 5, 20, 100, 10000] $ \effort ->
    beforeAll ((,) <$> paperArray <*> paperAlgebra Torus)
      . it ("a proved distance holds, and so does its radius: effort " ++ show effort)
      $ \(array, algebra) ->
        let offsets = cellsOf (Shape 5 5)
         in withMaxSuccess 40
              . whenRight (decoder (Effort effort (2 ^ (20 :: Int))) algebra offsets)
              $ \ready ->
                let known = decoderDistance ready
                    radius = fromIntegral (guaranteedRadius (atLeast known))
                    between = case known of
                      Exactly d -> d == 16
                      AtLeast d -> d >= 6 && d <= 16
                 in counterexample (show known) between
                      .&&. forAll
                        (wronging radius (content array (Position 3 4) offsets))
                        ( \word ->
                            whenRight (decoded ready Guaranteed word) $ \found ->
                              fst (located found) === Just (Position 3 4)
                        )
  it "the bound of the unlisted mass in several symmetries is the sum over each" $
    withMaxSuccess 200 $
      forAll (listOf ((,) <$> genLogarithm <*> genLogarithm)) $ \several ->
        let together = sum [exp mass | (mass, _) <- several]
            highest = maximum (map snd several)
         in case allBounds [Bounds mass word | (mass, word) <- several] of
              Nothing -> several === []
              Just (Bounds mass word) ->
                counterexample (show (mass, word)) $
                  abs (exp mass - together) <= 1e-12 * together && word == highest
  it "positions of a word on the sheet are counted; beyond 1024 only whether there is one" $ do
    let shape = Shape 255 257
        sides' = [Shape 1 1, Shape 1 3, Shape 1 4, Shape 2 2, Shape 1 200]
    array <- arrayOver gf4 8 Diagonal shape
    algebra <- right (rectangle (Shape 4 2)) >>= right . prepareAlgebra (ArrayOn Sheet array)
    forM_ sides' $ \side -> do
      code <- right (observedCode algebra (cellsOf side))
      forM_ [Position 3 5, Position 100 50] $ \at -> do
        let word = content array at (cellsOf side)
            onSheet = Shape (256 - rows side) (258 - columns side)
            there = filter (\p -> content array p (cellsOf side) == word) (cellsOf onSheet)
            -- Each cell is one equation for the state of eight.
            looked = min (4 ^ (8 - min 8 (area side))) (area onSheet)
            told = if looked > 1024 then take 1 there else there
        (side, positionsOnSheet code (rowFromList word))
          `shouldBe` (side, fromIntegral (length told))
  beforeAll (bits40 Sheet) $ do
    it "many solutions on a vast sheet: two on the sheet prove ambiguity, else a refusal" $
      \(array, algebra) -> do
        -- A patch that leaves the sheet but where it begins in one of the first two rows: of the
        -- first solutions none begins there.
        let last' = Position (2 ^ (20 :: Int) - 3) 0
            tall cells = patchOf (Shape (2 ^ (20 :: Int) - 2) 2) cells
            two = zip cells (content array (Position 0 5) cells)
              where
                cells = [Position 0 0, last']
            many =
              zip
                ([Position i 0 | i <- [0 .. 13]] ++ [Position i 1 | i <- [0 .. 12]] ++ [last'])
                (cycle [1, 0, 0, 1, 1])
        algebraPatch algebra (tall two)
          `shouldBe` Right (AmbiguousMany (2 ^ (38 :: Int)) (Just 38))
        -- Of the positions that are looked at, each agrees with a probability of 2^-28.
        algebraPatch algebra (tall many) `shouldBe` Left (AlgebraSheet (2 ^ (12 :: Int)))
    it "of many solutions the first 1024 are tried: two on the sheet suffice, one does not" $
      \(array, algebra) -> do
        logarithms <- right (prepareLogarithms (arrayPrimitive array))
        -- A tall patch may begin in so many rows, a few solutions in a thousand do. That one of the
        -- positions looked at afterwards agrees has a probability of 2^-12.
        told <- forM [(2048, 1), (2048, 2)] $
          \(begins, seed) -> do
            let offsets =
                  [Position i 0 | i <- [0 .. 12]]
                    ++ [Position i 1 | i <- [0 .. 11]]
                    ++ [Position (2 ^ (20 :: Int) - 1 - begins) 0]
                codes = [if testBit (seed * 40503 :: Int) (i `mod` 17) then 1 else 0 | i <- [0 ..]]
                cells = zip offsets codes
            solutions <- solve 40 <$> right (equations array cells)
            let places =
                  [ positionOfIndex array t
                    | x <- take 1024 (solutionResidues (arrayPrimitive array) solutions),
                      Right t <- [logarithmFrom logarithms x]
                  ]
                there = length (filter ((< begins) . row) places)
                came = algebraPatch algebra (patchOf (Shape (2 ^ (20 :: Int) - begins) 2) cells)
            (begins, seed, solutionCount solutions) `shouldSatisfy` \(_, _, n) -> n > 1024
            (begins, seed, came)
              `shouldBe` ( begins,
                           seed,
                           if there > 1
                             then
                               Right . AmbiguousMany (solutionCount solutions) $
                                 Just (solutionFreedom solutions)
                             else Left (AlgebraSheet (solutionCount solutions))
                         )
            pure there
        -- One has exactly one, the other more.
        told `shouldSatisfy` \counts -> elem 1 counts && any (> 1) counts
  it "onePatch asks for an upright patch, the guaranteed radius and no foreign share" $ do
    seen <- right (patch [[Just (Symbol (1 :: GF GF4)), Nothing]])
    let query = onePatch seen
    queryPatches query `shouldBe` [((0, 0), seen)]
    (querySymmetries query, queryRadius query, queryDoubt query)
      `shouldBe` ([identity], Guaranteed, 0.001)
    queryForeign query `shouldBe` Nothing
  it "a search that would take too long is refused, and so are unprepared cells" $ do
    array <- vastArray
    algebra <- vastAlgebra
    m <- right (rectangle (Shape 8 8))
    ready <- right (decoder (Effort 0 100) algebra (maskOffsets m))
    let word = content array (Position 1 2) (maskOffsets m)
        diagonal = zipWith (\i a -> if i `elem` [0, 9 .. 63 :: Int] then a + 1 else a) [0 ..] word
    fmap (fst . located) (decoded ready (UpTo 9) word) `shouldBe` Right (Just (Position 1 2))
    case decoded ready (UpTo 9) diagonal of
      Left (DecodingTooLong cleared _ limit) -> (limit, cleared <= 8) `shouldBe` (100, True)
      other -> expectationFailure (show other)
    (() <$ decodeWith ready Guaranteed (patchOf (Shape 1 1) [(Position 0 0, one)]))
      `shouldBe` Left DecodingOtherCells
  it "all steps share one budget of words: with one word less the last step is refused" $ do
    algebra <- vastAlgebra
    array <- vastArray
    m <- right (rectangle (Shape 8 8))
    let word = content array (Position 1 2) (maskOffsets m)
        diagonal = zipWith (\i a -> if i `elem` [0, 9 .. 63 :: Int] then a + 1 else a) [0 ..] word
        -- What is asked for next when this many words are allowed.
        asked allowed = do
          ready <- right (decoder (Effort 0 allowed) algebra (maskOffsets m))
          pure $ case decoded ready (UpTo 9) diagonal of
            Left (DecodingTooLong _ more limit) | limit == allowed -> Just more
            _ -> Nothing
        -- The steps asked for, one after the other, each allowed for as soon as it is asked for.
        climb allowed steps
          | length steps >= 12 = pure (reverse steps)
          | otherwise =
            asked allowed
              >>= maybe (pure (reverse steps)) (\n -> climb (allowed + n) (n : steps))
    steps <- climb 0 []
    length steps `shouldSatisfy` (> 3)
    short <- traverse (\k -> asked (sum (take k steps) - 1)) [1 .. length steps]
    short `shouldBe` map Just steps
  it "a patch of the sheet's size has one position there, however many on the torus" $
    onArray (2, 12, Diagonal, Shape 63 65, Shape 6 2) $ \array m -> do
      algebra <- right (prepareAlgebra (ArrayOn Sheet array) m)
      let at = Position 62 64
          p = patchOf (Shape 63 65) [(at, cellAt array at)]
      algebraPatch algebra p `shouldBe` Right (Unique (Position 0 0) [])
      found <- right (decodePatch algebra Guaranteed p)
      decisionOutcome found `shouldBe` Unique (Position 0 0) []
      let Distances _ least next _ _ = decisionDistances found
      (least, next) `shouldBe` (Just (Exactly 0), Nothing)
  where
    -- Of what has probability 0 too.
    genLogarithm = frequency [(5, choose (-40, 0)), (1, pure (-1 / 0))]
    -- 2^40 cells over GF(2).
    bits40 surface = do
      array <- arrayOver gf2 40 Diagonal (Shape (2 ^ (20 :: Int) - 1) (2 ^ (20 :: Int) + 1))
      algebra <- right (rectangle (Shape 20 2)) >>= right . prepareAlgebra (ArrayOn surface array)
      pure (array, algebra)

-- | At random positions of an array for this window, with this many cells missing, as many wrong
-- ones are found as the distance that is proved guarantees, which is at least the first number; and
-- as many as the second.
foundAgain :: Setting -> Shape -> Int -> Natural -> Int -> Property
foundAgain setting@(_, n, _, shape, _) size missing least errors =
  withMaxSuccess 3 $
    ofArray setting $ \array window ->
      whenRight (prepareAlgebra (ArrayOn Torus array) window) $ \algebra ->
        forAll ((,) <$> genPosition shape <*> shuffle (cellsOf size)) $ \(place, shuffled) ->
          let offsets = sort (drop missing shuffled)
              first' count = sort (take count (drop missing shuffled))
              sent = content array place offsets
              damaged wrong = zipWith (\at a -> if at `elem` wrong then a + 1 else a) offsets sent
           in (windowRank array <$> maskFrom offsets) == Right n
                ==> whenRight (decoder (Effort (2 ^ (22 :: Int)) (2 ^ (24 :: Int))) algebra offsets)
                $ \ready ->
                  let d = atLeast (decoderDistance ready)
                      certain = first' (fromIntegral (guaranteedRadius d))
                      more = first' errors
                      from radius wrong = whenRight (decoded ready radius (damaged wrong))
                   in conjoin
                        [ property (d >= least),
                          from Guaranteed certain $ \found ->
                            (located found, nearestDistance (decisionDistances found))
                              === ( (Just place, certain),
                                    Just (Exactly (fromIntegral (length certain)))
                                  ),
                          from (UpTo (fromIntegral errors)) more $ \found ->
                            nearby place more found $ \at ->
                              length (differing offsets (damaged more) (content array at offsets))
                        ]

-- | Beyond what is guaranteed another position may be as near, and must then be named, too. Given
-- the true position, the wrong cells, and in how many cells another position differs.
nearby :: Position -> [Position] -> Decision Position -> (Position -> Int) -> Property
nearby place wrong found differs = counterexample (show found) $ case decisionOutcome found of
  Unique at _
    | at == place -> corrected distances === wrong
    | otherwise -> property (differs at < length wrong)
  Ambiguous places _ ->
    property
      ( place `elem` places
          || nearestDistance distances /= Just (Exactly (fromIntegral (length wrong)))
      )
  _ -> property False
  where
    distances = decisionDistances found

-- | What a decoder makes of the symbols of the cells that it is for.
decoded ::
  KnownField k => Decoder k -> Radius -> [GF k] -> Either DecodingError (Decision Position)
decoded ready radius word = decodeWith ready radius (patchOf extent (zip offsets word))
  where
    offsets = decoderOffsets ready
    extent = Shape (1 + maximum (map row offsets)) (1 + maximum (map column offsets))

-- | The only position, and the wrong cells.
located :: Decision Position -> (Maybe Position, [Position])
located found = case decisionOutcome found of
  Unique place _ -> (Just place, corrected (decisionDistances found))
  _ -> (Nothing, corrected (decisionDistances found))

-- | The offsets of the symbols that differ.
differing :: [Position] -> [GF k] -> [GF k] -> [Position]
differing offsets word other = [at | (at, a, b) <- zip3 offsets word other, a /= b]

content :: KnownField k => PseudorandomArray k -> Position -> [Position] -> [GF k]
content array (Position r c) offsets =
  [cellAt array (Position (r + i) (c + j)) | Position i j <- offsets]

-- | This many symbols wrong.
wronging :: KnownField k => Int -> [GF k] -> Gen [GF k]
wronging count word = do
  wrong <- take count <$> shuffle (zipWith const [0 :: Int ..] word)
  mapM
    (\(i, a) -> if i `elem` wrong then genElement `suchThat` (/= a) else pure a)
    (zip [0 ..] word)
