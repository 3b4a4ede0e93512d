-- | The composite tactile image (the paper's figure 10): what the stitcher makes and segmentation
-- takes.
module PraTactile.Stitch.Composite
  ( Composite (..),
    compositeOf,
    compositePosition,
    compositePixel,
    weighted,
  )
where

import PraTactile.Image (Raster, constant, rasterHeight, rasterWidth, zipRaster)
import PraTactile.Image.Correlate (Reference, reference, referenceOf)
import PraTactile.Probe (taxelPitch)

-- | An image larger than the sensor, on a grid of one taxel's pitch whose axes are the robot's.
data Composite = Composite
  { -- | The mean of what the frames saw at each pixel; 0 where none touched.
    compositeImage :: !Raster,
    -- | How much sensor weight each pixel got: about the number of frames that saw it, 0 for never
    -- touched. The same size as the image.
    compositeCoverage :: !Raster,
    -- | The centre of pixel (0, 0), x and y in millimetres, in the robot's coordinates.
    compositeOrigin :: !(Double, Double),
    -- | How far each frame was moved from its nominal place, x and y in taxels, in the order of the
    -- frames.
    compositeDisplacements :: ![(Double, Double)]
  }
  deriving stock (Eq, Show)

-- | A single image, such as one read from a file, as a composite that was touched once everywhere,
-- with its pixel (0, 0) at the origin.
compositeOf :: Raster -> Composite
compositeOf image = Composite image (constant (rasterWidth image) (rasterHeight image) 1) (0, 0) []

-- | A place on the composite, x and y in pixels, as millimetres in the robot's coordinates.
compositePosition :: Composite -> (Double, Double) -> (Double, Double)
compositePosition composite (x, y) = (ox + taxelPitch * x, oy + taxelPitch * y)
  where
    (ox, oy) = compositeOrigin composite

-- | Where a place in the robot's coordinates, x and y in millimetres, is on the composite, in
-- pixels.
compositePixel :: Composite -> (Double, Double) -> (Double, Double)
compositePixel composite (x, y) = ((x - ox) / taxelPitch, (y - oy) / taxelPitch)
  where
    (ox, oy) = compositeOrigin composite

-- | The composite as a weighted image, to be interpolated.
weighted :: Composite -> Reference
weighted (Composite image coverage _ _) =
  either
    (const (referenceOf image))
    id
    (zipRaster (*) image coverage >>= \sums -> reference sums coverage)
