{-# LANGUAGE OverloadedStrings #-}
-- | @pra-tactile locate@: from the content of a patch to its position in the array.
module Command.Locate
  ( command
  ) where

import Data.Aeson (toJSON, (.=))
import Data.Aeson.Encoding (Series)
import qualified Data.ByteString.Lazy.Char8 as Lazy8
import Data.Char (isSpace)
import Data.Maybe (fromMaybe)
import Options.Applicative hiding (command)
import System.IO (hFlush, isEOF, stdout)

import ArrayChoice
import Command.Prove (surfaceOption)
import Described
import Ending
import Json
import Json.Profile
import Message
import PraTactile.Array (Position (..), Surface (..))
import PraTactile.Field (KnownField, parseElement)
import PraTactile.Locate
import PraTactile.Profile

command :: Mod CommandFields (IO Ending)
command = described "locate" "Tell the position of a patch of symbols in the array; rows are parted by '/', cells by spaces; codes or powers; '?' is a cell that was not observed."
  [ "pra-tactile locate '3 2 / 3 1'"
  , "pra-tactile locate 'A^2 A / A^2 1' --json"
  , "pra-tactile locate --batch < patches.txt" ]
  (run <$> arrayChoice <*> surfaceOption <*> switch (long "json" <> help "Print the answer as JSON") <*> source)
  where
    source = flag' Nothing (long "batch" <> help "Read one patch a line from the standard input; print one JSON answer a line")
      <|> (Just <$> strArgument (metavar "PATCH"))

run :: ArrayChoice -> Maybe Surface -> Bool -> Maybe String -> IO Ending
run choice chosen asJson source = do
  profile <- chosenProfile choice
  let on = fromMaybe (profileSurface profile) chosen
      build array mask = buildTable (profilePacking profile) on array mask
  answered <- orUnusable profileMessage (withProfile profile (\array mask -> fmap (answering profile asJson source) (build array mask)))
  either (unusable . locateMessage) id answered

answering :: KnownField k => Profile -> Bool -> Maybe String -> Table k -> IO Ending
answering profile asJson source table = case source of
  Nothing -> batch profile table Answered
  Just text -> case answer table text of
    Left complaint -> unusable complaint
    Right outcome -> do
      if asJson then printJson (outcomeJson profile outcome) else putStrLn (outcomeText outcome)
      pure (endingOf outcome)

-- | One line after another, each answered at once; the worst ending of all.
batch :: KnownField k => Profile -> Table k -> Ending -> IO Ending
batch profile table worst = do
  done <- isEOF
  if done then pure worst else do
    line <- getLine
    let outcome = answer table line
    Lazy8.putStrLn (encodeLine (either (invalidJson profile) (outcomeJson profile) outcome))
    hFlush stdout
    let ending = either (const Unusable) endingOf outcome
    ending `seq` batch profile table $! max worst ending

-- | Locate a patch as it is written; 'Left' says what is wrong with the writing.
answer :: KnownField k => Table k -> String -> Either String Outcome
answer table text = do
  cells <- traverse (traverse cell . words) (rowsOf text)
  observed <- either (Left . locateMessage) Right (patch cells)
  pure (locatePatch table observed)
  where
    cell "?" = Right Nothing
    cell word = either (Left . fieldMessage) (Right . Just) (parseElement word)

-- | The rows, parted by @/@; none in an empty line.
rowsOf :: String -> [String]
rowsOf text
  | all isSpace text = []
  | otherwise = parted text
  where
    parted rest = case break (== '/') rest of
      (line, _ : more) -> line : parted more
      (line, []) -> [line]

endingOf :: Outcome -> Ending
endingOf outcome = case outcome of
  Located _ _ -> Answered
  Ambiguous _ _ -> NotAnswered
  AmbiguousCoset _ _ -> NotAnswered
  Refused _ -> NotAnswered

outcomeText :: Outcome -> String
outcomeText outcome = case outcome of
  Located (Position r c) _ -> "row " ++ show r ++ ", column " ++ show c
  Ambiguous places _ -> "ambiguous: " ++ show (length places) ++ " positions fit: " ++ unwords (map pair places)
  AmbiguousCoset count _ -> "ambiguous: " ++ show count ++ " positions fit"
  Refused reason -> "refused (" ++ reasonName reason ++ "): " ++ reasonMessage reason
  where
    pair (Position r c) = show r ++ "," ++ show c

outcomeJson :: Profile -> Outcome -> Series
outcomeJson profile outcome = case outcome of
  Located place support -> form "located" (Just place) [] Nothing ("located: " ++ outcomeText outcome) support
  Ambiguous places support -> form "ambiguous" Nothing places Nothing (outcomeText outcome) support
  AmbiguousCoset _ _ -> form "ambiguous" Nothing [] Nothing (outcomeText outcome) []
  Refused reason -> form "refused" Nothing [] (Just (reasonName reason)) (reasonMessage reason) []
  where
    form = answerJson profile

invalidJson :: Profile -> String -> Series
invalidJson profile complaint = answerJson profile "invalid" Nothing [] (Just "bad-input") complaint []

answerJson :: Profile -> String -> Maybe Position -> [Position] -> Maybe String -> String -> [Position] -> Series
answerJson profile outcome place places reason message support =
  "schema" .= ("pra-tactile/locate/1" :: String)
    <> "profile" .= profileValue profile
    <> "outcome" .= outcome
    <> "position" .= fmap positionValue place
    <> "positions" .= map positionValue places
    <> "reason" .= reason
    <> "message" .= message
    <> "windows" .= map (toJSON . positionListValue) support
