-- | Frames held against the lattice of cells at one angle.
module PraTactile.Registration.Lattice.Fits
  ( Fits (..),
    fitsAt,
    bySize,
  )
where

import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import PraTactile.Image (Raster, rasterSize)
import PraTactile.Registration.Lattice.Likelihood (Fit, fitOf)
import PraTactile.Registration.Lattice.Template (PaperTables, Templates)

-- | What frames tell of the lattice at an angle. Each table and what each frame tells is made when
-- it is first looked at, and once.
data Fits = Fits
  { -- | Degrees clockwise from the frames' axes.
    fitsAngle :: !Double,
    -- | The tables by the width and height of frames.
    fitsTables :: (Int, Int) -> Templates,
    -- | In the order of the frames.
    fitsFrames :: [Fit]
  }

-- | Frames of any sizes at an angle, degrees clockwise.
fitsAt :: PaperTables -> [Raster] -> Double -> Fits
fitsAt tables images angle = Fits angle at [fitOf (at (rasterSize image)) image | image <- images]
  where
    at = bySize (map rasterSize images) (tables angle)

-- | Tables by size, each of these sizes' made once.
bySize :: [(Int, Int)] -> ((Int, Int) -> tables) -> (Int, Int) -> tables
bySize sizes make = \size -> Map.findWithDefault (make size) size made
  where
    made = Map.fromSet make (Set.fromList sizes)
