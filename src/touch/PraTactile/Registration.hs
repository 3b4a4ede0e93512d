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
import Data.List (sortOn, zipWith4)
import Data.List.NonEmpty (NonEmpty (..), nonEmpty)
import qualified Data.List.NonEmpty as NonEmpty
import Data.Maybe (fromMaybe, isJust)
import qualified Data.Set as Set
import Data.Tuple (swap)
import Data.Vector.Storable (Vector)
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
import PraTactile.Image
  ( Raster,
    generate,
    onRaster,
    rasterHeight,
    rasterSize,
    rasterValues,
    rasterWidth,
  )
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
import PraTactile.Registration.Contact (evened)
import PraTactile.Registration.Lattice.Fit (Touched)
import PraTactile.Registration.Lattice.Template (LatticeTables, latticeTables)
import PraTactile.Registration.Levelling (Level (..), levelled, unlevelled)
import PraTactile.Registration.Numbers (decisive)
import PraTactile.Registration.Search
  ( Registration (..),
    standardRegistration,
    supposedSigma,
    usable,
  )
import PraTactile.Sensor.Frame (Frame (..), Pose (..), isTaxelPitch, taxelPitch)
import PraTactile.Sensor.Manifest (alongAxes)
import PraTactile.Sensor.Resample (atCanonicalPitch, canonicalSize, isCanonical, turnedBack)
import PraTactile.Symmetry

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
  given <- traverse (uncurry upright) (NonEmpty.zip (0 :| [1 ..]) frames)
  let left = minimum (fmap (fst . placedAt) given)
      top = minimum (fmap (snd . placedAt) given)
      inTaxelsFrom (x, y) = (inTaxels (x - left), inTaxels (y - top))
      -- In the robot's own coordinates, which its axes and its scale are of.
      robot = (inTaxels left, inTaxels top)
      (asRead, ofEach) = witnesses (\p -> (swap (inTaxelsFrom (placedAt p)), shown p)) given
      nominalOf = fmap (\p -> (inTaxelsFrom (placedAt p), placedImage p))
      arrangedAs ps =
        arranging
          (supposed ps)
          robot
          [(inTaxelsFrom (placedAt p), (placedImage p, placedTouch p)) | p <- toList ps]
      supposed ps
        | all isCanonical frames = settings
        | otherwise = withMisfit (map placedImage (toList ps)) settings
  checkArea (nominalOf asRead)
  (placed, arrangement) <- first TooMuchToRegister $ do
    even' <- traverse (\ps -> (,) ps <$> arrangedAs ps) (evenedPlaced asRead)
    case even' of
      Just found | arrangementMethod (snd found) == ByLattice -> pure found
      _ -> (,) asRead <$> arrangedAs asRead
  let nominal = nominalOf placed
      arranged = arrangementFrames arrangement
      displacements = map registeredShift arranged
      levels = fromMaybe (fmap (const unlevelled) placed) (nonEmpty (arrangementLevels arrangement))
      onLevel = NonEmpty.zipWith (\level -> fmap (levelled level)) levels nominal
      counts = fmap levelWeight levels
      counted = NonEmpty.zipWith worthOf counts placed
      worthOf count p = Worth count (placedTouch p) (placedFelt p)
      at shifts = maybe onLevel moved (nonEmpty shifts)
      moved = NonEmpty.zipWith movedBy onLevel
      movedBy (place, image) shift = (place `plus` shift, image)
      together shifts =
        (blended (left, top) (NonEmpty.zip (at shifts) counted) (ofEach shifts))
          { compositeUncompared =
              if length placed == 1 || compared then 0 else supposedSigma settings,
            compositePositionError = arrangementSigma arrangement
          }
      compared =
        arrangementMethod arrangement /= Nominal && isJust (arrangementResidual arrangement)
      others =
        [ other {otherwiseLattice = movedLattice robot <$> otherwiseLattice other}
          | other <- arrangementOthers arrangement
        ]
      contradicting =
        likeliestFault
          (exp decisive)
          (map placedAt (toList placed))
          [(otherwiseFault other, otherwiseLikelier other) | other <- others]
      agreeingAlong axes =
        either (const Nothing) (Just . assemblyComposite) $
          compose arranging settings (fmap (along axes) frames)
      along axes frame = frame {framePose = alongAxes axes (framePose frame)}
      -- The frames as they were put, from where the robot would have them.
      putAs ats shifts =
        zipWith4 PutFrame ats shifts (map snd (toList onLevel)) (map touchOf (toList placed))
      touchOf one = placedTouch one <|> placedFelt one
      made =
        (together displacements)
          { compositeLattice = movedLattice robot <$> arrangementLattice arrangement
          }
  -- Blending relies on it.
  checkArea (at displacements)
  pure
    Assembly
      { assemblyComposite =
          made
            { compositeOthers = others,
              compositeContradiction = contradicting,
              compositeAgreeing = case contradicting of
                Just (AgreeingAlong axes) -> agreeingAlong axes
                _ -> Nothing,
              compositeFrames =
                putAs
                  (map placedAt (toList placed))
                  (if null displacements then repeat (0, 0) else displacements)
            },
        assemblyMethod = arrangementMethod arrangement,
        assemblyFrames = ofEach arranged,
        assemblyResidual = arrangementResidual arrangement
      }

-- | What was seen, row by row from the top, each once: the order of frames tells nothing, and one
-- that comes again is no second witness. With it, of what is known of each of these, what is known
-- of all that were given, in their order.
witnesses :: Ord k => (a -> k) -> NonEmpty a -> (NonEmpty a, [b] -> [b])
witnesses key given = (fmap (\((_, one) :| _) -> one) groups, ofEach)
  where
    groups = NonEmpty.groupAllWith1 (key . snd) (NonEmpty.zip (0 :| [1 :: Int ..]) given)
    ofEach told =
      map snd (sortOn fst [(k, b) | (same, b) <- zip (toList groups) told, (k, _) <- toList same])

-- | Millimetres as taxels, rounded to a millionth of one, so that rounding errors of the poses do
-- not decide anything.
inTaxels :: Double -> Double
inTaxels t
  | abs taxels < 1e9 = fromIntegral (round (taxels * million) :: Int) / million
  | otherwise = taxels
  where
    taxels = t / taxelPitch
    million = 1048576

checkArea :: NonEmpty (Taxels, Raster) -> Either StitchError ()
checkArea images
  | width * height <= fromIntegral maxCompositePixels = Right ()
  | otherwise = Left (AreaTooLarge width height)
  where
    width = maximum (fmap (\((x, _), image) -> x + fromIntegral (rasterWidth image)) images)
    height = maximum (fmap (\((_, y), image) -> y + fromIntegral (rasterHeight image)) images)

-- | A frame once its sensor's rotation is undone, at the canonical pitch.
data Placed = Placed
  { -- | Where the centre of its upper left pixel is, millimetres.
    placedAt :: !Taxels,
    placedImage :: !Raster,
    -- | The share of each pixel that living elements felt, where some are dead.
    placedFelt :: !(Maybe Raster),
    -- | What each pixel's touch counts, where some of a tilted press hardly touch.
    placedTouch :: !(Maybe Raster)
  }

-- | The frames as even presses would read them, where they are tilted.
evenedPlaced :: NonEmpty Placed -> Maybe (NonEmpty Placed)
evenedPlaced placed = do
  images <- evened (map placedImage (toList placed))
  nonEmpty (zipWith even' (toList placed) images)
  where
    even' p (image, touch) = p {placedImage = image, placedTouch = Just touch}

-- | All that a frame shows.
shown :: Placed -> (Vector Double, Maybe (Vector Double))
shown frame = (rasterValues (placedImage frame), rasterValues <$> placedFelt frame)

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

-- | A frame with its number as it is placed.
upright :: Int -> Frame -> Either StitchError Placed
upright i given =
  maybe (Left (FrameRotation i r)) Right $ do
    image <- seen given
    let place = (x - half (rasterWidth image), y - half (rasterHeight image))
    felt' <- traverse (seen . felt) (nonEmpty (frameDead given))
    pure (Placed place image felt' Nothing)
  where
    Pose x y r = framePose given
    seen = uprighted . frameImage . atCanonicalPitch
    uprighted = maybe (turnedBack r) (\symmetry -> Just . onRaster symmetry) (turnedByDegrees r)
    felt dead = given {frameImage = generate wide high (share (Set.fromList (toList dead)))}
    share dead u v = if Set.member (v, u) dead then 0 else 1
    (wide, high) = rasterSize (frameImage given)
    half side = taxelPitch * fromIntegral (side - 1) / 2
