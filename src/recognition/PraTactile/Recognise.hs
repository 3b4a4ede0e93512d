-- | From composite tactile images to the object's face: symbols, their orientation, the position in
-- the array, and what lies there (the paper's sections II and IV).
--
-- An answer must satisfy two conditions. The probability that it is wrong is at most what the
-- caller tolerates. And no more symbols contradict it than the minimum distance of the recognised
-- symbols' cells can correct. Every other case is refused with a reason.
module PraTactile.Recognise
  ( -- * The recogniser
    Recogniser,
    recogniser,
    recogniserPlacement,
    recogniserScale,
    recogniserReader,
    RecogniserError (..),
    Tolerance (..),
    standardTolerance,

    -- * Recognition
    Recognition (..),
    recognise,
    recogniseWith,
    recognisedAngle,
    leastSkew,

    -- * Recognition in two steps
    FaceReading,
    readFace,
    cellsShown,
    recogniseSeen,

    -- * Symbols
    ReadSymbol (..),
    readDoubt,
    readForeignProbability,

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
    Diagnosis (..),
    refusals,
    refusalName,
  )
where

import Data.Foldable (toList)
import Data.Maybe (isJust)
import PraTactile.Array (Position)
import PraTactile.Classification.Network (NetworkError)
import PraTactile.Composite (asTaken)
import PraTactile.Composite.Skew (leastSkew)
import PraTactile.Field (KnownField)
import PraTactile.Locate (ForeignDoubts (..), Reason (..), doubtOfForeign)
import PraTactile.Recognise.Diagnosis (Diagnosis (..), diagnose)
import PraTactile.Recognise.FaceGrid
import PraTactile.Recognise.FaceReading
import PraTactile.Recognise.Finding
import PraTactile.Recognise.GridLocation
import PraTactile.Recognise.GridOutcome
import PraTactile.Recognise.Layouts
import PraTactile.Recognise.Likeliest
import PraTactile.Recognise.Reading
import PraTactile.Recognise.Recogniser
import PraTactile.Recognise.Recognition
import PraTactile.Recognise.Support
import PraTactile.Recognise.Tolerance
import PraTactile.Registration (Composite (..))

-- | Recognises what a composite shows, with 'standardTolerance'. A composite without an answer is
-- not an error: the reason is in 'recognisedAnswer'. Refuses only what the network refuses.
recognise :: KnownField k => Recogniser k -> Composite -> Either NetworkError Recognition
recognise reader composite = recogniseWith standardTolerance reader [composite]

-- | Recognises what composites of one face show together. Their origins place them relative to each
-- other; the error must be less than a quarter of the symbols' pitch. The face may be turned by any
-- angle. All places in the result are in the given composites' pixels. Refuses what the network
-- refuses.
--
-- Composites whose frames contradict each other get no answer. Other layouts of the frames add to
-- the doubt if they show another place in the array.
recogniseWith ::
  KnownField k =>
  Tolerance ->
  Recogniser k ->
  [Composite] ->
  Either NetworkError Recognition
recogniseWith tolerance reader composites =
  readFace (recogniserReader reader) composites >>= recogniseSeen tolerance reader composites

-- | 'recogniseWith' for composites that were already read by 'readFace', whose result is the last
-- argument.
recogniseSeen ::
  KnownField k =>
  Tolerance ->
  Recogniser k ->
  [Composite] ->
  FaceReading ->
  Either NetworkError Recognition
recogniseSeen tolerance reader composites seen =
  case (contradictions, recognisedAnswer shown) of
    ((composite, found) : _, _) -> do
      agreeing <- traverse (recogniseAsPut tolerance reader . pure) (compositeAgreeing composite)
      let contradiction =
            asTaken (compositeConventions composite) (agreeing >>= shownMirrored) found
      pure shown {recognisedAnswer = Left (FramesContradict contradiction)}
    ([], Right (Found _)) ->
      pure (doubting tolerance (layoutDoubts reader tolerance composites shown) shown)
    (_, Left refusal)
      | refusal `elem` [NoSymbols, SymbolsUnclear] -> do
        there <- diagnose (fmap mostly . recogniseAsPut tolerance reader) composites
        pure shown {recognisedAnswer = Left (ShownInstead there refusal)}
      | notMirrored refusal,
        Just layout <- likelierByFrames tolerance composites ->
        pure shown {recognisedAnswer = Left (FramesContradict layout)}
    _ -> pure shown
  where
    shown = recognitionOf tolerance reader seen
    contradictions =
      [(one, found) | one <- composites, Just found <- [compositeContradiction one]]
    notMirrored refusal = case refusal of
      Mirrored _ -> False
      _ -> True
    mostly found = case recognisedAnswer found of
      Right _ -> True
      Left _ -> mostRecognised (recognisedSymbols found)

-- | Whether the composite is mirrored, according to its recognition; 'Nothing' if no symbol is
-- known.
shownMirrored :: Recognition -> Maybe Bool
shownMirrored shown = case recognisedAnswer shown of
  Left (Mirrored _) -> Just True
  _
    | any (isJust . readClass) (recognisedSymbols shown) -> Just False
    | otherwise -> Nothing

-- | The cells of the array that composites may show, if their frames were placed correctly. They
-- are those of all places that are likely by the symbols alone, for the composites as given and, if
-- they were read so, set upright.
cellsShown :: KnownField k => Tolerance -> Recogniser k -> FaceReading -> [Position]
cellsShown tolerance reader seen =
  foldMap cellsOf (faceAsGiven seen : [upright | (_, _, upright) <- toList (faceUpright seen)])
  where
    cellsOf = foldMap (likelyCells reader tolerance . gridCells . gridReadingCells) . readingOnGrid

-- | 'recogniseWith' as if the frames were certainly placed correctly.
recogniseAsPut ::
  KnownField k =>
  Tolerance ->
  Recogniser k ->
  [Composite] ->
  Either NetworkError Recognition
recogniseAsPut tolerance reader =
  fmap (recognitionOf tolerance reader) . readFace (recogniserReader reader)

-- | Locates what was read. If composites were read both as given and set upright, 'preferred'
-- chooses.
recognitionOf :: KnownField k => Tolerance -> Recogniser k -> FaceReading -> Recognition
recognitionOf tolerance reader seen = case faceUpright seen of
  Nothing -> asGiven
  Just (angle, places, upright) ->
    preferred angle (axesSkewed asGiven) (relocated angle places (located upright))
  where
    asGiven = located (faceAsGiven seen)
    located = either id (locatedReading tolerance reader) . readingOnGrid

-- | Locates symbols and parts on one grid.
locatedReading :: KnownField k => Tolerance -> Recogniser k -> GridReading -> Recognition
locatedReading tolerance reader onGrid =
  Recognition
    (gridReadingSymbols onGrid)
    (gridReadingParts onGrid)
    (gridCells (gridReadingCells onGrid))
    (gridAnchor (gridReadingCells onGrid))
    (locationSupport location)
    (locationLikeliest location)
    (gridReadingSkew onGrid)
    (identificationAt reader (gridReadingSkew onGrid) location)
  where
    location = locateGrid reader tolerance (gridReadingDissenters onGrid) (gridReadingCells onGrid)

-- | The answer or refusal for a located grid, whose symbols are turned by this angle in degrees.
identificationAt ::
  KnownField k => Recogniser k -> Double -> GridLocation -> Either Refusal Identification
identificationAt reader skew location = case locationOutcome location of
  Placed position ->
    maybe
      (Left (NotLocated NoCompleteWindow))
      (Right . Found)
      (findingAt reader skew location position)
  Undecided positions -> Right (Several (locationOrientation location) positions)
  WrongWayUp -> Left OrientationContradicts
  OffTheGrid -> Left GridContradicts
  GroupsApart -> Left WindowsContradict
  Unplaced reason -> Left (NotLocated reason)
  Undecoded why -> Left (NotDecoded why)
