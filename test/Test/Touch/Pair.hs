-- | Registration of pairs: every refusal by construction, and what must change nothing.
module Test.Touch.Pair (spec) where

import Data.Either (isLeft)
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as V
import PraTactile.Image
import PraTactile.Random (normals)
import PraTactile.Shape (Alphabet, embossedAt, paperAlphabet, shapes)
import PraTactile.Stitch.Pair
import System.Random (mkStdGen)
import Test.Hspec

spec :: Spec
spec = do
  it "blank: frames that show nothing" $ refusalOf (const (const 0.3)) `shouldBe` Just Blank
  it "blank: frames that show noise alone" $
    fmap (matchRefusal . found) (Just (noisy 1 (const (const 0)))) `shouldBe` Just (Just Blank)
  it "one axis: a straight edge upright fixes x and not y, and one level y and not x" $ do
    let upright = found (clean (\x _ -> if x < 12 then 0 else 1))
        level = found (clean (\_ y -> if y < 7 then 0 else 1))
    (matchRefusal upright, matchFixed upright) `shouldBe` (Just OneAxis, (True, False))
    (matchRefusal level, matchFixed level) `shouldBe` (Just OneAxis, (False, True))
  it "ambiguous: a pattern that repeats within the search fixes neither axis" $
    refusalOf (\x y -> if even (x `div` 2 + y `div` 2) then 0 else 1) `shouldBe` Just Ambiguous
  it "no overlap: frames further apart than they are wide" $
    fmap matchRefusal (ask (standardPairing (40, 0)) (clean symbols))
      `shouldBe` Right (Just NoOverlap)
  it "symbols are registered to where they are, by each method" $
    [ near (found' method (clean symbols))
      | method <- [Correlation, Blind, Lattice, Auto]
    ]
      `shouldBe` replicate 4 True
  it "what is affine in the grey values of either frame changes nothing" $
    sequence_
      [ close
          (found' method (a, b))
          (found' method (mapRaster (\v -> 3 * v - 1) a, mapRaster (\v -> 0.2 * v + 7) b))
          `shouldBe` True
        | method <- [Correlation, Blind, Lattice],
          let (a, b) = noisy 0.1 symbols
      ]
  it "frames of unequal size, values that are no numbers and senseless settings are refused" $ do
    let (a, b) = clean symbols
    isLeft (withTables (\t -> registerPair t (standardPairing (8, 0)) a (constant 8 8 0)))
      `shouldBe` True
    isLeft (withTables (\t -> registerPair t (standardPairing (8, 0)) a (mapRaster (/ 0) b)))
      `shouldBe` True
    isLeft (ask (standardPairing (0 / 0, 0)) (a, b)) `shouldBe` True
    isLeft (ask (standardPairing (8, 0)) {pairingSearch = -1} (a, b)) `shouldBe` True
  where
    refusalOf = matchRefusal . found . clean
    near match =
      let (x, y) = hypothesisShift (matchBest match)
       in matchRefusal match == Nothing && abs (x - 9) <= 0.75 && abs (y + 1) <= 0.75
    close m n =
      let ((x, y), (x', y')) = (hypothesisShift (matchBest m), hypothesisShift (matchBest n))
       in abs (x - x') < 1e-3 && abs (y - y') < 1e-3
            && abs (hypothesisProbability (matchBest m) - hypothesisProbability (matchBest n))
              < 1e-3

-- | Frames of a relief, the second 9 right and 1 up of the first.
clean :: (Int -> Int -> Double) -> (Raster, Raster)
clean relief = (generate 16 16 relief, generate 16 16 (\x y -> relief (x + 9) (y - 1)))

-- | The same with noise of that standard deviation.
noisy :: Double -> (Int -> Int -> Double) -> (Raster, Raster)
noisy sd relief = (with 0 a, with 256 b)
  where
    (a, b) = clean relief
    (drawn, _) = normals 512 (mkStdGen 5)
    with from image =
      generate 16 16 (\x y -> fromMaybe 0 (index image x y) + sd * drawn V.! (from + y * 16 + x))

-- | Symbols in the middle of cells of 16 x 20 taxels, a class a cell.
symbols :: Int -> Int -> Double
symbols x y = case paperAlphabet of
  Right known -> embossed known
  Left _ -> 0
  where
    (j, u) = (x + 5) `divMod` 16
    (i, v) = (y + 23) `divMod` 20
    embossed :: Alphabet -> Double
    embossed known = case drop ((3 * i + 2 * j) `mod` 4) (shapes known) of
      shape : _ | embossedAt shape (u - 4) (v - 4) -> 1
      _ -> 0

withTables :: (Tables -> Either PairError a) -> Either String a
withTables f = do
  known <- either (Left . show) Right paperAlphabet
  either (Left . show) Right (f (tablesFor known 16 16))

ask :: Pairing -> (Raster, Raster) -> Either String Match
ask pairing (a, b) = withTables (\t -> registerPair t pairing a b)

found :: (Raster, Raster) -> Match
found = found' Auto

found' :: Method -> (Raster, Raster) -> Match
found' method frames =
  either
    (const (Match (Just NoOverlap) (Hypothesis (0, 0) 0) (0, 0) (False, False) Auto []))
    id
    (ask (standardPairing (8, 0)) {pairingMethod = method} frames)
