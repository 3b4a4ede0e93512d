-- | Tests the results on placed frames, each against its definition: how much they differ, which of
-- them are connected, and the posterior of all pairs together.
module Test.Touch.Registration.ResidualAndGroups (spec) where

import Data.List (elemIndex, genericLength, nub)
import Data.Maybe (fromMaybe)
import PraTactile.Image
import PraTactile.Registration.Arrangement
import PraTactile.Registration.Groups (groupsOf)
import PraTactile.Registration.Posterior (Hypothesis (..))
import PraTactile.Registration.Residual (residual)
import PraTactile.Registration.Settings (Registration (..), standardRegistration)
import Test.Effort (withCases)
import Test.Hspec
import Test.QuickCheck hiding (generate)
import Test.Touch.Image.RastersAndCorrelation (genRasterOf, genRasterWithin)
import Test.Touch.Registration.Face (arranged)

spec :: Spec
spec = withCases 12 100 $ do
  residualSpec
  groupSpec
  othersSpec

residualSpec :: Spec
residualSpec =
  it "the residual is the deviation of a frame from the mean of all that cover a pixel" $
    forAll (choose (1, 5) >>= (`vectorOf` genPlaced)) $ \placed ->
      let pixels =
            [ ((x + u, y + v), value)
              | ((x, y), image) <- placed,
                u <- [0 .. rasterWidth image - 1],
                v <- [0 .. rasterHeight image - 1],
                Just value <- [index image u v]
            ]
          -- The values of all frames at each pixel that more than one covers.
          seen =
            [ vs
              | p <- nub (map fst pixels),
                vs@(_ : _ : _) <- [[v | (p', v) <- pixels, p' == p]]
            ]
          -- The sum of the squares from the mean over one less than their number is the variance.
          -- It is weighted by the number of frames.
          squares = sum (map apart seen)
          apart vs =
            let n = genericLength vs
             in n / (n - 1) * sum [(v - sum vs / n) ^ (2 :: Int) | v <- vs]
          count = fromIntegral (length (concat seen)) :: Double
          came = residual [((fromIntegral x, fromIntegral y), image) | ((x, y), image) <- placed]
       in counterexample (show came) $ case came of
            Nothing -> null seen
            Just found -> not (null seen) && abs (found - sqrt (squares / count)) < 1e-9
  where
    genPlaced = (,) <$> ((,) <$> place <*> place) <*> genRasterWithin (1, 6)
    place = choose (-5, 5 :: Int)

groupSpec :: Spec
groupSpec = do
  it "groups are connected by overlaps, directly or through others, and numbered in order" $
    forAll (choose (0, 12) >>= (`vectorOf` genPlaced)) $ \placed ->
      let numbered = zip [0 :: Int ..] placed
          meets ((x, y), a) ((x', y'), b) =
            meeting x (rasterWidth a) x' (rasterWidth b)
              && meeting y (rasterHeight a) y' (rasterHeight b)
          -- More than their edges.
          meeting a m b n = min (a + fromIntegral m) (b + fromIntegral n) > max a b
          beside ks = nub (ks ++ [l | k <- ks, (l, b) <- numbered, meets (snd (numbered !! k)) b])
          closed ks = let more = beside ks in if length more == length ks then ks else closed more
          firsts = [minimum (closed [k]) | (k, _) <- numbered]
       in groupsOf placed === [fromMaybe (-1) (elemIndex f (nub firsts)) | f <- firsts]
  it "frames that only touch at an edge or a corner are apart; slightly nearer they are together" $
    [ groupsOf [((0, 0), image), ((x, y), image)]
      | image <- [constant 16 16 0],
        (x, y) <-
          [(16, 0), (0, 16), (-16, 3), (16, 16)]
            ++ [(15.999, 0), (0, 15.999), (-15.999, -15.999)]
    ]
      `shouldBe` replicate 4 [0, 1] ++ replicate 3 [0, 0]
  where
    genPlaced = (,) <$> ((,) <$> place <*> place) <*> genRasterWithin (1, 6)
    place = (/ 2) . fromIntegral <$> choose (-30, 30 :: Int)

othersSpec :: Spec
othersSpec =
  it "relief that repeats along one axis gives other places along it, at least two taxels off" $
    forAll (genRasterOf 40 4) $ \stripes -> forAll (elements [False, True]) $ \upright ->
      let settings = standardRegistration {registrationSigma = Just 2, registrationNoise = 0.05}
          -- Any relief along one axis, repeated every four taxels along the other.
          relief along across = fromMaybe 0 (index stripes along (across `mod` 4))
          seen x y = if upright then relief (x + 4) y else relief (y + 4) x
          frame (dx, dy) = generate 16 16 (\x y -> seen (x + dx) (y + dy))
          step = if upright then (0, 8) else (8, 0)
          place (x, y) = (fromIntegral x, fromIntegral y)
          found =
            arranged ByPairs settings [(place at, frame at) | at <- [(0, 0), step]]
          moves =
            [ (dx - x, dy - y)
              | told <- arrangementFrames found,
                let (x, y) = registeredShift told,
                Hypothesis (dx, dy) _ <- registeredOthers told
            ]
          (alongX, alongY) = unzip moves
          (across', along') = if upright then (alongY, alongX) else (alongX, alongY)
       in counterexample (show moves) $
            not (null moves) && all ((>= 2) . abs) across' && all ((< 2) . abs) along'
