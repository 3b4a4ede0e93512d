-- | Registration one frame after the other: each frame lies where the composite of others and the
-- robot have it most probably, at first of those placed before it, in the end of all others.
module Test.Touch.Registration.GrownAndSwept (spec) where

import Data.List ((\\))
import Data.Maybe (fromMaybe)
import PraTactile.Composite.Blend
import PraTactile.Image hiding (mean)
import PraTactile.Image.Correlate
import PraTactile.Registration.Incremental
import PraTactile.Registration.Search
import Test.Effort (withCases)
import Test.Hspec
import Test.QuickCheck hiding (generate)
import Test.Touch.Image.RastersAndCorrelation (genRasterOf)

spec :: Spec
spec = withCases 25 200 $ do
  it "frames are displaced by eighths of a taxel, in the mean by less than one" $
    forAllBlind genFrames $ \frames -> forAll (genSettings [0, 1, 5]) $ \settings ->
      let moves = register settings frames
       in counterexample (show moves) $
            map eighths moves == moves && nearBy (1 / 16) (meanOf moves) (0, 0)
  it "without sweeps each frame is as probable as at any whole taxel, by those placed before it" $
    forAllBlind genFrames $ \frames -> forAll (genSettings [0]) $ \settings ->
      let moves = register settings frames
          orders = growing frames
          grown order = and (zipWith (lying order) [0 ..] order)
          lying order n k =
            let earlier = take n order
                -- The first one is where the robot has it.
                placed = [move `minus` (moves !! head order) | move <- moves]
                middle = eighths (meanOf (map (placed !!) earlier))
                -- They are known up to the error of their mean.
                spread = 1 + 1 / fromIntegral (max 1 n)
                start = whole middle
                prior = Prior middle (spread * variance settings)
                told = likely settings frames placed earlier k start prior
                near = windowed (Window middle (sqrt spread * searchRadius settings)) start
             in best told near (placed !! k)
       in counterexample (show (orders, moves)) (any grown orders)
  it "in the first sweep each frame is as probable as wherever it may be, by all others" $
    forAllBlind genFrames $ \frames -> forAll (genSettings [0]) $ \settings ->
      let lying (Seen _ d old told) =
            best told (windowed (Window (0, 0) (searchRadius settings)) (old `minus` whole old)) d
       in all lying (swept settings frames)
  it "later each frame that moves, or beside which one moved, is so by a taxel around it" $
    forAllBlind genFrames $ \frames -> forAll (genSettings [1, 2, 3]) $ \settings ->
      let lying (Seen moved d old told) =
            (d == old && not moved) || best told (windowed (Window old 1) old) d
       in all lying (swept settings frames)

-- | Whether a displacement is as probable as others, one of which it is refined from by a half, a
-- quarter and an eighth.
best :: (Taxels -> (Double, Double)) -> [Taxels] -> Taxels -> Bool
best told near d = all ((<= score d + 1e-9) . score) near && any (nearBy (7 / 8) d) near
  where
    score = uncurry (+) . told

-- | A frame in a sweep: whether another that it overlaps at their nominal places has moved since it
-- was looked at, where it is then and where it was, and what all others tell of it.
data Seen = Seen !Bool !Taxels !Taxels (Taxels -> (Double, Double))

-- | The frames in the sweep after so many. Their mean is taken away after each sweep, and told by a
-- frame that nothing ties to the others, which the robot alone places.
swept :: Registration -> [(Taxels, Raster)] -> [Seen]
swept settings given = [seen (take n order) k | (n, k) <- zip [0 ..] order, k > 0]
  where
    frames = ((500, -9), generate 6 5 (\x y -> fromIntegral ((3 * x + y * y) `mod` 5))) : given
    order = [0 .. length given]
    count = registrationSweeps settings
    start d = if count == 0 then d `minus` whole d else d
    (olds, news) = sweep count
    sweep n = (results !! n, map (`plus` (lone `minus` head next)) next)
      where
        next = results !! (n + 1)
        lone = if n == 0 then (0, 0) else head (results !! n)
    results = [register settings {registrationSweeps = n} frames | n <- [0 ..]]
    movedIn n l = let (from, to) = sweep n in n >= 0 && from !! l /= to !! l
    seen earlier k = Seen moved (news !! k) (olds !! k) (others settings frames placed k from)
      where
        from = start (olds !! k)
        placed = [if l `elem` earlier then news !! l else olds !! l | l <- [0 .. length given]]
        moved =
          or
            [ movedIn (if l `elem` earlier then count else count - 1) l
              | l <- order \\ [k],
                meeting (fst (frames !! l)) (fst (frames !! k))
            ]
    meeting (x, y) (u, v) = abs (x - u) < 6 && abs (y - v) < 5

-- | Parts of one relief, some hardly to be seen, near their places or far from all others.
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

-- | Settings with so many sweeps.
genSettings :: [Int] -> Gen Registration
genSettings sweeps =
  Registration
    <$> elements [Nothing, Just 0.5, Just 2]
    <*> elements [0, 0.1]
    <*> pure 2
    <*> elements sweeps

variance :: Registration -> Double
variance settings = supposedSigma settings * supposedSigma settings

-- | The orders of growth: next is the frame whose nominal overlaps with those placed tell most; of
-- equals that whose overlaps with all do, and of equals the first. What differs by rounding alone
-- may be either.
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

-- | The logarithms of a frame's likelihood and prior at a displacement, given the displacements of
-- all frames and which of these it is held against. They are laid on a grid on which the frame's
-- pixels lie if it is displaced as at the start; each of their pixels counts as surely as the mean
-- of so many frames is known, and an overlap no more than that at the start.
likely ::
  Registration ->
  [(Taxels, Raster)] ->
  [Taxels] ->
  [Int] ->
  Int ->
  Taxels ->
  Prior ->
  Taxels ->
  (Double, Double)
likely settings frames placed these k start prior = \d ->
  let overlap = at d
      capped = overlap {overlapWeight = min most (overlapWeight overlap)}
   in (logLikelihood settings capped, logPrior prior d)
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

-- | By all others and the robot.
others ::
  Registration ->
  [(Taxels, Raster)] ->
  [Taxels] ->
  Int ->
  Taxels ->
  Taxels ->
  (Double, Double)
others settings frames placed k start =
  likely settings frames placed these k start (Prior (0, 0) (variance settings))
  where
    these = [0 .. length frames - 1] \\ [k]

-- | The places of a window that lie whole taxels from a start, with the start.
windowed :: Window -> Taxels -> [Taxels]
windowed (Window middle radius) start =
  start :
    [ d
      | j <- [-9 .. 9],
        i <- [-9 .. 9],
        let d = start `plus` (i, j),
        distance (d `minus` middle) <= radius
    ]
  where
    distance (x, y) = sqrt (x * x + y * y)

nearBy :: Double -> Taxels -> Taxels -> Bool
nearBy most (x, y) (u, v) = max (abs (x - u)) (abs (y - v)) <= most

meanOf :: [Taxels] -> Taxels
meanOf places = (mean fst, mean snd)
  where
    mean part = sum (map part places) / fromIntegral (max 1 (length places))

eighths, whole :: Taxels -> Taxels
eighths (x, y) = (fromIntegral (round (8 * x) :: Int) / 8, fromIntegral (round (8 * y) :: Int) / 8)
whole (x, y) = (fromIntegral (round x :: Int), fromIntegral (round y :: Int))
