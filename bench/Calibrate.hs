-- | Checks whether the doubts of symbols are right, for each shipped alphabet, sensor and angle.
-- The presses use seeds that no calibration used. For each decade of doubt it prints the number of
-- symbols, and how many were predicted and found to be wrong. For other shapes it prints how many
-- pass a limit that most of ours pass.
module Main (main) where

import Control.Monad (forM_)
import Data.List (sort, transpose, unfoldr)
import Data.Maybe (isNothing)
import qualified Data.Text as Text
import qualified Data.Text.IO as Text
import PraTactile.Classification.Calibration
import PraTactile.Classification.Classifier
import PraTactile.Classification.Estimate
import PraTactile.Classification.Network (outputs)
import PraTactile.Classification.Reader
import PraTactile.Classification.Regimen (shippedSeed)
import PraTactile.Classification.Shipped
import PraTactile.Explore (Turns (AnyAngle))
import PraTactile.Image (Raster, onRaster)
import PraTactile.Sensor (Preset (..), presetName, presetSensor)
import PraTactile.Shape (alphabet, shapes)
import PraTactile.Shape.Design (admissible, parametersFor)
import PraTactile.Shape.Distance (nearest, nearestDistance)
import PraTactile.Steps (result)
import PraTactile.SymbolCalibration
import PraTactile.SymbolImages
import PraTactile.Symmetry
import System.Environment (getArgs)
import System.IO (BufferMode (LineBuffering), hSetBuffering, stdout)
import Text.Printf (printf)

-- | The arguments: the number of symbols per condition (300), and the orders of fields (all that
-- have shapes). Or @fit@ and an order: the calibration of the shipped network, as @train@ finds it,
-- without training.
main :: IO ()
main = do
  hSetBuffering stdout LineBuffering
  arguments <- getArgs
  case arguments of
    ["fit", q] -> orFail (shippedReader (read q)) >>= fitted' >>= Text.putStr . renderCalibration
    n : some@(_ : _) -> forM_ (map read some) (counting (read n))
    [n] -> forM_ shippedSizes (counting (read n))
    [] -> forM_ shippedSizes (counting 300)
  where
    counting count q = orFail (shippedReader q) >>= counted count q
    fitted' reader =
      orFail
        =<< orFail
          ( result $
              calibratedSteps
                (readerAlphabet reader)
                (readerTemplates reader)
                (outputs (readerNetwork reader))
                shippedSeed
          )

-- | An image and its truth.
type Known = (Maybe (Int, Symmetry), Raster)

-- | A symbol: its estimate, and its truth with features.
type Told = (ClassEstimate, LabelledFeatures)

-- | The tables of a field: for symbols, for whether they belong to the alphabet, and for other
-- shapes.
counted :: Int -> Int -> Reader -> IO ()
counted count q reader = do
  ours <-
    sequenceA
      [ (,) (conditionName c) <$> orFail (knownImages known count (7000000 + k) c)
        | (k, c) <- zip [0 ..] conditions,
          not (conditionOthers c)
      ]
  told <- traverse (traverse (traverse (toldBy network))) ours
  heading ["q", "symbols", "presses"] (decades ++ ["loss", "by three numbers"])
  forM_ (told ++ [("all", concatMap snd told)]) $ \(name, these) ->
    row
      [show q, "network", name]
      (byDecade (map wrongClass these) ++ map (\of' -> mean (map of' these)) [loss, lossOfThree])
  forM_ [("means", meansClassifier), ("logistic", logisticClassifier)] $ \(name, classifier) -> do
    these <- traverse (toldBy (classifier (readerCalibration reader) known)) (concatMap snd ours)
    row [show q, name, "all"] (byDecade (map wrongClass these) ++ [mean (map loss these), ""])
  others <- traverse othersBy [Paper, Real, Hard]
  let anyAngle = [(name, these) | (c, (name, these)) <- zip ordinary told, conditionAnyAngle c]
      beside = zip anyAngle others
  heading ["q", "ours or not", "presses"] decades
  forM_ beside $ \((name, mine), byDistance) -> do
    let far = concat (take 1 (reverse byDistance))
        n = min (length mine) (length far)
    row [show q, "network", name] (byDecade (map wrongKind (take n mine ++ take n far)))
  heading ["q", "where so many of ours pass", "presses"] (map distances bounds)
  forM_ [0.97, 0.99] $ \share -> forM_ beside $ \((name, mine), byDistance) ->
    row [show q, printf "%.0f %%" (100 * share), name] (map (passing share mine) byDistance)
  where
    known = readerAlphabet reader
    network = networkClassifier reader
    ordinary = filter (not . conditionOthers) conditions
    -- The estimates of other shapes, by their distance, at any angle.
    othersBy :: Preset -> IO [[Told]]
    othersBy sensor =
      sequenceA
        [ concat
            <$> sequenceA
              [ otherImages sensor some (7100000 + 1000 * k + j) >>= traverse (toldBy network)
                | (j, some) <- zip [0 ..] (portions bound [b | (b, d) <- drawn, d `within` bound])
              ]
          | (k, bound) <- zip [0 ..] bounds
        ]
    drawn = [(b, distanceFrom b) | b <- spread (admissible (parametersFor []))]
    distanceFrom b = minimum [nearestDistance (nearest symmetries a b) | a <- shapes known]
    -- Eight shapes per plate, 50 images of each. A range of distances with an upper bound gets a
    -- tenth as many plates.
    portions (_, to) = take (maybe plates (const (max 1 (plates `div` 10))) to) . parts 8
    plates = max 1 (3 * count `div` 400)
    otherImages sensor some seed
      | null some = pure []
      | otherwise = do
        these <- orFail (alphabet (zip (map (Text.pack . show) [0 :: Int ..]) some))
        labelled <-
          orFail
            ( labelledImages
                (symbolsOf known) {symbolShapes = these}
                (Presses (presetName sensor) (presetSensor sensor) AnyAngle)
                (max 1 (min 50 (count `div` length some)))
                seed
            )
        pure [(Nothing, image) | (image, _) <- labelledAs labelled]

-- | Every 101st element, then every 101st from the second on, and so on: neighbours are far apart
-- in the order of drawings.
spread :: [a] -> [a]
spread = concat . transpose . parts 101

-- | A list in parts of the given length.
parts :: Int -> [a] -> [[a]]
parts n = takeWhile (not . null) . unfoldr (Just . splitAt n)

-- | Ranges of the distance from the nearest shape of the alphabet, in taxels.
bounds :: [(Int, Maybe Int)]
bounds = [(4, Just 11), (12, Just 15), (16, Just 19), (20, Just 23), (24, Nothing)]

within :: Int -> (Int, Maybe Int) -> Bool
within d (from, to) = d >= from && all (d <=) to

distances :: (Int, Maybe Int) -> String
distances (from, to) = maybe (printf "%d taxels or more" from) (printf "%d to %d" from) to

toldBy :: Classifier -> Known -> IO Told
toldBy classifier (truth, image) = do
  upright <- orFail (classifierOutputs classifier image)
  upsideDown <- orFail (classifierOutputs classifier (onRaster (turned 2) image))
  let shapesSeen = classifierTemplates classifier
  pure
    ( estimateFrom (classifierCalibration classifier) shapesSeen image upright upsideDown,
      LabelledFeatures truth (symbolFeatures shapesSeen image upright upsideDown)
    )

-- | The doubt of class and orientation, and whether these were wrong.
wrongClass :: Told -> (Double, Bool)
wrongClass (e, LabelledFeatures truth _) = (estimateDoubt e, Just (estimateLikeliest e) /= truth)

-- | The doubt of whether a symbol belongs to the alphabet (prior 1/2), and whether that was wrong.
wrongKind :: Told -> (Double, Bool)
wrongKind (e, LabelledFeatures truth _) = (1 / (1 + exp (abs u)), (u > 0) /= isNothing truth)
  where
    u = estimateForeignShape e

loss :: Told -> Double
loss (e, LabelledFeatures truth _) = negate (log (maybe 1 (estimateChance e) truth))

-- | The loss of a simpler model for comparison: the doubt is a logistic regression with three
-- numbers, on the lead of the greatest logit and on the likeness to its shape, and all other
-- classes share it equally.
lossOfThree :: Told -> Double
lossOfThree (_, LabelledFeatures truth (SymbolFeatures told _)) =
  negate (log (if Just best == truth then 1 - doubt else doubt / others))
  where
    (greatest, (best, likeness)) = maximum [(z, (what, s)) | (what, (z, s)) <- told]
    lead = minimum [greatest - z | (what, (z, _)) <- told, what /= best]
    others = fromIntegral (length told - 1)
    regressed = 1 / (1 + exp (0.11 * lead + 21.9 * likeness - 11.3))
    doubt = max 1e-7 (min (others / (others + 1)) regressed)

-- | For each decade of doubt from 1e-4 up: the number of symbols, and how many were predicted and
-- found wrong.
byDecade :: [(Double, Bool)] -> [String]
byDecade these =
  [ printf "%d: %.2f, %d" (length here) (sum (map fst here)) (length (filter snd here))
    | (from, to) <- zip edges (drop 1 edges),
      let here = [t | t@(doubt, _) <- these, doubt >= from, doubt < to]
  ]
  where
    edges = [0, 1e-4, 1e-3, 1e-2, 1e-1, 1.1]

decades :: [String]
decades = ["below 1e-4", "1e-4 to 1e-3", "to 1e-2", "to 0.1", "above"]

-- | How many other shapes pass a limit that the given share of ours passes, and their number.
passing :: Double -> [Told] -> [Told] -> String
passing share ours others = printf "%d of %d" (length passed) (length others)
  where
    passed = filter (< limit) (unlike others)
    unlike = map (estimateForeignShape . fst)
    before = floor (share * fromIntegral (length ours)) :: Int
    limit = case drop before (sort (unlike ours)) of
      u : _ -> u
      [] -> 1 / 0

mean :: [Double] -> String
mean these = printf "%.5f" (sum these / fromIntegral (max 1 (length these)))

heading, row :: [String] -> [String] -> IO ()
heading names numbers = do
  putStrLn ""
  row names numbers
  putStrLn ("|" ++ concatMap (const "---|") names ++ concatMap (const "--:|") numbers)
row names numbers =
  putStrLn ("| " ++ concatMap (++ " | ") names ++ unwords (map (++ " |") numbers))

orFail :: Show e => Either e a -> IO a
orFail = either (fail . show) pure
