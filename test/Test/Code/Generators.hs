{-# LANGUAGE ExistentialQuantification #-}

-- | Fields, elements and arrays for the tests of the code wing.
module Test.Code.Generators
  ( -- * Fields
    SomeField (..),
    everyField,
    fieldsUpTo,

    -- * Elements
    genElement,
    shrinkElement,
    genElements,
    shrinkElements,

    -- * Arrays
    paperPrimitive,
    firstOver,
    folded,
    mask,

    -- * Probabilities
    genChances,
    genChancesOf,

    -- * Answers
    right,
    holds,
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
import Test.Hspec (Expectation, HasCallStack, expectationFailure)
import Test.QuickCheck (Gen, shrinkList, vectorOf)
import qualified Test.QuickCheck as QuickCheck

-- | A field with its name in "PraTactile.Field.Named".
data SomeField = forall k. KnownField k => SomeField (Proxy k)

-- | The named fields, by order.
everyField :: [(Int, SomeField)]
everyField =
  [ (2, SomeField (Proxy :: Proxy GF2)),
    (3, SomeField (Proxy :: Proxy GF3)),
    (4, SomeField (Proxy :: Proxy GF4)),
    (5, SomeField (Proxy :: Proxy GF5)),
    (7, SomeField (Proxy :: Proxy GF7)),
    (8, SomeField (Proxy :: Proxy GF8)),
    (9, SomeField (Proxy :: Proxy GF9)),
    (11, SomeField (Proxy :: Proxy GF11)),
    (13, SomeField (Proxy :: Proxy GF13)),
    (16, SomeField (Proxy :: Proxy GF16)),
    (17, SomeField (Proxy :: Proxy GF17)),
    (19, SomeField (Proxy :: Proxy GF19)),
    (23, SomeField (Proxy :: Proxy GF23)),
    (25, SomeField (Proxy :: Proxy GF25)),
    (27, SomeField (Proxy :: Proxy GF27)),
    (29, SomeField (Proxy :: Proxy GF29)),
    (31, SomeField (Proxy :: Proxy GF31)),
    (32, SomeField (Proxy :: Proxy GF32)),
    (37, SomeField (Proxy :: Proxy GF37)),
    (41, SomeField (Proxy :: Proxy GF41)),
    (43, SomeField (Proxy :: Proxy GF43)),
    (47, SomeField (Proxy :: Proxy GF47)),
    (49, SomeField (Proxy :: Proxy GF49)),
    (53, SomeField (Proxy :: Proxy GF53)),
    (59, SomeField (Proxy :: Proxy GF59)),
    (61, SomeField (Proxy :: Proxy GF61)),
    (64, SomeField (Proxy :: Proxy GF64)),
    (67, SomeField (Proxy :: Proxy GF67)),
    (71, SomeField (Proxy :: Proxy GF71)),
    (73, SomeField (Proxy :: Proxy GF73)),
    (79, SomeField (Proxy :: Proxy GF79)),
    (81, SomeField (Proxy :: Proxy GF81)),
    (83, SomeField (Proxy :: Proxy GF83)),
    (89, SomeField (Proxy :: Proxy GF89)),
    (97, SomeField (Proxy :: Proxy GF97)),
    (101, SomeField (Proxy :: Proxy GF101)),
    (103, SomeField (Proxy :: Proxy GF103)),
    (107, SomeField (Proxy :: Proxy GF107)),
    (109, SomeField (Proxy :: Proxy GF109)),
    (113, SomeField (Proxy :: Proxy GF113)),
    (121, SomeField (Proxy :: Proxy GF121)),
    (125, SomeField (Proxy :: Proxy GF125)),
    (127, SomeField (Proxy :: Proxy GF127)),
    (128, SomeField (Proxy :: Proxy GF128)),
    (131, SomeField (Proxy :: Proxy GF131)),
    (137, SomeField (Proxy :: Proxy GF137)),
    (139, SomeField (Proxy :: Proxy GF139)),
    (149, SomeField (Proxy :: Proxy GF149)),
    (151, SomeField (Proxy :: Proxy GF151)),
    (157, SomeField (Proxy :: Proxy GF157)),
    (163, SomeField (Proxy :: Proxy GF163)),
    (167, SomeField (Proxy :: Proxy GF167)),
    (169, SomeField (Proxy :: Proxy GF169)),
    (173, SomeField (Proxy :: Proxy GF173)),
    (179, SomeField (Proxy :: Proxy GF179)),
    (181, SomeField (Proxy :: Proxy GF181)),
    (191, SomeField (Proxy :: Proxy GF191)),
    (193, SomeField (Proxy :: Proxy GF193)),
    (197, SomeField (Proxy :: Proxy GF197)),
    (199, SomeField (Proxy :: Proxy GF199)),
    (211, SomeField (Proxy :: Proxy GF211)),
    (223, SomeField (Proxy :: Proxy GF223)),
    (227, SomeField (Proxy :: Proxy GF227)),
    (229, SomeField (Proxy :: Proxy GF229)),
    (233, SomeField (Proxy :: Proxy GF233)),
    (239, SomeField (Proxy :: Proxy GF239)),
    (241, SomeField (Proxy :: Proxy GF241)),
    (243, SomeField (Proxy :: Proxy GF243)),
    (251, SomeField (Proxy :: Proxy GF251)),
    (256, SomeField (Proxy :: Proxy GF256))
  ]

-- | Those of at most this order.
fieldsUpTo :: Int -> [(Int, SomeField)]
fieldsUpTo q = takeWhile ((<= q) . fst) everyField

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

-- | x^4 + x^2 + A x + A^2 over GF(4).
paperPrimitive :: Either PolynomialError (Primitive GF4)
paperPrimitive = checkPrimitive (polynomial [a * a, a, 1, 0, 1])
  where
    a = primitive

-- | The first primitive polynomial of a degree.
firstOver :: KnownField k => Proxy k -> Natural -> IO (Primitive k)
firstOver _ n = right (firstPrimitive n)

-- | The array of a primitive polynomial and the canonical state.
folded :: KnownField k => Folding -> Shape -> Primitive k -> Either FoldError (PseudorandomArray k)
folded folding shape h = fold folding shape h (canonicalState h)

-- | The mask of these offsets, row and column.
mask :: [(Natural, Natural)] -> Either WindowError Mask
mask = maskFrom . map (uncurry Position)

-- | The answer, or a failure of the test that shows the refusal.
right :: (HasCallStack, Show e) => Either e a -> IO a
right = either (\e -> expectationFailure' (show e)) pure
  where
    expectationFailure' message = expectationFailure message >> fail message

-- | Of each cell of a patch of one to three rows and columns the probabilities of four symbols in
-- 64ths, or nothing.
genChances :: Gen [[Maybe [Integer]]]
genChances = do
  h <- QuickCheck.choose (1, 3)
  w <- QuickCheck.choose (1, 3)
  genChancesOf h w

-- | The same of so many rows and columns.
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

-- | A property holds in so many cases.
holds :: QuickCheck.Testable p => Int -> p -> Expectation
holds count p =
  QuickCheck.quickCheckWithResult
    QuickCheck.stdArgs {QuickCheck.chatty = False, QuickCheck.maxSuccess = count}
    p
    >>= \r -> case r of
      QuickCheck.Success {} -> pure ()
      _ -> expectationFailure (QuickCheck.output r)
