-- | Tests sums of roots: their values, that they are 0 only if all terms are, their signs, their
-- rounding, and the largest product that is computed.
module Test.Solid.SumsOfRoots (spec) where

import Data.List (foldl')
import Data.Maybe (isJust)
import Data.Ratio ((%))
import PraTactile.Object.Number
import PraTactile.Object.Radicals
import PraTactile.Object.Vector (floorRoot)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  prop "sums and products have the value of the sum and product of their operands' values" $
    forAll ((,) <$> sums <*> sums) $ \(a, b) ->
      conjoin
        [ worth (made a `op` made b) `near` (worth (made a) `by` worth (made b))
          | (op, by) <- [(plus, (+)), (minus, (-)), (product', (*))]
        ]
  prop "(a + b) (a - b) and a a - b b have the same terms" $
    forAll ((,) <$> sums <*> sums) $ \drawn ->
      let (a, b) = (made (fst drawn), made (snd drawn))
       in (plus a b `product'` minus a b) === (product' a a `minus` product' b b)
  prop "the product of the roots of any numbers is the root of their product" $
    forAll ((,) <$> choose (1, 5000) <*> choose (1, 5000)) $ \(m, n) ->
      let root = rootIn (coprimeBase [m, n])
       in product' (root m) (root n) === root (m * n)
  prop "a sum of roots has the sign and the rounding of its value to hundreds of digits" $
    forAll ((,) <$> choose (1, 400) <*> choose (1, 400)) $ \(a, c) ->
      forAll (vectorOf 4 genFraction) $ \parts -> case parts of
        [p, q, r, s] ->
          let long n = floorRoot (fromInteger (n * 10 ^ (800 :: Int))) % 10 ^ (400 :: Int)
              about = p + q * long a + r * long c + s * long (a * c)
              value = if abs about < tiny then 0 else about
              term k n = times k (rootIn (coprimeBase [a, c]) n)
              number = fraction p `plus` term q a `plus` term r c `plus` term s (a * c)
           in conjoin
                [ nearest (fromRational :: Rational -> Double) number === fromRational value,
                  sign number === truncate (signum value),
                  compare number (fraction p) === compare (value - p) 0,
                  maybe True (\exact -> abs (exact - value) < tiny) (asFraction number) === True
                ]
        _ -> property False
  it "a product of more than 4096 pairs of terms is not computed" $ do
    let of' count = Just (summed (map (rootIn (coprimeBase few)) few))
          where
            few = take count squarefree
        given (a, b) = isJust (product' (of' a) (of' b))
    map given [(64, 64), (32, 128), (64, 65), (65, 64), (32, 129)]
      `shouldBe` [True, True, False, False, False]
  where
    base' = coprimeBase [2, 3, 5, 7, 30]
    tiny = 1 / 10 ^ (300 :: Int)
    -- Signs are computed in another way for more than two roots.
    genFraction = frequency [(1, pure 0), (2, (%) <$> choose (-999, 999) <*> choose (1, 99))]
    sums = listOf1 ((,) <$> (fromInteger <$> choose (-9, 9)) <*> choose (1, 210) `suchThat` smooth)
    smooth n = foldl' (\m p -> until ((/= 0) . (`mod` p)) (`div` p) m) n [2, 3, 5, 7] == 1
    made = summed . map (\(q, n) -> times q (rootIn base' n))
    summed = foldr plus (fraction 0)
    squarefree = filter (\n -> all ((/= 0) . mod n . (^ (2 :: Int))) [2 .. isqrt n]) [1 ..]
    isqrt = floor . sqrt . (fromIntegral :: Integer -> Double)

-- | The value as a floating number.
worth :: Radicals -> Double
worth given = sum [fromRational q * sqrt (fromInteger under) | (q, under) <- terms given]

near :: Double -> Double -> Property
near a b = counterexample (show (a, b)) (abs (a - b) <= 1e-9 * (1 + abs a + abs b))
