{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE ScopedTypeVariables #-}

-- |
-- Locating with wrong and missing cells: the position whose content differs from the observed cells
-- in the fewest of them. With d the minimum distance of the cells that were observed, e wrong ones
-- among them never mislead if 2 e < d; so s missing cells out of a window of distance d' never do if
-- 2 e + s < d', and often more of them do not, because d is seldom as small as d' - s (R. C.
-- Singleton 1964; F. J. MacWilliams and N. J. A. Sloane 1977, chapter 1). Exact: the patch is
-- compared with every position.
module PraTactile.Locate.Nearest
  ( -- * Deciding
    nearest
  , Decision (..)
  , Radius (..)

    -- * The guaranteed radius
  , guaranteedRadius
  , radiusFor
  ) where

import Data.Proxy (Proxy (..))
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Grid (canonicalPosition)
import PraTactile.Locate.Book
import PraTactile.Locate.Outcome
import PraTactile.Locate.Patch
import PraTactile.Locate.Search (agreeing, nowhere)
import PraTactile.Window (maskOffsets)

-- | How many of the observed cells may be taken to be wrong.
data Radius
  = -- | As many as can be corrected for certain: 'guaranteedRadius'.
    Guaranteed
  | -- | At most so many. Beyond the guaranteed radius an answer may be wrong.
    UpTo Natural
  deriving stock (Eq, Show)

-- | An outcome, and what it is worth.
data Decision = Decision
  { decisionOutcome :: Outcome
  -- ^ The position, or the several nearest ones. The support are the complete windows without a wrong
  -- cell.
  , decisionWrong :: [Position]
  -- ^ The offsets of the observed cells that are wrong if the patch is where it was located.
  , decisionNearest :: Maybe Natural
  -- ^ In how many cells the nearest position differs, within the radius or not; 'Nothing' if the
  -- patch fits nowhere on the sheet.
  , decisionRunnerUp :: Maybe Natural
  -- ^ In how many the next one differs; 'Nothing' if there is one position only.
  , decisionDistance :: Natural
  -- ^ The minimum distance of the observed cells.
  , decisionRadius :: Natural
  -- ^ The radius that was used.
  }
  deriving stock (Eq, Show)

-- | The largest e with 2 e < d, d being the minimum distance: so many wrong cells among the observed
-- ones are always corrected. 0 if d is 0.
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

-- | The nearest position within the radius. If there is none, the reason is 'ZeroWindow' where the
-- patch is within the radius of all zeros, which stand nowhere; that of the exact search if nothing may be
-- corrected; and else 'BeyondRadius'. Several positions equally near, which needs a radius beyond the
-- guaranteed one or cells that do not tell positions apart, are 'Ambiguous'. No observed cells are
-- 'TooFewCells'.
nearest :: forall k. KnownField k => Book k -> Radius -> Patch k -> Decision
nearest shelf stated observed =
  Decision
    { decisionOutcome = outcome
    , decisionWrong = wrong
    , decisionNearest = if size == 0 then Nothing else Just (fromIntegral least)
    , decisionRunnerUp = if size <= 1 then Nothing else Just (fromIntegral next)
    , decisionDistance = d
    , decisionRadius = radius
    }
 where
  cells = observedCells observed
  d = observedDistance shelf (map fst cells)
  radius = radiusFor stated d
  comparison = compareWith shelf [(offset, otherThan a) | (offset, a) <- cells]
  distances = comparedTotals comparison
  size = Primitive.length distances
  (least, next) = leastTwo distances
  (outcome, wrong)
    | null cells = (Refused TooFewCells, [])
    | size > 0 && fromIntegral least <= radius = case nearestIndices of
        [i] ->
          let place = comparedPosition comparison i
              differing = wrongAt place
           in (Located place (supportWithout differing), differing)
        indices -> (Ambiguous (map (comparedPosition comparison) indices) (supportWithout []), [])
    | radius == 0 = (Refused (nowhere (bookSurface shelf) array (bookMask shelf) (agreeing (bookSurface shelf) array) observed), [])
    | weight <= radius = (Refused ZeroWindow, [])
    | otherwise = (Refused BeyondRadius, [])
  nearestIndices = [i | (i, e) <- zip [0 ..] (Primitive.toList distances), e == least]
  weight = fromIntegral (length (filter ((/= zero) . snd) cells))
  wrongAt (Position r c) =
    [ offset
    | (offset@(Position i j), a) <- cells
    , fmap (cellAt array) (canonicalPosition (bookSurface shelf) (arrayShape array) (toInteger (r + i)) (toInteger (c + j))) /= Just a
    ]
  supportWithout differing =
    [ offset
    | (offset@(Position i j), _) <- completeWindows (bookMask shelf) observed
    , and [Position (i + i') (j + j') `notElem` differing | Position i' j' <- maskOffsets (bookMask shelf)]
    ]
  array = bookArray shelf
  q = fieldOrder (Proxy :: Proxy k)
  otherThan a = Primitive.generate q (\code -> if code == toCode a then 0 else 1)

-- | The least number and the next one, the same if it occurs twice; 'maxBound' for lack of numbers.
leastTwo :: Primitive.Vector Int -> (Int, Int)
leastTwo numbers = go 0 maxBound maxBound
 where
  go !i !a !b
    | i == Primitive.length numbers = (a, b)
    | x < a = go (i + 1) x a
    | x < b = go (i + 1) a x
    | otherwise = go (i + 1) a b
   where
    x = Primitive.unsafeIndex numbers i
