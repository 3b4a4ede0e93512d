-- | @pra-tactile evaluate@: simulated presses by the thousand, counted right, wrong and refused.
module Command.Evaluate
  ( command,
  )
where

import ArrayChoice
import Command.Decode (ToleranceChoice (..), toleranceComplaint, toleranceOptions)
import Control.Monad (foldM, when)
import Control.Parallel.Strategies (evalTuple2, parBuffer, rseq, withStrategy)
import Data.Bifunctor (first)
import Data.Foldable (toList)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import ExitStatus
import Message
import Options
import PlacementChoice
import PraTactile.Array (ArrayOn (..), PseudorandomArray, arrayPrimitive)
import PraTactile.Evaluate
import PraTactile.Explore
import PraTactile.Field (KnownField)
import PraTactile.Format.Evaluation
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
    form :: AnswerForm
  }

command :: Mod CommandFields (IO ExitStatus)
command =
  subcommand
    "evaluate"
    "Simulate presses at random places on the faces in turn, and count how many are decoded \
    \right, wrong or refused, with stitching and without."
    [ "pra-tactile evaluate --presses 12 --seed 1",
      "pra-tactile evaluate --presses 12 --seed 1 --noise 0.3 --doubt 0.0001",
      "pra-tactile evaluate --presses 12 --seed 1 --sensor real",
      "pra-tactile evaluate --presses 12 --seed 1 --sensor real --tilt 5",
      "pra-tactile evaluate --presses 12 --seed 1 --foreign 0.5",
      "pra-tactile evaluate --presses 12 --seed 1 --foreign-arrays 0.5",
      "pra-tactile evaluate --presses 12 --seed 1 --position-error 2 --any-angle --untold",
      "pra-tactile evaluate --presses 12 --seed 1 --bend 100 --bend-axis x",
      "pra-tactile evaluate --presses 12 --seed 1 --object sheet"
    ]
    (run <$> arrayChoice <*> options)
  where
    options =
      Options
        <$> defaulting 1000 intReader "presses" "N" "How many regions are explored"
        <*> seedOption (value 1 <> showDefault)
        <*> sizeOption
        <*> sensorOptions
        <*> turnsOption
        <*> bendOption
        <*> optional
          ( valued
              decimalReader
              "foreign"
              "SHARE"
              "The share of presses on what is none of ours: our shapes in an arrangement by \
              \chance, of which every answer is wrong (default: 0, or that of --foreign-arrays)"
          )
        <*> optional
          ( valued
              decimalReader
              "foreign-arrays"
              "SHARE"
              "Of all presses, the share of those on arrays by other polynomials, a part of \
              \--foreign (default: 0)"
          )
        <*> switch
          (long "untold" <> help "Do not tell the decoder the position error; it finds what it is")
        <*> toleranceOptions (pure (foreignPrior standardTolerance))
        <*> readerChoice
        <*> plateOr (placementChoice "The same from a database that 'objects --write' made")
        <*> jsonSwitch "Print the counts as JSON"

-- | How the faces lie.
turnsOption :: Parser Turns
turnsOption =
  flag'
    (AmongTurns rotations)
    ( long "quarter-turns"
        <> help "The faces lie in any of four ways (default: upright or turned by 180 degrees)"
    )
    <|> flag' AnyAngle (long "any-angle" <> help "The faces lie turned by any angle")
    <|> (TurnedBy <$> angleOption "The faces lie turned clockwise by so many degrees")
    <|> pure (AmongTurns halfTurns)

-- | The share of all foreign presses: of those on other arrays alone where no other is stated.
allForeign :: Options -> Maybe Double
allForeign options = foreignPresses options <|> foreignArrayPresses options

run :: ArrayChoice -> Options -> IO ExitStatus
run choice options
  | presses options < 1 = misused "--presses is a number from 1 up"
  | Just complaint <- toleranceComplaint (tolerance options) = misused complaint
  | not (all (\share -> share >= 0 && share <= 1) (foreignPresses options)) =
    misused "--foreign is a share from 0 to 1"
  | not (all (>= 0) arrays && all (<= fromMaybe 1 (foreignPresses options)) arrays) =
    misused "--foreign-arrays is a share from 0 to that of --foreign"
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
    results <- orUnusable profileMessage (withProfile profile made) >>= orUnusable id
    (counted, poses) <- tallied (form options == AsJson) (presses options) results
    let inMillimetres counts = counts {poseMedianFar = larger * poseMedianFar counts}
    printed profile options region simulated counted (inMillimetres <$> poseTally poses)
    pure Answered
  where
    arrays = foreignArrayPresses options

-- | Faces whose symbols, all of them together, do not tell where on the array they are.
unreadable :: KnownField k => PseudorandomArray k -> [LaidFace] -> [LaidFace]
unreadable array = filter (either (const False) tooFew . maskFrom . blockCells . laidBlock)
  where
    tooFew mask = windowRank array mask < degreeOf array
    degreeOf = fromIntegral . primitiveDegree . arrayPrimitive

-- | What is said of such faces among those that are pressed.
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

-- | The tallies with stitching and without, of results that are made on all cores as they are
-- needed; says how far it is where a person looks on. Trials are let go once counted. With them
-- come the poses' errors, if they are asked for.
tallied ::
  Bool -> Int -> [(TrialResult, Maybe PoseError)] -> IO ((Tally, Tally), [PoseError])
tallied withPoses count results =
  withProgress (evenly count "presses") $ \bar ->
    foldM
      (include bar)
      ((noResults, noResults), [])
      (zip [1 ..] (withStrategy (parBuffer 32 (evalTuple2 rseq rseq)) (map wanted results)))
  where
    wanted (outcome, pose)
      | withPoses = (outcome, (\found -> found `seq` pose) =<< pose)
      | otherwise = (outcome, Nothing)
    include bar ((stitched, unstitched), poses) (i, (outcome, pose)) =
      let stitched' = counting stitched (withStitching outcome)
          unstitched' = counting unstitched (withoutStitching outcome)
          poses' = maybe poses (: poses) pose
       in stitched'
            `seq` unstitched'
            `seq` poses'
            `seq` tell bar (i :: Integer) >> pure ((stitched', unstitched'), poses')

printed ::
  Profile -> Options -> (Int, Int) -> Sensor -> (Tally, Tally) -> Maybe PoseTally -> IO ()
printed profile options region simulated (stitched, unstitched) poses =
  printAs
    (form options)
    ( unlines
        [ headingText options region simulated,
          tallyText "stitching" stitched,
          tallyText "no-stitching" unstitched
        ]
    )
    (encodeEvaluation (report profile options simulated stitched unstitched poses))

report ::
  Profile -> Options -> Sensor -> Tally -> Tally -> Maybe PoseTally -> EvaluationReport
report profile options simulated stitched unstitched poses =
  EvaluationReport
    { evaluationProfile = profile,
      evaluationPresses = presses options,
      evaluationSeed = seed options,
      evaluationPositionError = sensorPositionError simulated,
      evaluationNoise = sensorNoise simulated,
      evaluationConditions =
        EvaluationConditions
          { conditionSensor = sensorNamed (sensor options),
            conditionRotationError = rotationSigma (sensor options),
            conditionTilt = tiltSigma (sensor options),
            conditionTurns = turns options,
            conditionBend = bend options,
            conditionForeign = allForeign options,
            conditionForeignArrays = foreignArrayPresses options,
            conditionUntold = untold options
          },
      evaluationStitched = stitched,
      evaluationUnstitched = unstitched,
      evaluationPose = poses
    }

headingText :: Options -> (Int, Int) -> Sensor -> String
headingText options region simulated =
  printf
    "%d presses, seed %d, regions of %d x %d taxels, position error sigma %g taxels, noise sd %g \
    \of full scale%s"
    (presses options)
    (seed options)
    (fst region)
    (snd region)
    (sensorPositionError simulated)
    (sensorNoise simulated)
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
tallyText name counted =
  printf
    "%-13s right %d  wrong %d (expected: %.2g)  refused %d (%.1f %%)%s"
    name
    (tallyRight counted)
    (tallyWrong counted)
    (tallyExpected counted)
    refused
    share
    ( concat
        [ printf "%s %s %d" (if i == 0 then ":" else "," :: String) reason n
          | (i, (reason, n)) <- zip [0 :: Int ..] (Map.toAscList (tallyRefused counted))
        ] ::
        String
    )
  where
    refused = sum (tallyRefused counted)
    share =
      100
        * fromIntegral refused
        / fromIntegral (max 1 (refused + tallyRight counted + tallyWrong counted)) ::
        Double
