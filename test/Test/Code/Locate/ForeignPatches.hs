-- | Patches that may be nothing of the array's.
module Test.Code.Locate.ForeignPatches (spec) where

import Data.Foldable (for_)
import Data.List (maximumBy)
import Data.Maybe (catMaybes, isNothing)
import Data.Ord (comparing)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named (GF4)
import PraTactile.Locate
import PraTactile.Locate.Foreign
import PraTactile.Locate.OtherArrays
import PraTactile.Random (uniform)
import PraTactile.Symmetry
import PraTactile.Window
import System.Random (StdGen, mkStdGen)
import Test.Code.Generators
import Test.Code.Locate.OtherPolynomials
import Test.Effort
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.Paper
import Test.QuickCheck hiding (elements)

spec :: Spec
spec = do
  prop "the doubts are those of Bayes' theorem, summed over all positions and foreign contents" $
    forAll ((,) <$> scenes <*> genWorth) $ \((share, q, symmetries'), others) ->
      -- In each symmetry, how probable the cells make it, and at each place its symbols, given it.
      let cells = length (concat (take 1 (map snd placed)))
          placed = [(shown, expected) | (shown, chances) <- symmetries', expected <- chances]
          likely (shown, expected) =
            shown
              * product
                [ (1 - misleading) * chance + misleading / fromIntegral q
                  | chance <- expected
                ]
          together = sum (map likely placed)
          best = maximumBy (comparing likely) placed
          ours = (1 - share) * byArray
          mean = sum (map fst symmetries') / fromIntegral (length symmetries')
          count = fromIntegral (length placed)
          (ofChance, ofOthers) = case others of
            Nothing -> (share, 0)
            Just w -> (share / 2, share / 2 * exp w * mean / count)
          theirs = ofChance * random
          whole = ours + theirs + ofOthers
          highest = log (likely best / together)
          shownBest = log (fst best / mean)
          comparison =
            ForeignComparison
              share
              q
              (places placed)
              (snd best)
              highest
              shownBest
              others
              (-1 / 0)
          found = foreignChances comparison
          byArray = together / count
          random = mean / fromIntegral q ^^ cells
       in counterexample (show (found, theirs / whole, ofOthers / whole)) $
            conjoin
              [ property (abs (doubtOfRandom found - theirs / whole) < 1e-9),
                property (abs (doubtOfOtherArrays found - ofOthers / whole) < 1e-9),
                property (abs (evidence comparison - log (byArray / random)) < 1e-9),
                otherArraysExact found === isNothing others
              ]
  it "without a foreign share no doubts are given, and a share of 0 changes no answer" $
    for_ [symbols, beliefs] $ \kind -> do
      plain <- locating Nothing 0.01 kind
      none <- locating (Just 0) 0.01 kind
      answerDoubts plain `shouldBe` Nothing
      fmap foreign' (answerDoubts none) `shouldBe` Just 0
      none {answerDoubts = Nothing} `shouldBe` plain
  it "a larger foreign share means a larger doubt, and too large a doubt a refusal" $
    for_ [symbols, beliefs] $ \kind -> do
      answers <- mapM (\share -> locating (Just share) 0.5 kind) [0.001, 0.01, 0.1, 0.9]
      let told = [foreign' doubts | Just doubts <- map answerDoubts answers]
      length told `shouldBe` 4
      and (zipWith (<) told (drop 1 told)) `shouldBe` True
      [share < 0.5 | share <- told] `shouldBe` [located answer | answer <- answers]
  it "with probabilities the doubt is the sum of its parts" $ do
    answer <- locating (Just 0.1) 0.5 beliefs
    case (answerDoubts answer, answerPosterior answer) of
      (Just doubts@(PlaceDoubts (Just place) _), Just found) -> do
        posteriorDoubt found - place - foreign' doubts `shouldSatisfy` ((< 1e-12) . abs)
        let listed = sum (map snd (posteriorRanking found))
        listed + foreign' doubts - 1 `shouldSatisfy` ((< 1e-9) . abs)
      other -> expectationFailure (show other)
  it "the doubt of symbols at several positions is Bayes', whether listed or counted" $ do
    array <- paperArray
    window <- paperWindow
    vast <- vastArray
    vastWindow <- right (rectangle (Shape 15 2))
    let bayes others cells all' count =
          let theirs = 0.15 / 4 ^^ length cells + 0.15 * others cells
              ours = 0.7 * fromIntegral count * (0.99 + 0.01 / 4) ^ length cells / all'
           in theirs / (ours + theirs)
        told made cells tolerated = do
          seen <- right (patch [map (Just . Symbol) cells])
          right (locate made (asking seen tolerated (Just 0.3)))
        paper = locator Nothing MostSignificantFirst (naturally array) window
        large = locator Nothing MostSignificantFirst (naturally vast) vastWindow
        fitting outcome = case outcome of
          Unique _ _ -> 1 :: Natural
          Ambiguous several _ -> fromIntegral (length several)
          AmbiguousMany count _ -> count
          Refused _ -> 0
        places' = fromIntegral . area . arrayShape
        kinds = byOtherPolynomials array
        among codes =
          let given = zip (cellsOf (Shape 1 9)) (map (\a _ b -> if a == b then 1 else 0) codes)
           in sum
                [fst (worth (naturally other) [identity] (Shape 1 9) given) | other <- kinds]
                / fromIntegral (length kinds)
                / 255
        codesAt from cells at = take cells (catMaybes (concat (look from (Shape 1 9) at)))
    -- Of cells that are not all 0 nothing is told too much.
    for_ (byEffort [1, 4, 6] [1 .. 6]) $ \cells -> for_ [Position 6 5, Position 3 3] $ \at ->
      for_
        [ (paper, codesAt array cells at, places' array, among),
          -- As many cells as are independent in every array that was drawn.
          (large, codesAt vast cells at, places' vast, \codes -> 4 ^^ negate (length codes))
        ]
        $ \(made, codes, count, others) -> do
          answer <- told made codes 0.999
          let found = maybe 0 foreign' (answerDoubts answer)
          (codes, fitting (answerOutcome answer)) `shouldSatisfy` ((> 0) . snd)
          (codes, found, bayes others codes count (fitting (answerOutcome answer)))
            `shouldSatisfy` \(_, a, b) -> abs (a - b) < 1e-9
          -- Tolerated is a doubt that is as large.
          refusal <- told made codes (found - 1e-12)
          equal <- told made codes found
          answerOutcome refusal `shouldBe` Refused BelowThreshold
          answerOutcome equal `shouldBe` answerOutcome answer
  it "the doubts hold for 2^1027 positions, of which many are equally likely" $
    for_ [0, 100, 700, 1024] $ \alike ->
      -- As many as alike are told apart by so many cells; each cell speaks for the array.
      let cells = 1030
          found =
            doubtOfRandom $
              foreignChances
                ForeignComparison
                  { foreignShare = 0.5,
                    foreignSymbols = 2,
                    foreignPlaces = 2 ^ (1027 :: Int),
                    foreignExpected = replicate cells 1,
                    foreignLikeliest = -(alike * log 2),
                    foreignSymmetry = 0,
                    foreignOthers = Nothing,
                    foreignShape = -1 / 0
                  }
          -- 2^alike 0.995^cells / 2^1027 against 2^-cells.
          odds = alike * log 2 + fromIntegral cells * log 0.995 + 3 * log 2
       in (alike, found, 1 / (1 + exp odds)) `shouldSatisfy` \(_, a, b) -> abs (a - b) < 1e-9 * b
  it "if some positions are unlisted, only the likeliest counts for the array" $ do
    array <- paperArray
    window <- paperWindow
    let rows' = look array (Shape 3 3) (Position 6 5)
        asked name share = do
          seen <- right (patch (map (map (fmap beliefs)) rows'))
          right $
            locate
              (locator (Just name) MostSignificantFirst (naturally array) window)
              (asking seen 0.5 share)
        foreignBy name = maybe 0 foreign' . answerDoubts <$> asked name (Just 0.3)
        alone others =
          doubtOfForeign . foreignChances $
            ForeignComparison 0.3 4 255 (replicate 9 0.97) 0 0 others (-1 / 0)
    seen <- right (patch (map (map (fmap (sure 0.97))) rows'))
    listed <- asked ListDecoder Nothing
    fmap posteriorUnlisted (answerPosterior listed) `shouldSatisfy` (/= Just Nothing)
    byList <- foreignBy ListDecoder
    compared <- foreignBy PosteriorDecoder
    let others = evidenceOfOthers (otherArrays (naturally array)) [identity] seen
    abs (byList - alone others) `shouldSatisfy` (< 1e-12)
    compared `shouldSatisfy` (< byList)
  it "no more answers are wrong than the doubts say, with 300 of 1500 patches foreign" $ do
    array <- paperArray
    window <- paperWindow
    let theLocator = locator Nothing MostSignificantFirst (naturally array) window
        others = byOtherPolynomials array
        judged seed = do
          let (isForeign, at, codes) = drawn array others (mkStdGen seed)
          seen <- right (patch (map (map (Just . Probabilities . seenAs)) codes))
          answer <- right (locate theLocator (asking seen 0.5 (Just 0.2)))
          pure $ case (answerOutcome answer, answerPosterior answer) of
            (Unique found _, Just told) ->
              [(isForeign || candidatePosition found /= at, posteriorDoubt told)]
            _ -> []
    answers <- concat <$> mapM judged [1 .. 1500]
    let expected = sum (map snd answers)
        counted = fromIntegral (length (filter fst answers)) :: Double
        deviation = sqrt (sum [p * (1 - p) | (_, p) <- answers])
    length answers `shouldSatisfy` (> 500)
    expected `shouldSatisfy` (> 5)
    (counted - expected) / deviation `shouldSatisfy` (< 3)
  where
    foreign' = doubtOfForeign . doubtsOfForeign
    genWorth = oneof [pure Nothing, Just <$> choose (-9, 3)]
    places = fromIntegral . length :: [a] -> Natural
    scenes = do
      share <- choose (0.001, 0.9)
      q <- choose (2, 5 :: Int)
      cells <- choose (1, 8 :: Int)
      count <- choose (1, 20 :: Int)
      ways <- choose (1, 3)
      symmetries' <-
        vectorOf ways $
          (,) <$> choose (0.01, 1) <*> vectorOf count (vectorOf cells (choose (0, 1 :: Double)))
      pure (share, q, symmetries')
    located answer = case answerOutcome answer of
      Unique _ _ -> True
      _ -> False
    symbols = Symbol
    beliefs = Probabilities . sure 0.97
    locating share tolerated kind = do
      array <- paperArray
      window <- paperWindow
      let rows' = look array (Shape 3 3) (Position 6 5)
      seen <- right (patch (map (map (fmap kind)) rows'))
      right $
        locate
          (locator Nothing MostSignificantFirst (naturally array) window)
          (asking seen tolerated share)
    asking seen tolerated share =
      Query [((0, 0), seen)] [identity] Guaranteed tolerated share (-1 / 0) Nothing
    -- Which symbol was seen; it is that one with this probability.
    sure p a =
      either (error . show) id $
        belief [if code == toCode a then p else (1 - p) / 3 | code <- [0 .. 3]]
    seenAs = sure 0.9

-- | Whether it is foreign, by chance or one of these other arrays, where it is, and the six symbols
-- that are seen: one in ten is another than there is.
drawn ::
  PseudorandomArray GF4 -> [PseudorandomArray GF4] -> StdGen -> (Bool, Position, [[GF GF4]])
drawn ours kinds generator0 = (isForeign, at, codes)
  where
    (u, generator1) = uniform generator0
    isForeign = u < 0.2
    byChance = u < 0.1
    array
      | isForeign && not byChance =
        kinds !! min (length kinds - 1) (floor ((u - 0.1) * 10 * fromIntegral (length kinds)))
      | otherwise = ours
    (r, generator2) = lessThan 15 generator1
    (c, generator3) = lessThan 17 generator2
    at = Position r c
    codes = go generator3 [[Position (r + i) (c + j) | j <- [0 .. 2]] | i <- [0, 1]]
    go generator rows' = case rows' of
      [] -> []
      line : rest ->
        let (symbols, generator') = seenIn generator line in symbols : go generator' rest
    seenIn generator line = case line of
      [] -> ([], generator)
      cell : rest ->
        let (v, g1) = uniform generator
            (k, g2) = lessThan 4 g1
            true = cellAt array (Position (row cell `mod` 15) (column cell `mod` 17))
            chance = either (error . show) id (fromCode (fromIntegral k))
            (others, g3) = seenIn g2 rest
         in (if byChance || v < 0.4 / 3 then chance : others else true : others, g3)
    lessThan n generator =
      let (v, generator') = uniform generator
       in (min (n - 1) (floor (v * fromIntegral (n :: Natural))), generator')
