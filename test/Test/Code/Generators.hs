{-# LANGUAGE AllowAmbiguousTypes #-}
{-# LANGUAGE ExistentialQuantification #-}
{-# LANGUAGE RankNTypes #-}
{-# LANGUAGE TypeApplications #-}

-- | Fields, elements and arrays for the tests of the code wing.
module Test.Code.Generators
  ( -- * Fields
    SomeField (..),
    everyField,
    fieldsUpTo,
    overField,
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
import Test.QuickCheck (Gen, shrinkList, vectorOf)
import qualified Test.QuickCheck as QuickCheck
import Test.Support

-- | A field with its name in "PraTactile.Field.Named".
data SomeField = forall k. KnownField k => SomeField (Proxy k)

-- | The named fields, by order.
everyField :: [(Int, SomeField)]
everyField =
  [ (2, some @GF2),
    (3, some @GF3),
    (4, some @GF4),
    (5, some @GF5),
    (7, some @GF7),
    (8, some @GF8),
    (9, some @GF9),
    (11, some @GF11),
    (13, some @GF13),
    (16, some @GF16),
    (17, some @GF17),
    (19, some @GF19),
    (23, some @GF23),
    (25, some @GF25),
    (27, some @GF27),
    (29, some @GF29),
    (31, some @GF31),
    (32, some @GF32),
    (37, some @GF37),
    (41, some @GF41),
    (43, some @GF43),
    (47, some @GF47),
    (49, some @GF49),
    (53, some @GF53),
    (59, some @GF59),
    (61, some @GF61),
    (64, some @GF64),
    (67, some @GF67),
    (71, some @GF71),
    (73, some @GF73),
    (79, some @GF79),
    (81, some @GF81),
    (83, some @GF83),
    (89, some @GF89),
    (97, some @GF97),
    (101, some @GF101),
    (103, some @GF103),
    (107, some @GF107),
    (109, some @GF109),
    (113, some @GF113),
    (121, some @GF121),
    (125, some @GF125),
    (127, some @GF127),
    (128, some @GF128),
    (131, some @GF131),
    (137, some @GF137),
    (139, some @GF139),
    (149, some @GF149),
    (151, some @GF151),
    (157, some @GF157),
    (163, some @GF163),
    (167, some @GF167),
    (169, some @GF169),
    (173, some @GF173),
    (179, some @GF179),
    (181, some @GF181),
    (191, some @GF191),
    (193, some @GF193),
    (197, some @GF197),
    (199, some @GF199),
    (211, some @GF211),
    (223, some @GF223),
    (227, some @GF227),
    (229, some @GF229),
    (233, some @GF233),
    (239, some @GF239),
    (241, some @GF241),
    (243, some @GF243),
    (251, some @GF251),
    (256, some @GF256)
  ]
  where
    some :: forall k. KnownField k => SomeField
    some = SomeField (Proxy :: Proxy k)

-- | Those of at most this order.
fieldsUpTo :: Int -> [(Int, SomeField)]
fieldsUpTo q = takeWhile ((<= q) . fst) everyField

-- | The same of the named field of this order.
overField :: Int -> (forall k. KnownField k => Proxy k -> Expectation) -> Expectation
overField q test = case lookup q everyField of
  Just (SomeField k) -> test k
  Nothing -> expectationFailure ("no field of order " ++ show q)

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

-- | The array of the first primitive polynomial of a degree.
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
