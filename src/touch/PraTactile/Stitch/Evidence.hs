{-# LANGUAGE BangPatterns #-}

-- | What one frame tells of the lattice of cells under it: the likelihood of every phase of the
-- lattice and of each cell's class. The alphabet and the pitch of the cells are known; the array,
-- the gain, the offset and the noise of the frame are not.
--
-- The symbols do not overlap, so the squared error of a whole lattice is a sum over its cells, and
-- with the classes independent and uniform the likelihood of a phase is a product over them. Gain,
-- offset and noise are found by expectation and maximisation.
module PraTactile.Stitch.Evidence
  ( Evidence (..),
    evidence,
    Level (..),
    phaseCount,
    absent,
    overClasses,
  )
where

import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import PraTactile.Geometry (columnPitch, rowPitch)
import PraTactile.Image (Raster, mapRaster, rasterHeight, rasterValues, rasterWidth)
import PraTactile.Stitch.Template

-- | How a frame reads relief: gain times the relief (1 embossed, 0 flat) plus offset, plus normal
-- noise of that variance.
data Level = Level
  { levelGain :: !Double,
    levelOffset :: !Double,
    levelVariance :: !Double
  }
  deriving stock (Eq, Show)

-- | What a frame tells.
data Evidence = Evidence
  { evidenceTables :: !Templates,
    evidenceLevel :: !Level,
    -- | How much likelier, as a natural logarithm, a symbol of a class at a place makes the frame
    -- than nothing there: by 'cellIndex' and class.
    evidenceClasses :: !(Vector Double),
    -- | The same for a cell whose class is not known, by 'cellIndex'.
    evidenceCells :: !(Vector Double),
    -- | The same for a whole lattice: by orientation, and the row and the column of places, modulo
    -- the pitch, of its cells.
    evidencePhases :: !(Vector Double),
    -- | The logarithm of the frame's probability density, standardised to variance 1.
    evidenceLog :: !Double
  }

-- | The probability that nothing is in a cell: beyond the face, or worn off.
absent :: Double
absent = 0.01

-- | The number of phases across and down, places to the taxel given.
phaseCount :: Int -> (Int, Int)
phaseCount q = (columnPitch * q, rowPitch * q)

-- | What a frame of the tables' size tells. A frame without any variation tells nothing.
evidence :: Templates -> Raster -> Evidence
evidence tables image = weighed tables fine (refined 1 tables fine (refined 4 rough coarse start))
  where
    values = rasterValues image
    n = fromIntegral (V.length values)
    average = V.sum values / n
    deviation = sqrt (V.sum (V.map (\v -> (v - average) * (v - average)) values) / n)
    standard = mapRaster (\v -> if deviation > 1e-9 then (v - average) / deviation else 0) image
    start = firstLevel standard
    rough = coarser tables
    coarse = correlations rough standard
    fine = correlations tables standard
    refined :: Int -> Templates -> Vector Double -> Level -> Level
    refined steps t products level = iterate (improved t products) level !! steps

-- | A first guess: the noise from the second differences across, in which smooth relief has next to
-- no part, and the gain and the offset from what is usual of symbols.
firstLevel :: Raster -> Level
firstLevel image = Level gain (-0.15 * gain) noise
  where
    w = rasterWidth image
    h = rasterHeight image
    v = rasterValues image
    at y x = V.unsafeIndex v (y * w + x)
    differences =
      [ let d = at y x - at y (x + 1) - at (y + 1) x + at (y + 1) (x + 1) in d * d
        | y <- [0 .. h - 2],
          x <- [0 .. w - 2]
      ]
    noise
      | null differences = 0.5
      | otherwise = max 1e-3 (min 0.95 (sum differences / (4 * fromIntegral (length differences))))
    gain = sqrt (max 0.02 (1 - noise)) / 0.36

-- | Everything at a level, from the correlations of the standardised frame.
weighed :: Templates -> Vector Double -> Level -> Evidence
weighed tables products level@(Level gain offset variance) =
  Evidence tables level classes cells phases total
  where
    -- Note [Bounds of classes]
    classes = V.generate (V.length products) $ \i ->
      ( gain * (V.unsafeIndex products i - offset * V.unsafeIndex (templateSums tables) i)
          - gain * gain / 2 * V.unsafeIndex (templateSquares tables) i
      )
        / variance
    cells = cellsOf (templateClasses tables) classes
    phases = phasesOf tables cells
    top = V.maximum phases
    n = let (w, h) = templateFrame tables in fromIntegral (w * h)
    total =
      top + log (V.sum (V.map (\l -> exp (l - top)) phases) / fromIntegral (V.length phases))
        - n * (1 + offset * offset) / (2 * variance)
        - n / 2 * log (2 * pi * variance)

{- Note [Bounds of classes] The correlations, the sums and the squares of a template all have one
   number for each cell and class. -}

-- | From classes to cells.
cellsOf :: Int -> Vector Double -> Vector Double
cellsOf count classes = V.generate (V.length classes `quot` count) cell
  where
    cell i = overClasses count (\k -> V.unsafeIndex classes (i * count + k))

-- | The logarithm of how likely a cell is, given those of each class: the mean over the classes,
-- and nothing at all with its own probability.
overClasses :: Int -> (Int -> Double) -> Double
overClasses count at = m + log (terms 0 (absent * exp (negate m)))
  where
    share = (1 - absent) / fromIntegral count
    m = highest 0 0
    highest :: Int -> Double -> Double
    highest !k !best
      | k >= count = best
      | otherwise = highest (k + 1) (max best (at k))
    terms :: Int -> Double -> Double
    terms !k !s
      | k >= count = s
      | at k - m < -30 = terms (k + 1) s
      | otherwise = terms (k + 1) (s + share * exp (at k - m))
{-# INLINE overClasses #-}

-- | From cells to lattices: the sum over the cells of each.
phasesOf :: Templates -> Vector Double -> Vector Double
phasesOf tables cells = V.generate (2 * down * across) phase
  where
    (columns, rows) = templateGrid tables
    (across, down) = phaseCount (templatePlaces tables)
    phase i = go py px 0
      where
        (row, px) = i `quotRem` across
        (o, py) = row `quotRem` down
        go !y !x !s
          | y >= rows = s
          | x >= columns = go (y + down) px s
          | otherwise =
            go y (x + across) (s + V.unsafeIndex cells (cellIndex tables o y x) :: Double)

-- | One step: what the symbols probably are at this level, and the level that fits them best.
improved :: Templates -> Vector Double -> Level -> Level
improved tables products level@(Level gain offset _) = Level gain' offset' variance'
  where
    given = weighed tables products level
    (columns, rows) = templateGrid tables
    (across, down) = phaseCount (templatePlaces tables)
    count = templateClasses tables
    share = (1 - absent) / fromIntegral count
    n = let (w, h) = templateFrame tables in fromIntegral (w * h)
    phases = evidencePhases given
    top = V.maximum phases
    weights = V.map (\l -> exp (l - top)) phases
    total = V.sum weights
    (sumY, sumT, sumTT) = V.ifoldl' phase (0, 0, 0) weights
    phase (!a, !b, !c) i weight
      | weight < 1e-6 * total = (a, b, c)
      | otherwise = go py px a b c
      where
        (row, px) = i `quotRem` across
        (o, py) = row `quotRem` down
        go !y !x !a' !b' !c'
          | y >= rows = (a', b', c')
          | x >= columns = go (y + down) px a' b' c'
          | otherwise =
            let cell = cellIndex tables o y x
                (a'', b'', c'') = symbols (cell * count) (V.unsafeIndex (evidenceCells given) cell)
             in go y (x + across) (a' + weight * a'') (b' + weight * b'') (c' + weight * c'')
    symbols start cell = go 0 0 0 0
      where
        go :: Int -> Double -> Double -> Double -> (Double, Double, Double)
        go !k !a !b !c
          | k >= count = (a, b, c)
          | otherwise =
            let p = share * exp (V.unsafeIndex (evidenceClasses given) (start + k) - cell)
             in go
                  (k + 1)
                  (a + p * V.unsafeIndex products (start + k))
                  (b + p * V.unsafeIndex (templateSums tables) (start + k))
                  (c + p * V.unsafeIndex (templateSquares tables) (start + k))
    -- The regression of the frame, of mean 0 and variance 1, on the relief.
    products' = sumY / total
    sums = sumT / total
    squares = sumTT / total
    spreadOfRelief = squares - sums * sums / n
    gain' = if spreadOfRelief > 1e-6 then max 0.3 (products' / spreadOfRelief) else gain
    offset' = if spreadOfRelief > 1e-6 then negate gain' * sums / n else offset
    variance' =
      max
        2e-3
        ( ( n * (1 + offset' * offset') - 2 * gain' * (products' - offset' * sums)
              + gain' * gain' * squares
          )
            / n
        )
