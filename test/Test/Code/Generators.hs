{-# LANGUAGE AllowAmbiguousTypes #-}
{-# LANGUAGE ExistentialQuantification #-}
{-# LANGUAGE RankNTypes #-}
{-# LANGUAGE TypeApplications #-}

-- | Fields, elements and arrays for the tests of the code wing.
module Test.Code.Generators
  ( -- * Fields
    SomeField (..),
    everyField,
    namedFields,
    fieldsUpTo,
    overField,
    ofField,
    gf2,
    gf3,
    gf4,

    -- * Elements
    genElement,
    shrinkElement,
    genElements,
    shrinkElements,

    -- * Arrays
    firstOver,
    folded,
    arrayOver,
    Setting,
    onArray,
    ofArray,
    mask,

    -- * Probabilities
    genChances,
    genChancesOf,
    module Test.Support,
  )
where

import Data.Proxy (Proxy (..))
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Polynomial
import PraTactile.Sequence
import PraTactile.Window
import Test.Hspec (Expectation, expectationFailure)
import Test.QuickCheck (Gen, Property, counterexample, shrinkList, vectorOf)
import qualified Test.QuickCheck as QuickCheck
import Test.Support

-- | A field that is known by its proxy.
data SomeField = forall k. KnownField k => SomeField (Proxy k)

-- | The fields up to 256 elements with their default moduli, by order.
everyField :: [(Int, SomeField)]
everyField =
  [ (fromIntegral q, field)
    | (q, (p, modulus)) <- conwayModuli,
      Right field <- [withField p modulus SomeField]
  ]

-- | The fields with a type of their own, by order.
namedFields :: [(Natural, SomeField)]
namedFields =
  [ (2, some @GF2),
    (3, some @GF3),
    (4, some @GF4),
    (5, some @GF5),
    (7, some @GF7),
    (8, some @GF8),
    (9, some @GF9),
    (16, some @GF16),
    (256, some @GF256)
  ]
  where
    some :: forall k. KnownField k => SomeField
    some = SomeField (Proxy :: Proxy k)

-- | The fields of 'everyField' up to this order.
fieldsUpTo :: Int -> [(Int, SomeField)]
fieldsUpTo q = takeWhile ((<= q) . fst) everyField

-- | Runs a test on the field of 'everyField' of this order.
overField :: Int -> (forall k. KnownField k => Proxy k -> Expectation) -> Expectation
overField q test = case lookup q everyField of
  Just (SomeField k) -> test k
  Nothing -> expectationFailure ("no field of order " ++ show q)

-- | A property of the field of 'everyField' of this order.
ofField :: Int -> (forall k. KnownField k => Proxy k -> Property) -> Property
ofField q law = case lookup q everyField of
  Just (SomeField k) -> law k
  Nothing -> counterexample ("no field of order " ++ show q) False

gf2 :: Proxy GF2
gf2 = Proxy

gf3 :: Proxy GF3
gf3 = Proxy

gf4 :: Proxy GF4
gf4 = Proxy

genElement :: KnownField k => Gen (GF k)
genElement = QuickCheck.elements elements

-- | Towards smaller codes.
shrinkElement :: KnownField k => GF k -> [GF k]
shrinkElement a = takeWhile (/= a) elements

genElements :: KnownField k => Int -> Gen [GF k]
genElements size = vectorOf size genElement

-- | Fewer elements, and smaller ones.
shrinkElements :: KnownField k => [GF k] -> [[GF k]]
shrinkElements = shrinkList shrinkElement

-- | The first primitive polynomial of a degree.
firstOver :: KnownField k => Proxy k -> Natural -> IO (Primitive k)
firstOver _ n = right (firstPrimitive n)

-- | The array of a primitive polynomial and the canonical state.
folded :: KnownField k => Folding -> Shape -> Primitive k -> Either FoldError (PseudorandomArray k)
folded folding shape h = fold folding shape h (canonicalState h)

-- | The array of the first primitive polynomial of a degree; a property of it is 'ofArray'.
arrayOver ::
  KnownField k => Proxy k -> Natural -> Folding -> Shape -> IO (PseudorandomArray k)
arrayOver k n folding shape = firstOver k n >>= right . folded folding shape

-- | The order of a field, a degree, a folding, the shape of an array, and that of its windows.
type Setting = (Int, Natural, Folding, Shape, Shape)

onArray ::
  Setting -> (forall k. KnownField k => PseudorandomArray k -> Mask -> Expectation) -> Expectation
onArray (q, n, folding, shape, window) test = overField q $ \k -> do
  array <- arrayOver k n folding shape
  right (rectangle window) >>= test array

-- | A property of the array of a setting, and of its window.
ofArray ::
  Setting -> (forall k. KnownField k => PseudorandomArray k -> Mask -> Property) -> Property
ofArray (q, n, folding, shape, window) law = ofField q $ \(_ :: Proxy k) ->
  whenRight (firstPrimitive n :: Either PolynomialError (Primitive k)) $ \h ->
    whenRight (folded folding shape h) $ \array -> whenRight (rectangle window) (law array)

-- | The mask of these offsets, row and column.
mask :: [(Natural, Natural)] -> Either WindowError Mask
mask = maskFrom . map (uncurry Position)

-- | Of each cell of a patch of one to three rows and columns the probabilities of four symbols in
-- 64ths, or nothing.
genChances :: Gen [[Maybe [Integer]]]
genChances = do
  h <- QuickCheck.choose (1, 3)
  w <- QuickCheck.choose (1, 3)
  genChancesOf h w

-- | The same of this many rows and columns.
genChancesOf :: Int -> Int -> Gen [[Maybe [Integer]]]
genChancesOf h w = vectorOf h (vectorOf w cell)
  where
    cell = do
      gone <- QuickCheck.choose (0, 4 :: Int)
      if gone == 0 then pure Nothing else Just <$> chances
    chances = do
      a <- QuickCheck.choose (0, 64)
      b <- QuickCheck.choose (0, 64 - a)
      c <- QuickCheck.choose (0, 64 - a - b)
      QuickCheck.shuffle [a, b, c, 64 - a - b - c]
