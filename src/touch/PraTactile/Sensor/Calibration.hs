-- | Calibration as a user does it: frames where nothing is touched and frames where every element
-- is pressed alike tell each element's offset and gain, and which are dead.
module PraTactile.Sensor.Calibration
  ( Calibration (..),
    calibrate,
    corrected,
    correctedImage,
    withoutStuck,
    CalibrationError (..),
  )
where

import Data.List (foldl', sort)
import Data.Maybe (fromMaybe)
import qualified Data.Set as Set
import qualified Data.Vector.Storable as V
import PraTactile.Image (Raster, generate, rasterSize, rasterValues)
import PraTactile.Sensor.Dead (filled)
import PraTactile.Sensor.Frame (Frame (..), Pose (..))

-- | What a sensor's readings are corrected by. Both rasters have the sensor's size.
data Calibration = Calibration
  { -- | what each element reads where nothing is touched
    calibrationOffset :: !Raster,
    -- | how much an element's reading rises, as a multiple of the median element's; positive
    calibrationGain :: !Raster,
    -- | the dead elements, row and column, in this order
    calibrationDead :: ![(Int, Int)]
  }
  deriving stock (Eq, Show)

-- | Why frames do not calibrate, or a calibration does not correct a frame.
data CalibrationError
  = -- | There is no dark frame.
    NoDarkFrame
  | -- | There is no flat frame.
    NoFlatFrame
  | -- | Two sizes, width and height, that should be one: the calibration's, or that of the first
    -- frame; and another frame's.
    SensorsDiffer !(Int, Int) !(Int, Int)
  | -- | A reading is infinite or not a number.
    ReadingNotFinite
  | -- | No element reads more in the flat frames than in the dark ones, by 0.02 of full scale.
    AllDead
  | -- | Every element reads full scale in the flat frames, so that its gain is not known.
    AllSaturated
  deriving stock (Eq, Show)

-- | The calibration from dark and flat frames' images. Its noise is that of the means. An element
-- is dead if it rises by less than a quarter of the median element's rise, if it reads more than
-- half of full scale in the dark, or full scale in the flat frames, where nothing tells its gain.
calibrate :: [Raster] -> [Raster] -> Either CalibrationError Calibration
calibrate [] _ = Left NoDarkFrame
calibrate _ [] = Left NoFlatFrame
calibrate darks@(one : _) flats
  | other : _ <- filter (/= size) (map rasterSize (darks ++ flats)) =
    Left (SensorsDiffer size other)
  | not (all (V.all finite . rasterValues) (darks ++ flats)) = Left ReadingNotFinite
  | V.all (>= saturation) flat = Left AllSaturated
  | middle < 0.02 = Left AllDead
  | otherwise =
    Right (Calibration (part (\_ k -> dark `at'` k)) (part gain) (filter isDead places))
  where
    size@(w, h) = rasterSize one
    (dark, flat) = (meanOf darks, meanOf flats)
    rise = V.zipWith (-) flat dark
    -- Of those that tell their gain.
    middle = median [r | (r, f) <- zip (V.toList rise) (V.toList flat), f < saturation]
    part f = generate w h (\x y -> f (y, x) (y * w + x))
    gain place k = if isDead place then 1 else (rise `at'` k) / middle
    places = [(y, x) | y <- [0 .. h - 1], x <- [0 .. w - 1]]
    isDead (y, x) =
      (rise `at'` k) < middle / 4 || (dark `at'` k) > 0.5 || (flat `at'` k) >= saturation
      where
        k = y * w + x
    at' v k = fromMaybe 0 (v V.!? k)
    meanOf images =
      V.map (/ fromIntegral (length images)) (foldr1' (V.zipWith (+)) (map rasterValues images))
    foldr1' f vectors = foldr f (V.replicate (w * h) 0) vectors
    finite v = not (isNaN v || isInfinite v)
    saturation = 0.995

median :: [Double] -> Double
median values = case drop (length values `div` 2) (sort values) of
  v : _ -> v
  [] -> 0

-- | A frame whose image is 'correctedImage', and in which the calibration's dead elements felt
-- nothing, beside those that did not before. Refuses frames of another size.
corrected :: Calibration -> Frame -> Either CalibrationError Frame
corrected calibration = \frame ->
  let felt image = frame {frameImage = image, frameDead = dead frame}
   in felt <$> image' (frameImage frame)
  where
    -- What does not depend on the frame is made once for all.
    image' = correctedImage calibration
    dead frame = Set.toAscList (Set.union (Set.fromList (frameDead frame)) gone)
    gone = Set.fromList (calibrationDead calibration)

-- | Frames in which elements that are stuck were not felt ('correctedImage'): those that read high
-- in every frame, though the sensor moved by 8 elements at least between some two of six frames or
-- more. High is above the middle between what most elements read at least and at most. Nothing is
-- changed where that says nothing: of fewer frames, of frames of several sizes, and where more than
-- a quarter of all elements would be stuck.
withoutStuck :: [Frame] -> [Frame]
withoutStuck frames = case frames of
  one : others
    | length others >= 5,
      moved,
      all ((== size) . rasterSize . frameImage) others,
      not (null stuck),
      4 * length stuck <= w * h ->
      [either (const frame) id (unstuck frame) | frame <- frames]
    where
      size@(w, h) = rasterSize (frameImage one)
      least = V.toList (over min)
      over among = foldl' (V.zipWith among) (values one) (map values others)
      values = rasterValues . frameImage
      high = (median least + median (V.toList (over max))) / 2
      stuck = [k `divMod` w | (k, v) <- zip [0 ..] least, v > high]
      without = Calibration (generate w h (\_ _ -> 0)) (generate w h (\_ _ -> 1)) stuck
      unstuck = corrected without
      moved = extent poseX >= 8 * frameTaxel one || extent poseY >= 8 * frameTaxel one
  _ -> frames
  where
    extent side = maximum (map (side . framePose) frames) - minimum (map (side . framePose) frames)

-- | A sensor's image with each reading less its offset, divided by its gain and clipped to 0..1. A
-- dead element was not felt: in its place stands what 'filled' has. Refuses images of another size.
correctedImage :: Calibration -> Raster -> Either CalibrationError Raster
correctedImage (Calibration offset gain dead) = \image ->
  if rasterSize image /= size
    then Left (SensorsDiffer size (rasterSize image))
    else
      let values = filledIn (V.zipWith3 value (rasterValues image) offsets gains)
       in Right (generate w h (\x y -> values V.! (y * w + x)))
  where
    size@(w, h) = rasterSize offset
    (offsets, gains) = (rasterValues offset, rasterValues gain)
    value reading zero slope = max 0 (min 1 ((reading - zero) / slope))
    -- What does not depend on the image is made once for all.
    filledIn = filled size (Set.filter onSensor (Set.fromList dead))
    onSensor (y, x) = y >= 0 && x >= 0 && y < h && x < w
