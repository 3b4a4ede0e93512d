-- | Tests whether an image shows one of the shapes or another shape.
module Test.Touch.Classification.OtherShapes (spec) where

import Data.Foldable (for_)
import qualified Data.Vector.Storable as V
import PraTactile.Classification.Estimate
import PraTactile.Classification.FreeForm
import PraTactile.Classification.Reader
import PraTactile.Classification.Shipped
import PraTactile.Image
import PraTactile.Shape
import PraTactile.Shape.Design (foreignShapes)
import PraTactile.Symmetry
import Test.Hspec
import Test.QuickCheck hiding (generate)
import Test.Support
import Test.Touch.Image.RastersAndCorrelation (genRasterOf)

spec :: Spec
spec = do
  it "no drawing of a third to two thirds of the blocks fits an image better than the free shape" $
    forAllBlind (genRasterOf 8 12) $ \image ->
      forAllBlind genDrawing $ \blocks ->
        counterexample (show (correlated image (drawn blocks), freeFormCorrelation image)) $
          correlated image (drawn blocks) <= freeFormCorrelation image + 1e-9
  it "an image of a drawing, of any gain and offset, is the free shape" $
    forAllBlind genDrawing $ \blocks ->
      forAll ((,) <$> choose (0.1, 9) <*> choose (-3, 3)) $ \(gain, offset) ->
        let free = freeFormCorrelation (mapRaster (\v -> gain * v + offset) (drawn blocks))
         in counterexample (show free) (abs (free - 1) < 1e-9)
  it "a symbol's own image is surely not another shape; an image of another shape surely is" $ do
    reader <- right (shippedReader 4)
    let known = readerAlphabet reader
        unlike =
          fmap estimateForeignShape
            . estimate (readerCalibration reader) (readerTemplates reader) (readerNetwork reader)
    others <- right (foreignShapes 5 24 12 known)
    for_ (shapes known) $ \shape ->
      for_ [identity, turned 2] $ \turn ->
        unlike (onRaster turn (toRaster shape)) `shouldSatisfy` either (const False) (< -3)
    for_ (shapes others) $ \shape ->
      unlike (toRaster shape) `shouldSatisfy` either (const False) (> 0)
  where
    genDrawing = do
      count <- choose (8, 16)
      take count <$> shuffle [0 .. 23 :: Int]
    drawn blocks =
      generate 8 12 (\x y -> if 4 * (y `div` 2) + x `div` 2 `elem` blocks then 1 else 0)

-- | The correlation coefficient, by its definition; 0 if either image is constant.
correlated :: Raster -> Raster -> Double
correlated a b = if va * vb <= 0 then 0 else V.sum (V.zipWith (*) a' b') / sqrt (va * vb)
  where
    (a', b') = (centred a, centred b)
    (va, vb) = (squares a', squares b')
    centred image =
      let values = rasterValues image
       in V.map (subtract (V.sum values / fromIntegral (V.length values))) values
    squares = V.sum . V.map (\v -> v * v)
