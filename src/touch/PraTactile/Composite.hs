{-# OPTIONS_HADDOCK hide #-}

-- | The composite tactile image (the paper's figure 10): what the stitcher makes and segmentation
-- takes.
module PraTactile.Composite
  ( Composite (..),
    PutFrame (..),
    Otherwise (..),
    Fault (..),
    Contradiction (..),
    likeliestFault,
    asTaken,
    leastCoverage,
    compositeOf,
    compositePosition,
    compositePixel,
    compositeFrom,
    blended,
    Worth (..),
    inFull,
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
    Remedy,
    Taking (..),
    remedies,
    standardTaking,
  )

-- | An image larger than the sensor, on a grid of one taxel's pitch whose axes are the robot's.
data Composite = Composite
  { -- | The mean of what the frames saw at each pixel; 0 where none touched.
    compositeImage :: !Raster,
    -- | How much sensor weight each pixel got: about the number of frames that saw it, 0 for never
    -- touched. The same size as the image. So the variance of a pixel's noise is that of a frame's,
    -- divided by this.
    compositeCoverage :: !Raster,
    -- | The centre of pixel (0, 0), x and y in millimetres, in the robot's coordinates.
    compositeOrigin :: !(Double, Double),
    -- | How far each frame was moved from its nominal place, x and y in taxels, in the order of the
    -- frames.
    compositeDisplacements :: ![(Double, Double)],
    -- | The standard deviation of the robot's position error along each axis, taxels, where
    -- registration told it.
    compositePositionError :: Maybe Double,
    -- | The standard deviation of the robot's position error along each axis, in taxels, with which
    -- several frames lie because nobody compared them: at their nominal places, or where none
    -- overlaps another. 0 of frames that were compared, and of one.
    compositeUncompared :: !Double,
    -- | The step of what the frames read ('readingStep'): less is no contrast.
    compositeStep :: Double,
    -- | Whether somebody said what the robot's axes are.
    compositeAxesStated :: !Bool,
    -- | How the positions and images of its frames are taken.
    compositeTaking :: !Taking,
    -- | How else the frames may lie: one of them elsewhere, the most probable first, or all where
    -- they would be if what the robot told is wrong.
    compositeOthers :: [Otherwise],
    -- | Whether the frames contradict each other where they should overlap.
    compositeContradiction :: Maybe Contradiction,
    -- | The same frames along the axes of 'AgreeingAlong', where these are named.
    compositeAgreeing :: Maybe Composite,
    -- | The frames themselves, each that was seen once; none of a whole image.
    compositeFrames :: [PutFrame],
    -- | The lattice of cells, where registration found one.
    compositeLattice :: Maybe Lattice
  }
  deriving stock (Eq, Show)

-- | A frame as it was put: upright, at the canonical pitch, on the scale of the others.
data PutFrame = PutFrame
  { -- | Where the robot has the centre of its pixel (0, 0), millimetres.
    putAt :: !(Double, Double),
    -- | How far it was moved from there, taxels.
    putBy :: !(Double, Double),
    putImage :: Raster,
    -- | The share of each pixel that living elements felt, where some are dead.
    putFelt :: Maybe Raster
  }
  deriving stock (Eq, Show)

-- | An alternative layout of a composite's frames.
data Otherwise = Otherwise
  { otherwiseFault :: !Fault,
    -- | The share that it has of the prior probability of such faults; 1 of 'OneFrame'.
    otherwiseShare :: !Double,
    -- | The likelihood ratio of this layout to the composite's, by what the frames show; of
    -- 'OneFrame' the odds.
    otherwiseLikelier :: !Double,
    -- | The lattice under the frames where they then lie; 'Nothing' where they have none in common.
    otherwiseLattice :: Maybe Lattice
  }
  deriving stock (Eq, Show)

-- | Why frames would lie otherwise.
data Fault
  = -- | one of them is elsewhere
    OneFrame
  | -- | their positions are along these axes, where they are told to be straight
    OtherAxes !Axes
  | -- | they are so many times as far from each other across and down as was told
    OtherScale !Double !Double
  | -- | beyond a line all of them lie a whole cell further along the face
    Slip
  | -- | each lies anywhere, whatever position was told
    Anywhere
  deriving stock (Eq, Show)

-- | The least sensor weight with which a pixel counts as touched.
leastCoverage :: Double
leastCoverage = 0.4

-- | The frames show other things where they should overlap.
data Contradiction
  = -- | If their positions were along these axes instead, they would show the same.
    AgreeingAlong !Axes
  | -- | They would show the same by any of these remedies.
    AgreeingBy [Remedy]
  | -- | If their positions were so many times as far apart across and down, they would show the
    -- same.
    AgreeingAtScale !Double !Double
  | -- | They fit their positions less well than any others: how many frames, and how far apart
    -- these are across and down, millimetres.
    AgreeingAnywhere !Int !Double !Double
  deriving stock (Eq, Show)

-- | The likeliest of the faults that all frames share, by their odds to the layout that is used, if
-- these are above a limit; given the frames' places in millimetres. A fault that is not 'farMore'
-- likely than the layout used and than all others says only that the frames lie anywhere.
likeliestFault :: Double -> [(Double, Double)] -> [(Fault, Double)] -> Maybe Contradiction
likeliestFault limit places weighed = case sortOn (negate . snd) (filter ofAll weighed) of
  (fault, odds) : rest
    | odds > limit ->
      let others = 1 : [o | (other, o) <- rest, not (alike fault other)]
          certain = all ((odds >) . (farMore *)) others
       in Just (contradictionBy places (if certain then fault else Anywhere))
  _ -> Nothing
  where
    ofAll (fault, _) = fault `notElem` [OneFrame, Slip]
    alike (OtherScale _ _) (OtherScale _ _) = True
    alike _ _ = False

-- | How many times as likely as all else a fault is that is named.
farMore :: Double
farMore = 1e4

-- | What such a fault says of frames at these places.
contradictionBy :: [(Double, Double)] -> Fault -> Contradiction
contradictionBy places fault = case fault of
  OtherAxes axes -> AgreeingAlong axes
  OtherScale across down -> AgreeingAtScale across down
  _ -> AgreeingAnywhere (length places) (extent fst) (extent snd)
  where
    extent part = case map part places of
      [] -> 0
      values -> maximum values - minimum values

-- | A contradiction of frames that were so taken, as what to take otherwise, given whether what
-- agrees is mirrored, where that is known.
asTaken :: Taking -> Maybe Bool -> Contradiction -> Contradiction
asTaken taking mirroredThen found = case found of
  AgreeingAlong axes -> AgreeingBy (remedies taking axes mirroredThen)
  AgreeingAtScale across down -> AgreeingAtScale (sx * across) (sy * down)
  _ -> found
  where
    (sx, sy) = takenScale taking

-- | A single image, such as one read from a file, as a composite that was touched once everywhere,
-- with its pixel (0, 0) at the origin.
compositeOf :: Raster -> Composite
compositeOf image =
  Composite
    { compositeImage = image,
      compositeCoverage = constant (rasterWidth image) (rasterHeight image) 1,
      compositeOrigin = (0, 0),
      compositeDisplacements = [],
      compositePositionError = Nothing,
      compositeUncompared = 0,
      compositeStep = readingStep [image],
      compositeAxesStated = False,
      compositeTaking = standardTaking,
      compositeOthers = [],
      compositeContradiction = Nothing,
      compositeAgreeing = Nothing,
      compositeFrames = [],
      compositeLattice = Nothing
    }

-- | A place on the composite, x and y in pixels, as millimetres in the robot's coordinates.
compositePosition :: Composite -> (Double, Double) -> (Double, Double)
compositePosition composite (x, y) = (ox + taxelPitch * x, oy + taxelPitch * y)
  where
    (ox, oy) = compositeOrigin composite

-- | Where a place in the robot's coordinates, x and y in millimetres, is on the composite, in
-- pixels.
compositePixel :: Composite -> (Double, Double) -> (Double, Double)
compositePixel composite (x, y) = ((x - ox) / taxelPitch, (y - oy) / taxelPitch)
  where
    (ox, oy) = compositeOrigin composite

-- | Where the composite's pixel (0, 0) is, in taxels right and down from where the robot counts.
compositeFrom :: Composite -> Taxels
compositeFrom composite = let (x, y) = compositeOrigin composite in (x / taxelPitch, y / taxelPitch)

-- | The composite as a weighted image, to be interpolated.
weighted :: Composite -> Reference
weighted composite =
  either
    (const (referenceOf image))
    id
    (zipRaster (*) image coverage >>= \sums -> reference sums coverage)
  where
    image = compositeImage composite
    coverage = compositeCoverage composite

-- | Images at their places, in taxels from an origin in millimetres, as a composite, with the
-- displacements given, as if these were compared, and no other way to put them together. Its grid
-- is the origin's, moved by whole taxels so that it holds all the images. With an image stands what
-- it counts in the mean, and perhaps the share of each pixel that was felt, 0 to 1: the rest of it
-- counts @interpolated@ in the mean, and @known@ in the coverage.
blended ::
  (Double, Double) ->
  NonEmpty ((Taxels, Raster), Worth) ->
  [Taxels] ->
  Composite
blended (left, top) images displacements =
  Composite
    { compositeImage = means,
      compositeCoverage = coverage,
      compositeOrigin = origin,
      compositeDisplacements = displacements,
      compositePositionError = Nothing,
      compositeUncompared = 0,
      compositeStep = readingStep (map (snd . fst) (NonEmpty.toList images)),
      compositeAxesStated = False,
      compositeTaking = standardTaking,
      compositeOthers = [],
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
      | all ((== inFull) . snd) images =
        (allSums, allWeights, allWeights)
      | otherwise = (total times, total inMean, total inCoverage)
    total value = blendSums (laid (\((place, im), counts) -> (place, value counts im)))
    -- What each pixel of an image counts, if it counts that where it was not felt at all.
    worth least felt im =
      maybe (mapRaster (const 1) im) (mapRaster (\share -> share + least * (1 - share))) felt
    inMean counts im =
      touching counts (mapRaster (worthCount counts *) (worth interpolated (worthFelt counts) im))
    inCoverage counts = touching counts . worth known (worthFelt counts)
    touching counts r = maybe r (orElse r . zipRaster (*) r) (worthTouch counts)
    times counts im = orElse im (zipRaster (*) (inMean counts im) im)
    means = orElse sums (zipRaster (\s w -> if w < leastWeight then 0 else s / w) sums weights)
    -- They are of one size.
    orElse other = either (const other) id

-- | What an image counts where it is blended with others.
data Worth = Worth
  { -- | What it counts in the mean.
    worthCount :: !Double,
    -- | What each pixel's touch counts, 0 to 1: what did not touch is not known. 1 if 'Nothing'.
    worthTouch :: !(Maybe Raster),
    -- | The share of each pixel that living elements felt; 1 if 'Nothing'.
    worthFelt :: !(Maybe Raster)
  }
  deriving stock (Eq, Show)

-- | As an image counts of which all was felt.
inFull :: Worth
inFull = Worth 1 Nothing Nothing

-- | What a value that stands for a dead element counts in a mean, beside 1 of a living one: enough
-- to be the mean where no other frame felt the place.
interpolated :: Double
interpolated = 0.02

-- | What it counts in the coverage: segmentation looks at such a pixel, but any frame that felt it
-- covers it better.
known :: Double
known = 0.5

-- | A pixel with less sensor weight than this counts as not touched: its value would be mostly
-- rounding.
leastWeight :: Double
leastWeight = 0.001
