{-# LANGUAGE BangPatterns #-}

-- | Where the lattice lies under all frames together.
module PraTactile.Registration.Joint.Phase
  ( commonPhase,
    glimpsedLog,
  )
where

import Data.List (foldl')
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Registration.Joint.Grid
import PraTactile.Registration.Lattice.Likelihood (Likelihood (..))
import PraTactile.Registration.Lattice.Places (phaseCount)
import PraTactile.Registration.Loops (dotWithin, tabulate)
import PraTactile.Registration.Model (outlier, placesPerTaxel)

-- | log P(lambda) of the lattice on the composite that the frames make likeliest, up to a constant,
-- and its orientation and phase, row and column.
commonPhase :: Grid -> [(Taxels, Likelihood)] -> (Double, (Int, (Int, Int)))
commonPhase grid frames = (logs V.! best, (o, (y, x)))
  where
    (across, down) = phaseCount placesPerTaxel
    logs = phasePosterior grid frames
    best = V.maxIndex logs
    (row, x) = best `quotRem` across
    (o, y) = row `quotRem` down

-- | log P(lambda) of the likeliest lattice up to a constant, at a glance: each frame has its
-- likeliest phase, and so the lattice has one of these.
glimpsedLog :: Grid -> [(Taxels, Likelihood)] -> Double
glimpsedLog grid frames =
  maximum [logSum [sum (map (given lambda) told) | told <- bySigma] | lambda <- map fst seen]
  where
    (across, down) = phaseCount placesPerTaxel
    seen =
      [ ((o, (y + ny) `mod` down, (x + nx) `mod` across), rest)
        | (place, told) <- frames,
          let ((nx, ny), rest) = onGrid place
              (row, x) = V.maxIndex (phaseLogs told) `quotRem` across
              (o, y) = row `quotRem` down
      ]
    bySigma =
      [ [ (lambda, kernel grid sigma across rx, kernel grid sigma down ry)
          | (lambda, (rx, ry)) <- seen
        ]
        | sigma <- gridOctaves grid
      ]
    given (o, y, x) ((o', y', x'), alongX, alongY)
      | o /= o' = log outlier
      | otherwise =
        log (outlier + (1 - outlier) * alongX V.! (across + x' - x) * alongY V.! (down + y' - y))

-- | log P(lambda) up to a constant, by orientation, row and column: each frame anywhere that the
-- robot's error lets it be, for one error to each octave.
phasePosterior :: Grid -> [(Taxels, Likelihood)] -> Vector Double
phasePosterior grid frames =
  V.generate (2 * across * down) (\i -> logSum (map (V.! i) bySigma))
  where
    (across, down) = phaseCount placesPerTaxel
    bySigma = map phasesGiven (gridOctaves grid)
    -- What so many frames tell has one logarithm: none of them tells less than delta.
    phasesGiven sigma = logsOfProducts 20 (map (ofFrame sigma) told)
    told = [(onGrid place, massesOf (phaseLogs given)) | (place, given) <- frames]
    -- What is too small for delta is nothing.
    massesOf phases =
      let !top = V.maximum phases
          !masses = V.map (\l -> if l - top < -60 then 0 else exp (l - top)) phases
          rowsOf o =
            [ start
              | y <- [0 .. down - 1],
                let start = (o * down + y) * across,
                V.any (> 0) (V.slice start across masses)
            ]
       in (masses, map (V.fromList . rowsOf) [0, 1])
    -- At each phase on the composite, what the frame says of its own, over the displacements with
    -- their prior: rows of phases in which it shows something are blurred across, and then down.
    ofFrame sigma (((nx, ny), (rx, ry)), (masses, shown)) = V.concat (map blurred shown)
      where
        blurred :: Vector Int -> Vector Double
        blurred rows = tabulate across down $ \y x ->
          outlier + (1 - outlier) * dotWithin n (blurredAcross, x * n) (downs, y * n)
          where
            !n = V.length rows
            !blurredAcross = tabulate n across $ \px ->
              let !x = (px - nx) `mod` across
               in \i -> dotWithin across (masses, rows V.! i) (kernelAcross, across - x)
            !downs = tabulate n down $ \py ->
              let !y = (py - ny) `mod` down
               in \i -> kernelDown V.! (down - y + (rows V.! i `quot` across) `mod` down)
        kernelAcross = kernel grid sigma across rx
        kernelDown = kernel grid sigma down ry

-- | The prior of the displacements from one phase to another, along an axis of so many phases, by
-- their difference, twice around, given sigma and what is left of the place.
kernel :: Grid -> Double -> Int -> Double -> Vector Double
kernel grid sigma period rest = once <> once
  where
    once =
      V.accum
        (+)
        (V.replicate period 0)
        [ (negate d `mod` period, priorAlong sigma (fromIntegral d - rest))
          | d <- [negate (gridReach grid) .. gridReach grid]
        ]

-- | The sum of the logarithms of vectors of numbers, of which so many, multiplied, are not too
-- small for a number.
logsOfProducts :: Int -> [Vector Double] -> Vector Double
logsOfProducts count vectors = case splitAt count vectors of
  (first : more, rest)
    | null rest -> logs
    | otherwise -> V.zipWith (+) logs (logsOfProducts count rest)
    where
      logs = V.map log (foldl' (V.zipWith (*)) first more)
  ([], _) -> V.empty
