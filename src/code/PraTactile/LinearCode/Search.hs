{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Searches for codewords near a word, among those that agree with it in all but few places of an
-- information set. With the zero word it finds a lightest codeword; with a received word it
-- decodes.
module PraTactile.LinearCode.Search
  ( -- * What to look at
    Step (..),
    schedule,
    changes,

    -- * Looking
    Wanted (..),
    Level (..),
    Near (..),
    nearAt,
  )
where

import Data.List (minimumBy)
import Data.Ord (comparing)
import Data.Vector.Primitive (Vector, unsafeIndex)
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Field
import PraTactile.Field.Vector (addScaled)
import PraTactile.LinearCode.InformationSet
import PraTactile.LinearCode.Packed

{- Note [Disjoint information sets]
   ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
   Fix a word y. A codeword is seen at level w of a set if it differs from y in at most w of the
   set's k places. These codewords are the combinations of at most w rows, added to the codeword
   that agrees with y at the k places. A codeword that is not seen at level w differs in at least w
   + 1 of the k places. Of these, d places belong to earlier sets, where d is the set's deficit. So
   the codeword differs in at least w + 1 - d of the set's own places, and the own places of
   different sets are disjoint. Therefore a codeword that is seen at none of the levels w(1), w(2),
   ... of the sets differs from y in at least

     sum of max 0 (w(j) + 1 - d(j))

   places, and all codewords that differ in fewer have been seen. (For y = 0, lightest codewords:
   K.-H. Zimmermann 1996; M. Grassl in "Discovering Mathematics with Magma", 2006.) At level k of
   any set every codeword is seen. -}

-- | A step of the search: one set is searched one level further, or several levels if its deficit
-- makes the first ones useless.
data Step k = Step
  { -- | The set.
    stepSet :: InformationSet k,
    -- | The levels: the exact numbers of its places that differ.
    stepLevels :: [Int],
    -- | The number of codewords that are tested.
    stepWords :: !Natural,
    -- | After this step all codewords have been seen that differ in at most this many places;
    -- 'Nothing': all codewords.
    stepSeen :: !(Maybe Int)
  }

-- | The steps, the cheapest first, until all codewords have been seen; see Note [Disjoint
-- information sets]. The function gives the number of codewords that differ in exactly w places of
-- a set.
schedule :: (Int -> Natural) -> [InformationSet k] -> [Step k]
schedule count sets = go [(i, set, -1) | (i, set) <- zip [0 :: Int ..] sets]
  where
    go [] = []
    go levels
      | next == setSize set = [Step set visited cost Nothing]
      | otherwise =
        Step
          set
          visited
          cost
          (Just (sum [max 0 (w + 1 - setDeficit other) | (_, other, w) <- after] - 1)) :
        go after
      where
        (cost, i, set, visited, next) =
          minimumBy (comparing (\(c, _, _, _, _) -> c)) (map offer levels)
        after = [(j, other, if j == i then next else w) | (j, other, w) <- levels]
    offer (i, set, w) = (sum (map count visited), i, set, visited, next)
      where
        next = min (setSize set) (max (w + 1) (setDeficit set))
        visited = [w + 1 .. next]

-- | @changes q k w@ is the number of words that differ from a given one in exactly w of k places,
-- over q symbols.
changes :: Int -> Int -> Int -> Natural
changes q k w
  | w > k = 0
  | otherwise =
    product (map fromIntegral [k - w + 1 .. k])
      `div` product (map fromIntegral [1 .. w])
      * fromIntegral (q - 1) ^ w

-- | The near codewords that are wanted.
data Wanted
  = -- | One of those nearest to zero: a codeword stands for its multiples, and zero does not count.
    -- The start of 'nearAt' must be zero.
    OneLightest
  | -- | All of them, if there are at most this many; otherwise only those nearer than some
    -- distance.
    AllUpTo Int

-- | The distance from the start within which codewords are tested.
data Level = Level
  { -- | The exact number of the set's places that differ, which is the number of rows that are
    -- combined.
    levelRows :: !Int,
    -- | The most other places that differ.
    levelLimit :: !Int
  }

-- | The near codewords that were found.
data Near k = Near
  { -- | For 'AllUpTo', every tested codeword that differs in at most this many of the other places
    -- is listed. For 'OneLightest' there is no such codeword; the listed one, if any, differs in
    -- one place more.
    nearLimit :: !Int,
    -- | For each codeword, the number of the other places in which it differs, and its combination
    -- of rows.
    nearFound :: [(Int, [(Int, GF k)])]
  }

-- | The data that stay the same while combinations of rows are tested.
data Scan (k :: Field) = Scan
  { scanWanted :: !Wanted,
    scanSet :: !(InformationSet k),
    -- | The factors of a row: all nonzero elements.
    scanFactors :: !(Vector (GF k))
  }

type role Scan nominal

-- | The combinations of exactly the level's number of rows that differ from the start, at the other
-- places, in at most the level's limit. The start has one element for each of the other places: the
-- word minus the codeword that agrees with it at the places of the set ('agreeingAt'). Its length
-- is not checked.
nearAt :: KnownField k => Wanted -> InformationSet k -> Vector (GF k) -> Level -> Near k
nearAt wanted set start (Level w limit)
  | limit < 0 || w > setSize set = Near limit []
  | w == 0 = case wanted of
    AllUpTo most | differing <= limit -> kept most (Near limit [(differing, [])])
    _ -> Near limit []
  | otherwise =
    let scan = Scan wanted set (Primitive.fromList (drop 1 elements))
        Near most found = addRows scan w 0 [] start (Near limit [])
     in Near most (reverse found)
  where
    differing = Primitive.length (Primitive.filter (/= zero) start)

-- | @addRows scan w from chosen rest near@ adds w more rows, from the row with index from on, to
-- the chosen ones, each with a factor. The rest is the start minus the chosen rows.
addRows ::
  KnownField k =>
  Scan k ->
  Int ->
  Int ->
  [(Int, GF k)] ->
  Vector (GF k) ->
  Near k ->
  Near k
addRows scan !w !from chosen !rest
  | w == 1 = addLastRow scan from chosen rest
  | otherwise = go from 0
  where
    !set = scanSet scan
    !many = factorsAfter scan chosen
    go !i !s near
      | i > setSize set - w = near
      | s >= many = go (i + 1) 0 near
      | otherwise =
        let a = unsafeIndex (scanFactors scan) s
            less = addScaled (negate a) (parityRow set i) rest
         in go i (s + 1) $! addRows scan (w - 1) (i + 1) ((i, a) : chosen) less near

-- | Adds the last row. Its multiples are compared with the rest only up to the limit.
addLastRow :: KnownField k => Scan k -> Int -> [(Int, GF k)] -> Vector (GF k) -> Near k -> Near k
addLastRow scan !from chosen !rest = go from 0
  where
    !set = scanSet scan
    !size = setSize set
    !multiples = setMultiples set
    !packedRest = packed [rest]
    !factors = scanFactors scan
    !many = factorsAfter scan chosen
    go !i !s near@(Near most _)
      | i >= size = near
      | s >= many = go (i + 1) 0 near
      | n <= most =
        go i (s + 1) $! include (scanWanted scan) (n, (i, unsafeIndex factors s) : chosen) near
      | otherwise = go i (s + 1) near
      where
        n = differences multiples (i * Primitive.length factors + s) packedRest most

-- | The number of factors of a further row. If multiples do not matter, the first row has factor 1
-- only.
factorsAfter :: Scan k -> [(Int, GF k)] -> Int
factorsAfter scan chosen = case (scanWanted scan, chosen) of
  (OneLightest, []) -> 1
  _ -> Primitive.length (scanFactors scan)

-- | Adds one more codeword.
include :: Wanted -> (Int, [(Int, GF k)]) -> Near k -> Near k
include wanted new (Near most found) = case wanted of
  OneLightest -> Near (fst new - 1) [new]
  AllUpTo many -> kept many (Near most (new : found))

-- | Keeps at most the given number of codewords, by dropping the farthest ones.
kept :: Int -> Near k -> Near k
kept many near@(Near most found)
  | length found <= many = near
  | otherwise = kept many (Near (most - 1) (filter ((< most) . fst) found))
