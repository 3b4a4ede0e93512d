{-# OPTIONS_HADDOCK hide #-}

-- | The arrays that are not ours but as ours: of the same field, degree, folding and shape, by each
-- other primitive polynomial. 'worthOfOthers' bounds how likely they make the observed cells, from
-- all of these arrays or from some that are drawn; docs/explanation/locating.md has the formulas.
--
-- The other arrays need no other polynomial. Every m-sequence of the period N = q^n - 1 is, but for
-- where it begins, a decimation s(0), s(r), s(2 r), ... of ours with r coprime to N, and two are of
-- the same polynomial if and only if their r are the same but for a factor q^i modulo N (N. Zierler
-- 1959). So there are phi(N)/n - 1 others.
module PraTactile.Locate.OtherArrays
  ( OtherArrays,
    otherArrays,
    worthOfOthers,

    -- * Parts of it
    decimations,
    upperLimit,
  )
where

import Data.Bits (shiftL, (.|.))
import Data.List (foldl', genericLength, sortOn)
import Data.Map.Lazy (Map)
import qualified Data.Map.Lazy as Map
import Data.Maybe (fromMaybe)
import Data.Ord (Down (..))
import qualified Data.Set as Set
import qualified Data.Vector.Primitive as Primitive
import Data.Word (Word64)
import Numeric (log1mexp)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Extension
import PraTactile.Field
import PraTactile.LinearCode.Elimination
import PraTactile.Locate.Belief
import PraTactile.Locate.Logarithm
import PraTactile.Locate.Patch
import PraTactile.Polynomial
import PraTactile.Polynomial.Search (splitMix)
import PraTactile.Probability
import PraTactile.Symmetry
import PraTactile.Window.Rank

-- | The others of an array, as many as are compared; made once, when first needed.
data OtherArrays (k :: Field) = OtherArrays
  { -- | our polynomial
    ownPrimitive :: Primitive k,
    -- | all others, or some that are drawn; none where there is no other array
    comparedOthers :: [OtherArray k],
    -- | whether these are all
    allCompared :: Bool
  }

type role OtherArrays nominal

-- | Another array: the powers of our root by which it goes on from row to row and from column to
-- column.
data OtherArray (k :: Field) = OtherArray (Residue k) (Residue k)

type role OtherArray nominal

-- | The others of an array: all of them if they are few, else some by a fixed seed. O(1).
otherArrays :: KnownField k => ArrayOn k -> OtherArrays k
otherArrays (ArrayOn _ array) =
  OtherArrays
    { ownPrimitive = h,
      comparedOthers =
        [ OtherArray (alphaTo (Position 1 0) r) (alphaTo (Position 0 1) r)
          | r <- if few then every else take most (drawnDecimations q terms)
        ],
      allCompared = few
    }
  where
    h = arrayPrimitive array
    terms = period h
    q = fromIntegral (fieldOrder array)
    few = terms <= smallPeriod && null (drop most every)
    every = decimations q terms
    most = mostCompared h
    alphaTo at r = powerOfRoot h (r * sequenceIndex array at `mod` terms)

-- | 2^15: up to so many terms the others are counted. Of more terms there are nearly always more
-- than 'mostCompared'.
smallPeriod :: Natural
smallPeriod = 2 ^ (15 :: Int)

-- | How many other arrays are compared: 1024, and fewer of degrees above 64, where each takes
-- longer.
mostCompared :: Primitive k -> Int
mostCompared h = max 16 (min 1024 (2 ^ (28 :: Int) `div` (n * n * n)))
  where
    n = primitiveDegree h

-- | The cells as they lie upright if they are seen in this symmetry.
seenIn :: Symmetry -> Patch a -> [(Position, a)]
seenIn o seen =
  [(onPosition (invert o) (patchShape seen) offset, a) | (offset, a) <- observedCells seen]

-- | The r of all other arrays, the least of each polynomial, ascending; given q and N.
--
-- >>> decimations 4 15
-- [2,7,11]
decimations :: Natural -> Natural -> [Natural]
decimations q terms = map fromIntegral (filter leads [2 .. n - 1])
  where
    n = fromIntegral terms :: Int
    q' = fromIntegral (q `mod` terms)
    leads r = gcd r n == 1 && all (>= r) (conjugates q' n r)

-- | r, r q, r q^2, ... modulo N: by all of these the decimations are of one polynomial. Given q and
-- N, to which both are coprime, and r.
conjugates :: Integral a => a -> a -> a -> [a]
conjugates q terms r = r : takeWhile (/= r) (drop 1 (iterate (\x -> x * q `mod` terms) r))

-- | An endless list of decimations that lead to other arrays, drawn independently and uniformly by
-- a fixed seed. Given q and N, for which there must be another array.
drawnDecimations :: Natural -> Natural -> [Natural]
drawnDecimations q terms = filter other (go (splitMix drawingSeed))
  where
    words' = length (takeWhile (> 0) (iterate (`div` 2 ^ (64 :: Int)) terms)) + 1
    go drawn = let (these, rest) = splitAt words' drawn in number these `mod` terms : go rest
    number = foldl' (\n w -> (n `shiftL` 64) .|. fromIntegral w) 0
    other r = gcd r terms == 1 && r `notElem` ours
    ours = conjugates q terms 1

-- | The seed by which arrays are drawn.
drawingSeed :: Word64
drawingSeed = 1959

-- | Bounds from above, as a logarithm, how likely another array makes the observed cells: their
-- likelihoods summed over the possible symmetries and all positions, in the mean of all other
-- arrays. 'Nothing' if there is no other array. O(m n^2) for m cells, each array and each symmetry.
--
-- In each symmetry, and for each array, the surest independent cells are taken. All contents of
-- these are equally frequent; the likeliest one determines the other cells, and for all other
-- contents these have at most their likeliest symbols. Of arrays that were drawn the mean is
-- replaced by the upper limit of its confidence.
worthOfOthers :: KnownField k => OtherArrays k -> [Symmetry] -> Patch (Belief k) -> Maybe Double
worthOfOthers others possible seen
  | null (comparedOthers others) = Nothing
  | otherwise = Just (logSum (map inSymmetry possible))
  where
    h = ownPrimitive others
    size = naturalLogarithm (period h + 1)
    -- What each array has in the cells that are seen in any symmetry.
    contents = map (vectorsOf h places) (comparedOthers others)
    places = Set.toAscList (Set.fromList [at | o <- possible, (at, _) <- seenIn o seen])
    inSymmetry o
      | isInfinite shown = shown
      | otherwise = shown + size + largest + log (expected relative)
      where
        cells = sortOn (Down . cellBest) (map (cellIn o) (seenIn o seen))
        shown = sum [log (symmetryChance o b) | (_, b) <- observedCells seen]
        bounds = [boundedBy h vectors cells | vectors <- contents]
        -- Relative to the most that an array of those ranks could have.
        largest = maximum [negate rank | (rank, _) <- bounds]
        relative = [exp (share - rank - largest) | (rank, share) <- bounds]
    expected xs
      | allCompared others = mean xs
      | otherwise = upperLimit (length xs) (mean xs)
    mean xs = sum xs / genericLength xs

-- | A cell in a symmetry: where it is upright, its likeliest symbol and how probable that is, and
-- how probable each symbol is.
data CellIn (k :: Field) = CellIn
  { cellAt' :: Position,
    cellLikeliest :: GF k,
    cellBest :: Double,
    cellChances :: Primitive.Vector Double
  }

type role CellIn nominal

cellIn :: KnownField k => Symmetry -> (Position, Belief k) -> CellIn k
cellIn o (at, b) = CellIn at (either (const zero) id (fromCode best)) (given Primitive.! best) given
  where
    given = Primitive.map (/ symmetryChance o b) (probabilitiesIn o b)
    best = Primitive.maxIndex given

-- | The elements of GF(q^n) at which cells of another array lie, by the cells.
vectorsOf :: KnownField k => Primitive k -> [Position] -> OtherArray k -> Map Position (Row k)
vectorsOf h places (OtherArray down right') =
  Map.fromDistinctAscList
    (zip places (gridVectors h (powerOfResidue h down) (powerOfResidue h right') places))

-- | For one other array: the logarithm of q to the rank of the cells, and the logarithm of a bound,
-- at most 1, of the probability of its contents that agree.
boundedBy :: KnownField k => Primitive k -> Map Position (Row k) -> [CellIn k] -> (Double, Double)
boundedBy h vectors cells =
  (fromIntegral (basisSize basis) * log (fromIntegral (fieldOrder h)), logSum [agreeing, others])
  where
    n = primitiveDegree h
    Walked basis sure told most =
      foldl' include (Walked emptyBasis 0 0 0) [(c, v) | c <- cells, Just v <- [vectorOf c]]
    vectorOf cell = Map.lookup (cellAt' cell) vectors
    agreeing = sure + told
    -- 1 less the probability of the likeliest content of the independent cells.
    others = log1mexp sure + most
    include (Walked known sureSoFar toldSoFar mostSoFar) (cell, vector)
      -- No row is independent any more, and what agrees is nothing in the sum, nor becomes more in
      -- it: a cell is as probable as its best symbol at most.
      | basisSize known == n
          && sureSoFar + toldSoFar < log1mexp sureSoFar + mostSoFar - 40 =
        Walked known sureSoFar toldSoFar (mostSoFar + log (cellBest cell))
      | Primitive.all (== zero) (Primitive.take n rest) =
        Walked known sureSoFar (toldSoFar + log predicted) (mostSoFar + log (cellBest cell))
      | otherwise =
        Walked
          (fromMaybe known (extend (< n) known rest))
          (sureSoFar + log (cellBest cell))
          toldSoFar
          mostSoFar
      where
        rest = reduced known (Primitive.snoc vector (cellLikeliest cell))
        -- The last element is the likeliest symbol less the one that the others tell.
        predicted = cellChances cell Primitive.! toCode (cellLikeliest cell - rest Primitive.! n)

-- | The cells that were gone through: those that are independent, the logarithm of the product of
-- their best probabilities, that of what the others have as these tell, and of the best that they
-- could have.
data Walked k = Walked (Basis k) !Double !Double !Double

-- | The upper limit, with a confidence of 99 %, of the expectation of numbers from 0 to 1 of which
-- so many have this mean x: the p >= x at which exp (-count D) is 0.01, D being the divergence
-- x log (x/p) + (1 - x) log ((1 - x)/(1 - p)) (W. Hoeffding 1963, theorem 1). Of none it is 1.
--
-- >>> abs (upperLimit 1024 0 - (1 - 0.01 ** (1 / 1024))) < 1e-9
-- True
upperLimit :: Int -> Double -> Double
upperLimit count x
  | count == 0 || x >= 1 = 1
  | otherwise = go (60 :: Int) x 1
  where
    go steps low high
      | steps == 0 = high
      | fromIntegral count * divergence middle >= log 100 = go (steps - 1) low middle
      | otherwise = go (steps - 1) middle high
      where
        middle = (low + high) / 2
    divergence p = part x p + part (1 - x) (1 - p)
    part a b = if a <= 0 then 0 else a * log (a / b)
