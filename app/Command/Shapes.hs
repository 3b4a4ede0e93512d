-- | @pra-tactile shapes@: the embossed shapes, drawn, measured and checked; the search that
-- designed them.
module Command.Shapes
  ( command,
  )
where

import Control.Monad (unless, when)
import Counted (counted)
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (for_)
import Data.Maybe (fromMaybe, isJust)
import Data.Proxy (Proxy)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import qualified Data.Text.IO as Text
import ExitStatus
import FieldChoice
import Message
import Numeric.Natural (Natural)
import Options
import Output
import PraTactile.Field (GF, KnownField, elements, showElement)
import PraTactile.Format.Shapes (encodeShapes)
import PraTactile.Shape
import PraTactile.Shape.Check
import PraTactile.Shape.Design
import PraTactile.Shape.Report
import PraTactile.Steps (result)
import Progress hiding (Work)
import Setup
import SvgFile
import Visible (visibleName)

data Options = Options
  { symbols :: AlphabetChoice,
    work :: Work,
    -- | of the search
    seed :: Maybe Int,
    -- | The form of the output, if not text.
    form :: Maybe (Drawings -> Text),
    output :: Maybe FilePath,
    picture :: Maybe FilePath
  }

data Work
  = Draw
  | Design
  | Check FilePath

command :: Subcommand
command =
  subcommand
    "shapes"
    "Draw, design or check the embossed shapes"
    "Draw the embossed shapes, with the table of their distances. Or run the search that designed \
    \them, or check drawings by the rules that they obey."
    []
    [ "pra-tactile shapes",
      "pra-tactile shapes --q 9 --picture shapes.svg",
      "pra-tactile shapes --design --output shapes.txt",
      "pra-tactile shapes --examine data/shapes.txt"
    ]
    (run <$> options)
  where
    options =
      Options
        <$> alphabetChoice
        <*> workOption
        <*> usually paperSeed intReader "seed" "N" "Seed of the search"
        <*> formOption
        <*> outputFileOption
        <*> pictureOption
          []
          "Draw the shapes as SVG as well; - is the standard output, in place of the text"
    formOption =
      flag' (Just alphabetSvg) (long "svg" <> internal)
        <|> (reported <$> jsonSwitch "Print the distances and the faults as JSON")
    reported given
      | given == AsJson = Just (\a -> Text.decodeUtf8 (encodeShapes a) <> Text.singleton '\n')
      | otherwise = Nothing

workOption :: Parser Work
workOption =
  Check
    <$> orAlias
      "check"
      pathReader
      (action "file")
      ( fileOption
          "examine"
          "FILE"
          "Print what is wrong with the shapes drawn in this file, and how far apart they are"
      )
    <|> flag'
      Design
      ( long "design"
          <> help
            "Run the search again, and write the shapes that it finds; four shapes take some \
            \seconds, nine some minutes"
      )
    <|> pure Draw

run :: Options -> IO ExitStatus
run options = do
  when (picture options == Just standardOutput) $
    leaveOut
      "--picture - prints the picture in place of the text"
      [("--json", isJust (form options)), ("--output", isJust (output options))]
  for_ (picture options) orNotSvg
  for_ (picture options) orUnwritable
  done options

-- | Draw, design or check, as the options say.
done :: Options -> IO ExitStatus
done options = case work options of
  Check file -> do
    leaveOut "the shapes of the file are examined" $
      ("--seed", isJust (seed options)) : alphabetGiven (symbols options)
    given <- readDrawings file
    shown (checkText (visibleName file) given) given
    pure (if null (faults given) then Answered else NotAnswered)
  Design -> do
    for_ (output options) orUnwritable
    q <-
      maybe (misused "--design makes shapes; leave out --shapes") pure (orderOf (symbols options))
    names <- elementNames q
    measured <-
      withProgress (unevenly drawings "drawings") $ \bar ->
        followWhile measuring bar $
          designSteps (fromMaybe paperSeed (seed options)) (parametersFor names)
    -- A proof that no shapes are this far apart may take arbitrarily long.
    searched <-
      withProgress (openly sought) $ \bar -> followWhile trying bar measured
    (found, report) <- orUnusable shapeMessage (result searched)
    shown (renderAlphabet found) (alphabetDrawings found)
    for_ (output options) (`sayBeside` Text.unpack (renderReport found report))
    pure Answered
  Draw -> do
    leaveOut "nothing is searched without --design" [("--seed", isJust (seed options))]
    chosen <- chosenAlphabet (symbols options)
    shown
      (drawAlphabet chosen <> Text.singleton '\n' <> distanceTable chosen)
      (alphabetDrawings chosen)
    pure Answered
  where
    measuring step = case step of
      Measured i -> Just (toInteger i)
      Trying _ -> Nothing
    trying step = case step of
      Trying d -> Just (toInteger d)
      Measured _ -> Nothing
    sought d
      | d == 0 = "looking for shapes"
      | otherwise = "looking for shapes " ++ show d ++ " taxels apart"
    shown text given = do
      for_ (picture options) $ \file -> writeWhole file (utf8 (alphabetSvg given))
      unless (picture options == Just standardOutput) $
        write (maybe text ($ given) (form options))
    utf8 = Lazy.fromStrict . Text.encodeUtf8
    write :: Text -> IO ()
    write text =
      maybe
        (Text.putStr text)
        (\file -> writeWhole file (utf8 text))
        (output options)

-- | The names of a field's elements, by code.
elementNames :: Natural -> IO [Text]
elementNames q = inConwayField q named
  where
    named :: forall k. KnownField k => Proxy k -> [Text]
    named _ = map (Text.pack . showElement) (elements :: [GF k])

-- | The distances, and each fault on a line.
checkText :: String -> Drawings -> Text
checkText name given =
  Text.unlines (Text.pack (name ++ ": " ++ apart) : map line (faults given))
  where
    q = length given
    apart =
      counted q "shape" "shapes"
        ++ (", least distance " ++ show (leastDistance given) ++ " of 96 taxels")
        ++ maybe
          ""
          (\d -> "; the greatest that so many can have is " ++ show d)
          (greatestPossible q)
    line (Fault shape kind) =
      Text.pack "fault: " <> shape <> Text.pack ": " <> Text.pack (faultWords kind)

faultWords :: ShapeFault -> String
faultWords kind = case kind of
  Side -> "less than 4 taxels are embossed along a side of its box"
  Stroke -> "it is not of blocks of 2 x 2 taxels, or some meet at a corner only"
  Pieces -> "it is in several pieces"
  Hole -> "it encloses something flat"
  Area -> "its area is not 48 to 56 taxels"
  OwnImage -> "it is like itself turned or mirrored" ++ near
  TooNear -> "it is like another shape" ++ near
  where
    near = ", but for less than " ++ show leastTolerated ++ " taxels"
