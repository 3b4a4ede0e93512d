{-# OPTIONS_HADDOCK hide #-}

-- | The parity checks that the code provides among observed cells. The contents of m cells of rank
-- r are a linear code of dimension r, so m - r independent parity checks hold among them. Let
-- column j have m_j of the cells, of rank r_j. Then m_j - r_j checks hold among the cells of column
-- j alone; they do not check how the columns lie beside each other. The remaining checks do, and
-- their number is the sum of all r_j, minus r. Rows are counted in the same way, and so are
-- sources: the patches in which cells were seen. docs/explanation/locating.md lists the numbers.
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

-- | The numbers of independent parity checks among cells in groups.
data Split = Split
  { -- | the number of checks within single groups
    checksWithin :: !Natural,
    -- | the number of further checks, across groups
    checksAcross :: !Natural
  }
  deriving stock (Eq, Show)

-- | The checks among cells, grouped by columns, rows and sources.
data Checks = Checks
  { checksOfColumns :: Split,
    checksOfRows :: Split,
    -- | for several sources only; a cell that two sources show is a check across them
    checksOfSources :: Maybe Split
  }
  deriving stock (Eq, Show)

-- | Whether there are checks, but only within groups.
noneAcross :: Split -> Bool
noneAcross (Split within across) = within > 0 && across == 0

-- | The checks among cells. The argument has, for each source, the offsets of its cells in the
-- upright patch. 'Nothing' on a surface other than the array's 'naturalSurface' and the sheet,
-- where contents are not linear. O(m n^2) for m cells, after 'cellVectors'.
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
