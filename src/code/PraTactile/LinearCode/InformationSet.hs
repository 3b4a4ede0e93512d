{-# OPTIONS_HADDOCK hide #-}

-- | Information sets of a linear code: places whose letters determine a codeword, with the basis
-- that is the unit matrix there.
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

-- | A basis of a code of dimension k which at k places, one a row, is the unit matrix.
data InformationSet (k :: Field) = InformationSet
  { -- | how many of those places belong to sets before this one
    setDeficit :: !Int,
    -- | the k places, by rows
    setPlaces :: !(Vector Int),
    -- | all other places, ascending
    setRest :: !(Vector Int),
    -- | the rows at the other places, one row after the other
    setParity :: !(Vector (GF k)),
    -- | the same times every element but zero: all multiples of one row after the other
    setMultiples :: Packed
  }

type role InformationSet nominal

-- | Information sets of the code of this length that some rows span; the places of each that do not
-- belong to sets before it are disjoint from them, and there are as many sets as there are places
-- for. Each takes the first places that it can: those that do not depend on places before them.
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

-- | How a word differs at the other places from the codeword that agrees with it at the places of
-- the set.
agreeingAt :: KnownField k => InformationSet k -> Row k -> Vector (GF k)
agreeingAt set y =
  foldl'
    without
    (Primitive.map (unsafeIndex y) (setRest set))
    (zip [0 ..] (Primitive.toList (setPlaces set)))
  where
    without x (i, place) = addScaled (negate (unsafeIndex y place)) (parityRow set i) x

-- | One of the rows at the other places.
parityRow :: InformationSet k -> Int -> Vector (GF k)
parityRow set i = Primitive.slice (i * width) width (setParity set)
  where
    width = Primitive.length (setRest set)

-- | The codeword that is this combination of rows, as long as the code.
combination :: KnownField k => InformationSet k -> [(Int, GF k)] -> Row k
combination set terms = Primitive.replicate size zero Primitive.// (atPlaces ++ atRest)
  where
    size = setSize set + width
    width = Primitive.length (setRest set)
    atPlaces = [(unsafeIndex (setPlaces set) i, a) | (i, a) <- terms]
    atRest = zip (Primitive.toList (setRest set)) (Primitive.toList sums)
    sums =
      foldl' (\x (i, a) -> addScaled a (parityRow set i) x) (Primitive.replicate width zero) terms

-- | The codeword that agrees with a word at the places of the set, with this combination of rows
-- added.
combinationFrom :: KnownField k => InformationSet k -> Row k -> [(Int, GF k)] -> Row k
combinationFrom set y terms =
  combination set (zipWith letter [0 ..] (Primitive.toList (setPlaces set)))
  where
    letter i place = (i, unsafeIndex y place + sum [a | (j, a) <- terms, j == i])
