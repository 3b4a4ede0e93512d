-- | The damage to the cells of a patch before it is located.
module PraTactile.Rates.Damage
  ( Damage (..),
  )
where

-- | The damage to each cell, independently.
data Damage = Damage
  { -- | The probability that the likeliest symbol of an observed cell is wrong: at least 0 and
    -- below 1 - 1/q.
    damageErrors :: !Double,
    -- | The probability that a cell is not observed: at least 0 and below 1.
    damageErasures :: !Double
  }
  deriving stock (Eq, Show)
