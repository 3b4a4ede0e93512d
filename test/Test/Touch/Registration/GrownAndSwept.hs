-- | Tests registration of one frame after the other: each frame lies where the composite of others
-- and the robot make it most probable. These are first the frames placed before it, and in the end
-- all others.
module Test.Touch.Registration.GrownAndSwept (spec) where

import Data.List (nub, (\\))
import Data.Maybe (fromMaybe)
import PraTactile.Composite.Blend
import PraTactile.Image hiding (mean)
import PraTactile.Image.Correlate
import PraTactile.Registration.Correlation
import PraTactile.Registration.Incremental
import PraTactile.Registration.Settings
import Test.Effort (withCases)
import Test.Hspec
import Test.QuickCheck hiding (generate)
import Test.Touch.Image.RastersAndCorrelation (genRasterOf)

spec :: Spec
spec = withCases 25 200 $ do
  it "displacements are in eighths of a taxel, with a mean below one eighth" $
    forAllBlind genFrames $ \frames -> forAll (genSettings [0, 1, 5]) $ \settings ->
      let moves = register settings frames
       in counterexample (show moves) $
            map eighths moves == moves && nearBy (1 / 16) (meanOf moves) (0, 0)
  it "without sweeps no whole taxel is more probable for a frame, given those placed before it" $
    forAllBlind genFrames $ \frames -> forAll (genSettings [0]) $ \settings ->
      let moves = register settings frames
          orders = growing frames
          grown order = and [lying n k | (n, k) <- zip [0 ..] order]
            where
              -- The first one is at the robot's position.
              placed = [move `minus` (moves !! head order) | move <- moves]
              lying n k = anywhere settings frames placed (take n order) k (0, 0)
       in counterexample (show (orders, moves)) (any grown orders)
  it "after a sweep without changes no place is more probable for a frame, given all others" $
    forAllBlind genFrames $ \frames -> forAll (genSettings [9]) $ \settings ->
      let moves = register settings frames
          numbers = [0 .. length frames - 1]
          still = moves == register settings {registrationSweeps = 8} frames
          others k = numbers \\ [k]
          -- All may have moved by one step, each when those before it had.
          alike by = all (\k -> best settings frames (placed k) (others k) k 1 (old k)) numbers
            where
              old k = (moves !! k) `minus` by
              placed k = [if l <= k then moves !! l else old l | l <- numbers]
          steps = [(x, y) | y <- line, x <- line]
          line = [signed * t / 8 | t <- [0 .. 16], signed <- [1, -1]]
          -- If the first sweep moves no frame, there is no second.
          wide k = anywhere settings frames moves (others k) k (moves !! k)
       in classify still "still" $
            counterexample (show moves) (not still || all wide numbers || any alike steps)

-- | Whether no other place of the robot is more probable for a frame, at whole taxels from where it
-- was before.
anywhere :: Registration -> [(Taxels, Raster)] -> [Taxels] -> [Int] -> Int -> Taxels -> Bool
anywhere settings frames placed these k old =
  any
    (best settings frames placed these k (spreadBeside these * searchRadius settings) . plus old)
    (nub [whole ((middle `minus` old) `plus` (u, v)) | u <- hair, v <- hair])
  where
    middle = meanOf (map (placed !!) these)
    -- A half taxel up to rounding may be either.
    hair = [-1e-9, 1e-9]

-- | The standard deviation of a displacement about the mean of these others, which has an error of
-- its own, in units of that of one frame.
spreadBeside :: [Int] -> Double
spreadBeside these = sqrt (1 + 1 / fromIntegral (max 1 (length these)))

-- | Whether no whole taxel from a start, up to this distance, is more probable for a frame, and
-- whether it was refined from one of them by a half, a quarter and an eighth. Given are the
-- displacements of all frames, and which of them count.
best ::
  Registration -> [(Taxels, Raster)] -> [Taxels] -> [Int] -> Int -> Double -> Taxels -> Bool
best settings frames placed these k radius start =
  all ((<= score d + 1e-9) . score) near && any (nearBy (7 / 8) d) near
  where
    d = placed !! k
    sigma = spreadBeside these * supposedSigma settings
    prior = Prior (meanOf (map (placed !!) these)) (sigma * sigma)
    score = likely settings frames placed these k start prior
    near = wholeTaxels radius start

-- | Parts of one relief, some hardly visible, near their places or far from all others.
genFrames :: Gen [(Taxels, Raster)]
genFrames = do
  relief <- referenceOf <$> genRasterOf 13 13
  count <- choose (1, 6)
  wide <- elements [5, 5, 14]
  vectorOf count $ do
    (x, y) <- (,) <$> choose (0, wide) <*> choose (0, 5)
    (dx, dy) <- (,) <$> choose (-1, 1) <*> choose (-1, 1)
    contrast <- elements [1, 1, 0.2, 0]
    rough <- genRasterOf 6 5
    share <- elements [0, 0.2, 1]
    far <- frequency [(9, pure 0), (1, pure 60)]
    let real = fromIntegral :: Int -> Double
        half t = (t + 1) / 2
        seen u v =
          maybe 0 fst (referenceAt relief (half (x + dx + real u)) (half (y + dy + real v)))
        noise u v = share * fromMaybe 0 (index rough u v)
        image = generate 6 5 (\u v -> contrast * (seen u v + noise u v))
    pure ((x + far, y), image)

-- | Settings with these sweeps.
genSettings :: [Int] -> Gen Registration
genSettings sweeps =
  Registration
    <$> elements [Nothing, Just 0.5, Just 2]
    <*> elements [0, 0.1]
    <*> pure 2
    <*> elements sweeps

-- | The orders of growth. The next frame is the one whose nominal overlaps with those placed carry
-- most information; of equals the one whose overlaps with all do, and of equals the first.
-- Differences of rounding may go either way.
growing :: [(Taxels, Raster)] -> [[Int]]
growing frames = grown [] [0 .. length frames - 1]
  where
    grown placed [] = [placed]
    grown placed waiting =
      concat
        [ grown (placed ++ [k]) (waiting \\ [k])
          | (n, k) <- numbered,
            not (any (earlier n k) numbered)
        ]
      where
        numbered = zip [0 :: Int ..] waiting
        earlier n k (m, l)
          | inCommon l /= inCommon k = inCommon l > inCommon k + 1e-9
          | inAll l /= inAll k = inAll l > inAll k + 1e-9
          | otherwise = m < n
        inCommon k = sum [telling l k | l <- placed]
    inAll k = sum [telling k l | l <- [0 .. length frames - 1], l /= k]
    telling l k = table !! l !! k
    table = [[overlapping a b | b <- frames] | a <- frames]
    overlapping ((x, y), a) ((u, v), b) =
      let Overlap n va vb _ = overlapAt (referenceOf a) b (u - x) (v - y) in n * sqrt (va * vb)

-- | The logarithm of a frame's likelihood and prior at a displacement, given the displacements of
-- all frames and which of these count. They are laid on a grid that contains the frame's pixels if
-- it is displaced as at the start. Each of their pixels is weighted by the certainty of a mean of
-- that many frames, and an overlap counts no more than at the start.
likely ::
  Registration ->
  [(Taxels, Raster)] ->
  [Taxels] ->
  [Int] ->
  Int ->
  Taxels ->
  Prior ->
  Taxels ->
  Double
likely settings frames placed these k start prior = \d ->
  let overlap = at d
      capped = overlap {overlapWeight = min most (overlapWeight overlap)}
   in logLikelihood (max 1e-9 (registrationNoise settings ^ (2 :: Int))) capped + logPrior prior d
  where
    (place, image) = frames !! k
    border = 20
    middle = (fromIntegral border, fromIntegral border)
    most = overlapWeight (at start)
    at d = uncurry (overlapAt composite image) (middle `plus` (d `minus` start))
    composite =
      fromMaybe (error "two sizes") . either (const Nothing) Just $ do
        values <- zipRaster (\s m -> s / (1 + m)) sums weights
        reference values (mapRaster (\m -> m / (1 + m)) weights)
    Blend sums weights =
      blend
        (rasterWidth image + 2 * border)
        (rasterHeight image + 2 * border)
        [ (middle `plus` ((there `plus` (placed !! l)) `minus` (place `plus` start)), other)
          | l <- these,
            let (there, other) = frames !! l
        ]

-- | The places at whole taxels from a start, up to this distance.
wholeTaxels :: Double -> Taxels -> [Taxels]
wholeTaxels radius start =
  [start `plus` (i, j) | j <- [-9 .. 9], i <- [-9 .. 9], sqrt (i * i + j * j) <= radius]

nearBy :: Double -> Taxels -> Taxels -> Bool
nearBy most (x, y) (u, v) = max (abs (x - u)) (abs (y - v)) <= most

meanOf :: [Taxels] -> Taxels
meanOf places = (mean fst, mean snd)
  where
    mean part = sum (map part places) / fromIntegral (max 1 (length places))

eighths, whole :: Taxels -> Taxels
eighths (x, y) = (fromIntegral (round (8 * x) :: Int) / 8, fromIntegral (round (8 * y) :: Int) / 8)
whole (x, y) = (fromIntegral (round x :: Int), fromIntegral (round y :: Int))
