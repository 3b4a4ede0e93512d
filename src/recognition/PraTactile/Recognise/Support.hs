{-# OPTIONS_HADDOCK hide #-}

-- | What a position rests on: the doubts that the probabilities leave, and the certain symbols.
module PraTactile.Recognise.Support
  ( Support (..),
    supportFrom,

    -- * Doubts
    Doubts (..),
    supportDoubt,
  )
where

import Data.List (genericLength)
import Data.Maybe (fromMaybe)
import Numeric.Natural (Natural)
import PraTactile.Field
import PraTactile.Locate
import PraTactile.Locate.Chance
import PraTactile.Locate.Checks (checksAmong)
import PraTactile.Recognise.Likeliest
import PraTactile.Recognise.Reading
import PraTactile.Recognise.Recogniser
import PraTactile.Recognise.Witnesses
import PraTactile.Symmetry

-- | What would make a position wrong, each with its probability. They exclude each other.
data Doubts = Doubts
  { -- | the symbols are the array's, but the orientation or the position is another
    doubtOfPosition :: Double,
    -- | a frame lies elsewhere than it was put, and then the frames show something else
    doubtOfStitching :: Double,
    -- | the robot's axes, or their scale, are others, and then the frames show something else
    doubtOfAxes :: Double,
    -- | frames slipped by a whole cell along the face, and then they show something else
    doubtOfSlip :: Double,
    -- | the surface is not the array's
    doubtsOfOrigin :: ForeignDoubts
  }
  deriving stock (Eq, Show)

-- | What a position rests on.
data Support = Support
  { -- | why it may be wrong, by the symbols' own probabilities
    supportDoubts :: Doubts,
    -- | how many certain symbols are what the array has in their cells
    supportAgreeing :: Int,
    -- | the numbers of those that are not, that lie another way up, or that lie off the grid
    supportWrong :: [Int],
    -- | the composites, counted from 0, of whose certain symbols more are wrong than agree
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

-- | What the likeliest position rests on, its frames lying where they were put. 'Nothing' where no
-- position is possible.
supportFrom :: KnownField k => Recogniser k -> Witnesses -> Asked k -> Maybe Support
supportFrom reader witnesses (Asked shown answered) = do
  answer <- either (const Nothing) Just answered
  candidate <- answerPosterior answer >>= posteriorBest
  PlaceDoubts elsewhere foreign' <- answerDoubts answer
  let standing = standingAt reader witnesses (candidatePosition candidate)
  pure
    Support
      { supportDoubts =
          Doubts
            { doubtOfPosition = fromMaybe 0 elsewhere,
              doubtOfStitching = 0,
              doubtOfAxes = 0,
              doubtOfSlip = 0,
              doubtsOfOrigin = foreign'
            },
        supportAgreeing = length (standingAgreeing standing),
        supportWrong = map readNumber (standingWrong standing),
        supportInconsistent = mostlyWrong standing,
        supportDistance = witnessesDistance witnesses,
        supportRadius = witnessesRadius witnesses,
        supportChance = chanceAmong reader (candidateSymmetry candidate) shown witnesses,
        supportChecks = checksAmong (locatorArray (recogniserLocator reader)) (bySource witnesses)
      }

-- | The share of all contents of the witnesses' cells that would be located.
chanceAmong ::
  KnownField k => Recogniser k -> Symmetry -> Patch (Belief k) -> Witnesses -> Maybe Chance
chanceAmong reader way shown witnesses =
  chance
    . amongCells (genericLength (witnessesCells witnesses))
    . correcting (atLeast (witnessesDistance witnesses)) (witnessesRadius witnesses)
    <$> spheres
      (locatorArray (recogniserLocator reader))
      [way]
      (patchShape shown)
      (map fst (observedCells shown))
