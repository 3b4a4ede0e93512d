-- | The window property, by both roads.
module Test.Code.Window.ProvedTwice (spec) where

import Control.Monad (forM_)
import Data.List (nub)
import Data.Maybe (isJust)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Grid
import PraTactile.Polynomial
import PraTactile.Window
import PraTactile.Window.Proof
import Test.Code.Generators
import Test.Code.Window.Visiting
import Test.Hspec
import Test.Paper
import Test.QuickCheck hiding (elements)

spec :: Spec
spec = do
  describe "the paper's array, 15 x 17 with 2 x 2 windows" $ do
    it "is proved on the torus by both methods: 255 distinct windows, rank 4 of 4" $ do
      array <- paperArray
      m <- right (rectangle (Shape 2 2))
      (verdict, witness) <- right (prove (ArrayOn Torus array) m)
      verdict
        `shouldBe` Verdict
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
    it "is refuted with 1 x 2 windows, and the two positions told have the same content" $ do
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
    it "a mask of rank 3 is refuted on the torus and proved on the sheet by visiting" $ do
      (onTorus, _) <- verdictOn Torus awkward
      (proved onTorus, rankDecision onTorus, rank onTorus, distinctWindows onTorus)
        `shouldBe` (False, Just False, Just 3, Just 64)
      (onSheet, witness) <- verdictOn Sheet awkward
      (proved onSheet, rankDecision onSheet, rank onSheet, distinctWindows onSheet)
        `shouldBe` (True, Nothing, Just 3, Just 32)
      isJust witness `shouldBe` True
  describe "other arrays" $ do
    it "of all 32 primitive quartics over GF(4): 255 distinct windows that are not zero" $ do
      found <- right (primitivePolynomials 4 :: Either PolynomialError [Primitive GF4])
      m <- right (rectangle (Shape 2 2))
      forM_ found $ \h -> do
        array <- right (folded Diagonal (Shape 15 17) h)
        (verdict, _) <- right (prove (ArrayOn Torus array) m)
        (proved verdict, distinctWindows verdict, zeroWindow verdict)
          `shouldBe` (True, Just 255, Nothing)
    it "63 x 65 with 3 x 2 windows is proved on the torus" $ do
      (verdict, _) <- ofDegree6 Diagonal (Shape 63 65) (Shape 3 2) Torus
      (proved verdict, rank verdict, distinctWindows verdict) `shouldBe` (True, Just 6, Just 4095)
    it "15 x 273 row by row is proved on the twisted torus, not with plain wrapping" $ do
      (twisted, _) <- ofDegree6 RowMajor (Shape 15 273) (Shape 2 3) TwistedTorus
      (proved twisted, rank twisted, distinctWindows twisted) `shouldBe` (True, Just 6, Just 4095)
      (plain, _) <- ofDegree6 RowMajor (Shape 15 273) (Shape 2 3) Torus
      (proved plain, rankDecision plain, rank plain, distinctWindows plain)
        `shouldBe` (False, Nothing, Nothing, Just 4065)
    it "of every small size that folds: n1 = q^k1 - 1, k1 x k2 windows (MacWilliams and Sloane)" $
      forM_
        [ (2, 2, 2),
          (2, 3, 2),
          (2, 2, 4),
          (2, 4, 2),
          (3, 1, 3),
          (3, 2, 1),
          (3, 1, 5),
          (4, 1, 2),
          (4, 2, 2),
          (5, 1, 3),
          (8, 1, 2),
          (16, 1, 2),
          (9, 1, 3)
        ]
        $ \(q, k1, k2) -> overField q $ \k -> do
          h <- firstOver k (k1 * k2)
          let n1 = fromIntegral q ^ k1 - 1
              shape = Shape n1 ((fromIntegral q ^ (k1 * k2) - 1) `div` n1)
          array <- right (folded Diagonal shape h)
          m <- right (rectangle (Shape k1 k2))
          (verdict, _) <- right (prove (ArrayOn Torus array) m)
          (q, k1, k2, proved verdict, distinctWindows verdict)
            `shouldBe` (q, k1, k2, True, Just (area shape))
    it "too large to visit are proved by the rank alone" $ do
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
    it "too large to visit, and not for the rank to decide, are refused" $ do
      h <- firstOver gf4 16
      let shape = Shape 255 (257 * 65537)
      array <- right (folded Diagonal shape h)
      m <- right (rectangle (Shape 1 2))
      (() <$ prove (ArrayOn Sheet array) m)
        `shouldBe` Left (ArrayTooLarge (TooManyCells (area shape) largestGrid))
  describe "the rank road" $ do
    it "agrees with visiting, for any mask: distinct iff rank n; else q^rank windows" $ do
      array <- paperArray
      holds 100 $ forAllShrink genMask shrinkOffsets $ agree Torus array
    it "agrees on the twisted torus" $ do
      array <- paperPrimitive >>= right . folded RowMajor (Shape 15 17)
      holds 100 $ forAllShrink genMask shrinkOffsets $ agree TwistedTorus array
    it "agrees for odd q: GF(3), 2 x 13, and GF(5), 4 x 31" $
      forM_ [(3, Shape 2 13), (5, Shape 4 31)] $ \(q, shape) ->
        overField q $ \k -> do
          h <- firstOver k 3
          array <- right (folded Diagonal shape h)
          holds 100 $ forAllShrink genMask shrinkOffsets $ agree Torus array
    it "rank: of a matrix whose row space has q^r vectors" $
      holds 100 $
        forAllShrink
          (choose (0, 4) >>= (`vectorOf` genElements 3))
          (shrinkList (const []))
          $ \matrix ->
            let spanned =
                  nub
                    [ foldr (zipWith (+)) [0, 0, 0] (zipWith (\a v -> map (a *) v) as matrix)
                      | as <- mapM (const elements) matrix
                    ]
             in fromIntegral (length spanned) === (3 :: Natural) ^ rankOf (matrix :: [[GF GF3]])
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

-- | 'prove' compares the roads and refuses if they differ; here the theorem is stated once more.
agree :: KnownField k => Surface -> PseudorandomArray k -> [(Natural, Natural)] -> Property
agree on array offsets = case mask offsets of
  Left _ -> property Discard
  Right m -> case (prove (ArrayOn on array) m, toGrid array) of
    (Right (verdict, _), Right grid) ->
      let r = windowRank array m
          n = fromIntegral (primitiveDegree (arrayPrimitive array))
          expected = if r == n then area (arrayShape array) else fromIntegral (fieldOrder array) ^ r
       in counterexample (show verdict) $
            fmap differentWindows (enumerate on grid m) === Right expected
              .&&. proved verdict === (r == n)
              .&&. fmap
                (\(a, b) -> windowAt (ArrayOn on array) m a == windowAt (ArrayOn on array) m b)
                (collision verdict)
                =/= Just False
              .&&. isJust (collision verdict) === not (proved verdict)
    (Left e, _) -> counterexample (show e) False
    (_, Left e) -> counterexample (show e) False

genMask :: Gen [(Natural, Natural)]
genMask = do
  count <- choose (1, 6 :: Int)
  nub
    <$> vectorOf
      count
      ((\i j -> (fromInteger i, fromInteger j)) <$> choose (0, 16) <*> choose (0, 18))
