-- | The whole way from composite tactile images to the object's face: symbols, their orientation,
-- the position in the array, and what lies there (the paper's sections II and IV).
--
-- Nothing is guessed: an answer is likely beyond the doubt that the caller tolerates, and
-- contradicted by no more symbols than the minimum distance of the recognised ones lets be wrong;
-- every other case is a typed refusal.
module PraTactile.Recognise
  ( -- * The recogniser
    Recogniser,
    recogniser,
    recogniserPlacement,
    recogniserReader,
    RecogniserError (..),
    Tolerance (..),
    standardTolerance,

    -- * Recognition
    Recognition (..),
    recognise,
    recogniseWith,
    cellsShown,
    recognisedAngle,
    leastTilt,

    -- * Symbols
    ReadSymbol (..),
    readDoubt,
    readNone,

    -- * Windows
    ReadWindow (..),

    -- * The answer
    Identification (..),
    Finding (..),
    SymbolPlace (..),
    Support (..),
    Doubts (..),
    ForeignDoubts (..),
    doubtOfForeign,
    supportDoubt,
    Refusal (..),
    Instead (..),
    refusals,
    refusalName,
  )
where

import Data.Foldable (toList)
import Data.List (partition)
import Data.Maybe (isJust, isNothing)
import PraTactile.Array (Position)
import PraTactile.Classification.Network (NetworkError)
import PraTactile.Composite (asTaken)
import PraTactile.Composite.Tilt (leastTilt, setUpright, tilt)
import PraTactile.Field (KnownField)
import PraTactile.Locate (ForeignDoubts (..), Reason (..), doubtOfForeign)
import PraTactile.Recognise.Elsewhere
import PraTactile.Recognise.FaceGrid
import PraTactile.Recognise.Finding
import PraTactile.Recognise.GridLocation
import PraTactile.Recognise.Parts
import PraTactile.Recognise.Reading
import PraTactile.Recognise.Recogniser
import PraTactile.Recognise.Recognition
import PraTactile.Recognise.Instead (Instead (..), seenInstead)
import PraTactile.Registration (Composite (..), Fault (..))
import PraTactile.Segmentation (Cleaned (..), Segmentation (..), cleaned)
import PraTactile.Sensor.Manifest (Remedy (..), remedies, straight)
import PraTactile.Symmetry

-- | Recognise what a composite image shows, with 'standardTolerance'. Refuses, through 'Either',
-- only what the network refuses.
recognise :: KnownField k => Recogniser k -> Composite -> Either NetworkError Recognition
recognise reader composite = recogniseWith standardTolerance reader [composite]

-- | Recognise what composites of one face show together, whose origins tell how they lie to each
-- other, to less than a quarter of the symbols' pitch. The face may be turned by any angle. All
-- places are in the given composites' pixels.
--
-- Composites whose frames contradict each other are not answered. What they show if their frames
-- are put together otherwise adds to the doubt where it is something else.
recogniseWith ::
  KnownField k =>
  Tolerance ->
  Recogniser k ->
  [Composite] ->
  Either NetworkError Recognition
recogniseWith tolerance reader composites = do
  shown <- recogniseAsPut tolerance reader composites
  case ([(c, found) | c <- composites, Just found <- [compositeContradiction c]], recognisedAnswer shown) of
    ((composite, found) : _, _) -> do
      agreeing <- traverse (recogniseAsPut tolerance reader . pure) (compositeAgreeing composite)
      let contradiction =
            asTaken (compositeTaking composite) (agreeing >>= shownMirrored) found
      pure shown {recognisedAnswer = Left (FramesContradict contradiction)}
    ([], Right (Found _)) -> do
      let (frames, layouts) =
            partition
              ((== OneFrame) . elsewhereFault)
              (putOtherwise tolerance (recognisedTilt shown) composites)
      others <- traverse (recogniseAsPut tolerance reader . elsewhereComposites) frames
      let oneFrame = sum [elsewhereOdds f | (f, other) <- zip frames others, differs shown other]
          misplaced = layoutDoubts reader tolerance composites shown oneFrame layouts
      pure (doubting tolerance misplaced shown)
    (_, Left refusal)
      | refusal `elem` [NoSymbols, SymbolsUnclear] -> do
        seen <- seenInstead (fmap mostly . recogniseAsPut tolerance reader) composites
        pure shown {recognisedAnswer = Left (ShownInstead seen refusal)}
    _ -> pure shown
  where
    mostly found = case recognisedAnswer found of
      Right _ -> True
      Left _ -> mostRecognised (recognisedSymbols found)


-- | Whether what is recognised is mirrored, as far as that is known.
shownMirrored :: Recognition -> Maybe Bool
shownMirrored shown = case recognisedAnswer shown of
  Left (Mirrored _) -> Just True
  _
    | any (isJust . readClass) (recognisedSymbols shown) -> Just False
    | otherwise -> Nothing

-- | What undoes the mirroring of composites.
unmirroring :: [Cleaned] -> [Remedy]
unmirroring composites = case map cleanedComposite composites of
  composite : _
    | null (compositeFrames composite) -> [remedy {remedyPositions = Nothing} | remedy <- found]
    | otherwise -> found
    where
      found = remedies (compositeTaking composite) straight (Just True)
  [] -> []

-- | The cells of the array that composites may show as their frames were put together, whatever
-- lies there: of all places that are likely by the symbols alone, in each way in which
-- 'recogniseWith' reads them.
cellsShown ::
  KnownField k => Tolerance -> Recogniser k -> [Composite] -> Either NetworkError [Position]
cellsShown tolerance reader composites =
  foldMap (likelyCells reader tolerance . recognisedCells) . bothWays
    <$> readAsPut tolerance reader composites
  where
    bothWays (asGiven, setRight) = asGiven : map snd (toList setRight)

-- | 'recogniseWith' of composites as their frames were put together. Where they are read both as
-- they are and set upright, what is 'preferred' holds.
recogniseAsPut ::
  KnownField k =>
  Tolerance ->
  Recogniser k ->
  [Composite] ->
  Either NetworkError Recognition
recogniseAsPut tolerance reader composites = do
  (asGiven, setRight) <- readAsPut tolerance reader composites
  pure (maybe asGiven (\(angle, other) -> preferred angle asGiven other) setRight)

-- | What is recognised in composites as they are; and, where the symbols are not nearly upright by
-- their 'tilt', that angle and what is recognised in the composites set upright.
readAsPut ::
  KnownField k =>
  Tolerance ->
  Recogniser k ->
  [Composite] ->
  Either NetworkError (Recognition, Maybe (Double, Recognition))
readAsPut tolerance reader given = case tilt (map cleanedComposite composites) of
  Just angle
    | abs angle > leastTilt -> do
      asGiven <- axesTilted <$> recogniseUpright tolerance reader Nothing composites
      let (upright, places) = unzip (map (cleanedUpright angle) composites)
      turnedBack <- recogniseUpright tolerance reader (Just 0) upright
      pure (asGiven, Just (angle, relocated angle places turnedBack))
  shown -> do
    asGiven <- recogniseUpright tolerance reader shown composites
    pure (asGiven, Nothing)
  where
    composites = map cleaned given

-- | 'setUpright' of a composite without what is foreign.
cleanedUpright :: Double -> Cleaned -> (Cleaned, (Double, Double) -> (Double, Double))
cleanedUpright angle (Cleaned composite forParts foreignThings) =
  (Cleaned upright (fst . setUpright angle <$> forParts) foreignThings, back)
  where
    (upright, back) = setUpright angle composite

-- | 'recogniseWith' of composites whose symbols' axes are nearly theirs: turned from them by the
-- angle, in degrees clockwise, as far as the images show it.
recogniseUpright ::
  KnownField k =>
  Tolerance ->
  Recogniser k ->
  Maybe Double ->
  [Cleaned] ->
  Either NetworkError Recognition
recogniseUpright tolerance reader angle composites = do
  upright <- readSymbols symbolReader identity 0 composites
  -- A composite whose upright symbols are known has no others, and one that is flat has none.
  let flat = all ((<= 0) . segmentedContrast . viewSegmentation) upright
      next = length (concatMap viewSymbols upright)
  sideways <-
    if flat || mostKnown upright
      then pure []
      else readSymbols symbolReader (turned 1) next composites
  let (views, others)
        | length (known sideways) > length (known upright) = (sideways, upright)
        | otherwise = (upright, sideways)
  isMirrored <-
    if null (known views) && not flat then readMirrored symbolReader composites else pure False
  pure $
    if isMirrored
      then unanswered (concatMap viewSymbols views ++ known others) (Mirrored (unmirroring composites))
      else answered tolerance reader angle views (known others)
  where
    symbolReader = recogniserReader reader
    known = filter (isJust . readClass) . concatMap viewSymbols

-- | The answer from the symbols of one axis, and from what the network knows of the other.
answered ::
  KnownField k =>
  Tolerance ->
  Recogniser k ->
  Maybe Double ->
  [View] ->
  [ReadSymbol] ->
  Recognition
answered tolerance reader angle views dissenters
  | null symbols = unanswered everything NoSymbols
  | all (isNothing . readClass) symbols = unanswered everything SymbolsUnclear
  | otherwise = maybe (unanswered everything GridContradicts) located (faceGrid (groups symbols))
  where
    symbols = concatMap viewSymbols views
    everything = symbols ++ dissenters
    next = 1 + maximum (-1 : map readNumber everything)
    located grid =
      let (whole, parts) = withParts (recogniserReader reader) views next grid
          location =
            locateGrid reader tolerance dissenters whole
       in Recognition
            everything
            parts
            (gridCells whole)
            (locationSupport location)
            (locationLikeliest location)
            (gridTilt angle grid)
            (identificationAt reader location)

-- | The answer where a grid is located.
identificationAt :: KnownField k => Recogniser k -> GridLocation -> Either Refusal Identification
identificationAt reader location = case locationOutcome location of
  Placed position ->
    maybe (Left (NotLocated NoCompleteWindow)) (Right . Found) (findingAt reader location position)
  Undecided positions -> Right (Several (locationOrientation location) positions)
  WrongWayUp -> Left OrientationContradicts
  OffTheGrid -> Left GridContradicts
  GroupsApart -> Left WindowsContradict
  Unplaced reason -> Left (NotLocated reason)
  Undecoded why -> Left (NotDecoded why)
