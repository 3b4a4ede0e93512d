{-# LANGUAGE GADTs #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Impostors of field arithmetic, and of polynomials over the field.
module PraTactile.Conformance.Impostors.Fields
  ( fieldImpostors,
    polynomialImpostors,
  )
where

import Control.Monad.Trans.Except (except)
import Data.Bits (xor)
import qualified Data.Vector.Unboxed as Vector
import PraTactile.Conformance.Definition (expected)
import PraTactile.Conformance.Definition.Array (ProfileFacts (..))
import PraTactile.Conformance.Definition.Field (Field (..), field)
import PraTactile.Conformance.Impostors.Impostor
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Question
import PraTactile.Conformance.Stage
import PraTactile.Profile (Profile (..))

-- | Mistakes in field operations.
fieldImpostors :: [Impostor]
fieldImpostors = tables ++ operations

-- | Mistakes in the tables of sums and products.
tables :: [Impostor]
tables =
  [ calculating "adds-modulo-q" "adds codes as numbers modulo q" $
      sums (\q a b -> (a + b) `mod` q),
    calculating "adds-by-xor" "adds codes bit by bit, as in characteristic 2, whatever the field" $
      sums (\q a b -> (a `xor` b) `mod` q),
    calculating "multiplies-modulo-q" "multiplies codes as numbers modulo q" $
      products (\q a b -> (a * b) `mod` q),
    calculating "reduces-by-another-modulus" "multiplies modulo another irreducible polynomial" $
      \k -> maybe k (\f -> k {knownField = f}) (anotherField (knownProfile k))
  ]
  where
    sums, products :: (Int -> Int -> Int -> Int) -> ProfileFacts -> ProfileFacts
    sums plus k = k {knownField = (knownField k) {fieldSums = tableOf plus k}}
    products times k = k {knownField = (knownField k) {fieldProducts = tableOf times k}}
    tableOf operation k =
      let q = fieldOrder (knownField k)
       in Vector.fromList [operation q a b | a <- [0 .. q - 1], b <- [0 .. q - 1]]
    -- The array stays right, and so do logarithms, whose computation might not end otherwise.
    calculating name mistake edit =
      answeringOtherwise name mistake $ \k right question ->
        if operationOf question `elem` filter (/= SomeOp Logarithm) (operationsIn OnField)
          then except (expected (edit k) question)
          else right question

-- | The field by another irreducible polynomial of the same degree, if there is one.
anotherField :: Profile -> Maybe Field
anotherField p = field (toInteger (profileOrder p)) =<< lookup (profileOrder p) others
  where
    others =
      [ (q, modulus)
        | (q, modulus) <- [(8, [1, 1, 0, 1]), (8, [1, 0, 1, 1]), (9, [2, 1, 1]), (9, [1, 0, 1])],
          map fromInteger modulus /= profileModulus p
      ]

operations :: [Impostor]
operations =
  [ answeringOtherwise "takes-codes-modulo-q" "takes a code of q or more modulo q" $
      \k right question ->
        let cut a = a `mod` profileOrder (knownProfile k)
         in case question of
              Add :? (a, b) -> right (Add :? (cut a, cut b))
              Multiply :? (a, b) -> right (Multiply :? (cut a, cut b))
              Negate :? a -> right (Negate :? cut a)
              Inverse :? a -> right (Inverse :? cut a)
              Power :? (a, i) -> right (Power :? (cut a, i))
              Logarithm :? a -> right (Logarithm :? cut a)
              Trace :? a -> right (Trace :? cut a)
              Primitive :? codes -> right (Primitive :? map cut codes)
              Pack :? codes -> right (Pack :? map cut codes)
              Locate :? rows -> right (Locate :? map (map (fmap cut)) rows)
              _ -> right question,
    answeringOtherwise "keeps-the-second-summand" "takes the second summand for the sum" $
      \_ right question -> case question of
        Add :? (a, b) -> right (Add :? (a, b)) >> right (Add :? (b, 0))
        _ -> right question,
    answeringOtherwise "squares-the-second-factor" "multiplies by the second factor twice" $
      \_ right question -> case question of
        Multiply :? (a, b) -> right (Multiply :? (a, b)) >>= \c -> right (Multiply :? (c, b))
        _ -> right question,
    answeringOtherwise "negates-nothing" "takes an element for its own negative" $
      \_ right question -> case question of
        Negate :? a -> right (Add :? (a, 0))
        _ -> right question,
    answeringOtherwise "takes-exponents-modulo-q" "reduces exponents modulo q, not q - 1" $
      \k right question -> case question of
        Power :? (a, i) -> right (Power :? (a, i `mod` toInteger (profileOrder (knownProfile k))))
        _ -> right question,
    answeringOtherwise "counts-logarithms-from-one" "has q - 1, not 0, for the logarithm of 1" $
      \k right question -> case question of
        Logarithm :? 1 -> pure (profileOrder (knownProfile k) - 1)
        _ -> right question,
    answeringOtherwise "traces-one-power-short" "leaves the last conjugate out of the trace" $
      \k right question -> case question of
        Trace :? a -> do
          let (q, m) = (profileOrder (knownProfile k), length (profileModulus (knownProfile k)) - 1)
              p = toInteger (sum (take 1 [i | i <- [2 .. q], q `mod` i == 0]))
          powers <- traverse (\i -> right (Power :? (a, p ^ i))) [0 .. max 0 (m - 2)]
          foldr (\b total -> total >>= right . (Add :?) . (,) b) (pure 0) powers
        _ -> right question
  ]

-- | Mistakes in polynomials.
polynomialImpostors :: [Impostor]
polynomialImpostors =
  [ answeringOtherwise "takes-x-plus-one-for-the-first" "has x + 1 for the first of degree 1" $
      \_ right question -> case question of
        FirstPrimitive :? 1 -> pure [1, 1]
        _ -> right question,
    answeringOtherwise "demands-a-linear-term" "takes only polynomials with a linear term" $
      \_ right question -> case question of
        Primitive :? h -> (&& any (/= 0) (take 1 (drop 1 h))) <$> right (Primitive :? h)
        _ -> right question,
    answeringOtherwise "reads-polynomials-backwards" "takes polynomials highest degree first" $
      \_ right question -> case question of
        Primitive :? codes -> right (Primitive :? reverse codes)
        FirstPrimitive :? n -> reverse <$> right (FirstPrimitive :? n)
        _ -> right question,
    answeringOtherwise "looks-for-roots-only" "takes a polynomial without roots for primitive" $
      \k right question -> case question of
        Primitive :? codes
          | 1 : _ : _ : _ <- reverse codes,
            take 1 codes /= [0] -> do
            let value x = foldr (\c rest -> rest >>= times x >>= plus c) (pure 0)
                times x a = right (Multiply :? (x, a))
                plus c a = right (Add :? (c, a))
            values <- traverse (`value` codes) [1 .. profileOrder (knownProfile k) - 1]
            pure (0 `notElem` values)
        _ -> right question
  ]
