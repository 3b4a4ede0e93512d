{-# LANGUAGE BangPatterns #-}

-- | Where the lattice lies under all frames together.
module PraTactile.Registration.Joint.Phase
  ( commonPhase,
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
import PraTactile.Registration.Model (placesPerTaxel)

-- | The orientation and the phase, row and column, of the lattice on the composite that the frames
-- make likeliest.
commonPhase :: Grid -> [(Taxels, Likelihood)] -> (Int, (Int, Int))
commonPhase grid frames = (o, (y, x))
  where
    (across, down) = phaseCount placesPerTaxel
    best = V.maxIndex (phasePosterior grid frames)
    (row, x) = best `quotRem` across
    (o, y) = row `quotRem` down

-- | log P(lambda) up to a constant, by orientation, row and column: each frame anywhere that the
-- prior lets it be.
phasePosterior :: Grid -> [(Taxels, Likelihood)] -> Vector Double
phasePosterior grid frames =
  foldl' (V.zipWith (+)) (V.replicate (2 * across * down) 0) (map ofFrame frames)
  where
    (across, down) = phaseCount placesPerTaxel
    ofFrame (place, given) = V.map (\m -> log (m + 1e-300)) (shifted (blurred masses))
      where
        phases = phaseLogs given
        top = V.maximum phases
        -- What is too small for the floor above is nothing: numbers near the smallest are slow.
        masses = V.map (\l -> if l - top < -700 then 0 else exp (l - top)) phases
        ((nx, ny), (rx, ry)) = onGrid place
        -- At the phase on the composite, what the frame says of its own.
        shifted v = tabulate across (2 * down) $ \r ->
          let (orient, py) = r `quotRem` down
              !start = ((py - ny) `mod` down) * across * 2 + orient
           in \px -> V.unsafeIndex v (start + 2 * ((px - nx) `mod` across))
        -- Over the displacements, with their prior; by row, column and orientation.
        blurred =
          ringed (2 * across) down (kernel down ry) . ringed (2 * down) across (kernel across rx)
        -- The prior of the displacements from one phase to another, by their difference, twice
        -- around.
        kernel period rest =
          let once =
                V.accum
                  (+)
                  (V.replicate period 0)
                  [ (negate d `mod` period, exp (priorAlong grid rest d))
                    | d <- [negate (gridReach grid) .. gridReach grid]
                  ]
           in once <> once

-- | So many rows of numbers, each a ring of that length, blurred by a kernel that is given twice
-- around; the rows become columns.
ringed :: Int -> Int -> Vector Double -> Vector Double -> Vector Double
ringed rows period kernel v =
  tabulate rows period $ \x y -> dotWithin period (v, y * period) (kernel, period - x)
