{-# LANGUAGE OverloadedStrings #-}
-- | @pra-tactile rates@: how often damaged patches are located right, wrong, or refused.
module Command.Rates
  ( command
  ) where

import Control.Monad (forM_)
import Control.Parallel.Strategies (parBuffer, rseq, withStrategy)
import Data.Aeson (Value, object, (.=))
import Data.Bits (shiftL, (.|.))
import Data.List (foldl', intercalate)
import Data.String (fromString)
import Options.Applicative hiding (columns, command)
import System.IO (hFlush, stdout)
import Text.Printf (printf)

import ArrayChoice
import Described
import Ending
import Json
import Json.Profile
import Message
import PraTactile.Array
import PraTactile.Field (KnownField, fieldOrder)
import PraTactile.Locate.Book
import PraTactile.Locate.Nearest (guaranteedRadius)
import PraTactile.Locate.Rates
import PraTactile.Profile
import PraTactile.Rates
import PraTactile.Window
import PraTactile.Window.Distance

data Form = Text | Csv | Json

data Options = Options
  { sizes :: [Shape]
  , errors :: [Double]     -- ^ per cent
  , erasures :: [Double]   -- ^ per cent
  , trials :: Int
  , seed :: Int
  , form :: Form
  }

command :: Mod CommandFields (IO Ending)
command = described "rates" "Tell how often damaged patches are located right, wrong, or refused: simulated from a seed, decoded from symbols to the guaranteed radius (hard) and from probabilities (soft), beside the exact rates of the weight enumerator."
  [ "pra-tactile rates"
  , "pra-tactile rates --size 4x4 --errors 2 --erasures 15 --trials 1000000" ]
  (run <$> arrayChoice <*> options)
  where
    options = Options
      <$> (some (option shapeReader (long "size" <> metavar "ROWSxCOLUMNS" <> help "A patch (default: 2x2, 3x3, 4x4 and 5x5); may be repeated")) <|> pure [Shape n n | n <- [2 .. 5]])
      <*> (some (option auto (long "errors" <> metavar "PERCENT" <> help "Wrong symbols among the observed ones (default: 0.6, 2, 5 and 10); may be repeated")) <|> pure [0.6, 2, 5, 10])
      <*> (some (option auto (long "erasures" <> metavar "PERCENT" <> help "Cells that were not observed (default: 0 and 15); may be repeated")) <|> pure [0, 15])
      <*> option auto (long "trials" <> metavar "N" <> value 10000 <> showDefault <> help "Trials a line of the table")
      <*> option auto (long "seed" <> metavar "N" <> value 1 <> showDefault <> help "Seed of every random draw")
      <*> option formReader (long "format" <> metavar "text|csv|json" <> value Text <> help "The form of the table (default text)")
    formReader = eitherReader $ \name -> maybe (Left (show name ++ " is no form; write text, csv or json")) Right (lookup name [("text", Text), ("csv", Csv), ("json", Json)])

run :: ArrayChoice -> Options -> IO Ending
run choice options
  | trials options < 1 = unusable "--trials is a number from 1 up"
  | any (\p -> not (p > 0 && p <= 50)) (errors options) = unusable "--errors is a share above 0 and up to 50 per cent"
  | any (\s -> not (s >= 0 && s < 100)) (erasures options) = unusable "--erasures is a share from 0 to below 100 per cent"
  | otherwise = do
      profile <- chosenProfile choice
      let on array mask = either (unusable . locateMessage) (\shelf -> tables profile options shelf) (book (naturalSurface (arrayFolding array)) array mask)
      either (unusable . profileMessage) id (withProfile profile on)

tables :: KnownField k => Profile -> Options -> Book k -> IO Ending
tables profile options shelf = do
  masks <- traverse (orUnusable windowMessage . rectangle) (sizes options)
  let linesOf = [ line options shelf size mask p s | (size, mask) <- zip (sizes options) masks, s <- erasures options, p <- errors options ]
  case form options of
    Json -> printJson ("schema" .= ("pra-tactile/rates/1" :: String) <> "profile" .= profileValue profile
      <> "trials" .= trials options <> "seed" .= seed options <> "rates" .= map lineValue linesOf)
    Csv -> putStrLn (commas ("size" : "errors_percent" : "erasures_percent" : [ way ++ "_" ++ what | way <- ways, what <- ["right", "wrong", "refused"] ]))
      >> forM_ linesOf (\l -> putStrLn (commas (shapeText (lineSize l) : show (lineErrors l) : show (lineErasures l) : concatMap (maybe ["", "", ""] csvRates) (lineRates l))) >> hFlush stdout)
    Text -> putStr heading >> forM_ linesOf (\l -> putStrLn (lineText l) >> hFlush stdout)
  pure Answered
  where
    commas = intercalate ","
    csvRates (Rates a b c) = map show [a, b, c]

ways :: [String]
ways = ["hard", "exact", "soft_999", "soft_as_hard"]

-- | A line of the table: rates by the 'ways'.
data Line = Line { lineSize :: Shape, lineErrors, lineErasures :: Double, lineRates :: [Maybe Rates] }

line :: KnownField k => Options -> Book k -> Shape -> Mask -> Double -> Double -> Line
line options shelf size mask p s = Line size p s [Just hard, exact, Just (softRates 0.001 counts), asHard]
  where
    damage = Damage (p / 100) (s / 100)
    counts = merge (withStrategy (parBuffer 8 rseq) [ simulate shelf size damage n (seed options * 1000003 + i) | (i, n) <- zip [0 ..] (chunks (trials options)) ])
    chunks left = if left <= 0 then [] else min 1000 left : chunks (left - 1000)
    hard = hardRates counts
    -- Where wrong answers are too rare to be counted, there is nothing to compare with.
    asHard = case maybe (rateWrong hard) rateWrong exact of
      0 -> Nothing
      wrong -> Just (softRatesAtMost wrong counts)
    exact = exactRates shelf mask damage

-- | The rates without chance, where there are few enough cells, or no erasures.
exactRates :: KnownField k => Book k -> Mask -> Damage -> Maybe Rates
exactRates shelf mask (Damage p s)
  | s > 0 = erasedRates ByObserved q supports n p s
  | windowDistance == 0 = Nothing
  | otherwise = either (const Nothing) (\weights -> Just (decodingRates q n weights (fromIntegral (guaranteedRadius windowDistance)) p)) (weightEnumerator array mask)
  where
    array = bookArray shelf
    q = fieldOrder array
    n = maskSize mask
    windowDistance = observedDistance shelf (maskOffsets mask)
    supports =
      [ foldl' (.|.) 0 [ 1 `shiftL` i | (i, a) <- zip [0 ..] content, a /= 0 ]
      | r <- upTo (rows (arrayShape array)), c <- upTo (columns (arrayShape array))
      , Just content <- [windowAt (bookSurface shelf) array mask (Position r c)]
      ]
    upTo k = takeWhile (< k) [0 ..]

lineValue :: Line -> Value
lineValue l = object
  [ "size" .= shapeText (lineSize l), "errors_percent" .= lineErrors l, "erasures_percent" .= lineErasures l
  , "by" .= object [ fromString way .= fmap ratesValue r | (way, r) <- zip ways (lineRates l) ] ]
  where
    ratesValue (Rates a b c) = object ["right" .= a, "wrong" .= b, "refused" .= c]

heading :: String
heading = unlines
  [ "right / wrong / refused in %. Hard: from symbols, to the radius that the observed cells guarantee; exact: the same without chance, where it can be"
  , "computed. Soft: from the same cells' probabilities, where 99.9 % certain; and as often as the wrong answers stay at most hard decoding's."
  , ""
  , printf "%-6s %6s %8s  %-30s %-30s %-30s %-30s" ("patch" :: String) ("errors" :: String) ("erasures" :: String)
      ("hard" :: String) ("exact" :: String) ("soft, 99.9 %" :: String) ("soft, as hard" :: String)
  ]

lineText :: Line -> String
lineText l = printf "%-6s %5.1f%% %7.1f%%  " (shapeText (lineSize l)) (lineErrors l) (lineErasures l)
  ++ unwords [ printf "%-30s" (maybe "-" ratesText r) | r <- lineRates l ]
  where
    ratesText (Rates a b c) = printf "%.3f / %.3g / %.3g" (100 * a) (100 * b) (100 * c) :: String
