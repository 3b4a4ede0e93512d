{-# OPTIONS_HADDOCK hide #-}

-- | Information sets of a linear code: places whose letters determine a codeword, each set with the
-- basis of the code that is the unit matrix at these places.
module PraTactile.LinearCode.InformationSet
  ( -- * Sets
    InformationSet,
    informationSets,
    setSize,
    setDeficit,
    setPlaces,
    setRest,
    setMultiples,
    parityRow,

    -- * Words
    agreeingAt,
    combination,
    combinationFrom,
  )
where

import qualified Data.IntSet as IntSet
import Data.List (foldl')
import Data.Maybe (fromMaybe)
import Data.Vector.Primitive (Vector, unsafeIndex)
import qualified Data.Vector.Primitive as Primitive
import PraTactile.Field
import PraTactile.Field.Vector (addScaled, scaleVector)
import PraTactile.LinearCode.Elimination
import PraTactile.LinearCode.Packed

-- | A basis of a code of dimension k that is the unit matrix at k places: its row i has 1 at the
-- set's place i and 0 at its other places. Below, "other places" are those outside the set.
data InformationSet (k :: Field) = InformationSet
  { -- | the number of the set's places that belong to earlier sets
    setDeficit :: !Int,
    -- | the k places, in the order of the rows
    setPlaces :: !(Vector Int),
    -- | the other places, ascending
    setRest :: !(Vector Int),
    -- | the entries of the rows at the other places, row after row
    setParity :: !(Vector (GF k)),
    -- | for each row in turn, those entries times each nonzero element, in the order of 'elements'
    setMultiples :: Packed
  }

type role InformationSet nominal

-- | Information sets of the code of this length that the rows span. All rows must have this length,
-- which is not checked. Each set takes the first independent places that belong to no earlier set,
-- and completes them with places of earlier sets. The last set is made when all codewords are 0 at
-- the places outside the sets.
informationSets :: forall k. KnownField k => Int -> [Row k] -> [InformationSet k]
informationSets size rows = go (IntSet.fromDistinctAscList [0 .. size - 1])
  where
    go free
      | IntSet.null taken = []
      | otherwise = fromBasis (basisSize basis - IntSet.size taken) : go (free IntSet.\\ taken)
      where
        basis = foldl' (include (`IntSet.member` free)) emptyBasis rows
        pivots = map fst (basisRows basis)
        taken = IntSet.fromList pivots `IntSet.intersection` free
        fromBasis deficit =
          InformationSet
            deficit
            (Primitive.fromList pivots)
            rest
            (Primitive.concat parity)
            (packed [scaleVector a x | x <- parity, a <- drop 1 elements])
        parity = map (parityOf . snd) (basisRows basis)
        rest =
          Primitive.fromList
            ( IntSet.toAscList
                (IntSet.fromDistinctAscList [0 .. size - 1] IntSet.\\ IntSet.fromList pivots)
            )
        parityOf x = Primitive.map (unsafeIndex x) rest
    include preferred basis x = fromMaybe basis (extend preferred basis x)

-- | The dimension of the code.
setSize :: InformationSet k -> Int
setSize = Primitive.length . setPlaces

-- | A word minus the codeword that agrees with it at the places of the set, at the other places: 0
-- where word and codeword agree. The word must have the code's length, which is not checked.
agreeingAt :: KnownField k => InformationSet k -> Row k -> Vector (GF k)
agreeingAt set y =
  foldl'
    without
    (Primitive.map (unsafeIndex y) (setRest set))
    (zip [0 ..] (Primitive.toList (setPlaces set)))
  where
    without x (i, place) = addScaled (negate (unsafeIndex y place)) (parityRow set i) x

-- | The entries of the row with this index at the other places.
parityRow :: InformationSet k -> Int -> Vector (GF k)
parityRow set i = Primitive.slice (i * width) width (setParity set)
  where
    width = Primitive.length (setRest set)

-- | The codeword that is this linear combination of rows, by their indices and factors. Each row is
-- listed at most once, which is not checked.
combination :: KnownField k => InformationSet k -> [(Int, GF k)] -> Row k
combination set terms = Primitive.replicate size zero Primitive.// (atPlaces ++ atRest)
  where
    size = setSize set + width
    width = Primitive.length (setRest set)
    atPlaces = [(unsafeIndex (setPlaces set) i, a) | (i, a) <- terms]
    atRest = zip (Primitive.toList (setRest set)) (Primitive.toList sums)
    sums =
      foldl' (\x (i, a) -> addScaled a (parityRow set i) x) (Primitive.replicate width zero) terms

-- | The codeword that agrees with a word at the places of the set, plus this linear combination of
-- rows, by their indices and factors. The word must have the code's length, which is not checked.
combinationFrom :: KnownField k => InformationSet k -> Row k -> [(Int, GF k)] -> Row k
combinationFrom set y terms =
  combination set (zipWith letter [0 ..] (Primitive.toList (setPlaces set)))
  where
    letter i place = (i, unsafeIndex y place + sum [a | (j, a) <- terms, j == i])
