{-# LANGUAGE BangPatterns #-}

-- | The likelihoods of all positions of many arrays, added up, where those of each one are not
-- asked for: of a sequence's decimations, all folded as it is.
--
-- Let a sequence s(0), s(1), ... of period N be folded so that each cell has a t of its own and the
-- term s(t). Its right neighbour has s(t + b), and the cell at an offset s(t + k), b and k by the
-- fold alone: they are the same for every decimation s(r t), and no array is made. The terms at t,
-- t + b, t + 2 b, ... are looked up together, by the number that they are the digits of.
module PraTactile.Locate.Decoder.Total
  ( Folded (..),
    totalLikelihood,
  )
where

import Data.Bits (unsafeShiftR, (.&.))
import Data.List (foldl', genericLength, sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (mapMaybe)
import Data.Ord (Down (..))
import qualified Data.Set as Set
import Data.Vector.Primitive (Vector)
import qualified Data.Vector.Primitive as Primitive
import Data.Word (Word16, Word8)
import PraTactile.Grid

-- | A sequence as it is folded.
data Folded = Folded
  { foldedSurface :: !Surface,
    foldedShape :: !Shape,
    -- | the size q of the alphabet
    foldedAlphabet :: !Int,
    -- | one period, as many terms as there are cells
    foldedTerms :: !(Vector Word8),
    -- | which term a cell has; beyond each row and column the same further on, modulo the period
    foldedIndex :: Position -> Int
  }

-- | The logarithm of the sum of likelihoods over the decimations by these r, each coprime to the
-- period N and less than it; these ways of seeing some cells; and all positions on the surface. A
-- way has the cells by their offsets, each with how likely every symbol makes what is seen there;
-- the likelihood of a position is the product over its cells. Likelihoods below 10^-308 of the
-- largest that is conceivable count as 0. O(m N) for m cells for each r and way.
totalLikelihood :: Folded -> [Int] -> [[(Position, Vector Double)]] -> Double
totalLikelihood folded rs ways = case sortOn (Down . wayMost) (concatMap (waysOn folded) ways) of
  [] -> -1 / 0
  seen@(likeliest : _) -> unit + log (foldl' addArray 0 rs)
    where
      unit = wayMost likeliest
      addArray sofar r = foldl' (addWay (numbersOf folded r)) sofar seen
      addWay numbers sofar way
        -- All its terms in all arrays would not show.
        | most * genericLength rs * size <= sofar * 2 ** (-53) = sofar
        | otherwise = sofar + most * overPlaces numbers way
        where
          most = exp (wayMost way - unit)
      size = fromIntegral (Primitive.length (foldedTerms folded))

-- | A way of seeing cells from some positions.
data Way = Way
  { -- | the logarithm of the largest likelihood that is conceivable
    wayMost :: !Double,
    -- | for each t 1 if it is one of the positions, else 0
    wayPlaces :: !(Vector Double),
    -- | runs of terms, by how far after t they begin, each with the likelihood of every number
    -- relative to the most
    wayRuns :: [(Int, Vector Double)]
  }

-- | A way of seeing cells, one for all positions from which these are the same terms further on:
-- all of them on the sheet and on the surface by which the fold goes on; on another surface also
-- one for those where cells lie beyond the last column.
waysOn :: Folded -> [(Position, Vector Double)] -> [Way]
waysOn folded unsorted =
  [ Way most (places bands) (runsOf folded (zip further given))
    | not (isInfinite most),
      (further, bands) <- Map.toList (Map.fromListWith (++) [(from one, [one]) | one <- allBands])
  ]
  where
    surface = foldedSurface folded
    shape = foldedShape folded
    size = Primitive.length (foldedTerms folded)
    most = sum (map (log . Primitive.maximum . snd) cells)
    cells = sortOn fst unsorted
    given = [Primitive.map (/ Primitive.maximum one) one | (_, one) <- cells]
    Shape high wide = admissible surface shape (extentOf (map fst cells))
    -- However far apart cells are, on a torus none is further than all around.
    offsets = mapMaybe (displaced surface shape (Position 0 0) . fst) cells
    -- Of the columns between two of these the same cells lie beyond the last one.
    cuts = Set.toAscList (Set.fromList (0 : wide : filter (< wide) beyond))
    beyond = [columns shape - j | Position _ j <- offsets]
    allBands = [band | high > 0, band <- zip cuts (drop 1 cuts)]
    from (first, _) =
      [ (foldedIndex folded at - foldedIndex folded here) `mod` size
        | offset <- offsets,
          let here = Position 0 first,
          Just at <- [displaced surface shape here offset]
      ]
    places bands =
      Primitive.replicate size 0
        Primitive.// [ (foldedIndex folded (Position i j), 1)
                       | i <- naturalsBelow high,
                         (first, end) <- bands,
                         j <- [first .. end - 1]
                     ]

-- | How many terms are looked up together: at most so many that a table of what they can be stays
-- at hand.
runLength :: Folded -> Int
runLength folded = length (takeWhile (<= 1024) (iterate (* q) q))
  where
    q = foldedAlphabet folded

-- | How far a cell's right neighbour is.
rightward :: Folded -> Int
rightward folded = foldedIndex folded (Position 0 1)

-- | Runs that have the terms that are so far on, each with the likelihoods of its symbols.
runsOf :: Folded -> [(Int, Vector Double)] -> [(Int, Vector Double)]
runsOf folded known = case known of
  [] -> []
  (from, _) : _ -> (from, table [(q ^ i, given) | (Just i, given) <- digits]) : runsOf folded others
    where
      digits = [(digit (term - from), given) | (term, given) <- known]
      others = [one | (one, (Nothing, _)) <- zip known digits]
  where
    q = foldedAlphabet folded
    size = Primitive.length (foldedTerms folded)
    digit further = lookup (further `mod` size) (zip multiples [0 .. runLength folded - 1])
    multiples = [i * rightward folded `mod` size | i <- [0 ..]]
    table these =
      Primitive.generate (q ^ runLength folded) $ \number ->
        product [given Primitive.! (number `div` unit `mod` q) | (unit, given) <- these]

-- | From each t on, twice around, the number of the run that begins there, in the decimation by r;
-- its first digit is the least.
numbersOf :: Folded -> Int -> Vector Word16
numbersOf folded r = twice (foldl' longer digits [2 .. runLength folded])
  where
    q = fromIntegral (foldedAlphabet folded)
    b = rightward folded
    size = Primitive.length (foldedTerms folded)
    !digits =
      Primitive.map
        (fromIntegral . Primitive.unsafeIndex (foldedTerms folded))
        (Primitive.iterateN size further 0)
    -- r further, less the period unless that is negative.
    further t = let beyond = t + r - size in beyond + (size .&. (beyond `unsafeShiftR` 63))
    longer known _ =
      let around = twice known
       in Primitive.imap (\t digit -> digit + q * Primitive.unsafeIndex around (t + b)) digits
    twice numbers = numbers <> numbers

-- | The sum of the likelihoods of all positions, relative to the most.
overPlaces :: Vector Word16 -> Way -> Double
overPlaces numbers way = Primitive.sum (times (wayRuns way) (wayPlaces way))
  where
    -- Two runs at a time, so that products are read and written half as often. All numbers are in
    -- their tables.
    times runs !known = case runs of
      [] -> known
      [(from, f)] -> Primitive.imap (\t x -> x * value f (from + t)) known
      (from, f) : (from', f') : others ->
        times others $
          Primitive.imap (\t x -> x * (value f (from + t) * value f' (from' + t))) known
    value f t = Primitive.unsafeIndex f (fromIntegral (Primitive.unsafeIndex numbers t))
