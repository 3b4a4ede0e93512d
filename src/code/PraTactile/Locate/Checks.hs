{-# OPTIONS_HADDOCK hide #-}

-- | What the code has checked among observed cells. The contents of m cells of rank r are a linear
-- code of dimension r, so that m - r independent parity checks hold among them. Those that hold
-- among the cells of one column alone, m_j - r_j for the column j, say nothing of how the columns
-- lie beside each other; only the others do, which number sum of r_j, less r. Likewise with rows,
-- and with the sources that cells were seen in. docs/explanation/locating.md lists how many there
-- are.
module PraTactile.Locate.Checks
  ( Checks (..),
    Split (..),
    noneAcross,
    checksAmong,
  )
where

import qualified Data.Map.Strict as Map
import Data.Maybe (mapMaybe)
import qualified Data.Set as Set
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.LinearCode.Elimination
import PraTactile.Polynomial
import PraTactile.Window.Rank

-- | The independent parity checks among cells that are in groups.
data Split = Split
  { -- | that hold within single groups
    checksWithin :: !Natural,
    -- | beyond those
    checksAcross :: !Natural
  }
  deriving stock (Eq, Show)

-- | The checks among cells, in groups of three kinds.
data Checks = Checks
  { checksOfColumns :: Split,
    checksOfRows :: Split,
    -- | a cell that two sources show is checked across them; 'Nothing' of a single source
    checksOfSources :: Maybe Split
  }
  deriving stock (Eq, Show)

-- | Whether there are checks, and none of them beyond single groups.
noneAcross :: Split -> Bool
noneAcross (Split within across) = within > 0 && across == 0

-- | The checks among the cells with these offsets in an upright patch, source by source. 'Nothing'
-- on a surface other than the array's 'naturalSurface' and the sheet, where contents are not
-- linear. O(m n^2) for m cells, after 'cellVectors'.
checksAmong :: KnownField k => ArrayOn k -> [[Position]] -> Maybe Checks
checksAmong (ArrayOn surface array) given
  | surface `notElem` [Sheet, naturalSurface (arrayFolding array)] = Nothing
  | otherwise =
    Just
      Checks
        { checksOfColumns = split (along column),
          checksOfRows = split (along row),
          checksOfSources = if length sources > 1 then Just (split sources) else Nothing
        }
  where
    sources = filter (not . null) (map (Set.toAscList . Set.fromList) given)
    cells = Set.toAscList (Set.fromList (concat sources))
    along index = Map.elems (Map.fromListWith (++) [(index cell, [cell]) | cell <- cells])
    split groups = Split (sum (map size groups) - ranks) (ranks - rank cells)
      where
        ranks = sum (map rank groups)
    size group = fromIntegral (length group) :: Natural
    vectors = Map.fromList (zip cells (cellVectors array cells))
    rank group =
      fromIntegral (length (independentRows n (mapMaybe (`Map.lookup` vectors) group))) :: Natural
    n = primitiveDegree (arrayPrimitive array)
