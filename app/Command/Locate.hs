{-# LANGUAGE OverloadedStrings #-}
-- | @pra-tactile locate@: from the content of a patch to its position in the array.
module Command.Locate
  ( command
  ) where

import Data.Aeson (toJSON, (.=))
import Data.Aeson.Encoding (Series)
import qualified Data.ByteString.Lazy.Char8 as Lazy8
import Data.List (intercalate)
import Data.Maybe (fromMaybe)
import qualified Data.Text as Text
import Options.Applicative hiding (command)
import System.IO (hFlush, stdout)

import ArrayChoice
import Command.Prove (surfaceOption)
import Described
import Ending
import Explain (explainChance)
import Json
import Json.Profile
import Lines
import Locating
import Locating.Seen
import Message
import PatchText
import PraTactile.Array (Position (..), Surface (..))
import PraTactile.Field (KnownField)
import PraTactile.Locate
import PraTactile.Locate.Chance (Chance)
import PraTactile.Locate.Nearest (Radius (..))
import PraTactile.Locate.Oriented (Candidate (..))
import PraTactile.Profile

data Options = Options
  { road :: Maybe Road
  , radius :: Radius
  , doubt :: Double
  , turning :: Turning
  , explain :: Bool
  , asJson :: Bool
  , source :: Maybe [String]
  }

command :: Mod CommandFields (IO Ending)
command = described "locate" "Tell the position of a patch of symbols in the array; rows are parted by '/', cells by spaces; codes or powers; '?' is a cell that was not observed. Or JSON, in which a cell may be the list of the probabilities of all symbols. Several patches of one face are parted by ';', each with its displacement from a common point in front, 'ROW,COLUMN:'; the position is then that of the upper left cell of the rectangle around all, from which offsets count."
  [ "pra-tactile locate '3 2 / 3 1'"
  , "pra-tactile locate 'A^2 A / A^2 1' --json"
  , "pra-tactile locate '3 2 ? 1 / 3 0 2 1 / 0 1 3 ? / 1 3 2 2' --explain"
  , "pra-tactile locate '[[[0,0,0.1,0.9], 2], [3, 1]]' --doubt 0.2"
  , "pra-tactile locate '3 2 / 3 1 ; 0,3: 1 1 / 1 1'"
  , "pra-tactile locate '{\"patches\": [{\"at\": [0, 0], \"cells\": [[3, 2], [3, 1]]}, {\"at\": [0, 3], \"cells\": [[1, 1], [1, 1]]}]}' --json"
  , "pra-tactile locate --orientation turned '1 0 3 3 / 0 1 1 2 / 2 3 2 0 / 2 0 1 1'"
  , "pra-tactile locate --batch < patches.txt" ]
  (run <$> arrayChoice <*> surfaceOption <*> options)
  where
    options = Options
      <$> optional (option roadReader (long "road" <> metavar "table|algebra|search" <> completeWith (map roadName [TableRoad, AlgebraRoad, SearchRoad]) <> help "How to find positions at which all observed cells agree (default: correct errors, by comparing with every position or, beyond 2^20 cells, by information sets)"))
      <*> radiusOption "Correct up to N wrong cells, at the risk of wrong answers (default: as many as the observed cells guarantee)"
      <*> option decimalReader (long "doubt" <> metavar "P" <> value 0.001 <> showDefault <> help "With probabilities: the probability of a wrong answer that is tolerated")
      <*> option turningReader (long "orientation" <> metavar "upright|turned|any" <> completeWith (map turningName [minBound ..]) <> value Upright <> showDefaultWith turningName <> help "How patches may be seen: by any quarter turn (turned), perhaps also mirrored (any); the answer then tells the orientation, clockwise, and says where it cannot")
      <*> switch (long "explain" <> help "Say what the answer rests on: the cells, their equations, the distance to the next candidate")
      <*> switch (long "json" <> help "Print the answer as JSON")
      <*> (flag' Nothing (long "batch" <> help "Read one patch, or several parted by ';', a line from the standard input; print one JSON answer a line")
        <|> (Just <$> some (strArgument (metavar "PATCH"))))
    turningReader = eitherReader $ \name -> case lookup name [ (turningName t, t) | t <- [minBound ..] ] of
      Just found -> Right found
      Nothing -> Left (show name ++ " is no choice of orientation; write upright, turned or any")
    roadReader = eitherReader $ \name -> case lookup name [ (roadName r, r) | r <- [TableRoad, AlgebraRoad, SearchRoad] ] of
      Just found -> Right found
      Nothing -> Left (show name ++ " is no road; write table, algebra or search")

run :: ArrayChoice -> Maybe Surface -> Options -> IO Ending
run choice chosen options
  | not (doubt options >= 0 && doubt options < 1) = unusable "--doubt is a probability below 1"
  | Just _ <- road options, UpTo _ <- radius options = unusable "--road finds positions at which all cells agree; leave it out to correct errors with --radius"
  | Just words'@(_ : _ : _) <- source options =
      unusable ("a patch is one argument; write it between quotation marks: '" ++ unwords words' ++ "'")
  | otherwise = do
      profile <- chosenProfile choice
      let on = fromMaybe (profileSurface profile) chosen
          how = Choice (road options) (radius options) (doubt options) (profilePacking profile)
      answered <- orUnusable profileMessage (withProfile profile (\array mask -> answering profile options <$> reporter how (turning options) on array mask))
      either unusable id answered

answering :: KnownField k => Profile -> Options -> (Written k -> Either String Report) -> IO Ending
answering profile options locate = case source options of
  Nothing -> batch profile options locate
  Just given -> case readPatches (Text.pack (unwords given)) >>= locate of
    Left complaint -> unusable complaint
    Right report -> do
      if asJson options
        then printJson (outcomeJson profile options report)
        else do
          putStr (unlines (answerText report : (if explain options then explained (reportAnswer report) else [])))
          mapM_ warn (worthLittle (reportAnswer report))
      pure (endingOf (answerOutcome (reportAnswer report)))

-- | What the answer rests on, and what it is worth.
explained :: Answer -> [String]
explained answer = answerExplained answer ++ maybe [] explainChance (answerChance answer)

-- | That a position would be told of random symbols as well.
worthLittle :: Answer -> Maybe String
worthLittle answer = case answerOutcome answer of
  Located _ _ -> answerChance answer >>= chanceWarning
  _ -> Nothing

-- | One line after another, each answered at once; the worst ending of all.
batch :: KnownField k => Profile -> Options -> (Written k -> Either String Report) -> IO Ending
batch profile options locate = forLines answerLine Answered
  where
    answerLine worst given = do
      let answer = textOf given >>= readPatches >>= locate
      Lazy8.putStrLn (encodeLine (either (invalidJson profile) (outcomeJson profile options) answer))
      hFlush stdout
      pure (max worst (either (const Unusable) (endingOf . answerOutcome . reportAnswer) answer))
    textOf given = case given of
      Line text -> Right text
      NotUtf8 -> Left "the line is not UTF-8 text"
      TooLong size -> Left ("the line has " ++ show size ++ " bytes; at most " ++ show largestLine ++ " are read")

-- | The outcome, how many cells were taken to be wrong, and which patches do not belong.
answerText :: Report -> String
answerText report = intercalate "; " ((told ++ corrections (answerCorrected answer)) : reportTogether report)
  where
    answer = reportAnswer report
    told = case (answerOutcome answer, reportCandidates report) of
      (located@(Located _ _), Just [Candidate o _]) -> outcomeText located ++ ", " ++ orientationText o
      (Ambiguous _ _, Just candidates) -> "ambiguous: " ++ show (length candidates) ++ " positions and orientations fit: "
        ++ intercalate "; " [ pairText (candidatePosition c) ++ " " ++ orientationText (candidateSymmetry c) | c <- candidates ]
      (AmbiguousCoset count _, Just _) -> "ambiguous: " ++ show count ++ " positions and orientations fit"
      (outcome, _) -> outcomeText outcome
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
  Ambiguous places _ -> "ambiguous: " ++ show (length places) ++ " positions fit: " ++ unwords (map pairText places)
  AmbiguousCoset count _ -> "ambiguous: " ++ show count ++ " positions fit"
  Refused reason -> "refused (" ++ reasonName reason ++ "): " ++ reasonMessage reason

outcomeJson :: Profile -> Options -> Report -> Series
outcomeJson profile options report = base <> "road" .= roadName (answerRoad answer) <> mconcat [ key .= detail | (key, detail) <- answerDetails answer ]
    <> (if explain options then "explanation" .= explained answer else mempty)
  where
    answer = reportAnswer report
    base = case answerOutcome answer of
      Located place support -> form "located" (Just place) [] Nothing ("located: " ++ answerText report) support
      Ambiguous places support -> form "ambiguous" Nothing places Nothing (answerText report) support
      AmbiguousCoset _ _ -> form "ambiguous" Nothing [] Nothing (answerText report) []
      Refused reason -> form "refused" Nothing [] (Just (reasonName reason)) (reasonMessage reason) []
    form = answerJson profile (answerChance answer)

invalidJson :: Profile -> String -> Series
invalidJson profile complaint = answerJson profile Nothing "invalid" Nothing [] (Just "bad-input") complaint []

answerJson :: Profile -> Maybe Chance -> String -> Maybe Position -> [Position] -> Maybe String -> String -> [Position] -> Series
answerJson profile worth outcome place places reason message support =
  "schema" .= ("pra-tactile/locate/1" :: String)
    <> "profile" .= profileValue profile
    <> "outcome" .= outcome
    <> "position" .= fmap positionValue place
    <> "positions" .= map positionValue places
    <> "reason" .= reason
    <> "message" .= message
    <> "windows" .= map (toJSON . positionListValue) support
    <> chanceSeries worth
