{-# OPTIONS_GHC -O1 #-}

-- | Whether frames contradict each other, against the definition, which is stated here once more
-- and asked on both sides of where its answer changes.
module Test.Touch.Registration.Contradictions (spec) where

import Data.List (maximumBy)
import Data.Maybe (fromMaybe)
import Data.Ord (comparing)
import PraTactile.Composite (Contradiction (..))
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Composite.Noise (frameNoise)
import PraTactile.Image
import PraTactile.Image.Correlate
import PraTactile.Registration.Agreement (contradiction)
import PraTactile.Registration.Neighbours (Neighbours (..), neighboursAround)
import PraTactile.Registration.Search
import PraTactile.Sensor.Frame (Pose (..))
import PraTactile.Sensor.Manifest (Axes, alongAxes, axesNamed, straight)
import Test.Effort (byEffort, withCases)
import Test.Hspec
import Test.QuickCheck hiding (generate, sample)
import Test.Touch.Image.RastersAndCorrelation (genRasterOf)

spec :: Spec
spec =
  withCases 4 60
    . it "frames contradict each other as defined, to where the answer changes"
    $ forAllBlind genMixed $ \(settings, frames) ->
      let answer = defined settings . frames
          (near, far) = changing answer
       in counterexample (show (near, answer near, far, answer far)) $
            label (show (answer near) ++ ", " ++ show (answer far)) $
              map (contradiction settings . frames) [near, far]
                === map answer [near, far]
  where
    -- A share from 0 to 1 and one next to it for which the answer is another, if there are such.
    changing answer
      | answer 0 == answer 1 = (0, 1)
      | otherwise = closer (byEffort 12 30 :: Int) (0, 1)
      where
        closer n (a, b)
          | n <= 0 = (a, b)
          | answer middle == answer a = closer (n - 1) (middle, b)
          | otherwise = closer (n - 1) (a, middle)
          where
            middle = (a + b) / 2 :: Double

-- | Frames of one relief at their places along some axes, or of a relief each, which turn into
-- another or fade.
genMixed :: Gen (Registration, Double -> [(Taxels, Raster)])
genMixed = do
  side <- choose (7, 13)
  extent <- choose (3, side)
  count <- frequency [(6, choose (3, 12)), (1, pure 40), (1, choose (66, 70))]
  scene <- genRelief (extent + side)
  places <- vectorOf count ((,) <$> choose (0, extent) <*> choose (0, extent))
  others <- vectorOf count (genRelief side)
  axes <- frequency [(2, pure straight), (3, elements (map snd axesNamed))]
  offset <- (,) <$> choose (-0.4, 0.4) <*> choose (-0.4, 0.4)
  (one, fading) <- elements [(True, False), (True, False), (True, True), (False, True)]
  sigma <- elements [0.2, 0.7, 1, 2, 3.5]
  noise <- elements [0, 0, 0, 0.05, 0.05, 0.3]
  let seen share (x, y) other =
        generate side side $ \i j ->
          let here = if one then at scene (x + i) (y + j) else at other i j
           in (1 - share) * here + if fading then 0 else share * at other i j
      frames share = [(told axes offset p, seen share p other) | (p, other) <- zip places others]
  pure (standardRegistration {registrationSigma = Just sigma, registrationNoise = noise}, frames)
  where
    at image i j = fromMaybe 0 (index image i j)
    told axes (u, v) (x, y) =
      let Pose x' y' _ = alongAxes axes (Pose (fromIntegral x + u) (fromIntegral y + v) 0)
       in (x', y')

-- | Relief that changes across three pixels.
genRelief :: Int -> Gen Raster
genRelief side = do
  coarse <- referenceOf <$> genRasterOf (side `div` 3 + 2) (side `div` 3 + 2)
  let third t = fromIntegral t / 3
  pure (generate side side (\x y -> maybe 0 fst (referenceAt coarse (third x) (third y))))

-- | The definition: of pairs side by side and of those one below the other, 16 each of those that
-- lie two taxels apart and overlap by an eighth of a frame and 45 % of what the most do, around 64
-- frames; of each the
-- displacement of the whole taxels within two standard deviations of the robot's that is most
-- probable; over all, how much less each varies from the other than by itself.
defined :: Registration -> [(Taxels, Raster)] -> Maybe Contradiction
defined settings frames
  | toldBest > toldGiven + 100 + toldGiven / 12,
    toldBest >= couldBest / 2 =
    Just (AgreeingAlong axes)
  | couldGiven > 60, toldGiven < 0.3 * couldGiven = Just AgreeingNowhere
  | otherwise = Nothing
  where
    (toldGiven, couldGiven) = along straight
    ((toldBest, couldBest), axes) =
      maximumBy (comparing (fst . fst)) [(along a, a) | (_, a) <- axesNamed, a /= straight]
    along :: Axes -> (Double, Double)
    along a =
      telling (map shared (chosen (filter far (neighboursAround 64 (map (moved a) frames)))))
    moved a ((x, y), shown) = let Pose x' y' _ = alongAxes a (Pose x y 0) in ((x', y'), shown)
    chosen found =
      concat
        [ evenly 16 [n | n <- some, neighboursShare n >= max 0.125 (0.45 * most)]
          | some <- [filter beside found, filter (not . beside) found],
            let most = maximum (map neighboursShare some)
        ]
    far found = let (x, y) = neighboursStep found in max (abs x) (abs y) >= 2
    beside found = let (x, y) = neighboursStep found in abs x > abs y
    evenly :: Int -> [a] -> [a]
    evenly most xs =
      let places = [(k * most) `div` length xs | k <- [0 .. length xs - 1]]
          firsts = zipWith (/=) places (-1 : places)
       in if length xs <= most then xs else map fst (filter snd (zip xs firsts))
    -- What is told, and what could be told at most.
    telling pairs
      | varying <= 0 || apart <= 0 = (0, 0)
      | otherwise =
        (0.2 * pixels * log (varying / apart), -0.2 * pixels * log (1 - likeness * likeness))
      where
        pixels = sum [n | (n, _, _) <- pairs]
        varying = sum [n * v | (n, v, _) <- pairs]
        apart = sum [n * v * (1 - rho * rho) | (n, v, rho) <- pairs]
        likeness = max 0 (min 0.85 (1 - (noise * noise + 1e-6) * pixels / varying))
    noise = max (registrationNoise settings) (frameNoise (map snd frames))
    -- How many pixels two frames share at their most probable displacement, how much these vary,
    -- and how much they resemble each other.
    shared (Neighbours k l (x, y) _) = (n, (va + vb) / 2 + 1e-6, rho)
      where
        Overlap n va vb cov =
          snd . maximumBy (comparing fst) $
            [ (0.4 * logLikelihood settings overlap - squares / (4 * sigma * sigma), overlap)
              | j <- [-9 .. 9],
                i <- [-9 .. 9],
                let squares = i * i + j * j,
                squares <= reach * reach,
                let overlap =
                      overlapAt (referenceOf (image k)) (image l) (nearest x + i) (nearest y + j)
            ]
        rho = max 0 cov / sqrt ((va + 1e-6) * (vb + 1e-6))
    image k = snd (frames !! k)
    nearest t = fromIntegral (round t :: Int) :: Double
    sigma = supposedSigma settings
    reach = max 1 (min 9 (2 * sqrt 2 * sigma))
