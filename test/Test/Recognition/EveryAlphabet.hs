-- | Tests the whole way with every shipped alphabet: an array over each field as a plate, pressed
-- and decoded; and what happens if press and decoder use different shapes.
module Test.Recognition.EveryAlphabet (spec) where

import qualified Data.ByteString as Bytes
import Data.Foldable (for_)
import Data.List (elemIndex)
import qualified Data.Text as T
import Numeric.LinearAlgebra (fromRows, toRows)
import PraTactile.Classification.Calibration (Calibration (..))
import PraTactile.Classification.Classifier
import PraTactile.Classification.Estimate
import PraTactile.Classification.Network hiding (Verdict (..), classify)
import PraTactile.Classification.Reader
import PraTactile.Classification.Samples (withNoise)
import PraTactile.Classification.Shipped
import PraTactile.Classification.Specimens
import PraTactile.Evaluate
import PraTactile.Format (decodeProfile)
import PraTactile.Image (onRaster)
import PraTactile.Object.Placement
import PraTactile.Object.Plate
import PraTactile.Pressing
import PraTactile.Profile
import PraTactile.Recognise
import PraTactile.Registration (standardRegistration)
import PraTactile.Sensor
import PraTactile.Shape
import PraTactile.Symmetry
import PraTactile.Truth (truthRegion)
import System.Random (mkStdGen)
import Test.Effort
import Test.Hspec hiding (after, before)
import Test.QuickCheck
import Test.Recognition.Setting
import Test.Support

spec :: Spec
spec = do
  -- A quick run has a field of two elements, one of a prime, and one of a prime's square. The
  -- paper's array is over another.
  for_ (byEffort [2, 7, 9] others) $ \q ->
    it ("presses in corners and along edges are located: GF(" ++ show q ++ ")") . ioProperty $ do
      profile <- shippedProfile q
      symbols <- right (shippedReader q)
      plate <- right (platePlacement (profileShape profile))
      -- With windows of four rows, more of them must be felt.
      let size = if q == 2 then (40, 92) else (40, 52)
      pure (onArray profile plate symbols (`locatedAround` size))
  it "exchanging classes, shapes and outputs alike, exchanges the answers" $
    for_ shippedSizes $ \q -> do
      symbols <- right (shippedReader q)
      let -- The first becomes the last.
          order = [1 .. q - 1] ++ [0]
          given = readerAlphabet symbols
          network' = readerNetwork symbols
      exchanged <-
        right (alphabet [(T.pack (show i), shapes given !! i) | i <- order])
      moved <-
        right . network (hiddenUnits network') . fromRows $
          map (toRows (outputUnits network') !!) order
      let with = (readerOf exchanged moved) {readerCalibration = alike (readerCalibration symbols)}
          alike c = c {classOffsets = map (classOffsets c !!) order}
          told (Reader {readerCalibration = sure, readerTemplates = seen, readerNetwork = net}) =
            estimate sure seen net
          back (c, symmetry) = (order !! c, symmetry)
      for_ (zip [1 ..] (concat (replicate 3 (shapes given)))) $ \(seed, shape) -> do
        let (image, _) = specimen given Upright shape (mkStdGen seed)
        before <- right (told symbols image)
        after <- right (told with image)
        back (estimateLikeliest after) `shouldBe` estimateLikeliest before
        for_ (estimateChances after) $ \(what, chance) ->
          estimateChance before (back what) `shouldSatisfy` \p -> abs (p - chance) < 1e-12
        elemIndex shape (shapes given) `shouldBe` Just (fst (estimateLikeliest before))
  it "an image turned by 180 degrees is read as turned, for each class and both ways up" $
    for_ shippedSizes $ \q -> do
      symbols <- right (shippedReader q)
      let given = readerAlphabet symbols
          told =
            estimate (readerCalibration symbols) (readerTemplates symbols) (readerNetwork symbols)
          over (c, way) = (c, if way == identity then turned 2 else identity)
          shown = [(kind, shape) | kind <- [Upright, Displaced, Halves], shape <- shapes given]
      for_ shown $ \(kind, shape) -> do
        let (image, _) = specimen given kind shape (mkStdGen 7)
        before <- right (told image)
        after <- right (told (onRaster (turned 2) image))
        over (estimateLikeliest after) `shouldBe` estimateLikeliest before
        abs (estimateForeignShape after - estimateForeignShape before) `shouldSatisfy` (< 1e-6)
        for_ (estimateChances after) $ \(what, chance) ->
          estimateChance before (over what) `shouldSatisfy` \p -> abs (p - chance) < 1e-9
  it "a mirror image of a symbol is not recognised, clean or with noise" $
    for_ shippedSizes $ \q -> do
      symbols <- right (shippedReader q)
      let given = readerAlphabet symbols
          images = [across shape | shape <- shapes given, across <- [mirroredColumns, mirroredRows]]
      for_ [(shape, noise) | shape <- images, noise <- [0, 0.1, 0.3]] $ \(shape, noise) -> do
        let (image, g) = specimen given Upright shape (mkStdGen 11)
            (spoilt, _) = withNoise noise image g
        shown <- right (classified (networkClassifier symbols) spoilt)
        (q, noise, classifiedVerdict shown) `shouldSatisfy` \(_, _, v) -> v /= Recognised
  for_ (byEffort (take 1) id [(4, 9), (3, 4), (5, 8)]) $ \(q, other) ->
    it (pressedWith q other ++ " is not read as certain") $ do
      profile <- if q == 4 then pure canonicalProfile else shippedProfile q
      plate <- right (platePlacement (profileShape profile))
      theirs <- right (shippedAlphabet other)
      pressed' <- right (alphabet (take q (zip (shapeNames theirs) (shapes theirs))))
      symbols <- right (shippedReader q)
      let count = byEffort 2 6
          found = onArray profile plate symbols $ \setting@(Setting array _ _ _) ->
            let reader = recogniserOf setting
             in [ withStitching (runTrial standardTolerance reader standardRegistration t)
                  | seed <- [1 .. count],
                    Right (frames, truth) <-
                      [pressed (pressingWith standardSensor seed) pressed' array plate plateName],
                    face <- laidFaces plate,
                    let t = Trial face (truthRegion truth) frames Nothing True
                ]
      length found `shouldBe` count
      [doubt | Mistaken doubt <- found, doubt < 1e-3] `shouldBe` []
  where
    others = filter (/= 4) shippedSizes
    pressedWith q other =
      unwords ["an array over", field q, "pressed with shapes of", field other]
    field q = "GF(" ++ show (q :: Int) ++ ")"

shippedProfile :: Int -> IO Profile
shippedProfile q =
  Bytes.readFile ("data/profiles/gf" ++ show q ++ ".json") >>= right . decodeProfile
