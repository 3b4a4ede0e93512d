-- | What the questions about networks are about, and their answers. No profile is known to them.
module PraTactile.Conformance.Question.Network
  ( Values,
    Weights (..),
    Training (..),
    Descended (..),
  )
where

import Numeric.Natural (Natural)
import PraTactile.Classification.Traingdx (Outcome)

-- | An image of 12 rows of 8 values each, 0 where it is flat and 1 where it is embossed.
type Values = [[Double]]

-- | A network: a row a unit, its weights and then its bias.
data Weights = Weights
  { -- | of 96 weights each, for the image's values row by row
    weightsHidden :: [[Double]],
    -- | as many weights as there are hidden units; a unit a class
    weightsOutput :: [[Double]]
  }
  deriving stock (Eq, Show)

-- | With what, and how, a network is trained.
data Training = Training
  { -- | each with its class
    trainingImages :: [(Values, Natural)],
    -- | how many at most; 50 can be asked for
    trainingEpochs :: Natural,
    trainingRate :: Double,
    trainingMomentum :: Double,
    -- | the error, and the norm of its gradient, at which a training ends
    trainingGoal :: Double,
    trainingLeast :: Double
  }
  deriving stock (Eq, Show)

-- | Where a training ends.
data Descended = Descended
  { descendedError :: Double,
    -- | the learning rate of the epoch that would have been the next
    descendedRate :: Double,
    -- | what became of the last epoch's step
    descendedStep :: Outcome
  }
  deriving stock (Eq, Show)
