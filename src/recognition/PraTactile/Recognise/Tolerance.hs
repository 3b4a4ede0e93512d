{-# OPTIONS_HADDOCK hide #-}

-- | The errors that a caller tolerates in an answer, and the priors that answers are weighed by.
module PraTactile.Recognise.Tolerance
  ( Tolerance (..),
    standardTolerance,
  )
where

import PraTactile.Locate (Radius (..))

-- | The errors that a caller tolerates, and the prior probabilities of their causes.
data Tolerance = Tolerance
  { -- | the greatest probability of a wrong answer, below 1
    toleratedDoubt :: Double,
    -- | the number of certain symbols that may be wrong
    toleratedErrors :: Radius,
    -- | the prior probability that the surface has the array's shapes in another arrangement, and
    -- also that it has other shapes; both have this prior, below 1
    foreignPrior :: Double,
    -- | the prior probability that the robot's axes are not as assumed; 'Nothing' stands for 1/100,
    -- or 1/400 if the axes were stated
    axesPrior :: Maybe Double,
    -- | the prior probability that frames slipped by a whole cell: in one folder, the frames beyond
    -- some line; with several folders, each folder but the first
    slipPrior :: Double
  }
  deriving stock (Eq, Show)

-- | A doubt of 1/100, as many wrong symbols as their minimum distance guarantees to correct, a
-- foreign surface once in 200 touches, and a slip once in 500 presses. With these values four
-- certain symbols are enough for an answer, although nearly every arrangement of four occurs in the
-- array.
standardTolerance :: Tolerance
standardTolerance =
  Tolerance
    { toleratedDoubt = 0.01,
      toleratedErrors = Guaranteed,
      foreignPrior = 0.005,
      axesPrior = Nothing,
      slipPrior = 0.002
    }
