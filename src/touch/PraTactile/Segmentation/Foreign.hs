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
    withoutForeign,

    -- * Foreign regions
    Strange (..),
    foreignIn,
  )
where

import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as V
import PraTactile.Composite (Composite (..))
import PraTactile.Composite.Level
import PraTactile.Image
import PraTactile.Segmentation.Foreign.Extent
import PraTactile.Segmentation.Foreign.Height (symbolLevels)
import PraTactile.Segmentation.Region
import PraTactile.Segmentation.Reject

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

-- | The composite with what is foreign taken for untouched, given the least weight with which a
-- pixel counts as touched, and what that is. Where all that is embossed is like symbols, or nothing
-- is, and nothing is sunk, the composite stays as it is.
withoutForeign :: Double -> Composite -> Cleaned
withoutForeign least composite = case levels noise (touchedValues field) of
  Just found
    | any (unlikeSymbols field) (regions field 0 (marked field (>= share 0.5 found)))
        || not (null (hollows (marked field (<= share (-0.35) found)))),
      Just (own, symbols) <- symbolLevels field noise ->
      removed composite field (foreignIn field own symbols)
  _ -> Cleaned composite Nothing []
  where
    field = fieldOf least composite
    noise = smoothing * pixelNoise field (compositeImage composite)
    hollows = filter ((>= leastHollow) . length) . regions field 0

-- | A share of the way from the background's level to the embossing's.
share :: Double -> Levels -> Double
share part found = levelBackground found + part * contrast found

-- | A composite without some regions.
removed :: Composite -> Field -> [Strange] -> Cleaned
removed composite field strange
  | null strange = Cleaned composite Nothing []
  | otherwise =
    Cleaned
      (without strange)
      (Just (without (filter strangeHeight strange)))
      [Reject (regionBox field region) cause | Strange region cause _ <- strange]
  where
    without some =
      composite
        { compositeImage = blank (compositeImage composite),
          compositeCoverage = blank (compositeCoverage composite)
        }
      where
        gone = around field 0 (concatMap strangePixels some)
        blank image =
          generate (fieldWidth field) (fieldHeight field) $ \x y ->
            if gone V.! (y * fieldWidth field + x) then 0 else fromMaybe 0 (index image x y)

-- | A foreign region.
data Strange = Strange
  { strangePixels :: !Region,
    strangeCause :: !Cause,
    -- | whether no symbol is so high, or so low
    strangeHeight :: !Bool
  }

-- | The foreign regions, given the symbols' levels and pixels: each with a rim, but for what is a
-- symbol's and its rim. What stands clearly higher than symbols goes first, for a symbol close to
-- it is not parted from it at a lower level.
foreignIn :: Field -> Levels -> [Region] -> [Strange]
foreignIn field own symbols =
  [Strange region TooLarge True | region <- high]
    ++ [Strange (widened 1 region) TooLarge False | region <- raised]
    ++ [Strange (widened 2 region) Hollow True | region <- sunken, length region >= leastHollow]
  where
    kept = around field 1 (concat symbols)
    free = V.zipWith (\keep m -> m && not keep) kept
    high = map (widened 2) (filter (tooLong field) (found (free (marked field (>= share 1.5 own)))))
    rest = V.zipWith (\gone m -> m && not gone) (around field 0 (concat high))
    raised = concatMap (straight field) (filter (tooLong field) (found level))
    level = rest (free (marked field (>= share 0.35 own)))
    sunken = found (free (marked field (<= share (-0.35) own)))
    found = regions field 0
    widened by region = [p | p <- grown field by region, not (kept V.! p)]

-- | Fewer sunken pixels are noise.
leastHollow :: Int
leastHollow = 12
