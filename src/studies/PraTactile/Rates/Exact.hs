-- | The exact rates of hard decoding, computed from the array.
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

-- | The rates of decoding the cells of this mask, to the guaranteed radius of the observed ones or
-- to a stated radius. Apply it to a locator and a mask once, and then to many kinds of damage: the
-- slow part, seconds for 25 cells, is done once.
--
-- 'Nothing' if it would take too long: for codes of more than 'largestSearch' words or 'mostCells'
-- cells, and with erasures beyond what 'punctured' accepts. Also 'Nothing' for a stated radius that
-- exceeds the guaranteed one, or with missing cells.
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
    -- If there are too many words, they are not even computed.
    holed = do
      guard (n <= mostErasedCells && 2 ^ n * area (arrayShape array) <= mostErasedWork)
      punctured n (map support contents)
    support content = foldl' (.|.) 0 [bit i | (i, a) <- zip [0 ..] content, a /= zero]
    contents =
      [ content
        | position <- shapeCells (arrayShape array),
          Just content <- [windowAt on mask position]
      ]
