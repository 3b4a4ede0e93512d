{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Two frames registered by the lattice of cells that lies under both: wherever the lattice lies
-- under the first frame, a displacement says where it lies under the second, and a cell that both
-- see holds one symbol.
module PraTactile.Registration.Pair.Lattice
  ( latticePosterior,
  )
where

import Data.List (foldl')
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Registration.Lattice.Likelihood
import PraTactile.Registration.Lattice.Places
import PraTactile.Registration.Lattice.Symbols (symbolsClasses)
import PraTactile.Registration.Lattice.Template
import PraTactile.Registration.Model (cellLog)
import PraTactile.Registration.Posterior

-- | The posterior of the place of the second frame's upper left pixel in the first, from their
-- nominal displacement and how far around it to search, taxels; summed over the phases of the
-- lattice and the classes of the cells.
latticePosterior :: Taxels -> Double -> Likelihood -> Likelihood -> Posterior
latticePosterior (stepX, stepY) search a b =
  posterior (taxels (startX, startY)) (1 / fromIntegral q) (side, side) (V.map log masses)
  where
    q = placesFineness (templatePlaces (likelihoodTables a))
    taxels (x, y) = (fromIntegral x / fromIntegral q, fromIntegral y / fromIntegral q)
    reach = ceiling (search * fromIntegral q) :: Int
    side = 2 * reach + 1
    startX = round (stepX * fromIntegral q) - reach
    startY = round (stepY * fromIntegral q) - reach
    prior i =
      let (y, x) = i `quotRem` side
          (dx, dy) = taxels (startX + x, startY + y)
       in priorAround search (dx - stepX, dy - stepY)
    priors = V.generate (side * side) prior
    found = candidates a b (startX, startY) side priors
    scored =
      [ (d, V.unsafeIndex priors d + joint a b (startX + x, startY + y) phase)
        | (d, phase) <- found,
          let (y, x) = d `quotRem` side
      ]
    top = foldl' (\m (_, s) -> max m s) (-1 / 0) scored
    masses = V.accum (+) (V.replicate (side * side) 0) [(d, exp (s - top)) | (d, s) <- scored]

-- | The displacements, by their index, and the phases that may matter. The classes that both frames
-- see can only add the logarithm of their number a cell to what the frames say apart, so what lies
-- further below the best by that need not be looked at.
candidates :: Likelihood -> Likelihood -> (Int, Int) -> Int -> Vector Double -> [(Int, Int)]
candidates a b (startX, startY) side priors = [(d, i) | (_, d, i) <- fewest 15 (upTo 15)]
  where
    (across, down) = phaseCount (placesFineness (templatePlaces (likelihoodTables a)))
    phasesA = phaseLogs a
    phasesB = phaseLogs b
    size = V.length phasesA
    -- What any displacement and the phase of B's lattice add at most.
    mostAdded = V.maximum phasesB + V.maximum priors
    top = best 0 (overDisplacements (\m _ s -> max m s) (V.maxIndex phasesA) (-1 / 0))
    best !i !m
      | i >= size = m
      | V.unsafeIndex phasesA i + mostAdded <= m = best (i + 1) m
      | otherwise = best (i + 1) (overDisplacements (\m' _ s -> max m' s) i m)
    upTo margin = from 0 []
      where
        from !i kept
          | i >= size = kept
          | V.unsafeIndex phasesA i + mostAdded < top - margin = from (i + 1) kept
          | otherwise = from (i + 1) (overDisplacements (keep i) i kept)
        keep i kept d s = if s >= top - margin then (s, d, i) : kept else kept
    -- Of too many, those that lie less far below.
    fewest :: Double -> [(Double, Int, Int)] -> [(Double, Int, Int)]
    fewest margin found
      | margin < 0.5 || length found <= 30000 = found
      | otherwise = fewest (0.7 * margin) [f | f@(s, _, _) <- found, s >= top - 0.7 * margin]
    -- What both frames say apart of a phase of A's lattice and each displacement, by its index.
    overDisplacements :: (s -> Int -> Double -> s) -> Int -> s -> s
    overDisplacements step i = rows 0 ((py - startY) `mod` down)
      where
        (row, px) = i `quotRem` across
        (o, py) = row `quotRem` down
        own = V.unsafeIndex phasesA i
        firstX = (px - startX) `mod` across
        -- The phase of B's lattice goes back where the displacement goes on.
        -- Note [Bounds of phases]
        rows !dy !y !s
          | dy >= side = s
          | otherwise =
            rows (dy + 1) (before down y) (columns (dy * side) ((dy + 1) * side) firstX s)
          where
            columns !d !end !x !s'
              | d >= end = s'
              | otherwise =
                columns (d + 1) end (before across x) $
                  step s' d $
                    V.unsafeIndex priors d
                      + own
                      + V.unsafeIndex phasesB ((o * down + y) * across + x)
    {-# INLINE overDisplacements #-}
    before period t = if t == 0 then period - 1 else t - 1 :: Int

{- Note [Bounds of phases] There are side * side priors, one for each displacement. Rows and columns
   of phases stay below how many there are of them, which is the same for both frames. -}

-- | How much likelier than by nothing at all both frames are, for a displacement in places and a
-- phase of A's lattice.
joint :: Likelihood -> Likelihood -> (Int, Int) -> Int -> Double
joint a b (dx, dy) phase = go firstY firstX 0
  where
    tables = likelihoodTables a
    places = templatePlaces tables
    count = symbolsClasses (templateSymbols tables)
    (columns, rows) = placesGrid places
    (across, down) = phaseCount (placesFineness places)
    (row, px) = phase `quotRem` across
    (o, py) = row `quotRem` down
    firstX = firstAtLeast px across (min 0 dx)
    firstY = firstAtLeast py down (min 0 dy)
    firstAtLeast p period least = p + period * negate ((p - least) `div` period)
    lastX = max columns (columns + dx)
    lastY = max rows (rows + dy)
    go !y !x !s
      | y >= lastY = s
      | x >= lastX = go (y + down) firstX s
      | otherwise = go y (x + across) (s + cell y x)
    cell y x
      | inA && inB = both ofA ofB
      | inA = V.unsafeIndex (cellLogs a) ofA
      | inB = V.unsafeIndex (cellLogs b) ofB
      | otherwise = 0
      where
        inA = y >= 0 && y < rows && x >= 0 && x < columns
        ofA = cellAt a (cellIndex places o y x)
        ofB = cellAt b (cellIndex places o (y - dy) (x - dx))
        inB = y - dy >= 0 && y - dy < rows && x - dx >= 0 && x - dx < columns
    both :: Int -> Int -> Double
    both i j =
      cellLog count $ \k ->
        V.unsafeIndex (classLogs a) (i * count + k) + V.unsafeIndex (classLogs b) (j * count + k)
