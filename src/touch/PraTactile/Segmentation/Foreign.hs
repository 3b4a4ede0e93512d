{-# OPTIONS_HADDOCK hide #-}

-- | What in a composite is none of the symbols' making: bars, rims, plateaus, holes, and what lies
-- beyond the object's edge. It would spoil the levels of background and embossing, and the estimate
-- of the angle, for the whole composite.
--
-- How high the symbols stand is taken from the symbols alone: what is of a symbol's size where it
-- is cut off at half its own height above its own surroundings. By these levels, what is longer
-- than any symbol is foreign, and so is what is sunk; it is taken out of the composite, as if it
-- had not been touched. The symbols beside it stay.
module PraTactile.Segmentation.Foreign
  ( Cleaned (..),
    cleaned,

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

-- | A composite without what is foreign.
data Cleaned = Cleaned
  { -- | what symbols are cut out of
    cleanedComposite :: !Composite,
    -- | what parts of symbols are read from, if that is another: with what is foreign but of the
    -- symbols' height left in, for what of a symbol lies beside it still shows which it is
    cleanedForParts :: !(Maybe Composite),
    cleanedRejects :: ![Reject]
  }
  deriving stock (Eq, Show)

-- | The composite with what is none of the symbols' making taken for untouched, and what that is:
-- what is longer than any symbol, and what is sunk beside it. Most composites are as they were:
-- where all that is embossed is like symbols, or nothing is, and nothing is sunk.
cleaned :: Composite -> Cleaned
cleaned composite = case levels least (touchedValues pixels) of
  Just found
    | any (unlikeSymbols pixels) (parts (>= share 0.5 found))
        || any ((>= leastHollow) . length) (parts (<= share (-0.35) found)),
      Just (own, symbols) <- symbolLevels pixels least ->
      removed composite pixels (foreignIn pixels own symbols)
  _ -> Cleaned composite Nothing []
  where
    touched = masked composite
    pixels = smoothed touched
    least = leastContrast (compositeStep composite) (smoothing * pixelNoise touched)
    parts test = components pixels 0 (touchedWhere test pixels)

-- | A share of the way from the background's level to the embossing's.
share :: Double -> Levels -> Double
share part found = levelBackground found + part * contrast found

-- | A composite without some regions.
removed :: Composite -> Masked -> [ForeignRegion] -> Cleaned
removed composite pixels regions
  | null regions = Cleaned composite Nothing []
  | otherwise =
    Cleaned
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

-- | A foreign region.
data ForeignRegion = ForeignRegion
  { foreignPixels :: !Region,
    foreignCause :: !Cause,
    -- | whether no symbol is so high, or so low
    foreignHeight :: !Bool
  }

-- | The foreign regions, given the symbols' levels and pixels: each with a rim, but for what is a
-- symbol's and its rim. What stands clearly higher than symbols goes first, for a symbol close to
-- it is not parted from it at a lower level.
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

-- | Fewer sunken pixels are noise.
leastHollow :: Int
leastHollow = 12
