{-# LANGUAGE OverloadedStrings #-}

-- | @pra-tactile sequence@: terms of the m-sequence, from wherever one likes.
module Command.Sequence
  ( command,
  )
where

import ArrayChoice
import Data.Aeson (toJSON, (.=))
import qualified Data.ByteString.Builder as Builder
import qualified Data.Vector.Primitive as Primitive
import Described
import Ending
import Json
import Message (profileMessage)
import Options.Applicative hiding (command)
import PraTactile.Array (PseudorandomArray, arrayPrimitive, arrayState)
import PraTactile.Field (KnownField, toCode)
import PraTactile.Format.Profile
import PraTactile.Profile
import PraTactile.Sequence
import System.IO (stdout)

command :: Mod CommandFields (IO Ending)
command =
  described
    "sequence"
    "Print terms of the m-sequence as codes: forward from any term, which is jumped to, or from \
    \before the first; --shape may be left out."
    [ "pra-tactile sequence --length 20",
      "pra-tactile sequence --q 4 --polynomial 3,2,1,0,1 --from 1000000000000000000 --length 40",
      "pra-tactile sequence --from=-3 --json"
    ]
    ( run
        <$> arrayChoice
        <*> from
        <*> count
        <*> switch (long "json" <> help "Print the terms as JSON")
    )
  where
    from =
      option
        decimalReader
        ( long "from"
            <> metavar "INDEX"
            <> value 0
            <> help "Index of the first term printed, of any size, also negative (default: 0)"
        )
    count =
      option
        (toInteger <$> naturalReader)
        (long "length" <> metavar "NUMBER" <> value 40 <> help "How many terms (default: 40)")

run :: ArrayChoice -> Integer -> Integer -> Bool -> IO Ending
run choice from count asJson = do
  profile <- chosenSequence choice
  codes <- orUnusable profileMessage (withProfile profile (\array _ -> codesFrom array from count))
  if asJson
    then
      printJson
        ( "schema" .= ("pra-tactile/sequence/1" :: String)
            <> "profile" .= profileValue profile
            <> "from" .= integerValue
            <> "length" .= naturalValue (fromInteger count)
            <> "terms" .= codes
        )
    else Builder.hPutBuilder stdout (spaced (map Builder.intDec codes) <> Builder.char7 '\n')
  pure Answered
  where
    integerValue =
      if from >= 0
        then naturalValue (fromInteger from)
        else
          if abs from < 2 ^ (53 :: Int)
            then toJSON from
            else toJSON (show from)
    spaced words' = case words' of
      [] -> mempty
      w : more -> w <> foldMap (Builder.char7 ' ' <>) more

-- | So many terms from an index on, block by block.
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
