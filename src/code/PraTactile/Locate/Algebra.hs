{-# LANGUAGE DataKinds #-}
{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE KindSignatures #-}
{-# LANGUAGE RoleAnnotations #-}

-- |
-- The algebra road from observed cells to position: solve "PraTactile.Locate.Equations" for alpha^t, take
-- the discrete logarithm t, and fold. It needs no table, and so no limit to the array's size but that
-- of the logarithm; and any n independent cells do, whatever their shape.
module PraTactile.Locate.Algebra
  ( -- * The road
    Algebra
  , prepareAlgebra
  , algebraSurface
  , algebraArray
  , algebraMask
  , algebraPatch
  , largestListing

    -- * Its parts
  , algebraPlaces
  , algebraNowhere

    -- * Refusals
  , AlgebraError (..)
  ) where

import Data.List (sort)
import Data.Maybe (isJust)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.DiscreteLog
import PraTactile.Field
import PraTactile.Grid (canonicalPosition)
import PraTactile.Locate.Equations
import PraTactile.Locate.Outcome
import PraTactile.Locate.Patch
import PraTactile.Locate.Search (nowhere)
import PraTactile.Polynomial
import PraTactile.Window

-- | Why the algebra leads to no outcome.
data AlgebraError
  = -- | Beyond the edges of this surface the array does not go on as its sequence does; the second is its
    -- 'naturalSurface'. The sheet has nothing beyond its edges.
    SurfaceForeign Surface Surface
  | -- | The logarithm cannot be taken.
    AlgebraLogarithm LogarithmError
  | -- | There are too many observed cells.
    AlgebraCells WindowError
  deriving stock (Eq, Show)

-- | An array on a surface, with what is computed once for all patches.
data Algebra (k :: Field) = Algebra
  { algebraSurface :: !Surface
  -- ^ What lies beyond the edges.
  , algebraArray :: !(PseudorandomArray k)
  -- ^ The array.
  , algebraMask :: !Mask
  -- ^ The array's window.
  , algebraLogarithms :: !(Logarithms k)
  }

type role Algebra nominal

-- | Prepare the algebra of an array. The mask is its window, which names the support of an answer, as
-- in "PraTactile.Locate.Search". Refuses a surface that is neither the array's own nor the sheet, and
-- fields in which logarithms are infeasible.
prepareAlgebra :: KnownField k => Surface -> PseudorandomArray k -> Mask -> Either AlgebraError (Algebra k)
prepareAlgebra surface array mask
  | surface `notElem` [Sheet, natural] = Left (SurfaceForeign surface natural)
  | otherwise = either (Left . AlgebraLogarithm) (Right . Algebra surface array mask) (prepareLogarithms (arrayPrimitive array))
 where
  natural = naturalSurface (arrayFolding array)

-- | 1024: the most positions of one patch that are listed; of more, 'AmbiguousCoset' tells the number.
largestListing :: Natural
largestListing = 1024

-- | The place of a patch, with the outcomes of "PraTactile.Locate.Search".
algebraPatch :: KnownField k => Algebra k -> Patch k -> Either AlgebraError Outcome
algebraPatch algebra observed
  | null cells = Right (Refused TooFewCells)
  | otherwise = do
      solutions <- solved algebra cells
      if solutionCount solutions > largestListing
        then Right (AmbiguousCoset (solutionCount solutions) (solutionFreedom solutions))
        else pure $ case algebraPlaces algebra (map fst cells) solutions of
          [] -> Refused (algebraNowhere algebra observed)
          [place] -> Located place support
          places -> Ambiguous (sort places) support
 where
  cells = observedCells observed
  support = map fst (completeWindows (algebraMask algebra) observed)

-- | Why a patch that agrees with the array nowhere does so.
algebraNowhere :: KnownField k => Algebra k -> Patch k -> Reason
algebraNowhere algebra = nowhere (algebraSurface algebra) (algebraArray algebra) (algebraMask algebra) occurring
 where
  -- A window has as few cells as any mask.
  occurring content = either (const []) (algebraPlaces algebra (map fst content)) (solved algebra content)

-- | The positions that solutions are, made as they are asked for: on the sheet those at which all cells,
-- by their offsets, lie on it.
algebraPlaces :: KnownField k => Algebra k -> [Position] -> Solutions k -> [Position]
algebraPlaces algebra offsets solutions =
  [ place
  | x <- solutionResidues (arrayPrimitive array) solutions
  , -- Only zero has no logarithm, and it is no solution.
  Right t <- [logarithmFrom (algebraLogarithms algebra) x]
  , let place = positionOfIndex array t
  , all (lies place) offsets
  ]
 where
  array = algebraArray algebra
  lies (Position r c) (Position i j) =
    isJust (canonicalPosition (algebraSurface algebra) (arrayShape array) (toInteger (r + i)) (toInteger (c + j)))

solved :: KnownField k => Algebra k -> [(Position, GF k)] -> Either AlgebraError (Solutions k)
solved algebra cells =
  either (Left . AlgebraCells) (Right . solve (primitiveDegree (arrayPrimitive array))) (equations array cells)
 where
  array = algebraArray algebra
