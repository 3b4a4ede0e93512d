{-# OPTIONS_HADDOCK hide #-}

-- | The tables behind "PraTactile.Field": the run-time value of a field index, and how it is built
-- and checked. Internal.
module PraTactile.Field.Tables
  ( -- * Tables
    Tables (..),
    checkedTables,
    trustedTables,

    -- * Errors
    FieldError (..),
    largestOrder,
  )
where

import Data.Bits (xor)
import Data.List (find, foldl')
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Primitive as Primitive
import Data.Word (Word8)
import Numeric.Natural (Natural)

-- | Why there is no such field, or no such element.
data FieldError
  = -- | The characteristic is not a prime.
    NotPrime Natural
  | -- | p^m, with this p and m, exceeds 256, the largest alphabet.
    FieldTooLarge Natural Natural
  | -- | The modulus has degree less than 1.
    ModulusConstant [Natural]
  | -- | The modulus has this leading coefficient instead of 1.
    ModulusNotMonic Natural
  | -- | The first number, a coefficient of the modulus, is not below the second, p.
    CoefficientOutOfRange Natural Natural
  | -- | The modulus factors over GF(p), so there are divisors of zero.
    ModulusReducible Natural [Natural]
  | -- | There is no field with this many elements.
    NotAPrimePower Natural
  | -- | The first number, a code, is negative or not below the second, the order.
    CodeOutOfRange Integer Natural
  | -- | Zero has no inverse.
    DivisionByZero
  | -- | The text is neither a code nor a power of A.
    ElementUnreadable String
  deriving stock (Eq, Show)

-- | 256: an element fits a byte.
largestOrder :: Natural
largestOrder = 256

-- | A field as look-up tables over codes. Tables of two arguments have rows of 256 for every order:
-- see Note [Rows of 256] in "PraTactile.Field".
data Tables = Tables
  { tableCharacteristic :: !Int,
    tableDegree :: !Int,
    tableOrder :: !Int,
    tableModulus :: [Natural],
    -- | the smallest code of order q - 1
    tablePrimitive :: !Word8,
    -- | 256 x 256
    tableSum :: !(Primitive.Vector Word8),
    -- | 256 x 256
    tableProduct :: !(Primitive.Vector Word8),
    -- | 256
    tableNegate :: !(Primitive.Vector Word8),
    -- | 256; the entry of 0 is 0 and never used
    tableInverse :: !(Primitive.Vector Word8),
    -- | 256; the entry of 0 is 0 and never used
    tableLogarithm :: !(Primitive.Vector Word8),
    -- | 256; the powers of the primitive element, entry i for exponent i < q - 1
    tablePower :: !(Primitive.Vector Word8)
  }

-- | The tables of GF(p)[x] / f. Refuses what is not a field of at most 256 elements. See Note [When
-- the modulus is good].
checkedTables :: Natural -> [Natural] -> Either FieldError Tables
checkedTables p modulus
  | p > largestOrder = Left (FieldTooLarge p (max 1 m))
  | not (isSmallPrime p) = Left (NotPrime p)
  | m > 8 = Left (FieldTooLarge p m)
  | length modulus < 2 = Left (ModulusConstant modulus)
  | p ^ m > largestOrder = Left (FieldTooLarge p m)
  | Just c <- find (>= p) modulus = Left (CoefficientOutOfRange c p)
  | leading /= 1 = Left (ModulusNotMonic leading)
  | otherwise = case primitiveCodes codes of
    [] -> Left (ModulusReducible p modulus)
    g : _ -> Right (buildTables codes g)
  where
    -- The list may be infinite; degree 9 is too large for every p.
    m = fromIntegral (length (take 10 modulus)) - min 1 (fromIntegral (length (take 1 modulus)))
    leading = foldl' (\_ c -> c) 0 modulus
    codes = codeArithmetic p modulus

-- | The tables of a named field. They are not checked here; the test suite checks these fields.
trustedTables :: Natural -> [Natural] -> Tables
trustedTables p modulus = buildTables codes (fromMaybe 1 (find (const True) (primitiveCodes codes)))
  where
    codes = codeArithmetic p modulus

isSmallPrime :: Natural -> Bool
isSmallPrime p = p >= 2 && all (\d -> p `mod` d /= 0) (takeWhile (\d -> d * d <= p) [2 ..])

{- Note [When the modulus is good]
   ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
   Z_p[x]/f has q elements. If one of them has q - 1 distinct nonzero powers that return to 1, all
   nonzero elements are units and the ring is a field. Conversely, the multiplicative group of a
   field is cyclic, so a field has such an element. Hence f is irreducible iff an element of order q
   - 1 exists, and the search for the primitive element is also the check. -}

-- | Arithmetic on codes, enough to fill the tables. It multiplies by Horner's rule on base-p
-- digits, unlike "PraTactile.Field.Definition", which convolves and divides.
data CodeArithmetic = CodeArithmetic
  { codePrime :: !Int,
    codeDegree :: !Int,
    codeOrder :: !Int,
    codeModulus :: [Natural],
    codeAdd :: Int -> Int -> Int,
    codeMultiply :: Int -> Int -> Int
  }

-- | The arithmetic for p and a modulus. It expects p^m <= 256 and a monic modulus of degree m >= 1.
codeArithmetic :: Natural -> [Natural] -> CodeArithmetic
codeArithmetic prime modulus = CodeArithmetic p m q modulus add multiply
  where
    p = fromIntegral prime :: Int
    m = length modulus - 1
    q = p ^ m
    add a b
      | p == 2 = a `xor` b
      | otherwise = fromDigits (zipWith (\x y -> (x + y) `mod` p) (digits a) (digits b))
    scale d a = fromDigits (map (\x -> d * x `mod` p) (digits a))
    -- x^m = - (f - x^m)
    reduced = fromDigits [(p - fromIntegral c) `mod` p | c <- take m modulus]
    timesX a = let (top, rest) = (a * p) `divMod` q in add rest (scale top reduced)
    multiply a b = foldl' (\acc d -> add (timesX acc) (scale d b)) 0 (reverse (digits a))
    digits a = take m (map (`mod` p) (iterate (`div` p) a))
    fromDigits = foldr (\d rest -> d + p * rest) 0

-- | The codes of order q - 1, in increasing order.
primitiveCodes :: CodeArithmetic -> [Int]
primitiveCodes codes = filter hasFullOrder [1 .. q - 1]
  where
    q = codeOrder codes
    hasFullOrder g = go (1 :: Int) g
      where
        go i x
          | x == 1 = i == q - 1
          | i >= q - 1 = False
          | otherwise = go (i + 1) (codeMultiply codes g x)

buildTables :: CodeArithmetic -> Int -> Tables
buildTables codes g =
  Tables
    { tableCharacteristic = codePrime codes,
      tableDegree = codeDegree codes,
      tableOrder = q,
      tableModulus = codeModulus codes,
      tablePrimitive = fromIntegral g,
      tableSum = binary (codeAdd codes),
      tableProduct = binary times,
      tableNegate = unary (\a -> fromMaybe 0 (find (\b -> codeAdd codes a b == 0) [0 .. q - 1])),
      tableInverse = unary (\a -> if a == 0 then 0 else powerOf (q - 1 - logOf a)),
      tableLogarithm = logarithms,
      tablePower = powers
    }
  where
    q = codeOrder codes
    cycle1 = take (q - 1) (iterate (codeMultiply codes g) 1)
    powers = Primitive.fromListN 256 (map fromIntegral cycle1 ++ repeat 0)
    logarithms = Primitive.replicate 256 0 Primitive.// zip cycle1 [0 ..]
    -- Codes and exponents are below 256, the length of the tables.
    powerOf i = fromIntegral (powers Primitive.! (i `mod` (q - 1))) :: Int
    logOf a = fromIntegral (logarithms Primitive.! a) :: Int
    times a b
      | a == 0 || b == 0 = 0
      | otherwise = powerOf (logOf a + logOf b)
    unary f = Primitive.generate 256 (\a -> if a < q then fromIntegral (f a) else 0)
    binary f =
      Primitive.generate 65536 $ \i ->
        let (a, b) = i `divMod` 256 in if a < q && b < q then fromIntegral (f a b) else 0
