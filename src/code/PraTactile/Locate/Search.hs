-- |
-- The search road from observed cells to position, which is what locating means: compare the patch
-- with the array at every position. Too slow to use on large arrays and too simple to be wrong; the
-- other roads are tested against it.
module PraTactile.Locate.Search
  ( searchPatch
  , largestSearchedArray
  , agreeing
  , nowhere
  ) where

import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Grid (canonicalPosition)
import PraTactile.Locate.Outcome
import PraTactile.Locate.Patch
import PraTactile.Window

-- | The place of a patch, by comparing every observed cell at every position. The mask is the
-- array's window: it takes no part in the comparison, but the windows of the patch are named as the
-- support of an answer, and they tell the reason of a refusal, as in "PraTactile.Locate". Unlike the
-- table, the search also uses patches in which no window is complete; 'TooFewCells' is the answer
-- to no observed cell at all. Refuses arrays of more than 'largestSearchedArray' cells.
searchPatch
  :: KnownField k => Surface -> PseudorandomArray k -> Mask -> Patch k -> Either LocateError Outcome
searchPatch surface array mask observed
  | cells > largestSearchedArray = Left (TooManyPlaces cells largestSearchedArray)
  | otherwise = Right $ case agreeing surface array (observedCells observed) of
      _ | null (observedCells observed) -> Refused TooFewCells
      [place] -> Located place support
      [] -> Refused (nowhere surface array mask (agreeing surface array) observed)
      places -> Ambiguous places support
 where
  cells = area (arrayShape array)
  support = map fst (completeWindows mask observed)

-- | 2^20: the most cells of an array that is searched.
largestSearchedArray :: Natural
largestSearchedArray = 2 ^ (20 :: Int)

-- | The positions, ascending, at which these cells, by their offsets, are those of the array. On the
-- sheet all of them must lie on it.
agreeing :: KnownField k => Surface -> PseudorandomArray k -> [(Position, GF k)] -> [Position]
agreeing surface array cells =
  [ Position r c
  | r <- below (rows shape)
  , c <- below (columns shape)
  , and [found == Just a | (offset, a) <- cells, let found = cellAt array <$> from (toInteger r, toInteger c) offset]
  ]
 where
  shape = arrayShape array
  from = shifted surface shape
  below n = takeWhile (< n) [0 ..]

-- | The cell at an offset from a row and a column.
shifted :: Surface -> Shape -> (Integer, Integer) -> Position -> Maybe Position
shifted surface shape (r, c) (Position i j) =
  canonicalPosition surface shape (r + toInteger i) (c + toInteger j)

-- | Why a patch that agrees with the array nowhere does so, by the patch's complete windows. The function tells
-- where cells, by their offsets, agree, as 'agreeing' does.
nowhere
  :: KnownField k
  => Surface -> PseudorandomArray k -> Mask -> ([(Position, GF k)] -> [Position]) -> Patch k -> Reason
nowhere surface array mask agreeingAt observed
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
    | (offset, content) <- windows
    , positions@(_ : _) <- [agreeingAt (zip (maskOffsets mask) content)]
    ]
  -- Where the patch's upper left is, perhaps beyond the edge, when its first window that occurs is at one of
  -- its positions.
  places = [(toInteger r - toInteger i, toInteger c - toInteger j) | (Position i j, positions) <- take 1 occurring, Position r c <- positions]
  sticksOut place =
    and [cellAt array p == a | (offset, a) <- cells, Just p <- [at place offset]]
      && and [standsAt place offset | (offset, _) <- occurring]
  standsAt (r, c) (Position i j) = and [onSheet (r + toInteger i, c + toInteger j) o | o <- maskOffsets mask]
  at = shifted Sheet (arrayShape array)
  onSheet place offset = at place offset /= Nothing
