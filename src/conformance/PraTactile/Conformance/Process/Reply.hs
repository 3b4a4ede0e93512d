{-# LANGUAGE OverloadedStrings #-}

-- | The lines of the protocol: writes requests, and reads replies strictly.
module PraTactile.Conformance.Process.Reply
  ( -- * Requests
    startRequest,
    profileRequest,
    profileRequestOf,
    runRequest,
    stopRequest,
    oneShotRequest,
    requestLine,

    -- * Replies
    Reply (..),
    readReply,
    Started (..),
    readStarted,
    excerpt,
  )
where

import Data.Aeson
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (toList)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import qualified Data.Text.Encoding.Error as Text
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Question
import PraTactile.Conformance.Subject
import PraTactile.Conformance.Wire.Line (readLine)
import PraTactile.Format.Error
  ( JsonError (JsonInEncoding, NoText, NotUtf8, RepeatedKey, TooDeep, TooLong),
  )
import PraTactile.Format.Json.Codec (integer, readValue)
import PraTactile.Format.Profile (profileValue)
import PraTactile.Profile (Profile)

-- | The first request.
startRequest :: Value
startRequest = object ["command" .= text "start", "protocol" .= (1 :: Int)]

-- | The request to put a profile in force.
profileRequest :: Profile -> Value
profileRequest = profileRequestOf . profileValue

-- | The request to put a profile in force, from the profile's JSON.
profileRequestOf :: Value -> Value
profileRequestOf profile = object ["command" .= text "profile", "profile" .= profile]

-- | The request to answer a question, with its sequence number.
runRequest :: Int -> SomeQuestion -> Value
runRequest number (SomeQuestion question) =
  object
    [ "command" .= text "run",
      "sequence" .= number,
      "operation" .= nameOf (operationOf question),
      "input" .= questionInput question
    ]

-- | The last request, which has no reply.
stopRequest :: Value
stopRequest = object ["command" .= text "stop"]

-- | The only request to a one-shot command. Without a question it asks whether the profile is
-- possible.
oneShotRequest :: Profile -> Maybe (Int, SomeQuestion) -> Value
oneShotRequest profile asked =
  Object ("profile" .= profileValue profile <> maybe mempty run asked)
  where
    run (number, question) = case runRequest number question of
      Object keys -> KeyMap.delete "command" keys
      _ -> mempty

text :: String -> String
text = id

-- | A request as a line.
requestLine :: Value -> Lazy.ByteString
requestLine request = encode request <> "\n"

-- | A reply, with the sequence number that it repeats, if it has one.
data Reply = Reply
  { replySequence :: Maybe Integer,
    replyResponse :: Response
  }

-- | Reads a reply: an object with exactly one of the four keys. Refuses anything else.
readReply :: ByteString -> Either Fault Reply
readReply line = readObject line >>= reply
  where
    reply fields = do
      number <- traverse (numbered line) (KeyMap.lookup "sequence" fields)
      response <- case [(key, value) | key <- kinds, Just value <- [KeyMap.lookup key fields]] of
        [(key, value)] -> kind key value
        [] -> notReply line ("has none of " ++ names)
        _ -> notReply line ("has more than one of " ++ names)
      pure (Reply number response)
    kinds = ["result", "refused", "skipped", "errored"]
    names = "result, refused, skipped, errored"
    kind key value = case (key, value) of
      ("result", _) -> Right (ResponseResult value)
      ("refused", String why) -> Right (ResponseRefused (Text.unpack why))
      ("skipped", String why) -> Right (ResponseSkipped (Text.unpack why))
      (_, String why) | key /= "result" -> Right (ResponseErrored (Text.unpack why))
      _ -> notReply line ("has a " ++ Key.toString key ++ " that is no text")

-- | A subject's description of itself.
data Started = Started
  { startedName :: String,
    -- | The names that it states.
    startedOperations :: [String],
    -- | The number of requests that it accepts before a reply.
    startedInFlight :: Int
  }

-- | Reads the reply to @start@. Refuses another protocol version, and missing or invalid keys.
readStarted :: ByteString -> Either Fault Started
readStarted line = do
  fields <- readObject line
  protocol <- key fields "protocol" >>= numbered line
  if protocol /= 1
    then notReply line ("speaks protocol " ++ show protocol ++ ", not 1")
    else
      Started
        <$> (key fields "name" >>= named)
        <*> (key fields "operations" >>= listed)
        <*> (key fields "in_flight" >>= numbered line >>= positive)
  where
    key fields name =
      maybe (notReply line ("to start has no " ++ show name)) Right $
        KeyMap.lookup (Key.fromString name) fields
    named value = case value of
      String name -> Right (Text.unpack name)
      _ -> notReply line "to start has a name that is no text"
    listed value = case value of
      Array values -> traverse named (toList values)
      _ -> notReply line "to start has operations that are no list"
    positive n
      | n >= 1 = Right (fromInteger (min n 4096))
      | otherwise = notReply line "to start has an in_flight below 1"

readObject :: ByteString -> Either Fault Object
readObject line = case readLine line of
  Right (Object fields) -> Right fields
  Right _ -> notReply line "is no object"
  Left why -> Left (Fault NotJson (reason why ++ ": " ++ excerpt line))
  where
    reason why = case why of
      NoText -> "an empty line"
      TooDeep -> "a line nested deeper than 64"
      TooLong -> "a line with a number of more than 4096 digits"
      NotUtf8 -> "a line that is not UTF-8"
      JsonInEncoding _ -> "a line that is not UTF-8"
      RepeatedKey key -> "a line with the key " ++ show key ++ " twice"
      _ -> "a line that is no JSON"

numbered :: ByteString -> Value -> Either Fault Integer
numbered line =
  either (const (notReply line "has a number that is none")) Right . readValue integer

notReply :: ByteString -> String -> Either Fault a
notReply line what = Left (Fault NotAReply ("a reply that " ++ what ++ ": " ++ excerpt line))

-- | The beginning of a line, printable.
excerpt :: ByteString -> String
excerpt line
  | Bytes.length line > 100 = shown (Bytes.take 80 line) ++ " ... (" ++ size ++ " bytes)"
  | otherwise = shown line
  where
    size = show (Bytes.length line)
    shown = Text.unpack . Text.decodeUtf8With Text.lenientDecode
