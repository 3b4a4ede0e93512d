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
    RecogniserError (..),
    Tolerance (..),
    standardTolerance,

    -- * Recognition
    Recognition (..),
    recognise,
    recogniseWith,
    recognisedAngle,
    leastTilt,

    -- * Symbols
    ReadSymbol (..),
    readDoubt,

    -- * Windows
    ReadWindow (..),

    -- * The answer
    Answer (..),
    Finding (..),
    SymbolPlace (..),
    Evidence (..),
    Doubts (..),
    evidenceDoubt,
    Refusal (..),
    refusals,
    refusalName,
  )
where

import Data.Either (isRight)
import Data.Maybe (isJust, isNothing)
import PraTactile.Array (Position (..))
import PraTactile.Classify.Network (NetworkError)
import PraTactile.Field (KnownField)
import PraTactile.Locate (Reason (..), reasonName, reasons)
import PraTactile.Recognise.FaceGrid
import PraTactile.Recognise.Finding
import PraTactile.Recognise.GridLocation
import PraTactile.Recognise.Parts
import PraTactile.Recognise.Reading
import PraTactile.Recognise.Recogniser
import PraTactile.Segment (Cleaned (..), Segmentation (..), SymbolImage (..), cleaned)
import PraTactile.Segment.Tilt (setUpright, tilt)
import PraTactile.Stitch (Composite)
import PraTactile.Symmetry

-- | What was recognised, whether or not it led to an answer.
data Recognition = Recognition
  { -- | every complete symbol of the composites
    recognisedSymbols :: [ReadSymbol],
    -- | symbols beside them that are not complete, or were not cut out, as far as they tell
    -- anything
    recognisedParts :: [ReadSymbol],
    -- | for the likeliest position, where there is one
    recognisedEvidence :: Maybe Evidence,
    -- | by how many degrees, clockwise, the symbols' axes are turned from the composites', beside
    -- quarter turns: the orientations of symbols and answer come on top of it
    recognisedTilt :: Double,
    recognisedAnswer :: Either Refusal Answer
  }
  deriving stock (Eq, Show)

-- | The answer.
data Answer
  = Found Finding
  | -- | The orientation, and the several positions of the patch's upper left cell that fit what was
    -- recognised (only where the array lacks the window property).
    Several Symmetry [Position]
  deriving stock (Eq, Show)

-- | Why there is no answer; each has a stable name, 'refusalName'.
data Refusal
  = -- | the composite shows no complete symbol
    NoSymbols
  | -- | there are symbols, but the network recognised none
    SymbolsUnclear
  | -- | the network recognises most symbols in the composite's mirror image, and none as it is
    Mirrored
  | -- | symbols disagree about the orientation of the grid
    OrientationContradicts
  | -- | the symbols do not lie on one grid of the array's pitch
    GridContradicts
  | -- | separate groups of symbols lead to different places
    WindowsContradict
  | -- | the recognised cells lead to no position
    NotLocated Reason
  deriving stock (Eq, Show)

-- | All refusals.
refusals :: [Refusal]
refusals =
  [NoSymbols, SymbolsUnclear, Mirrored, OrientationContradicts, GridContradicts, WindowsContradict]
    ++ map NotLocated reasons

-- | The stable name of a refusal, as JSON has it.
refusalName :: Refusal -> String
refusalName refusal = case refusal of
  NoSymbols -> "no-symbols"
  SymbolsUnclear -> "symbols-unclear"
  Mirrored -> "mirrored"
  OrientationContradicts -> "orientation-contradiction"
  GridContradicts -> "grid-contradiction"
  WindowsContradict -> "windows-contradiction"
  NotLocated reason -> reasonName reason

-- | Recognise what a composite image shows, with 'standardTolerance'. Refuses, through 'Either',
-- only what the network refuses.
recognise :: KnownField k => Recogniser k -> Composite -> Either NetworkError Recognition
recognise reader composite = recogniseWith standardTolerance reader [composite]

-- | Recognise what composites of one face show together, whose origins tell how they lie to each
-- other, to less than a quarter of the symbols' pitch. The face may be turned by any angle: where
-- its symbols are not nearly upright by their 'tilt', they are read both as they are and from the
-- composites set upright, and what leaves less doubt about the symbols holds; where both may be
-- read, an answer before a refusal. All places are in the given composites' pixels.
recogniseWith ::
  KnownField k =>
  Tolerance ->
  Recogniser k ->
  [Composite] ->
  Either NetworkError Recognition
recogniseWith tolerance reader given = case tilt (map cleanedComposite composites) of
  Just angle
    | abs angle > leastTilt -> do
      asGiven <- recogniseUpright tolerance reader composites
      let (upright, places) = unzip (map (cleanedUpright angle) composites)
      turnedBack <- recogniseUpright tolerance reader upright
      let setRight = relocated angle places turnedBack
          answeredBy = isRight . recognisedAnswer
      pure $
        if abs angle <= mostTilt && answeredBy asGiven /= answeredBy turnedBack
          then if answeredBy asGiven then asGiven else setRight
          else if certainty turnedBack > certainty asGiven then setRight else asGiven
  _ -> recogniseUpright tolerance reader composites
  where
    composites = map cleaned given

-- | 'setUpright' of a composite without what is foreign.
cleanedUpright :: Double -> Cleaned -> (Cleaned, (Double, Double) -> (Double, Double))
cleanedUpright angle (Cleaned composite forParts foreignThings) =
  (Cleaned upright (fst . setUpright angle <$> forParts) foreignThings, back)
  where
    (upright, back) = setUpright angle composite

-- | Symbols that are turned by no more than this, in degrees, are read as they are: as well as
-- those that are not turned at all, and the estimate of the angle is less certain than that.
leastTilt :: Double
leastTilt = 3

-- | Symbols that are turned by no more than this are still read as they are without error, if not
-- as often.
mostTilt :: Double
mostTilt = 7

-- | How much the symbols say together, in nats: the fewer doubts they leave, the better they were
-- cut out.
certainty :: Recognition -> Double
certainty = sum . map (negate . log . max 1e-300 . readDoubt) . recognisedSymbols

-- | What was recognised in composites that were set upright by an angle, as of the composites as
-- they were given, by where the places of the one are on the other.
relocated :: Double -> [(Double, Double) -> (Double, Double)] -> Recognition -> Recognition
relocated angle places recognition =
  recognition
    { recognisedSymbols = map symbol (recognisedSymbols recognition),
      recognisedParts = map symbol (recognisedParts recognition),
      recognisedTilt = angle + recognisedTilt recognition,
      recognisedAnswer = answer <$> recognisedAnswer recognition
    }
  where
    onFirst = place 0
    place source = case drop source places of
      back : _ -> back
      [] -> id
    symbol s =
      s
        { readAt = onFirst (readAt s),
          readImage =
            (readImage s)
              { symbolCentre = place (readSource s) (symbolCentre (readImage s)),
                symbolAxis = symbolAxis (readImage s) + angle
              }
        }
    answer found = case found of
      Several _ _ -> found
      Found there ->
        Found
          there
            { foundWindow = window (foundWindow there),
              foundWindows = map window (foundWindows there)
            }
    window w = w {windowSeenAt = onFirst (windowSeenAt w)}

-- | By how many degrees, clockwise and in [0, 360), the face is turned as the composites show it,
-- given the orientation that was found.
recognisedAngle :: Recognition -> Symmetry -> Double
recognisedAngle recognition orientation
  | angle < 0 = angle + 360
  | angle >= 360 = angle - 360
  | otherwise = angle
  where
    angle = degreesClockwise orientation + recognisedTilt recognition

-- | 'recogniseWith' of composites whose symbols' axes are nearly theirs.
recogniseUpright ::
  KnownField k =>
  Tolerance ->
  Recogniser k ->
  [Cleaned] ->
  Either NetworkError Recognition
recogniseUpright tolerance reader composites = do
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
      then unanswered (concatMap viewSymbols views ++ known others) Mirrored
      else answered tolerance reader views (known others)
  where
    symbolReader = recogniserReader reader
    known = filter (isJust . readClass) . concatMap viewSymbols

-- | Symbols without an answer, and why.
unanswered :: [ReadSymbol] -> Refusal -> Recognition
unanswered symbols = Recognition symbols [] Nothing 0 . Left

-- | The answer from the symbols of one axis, and from what the network knows of the other.
answered :: KnownField k => Tolerance -> Recogniser k -> [View] -> [ReadSymbol] -> Recognition
answered tolerance reader views dissenters
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
            (locationEvidence location)
            (gridTilt grid)
            (answerAt reader location)

-- | The answer where a grid is located.
answerAt :: KnownField k => Recogniser k -> GridLocation -> Either Refusal Answer
answerAt reader location = case locationOutcome location of
  Placed position ->
    maybe (Left (NotLocated NoCompleteWindow)) (Right . Found) (findingAt reader location position)
  Undecided positions -> Right (Several (locationOrientation location) positions)
  WrongWayUp -> Left OrientationContradicts
  OffTheGrid -> Left GridContradicts
  GroupsApart -> Left WindowsContradict
  Unplaced reason -> Left (NotLocated reason)
