{-# LANGUAGE OverloadedStrings #-}
-- | @pra-tactile locate@: from the content of a patch to its position in the array.
module Command.Locate
  ( command
  ) where

import Data.Aeson (toJSON, (.=))
import Data.Aeson.Encoding (Series)
import qualified Data.ByteString.Lazy.Char8 as Lazy8
import Data.Maybe (fromMaybe)
import Options.Applicative hiding (command)
import System.IO (hFlush, isEOF, stdout)

import ArrayChoice
import Command.Prove (surfaceOption)
import Described
import Ending
import Json
import Json.Profile
import Locating
import Message
import PatchText
import PraTactile.Array (Position (..), Surface (..))
import PraTactile.Field (KnownField)
import PraTactile.Locate
import PraTactile.Locate.Nearest (Radius (..))
import PraTactile.Profile

data Options = Options
  { road :: Maybe Road
  , radius :: Radius
  , doubt :: Double
  , explain :: Bool
  , asJson :: Bool
  , source :: Maybe String
  }

command :: Mod CommandFields (IO Ending)
command = described "locate" "Tell the position of a patch of symbols in the array; rows are parted by '/', cells by spaces; codes or powers; '?' is a cell that was not observed. Or JSON, in which a cell may be the list of the probabilities of all symbols."
  [ "pra-tactile locate '3 2 / 3 1'"
  , "pra-tactile locate 'A^2 A / A^2 1' --json"
  , "pra-tactile locate '3 2 1 / 3 ? 1 / 0 1 2' --explain"
  , "pra-tactile locate '[[[0,0,0.1,0.9], 2], [3, 1]]' --doubt 0.2"
  , "pra-tactile locate --batch < patches.txt" ]
  (run <$> arrayChoice <*> surfaceOption <*> options)
  where
    options = Options
      <$> optional (option roadReader (long "road" <> metavar "table|algebra|search" <> help "How to find positions at which all observed cells agree (default: compare with every position and correct errors; by algebra beyond 2^20 cells)"))
      <*> (maybe Guaranteed UpTo <$> optional (option naturalReader (long "radius" <> metavar "N" <> help "Correct up to N wrong cells, at the risk of wrong answers (default: as many as the observed cells guarantee)")))
      <*> option auto (long "doubt" <> metavar "P" <> value 0.001 <> showDefault <> help "With probabilities: the probability of a wrong answer that is tolerated")
      <*> switch (long "explain" <> help "Say what the answer rests on: the cells, their equations, the distance to the next candidate")
      <*> switch (long "json" <> help "Print the answer as JSON")
      <*> (flag' Nothing (long "batch" <> help "Read one patch a line from the standard input; print one JSON answer a line")
        <|> (Just <$> strArgument (metavar "PATCH")))
    roadReader = eitherReader $ \name -> case lookup name [ (roadName r, r) | r <- [TableRoad, AlgebraRoad, SearchRoad] ] of
      Just found -> Right found
      Nothing -> Left (show name ++ " is no road; write table, algebra or search")

run :: ArrayChoice -> Maybe Surface -> Options -> IO Ending
run choice chosen options
  | not (doubt options >= 0 && doubt options < 1) = unusable "--doubt is a probability below 1"
  | Just _ <- road options, UpTo _ <- radius options = unusable "--road finds positions at which all cells agree; leave it out to correct errors with --radius"
  | otherwise = do
      profile <- chosenProfile choice
      let on = fromMaybe (profileSurface profile) chosen
          how = Choice (road options) (radius options) (doubt options) (profilePacking profile)
      answered <- orUnusable profileMessage (withProfile profile (\array mask -> answering profile options <$> locator how on array mask))
      either unusable id answered

answering :: KnownField k => Profile -> Options -> Locator k -> IO Ending
answering profile options locate = case source options of
  Nothing -> batch profile options locate Answered
  Just text -> case readPatch text >>= locate of
    Left complaint -> unusable complaint
    Right answer -> do
      if asJson options
        then printJson (outcomeJson profile options answer)
        else putStr (unlines (answerText answer : (if explain options then answerExplained answer else [])))
      pure (endingOf (answerOutcome answer))

-- | One line after another, each answered at once; the worst ending of all.
batch :: KnownField k => Profile -> Options -> Locator k -> Ending -> IO Ending
batch profile options locate worst = do
  done <- isEOF
  if done then pure worst else do
    line <- getLine
    let answer = readPatch line >>= locate
    Lazy8.putStrLn (encodeLine (either (invalidJson profile) (outcomeJson profile options) answer))
    hFlush stdout
    let ending = either (const Unusable) (endingOf . answerOutcome) answer
    ending `seq` batch profile options locate $! max worst ending

-- | The outcome, and how many cells were taken to be wrong.
answerText :: Answer -> String
answerText answer = outcomeText (answerOutcome answer) ++ corrections (answerCorrected answer)
  where
    corrections cells = case length cells of
      0 -> ""
      1 -> " (1 cell corrected)"
      n -> " (" ++ show n ++ " cells corrected)"

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

outcomeJson :: Profile -> Options -> Answer -> Series
outcomeJson profile options answer = base <> "road" .= roadName (answerRoad answer) <> mconcat [ key .= detail | (key, detail) <- answerDetails answer ]
    <> (if explain options then "explanation" .= answerExplained answer else mempty)
  where
    base = case answerOutcome answer of
      Located place support -> form "located" (Just place) [] Nothing ("located: " ++ answerText answer) support
      Ambiguous places support -> form "ambiguous" Nothing places Nothing (answerText answer) support
      AmbiguousCoset _ _ -> form "ambiguous" Nothing [] Nothing (answerText answer) []
      Refused reason -> form "refused" Nothing [] (Just (reasonName reason)) (reasonMessage reason) []
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
