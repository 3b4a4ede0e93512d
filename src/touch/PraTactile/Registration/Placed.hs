{-# OPTIONS_HADDOCK hide #-}

-- | Frames at their nominal places, each once, at the canonical pitch, with their sensors'
-- rotations undone.
module PraTactile.Registration.Placed
  ( Placed (..),
    placed,
    evenedPlaced,
    PlacedFrames (..),
    placedFrames,
    robotOrigin,
    placeIn,
    ofEachFrame,
  )
where

import Data.Foldable (toList)
import qualified Data.IntMap.Strict as IntMap
import Data.List.NonEmpty (NonEmpty (..), nonEmpty)
import qualified Data.List.NonEmpty as NonEmpty
import qualified Data.Set as Set
import Data.Tuple (swap)
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Image
  ( Raster,
    generate,
    onRaster,
    rasterHeight,
    rasterSize,
    rasterValues,
    rasterWidth,
  )
import PraTactile.Registration.Contact (evened)
import PraTactile.Sensor.Frame (Frame (..), SensorPose (..), taxelPitch)
import PraTactile.Sensor.Resample (atCanonicalPitch, turnedBack)
import PraTactile.Symmetry

-- | A frame once its sensor's rotation is undone, at the canonical pitch.
data Placed = Placed
  { -- | The centre of its upper left pixel in the robot's coordinates: x right and y down,
    -- millimetres.
    placedAt :: !(Double, Double),
    placedImage :: !Raster,
    -- | The share of each pixel that living elements felt, if some are dead.
    placedFelt :: !(Maybe Raster),
    -- | The weight of each pixel, 0 to 1, smaller where a tilted press touches less. Only
    -- 'evenedPlaced' sets it.
    placedTouch :: !(Maybe Raster)
  }

-- | Undoes a frame's rotation, at the canonical pitch; 'Nothing' if the frame is too small for
-- that.
placed :: Frame -> Maybe Placed
placed given = do
  image <- seen given
  felt' <- traverse (seen . felt) (nonEmpty (frameDead given))
  let place = (x - half (rasterWidth image), y - half (rasterHeight image))
  pure (Placed place image felt' Nothing)
  where
    SensorPose x y r = framePose given
    seen = uprighted . frameImage . atCanonicalPitch
    uprighted = maybe (turnedBack r) (\symmetry -> Just . onRaster symmetry) (turnedByDegrees r)
    felt dead = given {frameImage = generate wide high (share (Set.fromList (toList dead)))}
    share dead u v = if Set.member (v, u) dead then 0 else 1
    (wide, high) = rasterSize (frameImage given)
    half side = taxelPitch * fromIntegral (side - 1) / 2

-- | The frames as even presses would read them; 'Nothing' unless they are tilted.
evenedPlaced :: NonEmpty Placed -> Maybe (NonEmpty Placed)
evenedPlaced frames = do
  images <- evened (map placedImage (toList frames))
  nonEmpty (zipWith even' (toList frames) images)
  where
    even' p (image, touch) = p {placedImage = image, placedTouch = Just touch}

-- | Frames of one face.
data PlacedFrames = PlacedFrames
  { -- | The least x and the least y of 'placedAt', millimetres. Places ('placeIn', taxels) are
    -- counted from here.
    placedCorner :: !(Double, Double),
    -- | The frames without duplicates, row by row from the top. The order of frames carries no
    -- information, and a duplicate is no second witness.
    placedDistinct :: NonEmpty Placed,
    -- | For each given frame its index in 'placedDistinct'.
    placedGiven :: [Int]
  }

-- | Collects frames of one face, given in any order.
placedFrames :: NonEmpty Placed -> PlacedFrames
placedFrames given =
  PlacedFrames corner (fmap (\((_, one) :| _) -> one) groups) (IntMap.elems numbers)
  where
    corner = (minimum (fmap (fst . placedAt) given), minimum (fmap (snd . placedAt) given))
    groups = NonEmpty.groupAllWith1 (key . snd) (NonEmpty.zip (0 :| [1 ..]) given)
    -- Row by row, and then by all that the frame shows.
    key p = (swap (fromCorner corner p), shown (placedImage p), shown <$> placedFelt p)
    shown = rasterValues
    numbers =
      IntMap.fromList [(k, n) | (n, same) <- zip [0 ..] (toList groups), (k, _) <- toList same]

-- | The origin of places in the robot's coordinates, taxels. Wrong axes or a wrong scale turn or
-- stretch places about the robot's own origin. To undo that, add this to a place, undo it, and
-- subtract this again.
robotOrigin :: PlacedFrames -> Taxels
robotOrigin scene = let (left, top) = placedCorner scene in (inTaxels left, inTaxels top)

-- | The nominal place of a frame's upper left pixel, taxels.
placeIn :: PlacedFrames -> Placed -> Taxels
placeIn = fromCorner . placedCorner

fromCorner :: (Double, Double) -> Placed -> Taxels
fromCorner (left, top) p = let (x, y) = placedAt p in (inTaxels (x - left), inTaxels (y - top))

-- | Expands values of the frames in 'placedDistinct' to all given frames, in their order.
ofEachFrame :: PlacedFrames -> [b] -> [b]
ofEachFrame scene known = [one | n <- placedGiven scene, Just one <- [IntMap.lookup n numbered]]
  where
    numbered = IntMap.fromList (zip [0 ..] known)

-- | Converts millimetres to taxels, rounded to a millionth of one, so that rounding errors of poses
-- decide nothing.
inTaxels :: Double -> Double
inTaxels t
  | abs taxels < 1e9 = fromIntegral (round (taxels * million) :: Int) / million
  | otherwise = taxels
  where
    taxels = t / taxelPitch
    million = 1048576
