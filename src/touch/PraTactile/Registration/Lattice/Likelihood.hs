{-# LANGUAGE BangPatterns #-}

-- | What one frame tells of the lattice of cells under it: the likelihood of every phase of the
-- lattice and of each cell's class. The alphabet and the pitch of the cells are known; the array,
-- the gain, the offset and the noise of the frame are not.
--
-- The symbols do not overlap, so the squared error of a whole lattice is a sum over its cells, and
-- with the classes independent and uniform the likelihood of a phase is a product over them. Gain,
-- offset and noise are found by expectation and maximisation, of which these are the steps.
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

import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import PraTactile.Registration.Lattice.Places
import PraTactile.Registration.Lattice.Symbols (symbolsClasses)
import PraTactile.Registration.Lattice.Template
import PraTactile.Registration.Loops (tabulate)
import PraTactile.Registration.Model

-- | What a frame tells.
data Likelihood = Likelihood
  { likelihoodTables :: !Templates,
    likelihoodTheta :: !Theta,
    -- | How much likelier, as a natural logarithm, a symbol of a class at a place makes the frame
    -- than nothing there: by 'cellIndex' times the number of classes, and the class. There is no
    -- table of these, which would be most of what is kept of a frame, and few are asked for.
    classLog :: Int -> Double,
    -- | The same for a cell whose class is not known, by 'cellIndex'.
    cellLogs :: !(Vector Double),
    -- | The same for a whole lattice: by orientation, and the row and the column of places, modulo
    -- the pitch, of its cells.
    phaseLogs :: !(Vector Double),
    -- | The logarithm of the frame's probability density, standardised to variance 1.
    logDensity :: !Double
  }

-- | What theta is found from: the tables, some phases of the lattice with their cells, the moments
-- of these, <z, T> of a single one of them, and N, how many taxels count.
data Statistics = Statistics !Templates Phases Moments (Int -> Double) !Double

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
    ( maybe
        id
        (weighed . correlationsOf tables)
        shares
        (Moments (correlationsOf tables areas) (templateSums tables) (templateSquares tables))
    )
    (correlationAt tables areas)
    n

-- | Some of all phases.
atPhases :: Statistics -> [Int] -> Statistics
atPhases statistics@(Statistics tables _ (Moments products sums squares) _ n) phases
  | many tables phases = statistics
  | otherwise = among tables here (Moments (at products) (at sums) (at squares)) n
  where
    (here, cells) = renumbered (phasesOf (templatePlaces tables) phases)
    count = symbolsClasses (templateSymbols tables)
    -- Note [Bounds of cells]
    at numbers =
      tabulate count (V.length cells) $ \c ->
        let !start = V.unsafeIndex cells c * count in \k -> V.unsafeIndex numbers (start + k)

-- | The same from the frame, without looking at the numbers of all.
somePhases :: Statistics -> Felt -> [Int] -> Statistics
somePhases statistics@(Statistics tables _ _ _ n) (Felt areas shares _) phases
  | many tables phases = statistics
  | otherwise = among tables here (weighedHere (momentsAt tables areas cells)) n
  where
    (here, cells) = renumbered (phasesOf (templatePlaces tables) phases)
    weighedHere = maybe id (\of' -> weighed (productsAt tables of' cells)) shares

-- | Phases with the moments of their cells.
among :: Templates -> Phases -> Moments -> Double -> Statistics
among tables here moments@(Moments products _ _) =
  Statistics tables here moments (V.unsafeIndex products)

-- | Whether so many phases are compared faster together with all others, as are none: then what the
-- frame tells is no number.
many :: Templates -> [Int] -> Bool
many tables phases = null phases || 4 * length phases > phaseTotal (templatePlaces tables)

-- | The cells of phases numbered from 0 on, as they come, and what they were.
renumbered :: Phases -> (Phases, Vector Int)
renumbered phases = (phases {phaseCells = V.enumFromN 0 (V.length cells)}, cells)
  where
    cells = phaseCells phases

-- | Everything at a theta.
eStep :: Statistics -> Theta -> Likelihood
eStep (Statistics tables lattices moments product' n) theta@(Theta _ offset variance) =
  Likelihood tables theta (\i -> classOf weights sums squares (product' i) i) cells phases total
  where
    !(Moments products sums squares) = moments
    !weights = weightsOf theta
    count = symbolsClasses (templateSymbols tables)
    cells = V.generate (V.length products `quot` count) $ \c ->
      cellLog
        count
        (\k -> let i = c * count + k in classOf weights sums squares (V.unsafeIndex products i) i)
    phases = overPhases lattices cells
    top = V.maximum phases
    total =
      top
        + log
          ( V.sum (V.map (relativeTo top) phases)
              / fromIntegral (phaseTotal (templatePlaces tables))
          )
        - n * (1 + offset * offset) / (2 * variance)
        - n / 2 * log (2 * pi * variance)

-- | What <z, T> adds to l_k at a theta, and what sum T and sum T^2 take from it.
data Weights = Weights !Double !Double !Double

weightsOf :: Theta -> Weights
weightsOf (Theta gain offset variance) =
  Weights (gain / variance) (gain * offset / variance) (gain * gain / (2 * variance))

-- | l_k, from the templates' sums and the sums of their squares, and <z, T> of one of them with its
-- place among these.
classOf :: Weights -> Vector Double -> Vector Double -> Double -> Int -> Double
classOf (Weights ofProducts ofSums ofSquares) sums squares y i =
  -- Note [Bounds of classes]
  ofProducts * y - ofSums * V.unsafeIndex sums i - ofSquares * V.unsafeIndex squares i
{-# INLINE classOf #-}

{- Note [Bounds of classes] The correlations, the sums and the squares of a template all have one
   number for each cell and class. -}

-- | How likely something is as a share of the likeliest, from the logarithms.
relativeTo :: Double -> Double -> Double
relativeTo top l = if l - top < negate negligible then 0 else exp (l - top)

-- | From cells to lattices: the sum over the cells of each.
overPhases :: Phases -> Vector Double -> Vector Double
overPhases lattices values = V.generate (V.length (phaseBegins lattices) - 1) phase
  where
    phase i = overCells lattices i 0 (\s cell -> s + V.unsafeIndex values cell)

-- | Over the cells of a phase, which are given by their numbers, from a start.
overCells :: Phases -> Int -> s -> (s -> Int -> s) -> s
overCells (Phases _ begins cells) i start step = go (V.unsafeIndex begins i) start
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

-- | By what the phases and the symbols probably are at a theta, the theta that fits them best.
mStep :: Statistics -> Likelihood -> Theta
mStep (Statistics tables lattices moments _ n) given = Theta gain' offset' variance'
  where
    Theta gain offset _ = likelihoodTheta given
    Moments products sums squares = moments
    count = symbolsClasses (templateSymbols tables)
    share = classPrior count
    !ofMoments = weightsOf (likelihoodTheta given)
    phases = phaseLogs given
    top = V.maximum phases
    weights = V.map (relativeTo top) phases
    total = V.sum weights
    Sums sumY sumT sumTT = V.ifoldl' phase (Sums 0 0 0) weights
    phase found i weight
      | weight < 1e-6 * total = found
      | otherwise = overCells lattices i found $ \(Sums a b c) cell ->
        let Sums a' b' c' = symbols (cell * count) (V.unsafeIndex (cellLogs given) cell)
         in Sums (a + weight * a') (b + weight * b') (c + weight * c')
    symbols start cell = go 0 (Sums 0 0 0)
      where
        go :: Int -> Sums -> Sums
        go !k found@(Sums a b c)
          | k >= count = found
          | otherwise =
            let i = start + k
                p = share * exp (classOf ofMoments sums squares (V.unsafeIndex products i) i - cell)
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
