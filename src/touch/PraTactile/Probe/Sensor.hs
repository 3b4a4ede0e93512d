-- | The sensor's forward model (the paper's section III): the height map of a face in, frames out.
--
-- Each tab of the elastic overlay expands without stress, so an element's output is proportional to
-- the height it meets; it is modelled as the mean height under the element's square aperture, one
-- pitch wide, as a share of full scale, with normal noise added, clipped to 0..1.
module PraTactile.Probe.Sensor
  ( -- * What is touched
    HeightMap (..),

    -- * The sensor
    Sensor (..),
    standardSensor,
    idealSensor,

    -- * Touching
    forwardImage,
    press,
    probe,
    scan,
  )
where

import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as V
import PraTactile.Geometry (symbolThickness)
import PraTactile.Image (Raster, generate, index, onRaster)
import PraTactile.Probe (Frame (..), Motion (..), Pose (..), move, sensorSide, taxelPitch)
import PraTactile.Random (normalPair, normals)
import PraTactile.Symmetry
import System.Random (RandomGen)

-- | The relief of a face, constant on square cells: the cell's side in millimetres, and the heights
-- in millimetres above the plane that the probe rests on. The upper left corner of cell (0, 0) is
-- the origin of the face's coordinates. Off the map there is nothing to touch, height 0.
data HeightMap = HeightMap
  { heightPitch :: !Double,
    heightValues :: !Raster
  }
  deriving stock (Eq, Show)

-- | What the simulation needs to know of a sensor and of the robot that carries it.
data Sensor = Sensor
  { -- | The height in millimetres that gives full scale.
    sensorFullScale :: !Double,
    -- | The standard deviation of the noise, as a share of full scale.
    sensorNoise :: !Double,
    -- | The standard deviation of the robot's position error, in taxels, the same along x and y.
    sensorPositionError :: !Double,
    -- | The force of a press in newtons, as the frames state it; the model does not depend on it.
    sensorForce :: !Double
  }
  deriving stock (Eq, Show)

-- | Full scale at a symbol's thickness, noise of 0.1 of full scale, position errors of one taxel,
-- 10 N.
standardSensor :: Sensor
standardSensor = Sensor symbolThickness 0.1 1 10

-- | 'standardSensor' without noise or position error.
idealSensor :: Sensor
idealSensor = standardSensor {sensorNoise = 0, sensorPositionError = 0}

-- | The image without noise at a pose in the face's coordinates, clipped to 0..1: exact for
-- multiples of 90 degrees, where the aperture's overlap with each cell is a product of lengths; for
-- other angles the mean over 8 x 8 points of each aperture.
forwardImage :: Sensor -> HeightMap -> Pose -> Raster
forwardImage sensor (HeightMap cell heights) (Pose x y r)
  | cell <= 0 || full <= 0 = generate sensorSide sensorSide (\_ _ -> 0)
  | otherwise = case turnedByDegrees r of
    -- A sensor turned clockwise sees its surroundings turned counter-clockwise.
    Just symmetry -> onRaster (invert symmetry) upright
    Nothing -> generate sensorSide sensorSide (\i j -> scaled (slanted (r * pi / 180) i j))
  where
    full = sensorFullScale sensor
    scaled height = max 0 (min 1 (height / full))
    half = fromIntegral sensorSide / 2
    upright = generate sensorSide sensorSide (\i j -> scaled (covered (spans x i) (spans y j)))
    -- The cells an aperture meets along one axis, each with the share of the aperture it covers.
    spans centre k = overlaps (start / cell) ((start + taxelPitch) / cell)
      where
        start = centre + taxelPitch * (fromIntegral k - half)
    covered xs ys = sum [wx * wy * heightAt i j | (j, wy) <- ys, (i, wx) <- xs]
    slanted radians i j =
      sum [heightAt (floor (px / cell)) (floor (py / cell)) | (px, py) <- points]
        / fromIntegral (supersampling * supersampling)
      where
        points =
          [ (x + cos radians * u - sin radians * v, y + sin radians * u + cos radians * v)
            | b <- [0 .. supersampling - 1],
              a <- [0 .. supersampling - 1],
              let u = taxelPitch * (fromIntegral (i :: Int) - half + within a),
              let v = taxelPitch * (fromIntegral (j :: Int) - half + within b)
          ]
    within a = (fromIntegral a + 0.5) / fromIntegral supersampling
    heightAt i j = fromMaybe 0 (index heights i j)

supersampling :: Int
supersampling = 8

-- | The unit cells [k, k + 1) that an interval meets, each with the share of the interval that lies
-- in it.
overlaps :: Double -> Double -> [(Int, Double)]
overlaps from to =
  [ (k, share)
    | k <- [floor from .. floor to],
      let share = (min to (fromIntegral k + 1) - max from (fromIntegral k)) / (to - from),
      share > 0
  ]

-- | One press at the true pose, in the face's coordinates: the image with its noise, clipped to
-- 0..1.
press :: RandomGen g => Sensor -> HeightMap -> Pose -> g -> (Raster, g)
press sensor heights pose g
  | sensorNoise sensor <= 0 = (ideal, g)
  | otherwise = (generate sensorSide sensorSide noisy, g')
  where
    ideal = forwardImage sensor heights pose
    (noise, g') = normals (sensorSide * sensorSide) g
    noisy x y = max 0 (min 1 (fromMaybe 0 (index ideal x y) + sensorNoise sensor * deviate x y))
    deviate x y = fromMaybe 0 (noise V.!? (y * sensorSide + x))

-- | One press where the robot means it to be: the motion carries the robot's coordinates to the
-- face's; the pose is the nominal one, in the robot's coordinates. The frame states the nominal
-- pose; its image is taken where the position error, drawn first, has put the sensor.
probe :: RandomGen g => Sensor -> HeightMap -> Motion -> Pose -> g -> (Frame, g)
probe sensor heights motion nominal g = (Frame nominal (sensorForce sensor) image, g'')
  where
    ((ex, ey), g') = normalPair g
    err = sensorPositionError sensor * taxelPitch
    true = nominal {poseX = poseX nominal + err * ex, poseY = poseY nominal + err * ey}
    (image, g'') = press sensor heights (move motion true) g'

-- | 'probe' at each pose in turn.
scan :: RandomGen g => Sensor -> HeightMap -> Motion -> [Pose] -> g -> ([Frame], g)
scan sensor heights motion = go
  where
    go [] g = ([], g)
    go (pose : poses) g =
      let (frame, g') = probe sensor heights motion pose g
          (frames, g'') = go poses g'
       in (frame : frames, g'')
