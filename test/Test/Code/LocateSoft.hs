-- | Positions from probabilities.
module Test.Code.LocateSoft (spec) where

import Data.List (sortOn)
import Data.Ord (Down (..))
import Data.Ratio ((%))
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Locate
import PraTactile.Locate.Decision
import PraTactile.Locate.Decoder.Codebook
import PraTactile.Locate.Decoder.Nearest
import PraTactile.Locate.Decoder.Posterior
import PraTactile.Window
import Test.Code.Generators
import Test.Hspec
import Test.QuickCheck (Gen, Property, choose, conjoin, counterexample, forAll, vectorOf, (===))

spec :: Spec
spec = do
  it "of symbols beyond doubt it locates as the exact comparison does" $ do
    array <- right paperPrimitive >>= right . folded Diagonal (Shape 15 17)
    m <- right (rectangle (Shape 2 2))
    shelf <- right (buildCodebook Torus array m)
    holds 300 $
      forAll
        ((,,) <$> choose (0, 14) <*> choose (0, 16) <*> vectorOf 6 genElement')
        $ \(r, c, other) ->
          let at i j = Position (fromInteger (r + i)) (fromInteger (c + j))
              seen = [[Just (cellAt array (at i j)) | j <- [0 .. 2]] | i <- [0, 1]]
              drawn = [map Just (take 3 other), map Just (drop 3 other)]
              exact cells =
                either
                  (const (Refused TooFewCells))
                  (withoutSupport . decisionOutcome . nearest shelf (UpTo 0))
                  (patch cells)
              soft cells =
                either
                  (const (Refused TooFewCells))
                  (decide 0 . posterior shelf)
                  (patch (map (map (fmap certainly)) cells))
              withoutSupport outcome = case outcome of
                Unique p _ -> Unique p []
                Ambiguous ps _ -> Ambiguous ps []
                _ -> Refused Contradiction
           in conjoin
                [ soft seen === exact seen,
                  soft drawn === exact drawn,
                  soft (map (take 1) seen) === exact (map (take 1) seen)
                ]
  it "a position is told only if the doubt is tolerated" $ do
    array <- right paperPrimitive >>= right . folded Diagonal (Shape 15 17)
    m <- right (rectangle (Shape 2 2))
    shelf <- right (buildCodebook Torus array m)
    [sure, unsure] <- mapM right [belief [0, 0, 0, 1], belief [0.1, 0, 0, 0.9]]
    [two, one'] <- mapM (\code -> certainly <$> right (fromCode code)) [2, 1]
    p <- right (patch [[Just unsure, Just two], [Just sure, Just one']])
    let found = posterior shelf p
    posteriorBest found `shouldBe` Just (Position 6 5)
    posteriorDoubt found `shouldSatisfy` near 0.1
    posteriorMargin found `shouldSatisfy` maybe False (near (log 9))
    map snd (take 2 (posteriorRanking found)) `shouldSatisfy` and . zipWith near [0.9, 0.1]
    decide 0.11 found `shouldBe` Unique (Position 6 5) []
    decide 0.09 found `shouldBe` Refused BelowThreshold
  it "an array can be impossible" $ do
    array <- right paperPrimitive >>= right . folded Diagonal (Shape 15 17)
    m <- right (rectangle (Shape 2 2))
    shelf <- right (buildCodebook Torus array m)
    p <- right (patch (replicate 2 (replicate 2 (Just (certainly (0 :: GF GF4))))))
    decide 0.5 (posterior shelf p) `shouldBe` Refused Contradiction
  it "numbers that are no probabilities are refused" $ do
    (belief [1, 0, 0] :: Either BeliefError (Belief GF4)) `shouldBe` Left (BeliefLength 3 4)
    (belief [1, 0, 0, 0, 0] :: Either BeliefError (Belief GF4)) `shouldBe` Left (BeliefLength 5 4)
    (belief [1.5, -0.5, 0, 0] :: Either BeliefError (Belief GF4))
      `shouldBe` Left (BeliefNegative 1 (-0.5))
    (belief [0.5, 0, 0, 0] :: Either BeliefError (Belief GF4)) `shouldBe` Left (BeliefSum 0.5)
    (belief [0 / 0, 0, 0, 1] :: Either BeliefError (Belief GF4))
      `shouldSatisfy` either (const True) (const False)
  where
    near a b = abs (a - b) < 1e-9 * (1 + abs a)
    genElement' = genElement :: Gen (GF GF4)
