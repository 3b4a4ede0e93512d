-- |
-- The code book of an array: every position with what a patch there would hold. For arrays of up to
-- 2^20 cells, decoding is the comparison of a patch with the whole book, which is exact.
module PraTactile.Locate.Book
  ( -- * Books
    Book,
    book,
    bookSurface,
    bookArray,
    bookMask,
    bookGrid,

    -- * Comparing
    Comparison,
    compareWith,
    comparedTotals,
    comparedPosition,

    -- * The distance of a code
    observedDistance,
  )
where

import Data.Proxy (Proxy (..))
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Grid
import PraTactile.Locate.Compare
import PraTactile.Locate.Definition (largestSearchedArray)
import PraTactile.Locate.Patch (LocateError (..))
import PraTactile.Window

-- | An array on a surface, with the window that its support and its refusals are named by.
data Book (k :: Field) = Book
  { -- | What lies beyond the edges.
    bookSurface :: !Surface,
    -- | The array.
    bookArray :: !(PseudorandomArray k),
    -- | The array's window.
    bookMask :: !Mask,
    -- | All its cells.
    bookGrid :: !Grid,
    -- | By symbol: 0 for zero and 1 for the others.
    weightAt :: !(Primitive.Vector Int)
  }

type role Book nominal

-- | The book of an array. Refuses arrays of more than 'largestSearchedArray' cells.
book ::
  forall k.
  KnownField k =>
  Surface ->
  PseudorandomArray k ->
  Mask ->
  Either LocateError (Book k)
book surface array mask
  | cells > largestSearchedArray = Left (TooManyPlaces cells largestSearchedArray)
  | otherwise = do
    grid <- either (Left . TableArray) Right (toGrid array)
    pure (Book surface array mask grid (Primitive.fromList (0 : replicate (q - 1) 1)))
  where
    cells = area (arrayShape array)
    q = fieldOrder (Proxy :: Proxy k)

-- | Sums at every position of the book at which the compared cells lie on the surface, in order.
data Comparison a = Comparison !Shape !(Primitive.Vector a)

-- | The sums, one a position.
comparedTotals :: Comparison a -> Primitive.Vector a
comparedTotals (Comparison _ sums) = sums

-- | The position that an index of the sums belongs to.
comparedPosition :: Comparison a -> Int -> Position
comparedPosition (Comparison shape _) = placeOf shape

-- | What the cells are worth at every position: of each its offset and what each symbol there is
-- worth, by its code, q entries.
compareWith ::
  (Primitive.Prim a, Num a) =>
  Book k ->
  [(Position, Primitive.Vector a)] ->
  Comparison a
compareWith shelf cells =
  Comparison (comparedShape surface (gridShape grid) extent) (totals surface grid extent cells)
  where
    surface = bookSurface shelf
    grid = bookGrid shelf
    extent = extentOf (map fst cells)
{-# INLINE compareWith #-}

-- | The minimum distance of the contents of the cells with these offsets, as they are on the
-- array's 'naturalSurface', where they are a linear code, so that it is the least number of them
-- that are not zero; 0 when some positions are not told apart. It holds on the sheet as well; for
-- another surface, where the contents are not linear, no distance is promised, and this is 0.
observedDistance :: Book k -> [Position] -> Natural
observedDistance shelf offsets
  | bookSurface shelf /= Sheet && bookSurface shelf /= natural = 0
  | null offsets = 0
  | otherwise = fromIntegral (Primitive.minimum sums)
  where
    natural = naturalSurface (arrayFolding (bookArray shelf))
    -- On a torus there is a sum for every cell of the array, and so at least one.
    sums =
      totals natural (bookGrid shelf) (Shape 1 1) [(offset, weightAt shelf) | offset <- offsets]
