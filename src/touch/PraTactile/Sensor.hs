-- | The sensor's forward model (the paper's section III): from the height map of a face to frames.
--
-- Each tab of the elastic overlay expands without stress, so an element's output is proportional to
-- the height it meets. By default the output is the mean height under the element's square
-- aperture, one pitch wide, as a share of full scale, plus normal noise, clipped to 0..1. With
-- other constants ("PraTactile.Sensor.Constants") the model is a force sensing array: a rigid press
-- ("PraTactile.Sensor.Press") and its reading ("PraTactile.Sensor.Response").
module PraTactile.Sensor
  ( -- * What is touched
    HeightMap (..),
    heightMap,
    Bend (..),
    BendAxis (..),
    bendAxisName,
    leastRadius,
    longestRadius,

    -- * The sensor
    Sensor (..),
    standardSensor,
    idealSensor,
    Preset (..),
    presetName,
    presetSensor,
    sensorTaxelGrid,
    withTaxel,
    Specimen (..),
    flawless,
    drawSpecimen,

    -- * Touching
    sensorReach,
    forwardImage,
    press,
    probe,
    scan,
    scanWith,

    -- * Calibration frames
    darkFrames,
    flatFrames,
  )
where

import Data.List (unfoldr)
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as V
import PraTactile.Geometry (cosineSine, symbolThickness)
import PraTactile.Image
  ( Raster,
    constant,
    generate,
    index,
    mapRaster,
    onRaster,
    rasterSize,
    zipRaster,
  )
import PraTactile.Random (normal, normalPair, normals)
import PraTactile.Sensor.Bend
import PraTactile.Sensor.Frame (Frame (..), Motion (..), SensorPose (..), move, taxelPitch)
import PraTactile.Sensor.Model
import PraTactile.Sensor.Preset
import PraTactile.Sensor.Press
import PraTactile.Sensor.Response
import PraTactile.Symmetry
import System.Random (RandomGen)

-- | The greatest distance, in mm, from the intended centre of the sensor at which an element may
-- feel something: half the sensor's diagonal with its tabs, plus the greatest position error.
-- Normal draws by Box and Muller's formula from numbers of 53 bits lie within sqrt (106 ln 2) < 8.6
-- standard deviations.
sensorReach :: Sensor -> Double
sensorReach sensor =
  sqrt (side sensorColumns * side sensorColumns + side sensorRows * side sensorRows) / 2
    + sensorTab sensor
    + 8.6 * sensorPositionError sensor * taxelPitch
  where
    side count = fromIntegral (count sensor) * sensorTaxel sensor

-- | The noiseless image at a pose in the face's coordinates, at the nominal force and without
-- tilt, clipped to 0..1.
forwardImage :: Sensor -> HeightMap -> SensorPose -> Raster
forwardImage sensor heights pose =
  mapRaster (max 0 . min 1 . reading sensor) (felt sensor heights pose (sensorForce sensor) (0, 0))

-- | The input of each element at a pose, force (N) and tilts (mm at the sensor's edge): newtons if
-- the model has forces, else shares of full scale.
felt :: Sensor -> HeightMap -> SensorPose -> Double -> (Double, Double) -> Raster
felt sensor heights pose force tilts
  | stiffness > 0 = spread (mapRaster (stiffness *) (displacements stiffness force tilts under))
  | sensorTab sensor > 0 = spread (either (const share) id (zipRaster (*) share (shares height)))
  | otherwise = spread (shares (meanHeights sensor heights pose))
  where
    stiffness = sensorStiffness sensor
    spread = spreadForces (sensorTaxel sensor) (sensorDepth sensor)
    under = tabSupport (sensorTaxelGrid sensor) (sensorTab sensor) heights pose
    share = supportShare under
    height = supportHeight under
    shares = sharesOfScale (sensorFullScale sensor) tilts

-- | The reading, as a share of full scale, for an input given by 'felt'.
reading :: Sensor -> Double -> Double
reading sensor
  | sensorStiffness sensor > 0 =
    conductance (sensorExponent sensor) (sensorBreakForce sensor) (sensorFullForce sensor)
  | otherwise = conductance (sensorExponent sensor) 0 1

-- | Heights in mm as shares of full scale (mm), clipped to 0..1, for a sensor with these tilts.
sharesOfScale :: Double -> (Double, Double) -> Raster -> Raster
sharesOfScale full tilts heights =
  generate w h (\x y -> clipped (at x y + tiltRise (w, h) tilts x y))
  where
    (w, h) = rasterSize heights
    at x y = fromMaybe 0 (index heights x y)
    clipped height = if full > 0 then max 0 (min 1 (height / full)) else 0

-- | The mean height in mm under each element's square aperture. It is exact for multiples of 90
-- degrees, where the overlap of an aperture and a cell is a product of lengths. For other angles it
-- is the mean over 8 x 8 points of each aperture; a bent face's fall is always such a mean. Where
-- there is no surface, the height is 0.
meanHeights :: Sensor -> HeightMap -> SensorPose -> Raster
meanHeights sensor heights (SensorPose x y r)
  | cell <= 0 = constant columns rows 0
  | otherwise = case turnedByDegrees r of
    -- To a sensor turned clockwise its surroundings appear turned counter-clockwise.
    Just symmetry
      | exchangesAxes symmetry -> onRaster (invert symmetry) (upright rows columns)
      | otherwise -> onRaster (invert symmetry) (upright columns rows)
    Nothing -> generate columns rows slanted
  where
    cell = heightPitch heights
    (columns, rows) = (sensorColumns sensor, sensorRows sensor)
    taxel = sensorTaxel sensor
    half count = fromIntegral count / 2
    upright w h =
      generate w h $ \i j ->
        covered (spans alongX w x i) (spans alongY h y j)
          - (fallen alongX w i + fallen alongY h j)
    (alongX, alongY) = courses (heightBend heights)
    begin count k = taxel * (fromIntegral (k :: Int) - half count)
    -- The cells that an aperture meets along one axis, each with the share of the aperture that it
    -- covers.
    spans course count centre k = case course of
      Straight -> overlaps (start / cell) ((start + taxel) / cell)
        where
          start = centre + begin count k
      Round _ ->
        [ (n, share)
          | n <- [cellAt from .. cellAt to],
            let share = (min to (border (n + 1)) - max from (border n)) / taxel,
            share > 0
        ]
        where
          (from, to) = (begin count k, from + taxel)
          cellAt u = floor ((centre + arc course u) / cell)
          border n = chord course (cell * fromIntegral n - centre)
    -- The mean depth of a bent face under an aperture.
    fallen Straight _ _ = 0
    fallen course count k =
      sum [fall course (begin count k + subsample a) | a <- [0 .. supersampling - 1]]
        / fromIntegral supersampling
    covered xs ys = sum [wx * wy * heightAt i j | (j, wy) <- ys, (i, wx) <- xs]
    (c, s) = cosineSine r
    slanted i j =
      sum [surface (c * u - s * v) (s * u + c * v) | (u, v) <- points]
        / fromIntegral (supersampling * supersampling)
      where
        points =
          [ (begin columns i + subsample a, begin rows j + subsample b)
            | b <- [0 .. supersampling - 1],
              a <- [0 .. supersampling - 1]
          ]
    subsample a = taxel * (fromIntegral (a :: Int) + 0.5) / fromIntegral supersampling
    -- The surface's height at a distance from the middle, along the face's axes.
    surface u v =
      heightAt (floor ((x + arc alongX u) / cell)) (floor ((y + arc alongY v) / cell))
        - (fall alongX u + fall alongY v)
    heightAt i j = fromMaybe 0 (heightOf heights i j)

supersampling :: Int
supersampling = 8

-- | The unit cells [k, k + 1) that an interval meets, each with its share of the interval.
overlaps :: Double -> Double -> [(Int, Double)]
overlaps from to =
  [ (k, share)
    | k <- [floor from .. floor to],
      let share = (min to (fromIntegral k + 1) - max from (fromIntegral k)) / (to - from),
      share > 0
  ]

-- | The state of a sensor between presses: the forces of the last press (if the sensor has
-- hysteresis), and the number of presses.
data Memory = Memory !(Maybe Raster) !Int

-- | One press of a flawless specimen at the true pose, in the face's coordinates, as if it were
-- the first. Returns the noisy image, clipped to 0..1.
press :: RandomGen g => Sensor -> HeightMap -> SensorPose -> g -> (Raster, g)
press sensor heights pose g = (image, g')
  where
    (image, _, g') = pressed sensor (flawless sensor) heights pose (Memory Nothing 0) g

-- | One press of a specimen at the true pose, with its state before and after.
pressed ::
  RandomGen g => Sensor -> Specimen -> HeightMap -> SensorPose -> Memory -> g -> (Raster, Memory, g)
pressed sensor specimen heights pose (Memory before count) g0 =
  (image, Memory (if sensorHysteresis sensor > 0 then Just forces else Nothing) (count + 1), g3)
  where
    (deviation, g1) = drawnIf (sensorForceSpread sensor) 0 normal g0
    ((a, b), g2) = drawnIf (sensorTiltSpread sensor) (0, 0) normalPair g1
    force = sensorForce sensor * max 0.05 (1 + sensorForceSpread sensor * deviation)
    tilt t = t * sensorTiltSpread sensor * symbolThickness
    now = felt sensor heights pose force (tilt a, tilt b)
    forces = case before of
      Just earlier ->
        either (const now) id (zipRaster (\f e -> f + sensorHysteresis sensor * e) now earlier)
      Nothing -> now
    (image, g3) = measured sensor specimen (count + 1) (mapRaster (reading sensor) forces) g2

-- | Draws only if the constant is positive; otherwise returns the default and the generator
-- unchanged.
drawnIf :: Double -> a -> (g -> (a, g)) -> g -> (a, g)
drawnIf constantIs without draw g = if constantIs > 0 then draw g else (without, g)

-- | The output of a specimen at its press with the given number (from 1), from error-free
-- readings: it applies gains, drift, crosstalk, noise, dead elements and the converter.
measured :: RandomGen g => Sensor -> Specimen -> Int -> Raster -> g -> (Raster, g)
measured sensor (Specimen gains) number levels g0 = (mapRaster code (alive withNoise), g')
  where
    code = converted (sensorBits sensor) (sensorZeroed sensor)
    amplified = combined (\v gain -> drifted (sensorDrift sensor) number v * gain) levels
    alive = combined (\v gain -> if gain > 0 then v else 0)
    combined f image = either (const image) id (zipRaster f image gains)
    mixed = crosstalk (sensorCrosstalk sensor) amplified
    (withNoise, g') = drawnNoise sensor mixed g0

-- | The readings with noise added.
drawnNoise :: RandomGen g => Sensor -> Raster -> g -> (Raster, g)
drawnNoise sensor image g0
  | sensorNoise sensor <= 0 && sensorNoiseSlope sensor <= 0 = (image, g0)
  | otherwise = (noisy sensor (Deviates own ofRows ofColumns) image, g3)
  where
    (columns, rows) = (sensorColumns sensor, sensorRows sensor)
    (own, g1) = normals (columns * rows) g0
    (ofRows, g2) = drawnIf (sensorRowNoise sensor) V.empty (normals rows) g1
    (ofColumns, g3) = drawnIf (sensorColumnNoise sensor) V.empty (normals columns) g2

-- | One press at a nominal pose by a randomly drawn specimen: 'scan' with one pose. The motion
-- converts the robot's coordinates to the face's; the pose is in the robot's.
probe :: RandomGen g => Sensor -> HeightMap -> Motion -> SensorPose -> g -> (Frame, g)
probe sensor heights motion nominal g = (frame, g3)
  where
    (specimen, g') = drawSpecimen sensor g
    (frame, _, g3) = probed sensor specimen heights motion (Memory Nothing 0) nominal g'

-- | One press at a nominal pose. The motion converts the robot's coordinates to the face's; the
-- nominal pose is in the robot's. The frame states the nominal pose and force. The image is taken
-- at the pose with the errors of position and rotation, which are drawn first.
probed ::
  RandomGen g =>
  Sensor ->
  Specimen ->
  HeightMap ->
  Motion ->
  Memory ->
  SensorPose ->
  g ->
  (Frame, Memory, g)
probed sensor specimen heights motion memory nominal g =
  (Frame nominal (sensorForce sensor) image (sensorTaxel sensor) [], memory', g3)
  where
    ((ex, ey), g') = normalPair g
    (er, g'') = drawnIf (sensorRotationError sensor) 0 normal g'
    err = sensorPositionError sensor * taxelPitch
    true =
      nominal
        { poseX = poseX nominal + err * ex,
          poseY = poseY nominal + err * ey,
          poseRotation = poseRotation nominal + sensorRotationError sensor * er
        }
    (image, memory', g3) = pressed sensor specimen heights (move motion true) memory g''

-- | Presses at each nominal pose in turn, by one specimen, which is drawn first. The motion
-- converts the robot's coordinates to the face's; the poses are in the robot's.
scan :: RandomGen g => Sensor -> HeightMap -> Motion -> [SensorPose] -> g -> ([Frame], g)
scan sensor heights motion poses g = scanWith sensor specimen heights motion poses g'
  where
    (specimen, g') = drawSpecimen sensor g

-- | 'scan' with the given specimen.
scanWith ::
  RandomGen g => Sensor -> Specimen -> HeightMap -> Motion -> [SensorPose] -> g -> ([Frame], g)
scanWith sensor specimen heights motion = go (Memory Nothing 0)
  where
    go _ [] g = ([], g)
    go memory (pose : poses) g =
      let (frame, memory', g') = probed sensor specimen heights motion memory pose g
          (frames, g'') = go memory' poses g'
       in (frame : frames, g'')

-- | The given number of frames of a specimen that touches nothing.
darkFrames :: RandomGen g => Sensor -> Specimen -> Int -> g -> [Frame]
darkFrames = framesAt 0

-- | The given number of frames of a specimen under a bladder that presses all elements equally, to
-- half of full scale.
flatFrames :: RandomGen g => Sensor -> Specimen -> Int -> g -> [Frame]
flatFrames = framesAt 0.5

-- | The given number of frames in which each element's error-free reading is the given level, each
-- as if it were the first.
framesAt :: RandomGen g => Double -> Sensor -> Specimen -> Int -> g -> [Frame]
framesAt level sensor specimen count g0 =
  [Frame (SensorPose 0 0 0) 0 image (sensorTaxel sensor) [] | image <- take count (unfoldr next g0)]
  where
    levels = constant (sensorColumns sensor) (sensorRows sensor) level
    next g = Just (measured sensor specimen 1 levels g)
