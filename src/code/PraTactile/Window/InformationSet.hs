{-# LANGUAGE BangPatterns #-}

-- | Information sets of a linear code, and the search for codewords near a word among those that
-- agree with it at all but few places of one of them. With the zero word that is the search for a
-- lightest codeword; with a received word it is decoding. Internal.
module PraTactile.Window.InformationSet
  ( -- * Sets
    InformationSet,
    informationSets,
    setDeficit,
    setPlaces,
    setRest,
    setParity,

    -- * Words
    agreeingAt,
    combination,
    combinationFrom,

    -- * What to look at
    Step (..),
    schedule,
    changes,

    -- * Looking
    Wanted (..),
    Near (..),
    nearAt,
  )
where

import Data.Bits (popCount, unsafeShiftL, unsafeShiftR, xor, (.&.), (.|.))
import qualified Data.IntSet as IntSet
import Data.List (foldl', minimumBy)
import Data.Maybe (fromMaybe)
import Data.Ord (comparing)
import Data.Proxy (Proxy (..))
import Data.Vector.Primitive (Vector, unsafeIndex)
import qualified Data.Vector.Primitive as Primitive
import Data.Word (Word64)
import Numeric.Natural (Natural)
import PraTactile.Field
import PraTactile.Window.Elimination

-- | A basis of a code of dimension k which at k places, one a row, is the unit matrix.
data InformationSet (k :: Field) = InformationSet
  { -- | how many of those places belong to sets before this one
    setDeficit :: !Int,
    -- | the k places, by rows
    setPlaces :: !(Vector Int),
    -- | all other places, ascending
    setRest :: !(Vector Int),
    -- | the rows at the other places, one row after the other
    setParity :: !(Vector (GF k)),
    -- | the same times every element but zero: all multiples of one row after the other
    setMultiples :: Packed
  }

type role InformationSet nominal

-- | Information sets of the code of this length that some rows span; the places of each that do not
-- belong to sets before it are disjoint from them, and there are as many sets as there are places
-- for. Each takes the first places that it can: those that do not depend on places before them.
informationSets :: forall k. KnownField k => Int -> [Row k] -> [InformationSet k]
informationSets size rows = go (IntSet.fromDistinctAscList [0 .. size - 1])
  where
    go free
      | IntSet.null taken = []
      | otherwise = fromBasis (basisSize basis - IntSet.size taken) : go (free IntSet.\\ taken)
      where
        basis = foldl' (include (`IntSet.member` free)) emptyBasis rows
        pivots = map fst (basisRows basis)
        taken = IntSet.fromList pivots `IntSet.intersection` free
        fromBasis deficit =
          InformationSet
            deficit
            (Primitive.fromList pivots)
            rest
            (Primitive.concat parity)
            (packed [scaleRow a x | x <- parity, a <- drop 1 elements])
        parity = map (parityOf . snd) (basisRows basis)
        rest =
          Primitive.fromList
            ( IntSet.toAscList
                (IntSet.fromDistinctAscList [0 .. size - 1] IntSet.\\ IntSet.fromList pivots)
            )
        parityOf x = Primitive.map (unsafeIndex x) rest
    include preferred basis x = fromMaybe basis (extend preferred basis x)

-- | The dimension of the code.
setSize :: InformationSet k -> Int
setSize = Primitive.length . setPlaces

-- | How a word differs at the other places from the codeword that agrees with it at the places of
-- the set.
agreeingAt :: KnownField k => InformationSet k -> Row k -> Vector (GF k)
agreeingAt set y =
  foldl'
    without
    (Primitive.map (unsafeIndex y) (setRest set))
    (zip [0 ..] (Primitive.toList (setPlaces set)))
  where
    without x (i, place) = addScaled (negate (unsafeIndex y place)) (parityRow set i) x

parityRow :: InformationSet k -> Int -> Vector (GF k)
parityRow set i = Primitive.slice (i * width) width (setParity set)
  where
    width = Primitive.length (setRest set)

-- | The codeword that is this combination of rows, as long as the code.
combination :: KnownField k => InformationSet k -> [(Int, GF k)] -> Row k
combination set terms = Primitive.replicate size zero Primitive.// (atPlaces ++ atRest)
  where
    size = setSize set + width
    width = Primitive.length (setRest set)
    atPlaces = [(unsafeIndex (setPlaces set) i, a) | (i, a) <- terms]
    atRest = zip (Primitive.toList (setRest set)) (Primitive.toList sums)
    sums =
      foldl' (\x (i, a) -> addScaled a (parityRow set i) x) (Primitive.replicate width zero) terms

-- | The codeword that agrees with a word at the places of the set, with this combination of rows
-- added.
combinationFrom :: KnownField k => InformationSet k -> Row k -> [(Int, GF k)] -> Row k
combinationFrom set y terms =
  combination set (zipWith letter [0 ..] (Primitive.toList (setPlaces set)))
  where
    letter i place = (i, unsafeIndex y place + sum [a | (j, a) <- terms, j == i])

{- Note [Disjoint information sets] Fix a word y, and say that a codeword is seen at level w of a
   set when it differs from y in at most w of the set's k places: these are the combinations of at
   most w rows, added to the codeword that agrees with y at the k places. A codeword not seen at
   level w differs in w + 1 of the k places or more. Of the k places, d, the set's deficit, belong
   to earlier sets, so that it differs in w + 1 - d or more of the places that are this set's own.
   The own places of different sets are disjoint. So a codeword that is seen at none of the levels
   w(1), w(2), ... of the sets differs from y in at least

     sum of max 0 (w(j) + 1 - d(j))

   places, and all codewords that differ in fewer have been seen (for y = 0, lightest codewords:
   K.-H. Zimmermann 1996; M. Grassl in "Discovering Mathematics with Magma", 2006). At level k of
   any set every codeword is seen. -}

-- | One set is to be searched one level further, or, where its deficit makes the first levels
-- useless, several.
data Step k = Step
  { -- | Which set.
    stepSet :: InformationSet k,
    -- | How many of its places differ: exactly one of these numbers.
    stepLevels :: [Int],
    -- | So many codewords are looked at.
    stepWords :: !Natural,
    -- | After it all codewords have been seen that differ in at most so many places; 'Nothing': all
    -- codewords.
    stepSeen :: !(Maybe Int)
  }

-- | What to look at, the cheapest step first, until all codewords have been seen; by Note [Disjoint
-- information sets]. Given is how many codewords are looked at that differ in exactly w places of a
-- set.
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

-- | @changes q k w@: how many words differ from one given in exactly w of k places, over q symbols.
changes :: Int -> Int -> Int -> Natural
changes q k w
  | w > k = 0
  | otherwise =
    product (map fromIntegral [k - w + 1 .. k])
      `div` product (map fromIntegral [1 .. w])
      * fromIntegral (q - 1) ^ w

-- | Which of the codewords that are near are wanted.
data Wanted
  = -- | One of the nearest, of zero: a codeword stands for its multiples, and zero itself does not
    -- count.
    OneLightest
  | -- | All of them, if they are at most so many; of more only those nearer than some distance.
    AllUpTo Int

-- | Codewords that are near.
data Near k = Near
  { -- | All that were looked at and differ in at most so many of the other places are there.
    nearLimit :: !Int,
    -- | In how many of the other places each differs, and the combination of rows that it is.
    nearFound :: [(Int, [(Int, GF k)])]
  }

-- | @nearAt wanted set start w limit@: of the combinations of exactly w rows those that at the
-- other places differ from the start in at most so many as the limit.
nearAt ::
  forall k.
  KnownField k =>
  Wanted ->
  InformationSet k ->
  Vector (GF k) ->
  Int ->
  Int ->
  Near k
nearAt wanted set start w limit
  | limit < 0 || w > k = Near limit []
  | w == 0 = case wanted of
    AllUpTo most | differing <= limit -> kept most (Near limit [(differing, [])])
    _ -> Near limit []
  | otherwise =
    let Near most found = rowsFrom w 0 [] start (Near limit []) in Near most (reverse found)
  where
    k = setSize set
    multiples = setMultiples set
    differing = Primitive.foldl' (\n a -> if a == zero then n else n + 1) 0 start
    scalars = Primitive.fromList (drop 1 elements) :: Vector (GF k)
    -- Up to a factor, the first coefficient is 1.
    factors chosen = case (wanted, chosen) of
      (OneLightest, []) -> 1
      _ -> Primitive.length scalars
    -- So many rows more, from this one on, beside those chosen; and what the start is less the
    -- chosen ones.
    rowsFrom :: Int -> Int -> [(Int, GF k)] -> Vector (GF k) -> Near k -> Near k
    rowsFrom !left !from chosen !partial
      | left == 1 = lastRow from (factors chosen) chosen partial
      | otherwise = go from 0
      where
        many = factors chosen
        go !i !s near
          | i > k - left = near
          | s >= many = go (i + 1) 0 near
          | otherwise =
            let a = unsafeIndex scalars s
             in go i (s + 1)
                  $! rowsFrom
                    (left - 1)
                    (i + 1)
                    ((i, a) : chosen)
                    (addScaled (negate a) (parityRow set i) partial)
                    near
    -- The last one, which is compared with what is left of the start only as far as the limit.
    lastRow :: Int -> Int -> [(Int, GF k)] -> Vector (GF k) -> Near k -> Near k
    lastRow !from !many chosen !partial = go from 0
      where
        left = packed [partial]
        go !i !s near@(Near most _)
          | i >= k = near
          | s >= many = go (i + 1) 0 near
          | n <= most = go i (s + 1) $! hit (n, (i, unsafeIndex scalars s) : chosen) near
          | otherwise = go i (s + 1) near
          where
            n = differences multiples (i * Primitive.length scalars + s) left most
    hit new (Near most found) = case wanted of
      OneLightest -> Near (fst new - 1) [new]
      AllUpTo many -> kept many (Near most (new : found))

-- | Those that are held of them: while they are too many, the farthest are given up.
kept :: Int -> Near k -> Near k
kept many near@(Near most found)
  | length found <= many = near
  | otherwise = kept many (Near (most - 1) (filter ((< most) . fst) found))

-- | Words of elements, all of one length, one after the other, with as few bits an element as the
-- codes need: that many, 1, 2, 4 or 8; and so many machine words to each.
data Packed = Packed !Int !Int !(Vector Word64)

packed :: forall k. KnownField k => [Vector (GF k)] -> Packed
packed rows =
  Packed bits width (Primitive.concat (map (\x -> Primitive.generate width (machineWord x)) rows))
  where
    q = fieldOrder (Proxy :: Proxy k)
    bits = if q <= 2 then 1 else if q <= 4 then 2 else if q <= 16 then 4 else 8
    each = 64 `div` bits
    width = (maximum (0 : map Primitive.length rows) + each - 1) `div` each
    machineWord x i = Primitive.ifoldl' place 0 (Primitive.take each (Primitive.drop (i * each) x))
    place acc j a = acc .|. fromIntegral (toCode a) `unsafeShiftL` (j * bits)

-- | In how many elements one word, by its index, differs from the single one; counted on only until
-- it is more than the limit.
differences :: Packed -> Int -> Packed -> Int -> Int
differences (Packed bits width rows) !index (Packed _ _ single) !most = go 0 0
  where
    base = index * width
    go :: Int -> Int -> Int
    go !j !n
      | j >= width || n > most = n
      | otherwise =
        go (j + 1) (n + popCount (marks (unsafeIndex rows (base + j) `xor` unsafeIndex single j)))
    -- One bit an element that is not zero.
    marks x = case bits of
      1 -> x
      2 -> (x .|. x `unsafeShiftR` 1) .&. 0x5555555555555555
      4 -> let y = x .|. x `unsafeShiftR` 1 in (y .|. y `unsafeShiftR` 2) .&. 0x1111111111111111
      _ ->
        let y = x .|. x `unsafeShiftR` 1
            z = y .|. y `unsafeShiftR` 2
         in (z .|. z `unsafeShiftR` 4) .&. 0x0101010101010101
{-# INLINE differences #-}
