-- | How sure the estimates of an alphabet's symbols are (Note [Calibration] of
-- "PraTactile.Classification.Estimate"): symbols are cut from composites of simulated explorations
-- of an array's plate, with a position error of a taxel and noise of 0.1 to 0.4 of full scale, and
-- the log odds of a wrong estimate are fitted by logistic regression on its lead and its likeness.
module Main (main) where

import Control.Monad (forM_)
import qualified Data.ByteString as Bytes
import Data.List (foldl')
import Data.Maybe (catMaybes, mapMaybe)
import Numeric.LinearAlgebra (Matrix, Vector, fromList, konst, outer, scale, toList, (<.>), (<\>))
import PraTactile.Array hiding (toList, toRows)
import PraTactile.Classification.Classifier
import PraTactile.Classification.Estimate
import PraTactile.Classification.Reader
import PraTactile.Classification.Shipped
import PraTactile.Evaluate
import PraTactile.Explore
import PraTactile.Field (KnownField)
import PraTactile.Format (decodeProfile)
import PraTactile.Geometry (columnPitch, rowPitch, taxelPitch)
import PraTactile.Image (Raster, onRaster)
import PraTactile.Object.Placement
import PraTactile.Object.Plate
import PraTactile.Profile
import PraTactile.Registration
import PraTactile.Relief
import PraTactile.Segmentation
import PraTactile.Sensor (Sensor (..), standardSensor)
import PraTactile.Sensor.Frame (movePoint)
import PraTactile.Symmetry
import System.Environment (getArgs)
import System.IO (BufferMode (LineBuffering), hSetBuffering, stdout)
import Text.Printf (printf)

-- | A symbol: its lead, its likeness, and whether its estimate is wrong.
data Symbol = Symbol !Double !Double !Bool

-- | The arguments: how many explorations at each noise (10), and the orders of fields, if not all
-- that have shapes.
main :: IO ()
main = do
  hSetBuffering stdout LineBuffering
  arguments <- getArgs
  case map read arguments of
    count : some@(_ : _) -> mapM_ (calibrate count) some
    [count] -> mapM_ (calibrate count) shippedSizes
    [] -> mapM_ (calibrate 10) shippedSizes

-- | What is counted and told of the alphabet for a field, and what is fitted where enough are
-- wrong.
calibrate :: Int -> Int -> IO ()
calibrate count q = do
  profile <-
    if q == 4 then pure canonicalProfile else Bytes.readFile file >>= orFail . decodeProfile
  reader <- orFail (shippedReader q)
  plate <- orFail (platePlacement (profileShape profile))
  cut <- orFail (withProfile profile (\array _ -> explored reader plate array count 1000))
  forM_
    [ ("network", networkClassifier reader),
      ("nearest class mean", meansClassifier (readerAlphabet reader)),
      ("logistic regression", logisticClassifier (readerAlphabet reader))
    ]
    $ \(name, classifier) -> do
      let byNoise = map (fmap (mapMaybe (symbolBy classifier))) cut
          symbols = concatMap snd byNoise
          wrong = length [() | Symbol _ _ True <- symbols]
          fitted = fit (classifierRegression classifier) symbols
          Regression a b c = fitted
      printf "GF(%d), %s\n" q (name :: String)
      mapM_ (told (classifierRegression classifier) fitted) byNoise
      if wrong < leastWrong
        then printf "%d wrong are too few to fit\n" wrong
        else printf "intercept %.2f, per lead %.3f, per likeness %.2f\n" a b c
  where
    file = "data/profiles/gf" ++ show q ++ ".json"
    orFail :: Show e => Either e a -> IO a
    orFail = either (fail . show) pure

-- | Of fewer wrong estimates three numbers follow the cases, not the law.
leastWrong :: Int
leastWrong = 100

-- | An image as a symbol of a classifier, with the class and turn that it truly has.
symbolBy :: Classifier -> (Raster, (Int, Symmetry)) -> Maybe Symbol
symbolBy classifier (image, true) = do
  upright <- right (classifierOutputs classifier image)
  upsideDown <- right (classifierOutputs classifier (onRaster (turned 2) image))
  (likeliest, _, lead, likeness) <-
    regressors (classifierTemplates classifier) image upright upsideDown
  pure (Symbol lead likeness (likeliest /= true))
  where
    right = either (const Nothing) Just

-- | At each noise the images of so many explorations' symbols, with their classes and turns.
explored ::
  KnownField k =>
  Reader ->
  Placement ->
  PseudorandomArray k ->
  Int ->
  Int ->
  [(Double, [(Raster, (Int, Symmetry))])]
explored reader plate array count seed =
  [ (noise, concatMap (cutOut noise) (catMaybes (take count (trials how faces (seed + i)))))
    | (i, noise) <- zip [0 ..] [0.1, 0.2, 0.3, 0.4],
      let how = exploration (sensor noise) (AmongTurns halfTurns) standardRegionSize
  ]
  where
    known noise = standardRegistration {registrationNoise = noise}
    sensor noise = standardSensor {sensorNoise = noise, sensorPositionError = 1}
    faces =
      [ (face, felt)
        | face <- laidFaces plate,
          Right felt <- [relief array plate (readerAlphabet reader) face]
      ]
    cutOut noise t =
      case stitch (readerTables reader) (known noise) (trialFrames t) of
        Left _ -> []
        Right composite ->
          [ (symbolPixels symbol, (true, regionSymmetry (trialRegion t)))
            | symbol <- segmentedSymbols (segment composite),
              let at = compositePosition composite (symbolCentre symbol),
              Just true <- [classUnder (trialFace t) (movePoint (regionMotion (trialRegion t)) at)]
          ]
    -- The class of the cell in whose middle a place of the face is, to a third of a pitch.
    classUnder face (x, y)
      | inside,
        near fi,
        near fj =
        Just (classOn array face (Position (fromInteger i) (fromInteger j)))
      | otherwise = Nothing
      where
        (fi, fj) = (y / (rowPitch * taxelPitch), x / (columnPitch * taxelPitch)) :: (Double, Double)
        (i, j) = (floor fi, floor fj) :: (Integer, Integer)
        inside =
          i >= 0 && j >= 0
            && i < toInteger (rows (laidGrid face))
            && j < toInteger (columns (laidGrid face))
        near f = abs (f - fromIntegral (floor f :: Integer) - 0.5) < 0.3

-- | The maximum of the likelihood, by Newton's method from a regression; a step that does not raise
-- it is halved.
fit :: Regression -> [Symbol] -> Regression
fit (Regression a b c) symbols = regression (iterate step start !! 40)
  where
    start = fromList [a, b, c]
    regression v = case toList v of
      [x, y, z] -> Regression x y z
      _ -> Regression a b c
    row (Symbol lead likeness _) = fromList [1, negate lead, negate likeness] :: Vector Double
    wrong (Symbol _ _ w) = if w then 1 else 0 :: Double
    chance v s = 1 / (1 + exp (negate (v <.> row s)))
    likelihood v =
      sum [log (max 1e-300 (if wrong s > 0 then chance v s else 1 - chance v s)) | s <- symbols]
    step v = foldr better v (take 20 (iterate (/ 2) 1))
      where
        gradient = foldl' (+) (konst 0 3) [scale (wrong s - chance v s) (row s) | s <- symbols]
        curvature =
          foldl'
            (+)
            (konst 0 (3, 3))
            [scale (p * (1 - p)) (outer (row s) (row s)) | s <- symbols, let p = chance v s] ::
            Matrix Double
        direction = curvature <\> gradient
        better by rest =
          let v' = v + scale by direction in if likelihood v' > likelihood v then v' else rest

-- | How many are wrong at a noise, and how many two regressions expect.
told :: Regression -> Regression -> (Double, [Symbol]) -> IO ()
told before after (noise, symbols) =
  printf
    "noise %.1f: %d symbols, wrong %d, expected %.1f; as fitted %.1f\n"
    noise
    (length symbols)
    (length [() | Symbol _ _ True <- symbols])
    (expected before)
    (expected after)
  where
    expected (Regression a b c) =
      sum
        [ 1 / (1 + exp (negate (a - b * lead - c * likeness)))
          | Symbol lead likeness _ <- symbols
        ]
