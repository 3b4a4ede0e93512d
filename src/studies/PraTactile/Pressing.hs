-- | Presses the simulated sensor on one face of an object, with known truth; and makes the frames
-- that calibrate a sensor.
module PraTactile.Pressing
  ( -- * A region of a face
    pressRegion,

    -- * An object
    Pressing (..),
    pressingWith,
    pressed,
    pressedMesh,
    darkPresses,
    flatPresses,

    -- * What cannot be pressed
    PressError (..),
  )
where

import Control.Monad (when)
import Data.Bifunctor (bimap, first)
import Data.Maybe (fromMaybe)
import PraTactile.Array (PseudorandomArray)
import PraTactile.Explore
import PraTactile.Field (KnownField)
import PraTactile.Object.Mesh (Mesh)
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge (FaceName, ObjectName, Solid, sameFace)
import PraTactile.Relief
import PraTactile.Relief.Mesh
import PraTactile.Sensor
import PraTactile.Sensor.Frame (Frame (..), ProbeError, SensorPose (..), taxelPitch)
import PraTactile.Shape (Alphabet)
import PraTactile.Truth (Truth (..))
import System.Random (RandomGen, StdGen, mkStdGen, randomR, split)

-- | Presses a specimen of a sensor on a region of a face with this relief. The number is the
-- distance between presses, in the sensor's taxels. Poses are nominal, in the robot's frame; images
-- are taken at the true poses. Refuses a region that the presses do not cover.
pressRegion ::
  RandomGen g =>
  Sensor ->
  Int ->
  Specimen ->
  Relief ->
  ProbedRegion ->
  g ->
  Either ProbeError [Frame]
pressRegion sensor spacing one surface region =
  fmap fst
    . exploreWith
      sensor
      spacing
      one
      (heightsUnder sensor region surface)
      (onRelief surface region)

-- | The settings of a press.
data Pressing = Pressing
  { pressingSensor :: Sensor,
    -- | the distance between neighbouring presses, in the sensor's taxels
    pressingSpacing :: Int,
    -- | the seed of every random draw
    pressingSeed :: Int,
    -- | the seed of the specimen's own properties; 'Nothing' for 'pressingSeed'
    pressingSpecimen :: Maybe Int,
    -- | the face, by its vertices from any of them; 'Nothing' for a random one with equal
    -- probabilities
    pressingFace :: Maybe FaceName,
    -- | the region's upper left corner, in millimetres right of and below the face's upper left
    -- vertex; 'Nothing' for a random one
    pressingAt :: Maybe (Double, Double),
    -- | the region's width and height, in taxels
    pressingSize :: (Int, Int),
    pressingTurns :: Turns,
    -- | the region's upper left corner in the robot's coordinates, in millimetres
    pressingOrigin :: (Double, Double),
    -- | the cylinder that the face is wrapped on; 'Nothing' for a flat face
    pressingBend :: Maybe Bend
  }

-- | The settings for a sensor and a seed: its default spacing and region size, anywhere on any face
-- that lies upright or upside down.
pressingWith :: Sensor -> Int -> Pressing
pressingWith sensor seed =
  Pressing
    { pressingSensor = sensor,
      pressingSpacing = defaultSpacing sensor,
      pressingSeed = seed,
      pressingSpecimen = Nothing,
      pressingFace = Nothing,
      pressingAt = Nothing,
      pressingSize = regionSizeFor sensor,
      pressingTurns = AmongTurns halfTurns,
      pressingOrigin = (0, 0),
      pressingBend = Nothing
    }

-- | Why nothing can be pressed.
data PressError
  = -- | There is no such object.
    ObjectRefused PlacementError
  | -- | No face of the object is laid on the array.
    NoFaceLaid
  | -- | The object has no face with this name; its faces are listed.
    NoSuchFace FaceName [LaidFace]
  | -- | The face has no relief.
    NoRelief ReliefError
  | -- | The polyhedron has no relief there.
    NoMeshRelief MeshError
  | -- | A region of this width and height, in millimetres on the face, does not lie on it, and does
    -- not contain it along the sides where it is longer.
    RegionOffFace LaidFace (Double, Double)
  | -- | The cylinder's radius is not above the sensor's 'leastRadius', in millimetres.
    BentTooMuch Double
  | -- | The presses do not cover the region.
    NotCovered ProbeError
  deriving stock (Eq, Show)

-- | Presses a region of an object's face. Returns the frames in the robot's coordinates, and the
-- truth.
pressed ::
  KnownField k =>
  Pressing ->
  Alphabet ->
  PseudorandomArray k ->
  Placement ->
  ObjectName ->
  Either PressError ([Frame], Truth)
pressed how alphabet array layout =
  pressedOn (\_ -> first NoRelief . relief array layout alphabet) how layout

-- | 'pressed' for a polyhedron that was made of the object. It must be scaled so that symbols have
-- the paper's size, and so must the placement.
pressedMesh ::
  Pressing -> Mesh -> Placement -> ObjectName -> Either PressError ([Frame], Truth)
pressedMesh how it = pressedOn (\whole -> first NoMeshRelief . meshRelief it whole) how

-- | 'pressed' with a relief that a function makes for the object's face.
pressedOn ::
  (Solid -> LaidFace -> Either PressError Relief) ->
  Pressing ->
  Placement ->
  ObjectName ->
  Either PressError ([Frame], Truth)
pressedOn reliefOn how layout object = do
  whole <- first ObjectRefused (findObject layout object)
  when (any ((<= least) . bendRadius) (pressingBend how)) (Left (BentTooMuch least))
  (face, generator) <-
    chosenFace [one | one <- laidFaces layout, faceObject (laidFace one) == object]
  flat <- reliefOn whole face
  (region, generator') <- chosenRegion how face generator
  frames <-
    first NotCovered $
      pressRegion
        sensor
        (pressingSpacing how)
        (specimen how)
        flat {reliefBend = pressingBend how}
        region
        generator'
  pure (map moved frames, Truth (laidFace face) region (pressingOrigin how) (pressingBend how))
  where
    sensor = pressingSensor how
    least = leastRadius sensor
    seeded = mkStdGen (pressingSeed how)
    chosenFace faces = case (pressingFace how, faces) of
      (Just name, _)
        | face : _ <- [one | one <- faces, sameFace (faceName (laidFace one)) name] ->
          Right (face, seeded)
        | otherwise -> Left (NoSuchFace name faces)
      (Nothing, one : others) ->
        let (i, generator) = randomR (0, length others) seeded
         in Right (foldr const one (drop i faces), generator)
      (Nothing, []) -> Left NoFaceLaid
    moved frame = frame {framePose = movedPose (framePose frame)}
    movedPose pose =
      pose
        { poseX = poseX pose + fst (pressingOrigin how),
          poseY = poseY pose + snd (pressingOrigin how)
        }

-- | Draws a region, with the requested place and rotation if given. Along each side of the face's
-- bounding box, the shorter of box and region lies within the longer.
chosenRegion :: Pressing -> LaidFace -> StdGen -> Either PressError (ProbedRegion, StdGen)
chosenRegion how face generator
  | onFace region = Right (region, generator')
  | otherwise = Left (RegionOffFace face (bimap millimetres millimetres (regionExtent region)))
  where
    region = maybe id atPlace (pressingAt how) drawn
    (drawn, generator') = drawnRegion (pressingTurns how) (pressingSize how) face generator
    atPlace (x, y) it = it {regionRight = x / taxelPitch, regionDown = y / taxelPitch}
    onFace it =
      within (regionRight it) (fst (regionExtent it)) left wide
        && within (regionDown it) (snd (regionExtent it)) top high
    (left, top) = spotMillimetres (laidBox face)
    (wide, high) = spotMillimetres (laidExtent face)
    within offset side from extent
      | size <= extent = all (>= -1e-9) beside
      | otherwise = all (<= 1e-9) beside
      where
        size = millimetres side
        before = taxelPitch * offset - from
        beside = [before, extent - before - size]
    millimetres taxels = taxelPitch * fromIntegral taxels

-- | The given number of frames of the sensor without contact.
darkPresses :: Pressing -> Int -> [Frame]
darkPresses = untouched darkFrames

-- | The given number of frames of the sensor with all elements pressed to half of full scale.
flatPresses :: Pressing -> Int -> [Frame]
flatPresses = untouched flatFrames

untouched :: (Sensor -> Specimen -> Int -> StdGen -> [Frame]) -> Pressing -> Int -> [Frame]
untouched frames how count = frames (pressingSensor how) (specimen how) count generator
  where
    -- Draws other than those of the specimen.
    generator = snd (split (mkStdGen (pressingSeed how)))

specimen :: Pressing -> Specimen
specimen how =
  fst
    ( drawSpecimen
        (pressingSensor how)
        (mkStdGen (fromMaybe (pressingSeed how) (pressingSpecimen how)))
    )
