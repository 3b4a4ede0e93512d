{-# OPTIONS_HADDOCK hide #-}

-- | The conventions of a profile in sentences, for somebody whose implementation answered something
-- else, and what records of operations under a profile have in common.
module PraTactile.Conformance.Operations.Conventions
  ( -- * Conventions
    digitsOf,
    modulusOf,
    sequenceRule,
    foldingRule,
    packingRule,
    surfaceText,
    of',

    -- * Definitions
    codeIn,
    refuseFor,
    orRefusal,
    tooLong,
    leastOfList,
    toTenPlaces,

    -- * Inputs
    orderIn,
    largeNumbers,
    lessNatural,
    lessList,
    lessPatch,
    oneLess,
    fewer,
    pairsLess,
    fewCases,
  )
where

import Data.List (intercalate, transpose)
import Numeric.Natural (Natural)
import PraTactile.Array (Folding (..), Shape (Shape), Surface (..))
import PraTactile.Conformance.Definition.Array (ProfileFacts, knownProfile)
import PraTactile.Conformance.Question
import PraTactile.Profile (Profile (..), Reading (..))
import PraTactile.Window (Packing (..))
import Test.QuickCheck (shrinkIntegral)

-- | A sentence on the profile.
of' :: (Profile -> String) -> ProfileFacts -> String
of' sentence = sentence . knownProfile

-- | The digits of a code.
digitsOf :: Profile -> String
digitsOf p =
  "a code's base-p digits, p the characteristic of GF(" ++ show (profileOrder p)
    ++ "), are the coefficients of a polynomial, lowest degree first"

-- | The modulus.
modulusOf :: Profile -> String
modulusOf p = listed (profileModulus p) ++ " (constant term first)"

-- | The recurrence of the sequence.
sequenceRule :: Profile -> String
sequenceRule p =
  "s(i+n) = - (c0 s(i) + ... + c(n-1) s(i+n-1)) with c = " ++ listed (profilePolynomial p)
    ++ readAs
    ++ ", from the state "
    ++ listed (profileState p)
  where
    readAs = case profileReading p of
      Characteristic -> ", the characteristic polynomial"
      Reciprocal -> " read backwards and made monic, since the profile states the reciprocal"

-- | The folding.
foldingRule :: Profile -> String
foldingRule p = case profileFolding p of
  Diagonal -> "a[i mod " ++ show n1 ++ "][i mod " ++ show n2 ++ "] = s(i)"
  RowMajor -> "a[r][c] = s(" ++ show n2 ++ " r + c)"
  where
    Shape n1 n2 = profileShape p

-- | The packing of windows.
packingRule :: Profile -> String
packingRule p =
  "the number to the base " ++ show (profileOrder p) ++ " whose " ++ first
    ++ " significant digit is the first cell"
  where
    first = case profilePacking p of
      MostSignificantFirst -> "most"
      LeastSignificantFirst -> "least"

-- | The surface.
surfaceText :: Profile -> String
surfaceText p = case profileSurface p of
  Torus -> "torus"
  TwistedTorus -> "twisted torus, where the next row follows the last column"
  Sheet -> "sheet, which ends at its edges"

listed :: [Natural] -> String
listed = intercalate "," . map show

-- Definitions.

-- | The element of a code, or a refusal.
codeIn :: ProfileFacts -> Code -> Either Refusal Int
codeIn k a
  | a < orderIn k = Right (fromIntegral a)
  | otherwise = refuseFor "invalid"

refuseFor :: String -> Either Refusal a
refuseFor = Left . Refusal

orRefusal :: String -> Maybe a -> Either Refusal a
orRefusal reason = maybe (refuseFor reason) Right

-- | The reason for an answer that does not fit in a line of the protocol.
tooLong :: (String, String)
tooLong = ("too-long", "the answer exceeds a line of 1 MiB")

-- | The least number of bytes of a list of so many codes: a digit each, and what stands around it.
leastOfList :: Natural -> Natural
leastOfList count = 2 * count + 1

-- | Rounded to ten decimal places.
toTenPlaces :: Double -> Double
toTenPlaces x = fromInteger (round (x * 1e10)) / 1e10

-- Inputs.

-- | q.
orderIn :: ProfileFacts -> Natural
orderIn = profileOrder . knownProfile

-- | Numbers of 1 to 41 digits.
largeNumbers :: [Natural]
largeNumbers = [7, 2 ^ (53 :: Int) + 1, 10 ^ (19 :: Int) + 7, 10 ^ (40 :: Int) + 3]

-- | Whether so many cases are few enough to list all.
fewCases :: Natural -> Bool
fewCases n = n <= 1024

-- | Towards 0, the largest step first.
lessNatural :: Natural -> [Natural]
lessNatural n = [fromInteger i | i <- shrinkIntegral (toInteger n), i >= 0]

-- | With one of both numbers smaller.
pairsLess :: (Natural, Natural) -> [(Natural, Natural)]
pairsLess (a, b) = [(c, b) | c <- lessNatural a] ++ [(a, d) | d <- lessNatural b]

-- | One element less, from either end, or one of them smaller.
lessList :: (a -> [a]) -> [a] -> [[a]]
lessList less xs = fewer xs ++ oneLess less xs

-- | One row or column less, or one of the cells with less in it.
lessPatch :: (a -> [a]) -> [[a]] -> [[[a]]]
lessPatch less rows =
  filter (any (not . null)) (fewer rows ++ map transpose (fewer (transpose rows)))
    ++ oneLess (oneLess less) rows

-- | Without the first, and without the last.
fewer :: [a] -> [[a]]
fewer xs = case xs of
  [] -> []
  [_] -> []
  _ : rest -> [rest, init xs]

-- | With one of them smaller.
oneLess :: (a -> [a]) -> [a] -> [[a]]
oneLess less xs =
  [ before ++ x' : after
    | (before, x : after) <- map (`splitAt` xs) [0 .. length xs - 1],
      x' <- less x
  ]
