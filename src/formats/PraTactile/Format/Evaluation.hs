{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The JSON that the command @evaluate@ writes. The file of a shard has one line per press, so
-- that it can be continued and shards can be merged.
--
-- > {"schema":"pra-tactile/evaluate/1",...,"shard":[1,3],"setting":"5c0e...","results":[
-- > {"press":1,"stitching":{"right":2.1e-6},"no_stitching":{"refused":"ambiguous"},"check":...}
-- > ,{"press":4,...}
-- > ],"stitching":{"right":...},...}
module PraTactile.Format.Evaluation
  ( -- * Counts
    Evaluation (..),
    Conditions (..),
    encodeEvaluation,

    -- * Shards
    EvaluationShard (..),
    isInPart,
    partSize,
    beginning,
    pressLine,
    ending,

    -- * Files of shards
    Contents (..),
    headingOf,
    contentsOf,
    EvaluationFileError (..),

    -- * Merging
    differing,
    merged,
    MergeError (..),
  )
where

import Control.Monad (unless)
import Data.Aeson (Series, Value, (.=))
import qualified Data.Aeson as Json
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Bifunctor (first)
import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (for_, toList)
import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.Map.Strict as Map
import Data.String (fromString)
import PraTactile.Evaluate
import PraTactile.Explore (Turns (..), halfTurns)
import PraTactile.Format.Digest (digestOf)
import PraTactile.Format.Error
import PraTactile.Format.Json
import PraTactile.Format.Json.Codec
import PraTactile.Format.Profile
import PraTactile.Format.Sensor (bendCodec)
import PraTactile.Format.Shards
import PraTactile.Profile (Profile)
import PraTactile.Sensor (Bend)

-- | The settings of an evaluation.
data Evaluation = Evaluation
  { evaluationProfile :: Profile,
    -- | the number of presses in all shards together
    evaluationPresses :: Int,
    evaluationSeed :: Int,
    -- | the standard deviation of the robot's position error, in taxels
    evaluationPositionError :: Double,
    -- | the standard deviation of the sensor's noise, as a share of full scale
    evaluationNoise :: Double,
    -- | the options that differ from their defaults
    evaluationConditions :: Conditions
  }
  deriving stock (Eq, Show)

-- | Options of the presses. Each is 'Nothing' or false if it has its default; 'conditionTurns' is
-- then @'AmongTurns' 'halfTurns'@.
data Conditions = Conditions
  { -- | the preset's name or the file that describes the sensor
    conditionSensor :: Maybe String,
    -- | the standard deviation of the error of a frame's rotation, in degrees
    conditionRotationError :: Maybe Double,
    -- | the standard deviation of each of the sensor's two tilts, in degrees
    conditionTilt :: Maybe Double,
    conditionTurns :: Turns,
    conditionBend :: Maybe Bend,
    -- | the share of presses on foreign surfaces
    conditionForeign :: Maybe Double,
    -- | the share, of all presses, on arrays by other polynomials
    conditionForeignArrays :: Maybe Double,
    -- | whether the robot's position error was not given to the decoders, so that they had to
    -- estimate it
    conditionUntold :: Bool
  }
  deriving stock (Eq, Show)

-- | An evaluation's settings and counts as one line, without its line end.
encodeEvaluation :: Evaluation -> Counts -> ByteString
encodeEvaluation evaluation counts =
  Lazy.toStrict (encodeLine (series evaluationKeys evaluation <> countsSeries counts))

evaluationKeys :: Keys Evaluation Evaluation
evaluationKeys =
  schemaKey "pra-tactile/evaluate/1"
    *> ( Evaluation
           <$> key "profile" profileCodec evaluationProfile
           <*> key "presses" int evaluationPresses
           <*> key "seed" int evaluationSeed
           <*> key "position_error_taxels" real evaluationPositionError
           <*> key "noise" real evaluationNoise
           <*> withKeys evaluationConditions conditionKeys
       )

conditionKeys :: Keys Conditions Conditions
conditionKeys =
  Conditions
    <$> optionalKey "sensor" text conditionSensor
    <*> optionalKey "rotation_error_deg" real conditionRotationError
    <*> optionalKey "tilt_deg" real conditionTilt
    <*> (turnsOf <$> isSo "any_angle" anyAngle <*> optionalKey "turn_deg" real turn)
    <*> optionalKey "bend" bendCodec conditionBend
    <*> optionalKey "foreign" real conditionForeign
    <*> optionalKey "foreign_arrays" real conditionForeignArrays
    <*> isSo "untold" conditionUntold
  where
    isSo name part =
      (== Just True) <$> optionalKey name bool (\r -> if part r then Just True else Nothing)
    anyAngle r = conditionTurns r == AnyAngle
    turn r = case conditionTurns r of
      TurnedBy degrees -> Just degrees
      _ -> Nothing
    turnsOf free stated
      | free = AnyAngle
      | otherwise = maybe (AmongTurns halfTurns) TurnedBy stated

countsSeries :: Counts -> Series
countsSeries counts =
  "stitching" .= tallyValue (countsStitched counts)
    <> "no_stitching" .= tallyValue (countsUnstitched counts)
    <> "pose" .= fmap poseValue (poseTally (countsPoses counts))

tallyValue :: Tally -> Value
tallyValue counts =
  Json.object
    [ "right" .= tallyRight counts,
      "wrong" .= tallyWrong counts,
      "wrong_expected" .= tallyExpected counts,
      "refused" .= sum (tallyRefused counts),
      "reasons"
        .= Json.object
          [fromString reason .= n | (reason, n) <- Map.toAscList (tallyRefused counts)]
    ]

poseValue :: PoseTally -> Value
poseValue counts =
  Json.object
    [ "median_mm" .= poseMedianFar counts,
      "median_deg" .= poseMedianTurned counts,
      "within_50" .= poseWithin50 counts,
      "within_95" .= poseWithin95 counts
    ]

-- | A shard of an evaluation: number I of N shards, counted from 1. It has the presses I, I + N, I
-- + 2 N, ...
data EvaluationShard = EvaluationShard
  { -- | I
    partNumber :: Int,
    -- | N
    partOf :: Int,
    -- | a digest of everything else that determines the results; equal for all shards of one
    -- evaluation
    partSetting :: String
  }
  deriving stock (Eq, Show)

-- | Whether a shard has the press with this number, counted from 1.
isInPart :: EvaluationShard -> Int -> Bool
isInPart part number = (number - partNumber part) `mod` partOf part == 0

-- | The number of presses of a shard.
partSize :: Evaluation -> EvaluationShard -> Int
partSize evaluation part =
  (evaluationPresses evaluation - partNumber part) `div` partOf part + 1

partKeys :: Keys EvaluationShard EvaluationShard
partKeys =
  (\(number, count) -> EvaluationShard number count)
    <$> key "shard" (satisfying valid NotShard (pairOf int)) (\it -> (partNumber it, partOf it))
    <*> key "setting" text partSetting
  where
    valid (number, count) = 1 <= number && number <= count

pressKeys :: Keys PressResult PressResult
pressKeys =
  PressResult
    <$> key "press" int pressNumber
    <*> ( TrialResult
            <$> key "stitching" outcome (withStitching . pressResult)
            <*> key "no_stitching" outcome (withoutStitching . pressResult)
        )
    <*> optionalKey "pose" (object poseKeys) pressPose
  where
    poseKeys =
      PoseError
        <$> key "mm" real poseErrorFar
        <*> key "deg" real poseErrorTurned
        <*> key "distance" real poseErrorDistance

-- | The outcome of a press, an object with one key: @right@ or @wrong@ with the answer's doubt, or
-- @refused@ with the reason.
outcome :: Codec Result
outcome = via parts one (object keys)
  where
    keys =
      (,,)
        <$> optionalKey "right" real (\(right, _, _) -> right)
        <*> optionalKey "wrong" real (\(_, wrong, _) -> wrong)
        <*> optionalKey "refused" text (\(_, _, reason) -> reason)
    parts result = case result of
      Correct doubt -> (Just doubt, Nothing, Nothing)
      Mistaken doubt -> (Nothing, Just doubt, Nothing)
      NoAnswer reason -> (Nothing, Nothing, Just reason)
    one given = case given of
      (Just doubt, Nothing, Nothing) -> Right (Correct doubt)
      (Nothing, Just doubt, Nothing) -> Right (Mistaken doubt)
      (Nothing, Nothing, Just reason) -> Right (NoAnswer reason)
      _ -> refuse NotOutcome

-- | The first line of a shard's file.
beginning :: Evaluation -> EvaluationShard -> ByteString
beginning evaluation part = Bytes.take (Bytes.length keys - 1) keys <> opened <> "\n"
  where
    keys = Lazy.toStrict (encodeLine (series evaluationKeys evaluation <> series partKeys part))

-- | The end of the first line, after the shard's own keys.
opened :: ByteString
opened = ",\"results\":["

-- | The line of a press in a shard's file. Applied to the evaluation and the shard alone, it
-- computes their digest once.
pressLine :: Evaluation -> EvaluationShard -> PressResult -> ByteString
pressLine evaluation part =
  let keys = checkedKeys (digestOf (beginning evaluation part))
   in \press ->
        (if pressNumber press == partNumber part then "" else ",")
          <> writeLine keys press
          <> "\n"

-- | The keys of a press and its 'checkOf'. The argument is the digest of the first line.
checkedKeys :: String -> Keys PressResult (PressResult, String)
checkedKeys header = (,) <$> pressKeys <*> key "check" text (checkOf header)

-- | The check of a press: the first 16 digits of the SHA-256 of the first line's digest and the
-- press. No press of another evaluation or shard has the same.
checkOf :: String -> PressResult -> String
checkOf header press = take 16 (digestOf (Bytes.pack header <> writeLine pressKeys press))

-- | The last line of a shard's file.
ending :: Counts -> ByteString
ending counts = "]," <> Bytes.drop 1 (Lazy.toStrict (encodeLine (countsSeries counts))) <> "\n"

-- | The contents of a shard's file.
data Contents = Contents
  { contentsEvaluation :: Evaluation,
    contentsPart :: EvaluationShard,
    -- | the presses whose lines are complete, in order from the shard's first press
    contentsPresses :: [PressResult],
    -- | whether all presses and the last line are there
    contentsFinished :: Bool,
    -- | the length of the file up to the end of the last press's line, in bytes
    contentsKept :: Int
  }
  deriving stock (Eq, Show)

-- | Why a file is not a shard's. A line is named by its number, from 1.
data EvaluationFileError
  = -- | The first line is not that of a shard.
    NoShard FormatError
  | -- | This line is not a press.
    DamagedPress Int FormatError
  | -- | The check on this line does not match the press.
    CheckOfPress Int
  | -- | The press on this line is not the expected one.
    OtherPress Int
  | -- | This line, the last one, does not match the presses.
    OtherEnding Int
  deriving stock (Eq, Show)

-- | Reads the file of a shard, finished or cut off anywhere after its first line. A press whose
-- line is cut off is ignored. If the last line is there, it must match the presses.
contentsOf :: ByteString -> Either EvaluationFileError Contents
contentsOf bytes = do
  (evaluation, part) <- headingOf bytes
  let header = digestOf (firstLine <> "\n")
      numbers = [partNumber part, partNumber part + partOf part .. evaluationPresses evaluation]
  (presses, finished, kept) <-
    go header 2 (Bytes.length firstLine + 1) [] numbers (Bytes.drop 1 others)
  pure (Contents evaluation part presses finished kept)
  where
    (firstLine, others) = Bytes.break (== '\n') bytes
    go header line kept found numbers text'
      | Bytes.null more = Right (reverse found, False, kept)
      | otherwise = case numbers of
        [] | text' == ending (countPresses (reverse found)) -> Right (reverse found, True, kept)
        [] -> Left (OtherEnding line)
        number : numbers' -> do
          (press, check) <- first (DamagedPress line) (pressOn header line one)
          unless (check == checkOf header press) (Left (CheckOfPress line))
          unless (pressNumber press == number) (Left (OtherPress line))
          go header (line + 1) (kept + Bytes.length one + 1) (press : found) numbers' rest
      where
        (one, more) = Bytes.break (== '\n') text'
        rest = Bytes.drop 1 more
    pressOn header line one
      | line == (2 :: Int) = decodeWith (checkedKeys header) one
      | otherwise =
        maybe
          (Left (JsonRefused NotJson))
          (decodeWith (checkedKeys header))
          (Bytes.stripPrefix "," one)

-- | The evaluation and the shard of a file, from its first line. Refuses another first line
-- ('NoShard').
headingOf :: ByteString -> Either EvaluationFileError (Evaluation, EvaluationShard)
headingOf bytes = case Bytes.stripSuffix opened (Bytes.takeWhile (/= '\n') bytes) of
  Nothing -> Left (NoShard (Misfit [] NotListed))
  Just keys -> first NoShard (decodeWith headingKeys (keys <> "}"))
  where
    headingKeys = (,) <$> withKeys fst evaluationKeys <*> withKeys snd partKeys

-- | Why shards cannot be merged.
data MergeError
  = -- | These two files belong to different evaluations; their first lines differ in these keys.
    DifferentEvaluations FilePath FilePath [String]
  | -- | This file is cut off.
    Unfinished FilePath
  | -- | A press of the evaluation is missing or repeated.
    PressesApart PartsError
  deriving stock (Eq, Show)

-- | The evaluation of some shards and the counts of all its presses, equal to those of a single
-- run. Each shard comes with the name of its file. Refuses shards of different evaluations,
-- unfinished ones, and missing or repeated presses.
merged :: NonEmpty (FilePath, Contents) -> Either MergeError (Evaluation, Counts)
merged shards@((file, one) :| _) = do
  for_ shards $ \(file', other) ->
    case filter (/= "shard") (differing (heading one) (heading other)) of
      [] -> Right ()
      keys -> Left (DifferentEvaluations file file' keys)
  for_ shards $ \(file', other) -> unless (contentsFinished other) (Left (Unfinished file'))
  presses <-
    first PressesApart . together 1 (fromIntegral (evaluationPresses evaluation)) $
      [ (file', fromIntegral (pressNumber press), press)
        | (file', other) <- toList shards,
          press <- contentsPresses other
      ]
  pure (evaluation, countPresses presses)
  where
    evaluation = contentsEvaluation one
    heading it = (contentsEvaluation it, contentsPart it)

-- | The keys in which the first lines of two shards' files differ.
differing :: (Evaluation, EvaluationShard) -> (Evaluation, EvaluationShard) -> [String]
differing one other =
  [ Key.toString name
    | name <- KeyMap.keys (KeyMap.union (keysOf one) (keysOf other)),
      KeyMap.lookup name (keysOf one) /= KeyMap.lookup name (keysOf other)
  ]
  where
    keysOf (evaluation, part) =
      KeyMap.union (writeObject evaluationKeys evaluation) (writeObject partKeys part)
