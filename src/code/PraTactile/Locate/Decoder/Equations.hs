{-# OPTIONS_HADDOCK hide #-}

-- | Observed cells as linear equations over GF(q) for a position. At the position of the term s(t),
-- the cell at offset (i, j) holds s(t + e(i, j)), with e as in "PraTactile.Window.Rank". Write
-- alpha^t = x0 + x1 alpha + ... + x(n-1) alpha^(n-1). Since s(t) is a linear function of alpha^t,
-- the cell holds x0 s(e) + x1 s(e + 1) + ... + x(n-1) s(e + n - 1). So n independent cells
-- determine alpha^t, and the others must agree.
module PraTactile.Locate.Decoder.Equations
  ( -- * Equations
    Equation (..),
    equations,

    -- * Solutions
    Solutions (..),
    solve,
    solutionFreedom,
    solutionCount,
    solutionResidues,
  )
where

import Data.List (foldl')
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Extension
import PraTactile.Field
import PraTactile.LinearCode.Elimination
import PraTactile.Polynomial
import PraTactile.Sequence
import PraTactile.Window
import PraTactile.Window.Rank

-- | The equation of one observed cell: its offset, the coefficients of x0, ..., x(n-1), and the
-- observed element.
data Equation (k :: Field) = Equation
  { equationOffset :: Position,
    equationFactors :: [GF k],
    equationValue :: GF k
  }

type role Equation nominal

-- | The equations of observed cells, given by their offsets, on the array's 'naturalSurface'.
-- Refuses what 'maskFrom' refuses.
equations ::
  KnownField k =>
  PseudorandomArray k ->
  [(Position, GF k)] ->
  Either WindowError [Equation k]
equations array cells = do
  mask <- maskFrom (map fst cells)
  pure
    ( zipWith
        (\(offset, a) root -> Equation offset (factors root) a)
        cells
        (windowVectors array mask)
    )
  where
    h = arrayPrimitive array
    n = primitiveDegree h
    terms = sequenceVector h (arrayState array) (2 * n - 1)
    -- s(e + k) is the same linear combination of s(k), s(k + 1), ... as alpha^e is of 1, alpha, ...
    factors root =
      [ Primitive.sum (Primitive.zipWith (*) coordinates (Primitive.drop k terms))
        | k <- [0 .. n - 1]
      ]
      where
        coordinates = Primitive.fromListN n root

-- | The solutions of equations, by the n coordinates x0, ..., x(n-1): none, or one plus every
-- linear combination of independent directions.
data Solutions k
  = -- | No values satisfy all equations.
    Inconsistent
  | -- | One solution and the directions: a coset of the space that the directions span.
    Solutions [GF k] [[GF k]]
  deriving stock (Eq, Show)

-- | Solves equations in this many unknowns by elimination.
solve :: KnownField k => Int -> [Equation k] -> Solutions k
solve n given
  | n `Map.member` pivoted = Inconsistent
  | otherwise = Solutions (coordinates (Primitive.! n)) [coordinates' f | f <- free]
  where
    rowOf e = rowFromList (equationFactors e ++ [equationValue e])
    include basis e = fromMaybe basis (extend (< n) basis (rowOf e))
    -- Column n holds the values. It has a pivot if all coefficients of a row are eliminated but its
    -- value is not.
    pivoted = Map.fromList (basisRows (foldl' include emptyBasis given))
    free = filter (`Map.notMember` pivoted) [0 .. n - 1]
    coordinates of' = [maybe zero of' (Map.lookup i pivoted) | i <- [0 .. n - 1]]
    coordinates' f =
      [ if i == f then one else maybe zero (negate . (Primitive.! f)) (Map.lookup i pivoted)
        | i <- [0 .. n - 1]
      ]

-- | The dimension of the solutions: n minus the number of independent equations; 0 if there are
-- none.
solutionFreedom :: Solutions k -> Natural
solutionFreedom solutions = case solutions of
  Inconsistent -> 0
  Solutions _ directions -> fromIntegral (length directions)

-- | The number of positions among the solutions. Zero is not a power of alpha, so it is not a
-- position.
solutionCount :: KnownField k => Solutions k -> Natural
solutionCount solutions = case solutions of
  Inconsistent -> 0
  Solutions x directions ->
    let size = fromIntegral (fieldOrder solutions) ^ length directions
     in if all (== zero) x then size - 1 else size

-- | The nonzero solutions, each as alpha^t, computed lazily.
solutionResidues :: KnownField k => Primitive k -> Solutions k -> [Residue k]
solutionResidues h solutions = case solutions of
  Inconsistent -> []
  Solutions x directions ->
    [ residue h (polynomial y)
      | scalars <- mapM (const elements) directions,
        let y = foldl' (zipWith (+)) x (zipWith (\a d -> map (a *) d) scalars directions),
        any (/= zero) y
    ]
