-- | @pra-tactile synthesise@: which recurrence produced these symbols?
module Command.Synthesise
  ( command,
  )
where

import Control.Monad (when)
import Data.Bifunctor (first)
import Data.List (intercalate)
import Data.Maybe (fromMaybe)
import Data.Proxy (Proxy)
import qualified Data.Text as Text
import ExitStatus
import Files (readBytes)
import Message (fieldMessage, notUtf8Message)
import Numeric.Natural (Natural)
import Options
import PraTactile.Field
import PraTactile.Field.Named (conwayModulus)
import PraTactile.Format (SynthesisReport (..), encodeSynthesis)
import PraTactile.PlainText (plainUtf8)
import PraTactile.Polynomial
import PraTactile.Sequence.Synthesis

command :: Subcommand
command =
  subcommand
    "synthesise"
    "Find the shortest shift register for given symbols"
    "Find the shortest shift register that puts out the symbols on the standard input. Symbols are \
    \codes or powers, separated by spaces, commas or line ends. The status is 1 if they do not \
    \determine the register."
    []
    [ "pra-tactile sequence --from 1000 --length 8 | pra-tactile synthesise --q 4",
      "echo '0 0 1 0 1 1 1' | pra-tactile synthesise --q 2 --json"
    ]
    (run <$> orderOption <*> modulusOption <*> jsonSwitch "Print the answer as JSON")

run :: Natural -> Maybe [Natural] -> AnswerForm -> IO ExitStatus
run q modulusGiven form = do
  text <- readBytes "-" >>= orUnusable (("the standard input" ++) . notUtf8Message) . plainUtf8
  let symbols = words (map (\c -> if c == ',' then ' ' else c) (Text.unpack text))
  when (null symbols) (unusable "there are no symbols on the standard input")
  (p, usual) <- orUnusable fieldMessage (conwayModulus q)
  let modulus = fromMaybe usual modulusGiven
  when
    (length (take (length usual + 1) modulus) /= length usual)
    (misused ("the modulus of GF(" ++ show q ++ ") has degree " ++ show (length usual - 1)))
  found <-
    orUnusable id =<< orUnusable fieldMessage (withField p modulus (\k -> search k q symbols))
  printAs form (foundText found) (encodeSynthesis found)
  pure (if synthesisUnique found then Answered else NotAnswered)

-- | The shortest register over the field of this order; 'Left' names the first invalid symbol.
search ::
  forall k. KnownField k => Proxy k -> Natural -> [String] -> Either String SynthesisReport
search k q symbols = do
  terms <- traverse element (zip [1 :: Int ..] symbols) :: Either String [GF k]
  let result = synthesise terms
      h = synthesisPolynomial result
  pure
    SynthesisReport
      { synthesisOrder = q,
        synthesisModulus = fieldModulus k,
        synthesisSymbols = synthesisTerms result,
        synthesisCodes = map codeOf (coefficients h),
        synthesisRegister = synthesisLength result,
        synthesisUnique = synthesisDetermined result,
        synthesisPrimitive =
          if synthesisLength result > 256 then Nothing else primitivity h (checkPrimitive h),
        synthesisState = map codeOf (take (synthesisLength result) terms)
      }
  where
    element (i, text) =
      first (\e -> "symbol " ++ show i ++ ": " ++ fieldMessage e) (parseElement text)
    codeOf = fromIntegral . toCode :: GF k -> Natural
    primitivity h checked = case checked of
      Right _ -> Just True
      -- If q^n - 1 is not factored, a reducible polynomial is still known not to be primitive.
      Left (OrderNotFactored _) -> if isIrreducible h then Nothing else Just False
      Left _ -> Just False

foundText :: SynthesisReport -> String
foundText found =
  unlines
    [ "polynomial " ++ list (synthesisCodes found),
      "length     " ++ show (synthesisRegister found),
      "determined " ++ if synthesisUnique found then "yes" else "no: " ++ missing,
      "primitive  " ++ maybe "not decided" (\yes -> if yes then "yes" else "no") primitivity,
      "state      " ++ list (synthesisState found)
    ]
  where
    list = intercalate "," . map show
    primitivity = synthesisPrimitive found
    missing =
      show (2 * synthesisRegister found)
        ++ " symbols would determine it, and there are "
        ++ show (synthesisSymbols found)
