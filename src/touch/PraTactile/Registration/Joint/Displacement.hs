-- | The displacements that a frame may have on a lattice, and what it says of the cells that it
-- then sees.
module PraTactile.Registration.Joint.Displacement
  ( Displacement (..),
    ClassLogs,
    displacementsOf,
  )
where

import qualified Data.Vector.Storable as V
import qualified Data.Vector.Unboxed as Unboxed
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Registration.Joint.Grid
import PraTactile.Registration.Lattice.Likelihood (Likelihood (..))
import PraTactile.Registration.Lattice.Places
import PraTactile.Registration.Lattice.Symbols (symbolsClasses)
import PraTactile.Registration.Lattice.Template (Templates (..))

-- | A displacement d of a frame, in places from its grid point: log pi, and l_k of each cell that
-- the frame sees there, by the cell's number.
data Displacement = Displacement
  { displacementShift :: !(Int, Int),
    displacementPrior :: !Double,
    displacementCells :: ![(Int, ClassLogs)]
  }

-- | A number for each class of symbols. There are millions of them where there are thousands of
-- frames, and the garbage collector may move them together.
type ClassLogs = Unboxed.Vector Double

-- | The displacements of a frame that may matter: those not more than 12 below the likeliest, as
-- natural logarithms, by the frame alone. Given are the lattice's orientation and phase, the place
-- of the frame's first one, in taxels, and what the frame tells.
displacementsOf :: Grid -> Int -> (Int, Int) -> (Taxels, Likelihood) -> [Displacement]
displacementsOf grid orientation (phaseY, phaseX) (place, given) =
  [ Displacement (dx, dy) prior (cells dx dy)
    | (score, prior, dx, dy) <- scored,
      score >= best - margin
  ]
  where
    tables = likelihoodTables given
    places = templatePlaces tables
    (across, down) = phaseCount (placesFineness places)
    (columns, rows) = placesGrid places
    count = symbolsClasses (templateSymbols tables)
    ((nx, ny), (rx, ry)) = onGrid place
    reach = gridReach grid
    scored =
      [ (prior + alone dx dy, prior, dx, dy)
        | dy <- [negate reach .. reach],
          dx <- [negate reach .. reach],
          let prior = priorAlong grid rx dx + priorAlong grid ry dy
      ]
    alone dx dy =
      V.unsafeIndex
        (phaseLogs given)
        ( (orientation * down + (phaseY - ny - dy) `mod` down) * across
            + (phaseX - nx - dx) `mod` across
        )
    best = maximum [s | (s, _, _, _) <- scored]
    margin = 12
    cells dx dy =
      [ ( cellNumber ((y + ny + dy - phaseY) `div` down) ((x + nx + dx - phaseX) `div` across),
          let start = cellIndex places orientation y x * count
           in Unboxed.generate count (\k -> V.unsafeIndex (classLogs given) (start + k))
        )
        | y <- [(phaseY - ny - dy) `mod` down, (phaseY - ny - dy) `mod` down + down .. rows - 1],
          x <-
            [ (phaseX - nx - dx) `mod` across,
              (phaseX - nx - dx) `mod` across + across
              .. columns - 1
            ]
      ]

-- | One number for a cell's row and column.
cellNumber :: Int -> Int -> Int
cellNumber row column = row * 1048576 + column
