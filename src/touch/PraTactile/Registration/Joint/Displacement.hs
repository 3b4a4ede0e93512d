{-# LANGUAGE BangPatterns #-}

-- | The displacements that a frame may have on a lattice, and what it says of the cells that it
-- then sees.
module PraTactile.Registration.Joint.Displacement
  ( Displacement (..),
    Logs,
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
import PraTactile.Registration.Loops (dotWithin, tabulate)

-- | A displacement d of a frame, in places from its grid point: log pi by the standard deviation of
-- the robot's error, and l_k of each cell that the frame sees there, by the cell's number.
data Displacement = Displacement
  { displacementShift :: !(Int, Int),
    displacementPriors :: !Logs,
    displacementCells :: ![(Int, Logs)]
  }

-- | Logarithms, a number for each class of symbols or each standard deviation. There are millions
-- of them where there are thousands of frames, and the garbage collector may move them together.
type Logs = Unboxed.Vector Double

-- | The displacements that are not less likely than a frame's best by a @margin@, as natural
-- logarithms, by the frame alone. Given are the lattice's orientation and phase, the place of the
-- frame's first one, in taxels, and what the frame tells.
displacementsOf :: Grid -> Int -> (Int, Int) -> (Taxels, Likelihood) -> [Displacement]
displacementsOf grid orientation (phaseY, phaseX) (place, given) =
  [ Displacement
      (i - reach, j - reach)
      (Unboxed.fromList (zipWith (\h v -> h V.! i + v V.! j) across' down'))
      (cells (i - reach) (j - reach))
    | k <- V.toList (V.findIndices (>= V.maximum scores - margin) scores),
      let (j, i) = k `quotRem` side
  ]
  where
    tables = likelihoodTables given
    places = templatePlaces tables
    (across, down) = phaseCount (placesFineness places)
    (columns, rows) = placesGrid places
    count = symbolsClasses (templateSymbols tables)
    ((nx, ny), (rx, ry)) = onGrid place
    reach = gridReach grid
    side = 2 * reach + 1
    across' = map (priorAlong grid rx) (gridSigmas grid)
    down' = map (priorAlong grid ry) (gridSigmas grid)
    -- By row and column of displacements; pi is the mean over an error to each octave.
    scores = tabulate side side $ \j ->
      let !row = (orientation * down + (phaseY - ny - j + reach) `mod` down) * across
       in \i ->
            log (dotWithin octaves (octavesAcross, i * octaves) (octavesDown, j * octaves))
              + V.unsafeIndex (phaseLogs given) (row + (phaseX - nx - i + reach) `mod` across)
    coarse = gridOctaves grid
    octaves = length (gridSigmas coarse)
    octavesAcross = byOctave rx
    octavesDown = byOctave ry
    byOctave rest =
      let logs = map (priorAlong coarse rest) (gridSigmas coarse)
       in V.concat [V.fromList [exp (l V.! i) | l <- logs] | i <- [0 .. side - 1]]
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
