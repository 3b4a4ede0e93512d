{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The displacements that a frame may have on a lattice, with the log-likelihoods of the cells
-- that it then sees.
module PraTactile.Registration.Joint.Displacement
  ( Displacement (..),
    displacementOf,
    displacementCells,
    ClassLogs,
    displacementsOf,
    displacementScores,
    displacementAt,
    phaseCounts,
    cellsOfPhases,
    cellRowColumn,
    cellNumber,
  )
where

import Data.List (transpose)
import qualified Data.Vector.Storable as V
import qualified Data.Vector.Unboxed as Unboxed
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Composite.Lattice (ClassLogs)
import PraTactile.Registration.Field
import PraTactile.Registration.Lattice.Likelihood (Likelihood (..))
import PraTactile.Registration.Lattice.Places
import PraTactile.Registration.Lattice.Symbols (symbolsClasses)
import PraTactile.Registration.Lattice.Template (LatticeTemplates (..))
import PraTactile.Registration.Loops (dotWithin, tabulate)
import PraTactile.Registration.Numbers (unlikely)

-- | A displacement d of a frame, in steps from its grid point, with |d|^2 in square steps. It holds
-- the numbers of the cells that the frame then sees, and l_k of each, one cell after the other.
-- Thousands of frames have millions of displacements, so each is kept in a few words.
data Displacement = Displacement
  { displacementShift :: !(Int, Int),
    displacementSquare :: !Double,
    displacementNumbers :: !(Unboxed.Vector Int),
    displacementLogs :: !ClassLogs
  }

-- | A displacement from its shift, |d|^2, and l_k of each cell by its number. All cells have
-- equally many classes.
displacementOf :: (Int, Int) -> Double -> [(Int, ClassLogs)] -> Displacement
displacementOf shift square cells =
  Displacement shift square (Unboxed.fromList (map fst cells)) (Unboxed.concat (map snd cells))

-- | l_k of each cell that the frame sees, by the cell's number.
displacementCells :: Displacement -> [(Int, ClassLogs)]
displacementCells (Displacement _ _ numbers logs) =
  [ (number, Unboxed.slice (k * classes) classes logs)
    | (k, number) <- zip [0 ..] (Unboxed.toList numbers)
  ]
  where
    classes = Unboxed.length logs `quot` max 1 (Unboxed.length numbers)

-- | The likely displacements of a frame: those within 'unlikely' of the best, as natural
-- logarithms, by the frame alone. There are none if none of their phases was evaluated. Given are
-- the grid, the lattice's orientation and phase, and the place (taxels) of the frame's first one
-- with its likelihood.
displacementsOf :: Grid -> Int -> (Int, Int) -> (Taxels, Likelihood) -> [Displacement]
displacementsOf grid orientation phase told =
  map (displacementAt grid orientation phase told) $
    V.toList (V.findIndices (>= max least (V.maximum scores - unlikely)) scores)
  where
    scores = displacementScores grid orientation phase told

-- | A lower score means that the displacement's phase was not evaluated.
least :: Double
least = -1e300

-- | The log score of each grid displacement by the frame alone, row by row, up to a constant. The
-- prior pi is the mean over one sigma per octave.
displacementScores :: Grid -> Int -> (Int, Int) -> (Taxels, Likelihood) -> V.Vector Double
displacementScores grid orientation (phaseY, phaseX) (place, given) =
  tabulate side side $ \j ->
    let !row = (orientation * down + V.unsafeIndex phasesDown j) * across
     in \i ->
          let !l = V.unsafeIndex phases (row + V.unsafeIndex phasesAcross i)
           in if l < least then l else l + log (prior i j)
  where
    !(!across, !down) = phaseCounts given
    !((!nx, !ny), (!rx, !ry)) = onGrid grid place
    !reach = gridReach grid
    !side = 2 * reach + 1
    !phases = phaseLogs given
    !phasesAcross = phasesAlong (phaseX - nx) across
    !phasesDown = phasesAlong (phaseY - ny) down
    phasesAlong :: Int -> Int -> V.Vector Int
    phasesAlong phase period = V.generate side (\i -> (phase - i + reach) `mod` period)
    prior i j = dotWithin octaves (priorsAcross, i * octaves) (priorsDown, j * octaves)
    !octaves = length (gridOctaves grid)
    !priorsAcross = priors rx
    !priorsDown = priors ry
    priors beyond = V.fromList (concat (transpose (map told (gridOctaves grid))))
      where
        told sigma = V.toList (priorsAlong grid sigma beyond)

-- | The displacement at an index of the grid, row by row.
displacementAt :: Grid -> Int -> (Int, Int) -> (Taxels, Likelihood) -> Int -> Displacement
displacementAt grid orientation (phaseY, phaseX) (place, given) k =
  displacementOf (dx, dy) (squared dx rx + squared dy ry) $
    [ (cellNumber ((y + ny + dy - phaseY) `div` down) ((x + nx + dx - phaseX) `div` across), l)
      | ((y, x), l) <- cellsOf given orientation (phaseY - ny - dy, phaseX - nx - dx)
    ]
  where
    (across, down) = phaseCounts given
    ((nx, ny), (rx, ry)) = onGrid grid place
    (dx, dy) = let (j, i) = k `quotRem` (2 * reach + 1) in (i - reach, j - reach)
    reach = gridReach grid
    squared d beyond = let t = fromIntegral d - beyond in t * t :: Double

-- | The number of phases across and down.
phaseCounts :: Likelihood -> (Int, Int)
phaseCounts = phaseCount . placesFineness . templatePlaces . likelihoodTables

-- | The cells that a frame sees at an orientation and a phase, modulo the pitch: the row and column
-- of each among the frame's places, and l_k of its classes.
cellsOf :: Likelihood -> Int -> (Int, Int) -> [((Int, Int), ClassLogs)]
cellsOf given orientation (phaseY, phaseX) =
  [ ((y, x), classesFrom (count * cellAt given (cellIndex places orientation y x)))
    | y <- every (phaseY `mod` down) down rows,
      x <- every (phaseX `mod` across) across columns
  ]
  where
    places = templatePlaces (likelihoodTables given)
    (across, down) = phaseCounts given
    (columns, rows) = placesGrid places
    count = symbolsClasses (templateSymbols (likelihoodTables given))
    every first period end = [first, first + period .. end - 1]
    classesFrom start = Unboxed.generate count (\k -> classLogs given V.! (start + k))

-- | l_k of the cells that a frame sees at each likely phase: first the upright phases, then the
-- half turned ones. Phases more than 'unlikely' below the best are left out.
cellsOfPhases :: Likelihood -> ([[ClassLogs]], [[ClassLogs]])
cellsOfPhases given = (turnedBy 0, turnedBy 1)
  where
    turnedBy o = [map snd (cellsOf given o (y, x)) | (o', (y, x)) <- likely, o' == o]
    phases = phaseLogs given
    (across, down) = phaseCounts given
    likely =
      [ (o, (y, x))
        | i <- V.toList (V.findIndices (>= V.maximum phases - unlikely) phases),
          let (row, x) = i `quotRem` across
              (o, y) = row `quotRem` down
      ]

-- | A cell's row and column as one number. A composite has fewer than 2^20 columns of cells.
cellNumber :: Int -> Int -> Int
cellNumber row column = row * 1048576 + column

-- | The row and column of a cell, from its number.
cellRowColumn :: Int -> (Int, Int)
cellRowColumn number = (row, number - row * 1048576)
  where
    row = (number + 524288) `div` 1048576
