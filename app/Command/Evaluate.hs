{-# LANGUAGE OverloadedStrings #-}

-- | @pra-tactile evaluate@: simulated presses by the thousand, counted right, wrong and refused; in
-- one run, or in shards whose files can be continued.
module Command.Evaluate
  ( command,
  )
where

import ArrayChoice
import Command.Decode
  ( ToleranceChoice (..),
    toleranceComplaint,
    toleranceGroup,
    toleranceOptions,
  )
import Control.Monad (foldM, void, when)
import Control.Parallel.Strategies (parBuffer, rseq, withStrategy)
import Data.Aeson ((.=))
import Data.Bifunctor (first)
import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Bytes
import Data.Foldable (toList)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Data.Version (showVersion)
import ExitStatus
import Files (alreadyIn)
import Json (sayWrittenAs)
import Message
import Message.Evaluation
import Numeric.Natural (Natural)
import Options
import Output
import Paths_pra_tactile (version)
import PlacementChoice
import PraTactile.Array (ArrayOn (..), PseudorandomArray, arrayPrimitive)
import PraTactile.Classification.Reader (Reader (..))
import PraTactile.Evaluate
import PraTactile.Explore
import PraTactile.Field (KnownField)
import PraTactile.Format (encodePlacement)
import PraTactile.Format.Digest (digestOf)
import PraTactile.Format.Evaluation
import PraTactile.Format.Network
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge
import PraTactile.Polynomial (primitiveDegree)
import PraTactile.Profile
import PraTactile.Recognise
import PraTactile.Relief (symbolScale)
import PraTactile.Sensor (Bend, Sensor (..))
import PraTactile.Symmetry (rotations)
import PraTactile.Window (maskFrom)
import PraTactile.Window.Proof (windowRank)
import Progress
import SensorChoice
import Setup
import System.IO (Handle, hFlush, stdout)
import Text.Printf (printf)
import Visible (visible, visibleName)

data Options = Options
  { presses :: Int,
    seed :: Int,
    size :: Maybe (Int, Int),
    sensor :: SensorChoice,
    turns :: Turns,
    bend :: Maybe Bend,
    foreignPresses :: Maybe Double,
    foreignArrayPresses :: Maybe Double,
    untold :: Bool,
    tolerance :: ToleranceChoice,
    symbolReader :: ReaderChoice,
    objects :: PlacementChoice,
    shard :: Maybe (Natural, Natural),
    output :: Maybe FilePath,
    form :: AnswerForm
  }

command :: Subcommand
command =
  subcommand
    "evaluate"
    "Count right and wrong answers over simulated presses"
    "Press the simulated sensor at random places, on the faces in turn, and decode each press with \
    \stitching and without. Count how many answers are right, wrong or refused."
    [sensorGroup, objectsGroup, toleranceGroup, arrayGroup]
    [ "pra-tactile evaluate --presses 12 --seed 1",
      "pra-tactile evaluate --presses 12 --seed 1 --noise 0.3 --doubt 0.0001",
      "pra-tactile evaluate --presses 12 --seed 1 --sensor real",
      "pra-tactile evaluate --presses 12 --seed 1 --sensor real --tilt 5",
      "pra-tactile evaluate --presses 12 --seed 1 --foreign-presses 0.5",
      "pra-tactile evaluate --presses 12 --seed 1 --foreign-arrays 0.5",
      "pra-tactile evaluate --presses 12 --seed 1 --position-error 2 --any-angle --untold",
      "pra-tactile evaluate --presses 12 --seed 1 --bend 100 --bend-axis x",
      "pra-tactile evaluate --presses 12 --seed 1 --sheet",
      "pra-tactile evaluate --presses 12 --seed 1 --shard 1/3 --output part1.json"
    ]
    (run <$> options <*> arrayChoice)
  where
    options =
      Options
        <$> defaulting 1000 intReader "presses" "N" "Number of presses; each explores a region"
        <*> seedOption (value 1 <> showDefault)
        <*> sizeOption
        <*> sensorOptions
        <*> turnsOption
        <*> bendOption
        <*> optional
          ( orAlias "foreign" decimalReader mempty $
              valued
                decimalReader
                "foreign-presses"
                "SHARE"
                "Share of the presses on random arrangements of the shapes, where every answer is \
                \wrong (default: 0, or that of --foreign-arrays)"
          )
        <*> optional
          ( valued
              decimalReader
              "foreign-arrays"
              "SHARE"
              "Share of the presses on arrays by other polynomials; it is a part of \
              \--foreign-presses (default: 0)"
          )
        <*> switch
          ( long "untold"
              <> help
                "Do not tell the decoder the position error; the decoder estimates it"
          )
        <*> toleranceOptions (pure (foreignPrior standardTolerance))
        <*> readerChoice
        <*> plateOr (placementChoice "Take them from a database that 'objects --write' made")
        <*> shardOption
        <*> optionalFile
          "output"
          "FILE"
          "Write each press to this file, which 'merge' counts; running the command again \
          \continues an unfinished file"
        <*> jsonSwitch "Print the counts as JSON; for a shard also each press, for 'merge'"

-- | The options for how the faces lie turned.
turnsOption :: Parser Turns
turnsOption =
  flag'
    (AmongTurns rotations)
    ( long "quarter-turns"
        <> help "The faces lie turned by 0, 90, 180 or 270 degrees (default: by 0 or 180)"
    )
    <|> flag' AnyAngle (long "any-angle" <> help "The faces lie turned by any angle")
    <|> (TurnedBy <$> angleOption "The faces lie turned clockwise by this angle")
    <|> pure (AmongTurns halfTurns)

-- | The share of all foreign presses: that of @--foreign-arrays@ if no other is given.
allForeign :: Options -> Maybe Double
allForeign options = foreignPresses options <|> foreignArrayPresses options

run :: Options -> ArrayChoice -> IO ExitStatus
run options choice
  | presses options < 1 = misused "--presses must be a number, 1 or more"
  | Just complaint <- toleranceComplaint (tolerance options) = misused complaint
  | not (all (\share -> share >= 0 && share <= 1) (foreignPresses options)) =
    misused "--foreign-presses must be a share from 0 to 1"
  | not (all (>= 0) arrays && all (<= fromMaybe 1 (foreignPresses options)) arrays) =
    misused "--foreign-arrays must be a share from 0 to that of --foreign-presses"
  | any ((> 1000000000) . snd) (shard options) =
    misused "--shard I/K must have at most a billion parts"
  | otherwise = do
    real <- chosenSensor (sensor options)
    let feltAs scale = feltBySymbols scale real
        regionOf = chosenSize (size options)
        reach pitch = restingOn (regionOf (feltAs (fromMaybe 1 (symbolScale pitch))))
    (profile, laid) <-
      chosenFirst choice (objects options) (presses options) reach
    (scale, layout) <- feltPlacement laid
    let simulated = feltAs scale
        region = regionOf simulated
        pressed = take (presses options) (laidFaces layout)
    symbols <- readerFor (symbolReader options) profile
    unread <- orUnusable profileMessage (withProfile profile (\array _ -> unreadable array pressed))
    mapM_ warn (unreadWarning profile unread pressed)
    when (not (null unread) && length unread == length pressed) (leave NotAnswered)
    let experiment =
          Experiment
            { experimentPresses = presses options,
              experimentSeed = seed options,
              experimentExploration =
                (exploration simulated (turns options) region)
                  { explorationSpacing = chosenSpacing (sensor options) simulated,
                    explorationBend = bendBySymbols scale <$> bend options
                  },
              experimentForeign = allForeign options,
              experimentForeignArrays = fromMaybe 0 arrays,
              experimentTold = not (untold options),
              experimentTolerance = tolerated (tolerance options)
            }
        larger = fromRational scale
        made array mask = do
          reader <-
            first
              recogniserMessage
              (recogniser (ArrayOn (profileSurface profile) array) mask layout symbols)
          first (experimentMessage larger) (evaluatedPoses experiment array reader)
        inMillimetres pose = pose {poseErrorFar = larger * poseErrorFar pose}
        evaluation = evaluationOf profile options simulated
        how = experimentExploration experiment
        part =
          EvaluationShard
            { partNumber = maybe 1 (fromIntegral . fst) (shard options),
              partOf = maybe 1 (fromIntegral . snd) (shard options),
              partSetting =
                digestOf . Bytes.unlines $
                  [ Bytes.pack (showVersion version),
                    encodePlacement profile layout,
                    encodeNetwork (fileOf symbols),
                    Bytes.pack . show $
                      ( (simulated, explorationSpacing how, region, turns options, bend options),
                        (allForeign options, arrays, untold options, tolerated (tolerance options))
                      )
                  ]
            }
    results <- orUnusable profileMessage (withProfile profile made) >>= orUnusable id
    let pressesOf kept =
          [ PressResult
              number
              outcome
              (if kept == WithPoses then inMillimetres <$> pose else Nothing)
            | (number, (outcome, pose)) <- zip [1 ..] results,
              isInPart part number
          ]
    delivered options region evaluation part pressesOf
    pure Answered
  where
    arrays = foreignArrayPresses options
    fileOf (Reader alphabet _ _ network sure) =
      NetworkFile network (alphabetDigest alphabet) sure Nothing Nothing

-- | Whether the error of a press's pose is kept.
data Kept = WithPoses | CountsAlone
  deriving stock (Eq)

-- | Print or write the results of the presses of a shard.
delivered ::
  Options ->
  (Int, Int) ->
  Evaluation ->
  EvaluationShard ->
  (Kept -> [PressResult]) ->
  IO ()
delivered options region evaluation part pressesOf = case (output options, shard options) of
  (Just file, _) -> do
    bytes <- alreadyIn file
    (kept, before, finished) <- continued file bytes evaluation part
    counts <-
      if finished
        then pure (countPresses before)
        else
          writtenAfter file (Bytes.length bytes, kept) $
            document evaluation part (kept, before) (drop (length before) (pressesOf WithPoses))
    sayWrittenAs asked file (": " ++ pressesText evaluation part) "evaluate-written/1" $
      "presses" .= partSize evaluation part
    standard <- leadsToStandardOutput file
    when (asked == AsText && not standard) (putStr (told counts))
  (Nothing, Just _)
    | asked == AsJson ->
      void (document evaluation part (0, []) (pressesOf WithPoses) stdout)
  _ -> do
    counts <-
      pressesCounted evaluation part [] (const (pure ())) $
        pressesOf (if asked == AsJson then WithPoses else CountsAlone)
    printAs asked (told counts) (encodeEvaluation evaluation counts)
  where
    asked = form options
    told = countsText options region evaluation part

-- | The contents of an unfinished file: its length up to the last whole press, the presses, and
-- whether they are complete. Any other file is left alone, with status 2.
continued ::
  FilePath ->
  ByteString ->
  Evaluation ->
  EvaluationShard ->
  IO (Int, [PressResult], Bool)
continued file bytes evaluation part
  | bytes `Bytes.isPrefixOf` begins = pure (0, [], False)
  | begins `Bytes.isPrefixOf` bytes = do
    it <- orUnusable (evaluationFileMessage file) (contentsOf bytes)
    pure (contentsKept it, contentsPresses it, contentsFinished it)
  | otherwise =
    unusable . otherEvaluationMessage file $
      either (const []) (differing (evaluation, part)) (headingOf bytes)
  where
    begins = beginning evaluation part

-- | Write the presses that a shard's file lacks, each at once and whole, after the bytes and
-- presses that it has; the counts of all presses.
document ::
  Evaluation ->
  EvaluationShard ->
  (Int, [PressResult]) ->
  [PressResult] ->
  Handle ->
  IO Counts
document evaluation part (kept, before) others handle = do
  when (kept == 0) (put (beginning evaluation part))
  counts <- pressesCounted evaluation part before (put . line) others
  put (ending counts)
  pure counts
  where
    line = pressLine evaluation part
    put bytes = Bytes.hPutStr handle bytes >> hFlush handle

-- | The counts of all presses, including those made before. The others are made on all cores as
-- they are needed. Each is given to the action, counted and dropped from memory. Shows progress on
-- a terminal.
pressesCounted ::
  Evaluation ->
  EvaluationShard ->
  [PressResult] ->
  (PressResult -> IO ()) ->
  [PressResult] ->
  IO Counts
pressesCounted evaluation part before put others =
  withProgress (doneBefore done (evenly (partSize evaluation part) "presses")) $ \bar ->
    foldM
      (include bar)
      (countPresses before)
      (zip [done + 1 ..] (withStrategy (parBuffer 32 rseq) others))
  where
    done = toInteger (length before)
    include bar counts (i, press) = do
      put press
      let counts' = countingPress counts press
      counts' `seq` tell bar i
      pure counts'

-- | Faces whose position on the array cannot be found even from all their symbols.
unreadable :: KnownField k => PseudorandomArray k -> [LaidFace] -> [LaidFace]
unreadable array = filter (either (const False) tooFew . maskFrom . blockCells . laidBlock)
  where
    tooFew mask = windowRank array mask < degreeOf array
    degreeOf = fromIntegral . primitiveDegree . arrayPrimitive

-- | The warning about unreadable faces among the pressed ones.
unreadWarning :: Profile -> [LaidFace] -> [LaidFace] -> Maybe String
unreadWarning profile unread pressed = case unread of
  [] -> Nothing
  one : _ ->
    Just $
      "warning: of " ++ show (length pressed) ++ " faces that are pressed "
        ++ show (length unread)
        ++ " cannot be read, such as "
        ++ visible (faceText (faceName (laidFace one)))
        ++ " of the "
        ++ visible (objectText (faceObject (laidFace one)))
        ++ ": too few symbols, of rank below "
        ++ show (length (profilePolynomial profile) - 1)

evaluationOf :: Profile -> Options -> Sensor -> Evaluation
evaluationOf profile options simulated =
  Evaluation
    { evaluationProfile = profile,
      evaluationPresses = presses options,
      evaluationSeed = seed options,
      evaluationPositionError = sensorPositionError simulated,
      evaluationNoise = sensorNoise simulated,
      evaluationConditions =
        Conditions
          { conditionSensor = sensorNamed (sensor options),
            conditionRotationError = rotationSigma (sensor options),
            conditionTilt = tiltSigma (sensor options),
            conditionTurns = turns options,
            conditionBend = bend options,
            conditionForeign = allForeign options,
            conditionForeignArrays = foreignArrayPresses options,
            conditionUntold = untold options
          }
    }

-- | The number of presses, and how many of them a shard has.
pressesText :: Evaluation -> EvaluationShard -> String
pressesText evaluation part
  | partOf part == 1 = count ++ " presses"
  | otherwise = show (partSize evaluation part) ++ " of " ++ count ++ " presses"
  where
    count = show (evaluationPresses evaluation)

countsText :: Options -> (Int, Int) -> Evaluation -> EvaluationShard -> Counts -> String
countsText options region evaluation part counts =
  unlines
    [ headingText options region evaluation part,
      tallyText "stitching" (countsStitched counts),
      tallyText "no-stitching" (countsUnstitched counts)
    ]

headingText :: Options -> (Int, Int) -> Evaluation -> EvaluationShard -> String
headingText options region evaluation part =
  printf
    "%s, seed %d, regions of %d x %d taxels, position error sigma %g taxels, noise sd %g \
    \of full scale%s"
    (pressesText evaluation part)
    (evaluationSeed evaluation)
    (fst region)
    (snd region)
    (evaluationPositionError evaluation)
    (evaluationNoise evaluation)
    (concatMap (", " ++) (named ++ turned ++ map bendText (toList (bend options)) ++ others))
  where
    named = ["sensor " ++ visibleName name | Just name <- [sensorNamed (sensor options)]]
    turned = case turns options of
      AnyAngle -> ["at any angle"]
      TurnedBy degrees -> [printf "turned by %g degrees" degrees]
      AmongTurns _ -> []
    others =
      [ printf "share of foreign presses %g" share
        | Just share <- [allForeign options]
      ]
        ++ [printf "on other arrays %g" share | Just share <- [foreignArrayPresses options]]
        ++ [ printf "tilted by sigma %g degrees" degrees
             | Just degrees <- [tiltSigma (sensor options)]
           ]
        ++ ["position error untold" | untold options]

tallyText :: String -> Tally -> String
tallyText name counts =
  printf
    "%-13s right %d  wrong %d (expected: %.2g)  refused %d (%.1f %%)%s"
    name
    (tallyRight counts)
    (tallyWrong counts)
    (tallyExpected counts)
    refused
    share
    ( concat
        [ printf "%s %s %d" (if i == 0 then ":" else "," :: String) reason n
          | (i, (reason, n)) <- zip [0 :: Int ..] (Map.toAscList (tallyRefused counts))
        ] ::
        String
    )
  where
    refused = sum (tallyRefused counts)
    share =
      100
        * fromIntegral refused
        / fromIntegral (max 1 (refused + tallyRight counts + tallyWrong counts)) ::
        Double
