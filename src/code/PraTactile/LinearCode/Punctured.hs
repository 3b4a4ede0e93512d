{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Punctured codes: each set of observed cells gives a code with its own minimum distance and
-- weights (F. J. MacWilliams and N. J. A. Sloane 1977, chapter 1). All 2^n sets of n cells are
-- visited, once for all shares of missing cells. The result contains what the rates of decoding
-- depend on.
module PraTactile.LinearCode.Punctured
  ( Punctured,
    punctured,
    mostErasedCells,
    mostErasedWork,

    -- * What was counted
    puncturedCells,
    puncturedWords,
    puncturedDistance,
    puncturedClasses,
    PuncturedClass (..),
  )
where

import Control.Monad.ST (ST)
import Data.Bits (popCount, shiftL, shiftR, testBit, (.&.), (.|.))
import qualified Data.Map.Strict as Map
import Data.Vector.Primitive (MVector, Vector)
import qualified Data.Vector.Primitive as Primitive
import qualified Data.Vector.Primitive.Mutable as Mutable
import Data.Word (Word64)
import Numeric.Natural (Natural)

-- | Counts over all punctured codes of a code, one for each set of observed cells.
data Punctured = Punctured
  { -- | The number n of all cells.
    puncturedCells :: !Int,
    -- | The number of nonzero words.
    puncturedWords :: !Int,
    -- | The least weight of a nonzero word; 0 if there is none.
    puncturedDistance :: !Int,
    -- | The classes of sets that occur.
    puncturedClasses :: [PuncturedClass]
  }
  deriving stock (Eq, Show)

-- | The sets that have the same number of observed cells and the same least weight.
data PuncturedClass = PuncturedClass
  { -- | The number of observed cells.
    classCells :: !Int,
    -- | The least weight of a nonzero word in these cells: 0 if two words are equal in them.
    classDistance :: !Int,
    -- | Whether exactly one nonzero word is zero in these cells. Over GF(2) it is then still not
    -- equal to any other nonzero word.
    classLoneZero :: !Bool,
    -- | The number of such sets.
    classSets :: !Int,
    -- | The number of words with each weight, over all these sets.
    classWeights :: [(Int, Int)]
  }
  deriving stock (Eq, Show)

-- | The most cells for which all sets are visited, 25.
mostErasedCells :: Int
mostErasedCells = 25

-- | The most words over all sets, 2^33, which take some seconds.
mostErasedWork :: Natural
mostErasedWork = 2 ^ (33 :: Int)

-- | The punctured codes of the words with these supports in n cells: bit i is set if the word is
-- nonzero in cell i. All nonzero words must be listed, including those with equal supports.
-- 'Nothing' beyond 'mostErasedCells' or 'mostErasedWork'.
punctured :: Int -> [Int] -> Maybe Punctured
punctured n supports
  | n < 1 || n > mostErasedCells || null supports || work > mostErasedWork = Nothing
  | otherwise =
    Just (Punctured n (length supports) (minimum (map popCount supports)) (classesOf n unit counts))
  where
    work = 2 ^ n * fromIntegral (length supports)
    repeated = Map.fromListWith (+) [(x, 1) | x <- supports]
    -- The multiples of a word have its support, so one visit counts for all of them.
    unit = foldr gcd 0 (Map.elems repeated)
    visited = concat [replicate (k `div` unit) x | (x, k) <- Map.toList repeated]
    counts =
      countSets
        n
        unit
        (length visited)
        [packed [if testBit x i then 1 else 0 | x <- visited] | i <- [0 .. n - 1]]

-- | Packs numbers below 256, eight in a machine word, the first one lowest.
packed :: [Word64] -> Vector Word64
packed = Primitive.fromList . go
  where
    go numbers = case splitAt 8 numbers of
      ([], _) -> []
      (eight, others) -> foldr (\x word -> word `shiftL` 8 .|. x) 0 eight : go others

-- | The classes, from the result of 'countSets'. Arguments: n; the number of words that one visited
-- word counts for; the counts.
classesOf :: Int -> Int -> Vector Int -> [PuncturedClass]
classesOf n unit counts =
  [ PuncturedClass
      m
      (if c > n then 0 else c)
      (c > n)
      sets
      [(w, unit * k) | w <- [0 .. n], let k = at (w + 1), k > 0]
    | m <- [0 .. n],
      c <- [0 .. n + 1],
      let at i = counts Primitive.! (classAt n m c + i)
          sets = at 0,
      sets > 0
  ]

-- | The index of the n + 2 counts of a class, given n, the number of its cells and its least
-- weight: the number of sets, then the numbers of words with weight 0, 1, ..., n. The least weight
-- n + 1 stands for a lone zero.
classAt :: Int -> Int -> Int -> Int
classAt n m c = (m * (n + 2) + c) * (n + 2)

-- | The memory for counting: the counts of all classes; row k with the weights of all words in the
-- first k cells, as far as they are observed; and the numbers of words of one set with each weight,
-- in two tallies.
data Scratch s = Scratch !(MVector s Int) !(MVector s Word64) !(MVector s Int)

-- | The data that all sets share: n; the number of words that one visited word counts for; the
-- number of machine words in a row; the number of unused bytes in the last one; and for each cell
-- k, whether each word is nonzero there.
data Words = Words !Int !Int !Int !Int !(Vector Word64)

-- | @countSets n unit count cells@ gives the counts of all classes. There are count words, each
-- counting for unit words; for each cell, the list says whether each word is nonzero there. The
-- search is depth first and takes or leaves one cell at each step. So the weights of all words are
-- updated by a few additions of eight at a time.
countSets :: Int -> Int -> Int -> [Vector Word64] -> Vector Int
countSets n unit count cells = Primitive.create $ do
  counts <- Mutable.replicate (classAt n n (n + 2)) 0
  weights <- Mutable.replicate ((n + 1) * wide) 0
  tally <- Mutable.replicate 512 0
  let given = Words n unit wide (8 * wide - count) (Primitive.concat cells)
  visit given (Scratch counts weights tally)
  pure counts
  where
    wide = (count + 7) `div` 8

-- | Visits all sets, depth first.
visit :: forall s. Words -> Scratch s -> ST s ()
visit given@(Words n _ size _ ones) scratch@(Scratch _ weights _) = go 0 0
  where
    -- Of the first k cells, m are observed.
    go :: Int -> Int -> ST s ()
    go !k !m
      | k == n = leaf given scratch m
      | otherwise = do
        forBelow size $ \i ->
          Mutable.unsafeRead weights (k * size + i)
            >>= Mutable.unsafeWrite weights ((k + 1) * size + i)
        go (k + 1) m
        forBelow size $ \i ->
          Mutable.unsafeModify
            weights
            (+ Primitive.unsafeIndex ones (k * size + i))
            ((k + 1) * size + i)
        go (k + 1) (m + 1)

-- | Counts a set of m cells and the weights of all words in it.
leaf :: Words -> Scratch s -> Int -> ST s ()
leaf (Words n unit size spare _) (Scratch counts weights tally) !m = do
  Mutable.set (Mutable.unsafeTake (2 * n + 2) tally) 0
  -- The unused bytes have weight 0.
  Mutable.unsafeWrite tally 0 (negate spare)
  forBelow size $ \i -> Mutable.unsafeRead weights (from + i) >>= tallyBytes tally
  least <- firstFrom 0
  zeros <- tallied 0
  let loneZero = least == 0 && unit * zeros == 1
      class' = classAt n m (if loneZero then n + 1 else least)
  Mutable.unsafeModify counts (+ 1) class'
  forBelow (n + 1 - least) $ \i -> do
    words' <- tallied (least + i)
    Mutable.unsafeModify counts (+ words') (class' + least + i + 1)
  where
    !from = n * size
    tallied w = (+) <$> Mutable.unsafeRead tally (2 * w) <*> Mutable.unsafeRead tally (2 * w + 1)
    -- There is a word, and its weight is at most n.
    firstFrom !w
      | w >= n = pure n
      | otherwise = do
        words' <- tallied w
        if words' > 0 then pure w else firstFrom (w + 1)
{-# INLINE leaf #-}

-- | Counts the eight bytes of a machine word in two alternating tallies. Neighbours are often
-- equal, and one counter cannot be increased twice at once.
tallyBytes :: MVector s Int -> Word64 -> ST s ()
tallyBytes tally word = do
  up (2 * (word .&. 255))
  up (2 * (word `shiftR` 8 .&. 255) + 1)
  up (2 * (word `shiftR` 16 .&. 255))
  up (2 * (word `shiftR` 24 .&. 255) + 1)
  up (2 * (word `shiftR` 32 .&. 255))
  up (2 * (word `shiftR` 40 .&. 255) + 1)
  up (2 * (word `shiftR` 48 .&. 255))
  up (2 * (word `shiftR` 56) + 1)
  where
    up = Mutable.unsafeModify tally (+ 1) . fromIntegral
{-# INLINE tallyBytes #-}

-- | Runs an action for 0, 1, ..., below a number.
forBelow :: Int -> (Int -> ST s ()) -> ST s ()
forBelow size act = go 0
  where
    go !i
      | i >= size = pure ()
      | otherwise = act i >> go (i + 1)
{-# INLINE forBelow #-}
