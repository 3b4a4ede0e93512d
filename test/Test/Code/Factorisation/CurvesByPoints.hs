-- | Elliptic curves in Montgomery's form, against addition of points by both their coordinates.
module Test.Code.Factorisation.CurvesByPoints (spec) where

import Control.Monad (forM_)
import PraTactile.Factorisation.EllipticCurve
import Test.Hspec

spec :: Spec
spec = do
  it "the multiples of a point have the x that addition gives them" $
    forM_ (curvesOf (dropWhile (<= 3) (takeWhile (< 120) primes)) 9) $ \(p, c) -> do
      let points = take 150 (multiplesOf p c)
      (p, c, [sameX p (multiple p c k (Point 2 1)) point | (k, point) <- zip [1 ..] points])
        `shouldBe` (p, c, map (const True) points)
  it "so they have modulo a composite number, for each of its prime factors" $
    forM_ [(p, q, c) | (p, q) <- [(101, 103), (11, 1009)], c <- [2 .. 9]] $ \(p, q, c) ->
      forM_ [r | r <- [p, q], regular r c] $ \r -> do
        let points = take 300 (multiplesOf r c)
        (r, c, [sameX r (multiple (p * q) c k (Point 2 1)) point | (k, point) <- zip [1 ..] points])
          `shouldBe` (r, c, map (const True) points)
  it "the second stage shows every order that is a prime from its limit to 50 times that" $
    forM_ [4, 10, 30, 430] $ \limit -> do
      let cases =
            [ (p, c, l)
              | (p, c) <- curvesOf [499, 997, 1499, 1999, 2503] 6,
                l <- [l | l <- dropWhile (< max 106 limit) primes', orderOf p c `mod` l == 0],
                l <= 50 * limit || l > 50 * limit + 210
            ]
          primes' = takeWhile (< 3000) primes
          shown (p, c, l) =
            let order = multiple p c (orderOf p c `div` l) (Point 2 1)
             in secondStage p c limit order `mod` p == 0
      (limit, length cases) `shouldSatisfy` ((> 1) . snd)
      (limit, [(x, shown x) | x <- cases])
        `shouldBe` (limit, [(x, l <= 50 * limit) | x@(_, _, l) <- cases])
  it "a curve finds a factor if its point's order there divides lcm (1 .. 2000), or nearly" $ do
    let (p, q) = (17383, 19997)
        found = map toInteger (take 8 (curveDivisors (fromInteger (p * q))))
        smooth c = product [r | r <- [p, q], foldr lcm 1 [2 .. 2000] `mod` orderOf r c == 0]
    [x | (x, True) <- zip found (cycle [True, False])] `shouldBe` map smooth [2 .. 5]
    -- What is left of an order below 20000 is a prime below 100000.
    [x | (x, True) <- zip found (cycle [False, True])] `shouldBe` replicate 4 (p * q)
  it "30, 75 and 60 curves are tried, and beyond 200 binary digits fewer, as the square of these" $
    forM_ [1, 2, 199, 200, 201, 230, 283, 317, 400, 500, 800, 2000] $ \size -> do
      let affordable n = if size <= 200 then n else max 1 (n * 40000 `div` (size * size))
      (size, length (curveDivisors (2 ^ size - 1)))
        `shouldBe` (size, 2 * sum (map affordable [30, 75, 60]))

-- | The curves modulo these primes, the second to this one.
curvesOf :: [Integer] -> Integer -> [(Integer, Integer)]
curvesOf moduli most = [(p, c) | p <- moduli, c <- [2 .. most], regular p c]

primes :: [Integer]
primes = [n | n <- 2 : [3, 5 ..], all (\d -> n `mod` d /= 0) (takeWhile (\d -> d * d <= n) [2 ..])]

-- | A, of the curve B y^2 = x^3 + A x^2 + x whose (A + 2)/4 is this number.
coefficientA :: Integer -> Integer
coefficientA c = 4 * c - 2

-- | B, if (2, 1) lies on the curve.
coefficientB :: Integer -> Integer
coefficientB c = 8 + 4 * coefficientA c + 2

-- | Whether it is a curve modulo this prime.
regular :: Integer -> Integer -> Bool
regular p c = coefficientB c `mod` p /= 0 && (coefficientA c ^ (2 :: Int) - 4) `mod` p /= 0

-- | P, 2 P, 3 P, ... of P = (2, 1) modulo a prime; 'Nothing' is the neutral element.
multiplesOf :: Integer -> Integer -> [Maybe (Integer, Integer)]
multiplesOf p c = iterate (add (Just (2, 1))) (Just (2, 1))
  where
    (a, b) = (coefficientA c, coefficientB c)
    add Nothing other = other
    add other Nothing = other
    add (Just (x1, y1)) (Just (x2, y2))
      | x1 /= x2 = line ((y2 - y1) * inverseOf p (x2 - x1))
      | (y1 + y2) `mod` p == 0 = Nothing
      | otherwise = line ((3 * x1 * x1 + 2 * a * x1 + 1) * inverseOf p (2 * b * y1))
      where
        line slope =
          let x = (b * slope * slope - a - x1 - x2) `mod` p
           in Just (x, (slope * (x1 - x) - y1) `mod` p)

-- | The order of the point (2, 1).
orderOf :: Integer -> Integer -> Integer
orderOf p c = 1 + fromIntegral (length (takeWhile (/= Nothing) (multiplesOf p c)))

-- | Whether a point is this one, by x = X/Z.
sameX :: Integer -> Point -> Maybe (Integer, Integer) -> Bool
sameX p (Point x z) given = case given of
  Nothing -> z `mod` p == 0 && x `mod` p /= 0
  Just (x', _) -> z `mod` p /= 0 && (x - x' * z) `mod` p == 0

-- | The inverse modulo a prime, by Euclid.
inverseOf :: Integer -> Integer -> Integer
inverseOf p a = go p (a `mod` p) 0 1
  where
    go r s x y
      | s == 0 = x `mod` p
      | otherwise = go s (r `mod` s) y (x - r `div` s * y)
