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

-- | A lattice of cells with the evidence of the frames in each cell.
data Lattice = Lattice
  { -- | The angle of the lattice's axes, in degrees clockwise from the composite's, in [-90, 90).
    latticeAngle :: !Double,
    -- | Whether the symbols are upside down along these axes.
    latticeHalfTurned :: !Bool,
    -- | The centre of the upper left taxel of the symbol in cell (0, 0), in taxels right and down
    -- from the origin of the robot's coordinates.
    latticeOrigin :: !Taxels,
    -- | The centre of each frame, in taxels right and down from the same origin.
    latticeFrames :: ![Taxels],
    -- | The grey value of flat ground in the composite, and the contrast of the relief above it.
    latticeFlat :: !Double,
    latticeContrast :: !Double,
    -- | By row and column along the lattice's axes: g_c summed over all frames
    -- ("PraTactile.Registration.Model").
    latticeCells :: !(Map (Int, Int) ClassLogs)
  }
  deriving stock (Eq, Show)

-- | For each class its log-likelihood ratio to an empty cell.
type ClassLogs = Unboxed.Vector Double

-- | A lattice and its frames moved by a displacement.
movedLattice :: Taxels -> Lattice -> Lattice
movedLattice by lattice =
  lattice
    { latticeOrigin = latticeOrigin lattice `plus` by,
      latticeFrames = map (plus by) (latticeFrames lattice)
    }

-- | The displacement of the given number of rows and columns of cells, in taxels right and down.
latticeStep :: Lattice -> (Int, Int) -> Taxels
latticeStep lattice (i, j) =
  rotated (latticeAngle lattice) (columnPitch * fromIntegral j, rowPitch * fromIntegral i)

-- | The steps (rows, columns) to the four neighbours of a cell.
cellSteps :: [(Int, Int)]
cellSteps = [(0, 1), (0, -1), (1, 0), (-1, 0)]
