{-# LANGUAGE DerivingStrategies #-}

-- |
-- Locating patches that may be turned or mirrored: the nearest, or the likeliest, of all positions in all orientations
-- in question, as one answer. A patch is seen in one orientation; a position is that of its upper left cell once the orientation is
-- undone; offsets are those in the patch as it is seen.
module PraTactile.Locate.Oriented
  ( -- * Candidates
    Candidate (..)
  , OrientedOutcome (..)

    -- * The nearest
  , nearestOriented
  , OrientedDecision (..)

    -- * Other roads
  , boundedOriented
  , eachOriented
  , eachLaid

    -- * The likeliest
  , posteriorOriented
  , decideOriented
  ) where

import Data.List (nub, sort)
import Data.Maybe (catMaybes, mapMaybe)
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Locate.Algebra
import PraTactile.Locate.Book
import PraTactile.Locate.BoundedDistance
import PraTactile.Locate.Nearest
import PraTactile.Locate.Separation
import PraTactile.Symmetry
import PraTactile.Locate.Answer
import PraTactile.Locate.Patch
import PraTactile.Locate.Soft

-- | Where a patch may be, and how it is then seen.
data Candidate = Candidate
  { candidateSymmetry :: Symmetry
  , candidatePosition :: Position
  }
  deriving stock (Eq, Ord, Show)

-- | What is known of a patch's place and orientation.
data OrientedOutcome
  = -- | The only candidate; and the offsets of the complete windows that say so, each by the cell that is its upper left one.
    OrientedAt Candidate [Position]
  | -- | All candidates, two or more, by the orientations in the order in which they were asked for.
    OrientedAmong [Candidate]
  | -- | So many candidates, too many to list.
    OrientedMany Natural
  | -- | No candidate, and why.
    OrientedNowhere Reason
  deriving stock (Eq, Show)

-- | An outcome, and what it is worth.
data OrientedDecision = OrientedDecision
  { orientedOutcome :: OrientedOutcome
  , orientedWrong :: [Position]
  -- ^ The observed cells that are wrong if the patch is where and as it was located.
  , orientedNearest :: Maybe Natural
  -- ^ In how many cells the nearest candidate differs, within the radius or not; 'Nothing' if the patch fits nowhere on the sheet, and if
  -- not all positions were compared and none was found within the radius.
  , orientedRunnerUp :: Maybe Natural
  -- ^ In how many the next one differs, if all positions were compared.
  , orientedMinimum :: Natural
  -- ^ The number of observed cells in which two candidates differ at least: 'candidateDistance'.
  , orientedRadius :: Natural
  -- ^ The radius that was used.
  }
  deriving stock (Eq, Show)

-- | The candidate, of these orientations and all positions, that differs from the patch in the fewest cells. 'Guaranteed' is half
-- of the least distance between any two candidates, which several orientations make smaller, often 0: then only exact agreement is
-- answered. Several candidates equally near within the radius are ambiguous. The reasons to refuse are those of 'nearest'; where
-- those of the orientations differ, that of the orientation that came farthest: off the sheet, contradiction, no such window,
-- zeros.
nearestOriented :: KnownField k => Book k -> [Symmetry] -> Radius -> Patch k -> OrientedDecision
nearestOriented shelf possible stated observed =
  decided d radius (case sort (concatMap (\(_, _, (_, _, near, next)) -> catMaybes [near, next]) found) of { _ : next : _ -> Just next; _ -> Nothing }) found
 where
  offsets = map fst (observedCells observed)
  -- In a single orientation all positions are compared for it, which is exact.
  d = case nub possible of
    [only] -> observedDistance shelf (map (onPosition (invert only) (patchShape observed)) offsets)
    _ -> candidateDistance (bookSurface shelf) (bookArray shelf) possible (patchShape observed) offsets
  radius = radiusFor stated d
  found =
    [ (o, patchShape laid, (decisionOutcome decision, decisionWrong decision, decisionNearest decision, decisionRunnerUp decision))
    | (o, laid) <- eachLaid possible observed
    , let decision = nearest shelf (UpTo radius) laid
    ]

-- | The same on arrays of any size, by "PraTactile.Locate.BoundedDistance" in each orientation.
boundedOriented
  :: KnownField k => Algebra k -> [Symmetry] -> Radius -> Patch k -> Either DecodingError OrientedDecision
boundedOriented algebra possible stated observed = decided d radius Nothing <$> traverse decode (eachLaid possible observed)
 where
  d = candidateDistance (algebraSurface algebra) (algebraArray algebra) possible (patchShape observed) (map fst (observedCells observed))
  radius = radiusFor stated d
  decode (o, laid) = do
    decoding <- decodePatch algebra (UpTo radius) laid
    let near = case decodingNearest decoding of
          Exactly e -> Just e
          AtLeast _ -> Nothing
    pure (o, patchShape laid, (decodingOutcome decoding, decodingWrong decoding, near, Nothing))

-- | What orientations come to, each with the upright patch's shape, its outcome, the wrong cells, and in how many cells the nearest
-- position and the next differ; by the distance, the radius and the runner-up of all.
decided :: Natural -> Natural -> Maybe Natural -> [(Symmetry, Shape, (Outcome, [Position], Maybe Natural, Maybe Natural))] -> OrientedDecision
decided d radius next found =
  OrientedDecision
    { orientedOutcome = outcome
    , orientedWrong = wrong
    , orientedNearest = least
    , orientedRunnerUp = next
    , orientedMinimum = d
    , orientedRadius = radius
    }
 where
  least = case mapMaybe nearestOf found of
    [] -> Nothing
    distances -> Just (minimum distances)
  nearestOf (_, _, (_, _, near, _)) = near
  -- Those farther away may be within the radius, too, but are no candidates.
  nearestOnes = [one' | one' <- found, nearestOf one' == least]
  outcome = together [(o, shape, answer) | (o, shape, (answer, _, _, _)) <- if any answered nearestOnes then nearestOnes else found]
  wrong = case (outcome, filter answered nearestOnes) of
    (OrientedAt _ _, [(o, shape, (_, cells, _, _))]) -> sort (map (onPosition o shape) cells)
    _ -> []
  answered (_, _, (answer, _, _, _)) = case answer of
    Refused _ -> False
    _ -> True

-- | The outcome of another road, which answers exact agreement only, in all these orientations. Refuses where the road
-- refuses one of them.
eachOriented :: [Symmetry] -> (Patch k -> Either e Outcome) -> Patch k -> Either e OrientedOutcome
eachOriented possible road observed = together <$> traverse answer (eachLaid possible observed)
 where
  answer (o, laid) = (,,) o (patchShape laid) <$> road laid

-- | The patch upright again, by each orientation in which it may be seen.
eachLaid :: [Symmetry] -> Patch k -> [(Symmetry, Patch k)]
eachLaid possible observed =
  [(o, rearranged (onShape back shape) (onPosition back shape) observed) | o <- nub possible, let back = invert o]
 where
  shape = patchShape observed

-- | The outcomes in several orientations, with the upright patch's shape, as one.
together :: [(Symmetry, Shape, Outcome)] -> OrientedOutcome
together outcomes = case (concatMap listed outcomes, sum (map unlisted outcomes)) of
  ([], 0) -> OrientedNowhere (farthest [reason | (_, _, Refused reason) <- outcomes])
  ([(found, support)], 0) -> OrientedAt found support
  (several, 0) -> OrientedAmong (map fst several)
  (several, more) -> OrientedMany (fromIntegral (length several) + more)
 where
  listed (o, shape, outcome) = case outcome of
    Located place support -> [(Candidate o place, sort (map (onPosition o shape) support))]
    Ambiguous places _ -> [(Candidate o place, []) | place <- places]
    _ -> []
  unlisted (_, _, outcome) = case outcome of
    AmbiguousCoset count _ -> count
    _ -> 0
  farthest given = case filter (`elem` given) [OffSheet, Contradiction, NotInArray, NoCompleteWindow, BeyondRadius, ZeroWindow] of
    reason : _ -> reason
    [] -> TooFewCells

-- | How likely each of these orientations is with each position of the book, all of them being equally likely beforehand; on the
-- sheet those with which all observed cells lie on it.
posteriorOriented :: Book k -> [Symmetry] -> SoftPatch k -> PosteriorOver Candidate
posteriorOriented shelf possible observed = ranked candidateAt (Primitive.concat [comparedTotals compared | (_, compared) <- comparisons])
 where
  -- In every orientation the cells are added up in the same order, so that what is equally likely is found equal.
  comparisons = [(o, likelihoods shelf [(onPosition (invert o) shape offset, b) | (offset, b) <- softCells observed]) | o <- nub possible]
  shape = softShape observed
  candidateAt i = go i comparisons
  go i given = case given of
    (o, compared) : others
      | i < size || null others -> Candidate o (comparedPosition compared i)
      | otherwise -> go (i - size) others
     where
      size = Primitive.length (comparedTotals compared)
    -- Without orientations there are no indices.
    [] -> Candidate identity (Position 0 0)

-- | @decideOriented tolerated@: the likeliest candidate, as 'decide' does.
decideOriented :: Double -> PosteriorOver Candidate -> OrientedOutcome
decideOriented tolerated found = case decideAmong tolerated found of
  Right [only] -> OrientedAt only []
  Right several -> OrientedAmong several
  Left reason -> OrientedNowhere reason
