-- | Tests composites with little relief that lies far apart: they take memory and time for the
-- touched pixels only, and give the results of the full rectangle.
module Test.Touch.Segmentation.FeltFarApart (spec) where

import Control.Exception (evaluate)
import Data.Either (isRight)
import qualified Data.IntSet as IntSet
import Data.List (sort)
import qualified Data.Vector.Storable as V
import PraTactile.Classification.Shipped (shippedReader)
import PraTactile.Composite (weighted)
import PraTactile.Composite.Skew (setUpright)
import PraTactile.Image
import PraTactile.Image.Correlate (referenceAt)
import PraTactile.Recognise.Features (features)
import PraTactile.Registration
import PraTactile.Segmentation.Masked
import PraTactile.Segmentation.Region
import PraTactile.Sensor.Frame
import PraTactile.Symmetry
import Test.Effort (byEffort, withCases)
import Test.Hostile.Judgement (withinBounds)
import Test.Hspec
import Test.QuickCheck hiding (generate, sample)

spec :: Spec
spec = do
  withCases 1 3 rasterSpec
  withCases 2 4 turnedSpec
  it "six frames of stripes, one of them thirty metres away, take two seconds, 300 MB at most" $ do
    composite <- composed [(0, 0), (12.7, 0), (25.4, 0), (0, 12.7), (12.7, 12.7), (3e4, 0)]
    reader <- either (fail . show) pure (shippedReader 4)
    found <- withinBounds (evaluate (length (show (features reader composite))))
    found `shouldSatisfy` isRight
  it "symbols' pixels far apart are connected like those in a small field" $ do
    let far = maskedAs (1000000, 1000000) V.empty V.empty
        here = maskedAs (9, 9) V.empty V.empty
        marks = [0, 1, 10, 13, 22, 40, 42, 80]
        -- The pixels in the middle of the large field, and again far from there.
        on field (x, y) p = let (u, v) = placeOf here p in (y + v) * maskedWidth field + x + u
        wanted = map sort (components here 0 marks)
        places = [(500000, 17), (20, 900000)]
    map sort (components far 0 (concat [map (on far place) marks | place <- places]))
      `shouldBe` [sort (map (on far place) region) | place <- places, region <- wanted]

-- | Large images with few nonzero pixels obey the laws of all images.
rasterSpec :: Spec
rasterSpec =
  it "a large image of which few pixels are kept equals the full image" $
    forAll (IntSet.fromList <$> listed (choose (0, w * h - 1))) $ \some ->
      let numbers = V.fromList (IntSet.toAscList some)
          value x y = fromIntegral (x + 2 * y + 1)
          few = generateAt w h numbers value
          full = generate w h (\x y -> if IntSet.member (y * w + x) some then value x y else 0)
          places = [(x + 0.25, y - 0.5) | x <- [-1, 7, fromIntegral w - 1], y <- [0, 9]]
       in conjoin
            [ few === full,
              conjoin [onRaster o few === onRaster o full | o <- someTurns],
              mapRaster (+ 1) few === mapRaster (+ 1) full,
              zipRaster (\a b -> a - 2 * b + 1) few few
                === zipRaster (\a b -> a - 2 * b + 1) full full,
              zipRaster (-) few full === Right (constant w h 0),
              map (uncurry (sample few)) places === map (uncurry (sample full)) places,
              pixelsWhere (> 0) few === numbers,
              pixelsWhere (<= 0) few === pixelsWhere (<= 0) full,
              valuesAt few numbers === valuesAt full numbers,
              toRows few === toRows full
            ]
  where
    (w, h) = (1500, 800)
    -- A single case would have no pixel.
    listed = byEffort (resize 60 . listOf1) listOf
    -- One that exchanges the axes, and one that does not.
    someTurns = byEffort [turned 1, turned 2] symmetries

-- | A composite with relief far apart, set upright.
turnedSpec :: Spec
turnedSpec = do
  composite <- runIO (composed [(0, 0), (300, 2000), (2000, 300)])
  let known = weighted composite
  it "set upright, each pixel shows what was felt at its place, and nothing elsewhere" $
    forAll (choose (-45, 45)) $ \angle ->
      let (upright, back) = setUpright angle composite
          image = compositeImage upright
          felt = V.toList (pixelsWhere (> 0) (compositeCoverage upright))
          (w, h) = rasterSize image
          shown (x, y) = (index image x y, index (compositeCoverage upright) x y)
          wanted (x, y) =
            maybe
              (Just 0, Just 0)
              (\(v, m) -> (Just v, Just m))
              (uncurry (referenceAt known) (back (fromIntegral x, fromIntegral y)))
          near = [p + d | p <- felt, d <- [0, 1, -1, w, negate w], p + d >= 0, p + d < w * h]
          places = [(x, y) | p <- near, let (y, x) = p `quotRem` w]
       in counterexample (show (w, h)) $
            length felt > 600 .&&. map shown places === map wanted places

-- | Frames of stripes, in the direction of 30 degrees, at these places in millimetres, placed
-- without registration.
composed :: [(Double, Double)] -> IO Composite
composed = either (fail . show) pure . placeOnly . map frame
  where
    frame (x, y) = Frame (SensorPose x y 0) 1 (generate 16 16 stripes) taxelPitch []
    stripes x y = (1 + sin (0.75 * sqrt 3 * fromIntegral y - 0.75 * fromIntegral x)) / 2
