{-# LANGUAGE DerivingStrategies #-}

-- | Stitching (the paper's section IV): overlapping frames with their nominal poses to one composite image, the misalignment of successive frames
-- corrected by two-dimensional cross-correlation.
module PraTactile.Stitch
  ( -- * Composites
    Composite (..)
  , compositeOf
  , compositePosition

    -- * Stitching
  , stitch
  , placeOnly
  , Registration (..)
  , standardRegistration
  , StitchError (..)
  , maxCompositePixels
  ) where

import qualified Data.Vector.Storable as V

import PraTactile.Image (Raster, halfTurn, quarterTurn, rasterHeight, rasterValues, rasterWidth, zipRaster)
import PraTactile.Probe (Frame (..), Pose (..), sensorSide, taxelPitch)
import PraTactile.Stitch.Blend (Blend (..), blend)
import PraTactile.Stitch.Composite (Composite (..), compositeOf, compositePosition)
import PraTactile.Stitch.Register (register)
import PraTactile.Stitch.Search (Registration (..), standardRegistration)

-- | Why frames cannot be stitched. Frames are named by their zero-based place in the list.
data StitchError
  = -- | There is no frame.
    NoFrames
  | -- | A frame is not 16 x 16: which, its width and its height.
    FrameSize !Int !Int !Int
  | -- | A frame's rotation is not a multiple of 90 degrees: which, and its rotation.
    FrameRotation !Int !Double
  | -- | A frame's pose or one of its values is infinite or not a number.
    FrameNotFinite !Int
  | -- | The frames lie so far apart that the composite would have more than 'maxCompositePixels' pixels; its width and height, taxels.
    AreaTooLarge !Double !Double
  deriving stock (Eq, Show)

-- | The most pixels a composite may have.
maxCompositePixels :: Int
maxCompositePixels = 4194304

-- | Frames at their corrected places, blended.
stitch :: Registration -> [Frame] -> Either StitchError Composite
stitch settings frames = compose (register settings) frames

-- | Frames at their nominal places, blended: stitching without any correction.
placeOnly :: [Frame] -> Either StitchError Composite
placeOnly = compose (map (const (0, 0)))

-- | Check the frames, place them in taxels, let the function find their displacements, and blend.
compose :: ([((Double, Double), Raster)] -> [(Double, Double)]) -> [Frame] -> Either StitchError Composite
compose displace frames = do
  placed <- traverse upright (zip [0 ..] frames)
  case placed of
    [] -> Left NoFrames
    _ -> do
      let left = minimum (map (fst . fst) placed)
          top = minimum (map (snd . fst) placed)
          nominal = [(((x - left) / taxelPitch, (y - top) / taxelPitch), image) | ((x, y), image) <- placed]
      checkArea nominal
      let displacements = displace nominal
          moved = [((x + dx, y + dy), image) | (((x, y), image), (dx, dy)) <- zip nominal displacements]
          -- The grid is the nominal one, moved by whole pixels so that it holds the frames where they now are.
          x0 = floor (minimum (map (fst . fst) moved)) :: Int
          y0 = floor (minimum (map (snd . fst) moved)) :: Int
          x1 = ceiling (maximum (map (fst . fst) moved)) + sensorSide
          y1 = ceiling (maximum (map (snd . fst) moved)) + sensorSide
          Blend sums weights =
            blend (x1 - x0) (y1 - y0) [((x - fromIntegral x0, y - fromIntegral y0), image) | ((x, y), image) <- moved]
          image = either (const sums) id (zipRaster (\s w -> if w < leastWeight then 0 else s / w) sums weights)
          origin = (left + taxelPitch * fromIntegral x0, top + taxelPitch * fromIntegral y0)
      Right (Composite image weights origin displacements)

-- | A pixel with less sensor weight than this counts as not touched: its value would be mostly rounding.
leastWeight :: Double
leastWeight = 0.001

checkArea :: [((Double, Double), Raster)] -> Either StitchError ()
checkArea nominal
  | width * height > fromIntegral maxCompositePixels = Left (AreaTooLarge width height)
  | otherwise = Right ()
 where
  width = maximum (map (fst . fst) nominal) + fromIntegral sensorSide
  height = maximum (map (snd . fst) nominal) + fromIntegral sensorSide

-- | The millimetre place of the centre of the pixel that is the upper left one once the sensor's own rotation is undone, and the image so turned.
upright :: (Int, Frame) -> Either StitchError ((Double, Double), Raster)
upright (i, Frame (Pose x y r) _ image)
  | rasterWidth image /= sensorSide || rasterHeight image /= sensorSide = Left (FrameSize i (rasterWidth image) (rasterHeight image))
  | not (all finite [x, y, r]) || not (V.all finite (rasterValues image)) = Left (FrameNotFinite i)
  | otherwise = (,) (x - half, y - half) <$> turned
 where
  half = taxelPitch * fromIntegral (sensorSide - 1) / 2
  finite v = not (isNaN v || isInfinite v)
  turned = case r - 360 * fromIntegral (floor (r / 360) :: Integer) of
    0 -> Right image
    90 -> Right (quarterTurn image)
    180 -> Right (halfTurn image)
    270 -> Right (quarterTurn (halfTurn image))
    _ -> Left (FrameRotation i r)
