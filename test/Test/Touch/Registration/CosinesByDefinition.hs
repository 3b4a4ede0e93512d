-- | Tests the cosine transform of images and of their patches against its definition.
module Test.Touch.Registration.CosinesByDefinition (spec) where

import qualified Data.Vector.Storable as V
import PraTactile.Image
import PraTactile.Registration.Cosine
import PraTactile.Registration.Definition.Pairs (cosines)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck hiding (generate)

spec :: Spec
spec = do
  prop "of an image are the sums over its pixels with a cosine along each axis" $
    forAll (images 1 9) $ \image ->
      near (cosineTransform (cosinesFor image) image) (V.fromList (map snd (cosines image)))
  prop "of a patch are those of the patch cut out" $
    forAll (images 2 12) $ \image ->
      forAll (stretch (rasterWidth image)) $ \(x, w) ->
        forAll (stretch (rasterHeight image)) $ \(y, h) ->
          let known = cosinesFor image
              cut = generate w h (\i j -> pixel image (x + i) (y + j))
           in near (patchTransform known (strip known image x w) y h) (cosineTransform known cut)
  prop "keep the sum of squares about an image's mean" $
    forAll (images 1 32) $ \image ->
      let values = rasterValues image
          middle = V.sum values / fromIntegral (V.length values)
          squares v = V.sum (V.map (\t -> t * t) v)
       in near
            (V.singleton (squares (cosineTransform (cosinesFor image) image)))
            (V.singleton (squares (V.map (subtract middle) values)))
  it "have at most 32 frequencies along each side" $ do
    let image = generate 40 3 (\i j -> fromIntegral (i * j))
    V.length (cosineTransform (cosinesFor image) image) `shouldBe` 32 * 3 - 1
    highest `shouldBe` 32

cosinesFor :: Raster -> Cosines
cosinesFor image = cosinesUpTo (max (rasterWidth image) (rasterHeight image))

-- | Images with sides between these bounds, and values within 0..1.
images :: Int -> Int -> Gen Raster
images least most = do
  w <- chooseInt (least, most)
  h <- chooseInt (least, most)
  values <- V.fromList <$> vectorOf (w * h) (choose (0, 1))
  pure (generate w h (\i j -> values V.! (j * w + i)))

-- | A part of a side: its start and its length.
stretch :: Int -> Gen (Int, Int)
stretch side = do
  from <- chooseInt (0, side - 1)
  (,) from <$> chooseInt (1, side - from)

pixel :: Raster -> Int -> Int -> Double
pixel image i j = rasterValues image V.! (j * rasterWidth image + i)

near :: V.Vector Double -> V.Vector Double -> Property
near found wanted =
  counterexample (show (found, wanted)) $
    V.length found === V.length wanted
      .&&. V.and (V.zipWith (\a b -> abs (a - b) < 1e-9) found wanted)
