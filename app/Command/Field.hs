-- | @pra-tactile field@: the tables of a field, for whoever implements it elsewhere.
module Command.Field
  ( command,
  )
where

import Data.List (intercalate, transpose)
import Data.Proxy (Proxy)
import ExitStatus
import FieldChoice
import Options
import PraTactile.Field
import PraTactile.Field.Structure
import PraTactile.Format (encodeField)
import PraTactile.Polynomial (coefficients)

command :: Subcommand
command =
  subcommand
    "field"
    "Print a field: its elements and tables"
    "Print a field: its modulus, its elements with their properties, and the tables of sums and \
    \products."
    []
    [ "pra-tactile field --q 4",
      "pra-tactile field --q 9 --modulus 1,0,1 --json"
    ]
    (run <$> fieldChoice <*> jsonSwitch "Print the field as JSON, with codes for elements")

run :: FieldChoice -> AnswerForm -> IO ExitStatus
run choice form = withChosenField choice $ \k -> do
  printAs form (unlines (fieldText k)) (encodeField k)
  pure Answered

-- | The field in words; the tables of sums and products only if they fit on a page.
fieldText :: forall k. KnownField k => Proxy k -> [String]
fieldText k =
  [ "GF("
      ++ show q
      ++ "), characteristic "
      ++ show p
      ++ ", modulus "
      ++ written (fieldModulus k)
      ++ " ("
      ++ intercalate "," (map show (fieldModulus k))
      ++ ")",
    "A is the element of code "
      ++ show (toCode (primitive :: GF k))
      ++ ", the smallest of order "
      ++ show (q - 1)
      ++ ": every element but 0 is a power of it.",
    ""
  ]
    ++ elementLines k
    ++ if q <= 32
      then operations k
      else
        [ "",
          "The tables of " ++ times ++ " sums and products are printed by --json."
        ]
  where
    q = fieldOrder k
    p = fieldCharacteristic k
    times = show q ++ " x " ++ show q

-- | What each element is.
elementLines :: forall k. KnownField k => Proxy k -> [String]
elementLines k =
  zipWith
    (\cells f -> cells ++ "  " ++ f)
    (aligned (heading : map line everything))
    ( ("minimal polynomial over GF(" ++ show (fieldCharacteristic k) ++ ")") :
      map (written . map toCode . coefficients . minimalPolynomial primeSubfield) everything
    )
  where
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

-- | The tables of sums and products.
operations :: forall k. KnownField k => Proxy k -> [String]
operations _ =
  ["", "Sums, by codes:"] ++ table "+" (+) ++ ["", "Products, by codes:"] ++ table "*" (*)
  where
    everything = elements :: [GF k]
    table sign operation =
      aligned
        ( (sign : map code everything) :
            [code a : [code (operation a b) | b <- everything] | a <- everything]
        )

code :: GF k -> String
code = show . toCode

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

-- | Lines of words in columns, flush right.
aligned :: [[String]] -> [String]
aligned grid = [unwords (zipWith pad widths line) | line <- grid]
  where
    widths = map (maximum . map length) (transpose grid)
    pad width word = replicate (width - length word) ' ' ++ word
