{-# LANGUAGE BangPatterns #-}

-- | The ways to find where frames were: which, and what is told of each frame.
module PraTactile.Registration.Arrangement
  ( Way (..),
    Registered (..),
    Arrangement (..),
    arrange,
    withMisfit,
    residual,
    groupsOf,
  )
where

import Data.List (foldl')
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, listToMaybe)
import qualified Data.Vector.Storable as V
import PraTactile.Composite (compositeOf)
import PraTactile.Composite.Blend (Blend (..), Place, blend)
import PraTactile.Composite.Noise (spacedOut)
import PraTactile.Composite.Tilt (tilt)
import PraTactile.Image
  ( Raster,
    rasterHeight,
    rasterSize,
    rasterValues,
    rasterWidth,
    standardDeviation,
  )
import PraTactile.Image.Correlate (Reference, reference, referenceAt)
import PraTactile.Registration.AllPairs (registerPairwise)
import PraTactile.Registration.Incremental (register)
import PraTactile.Registration.Joint
import PraTactile.Registration.Lattice.Angle (latticeAngle)
import PraTactile.Registration.Lattice.Fit (Fits, bySize, fitsAt)
import PraTactile.Registration.Lattice.Template (PaperTables, paperTemplates)
import PraTactile.Registration.Posterior (Hypothesis)
import PraTactile.Registration.Search (Registration (..))
import PraTactile.Registration.Spectrum (spectra)

-- | How frames are registered.
data Way
  = -- | incrementally; where the robot is known for an error above 1.25 taxels, or the sensor for
    -- noise above a quarter of full scale, by the lattice if the frames show it
    Automatic
  | -- | by the lattice of cells
    ByLattice
  | -- | by all pairs that overlap, together, by what they show alone
    Jointly
  | -- | frame by frame, by the paper's cross-correlation
    Incremental
  | -- | not at all
    Nominal
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | What is told of a frame.
data Registered = Registered
  { -- | Its displacement from its nominal place, taxels right and down.
    registeredShift :: !Place,
    -- | Its standard deviations, taxels, where the way tells them.
    registeredDeviation :: !(Maybe Place),
    -- | The probability that it is within three quarters of a taxel of the truth, likewise.
    registeredProbability :: !(Maybe Double),
    -- | Displacements that it may have instead, at least two taxels away, the most probable first.
    registeredOthers :: [Hypothesis],
    -- | The group of frames that overlap one another, directly or through others, from 0 on.
    registeredGroup :: !Int
  }
  deriving stock (Eq, Show)

-- | Frames with their displacements.
data Arrangement = Arrangement
  { arrangementWay :: !Way,
    arrangementFrames :: ![Registered],
    -- | The standard deviation of one frame from what others saw at the same place, grey values.
    arrangementResidual :: Maybe Double
  }

-- | Find the displacements, given the nominal places (taxels) of the frames' upper left pixels.
arrange :: Way -> Registration -> [(Place, Raster)] -> Arrangement
arrange way settings frames = case (way, paperTemplates) of
  (Nominal, _) -> plain Nominal unmoved
  _ | all (flat . snd) frames -> plain Incremental unmoved
  (Jointly, _) ->
    arranged
      Jointly
      [ Registered d (Just (sd, sd)) Nothing []
        | (d, sd) <- registerPairwise settings (bySize sizes (uncurry spectra)) frames
      ]
  (ByLattice, Just tables) -> jointly (fromMaybe (at tables 0) (latticeOf tables))
  (Automatic, Just tables)
    | length frames >= 2 && doubtful,
      Just fits <- latticeOf tables ->
      jointly fits
  _ -> plain Incremental (register settings frames)
  where
    unmoved = map (const ((0, 0), [])) frames
    flat image = V.all (== rasterValues image V.! 0) (rasterValues image)
    doubtful = registrationSigma settings > 1.25 || registrationNoise settings > 0.25
    sizes = map (rasterSize . snd) frames
    at tables = fitsAt tables (map snd frames)
    -- The frames held against the lattice, if they show it.
    latticeOf :: PaperTables -> Maybe Fits
    latticeOf tables = do
      size <- listToMaybe sizes
      latticeAngle
        (at tables)
        (uncurry spectra size)
        (tilt (map compositeOf (spacedOut tiltFrames (map snd frames))))
        (map snd frames)
    jointly :: Fits -> Arrangement
    jointly fits =
      arranged
        ByLattice
        [ Registered
            (estimateShift l)
            (Just (estimateDeviation l))
            (Just (estimateProbability l))
            (estimateOthers l)
          | l <- registerJointly settings fits frames
        ]
    plain used ds = arranged used [Registered d Nothing Nothing instead | (d, instead) <- ds]
    arranged used frameOf =
      Arrangement
        used
        (zipWith ($) frameOf (groupsOf places))
        (residual places)
      where
        places = moved frames [registeredShift (a 0) | a <- frameOf]

-- | The most frames that the angle at which symbols seem to lie is told from, before it is told by
-- the lattice: more would take memory for nothing.
tiltFrames :: Int
tiltFrames = 256

-- | Settings for frames of another pitch, brought to the canonical one: their noise has, beside the
-- sensor's, what two frames differ by because their pixels are interpolated: as variance, a share
-- of that of all the frames' relief (assumption). Noise that was averaged away would otherwise let
-- patches that hardly vary decide where a frame lies.
withMisfit :: [Raster] -> Registration -> Registration
withMisfit images settings = settings {registrationNoise = sqrt (noise * noise + misfit * relief)}
  where
    noise = registrationNoise settings
    relief = max 0 (average [sd * sd | Just sd <- map standardDeviation images] - noise * noise)
    misfit = 0.05
    average values = sum values / fromIntegral (max 1 (length values))

moved :: [(Place, Raster)] -> [Place] -> [(Place, Raster)]
moved = zipWith (\((x, y), image) (dx, dy) -> ((x + dx, y + dy), image))

-- | The standard deviation of one frame from what others saw, over all pixels of all frames that
-- others saw, grey values: of images at their places, in taxels. 'Nothing' where none overlap.
residual :: [(Place, Raster)] -> Maybe Double
residual placed
  | total > 0 = Just (sqrt (sum [s * n | (s, n) <- found] / total))
  | otherwise = Nothing
  where
    found = differencesOf placed
    total = sum (map snd found)

-- | For each frame the mean square of its differences from the blend of all, as if the others had
-- no noise and no part of it were its own, and how many pixels others saw.
differencesOf :: [(Place, Raster)] -> [(Double, Double)]
differencesOf placed = map each onGrid
  where
    x0 = floor (minimum (map (fst . fst) placed)) :: Int
    y0 = floor (minimum (map (snd . fst) placed)) :: Int
    wide = maximum [ceiling x - x0 + rasterWidth i + 1 | ((x, _), i) <- placed]
    high = maximum [ceiling y - y0 + rasterHeight i + 1 | ((_, y), i) <- placed]
    onGrid = [((x - fromIntegral x0, y - fromIntegral y0), i) | ((x, y), i) <- placed]
    Blend sums weights = blend wide high onGrid
    each ((x, y), image) = case reference sums weights of
      Right there -> compared there x y image
      Left _ -> (0, 0)

compared :: Reference -> Double -> Double -> Raster -> (Double, Double)
compared there x y image = (if n > 0 then total / n else 0, n)
  where
    w = rasterWidth image
    (total, n) = V.ifoldl' step (0, 0) (rasterValues image)
    step (!s, !k) i f =
      let (v, u) = i `quotRem` w
       in case referenceAt there (x + fromIntegral u) (y + fromIntegral v) of
            Just (c, m) | m > 1.5 -> (s + (f - c) * (f - c) * m / (m - 1), k + 1)
            _ -> (s, k)

-- | For each image, at its place in taxels, its group: images that overlap, directly or through
-- others, are of one group. Groups are numbered from 0 as they come.
groupsOf :: [(Place, Raster)] -> [Int]
groupsOf placed = numbered (map (root joined) [0 .. length placed - 1])
  where
    -- Two images whose corners are in one square overlap, however many there are.
    side =
      fromIntegral
        (minimum (maxBound : concat [[rasterWidth i, rasterHeight i] | (_, i) <- placed])) ::
        Double
    furthest = maximum (1 : concat [[rasterWidth i, rasterHeight i] | (_, i) <- placed])
    reach = ceiling (fromIntegral furthest / side) :: Int
    square (x, y) = (floor (x / side) :: Int, floor (y / side) :: Int)
    squares =
      Map.fromListWith
        (flip (++))
        [(square place, [(k, (place, image))]) | (k, (place, image)) <- zip [0 ..] placed]
    joined =
      foldl'
        union
        (Map.fromList [(k, k) | k <- [0 .. length placed - 1]])
        ( [(k, l) | (k, _) : others <- Map.elems squares, (l, _) <- others]
            ++ [ pair
                 | ((c, r), here) <- Map.toList squares,
                   j <- [0 .. reach],
                   i <- [negate reach .. reach],
                   (j, i) > (0, 0),
                   Just there <- [Map.lookup (c + i, r + j) squares],
                   pair <- take 1 [(k, l) | (k, a) <- here, (l, b) <- there, meets a b]
               ]
        )
    meets ((x, y), a) ((x', y'), b) =
      x' - x < wide a && x - x' < wide b && y' - y < tall a && y - y' < tall b
    wide = fromIntegral . rasterWidth
    tall = fromIntegral . rasterHeight
    union parents (a, b) =
      let (ra, rb) = (root parents a, root parents b)
       in if ra == rb then parents else Map.insert (max ra rb) (min ra rb) parents
    root :: Map.Map Int Int -> Int -> Int
    root parents k = case Map.lookup k parents of
      Just p | p /= k -> root parents p
      _ -> k
    numbered roots =
      let numbers = Map.fromList (zip (Map.keys (Map.fromList [(r, ()) | r <- roots])) [0 ..])
       in [Map.findWithDefault 0 r numbers | r <- roots]
