-- | Tests the derived figures in a table of rates against their definitions.
module Test.Formats.Rates (spec) where

import PraTactile.Array (Shape (..))
import PraTactile.Format.Rates
import PraTactile.Rates (Calibration (..), Rates (..))
import Test.Hspec
import Test.QuickCheck

spec :: Spec
spec = do
  it "soft decoding answers this many per cent more patches than hard decoding" $
    forAll genLine $ \line ->
      let answers = (1 -) . rateRefused
       in case (moreAnswers line, lineAsHard line) of
            (Nothing, soft) -> soft === Nothing .||. answers (lineHard line) <= 0
            (Just more, Just soft) ->
              counterexample (show more) $
                abs (answers (lineHard line) * (1 + more / 100) - answers soft) < 1e-9
            (Just more, Nothing) -> counterexample (show more) False
  it "a simulated rate differs from the exact one by this many standard errors of its mean" $
    forAll genLine $ \line -> case (deviations line, lineExact line) of
      (Nothing, exact) -> exact === Nothing
      (Just found, Just exact) ->
        conjoin
          [ counterexample (show (d, p, r)) $
              -- The variance of one trial, which is 1 with probability p, is E(x^2) - E(x)^2.
              abs (d * d * (p - p * p) - (r - p) * (r - p) * fromIntegral (lineTrials line)) < 1e-6
                .&&. (d >= 0) === (r >= p || d == 0)
            | (d, rate) <- zip found [rateRight, rateWrong, rateRefused],
              let p = rate exact,
              let r = rate (lineHard line),
              p > 0.01 && p < 0.99
          ]
          .&&. length found === 3
      (Just found, Nothing) -> counterexample (show found) False

genLine :: Gen Line
genLine =
  Line
    <$> (Shape <$> elements [1 .. 6] <*> elements [1 .. 6])
    <*> choose (0, 30)
    <*> choose (0, 30)
    <*> choose (1, 100000)
    <*> genRates
    <*> oneof [pure Nothing, Just <$> genRates]
    <*> genRates
    <*> oneof [pure Nothing, Just <$> genRates]
    <*> pure (Calibration 0 0 0)

-- | Three shares that add up to 1.
genRates :: Gen Rates
genRates = do
  a <- choose (0, 1)
  b <- choose (0, 1 - a)
  elements [Rates a b (1 - a - b), Rates b (1 - a - b) a, Rates 0 0 1, Rates 1 0 0]
