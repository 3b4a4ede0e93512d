-- | Whether the doubts of symbols mean what they say, for each shipped alphabet, sensor and angle:
-- on presses of seeds that no calibration has, by each decade of doubt how many symbols were told
-- to be wrong and how many were; and of other shapes, how many pass where most of ours do.
module Main (main) where

import Control.Monad (forM_)
import Data.List (sort)
import qualified Data.Text.IO as Text
import PraTactile.Classification.Calibration
import PraTactile.Classification.Classifier
import PraTactile.Classification.Estimate
import PraTactile.Classification.Network (outputs)
import PraTactile.Classification.Reader
import PraTactile.Classification.Regimen (shippedSeed)
import PraTactile.Classification.Shipped
import PraTactile.Image (Raster, onRaster)
import PraTactile.SymbolCalibration
import PraTactile.Symmetry
import System.Environment (getArgs)
import System.IO (BufferMode (LineBuffering), hSetBuffering, stdout)
import Text.Printf (printf)

-- | The arguments: how many symbols of each condition (300), and the orders of fields, if not all
-- that have shapes. Or @fit@ and an order: then the calibration of the shipped network, as @train@
-- finds it, without training.
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
          ( calibrated
              (readerAlphabet reader)
              (readerTemplates reader)
              (outputs (readerNetwork reader))
              shippedSeed
          )

-- | A symbol: what is told of it, and what it truly is.
type Told = (Estimate, Maybe (Int, Symmetry))

counted :: Int -> Int -> Reader -> IO ()
counted count q reader = do
  images <-
    sequenceA
      [ (,) c <$> orFail (knownImages alphabet count (9000000 + k) c)
        | (k, c) <- zip [0 ..] conditions
      ]
  forM_
    [ ("network", networkClassifier reader),
      ("means", meansClassifier (readerCalibration reader) alphabet),
      ("logistic", logisticClassifier (readerCalibration reader) alphabet)
    ]
    $ \(name, classifier) -> do
      judged <- traverse (traverse (traverse (toldBy classifier))) images
      printf "GF(%d), %s\n" q (name :: String)
      forM_ [(c, these) | (c, these) <- judged, not (conditionOthers c)] $ \(c, these) ->
        decades (conditionName c) these
      decades "all of them" (concat [these | (c, these) <- judged, not (conditionOthers c)])
      forM_ [(c, these) | (c, these) <- judged, conditionOthers c] $ \(c, these) ->
        passing
          (conditionName c)
          (concat [ours | (o, ours) <- judged, o == c {conditionOthers = False}])
          these
  where
    alphabet = readerAlphabet reader

toldBy :: Classifier -> (Maybe (Int, Symmetry), Raster) -> IO Told
toldBy classifier (truth, image) = do
  upright <- orFail (classifierOutputs classifier image)
  upsideDown <- orFail (classifierOutputs classifier (onRaster (turned 2) image))
  pure
    ( estimateFrom
        (classifierCalibration classifier)
        (classifierTemplates classifier)
        image
        upright
        upsideDown,
      truth
    )

-- | By decade of doubt, from 1e-4 up: symbols, told and counted wrong; and the mean loss, - log of
-- the probability of the truth.
decades :: String -> [Told] -> IO ()
decades name these = do
  printf "  %-20s" name
  forM_ (zip bounds (drop 1 bounds)) $ \(from, to) -> do
    let here = [t | t@(e, _) <- these, estimateDoubt e >= from, estimateDoubt e < to]
    printf " | %5d %6.2f %3d" (length here) (sum (map (estimateDoubt . fst) here)) (wrong here)
  printf " | loss %.5f\n" (sum (map loss these) / fromIntegral (max 1 (length these)))
  where
    bounds = [0, 1e-4, 1e-3, 1e-2, 1e-1, 1.1] :: [Double]
    wrong here = length [() | (e, truth) <- here, Just (estimateLikeliest e) /= truth]
    loss (e, truth) = negate (log (maybe 1 (estimateChance e) truth))

-- | How many others pass where 97 and 99 % of ours do, and how many of either are likelier another
-- shape than they are told to be.
passing :: String -> [Told] -> [Told] -> IO ()
passing name ours others =
  printf
    "  %-20s pass where 97 %% of ours do: %.1f %%, 99 %%: %.1f %%; \
    \likelier others: of ours %d of %d, of others %d of %d\n"
    name
    (share 0.97)
    (share 0.99)
    (likelier ours)
    (length ours)
    (likelier others)
    (length others)
  where
    unlike = map (estimateUnlike . fst)
    before part = floor (part * fromIntegral (length ours)) :: Int
    limit part = case drop (before part) (sort (unlike ours)) of
      u : _ -> u
      [] -> 1 / 0
    share :: Double -> Double
    share part =
      100 * fromIntegral (length (filter (< limit part) (unlike others)))
        / fromIntegral (max 1 (length others))
    likelier = length . filter (> 0) . unlike

orFail :: Show e => Either e a -> IO a
orFail = either (fail . show) pure
