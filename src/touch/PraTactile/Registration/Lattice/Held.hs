-- | Frames held against the lattice of cells at one angle.
module PraTactile.Registration.Lattice.Held
  ( Held (..),
    held,
    madeFor,
  )
where

import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import PraTactile.Image (Raster, rasterSize)
import PraTactile.Registration.Lattice.Evidence (Sight, sight)
import PraTactile.Registration.Lattice.Template (PaperTables, Templates)

-- | What frames tell of the lattice at an angle. Each table and what each frame tells is made when
-- it is first looked at, and once.
data Held = Held
  { -- | Degrees clockwise from the frames' axes.
    heldAngle :: !Double,
    -- | The tables by the width and height of frames.
    heldTables :: (Int, Int) -> Templates,
    -- | In the order of the frames.
    heldFrames :: [Sight]
  }

-- | Frames of any sizes at an angle, degrees clockwise.
held :: PaperTables -> [Raster] -> Double -> Held
held tables images angle = Held angle at [sight (at (rasterSize image)) image | image <- images]
  where
    at = madeFor (map rasterSize images) (tables angle)

-- | Tables by size, each of these sizes' made once.
madeFor :: [(Int, Int)] -> ((Int, Int) -> tables) -> (Int, Int) -> tables
madeFor sizes make = \size -> Map.findWithDefault (make size) size made
  where
    made = Map.fromSet make (Set.fromList sizes)
