{-# OPTIONS_HADDOCK hide #-}

-- | What composites show in which no symbol was recognised: nothing at all, light and dark
-- exchanged, or symbols of another size. Each is found by reading the composites so.
module PraTactile.Recognise.Instead
  ( Instead (..),
    seenInstead,
  )
where

import qualified Data.Vector.Storable as V
import PraTactile.Image (rasterHeight, rasterSize, rasterValues, rasterWidth, zipRaster)
import PraTactile.Registration (Composite (..), compositeOf)
import PraTactile.Sensor.Manifest (Taking (..))
import PraTactile.Sensor.Resample (resampled)

-- | What composites show.
data Instead
  = -- | one and the same reading everywhere
    InsteadFlat
  | -- | symbols, if no contact is full scale and full contact 0
    InsteadInverted
  | -- | symbols so many times as large as the alphabet's: the factor, and the distance of the
    -- sensor's taxels, millimetres, with which they would be as large
    InsteadScaled !Double !Double
  | -- | nothing that is known, in so many taxels across and down
    InsteadUnknown !Int !Int
  deriving stock (Eq, Show)

-- | What composites show instead of symbols as they are expected, given how to tell whether symbols
-- are recognised in composites. Scales from a third to three are tried.
seenInstead :: Monad m => ([Composite] -> m Bool) -> [Composite] -> m Instead
seenInstead readable composites
  | all flat composites = pure InsteadFlat
  | otherwise = firstOf ((InsteadInverted, map inverted composites) : scaled)
  where
    flat composite = case V.toList (rasterValues (compositeImage composite)) of
      v : others -> all (== v) others
      [] -> True
    firstOf hypotheses = case hypotheses of
      (seen, shown) : rest -> do
        found <- readable shown
        if found then pure seen else firstOf rest
      [] -> pure (InsteadUnknown (largest rasterWidth) (largest rasterHeight))
    largest side = maximum (0 : map (side . compositeImage) composites)
    scaled =
      [ (InsteadScaled factor (taxel / factor), map (atScale factor) composites)
        | factor <- [2, 1 / 2, 3 / 2, 2 / 3, 3, 1 / 3],
          all (small factor) composites
      ]
    taxel = maximum (map (takenTaxel . compositeTaking) composites)
    small factor composite =
      let (w, h) = rasterSize (compositeImage composite)
       in fromIntegral (w * h) / (factor * factor) < mostPixels

-- | A composite of the contact that is left where it was touched: none counts as full.
inverted :: Composite -> Composite
inverted composite =
  composite
    { compositeImage = either (const image) id (zipRaster other image coverage),
      compositeLattice = Nothing
    }
  where
    image = compositeImage composite
    coverage = compositeCoverage composite
    other v covered = if covered > 0 then 1 - v else 0

-- | The image of a composite whose symbols are so many times too large, at their own size.
atScale :: Double -> Composite -> Composite
atScale factor composite = compositeOf (resampled (1 / factor) (compositeImage composite))

-- | The most pixels of an image in which symbols of another size are looked for.
mostPixels :: Double
mostPixels = 262144
