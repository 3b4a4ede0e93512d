{-# OPTIONS_GHC -O1 #-}

-- | Tests the angle of a lattice under frames, found from any likelihoods of frames at any angle,
-- against its definition.
module Test.Touch.Registration.AngleByDefinition (spec) where

import Data.List (find, genericLength, maximumBy, sortOn)
import Data.Ord (Down (..), comparing)
import PraTactile.Image
import PraTactile.Registration.Lattice.Angle
import PraTactile.Registration.Lattice.Fit (Fit (..), Fits (..))
import PraTactile.Registration.Spectrum
import Test.Effort (withCases)
import Test.Hspec
import Test.QuickCheck hiding (generate)
import Test.Touch.Image.RastersAndCorrelation (genRasterOf)

spec :: Spec
spec =
  withCases 25 200 $
    it "the angle is found as defined for any likelihoods, until there is none" $
      forAllBlind genTold $ \(images, roughly, finely) ->
        forAll (choose (0, 4) >>= \n -> vectorOf n (choose (-45, 45))) $ \hints ->
          let wanted level = defined (spectra 5 5) hints images roughly (map (above level) finely)
              found level =
                fitsAngle
                  <$> latticeAngle
                    (toldAt roughly (map (above level) finely))
                    (spectra 5 5)
                    hints
                    images
              above level told a = level + told a
              levels = closer (40 :: Int) wanted (-200, 200)
              alike (Just a) (Just b) = abs (a - b) < 1e-9
              alike a b = a == b
           in label (maybe "none" (\a -> if a == 0 then "upright" else "an angle") (wanted 200)) $
                conjoin
                  [ counterexample (show (found level, wanted level)) $
                      alike (found level) (wanted level)
                    | level <- [fst levels, snd levels, 200]
                  ]
  where
    -- Two adjacent levels between which the answer changes.
    closer n answer (a, b)
      | n <= 0 = (a, b)
      | answer middle == answer a = closer (n - 1) answer (middle, b)
      | otherwise = closer (n - 1) answer (a, middle)
      where
        middle = (a + b) / 2 :: Double
    toldAt roughly finely angle =
      Fits
        { fitsAngle = angle,
          fitsTables = error "no table is needed",
          fitsFrames =
            [ Fit (r angle) (f angle) (error "nor what is told") (error "nor all of it") 1
              | (r, f) <- zip roughly finely
            ]
        }

-- | Frames, some of another size, and the likelihood of each at any angle: at whole taxels, and at
-- all places.
genTold :: Gen ([Raster], [Double -> Double], [Double -> Double])
genTold = do
  count <- choose (1, 16)
  images <- (:) <$> genRasterOf 5 5 <*> vectorOf (count - 1) frame
  centre <- oneof [choose (-90, 90), choose (-5, 5)]
  level <- choose (-100, 0)
  tells <- vectorOf count $ do
    own <- (centre +) <$> choose (-6, 6)
    share <- choose (0.1, 1)
    wave <- choose (0, 6)
    depth <- elements [0, 3, 30]
    pure
      ( \a -> level + share * 10 * cos ((a - own) * pi / 90) + depth * sin (a + wave),
        \a -> depth / 9 * sin (a + wave) - share * (min 12 (turns (a - own)) ^ (2 :: Int)) / 8
      )
  pure (images, map fst tells, map snd tells)
  where
    frame = frequency [(8, fainter <$> choose (0, 1) <*> genRasterOf 5 5), (1, genRasterOf 4 6)]
    fainter k = mapRaster (* k)
    -- The rest of an angle up to half turns.
    turns a = let b = a / 180 in 180 * abs (b - fromIntegral (round b :: Int))

-- | The angle by definition. It is upright if that is likelier than other relief and than three
-- degrees to either side. Else it is near the likeliest of three hints and upright, or wherever it
-- is likeliest in steps of nine degrees, if that is likelier than other relief. If five frames at
-- whole taxels do not show it upright, and the first hint at which they show it (or else the
-- likeliest) is far likelier, it is searched near that hint, and upright last.
defined ::
  Spectra ->
  [Double] ->
  [Raster] ->
  [Double -> Double] ->
  [Double -> Double] ->
  Maybe Double
defined processes hints images roughly finely
  | turned = find shown [best lead, elsewhere, 0]
  | shown 0 && fine 5 0 > fine 5 3 && fine 5 0 > fine 5 (-3) = Just 0
  | otherwise = find shown [best (likeliest (0 : asked)), elsewhere]
  where
    turned =
      not (null hints)
        && not (coarselyShown 0)
        && abs lead > 3
        && coarse 5 lead > coarse 5 0 + log 99
    lead = head (filter coarselyShown asked ++ [likeliest asked])
    coarselyShown = shownBy roughly (take 5 telling)
    asked = [likeliest [a, a + 90] | a <- take 3 hints]
    elsewhere = best (settled (likeliest [-90, -81 .. 81]))
    best = nearly0 . folded . uphill (3 :: Int)
    nearly0 a = if abs a <= 1 then 0 else a
    folded a
      | a < -90 = folded (a + 180)
      | a >= 90 = folded (a - 180)
      | otherwise = a
    ofSize = [k | (k, image) <- zip [0 ..] images, rasterSize image == rasterSize (head images)]
    -- Twelve of them, evenly taken; those with most contrast first.
    few = [k | (i, k) <- zip [0 ..] ofSize, n <= 12 || (i * 12) `div` n /= ((i - 1) * 12) `div` n]
    n = length ofSize
    telling = sortOn (Down . standardDeviation . (images !!)) ofSize
    summed told ks a = sum [(told !! k) a | k <- ks]
    coarse count = summed roughly (take count telling)
    fine count = summed finely (take count telling)
    -- Enough for a posterior of a lattice of 0.99; a frame of 25 pixels determines two more numbers
    -- than other relief.
    shown = shownBy finely few
    shownBy told ks a = summed told ks a - genericLength ks * log 25 > others ks + log 99
    -- Any other relief, at least a tenth of which is noise.
    others = sum . map (likely . coefficients)
    likely seen = densityLog (fitTo processes (processOf processes 0.1 [seen]) seen)
    coefficients k = coefficientsOf processes (images !! k)
    likeliest = maximumBy (comparing (\a -> (coarse 5 a, a)))
    -- From there in steps of two degrees, at most three, at whole taxels.
    settled a = foldl looked a [4, 2]
    looked a by = maximumBy (comparing (\b -> (coarse 8 b, b))) [a - by, a, a + by]
    -- In steps of two degrees at all places, three times at most; then to the vertex of a parabola.
    uphill left a
      | left > 0 && below > here = uphill (left - 1) (a - 2)
      | left > 0 && above > here = uphill (left - 1) (a + 2)
      | curve < 0 = a + 2 * max (-0.5) (min 0.5 ((below - above) / (2 * curve)))
      | otherwise = a
      where
        (below, here, above) = (fine 8 (a - 2), fine 8 a, fine 8 (a + 2))
        curve = below + above - 2 * here
