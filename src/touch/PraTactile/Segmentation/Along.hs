{-# OPTIONS_HADDOCK hide #-}

-- | Segmentation of symbols that lie on their side or upside down.
module PraTactile.Segmentation.Along
  ( onComposite,
    segmentAlong,
  )
where

import PraTactile.Composite (Composite (..))
import PraTactile.Image (onRaster, rasterHeight, rasterWidth)
import PraTactile.Segmentation.Symbol
import PraTactile.Segmentation.Upright (segment)
import PraTactile.Symmetry

-- | The composite rotated or mirrored. Its origin is unchanged, its lattice is dropped.
onComposite :: Symmetry -> Composite -> Composite
onComposite symmetry composite =
  composite
    { compositeImage = onRaster symmetry (compositeImage composite),
      compositeCoverage = onRaster symmetry (compositeCoverage composite),
      compositeLattice = Nothing
    }

-- | Segments a composite along an axis: it finds symbols rotated by the axis, or by 180 degrees
-- more. Returns the composite rotated so that the axis is upright; the segmentation in that
-- composite's pixels; and the segmentation with centres and boxes in the given composite's pixels.
-- Symbol images and sizes are as seen along the axis.
segmentAlong :: Symmetry -> Composite -> (Composite, Segmentation, Segmentation)
segmentAlong axis composite = (upright, found, back)
  where
    upright = onComposite (invert axis) composite
    found = segment upright
    back =
      found
        { segmentedSymbols = map symbolBack (segmentedSymbols found),
          segmentedRejects = map boxBack (segmentedRejects found)
        }
    pixelBack = onPixel axis (size rasterWidth, size rasterHeight)
    size side = fromIntegral (side (compositeImage upright))
    symbolBack s =
      s {symbolCentre = pixelBack (symbolCentre s), symbolAxis = degreesClockwise axis}
    boxBack (Reject (l, t, r, b) why) =
      let (x, y) = pixelBack (l, t)
          (x', y') = pixelBack (r, b)
       in Reject (min x x', min y y', max x x', max y y') why
