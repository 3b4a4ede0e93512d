{-# LANGUAGE OverloadedStrings #-}

-- | Mistakes in what is taken for a profile, and for an input: each leaves out one check, and goes
-- on with what it has.
module PraTactile.Conformance.Impostors.Openings
  ( openingImpostors,
    readingImpostors,
  )
where

import Control.Monad (unless)
import Control.Monad.Trans.Except (catchE)
import Data.Aeson (Value (..), object, toJSON, (.=))
import Data.Aeson.Key (Key)
import qualified Data.Aeson.KeyMap as KeyMap
import Data.List (transpose)
import qualified Data.Text as Text
import qualified Data.Vector as Vector
import Numeric.Natural (Natural)
import PraTactile.Array (Folding (..), Shape (..), area)
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Impostors.Decoder
import PraTactile.Conformance.Impostors.Impostor
import PraTactile.Conformance.Impostors.Searching
import PraTactile.Conformance.Impostors.Ways
import PraTactile.Profile (Profile (..))

-- | In opening.
openingImpostors :: [Impostor]
openingImpostors = ofFields ++ ofSequences ++ ofArrays ++ tooStrict

-- | Goes on with the first of these profiles that is possible, if the one given is not.
lenient :: String -> String -> (Profile -> [Profile]) -> Impostor
lenient name mistake repairs =
  Impostor name mistake [] $ \base ->
    base {open = \p -> (\s -> s {profile = p}) <$> opening (open base) (p : repairs p)}

-- | The same, but the array is made as the impossible profile says.
heedless :: String -> String -> (Profile -> [Profile]) -> Impostor
heedless name mistake repairs =
  Impostor name mistake [] $ \base ->
    base
      { open = \p ->
          open base p `catchE` \_ ->
            session rightWays rightSearching p
              <$> opening
                (open base)
                (repairs p)
      }

opening :: (Profile -> Wire Session) -> [Profile] -> Wire Session
opening open' profiles = case profiles of
  [] -> refuse "impossible-profile"
  p : rest -> open' p `catchE` \_ -> opening open' rest

ofFields :: [Impostor]
ofFields =
  [ lenient
      "reads-the-order-off-the-modulus"
      "takes p to the modulus's degree for q, whatever is stated"
      $ \p ->
        [p {profileOrder = base ^ (max 1 (length (profileModulus p)) - 1)} | base <- [2, 3, 5, 7]],
    lenient
      "takes-the-usual-modulus-for-another-degree"
      "takes the Conway polynomial where the modulus has another degree"
      $ \p ->
        [p {profileModulus = m} | m <- usualModuli, length m /= length (profileModulus p)],
    lenient
      "takes-the-usual-modulus-for-a-reducible-one"
      "takes the Conway polynomial where the modulus is reducible"
      $ \p ->
        [ p {profileModulus = m}
          | m <-
              usualModuli,
            length m == length (profileModulus p),
            endsInOne (profileModulus p)
        ],
    lenient "makes-the-modulus-monic" "takes the modulus's leading coefficient for 1" $ \p ->
      [p {profileModulus = ledByOne (profileModulus p)}],
    lenient "reduces-the-modulus" "takes the modulus's coefficients modulo q" $ \p ->
      [p {profileModulus = map (`mod` max 1 (profileOrder p)) (profileModulus p)}]
  ]
  where
    endsInOne xs = take 1 (reverse xs) == [1]

-- | Of the fields of the default profiles.
usualModuli :: [[Natural]]
usualModuli = [[1, 1], [3, 1], [1, 1, 1], [2, 2, 1], [1, 1, 0, 1]]

ledByOne :: [Natural] -> [Natural]
ledByOne xs = take (length xs - 1) xs ++ [1]

ofSequences :: [Impostor]
ofSequences =
  [ lenient "makes-the-polynomial-monic" "takes the polynomial's leading coefficient for 1" $ \p ->
      [p {profilePolynomial = ledByOne (profilePolynomial p)}],
    heedless
      "accepts-a-polynomial-that-is-not-primitive"
      "folds the sequence of any monic polynomial"
      $ \p ->
        [ p {profilePolynomial = h}
          | take 1 (reverse (profilePolynomial p)) == [1],
            all (< profileOrder p) (profilePolynomial p),
            h <- primitives,
            length h == length (profilePolynomial p)
        ],
    lenient "reduces-the-polynomial" "takes the polynomial's coefficients modulo q" $ \p ->
      [p {profilePolynomial = map (`mod` max 1 (profileOrder p)) (profilePolynomial p)}],
    heedless "accepts-the-state-of-zeros" "begins with zeros where the state says so" $ \p ->
      [p {profileState = map (const 1) (profileState p)} | all (== 0) (profileState p)],
    lenient "fills-up-the-state" "fills a state up, or cuts it off, to the degree" $ \p ->
      [ p {profileState = state}
        | let n = length (profilePolynomial p) - 1,
          state <- [take n (profileState p ++ repeat 0), replicate n 1]
      ],
    lenient "reduces-the-state" "takes the terms of the state modulo q" $ \p ->
      [ p {profileState = state}
        | state <-
            [ map (`mod` max 1 (profileOrder p)) (profileState p),
              map
                (const 1)
                (profileState p)
            ],
          any (>= profileOrder p) (profileState p)
      ]
  ]

-- | Primitive polynomials of the default profiles' fields and degrees.
primitives :: [[Natural]]
primitives =
  [ [3, 2, 1, 0, 1],
    [1, 1, 0, 0, 1],
    [2, 1, 1, 0, 0, 0, 1],
    [1, 2, 0, 1],
    [2, 3, 0, 1],
    [3, 1, 1],
    [5, 2, 1]
  ]

ofArrays :: [Impostor]
ofArrays =
  [ heedless "accepts-any-shape" "folds the sequence into as many cells as the shape has" $ \p ->
      [ p {profileShape = Shape n1 (period `div` n1), profileFolding = RowMajor}
        | let period = max 1 (profileOrder p) ^ (max 1 (length (profilePolynomial p)) - 1) - 1,
          period /= area (profileShape p),
          n1 <- [1]
      ],
    heedless
      "accepts-sides-that-are-not-coprime"
      "folds diagonally though it comes back too soon"
      $ \p ->
        [p {profileFolding = RowMajor} | profileFolding p == Diagonal],
    lenient
      "accepts-the-window-without-cells"
      "takes a window without rows or columns for one of one"
      $ \p ->
        let Shape h w = profileWindow p in [p {profileWindow = Shape (max 1 h) (max 1 w)}]
  ]

-- | Each demands what need not be.
tooStrict :: [Impostor]
tooStrict =
  [ demanding
      "demands-that-windows-differ"
      "refuses a profile whose windows are too few to tell all places"
      $ \p ->
        profileOrder p ^ area (profileWindow p) > area (profileShape p),
    demanding
      "demands-a-primitive-modulus"
      "refuses a modulus whose root is no primitive element"
      $ \p ->
        profileModulus p /= [1, 0, 1],
    demanding "demands-the-usual-state" "refuses a state other than 0, ..., 0, 1" $ \p ->
      profileState p == replicate (length (profileState p) - 1) 0 ++ [1],
    demanding "demands-a-diagonal-fold" "refuses a row-major folding" $ \p ->
      profileFolding p
        == Diagonal
  ]
  where
    demanding name mistake demanded =
      Impostor name mistake [] $ \base ->
        base {open = \p -> unless (demanded p) (refuse "impossible-profile") >> open base p}

-- | In reading inputs.
readingImpostors :: [Impostor]
readingImpostors =
  [ reading
      "takes-anything-for-a-number"
      "takes true for 1, objects for 0, and cuts fractions off"
      whole,
    reading "forgets-signs" "takes a negative number for its magnitude" unsigned,
    reading
      "takes-missing-keys-for-zero"
      "takes a key that is missing for 0, or for nothing"
      filledUp,
    reading "fills-up-rows" "fills rows up with cells not felt, and with blanks" evened,
    reading
      "reads-any-mark"
      "takes every character of a mask but # and / for a blank, and \
      \mends what is left over"
      marked
  ]
  where
    reading name mistake change = mistaken name mistake $ \s ->
      s {understood = \operation input -> understood s operation (change input)}

-- | Numbers where there are none, at any depth but the outermost.
whole :: Value -> Value
whole value = case value of
  Object fields -> Object (KeyMap.map inner fields)
  other -> other
  where
    inner v = case v of
      Number n -> Number (fromInteger (truncate n))
      Bool true -> Number (if true then 1 else 0)
      Object _ -> Number 0
      Array items -> Array (Vector.map inner items)
      other -> other

-- | Each value changed, given its key.
withKeys :: (Key -> Value -> Value) -> KeyMap.KeyMap Value -> KeyMap.KeyMap Value
withKeys change = KeyMap.fromList . map (\(name, v) -> (name, change name v)) . KeyMap.toList

unsigned :: Value -> Value
unsigned value = case value of
  Object fields ->
    Object
      (withKeys (\name v -> if name == "exponent" then v else unsigned v) fields)
  Array items -> Array (Vector.map unsigned items)
  Number n | n < 0 -> Number (negate n)
  other -> other

filledUp :: Value -> Value
filledUp value = case value of
  Object fields -> case object defaults of
    Object others -> Object (KeyMap.union fields others)
    _ -> value
  _ -> value
  where
    defaults =
      [ name .= (0 :: Int)
        | name <-
            ["a", "b", "exponent", "index", "from", "length", "row", "column", "packed"]
      ]
        ++ ["degree" .= (1 :: Int), "mask" .= ("#" :: String), "radius" .= Null]
        ++ ["polynomial" .= [1 :: Int], "cells" .= [0 :: Int], "patch" .= [[0 :: Int]]]

-- | All rows as long as the longest.
evened :: Value -> Value
evened value = case value of
  Object fields -> Object (withKeys row fields)
  other -> other
  where
    row name v = case v of
      Array lines'
        | name == "patch",
          all isArray lines' ->
          Array
            (Vector.map (longer (widest lines')) lines')
      String drawing
        | name == "mask" ->
          String
            (Text.intercalate "/" (even' (Text.splitOn "/" drawing)))
      other -> other
    isArray v = case v of
      Array _ -> True
      _ -> False
    size v = case v of
      Array items -> Vector.length items
      _ -> 0
    widest lines' = maximum (1 : map size (Vector.toList lines'))
    longer n v = case v of
      Array items -> Array (items <> Vector.replicate (n - Vector.length items) Null)
      other -> other
    even' rows' = map (Text.justifyLeft (maximum (map Text.length rows')) '.') rows'

marked :: Value -> Value
marked value = case value of
  Object fields -> Object (withKeys (\name v -> if name == "mask" then mark v else v) fields)
  other -> other
  where
    mark v = case v of
      String drawing -> toJSON (mended (Text.unpack (Text.map blank drawing)))
      other -> other
    blank c = if c == '#' || c == '/' then c else '.'
    mended = intercalateRows . transpose . transpose . filter (not . null) . rowsOf
    rowsOf text = case break (== '/') text of
      (line, []) -> [line]
      (line, _ : rest) -> line : rowsOf rest
    intercalateRows rows' = case rows' of
      [] -> ""
      _ -> foldr1' rows'
    foldr1' rows' = drop 1 (concatMap ('/' :) rows')
