{-# LANGUAGE OverloadedStrings #-}

-- | The server side of the protocol: an implementation in this process that answers JSON lines.
-- Every line gets one line in reply, except @stop@.
module PraTactile.Conformance.Serve
  ( serve,
    serveOnce,
    replyOnce,
  )
where

import Control.Monad (when)
import Data.Aeson
import Data.Aeson.Encoding (encodingToLazyByteString)
import qualified Data.Aeson.KeyMap as KeyMap
import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.IORef (writeIORef)
import Data.List (find)
import Data.Maybe (fromMaybe)
import qualified Data.Text as Text
import GHC.Clock (getMonotonicTime)
import PraTactile.Conformance.Forms (readWhole)
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.InProcess
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Question
import PraTactile.Conformance.Subject (Response (..), responseItem)
import PraTactile.Conformance.Wire.Line (lineHolds, longestLine, readLine)
import PraTactile.Format.Json.Codec (readValue)
import PraTactile.Format.Profile (profileCodec)
import System.IO

-- | Answers the lines of the first handle on the second, until @stop@ or the end of input.
serve :: Implementation -> Handle -> Handle -> IO ()
serve implementation input output = do
  mapM_ (`hSetBinaryMode` True) [input, output]
  hSetBuffering output (BlockBuffering (Just 65536))
  force <- noForce
  start <- getMonotonicTime
  replying (replyTo implementation force) input output start Empty

-- | The input that was read but not used: bytes, or the rest of a line that is too long.
data Pending
  = Empty
  | Pending ByteString
  | TooLong

-- | Replies to each line. Replies are flushed when no more input waits, or after a fiftieth of a
-- second.
replying ::
  (ByteString -> IO (Maybe Lazy.ByteString)) -> Handle -> Handle -> Double -> Pending -> IO ()
replying reply input output = go
  where
    go flushed pending = case pending of
      Pending bytes
        | Just i <- Bytes.elemIndex '\n' bytes,
          i <= longestLine -> do
          answer <- reply (Bytes.take i bytes)
          case answer of
            Nothing -> hFlush output
            Just said -> do
              Lazy.hPut output said
              now <- getMonotonicTime
              let due = now - flushed > 0.02
              when due (hFlush output)
              go (if due then now else flushed) (Pending (Bytes.drop (i + 1) bytes))
      Pending bytes | Bytes.length bytes > longestLine -> do
        Lazy.hPut output (line (errored "a line of more than 1 MiB"))
        go flushed (afterLine bytes)
      _ -> do
        hFlush output
        more <- Bytes.hGetSome input 65536
        now <- getMonotonicTime
        case (pending, Bytes.null more) of
          (Pending rest, True)
            | not (Bytes.null rest) -> reply rest >>= mapM_ (Lazy.hPut output) >> hFlush output
          (_, True) -> hFlush output
          (TooLong, _) -> go now (afterLine more)
          (Pending rest, _) -> go now (Pending (rest <> more))
          (Empty, _) -> go now (Pending more)
    afterLine bytes = case Bytes.elemIndex '\n' bytes of
      Just i -> Pending (Bytes.drop (i + 1) bytes)
      Nothing -> TooLong

-- | An object as a line.
line :: Series -> Lazy.ByteString
line keys = object' keys <> "\n"

object' :: Series -> Lazy.ByteString
object' = encodingToLazyByteString . pairs

-- | The reply to a line; 'Nothing' for @stop@.
replyTo :: Implementation -> Force -> ByteString -> IO (Maybe Lazy.ByteString)
replyTo implementation force bytes = case requestIn bytes of
  Left problem -> pure (Just (line (errored problem)))
  Right keys -> case KeyMap.lookup "command" keys of
    Just "start" -> pure (Just (line (started implementation keys)))
    Just "profile" -> Just . line . responseKeys <$> profiled implementation force keys
    Just "run" -> Just . numbered keys <$> ran implementation force keys
    Just "stop" -> pure Nothing
    _ -> pure (Just (numbered keys (errored "a command is start, profile, run or stop")))

requestIn :: ByteString -> Either String Object
requestIn bytes = case readLine bytes of
  Right (Object keys) -> Right keys
  Right _ -> Left "a request is a JSON object"
  Left _ -> Left "a request is one line of JSON"

-- | The implementation's description of itself.
started :: Implementation -> Object -> Series
started implementation keys
  | KeyMap.lookup "protocol" keys == Just (Number 1) =
    "protocol" .= (1 :: Int)
      <> "name" .= implementationName implementation
      <> "operations" .= map nameOf (offered implementation)
      <> "in_flight" .= (64 :: Int)
  | otherwise = errored "only protocol 1 is spoken here"

-- | Puts the profile of a request in force. An invalid profile is refused like an invalid input,
-- and integers are read as in inputs.
profiled :: Implementation -> Force -> Object -> IO Response
profiled implementation force keys = case readProfile <$> KeyMap.lookup "profile" keys of
  Just (Right asked) -> putInForce implementation force asked
  _ -> ResponseRefused "invalid" <$ writeIORef force Nothing
  where
    readProfile = readValue profileCodec . integersAsText

-- | A value with each integer as a decimal string, and each other number as null.
integersAsText :: Value -> Value
integersAsText value = case value of
  Number _ -> maybe Null (String . Text.pack . show) (readWhole value)
  Array items -> Array (integersAsText <$> items)
  Object fields -> Object (integersAsText <$> fields)
  _ -> value

-- | The answer to a @run@ request under the profile in force.
ran :: Implementation -> Force -> Object -> IO Series
ran implementation force keys = case KeyMap.lookup "operation" keys of
  Just (String name)
    | Just operation <- find ((== Text.unpack name) . nameOf) (offered implementation) ->
      responseKeys <$> answerIn implementation force (Raw operation input)
    | otherwise ->
      let skipped = ResponseSkipped (Text.unpack name ++ " is not offered")
       in pure (responseKeys skipped <> "link" .= page)
  _ -> pure (errored "a run has an operation")
  where
    input = fromMaybe Null (KeyMap.lookup "input" keys)
    page = "docs/reference/protocol.md" :: String

-- | Answers one request of the first handle on the second, by 'replyOnce'.
serveOnce :: Implementation -> Handle -> Handle -> IO ()
serveOnce implementation input output = do
  mapM_ (`hSetBinaryMode` True) [input, output]
  bytes <- firstLine [] 0
  either (pure . line . errored) (replyOnce implementation) bytes >>= Lazy.hPut output
  hFlush output
  where
    firstLine pieces size = do
      more <- Bytes.hGetSome input 65536
      let whole = Bytes.concat (reverse (more : pieces))
      if Bytes.null more || Bytes.elem '\n' more
        then pure (Right (Bytes.takeWhile (/= '\n') whole))
        else
          if size + Bytes.length more > longestLine
            then pure (Left "a line of more than 1 MiB")
            else firstLine (more : pieces) (size + Bytes.length more)

-- | The reply to a single request that includes a profile. Without an operation it tells whether
-- the profile is possible.
replyOnce :: Implementation -> ByteString -> IO Lazy.ByteString
replyOnce implementation = either (pure . line . errored) once . requestIn
  where
    once keys = do
      force <- noForce
      opened <- profiled implementation force keys
      numbered keys <$> case opened of
        ResponseResult _ | KeyMap.member "operation" keys -> ran implementation force keys
        _ -> pure (responseKeys opened)

-- | The reply as a line with the request's sequence number. A reply that is too long for a line
-- becomes a refusal.
numbered :: Object -> Series -> Lazy.ByteString
numbered request reply
  | lineHolds whole = whole <> "\n"
  | otherwise = line (repeated <> responseKeys (ResponseRefused "too-long"))
  where
    whole = object' (repeated <> reply)
    repeated = case KeyMap.lookup "sequence" request of
      Just number | Just _ <- readWhole number -> "sequence" .= number
      _ -> mempty

responseKeys :: Response -> Series
responseKeys = uncurry (.=) . responseItem

errored :: String -> Series
errored = ("errored" .=)
