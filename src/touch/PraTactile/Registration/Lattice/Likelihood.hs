{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The likelihood of one frame: of the phases of the lattice under it, and of each cell's class.
-- The alphabet and the pitch of the cells are known. The array is not, and neither are the frame's
-- gain, offset and noise.
--
-- A symbol of class k whose upper left taxel lies at x, in orientation o (upright or half turned),
-- brings to taxel u the relief
--
-- > T(u) = sum over the embossed taxels j of class k, turned by o, of g(u - x - j)
--
-- where g is that of "PraTactile.Shape.Blur", but 0 from three taxels on along an axis. At an angle
-- the taxels j turn with the lattice; g, nearly the same in all directions, does not. Places x are
-- those from which a symbol's taxels come within two taxels of the frame. The log-likelihood ratios
-- to an empty cell at x are
--
-- > l_k(x)    = (a <z, T> - a b sum T - a^2 sum T^2 / 2) / v
-- > l(x)      = log (epsilon + sum over k of P(k) exp l_k(x))               a cell, classes summed
-- > L(lambda) = sum over the cells x of lambda of l(x)                      a phase
-- > log p(z)  = log (mean over lambda of exp L(lambda))
-- >             - N (1 + b^2) / (2 v) - N/2 log (2 pi v)                    the frame
--
-- EM finds theta, with phases and classes summed. No step makes p(z) smaller:
--
-- > eStep:  w(lambda) ~ exp L(lambda),    p_k(x) = P(k) exp (l_k(x) - l(x))
-- > mStep:  Y, S, Q = sum of w(lambda) p_k(x) times <z, T>, sum T, sum T^2,
-- >                   over phases, their cells and classes
-- >         a = Y / (Q - S^2 / N),    b = - a S / N
-- >         v = (N (1 + b^2) - 2 a (Y - b S) + a^2 Q) / N
--
-- For a tilted press, sums over taxels are by weight: the mean and variance of z, N, \<z, T> and
-- sum T. Sum T^2 shrinks by the factor by which the weights shrink sum T.
module PraTactile.Registration.Lattice.Likelihood
  ( Likelihood (..),
    eStep,
    mStep,

    -- * What theta is found from
    Statistics (..),
    FrameSums (..),
    allPhases,
    atPhases,
    somePhases,
  )
where

import qualified Data.IntMap.Strict as IntMap
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import PraTactile.Registration.Lattice.Places
import PraTactile.Registration.Lattice.Symbols (symbolsClasses)
import PraTactile.Registration.Lattice.Template
import PraTactile.Registration.Loops (tabulate)
import PraTactile.Registration.Model
import PraTactile.Registration.Numbers (leastGain, leastVariance, leastWeight, negligible)

-- | The likelihood of one frame.
data Likelihood = Likelihood
  { likelihoodTables :: !LatticeTemplates,
    likelihoodTheta :: !Theta,
    -- | The position of a cell in 'cellLogs', from its 'cellIndex', if any phase that it belongs to
    -- was evaluated.
    cellAt :: Int -> Int,
    -- | l_k: the log-likelihood ratio of each class to an empty cell, by the cell's position and
    -- then the class.
    classLogs :: !(Vector Double),
    -- | l: the log-likelihood ratio of a cell, classes summed, to an empty one, by the cell's
    -- position.
    cellLogs :: !(Vector Double),
    -- | L: the log-likelihood ratio of a phase, by orientation, and the row and column of places
    -- modulo the pitch. It is minus infinity for phases that were not evaluated.
    phaseLogs :: !(Vector Double),
    -- | The index of the greatest of 'phaseLogs'.
    likeliestPhase :: Int,
    -- | log p(z): the frame's log probability density, standardised to variance 1.
    logDensity :: !Double
  }

-- | The data of the steps: the tables, some phases with the positions of their cells, the position
-- of a cell by its 'cellIndex', the moments by position, and N, the total weight.
data Statistics = Statistics !LatticeTemplates Phases (Int -> Int) TemplateSums !Double

-- | A frame as it is compared with templates: 'areaSums' of its weighted readings; 'areaSums' of
-- the weights, unless all are 1; and the total weight.
data FrameSums = FrameSums
  { sumsReadings :: Vector Double,
    sumsWeights :: Maybe (Vector Double),
    sumsTotal :: !Double
  }

-- | The statistics of all phases of a frame.
allPhases :: LatticeTemplates -> FrameSums -> Statistics
allPhases tables (FrameSums areas shares n) =
  Statistics
    tables
    (templatePhases tables)
    id
    ( maybe
        id
        (weighed . correlationsOf tables)
        shares
        (TemplateSums (correlationsOf tables areas) (templateSums tables) (templateSquares tables))
    )
    n

-- | Restricts the statistics of all phases to some of them.
atPhases :: Statistics -> [Int] -> Statistics
atPhases statistics@(Statistics tables _ _ (TemplateSums products sums squares) n) phases
  | many tables phases = statistics
  | otherwise = among tables phases momentsOf n
  where
    momentsOf cells = TemplateSums (at cells products) (at cells sums) (at cells squares)
    count = symbolsClasses (templateSymbols tables)
    -- Note [Bounds of cells]
    at cells numbers =
      tabulate count (V.length cells) $ \c ->
        let !start = V.unsafeIndex cells c * count in \k -> V.unsafeIndex numbers (start + k)

-- | The statistics of some phases, from the frame, without evaluating all.
somePhases :: LatticeTemplates -> FrameSums -> [Int] -> Statistics
somePhases tables felt@(FrameSums areas shares n) phases
  | many tables phases = allPhases tables felt
  | otherwise = among tables phases momentsOf n
  where
    momentsOf cells =
      maybe id (\of' -> weighed (productsAt tables of' cells)) shares (momentsAt tables areas cells)

-- | The statistics of some phases, given a function for the moments of cells, which are given by
-- 'cellIndex'.
among :: LatticeTemplates -> [Int] -> (Vector Int -> TemplateSums) -> Double -> Statistics
among tables phases momentsOf =
  Statistics
    tables
    here {phaseCells = V.enumFromN 0 (V.length cells)}
    (numbers IntMap.!)
    (momentsOf cells)
  where
    here = phasesOf (templatePlaces tables) phases
    cells = phaseCells here
    numbers = IntMap.fromList (zip (V.toList cells) [0 ..])

-- | Whether to evaluate all phases at once: when more than a quarter are wanted, or none
-- (log-likelihoods are NaN).
many :: LatticeTemplates -> [Int] -> Bool
many tables phases = null phases || 4 * length phases > phaseTotal (templatePlaces tables)

-- | All log-likelihoods at a theta.
eStep :: Statistics -> Theta -> Likelihood
eStep (Statistics tables lattices at (TemplateSums products sums squares) n) theta =
  Likelihood tables theta at classes cells phases (V.maxIndex phases) total
  where
    Theta gain offset variance = theta
    !count = symbolsClasses (templateSymbols tables)
    !ofProducts = gain / variance
    !ofSums = gain * offset / variance
    !ofSquares = gain * gain / (2 * variance)
    -- Note [Bounds of classes]
    !classes =
      tabulate (V.length products) 1 $ \_ i ->
        ofProducts * V.unsafeIndex products i - ofSums * V.unsafeIndex sums i
          - ofSquares * V.unsafeIndex squares i
    cells =
      tabulate (V.length products `quot` count) 1 $ \_ c ->
        cellLog count (\k -> V.unsafeIndex classes (c * count + k))
    looked = overPhases lattices cells
    phases =
      V.unsafeUpdate_
        (V.replicate (phaseTotal (templatePlaces tables)) (-1 / 0))
        (phaseNumbers lattices)
        looked
    top = V.maximum looked
    total =
      top
        + log
          ( V.sum (V.map (relativeTo top) looked)
              / fromIntegral (phaseTotal (templatePlaces tables))
          )
        - n * (1 + offset * offset) / (2 * variance)
        - n / 2 * log (2 * pi * variance)

{- Note [Bounds of classes] The correlations, the sums and the squares of templates all have one
   number for each cell and class. -}

-- | The likelihood relative to the best, from logarithms; 0 below 'negligible'.
relativeTo :: Double -> Double -> Double
relativeTo top l = if l - top < negate negligible then 0 else exp (l - top)

-- | The sum of the cells' values over each phase.
overPhases :: Phases -> Vector Double -> Vector Double
overPhases lattices !values = V.generate (V.length (phaseBegins lattices) - 1) phase
  where
    phase i = overCells lattices i 0 (\s cell -> s + V.unsafeIndex values cell)

-- | Folds over the cells of phase i, which are given by number, from a start.
overCells :: Phases -> Int -> s -> (s -> Int -> s) -> s
overCells (Phases _ !begins !cells) i start step = go (V.unsafeIndex begins i) start
  where
    !end = V.unsafeIndex begins (i + 1)
    -- Note [Bounds of cells]
    go !c !s
      | c >= end = s
      | otherwise = go (c + 1) (step s (V.unsafeIndex cells c))
{-# INLINE overCells #-}

{- Note [Bounds of cells] The beginnings have a final end, and each lies within the cells. Cells are
   numbers within their tables, as phases are numbers among all phases. -}

-- | Posterior sums over symbols: of the correlations, of sum T, and of sum T^2.
data Sums = Sums !Double !Double !Double

-- | The theta that fits best, given the posterior of phases and symbols at a theta.
mStep :: Statistics -> Likelihood -> Theta
mStep (Statistics tables lattices _ moments n) given = Theta gain' offset' variance'
  where
    Theta gain offset _ = likelihoodTheta given
    !(TemplateSums products sums squares) = moments
    !count = symbolsClasses (templateSymbols tables)
    !share = classPrior count
    !ofCells = cellLogs given
    !ofClasses = classLogs given
    -- Note [Bounds of cells]
    phases = V.map (V.unsafeIndex (phaseLogs given)) (phaseNumbers lattices)
    top = V.maximum phases
    weights = V.map (relativeTo top) phases
    total = V.sum weights
    Sums sumY sumT sumTT = V.ifoldl' phase (Sums 0 0 0) weights
    phase found i weight
      | weight < leastWeight * total = found
      | otherwise = overCells lattices i found $ \(Sums a b c) cell ->
        let Sums a' b' c' = symbols (cell * count) (V.unsafeIndex ofCells cell)
         in Sums (a + weight * a') (b + weight * b') (c + weight * c')
    symbols !start !cell = go 0 (Sums 0 0 0)
      where
        go :: Int -> Sums -> Sums
        go !k found@(Sums a b c)
          | k >= count = found
          | l < log leastWeight = go (k + 1) found
          | otherwise =
            go
              (k + 1)
              ( Sums
                  (a + p * V.unsafeIndex products i)
                  (b + p * V.unsafeIndex sums i)
                  (c + p * V.unsafeIndex squares i)
              )
          where
            i = start + k
            l = V.unsafeIndex ofClasses i - cell
            p = share * exp l
    -- Regression of the frame, of mean 0 and variance 1, on the relief.
    product' = sumY / total
    sum' = sumT / total
    square' = sumTT / total
    spreadOfRelief = square' - sum' * sum' / n
    gain' = if spreadOfRelief > 1e-6 then max leastGain (product' / spreadOfRelief) else gain
    offset' = if spreadOfRelief > 1e-6 then negate gain' * sum' / n else offset
    variance' =
      max
        leastVariance
        ( ( n * (1 + offset' * offset') - 2 * gain' * (product' - offset' * sum')
              + gain' * gain' * square'
          )
            / n
        )
