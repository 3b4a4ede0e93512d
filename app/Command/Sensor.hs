-- | @pra-tactile sensor@: every constant of the simulated sensor, with its source.
module Command.Sensor
  ( command,
  )
where

import Data.List (dropWhileEnd, find)
import ExitStatus
import Options
import PraTactile.Format (encodeSensor)
import PraTactile.Sensor (Preset (..), presetName)
import PraTactile.Sensor.Constants
import SensorChoice (readSensor, sensorOption)
import Text.Printf (printf)

command :: Subcommand
command =
  subcommand
    "sensor"
    "Print the constants of the simulated sensor"
    "Print every constant of the simulated sensor and of the robot that carries it, with its unit \
    \and its source."
    []
    [ "pra-tactile sensor",
      "pra-tactile sensor --sensor hard",
      "pra-tactile sensor --sensor real --json > mine.json && pra-tactile probe --object cube \
      \--seed 7 --sensor mine.json --output frames"
    ]
    ( run
        <$> ( orAlias
                "preset"
                pathReader
                (completeWith (map presetName [minBound ..]))
                ( sensorOption
                    "The sensor: ideal, paper, real, hard, or a file as --json prints it (default: \
                    \paper)"
                )
                <|> pure (presetName Paper)
            )
        <*> jsonSwitch "Print the constants as JSON, which --sensor takes"
    )

run :: String -> AnswerForm -> IO ExitStatus
run name form = do
  sensor <- readSensor name
  let preset = find ((== name) . presetName) [minBound ..]
  printAs form (concatMap line (constantsOf sensor)) (encodeSensor preset sensor)
  pure Answered
  where
    number v = case break (== '.') (printf "%.6f" v :: String) of
      (digits, decimals) -> digits ++ dropWhileEnd (== '.') (dropWhileEnd (== '0') decimals)
    line (constant, v) =
      printf
        "%-21s %-10s %-5s %s\n"
        (constantName constant)
        (number v)
        (constantUnit constant)
        (constantSource constant)
