-- | The inputs of questions about networks. They need no profile.
module PraTactile.Conformance.Question.Network
  ( Values,
    Weights (..),
  )
where

-- | An image of 12 rows of 8 values: 0 where flat, 1 where embossed.
type Values = [[Double]]

-- | A network: one row per unit, its weights and then its bias.
data Weights = Weights
  { -- | 96 weights each, for the image's values row by row
    weightsHidden :: [[Double]],
    -- | as many weights as hidden units; one unit per class
    weightsOutput :: [[Double]]
  }
  deriving stock (Eq, Show)
