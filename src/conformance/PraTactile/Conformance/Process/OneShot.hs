{-# LANGUAGE OverloadedStrings #-}

-- | The protocol with one process per request: one object in, one reply out.
module PraTactile.Conformance.Process.OneShot
  ( oneShot,
    offeredOneShot,
    runOnce,
  )
where

import Control.Exception
import Data.Aeson (Value)
import qualified Data.ByteString.Char8 as Bytes
import GHC.Clock (getMonotonicTime)
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Process.Await
import PraTactile.Conformance.Process.Child
import PraTactile.Conformance.Process.Lines
import PraTactile.Conformance.Process.Reply
import PraTactile.Conformance.Process.Session (Limits (..))
import PraTactile.Conformance.Question
import PraTactile.Conformance.Subject
import PraTactile.Profile (Profile)
import System.Exit (ExitCode (..))

-- | Asks one question, or, without a question, whether the profile is possible.
oneShot :: Limits -> Command -> Profile -> Maybe (Int, SomeQuestion) -> IO (Either Fault Response)
oneShot limits command profile asked = do
  answered <- runOnce limits command (oneShotRequest profile asked)
  pure (answered >>= named)
  where
    named reply = case (asked, replySequence reply) of
      (Just (number, _), Just given)
        | given == toInteger number -> Right (replyResponse reply)
        | otherwise -> Left (Fault OutOfOrder (wrong number ("\"sequence\" " ++ show given)))
      (Just (number, _), Nothing) -> Left (Fault NotAReply (wrong number "no \"sequence\""))
      (Nothing, _) -> Right (replyResponse reply)
    wrong number what = "a reply to request " ++ show number ++ " with " ++ what

-- | Starts the command, sends one request, and reads its only reply.
runOnce :: Limits -> Command -> Value -> IO (Either Fault Reply)
runOnce limits command request = bracket (begin command) (mapM_ end) $ \started ->
  case started of
    Left problem -> pure (Left (Fault CannotStart problem))
    Right child -> do
      send child (requestLine request)
      closeInput child
      now <- getMonotonicTime
      let deadline = now + limitReply limits
      line <- awaitLine child (limitReply limits)
      case line of
        Left fault -> pure (Left fault)
        Right bytes -> either (pure . Left) (ended child deadline) (readReply bytes)

-- | Accepts the reply if nothing follows it and the process exits with status 0.
ended :: Child -> Double -> Reply -> IO (Either Fault Reply)
ended child deadline reply = do
  more <- restOf
  case more of
    Line line
      | Right _ <- readReply line -> fault AnsweredTwice ("a second reply: " ++ excerpt line)
      | otherwise -> fault NotAReply ("output after the reply: " ++ excerpt line)
    Oversized start -> fault LineTooLong ("output after the reply: " ++ excerpt start)
    Unfinished _ -> fault DoesNotStop "it does not end after its reply"
    NoMore partial
      | not (Bytes.null partial) ->
        fault HalfLine ("output after the reply: " ++ excerpt partial)
      | otherwise -> do
        code <- waitExit child deadline
        case code of
          Just ExitSuccess -> pure (Right reply)
          Just failed -> fault Crashed (exitText failed ++ ", after its reply")
          Nothing -> fault DoesNotStop "it does not end after its reply"
  where
    restOf = nextLine child deadline
    fault kind detail = flooded child 1 (Fault kind detail) >>= fmap Left . withErrors child

-- | The operations that a command offers. Each is asked once; a reply of @skipped@ means that it
-- is not offered. 'Left' if the command answers none.
offeredOneShot :: Limits -> Command -> Profile -> IO (Either Fault [SomeOp])
offeredOneShot limits command profile = do
  replies <- sampled (map exampleOf allOperations)
  pure $ case [why | (_, Left why) <- replies] of
    why : _ | null [() | (_, Right _) <- replies] -> Left why
    _ -> Right [operation | (operation, reply) <- replies, not (skips reply)]
  where
    -- A command that cannot be started once is not tried again.
    sampled questions = case questions of
      [] -> pure []
      question@(SomeQuestion asked) : others -> do
        reply <- oneShot limits command profile (Just (1, question))
        ((operationOf asked, reply) :) <$> case reply of
          Left why | faultKind why == CannotStart -> pure []
          _ -> sampled others
    skips reply = case reply of
      Right (ResponseSkipped _) -> True
      _ -> False
