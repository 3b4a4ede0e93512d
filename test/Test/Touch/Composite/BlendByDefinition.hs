-- | Tests blending and the growth of a composite, each against its definition.
module Test.Touch.Composite.BlendByDefinition (spec) where

import Data.Maybe (fromMaybe)
import PraTactile.Composite.Blend
import PraTactile.Image
import PraTactile.Image.Correlate (Reference, overlapAt, reference)
import PraTactile.Registration hiding (assemble)
import PraTactile.Registration.Correlation
import PraTactile.Registration.Settings
import PraTactile.Sensor.Frame
import Test.Effort (withCases)
import Test.Hspec
import Test.QuickCheck hiding (generate)
import Test.Touch.Image.RastersAndCorrelation (genRasterOf)
import Test.Touch.Paper (assemble)

spec :: Spec
spec = do
  describe "Blending" blending
  describe "Growing" growing

blending :: Spec
blending = do
  it "a pixel of each image counts for a pixel of the grid by 1 - distance along x and along y" $
    forAll genSize $ \(w, h) -> forAll (choose (0, 3) >>= (`vectorOf` genPlaced)) $ \images ->
      let Blend sums weights = blend w h images
          close a b =
            counterexample (show (toRows a, toRows b)) $
              rasterSize a === rasterSize b
                .&&. either (const False) (maybe True (< 1e-9) . maximumValue) (differences a b)
       in close sums (defined w h id images) .&&. close weights (defined w h (const 1) images)
  it "images far from the grid are dropped, however far they are" $
    [ toRows (blendWeights (blend 3 2 [(place, constant 2 2 1)]))
      | far <- [3, 1e8, 1e9, 1e18, 1e300, 1 / 0, 0 / 0],
        place <- [(far, 0), (0, far), (-far, 0), (0, -far), (far, -far)]
    ]
      `shouldSatisfy` all (== replicate 2 (replicate 3 0))
  it "a dead taxel counts 0.02 of a living one in the mean, and half of one in the coverage" $
    forAll (choose (1, 3) >>= (`vectorOf` genFrame)) $ \frames ->
      case placeOnly frames of
        Left e -> counterexample (show e) False
        Right composite ->
          let (ox, oy) = compositeOrigin composite
              pixels =
                [ (x, y)
                  | y <- [0 .. rasterHeight (compositeImage composite) - 1],
                    x <- [0 .. rasterWidth (compositeImage composite) - 1]
                ]
           in conjoin
                [ counterexample (show (x, y)) $
                    near image (meanOr image) .&&. near coverage covered
                  | (x, y) <- pixels,
                    let at' = (ox / taxelPitch + fromIntegral x, oy / taxelPitch + fromIntegral y)
                        told = concatMap (tellingOf at') frames
                        weight = sum [share * worth 0.02 dead | (share, dead, _) <- told]
                        values = sum [share * worth 0.02 dead * v | (share, dead, v) <- told]
                        covered = sum [share * worth 0.5 dead | (share, dead, _) <- told]
                        -- With next to no coverage 0, or up to rounding any value.
                        meanOr v
                          | weight < 0.0009 = 0
                          | weight < 0.0011 = v
                          | otherwise = values / weight,
                    Just image <- [index (compositeImage composite) x y],
                    Just coverage <- [index (compositeCoverage composite) x y]
                ]
  where
    near a b = counterexample (show (a, b)) (abs (a - b) < 1e-3)
    worth least dead = if dead then least else 1 :: Double
    genFrame = do
      image <- genRasterOf 6 4
      pose <- SensorPose <$> choose (-8, 8) <*> choose (-8, 8) <*> elements [0, 90, 180, 270]
      dead <- listOf ((,) <$> choose (0, 3) <*> choose (0, 5))
      pure (Frame pose 1 image taxelPitch dead)
    -- The taxels that cover a place, in taxels: the share of each, whether it is dead, and its
    -- value.
    tellingOf (px, py) (Frame (SensorPose x y r) _ image _ dead) =
      [ (share, (j, i) `elem` dead, v)
        | i <- [0 .. 5],
          j <- [0 .. 3],
          let (c, s) = (cos (r * pi / 180), sin (r * pi / 180))
              (u, w) = (fromIntegral i - 2.5, fromIntegral j - 1.5)
              share =
                left (x / taxelPitch + c * u - s * w) px * left (y / taxelPitch + s * u + c * w) py,
          share > 0,
          Just v <- [index image i j]
      ]
    genSize = (,) <$> choose (-1, 6) <*> choose (-1, 6)
    genPlaced = do
      w <- choose (0, 4)
      h <- choose (0, 4)
      (,) <$> ((,) <$> coordinate <*> coordinate) <*> genRasterOf w h
    coordinate = oneof [choose (-6, 8), fromIntegral <$> choose (-6, 8 :: Int)]
    differences = zipRaster (\a b -> abs (a - b))
    defined w h value images =
      generate w h $ \x y ->
        sum
          [ left (px + fromIntegral i) (fromIntegral x)
              * left (py + fromIntegral j) (fromIntegral y)
              * value v
            | ((px, py), image) <- images,
              i <- [0 .. rasterWidth image - 1],
              j <- [0 .. rasterHeight image - 1],
              Just v <- [index image i j]
          ]
    left place x = max 0 (1 - abs (place - x)) :: Double

-- | With k agreeing frames placed, the next one's displacement less the mean of theirs is its own
-- error less the mean of k others. These are independent, each with variance sigma^2, so it has
-- variance sigma^2 (1 + 1/k).
growing :: Spec
growing =
  withCases 7 60 $
    it "the frame after k agreeing ones is placed by a prior of variance sigma^2 (1 + 1/k)" $
      forAll ((,) <$> choose (2, 5) <*> choose (0.3, 1.5)) $ \(k, sigma) ->
        forAll ((,) <$> genRasterOf 16 16 <*> genRasterOf 16 16) $ \(strong, texture) ->
          -- Faint, so that prior and likelihood both count.
          forAll ((,) <$> choose (0.05, 0.4) <*> choose (4, 9)) $ \(contrast, overlap) ->
            let faint = mapRaster (* contrast) texture
                settings =
                  standardRegistration {registrationSigma = Just sigma, registrationSweeps = 0}
                at x = SensorPose (taxelPitch * fromIntegral (x :: Int)) 0 0
                apart = 16 - overlap
                frames =
                  Frame (at apart) 1 faint taxelPitch [] :
                  replicate k (Frame (at 0) 1 strong taxelPitch [])
                moved = compositeDisplacements . assemblyComposite
             in case moved <$> assemble Incremental settings frames of
                  Right ((x, y) : others@((x', y') : _)) ->
                    counterexample (show others) (all (== (x', y')) others)
                      .&&. (x - x', y - y') === expected settings k strong faint apart
                  other -> counterexample (show other) False
  where
    expected settings k strong faint apart =
      mostProbable
        settings
        ( \(x, y) ->
            overlapAt
              (agreed k strong)
              faint
              (x + fromIntegral (apart + border))
              (y + fromIntegral border)
        )
        (Prior (0, 0) (sigma * sigma * spread))
        (sqrt spread * registrationReach settings * sigma)
        (0, 0)
      where
        sigma = supposedSigma settings
        spread = 1 + 1 / fromIntegral k
    -- The mean of k frames, each pixel with the weight k / (1 + k), and nothing around it.
    agreed :: Int -> Raster -> Reference
    agreed k image =
      fromMaybe (error "two sizes") $
        either (const Nothing) Just $
          reference (framed (mapRaster (* share) image)) (framed (mapRaster (const share) image))
      where
        share = fromIntegral k / (1 + fromIntegral k)
        framed r =
          generate
            (16 + 2 * border)
            (16 + 2 * border)
            (\x y -> fromMaybe 0 (index r (x - border) (y - border)))
    border = 30
