{-# LANGUAGE DataKinds #-}

-- | The rates of right, wrong and refused answers.
module Test.Code.LocateRates (spec) where

import Control.Monad (forM_)
import Data.Bits (shiftL, (.|.))
import Data.List (foldl')
import qualified Data.Map.Strict as Map
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field.Named
import PraTactile.Locate.Rates
import PraTactile.Window
import PraTactile.Window.Distance
import Test.Code.Generators
import Test.Hspec

spec :: Spec
spec = do
  it "an error reaches a word as often as counting all errors says" $
    forM_ [(2, 6), (3, 4), (4, 4)] $ \(q, n) -> forM_ [0 .. n] $ \w -> forM_ [0 .. 2] $ \t -> do
      let p = 0.07
          vectors = mapM (const [0 .. q - 1]) [1 .. n]
          word = replicate w 1 ++ replicate (n - w) 0
          chance e = product [if x == 0 then 1 - p else p / fromIntegral (q - 1) | x <- e]
          counted = sum [chance e | e <- vectors, length (filter id (zipWith (/=) e word)) <= t] :: Double
      abs (reachProbability q n t p w - counted) `shouldSatisfy` (< 1e-12)
  it "on the paper's array: right, wrong and refused in %, as computed elsewhere" $
    forM_ figures $ \((h, w, t, p), (right', wrong, refused)) -> do
      weights <- weightsOf (Shape h w)
      let Rates a b c = decodingRates 4 (fromIntegral (h * w)) weights t p
      forM_ (zip [a, b, c] [right', wrong, refused]) $ \(x, (figure, half)) -> abs (100 * x - figure) `shouldSatisfy` (<= half)
  it "4x4 at 2 % errors with 15 % erasures: 99.685 % right by the window's distance, 99.849 % by that of the cells observed" $ do
    supports <- supportsOf (Shape 4 4)
    forM_ [(ByWindow, 99.685), (ByObserved, 99.849)] $ \(rule, figure) ->
      fmap (\r -> abs (100 * rateRight r - figure) <= 0.0005) (erasedRates rule 4 supports 16 0.02 0.15) `shouldBe` Just True
  it "without erasures the rates are those without erasures" $ do
    supports <- supportsOf (Shape 3 3)
    weights <- weightsOf (Shape 3 3)
    forM_ [ByWindow, ByObserved] $ \rule -> case erasedRates rule 4 supports 9 0.05 0 of
      Just (Rates a b c) -> let Rates a' b' c' = decodingRates 4 9 weights 1 0.05 in maximum (map abs [a - a', b - b', c - c']) `shouldSatisfy` (< 1e-12)
      Nothing -> expectationFailure "nothing"
 where
  -- Rows, columns, radius, error rate; and what is right, wrong and refused in %, each within half a unit of its last digit; for 4x4 at 5 %
  -- within 3 standard errors of a million trials, as the figure is one of a simulation: at most 4 errors among 16 cells have
  -- the probability 99.914 %.
  figures :: [((Natural, Natural, Int, Double), ((Double, Double), (Double, Double), (Double, Double)))]
  figures =
    [ ((2, 2, 0, 0.006), ((97.6, 0.05), (2.4, 0.05), (0.01, 0.005)))
    , ((3, 3, 1, 0.006), ((99.87, 0.005), (0.000065, 0.0000005), (0.13, 0.005)))
    , ((3, 3, 1, 0.05), ((92.9, 0.05), (0.03, 0.00005), (7.1, 0.05)))
    , ((4, 4, 4, 0.05), ((99.92, 0.009), (0.00039, 0.000005), (0.08, 0.009)))
    , ((4, 4, 4, 0.1), ((98.3, 0.05), (0.0083, 0.00005), (1.7, 0.05)))
    ]

paperArray :: IO (PseudorandomArray GF4)
paperArray = right paperPrimitive >>= right . folded Diagonal (Shape 15 17)

weightsOf :: Shape -> IO (Map.Map Natural Natural)
weightsOf size = do
  array <- paperArray
  m <- right (rectangle size)
  right (weightEnumerator array m)

supportsOf :: Shape -> IO [Int]
supportsOf size = do
  array <- paperArray
  m <- right (rectangle size)
  pure [foldl' (.|.) 0 [1 `shiftL` i | (i, a) <- zip [0 ..] content, a /= 0] | r <- [0 .. 14], c <- [0 .. 16], Just content <- [windowAt Torus array m (Position r c)]]
