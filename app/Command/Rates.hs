{-# LANGUAGE OverloadedStrings #-}

-- | @pra-tactile rates@: how often damaged patches are located right, wrong, or refused.
module Command.Rates
  ( command,
  )
where

import ArrayChoice
import Control.Monad (foldM, forM, forM_, unless)
import Control.Parallel.Strategies (parBuffer, rseq, withStrategy)
import Data.Aeson ((.=))
import Data.Foldable (for_)
import Described
import Ending
import Json
import Message
import Options.Applicative hiding (columns, command)
import Output
import PraTactile.Array
import PraTactile.Field (KnownField, fieldOrder)
import PraTactile.Format.Profile
import PraTactile.LinearCode.Rates
import PraTactile.Locate.Decoder.Codebook
import PraTactile.Profile
import PraTactile.Rates
import PraTactile.Window
import Progress
import RatesPlot
import RatesTable
import SvgFile
import System.IO (hFlush, hIsTerminalDevice, stdout)

data Form = Text | Csv | Json
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
    form :: Form,
    plot :: Maybe FilePath
  }

command :: Mod CommandFields (IO Ending)
command =
  described
    "rates"
    ( "Tell how often damaged patches are located right, wrong, or refused: simulated from a \
      \seed, decoded from symbols to the guaranteed "
        ++ "radius, or a stated one (hard) and from probabilities (soft), beside the exact rates \
           \of the weight enumerator."
    )
    [ "pra-tactile rates --trials 2000",
      "pra-tactile rates --size 4x4 --errors 2 --erasures 15 --trials 20000",
      "pra-tactile rates --size 4x4 --errors 20 --radius 6",
      "pra-tactile rates --trials 2000 --plot rates.svg"
    ]
    (run <$> arrayChoice <*> options)
  where
    options =
      Options
        <$> several
          [Shape n n | n <- [2 .. 5]]
          ( option
              shapeReader
              ( long "size"
                  <> metavar "ROWSxCOLUMNS"
                  <> help "A patch (default: 2x2, 3x3, 4x4 and 5x5); may be repeated"
              )
          )
        <*> several
          [0.6, 2, 5, 10]
          ( option
              decimalReader
              ( long "errors"
                  <> metavar "PERCENT"
                  <> help
                    "Wrong symbols among the observed ones (default: 0.6, 2, 5 and 10); may be \
                    \repeated"
              )
          )
        <*> several
          [0, 15]
          ( option
              decimalReader
              ( long "erasures"
                  <> metavar "PERCENT"
                  <> help "Cells that were not observed (default: 0 and 15); may be repeated"
              )
          )
        <*> radiusOption
          "Hard decoding corrects up to N wrong cells (default: as many as the observed cells \
          \guarantee)"
        <*> option
          intReader
          ( long "trials"
              <> metavar "N"
              <> value 10000
              <> showDefault
              <> help "Trials a line of the table"
          )
        <*> option
          intReader
          (long "seed" <> metavar "N" <> value 1 <> showDefault <> help "Seed of every random draw")
        <*> option
          formReader
          ( long "format"
              <> metavar "text|csv|json"
              <> completeWith ["text", "csv", "json"]
              <> value Text
              <> help "The form of the table (default text)"
          )
        <*> optional
          ( strOption
              ( long "plot"
                  <> metavar "FILE.svg"
                  <> action "file"
                  <> help
                    "Draw the table as well, into an SVG file; - is the standard output, in place \
                    \of the table"
              )
          )
    several standard one = some one <|> pure standard
    formReader = namedReader "form" [("text", Text), ("csv", Csv), ("json", Json)]

run :: ArrayChoice -> Options -> IO Ending
run choice options
  | trials options < 1 = unusable "--trials is a number from 1 up"
  | any (\s -> not (s >= 0 && s < 100)) (erasures options) =
    unusable "--erasures is a share from 0 to below 100 per cent"
  | otherwise = do
    for_ (plot options) orNotSvg
    profile <- chosenProfile choice
    let on array mask =
          either
            (unusable . locateMessage)
            (tables profile options)
            (buildCodebook (naturalSurface (arrayFolding array)) array mask)
    either (unusable . profileMessage) id (withProfile profile on)

-- | Check what depends on the array, print the lines as they are made, and draw them.
tables :: KnownField k => Profile -> Options -> Codebook k -> IO Ending
tables profile options shelf = do
  forM_ (errors options) $ \p -> if p >= 0 && p < chance then pure () else unusable tooWrong
  grounds <- forM (sizes options) $ \size -> do
    mask <- orUnusable windowMessage (rectangle size)
    place <- orUnusable groundMessage (ground shelf size)
    pure (size, place, exactRates (radius options) shelf mask)
  for_ (plot options) orUnwritable
  printsAsItGoes <- (form options /= Json &&) <$> hIsTerminalDevice stdout
  let total =
        toInteger (length grounds * length (errors options) * length (erasures options))
          * toInteger (trials options)
      cases =
        [ (size, place, exact, p, s)
          | (size, place, exact) <- grounds,
            s <- erasures options,
            p <- errors options
        ]
      perLine = toInteger (trials options)
      -- Lines and a bar on one terminal would run into each other.
      watched act = if printsAsItGoes then act (const (pure ())) else withProgress total 0 act
  case form options of
    Text -> say (heading (radius options))
    Csv -> say (csvHeading ++ "\n")
    Json -> pure ()
  made <- watched $ \tell -> forM (zip [0 ..] cases) $ \(i, (size, place, exact, p, s)) -> do
    l <- line options place size exact p s (\n -> tell (i * perLine + toInteger n))
    case form options of
      Text -> say (lineText l ++ "\n") >> hFlush stdout
      Csv -> say (lineCsv l ++ "\n") >> hFlush stdout
      Json -> pure ()
    pure l
  case form options of
    Text -> say (checksHeading ++ unlines (map checksText made) ++ checksOfAll made)
    Csv -> pure ()
    Json ->
      unless drawnOnly $
        printJson
          ( "schema" .= ("pra-tactile/rates/1" :: String) <> "profile" .= profileValue profile
              <> "trials" .= trials options
              <> "seed" .= seed options
              <> "radius" .= stated
              <> "rates" .= map lineValue made
          )
  for_ (plot options) $ \file -> writeWhole file (ratesSvg (seed options) made)
  pure Answered
  where
    drawnOnly = plot options == Just standardOutput
    say = unless drawnOnly . putStr
    stated = case radius options of
      Guaranteed -> Nothing
      UpTo e -> Just (naturalValue e)
    -- A symbol that is guessed is wrong as often; noise alone cannot do worse.
    chance = 100 * (1 - 1 / fromIntegral (fieldOrder (codebookArray shelf)))
    tooWrong =
      "--errors is a share from 0 to below "
        ++ numberText chance
        ++ " per cent, at which symbols are guessed"

-- | Simulate a line, telling how many trials are done.
line ::
  KnownField k =>
  Options ->
  Ground k ->
  Shape ->
  (Damage -> Maybe Rates) ->
  Double ->
  Double ->
  (Int -> IO ()) ->
  IO Line
line options place size exactly p s tell = do
  counts <-
    foldM
      add
      noTrials
      ( withStrategy
          (parBuffer 8 rseq)
          (simulations (radius options) place damage (trials options) (seed options))
      )
  let hard = hardRates counts
      exact = exactly damage
      share = maybe (rateWrong hard) rateWrong exact
  pure
    Line
      { lineSize = size,
        lineErrors = p,
        lineErasures = s,
        lineTrials = trials options,
        lineHard = hard,
        lineExact = exact,
        lineSoft = softRates tolerated counts,
        lineAsHard = if share > 0 then Just (softRatesAtMost share counts) else Nothing,
        lineCalibration = calibration tolerated counts
      }
  where
    damage = Damage (p / 100) (s / 100)
    tolerated = 0.001
    add counts part = do
      let counts' = merge [counts, part]
      counts' `seq` tell (tallyTrials counts')
      pure counts'
