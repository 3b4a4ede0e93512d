{-# OPTIONS_HADDOCK hide #-}

-- | Queries: observed cells, in one patch or in several at known displacements; the symmetries in
-- which they may be seen; and the number of cells that may be wrong.
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
import PraTactile.Locate.Belief
import PraTactile.Locate.Patch
import PraTactile.Locate.Prior
import PraTactile.Symmetry

-- | What was observed in a cell.
data Cell (k :: Field)
  = -- | A symbol.
    Symbol !(GF k)
  | -- | The probability of each symbol; jointly with each symmetry in which the cell may be seen,
    -- if the cell shows that.
    Probabilities !(Belief k)
  deriving stock (Eq, Show)

type role Cell nominal

-- | The belief about a cell; a symbol is certain.
cellBelief :: KnownField k => Cell k -> Belief k
cellBelief cell = case cell of
  Symbol a -> certainly a
  Probabilities b -> b

-- | The number of observed cells that may be wrong.
data Radius
  = -- | The largest number that is certainly corrected: 'guaranteedRadius'.
    Guaranteed
  | -- | At most this many. Beyond the guaranteed radius an answer may be wrong.
    UpTo Natural
  deriving stock (Eq, Show)

-- | The largest e with 2 e < d, where d is the minimum distance: e wrong cells among the observed
-- ones are always corrected. 0 if d is 0.
--
-- >>> map guaranteedRadius [0, 1, 2, 4, 9]
-- [0,0,0,1,4]
guaranteedRadius :: Natural -> Natural
guaranteedRadius d = if d == 0 then 0 else (d - 1) `div` 2

-- | The radius as a number, for this minimum distance.
radiusFor :: Radius -> Natural -> Natural
radiusFor stated d = case stated of
  Guaranteed -> guaranteedRadius d
  UpTo e -> e

-- | A query for the place of patches.
data Query (k :: Field) = Query
  { -- | The patches as seen, all in the same symmetry. Each has the displacement of its upper left
    -- cell from a common point, in rows down and columns to the right.
    queryPatches :: [((Integer, Integer), Patch (Cell k))],
    -- | The symmetries in which they may be seen; only the identity if they are upright.
    querySymmetries :: [Symmetry],
    -- | The number of symbols that may be wrong. Only decoders of symbols use it.
    queryRadius :: Radius,
    -- | The tolerated probability of a wrong answer, below 1. It is used if any cell has
    -- probabilities, or if being foreign is weighed.
    queryDoubt :: Double,
    -- | The prior probability, below 1, that the patches are not the array's; 'Nothing' if that is
    -- not weighed.
    queryForeign :: Maybe Double,
    -- | The log-likelihood ratio of other symbols than the array's to the array's; minus infinity
    -- if unknown. It is used with 'queryForeign'.
    queryForeignShape :: Double,
    -- | The prior of each candidate and its silent cells ("PraTactile.Locate.Prior"), used if
    -- any cell has probabilities; 'Nothing' for a uniform prior.
    queryPrior :: Maybe (Candidate -> CandidatePrior)
  }

type role Query nominal

-- | The query for one upright patch: 'Guaranteed' radius, a tolerated doubt of a thousandth, and
-- nothing foreign.
onePatch :: Patch (Cell k) -> Query k
onePatch seen = Query [((0, 0), seen)] [identity] Guaranteed 0.001 Nothing (-1 / 0) Nothing
