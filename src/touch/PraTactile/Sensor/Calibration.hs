-- | Calibration of a sensor from dark frames (nothing touched) and flat frames (all elements
-- pressed equally). They give each element's offset and gain, and show which elements are dead.
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
import PraTactile.Sensor.Frame (Frame (..), SensorPose (..))

-- | The correction of a sensor's readings. Both rasters have the sensor's size.
data Calibration = Calibration
  { -- | the reading of each element when nothing is touched
    calibrationOffset :: !Raster,
    -- | the rise of each element's reading divided by the median element's rise; positive
    calibrationGain :: !Raster,
    -- | the dead elements (row, column), ascending
    calibrationDead :: ![(Int, Int)]
  }
  deriving stock (Eq, Show)

-- | Why a calibration cannot be computed or applied.
data CalibrationError
  = -- | There is no dark frame.
    NoDarkFrame
  | -- | There is no flat frame.
    NoFlatFrame
  | -- | Two sizes (width, height) differ: that of the calibration or of the first frame, and that
    -- of another frame.
    SensorsDiffer !(Int, Int) !(Int, Int)
  | -- | A reading is infinite or NaN.
    ReadingNotFinite
  | -- | No element reads at least 0.02 of full scale more in the flat frames than in the dark
    -- ones.
    AllDead
  | -- | Every element reads full scale in the flat frames, so its gain is unknown.
    AllSaturated
  deriving stock (Eq, Show)

-- | The calibration from the images of dark frames and of flat frames, by their means. An element
-- is dead in three cases: its rise is less than a quarter of the median element's rise; it reads
-- more than half of full scale in the dark; it reads full scale in the flat frames, so that its
-- gain is unknown.
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
    -- Only elements whose gain is known.
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

-- | A frame with its image corrected by 'correctedImage' and the calibration's dead elements added
-- to its own. Refuses frames of another size.
corrected :: Calibration -> Frame -> Either CalibrationError Frame
corrected calibration = \frame ->
  let felt image = frame {frameImage = image, frameDead = dead frame}
   in felt <$> image' (frameImage frame)
  where
    -- Computed once for all frames.
    image' = correctedImage calibration
    dead frame = Set.toAscList (Set.union (Set.fromList (frameDead frame)) gone)
    gone = Set.fromList (calibrationDead calibration)

-- | Marks stuck elements as dead and replaces their readings ('correctedImage'). An element is
-- stuck if it reads high in every frame, although the sensor moved by at least 8 elements between
-- two of at least six frames. High means above the middle between the medians of the elements'
-- least and greatest readings. The frames stay unchanged if they are fewer than six, of several
-- sizes, or if more than a quarter of all elements would be stuck.
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

-- | An image with each reading minus its offset, divided by its gain and clipped to 0..1. The
-- value of a dead element is replaced by 'filled'. Refuses images of another size.
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
    -- Computed once for all images.
    filledIn = filled size (Set.filter onSensor (Set.fromList dead))
    onSensor (y, x) = y >= 0 && x >= 0 && y < h && x < w
