-- | The window property of all arrays up to a size, by both roads.
module Test.Code.Window.ProvedExhaustively (spec) where

import Control.Monad (forM_, when)
import Data.Maybe (isJust)
import Data.Proxy (Proxy)
import Numeric.Natural (Natural)
import PraTactile.Advise.Layout
import PraTactile.Array
import PraTactile.Census
import PraTactile.Factorisation
import PraTactile.Field
import PraTactile.Polynomial
import PraTactile.Window
import PraTactile.Window.Proof
import Test.Code.Generators
import Test.Effort
import Test.Hspec

spec :: Spec
spec = do
  let bits = byEffort 14 20
  describe
    ("every array of n1 = q^k1 - 1 rows and k1 x k2 windows, q^(k1 k2) <= 2^" ++ show (bits :: Int))
    $ forM_ [2, 3, 4, 5, 7, 8, 9, 16] $ \q ->
      it
        ( "over GF("
            ++ show q
            ++ "), by both methods, diagonal if gcd(q^k1 - 1, k2) = 1, else row by row"
        )
        $ overField q $ \k ->
          forM_ (sizes (fromIntegral q) (2 ^ bits)) $ \(k1, k2) ->
            firstOver k (k1 * k2) >>= bothRoads k1 k2
  -- Up to 2^12 these are among the next.
  when (bits > 16) $
    describe ("every primitive polynomial in the same shapes, q^(k1 k2) <= 2^" ++ show (bits - 4)) $
      forM_ [2, 3, 4, 5, 7, 8, 9, 16] $ \q ->
        it ("over GF(" ++ show q ++ ")") $
          overField q $ \k ->
            forM_ (sizes (fromIntegral q) (2 ^ (bits - 4))) $ \(k1, k2) ->
              allOver k (k1 * k2) >>= mapM_ (bothRoads k1 k2)
  let most = byEffort 256 4096
  describe ("every primitive polynomial and every shape, q^n <= " ++ show most) $
    forM_ [2, 3, 4, 5, 7, 8, 9, 16] $ \q ->
      it ("over GF(" ++ show q ++ "): windows that theory guarantees are proved by both methods") $
        overField q $ \k ->
          forM_ (takeWhile (\n -> (fromIntegral q :: Natural) ^ n <= most) [1 ..]) $ \n ->
            everyShape k n
  where
    sizes q bound =
      [ (k1, k2)
        | n <- takeWhile (\n -> q ^ n <= (bound :: Natural)) [1 ..],
          k1 <- [1 .. n],
          k2 <- [1 .. n],
          k1 * k2 == n
      ]

allOver :: KnownField k => Proxy k -> Natural -> IO [Primitive k]
allOver _ n = right (primitivePolynomials n)

-- | The array of a primitive polynomial of degree k1 k2.
bothRoads :: KnownField k => Natural -> Natural -> Primitive k -> Expectation
bothRoads k1 k2 h = do
  let q = fromIntegral (fieldOrder h) :: Natural
      n1 = q ^ k1 - 1
      shape = Shape n1 (period h `div` n1)
      g = gcd n1 k2
  case folded Diagonal shape h of
    Left refusal -> do
      -- (q^n - 1) / (q^k1 - 1) is a sum of k2 powers of q^k1, each 1 modulo q^k1 - 1.
      refusal `shouldBe` NotCoprime (rows shape) (columns shape) g
      g `shouldNotBe` 1
      array <- right (folded RowMajor shape h)
      provedOn TwistedTorus array
    Right array -> do
      g `shouldBe` 1
      provedOn Torus array
  where
    provedOn on array = do
      m <- right (rectangle (Shape k1 k2))
      (verdict, witness) <- right (prove (ArrayOn on array) m)
      ( proved verdict,
        enumeration verdict,
        rankDecision verdict,
        distinctWindows verdict,
        zeroWindow verdict,
        isJust witness
        )
        `shouldBe` (True, Just True, Just True, Just (area (arrayShape array)), Nothing, True)

-- | All arrays of a degree, with the windows that work whatever the polynomial is.
everyShape :: KnownField k => Proxy k -> Natural -> Expectation
everyShape k n = do
  polynomials <- allOver k n
  factors <- right (factorise (q ^ n - 1))
  forM_ polynomials $ \h ->
    forM_ [minBound .. maxBound] $ \folding -> forM_ (scopeShapes folding factors) $ \shape -> do
      array <- right (folded folding shape h)
      forM_ (sureWindows q n (Single folding) shape) $ \window -> do
        m <- right (rectangle window)
        (verdict, _) <- right (prove (ArrayOn (naturalSurface folding) array) m)
        (shape, window, proved verdict, enumeration verdict, rankDecision verdict)
          `shouldBe` (shape, window, True, Just True, Just True)
  where
    q = fromIntegral (fieldOrder k) :: Natural
