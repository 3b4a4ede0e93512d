{-# LANGUAGE BangPatterns #-}

-- | Two frames registered by the lattice of cells that lies under both: wherever the lattice lies
-- under the first frame, a displacement says where it lies under the second, and a cell that both
-- see holds one symbol.
module PraTactile.Stitch.Pair.Lattice
  ( latticePosterior,
  )
where

import Data.List (foldl')
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import PraTactile.Stitch.Blend (Place)
import PraTactile.Stitch.Evidence
import PraTactile.Stitch.Posterior
import PraTactile.Stitch.Template

-- | The posterior of the place of the second frame's upper left pixel in the first, from their
-- nominal displacement and how far around it to search, taxels; summed over the phases of the
-- lattice and the classes of the cells.
latticePosterior :: Place -> Double -> Evidence -> Evidence -> Posterior
latticePosterior (stepX, stepY) search a b =
  posterior (taxels (startX, startY)) (1 / fromIntegral q) (side, side) (V.map log masses)
  where
    q = templatePlaces (evidenceTables a)
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
candidates :: Evidence -> Evidence -> (Int, Int) -> Int -> Vector Double -> [(Int, Int)]
candidates a b (startX, startY) side priors = within (margins 15)
  where
    q = templatePlaces (evidenceTables a)
    (across, down) = phaseCount q
    phasesA = evidencePhases a
    phasesB = evidencePhases b
    most = 30000
    -- The index of the phase of B's lattice where A's has the given one.
    apart !d !i =
      let (dy, dx) = d `quotRem` side
          (row, px) = i `quotRem` across
          (o, py) = row `quotRem` down
          x = (px - startX - dx) `mod` across
          y = (py - startY - dy) `mod` down
       in V.unsafeIndex priors d + V.unsafeIndex phasesA i
            + V.unsafeIndex phasesB ((o * down + y) * across + x)
    -- Phases of A that no displacement can save are passed over.
    bestB = V.maximum phasesB + V.maximum priors
    topA = V.maximum phasesA
    size = V.length phasesA
    top = foldPhases (topA - 40) (\m d i -> max m (apart d i)) (-1 / 0)
    foldPhases :: Double -> (s -> Int -> Int -> s) -> s -> s
    foldPhases least step = outer 0
      where
        outer !i !s
          | i >= size = s
          | V.unsafeIndex phasesA i < least = outer (i + 1) s
          | otherwise = inner i 0 s
        inner !i !d !s
          | d >= side * side = outer (i + 1) s
          | otherwise = inner i (d + 1) (step s d i)
    {-# INLINE foldPhases #-}
    within (margin, known) = known `seq` foldPhases (top - margin - bestB) keep []
      where
        keep kept d i = if apart d i >= top - margin then (d, i) : kept else kept
    margins :: Double -> (Double, ())
    margins margin
      | margin < 0.5 = (margin, ())
      | counted > most = margins (margin * 0.7)
      | otherwise = (margin, ())
      where
        counted =
          foldPhases
            (top - margin - bestB)
            (\n d i -> if apart d i >= top - margin then n + 1 else n)
            (0 :: Int)

-- | How much likelier than by nothing at all both frames are, for a displacement in places and a
-- phase of A's lattice.
joint :: Evidence -> Evidence -> (Int, Int) -> Int -> Double
joint a b (dx, dy) phase = go firstY firstX 0
  where
    tables = evidenceTables a
    q = templatePlaces tables
    count = templateClasses tables
    (columns, rows) = templateGrid tables
    (across, down) = phaseCount q
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
      | inA && inB = both (cellIndex tables o y x) (cellIndex tables o (y - dy) (x - dx))
      | inA = V.unsafeIndex (evidenceCells a) (cellIndex tables o y x)
      | inB = V.unsafeIndex (evidenceCells b) (cellIndex tables o (y - dy) (x - dx))
      | otherwise = 0
      where
        inA = y >= 0 && y < rows && x >= 0 && x < columns
        inB = y - dy >= 0 && y - dy < rows && x - dx >= 0 && x - dx < columns
    both :: Int -> Int -> Double
    both i j =
      overClasses count $ \k ->
        V.unsafeIndex (evidenceClasses a) (i * count + k)
          + V.unsafeIndex (evidenceClasses b) (j * count + k)
