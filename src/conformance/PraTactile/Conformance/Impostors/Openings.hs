{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Impostors of opening profiles and reading inputs: each omits one check and continues with what
-- it has.
module PraTactile.Conformance.Impostors.Openings
  ( openingImpostors,
    readingImpostors,
  )
where

import Data.Aeson (Value (..), object, (.=))
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Char (isDigit)
import qualified Data.Text as Text
import qualified Data.Vector as Vector
import Numeric.Natural (Natural)
import PraTactile.Array (Folding (..), Shape (..))
import PraTactile.Conformance.Impostors.Impostor
import PraTactile.Profile (Profile (..))

-- | Mistakes in opening: each repairs a profile that should be refused.
openingImpostors :: [Impostor]
openingImpostors =
  [ mending "reads-the-order-off-the-modulus" "takes p to the modulus's degree for q" $ \p ->
      [p {profileOrder = base ^ (max 1 (length (profileModulus p)) - 1)} | base <- [2, 3, 5]],
    mending
      "takes-the-usual-modulus-for-another-degree"
      "takes the Conway polynomial where the modulus has another degree"
      $ \p -> [p {profileModulus = m} | m <- usualModuli, not (m `asLongAs` profileModulus p)],
    mending
      "takes-the-usual-modulus-for-a-reducible-one"
      "takes the Conway polynomial where the modulus is reducible"
      $ \p ->
        [ p {profileModulus = m}
          | m <- usualModuli,
            m `asLongAs` profileModulus p,
            isMonic (profileModulus p)
        ],
    mending "makes-the-modulus-monic" "takes the modulus's leading coefficient for 1" $ \p ->
      [p {profileModulus = ledByOne (profileModulus p)}],
    mending "reduces-the-modulus" "takes the modulus's coefficients modulo q" $ \p ->
      [p {profileModulus = modulo p (profileModulus p)}],
    mending "makes-the-polynomial-monic" "takes the polynomial's leading coefficient for 1" $ \p ->
      [p {profilePolynomial = ledByOne (profilePolynomial p)}],
    mending "accepts-any-monic-polynomial" "takes a primitive polynomial for any monic one" $ \p ->
      [ p {profilePolynomial = h}
        | h <- usualPolynomials,
          h `asLongAs` profilePolynomial p,
          isMonic (profilePolynomial p),
          all (< profileOrder p) (profilePolynomial p)
      ],
    mending "reduces-the-polynomial" "takes the polynomial's coefficients modulo q" $ \p ->
      [p {profilePolynomial = modulo p (profilePolynomial p)}],
    mending "accepts-the-state-of-zeros" "begins with ones where the state is of zeros" $ \p ->
      [p {profileState = map (const 1) (profileState p)} | all (== 0) (profileState p)],
    mending "fills-up-the-state" "fills a state up, or cuts it off, to the degree" $ \p ->
      let n = length (profilePolynomial p) - 1
       in [p {profileState = take n (profileState p ++ repeat 1)}],
    mending "reduces-the-state" "takes the terms of the state modulo q" $ \p ->
      [ p {profileState = state}
        | any (>= profileOrder p) (profileState p),
          state <- [modulo p (profileState p), map (const 1) (profileState p)]
      ],
    mending "accepts-any-shape" "folds a period into a row, whatever the shape" $ \p ->
      let period = max 1 (profileOrder p) ^ (max 1 (length (profilePolynomial p)) - 1) - 1
          Shape n1 n2 = profileShape p
       in [p {profileShape = Shape 1 period} | n1 * n2 /= period],
    mending "accepts-sides-that-are-not-coprime" "folds row by row where the diagonal returns" $
      \p -> [p {profileFolding = RowMajor} | profileFolding p == Diagonal],
    mending "accepts-the-window-without-cells" "takes a window without cells for one of a cell" $
      \p -> let Shape h w = profileWindow p in [p {profileWindow = Shape (max 1 h) (max 1 w)}],
    opening "demands-the-usual-state" "refuses a state other than 0, ..., 0, 1" $ \p ->
      [p | profileState p == replicate (length (profileState p) - 1) 0 ++ [1]]
  ]
  where
    mending name mistake repairs = opening name mistake (\p -> p : repairs p)
    asLongAs xs ys = length xs == length ys
    isMonic xs = take 1 (reverse xs) == [1]
    ledByOne xs = take (length xs - 1) xs ++ [1]
    modulo p = map (`mod` max 1 (profileOrder p))

-- | The moduli of the default profiles' fields.
usualModuli :: [[Natural]]
usualModuli = [[1, 1], [3, 1], [1, 1, 1], [2, 2, 1], [1, 1, 0, 1]]

-- | Primitive polynomials of the default profiles' fields and degrees.
usualPolynomials :: [[Natural]]
usualPolynomials =
  [ [3, 2, 1, 0, 1],
    [1, 1, 0, 0, 1],
    [2, 1, 1, 0, 0, 0, 1],
    [1, 2, 0, 1],
    [2, 3, 0, 1],
    [3, 1, 1],
    [5, 2, 1]
  ]

-- | Mistakes in reading inputs.
readingImpostors :: [Impostor]
readingImpostors =
  [ reading
      "takes-anything-for-a-number"
      "takes true for 1, objects for 0, and cuts fractions off"
      (inFields number),
    reading "forgets-signs" "takes a negative number for its magnitude" (inFields unsigned),
    reading
      "takes-small-integers-as-numbers-only"
      "takes decimal strings of less than 17 digits for nothing"
      shortStrings,
    reading "takes-missing-keys-for-zero" "takes a key that is missing for 0, or for nothing" filled
  ]

inFields :: (Value -> Value) -> Value -> Value
inFields change value = case value of
  Object fields -> Object (KeyMap.map change fields)
  other -> other

shortStrings :: Value -> Value
shortStrings value = case value of
  Object fields -> Object (KeyMap.map shortStrings fields)
  Array items -> Array (Vector.map shortStrings items)
  String text | Text.all isDigit text && Text.length text < 17 -> Bool False
  other -> other

number, unsigned :: Value -> Value
number value = case value of
  Number n -> Number (fromInteger (truncate n))
  Bool true -> Number (if true then 1 else 0)
  Object _ -> Number 0
  Array items -> Array (Vector.map number items)
  other -> other
unsigned value = case value of
  Number n -> Number (abs n)
  Array items -> Array (Vector.map unsigned items)
  other -> other

filled :: Value -> Value
filled value = case (value, object defaults) of
  (Object fields, Object others) -> Object (KeyMap.union fields others)
  _ -> value
  where
    defaults =
      [ name .= (0 :: Int)
        | name <- ["a", "b", "exponent", "index", "from", "length", "row", "column", "packed"]
      ]
        ++ ["degree" .= (1 :: Int), "mask" .= ("#" :: String), "radius" .= Null]
        ++ ["polynomial" .= [1 :: Int], "cells" .= [0 :: Int], "patch" .= [[0 :: Int]]]
