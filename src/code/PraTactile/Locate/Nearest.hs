{-# LANGUAGE BangPatterns #-}

-- | Locating with wrong and missing cells: the position whose content differs from the observed
-- cells in the fewest of them. With d the minimum distance of the cells that were observed, e wrong
-- ones among them never mislead if 2 e < d; so s missing cells out of a window of distance d' never
-- do if 2 e + s < d', and often more of them do not, because d is seldom as small as d' - s (R. C.
-- Singleton 1964; F. J. MacWilliams and N. J. A. Sloane 1977, chapter 1). Exact: the patch is
-- compared with every position.
module PraTactile.Locate.Nearest
  ( -- * Deciding
    nearest,
  )
where

import Data.Proxy (Proxy (..))
import qualified Data.Vector.Primitive as Primitive
import PraTactile.Array
import PraTactile.Field
import PraTactile.Grid (canonicalPosition)
import PraTactile.Locate.Answer
import PraTactile.Locate.Book
import PraTactile.Locate.Decision
import PraTactile.Locate.Definition (agreeing, nowhere)
import PraTactile.Locate.Patch
import PraTactile.Locate.Query (Radius, radiusFor)

-- | The nearest position within the radius. If there is none, the reason is 'ZeroWindow' where the
-- patch is within the radius of all zeros, which stand nowhere; that of the exact search if nothing
-- may be corrected; and else 'BeyondRadius'. Several positions equally near, which needs a radius
-- beyond the guaranteed one or cells that do not tell positions apart, are 'Ambiguous'. No observed
-- cells are 'TooFewCells'.
nearest :: forall k. KnownField k => Book k -> Radius -> Patch (GF k) -> Decision Position
nearest shelf stated observed
  | null cells = nowhereDecision (radiusFor stated 0)
  | otherwise =
    Decision
      outcome
      Distances
        { corrected = wrong,
          nearestDistance = if size == 0 then Nothing else Just (Exactly (fromIntegral least)),
          runnerUpDistance = if size <= 1 then Nothing else Just (Exactly (fromIntegral next)),
          codeDistance = Exactly d,
          correctionRadius = radius
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
      | size > 0 && fromIntegral least <= radius = case nearestIndices of
        [i] ->
          let place = comparedPosition comparison i
              differing = wrongCells place
           in (Unique place (windowsWithout differing (bookMask shelf) observed), differing)
        indices ->
          ( Ambiguous
              (map (comparedPosition comparison) indices)
              (windowsWithout [] (bookMask shelf) observed),
            []
          )
      | radius == 0 =
        ( Refused
            ( nowhere
                (bookSurface shelf)
                array
                (bookMask shelf)
                (agreeing (bookSurface shelf) array)
                observed
            ),
          []
        )
      | weight <= radius = (Refused ZeroWindow, [])
      | otherwise = (Refused BeyondRadius, [])
    nearestIndices = [i | (i, e) <- zip [0 ..] (Primitive.toList distances), e == least]
    weight = fromIntegral (length (filter ((/= zero) . snd) cells))
    wrongCells (Position r c) =
      [ offset
        | (offset@(Position i j), a) <- cells,
          let at =
                canonicalPosition
                  (bookSurface shelf)
                  (arrayShape array)
                  (toInteger (r + i))
                  (toInteger (c + j)),
          fmap (cellAt array) at /= Just a
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
