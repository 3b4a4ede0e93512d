-- | Stitching (the paper's section IV): overlapping frames with nominal poses become one composite
-- image. Registration corrects their misalignment first; the paper does so by two-dimensional
-- cross-correlation.
module PraTactile.Registration
  ( -- * Composites
    Composite (..),
    CompositeFrame (..),
    AlternativeLayout (..),
    LayoutCause (..),
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
  ( AlternativeLayout (..),
    BlendWeight (..),
    Composite (..),
    CompositeFrame (..),
    Contradiction (..),
    LayoutCause (..),
    blended,
    compositeOf,
    compositePosition,
    likeliestCause,
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
import PraTactile.Sensor.Frame (Frame (..), SensorPose (..), isTaxelPitch)
import PraTactile.Sensor.Manifest (alongAxes)
import PraTactile.Sensor.Resample (canonicalSize, isCanonical)

-- | Why frames cannot be stitched. Frames are numbered from 0 by their place in the list.
data StitchError
  = -- | There is no frame.
    NoFrames
  | -- | There are more frames than 'maxFrames': their number.
    TooManyFrames !Int
  | -- | A frame differs in size from the first, or is not of 4 x 4 to 256 x 256 taxels: its number,
    -- width and height.
    FrameSize !Int !Int !Int
  | -- | A frame is too small to be turned by its rotation, which is not a multiple of 90 degrees:
    -- its number and rotation.
    FrameRotation !Int !Double
  | -- | The pose or a value of this frame is infinite or not a number.
    FrameNotFinite !Int
  | -- | A frame's taxel pitch is not one of 'taxelPitches': its number and its pitch, millimetres.
    FramePitch !Int !Double
  | -- | The frames have more than 'maxFramePixels' pixels together: their number.
    TooManyFramePixels !Int
  | -- | The composite would have more than 'maxCompositePixels' pixels: its width and height,
    -- taxels.
    AreaTooLarge !Double !Double
  | -- | Registration by the chosen method would cost too much.
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

-- | The most pixels that all frames may have together. Each frame counts at its own pitch or at the
-- canonical one, whichever has more pixels.
maxFramePixels :: Int
maxFramePixels = 8388608

-- | Registers frames and blends them into a composite. Each pixel is the mean of the frames there,
-- with bilinear weights. Pixels of dead elements ('frameDead') have next to no weight where a
-- living element felt the place. The order of the frames does not matter, and the composite moves
-- with their poses. A single frame of rotation 0 is returned unchanged. The tables are those of the
-- symbols that may have been felt.
stitch :: LatticeTables -> Registration -> [Frame] -> Either StitchError Composite
stitch tables settings = fmap assemblyComposite . assemble tables Automatic settings

-- | Sets the noise to what the frames show ('frameNoise'), for a sensor of unknown noise.
withNoiseOf :: [Frame] -> Registration -> Registration
withNoiseOf frames settings = settings {registrationNoise = frameNoise (map frameImage frames)}

-- | Blends frames at their nominal places, without registration.
placeOnly :: [Frame] -> Either StitchError Composite
placeOnly =
  fmap assemblyComposite
    . assembledAs (\_ _ -> Right . unarranged Nominal . map (fmap fst)) standardRegistration

-- | A composite, and how it was made.
data Assembly = Assembly
  { assemblyComposite :: !Composite,
    -- | The method that was used; never 'Automatic'.
    assemblyMethod :: !StitchMethod,
    -- | Each frame, in the order of the frames.
    assemblyFrames :: ![Registered],
    -- | The root of the mean squared difference of the frames from the others, as the noise of one
    -- frame; 'Nothing' if no two overlap.
    assemblyResidual :: Maybe Double
  }

-- | Registers frames by the given method, and blends them. The tables are those of the symbols that
-- may have been felt.
assemble :: LatticeTables -> StitchMethod -> Registration -> [Frame] -> Either StitchError Assembly
assemble tables method = assembledAs (arrange tables method)

-- | Registers frames, given the settings, the origin of their places in the robot's coordinates,
-- and each frame with its nominal place; taxels.
type Arranging = Registration -> Taxels -> [(Taxels, Touched)] -> Either TooMuch Arrangement

-- | Checks frames, registers them by the given function, and blends them.
assembledAs :: Arranging -> Registration -> [Frame] -> Either StitchError Assembly
assembledAs arranging settings frames = do
  given <- maybe (Left NoFrames) Right (nonEmpty frames)
  checkFrames given
  unless (usable settings) (Left (UnusableRegistration settings))
  compose arranging settings given

-- | Places frames in taxels, registers them, and blends them.
compose :: Arranging -> Registration -> NonEmpty Frame -> Either StitchError Assembly
compose arranging settings frames = do
  given <- traverse (uncurry uprighted) (NonEmpty.zip (0 :| [1 ..]) frames)
  let scene = placedFrames given
  checkArea (fmap (nominal scene) (placedDistinct scene))
  (seen, arrangement) <- first TooMuchToRegister (arrangedScene arranging supposed scene)
  let put = putTogether scene seen arrangement
      made = blendedScene settings scene arrangement put
  -- Blending relies on this limit.
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
    frameRotation i frame = let SensorPose _ _ r = framePose frame in FrameRotation i r
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

-- | Registers the frames of a scene. If they are tilted, the frames as even presses would read them
-- come first; the result counts if it shows a lattice. Otherwise the frames are registered as they
-- are read.
arrangedScene ::
  Arranging ->
  (NonEmpty Placed -> Registration) ->
  PlacedFrames ->
  Either TooMuch (NonEmpty Placed, Arrangement)
arrangedScene arranging supposed scene = do
  even' <- traverse arranged (evenedPlaced asRead)
  case even' of
    Just found | arrangementMethod (snd found) == ByLattice -> pure found
    _ -> arranged asRead
  where
    asRead = placedDistinct scene
    arranged seen =
      (,) seen
        <$> arranging
          (supposed seen)
          (robotOrigin scene)
          [(placeIn scene p, (placedImage p, placedTouch p)) | p <- toList seen]

-- | A registered frame, ready to be blended.
data Laid = Laid
  { laidFrom :: !Placed,
    -- | Its displacement, taxels.
    laidShift :: !Taxels,
    -- | The place of its upper left pixel after the displacement, taxels.
    laidPlace :: !Taxels,
    -- | Its image on the common scale.
    laidImage :: !Raster,
    laidLevel :: !Level
  }

-- | Moves the frames of a scene by their displacements, and brings them to one scale.
putTogether :: PlacedFrames -> NonEmpty Placed -> Arrangement -> NonEmpty Laid
putTogether scene seen arrangement = NonEmpty.zipWith put (NonEmpty.zip seen levels) shifts
  where
    levels = fromMaybe (fmap (const unlevelled) seen) (nonEmpty (arrangementLevels arrangement))
    shifts =
      fromMaybe
        (fmap (const (0, 0)) seen)
        (nonEmpty (map registeredShift (arrangementFrames arrangement)))
    put (p, level) shift =
      Laid p shift (placeIn scene p `plus` shift) (levelled level (placedImage p)) level

-- | The composite of registered frames, with the findings of their registration.
blendedScene :: Registration -> PlacedFrames -> Arrangement -> NonEmpty Laid -> Composite
blendedScene settings scene arrangement put =
  (blended (placedCorner scene) (fmap counted put) (ofEachFrame scene shifts))
    { compositeUnregisteredError =
        if length put == 1 || compared then 0 else supposedSigma settings,
      compositePositionError = arrangementSigma arrangement,
      compositeLattice = fromRobot <$> arrangementLattice arrangement,
      compositeAlternatives = others,
      compositeContradiction =
        likeliestCause
          (exp decisive)
          (map (placedAt . laidFrom) (toList put))
          [(alternativeCause other, alternativeRatio other) | other <- others],
      compositeFrames = map putFrame (toList put)
    }
  where
    shifts = map registeredShift (arrangementFrames arrangement)
    counted one =
      ( (laidPlace one, laidImage one),
        BlendWeight
          (levelWeight (laidLevel one))
          (placedTouch (laidFrom one))
          (placedFelt (laidFrom one))
      )
    compared =
      arrangementMethod arrangement /= Nominal && isJust (arrangementResidual arrangement)
    fromRobot = movedLattice (robotOrigin scene)
    others =
      [ other {alternativeLattice = fromRobot <$> alternativeLattice other}
        | other <- arrangementAlternatives arrangement
      ]
    -- Its nominal place and its displacement.
    putFrame one =
      let p = laidFrom one
       in CompositeFrame
            (placedAt p)
            (laidShift one)
            (laidImage one)
            (placedTouch p <|> placedFelt p)

checkArea :: NonEmpty (Taxels, Raster) -> Either StitchError ()
checkArea images
  | width * height <= fromIntegral maxCompositePixels = Right ()
  | otherwise = Left (AreaTooLarge width height)
  where
    width = maximum (fmap (\((x, _), image) -> x + fromIntegral (rasterWidth image)) images)
    height = maximum (fmap (\((_, y), image) -> y + fromIntegral (rasterHeight image)) images)

-- | Refuses frames that cannot be placed, or would take too much memory, before any is resampled.
checkFrames :: NonEmpty Frame -> Either StitchError ()
checkFrames frames@(one :| _) = do
  when (length frames > maxFrames) (Left (TooManyFrames (length frames)))
  traverse_ (uncurry (checkFrame one)) (NonEmpty.zip (0 :| [1 ..]) frames)
  when (pixels > maxFramePixels) (Left (TooManyFramePixels pixels))
  where
    pixels = sum (fmap largest frames)
    largest frame = max (area (rasterSize (frameImage frame))) (area (canonicalSize frame))
    area (w, h) = w * h

-- | Refuses the i-th frame if its size differs from the first one's, or if its size, pose, values
-- or pitch are unusable.
checkFrame :: Frame -> Int -> Frame -> Either StitchError ()
checkFrame one i given
  | (w, h) /= rasterSize (frameImage one) || not (possible w && possible h) =
    Left (FrameSize i w h)
  | not (all finite [x, y, r]) || not (V.all finite (rasterValues (frameImage given))) =
    Left (FrameNotFinite i)
  | not (isTaxelPitch (frameTaxel given)) = Left (FramePitch i (frameTaxel given))
  | otherwise = Right ()
  where
    SensorPose x y r = framePose given
    (w, h) = rasterSize (frameImage given)
    possible side = side >= 4 && side <= 256
    finite v = not (isNaN v || isInfinite v)
