{-# LANGUAGE GADTs #-}

-- | Why the definition answers a question so, in a sentence for somebody whose implementation
-- answered something else: the convention of the profile that decides it, or the rule of a refusal.
module PraTactile.Conformance.Laws.Why
  ( why,
  )
where

import Data.List (intercalate)
import Numeric.Natural (Natural)
import PraTactile.Array (Folding (..), Shape (..), Surface (..))
import PraTactile.Conformance.Question
import PraTactile.Profile (Profile (..), Reading (..))
import PraTactile.Window (Packing (..))

-- | The reason, given the profile, the question, and what the definition says.
why :: Profile -> Question a -> Either Refusal a -> String
why p question wanted = case wanted of
  Left (Refusal reason) -> refusedSince question reason
  Right _ -> case operationOf question of
    OfAdd -> digits p ++ ": they are added digit by digit modulo the characteristic"
    OfNegate -> digits p ++ ": each digit is negated modulo the characteristic"
    OfMultiply -> digits p ++ ", multiplied as polynomials and reduced modulo " ++ modulus p
    OfInverse -> "the product of both is 1, reduced modulo " ++ modulus p
    OfPower -> "a product of as many factors, modulo " ++ modulus p ++ "; a^-i = (1/a)^i; 0^0 = 1"
    OfLogarithm ->
      "the least exponent to the base that is the smallest code of order q - 1, modulo "
        ++ modulus p
    OfTrace ->
      "a + a^p + a^(p^2) + ..., with as many summands as the modulus " ++ modulus p
        ++ " has degree"
    operation -> ofTheArray p operation

-- | Where sequence, array, windows and places come from.
ofTheArray :: Profile -> Operation -> String
ofTheArray p operation = case operation of
  OfPrimitive -> "monic, of degree n > 0, with x of order q^n - 1 modulo the polynomial"
  OfFirstPrimitive ->
    "polynomials in the order that compares coefficients from the highest \
    \degree down"
  OfTerm -> sequenceOf p
  OfTerms -> sequenceOf p
  OfCell -> foldingOf p
  OfPack -> packingOf p
  OfUnpack -> packingOf p
  OfLocate ->
    "the memory table of all complete windows on the " ++ surfaceOf p ++ "; "
      ++ foldingOf p
  OfNearest -> "the observed cells, compared with those at every position of the " ++ surfaceOf p
  OfPosterior ->
    "Bayes: the product of the probabilities of the symbols at each position of the "
      ++ surfaceOf p
      ++ ", divided by their sum"
  OfProve ->
    "all windows of the mask on the " ++ surfaceOf p
      ++ ", compared; the rank on the surface of the fold"
  OfDistance -> "the least number of cells in which two windows differ, on the surface of the fold"
  _ -> "by definition"

digits :: Profile -> String
digits p =
  "the digits of a code to the base p, p the characteristic of GF(" ++ show (profileOrder p)
    ++ "), are the coefficients of a polynomial, lowest degree first"

modulus :: Profile -> String
modulus p = codes (profileModulus p) ++ " (constant term first)"

sequenceOf :: Profile -> String
sequenceOf p =
  "s(i+n) = - (c0 s(i) + ... + c(n-1) s(i+n-1)) with c = " ++ codes (profilePolynomial p)
    ++ readAs
    ++ ", from the state "
    ++ codes (profileState p)
  where
    readAs = case profileReading p of
      Characteristic -> ", the characteristic polynomial"
      Reciprocal -> " read backwards and made monic, since the profile states the reciprocal"

foldingOf :: Profile -> String
foldingOf p = case profileFolding p of
  Diagonal -> "a[i mod " ++ show n1 ++ "][i mod " ++ show n2 ++ "] = s(i)"
  RowMajor -> "a[r][c] = s(" ++ show n2 ++ " r + c)"
  where
    Shape n1 n2 = profileShape p

packingOf :: Profile -> String
packingOf p =
  "the number to the base " ++ show (profileOrder p) ++ " whose " ++ first
    ++ " significant digit is the first cell"
  where
    first = case profilePacking p of
      MostSignificantFirst -> "most"
      LeastSignificantFirst -> "least"

surfaceOf :: Profile -> String
surfaceOf p = case profileSurface p of
  Torus -> "torus"
  TwistedTorus -> "twisted torus, where the next row follows on the last column"
  Sheet -> "sheet, which ends at its edges"

codes :: [Natural] -> String
codes = intercalate "," . map show

-- | The rule of a refusal.
refusedSince :: Question a -> String -> String
refusedSince question reason = case reason of
  "invalid" -> "the input is none that the operation takes"
  "division-by-zero" -> "0 has no inverse"
  "out-of-range" -> case operationOf question of
    OfLogarithm -> "0 is no power"
    _ -> "a packed window is less than q to the number of its cells"
  "too-few-cells" -> "nothing was observed"
  "no-complete-window" -> "no window of the patch has all its cells observed"
  "zero-window" -> case operationOf question of
    OfLocate -> "the complete windows are all zeros, and none such occurs"
    _ -> "as few observed cells are other than 0 as the radius corrects"
  "not-in-array" -> "no complete window of the patch occurs on the surface"
  "off-sheet" -> case operationOf question of
    OfProve -> "no window of the mask lies on the sheet"
    OfDistance -> "no window of the mask lies on the sheet"
    _ -> "what lies on the sheet agrees, but the patch goes beyond it"
  "contradiction" -> case operationOf question of
    OfPosterior -> "no position is possible"
    _ -> "no position agrees with all observed cells"
  "beyond-radius" -> "no position differs from the observed cells in as few as the radius"
  _ -> "by definition"
