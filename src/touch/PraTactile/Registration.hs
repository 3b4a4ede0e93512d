-- | Stitching (the paper's section IV): combines overlapping frames with known nominal poses into
-- one composite image. Two-dimensional cross-correlation corrects the misalignment of successive
-- frames.
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

-- | Why frames cannot be stitched. A frame is named by its index in the list, from 0.
data StitchError
  = -- | There is no frame.
    NoFrames
  | -- | There are this many frames, more than 'maxFrames'.
    TooManyFrames !Int
  | -- | This frame has another size than the first one, or not 4 x 4 to 256 x 256 taxels: its
    -- index, width and height.
    FrameSize !Int !Int !Int
  | -- | This frame is too small to undo its rotation, which is not a multiple of 90 degrees: its
    -- index, and its rotation in degrees.
    FrameRotation !Int !Double
  | -- | The pose of this frame, or one of its values, is infinite or NaN.
    FrameNotFinite !Int
  | -- | The pitch of this frame's taxels is outside 'taxelPitches': its index, and the pitch in
    -- millimetres.
    FramePitch !Int !Double
  | -- | The frames have this many pixels together, more than 'maxFramePixels'.
    TooManyFramePixels !Int
  | -- | The composite would have more than 'maxCompositePixels' pixels, because the frames lie far
    -- apart: its width and height in taxels.
    AreaTooLarge !Double !Double
  | -- | Registering the frames by the requested method would take too much time or memory.
    TooMuchToRegister !TooMuch
  | -- | The settings are unusable: a sigma that is not positive, negative noise, or a search radius
    -- that is negative or above 64 taxels.
    UnusableRegistration !Registration
  deriving stock (Eq, Show)

-- | The most pixels of a composite.
maxCompositePixels :: Int
maxCompositePixels = 4194304

-- | The most pixels of a whole image: 1024 x 1024, which take a second to examine.
maxImagePixels :: Int
maxImagePixels = 1048576

-- | The most frames of a composite.
maxFrames :: Int
maxFrames = 10000

-- | The most pixels of all frames together. A frame counts with its own pixels, or with those at
-- the canonical pitch if these are more.
maxFramePixels :: Int
maxFramePixels = 8388608

-- | Stitches frames: finds their displacements by 'Automatic' and blends them. Each pixel of the
-- composite is the weighted mean of the frames' values there, with bilinear weights. Dead elements
-- ('frameDead') have nearly no weight where another frame has living ones. The composite does not
-- depend on the order of the frames, and if all poses are shifted it is shifted with them. A single
-- frame of rotation 0 is returned as it is. The tables are those of the symbols that may have been
-- touched.
stitch :: LatticeTables -> Registration -> [Frame] -> Either StitchError Composite
stitch tables settings = fmap assemblyComposite . assemble tables Automatic settings

-- | The settings with the noise that the frames show ('frameNoise'), for a sensor whose noise is
-- unknown.
withNoiseOf :: [Frame] -> Registration -> Registration
withNoiseOf frames settings = settings {registrationNoise = frameNoise (map frameImage frames)}

-- | Blends frames at their nominal places: stitching without any correction.
placeOnly :: [Frame] -> Either StitchError Composite
placeOnly =
  fmap assemblyComposite
    . assembledAs (\_ _ -> Right . unarranged Nominal . map (fmap fst)) standardRegistration

-- | A composite, and how its frames were registered.
data Assembly = Assembly
  { assemblyComposite :: !Composite,
    -- | The method that was used; never 'Automatic'.
    assemblyMethod :: !StitchMethod,
    -- | What is known of each frame, in the order of the frames.
    assemblyFrames :: ![Registered],
    -- | The root mean squared difference of each frame from the others at the same places,
    -- expressed as the noise of one frame; 'Nothing' if no two frames overlap.
    assemblyResidual :: Maybe Double
  }

-- | Registers frames by the given method, and blends them. The tables are those of the symbols that
-- may have been touched.
assemble :: LatticeTables -> StitchMethod -> Registration -> [Frame] -> Either StitchError Assembly
assemble tables method = assembledAs (arrange tables method)

-- | A way of arranging frames. Arguments: the settings; the origin of places, in the robot's
-- coordinates; each frame with its nominal place. All lengths are taxels.
type Arranging = Registration -> Taxels -> [(Taxels, Touched)] -> Either TooMuch Arrangement

-- | Checks frames and settings, arranges the frames in the given way, and blends them.
assembledAs :: Arranging -> Registration -> [Frame] -> Either StitchError Assembly
assembledAs arranging settings frames = do
  given <- maybe (Left NoFrames) Right (nonEmpty frames)
  checkFrames given
  unless (usable settings) (Left (UnusableRegistration settings))
  compose arranging settings given

-- | Places frames in taxels, arranges them, and blends them.
compose :: Arranging -> Registration -> NonEmpty Frame -> Either StitchError Assembly
compose arranging settings frames = do
  given <- traverse (uncurry uprighted) (NonEmpty.zip (0 :| [1 ..]) frames)
  let scene = sceneOf given
  checkArea (fmap (nominal scene) (sceneSeen scene))
  (seen, arrangement) <- first TooMuchToRegister (arrangedScene arranging supposed scene)
  let put = putTogether scene seen arrangement
      made = blendedScene settings scene arrangement put
  -- Blending needs memory for the whole area, so the corrected places are checked too.
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

-- | The frames of a scene as they were arranged, and their arrangement. If the presses are tilted,
-- the frames are first corrected to those of even presses; that counts only if they are then
-- registered by a lattice. Otherwise the frames are arranged as they are. The function gives the
-- settings for frames.
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

-- | A frame in its place.
data Laid = Laid
  { laidFrom :: !Placed,
    -- | Its displacement from its nominal place, and the resulting place of its upper left pixel,
    -- in taxels.
    laidShift :: !Taxels,
    laidPlace :: !Taxels,
    -- | Its image, on the common scale of all frames.
    laidImage :: !Raster,
    laidLevel :: !Level
  }

-- | The frames of a scene in the places of an arrangement, on a common scale.
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

-- | The composite of frames in their places, with what their arrangement says about it. Arguments:
-- the settings; the scene; the arrangement; the frames.
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
    -- Its nominal place, and its displacement from there.
    putFrame one =
      let p = laidFrom one
       in PutFrame (placedAt p) (laidShift one) (laidImage one) (placedTouch p <|> placedFelt p)

-- | Refuses images, given with their places in taxels, that extend over more than
-- 'maxCompositePixels' pixels. Places are counted from the composite's upper left corner.
checkArea :: NonEmpty (Taxels, Raster) -> Either StitchError ()
checkArea images
  | width * height <= fromIntegral maxCompositePixels = Right ()
  | otherwise = Left (AreaTooLarge width height)
  where
    width = maximum (fmap (\((x, _), image) -> x + fromIntegral (rasterWidth image)) images)
    height = maximum (fmap (\((_, y), image) -> y + fromIntegral (rasterHeight image)) images)

-- | Refuses frames that cannot be placed or would take too much memory, before any is resampled.
checkFrames :: NonEmpty Frame -> Either StitchError ()
checkFrames frames@(one :| _) = do
  when (length frames > maxFrames) (Left (TooManyFrames (length frames)))
  traverse_ (uncurry (checkFrame one)) (NonEmpty.zip (0 :| [1 ..]) frames)
  when (pixels > maxFramePixels) (Left (TooManyFramePixels pixels))
  where
    pixels = sum (fmap largest frames)
    largest frame = max (area (rasterSize (frameImage frame))) (area (canonicalSize frame))
    area (w, h) = w * h

-- | Refuses a frame of another size than the first one, or with a size, a number or a pitch that no
-- frame has. Arguments: the first frame; the index of the frame; the frame.
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
