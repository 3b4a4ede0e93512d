{-# OPTIONS_HADDOCK hide #-}

-- | What locating means, too slow to use on large arrays and too simple to be wrong: every symmetry
-- with every position is a candidate, and what was observed is compared with what the array has
-- there. The nearest candidate differs in the fewest cells; how likely one is, is Bayes' theorem.
-- The decoders are tested against it.
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

-- | Every candidate, by symmetries in the order given and positions row by row, with what the array
-- has in the cells with these offsets of a patch with this shape as it is seen; on the sheet those
-- with which all of the cells and the upper left one of the upright patch lie on it.
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

-- | Every candidate with its probability, all of them being equally likely beforehand: the product
-- of the probabilities of the symbols there, each together with the candidate's symmetry where the
-- cell shows how it lies, over the sum of these; in exact fractions. The cells
-- may be several looks at one cell each. None if no candidate is possible.
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

-- | The rectangle around displaced patches, and for each observed cell in it all looks at it.
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

-- | The place of a patch, by comparing every observed cell at every position. The mask is the
-- array's window: it takes no part in the comparison, but the windows of the patch are named as the
-- support of an answer, and decide the reason of a refusal, as in "PraTactile.Locate". Unlike the
-- table, the search also uses patches in which no window is complete; 'TooFewCells' is the answer
-- to no observed cell at all. Refuses arrays of more than 'largestSearchedArray' cells.
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

-- | 2^20: the most cells of an array that is searched.
largestSearchedArray :: Natural
largestSearchedArray = 2 ^ (20 :: Int)

-- | The positions, ascending, at which these cells, by their offsets, are those of the array. On
-- the sheet all of them must lie on it.
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

-- | Why a patch that agrees with the array nowhere does so, by the patch's complete windows. The
-- function is where cells, by their offsets, agree, as 'agreeing' has it.
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
    -- The offset of a window that occurs, with where.
    occurring =
      [ (offset, positions)
        | (offset, content) <- windows,
          positions@(_ : _) <- [agreeingAt (zip (maskOffsets mask) content)]
      ]
    -- Where the patch's upper left is, perhaps beyond the edge, when its first window that occurs
    -- is at one of its positions.
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
