{-# OPTIONS_HADDOCK hide #-}

-- | Decodes observed cells by algebra: it solves "PraTactile.Locate.Decoder.Equations" for alpha^t,
-- takes the discrete logarithm t, and folds. There is no table, so only the logarithm limits the
-- array's size. Any n independent cells suffice, whatever their shape.
module PraTactile.Locate.Decoder.Algebra
  ( -- * The decoder
    Algebra,
    prepareAlgebra,
    algebraOn,
    algebraSurface,
    algebraArray,
    algebraMask,
    algebraPatch,
    largestListing,

    -- * Its parts
    algebraPlaces,
    algebraVisits,
    Listed (..),
    algebraListing,
    algebraPositions,
    algebraNowhere,

    -- * Refusals
    AlgebraError (..),
  )
where

import Data.List (genericDrop, genericTake, sort)
import Data.Maybe (isJust, mapMaybe)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.DiscreteLog
import PraTactile.Extension (Residue)
import PraTactile.Field
import PraTactile.Grid (admissible, displaced, extentOf)
import PraTactile.Locate.Answer
import PraTactile.Locate.Decoder.Equations
import PraTactile.Locate.Definition (nowhere)
import PraTactile.Locate.Patch
import PraTactile.Polynomial
import PraTactile.Window

-- | Why the algebra has no outcome.
data AlgebraError
  = -- | On this surface the array does not continue as its sequence does; the second is its
    -- 'naturalSurface'. The sheet is allowed, since nothing lies beyond its edges.
    SurfaceForeign Surface Surface
  | -- | The logarithm cannot be taken.
    AlgebraLogarithm LogarithmError
  | -- | There are too many observed cells.
    AlgebraCells WindowError
  | -- | This many positions of the array agree, too many to find those that lie on the sheet with
    -- all cells.
    AlgebraSheet Natural
  deriving stock (Eq, Show)

-- | An array on a surface, with what is computed once for all its patches.
data Algebra (k :: Field) = Algebra
  { -- | The array on its surface.
    algebraOn :: !(ArrayOn k),
    -- | The array's window.
    algebraMask :: !Mask,
    algebraLogarithms :: !(Logarithms k)
  }

type role Algebra nominal

-- | Prepares the algebra of an array. The mask is the array's window, which names the support of an
-- answer, as in "PraTactile.Locate.Definition". Refuses a surface that is neither the array's own
-- nor the sheet, and fields in which logarithms are infeasible.
prepareAlgebra ::
  KnownField k =>
  ArrayOn k ->
  Mask ->
  Either AlgebraError (Algebra k)
prepareAlgebra on@(ArrayOn surface array) mask
  | surface `notElem` [Sheet, natural] = Left (SurfaceForeign surface natural)
  | otherwise =
    either
      (Left . AlgebraLogarithm)
      (Right . Algebra on mask)
      (prepareLogarithms (arrayPrimitive array))
  where
    natural = naturalSurface (arrayFolding array)

-- | The surface, which says what lies beyond the edges.
algebraSurface :: Algebra k -> Surface
algebraSurface = arraySurface . algebraOn

-- | The array.
algebraArray :: Algebra k -> PseudorandomArray k
algebraArray = arrayItself . algebraOn

-- | Positions; or that there are at least two, and perhaps too many to list.
data Listed = Listed [Position] | More
  deriving stock (Eq, Show)

-- | The most positions of one patch that are listed, 1024. For more, 'AmbiguousMany' has the
-- number.
largestListing :: Natural
largestListing = 1024

-- | Locates a patch, with the outcomes of "PraTactile.Locate.Definition".
algebraPatch :: KnownField k => Algebra k -> Patch (GF k) -> Either AlgebraError (Outcome Position)
algebraPatch algebra observed
  | null cells = Right (Refused TooFewCells)
  | otherwise = do
    solutions <- solved algebra cells
    found <- algebraListing algebra cells solutions
    pure $ case found of
      More -> AmbiguousMany (solutionCount solutions) (Just (solutionFreedom solutions))
      Listed [] -> Refused (algebraNowhere algebra observed)
      Listed [place] -> Unique place support
      Listed several -> Ambiguous (sort several) support
  where
    cells = observedCells observed
    support = map fst (completeWindows (algebraMask algebra) observed)

-- | Why a patch agrees with the array nowhere.
algebraNowhere :: KnownField k => Algebra k -> Patch (GF k) -> Reason
algebraNowhere algebra =
  nowhere (algebraOn algebra) (algebraMask algebra) occurring
  where
    -- The content of a window is accepted, since it has no more cells than a mask may have.
    occurring content = either (const []) (algebraPlaces algebra content) (solved algebra content)

-- | The positions of the solutions for these cells, computed lazily. On the sheet, only positions
-- with all cells on it count.
algebraPlaces :: KnownField k => Algebra k -> [(Position, GF k)] -> Solutions k -> [Position]
algebraPlaces algebra cells solutions
  | algebraVisits algebra offsets solutions == solutionCount solutions =
    mapMaybe
      (algebraPlace algebra offsets)
      (solutionResidues (arrayPrimitive (algebraArray algebra)) solutions)
  | otherwise = filter (agreesAt algebra cells) (positionsOf algebra offsets)
  where
    offsets = map fst cells

-- | The number of positions that must be tried to list those of the solutions: the solutions
-- themselves, or on the sheet, if they are fewer, the positions with all cells on it.
algebraVisits :: KnownField k => Algebra k -> [Position] -> Solutions k -> Natural
algebraVisits algebra offsets solutions =
  min (solutionCount solutions) (area (algebraPositions algebra offsets))

-- | The positions of the solutions, or 'More' if there are more than 'largestListing'. On the
-- sheet, 'More' requires that two of them are found on it, among limited numbers of solutions or
-- positions; else 'AlgebraSheet'.
algebraListing ::
  KnownField k =>
  Algebra k ->
  [(Position, GF k)] ->
  Solutions k ->
  Either AlgebraError Listed
algebraListing algebra cells solutions
  | count <= largestListing = Right (Listed (algebraPlaces algebra cells solutions))
  | algebraSurface algebra /= Sheet = Right More
  | area (algebraPositions algebra offsets) <= largestVisit =
    Right (if several largestListing onSheet then More else Listed onSheet)
  | several 1 (mapMaybe (algebraPlace algebra offsets) (genericTake largestListing residues)) =
    Right More
  | several
      1
      ( filter
          (agreesAt algebra cells)
          (genericTake largestVisit (positionsOf algebra offsets))
      ) =
    Right More
  | otherwise = Left (AlgebraSheet count)
  where
    count = solutionCount solutions
    offsets = map fst cells
    residues = solutionResidues (arrayPrimitive (algebraArray algebra)) solutions
    onSheet = filter (agreesAt algebra cells) (positionsOf algebra offsets)
    several :: Natural -> [a] -> Bool
    several n = not . null . genericDrop n

-- | The most positions of the sheet that are tried to find cells that agree, 2^14.
largestVisit :: Natural
largestVisit = 2 ^ (14 :: Int)

-- | The shape of the region of positions for which all cells lie on the surface.
algebraPositions :: Algebra k -> [Position] -> Shape
algebraPositions algebra offsets =
  admissible (algebraSurface algebra) (arrayShape (algebraArray algebra)) (extentOf offsets)

-- | All positions for which the cells lie on the surface, row by row.
positionsOf :: Algebra k -> [Position] -> [Position]
positionsOf algebra = shapeCells . algebraPositions algebra

-- | Whether all cells agree with the array when the patch is at this position.
agreesAt :: KnownField k => Algebra k -> [(Position, GF k)] -> Position -> Bool
agreesAt algebra cells place =
  and
    [ (cellAt (algebraArray algebra) <$> cellFrom algebra place offset) == Just a
      | (offset, a) <- cells
    ]

-- | The position of a solution; 'Nothing' unless all cells then lie on the surface.
algebraPlace :: KnownField k => Algebra k -> [Position] -> Residue k -> Maybe Position
algebraPlace algebra offsets x = case logarithmFrom (algebraLogarithms algebra) x of
  Right t
    | let place = positionOfIndex (algebraArray algebra) t,
      all (isJust . cellFrom algebra place) offsets ->
      Just place
  -- Only zero has no logarithm, and zero is not a solution.
  _ -> Nothing

-- | The cell of the array at an offset from a position.
cellFrom :: Algebra k -> Position -> Position -> Maybe Position
cellFrom algebra = displaced (algebraSurface algebra) (arrayShape (algebraArray algebra))

-- | Solves the equations of observed cells.
solved :: KnownField k => Algebra k -> [(Position, GF k)] -> Either AlgebraError (Solutions k)
solved algebra cells =
  either
    (Left . AlgebraCells)
    (Right . solve (primitiveDegree (arrayPrimitive array)))
    (equations array cells)
  where
    array = algebraArray algebra
