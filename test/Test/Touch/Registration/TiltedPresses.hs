{-# OPTIONS_GHC -O1 #-}

-- | Tests tilted presses: the steps of their fit against the formulas summed in full, the plane of
-- frames made by the formula, and the weight of a frame on the lattice.
module Test.Touch.Registration.TiltedPresses (spec) where

import Data.Foldable (for_)
import qualified Data.Map.Strict as Map
import Data.Maybe (isNothing)
import qualified Data.Vector.Storable as V
import PraTactile.Image hiding (mean)
import PraTactile.Registration.Contact
import PraTactile.Registration.Definition (SymbolReadings, drawings, drawn)
import PraTactile.Registration.Lattice.Fit
import PraTactile.Registration.Lattice.Likelihood hiding (eStep, mStep)
import PraTactile.Registration.Lattice.Template (tablesAt)
import PraTactile.Registration.Model
import PraTactile.Registration.Numbers (leastGain, leastVariance)
import Test.Effort (byEffort, withCases)
import Test.Hspec
import Test.QuickCheck hiding (generate)
import Test.Touch.Paper (paperAlphabet, paperTables)
import Test.Touch.Sensor.MeanHeights (embossing)

spec :: Spec
spec = do
  withCases 7 60 stepSpec
  withCases 2 8 planeSpec
  withCases 1 3 weightSpec

-- | The reliefs that a taxel may have.
reliefs :: [Double]
reliefs = [0, 1 / 2, 1]

stepSpec :: Spec
stepSpec = do
  it "log p is the sum over taxels of the log of the mixture over all reliefs" $
    forAll genPress $ \press -> forAllBlind genTaxels $ \taxels ->
      near (fst (eStep press taxels)) (sum (map (log . densityAt press) taxels))
  it "a step has the least squares of all presses that the same taxels and reliefs touch" $
    forAll genPress $ \press -> forAllBlind genTaxels $ \taxels ->
      forAll (vectorOf 4 (choose (-0.1, 0.1))) $ \off ->
        let next = mStep 4 press (snd (eStep press taxels))
            other = case off of
              [a, b, p, q] ->
                next
                  { pressGain = pressGain next + a,
                    pressDepth = pressDepth next + b,
                    pressAcross = pressAcross next + p,
                    pressDown = pressDown next + q
                  }
              _ -> next
            -- The ridge of the equations is negligible beside the taxels.
            bound = errorsBy press taxels other + 1e-3
         in (pressGain next > leastGain)
              ==> counterexample (show next) (errorsBy press taxels next <= bound)
  it "a step's variance is the mean square of the residuals of the press before" $
    forAll genPress $ \press -> forAllBlind genTaxels $ \taxels ->
      let left =
            sum
              [ share press taxel r * (t - indentation press r (planeAt press x y)) ^ (2 :: Int)
                | taxel@(Taxel t x y) <- taxels,
                  r <- reliefs
              ]
       in near
            (pressVariance (mStep 4 press (snd (eStep press taxels))))
            (max leastVariance (left / fromIntegral (length taxels)))
  where
    near a b = counterexample (show (a, b)) (abs (a - b) < 1e-9 * max 1 (abs b))

-- | P(r) N(z; c + h_r, v), summed.
densityAt :: TiltedPress -> Taxel -> Double
densityAt press taxel = sum (map (joint press taxel) reliefs)

joint :: TiltedPress -> Taxel -> Double -> Double
joint press (Taxel t x y) r =
  reliefShare r * exp (negate (d * d) / (2 * v)) / sqrt (2 * pi * v)
  where
    d = t - indentation press r (planeAt press x y)
    v = pressVariance press

-- | rho_r.
share :: TiltedPress -> Taxel -> Double -> Double
share press taxel r = joint press taxel r / densityAt press taxel

-- | The squared errors of a press, of the taxels and reliefs that touch at another press, weighted
-- by their probability there.
errorsBy :: TiltedPress -> [Taxel] -> TiltedPress -> Double
errorsBy by taxels (TiltedPress a b p q _) =
  sum
    [ share by taxel r * (t - (a * r + b + p * x + q * y)) ^ (2 :: Int)
      | taxel@(Taxel t x y) <- taxels,
        r <- reliefs,
        touches by r (planeAt by x y)
    ]

genPress :: Gen TiltedPress
genPress =
  TiltedPress <$> choose (0.5, 3) <*> choose (-1, 1.5) <*> choose (-1, 1) <*> choose (-1, 1)
    <*> choose (0.05, 1)

genTaxels :: Gen [Taxel]
genTaxels = do
  count <- choose (20, 60)
  vectorOf count (Taxel <$> choose (0, 4) <*> choose (-1, 1) <*> choose (-1, 1))

planeSpec :: Spec
planeSpec = do
  it "frames by the formula are levelled to the relief, and untouched parts count nothing" $
    forAllBlind (vectorOf 12 genTilted) $ \made -> case evened (map fst made) of
      Nothing -> counterexample "not tilted" False
      Just found ->
        let apart = concat (zipWith differences made found)
            right = length (filter (< 0.2) apart)
         in counterexample (show (right, length apart)) (10 * right >= 9 * length apart)
  it "frames of even presses are not taken for tilted" $
    forAllBlind (vectorOf 12 (frameOf 0)) $ \made -> isNothing (evened (map fst made))
  it "frames without variation, or no frames, are not taken for tilted" $
    for_ [[], [constant 16 16 0.4], replicate 5 (constant 16 16 0)] $ \frames ->
      evened frames `shouldSatisfy` isNothing
  where
    genTilted = frameOf 1
    -- For taxels that touch at least half as much as the centre, the distance between relief and
    -- reading, as a share of the relief's height.
    differences (_, (relief, touch)) (level, _) =
      [ abs ((l - base) / height - r)
        | (i, r, t) <- zip3 [0 ..] (V.toList (rasterValues relief)) (V.toList (rasterValues touch)),
          t > 0.5,
          let l = rasterValues level V.! i
      ]
      where
        -- The levels of flat and embossed are those of the frame's own centre.
        (base, height) = scaleBy (rasterValues level) (rasterValues relief) (rasterValues touch)
    -- The line of least squares through the readings over the relief.
    scaleBy level relief touch = (my - slope * mx, slope)
      where
        kept =
          [ (r, l)
            | (r, l, t) <- zip3 (V.toList relief) (V.toList level) (V.toList touch),
              t > 0.5
          ]
        n = fromIntegral (length kept)
        (mx, my) = (sum (map fst kept) / n, sum (map snd kept) / n)
        slope =
          sum [(x - mx) * (y - my) | (x, y) <- kept]
            / max 1e-9 (sum [(x - mx) * (x - mx) | (x, _) <- kept])

-- | A frame of symbols by the formula, at slopes of this many times the relief, with the relief and
-- the touch of each taxel relative to the centre.
frameOf :: Double -> Gen (Raster, (Raster, Raster))
frameOf slope = do
  (dx, dy) <- (,) <$> choose (0, 15) <*> choose (0, 19)
  kinds <- vectorOf 4 (elements embossing)
  angle <- choose (0, 2 * pi)
  depth <- choose (0.1, 0.6)
  noise <- vectorOf 256 (choose (-0.05, 0.05))
  let relief = generate 16 16 $ \x y -> reliefAt kinds (x + dx) (y + dy)
      plane x y = slope * (cos angle * along x + sin angle * along y)
      along k = (2 * fromIntegral k - 15) / 16
      reading x y = max 0 (valueAt relief x y + depth + plane x y)
      touch x y = (max 0 (1 + depth + plane x y) - max 0 (depth + plane x y)) / 1
      image = generate 16 16 (\x y -> 0.2 + 0.5 * reading x y + 0.5 * noise !! (16 * y + x))
  pure (image, (relief, generate 16 16 touch))
  where
    valueAt image x y = rasterValues image V.! (16 * y + x)
    reliefAt kinds x y =
      let (column, u) = x `quotRem` 16
          (row, v) = y `quotRem` 20
       in case drop (2 * (row `mod` 2) + column `mod` 2) kinds of
            shape : _ | Just r <- index shape (u - 4) (v - 4) -> r
            _ -> 0

weightSpec :: Spec
weightSpec = do
  it "a frame whose taxels all have weight 1 has the likelihood of the unweighted frame" $
    forAllBlind (fst <$> frameOf 0) $ \image ->
      let (plain, counted) = (told image Nothing, told image (Just (constant 16 16 1)))
          close a b = abs (a - b) < 1e-6 * (1 + abs b)
       in conjoin
            [ property (close (logDensity counted) (logDensity plain)),
              property (and (zipWith close (logs phaseLogs counted) (logs phaseLogs plain)))
            ]
  it "with weighted taxels, a symbol's likelihood is that of the weighted sums" $
    forAllBlind genPart $ \(image, ends) ->
      let (wide, high) = rasterSize image
          weights = generate wide high (\x _ -> max 0 (min 1 (blendOf ends (fromIntegral x / 15))))
          blendOf (from : to : _) t = from + (to - from) * t + 0.1
          blendOf _ _ = 1 :: Double
          likely = told image (Just weights)
          Theta a b v = likelihoodTheta likely
          (values, counts) = (rasterValues image, rasterValues weights)
          n = V.sum counts
          mean = V.sum (V.zipWith (*) counts values) / n
          variance = V.sum (V.zipWith (\w z -> w * (z - mean) * (z - mean)) counts values) / n
          weighed =
            generate wide high $ \x y ->
              let i = wide * y + x in (counts V.! i) * (values V.! i - mean) / sqrt variance
          wanted =
            [ (a * y - a * b * s - a * a * (if s1 > 1e-6 then q * s / s1 else q) / 2) / v
              | (ofCell, shares) <-
                  zip (Map.elems (drawn paper 2 weighed)) (Map.elems (drawn paper 2 weights)),
                ((y, s1, q), (s, _, _)) <- zip ofCell shares
            ]
          found = V.toList (V.take (length wanted) (classLogs likely))
          most = maximum (map abs wanted)
       in counterexample (show (maximum (zipWith (\x y -> abs (x - y)) found wanted), most)) $
            and (zipWith (\x y -> abs (x - y) < 1e-3 * (1 + most)) found wanted)
  where
    told image counting =
      fitLikelihood (fitOf (tablesAt paperTables 0 (rasterSize image)) (image, counting))
    logs of' = V.toList . of'
    genPart = (,) <$> (part . fst <$> frameOf 0) <*> vectorOf 2 (choose (0, 1))
    -- Large enough a part of a frame to contain some of a symbol.
    part = either (error . show) id . crop (0, 0) (byEffort (12, 11) (16, 16))

paper :: SymbolReadings
paper = either (error . show) drawings paperAlphabet
