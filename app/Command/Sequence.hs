-- | @pra-tactile sequence@: terms of the m-sequence, from any index on.
module Command.Sequence
  ( command,
  )
where

import ArrayChoice
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy.Char8 as Lazy8
import Data.List (intersperse)
import qualified Data.Vector.Primitive as Primitive
import ExitStatus
import Message (profileMessage)
import Numeric.Natural (Natural)
import Options
import PraTactile.Array (PseudorandomArray, arrayPrimitive, arrayState)
import PraTactile.Field (KnownField, toCode)
import PraTactile.Format (encodeTerms)
import PraTactile.Profile
import PraTactile.Sequence
import System.IO (stdout)

command :: Subcommand
command =
  subcommand
    "sequence"
    "Print terms of the m-sequence, from any index on"
    "Print terms of the m-sequence, as codes. They begin at any index, which may be negative or \
    \very large. --shape may be left out."
    [arrayGroup]
    [ "pra-tactile sequence --length 20",
      "pra-tactile sequence --q 4 --polynomial 3,2,1,0,1 --from 1000000000000000000 --length 40",
      "pra-tactile sequence --from=-3 --json"
    ]
    (run <$> from <*> count <*> jsonSwitch "Print the terms as JSON" <*> arrayChoice)
  where
    from =
      option
        decimalReader
        ( long "from"
            <> metavar "INDEX"
            <> value 0
            <> help "Index of the first term, of any size, also negative (default: 0)"
        )
    count =
      option
        naturalReader
        (long "length" <> metavar "NUMBER" <> value 40 <> help "Number of terms (default: 40)")

run :: Integer -> Natural -> AnswerForm -> ArrayChoice -> IO ExitStatus
run from count form choice = do
  profile <- chosenSequence choice
  codes <-
    orUnusable
      profileMessage
      (withProfile profile (\array _ -> codesFrom array from (toInteger count)))
  case form of
    AsText -> Builder.hPutBuilder stdout (spaced (map Builder.intDec codes) <> Builder.char7 '\n')
    AsJson -> Lazy8.putStrLn (encodeTerms profile from count codes)
  pure Answered
  where
    spaced = mconcat . intersperse (Builder.char7 ' ')

-- | Terms from an index on, this many, block by block.
codesFrom :: KnownField k => PseudorandomArray k -> Integer -> Integer -> [Int]
codesFrom array from count
  | count <= 0 = []
  | otherwise =
    map
      toCode
      (Primitive.toList (sequenceVector h (stateAt h (arrayState array) from) (fromInteger size)))
      ++ codesFrom array (from + size) (count - size)
  where
    h = arrayPrimitive array
    size = min count (2 ^ (16 :: Int))
