-- | The window property, by both roads.
module Test.Code.Window.ProvedTwice (spec) where

import Data.Maybe (isJust)
import PraTactile.Array
import PraTactile.Grid
import PraTactile.Window
import PraTactile.Window.Proof
import Test.Code.Generators
import Test.Code.Window.Visiting
import Test.Hspec
import Test.Paper

spec :: Spec
spec = do
  describe "the paper's array, 15 x 17 with 2 x 2 windows" $ do
    it "is proved on the torus by both methods: 255 distinct windows, rank 4 of 4" $ do
      array <- paperArray
      m <- right (rectangle (Shape 2 2))
      (verdict, witness) <- right (prove (ArrayOn Torus array) m)
      verdict
        `shouldBe` WindowVerdict
          { proved = True,
            enumeration = Just True,
            rankDecision = Just True,
            rank = Just 4,
            needed = Just 4,
            distinctWindows = Just 255,
            surface = Torus,
            collision = Nothing,
            zeroWindow = Nothing
          }
      fmap (\w -> (provedMask w, provedSurface w, arrayShape (provedArray w))) witness
        `shouldBe` Just (m, Torus, Shape 15 17)
    it "has 224 windows on the sheet, distinct as well" $ do
      (verdict, _) <- verdictOn Sheet (rectangle (Shape 2 2))
      (proved verdict, distinctWindows verdict, rank verdict) `shouldBe` (True, Just 224, Just 4)
    it "is refuted with 1 x 2 windows, by two positions with the same content" $ do
      array <- paperArray
      m <- right (rectangle (Shape 1 2))
      (verdict, witness) <- right (prove (ArrayOn Torus array) m)
      (proved verdict, rank verdict, distinctWindows verdict, isJust (zeroWindow verdict))
        `shouldBe` (False, Just 2, Just 16, True)
      fmap (const ()) witness `shouldBe` Nothing
      fmap
        ( \(a, b) ->
            (a == b, windowAt (ArrayOn Torus array) m a == windowAt (ArrayOn Torus array) m b)
        )
        (collision verdict)
        `shouldBe` Just (False, True)
    it "with a mask of rank 3 is refuted on the torus and proved on the sheet, by visiting" $ do
      (onTorus, _) <- verdictOn Torus awkward
      (proved onTorus, rankDecision onTorus, rank onTorus, distinctWindows onTorus)
        `shouldBe` (False, Just False, Just 3, Just 64)
      (onSheet, witness) <- verdictOn Sheet awkward
      (proved onSheet, rankDecision onSheet, rank onSheet, distinctWindows onSheet)
        `shouldBe` (True, Nothing, Just 3, Just 32)
      isJust witness `shouldBe` True
  describe "other arrays" $ do
    it "63 x 65 with 3 x 2 windows is proved on the torus" $ do
      (verdict, _) <- ofDegree6 Diagonal (Shape 63 65) (Shape 3 2) Torus
      (proved verdict, rank verdict, distinctWindows verdict) `shouldBe` (True, Just 6, Just 4095)
    it "15 x 273 row by row is proved on the twisted torus, not with plain wrapping" $ do
      (twisted, _) <- ofDegree6 RowMajor (Shape 15 273) (Shape 2 3) TwistedTorus
      (proved twisted, rank twisted, distinctWindows twisted) `shouldBe` (True, Just 6, Just 4095)
      (plain, _) <- ofDegree6 RowMajor (Shape 15 273) (Shape 2 3) Torus
      (proved plain, rankDecision plain, rank plain, distinctWindows plain)
        `shouldBe` (False, Nothing, Nothing, Just 4065)
    it "that are too large to visit are proved by rank alone" $ do
      h <- firstOver gf4 16
      array <- right (folded Diagonal (Shape 255 (257 * 65537)) h)
      m <- right (rectangle (Shape 4 4))
      (verdict, witness) <- right (prove (ArrayOn Torus array) m)
      ( proved verdict,
        enumeration verdict,
        rankDecision verdict,
        distinctWindows verdict,
        isJust witness
        )
        `shouldBe` (True, Nothing, Just True, Just (4 ^ (16 :: Int) - 1), True)
      (onSheet, _) <- right (prove (ArrayOn Sheet array) m)
      distinctWindows onSheet `shouldBe` Just ((255 - 3) * (257 * 65537 - 3))
    it "that are too large to visit are refused if the rank does not decide" $ do
      h <- firstOver gf4 16
      let shape = Shape 255 (257 * 65537)
      array <- right (folded Diagonal shape h)
      m <- right (rectangle (Shape 1 2))
      (() <$ prove (ArrayOn Sheet array) m)
        `shouldBe` Left (ArrayTooLarge (TooManyCells (area shape) largestGrid))
  describe "visiting" visitingSpec
  where
    awkward = mask [(0, 0), (0, 9), (11, 8)]
    verdictOn on m = do
      array <- paperArray
      m' <- right m
      right (prove (ArrayOn on array) m')
    ofDegree6 folding shape window on = do
      h <- firstOver gf4 6
      array <- right (folded folding shape h)
      m <- right (rectangle window)
      right (prove (ArrayOn on array) m)
