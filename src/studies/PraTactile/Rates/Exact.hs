-- | The rates of hard decoding without chance, from the array itself.
module PraTactile.Rates.Exact
  ( exactRates,
  )
where

import Control.Monad (guard)
import Data.Bits (bit, (.|.))
import Data.List (foldl')
import PraTactile.Array
import PraTactile.Field
import PraTactile.LinearCode.Punctured
import PraTactile.Locate
  ( Locator,
    Radius (..),
    atLeast,
    cellsDistance,
    guaranteedRadius,
    locatorArray,
  )
import PraTactile.Rates.Damage
import PraTactile.Rates.Formulas
import PraTactile.Window
import PraTactile.Window.Distance

-- | The rates of decoding the cells of this mask, to the radius of those observed, or to a stated
-- one. Applied to a locator and a mask, it can be kept for many kinds of damage: what takes time,
-- seconds for 25 cells, is done once. 'Nothing' where it would take too long: for codes beyond
-- 'largestSearch' words or 'mostCells' cells, and with erasures beyond what 'punctured' takes; and
-- where a stated radius is more than is guaranteed, or some cells are missing.
exactRates :: KnownField k => Radius -> Locator k -> Mask -> Damage -> Maybe Rates
exactRates stated theLocator mask = \damage -> do
  guard (fromIntegral n <= mostCells)
  guard $ case stated of
    Guaranteed -> True
    UpTo e ->
      damageErasures damage <= 0 && windowDistance > 0 && e <= guaranteedRadius windowDistance
  if damageErasures damage > 0 || windowDistance == 0
    then (\code -> erasedRates ByObserved q code damage) <$> holed
    else decodingRates (BoundedDistance q n radius (damageErrors damage)) <$> whole
  where
    on@(ArrayOn _ array) = locatorArray theLocator
    q = fieldOrder array
    n = maskSize mask
    windowDistance = atLeast (cellsDistance theLocator (maskOffsets mask))
    radius = case stated of
      Guaranteed -> fromIntegral (guaranteedRadius windowDistance)
      UpTo e -> fromIntegral e
    whole = either (const Nothing) Just (weightEnumerator array mask)
    -- The words are not even made where there are too many.
    holed = do
      guard (n <= mostErasedCells && 2 ^ n * area (arrayShape array) <= mostErasedWork)
      punctured n (map support contents)
    support content = foldl' (.|.) 0 [bit i | (i, a) <- zip [0 ..] content, a /= zero]
    contents =
      [ content
        | position <- shapeCells (arrayShape array),
          Just content <- [windowAt on mask position]
      ]
