-- | What the questions about networks are about. No profile is known to them.
module PraTactile.Conformance.Question.Network
  ( Values,
    Weights (..),
  )
where

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
