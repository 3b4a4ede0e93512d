-- | What the questions about touch are about, and their answers. No profile is known to them. Grey
-- values are whole numbers from 0, no contact, to 65535, full scale; places and displacements are
-- in taxels, to the right and down.
module PraTactile.Conformance.Question.Touch
  ( Rows,
    WholeTaxels,
    Taxels,
    Drawings,
    Pair (..),
    Registered (..),
    Placed (..),
    Symbol (..),
    fullScale,
  )
where

import Numeric.Natural (Natural)

-- | The grey values of a frame, or of a composite: rows of one length, from the top.
type Rows = [[Natural]]

-- | WholeTaxels taxels to the right and down.
type WholeTaxels = (Integer, Integer)

-- | Taxels to the right and down.
type Taxels = (Double, Double)

-- | The shapes of symbols, a class each: 12 rows of 8 taxels, @#@ for one that is raised and @.@
-- for one that is not.
type Drawings = [[String]]

-- | Two frames of one size.
data Pair = Pair
  { pairFirst :: Rows,
    pairSecond :: Rows,
    -- | Where the second frame's upper left taxel should lie in the first.
    pairStep :: WholeTaxels,
    -- | How far it may lie from there along each axis, taxels.
    pairSearch :: Natural
  }
  deriving stock (Eq, Show)

-- | Where the second of two frames lies in the first.
data Registered = Registered
  { -- | Why that is not given: @blank@, @one-axis@, @ambiguous@ or @no-overlap@; 'Nothing' where it
    -- is.
    registeredReason :: Maybe String,
    -- | Where it most probably lies, also if it is not given.
    registeredBest :: Taxels,
    -- | Whether the displacement along x is fixed, and that along y.
    registeredFixed :: (Bool, Bool)
  }
  deriving stock (Eq, Show)

-- | A frame, and where its upper left taxel should be.
data Placed = Placed Rows WholeTaxels
  deriving stock (Eq, Show)

-- | A symbol in a composite.
data Symbol = Symbol
  { -- | Its centre, x and y in pixels of the composite, the upper left one's centre being (0, 0).
    symbolPlace :: Taxels,
    -- | The direction of its x axis, degrees clockwise from the composite's, up to half turns.
    symbolDegrees :: Double
  }
  deriving stock (Eq, Show)

-- | The largest grey value: 65535.
fullScale :: Natural
fullScale = 65535
