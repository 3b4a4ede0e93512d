-- | The inputs and answers of questions about touch. They need no profile. Grey values are
-- integers from 0 (no contact) to 65535 (full scale). Places and displacements are in taxels, to
-- the right and down.
module PraTactile.Conformance.Question.Touch
  ( Rows,
    WholeTaxels,
    Taxels,
    Drawings,
    Pair (..),
    Registered (..),
    NominalFrame (..),
    Symbol (..),
    fullScale,
  )
where

import Numeric.Natural (Natural)

-- | The grey values of a frame or of a composite: rows of equal length, from the top.
type Rows = [[Natural]]

-- | Whole taxels to the right and down.
type WholeTaxels = (Integer, Integer)

-- | Taxels to the right and down.
type Taxels = (Double, Double)

-- | The shapes of symbols, one per class: 12 rows of 8 taxels, @#@ for raised and @.@ for flat.
type Drawings = [[String]]

-- | Two frames of one size.
data Pair = Pair
  { pairFirst :: Rows,
    pairSecond :: Rows,
    -- | The nominal place of the second frame's upper left taxel in the first.
    pairStep :: WholeTaxels,
    -- | The greatest distance from there along each axis, in taxels.
    pairSearch :: Natural
  }
  deriving stock (Eq, Show)

-- | The displacement of the second of two frames in the first.
data Registered = Registered
  { -- | The reason for a refusal: @blank@, @one-axis@, @ambiguous@ or @no-overlap@; 'Nothing' if
    -- it is registered.
    registeredReason :: Maybe String,
    -- | The most probable displacement, also after a refusal.
    registeredBest :: Taxels,
    -- | Whether the displacement is determined along x, and along y.
    registeredFixed :: (Bool, Bool)
  }
  deriving stock (Eq, Show)

-- | A frame with the nominal place of its upper left taxel.
data NominalFrame = NominalFrame Rows WholeTaxels
  deriving stock (Eq, Show)

-- | A symbol in a composite.
data Symbol = Symbol
  { -- | Its centre, x and y in pixels of the composite. The centre of the upper left pixel is (0,
    -- 0).
    symbolPlace :: Taxels,
    -- | The direction of its x axis, in degrees clockwise from the composite's, up to half turns.
    symbolDegrees :: Double
  }
  deriving stock (Eq, Show)

-- | The largest grey value: 65535.
fullScale :: Natural
fullScale = 65535
