{-# OPTIONS_HADDOCK hide #-}

-- | What a caller tolerates in an answer, and the prior probabilities that answers are weighed by.
module PraTactile.Recognise.Tolerance
  ( Tolerance (..),
    standardTolerance,
  )
where

import PraTactile.Locate (Radius (..))

-- | The errors that an answer may have, and the prior probabilities of what makes one wrong.
data Tolerance = Tolerance
  { -- | the greatest probability of a wrong answer, below 1
    toleratedDoubt :: Double,
    -- | how many certain symbols may be wrong
    toleratedErrors :: Radius,
    -- | the prior probability that the surface has the shapes in another arrangement than the
    -- array's, and that it has other shapes: each this, below 1
    foreignPrior :: Double,
    -- | the prior probability that the robot's axes are others than supposed; 'Nothing' stands for
    -- 1/100, or 1/400 where the axes were stated
    axesPrior :: Maybe Double,
    -- | the prior probability that frames slipped by a whole cell: of one folder, those beyond some
    -- line; of several folders, each but the first
    slipPrior :: Double
  }
  deriving stock (Eq, Show)

-- | A doubt of 1/100; as many wrong symbols as their minimum distance guarantees to correct; a
-- foreign surface once in 200 touches, and a slip once in 500 presses. By these, four certain
-- symbols are still an answer, although nearly every arrangement of four occurs in the array.
standardTolerance :: Tolerance
standardTolerance =
  Tolerance
    { toleratedDoubt = 0.01,
      toleratedErrors = Guaranteed,
      foreignPrior = 0.005,
      axesPrior = Nothing,
      slipPrior = 0.002
    }
