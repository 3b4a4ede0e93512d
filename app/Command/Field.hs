{-# LANGUAGE OverloadedStrings #-}

-- | @pra-tactile field@: the tables of a field, for whoever implements it elsewhere.
module Command.Field
  ( command,
  )
where

import Data.Aeson ((.=))
import Data.Aeson.Encoding (Series)
import Data.List (intercalate, transpose)
import Data.Proxy (Proxy)
import Described
import Ending
import FieldChoice
import Json
import Options.Applicative hiding (command)
import PraTactile.Field
import PraTactile.Field.Structure
import PraTactile.Polynomial (coefficients)

command :: Mod CommandFields (IO Ending)
command =
  described
    "field"
    "Print a field: its modulus, its elements and what each is, and the tables of sums and \
    \products."
    [ "pra-tactile field --q 4",
      "pra-tactile field --q 9 --modulus 1,0,1 --json"
    ]
    ( run
        <$> fieldChoice
        <*> switch (long "json" <> help "Print the tables as JSON, codes for elements")
    )

run :: FieldChoice -> Bool -> IO Ending
run choice asJson = withChosenField choice $ \k -> do
  if asJson then printJson (fieldJson k) else putStr (unlines (fieldText k))
  pure Answered

-- | Codes throughout: lists are indexed by codes, and lists of lists by two of them.
fieldJson :: forall k. KnownField k => Proxy k -> Series
fieldJson k =
  "schema" .= ("pra-tactile/field/1" :: String)
    <> "q" .= fieldOrder k
    <> "p" .= fieldCharacteristic k
    <> "degree" .= fieldDegree k
    <> "modulus" .= map naturalValue (fieldModulus k)
    <> "primitive" .= toCode (primitive :: GF k)
    <> "add" .= [[toCode (a + b) | b <- everything] | a <- everything]
    <> "multiply" .= [[toCode (a * b) | b <- everything] | a <- everything]
    <> "negate" .= map (toCode . negate) everything
    <> "inverse" .= map (either (const Nothing) (Just . toCode) . inverse) everything
    <> "powers" .= [toCode (exponential e :: GF k) | e <- [0 .. toInteger (fieldOrder k) - 2]]
    <> "log" .= map logarithm everything
  where
    everything = elements :: [GF k]

-- | For people; the tables of two arguments only where they fit a page.
fieldText :: forall k. KnownField k => Proxy k -> [String]
fieldText k =
  [ "GF("
      ++ show q
      ++ "), characteristic "
      ++ show (fieldCharacteristic k)
      ++ ", modulus "
      ++ written (fieldModulus k)
      ++ " ("
      ++ commas (fieldModulus k)
      ++ ")",
    "A is the element of code "
      ++ show (toCode (primitive :: GF k))
      ++ ", the smallest of order "
      ++ show (q - 1)
      ++ ": every element but 0 is a power of it.",
    ""
  ]
    ++ zipWith
      (\cells f -> cells ++ "  " ++ f)
      (aligned (heading : map line everything))
      ( ("minimal polynomial over GF(" ++ show (fieldCharacteristic k) ++ ")") :
        map (written . map toCode . coefficients . minimalPolynomial primeSubfield) everything
      )
    ++ ( if q <= 32
           then
             "" :
             "Sums, by codes:" :
             table "+" (+)
               ++ ["", "Products, by codes:"]
               ++ table "*" (*)
           else
             [ "",
               "The tables of "
                 ++ show q
                 ++ " x "
                 ++ show q
                 ++ " sums and products are printed by --json."
             ]
       )
  where
    q = fieldOrder k
    everything = elements :: [GF k]
    heading = ["code", "element", "negative", "inverse", "order", "trace", "norm"]
    line a =
      [ code a,
        showElement a,
        code (negate a),
        either (const "-") code (inverse a),
        either (const "-") show (elementOrder a),
        code (trace primeSubfield a),
        code (norm primeSubfield a)
      ]
    code = show . toCode
    table sign operation =
      aligned
        ( (sign : map code everything) :
            [code a : [code (operation a b) | b <- everything] | a <- everything]
        )

-- | Coefficients, constant term first, as a polynomial in x.
written :: (Ord c, Num c, Show c) => [c] -> String
written terms = case [term c i | (i, c) <- reverse (zip [0 :: Int ..] terms), c /= 0] of
  [] -> "0"
  shown -> intercalate " + " shown
  where
    term c i
      | i == 0 = show c
      | c == 1 = variablePower i
      | otherwise = show c ++ " " ++ variablePower i
    variablePower i = if i == 1 then "x" else "x^" ++ show i

commas :: Show a => [a] -> String
commas = intercalate "," . map show

-- | Lines of words in columns, to the right.
aligned :: [[String]] -> [String]
aligned grid = [unwords (zipWith pad widths line) | line <- grid]
  where
    widths = map (maximum . map length) (transpose grid)
    pad width word = replicate (width - length word) ' ' ++ word
