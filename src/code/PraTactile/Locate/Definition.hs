{-# OPTIONS_HADDOCK hide #-}

-- | The definition of locating, too slow for large arrays and too simple to be wrong. Every
-- position in every symmetry is a candidate, and the observed cells are compared with what the
-- array has there. The nearest candidate differs in the fewest cells; probabilities follow from
-- Bayes' theorem. The decoders are tested against it.
module PraTactile.Locate.Definition
  ( -- * All candidates
    everyCandidate,
    differencesByDefinition,
    posteriorByDefinition,
    looksByDefinition,

    -- * Agreeing in every cell
    searchPatch,
    largestSearchedArray,
    agreeing,
    nowhere,
  )
where

import qualified Data.Map.Strict as Map
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Grid (canonicalPosition, displaced)
import PraTactile.Locate.Answer
import PraTactile.Locate.Belief
import PraTactile.Locate.Patch
import PraTactile.Symmetry
import PraTactile.Window

-- | Every candidate with the array's symbols in the cells of a patch as seen. Symmetries come in
-- the given order, positions row by row. The cells are given by the patch's shape and their
-- offsets. On the sheet, only candidates with all these cells and the upright patch's upper left
-- cell on it count.
everyCandidate ::
  KnownField k =>
  ArrayOn k ->
  [Symmetry] ->
  Shape ->
  [Position] ->
  [(Candidate, [GF k])]
everyCandidate (ArrayOn surface array) possible shape offsets =
  [ (Candidate o place, content)
    | o <- possible,
      place <- shapeCells (arrayShape array),
      let symbolAt offset =
            cellAt array
              <$> displaced
                surface
                (arrayShape array)
                place
                (onPosition (invert o) shape offset),
      Just content <- [traverse symbolAt offsets]
  ]

-- | Every candidate with the observed cells that differ there.
differencesByDefinition ::
  KnownField k =>
  ArrayOn k ->
  [Symmetry] ->
  Patch (GF k) ->
  [(Candidate, [Position])]
differencesByDefinition on possible observed =
  [ (candidate, [offset | ((offset, a), b) <- zip cells content, a /= b])
    | (candidate, content) <-
        everyCandidate on possible (patchShape observed) (map fst cells)
  ]
  where
    cells = observedCells observed

-- | The exact posterior of every candidate under a uniform prior. A candidate's likelihood is the
-- product of the probabilities of its symbols, each jointly with its symmetry if the cell shows
-- that. A cell may be listed several times, for several observations. Empty if no candidate is
-- possible.
posteriorByDefinition ::
  KnownField k =>
  ArrayOn k ->
  [Symmetry] ->
  Shape ->
  [(Position, Belief k)] ->
  [(Candidate, Rational)]
posteriorByDefinition on possible shape cells
  | total == 0 = []
  | otherwise = [(candidate, p / total) | (candidate, p) <- likelihood]
  where
    likelihood =
      [ (candidate, product (zipWith (probability candidate) (map snd cells) content))
        | (candidate, content) <- everyCandidate on possible shape (map fst cells)
      ]
    probability candidate b a =
      toRational (Primitive.toList (probabilitiesIn (candidateSymmetry candidate) b) !! toCode a)
    total = sum (map snd likelihood)

-- | The rectangle around displaced patches, and all observations of each observed cell in it.
looksByDefinition :: [((Integer, Integer), Patch a)] -> (Shape, [(Position, [a])])
looksByDefinition given = (Shape (side bottom top) (side right left), Map.toAscList seen)
  where
    top = minimum [r | ((r, _), _) <- given]
    left = minimum [c | ((_, c), _) <- given]
    bottom = maximum [r + toInteger (rows (patchShape p)) | ((r, _), p) <- given]
    right = maximum [c + toInteger (columns (patchShape p)) | ((_, c), p) <- given]
    side to from = fromInteger (to - from)
    seen =
      Map.fromListWith
        (flip (++))
        [ (Position (i + fromInteger (r - top)) (j + fromInteger (c - left)), [a])
          | ((r, c), p) <- given,
            (Position i j, a) <- observedCells p
        ]

-- | Locates a patch by comparing every observed cell at every position. The mask is the array's
-- window. It is not used for the comparison, but the patch's windows are named as the support of an
-- answer, and decide the reason of a refusal, as in "PraTactile.Locate". Unlike the table, the
-- search also uses patches without a complete window. A patch without observed cells gives
-- 'TooFewCells'. Refuses arrays of more than 'largestSearchedArray' cells.
searchPatch ::
  KnownField k =>
  ArrayOn k ->
  Mask ->
  Patch (GF k) ->
  Either LocateError (Outcome Position)
searchPatch on@(ArrayOn _ array) mask observed
  | cells > largestSearchedArray = Left (TooManyPlaces cells largestSearchedArray)
  | otherwise = Right $ case agreeing on (observedCells observed) of
    _ | null (observedCells observed) -> Refused TooFewCells
    [place] -> Unique place support
    [] -> Refused (nowhere on mask (agreeing on) observed)
    places -> Ambiguous places support
  where
    cells = area (arrayShape array)
    support = map fst (completeWindows mask observed)

-- | The most cells of an array that is searched, 2^20.
largestSearchedArray :: Natural
largestSearchedArray = 2 ^ (20 :: Int)

-- | The positions, ascending, where the array has these symbols at these offsets. On the sheet all
-- cells must lie on it.
agreeing :: KnownField k => ArrayOn k -> [(Position, GF k)] -> [Position]
agreeing (ArrayOn surface array) cells =
  [ place
    | place <- shapeCells shape,
      and [(cellAt array <$> displaced surface shape place offset) == Just a | (offset, a) <- cells]
  ]
  where
    shape = arrayShape array

-- | The cell at an offset from a row and a column.
shifted :: Surface -> Shape -> (Integer, Integer) -> Position -> Maybe Position
shifted surface shape (r, c) (Position i j) =
  canonicalPosition surface shape (r + toInteger i) (c + toInteger j)

-- | Why a patch agrees with the array nowhere, judged by its complete windows. The function gives
-- the positions where cells agree, as 'agreeing' does.
nowhere ::
  KnownField k =>
  ArrayOn k ->
  Mask ->
  ([(Position, GF k)] -> [Position]) ->
  Patch (GF k) ->
  Reason
nowhere (ArrayOn surface array) mask agreeingAt observed
  | null windows = if all ((== zero) . snd) cells then ZeroWindow else Contradiction
  | null occurring = if all (all (== zero) . snd) windows then ZeroWindow else NotInArray
  | surface == Sheet && any sticksOut places = OffSheet
  | otherwise = Contradiction
  where
    cells = observedCells observed
    windows = completeWindows mask observed
    -- The offset of each window that occurs, with its positions.
    occurring =
      [ (offset, positions)
        | (offset, content) <- windows,
          positions@(_ : _) <- [agreeingAt (zip (maskOffsets mask) content)]
      ]
    -- The patch's upper left corner for each position of its first window that occurs; it may lie
    -- beyond the edge.
    places =
      [ (toInteger r - toInteger i, toInteger c - toInteger j)
        | (Position i j, positions) <- take 1 occurring,
          Position r c <- positions
      ]
    sticksOut place =
      and [cellAt array p == a | (offset, a) <- cells, Just p <- [at place offset]]
        && and [standsAt place offset | (offset, _) <- occurring]
    standsAt (r, c) (Position i j) =
      and [onSheet (r + toInteger i, c + toInteger j) o | o <- maskOffsets mask]
    at = shifted Sheet (arrayShape array)
    onSheet place offset = at place offset /= Nothing
