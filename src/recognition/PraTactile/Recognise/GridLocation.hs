-- | From the symbols on a grid to the place of the grid's upper left cell in the array, by two
-- decodings that must agree.
--
-- The probabilities of all symbols and parts, known to the network or not, say how likely every
-- position is; the likeliest must be likely enough. And of the symbols that the network knows, and
-- of the parts that leave hardly a doubt, no more may contradict it than the minimum distance of
-- their cells lets be wrong: probabilities rest on a model of the sensor, the distance does not.
module PraTactile.Recognise.GridLocation
  ( -- * Locating a grid
    Tolerance (..),
    standardTolerance,
    locateGrid,
    GridLocation (..),
    GridOutcome (..),

    -- * What it rests on
    Evidence (..),
    Doubts (..),
    evidenceDoubt,
    cellFrom,
  )
where

import Control.Monad (join)
import Data.List (partition)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, isJust, mapMaybe)
import Data.Proxy (Proxy (..))
import qualified Data.Set as Set
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Grid (canonicalPosition, displaced)
import PraTactile.Locate hiding (Cell)
import PraTactile.Locate.Chance
import PraTactile.Locate.Decoder.Codebook
import PraTactile.Locate.Foreign
import PraTactile.Locate.Query (radiusFor)
import PraTactile.Recognise.FaceGrid
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
    -- | the probability beforehand that what was touched is nothing of the array's: symbols of the
    -- same shapes, each as likely as any other in every cell; below 1
    foreignPrior :: Double
  }
  deriving stock (Eq, Show)

-- | A hundredth, and as many wrong symbols as the certain ones' minimum distance lets be corrected
-- for certain; of 200 things that are touched, one is foreign. So a window of four symbols beyond
-- doubt, which nearly every arrangement of four symbols is, is still an answer.
standardTolerance :: Tolerance
standardTolerance = Tolerance 0.01 Guaranteed 0.005

-- | What would make a position wrong, each with its probability; they exclude each other.
data Doubts = Doubts
  { -- | the symbols are the array's, but orientation or position are others
    doubtOfPosition :: Double,
    -- | the frames lie otherwise than they were put together, and then show something else
    doubtOfStitching :: Double,
    -- | it is nothing of the array's
    doubtOfOrigin :: Double
  }
  deriving stock (Eq, Show)

-- | What a position rests on.
data Evidence = Evidence
  { -- | how probable it is, by the symbols' own probabilities, that it is wrong
    evidenceDoubts :: Doubts,
    -- | how many certain symbols are what the array has in their place
    evidenceAgreeing :: Int,
    -- | the numbers of those that are not, or that lie another way up, or off the grid
    evidenceWrong :: [Int],
    -- | the composites, counted from 0, of whose certain symbols more are wrong than not
    evidenceInconsistent :: [Int],
    -- | the minimum distance of the cells with a certain symbol
    evidenceDistance :: Natural,
    -- | how many of them may be wrong
    evidenceRadius :: Natural,
    -- | of all contents of these cells, the share that would be located: at most this; 'Nothing' if
    -- no cell says anything
    evidenceChance :: Maybe Chance
  }
  deriving stock (Eq, Show)

-- | The probability that the position is wrong.
evidenceDoubt :: Evidence -> Double
evidenceDoubt evidence = doubtOfPosition doubts + doubtOfStitching doubts + doubtOfOrigin doubts
  where
    doubts = evidenceDoubts evidence

-- | Where a grid is.
data GridLocation = GridLocation
  { locationOrientation :: Symmetry,
    -- | the grid as it lies on the face
    locationCells :: Cells,
    -- | for the likeliest position, accepted or not
    locationEvidence :: Maybe Evidence,
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
  deriving stock (Eq, Show)

-- | Locate a grid of symbols of one axis. The dissenters are symbols of the other axis that the
-- network knows all the same.
locateGrid ::
  forall k. KnownField k => Recogniser k -> Tolerance -> [ReadSymbol] -> FaceGrid -> GridLocation
locateGrid reader tolerance dissenters grid =
  GridLocation orientation cells (snd <$> found) outcome
  where
    q = fieldOrder (Proxy :: Proxy k)
    codebook = recogniserCodebook reader
    (orientation, orientationDoubt) = likeliestOrientation q (gridCells grid)
    cells = seenOnFace orientation (gridCells grid)
    witnesses = witnessesOf codebook tolerance orientation (dissenters, gridStrays grid) cells
    stated = toleratedErrors tolerance
    ask seen =
      rightOnly
        ( locate
            (recogniserLocator reader)
            (onePatch (codebookSurface codebook) seen) {queryRadius = stated}
        )
    beliefs = rightOnly (patch (map (map join) (gridRows (Map.map (beliefIn q orientation) cells))))
    found = do
      seen <- beliefs
      posterior <- ask (Probabilities <$> seen) >>= answerPosterior
      evidenceFrom codebook witnesses (foreignPrior tolerance) orientationDoubt seen posterior

    exactly some = do
      known <- rightOnly (knownPatch some orientation)
      fmap candidatePosition . answerOutcome <$> ask (Symbol <$> known)
    alone numbers =
      exactly (Map.map (filter ((`Set.member` numbers) . readNumber)) cells) >>= onlyPlace
    findings =
      Findings
        { foundExactly = fromMaybe (Refused TooFewCells) (exactly cells),
          foundApart = differ (mapMaybe alone (gridGroups grid))
        }
    outcome = case found of
      Just (place, evidence)
        | evidenceDoubt evidence <= toleratedDoubt tolerance ->
          if counted (evidenceWrong evidence) <= witnessesRadius witnesses
            then Placed place
            else contradicted findings witnesses (counted (evidenceWrong evidence))
      _ -> unclear findings witnesses

-- | The likeliest position, and what it rests on, given the share of foreign things, the doubt
-- about the orientation and the probabilities of the observed cells. 'Nothing' where no position is
-- possible.
evidenceFrom ::
  KnownField k =>
  Codebook k ->
  Witnesses ->
  Double ->
  Double ->
  Patch (Belief k) ->
  Posterior Candidate ->
  Maybe (Position, Evidence)
evidenceFrom codebook witnesses share orientationDoubt seen posterior = do
  place <- candidatePosition <$> posteriorBest posterior
  let (agreeing, wrong) = standing codebook witnesses place
  pure
    ( place,
      Evidence
        { evidenceDoubts = doubtsOf (foreignAt codebook share seen place doubt),
          evidenceAgreeing = length agreeing,
          evidenceWrong = map readNumber wrong,
          evidenceInconsistent = mostlyIn wrong agreeing,
          evidenceDistance = witnessesDistance witnesses,
          evidenceRadius = witnessesRadius witnesses,
          evidenceChance = chanceAmong codebook seen witnesses
        }
    )
  where
    doubt = posteriorDoubt posterior
    other = orientationDoubt + doubt - orientationDoubt * doubt
    doubtsOf alien = Doubts (other * (1 - alien)) 0 alien

-- | The probability that the observed cells are foreign, given the share of foreign things, the
-- likeliest position, and the probability that among all positions it is another one.
foreignAt ::
  KnownField k => Codebook k -> Double -> Patch (Belief k) -> Position -> Double -> Double
foreignAt codebook share seen place doubt =
  foreignChance
    ForeignComparison
      { foreignShare = share,
        foreignSymbols = fieldOrder array,
        foreignPlaces = area size,
        foreignExpected = [chanceOf offset b | (offset, b) <- observedCells seen],
        foreignLikeliest = log (1 - doubt)
      }
  where
    array = codebookArray codebook
    size = arrayShape array
    chanceOf offset b = case displaced (codebookSurface codebook) size place offset of
      Just there -> probabilities b Primitive.! toCode (cellAt array there)
      Nothing -> 0

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
    witnessesDistance :: Natural,
    -- | how many symbols may be wrong
    witnessesRadius :: Natural
  }

-- | The witnesses among the symbols of the other axis, those off the grid, and those in its cells.
witnessesOf ::
  Codebook k -> Tolerance -> Symmetry -> ([ReadSymbol], [ReadSymbol]) -> Cells -> Witnesses
witnessesOf codebook tolerance orientation (dissenters, strays) cells =
  Witnesses
    { witnessesKnown = known,
      witnessesOtherWayUp =
        [s | ((_, s), o) <- ways, o /= orientation] ++ filter (isJust . certain) dissenters,
      witnessesStray = filter (isJust . certain) strays,
      witnessesCells = offsets,
      witnessesDistance = distance,
      witnessesRadius = radiusFor (toleratedErrors tolerance) distance
    }
  where
    known = [here | (here, o) <- ways, o == orientation]
    offsets = map offsetOf (Set.toAscList (Set.fromList (map fst known)))
    distance = observedDistance codebook offsets
    ways =
      [ ((cell, s), o)
        | (cell, here) <- Map.toList cells,
          s <- here,
          Just (o, _) <- [certain s]
      ]

-- | The symbols that agree with a place of the grid, and those that are wrong there.
standing ::
  KnownField k => Codebook k -> Witnesses -> Position -> ([ReadSymbol], [ReadSymbol])
standing codebook witnesses place =
  (map snd agreeing, map snd misfits ++ witnessesOtherWayUp witnesses ++ witnessesStray witnesses)
  where
    (agreeing, misfits) = partition right (witnessesKnown witnesses)
    right (cell, s) = codeAt cell == fmap snd (certain s)
    codeAt cell = toCode . cellAt (codebookArray codebook) <$> cellFrom codebook place cell

-- | The composites that have more of the first symbols than of the second.
mostlyIn :: [ReadSymbol] -> [ReadSymbol] -> [Int]
mostlyIn these those =
  [ source
    | (source, n) <- Map.toAscList (bySource these),
      n > Map.findWithDefault 0 source (bySource those)
  ]
  where
    bySource symbols = Map.fromListWith (+) [(readSource s, 1 :: Int) | s <- symbols]

-- | The share of all contents of the certain cells that would be located.
chanceAmong :: KnownField k => Codebook k -> Patch (Belief k) -> Witnesses -> Maybe Chance
chanceAmong codebook seen witnesses =
  chance
    . amongCells (counted (witnessesCells witnesses))
    . correcting (witnessesDistance witnesses) (witnessesRadius witnesses)
    <$> spheres
      (codebookSurface codebook)
      (codebookArray codebook)
      [identity]
      (patchShape seen)
      (map fst (observedCells seen))

-- | What the symbols that the network knows say by themselves.
data Findings = Findings
  { -- | where they are together
    foundExactly :: Outcome Position,
    -- | whether groups of them are at different places
    foundApart :: Bool
  }

-- | Why there is no answer where a position is likely, but this many symbols contradict it.
contradicted :: Findings -> Witnesses -> Natural -> GridOutcome
contradicted findings witnesses wrong
  | accountFor (witnessesOtherWayUp witnesses) = WrongWayUp
  | accountFor (witnessesStray witnesses) = OffTheGrid
  | foundApart findings = GroupsApart
  | Refused reason <- foundExactly findings = Unplaced reason
  | otherwise = Unplaced Contradiction
  where
    accountFor symbols = not (null symbols) && wrong <= witnessesRadius witnesses + counted symbols

-- | Why there is no answer where no position is likely enough.
unclear :: Findings -> Witnesses -> GridOutcome
unclear findings witnesses
  | counted (witnessesOtherWayUp witnesses) > witnessesRadius witnesses = WrongWayUp
  | otherwise = case foundExactly findings of
    Unique _ _ -> Unplaced BelowThreshold
    Ambiguous places (_ : _) -> Undecided places
    Refused reason
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

-- | Where a cell of the grid is in the array, if the grid's upper left cell is at the position;
-- 'Nothing' beyond the sheet.
cellFrom :: Codebook k -> Position -> Cell -> Maybe Position
cellFrom codebook (Position r c) (i, j) =
  canonicalPosition
    (codebookSurface codebook)
    (arrayShape (codebookArray codebook))
    (toInteger r + toInteger i)
    (toInteger c + toInteger j)

-- | A cell of the grid, which has no rows and columns before 0, as an offset.
offsetOf :: Cell -> Position
offsetOf (i, j) = Position (fromIntegral i) (fromIntegral j)
