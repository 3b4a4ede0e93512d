{-# OPTIONS_HADDOCK hide #-}

-- | What composites show in which no symbol was recognised: nothing, inverted intensities, or
-- symbols of another size. Each hypothesis is tried by reading the composites accordingly.
module PraTactile.Recognise.Diagnosis
  ( Diagnosis (..),
    diagnose,
  )
where

import qualified Data.Vector.Storable as V
import PraTactile.Image (rasterHeight, rasterSize, rasterValues, rasterWidth, zipRaster)
import PraTactile.Registration (Composite (..), compositeOf)
import PraTactile.Sensor.Manifest (FrameConventions (..))
import PraTactile.Sensor.Resample (resampled)

-- | What composites show instead of symbols.
data Diagnosis
  = -- | every pixel has one reading
    InsteadFlat
  | -- | symbols, if the intensities are inverted: no contact is full scale and full contact 0
    InsteadInverted
  | -- | symbols larger than the alphabet's by the factor; and the sensor's pitch in millimetres at
    -- which they would have the right size
    InsteadScaled !Double !Double
  | -- | nothing recognisable, in an image of at most this width and height in taxels
    InsteadUnknown !Int !Int
  deriving stock (Eq, Show)

-- | Finds what composites show instead of symbols. The first argument says whether symbols are
-- recognised in composites. Scale factors from 1/3 to 3 are tried.
diagnose :: Monad m => ([Composite] -> m Bool) -> [Composite] -> m Diagnosis
diagnose readable composites
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
    taxel = maximum (map (conventionsTaxel . compositeConventions) composites)
    small factor composite =
      let (w, h) = rasterSize (compositeImage composite)
       in fromIntegral (w * h) / (factor * factor) < mostPixels

-- | A composite with its intensities inverted where it was touched.
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

-- | A composite whose symbols are too large by this factor, resampled to their proper size.
atScale :: Double -> Composite -> Composite
atScale factor composite = compositeOf (resampled (1 / factor) (compositeImage composite))

-- | The largest image, in pixels, that is searched for symbols of another size.
mostPixels :: Double
mostPixels = 262144
