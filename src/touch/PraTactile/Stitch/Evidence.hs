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
    Sight (..),
    sight,
    Level (..),
    absent,
    overClasses,
  )
where

import qualified Data.IntSet as IntSet
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import PraTactile.Image (Raster, mapRaster, rasterHeight, rasterValues, rasterWidth)
import PraTactile.Stitch.Blur (areaSums)
import PraTactile.Stitch.Layout
import PraTactile.Stitch.Symbols (symbolsClasses)
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

-- | What a frame tells, each part made when it is first looked at.
data Sight = Sight
  { -- | At whole taxels.
    sightRough :: Evidence,
    -- | The logarithm of its probability density, standardised to variance 1: 'evidenceLog', but
    -- for phases that it makes most unlikely at whole taxels.
    sightLog :: Double,
    -- | All, at all places.
    sightEvidence :: Evidence
  }

-- | What a frame of the tables' size tells. A frame without any variation tells nothing.
evidence :: Templates -> Raster -> Evidence
evidence tables = sightEvidence . sight tables

-- | The same by parts.
sight :: Templates -> Raster -> Sight
sight tables image = Sight rough likely fine
  where
    values = rasterValues image
    n = fromIntegral (V.length values)
    average = V.sum values / n
    deviation = sqrt (V.sum (V.map (\v -> (v - average) * (v - average)) values) / n)
    standard = mapRaster (\v -> if deviation > 1e-9 then (v - average) / deviation else 0) image
    areas = areaSums (templateLayout tables) standard
    coarse = wholly (coarser tables) (areaSums (templateLayout (coarser tables)) standard)
    rough = weighed coarse (iterate (improved coarse) (firstLevel standard) !! 4)
    fine = anew (wholly tables areas)
    anew comparison = weighed comparison (improved comparison (evidenceLevel rough))
    likely
      | 4 * length left > phaseTotal (templateLayout tables) = evidenceLog fine
      | otherwise = evidenceLog (anew (partly tables areas left))
    left = phasesLeft rough tables

-- | The phases at less than a taxel from those that are not most unlikely by what a frame tells at
-- whole taxels.
phasesLeft :: Evidence -> Templates -> [Int]
phasesLeft rough tables = IntSet.toList (IntSet.fromList (concatMap around kept))
  where
    q = layoutPlaces (templateLayout tables) `quot` layoutPlaces roughLayout
    roughLayout = templateLayout (evidenceTables rough)
    (acrossRough, downRough) = phaseCount (layoutPlaces roughLayout)
    (across, down) = (q * acrossRough, q * downRough)
    phases = evidencePhases rough
    top = V.maximum phases
    kept = V.toList (V.findIndices (> top - negligible) phases)
    around phase =
      let (row, x) = phase `quotRem` acrossRough
          (o, y) = row `quotRem` downRough
       in [ (o * down + (q * y + j) `mod` down) * across + (q * x + i) `mod` across
            | j <- [1 - q .. q - 1],
              i <- [1 - q .. q - 1]
          ]

-- | A frame held against symbols in cells: the tables, some phases of the lattice with their cells,
-- and the numbers of these.
data Comparison = Comparison !Templates !Phases !Numbers

-- | All phases, from the frame's 'areaSums'.
wholly :: Templates -> Vector Double -> Comparison
wholly tables areas =
  Comparison
    tables
    (templatePhases tables)
    (Numbers (correlationsOf tables areas) (templateSums tables) (templateSquares tables))

-- | Those phases only; the cells are numbered anew.
partly :: Templates -> Vector Double -> [Int] -> Comparison
partly tables areas phases =
  Comparison
    tables
    (Phases begins (V.enumFromN 0 (V.length cells)))
    (numbersAt tables areas cells)
  where
    Phases begins cells = phasesOf (templateLayout tables) phases

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

-- | Everything at a level.
weighed :: Comparison -> Level -> Evidence
weighed (Comparison tables lattices numbers) level@(Level gain offset variance) =
  Evidence tables level classes cells phases total
  where
    Numbers products sums squares = numbers
    -- Note [Bounds of classes]
    classes = V.generate (V.length products) $ \i ->
      ofProducts * V.unsafeIndex products i
        - ofSums * V.unsafeIndex sums i
        - ofSquares * V.unsafeIndex squares i
    ofProducts = gain / variance
    ofSums = gain * offset / variance
    ofSquares = gain * gain / (2 * variance)
    cells = cellsOf (symbolsClasses (templateSymbols tables)) classes
    phases = overPhases lattices cells
    top = V.maximum phases
    n = taxelsOf tables
    total =
      top
        + log
          ( V.sum (V.map (\l -> exp (l - top)) phases)
              / fromIntegral (phaseTotal (templateLayout tables))
          )
        - n * (1 + offset * offset) / (2 * variance)
        - n / 2 * log (2 * pi * variance)

{- Note [Bounds of classes] The correlations, the sums and the squares of a template all have one
   number for each cell and class. -}

-- | The number of a frame's taxels.
taxelsOf :: Templates -> Double
taxelsOf tables = let (w, h) = layoutFrame (templateLayout tables) in fromIntegral (w * h)

-- | From classes to cells.
cellsOf :: Int -> Vector Double -> Vector Double
cellsOf count classes = V.generate (V.length classes `quot` count) cell
  where
    cell i = overClasses count (\k -> V.unsafeIndex classes (i * count + k))

-- | The logarithm of how likely a cell is, given those of each class: the mean over the classes,
-- and nothing at all with its own probability. What is less likely by 'negligible' does not count.
overClasses :: Int -> (Int -> Double) -> Double
overClasses count at
  | m <= 0 = sumOf 0 absent
  | m > negligible = sumOf m 0
  | otherwise = sumOf m (absent * exp (negate m))
  where
    sumOf top rest = let s = terms top 0 rest in if s == absent then top + none else top + log s
    share = (1 - absent) / fromIntegral count
    none = log absent
    m = highest 0 0
    highest :: Int -> Double -> Double
    highest !k !best
      | k >= count = best
      | otherwise = highest (k + 1) (max best (at k))
    terms :: Double -> Int -> Double -> Double
    terms !top !k !s
      | k >= count = s
      | at k - top < negate negligible = terms top (k + 1) s
      | at k == top = terms top (k + 1) (s + share)
      | otherwise = terms top (k + 1) (s + share * exp (at k - top))
{-# INLINE overClasses #-}

negligible :: Double
negligible = 30

-- | From cells to lattices: the sum over the cells of each.
overPhases :: Phases -> Vector Double -> Vector Double
overPhases lattices values = V.generate (V.length (phaseBegins lattices) - 1) phase
  where
    phase i = overCells lattices i 0 (\s cell -> s + V.unsafeIndex values cell)

-- | Over the cells of a phase, which are given by their numbers, from a start.
overCells :: Phases -> Int -> s -> (s -> Int -> s) -> s
overCells (Phases begins cells) i start step = go (V.unsafeIndex begins i) start
  where
    end = V.unsafeIndex begins (i + 1)
    -- Note [Bounds of cells]
    go !c !s
      | c >= end = s
      | otherwise = go (c + 1) (step s (V.unsafeIndex cells c))
{-# INLINE overCells #-}

{- Note [Bounds of cells] The beginnings have an end, and each lies within the cells; these have
   their numbers in the tables that they are cells of. -}

-- | Sums over symbols, each as probable as it is: of their correlations, of the templates and of
-- the templates' squares.
data Sums = Sums !Double !Double !Double

-- | One step: what the symbols probably are at this level, and the level that fits them best.
improved :: Comparison -> Level -> Level
improved comparison@(Comparison tables lattices numbers) level@(Level gain offset _) =
  Level gain' offset' variance'
  where
    given = weighed comparison level
    Numbers products sums squares = numbers
    count = symbolsClasses (templateSymbols tables)
    share = (1 - absent) / fromIntegral count
    n = taxelsOf tables
    phases = evidencePhases given
    top = V.maximum phases
    weights = V.map (\l -> exp (l - top)) phases
    total = V.sum weights
    Sums sumY sumT sumTT = V.ifoldl' phase (Sums 0 0 0) weights
    phase found i weight
      | weight < 1e-6 * total = found
      | otherwise = overCells lattices i found $ \(Sums a b c) cell ->
        let Sums a' b' c' = symbols (cell * count) (V.unsafeIndex (evidenceCells given) cell)
         in Sums (a + weight * a') (b + weight * b') (c + weight * c')
    symbols start cell = go 0 (Sums 0 0 0)
      where
        go :: Int -> Sums -> Sums
        go !k found@(Sums a b c)
          | k >= count = found
          | otherwise =
            let p = share * exp (V.unsafeIndex (evidenceClasses given) (start + k) - cell)
             in go
                  (k + 1)
                  ( Sums
                      (a + p * V.unsafeIndex products (start + k))
                      (b + p * V.unsafeIndex sums (start + k))
                      (c + p * V.unsafeIndex squares (start + k))
                  )
    -- The regression of the frame, of mean 0 and variance 1, on the relief.
    product' = sumY / total
    sum' = sumT / total
    square' = sumTT / total
    spreadOfRelief = square' - sum' * sum' / n
    gain' = if spreadOfRelief > 1e-6 then max 0.3 (product' / spreadOfRelief) else gain
    offset' = if spreadOfRelief > 1e-6 then negate gain' * sum' / n else offset
    variance' =
      max
        2e-3
        ( ( n * (1 + offset' * offset') - 2 * gain' * (product' - offset' * sum')
              + gain' * gain' * square'
          )
            / n
        )
