{-# LANGUAGE DataKinds #-}
{-# LANGUAGE KindSignatures #-}

-- | The window property by algebra, for arrays of any size. The cell at offset (i, j) from the
-- position of the term s(t) holds s(t + e(i, j)), and s(t) is a linear function of alpha^t, none
-- but zero of which is zero for all t. So the window's content is a linear function of alpha^t,
-- which tells all of them apart iff the alpha^e(i, j) span GF(q^n) over GF(q).
module PraTactile.Window.Rank
  ( windowRank
  , rankOf
  , windowsOfRank
  ) where

import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Extension
import PraTactile.Field
import PraTactile.Polynomial
import PraTactile.Window

-- | The rank over GF(q) of the alpha^e(i, j), (i, j) the cells of the mask: at most n. The windows
-- of the 'naturalSurface' are distinct iff it is n; those of the sheet if it is n.
windowRank :: KnownField k => PseudorandomArray k -> Mask -> Natural
windowRank array mask = rankOf (map (residueCoefficients h . alphaTo) (maskOffsets mask))
 where
  alphaTo = powerOfRoot h . sequenceIndex array
  h = arrayPrimitive array

-- | The rank of a matrix over GF(q), given by rows of one length, by elimination without division.
rankOf :: KnownField k => [[GF k]] -> Natural
rankOf matrix = case break ((/= zero) . fst) split of
  (_, []) | null split -> 0
          | otherwise -> rankOf (map snd split)
  (before, (pivot, pivotRow) : after) ->
    1 + rankOf [zipWith (\x y -> pivot * x - a * y) r pivotRow | (a, r) <- before ++ after]
 where
  -- Each row as its first element and the rest.
  split = [(a, r) | a : r <- matrix]

-- | How many distinct windows there are on the 'naturalSurface' when the rank is this. As alpha^t
-- runs through the q^n - 1 non-zero elements, the content runs through the image of a linear map of
-- rank r without the image of zero: for r = n that is q^n - 1 contents; for r < n some non-zero
-- element has the image of zero as well, and it is q^r.
windowsOfRank :: KnownField k => PseudorandomArray k -> Natural -> Natural
windowsOfRank array r
  | r == fromIntegral (primitiveDegree h) = period h
  | otherwise = fromIntegral (fieldOrder array) ^ r
 where
  h = arrayPrimitive array
