{-# OPTIONS_HADDOCK hide #-}

-- | What supports a position: the doubts that the probabilities leave, and the certain symbols.
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

-- | The probabilities of all causes that would make a position wrong. The causes exclude each
-- other.
data Doubts = Doubts
  { -- | the symbols are the array's, but at another position or in another orientation
    doubtOfPosition :: Double,
    -- | one frame lies elsewhere, and the frames then show another place
    doubtOfStitching :: Double,
    -- | the robot's axes or their scale differ, and the frames then show another place
    doubtOfAxes :: Double,
    -- | frames slipped by a whole cell along the face, and then show another place
    doubtOfSlip :: Double,
    -- | the surface does not carry the array
    doubtsOfOrigin :: ForeignDoubts
  }
  deriving stock (Eq, Show)

-- | What supports a position.
data Support = Support
  { -- | the doubts by the symbols' own probabilities
    supportDoubts :: Doubts,
    -- | the number of certain symbols that agree with the array
    supportAgreeing :: Int,
    -- | the numbers of certain symbols that disagree, lie another way up, or lie off the grid
    supportWrong :: [Int],
    -- | the composites, counted from 0, with more wrong than agreeing certain symbols
    supportInconsistent :: [Int],
    -- | the minimum distance of the cells with a certain symbol
    supportDistance :: Known,
    -- | the number of certain symbols that may be wrong
    supportRadius :: Natural,
    -- | an upper bound on the share of all contents of these cells that would be located; 'Nothing'
    -- if no cell is observed
    supportChance :: Maybe Chance,
    -- | what the code checks among these cells, with the composites as sources
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

-- | The support of the likeliest position, on the assumption that all frames lie where they were
-- put. 'Nothing' if no position is possible.
supportFrom :: KnownField k => Recogniser k -> Witnesses -> Asked k -> Maybe Support
supportFrom reader witnesses (Asked shown answered) = do
  answer <- either (const Nothing) Just answered
  candidate <- answerPosterior answer >>= posteriorBest
  PlaceDoubts elsewhere foreign' <- answerDoubts answer
  let standing = witnessesAt reader witnesses (candidatePosition candidate)
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
        supportAgreeing = length (agreeingWitnesses standing),
        supportWrong = map readNumber (wrongWitnesses standing),
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
