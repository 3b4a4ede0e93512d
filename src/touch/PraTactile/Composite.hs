{-# OPTIONS_HADDOCK hide #-}

-- | The composite tactile image (the paper's figure 10): the result of stitching and the input of
-- segmentation.
module PraTactile.Composite
  ( Composite (..),
    CompositeFrame (..),
    AlternativeLayout (..),
    LayoutCause (..),
    Contradiction (..),
    likeliestCause,
    asTaken,
    leastCoverage,
    compositeOf,
    compositePosition,
    compositePixel,
    compositeFrom,
    blended,
    BlendWeight (..),
    fullWeight,
    weighted,
  )
where

import Data.List (sortOn)
import Data.List.NonEmpty (NonEmpty)
import qualified Data.List.NonEmpty as NonEmpty
import PraTactile.Composite.Blend (Blend (..), Taxels, blend)
import PraTactile.Composite.Lattice (Lattice)
import PraTactile.Composite.Noise (readingStep)
import PraTactile.Image (Raster, constant, mapRaster, rasterHeight, rasterWidth, zipRaster)
import PraTactile.Image.Correlate (Reference, reference, referenceOf)
import PraTactile.Sensor.Frame (taxelPitch)
import PraTactile.Sensor.Manifest
  ( Axes,
    FrameConventions (..),
    Remedy,
    remedies,
    standardConventions,
  )

-- | An image larger than the sensor, on a grid with the pitch of one taxel and the robot's axes.
data Composite = Composite
  { -- | The mean of the frames' values at each pixel; 0 where no frame touched.
    compositeImage :: !Raster,
    -- | The sensor weight of each pixel, about the number of frames that touched it; 0 where none
    -- did. It has the image's size. The noise variance of a pixel is that of a frame divided by its
    -- coverage.
    compositeCoverage :: !Raster,
    -- | The centre of pixel (0, 0): x and y in millimetres, in the robot's coordinates.
    compositeOrigin :: !(Double, Double),
    -- | The displacement of each frame from its nominal place, x and y in taxels, in the order of
    -- the frames.
    compositeDisplacements :: ![(Double, Double)],
    -- | The standard deviation of the robot's position error along each axis, in taxels, where
    -- registration estimated it.
    compositePositionError :: Maybe Double,
    -- | The standard deviation, in taxels along each axis, of the position errors of frames that
    -- were not registered. Such frames lie at their nominal places, or no two of them overlap. 0
    -- for registered frames and for a single frame.
    compositeUnregisteredError :: !Double,
    -- | The step of the readings ('readingStep'). Smaller differences are not contrast.
    compositeStep :: Double,
    -- | Whether the robot's axes were given.
    compositeAxesStated :: !Bool,
    -- | How the positions and images of the frames are interpreted.
    compositeConventions :: !FrameConventions,
    -- | Alternative layouts of the frames: with one frame elsewhere (most probable first), or with
    -- all frames elsewhere because the robot's positions are wrong.
    compositeAlternatives :: [AlternativeLayout],
    -- | The contradiction of the frames, if they differ where they should overlap.
    compositeContradiction :: Maybe Contradiction,
    -- | The composite of the same frames along the axes of 'AgreeingAlong', if that is the
    -- contradiction.
    compositeAgreeing :: Maybe Composite,
    -- | The frames themselves without duplicates; empty for a whole image.
    compositeFrames :: [CompositeFrame],
    -- | The lattice of cells, if registration found one.
    compositeLattice :: Maybe Lattice
  }
  deriving stock (Eq, Show)

-- | A frame in its place in a composite: upright, at the canonical pitch, on the common scale of
-- the frames.
data CompositeFrame = CompositeFrame
  { -- | The centre of its pixel (0, 0) by the robot's position, in millimetres.
    compositeFrameAt :: !(Double, Double),
    -- | Its displacement from there, in taxels.
    compositeFrameShift :: !(Double, Double),
    compositeFrameImage :: Raster,
    -- | The share of each pixel that comes from living elements, if some are dead.
    compositeFrameWeight :: Maybe Raster
  }
  deriving stock (Eq, Show)

-- | An alternative layout of a composite's frames.
data AlternativeLayout = AlternativeLayout
  { alternativeCause :: !LayoutCause,
    -- | Its share of the prior probability of such faults; 1 for 'OneFrame'.
    alternativeShare :: !Double,
    -- | The likelihood ratio of this layout to the composite's; for 'OneFrame' the posterior odds.
    alternativeRatio :: !Double,
    -- | The lattice under the frames in this layout; 'Nothing' if they have none in common.
    alternativeLattice :: Maybe Lattice
  }
  deriving stock (Eq, Show)

-- | A reason for another layout.
data LayoutCause
  = -- | one frame is elsewhere
    OneFrame
  | -- | the positions are along these axes, not along the stated ones
    OtherAxes !Axes
  | -- | the distances across and down are the stated ones times these factors
    OtherScale !Double !Double
  | -- | beyond a line all frames lie a whole cell further along the face
    Slip
  | -- | each frame lies anywhere, whatever its stated position
    Anywhere
  deriving stock (Eq, Show)

-- | The least coverage with which a pixel counts as touched.
leastCoverage :: Double
leastCoverage = 0.4

-- | What removes the contradiction, when frames differ where they should overlap.
data Contradiction
  = -- | The frames agree if their positions are along these axes.
    AgreeingAlong !Axes
  | -- | The frames agree after any one of these remedies.
    AgreeingBy [Remedy]
  | -- | The frames agree if their distances across and down are multiplied by these factors.
    AgreeingAtScale !Double !Double
  | -- | The frames fit their positions worse than any others: the number of frames, and the
    -- extents of their positions across and down, in millimetres.
    AgreeingAnywhere !Int !Double !Double
  deriving stock (Eq, Show)

-- | The most probable fault that all frames share, as a contradiction, if its odds against the
-- layout in use exceed the limit. The arguments are the limit, the frames' places (millimetres),
-- and the faults with their odds. If the fault is not 'farMore' probable than the layout in use and
-- all other faults, the result is 'AgreeingAnywhere'.
likeliestCause :: Double -> [(Double, Double)] -> [(LayoutCause, Double)] -> Maybe Contradiction
likeliestCause limit places weighed = case sortOn (negate . snd) (filter ofAll weighed) of
  (cause, odds) : rest
    | odds > limit ->
      let others = 1 : [o | (other, o) <- rest, not (alike cause other)]
          certain = all ((odds >) . (farMore *)) others
       in Just (contradictionBy places (if certain then cause else Anywhere))
  _ -> Nothing
  where
    ofAll (cause, _) = cause `notElem` [OneFrame, Slip]
    alike (OtherScale _ _) (OtherScale _ _) = True
    alike _ _ = False

-- | The ratio of odds above which a single fault is named.
farMore :: Double
farMore = 1e4

-- | The contradiction that a fault means for frames at the given places (millimetres).
contradictionBy :: [(Double, Double)] -> LayoutCause -> Contradiction
contradictionBy places cause = case cause of
  OtherAxes axes -> AgreeingAlong axes
  OtherScale across down -> AgreeingAtScale across down
  _ -> AgreeingAnywhere (length places) (extent fst) (extent snd)
  where
    extent part = case map part places of
      [] -> 0
      values -> maximum values - minimum values

-- | A contradiction expressed as changes of how the frames are interpreted. The arguments are the
-- present interpretation and whether the agreeing composite is mirrored, if known.
asTaken :: FrameConventions -> Maybe Bool -> Contradiction -> Contradiction
asTaken taking mirroredThen found = case found of
  AgreeingAlong axes -> AgreeingBy (remedies taking axes mirroredThen)
  AgreeingAtScale across down -> AgreeingAtScale (sx * across) (sy * down)
  _ -> found
  where
    (sx, sy) = positionScale taking

-- | A single image, such as one read from a file, as a composite with coverage 1 everywhere and
-- pixel (0, 0) at the origin.
compositeOf :: Raster -> Composite
compositeOf image =
  Composite
    { compositeImage = image,
      compositeCoverage = constant (rasterWidth image) (rasterHeight image) 1,
      compositeOrigin = (0, 0),
      compositeDisplacements = [],
      compositePositionError = Nothing,
      compositeUnregisteredError = 0,
      compositeStep = readingStep [image],
      compositeAxesStated = False,
      compositeConventions = standardConventions,
      compositeAlternatives = [],
      compositeContradiction = Nothing,
      compositeAgreeing = Nothing,
      compositeFrames = [],
      compositeLattice = Nothing
    }

-- | Converts a place on the composite, x and y in pixels, to millimetres in the robot's
-- coordinates.
compositePosition :: Composite -> (Double, Double) -> (Double, Double)
compositePosition composite (x, y) = (ox + taxelPitch * x, oy + taxelPitch * y)
  where
    (ox, oy) = compositeOrigin composite

-- | Converts a place in the robot's coordinates, x and y in millimetres, to pixels of the
-- composite.
compositePixel :: Composite -> (Double, Double) -> (Double, Double)
compositePixel composite (x, y) = ((x - ox) / taxelPitch, (y - oy) / taxelPitch)
  where
    (ox, oy) = compositeOrigin composite

-- | The place of pixel (0, 0), in taxels right and down from the origin of the robot's
-- coordinates.
compositeFrom :: Composite -> Taxels
compositeFrom composite = let (x, y) = compositeOrigin composite in (x / taxelPitch, y / taxelPitch)

-- | The composite as a weighted image for interpolation.
weighted :: Composite -> Reference
weighted composite =
  either
    (const (referenceOf image))
    id
    (zipRaster (*) image coverage >>= \sums -> reference sums coverage)
  where
    image = compositeImage composite
    coverage = compositeCoverage composite

-- | Blends images into a composite without alternative layouts, marked as registered. The
-- arguments are an origin in millimetres; the images with their places in taxels from it and their
-- weights; and the displacements to record. The grid is shifted from the origin by whole taxels so
-- that it holds all images. A taxel that no living element felt counts 'interpolated' in the mean
-- and 'known' in the coverage.
blended ::
  (Double, Double) ->
  NonEmpty ((Taxels, Raster), BlendWeight) ->
  [Taxels] ->
  Composite
blended (left, top) images displacements =
  Composite
    { compositeImage = means,
      compositeCoverage = coverage,
      compositeOrigin = origin,
      compositeDisplacements = displacements,
      compositePositionError = Nothing,
      compositeUnregisteredError = 0,
      compositeStep = readingStep (map (snd . fst) (NonEmpty.toList images)),
      compositeAxesStated = False,
      compositeConventions = standardConventions,
      compositeAlternatives = [],
      compositeContradiction = Nothing,
      compositeAgreeing = Nothing,
      compositeFrames = [],
      compositeLattice = Nothing
    }
  where
    (x0, x1) = reach fst rasterWidth
    (y0, y1) = reach snd rasterHeight
    reach :: (Taxels -> Double) -> (Raster -> Int) -> (Int, Int)
    reach coordinate side =
      ( floor (minimum (fmap (coordinate . fst . fst) images)),
        maximum (fmap (\((place, im), _) -> ceiling (coordinate place) + side im) images)
      )
    origin = (left + taxelPitch * fromIntegral x0, top + taxelPitch * fromIntegral y0)
    laid from = blend (x1 - x0) (y1 - y0) (map (onGrid . from) (NonEmpty.toList images))
    onGrid ((x, y), im) = ((x - fromIntegral x0, y - fromIntegral y0), im)
    Blend allSums allWeights = laid fst
    (sums, weights, coverage)
      | all ((== fullWeight) . snd) images =
        (allSums, allWeights, allWeights)
      | otherwise = (total times, total inMean, total inCoverage)
    total value = blendSums (laid (\((place, im), counts) -> (place, value counts im)))
    -- The weight of each pixel of an image, if pixels of dead elements have the weight @least@.
    livingShare least felt im =
      maybe (mapRaster (const 1) im) (mapRaster (\share -> share + least * (1 - share))) felt
    inMean counts im =
      touching counts . mapRaster (weightInMean counts *) $
        livingShare interpolated (weightOfLiving counts) im
    inCoverage counts = touching counts . livingShare known (weightOfLiving counts)
    touching counts r = maybe r (orElse r . zipRaster (*) r) (weightOfTouch counts)
    times counts im = orElse im (zipRaster (*) (inMean counts im) im)
    means = orElse sums (zipRaster (\s w -> if w < leastWeight then 0 else s / w) sums weights)
    -- The rasters have one size, so this default is never used.
    orElse other = either (const other) id

-- | The weight of an image in a blend.
data BlendWeight = BlendWeight
  { -- | Its weight in the mean.
    weightInMean :: !Double,
    -- | The weight of each pixel, 0 to 1, by how well it touched; 1 if 'Nothing'.
    weightOfTouch :: !(Maybe Raster),
    -- | The share of each pixel that comes from living elements; 1 if 'Nothing'.
    weightOfLiving :: !(Maybe Raster)
  }
  deriving stock (Eq, Show)

-- | The weight of an image without dead elements: 1 everywhere.
fullWeight :: BlendWeight
fullWeight = BlendWeight 1 Nothing Nothing

-- | The weight in the mean of a value that replaces a dead element, relative to a living one. It
-- is enough to be the mean where no other frame felt the place.
interpolated :: Double
interpolated = 0.02

-- | The weight in the coverage of a value that replaces a dead element. Segmentation uses such a
-- pixel, but any frame that felt it covers it better.
known :: Double
known = 0.5

-- | The least weight of a touched pixel. Below it the mean would be mostly rounding.
leastWeight :: Double
leastWeight = 0.001
