{-# OPTIONS_HADDOCK hide #-}

-- | What the observed cells can hold, at all positions of the array, is a linear code, zero left
-- out: the images of alpha^t under the equations of the cells. This is that code of a set of cells,
-- by their offsets, for decoding where there are too many positions to visit.
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

-- | Of an array and the offsets of some cells.
data ObservedCode (k :: Field) = ObservedCode
  { -- | The array on its surface.
    codeAlgebra :: !(Algebra k),
    -- | The cells, a letter of a codeword each.
    codeOffsets :: [Position],
    -- | Of each cell, if it were zero.
    codeEquations :: [Equation k],
    -- | Independent codewords that span the code.
    codeRows :: [Row k]
  }

type role ObservedCode nominal

-- | The code of cells with these offsets. Refuses too many of them.
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

-- | The dimension of the code: n where no two positions of the array's own surface have the same
-- content.
codeRank :: ObservedCode k -> Int
codeRank = length . codeRows

-- | The solutions for alpha^t of the equations with the letters of a word as values.
wordSolutions :: KnownField k => ObservedCode k -> Row k -> Solutions k
wordSolutions code word = solve n (zipWith valued (codeEquations code) (Primitive.toList word))
  where
    n = primitiveDegree (arrayPrimitive (algebraArray (codeAlgebra code)))
    valued equation a = equation {equationValue = a}

-- | The positions of a word with these solutions; on the sheet those at which all the cells lie on
-- it.
wordPlaces :: KnownField k => ObservedCode k -> Row k -> Solutions k -> [Position]
wordPlaces code word =
  algebraPlaces (codeAlgebra code) (zip (codeOffsets code) (Primitive.toList word))

-- | The same as a list, or that they are too many.
wordListing ::
  KnownField k => ObservedCode k -> Row k -> Solutions k -> Either AlgebraError Listed
wordListing code word =
  algebraListing (codeAlgebra code) (zip (codeOffsets code) (Primitive.toList word))

-- | How many positions have to be looked at to list those of a word with these solutions.
wordVisits :: KnownField k => ObservedCode k -> Solutions k -> Natural
wordVisits code = algebraVisits (codeAlgebra code) (codeOffsets code)

-- | At how many positions the cells lie on the surface.
codePlaces :: ObservedCode k -> Natural
codePlaces code = area (algebraPositions (codeAlgebra code) (codeOffsets code))

-- | Each codeword is at q to this power of positions, zero being one of them as well.
wordFreedom :: ObservedCode k -> Natural
wordFreedom code =
  fromIntegral (primitiveDegree (arrayPrimitive (algebraArray (codeAlgebra code))) - codeRank code)
