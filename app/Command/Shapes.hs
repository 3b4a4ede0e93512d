-- | @pra-tactile shapes@: the embossed shapes, drawn and measured; the search that designed them.
module Command.Shapes
  ( command,
  )
where

import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (for_)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import qualified Data.Text.IO as Text
import ExitStatus
import Message
import Options
import Output (writeWhole)
import PraTactile.Shape
import PraTactile.Shape.Design
import PraTactile.Shape.Report
import Progress
import Setup

data Options = Options
  { designing :: Bool,
    seed :: Int,
    svg :: Bool,
    output :: Maybe FilePath
  }

command :: Mod CommandFields (IO ExitStatus)
command =
  subcommand
    "shapes"
    "Draw the four embossed shapes with the table of their distances, or run the search that \
    \designed them."
    [ "pra-tactile shapes",
      "pra-tactile shapes --svg --output shapes.svg",
      "pra-tactile shapes --design --output shapes.txt"
    ]
    (run <$> options)
  where
    options =
      Options
        <$> switch
          ( long "design"
              <> help "Run the search again (some seconds) and write the alphabet it finds"
          )
        <*> defaulting paperSeed intReader "seed" "N" "Seed of the search"
        <*> switch (long "svg" <> help "Draw the shipped shapes as SVG")
        <*> outputFileOption

run :: Options -> IO ExitStatus
run options
  | designing options = do
    (found, report) <-
      orUnusable shapeMessage
        =<< withProgress
          (toInteger searchLength)
          0
          (`follow` designSteps (seed options) paperParameters)
    write (renderAlphabet found)
    for_ (output options) (const (Text.putStr (renderReport found report)))
    pure Answered
  | otherwise = do
    shipped <- shippedAlphabet
    write
      ( if svg options
          then alphabetSvg shipped
          else drawAlphabet shipped <> Text.singleton '\n' <> distanceTable shipped
      )
    pure Answered
  where
    write :: Text -> IO ()
    write text =
      maybe
        (Text.putStr text)
        (\file -> writeWhole file (Lazy.fromStrict (Text.encodeUtf8 text)))
        (output options)
