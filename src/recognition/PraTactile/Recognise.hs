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

    -- * Symbols
    ReadSymbol (..),
    readDoubt,
    Orientation (..),
    orientationDegrees,
    isSideways,
    onComposite,

    -- * Windows
    ReadWindow (..),

    -- * The answer
    Answer (..),
    Finding (..),
    SymbolPlace (..),
    Evidence (..),
    Refusal (..),
    refusals,
    refusalName,
  )
where

import Data.List (sortOn)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust, isNothing, listToMaybe)
import Data.Ord (Down (..))
import PraTactile.Array (Position (..), PseudorandomArray, Shape (..), Surface, arrayShape, cellAt)
import PraTactile.Classify.Network (Network, NetworkError, outputCount)
import PraTactile.Classify.Templates (templates)
import PraTactile.Field (KnownField, fieldOrder, toCode)
import PraTactile.Geometry (columnPitch, rowPitch)
import PraTactile.Locate (LocateError, Reason (..), reasonName, reasons)
import PraTactile.Locate.Decoder.Codebook
import PraTactile.Object.Canonical (canonicalPitch)
import PraTactile.Object.Placement
  ( Pitch,
    Placement,
    Whereabouts (..),
    placementPitch,
    placementShape,
    whereabouts,
  )
import PraTactile.Recognise.FaceGrid
import PraTactile.Recognise.Judgement
import PraTactile.Recognise.Parts
import PraTactile.Recognise.Reading
import PraTactile.Segment (Segmentation (..))
import PraTactile.Segment.Lattice (Cell)
import PraTactile.Shape (Alphabet, alphabetSize)
import PraTactile.Stitch (Composite)
import PraTactile.Window (Mask, maskExtent)

-- | All that recognition needs: the array with all its positions, the placement of the faces, the
-- shapes and the trained network.
data Recogniser k = Recogniser
  { recogniserBook :: Codebook k,
    recogniserWindow :: Shape,
    -- | the placement that positions are looked up in
    recogniserPlacement :: Placement,
    recogniserReader :: Reader
  }

-- | Why there is no recogniser.
data RecogniserError
  = -- | The array cannot be compared with.
    RecogniserArray LocateError
  | -- | The network has this many outputs, the alphabet this many shapes, and the field this many
    -- elements, which must be as many.
    ClassesDiffer Int Int Int
  | -- | The objects are laid on an array of the first shape; the array has the second.
    ArraysDiffer Shape Shape
  | -- | The objects' symbols are the first distances apart; symbols are read at the second.
    PitchesDiffer Pitch Pitch
  deriving stock (Eq, Show)

-- | A recogniser for rectangular windows on an array and its surface. Refuses what 'buildCodebook'
-- refuses, classes that are not one an element, and a placement on an array of another shape or
-- with symbols at another pitch than 'canonicalPitch', at which they are read.
recogniser ::
  KnownField k =>
  Surface ->
  PseudorandomArray k ->
  Mask ->
  Placement ->
  Alphabet ->
  Network ->
  Either RecogniserError (Recogniser k)
recogniser surface array window layout alphabetOfAll network
  | any (/= q) [given, shaped] = Left (ClassesDiffer given shaped q)
  | placementShape layout /= arrayShape array =
    Left (ArraysDiffer (placementShape layout) (arrayShape array))
  | placementPitch layout /= canonicalPitch =
    Left (PitchesDiffer (placementPitch layout) canonicalPitch)
  | otherwise = do
    shelf <- either (Left . RecogniserArray) Right (buildCodebook surface array window)
    pure (Recogniser shelf (maskExtent window) layout (Reader (templates alphabetOfAll) network))
  where
    q = fieldOrder array
    given = outputCount network
    shaped = alphabetSize alphabetOfAll

-- | A window of the array that was found.
data ReadWindow = ReadWindow
  { -- | in the array
    windowPosition :: Position,
    -- | row by row, as seen on the face; 'Nothing' where no symbol was recognised as the array's
    windowClasses :: [[Maybe Int]],
    -- | its centre, by those of its symbols that were seen, as 'readAt' has it
    windowSeenAt :: (Double, Double),
    -- | what lies there
    windowWhereabouts :: Whereabouts
  }
  deriving stock (Eq, Show)

-- | Where a symbol is in the array.
data SymbolPlace = SymbolPlace
  { -- | its cell
    symbolCell :: Position,
    -- | the class that the array has there
    symbolExpected :: Int
  }
  deriving stock (Eq, Show)

-- | What was recognised, whether or not it led to an answer.
data Recognition = Recognition
  { -- | every complete symbol of the composites
    recognisedSymbols :: [ReadSymbol],
    -- | symbols beside them that are not complete, or were not cut out, as far as they tell
    -- anything
    recognisedParts :: [ReadSymbol],
    -- | for the likeliest position, where there is one
    recognisedEvidence :: Maybe Evidence,
    recognisedAnswer :: Either Refusal Answer
  }
  deriving stock (Eq, Show)

-- | The answer.
data Answer
  = Found Finding
  | -- | The orientation, and the several positions of the patch's upper left cell that fit what was
    -- recognised (only where the array lacks the window property).
    Several Orientation [Position]
  deriving stock (Eq, Show)

-- | Where the composites are.
data Finding = Finding
  { foundOrientation :: Orientation,
    -- | the first complete window in reading order; if there is none, the first of those with the
    -- most recognised symbols
    foundWindow :: ReadWindow,
    -- | all complete windows, in reading order
    foundWindows :: [ReadWindow],
    -- | by the symbols' numbers
    foundPlaces :: Map Int SymbolPlace
  }
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
-- other, to less than a quarter of the symbols' pitch.
recogniseWith ::
  KnownField k =>
  Tolerance ->
  Recogniser k ->
  [Composite] ->
  Either NetworkError Recognition
recogniseWith tolerance reader composites = do
  upright <- readSymbols (recogniserReader reader) False 0 composites
  -- A composite whose upright symbols are known has no others, and one that is flat has none.
  let flat = all ((<= 0) . segmentedContrast . viewSegmentation) upright
      next = length (concatMap viewSymbols upright)
  sideways <-
    if flat || mostKnown upright
      then pure []
      else readSymbols (recogniserReader reader) True next composites
  let known = length . filter (isJust . readClass) . concatMap viewSymbols
      (views, others) =
        if known sideways > known upright then (sideways, upright) else (upright, sideways)
  mirrored <-
    if known views == 0 && not flat
      then readMirrored (recogniserReader reader) composites
      else pure False
  pure
    ( answered
        tolerance
        reader
        mirrored
        views
        (filter (isJust . readClass) (concatMap viewSymbols others))
    )

-- | The answer from the symbols of one axis, and from what the network knows of the other.
answered ::
  KnownField k =>
  Tolerance ->
  Recogniser k ->
  Bool ->
  [View] ->
  [ReadSymbol] ->
  Recognition
answered tolerance reader mirrored views dissenters
  | mirrored = refused Mirrored
  | null symbols = refused NoSymbols
  | all (isNothing . readClass) symbols = refused SymbolsUnclear
  | otherwise = case faceGrid (groups symbols) of
    Nothing -> refused GridContradicts
    Just grid ->
      let (whole, parts) =
            withParts
              (recogniserReader reader)
              views
              (1 + maximum (-1 : map readNumber everything))
              grid
          judgement = judge (recogniserBook reader) tolerance dissenters whole
       in Recognition everything parts (judgedEvidence judgement) (fromJudgement reader judgement)
  where
    symbols = concatMap viewSymbols views
    everything = symbols ++ dissenters
    refused = Recognition everything [] Nothing . Left

fromJudgement :: KnownField k => Recogniser k -> Judgement -> Either Refusal Answer
fromJudgement reader judgement = case judgedRuling judgement of
  Placed position ->
    maybe (Left (NotLocated NoCompleteWindow)) (Right . Found) (foundAt reader judgement position)
  Undecided positions -> Right (Several (judgedOrientation judgement) positions)
  WrongWayUp -> Left OrientationContradicts
  OffTheGrid -> Left GridContradicts
  GroupsApart -> Left WindowsContradict
  Unplaced reason -> Left (NotLocated reason)

-- | The answer when the grid's upper left cell is at this position.
foundAt :: KnownField k => Recogniser k -> Judgement -> Position -> Maybe Finding
foundAt reader judgement position = do
  window <- listToMaybe (if null complete then sortOn (Down . felt) windows else complete)
  pure
    Finding
      { foundOrientation = judgedOrientation judgement,
        foundWindow = window,
        foundWindows = complete,
        foundPlaces =
          Map.fromList
            [ (readNumber s, place)
              | (cell, here) <- Map.toList cells,
                Just place <- [placeOf cell],
                s <- here
            ]
      }
  where
    cells = judgedCells judgement
    array = codebookArray (recogniserBook reader)
    place0 = cellFrom (recogniserBook reader) position
    placeOf cell = (\p -> SymbolPlace p (toCode (cellAt array p))) <$> place0 cell
    -- Cells with a symbol that the network knows as what the array has there.
    right = Map.mapMaybeWithKey agreeing cells
    agreeing cell here = do
      expected <- symbolExpected <$> placeOf cell
      if any ((== Just (judgedOrientation judgement, expected)) . readClass) here
        then Just expected
        else Nothing
    windows =
      [ window
        | i <- [0 .. fst end],
          j <- [0 .. snd end],
          Just window <- [windowIn reader judgement right place0 (i, j)]
      ]
    end = (maximum (0 : map fst (Map.keys cells)), maximum (0 : map snd (Map.keys cells)))
    complete = filter (all (all isJust) . windowClasses) windows
    felt window =
      (length (filter isJust (concat (windowClasses window))), onFace (windowWhereabouts window))
    onFace w = case w of
      OnFace _ -> True
      _ -> False

-- | The window whose upper left cell is this one of the grid.
windowIn ::
  Recogniser k ->
  Judgement ->
  Map Cell Int ->
  (Cell -> Maybe Position) ->
  Cell ->
  Maybe ReadWindow
windowIn reader judgement right place0 (i, j) = do
  position <- place0 (i, j)
  pure
    ReadWindow
      { windowPosition = position,
        windowClasses = [[Map.lookup cell right | cell <- line] | line <- block],
        windowSeenAt = centroid centres,
        windowWhereabouts = whereabouts (recogniserPlacement reader) window position
      }
  where
    window = recogniserWindow reader
    block = [[(i + di, j + dj) | dj <- [0 .. wide - 1]] | di <- [0 .. high - 1]]
    (high, wide) = (fromIntegral (rows window), fromIntegral (columns window))
    centres =
      [ centreFrom s cell
        | line <- block,
          cell <- line,
          Just here <- [Map.lookup cell (judgedCells judgement)],
          s <- here
      ]
    -- Where the window's centre is, by the symbol in this cell.
    centreFrom s (i', j') =
      let (x, y) = readAt s
          across = columnPitch * (fromIntegral (j' - j) - (fromIntegral (columns window) - 1) / 2)
          down = rowPitch * (fromIntegral (i' - i) - (fromIntegral (rows window) - 1) / 2)
          (dx, dy) = onComposite (judgedOrientation judgement) (across, down)
       in (x - dx, y - dy)
