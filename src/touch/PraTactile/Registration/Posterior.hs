{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The posterior of a displacement on a grid, and estimates from it.
module PraTactile.Registration.Posterior
  ( GridPosterior (..),
    posterior,
    Hypothesis (..),
    hypotheses,
    probabilityAround,
    priorAlone,
    deviations,
    marginals,
    priorAround,
  )
where

import Data.List (foldl')
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Registration.Model (normalLog)
import PraTactile.Registration.Numbers (tolerance)

-- | Probabilities of displacements on a grid.
data GridPosterior = GridPosterior
  { -- | The first displacement, taxels.
    posteriorOrigin :: !Taxels,
    -- | The spacing of the grid, taxels.
    posteriorSpacing :: !Double,
    -- | The numbers of displacements across and down.
    posteriorSize :: !(Int, Int),
    -- | Their probabilities, row by row; the sum is 1.
    posteriorMasses :: !(Vector Double)
  }
  deriving stock (Eq, Show)

-- | Normalises log weights to a posterior. NaN counts as -infinity. If none is above -infinity, or
-- one is +infinity, the posterior is uniform.
posterior :: Taxels -> Double -> (Int, Int) -> Vector Double -> GridPosterior
posterior origin spacing size logs = GridPosterior origin spacing size (V.map (/ total) masses)
  where
    top = V.foldl' max (-1 / 0) (V.filter (not . isNaN) logs)
    masses
      | isInfinite top = V.map (const 1) logs
      | otherwise = V.map (\l -> if isNaN l then 0 else exp (l - top)) logs
    total = V.sum masses

-- | A displacement, and the probability that the true one lies within 'tolerance' of it on both
-- axes.
data Hypothesis = Hypothesis
  { hypothesisShift :: !Taxels,
    hypothesisProbability :: !Double
  }
  deriving stock (Eq, Show)

-- | At most the given number of the most probable displacements, the best first, each of at least
-- the given probability. Each grid point counts for one only, so those after the first may state
-- too little. The first is given whatever its probability.
hypotheses :: Int -> Double -> GridPosterior -> [Hypothesis]
hypotheses most least given = case go most (posteriorMasses given) of
  [] -> [fst (bestOf given)]
  found -> found
  where
    go :: Int -> Vector Double -> [Hypothesis]
    go n masses
      | n <= 0 || V.sum masses < least = []
      | n < most && hypothesisProbability best < least = []
      | otherwise = best : go (n - 1) (V.imap (\i m -> if inside i then 0 else m) masses)
      where
        (best, inside) = bestOf given {posteriorMasses = masses}

-- | The probability that the true displacement lies within 'tolerance' of one on both axes.
probabilityAround :: GridPosterior -> Taxels -> Double
probabilityAround (GridPosterior (ox, oy) spacing (columns, _) masses) (x, y) =
  min 1 (V.sum (V.ifilter (const . around) masses))
  where
    around i =
      let (row, column) = i `quotRem` columns
       in near (ox + spacing * fromIntegral column - x)
            && near (oy + spacing * fromIntegral row - y)
    near t = abs t <= tolerance + 1e-6

-- | The displacement with the most probability within 'tolerance', and the grid points that count
-- there. It takes the window of points that holds most. There it takes the mean, clamped along each
-- axis to within 'tolerance' of the outermost points that are left when at most 1/2000 of the
-- window's probability is cut off each end.
bestOf :: GridPosterior -> (Hypothesis, Int -> Bool)
bestOf (GridPosterior (ox, oy) spacing (columns, rows) masses) =
  (Hypothesis (ox + spacing * bestX, oy + spacing * bestY) (max 0 (min 1 held)), inside)
  where
    sums = integralOf columns rows masses
    heldIn (x0, x1) (y0, y1) = at y1 x1 - at y0 x1 - at y1 x0 + at y0 x0
    at y x = V.unsafeIndex sums (y * (columns + 1) + x)
    (_, wx, wy) =
      foldl'
        better
        (-1, (0, 0), (0, 0))
        [(x, y) | y <- windows spacing rows, x <- windows spacing columns]
    better best@(most, _, _) (x, y) = let s = heldIn x y in if s > most then (s, x, y) else best
    bestX = centreOf wx [heldIn (x, x + 1) wy | x <- uncurry stretch wx]
    bestY = centreOf wy [heldIn wx (y, y + 1) | y <- uncurry stretch wy]
    held = heldIn (around columns bestX) (around rows bestY)
    inside i =
      let (y, x) = i `quotRem` columns
       in among (around columns bestX) x && among (around rows bestY) y
    among (from, to) t = t >= from && t < to
    around n t = (max 0 (ceiling (t - reach - 1e-6)), min n (floor (t + reach + 1e-6) + 1))
    reach = tolerance / spacing
    stretch from to = [from .. to - 1]
    centreOf (from, _) line
      | total <= 0 = fromIntegral from
      | otherwise = max (last' - reach) (min (first' + reach) mean)
      where
        total = sum line
        mean = sum (zipWith (*) (map fromIntegral [from ..]) line) / total
        slight = length . takeWhile (<= total / 2000) . scanl1 (+)
        first' = fromIntegral (from + slight line)
        last' = fromIntegral (from + length line - 1 - slight (reverse line))

-- | The longest windows of grid points that lie within 'tolerance' of one place, as the first index
-- and the one after the last.
windows :: Double -> Int -> [(Int, Int)]
windows spacing n
  | n <= longest = [(0, n)]
  | otherwise = [(i, i + longest) | i <- [0 .. n - longest]]
  where
    longest = 1 + floor (2 * tolerance / spacing + 1e-9)

integralOf :: Int -> Int -> Vector Double -> Vector Double
integralOf columns rows masses =
  V.fromList (concat (scanl below (replicate (columns + 1) 0) [0 .. rows - 1]))
  where
    below above y =
      zipWith (+) above (scanl (+) 0 (V.toList (V.slice (y * columns) columns masses)))

-- | The standard deviations along x and y, taxels, including that of a grid cell.
deviations :: GridPosterior -> Taxels
deviations (GridPosterior _ spacing (columns, _) masses) = (along snd, along fst)
  where
    cell = spacing * spacing / 12
    along coordinate = sqrt (max 0 (second - first * first) * spacing * spacing + cell)
      where
        first = moment id
        second = moment (\t -> t * t)
        moment f =
          V.ifoldl'
            (\ !s i m -> s + m * f (fromIntegral (coordinate (i `quotRem` columns))))
            0
            masses

-- | The probability that x alone lies within 'tolerance' of the best x, and y alone of the best y.
marginals :: GridPosterior -> (Double, Double)
marginals (GridPosterior _ spacing (columns, rows) masses) = (best columns across, best rows down)
  where
    across = V.generate columns (\x -> sum [masses V.! (y * columns + x) | y <- [0 .. rows - 1]])
    down = V.generate rows (\y -> V.sum (V.slice (y * columns) columns masses))
    best n line =
      maximum (0 : [V.sum (V.slice from (to - from) line) | (from, to) <- windows spacing n])

-- | The log prior, up to a constant, of a displacement's difference from the nominal one, for a
-- search in taxels. It is normal along both axes, with half the search as standard deviation; flat
-- if the search is 0 or less.
priorAround :: Double -> Taxels -> Double
priorAround search (x, y)
  | search <= 0 = 0
  | otherwise = normalLog (sigma * sigma) (x * x + y * y)
  where
    sigma = search / 2

-- | The prior on the grid of a posterior: 'priorAround' the nominal displacement, for a search in
-- taxels.
priorAlone :: Double -> Taxels -> GridPosterior -> GridPosterior
priorAlone search (stepX, stepY) (GridPosterior origin@(ox, oy) spacing size@(columns, rows) _) =
  posterior origin spacing size $
    V.generate (columns * rows) $ \i ->
      let (row, column) = i `quotRem` columns
          along from k = from + spacing * fromIntegral k
       in priorAround search (along ox column - stepX, along oy row - stepY)
