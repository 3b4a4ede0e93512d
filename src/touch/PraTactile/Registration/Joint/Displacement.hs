{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The displacements that a frame may have on a lattice, and what it says of the cells that it
-- then sees.
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
import PraTactile.Registration.Lattice.Template (Templates (..))
import PraTactile.Registration.Loops (dotWithin, tabulate)
import PraTactile.Registration.Numbers (unlikely)

-- | A displacement d of a frame, in places from its grid point: |d|^2 in square places, and what it
-- says of the cells that the frame sees there: their numbers, and one after the other l_k of each.
-- There are millions of these where there are thousands of frames, so that each is kept in a few
-- words.
data Displacement = Displacement
  { displacementShift :: !(Int, Int),
    displacementSquare :: !Double,
    displacementNumbers :: !(Unboxed.Vector Int),
    displacementLogs :: !ClassLogs
  }

-- | A displacement with |d|^2 and l_k of each cell, by its number; all of as many classes.
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

-- | The displacements of a frame that may matter: those not more than 12 below the likeliest, as
-- natural logarithms, by the frame alone; none where none has a phase that was looked at. Given are
-- the lattice's orientation and phase, the place of the frame's first one, in taxels, and what the
-- frame tells.
displacementsOf :: Grid -> Int -> (Int, Int) -> (Taxels, Likelihood) -> [Displacement]
displacementsOf grid orientation phase told =
  map (displacementAt grid orientation phase told) $
    V.toList (V.findIndices (>= max least (V.maximum scores - unlikely)) scores)
  where
    scores = displacementScores grid orientation phase told

-- | The least score of a displacement whose phase was looked at.
least :: Double
least = -1e300

-- | The logarithm of how likely each displacement of the grid is by the frame alone, row by row, up
-- to a constant; pi is the mean over one sigma an octave.
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

-- | The displacement of that index, row by row on the grid.
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

-- | How many phases there are across and down.
phaseCounts :: Likelihood -> (Int, Int)
phaseCounts = phaseCount . placesFineness . templatePlaces . likelihoodTables

-- | The cells that a frame sees at a phase of an orientation, modulo the pitch: the row and column
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

-- | What a frame says of the cells that it sees, at each phase that may matter: the upright phases,
-- and the half turned ones. Phases more than 'unlikely' below the likeliest are left out.
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

-- | One number for a cell's row and column: in an area that can be put together there are fewer
-- than 2^20 columns.
cellNumber :: Int -> Int -> Int
cellNumber row column = row * 1048576 + column

-- | The row and column of a cell's number.
cellRowColumn :: Int -> (Int, Int)
cellRowColumn number = (row, number - row * 1048576)
  where
    row = (number + 524288) `div` 1048576
