{-# OPTIONS_HADDOCK hide #-}

-- | The arrays like ours with the same field, degree, folding and shape that other primitive
-- polynomials make. 'evidenceOfOthers' bounds their likelihood for the observed cells, from all of
-- them or from a random sample; docs/explanation/locating.md has the formulas.
--
-- The other arrays are computed from our own polynomial. Every m-sequence of period N = q^n - 1 is,
-- up to its starting point, a decimation s(0), s(r), s(2 r), ... of ours with r coprime to N. Two
-- of them have the same polynomial if and only if their r differ by a factor q^i modulo N (N.
-- Zierler 1959). So there are phi(N)/n - 1 other arrays.
module PraTactile.Locate.OtherArrays
  ( OtherArrays,
    otherArrays,
    evidenceOfOthers,

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

-- | The other arrays that are compared; computed once, when first needed.
data OtherArrays (k :: Field) = OtherArrays
  { -- | our polynomial
    ownPrimitive :: Primitive k,
    -- | all others, or a random sample; empty if there is no other array
    comparedOthers :: [OtherArray k],
    -- | whether these are all the others
    allCompared :: Bool
  }

type role OtherArrays nominal

-- | Another array: the powers of our root that take it from row to row and from column to column.
data OtherArray (k :: Field) = OtherArray (Residue k) (Residue k)

type role OtherArray nominal

-- | The other arrays: all of them if they are few, else a sample drawn with a fixed seed. O(1).
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

-- | 2^15: up to this period the other arrays are counted. Above it there are nearly always more
-- than 'mostCompared'.
smallPeriod :: Natural
smallPeriod = 2 ^ (15 :: Int)

-- | The number of other arrays that are compared: 1024, and fewer for degrees above 64, where each
-- takes longer.
mostCompared :: Primitive k -> Int
mostCompared h = max 16 (min 1024 (2 ^ (28 :: Int) `div` (n * n * n)))
  where
    n = primitiveDegree h

-- | The cells of a patch that is seen in this symmetry, with their upright offsets.
seenIn :: Symmetry -> Patch a -> [(Position, a)]
seenIn o seen =
  [(onPosition (invert o) (patchShape seen) offset, a) | (offset, a) <- observedCells seen]

-- | The decimations r of all other arrays, the smallest for each polynomial, ascending. Arguments:
-- q and N.
--
-- >>> decimations 4 15
-- [2,7,11]
decimations :: Natural -> Natural -> [Natural]
decimations q terms = map fromIntegral (filter leads [2 .. n - 1])
  where
    n = fromIntegral terms :: Int
    q' = fromIntegral (q `mod` terms)
    leads r = gcd r n == 1 && all (>= r) (conjugates q' n r)

-- | r, r q, r q^2, ... modulo N: the decimations with one polynomial. Arguments: q, N and r; q and
-- r must be coprime to N.
conjugates :: Integral a => a -> a -> a -> [a]
conjugates q terms r = r : takeWhile (/= r) (drop 1 (iterate (\x -> x * q `mod` terms) r))

-- | An endless list of decimations of other arrays, drawn independently and uniformly with a fixed
-- seed. Arguments: q and N, for which another array must exist.
drawnDecimations :: Natural -> Natural -> [Natural]
drawnDecimations q terms = filter other (go (splitMix drawingSeed))
  where
    words' = length (takeWhile (> 0) (iterate (`div` 2 ^ (64 :: Int)) terms)) + 1
    go drawn = let (these, rest) = splitAt words' drawn in number these `mod` terms : go rest
    number = foldl' (\n w -> (n `shiftL` 64) .|. fromIntegral w) 0
    other r = gcd r terms == 1 && r `notElem` ours
    ours = conjugates q terms 1

-- | The seed for drawing arrays.
drawingSeed :: Word64
drawingSeed = 1959

-- | An upper bound, as a logarithm, on the likelihood of another array for the observed cells:
-- summed over the possible symmetries and all positions, averaged over the other arrays. 'Nothing'
-- if there is no other array. O(m n^2) for m cells, each array and each symmetry.
--
-- For each symmetry and array, the surest independent cells are taken. All their contents are
-- equally frequent. The likeliest content determines the other cells; for any other content, these
-- have at most their likeliest symbols. For a sample of arrays, the mean is replaced by its upper
-- confidence limit.
evidenceOfOthers :: KnownField k => OtherArrays k -> [Symmetry] -> Patch (Belief k) -> Maybe Double
evidenceOfOthers others possible seen
  | null (comparedOthers others) = Nothing
  | otherwise = Just (logSum (map inSymmetry possible))
  where
    h = ownPrimitive others
    size = naturalLogarithm (period h + 1)
    -- The content of each array in the cells that are seen in any symmetry.
    contents = map (vectorsOf h places) (comparedOthers others)
    places = Set.toAscList (Set.fromList [at | o <- possible, (at, _) <- seenIn o seen])
    inSymmetry o
      | isInfinite shown = shown
      | otherwise = shown + size + largest + log (expected relative)
      where
        cells = sortOn (Down . cellBest) (map (cellIn o) (seenIn o seen))
        shown = sum [log (symmetryChance o b) | (_, b) <- observedCells seen]
        bounds = [boundedBy h vectors cells | vectors <- contents]
        -- Relative to the largest value that an array with those ranks could have.
        largest = maximum [negate rank | (rank, _) <- bounds]
        relative = [exp (share - rank - largest) | (rank, share) <- bounds]
    expected xs
      | allCompared others = mean xs
      | otherwise = upperLimit (length xs) (mean xs)
    mean xs = sum xs / genericLength xs

-- | A cell in a symmetry: its upright offset, its likeliest symbol with that symbol's probability,
-- and the probabilities of all symbols.
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

-- | The elements of GF(q^n) at the cells of another array.
vectorsOf :: KnownField k => Primitive k -> [Position] -> OtherArray k -> Map Position (Row k)
vectorsOf h places (OtherArray down right') =
  Map.fromDistinctAscList
    (zip places (gridVectors h (powerOfResidue h down) (powerOfResidue h right') places))

-- | For one other array: the logarithm of q to the rank of the cells, and the logarithm of a bound,
-- at most 1, on the probability of the contents that agree.
boundedBy :: KnownField k => Primitive k -> Map Position (Row k) -> [CellIn k] -> (Double, Double)
boundedBy h vectors cells =
  (fromIntegral (basisSize basis) * log (fromIntegral (fieldOrder h)), logSum [agreeing, others])
  where
    n = primitiveDegree h
    Walked basis sure told most =
      foldl' include (Walked emptyBasis 0 0 0) [(c, v) | c <- cells, Just v <- [vectorOf c]]
    vectorOf cell = Map.lookup (cellAt' cell) vectors
    agreeing = sure + told
    -- 1 minus the probability of the likeliest content of the independent cells.
    others = log1mexp sure + most
    include (Walked known sureSoFar toldSoFar mostSoFar) (cell, vector)
      -- All further rows are dependent. The agreeing term is negligible in the sum and can only
      -- become smaller, since a cell is at most as probable as its best symbol.
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
        -- The last element is the likeliest symbol minus the one that the others determine.
        predicted = cellChances cell Primitive.! toCode (cellLikeliest cell - rest Primitive.! n)

-- | The state after some cells: the independent ones, the log-product of their best probabilities,
-- that of the dependent cells' determined symbols, and that of the dependent cells' best symbols.
data Walked k = Walked (Basis k) !Double !Double !Double

-- | The upper confidence limit, at 99 %, of the mean of numbers in 0 to 1, given their count and
-- their sample mean x. It is the p >= x at which exp (-count D) is 0.01, where D is the divergence
-- x log (x/p) + (1 - x) log ((1 - x)/(1 - p)) (W. Hoeffding 1963, theorem 1). For a count of 0 it
-- is 1.
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
