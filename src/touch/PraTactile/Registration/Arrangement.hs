-- | The methods to find where frames were: which, and what is told of each frame.
module PraTactile.Registration.Arrangement
  ( StitchMethod (..),
    Registered (..),
    Arrangement (..),
    arrange,
    withMisfit,
  )
where

import Data.Maybe (fromMaybe, listToMaybe)
import qualified Data.Vector.Storable as V
import PraTactile.Composite (compositeOf)
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Composite.Noise (spacedOut)
import PraTactile.Composite.Tilt (tilt)
import PraTactile.Image (Raster, rasterSize, rasterValues, standardDeviation)
import PraTactile.Registration.AllPairs (registerPairwise)
import PraTactile.Registration.Groups (groupsOf)
import PraTactile.Registration.Incremental (register)
import PraTactile.Registration.Joint
import PraTactile.Registration.Lattice.Angle (latticeAngle)
import PraTactile.Registration.Lattice.Fit (Fits, bySize, fitsAt)
import PraTactile.Registration.Lattice.Template (PaperTables, paperTemplates)
import PraTactile.Registration.Posterior (Hypothesis)
import PraTactile.Registration.Residual (residual)
import PraTactile.Registration.Search (Registration (..))
import PraTactile.Registration.Spectrum (spectra)

-- | How frames are registered.
data StitchMethod
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
    registeredShift :: !Taxels,
    -- | Its standard deviations, taxels, where the method tells them.
    registeredDeviation :: !(Maybe Taxels),
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
  { arrangementMethod :: !StitchMethod,
    arrangementFrames :: ![Registered],
    -- | The standard deviation of one frame from what others saw at the same place, grey values.
    arrangementResidual :: Maybe Double
  }

-- | Find the displacements, given the nominal places (taxels) of the frames' upper left pixels.
arrange :: StitchMethod -> Registration -> [(Taxels, Raster)] -> Arrangement
arrange method settings frames = case (method, paperTemplates) of
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

moved :: [(Taxels, Raster)] -> [Taxels] -> [(Taxels, Raster)]
moved = zipWith (\((x, y), image) (dx, dy) -> ((x + dx, y + dy), image))
