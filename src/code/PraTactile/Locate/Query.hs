{-# OPTIONS_HADDOCK hide #-}

-- | The one question: cells that were observed, in one patch or in several at known displacements,
-- seen in one of the symmetries that are possible; and how much of them may be wrong.
module PraTactile.Locate.Query
  ( Query (..),
    onePatch,
    Cell (..),
    cellBelief,
    Radius (..),
    radiusFor,
    guaranteedRadius,
  )
where

import Numeric.Natural (Natural)
import PraTactile.Field
import PraTactile.Locate.Answer (Candidate)
import PraTactile.Locate.Beforehand
import PraTactile.Locate.Belief
import PraTactile.Locate.Patch
import PraTactile.Symmetry

-- | What was observed in a cell.
data Cell (k :: Field)
  = -- | A symbol.
    Symbol !(GF k)
  | -- | The probability of each symbol; where the cell shows how it lies, of each symmetry in which
    -- it may be seen, together with each symbol.
    Probabilities !(Belief k)
  deriving stock (Eq, Show)

type role Cell nominal

-- | What is known of a cell as probabilities: a symbol is beyond doubt.
cellBelief :: KnownField k => Cell k -> Belief k
cellBelief cell = case cell of
  Symbol a -> certainly a
  Probabilities b -> b

-- | How many of the observed cells may be taken to be wrong.
data Radius
  = -- | As many as can be corrected for certain: 'guaranteedRadius'.
    Guaranteed
  | -- | At most this many. Beyond the guaranteed radius an answer may be wrong.
    UpTo Natural
  deriving stock (Eq, Show)

-- | The largest e with 2 e < d, d being the minimum distance: e wrong cells among the observed ones
-- are always corrected. 0 if d is 0.
--
-- >>> map guaranteedRadius [0, 1, 2, 4, 9]
-- [0,0,0,1,4]
guaranteedRadius :: Natural -> Natural
guaranteedRadius d = if d == 0 then 0 else (d - 1) `div` 2

-- | The radius that is meant where the minimum distance is this.
radiusFor :: Radius -> Natural -> Natural
radiusFor stated d = case stated of
  Guaranteed -> guaranteedRadius d
  UpTo e -> e

-- | Where are these patches?
data Query (k :: Field) = Query
  { -- | As they are seen, all in the same symmetry, each with the displacement of its upper left
    -- cell, rows down and columns to the right, from a common point.
    queryPatches :: [((Integer, Integer), Patch (Cell k))],
    -- | In which symmetries they may be seen; the identity alone if they are upright.
    querySymmetries :: [Symmetry],
    -- | How many symbols may be wrong.
    queryRadius :: Radius,
    -- | The probability of a wrong answer that is tolerated, below 1; if any cell has
    -- probabilities, or if it is weighed that it may be foreign.
    queryDoubt :: Double,
    -- | The probability beforehand, below 1, that it is nothing of the array's; 'Nothing' where
    -- that is not weighed.
    queryForeign :: Maybe Double,
    -- | The logarithm of how many times as likely what was seen is if it shows other symbols than
    -- the array's; minus infinity where nobody says so. It counts where 'queryForeign' does.
    queryUnlike :: Double,
    -- | What is known of each candidate beside the cells; it counts where any cell has
    -- probabilities. 'Nothing' where nothing is.
    queryBeforehand :: Maybe (Candidate -> Beforehand)
  }

type role Query nominal

-- | The question for one upright patch: of symbols as many may be wrong as can be
-- corrected for certain, a doubt of a thousandth is tolerated, and nothing foreign is thought of.
onePatch :: Patch (Cell k) -> Query k
onePatch seen = Query [((0, 0), seen)] [identity] Guaranteed 0.001 Nothing (-1 / 0) Nothing
