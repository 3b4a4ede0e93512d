{-# LANGUAGE OverloadedStrings #-}

-- | Tests files of evaluations' shards: written files are read again, whole or cut off; changes are
-- noticed; and shards add up to a single run.
module Test.Formats.EvaluationFile (spec) where

import Data.ByteString.Char8 (ByteString)
import qualified Data.ByteString.Char8 as Bytes
import Data.Char (isDigit)
import Data.List.NonEmpty (NonEmpty (..))
import PraTactile.Evaluate
import PraTactile.Explore (Turns (..), halfTurns)
import PraTactile.Format.Evaluation
import PraTactile.Format.Shards
import PraTactile.Profile (canonicalProfile)
import PraTactile.Sensor (Bend (..), BendAxis (..))
import Test.Hspec
import Test.QuickCheck

spec :: Spec
spec = do
  it "a file cut off anywhere has the presses whose lines are whole" $
    forAll someShard $ \shard@(evaluation, part, presses) -> do
      let file = fileOf shard
          header = Bytes.length (beginning evaluation part)
      forAll (choose (header, Bytes.length file)) $ \end -> do
        let whole = length (takeWhile (<= end) (drop 1 (scanl (+) header (lineLengths shard))))
        contentsOf (Bytes.take end file)
          === Right
            Contents
              { contentsEvaluation = evaluation,
                contentsPart = part,
                contentsPresses = take whole presses,
                contentsFinished = end == Bytes.length file,
                contentsKept = header + sum (take whole (lineLengths shard))
              }
  it "a file with another digit, or of another evaluation or shard, is refused" $
    forAll someShard $ \shard -> do
      let file = fileOf shard
          digits = [i | (i, c) <- zip [0 ..] (Bytes.unpack file), isDigit c]
      forAll ((,) <$> elements digits <*> elements ['0' .. '9']) $ \(i, digit) -> do
        let changed = Bytes.take i file <> Bytes.cons digit (Bytes.drop (i + 1) file)
            heading found = (contentsEvaluation found, contentsPart found)
        -- A last digit beyond a double's precision changes nothing.
        case (contentsOf file, contentsOf changed) of
          (Right one, Right other) -> one === other .||. heading one =/= heading other
          (Right _, Left _) -> property True
          (Left why, _) -> counterexample (show why) False

  it "shards in any order add up to a single run, to the byte; each is needed once" $
    forAll someEvaluation $ \evaluation ->
      forAll (choose (1, evaluationPresses evaluation)) $ \count ->
        forAll (pressesFor evaluation) $ \presses -> do
          let parts =
                [(show i, fileOf (partly (EvaluationShard i count "setting"))) | i <- [1 .. count]]
              partly part = (evaluation, part, filter (isInPart part . pressNumber) presses)
              others = EvaluationShard 1 count "another"
          forAll (shuffle parts) $ \shuffled -> do
            let alien = ("x", fileOf (partly others))
            conjoin
              [ mergedOf shuffled === Right (encodeEvaluation evaluation (countPresses presses)),
                case mergedOf (drop 1 shuffled) of
                  Left (PressesApart (PartsMissing _ _)) -> property True
                  Left _ | count == 1 -> property True
                  got -> counterexample (show got) False,
                case mergedOf (shuffled ++ take 1 shuffled) of
                  Left (PressesApart (PartTwice _ a b)) -> a === b
                  got -> counterexample (show got) False,
                isDifferent (mergedOf (alien : shuffled)) === True,
                mergedOf
                  [("cut", Bytes.take (Bytes.length file - 2) file) | (_, file) <- take 1 parts]
                  === Left (Unfinished "cut")
              ]
  where
    isDifferent got = case got of
      Left (DifferentEvaluations "x" _ ["setting"]) -> True
      Left (DifferentEvaluations _ "x" ["setting"]) -> True
      _ -> False
    lineLengths (evaluation, part, presses) =
      map (Bytes.length . pressLine evaluation part) presses

type Shard = (Evaluation, EvaluationShard, [PressResult])

fileOf :: Shard -> ByteString
fileOf (evaluation, part, presses) =
  beginning evaluation part
    <> Bytes.concat (map (pressLine evaluation part) presses)
    <> ending (countPresses presses)

mergedOf :: [(FilePath, ByteString)] -> Either MergeError ByteString
mergedOf files = case [(name, found) | (name, bytes) <- files, Right found <- [contentsOf bytes]] of
  one : others
    | length others + 1 == length files -> uncurry encodeEvaluation <$> merged (one :| others)
  _ -> Left (Unfinished "unreadable")

someShard :: Gen Shard
someShard = do
  evaluation <- someEvaluation
  count <- choose (1, evaluationPresses evaluation)
  part <- (\i -> EvaluationShard i count "5c0e") <$> choose (1, count)
  presses <- pressesFor evaluation
  pure (evaluation, part, filter (isInPart part . pressNumber) presses)

pressesFor :: Evaluation -> Gen [PressResult]
pressesFor evaluation = traverse press [1 .. evaluationPresses evaluation]
  where
    press number = PressResult number <$> (TrialResult <$> outcome <*> outcome) <*> pose
    outcome =
      oneof
        [ Correct <$> doubt,
          Mistaken <$> doubt,
          NoAnswer <$> elements ["ambiguous", "no-symbols", "not-stitched"]
        ]
    doubt = oneof [pure 0, choose (0, 1), (\x -> 10 ** (-300 * x)) <$> choose (0, 1)]
    pose =
      oneof
        [ pure Nothing,
          Just <$> (PoseError <$> choose (0, 9) <*> choose (0, 180) <*> choose (0, 99))
        ]

someEvaluation :: Gen Evaluation
someEvaluation =
  Evaluation canonicalProfile
    <$> choose (1, 12)
    <*> arbitrary
    <*> choose (0, 3)
    <*> choose (0, 1)
    <*> ( Conditions
            <$> perhaps (elements ["real", "a file \"of\" \955"])
            <*> perhaps (choose (0, 9))
            <*> perhaps (choose (0, 9))
            <*> oneof [pure (AmongTurns halfTurns), pure AnyAngle, TurnedBy <$> choose (-360, 360)]
            <*> perhaps (Bend <$> choose (50, 100) <*> elements [AboutX, AboutY])
            <*> perhaps (choose (0, 1))
            <*> perhaps (choose (0, 1))
            <*> arbitrary
        )
  where
    perhaps draw = oneof [pure Nothing, Just <$> draw]
