-- | Sums of roots: what they are worth, that they are 0 only where all terms are, and the largest
-- product that is made.
module Test.Solid.SumsOfRoots (spec) where

import Data.List (foldl')
import Data.Maybe (isJust)
import PraTactile.Object.Number
import PraTactile.Object.Radicals
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  prop "sums and products are worth as much as what they are made of" $
    forAll ((,) <$> sums <*> sums) $ \(a, b) ->
      conjoin
        [ worth (made a `op` made b) `near` (worth (made a) `by` worth (made b))
          | (op, by) <- [(plus, (+)), (minus, (-)), (product', (*))]
        ]
  prop "(a + b) (a - b) and a a - b b have the same terms" $
    forAll ((,) <$> sums <*> sums) $ \drawn ->
      let (a, b) = (made (fst drawn), made (snd drawn))
       in terms (plus a b `product'` minus a b) === terms (product' a a `minus` product' b b)
  prop "of any numbers the product of the roots is the root of the product" $
    forAll ((,) <$> choose (1, 5000) <*> choose (1, 5000)) $ \(m, n) ->
      let base = coprimeBase [m, n]
          root k = uncurry radical (rootIn base k)
       in terms (product' (root m) (root n)) === terms (root (m * n))
  it "a product is made of 4096 pairs of terms at most" $ do
    let of' count = Just (summed [radical 1 p | p <- take count squarefree])
        given (a, b) = isJust (product' (of' a) (of' b))
    map given [(64, 64), (2, 2048), (64, 65), (65, 64), (2, 2049)]
      `shouldBe` [True, True, False, False, False]
  where
    base' = coprimeBase [2, 3, 5, 7, 30]
    sums = listOf1 ((,) <$> (fromInteger <$> choose (-9, 9)) <*> choose (1, 210) `suchThat` smooth)
    smooth n = foldl' (\m p -> until ((/= 0) . (`mod` p)) (`div` p) m) n [2, 3, 5, 7] == 1
    made = summed . map (\(q, n) -> let (k, under) = rootIn base' n in radical (q * k) under)
    summed = foldr plus (fraction 0)
    squarefree = filter (\n -> all ((/= 0) . mod n . (^ (2 :: Int))) [2 .. isqrt n]) [1 ..]
    isqrt = floor . sqrt . (fromIntegral :: Integer -> Double)

-- | As a floating number.
worth :: Radicals -> Double
worth given = sum [fromRational q * sqrt (fromInteger under) | (q, under) <- terms given]

near :: Double -> Double -> Property
near a b = counterexample (show (a, b)) (abs (a - b) <= 1e-9 * (1 + abs a + abs b))
