{-# LANGUAGE RankNTypes #-}
{-# OPTIONS_GHC -O1 #-}

-- | Every folding of every small sequence, against walking along it.
module Test.Code.Array.FoldingsByWalking (spec) where

import Control.Monad (forM_, unless)
import Data.List (nub)
import Data.Proxy (Proxy)
import qualified Data.Vector.Primitive as Primitive
import qualified Data.Vector.Primitive.Mutable as Mutable
import Data.Word (Word8)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Array.Fill
import PraTactile.Grid
import PraTactile.Polynomial
import PraTactile.Sequence
import Test.Code.Generators
import Test.Effort
import Test.Hspec

spec :: Spec
spec = do
  describe "every small factorisation n1 n2 = q^n - 1, over every field" $ do
    it "folds along the diagonal iff gcd (n1, n2) = 1, and then visits each cell once" $
      forM_ (sizesUpTo 4096) $ \(q, n) -> overField q $ \k -> do
        h <- firstOver k n
        forM_ (shapesOf (period h)) $ \shape@(Shape n1 n2) -> do
          let reached = walk shape
          case folded Diagonal shape h of
            Right _ -> (shape, distinct reached) `shouldBe` (shape, Primitive.length reached)
            Left reason -> do
              reason `shouldBe` NotCoprime n1 n2 (gcd n1 n2)
              (shape, distinct reached)
                `shouldBe` (shape, Primitive.length reached `div` fromIntegral (gcd n1 n2))
    it "has a[i mod n1][i mod n2] = s(i), with every primitive polynomial or some" $
      forM_ (sizesUpTo (byEffort 1024 4096)) $ \(q, n) ->
        overField q $ \(_ :: Proxy k) -> do
          found <- right (primitivePolynomials n)
          let coprime =
                [ (shape, walk shape)
                  | shape <- shapesOf (fromIntegral q ^ n - 1),
                    gcd (rows shape) (columns shape) == 1
                ]
          forM_ (spread (byEffort 4 40) (found :: [Primitive k])) $ \h -> do
            let s = codes (sequenceVector h (canonicalState h) (fromIntegral (period h)))
            forM_ coprime $ \(shape, cells) -> do
              grid <- right (folded Diagonal shape h >>= toGrid)
              unless
                (Primitive.backpermute (gridCells grid) cells == s)
                (expectationFailure (show (q, h, shape)))
  describe "larger arrays, wide, tall and square, written block by block" $
    -- In a full run every factorisation.
    forM_ [(2, 16), (3, 11), (4, 9), (5, 7), (8, 6), (9, 5), (251, 2), (256, 2)] $ \(q, n) ->
      it ("GF(" ++ show q ++ "), degree " ++ show n) $
        overField q $ \k -> do
          h <- firstOver k n
          let s = codes (sequenceVector h (canonicalState h) (fromIntegral (period h)))
          forM_ (byEffort threeOf id (coprimeShapes (period h))) $ \shape -> do
            grid <- right (folded Diagonal shape h >>= toGrid)
            unless
              (Primitive.backpermute (gridCells grid) (walk shape) == s)
              (expectationFailure (show (h, shape)))
  where
    coprimeShapes cells = [shape | shape <- shapesOf cells, gcd (rows shape) (columns shape) == 1]
    -- From the widest to the tallest: the widest of several rows, a square one, one column.
    threeOf shapes =
      [shapes !! i | i <- nub [1, length shapes `div` 2, length shapes - 1], i < length shapes]

-- | As many of these at most, from the first one on and evenly among them.
spread :: Int -> [a] -> [a]
spread most xs = [x | (i, x) <- zip [0 ..] xs, i `mod` step == 0]
  where
    step = max 1 ((length xs + most - 1) `div` most)

-- | The orders and degrees with 2 < q^n <= the limit.
sizesUpTo :: Int -> [(Int, Natural)]
sizesUpTo limit =
  [(q, n) | (q, _) <- everyField, n <- takeWhile (\n -> q ^ n <= limit) [1 ..], q ^ n > 2]

-- | All n1 x n2 with this many cells.
shapesOf :: Natural -> [Shape]
shapesOf cells = [Shape n1 (cells `div` n1) | n1 <- [1 .. cells], cells `mod` n1 == 0]

-- | The cells of the diagonal, i mod n1 and i mod n2 for i = 0, 1, 2, ..., each by its index row by
-- row.
walk :: Shape -> Primitive.Vector Int
walk (Shape n1 n2) = Primitive.generate (high * wide) (\i -> (i `mod` high) * wide + i `mod` wide)
  where
    high = fromIntegral n1
    wide = fromIntegral n2

-- | How many different cells there are among them.
distinct :: Primitive.Vector Int -> Int
distinct cells = Primitive.sum (Primitive.map fromIntegral marks)
  where
    marks = Primitive.create $ do
      seen <- Mutable.replicate (Primitive.length cells) (0 :: Word8)
      Primitive.forM_ cells (\cell -> Mutable.write seen cell 1)
      pure seen
