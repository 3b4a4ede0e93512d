{-# LANGUAGE OverloadedStrings #-}

-- | @pra-tactile synthesise@: which recurrence produced these symbols?
module Command.Synthesise
  ( command,
  )
where

import ArrayChoice
import Control.Monad (when)
import Data.Aeson ((.=))
import Data.Bifunctor (first)
import Data.List (intercalate)
import Data.Maybe (fromMaybe)
import Data.Proxy (Proxy)
import qualified Data.Text as Text
import Data.Text.Encoding (decodeUtf8')
import Described
import Ending
import Files (readBytes)
import Json
import Message (fieldMessage)
import Numeric.Natural (Natural)
import Options.Applicative hiding (command)
import PraTactile.Field
import PraTactile.Field.Named (conwayModulus)
import PraTactile.Polynomial
import PraTactile.Sequence.Synthesis

command :: Mod CommandFields (IO Ending)
command =
  described
    "synthesise"
    "Find the shortest shift register that puts out the symbols read from the standard input, \
    \codes or powers parted by spaces, commas or line ends; status 1 if the symbols do not \
    \determine it."
    [ "pra-tactile sequence --from 1000 --length 8 | pra-tactile synthesise --q 4",
      "echo '0 0 1 0 1 1 1' | pra-tactile synthesise --q 2 --json"
    ]
    ( run
        <$> orderOption
        <*> optional modulusOption
        <*> switch (long "json" <> help "Print the answer as JSON")
    )

-- | What was found, without its field.
data Found = Found
  { foundSymbols :: Int,
    foundPolynomial :: [Natural],
    foundLength :: Int,
    foundDetermined :: Bool,
    -- | 'Nothing' where it was not decided
    foundPrimitive :: Maybe Bool,
    foundState :: [Natural]
  }

run :: Natural -> Maybe [Natural] -> Bool -> IO Ending
run q chosen asJson = do
  text <- readBytes "-" >>= orUnusable (const "the standard input is not UTF-8 text") . decodeUtf8'
  let symbols = words (map (\c -> if c == ',' then ' ' else c) (Text.unpack text))
  when (null symbols) (unusable "there are no symbols on the standard input")
  (p, usual) <- orUnusable fieldMessage (conwayModulus q)
  let modulus = fromMaybe usual chosen
  when
    (length (take (length usual + 1) modulus) /= length usual)
    (unusable ("the modulus of GF(" ++ show q ++ ") has degree " ++ show (length usual - 1)))
  found <- orUnusable id (join' (first fieldMessage (withField p modulus (`search` symbols))))
  if asJson then printJson (foundJson q modulus found) else putStr (foundText found)
  pure (if foundDetermined found then Answered else NotAnswered)
  where
    join' = either Left id
    foundJson order modulus found =
      "schema" .= ("pra-tactile/synthesise/1" :: String)
        <> "q" .= naturalValue order
        <> "modulus" .= map naturalValue modulus
        <> "symbols" .= foundSymbols found
        <> "polynomial" .= map naturalValue (foundPolynomial found)
        <> "length" .= foundLength found
        <> "determined" .= foundDetermined found
        <> "primitive" .= foundPrimitive found
        <> "state" .= map naturalValue (foundState found)

-- | The shortest register; 'Left' says which symbol is none.
search :: forall k. KnownField k => Proxy k -> [String] -> Either String Found
search _ symbols = do
  terms <- traverse element (zip [1 :: Int ..] symbols) :: Either String [GF k]
  let result = synthesise terms
      h = synthesisPolynomial result
  pure
    Found
      { foundSymbols = synthesisTerms result,
        foundPolynomial = map codeOf (coefficients h),
        foundLength = synthesisLength result,
        foundDetermined = synthesisDetermined result,
        foundPrimitive =
          if synthesisLength result > 256 then Nothing else primitivity h (checkPrimitive h),
        foundState = map codeOf (take (synthesisLength result) terms)
      }
  where
    element (i, text) =
      first (\e -> "symbol " ++ show i ++ ": " ++ fieldMessage e) (parseElement text)
    codeOf = fromIntegral . toCode :: GF k -> Natural
    primitivity h checked = case checked of
      Right _ -> Just True
      -- Beyond what is factored, a polynomial with a factor is not primitive all the same.
      Left (OrderNotFactored _) -> if isIrreducible h then Nothing else Just False
      Left _ -> Just False

foundText :: Found -> String
foundText found =
  unlines
    [ "polynomial " ++ list (foundPolynomial found),
      "length     " ++ show (foundLength found),
      "determined "
        ++ ( if foundDetermined found
               then "yes"
               else
                 "no: "
                   ++ show (2 * foundLength found)
                   ++ " symbols would determine it, and there are "
                   ++ show (foundSymbols found)
           ),
      "primitive  "
        ++ maybe "not decided" (\yes -> if yes then "yes" else "no") (foundPrimitive found),
      "state      " ++ list (foundState found)
    ]
  where
    list = intercalate "," . map show
