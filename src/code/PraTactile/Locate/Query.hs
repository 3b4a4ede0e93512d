{-# OPTIONS_HADDOCK hide #-}

-- | Queries: observed cells, in one patch or in several at known displacements; the symmetries in
-- which they may be seen; how many cells may be wrong; the tolerated doubt of the answer; and the
-- priors of candidates and of foreign patches.
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
  | -- | The probability of each symbol. If the cell's image shows which way up it is, the
    -- probability of each pair of a symbol and a symmetry.
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

-- | The largest e with 2 e < d, where d is the minimum distance: the least number of observed cells
-- in which two positions differ. Up to e wrong cells are always corrected. 0 if d is 0.
--
-- >>> map guaranteedRadius [0, 1, 2, 4, 9]
-- [0,0,0,1,4]
guaranteedRadius :: Natural -> Natural
guaranteedRadius d = if d == 0 then 0 else (d - 1) `div` 2

-- | The radius as a number, if the observed cells have this minimum distance.
radiusFor :: Radius -> Natural -> Natural
radiusFor stated d = case stated of
  Guaranteed -> guaranteedRadius d
  UpTo e -> e

-- | A query for the place of patches. It is decoded by probabilities if any cell has probabilities,
-- or if the locator's requested decoder treats symbols as probabilities; otherwise by symbols.
data Query (k :: Field) = Query
  { -- | The patches as seen, all in the same symmetry. Each has the displacement of its upper left
    -- cell from a common point, in rows down and columns to the right. Displacements are as seen,
    -- too: before the symmetry is undone.
    queryPatches :: [((Integer, Integer), Patch (Cell k))],
    -- | The symmetries in which they may be seen; only the identity if they are upright.
    querySymmetries :: [Symmetry],
    -- | The number of symbols that may be wrong. Decoding by probabilities ignores it.
    queryRadius :: Radius,
    -- | The tolerated probability of a wrong answer, below 1. It is used when decoding by
    -- probabilities, and if 'queryForeign' is given.
    queryDoubt :: Double,
    -- | The prior probability, below 1, that the patches are not the array's; 'Nothing' if that is
    -- not weighed.
    queryForeign :: Maybe Double,
    -- | The logarithm of a likelihood ratio: the probability of what was seen in all cells if the
    -- symbols are of other shapes than the array's, over that if they are the array's. Minus
    -- infinity excludes other shapes. It is used only with 'queryForeign'.
    queryForeignShape :: Double,
    -- | For each candidate its prior and its silent cells: those that do not show the array if the
    -- candidate is right ("PraTactile.Locate.Prior"). Decoding by symbols ignores it.
    -- 'Nothing' is a uniform prior without silent cells.
    queryPrior :: Maybe (Candidate -> CandidatePrior)
  }

type role Query nominal

-- | The query for one upright patch: 'Guaranteed' radius, and a tolerated doubt of a thousandth.
-- The prior is uniform, and the patch is taken to be the array's.
onePatch :: Patch (Cell k) -> Query k
onePatch seen = Query [((0, 0), seen)] [identity] Guaranteed 0.001 Nothing (-1 / 0) Nothing
