{-# OPTIONS_HADDOCK hide #-}

-- | From the symbols on a grid to the place of the grid's upper left cell in the array, by two
-- judgements that must agree.
--
-- The probabilities of all symbols and parts, known to the network or not, say how likely every
-- position is, either way up; the likeliest must be likely enough. And of the symbols that the
-- network knows, and
-- of the parts that leave hardly a doubt, no more may contradict it than the minimum distance of
-- their cells lets be wrong: probabilities rest on a model of the sensor, the distance does not.
-- At least one that agrees is complete: of parts it is not asked whether they may be another shape.
--
-- What is touched is one face of the placement, and beyond its edge nothing of the array's lies, as
-- "PraTactile.Recognise.OneFace" has it.
module PraTactile.Recognise.GridLocation
  ( -- * Locating a grid
    Tolerance (..),
    standardTolerance,
    locateGrid,
    GridLocation (..),
    GridOutcome (..),

    -- * Where it lies most probably
    Likeliest (..),
    likeliestAt,
    likeliestElsewhere,
    likelyCells,

    -- * What it rests on
    Support (..),
    Doubts (..),
    supportDoubt,
    cellFrom,
  )
where

import Control.Monad (join)
import Data.List (maximumBy, partition)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, isJust, mapMaybe)
import Data.Ord (comparing)
import qualified Data.Set as Set
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Grid (canonicalPosition)
import PraTactile.Locate hiding (Cell)
import PraTactile.Locate.Chance
import PraTactile.Locate.Checks (checksAmong)
import PraTactile.Recognise.FaceGrid
import PraTactile.Recognise.OneFace
import PraTactile.Recognise.Reading
import PraTactile.Recognise.Recogniser
import PraTactile.Recognise.SymbolBelief
import PraTactile.Segmentation.Lattice (Cell)
import PraTactile.Symmetry

-- | What a caller lets pass.
data Tolerance = Tolerance
  { -- | the probability of a wrong answer, below 1
    toleratedDoubt :: Double,
    -- | how many certain symbols may be wrong
    toleratedErrors :: Radius,
    -- | the probability beforehand that what was touched is nothing of the array's: the shapes in
    -- another arrangement; and again that it is other shapes; each below 1
    foreignPrior :: Double,
    -- | the probability beforehand that the robot's axes are others than those supposed; where it
    -- is not given, a hundredth, and a quarter of that where somebody stated them
    axesPrior :: Maybe Double,
    -- | the probability beforehand that frames slipped by a whole cell: some of those of one folder
    -- beyond a line, and again each folder but the first
    slipPrior :: Double
  }
  deriving stock (Eq, Show)

-- | A hundredth, and as many wrong symbols as the certain ones' minimum distance lets be corrected
-- for certain; of 200 things that are touched, one is foreign, and of 500 presses one has slipped.
-- So a window of four symbols beyond doubt, which nearly every arrangement of four symbols is, is
-- still an answer.
standardTolerance :: Tolerance
standardTolerance = Tolerance 0.01 Guaranteed 0.005 Nothing 0.002

-- | What would make a position wrong, each with its probability; they exclude each other.
data Doubts = Doubts
  { -- | the symbols are the array's, but orientation or position are others
    doubtOfPosition :: Double,
    -- | the frames lie otherwise than they were put together, and then show something else
    doubtOfStitching :: Double,
    -- | the robot's axes, or their scale, are others, and then the frames show something else
    doubtOfAxes :: Double,
    -- | frames slipped by a whole cell along the face, and likewise
    doubtOfSlip :: Double,
    -- | it is nothing of the array's
    doubtsOfOrigin :: ForeignDoubts
  }
  deriving stock (Eq, Show)

-- | What a position rests on.
data Support = Support
  { -- | how probable it is, by the symbols' own probabilities, that it is wrong
    supportDoubts :: Doubts,
    -- | how many certain symbols are what the array has in their place
    supportAgreeing :: Int,
    -- | the numbers of those that are not, or that lie another way up, or off the grid
    supportWrong :: [Int],
    -- | the composites, counted from 0, of whose certain symbols more are wrong than not
    supportInconsistent :: [Int],
    -- | the minimum distance of the cells with a certain symbol
    supportDistance :: Known,
    -- | how many of them may be wrong
    supportRadius :: Natural,
    -- | of all contents of these cells, the share that would be located: at most this; 'Nothing' if
    -- no cell says anything
    supportChance :: Maybe Chance,
    -- | what the code has checked among these cells, of the composites as their sources
    supportChecks :: Maybe Checks
  }
  deriving stock (Eq, Show)

-- | The probability that the position is wrong.
supportDoubt :: Support -> Double
supportDoubt support =
  doubtOfPosition doubts
    + doubtOfStitching doubts
    + doubtOfAxes doubts
    + doubtOfSlip doubts
    + doubtOfForeign (doubtsOfOrigin doubts)
  where
    doubts = supportDoubts support

-- | Where a grid is.
data GridLocation = GridLocation
  { locationOrientation :: Symmetry,
    -- | the grid as it lies on the face
    locationCells :: Cells,
    -- | for the likeliest position, accepted or not
    locationSupport :: Maybe Support,
    locationLikeliest :: Maybe Likeliest,
    locationOutcome :: GridOutcome
  }

-- | Where the grid's upper left cell is, or what stands against an answer.
data GridOutcome
  = Placed Position
  | -- | several positions agree with all that is known
    Undecided [Position]
  | -- | too many symbols lie another way up than the rest
    WrongWayUp
  | -- | too many symbols lie off the grid of the rest
    OffTheGrid
  | -- | groups of symbols lead to different places
    GroupsApart
  | Unplaced Reason
  | -- | what was seen cannot be decoded
    Undecoded LocatorError
  deriving stock (Eq, Show)

-- | Locate a grid of symbols of one axis. The dissenters are symbols of the other axis that the
-- network knows all the same.
locateGrid ::
  KnownField k => Recogniser k -> Tolerance -> [ReadSymbol] -> FaceGrid -> GridLocation
locateGrid reader tolerance dissenters grid =
  GridLocation
    orientation
    cells
    (join (supportFrom reader witnesses <$> seen <*> answer))
    (answer >>= likeliestFrom reader (gridCells grid))
    outcome
  where
    axis = axisOf (gridCells grid)
    (seen, answered) = locatedCells reader tolerance (gridCells grid)
    answer = answered >>= rightOnly
    likeliest' = answer >>= answerPosterior >>= posteriorBest
    orientation =
      axis <> maybe (wayUpAlone (map snd (foldMap observedCells seen))) candidateSymmetry likeliest'
    silent = maybe [] (beforehandSilent . beforehandOf reader (gridCells grid)) likeliest'
    -- Cells that say nothing stay, without what was seen in them: so the grid keeps its extent.
    cells =
      seenOnFace
        orientation
        (Map.mapWithKey (\c here -> if offsetOf c `elem` silent then [] else here) (gridCells grid))
    witnesses = witnessesOf reader tolerance orientation (dissenters, gridStrays grid) cells

    exactly some = case knownPatch some orientation of
      Left _ -> Just (Refused TooFewCells)
      Right known ->
        fmap candidatePosition . answerOutcome
          <$> rightOnly
            ( locate
                (recogniserLocator reader)
                (onePatch (Symbol <$> known)) {queryRadius = toleratedErrors tolerance}
            )
    alone numbers =
      exactly (Map.map (filter ((`Set.member` numbers) . readNumber)) cells) >>= onlyPlace
    findings =
      Findings
        { foundExactly = exactly cells,
          foundApart = differ (mapMaybe alone (gridGroups grid))
        }
    outcome = case fmap answerOutcome <$> answered of
      Just (Left why) -> Undecoded why
      Just (Right (Unique candidate _))
        | counted wrong > witnessesRadius witnesses ->
          contradicted findings witnesses (counted wrong)
        | any ((>= 1) . readSeen) agreeing -> Placed (candidatePosition candidate)
        | otherwise -> Unplaced BelowThreshold
        where
          (agreeing, wrong) = standing reader witnesses (candidatePosition candidate)
      _ -> unclear findings witnesses

-- | What is seen of cells, and what comes of locating it.
locatedCells ::
  KnownField k =>
  Recogniser k ->
  Tolerance ->
  Cells ->
  (Maybe (Patch (Belief k)), Maybe (Either LocatorError Answer))
locatedCells reader tolerance cells =
  (seen, locate (recogniserLocator reader) . whereAre reader tolerance cells <$> seen)
  where
    seen = seenOf cells

-- | What comes of locating cells where it is not asked whether they are foreign.
locatedAsOurs :: KnownField k => Recogniser k -> Tolerance -> Cells -> Maybe Answer
locatedAsOurs reader tolerance cells = do
  question <- whereAre reader tolerance cells <$> seenOf cells
  rightOnly (locate (recogniserLocator reader) question {queryForeign = Nothing})

-- | What is seen of cells; 'Nothing' where that is not a patch.
seenOf :: KnownField k => Cells -> Maybe (Patch (Belief k))
seenOf cells = rightOnly (patch (map (map (>>= beliefAlong (axisOf cells))) (gridRows cells)))

-- | Where are cells, given what is seen of them? How unlike ours a single symbol is counts for less
-- than on the sensors that it was calibrated with, from -6 to 4: one that is spoilt, as beside an
-- edge, does not outweigh many.
whereAre :: Recogniser k -> Tolerance -> Cells -> Patch (Belief k) -> Query k
whereAre reader tolerance cells seen =
  (onePatch (Probabilities <$> seen))
    { querySymmetries = waysUp,
      queryDoubt = toleratedDoubt tolerance,
      queryForeign = Just (foreignPrior tolerance),
      queryUnlike = sum [max (-6) (min 4 (readUnlike s)) | here <- Map.elems cells, s <- here],
      queryBeforehand = Just (beforehandOf reader cells)
    }

-- | What cells make of the array, whether or not that is enough for an answer.
data Likeliest = Likeliest
  { -- | the logarithm of how many times as probable they are if they are the array's as by chance
    likeliestEvidence :: Double,
    -- | that of how probable the place is beforehand, at most 0
    likeliestPrior :: Double,
    -- | how the face is seen
    likeliestOrientation :: Symmetry,
    -- | where in the array the upper left cell is, as it lies on the face
    likeliestFirst :: Position,
    -- | the greatest row and column of the cells, along the symbols' axes
    likeliestEnd :: Cell
  }
  deriving stock (Eq, Show)

-- | The cell of the array at a cell of a grid, which need not be seen; 'Nothing' beyond the sheet.
likeliestAt :: KnownField k => Recogniser k -> Likeliest -> Cell -> Maybe Position
likeliestAt reader found (i, j) = fst <$> cellFrom reader (likeliestFirst found) onFace
  where
    (lastRow, lastColumn) = likeliestEnd found
    onFace
      | quarterTurns (likeliestOrientation found) >= 2 = (lastRow - i, lastColumn - j)
      | otherwise = (i, j)

-- | Where cells lie most probably if frames lie elsewhere; 'Nothing' where nothing is possible. Of
-- a large array, where most such cells agree with no place, 2^10 words are looked at: what is
-- likely is among the first, and what is not listed counts as doubt of the answer.
likeliestElsewhere :: KnownField k => Recogniser k -> Tolerance -> Cells -> Maybe Likeliest
likeliestElsewhere reader tolerance cells =
  locatedAsOurs briefly tolerance cells >>= likeliestFrom reader cells
  where
    briefly = reader {recogniserLocator = withListing 1024 (recogniserLocator reader)}

-- | Where cells lie most probably by the answer for them.
likeliestFrom :: Recogniser k -> Cells -> Answer -> Maybe Likeliest
likeliestFrom reader cells answer = do
  candidate <- answerPosterior answer >>= posteriorBest
  speaking <- answerEvidence answer
  pure
    Likeliest
      { likeliestEvidence = speaking,
        likeliestPrior = beforehandPrior (beforehandOf reader cells candidate),
        likeliestOrientation = axisOf cells <> candidateSymmetry candidate,
        likeliestFirst = candidatePosition candidate,
        likeliestEnd = (end fst, end snd)
      }
  where
    end part = maximum (0 : map part (Map.keys cells))

-- | The cells of the array that may lie under these, in their likely places: the first thousand.
-- That they may be foreign makes none of these likelier than another.
likelyCells :: KnownField k => Recogniser k -> Tolerance -> Cells -> [Position]
likelyCells reader tolerance cells =
  Set.toAscList . Set.fromList $
    [ place
      | Just answer <- [locatedAsOurs reader tolerance cells],
        Just found <- [answerPosterior answer],
        (candidate, _) <- fst (weighable (posteriorRanking found)),
        (place, _) <- lyingAt reader cells candidate
    ]

-- | Where on the array the cells are, if the candidate is right, with what was read there.
lyingAt :: KnownField k => Recogniser k -> Cells -> Candidate -> [(Position, [ReadSymbol])]
lyingAt reader cells candidate =
  [ (place, here)
    | (cell, here) <- Map.toList (seenOnFace (axisOf cells <> candidateSymmetry candidate) cells),
      Just (place, _) <- [cellFrom reader (candidatePosition candidate) cell]
  ]

-- | The way up that cells show by themselves, where no position is possible.
wayUpAlone :: [Belief k] -> Symmetry
wayUpAlone cells = maximumBy (comparing shown) (reverse waysUp)
  where
    shown way = sum (map (log . symmetryChance way) cells)

-- | What the likeliest position rests on; 'Nothing' where none is possible.
supportFrom ::
  KnownField k => Recogniser k -> Witnesses -> Patch (Belief k) -> Answer -> Maybe Support
supportFrom reader witnesses seen answer = do
  candidate <- answerPosterior answer >>= posteriorBest
  PlaceDoubts elsewhere' alien <- answerDoubts answer
  let (agreeing, wrong) = standing reader witnesses (candidatePosition candidate)
  pure
    Support
      { supportDoubts = Doubts (fromMaybe 0 elsewhere') 0 0 0 alien,
        supportAgreeing = length agreeing,
        supportWrong = map readNumber wrong,
        supportInconsistent = mostlyIn wrong agreeing,
        supportDistance = witnessesDistance witnesses,
        supportRadius = witnessesRadius witnesses,
        supportChance = chanceAmong reader (candidateSymmetry candidate) seen witnesses,
        supportChecks = checksAmong (locatorArray (recogniserLocator reader)) (bySource witnesses)
      }

-- | The symbols that are certain, for an orientation of the face.
data Witnesses = Witnesses
  { -- | those that lie so, each in its cell
    witnessesKnown :: [(Cell, ReadSymbol)],
    -- | those that lie another way up
    witnessesOtherWayUp :: [ReadSymbol],
    -- | those that lie off the grid
    witnessesStray :: [ReadSymbol],
    -- | the cells of those that lie so
    witnessesCells :: [Position],
    -- | the minimum distance of these cells
    witnessesDistance :: Known,
    -- | how many symbols may be wrong
    witnessesRadius :: Natural
  }

-- | The witnesses among the symbols of the other axis, those off the grid, and those in its cells.
witnessesOf ::
  KnownField k =>
  Recogniser k ->
  Tolerance ->
  Symmetry ->
  ([ReadSymbol], [ReadSymbol]) ->
  Cells ->
  Witnesses
witnessesOf reader tolerance orientation (dissenters, strays) cells =
  Witnesses
    { witnessesKnown = known,
      witnessesOtherWayUp =
        [s | ((_, s), o) <- ways, o /= orientation] ++ filter (isJust . certain) dissenters,
      witnessesStray = filter (isJust . certain) strays,
      witnessesCells = offsets,
      witnessesDistance = distance,
      witnessesRadius = radiusFor (toleratedErrors tolerance) (atLeast distance)
    }
  where
    known = [here | (here, o) <- ways, o == orientation]
    offsets = map offsetOf (Set.toAscList (Set.fromList (map fst known)))
    distance = cellsDistance (recogniserLocator reader) offsets
    ways =
      [ ((cell, s), o)
        | (cell, here) <- Map.toList cells,
          s <- here,
          Just (o, _) <- [certain s]
      ]

-- | The cells of the symbols that lie so, composite by composite.
bySource :: Witnesses -> [[Position]]
bySource witnesses =
  Map.elems $
    Map.fromListWith
      (++)
      [(readSource s, [offsetOf cell]) | (cell, s) <- witnessesKnown witnesses]

-- | The symbols that agree with a place of the grid, and those that are wrong there.
standing ::
  KnownField k => Recogniser k -> Witnesses -> Position -> ([ReadSymbol], [ReadSymbol])
standing reader witnesses place =
  (map snd agreeing, map snd misfits ++ witnessesOtherWayUp witnesses ++ witnessesStray witnesses)
  where
    (agreeing, misfits) = partition right (witnessesKnown witnesses)
    right (cell, s) = codeAt cell == fmap snd (certain s)
    codeAt cell = toCode . snd <$> cellFrom reader place cell

-- | The composites that have more of the first symbols than of the second.
mostlyIn :: [ReadSymbol] -> [ReadSymbol] -> [Int]
mostlyIn these those =
  [ source
    | (source, n) <- Map.toAscList (counts these),
      n > Map.findWithDefault 0 source (counts those)
  ]
  where
    counts symbols = Map.fromListWith (+) [(readSource s, 1 :: Int) | s <- symbols]

-- | The share of all contents of the certain cells that would be located.
chanceAmong ::
  KnownField k => Recogniser k -> Symmetry -> Patch (Belief k) -> Witnesses -> Maybe Chance
chanceAmong reader way seen witnesses =
  chance
    . amongCells (counted (witnessesCells witnesses))
    . correcting (atLeast (witnessesDistance witnesses)) (witnessesRadius witnesses)
    <$> spheres
      (locatorArray (recogniserLocator reader))
      [way]
      (patchShape seen)
      (map fst (observedCells seen))

-- | What the symbols that the network knows say by themselves.
data Findings = Findings
  { -- | where they are together, if that can be decoded
    foundExactly :: Maybe (Outcome Position),
    -- | whether groups of them are at different places
    foundApart :: Bool
  }

-- | Why there is no answer where a position is likely, but this many symbols contradict it.
contradicted :: Findings -> Witnesses -> Natural -> GridOutcome
contradicted findings witnesses wrong
  | accountFor (witnessesOtherWayUp witnesses) = WrongWayUp
  | accountFor (witnessesStray witnesses) = OffTheGrid
  | foundApart findings = GroupsApart
  | Just (Refused reason) <- foundExactly findings = Unplaced reason
  | otherwise = Unplaced Contradiction
  where
    accountFor symbols = not (null symbols) && wrong <= witnessesRadius witnesses + counted symbols

-- | Why there is no answer where no position is likely enough.
unclear :: Findings -> Witnesses -> GridOutcome
unclear findings witnesses
  | counted (witnessesOtherWayUp witnesses) > witnessesRadius witnesses = WrongWayUp
  | otherwise = case foundExactly findings of
    Nothing -> Unplaced BelowThreshold
    Just (Unique _ _) -> Unplaced BelowThreshold
    Just (Ambiguous places (_ : _)) -> Undecided places
    Just (Refused reason)
      | reason `notElem` [TooFewCells, NoCompleteWindow] ->
        if foundApart findings then GroupsApart else Unplaced reason
    _ -> Unplaced NoCompleteWindow

onlyPlace :: Outcome place -> Maybe place
onlyPlace outcome = case outcome of
  Unique place _ -> Just place
  _ -> Nothing

differ :: Eq a => [a] -> Bool
differ places = or (zipWith (/=) places (drop 1 places))

counted :: [a] -> Natural
counted = fromIntegral . length

rightOnly :: Either e a -> Maybe a
rightOnly = either (const Nothing) Just

-- | Where a cell of the grid is in the array, and the symbol there, if the grid's upper left cell
-- is at the position; 'Nothing' beyond the sheet.
cellFrom :: KnownField k => Recogniser k -> Position -> Cell -> Maybe (Position, GF k)
cellFrom reader (Position r c) (i, j) = (\place -> (place, cellAt array place)) <$> at
  where
    ArrayOn surface array = locatorArray (recogniserLocator reader)
    at =
      canonicalPosition
        surface
        (arrayShape array)
        (toInteger r + toInteger i)
        (toInteger c + toInteger j)
