-- | Stitching (the paper's section IV): overlapping frames with their nominal poses to one
-- composite image, the misalignment of successive frames corrected by two-dimensional
-- cross-correlation.
module PraTactile.Registration
  ( -- * Composites
    Composite (..),
    PutFrame (..),
    Otherwise (..),
    Fault (..),
    Contradiction (..),
    compositeOf,
    compositePosition,

    -- * Stitching
    LatticeTables,
    latticeTables,
    stitch,
    placeOnly,
    assemble,
    Assembly (..),
    StitchMethod (..),
    Registered (..),
    Registration (..),
    standardRegistration,
    withNoiseOf,
    StitchError (..),
    maxCompositePixels,
    maxImagePixels,
    maxFrames,
    maxFramePixels,
    TooMuch (..),
    maxComparisons,
    maxPairPixels,
    maxLatticePixels,
  )
where

import Control.Applicative ((<|>))
import Control.Monad (unless, when)
import Data.Bifunctor (first)
import Data.Foldable (toList, traverse_)
import Data.List.NonEmpty (NonEmpty (..), nonEmpty)
import qualified Data.List.NonEmpty as NonEmpty
import Data.Maybe (fromMaybe, isJust)
import qualified Data.Vector.Storable as V
import PraTactile.Composite
  ( Composite (..),
    Contradiction (..),
    Fault (..),
    Otherwise (..),
    PutFrame (..),
    Worth (..),
    blended,
    compositeOf,
    compositePosition,
    likeliestFault,
  )
import PraTactile.Composite.Blend (Taxels, plus)
import PraTactile.Composite.Lattice (movedLattice)
import PraTactile.Composite.Noise (frameNoise)
import PraTactile.Image (Raster, rasterHeight, rasterSize, rasterValues, rasterWidth)
import PraTactile.Registration.Arrangement
  ( Arrangement (..),
    Registered (..),
    StitchMethod (..),
    TooMuch (..),
    arrange,
    maxComparisons,
    maxLatticePixels,
    maxPairPixels,
    unarranged,
    withMisfit,
  )
import PraTactile.Registration.Lattice.Fit (Touched)
import PraTactile.Registration.Lattice.Template (LatticeTables, latticeTables)
import PraTactile.Registration.Levelling (Level (..), levelled, unlevelled)
import PraTactile.Registration.Numbers (decisive)
import PraTactile.Registration.Placed
import PraTactile.Registration.Settings
  ( Registration (..),
    standardRegistration,
    supposedSigma,
    usable,
  )
import PraTactile.Sensor.Frame (Frame (..), Pose (..), isTaxelPitch)
import PraTactile.Sensor.Manifest (alongAxes)
import PraTactile.Sensor.Resample (canonicalSize, isCanonical)

-- | Why frames cannot be stitched. Frames are named by their zero-based place in the list.
data StitchError
  = -- | There is no frame.
    NoFrames
  | -- | There are more frames than 'maxFrames': how many.
    TooManyFrames !Int
  | -- | A frame is not of the first one's size, or not of 4 x 4 to 256 x 256 taxels: which, its
    -- width and its height.
    FrameSize !Int !Int !Int
  | -- | A frame is too small to be turned by its rotation, which is not a multiple of 90 degrees:
    -- which, and its rotation.
    FrameRotation !Int !Double
  | -- | A frame's pose or one of its values is infinite or not a number.
    FrameNotFinite !Int
  | -- | The pitch of a frame's taxels is none of 'taxelPitches': which, and its pitch, millimetres.
    FramePitch !Int !Double
  | -- | The frames have more than 'maxFramePixels' pixels together: how many.
    TooManyFramePixels !Int
  | -- | The frames lie so far apart that the composite would have more than 'maxCompositePixels'
    -- pixels; its width and height, taxels.
    AreaTooLarge !Double !Double
  | -- | To register the frames by the method asked for would take too much.
    TooMuchToRegister !TooMuch
  | -- | The settings are unusable: a sigma that is not positive, negative noise, or a search radius
    -- that is negative or above 64 taxels.
    UnusableRegistration !Registration
  deriving stock (Eq, Show)

-- | The most pixels a composite may have.
maxCompositePixels :: Int
maxCompositePixels = 4194304

-- | The most pixels a whole image may have: 1024 x 1024, which take a second to examine.
maxImagePixels :: Int
maxImagePixels = 1048576

-- | The most frames a composite may be made of.
maxFrames :: Int
maxFrames = 10000

-- | The most pixels that frames may have together, each as it is given or at the canonical pitch,
-- where it has more.
maxFramePixels :: Int
maxFramePixels = 8388608

-- | Frames at their corrected places, blended: each pixel of the composite is the mean of what the
-- frames saw there, with bilinear weights; what stands for a dead element ('frameDead') counts next
-- to nothing where a living one felt the place. The composite does not depend on the order of the
-- frames, and moves with their poses. A single frame of rotation 0 is returned as it is. The tables
-- are those of the symbols that may have been felt.
stitch :: LatticeTables -> Registration -> [Frame] -> Either StitchError Composite
stitch tables settings = fmap assemblyComposite . assemble tables Automatic settings

-- | Settings with the noise that the frames show ('frameNoise'), for a sensor whose noise is not
-- known.
withNoiseOf :: [Frame] -> Registration -> Registration
withNoiseOf frames settings = settings {registrationNoise = frameNoise (map frameImage frames)}

-- | Frames at their nominal places, blended: stitching without any correction.
placeOnly :: [Frame] -> Either StitchError Composite
placeOnly =
  fmap assemblyComposite
    . assembledAs (\_ _ -> Right . unarranged Nominal . map (fmap fst)) standardRegistration

-- | A composite, and how it came about.
data Assembly = Assembly
  { assemblyComposite :: !Composite,
    -- | The method that was used; never 'Automatic'.
    assemblyMethod :: !StitchMethod,
    -- | Each frame, in the order of the frames.
    assemblyFrames :: ![Registered],
    -- | The root of the mean squared difference of the frames from what others saw there, as the
    -- noise of one frame; 'Nothing' where no two overlap.
    assemblyResidual :: Maybe Double
  }

-- | Frames registered by the given method, and blended. The tables are those of the symbols that
-- may have been felt.
assemble :: LatticeTables -> StitchMethod -> Registration -> [Frame] -> Either StitchError Assembly
assemble tables method = assembledAs (arrange tables method)

-- | How frames are arranged by settings, where their places count from in the robot's coordinates,
-- and each frame with its nominal place; taxels.
type Arranging = Registration -> Taxels -> [(Taxels, Touched)] -> Either TooMuch Arrangement

-- | Frames arranged so, and blended.
assembledAs :: Arranging -> Registration -> [Frame] -> Either StitchError Assembly
assembledAs arranging settings frames = do
  given <- maybe (Left NoFrames) Right (nonEmpty frames)
  checkFrames given
  unless (usable settings) (Left (UnusableRegistration settings))
  compose arranging settings given

-- | Place frames in taxels, arrange them, and blend.
compose :: Arranging -> Registration -> NonEmpty Frame -> Either StitchError Assembly
compose arranging settings frames = do
  given <- traverse (uncurry uprighted) (NonEmpty.zip (0 :| [1 ..]) frames)
  let scene = sceneOf given
  checkArea (fmap (nominal scene) (sceneSeen scene))
  (seen, arrangement) <- first TooMuchToRegister (arrangedScene arranging supposed scene)
  let put = putTogether scene seen arrangement
      made = blendedScene settings scene arrangement put
  -- Blending relies on it.
  checkArea (fmap (\one -> (laidPlace one, laidImage one)) put)
  pure
    Assembly
      { assemblyComposite = made {compositeAgreeing = agreeing (compositeContradiction made)},
        assemblyMethod = arrangementMethod arrangement,
        assemblyFrames = ofEachFrame scene (arrangementFrames arrangement),
        assemblyResidual = arrangementResidual arrangement
      }
  where
    uprighted i frame = maybe (Left (frameRotation i frame)) Right (placed frame)
    frameRotation i frame = let Pose _ _ r = framePose frame in FrameRotation i r
    nominal scene p = (placeIn scene p, placedImage p)
    supposed seen
      | all isCanonical frames = settings
      | otherwise = withMisfit (map placedImage (toList seen)) settings
    agreeing contradiction = case contradiction of
      Just (AgreeingAlong axes) ->
        either (const Nothing) (Just . assemblyComposite) $
          compose arranging settings (fmap (along axes) frames)
      _ -> Nothing
    along axes frame = frame {framePose = alongAxes axes (framePose frame)}

-- | The frames of a scene arranged by the settings for them: as even presses would read them, if
-- they are tilted and then show a lattice; otherwise as they are read.
arrangedScene ::
  Arranging ->
  (NonEmpty Placed -> Registration) ->
  Scene ->
  Either TooMuch (NonEmpty Placed, Arrangement)
arrangedScene arranging supposed scene = do
  even' <- traverse arranged (evenedPlaced asRead)
  case even' of
    Just found | arrangementMethod (snd found) == ByLattice -> pure found
    _ -> arranged asRead
  where
    asRead = sceneSeen scene
    arranged seen =
      (,) seen
        <$> arranging
          (supposed seen)
          (robotOrigin scene)
          [(placeIn scene p, (placedImage p, placedTouch p)) | p <- toList seen]

-- | A frame as it is put.
data Laid = Laid
  { laidFrom :: !Placed,
    -- | Its displacement, and where its upper left pixel then lies, taxels.
    laidShift :: !Taxels,
    laidPlace :: !Taxels,
    -- | Its image, on the scale of all.
    laidImage :: !Raster,
    laidLevel :: !Level
  }

-- | The frames of a scene where an arrangement has them, on one scale.
putTogether :: Scene -> NonEmpty Placed -> Arrangement -> NonEmpty Laid
putTogether scene seen arrangement = NonEmpty.zipWith put (NonEmpty.zip seen levels) shifts
  where
    levels = fromMaybe (fmap (const unlevelled) seen) (nonEmpty (arrangementLevels arrangement))
    shifts =
      fromMaybe
        (fmap (const (0, 0)) seen)
        (nonEmpty (map registeredShift (arrangementFrames arrangement)))
    put (p, level) shift =
      Laid p shift (placeIn scene p `plus` shift) (levelled level (placedImage p)) level

-- | The composite of frames that are put, with what their arrangement tells.
blendedScene :: Registration -> Scene -> Arrangement -> NonEmpty Laid -> Composite
blendedScene settings scene arrangement put =
  (blended (sceneCorner scene) (fmap counted put) (ofEachFrame scene shifts))
    { compositeUncompared = if length put == 1 || compared then 0 else supposedSigma settings,
      compositePositionError = arrangementSigma arrangement,
      compositeLattice = fromRobot <$> arrangementLattice arrangement,
      compositeOthers = others,
      compositeContradiction =
        likeliestFault
          (exp decisive)
          (map (placedAt . laidFrom) (toList put))
          [(otherwiseFault other, otherwiseLikelier other) | other <- others],
      compositeFrames = map putFrame (toList put)
    }
  where
    shifts = map registeredShift (arrangementFrames arrangement)
    counted one =
      ( (laidPlace one, laidImage one),
        Worth
          (levelWeight (laidLevel one))
          (placedTouch (laidFrom one))
          (placedFelt (laidFrom one))
      )
    compared =
      arrangementMethod arrangement /= Nominal && isJust (arrangementResidual arrangement)
    fromRobot = movedLattice (robotOrigin scene)
    others =
      [ other {otherwiseLattice = fromRobot <$> otherwiseLattice other}
        | other <- arrangementOthers arrangement
      ]
    -- As it was put, from where the robot would have it.
    putFrame one =
      let p = laidFrom one
       in PutFrame (placedAt p) (laidShift one) (laidImage one) (placedTouch p <|> placedFelt p)

checkArea :: NonEmpty (Taxels, Raster) -> Either StitchError ()
checkArea images
  | width * height <= fromIntegral maxCompositePixels = Right ()
  | otherwise = Left (AreaTooLarge width height)
  where
    width = maximum (fmap (\((x, _), image) -> x + fromIntegral (rasterWidth image)) images)
    height = maximum (fmap (\((_, y), image) -> y + fromIntegral (rasterHeight image)) images)

-- | Refuses frames that cannot be placed, or would take too much memory, before one is resampled.
checkFrames :: NonEmpty Frame -> Either StitchError ()
checkFrames frames@(one :| _) = do
  when (length frames > maxFrames) (Left (TooManyFrames (length frames)))
  traverse_ (uncurry (checkFrame one)) (NonEmpty.zip (0 :| [1 ..]) frames)
  when (pixels > maxFramePixels) (Left (TooManyFramePixels pixels))
  where
    pixels = sum (fmap largest frames)
    largest frame = max (area (rasterSize (frameImage frame))) (area (canonicalSize frame))
    area (w, h) = w * h

-- | Refuses a frame, which has this number, that is not of the first one's size or not of numbers
-- that a frame has.
checkFrame :: Frame -> Int -> Frame -> Either StitchError ()
checkFrame one i given
  | (w, h) /= rasterSize (frameImage one) || not (possible w && possible h) =
    Left (FrameSize i w h)
  | not (all finite [x, y, r]) || not (V.all finite (rasterValues (frameImage given))) =
    Left (FrameNotFinite i)
  | not (isTaxelPitch (frameTaxel given)) = Left (FramePitch i (frameTaxel given))
  | otherwise = Right ()
  where
    Pose x y r = framePose given
    (w, h) = rasterSize (frameImage given)
    possible side = side >= 4 && side <= 256
    finite v = not (isNaN v || isInfinite v)
