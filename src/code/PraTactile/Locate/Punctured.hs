{-# LANGUAGE BangPatterns #-}

-- | A code of which cells are missing: each set of observed cells makes another code, a punctured
-- one, with a minimum distance and weights of its own (F. J. MacWilliams and N. J. A. Sloane 1977,
-- chapter 1). All 2^n sets are visited, once for all shares of missing cells; kept is what the
-- rates of decoding depend on.
module PraTactile.Locate.Punctured
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

-- | The sets of so many observed cells that are alike in what they guarantee.
data PuncturedClass = PuncturedClass
  { -- | How many cells are observed.
    classCells :: !Int,
    -- | The least weight that a word has in them: 0 if they do not tell the words apart.
    classDistance :: !Int,
    -- | Whether exactly one word is zero in them. Over GF(2) it can be told from the others all the
    -- same.
    classLoneZero :: !Bool,
    -- | How many such sets there are.
    classSets :: !Int,
    -- | How many words have each weight, in all these sets together.
    classWeights :: [(Int, Int)]
  }
  deriving stock (Eq, Show)

-- | 25: the most cells for which all sets are visited.
mostErasedCells :: Int
mostErasedCells = 25

-- | 2^33: the most words of all sets together, which take some seconds.
mostErasedWork :: Natural
mostErasedWork = 2 ^ (33 :: Int)

-- | The punctured codes of the words with these supports, in n cells: bit i for the cell i, if it
-- is not zero. To be given are all words but zero, also those with equal supports. 'Nothing' beyond
-- 'mostErasedCells' or 'mostErasedWork'.
punctured :: Int -> [Int] -> Maybe Punctured
punctured n supports
  | n < 1 || n > mostErasedCells || null supports || 2 ^ n
      * fromIntegral
        ( length
            supports
        )
      > mostErasedWork =
    Nothing
  | otherwise =
    Just (Punctured n (length supports) (minimum (map popCount supports)) (classesOf n unit counts))
  where
    repeated = Map.fromListWith (+) [(x, 1) | x <- supports]
    -- The multiples of a word have its support, so that one visit is worth all of them.
    unit = foldr gcd 0 (Map.elems repeated)
    visited = concat [replicate (k `div` unit) x | (x, k) <- Map.toList repeated]
    counts =
      countSets
        n
        (unit == 1)
        (length visited)
        [packed [if testBit x i then 1 else 0 | x <- visited] | i <- [0 .. n - 1]]

-- | Numbers below 256, eight in a machine word, the first one lowest.
packed :: [Word64] -> Vector Word64
packed = Primitive.fromList . go
  where
    go numbers = case splitAt 8 numbers of
      ([], _) -> []
      (eight, others) -> foldr (\x word -> word `shiftL` 8 .|. x) 0 eight : go others

-- | The classes, from 'countSets'.
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

-- | The numbers of all classes: of so many words, given for each cell as whether each is not zero
-- there, and with whether a word that is visited once is one word. Depth first, a cell taken or not
-- at each step, so that the weights of all words are kept up by a few additions of eight at a time.
countSets :: Int -> Bool -> Int -> [Vector Word64] -> Vector Int
countSets n single count cells = Primitive.create $ do
  counts <- Mutable.replicate (classAt n n (n + 2)) 0
  weights <- Mutable.replicate ((n + 1) * wide) 0
  tally <- Mutable.replicate 512 0
  visit counts weights tally 0 0
  pure counts
  where
    wide = (count + 7) `div` 8
    ones = Primitive.concat cells
    -- The last word's bytes that belong to no word count as zeros.
    spare = 8 * wide - count
    -- What the first k cells leave of the weights is in row k; m of them are observed.
    visit :: MVector s Int -> MVector s Word64 -> MVector s Int -> Int -> Int -> ST s ()
    visit counts weights tally = go
      where
        go !k !m
          | k == n = leaf m
          | otherwise = do
            along
              ( \i ->
                  Mutable.unsafeRead weights (k * wide + i)
                    >>= Mutable.unsafeWrite weights ((k + 1) * wide + i)
              )
            go (k + 1) m
            along
              ( \i ->
                  Mutable.unsafeModify
                    weights
                    (+ Primitive.unsafeIndex ones (k * wide + i))
                    ((k + 1) * wide + i)
              )
            go (k + 1) (m + 1)
        along act = each 0
          where
            each !i
              | i == wide = pure ()
              | otherwise = act i >> each (i + 1)
        {-# INLINE along #-}
        -- Two tallies in turn: neighbours are often equal, and one number cannot be counted up
        -- twice at once.
        leaf m = do
          Mutable.set (Mutable.unsafeTake (2 * n + 2) tally) 0
          Mutable.unsafeWrite tally 0 (negate spare)
          along (\i -> Mutable.unsafeRead weights (n * wide + i) >>= bytes)
          least <- firstFrom 0
          zeros <- (+) <$> Mutable.unsafeRead tally 0 <*> Mutable.unsafeRead tally 1
          let class' = classAt n m (if least == 0 && single && zeros == 1 then n + 1 else least)
          Mutable.unsafeModify counts (+ 1) class'
          let add !w
                | w > n = pure ()
                | otherwise = do
                  a <- Mutable.unsafeRead tally (2 * w)
                  b <- Mutable.unsafeRead tally (2 * w + 1)
                  Mutable.unsafeModify counts (+ (a + b)) (class' + w + 1)
                  add (w + 1)
          add least
        bytes word = do
          up (2 * (word .&. 255))
          up (2 * (word `shiftR` 8 .&. 255) + 1)
          up (2 * (word `shiftR` 16 .&. 255))
          up (2 * (word `shiftR` 24 .&. 255) + 1)
          up (2 * (word `shiftR` 32 .&. 255))
          up (2 * (word `shiftR` 40 .&. 255) + 1)
          up (2 * (word `shiftR` 48 .&. 255))
          up (2 * (word `shiftR` 56) + 1)
        up = Mutable.unsafeModify tally (+ 1) . fromIntegral
        -- There is a word, and its weight is at most n.
        firstFrom !w
          | w >= n = pure n
          | otherwise = do
            a <- Mutable.unsafeRead tally (2 * w)
            b <- Mutable.unsafeRead tally (2 * w + 1)
            if a + b > 0 then pure w else firstFrom (w + 1)
