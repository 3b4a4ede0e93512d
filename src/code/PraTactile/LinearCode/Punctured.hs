{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | A code of which cells are missing: each set of observed cells makes another code, a punctured
-- one, with a minimum distance and weights of its own (F. J. MacWilliams and N. J. A. Sloane 1977,
-- chapter 1). All 2^n sets are visited, once for all shares of missing cells; kept is what the
-- rates of decoding depend on.
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

-- | The punctured codes of a code, counted.
data Punctured = Punctured
  { -- | The number n of all cells.
    puncturedCells :: !Int,
    -- | The number of words, zero left out.
    puncturedWords :: !Int,
    -- | The least weight of a word; 0 if there is none.
    puncturedDistance :: !Int,
    -- | The classes that occur.
    puncturedClasses :: [PuncturedClass]
  }
  deriving stock (Eq, Show)

-- | The sets of one number of observed cells that are alike in what they guarantee.
data PuncturedClass = PuncturedClass
  { -- | How many cells are observed.
    classCells :: !Int,
    -- | The least weight that a word has in them: 0 if two words are alike in them.
    classDistance :: !Int,
    -- | Whether exactly one word is zero in them. Over GF(2) no other word is like it all the same.
    classLoneZero :: !Bool,
    -- | How many such sets there are.
    classSets :: !Int,
    -- | How many words have each weight, in all these sets.
    classWeights :: [(Int, Int)]
  }
  deriving stock (Eq, Show)

-- | 25: the most cells for which all sets are visited.
mostErasedCells :: Int
mostErasedCells = 25

-- | 2^33: the most words, those of all sets added up, which take some seconds.
mostErasedWork :: Natural
mostErasedWork = 2 ^ (33 :: Int)

-- | The punctured codes of the words with these supports, in n cells: bit i for the cell i, if it
-- is not zero. To be given are all words but zero, also those with equal supports. 'Nothing' beyond
-- 'mostErasedCells' or 'mostErasedWork'.
punctured :: Int -> [Int] -> Maybe Punctured
punctured n supports
  | n < 1 || n > mostErasedCells || null supports || work > mostErasedWork = Nothing
  | otherwise =
    Just (Punctured n (length supports) (minimum (map popCount supports)) (classesOf n unit counts))
  where
    work = 2 ^ n * fromIntegral (length supports)
    repeated = Map.fromListWith (+) [(x, 1) | x <- supports]
    -- The multiples of a word have its support, so that one visit stands for all of them.
    unit = foldr gcd 0 (Map.elems repeated)
    visited = concat [replicate (k `div` unit) x | (x, k) <- Map.toList repeated]
    counts =
      countSets
        n
        unit
        (length visited)
        [packed [if testBit x i then 1 else 0 | x <- visited] | i <- [0 .. n - 1]]

-- | Numbers below 256, eight in a machine word, the first one lowest.
packed :: [Word64] -> Vector Word64
packed = Primitive.fromList . go
  where
    go numbers = case splitAt 8 numbers of
      ([], _) -> []
      (eight, others) -> foldr (\x word -> word `shiftL` 8 .|. x) 0 eight : go others

-- | The classes, from the numbers that @countSets@ gives.
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

-- | Where the n + 2 numbers of a class are, by the number of its cells and its least weight: how
-- many sets, and how many words of weight 0, 1, ..., n. A least weight of n + 1 stands for a lone
-- zero.
classAt :: Int -> Int -> Int -> Int
classAt n m c = (m * (n + 2) + c) * (n + 2)

-- | What is counted in: the numbers of all classes; in row k the weights of all words in the first
-- k cells, as far as these are observed; and how many words of one set have each weight, in two
-- tallies.
data Scratch s = Scratch !(MVector s Int) !(MVector s Word64) !(MVector s Int)

-- | What is the same for all sets: n; how many words one that is visited stands for; how many
-- machine words a row has; how many bytes of the last of these belong to no word; and in row k,
-- whether each word is not zero in the cell k.
data Words = Words !Int !Int !Int !Int !(Vector Word64)

-- | @countSets n unit count cells@: the numbers of all classes, of words that stand for as many as
-- the unit each, given for each cell as whether each is not zero there. Depth first, a cell taken
-- or not at each step, so that the weights of all words are kept up by a few additions of eight at
-- a time.
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

-- | Visit all sets, depth first.
visit :: forall s. Words -> Scratch s -> ST s ()
visit given@(Words n _ size _ ones) scratch@(Scratch _ weights _) = go 0 0
  where
    -- Of the first k cells m are observed.
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

-- | A set of m cells: count it, and the weights of all words in it.
leaf :: Words -> Scratch s -> Int -> ST s ()
leaf (Words n unit size spare _) (Scratch counts weights tally) !m = do
  Mutable.set (Mutable.unsafeTake (2 * n + 2) tally) 0
  -- The bytes that belong to no word have the weight 0.
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

-- | Count the eight bytes of a machine word, in two tallies in turn: neighbours are often equal,
-- and one number cannot be counted up twice at once.
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

-- | Act on 0, 1, ..., below a number.
forBelow :: Int -> (Int -> ST s ()) -> ST s ()
forBelow size act = go 0
  where
    go !i
      | i >= size = pure ()
      | otherwise = act i >> go (i + 1)
{-# INLINE forBelow #-}
