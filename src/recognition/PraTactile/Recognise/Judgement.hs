-- | From the symbols on a grid to the place of the grid's upper left cell in the array: two
-- judgements that must agree.
--
-- The probabilities of all symbols and parts, known to the network or not, say how likely every
-- position is; the likeliest must be likely enough. And of the symbols that the network knows, and
-- of the parts that leave hardly a doubt, no more may contradict it than the minimum distance of
-- their cells lets be wrong: probabilities rest on a model of the sensor, the distance does not.
module PraTactile.Recognise.Judgement
  ( -- * Judging
    Tolerance (..),
    standardTolerance,
    judge,
    Judgement (..),
    Ruling (..),

    -- * What is behind it
    Evidence (..),
    cellFrom,
  )
where

import Control.Monad (join)
import Data.List (foldl')
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, isJust, mapMaybe)
import Data.Proxy (Proxy (..))
import qualified Data.Set as Set
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Grid (canonicalPosition)
import PraTactile.Locate hiding (Cell)
import PraTactile.Locate.Chance
import PraTactile.Locate.Decision (Decision (..))
import PraTactile.Locate.Decoder.Codebook
import PraTactile.Locate.Decoder.Nearest (nearest)
import PraTactile.Locate.Decoder.Posterior (posterior)
import PraTactile.Recognise.FaceGrid
import PraTactile.Recognise.Reading
import PraTactile.Segment.Lattice (Cell)
import PraTactile.Symbol (elementOfClass)
import PraTactile.Symmetry (identity)

-- | What a caller lets pass.
data Tolerance = Tolerance
  { -- | the probability of a wrong answer, below 1
    toleratedDoubt :: Double,
    -- | how many certain symbols may be wrong
    toleratedErrors :: Radius
  }
  deriving stock (Eq, Show)

-- | A hundredth, and as many wrong symbols as the certain ones' minimum distance lets be corrected
-- for certain.
standardTolerance :: Tolerance
standardTolerance = Tolerance 0.01 Guaranteed

-- | What a position rests on.
data Evidence = Evidence
  { -- | the probability, by the symbols' own, that orientation or position are others
    evidenceDoubt :: Double,
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

-- | What was made of a grid.
data Judgement = Judgement
  { judgedOrientation :: Orientation,
    -- | the grid as it lies on the face
    judgedCells :: Cells,
    -- | for the likeliest position, accepted or not
    judgedEvidence :: Maybe Evidence,
    judgedRuling :: Ruling
  }

-- | Where the grid's upper left cell is, or what stands against an answer.
data Ruling
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

-- | Judge a grid of symbols of one axis. The dissenters are symbols of the other axis that the
-- network knows all the same.
judge :: forall k. KnownField k => Codebook k -> Tolerance -> [ReadSymbol] -> FaceGrid -> Judgement
judge shelf tolerance dissenters grid = Judgement orientation cells evidence ruling
  where
    q = fieldOrder (Proxy :: Proxy k)
    (orientation, orientationDoubt) = likeliestOrientation q (gridCells grid)
    cells = seenOnFace orientation (gridCells grid)
    known =
      [ (cell, s)
        | (cell, here) <- Map.toList cells,
          s <- here,
          Just (o, _) <- [certain s],
          o == orientation
      ]
    otherWayUp =
      [s | here <- Map.elems cells, s <- here, Just (o, _) <- [certain s], o /= orientation]
        ++ dissenters
    strays = filter (isJust . readClass) (gridStrays grid)
    knownCells = Set.toAscList (Set.fromList (map fst known))
    distance = observedDistance shelf (map offset knownCells)
    radius = case toleratedErrors tolerance of
      Guaranteed -> guaranteedRadius distance
      UpTo e -> e

    likely = patch (map (map join) (gridRows (Map.map (beliefIn q orientation) cells)))
    found = posterior shelf <$> either (const Nothing) Just likely
    evidence = do
      soft <- found
      place <- posteriorBest soft
      let right (cell, s) = codeAt place cell == fmap snd (certain s)
          misfits = [s | here@(_, s) <- known, not (right here)]
          wrong = misfits ++ otherWayUp ++ strays
          agreeing = map snd (filter right known)
          bySource here = Map.fromListWith (+) [(readSource s, 1 :: Int) | s <- here]
      pure
        Evidence
          { evidenceDoubt =
              orientationDoubt + posteriorDoubt soft - orientationDoubt * posteriorDoubt soft,
            evidenceAgreeing = length agreeing,
            evidenceWrong = map readNumber wrong,
            evidenceInconsistent =
              [ source
                | (source, n) <- Map.toAscList (bySource wrong),
                  n > Map.findWithDefault 0 source (bySource agreeing)
              ],
            evidenceDistance = distance,
            evidenceRadius = radius,
            evidenceChance = do
              here <- either (const Nothing) Just likely
              around <-
                spheres
                  (codebookSurface shelf)
                  (codebookArray shelf)
                  [identity]
                  (patchShape here)
                  (map fst (observedCells here))
              pure
                ( chance
                    ( amongCells
                        (fromIntegral (length knownCells))
                        (correcting distance radius around)
                    )
                )
          }
    exact = fromMaybe (Refused TooFewCells) (exactly cells)
    exactly some =
      either
        (const Nothing)
        (Just . decisionOutcome . nearest shelf (toleratedErrors tolerance))
        (knownPatch some orientation)

    ruling = case (found >>= posteriorBest, evidence) of
      (Just place, Just e)
        | evidenceDoubt e <= toleratedDoubt tolerance ->
          if counted (evidenceWrong e) <= radius
            then Placed place
            else against (counted (evidenceWrong e))
      _
        | counted otherWayUp > radius -> WrongWayUp
        | otherwise -> unclear
    counted :: [a] -> Natural
    counted = fromIntegral . length
    -- The position is likely, but too much contradicts it.
    against wrong
      | not (null otherWayUp) && wrong <= radius + counted otherWayUp = WrongWayUp
      | not (null strays) && wrong <= radius + counted strays = OffTheGrid
      | groupsApart = GroupsApart
      | Refused reason <- exact = Unplaced reason
      | otherwise = Unplaced Contradiction
    -- No position is likely enough.
    unclear = case exact of
      Unique _ _ -> Unplaced BelowThreshold
      Ambiguous places (_ : _) -> Undecided places
      Refused reason
        | reason `notElem` [TooFewCells, NoCompleteWindow] ->
          if groupsApart then GroupsApart else Unplaced reason
      _ -> Unplaced NoCompleteWindow

    groupsApart = case mapMaybe alone (gridGroups grid) of
      place : places -> any (/= place) places
      [] -> False
    alone numbers = case exactly (Map.map (among numbers) cells) of
      Just (Unique place _) -> Just place
      _ -> Nothing
    among numbers = filter ((`Set.member` numbers) . readNumber)
    codeAt place cell = toCode . cellAt (codebookArray shelf) <$> cellFrom shelf place cell
    offset (i, j) = Position (fromIntegral i) (fromIntegral j)

-- | Where a cell of the grid is in the array, if the grid's upper left cell is at the position;
-- 'Nothing' beyond the sheet.
cellFrom :: Codebook k -> Position -> Cell -> Maybe Position
cellFrom shelf (Position r c) (i, j) =
  canonicalPosition
    (codebookSurface shelf)
    (arrayShape (codebookArray shelf))
    (toInteger r + toInteger i)
    (toInteger c + toInteger j)

-- | What a symbol is, if that is certain: the network knows it, or it is a part that leaves less
-- than a hundredth of doubt.
certain :: ReadSymbol -> Maybe (Orientation, Int)
certain s
  | readSeen s < 1 && readDoubt s < 0.01 = Just (readLikeliest s)
  | otherwise = readClass s

-- | The orientation of the symbols' axis that fits them best, and the probability that it is the
-- other one, by what the symbols themselves show. Upright symbols decide for themselves; the code
-- is not asked.
likeliestOrientation :: Int -> Cells -> (Orientation, Double)
likeliestOrientation q cells
  | difference >= 0 = (one', doubt difference)
  | otherwise = (other, doubt (negate difference))
  where
    sideways = or [isSideways (fst (readLikeliest s)) | here <- Map.elems cells, s <- here]
    (one', other) = if sideways then (TurnedRight, TurnedLeft) else (Upright, HalfTurned)
    difference =
      sum
        [ log (sum (chances q one' here)) - log (sum (chances q other here))
          | here <- Map.elems cells
        ]
    doubt d = 1 / (1 + exp d)

-- | What the symbols read in a cell say of each class if the face lies so, up to a factor: the
-- product over the symbols, which were seen independently.
chances :: Int -> Orientation -> [ReadSymbol] -> [Double]
chances q orientation here = foldl' (zipWith (*)) (replicate q 1) (map ofSymbol here)
  where
    ofSymbol s =
      [sum [p | (what, p) <- readChances s, what == (orientation, c)] | c <- [0 .. q - 1]]

-- | The probabilities of the classes in a cell.
beliefIn :: KnownField k => Int -> Orientation -> [ReadSymbol] -> Maybe (Belief k)
beliefIn q orientation here
  | null here || total <= 0 = Nothing
  | otherwise = either (const Nothing) Just (belief (map (/ total) weights))
  where
    weights = chances q orientation here
    total = sum weights

-- | The symbols of this orientation that the network knows, where all of a cell agree. Refuses no
-- cells.
knownPatch :: KnownField k => Cells -> Orientation -> Either LocateError (Patch (GF k))
knownPatch cells orientation = patch (map (map (>>= agreed)) (gridRows cells))
  where
    agreed here = case [c | s <- here, Just (o, c) <- [readClass s], o == orientation] of
      c : others | all (== c) others -> either (const Nothing) Just (elementOfClass c)
      _ -> Nothing
