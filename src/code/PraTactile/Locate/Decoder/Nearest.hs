{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Locates patches with wrong and missing cells: it finds the position that differs from the
-- observed cells in the fewest of them. The patch is compared with every position, so this is
-- exact.
--
-- Let d be the minimum distance of the observed cells. Then e wrong cells never mislead if 2 e < d.
-- Let the observed cells be a window of distance d' without s of its cells. Then d is at least d' -
-- s. So e wrong cells never mislead if 2 e + s < d'. Often more do not, because d is seldom as
-- small as d' - s (R. C. Singleton 1964; F. J. MacWilliams and N. J. A. Sloane 1977, chapter 1).
module PraTactile.Locate.Decoder.Nearest
  ( nearest,
  )
where

import Data.Proxy (Proxy (..))
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Grid (displaced)
import PraTactile.Locate.Answer
import PraTactile.Locate.Decision
import PraTactile.Locate.Decoder.Codebook
import PraTactile.Locate.Definition (agreeing, nowhere)
import PraTactile.Locate.Patch
import PraTactile.Locate.Query (Radius, radiusFor)

-- | Finds the nearest position of an upright patch's upper left cell within the radius, and the
-- cells that are wrong there. The guaranteed radius is the largest e with 2 e < d, or 0 if d is 0;
-- 'radiusFor' chooses it or the stated one. If there is no position, the reason is that of the
-- exact search for radius 0, 'ZeroWindow' if the patch is within the radius of all zeros, and else
-- 'BeyondRadius'. Several equally near positions are 'Ambiguous'; that needs a radius beyond the
-- guaranteed one, or cells that have the same content at several positions. Without observed cells
-- the reason is 'TooFewCells'. O(m N) for m observed cells and N positions.
nearest :: forall k. KnownField k => Codebook k -> Radius -> Patch (GF k) -> Decision Position
nearest codebook stated observed
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
    d = observedDistance codebook (map fst cells)
    radius = radiusFor stated d
    comparison = compareWith codebook [(offset, otherThan a) | (offset, a) <- cells]
    otherThan a =
      Primitive.generate
        (fieldOrder (Proxy :: Proxy k))
        (\code -> if code == toCode a then 0 else 1)
    distances = comparedTotals comparison
    size = Primitive.length distances
    (least, next) = leastTwo distances
    (outcome, wrong)
      | size > 0 && fromIntegral least <= radius =
        nearestOutcome
          codebook
          observed
          [ comparedPosition comparison i
            | (i, e) <- zip [0 ..] (Primitive.toList distances),
              e == least
          ]
      | otherwise = (Refused (noneWithin codebook radius observed), [])

-- | The outcome for the nearest positions, and the wrong cells if there is only one position.
nearestOutcome ::
  KnownField k =>
  Codebook k ->
  Patch (GF k) ->
  [Position] ->
  (Outcome Position, [Position])
nearestOutcome codebook observed places = case places of
  [place] -> let wrong = wrongCells codebook observed place in (Unique place (support wrong), wrong)
  _ -> (Ambiguous places (support []), [])
  where
    support wrong = windowsWithout wrong (codebookMask codebook) observed

-- | The cells in which a patch at this position differs from the array.
wrongCells :: KnownField k => Codebook k -> Patch (GF k) -> Position -> [Position]
wrongCells codebook observed place =
  [offset | (offset, a) <- observedCells observed, (cellAt array <$> at offset) /= Just a]
  where
    array = codebookArray codebook
    at = displaced (codebookSurface codebook) (arrayShape array) place

-- | Why no position is within the radius: for radius 0 the reason of the exact search; 'ZeroWindow'
-- if the patch is within the radius of all zeros, which occur nowhere; else 'BeyondRadius'.
noneWithin :: KnownField k => Codebook k -> Natural -> Patch (GF k) -> Reason
noneWithin codebook radius observed
  | radius == 0 = nowhere on (codebookMask codebook) (agreeing on) observed
  | fromIntegral (length (filter (/= zero) (map snd (observedCells observed)))) <= radius =
    ZeroWindow
  | otherwise = BeyondRadius
  where
    on = codebookOn codebook

-- | The smallest number and the second smallest, which are equal if the smallest occurs twice;
-- 'maxBound' for each that does not exist.
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
