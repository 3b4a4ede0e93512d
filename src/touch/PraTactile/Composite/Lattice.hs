{-# OPTIONS_HADDOCK hide #-}

-- | The lattice of cells under the frames of a composite, as registration found it.
module PraTactile.Composite.Lattice
  ( Lattice (..),
    movedLattice,
    latticeStep,
    cellSteps,
    ClassLogs,
  )
where

import Data.Map.Strict (Map)
import qualified Data.Vector.Unboxed as Unboxed
import PraTactile.Composite.Blend (Taxels, plus)
import PraTactile.Geometry (columnPitch, rotated, rowPitch)

-- | A lattice of cells, and what the frames show in each cell.
data Lattice = Lattice
  { -- | The angle of the lattice's axes, in degrees clockwise from the composite's, in [-90, 90).
    latticeAngle :: !Double,
    -- | Whether the symbols stand upside down along these axes.
    latticeHalfTurned :: !Bool,
    -- | The centre of the upper left taxel of the symbol in cell (0, 0), in taxels right and down
    -- from where the robot counts.
    latticeOrigin :: !Taxels,
    -- | The centre of each frame, likewise.
    latticeFrames :: ![Taxels],
    -- | What flat ground reads in the composite, and how much more relief reads; grey values.
    latticeFlat :: !Double,
    latticeContrast :: !Double,
    -- | By row and column along the lattice's axes: g_c of all frames
    -- ("PraTactile.Registration.Model").
    latticeCells :: !(Map (Int, Int) ClassLogs)
  }
  deriving stock (Eq, Show)

-- | For each class its log-likelihood ratio to an empty cell.
type ClassLogs = Unboxed.Vector Double

-- | A lattice and its frames that far right and down.
movedLattice :: Taxels -> Lattice -> Lattice
movedLattice by lattice =
  lattice
    { latticeOrigin = latticeOrigin lattice `plus` by,
      latticeFrames = map (plus by) (latticeFrames lattice)
    }

-- | How far that many rows and columns of cells are, in taxels right and down.
latticeStep :: Lattice -> (Int, Int) -> Taxels
latticeStep lattice (i, j) =
  rotated (latticeAngle lattice) (columnPitch * fromIntegral j, rowPitch * fromIntegral i)

-- | The rows and columns to the four cells beside one.
cellSteps :: [(Int, Int)]
cellSteps = [(0, 1), (0, -1), (1, 0), (-1, 0)]
