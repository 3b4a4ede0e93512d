{-# OPTIONS_HADDOCK hide #-}

-- | Finds and masks regions that cannot be symbols: bars, rims, plateaus, holes, and what lies
-- beyond the object's edge. They would spoil the levels of background and embossing, and the
-- estimate of the angle, for the whole composite.
--
-- The height of the symbols is measured on candidates only: regions of a symbol's size when cut off
-- at half their own height above their surroundings. By these levels, regions longer than any
-- symbol and sunken regions are foreign. They are removed from the composite as if untouched. The
-- symbols beside them stay.
module PraTactile.Segmentation.Foreign
  ( ForeignMasked (..),
    maskForeign,

    -- * Foreign regions
    ForeignRegion (..),
    foreignIn,
  )
where

import Data.Maybe (fromMaybe)
import PraTactile.Composite (Composite (..))
import PraTactile.Composite.Level
import PraTactile.Image
import PraTactile.Segmentation.Foreign.Extent
import PraTactile.Segmentation.Foreign.Height (symbolLevels)
import PraTactile.Segmentation.Masked
import PraTactile.Segmentation.Region
import PraTactile.Segmentation.Symbol

-- | A composite with its foreign regions masked.
data ForeignMasked = ForeignMasked
  { -- | the composite for cutting out symbols
    maskedComposite :: !Composite,
    -- | 'Nothing' if no region was masked; otherwise the composite for reading parts of symbols. In
    -- it foreign regions of the symbols' height stay, because the part of a symbol beside one still
    -- shows its class.
    maskedByHeight :: !(Maybe Composite),
    maskedRejects :: ![Reject]
  }
  deriving stock (Eq, Show)

-- | Masks the regions of a composite that are longer than any symbol or sunken, and lists them.
-- The composite stays unchanged if nothing is embossed; if everything embossed looks like symbols
-- and nothing is sunken; or if no region has a symbol's size, so that the symbols' height is
-- unknown.
maskForeign :: Composite -> ForeignMasked
maskForeign composite = case levels least (touchedValues pixels) of
  Just found
    | any (unlikeSymbols pixels) (parts (>= share 0.5 found))
        || any ((>= leastHollow) . length) (parts (<= share (-0.35) found)),
      Just (own, symbols) <- symbolLevels pixels least ->
      removed composite pixels (foreignIn pixels own symbols)
  _ -> ForeignMasked composite Nothing []
  where
    touched = masked composite
    pixels = smoothed touched
    least = leastContrast (compositeStep composite) (smoothing * pixelNoise touched)
    parts test = components pixels 0 (touchedWhere test pixels)

-- | The intensity at a given share of the contrast above the background.
share :: Double -> Levels -> Double
share part found = levelBackground found + part * contrast found

-- | The composite without the given regions.
removed :: Composite -> Masked -> [ForeignRegion] -> ForeignMasked
removed composite pixels regions
  | null regions = ForeignMasked composite Nothing []
  | otherwise =
    ForeignMasked
      (without regions)
      (Just (without (filter foreignHeight regions)))
      [Reject (regionBox pixels region) cause | ForeignRegion region cause _ <- regions]
  where
    without some =
      composite
        { compositeImage = blank (compositeImage composite),
          compositeCoverage = blank (compositeCoverage composite)
        }
      where
        gone = among (concatMap foreignPixels some)
        blank image =
          generate (maskedWidth pixels) (maskedHeight pixels) $ \x y ->
            if gone (y * maskedWidth pixels + x)
              then 0
              else fromMaybe 0 (index image x y)

-- | A region that is not part of a symbol.
data ForeignRegion = ForeignRegion
  { foreignPixels :: !Region,
    foreignCause :: !Cause,
    -- | whether it is clearly higher than symbols, or sunken
    foreignHeight :: !Bool
  }

-- | The foreign regions, given the symbols' levels and regions. Each is widened by a margin that
-- stays clear of symbols and of their margins. Of long regions of the symbols' height only the
-- parts on straight lines are foreign, so that a symbol that touches a bar stays. Regions clearly
-- higher than symbols are found first, because at a lower threshold a nearby symbol would merge
-- with them.
foreignIn :: Masked -> Levels -> [Region] -> [ForeignRegion]
foreignIn pixels own symbols =
  [ForeignRegion region TooLarge True | region <- high]
    ++ [ForeignRegion (widened 1 region) TooLarge False | region <- raised]
    ++ [ForeignRegion (widened 2 region) Hollow True | region <- holes]
  where
    kept = among (around pixels 1 (concat symbols))
    high = map (widened 2) (filter (tooLong pixels) (found (free (>= share 1.5 own))))
    gone = among (concat high)
    level = filter (not . gone) (free (>= share 0.35 own))
    raised = concatMap (straight pixels) (filter (tooLong pixels) (found level))
    holes = filter ((>= leastHollow) . length) (found (free (<= share (-0.35) own)))
    free test = filter (not . kept) (touchedWhere test pixels)
    found = components pixels 0
    widened by = filter (not . kept) . around pixels by

-- | The least number of sunken pixels of a hole; fewer are noise.
leastHollow :: Int
leastHollow = 12
