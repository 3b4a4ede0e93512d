-- | Tests the search for a frame's displacement, and its assumptions, against their definitions.
module Test.Touch.Registration.SearchByDefinition (spec) where

import Data.List (foldl')
import Data.Maybe (fromMaybe)
import PraTactile.Image
import PraTactile.Image.Correlate
import PraTactile.Registration.Correlation
import PraTactile.Registration.Pair.Alike (agreements)
import PraTactile.Registration.Settings
import Test.Effort (withCases)
import Test.Hspec
import Test.QuickCheck hiding (generate, sample)
import Test.Touch.Image.RastersAndCorrelation (genRasterOf)

spec :: Spec
spec = withCases 12 100 $ do
  describe "The assumptions of registration" settingsSpec
  describe "The most probable displacement" searchSpec
  describe "Other places" otherSpec

settingsSpec :: Spec
settingsSpec = do
  it "are an unknown error, noise of 0.1, 4.5 standard deviations, five sweeps" $
    standardRegistration `shouldBe` Registration Nothing 0.1 4.5 5
  it "take an unknown error from half a taxel to a quarter pitch, and a known one up to twice" $
    [ (sigmasFor settings, supposedSigma settings)
      | told <- [Nothing, Just 0.5, Just 3, Just 5],
        let settings = standardRegistration {registrationSigma = told}
    ]
      `shouldBe` [((0.5, 4), 1), ((0.25, 1), 0.5), ((1.5, 4), 3), ((2.5, 5), 5)]
  it "are valid if the deviation is positive, nothing is negative, and the search is within 64" $
    [ (sigma, noise, reach)
      | sigma <- [-1, 0, 1e-300, 1, 16, 1 / 0, 0 / 0],
        noise <- [-0.1, 0, 0.1, 7, 1 / 0, 0 / 0],
        reach <- [-0.5, -1e-9, 0, 4, 4.01, 64, 64.01, 0 / 0],
        usable (Registration (Just sigma) noise reach 5)
    ]
      `shouldBe` [ (sigma, noise, reach)
                   | sigma <- [1e-300, 1, 16],
                     noise <- [0, 0.1, 7],
                     reach <- [0, 4, 4.01, 64, 64.01],
                     sigma * reach <= 64
                 ]

-- | A reference and an image that is a part of it with some noise, the part's place, the robot's
-- certainty of a place near it, and a start near that place with the range of the search.
data Sought = Sought
  { soughtReference :: Reference,
    soughtImage :: Raster,
    soughtPrior :: Prior,
    soughtRadius :: Double,
    soughtStart :: (Double, Double)
  }

genSought :: Gen Sought
genSought = do
  scene <- genRasterOf 12 11
  rough <- genRasterOf 6 5
  noise <- elements [0, 0.2, 1]
  (x, y) <- (,) <$> choose (2, 4) <*> choose (2, 4)
  near <- (,) <$> choose (-1, 1) <*> choose (-1, 1)
  start <- (,) <$> elements [0, 0.125, -0.25] <*> elements [0, 0.5]
  let there = referenceOf scene
      pixel u v =
        maybe 0 fst (referenceAt there (x + fromIntegral u) (y + fromIntegral v))
          + noise * fromMaybe 0 (index rough u v)
  radius <- elements [1, 1.5, 2.5]
  variance <- elements [0.25, 1, 4]
  let image = generate 6 5 pixel
      centre = (fromIntegral (round x :: Int) + fst near, fromIntegral (round y :: Int) + snd near)
  pure
    ( Sought
        there
        image
        (Prior centre variance)
        radius
        (fst centre + fst start, snd centre + snd start)
    )

-- | The log-likelihood of an overlap at a displacement, the overlap counting no more than at the
-- start, and the log prior.
terms :: Registration -> Sought -> (Double, Double) -> (Double, Double)
terms settings sought d =
  ( logLikelihood
      (max 1e-9 (registrationNoise settings ^ (2 :: Int)))
      (at d) {overlapWeight = min (weight start) (weight d)},
    logPrior (soughtPrior sought) d
  )
  where
    start = soughtStart sought
    weight = overlapWeight . at
    at = overlapOf sought

overlapOf :: Sought -> (Double, Double) -> Overlap
overlapOf sought = uncurry (overlapAt (soughtReference sought) (soughtImage sought))

searchSpec :: Spec
searchSpec = do
  it
    "is the best whole taxel within the radius, then refined by 1/2, 1/4 and 1/8, x before y"
    $ forAllBlind genSought $ \sought ->
      let settings = standardRegistration
          score d = uncurry (+) (terms settings sought d)
          radius = soughtRadius sought
          start@(x0, y0) = soughtStart sought
          whole =
            start :
              [ d
                | j <- [-5 .. 5],
                  i <- [-5 .. 5],
                  let d = (x0 + i, y0 + j),
                  i * i + j * j <= radius * radius
              ]
          refined d step = foldl' (beside step) d [(1, 0), (0, 1)]
          beside step (x, y) (i, j) =
            best [(x, y), (x - i * step, y - j * step), (x + i * step, y + j * step)]
          best = snd . maximumOfFirst score
          wanted = foldl' refined (best whole) [0.5, 0.25, 0.125]
       in mostProbable settings (overlapOf sought) (soughtPrior sought) radius start === wanted
  where
    -- The first of the greatest.
    maximumOfFirst score ds =
      foldl' (\a b -> if fst b > fst a then b else a) (-1 / 0, (0, 0)) [(score d, d) | d <- ds]

otherSpec :: Spec
otherSpec = do
  it "on a plane, which is equal everywhere but for its level, are all within the search" $
    forAll ((,) <$> choose (-3, 3) <*> choose (-3, 3)) $ \(dx, dy) ->
      forAll (elements [0, 1, 2]) $ \search ->
        let plane = generate 9 9 (\x y -> 0.1 * fromIntegral x + 0.07 * fromIntegral y)
            line t = map fromIntegral [t - search .. t + search :: Int]
         in agreements (fromIntegral dx, fromIntegral dy) (fromIntegral search) plane plane
              === [(x, y) | y <- line dy, x <- line dx]
