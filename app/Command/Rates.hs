-- | @pra-tactile rates@: how often damaged patches are located right, wrong, or refused.
module Command.Rates
  ( command,
  )
where

import ArrayChoice
import Control.Monad (foldM, unless, when)
import Control.Parallel.Strategies (parBuffer, rseq, withStrategy)
import Counted (numberText)
import qualified Data.ByteString.Char8 as Bytes
import Data.Foldable (for_)
import Data.Maybe (fromMaybe, isJust)
import Data.Traversable (for)
import ExitStatus
import Message
import Options
import Output
import PraTactile.Array
import PraTactile.Field (KnownField, fieldOrder)
import PraTactile.Format.Rates
import PraTactile.Locate
import PraTactile.Profile
import PraTactile.Rates
import PraTactile.Window
import Progress
import RatesPlot
import RatesTable
import SvgFile
import System.IO (hFlush, stdout)

data Format = Text | Csv | Json
  deriving stock (Eq)

data Options = Options
  { sizes :: [Shape],
    -- | per cent
    errors :: [Double],
    -- | per cent
    erasures :: [Double],
    radius :: Radius,
    trials :: Int,
    seed :: Int,
    -- | 'Nothing': as text
    format :: Maybe Format,
    plot :: Maybe FilePath
  }

command :: Subcommand
command =
  subcommand
    "rates"
    "Measure how often damaged patches are located right"
    "Simulate damaged patches, and count how many are located right, located wrong or refused. \
    \Each patch is decoded twice: from its symbols, up to a radius (hard), and from probabilities \
    \(soft). The exact rates, from the weight enumerator, stand beside the counts."
    [arrayGroup]
    [ "pra-tactile rates --trials 200",
      "pra-tactile rates --patch 4x4 --errors 2 --erasures 15 --trials 20000",
      "pra-tactile rates --patch 4x4 --errors 20 --radius 6",
      "pra-tactile rates --trials 200 --picture rates.svg"
    ]
    (run <$> optionsParser <*> arrayChoice)

optionsParser :: Parser Options
optionsParser =
  Options
    <$> several
      [Shape n n | n <- [2 .. 5]]
      ( orAlias "size" shapeReader mempty $
          valued
            shapeReader
            "patch"
            "ROWSxCOLUMNS"
            "The shape of the patches; may be repeated (default: 2x2, 3x3, 4x4 and 5x5)"
      )
    <*> percent
      [0.6, 2, 5, 10]
      "errors"
      "Share of the observed symbols that are wrong; may be repeated (default: 0.6, 2, 5 and 10)"
    <*> percent
      [0, 15]
      "erasures"
      "Share of the cells that are not observed; may be repeated (default: 0 and 15)"
    <*> radiusOption
      "Correct up to N wrong cells in hard decoding (default: as many as the observed cells \
      \guarantee)"
    <*> defaulting 10000 intReader "trials" "N" "Trials for each line of the table"
    <*> seedOption (value 1 <> showDefault)
    <*> optional
      ( choosing
          "form"
          [("text", Text), ("csv", Csv), ("json", Json)]
          "format"
          "text|csv|json"
          "The form of the table (default: text)"
          mempty
      )
    <*> pictureOption
      ["plot"]
      "Draw the table as well, as SVG; - is the standard output, in place of the table"
  where
    several standard one = some one <|> pure standard
    percent standard name text = several standard (valued decimalReader name "PERCENT" text)

run :: Options -> ArrayChoice -> IO ExitStatus
run options choice
  | trials options < 1 = misused "--trials must be a number, 1 or more"
  | any (\s -> not (s >= 0 && s < 100)) (erasures options) =
    misused "--erasures must be a share from 0 to below 100 per cent"
  | otherwise = do
    when (plot options == Just standardOutput) $
      leaveOut
        "--picture - prints the picture in place of the table"
        [("--format", isJust (format options))]
    for_ (plot options) orNotSvg
    profile <- chosenProfile choice
    let on array mask =
          table profile options (locator Nothing (profilePacking profile) (naturally array) mask)
    either (unusable . profileMessage) id (withProfile profile on)

-- | A line of the table to be made: its trials, the size of its patches, its exact rates by the
-- damage, and its shares of wrong and missing cells in per cent.
data Setting k = Setting
  { settingTrials :: TrialSetup k,
    settingSize :: Shape,
    settingExact :: Damage -> Maybe Rates,
    settingErrors :: Double,
    settingErasures :: Double
  }

type role Setting nominal

-- | Check what depends on the array, print the lines as they are made, and draw them.
table :: KnownField k => Profile -> Options -> Locator k -> IO ExitStatus
table profile options theLocator = do
  settings <- settingsOf options theLocator
  for_ (plot options) orUnwritable
  let total = toInteger (length settings) * perLine
      say = unless drawnOnly . putStr
  say (opening options)
  -- Large patches take longer than small ones.
  made <- withProgress (unevenly total "trials") $ \bar ->
    for (zip [0 ..] settings) $ \(i, setting) -> do
      l <- line options setting (\n -> tell bar (i * perLine + toInteger n))
      aside bar (say (lineAs (tableForm options) l) >> hFlush stdout)
      pure l
  case tableForm options of
    Text -> say (checksHeading ++ unlines (map checksText made) ++ checksOfAll made)
    Csv -> pure ()
    Json -> unless drawnOnly (Bytes.putStrLn (encodeRates (report made)))
  for_ (plot options) $ \file -> writeWhole file (ratesSvg (seed options) made)
  pure Answered
  where
    drawnOnly = plot options == Just standardOutput
    perLine = toInteger (trials options)
    report made =
      RatesReport
        { ratesProfile = profile,
          ratesTrials = trials options,
          ratesSeed = seed options,
          ratesRadius = radius options,
          ratesLines = made
        }

-- | The form of the table.
tableForm :: Options -> Format
tableForm = fromMaybe Text . format

-- | What is printed before the lines.
opening :: Options -> String
opening options = case tableForm options of
  Text -> heading (radius options)
  Csv -> csvHeading ++ "\n"
  Json -> ""

-- | A line as it is printed once it is made.
lineAs :: Format -> Line -> String
lineAs how l = case how of
  Text -> lineText l ++ "\n"
  Csv -> lineCsv l ++ "\n"
  Json -> ""

-- | All lines, size by size.
settingsOf :: KnownField k => Options -> Locator k -> IO [Setting k]
settingsOf options theLocator = do
  unless (all (\p -> p >= 0 && p < chance) (errors options)) (misused tooWrong)
  concat <$> for (sizes options) withSize
  where
    withSize size = do
      mask <- orUnusable windowMessage (rectangle size)
      setup <- orUnusable setupMessage (trialSetup (locatorArray theLocator) size)
      let exact = exactRates (radius options) theLocator mask
      pure [Setting setup size exact p s | s <- erasures options, p <- errors options]
    -- The share of wrong symbols among guessed ones; noise alone cannot do worse.
    chance = 100 * (1 - 1 / fromIntegral (fieldOrder (arrayItself (locatorArray theLocator))))
    tooWrong =
      "--errors must be a share from 0 to below "
        ++ numberText chance
        ++ " per cent, the share for guessed symbols"

-- | Simulate a line, given an action that is told the number of trials done.
line :: KnownField k => Options -> Setting k -> (Int -> IO ()) -> IO Line
line options setting tick = do
  counts <- foldM add noTrials (withStrategy (parBuffer 8 rseq) simulated)
  let hard = hardRates counts
      exact = settingExact setting damage
      share = maybe (rateWrong hard) rateWrong exact
  pure
    Line
      { lineSize = settingSize setting,
        lineErrors = settingErrors setting,
        lineErasures = settingErasures setting,
        lineTrials = trials options,
        lineHard = hard,
        lineExact = exact,
        lineSoft = softRates tolerated counts,
        lineAsHard = if share > 0 then Just (softRatesAtMost share counts) else Nothing,
        lineCalibration = calibration tolerated counts
      }
  where
    simulated =
      simulations
        (radius options)
        (settingTrials setting)
        damage
        (trials options)
        (Seed (seed options))
    damage = Damage (settingErrors setting / 100) (settingErasures setting / 100)
    tolerated = 0.001
    add counts part = do
      let counts' = merge [counts, part]
      counts' `seq` tick (tallyTrials counts')
      pure counts'
