-- | Tests frames registered by all their pairs: the field of their displacements against its
-- formulas on lists, its laws, and scenes of known truth with an unknown error.
module Test.Touch.Registration.PairsTogether (spec) where

import Data.List (foldl', genericLength, sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Data.Ord (Down (..))
import qualified Data.Vector.Storable as V
import PraTactile.Composite.Blend (Taxels, minus)
import PraTactile.Image
import PraTactile.Registration.AllPairs
import PraTactile.Registration.AllPairs.Pair
import PraTactile.Registration.Estimate (Estimate (..))
import PraTactile.Registration.Field
import PraTactile.Registration.Field.Pairs
import PraTactile.Registration.Settings
import Test.Effort (withCases)
import Test.Hspec
import Test.QuickCheck hiding (generate)
import Test.Touch.Image.RastersAndCorrelation (genRasterOf)

spec :: Spec
spec = do
  withCases 3 30 fieldSpec
  withCases 2 20 truthSpec
  it "each frame chooses at most eight pairs: of nine frames at one place all, of more not" $ do
    let compared count = comparedPixels told (replicate count ((0, 0), constant 16 16 0.5))
        pairs count = compared count `div` compared 2
        all' count = count * (count - 1) `div` 2
        -- A pair that both frames have chosen counts once.
        few count = pairs count >= 4 * count && pairs count <= min (8 * count) (all' count - 1)
    map pairs [2 .. 9] `shouldBe` map all' [2 .. 9]
    map few [10 .. 14] `shouldBe` replicate 5 True

-- | A known error of half a taxel, taken as a quarter to one. A frame is at most three taxels off,
-- and so is a pair.
told :: Registration
told = standardRegistration {registrationSigma = Just 0.5}

line :: [Int]
line = [-3 .. 3]

square :: [(Int, Int)]
square = [(x, y) | y <- line, x <- line]

-- | L of two frames by the difference of their displacements.
type Said = ((Int, Int), Map.Map (Int, Int) Double)

fieldsOf :: Int -> [Said] -> [Masses]
fieldsOf count = pairwiseField grid (replicate count (0, 0)) 3 . map pairOfLogs

grid :: Grid
grid = pairsGrid told

pairOfLogs :: Said -> Pair
pairOfLogs ((k, l), logs) =
  Pair k l most (V.fromList [realToFrac (exp (logs Map.! e - most)) | e <- square])
  where
    most = maximum logs

-- | The formulas: the fields of this many frames on grid points, after ten sweeps or when none
-- changes its likeliest displacement.
fieldByFormulas :: Int -> [Said] -> [Map.Map (Int, Int) Double]
fieldByFormulas count said = Map.elems (go (10 :: Int) Map.empty)
  where
    go n now
      | n <= 1 || Map.map top new == Map.map top now = new
      | otherwise = go (n - 1) new
      where
        new = foldl' (\at k -> Map.insert k (fieldOf at k) at) now order
    top = fst . foldl' (\a b -> if snd b > snd a then b else a) ((0, 0), -1) . rowByRow
    rowByRow q = sortOn (\((x, y), _) -> (y, x)) (Map.toList q)
    -- The first of a connected group is at the robot's position.
    fieldOf at k
      | not (null (partners k)),
        not (any (`elem` takeWhile (/= k) order) (partners k)) =
        Map.fromList [(d, if d == (0, 0) then 1 else 0) | d <- square]
      | otherwise = priors
      where
        -- A pair without information is as likely as one with it.
        heard =
          [ \d -> log (1 + sum [q * exp (logs (apart d d')) | (d', q) <- seen])
            | ((i, j), table) <- said,
              (sign, other) <- [(1, i) | j == k] ++ [(-1, j) | i == k],
              Just q' <- [Map.lookup other at],
              let seen = filter ((> 0.002) . snd) (Map.toList q'),
              let apart (x, y) (u, v) = (sign * (x - u), sign * (y - v)),
              let logs e = fromMaybe (-1 / 0) (Map.lookup e table)
          ]
        priors = posteriorOf (Map.fromList [(d, robot d + sum (map ($ d) heard)) | d <- square])
        others = [q | (i, q) <- Map.toList at, i /= k]
        m = genericLength others :: Double
        middle part = if null others then 0 else sum (map (expected part) others) / m
        expected f q = sum [p * f d | (d, p) <- Map.toList q]
        (mx, my) = (middle (real . fst), middle (real . snd))
        squares = sum (map (expected squared) others) - m * (mx * mx + my * my)
        squared (x, y) = real x * real x + real y * real y
        -- For one standard deviation out of 13, those of a frame and of the mean of m others.
        variances = [s * s + 1 / 12 | i <- [0 .. 12 :: Int], let s = 0.25 * 2 ** (real i / 6)]
        shares v = exp (negate (max 0 squares) / (2 * v) - max 0 (m - 1) * log v)
        robot (x, y) =
          let t = (real x - mx) ^ (2 :: Int) + (real y - my) ^ (2 :: Int)
              f = if m > 0 then m / (m + 1) else 1
           in log (sum [shares v / both / v * exp (negate f * t / (2 * v)) | v <- variances])
        both = sum (map shares variances)
    posteriorOf logs =
      let most = maximum logs
          masses = Map.map (exp . subtract most) logs
       in Map.map (/ sum masses) masses
    real = fromIntegral :: Int -> Double
    order = growingOf [0 .. count - 1] []
    growingOf [] _ = []
    growingOf waiting placed = next : growingOf (filter (/= next) waiting) (next : placed)
      where
        next = snd (minimum [(map (Down . (`gain` k)) [placed, everyone], k) | k <- waiting])
    everyone = [0 .. count - 1]
    partners k = [if i == k then j else i | ((i, j), _) <- said, k `elem` [i, j]]
    gain others k =
      sum
        [ maximum logs
          | ((i, j), logs) <- said,
            (i == k && j `elem` others) || (j == k && i `elem` others)
        ]

fieldSpec :: Spec
fieldSpec = do
  it "displacements have the probability that pairs and the robot give together" $
    forAll (choose (2, 4)) $ \count -> forAllBlind (genSaid count) $ \said ->
      let found = fieldsOf count said
          wanted = fieldByFormulas count said
          masses q = [q Map.! d | d <- square]
          apart' f w = maximum (map abs (zipWith (-) (V.toList f) (masses w)))
          off = zipWith apart' found wanted
       in counterexample (show off) (length found == count && maximum off < 1e-3)
  it "mirroring the pairs, or exchanging the axes, changes the displacements alike" $
    forAll (choose (2, 4)) $ \count -> forAllBlind (genTrue count) $ \(_, said) ->
      conjoin
        [ map (turn . top) (fieldsOf count said)
            === map top (fieldsOf count (map (turned turn) said))
          | turn <- [\(x, y) -> (x, negate y), \(x, y) -> (y, x)]
        ]
  it "frames lie where all pairs agree, and one wrong pair among them changes nothing" $
    forAllBlind (genTrue 4) $ \(truth, said) -> forAll (elements said) $ \(which, _) ->
      forAll (elements square) $ \off ->
        let stray = (which, spike 8 off)
            others = [one | one <- said, fst one /= which]
            steps = map top . fieldsOf 4
            relative ds = [d `minus` head ds | d <- ds]
         in relative (steps said) === relative (map both truth)
              .&&. relative (steps (stray : others)) === relative (map both truth)
  it "frames without pairs are at the robot's positions" $
    map top (fieldsOf 3 []) `shouldBe` replicate 3 (0, 0)
  where
    top = likeliest grid (0, 0)
    turned :: (Taxels -> Taxels) -> Said -> Said
    turned turn (which, logs) = (which, Map.mapKeys (whole . turn . both) logs)
    whole (x, y) = (round x, round y)
    both (x, y) = (fromIntegral x, fromIntegral y)
    spike height at = Map.fromList [(d, if d == at then height else 0) | d <- square]
    genSaid :: Int -> Gen [Said]
    genSaid count =
      sequence
        [ do
            logs <- vectorOf 49 (choose (0, 1))
            at <- elements square
            height <- choose (0, 8)
            pure ((k, l), Map.insertWith (+) at height (Map.fromList (zip square logs)))
          | l <- [1 .. count - 1],
            k <- [0 .. l - 1]
        ]
    -- Frames a taxel off at most, and pairs that say so.
    genTrue :: Int -> Gen ([(Int, Int)], [Said])
    genTrue count = do
      truth <- vectorOf count ((,) <$> choose (-1, 1) <*> choose (-1, 1))
      pure
        ( truth,
          [ ((k, l), spike 20 (u - x, v - y))
            | (l, (u, v)) <- zip [0 ..] truth,
              (k, (x, y)) <- zip [0 ..] truth,
              k < l
          ]
        )

truthSpec :: Spec
truthSpec =
  it "frames of white relief are placed despite unknown errors of up to three taxels" $
    forAll (genRasterOf 50 50) $ \relief ->
      forAll (vectorOf 9 ((,) <$> choose (-3, 3) <*> choose (-3, 3))) $ \errors ->
        let places = [(10 + 8 * i, 10 + 8 * j) | j <- [0 .. 2], i <- [0 .. 2 :: Int]]
            frames =
              [ ((fromIntegral x, fromIntegral y), seen (x + dx) (y + dy))
                | ((x, y), (dx, dy)) <- zip places errors
              ]
            seen x y = generate 16 16 (\u v -> fromMaybe 0 (index relief (x + u) (y + v)))
            Pairwise found sigma _ = registerPairwise standardRegistration frames
            truth = [(fromIntegral x, fromIntegral y) | (x, y) <- errors]
            less ds = [d `minus` head ds | d <- ds]
            off (x, y) = max (abs x) (abs y)
            errors' = zipWith minus (less (map estimateShift found)) (less truth)
            furthest = maximum (map off errors')
         in -- The robot's prior shifts them a little.
            counterexample (show furthest) (furthest <= 0.125)
              .&&. counterexample (show sigma) (maybe False (\s -> s >= 0.5 && s <= 4) sigma)
