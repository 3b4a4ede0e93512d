{-# OPTIONS_HADDOCK hide #-}

-- | Windows by definition: the cells that a mask covers at each position.
module PraTactile.Conformance.Definition.Windows
  ( Offset,
    maskOf,
    windowOffsets,
    windowsOn,
    prove,
    distance,
    pack,
    unpack,
  )
where

import Data.List (foldl')
import qualified Data.Set as Set
import Numeric.Natural (Natural)
import PraTactile.Array (Shape (..), Surface (..))
import PraTactile.Conformance.Definition.Array
import PraTactile.Conformance.Definition.Field
import PraTactile.Conformance.Question
import PraTactile.Profile (Profile (..))
import PraTactile.Window (Packing (..))

-- | Rows down and columns to the right of a window's position.
type Offset = (Int, Int)

-- | The cells of a mask, marked by @#@ in rows of equal length of @#@ and @.@. 'Nothing' for other
-- characters, unequal rows, no cell, or more than 4096 cells.
maskOf :: MaskRows -> Maybe [Offset]
maskOf drawing
  | any (any (`notElem` "#.")) drawing || any ((/= width) . length) drawing = Nothing
  | null cells || length cells > 4096 = Nothing
  | otherwise = Just cells
  where
    width = sum (map length (take 1 drawing))
    cells = [(i, j) | (i, line) <- zip [0 ..] drawing, (j, '#') <- zip [0 ..] line]

-- | The cells of the profile's window, row by row.
windowOffsets :: ProfileFacts -> [Offset]
windowOffsets k =
  [(i, j) | i <- [0 .. fromIntegral high - 1], j <- [0 .. fromIntegral wide - 1]]
  where
    Shape high wide = profileWindow (knownProfile k)

-- | The contents of the cells with these offsets, at each position at which all of them lie on the
-- surface.
windowsOn :: ProfileFacts -> Surface -> [Offset] -> [((Int, Int), [Int])]
windowsOn k surface offsets =
  [ (place, content)
    | place@(r, c) <- positions k,
      let content = [onSurface k surface (r + i) (c + j) | (i, j) <- offsets],
      all (>= 0) content
  ]

-- | Whether all windows on the profile's surface differ, by counting distinct contents. 'Nothing'
-- if no window lies on it.
prove :: ProfileFacts -> [Offset] -> Maybe Proof
prove k offsets
  | null windows = Nothing
  | otherwise = Just (Proof (different == length windows) rank (fromIntegral different))
  where
    surface = profileSurface (knownProfile k)
    windows = map snd (windowsOn k surface offsets)
    different = Set.size (Set.fromList windows)
    rank
      | surface `elem` [ownSurface k, Sheet] = Just (fromIntegral (rankOf k offsets))
      | otherwise = Nothing

-- | The dimension of the space spanned by the windows on the folding's own surface, by
-- elimination.
rankOf :: ProfileFacts -> [Offset] -> Int
rankOf k offsets = length (foldl' insert [] (map snd (windowsOn k (ownSurface k) offsets)))
  where
    f = knownField k
    -- Independent rows, last one first. Each begins with zeros and a 1; later rows have a 0 where
    -- it has the 1.
    insert rows' window = case foldr reduce window rows' of
      reduced | all (== 0) reduced -> rows'
      reduced -> map (multiply f (leading reduced)) reduced : rows'
    reduce row window =
      let i = length (takeWhile (== 0) row)
          scale = negation f (window !! i)
       in zipWith (\a b -> add f a (multiply f scale b)) window row
    leading reduced = sum (concatMap (foldMap pure . inverse f) (take 1 (dropWhile (== 0) reduced)))

-- | The least number of cells in which two windows on the folding's own surface differ; 0 if two
-- are equal.
--
-- The difference of two windows is a third window there: the difference of two shifts of an
-- m-sequence is another shift, or 0 only for a shift by a whole period. Conversely every window is
-- such a difference. So the least weight is the least difference.
distance :: ProfileFacts -> [Offset] -> Natural
distance k offsets =
  fromIntegral (minimum (map weight (positions k)))
  where
    at = onSurface k (ownSurface k)
    weight (r, c) = length (filter (\(i, j) -> at (r + i) (c + j) /= 0) offsets)

-- | The number of a window: its cells as base-q digits.
pack :: ProfileFacts -> [Int] -> Natural
pack k = foldl' (\n c -> profileOrder (knownProfile k) * n + fromIntegral c) 0 . ordered k

-- | The window of a number below q^cells, the inverse of 'pack'.
unpack :: ProfileFacts -> Natural -> [Int]
unpack k = ordered k . reverse . map fromIntegral . digits (profileOrder (knownProfile k)) cells
  where
    cells = length (windowOffsets k)

-- | The cells with the most significant digit first.
ordered :: ProfileFacts -> [a] -> [a]
ordered k = case profilePacking (knownProfile k) of
  MostSignificantFirst -> id
  LeastSignificantFirst -> reverse
