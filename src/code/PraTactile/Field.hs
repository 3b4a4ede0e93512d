{-# LANGUAGE AllowAmbiguousTypes #-}
{-# LANGUAGE FlexibleContexts #-}
{-# LANGUAGE FlexibleInstances #-}
{-# LANGUAGE GeneralizedNewtypeDeriving #-}
{-# LANGUAGE RankNTypes #-}
{-# LANGUAGE TypeApplications #-}
{-# LANGUAGE UnboxedTuples #-}
{-# LANGUAGE UndecidableInstances #-}

-- | The symbols of the alphabet: elements of GF(q), where q = p^m is a prime power up to 256
-- (section II of the paper). They are bytes with table arithmetic. The field is an index of the
-- type, so elements of different fields cannot be mixed. 'withField' makes that index from a
-- characteristic and a modulus that are known only at run time.
module PraTactile.Field
  ( -- * Fields
    Field (Over),
    KnownField,
    withField,
    fieldOrder,
    fieldCharacteristic,
    fieldDegree,
    fieldModulus,

    -- * Elements
    GF,
    zero,
    one,
    primitive,
    elements,
    toCode,
    fromCode,
    elementsFromCodes,

    -- * Arithmetic beyond 'Num'
    inverse,
    divide,
    power,
    logarithm,

    -- * Writing and reading
    showElement,
    parseElement,

    -- * Errors
    FieldError (..),
  )
where

import Data.Char (isDigit, ord)
import Data.List (foldl')
import Data.Proxy (Proxy (..))
import Data.Reflection (Reifies, reflect, reify)
import Data.Vector.Primitive (Prim, unsafeIndex)
import qualified Data.Vector.Primitive as Primitive
import Data.Word (Word8)
import Numeric.Natural (Natural)
import PraTactile.Field.Conway (NamedField (..))
import PraTactile.Field.Kind (Field (..))
import PraTactile.Field.Tables
import Text.Read (readMaybe)

-- | An element of the field k, stored as its code: the integer whose base-p digits are the
-- coefficients, lowest degree first. 'Ord' is the order of the codes; 'Show' is 'showElement'.
newtype GF (k :: Field) = GF Word8
  deriving newtype (Eq, Ord, Prim)

type role GF nominal

-- | Fields whose arithmetic tables are known: those named in "PraTactile.Field.Named", and those
-- that 'withField' brings into scope. The tables are made once for each field.
class KnownField (k :: Field) where
  tables :: Tables

instance NamedField ('Over p modulus) => KnownField ('Over p modulus) where
  tables = namedTables @('Over p modulus)

instance Reifies s Tables => KnownField ('RunTime s) where
  tables = reflect (Proxy @s)

-- | Applies a function to the field GF(p)[x] / f, given p and the modulus f, constant term first.
-- The function gets a 'Proxy' that names the field. Refuses, each with its own 'FieldError', a p
-- that is not prime, an order above 256, and a modulus that is constant, not monic, not reduced
-- modulo p, or reducible. O(q^2 m), where m is the degree of f; each call makes tables of 130 kB.
--
-- >>> withField 2 [1, 1, 1] fieldOrder
-- Right 4
-- >>> withField 2 [1, 0, 1] fieldOrder
-- Left (ModulusReducible 2 [1,0,1])
withField :: Natural -> [Natural] -> (forall k. KnownField k => Proxy k -> r) -> Either FieldError r
withField p modulus use = do
  checked <- checkedTables p modulus
  pure (reify checked (use . runTime))
  where
    runTime :: Proxy s -> Proxy ('RunTime s)
    runTime _ = Proxy

-- | The number of elements, q. The argument only names the field.
fieldOrder :: forall k proxy. KnownField k => proxy k -> Int
fieldOrder _ = tableOrder (tables @k)

-- | The prime p of which q is a power. The argument only names the field.
fieldCharacteristic :: forall k proxy. KnownField k => proxy k -> Int
fieldCharacteristic _ = tableCharacteristic (tables @k)

-- | The exponent m in q = p^m. The argument only names the field.
fieldDegree :: forall k proxy. KnownField k => proxy k -> Int
fieldDegree _ = tableDegree (tables @k)

-- | The modulus, constant term first. The argument only names the field.
fieldModulus :: forall k proxy. KnownField k => proxy k -> [Natural]
fieldModulus _ = tableModulus (tables @k)

{- Note [Rows of 256]
   ~~~~~~~~~~~~~~~~~~
   The product of codes a and b is entry 256 a + b of a table of 65536. Since a and b are bytes,
   every index is within the table. So the types alone make it safe to omit the bounds check,
   without an invariant to keep elsewhere. Rows of q would save memory for small fields. But safety
   would then depend on correct use of the constructor, and the inner loop would need q. In a small
   field, a row uses few cache lines. -}

-- | Index by two bytes; the table has 65536 entries.
at2 :: Primitive.Vector Word8 -> Word8 -> Word8 -> Word8
at2 table a b = unsafeIndex table (fromIntegral a * 256 + fromIntegral b)
{-# INLINE at2 #-}

-- | Index by one byte; the table has 256 entries.
at1 :: Primitive.Vector Word8 -> Word8 -> Word8
at1 table a = unsafeIndex table (fromIntegral a)
{-# INLINE at1 #-}

-- | 'fromInteger' is the ring map from Z, so 2 is 0 in GF(4); 'fromCode' reads codes. A finite
-- field has no compatible order, so 'abs' is the identity, and 'signum' is 1 except at 0. This
-- keeps @abs x * signum x == x@.
instance KnownField k => Num (GF k) where
  GF a + GF b = GF (at2 (tableSum (tables @k)) a b)
  {-# INLINE (+) #-}
  GF a - GF b = GF (at2 (tableSum (tables @k)) a (at1 (tableNegate (tables @k)) b))
  {-# INLINE (-) #-}
  GF a * GF b = GF (at2 (tableProduct (tables @k)) a b)
  {-# INLINE (*) #-}
  negate (GF a) = GF (at1 (tableNegate (tables @k)) a)
  {-# INLINE negate #-}
  abs = id
  signum x = if x == zero then zero else one
  fromInteger n = GF (fromInteger (n `mod` toInteger (tableCharacteristic (tables @k))))

instance KnownField k => Show (GF k) where
  showsPrec _ = showString . showElement

-- | The neutral element of addition; code 0.
zero :: GF k
zero = GF 0

-- | The neutral element of multiplication; code 1.
one :: GF k
one = GF 1

-- | The element with the smallest code among those of multiplicative order q - 1. For a Conway
-- modulus it is A, the modulus's root.
primitive :: forall k. KnownField k => GF k
primitive = GF (tablePrimitive (tables @k))

-- | All q elements by increasing code. O(q).
elements :: forall k. KnownField k => [GF k]
elements = map (GF . fromIntegral) [0 .. tableOrder (tables @k) - 1]

-- | The code of an element: 0 <= code < q.
toCode :: GF k -> Int
toCode (GF a) = fromIntegral a
{-# INLINE toCode #-}

-- | The element of a code. Refuses codes outside 0 ... q - 1.
fromCode :: forall k. KnownField k => Int -> Either FieldError (GF k)
fromCode code
  | 0 <= code && code < q = Right (GF (fromIntegral code))
  | otherwise = Left (CodeOutOfRange (toInteger code) (fromIntegral q))
  where
    q = tableOrder (tables @k)

-- | The elements of a list of codes. Refuses codes not below q. O(k) for k codes.
elementsFromCodes :: forall k. KnownField k => [Natural] -> Either FieldError [GF k]
elementsFromCodes = traverse element
  where
    element c
      | c < q = fromCode (fromIntegral c)
      | otherwise = Left (CodeOutOfRange (toInteger c) q)
    q = fromIntegral (tableOrder (tables @k))

-- | The multiplicative inverse. Refuses zero.
inverse :: forall k. KnownField k => GF k -> Either FieldError (GF k)
inverse (GF 0) = Left DivisionByZero
inverse (GF a) = Right (GF (at1 (tableInverse (tables @k)) a))

-- | @divide a b@ is a / b. Refuses b = 0.
divide :: KnownField k => GF k -> GF k -> Either FieldError (GF k)
divide a b = (a *) <$> inverse b

-- | A power with any exponent, at the cost of two look-ups; @power 0 0@ is 1.
power :: forall k. KnownField k => GF k -> Natural -> GF k
power a n = case logarithm a of
  Just l -> GF (at1 (tablePower (tables @k)) (fromInteger (toInteger l * toInteger n `mod` units)))
  Nothing -> if n == 0 then one else zero
  where
    units = toInteger (tableOrder (tables @k)) - 1

-- | The exponent 0 <= e < q - 1 with 'primitive' ^ e equal to the element; 'Nothing' for zero.
logarithm :: forall k. KnownField k => GF k -> Maybe Int
logarithm (GF 0) = Nothing
logarithm (GF a) = Just (fromIntegral (at1 (tableLogarithm (tables @k)) a))

-- | An element as 0, 1, A, A^2, ...: a power of A = 'primitive'.
showElement :: KnownField k => GF k -> String
showElement a = case logarithm a of
  Nothing -> "0"
  Just 0 -> "1"
  Just 1 -> "A"
  Just e -> "A^" ++ show e

-- | Reads a code (@3@) or a power of A = 'primitive' (@A@, @A^2@; exponents of any size). Refuses
-- codes not below q and any other text. O(k) for k characters.
parseElement :: forall k. KnownField k => String -> Either FieldError (GF k)
parseElement text = case text of
  "A" -> Right primitive
  'A' : '^' : digits@(_ : _)
    | all isDigit digits -> Right (power primitive (remainderBy (q - 1) digits))
  _ : _
    | all isDigit text, null (drop 3 significant), code < q -> Right (GF (fromIntegral code))
    | all isDigit text, Just large <- readMaybe text -> Left (CodeOutOfRange large q)
  _ -> Left (ElementUnreadable text)
  where
    q = fromIntegral (tableOrder (tables @k)) :: Natural
    significant = dropWhile (== '0') text
    code = remainderBy 1000 significant
    -- The number written by the digits, modulo n.
    remainderBy :: Natural -> String -> Natural
    remainderBy n = foldl' (\r d -> (10 * r + fromIntegral (ord d - ord '0')) `mod` n) 0
