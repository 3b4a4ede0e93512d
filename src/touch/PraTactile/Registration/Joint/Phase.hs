{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The phase of the lattice under all frames together. Displacements are summed, sigma takes one
-- value per octave, and L*_f is a frame's greatest L:
--
-- > P(lambda) ~ sum over sigma of product over f of
-- >    (delta + (1 - delta) * sum over d of pi_sigma(d) exp (L_f(lambda - n_f - d) - L*_f))
module PraTactile.Registration.Joint.Phase
  ( CommonPhase (..),
    commonPhase,
    quickPhaseLog,
  )
where

import Data.List (foldl', foldl1')
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Probability (logSum)
import PraTactile.Registration.Field
import PraTactile.Registration.Lattice.Likelihood (Likelihood (..))
import PraTactile.Registration.Lattice.Places (phaseCount)
import PraTactile.Registration.Loops (dotWithin, tabulate)
import PraTactile.Registration.Numbers (outlier, placesPerTaxel)

-- | The likeliest phase of the lattice under all frames.
data CommonPhase = CommonPhase
  { -- | log P(lambda), up to a constant.
    commonLog :: !Double,
    -- | The posterior probability of this phase among all phases.
    commonShare :: !Double,
    commonOrientation :: !Int,
    -- | Row and column of places.
    commonRowColumn :: !(Int, Int)
  }

-- | The likeliest phase of the lattice on the composite by at most 100 frames. If a phase is given
-- (orientation, row and column), it is taken instead.
commonPhase :: Grid -> [(Taxels, Likelihood)] -> Maybe (Int, (Int, Int)) -> CommonPhase
commonPhase grid frames known = CommonPhase (log here) (here / V.sum probable) o (y, x)
  where
    here = probable V.! phase
    (across, down) = phaseCount placesPerTaxel
    probable = phasePosterior grid frames
    phase = maybe (V.maxIndex probable) (\(o', (y', x')) -> (o' * down + y') * across + x') known
    (row, x) = phase `quotRem` across
    (o, y) = row `quotRem` down

-- | A quick log P(lambda) of the likeliest lattice, up to a constant. Each frame has only its
-- likeliest phase, and the lattice has one of these.
quickPhaseLog :: Grid -> [(Taxels, Likelihood)] -> Double
quickPhaseLog grid frames =
  maximum [logSum [sum (map (given lambda) told) | told <- bySigma] | lambda <- map fst seen]
  where
    (across, down) = phaseCount placesPerTaxel
    seen =
      [ ((o, (y + ny) `mod` down, (x + nx) `mod` across), rest)
        | (place, told) <- frames,
          let ((nx, ny), rest) = onGrid grid place
              (row, x) = likeliestPhase told `quotRem` across
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

-- | P(lambda) up to a constant, by orientation, row and column. Displacements are summed by their
-- prior, and sigma takes one value per octave. Each frame's factor is at least delta, so that the
-- product of a hundred stays above 0.
phasePosterior :: Grid -> [(Taxels, Likelihood)] -> Vector Double
phasePosterior grid frames = foldl1' (V.zipWith (+)) (map phasesGiven (gridOctaves grid))
  where
    (across, down) = phaseCount placesPerTaxel
    phasesGiven sigma = foldl' (given sigma) (V.replicate (2 * across * down) 1) told
    told = [(onGrid grid place, massesOf (phaseLogs seen)) | (place, seen) <- frames]
    -- Values too small beside delta are set to 0.
    massesOf phases =
      let !top = V.maximum phases
          likely = V.toList (V.findIndices (\l -> l - top >= -60) phases)
          !masses =
            V.replicate (V.length phases) 0 V.// [(i, exp (phases V.! i - top)) | i <- likely]
       in (masses, [shownIn [i | i <- likely, i `quot` (across * down) == o] | o <- [0, 1]])
    -- The rows that have values, and their range of columns, by fours.
    shownIn likely =
      ( V.uniq (V.fromList [i - i `rem` across | i <- likely]),
        minimum (across : columns) `quot` 4 * 4,
        maximum (0 : columns) `quot` 4 * 4 + 4
      )
      where
        columns = map (`rem` across) likely
    -- Multiplies by a frame's own factor at each phase of the composite: its likelihood, blurred by
    -- the prior of displacements, across and then down, in rows that have values.
    given sigma before (((nx, ny), (rx, ry)), (masses, shown)) =
      V.concat [blurred (o * across * down) rows | (o, rows) <- zip [0, 1] shown]
      where
        blurred :: Int -> (Vector Int, Int, Int) -> Vector Double
        blurred start (rows, from, to)
          | n == 0 = V.map (outlier *) (V.slice start (across * down) before)
          | otherwise = tabulate across down $ \y ->
            let !row = start + y * across
             in \x ->
                  V.unsafeIndex before (row + x)
                    * (outlier + (1 - outlier) * dotWithin n (blurredAcross, x * n) (downs, y * n))
          where
            !n = V.length rows
            !blurredAcross = tabulate n across $ \px ->
              let !x = (px - nx) `mod` across
                  !start' = across - x + from
               in \i -> dotWithin (to - from) (masses, rows V.! i + from) (kernelAcross, start')
            !downs = tabulate n down $ \py ->
              let !y = (py - ny) `mod` down
               in \i -> kernelDown V.! (down - y + (rows V.! i `quot` across) `mod` down)
        kernelAcross = kernel grid sigma across rx
        kernelDown = kernel grid sigma down ry

-- | The prior of displacements along an axis by the difference of two phases, given sigma, the
-- number of phases, and the place's offset from its grid point. The period is stored twice, so that
-- differences need no wrapping.
kernel :: Grid -> Double -> Int -> Double -> Vector Double
kernel grid sigma period rest = once <> once
  where
    once = V.generate period (\c -> every ((gridReach grid - c) `mod` period))
    every i
      | i < V.length priors = V.unsafeIndex priors i + every (i + period)
      | otherwise = 0
    priors = priorsAlong grid sigma rest
