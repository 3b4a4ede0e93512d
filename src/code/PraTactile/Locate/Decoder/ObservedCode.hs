{-# OPTIONS_HADDOCK hide #-}

-- | The code of observed cells, for decoders that cannot try all positions. Over all positions of
-- the array, the contents of some cells are the nonzero words of a linear code: the images of
-- alpha^t under the cells' equations.
module PraTactile.Locate.Decoder.ObservedCode
  ( -- * Codes
    ObservedCode,
    observedCode,
    codeAlgebra,
    codeOffsets,
    codeRank,
    codeRows,
    codePlaces,

    -- * From words to positions
    wordSolutions,
    wordPlaces,
    wordListing,
    wordVisits,
    wordFreedom,
  )
where

import Data.List (transpose)
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.LinearCode.Elimination
import PraTactile.Locate.Decoder.Algebra
import PraTactile.Locate.Decoder.Equations
import PraTactile.Polynomial

-- | The code of the cells with some offsets in an array.
data ObservedCode (k :: Field) = ObservedCode
  { -- | The array on its surface.
    codeAlgebra :: !(Algebra k),
    -- | The offsets of the cells, one for each letter of a codeword.
    codeOffsets :: [Position],
    -- | The equation of each cell, with value zero.
    codeEquations :: [Equation k],
    -- | Independent codewords that span the code.
    codeRows :: [Row k]
  }

type role ObservedCode nominal

-- | The code of cells with these offsets. Refuses too many cells.
observedCode :: KnownField k => Algebra k -> [Position] -> Either AlgebraError (ObservedCode k)
observedCode algebra offsets = do
  given <-
    either
      (Left . AlgebraCells)
      Right
      (equations (algebraArray algebra) [(offset, zero) | offset <- offsets])
  let spanning = map rowFromList (transpose (map equationFactors given))
      independent = independentRows maxBound spanning
  pure
    (ObservedCode algebra offsets given [x | (i, x) <- zip [0 ..] spanning, i `elem` independent])

-- | The dimension of the code. It is n if all positions of the array's natural surface have
-- different contents.
codeRank :: ObservedCode k -> Int
codeRank = length . codeRows

-- | The solutions for alpha^t of the equations, with the letters of a word as values.
wordSolutions :: KnownField k => ObservedCode k -> Row k -> Solutions k
wordSolutions code word = solve n (zipWith valued (codeEquations code) (Primitive.toList word))
  where
    n = primitiveDegree (arrayPrimitive (algebraArray (codeAlgebra code)))
    valued equation a = equation {equationValue = a}

-- | The positions of a word with these solutions. On the sheet, only positions with all cells on it
-- count.
wordPlaces :: KnownField k => ObservedCode k -> Row k -> Solutions k -> [Position]
wordPlaces code word =
  algebraPlaces (codeAlgebra code) (zip (codeOffsets code) (Primitive.toList word))

-- | The positions of a word with these solutions as a list, or 'More' if there are too many.
wordListing ::
  KnownField k => ObservedCode k -> Row k -> Solutions k -> Either AlgebraError Listed
wordListing code word =
  algebraListing (codeAlgebra code) (zip (codeOffsets code) (Primitive.toList word))

-- | The number of positions that must be tried to list those of a word with these solutions.
wordVisits :: KnownField k => ObservedCode k -> Solutions k -> Natural
wordVisits code = algebraVisits (codeAlgebra code) (codeOffsets code)

-- | The number of positions for which the cells lie on the surface.
codePlaces :: ObservedCode k -> Natural
codePlaces code = area (algebraPositions (codeAlgebra code) (codeOffsets code))

-- | The exponent d for which each codeword belongs to q^d elements: positions, and zero for the
-- zero word.
wordFreedom :: ObservedCode k -> Natural
wordFreedom code =
  fromIntegral (primitiveDegree (arrayPrimitive (algebraArray (codeAlgebra code))) - codeRank code)
