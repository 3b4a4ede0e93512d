-- | A decoder written from the documentation alone, with each of its steps as a value that can be
-- exchanged: how elements are added and multiplied, which way the polynomial is read, where the
-- sequence begins, how it is folded, what lies beyond the edges, how windows are packed. With
-- 'rightWays' it is right. An impostor is this decoder with one step wrong.
module PraTactile.Conformance.Impostors.Ways
  ( Ways (..),
    rightWays,

    -- * Steps
    Cell,
    digitwise,
    productModulo,
    inverseBy,
    characteristic,
    sizes,
    onTorus,
    onTwisted,
    onSheet,
    surfaceStep,
    statedTaps,
  )
where

import Data.List (foldl')
import Numeric.Natural (Natural)
import PraTactile.Array (Folding (..), Shape (..), Surface (..))
import PraTactile.Profile (Profile (..), Reading (..))
import PraTactile.Window (Packing (..))

-- | Row and column, in the array or beyond it.
type Cell = (Integer, Integer)

-- | The steps from a profile to an array.
data Ways = Ways
  { -- | the sum of two codes
    plus :: Profile -> Int -> Int -> Int,
    -- | the product of two codes
    times :: Profile -> Int -> Int -> Int,
    -- | the negative of a code
    minus :: Profile -> Int -> Int,
    -- | what the sum of the terms, each times its coefficient, becomes as the next term
    nextTerm :: Profile -> Int -> Int,
    -- | c0, ..., c(n-1), given the product of codes
    taps :: Profile -> [Int],
    -- | s(0), ..., s(n-1)
    start :: Profile -> [Int],
    -- | an index of any size, as one of the period
    withinPeriod :: Profile -> Integer -> Integer,
    -- | the index of the term that a cell of the array holds
    folded :: Profile -> Cell -> Integer,
    -- | where a cell that is asked for is in the array
    goesOn :: Profile -> Cell -> Maybe Cell,
    -- | where a cell that is compared is on the profile's surface
    lies :: Profile -> Cell -> Maybe Cell,
    -- | a window's cells, the most significant digit first
    packed :: Profile -> [Int] -> [Int]
  }

-- | All as documented.
rightWays :: Ways
rightWays =
  Ways
    { plus = digitwise (+),
      times = \p -> productModulo p (profileModulus p),
      minus = negated,
      nextTerm = negated,
      taps = statedTaps profileReading,
      start = map fromIntegral . profileState,
      withinPeriod = \p i -> i `mod` (toInteger (profileOrder p) ^ degree p - 1),
      folded = \p -> case profileFolding p of
        Diagonal -> diagonal p
        RowMajor -> \(r, c) -> r * snd (sizes p) + c,
      goesOn = \p -> case profileFolding p of
        Diagonal -> onTorus p
        RowMajor -> onTwisted p,
      lies = \p -> surfaceStep (profileSurface p) p,
      packed = \p -> case profilePacking p of
        MostSignificantFirst -> id
        LeastSignificantFirst -> reverse
    }
  where
    negated p = digitwise (\_ b -> -b) p 0
    degree p = length (profilePolynomial p) - 1

-- | The rows and columns of the array.
sizes :: Profile -> (Integer, Integer)
sizes p = (toInteger n1, toInteger n2)
  where
    Shape n1 n2 = profileShape p

surfaceStep :: Surface -> Profile -> Cell -> Maybe Cell
surfaceStep surface = case surface of
  Torus -> onTorus
  TwistedTorus -> onTwisted
  Sheet -> onSheet

onTorus, onTwisted, onSheet :: Profile -> Cell -> Maybe Cell
onTorus p (r, c) = Just (r `mod` n1, c `mod` n2)
  where
    (n1, n2) = sizes p
onTwisted p (r, c) = Just ((r + c `div` n2) `mod` n1, c `mod` n2)
  where
    (n1, n2) = sizes p
onSheet p (r, c)
  | r >= 0 && c >= 0 && r < n1 && c < n2 = Just (r, c)
  | otherwise = Nothing
  where
    (n1, n2) = sizes p

-- | The index that is the row modulo n1 and the column modulo n2: n1 steps at a time from the row
-- on, until the column fits.
diagonal :: Profile -> Cell -> Integer
diagonal p (r, c) = case [i | i <- [r, r + n1 .. n1 * n2 - 1], i `mod` n2 == c] of
  i : _ -> i
  [] -> 0
  where
    (n1, n2) = sizes p

-- | The prime that q is a power of.
characteristic :: Profile -> Int
characteristic p = case [i | i <- [2 .. q], q `mod` i == 0] of
  least : _ -> least
  [] -> 2
  where
    q = fromIntegral (profileOrder p)

-- | The digits of both to the base p combined one by one, modulo p.
digitwise :: (Int -> Int -> Int) -> Profile -> Int -> Int -> Int
digitwise combine p a b
  | a == 0 && b == 0 = 0
  | otherwise =
    combine (a `mod` base) (b `mod` base) `mod` base + base
      * digitwise
        combine
        p
        (a `div` base)
        (b `div` base)
  where
    base = characteristic p

-- | The product of polynomials over the prime field, modulo this one.
productModulo :: Profile -> [Natural] -> Int -> Int -> Int
productModulo p modulus a b = foldl' step 0 (reverse (digits b))
  where
    base = characteristic p
    add = digitwise (+) p
    step total digit = add (shifted total) (scaled digit a)
    scaled k x = iterate (add x) 0 !! k
    -- Times the root: one digit up, and the leading one replaced by the modulus.
    shifted x =
      let (leading, rest) = (x * base) `divMod` size
       in iterate (add lower) rest !! leading
    size = base ^ (length modulus - 1)
    lower =
      sum
        [ ((base - fromIntegral c) `mod` base) * base ^ i
          | (i, c) <-
              zip
                [0 :: Int ..]
                (take (length modulus - 1) modulus)
        ]
    digits x = if x == 0 then [] else x `mod` base : digits (x `div` base)

-- | The code whose product with this one is 1; 0 if there is none.
inverseBy :: (Int -> Int -> Int) -> Int -> Int -> Int
inverseBy multiply q a = case [b | b <- [1 .. q - 1], multiply a b == 1] of
  b : _ -> b
  [] -> 0

-- | The coefficients below the leading one, read as is said.
statedTaps :: (Profile -> Reading) -> Profile -> [Int]
statedTaps reading p = case reading p of
  Characteristic -> init' stated
  Reciprocal -> case stated of
    c : _ ->
      map
        (multiply (inverseBy multiply (fromIntegral (profileOrder p)) c))
        (init' (reverse stated))
    [] -> []
  where
    stated = map fromIntegral (profilePolynomial p)
    multiply = productModulo p (profileModulus p)
    init' xs = take (length xs - 1) xs
