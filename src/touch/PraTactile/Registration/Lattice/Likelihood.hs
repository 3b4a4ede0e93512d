{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | What one frame tells of the lattice of cells under it: the likelihood of phases of the lattice
-- and of each cell's class. The alphabet and the pitch of the cells are known; the array,
-- the gain, the offset and the noise of the frame are not.
--
-- A symbol of class k whose upper left taxel lies at x, in orientation o (upright or half turned),
-- brings to taxel u the relief
--
-- > T(u) = sum over the embossed taxels j of class k, turned by o, of g(u - x - j)
--
-- where g is that of "PraTactile.Shape.Blur", but 0 from three taxels on along an axis. On a
-- lattice at an angle the taxels j are turned with it, and g, which is nearly the same in all
-- directions, is not. Places x are those from which a symbol's taxels come within two taxels of the
-- frame. Against an empty cell at x the log-likelihood ratios are
--
-- > l_k(x)    = (a <z, T> - a b sum T - a^2 sum T^2 / 2) / v
-- > l(x)      = log (epsilon + sum over k of P(k) exp l_k(x))               a cell, classes summed
-- > L(lambda) = sum over the cells x of lambda of l(x)                      a phase
-- > log p(z)  = log (mean over lambda of exp L(lambda))
-- >             - N (1 + b^2) / (2 v) - N/2 log (2 pi v)                    the frame
--
-- Theta is found by expectation and maximisation, with phases and classes summed. No step makes
-- p(z) smaller:
--
-- > eStep:  w(lambda) ~ exp L(lambda),    p_k(x) = P(k) exp (l_k(x) - l(x))
-- > mStep:  Y, S, Q = sum of w(lambda) p_k(x) times <z, T>, sum T, sum T^2,
-- >                   over phases, their cells and classes
-- >         a = Y / (Q - S^2 / N),    b = - a S / N
-- >         v = (N (1 + b^2) - 2 a (Y - b S) + a^2 Q) / N
--
-- Of a tilted press the sums over taxels are by weight: the mean and variance of z, N, \<z, T>, sum
-- T and sum T^2, of which the last is taken for as much less as sum T is.
module PraTactile.Registration.Lattice.Likelihood
  ( Likelihood (..),
    eStep,
    mStep,

    -- * What theta is found from
    Statistics (..),
    Felt (..),
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

-- | What a frame tells.
data Likelihood = Likelihood
  { likelihoodTables :: !Templates,
    likelihoodTheta :: !Theta,
    -- | Where what is told of a cell stands, by 'cellIndex', where any phase that it is of was
    -- looked at.
    cellAt :: Int -> Int,
    -- | How much likelier, as a natural logarithm, a symbol of a class makes the frame than nothing
    -- in a cell: by where it stands, and then the class.
    classLogs :: !(Vector Double),
    -- | The same for a cell whose class is not known, by where it stands.
    cellLogs :: !(Vector Double),
    -- | The same for a whole lattice: by orientation, and the row and the column of places, modulo
    -- the pitch, of its cells; minus infinity for phases that were not looked at.
    phaseLogs :: !(Vector Double),
    -- | Which of these is likeliest.
    likeliestPhase :: Int,
    -- | The logarithm of the frame's probability density, standardised to variance 1.
    logDensity :: !Double
  }

-- | What theta is found from: the tables, some phases of the lattice with where their cells stand
-- among the moments, where others do by 'cellIndex', the moments, and N, how many taxels count.
data Statistics = Statistics !Templates Phases (Int -> Int) Moments !Double

-- | A frame as it is held against templates: 'areaSums' of its readings, each times what its taxel
-- counts; where some count less than 1, those of what they count; and how many count in all.
data Felt = Felt
  { feltReadings :: Vector Double,
    feltShares :: Maybe (Vector Double),
    feltCount :: !Double
  }

-- | All phases of a frame.
allPhases :: Templates -> Felt -> Statistics
allPhases tables (Felt areas shares n) =
  Statistics
    tables
    (templatePhases tables)
    id
    ( maybe
        id
        (weighed . correlationsOf tables)
        shares
        (Moments (correlationsOf tables areas) (templateSums tables) (templateSquares tables))
    )
    n

-- | Some of all phases.
atPhases :: Statistics -> [Int] -> Statistics
atPhases statistics@(Statistics tables _ _ (Moments products sums squares) n) phases
  | many tables phases = statistics
  | otherwise = among tables phases momentsOf n
  where
    momentsOf cells = Moments (at cells products) (at cells sums) (at cells squares)
    count = symbolsClasses (templateSymbols tables)
    -- Note [Bounds of cells]
    at cells numbers =
      tabulate count (V.length cells) $ \c ->
        let !start = V.unsafeIndex cells c * count in \k -> V.unsafeIndex numbers (start + k)

-- | The same from the frame, without looking at the numbers of all.
somePhases :: Templates -> Felt -> [Int] -> Statistics
somePhases tables felt@(Felt areas shares n) phases
  | many tables phases = allPhases tables felt
  | otherwise = among tables phases momentsOf n
  where
    momentsOf cells =
      maybe id (\of' -> weighed (productsAt tables of' cells)) shares (momentsAt tables areas cells)

-- | Phases with the moments of their cells, which are given by 'cellIndex'.
among :: Templates -> [Int] -> (Vector Int -> Moments) -> Double -> Statistics
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

-- | Whether so many phases are compared faster together with all others, as are none: then what the
-- frame tells is no number.
many :: Templates -> [Int] -> Bool
many tables phases = null phases || 4 * length phases > phaseTotal (templatePlaces tables)

-- | Everything at a theta.
eStep :: Statistics -> Theta -> Likelihood
eStep (Statistics tables lattices at (Moments products sums squares) n) theta =
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

{- Note [Bounds of classes] The correlations, the sums and the squares of a template all have one
   number for each cell and class. -}

-- | How likely something is as a share of the likeliest, from the logarithms.
relativeTo :: Double -> Double -> Double
relativeTo top l = if l - top < negate negligible then 0 else exp (l - top)

-- | From cells to lattices: the sum over the cells of each.
overPhases :: Phases -> Vector Double -> Vector Double
overPhases lattices !values = V.generate (V.length (phaseBegins lattices) - 1) phase
  where
    phase i = overCells lattices i 0 (\s cell -> s + V.unsafeIndex values cell)

-- | Over the cells of a phase, which are given by their numbers, from a start.
overCells :: Phases -> Int -> s -> (s -> Int -> s) -> s
overCells (Phases _ !begins !cells) i start step = go (V.unsafeIndex begins i) start
  where
    !end = V.unsafeIndex begins (i + 1)
    -- Note [Bounds of cells]
    go !c !s
      | c >= end = s
      | otherwise = go (c + 1) (step s (V.unsafeIndex cells c))
{-# INLINE overCells #-}

{- Note [Bounds of cells] The beginnings have an end, and each lies within the cells; these have
   their numbers in the tables that they are cells of, as phases have theirs among all. -}

-- | Sums over symbols, each as probable as it is: of their correlations, of the templates and of
-- the templates' squares.
data Sums = Sums !Double !Double !Double

-- | By what the phases and the symbols probably are at a theta, the theta that fits them best.
mStep :: Statistics -> Likelihood -> Theta
mStep (Statistics tables lattices _ moments n) given = Theta gain' offset' variance'
  where
    Theta gain offset _ = likelihoodTheta given
    !(Moments products sums squares) = moments
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
    -- The regression of the frame, of mean 0 and variance 1, on the relief.
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
