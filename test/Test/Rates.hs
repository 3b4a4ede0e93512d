{-# LANGUAGE DataKinds #-}
-- | Simulated rates, beside the exact ones.
module Test.Rates (spec) where

import Control.Monad (forM_)
import Test.Hspec

import PraTactile.Array
import PraTactile.Field.Named
import PraTactile.Locate.Book
import PraTactile.Locate.Rates
import PraTactile.Rates
import PraTactile.Window
import PraTactile.Window.Distance
import Test.Code.Generators

spec :: Spec
spec = do
  it "two numbers are in the wrong order with probability Phi(-1/(sigma sqrt 2))" $
    forM_ [(1 / sqrt 2, 0.15865525393145705), (1 / sqrt 8, 0.022750131948179195)] $ \(sigma, figure) ->
      abs (errorRate 2 sigma - figure) `shouldSatisfy` (< 1e-9)
  it "the noise for an error rate has that error rate" $
    forM_ [(q, p) | q <- [2, 4, 9], p <- [0.001, 0.02, 0.3]] $ \(q, p) -> abs (errorRate q (noiseFor q p) - p) `shouldSatisfy` (< 1e-9)
  it "hard decoding is right, wrong and refused as often as the weights say, within 4 standard errors" $ do
    shelf <- paperBook
    forM_ [(Shape 2 2, 0, 0.02), (Shape 3 3, 1, 0.1), (Shape 3 4, 2, 0.1)] $ \(size, t, p) -> do
      m <- right (rectangle size)
      weights <- right (weightEnumerator (bookArray shelf) m)
      let exact = decodingRates 4 (maskSize m) weights t p
          found = hardRates (simulate shelf size (Damage p 0) trials 1)
      forM_ [rateRight, rateWrong, rateRefused] $ \rate ->
        abs (rate found - rate exact) `shouldSatisfy` (<= 4 * sqrt (rate exact * (1 - rate exact) / fromIntegral trials))
  it "soft decoding errs as often as its doubts add up to, within 4 standard errors, at every threshold" $ do
    shelf <- paperBook
    forM_ [(Shape 2 2, Damage 0.05 0), (Shape 3 3, Damage 0.1 0.15), (Shape 3 3, Damage 0.2 0)] $ \(size, damage) -> do
      let tally = simulate shelf size damage trials 2
      forM_ [1, 0.1, 0.01, 0.001] $ \tolerated -> do
        let (count, expected, wrong) = wrongAmong tolerated tally
        abs (fromIntegral wrong - expected) `shouldSatisfy` (<= 4 * sqrt (expected + 0.25))
        fromIntegral wrong `shouldSatisfy` (<= tolerated * fromIntegral count + 4 * sqrt (tolerated * fromIntegral count + 0.25))
  it "soft decoding answers more often than hard decoding, at no more wrong answers" $ do
    shelf <- paperBook
    forM_ [Damage 0.1 0, Damage 0.1 0.15, Damage 0.05 0.15] $ \damage -> do
      let tally = simulate shelf (Shape 3 3) damage trials 3
          hard = hardRates tally
          soft = softRatesAtMost (rateWrong hard) tally
      rateRight soft `shouldSatisfy` (> rateRight hard + 0.02)
  it "one seed, one result; chunks merge" $ do
    shelf <- paperBook
    let part = simulate shelf (Shape 3 3) (Damage 0.05 0.1) 50
    part 7 `shouldBe` part 7
    part 7 `shouldNotBe` part 8
    tallyTrials (merge [part 7, part 8]) `shouldBe` 100
 where
  trials = 5000 :: Int

paperBook :: IO (Book GF4)
paperBook = do
  array <- right paperPrimitive >>= right . folded Diagonal (Shape 15 17)
  m <- right (rectangle (Shape 2 2))
  right (book Torus array m)
