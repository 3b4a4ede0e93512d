-- | Linear codes over GF(q), as far as the distances of a mask need them: a lightest codeword, and
-- how many codewords there are of each weight. Internal; "PraTactile.Window.Distance" exports what
-- it means.
module PraTactile.Window.LinearCode
  ( -- * Codes
    LinearCode,
    spannedBy,
    dimension,
    codeLength,
    dual,

    -- * Lightest codewords
    Lightest (..),
    lightest,
    leastWeight,

    -- * Weights
    weights,
    weightsOfDual,
  )
where

import Control.Monad (forM_)
import Data.List (foldl', tails, uncons)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Primitive as Primitive
import qualified Data.Vector.Primitive.Mutable as Mutable
import Numeric.Natural (Natural)
import PraTactile.Field
import PraTactile.Window.Elimination
import PraTactile.Window.InformationSet

-- | The space that some vectors of one length span: that length and a basis.
data LinearCode (k :: Field) = LinearCode !Int !(Basis k)

type role LinearCode nominal

-- | The code of this length that the vectors span.
spannedBy :: KnownField k => Int -> [Row k] -> LinearCode k
spannedBy size =
  LinearCode size . foldl' (\basis x -> fromMaybe basis (extend (const True) basis x)) emptyBasis

-- | The dimension: the number of independent codewords.
dimension :: LinearCode k -> Int
dimension (LinearCode _ basis) = basisSize basis

-- | The number of elements of a codeword.
codeLength :: LinearCode k -> Int
codeLength (LinearCode size _) = size

-- | The vectors that are orthogonal to every codeword. If the basis is the unit matrix at the
-- pivots and P elsewhere, they have a unit matrix elsewhere, and the transpose of -P at the pivots.
dual :: forall k. KnownField k => LinearCode k -> LinearCode k
dual (LinearCode size basis) = spannedBy size (map orthogonal free)
  where
    pivoted = Map.fromList (basisRows basis) :: Map Int (Row k)
    free = filter (`Map.notMember` pivoted) [0 .. size - 1]
    orthogonal j = rowFromList (map (entry j) [0 .. size - 1])
    entry j i = case Map.lookup i pivoted of
      Just x -> negate (Primitive.unsafeIndex x j)
      Nothing -> if i == j then one else zero

-- | The number of elements that are not zero.
weight :: Row k -> Int
weight = Primitive.foldl' (\n a -> if a == zero then n else n + 1) 0

-- | What the search for a lightest codeword found.
data Lightest k
  = -- | A codeword, not zero, and no other is lighter.
    Lightest (Row k)
  | -- | The search was given up: the weight is at least the first number, and at most the second.
    Between Int Int
  | -- | The code has no codeword but zero.
    NoCodeword

{- Note [Brouwer and Zimmermann] The search for a lightest codeword is Note [Disjoint information
   sets] in "PraTactile.Window.InformationSet" with zero as the word: the codewords seen are the
   combinations of few rows of one set, those not seen are not lighter than the sum there. The
   search ends when the lightest codeword seen is no heavier than that. (K.-H. Zimmermann 1996; M.
   Grassl in "Discovering Mathematics with Magma", 2006.) -}

-- | A lightest codeword that is not zero, by the method of Note [Brouwer and Zimmermann]. The
-- search is given up before it has looked at so many codewords.
lightest :: KnownField k => Natural -> LinearCode k -> Lightest k
lightest effort code@(LinearCode size basis)
  | k == 0 = NoCodeword
  | otherwise =
    search effort 0 Nothing (schedule count (informationSets size (map snd (basisRows basis))))
  where
    k = dimension code
    q = fieldOrder code
    -- Up to a factor, and without zero.
    count w = if w == 0 then 0 else changes q k w `div` fromIntegral (q - 1)
    -- All codewords lighter than the bound have been seen.
    search left bound best steps = case steps of
      _ | Just x <- best, weight x <= bound -> Lightest x
      [] -> maybe NoCodeword Lightest best
      step : later
        | stepWords step > left -> Between (max 1 bound) (maybe size weight best)
        | otherwise ->
          search
            (left - stepWords step)
            (maybe size (+ 1) (stepSeen step))
            (foldl' (lighter (stepSet step)) best (stepLevels step))
            later
    lighter set best w = case nearFound (nearAt OneLightest set zeros w (below - 1 - w)) of
      (_, terms) : _ -> Just (combination set terms)
      [] -> best
      where
        zeros = Primitive.map (const zero) (setRest set)
        below = maybe (size + 1) weight best

-- | The least weight of a codeword that is not zero, by 'lightest', or by visiting all codewords
-- where that is shorter. Beyond so many codewords a lower bound. 0 if zero is the only one.
leastWeight :: KnownField k => Natural -> LinearCode k -> Int
leastWeight effort code = case lightest (min effort all') code of
  Lightest x -> weight x
  NoCodeword -> 0
  Between low _
    | all' <= effort -> maybe low fst (Map.lookupMin (Map.delete 0 (weights code)))
    | otherwise -> low
  where
    q = fromIntegral (fieldOrder code) :: Natural
    -- Up to a factor.
    all' = (q ^ dimension code - 1) `div` (q - 1)

binomial :: Int -> Int -> Natural
binomial n k
  | k < 0 || k > n = 0
  | otherwise =
    product (map fromIntegral [n - k + 1 .. n]) `div` product (map fromIntegral [1 .. k])

-- | How many codewords have each weight, by visiting all q^k of them, up to a factor. Weights that
-- do not occur are left out.
weights :: forall k. KnownField k => LinearCode k -> Map Int Natural
weights code@(LinearCode size basis) = Map.insert 0 1 (Map.map (units *) (Map.filter (> 0) counted))
  where
    units = fromIntegral (fieldOrder code - 1)
    counted = Map.fromDistinctAscList (zip [0 ..] (map fromIntegral (Primitive.toList tally)))
    tally = Primitive.create $ do
      counts <- Mutable.replicate (size + 1) (0 :: Int)
      let visit x others = case others of
            [] -> Mutable.modify counts (+ 1) (weight x)
            y : rest -> forM_ (elements :: [GF k]) $ \a -> visit (addScaled a y x) rest
      forM_ (tails (map snd (basisRows basis))) $ mapM_ (uncurry visit) . uncons
      pure counts

-- | How many codewords of the dual code have each weight, from how many the code has of each, its
-- length and q: the identity of MacWilliams, by Krawtchouk's polynomials.
weightsOfDual :: Int -> Int -> Map Int Natural -> Map Int Natural
weightsOfDual q size own =
  Map.filter
    (> 0)
    (Map.fromDistinctAscList [(j, fromInteger (total j `div` codewords)) | j <- [0 .. size]])
  where
    codewords = toInteger (sum (Map.elems own))
    total j = sum [toInteger count * krawtchouk j i | (i, count) <- Map.toList own]
    krawtchouk :: Int -> Int -> Integer
    krawtchouk j i =
      sum
        [ (-1) ^ s
            * toInteger (q - 1) ^ (j - s)
            * toInteger (binomial i s)
            * toInteger (binomial (size - i) (j - s))
          | s <- [0 .. j]
        ]
