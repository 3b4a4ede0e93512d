-- | A failing case as a text of only letters, digits, @-@ and @_@. It holds everything for
-- replaying the case: the law, the case and the whole profile.
module PraTactile.Conformance.Run.Token
  ( Token (..),
    writeToken,
    readToken,
  )
where

import Data.Aeson (Value (..), encode, toJSON)
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import qualified Data.ByteString.Base64.URL as Base64
import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (isAlphaNum, isAscii)
import Data.Foldable (toList)
import qualified Data.Text as Text
import PraTactile.Conformance.Wire.Line (readLine)
import PraTactile.Format.Json.Codec (readValue)
import PraTactile.Format.Profile (profileCodec, profileValue)
import PraTactile.Profile (Profile)

-- | A case of a law.
data Token = Token
  { tokenLaw :: String,
    -- | 'Nothing' for a law about opening profiles, whose case is itself a profile, and for a law
    -- without a profile.
    tokenProfile :: Maybe Profile,
    -- | The case in JSON.
    tokenCase :: Value
  }
  deriving stock (Eq, Show)

-- | The text of a token.
writeToken :: Token -> String
writeToken (Token law profile case') =
  Bytes.unpack . Base64.encodeUnpadded . Lazy.toStrict . encode $
    [toJSON version, toJSON law, maybe Null row profile, case']
  where
    row p = case profileValue p of
      Object keys -> toJSON [KeyMap.lookup (Key.fromString name) keys | name <- profileKeys]
      other -> other

-- | Reads a token; 'Nothing' if the text is not one.
readToken :: String -> Maybe Token
readToken given
  | all (\c -> isAscii c && (isAlphaNum c || c `elem` "-_")) given,
    Right bytes <- Base64.decodeUnpadded (Bytes.pack given),
    Right (Array values) <- readLine bytes,
    [Number 1, String law, profile, case'] <- toList values = do
    read' <- case profile of
      Null -> Just Nothing
      Array row
        | length row == length profileKeys ->
          either (const Nothing) (Just . Just) . readValue profileCodec . Object $
            KeyMap.fromList
              ( (Key.fromString "schema", String (Text.pack "pra-tactile/profile/1")) :
                zip (map Key.fromString profileKeys) (toList row)
              )
      _ -> Nothing
    Just (Token (Text.unpack law) read' case')
  | otherwise = Nothing

version :: Int
version = 1

-- | The keys of a profile, in the order of their values in a token.
profileKeys :: [String]
profileKeys =
  words "q modulus polynomial reading state folding shape window surface packing"
