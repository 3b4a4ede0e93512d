{-# OPTIONS_HADDOCK hide #-}

-- | Small matrices, as lists of rows.
module PraTactile.Pose.Matrix
  ( Matrix,
    times,
    applied,
    plus,
    scaled,
    diagonal,
    propagated,
    inverse,
  )
where

import Data.List (maximumBy, transpose)
import Data.Ord (comparing)

-- | Rows, all of one length.
type Matrix = [[Double]]

-- | The product of two matrices. The first must have as many columns as the second has rows.
times :: Matrix -> Matrix -> Matrix
times a b = [[sum (zipWith (*) line column) | column <- transpose b] | line <- a]

-- | The product of a matrix and a column of as many numbers as the matrix has columns.
applied :: Matrix -> [Double] -> [Double]
applied a v = map (sum . zipWith (*) v) a

-- | The sum of two matrices of one size.
plus :: Matrix -> Matrix -> Matrix
plus = zipWith (zipWith (+))

-- | All entries times a number.
scaled :: Double -> Matrix -> Matrix
scaled k = map (map (k *))

-- | The matrix with this diagonal, 0 elsewhere.
diagonal :: [Double] -> Matrix
diagonal values =
  [[if i == j then v else 0 | j <- [1 .. length values]] | (i, v) <- zip [1 ..] values]

-- | J C J^T: the covariance of J x, given the covariance C of x.
propagated :: Matrix -> Matrix -> Matrix
propagated j c = j `times` c `times` transpose j

-- | The inverse of a square matrix by Gauss-Jordan elimination, with the largest pivot in each
-- column. 'Nothing' if a pivot is less than 1e-12 of the largest entry, if all entries are 0, or if
-- one is not a finite number.
inverse :: Matrix -> Maybe Matrix
inverse a
  | largest > 0 && not (isNaN largest) && not (isInfinite largest) =
    map (drop n) <$> eliminated 0 (zipWith (++) a (diagonal (replicate n 1)))
  | otherwise = Nothing
  where
    n = length a
    largest = maximum (0 : map abs (concat a))
    eliminated column lines'
      | column >= n = Just lines'
      | abs pivot < 1e-12 * largest = Nothing
      | otherwise = eliminated (column + 1) (map cleared above ++ [unit] ++ map cleared below)
      where
        (above, rest) = splitAt column lines'
        best = snd (maximumBy (comparing (abs . at . fst)) (zip rest [0 :: Int ..]))
        (chosen, below) = case splitAt best rest of
          (before, line : after) -> (line, before ++ after)
          (before, []) -> ([], before)
        at line = sum (take 1 (drop column line))
        pivot = at chosen
        unit = map (/ pivot) chosen
        cleared line = zipWith (\x u -> x - at line * u) line unit
