-- | Tests the parts of the registration of pairs, and frames turned back, each against its
-- definition on lists.
module Test.Touch.Registration.PairsInParts (spec) where

import Data.List (nub, sort)
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as V
import PraTactile.Composite.Noise (frameNoise)
import PraTactile.Image
import PraTactile.Registration.Overlap
import PraTactile.Registration.Pair.Alike
import PraTactile.Registration.Pair.Methods
import PraTactile.Registration.Pair.Straight
import PraTactile.Registration.Posterior
import PraTactile.Registration.Spectrum
import PraTactile.Sensor.Resample
import PraTactile.Symmetry
import System.Random (mkStdGen, randomRs)
import Test.Effort (withCases)
import Test.Hspec
import Test.QuickCheck hiding (generate, sample)
import Test.Touch.Image.RastersAndCorrelation (genRasterOf, genRasterWithin)

spec :: Spec
spec = withCases 12 100 $ do
  overlapSpec
  blindSpec
  straightSpec
  turnSpec

-- | The values of two images at the same places, row by row, if the second's upper left pixel lies
-- there in the first.
both :: Raster -> Raster -> (Int, Int) -> [(Double, Double)]
both a b (dx, dy) =
  [ (v, w)
    | y <- [0 .. rasterHeight a - 1],
      x <- [0 .. rasterWidth a - 1],
      Just v <- [index a x y],
      Just w <- [index b (x - dx) (y - dy)]
  ]

overlapSpec :: Spec
overlapSpec = do
  it "displacements are the whole ones within the search, and at least one" $
    forAll ((,) <$> choose (-9, 9) <*> choose (-9, 9)) $ \step ->
      forAll (elements [0, 0.2, 0.5, 1, 2.5, 3]) $ \search ->
        let found = allOf (displacementsAround step search)
            reached t = [k | k <- [-20 .. 20], abs (fromIntegral k - t) <= search] :: [Int]
            right seen wanted = if null wanted then length seen == 1 else seen == wanted
            (alongX, alongY) = (nub (map fst found), nub (map snd found))
         in counterexample (show found) $
              right alongX (reached (fst step)) && right alongY (reached (snd step))
                && found == [(x, y) | y <- alongY, x <- alongX]
  it "an overlap has the values of both images at the same places" $
    forAll ((,) <$> genRasterWithin (2, 7) <*> genRasterWithin (2, 7)) $ \(a, b) ->
      forAll ((,) <$> choose (-8, 8) <*> choose (-8, 8)) $ \(dx, dy) ->
        let pairs = both a b (dx, dy)
         in case patchesAt a b (dx, dy) of
              Nothing -> pairs === []
              Just ((w, h), pa, pb) ->
                (w * h, zip (V.toList pa) (V.toList pb)) === (length pairs, pairs)
  it "images agree if their overlap is equal but for gain and offset, and varies enough" $
    forAll (genRasterOf 9 8) $ \scene ->
      forAll (elements [1, 0.3, -1]) $ \gain ->
        forAll ((,) <$> choose (0, 4) <*> choose (0, 3)) $ \(dx, dy) ->
          forAll ((,) <$> choose (3, 6) <*> choose (3, 6)) $ \(w, h) ->
            let a = part 5 5 0 0 id
                b = part w h dx dy (\v -> gain * v + 0.2)
                part m n x y with =
                  generate m n (\i j -> with (fromMaybe 0 (index scene (x + i) (y + j))))
                found = agreements (fromIntegral dx, fromIntegral dy) 1 a b
                wanted =
                  [ (fromIntegral i, fromIntegral j)
                    | j <- [dy - 1 .. dy + 1],
                      i <- [dx - 1 .. dx + 1],
                      let wide = min 5 (i + w) - max 0 i,
                      let high = min 5 (j + h) - max 0 j,
                      min wide high >= 3,
                      correlated a b (i, j)
                  ]
             in found === wanted
  it "places are apart along an axis if they differ by more than a taxel there" $
    [ apart places
      | places <-
          [ [],
            [(3, 4)],
            [(0, 0), (1, 1)],
            [(0, 0), (1.1, 1)],
            [(5, 2), (5, 7), (5, 3)],
            [(-2, 1), (0, -1)]
          ]
    ]
      `shouldBe` [ (False, False),
                   (False, False),
                   (False, False),
                   (True, False),
                   (False, True),
                   (True, True)
                 ]
  where
    -- A correlation close to 1, of relief that varies by at least a hundredth of the images.
    correlated a b d =
      let pairs = both a b d
          n = fromIntegral (length pairs)
          centred vs = map (subtract (sum vs / fromIntegral (length vs))) vs
          (da, db) = (centred (map fst pairs), centred (map snd pairs))
          power vs = sum (map (^ (2 :: Int)) (centred vs)) / fromIntegral (length vs)
          whole image = power (V.toList (rasterValues image))
          cov = sum (zipWith (*) da db) / n
          (va, vb) = (power (map fst pairs), power (map snd pairs))
       in va > 0.01 * whole a && vb > 0.01 * whole b && cov / sqrt (va * vb) >= 0.9999

blindSpec :: Spec
blindSpec =
  it "blind, relief constant along an axis shifts the median less than the prior's deviation" $
    sort (map offStep [1 .. 21]) !! 10 `shouldSatisfy` ((< 1.5) . abs)
  where
    -- The mean distance of the posterior from the step, along the axis, for frames with random rows
    -- and noise of a hundredth.
    offStep seed =
      let (a, b) = (seen (100 * seed + 1), seen (100 * seed + 2))
          known = spectra 16 16
          GridPosterior _ _ (columns, _) masses = blindPosterior (reliefOf known 0 [a, b]) step 3
          step = if upright then (0, 8) else (8, 0)
          upright = even seed
          seen k =
            onRaster (if upright then turned 1 else identity) . generate 16 16 $ \x y ->
              drawn seed y + 0.04 * drawn k (16 * y + x)
       in sum
            [ m * fromIntegral ((if upright then row else column) - 3)
              | (i, m) <- zip [0 ..] (V.toList masses),
                let (row, column) = i `quotRem` columns
            ]
    drawn seed k = randomRs (0, 1) (mkStdGen seed) !! k :: Double

straightSpec :: Spec
straightSpec = do
  it "a direction is found if slopes exceed the noise across it, and not along it" $
    forAll (genRasterOf 8 9) $ \rough ->
      forAll ((,) <$> genRasterOf 8 9 <*> choose (0, pi)) $ \(other, angle) ->
        forAll (elements [0, 0.02, 0.1, 0.3, 1]) $ \noise ->
          let (c, s) = (cos angle, sin angle)
              -- A step along a line at that angle, and noise.
              line u v = 1 / (1 + exp (-2 * ((u - 4) * c + (v - 4.5) * s))) :: Double
              seen dice =
                generate 8 9 $ \x y ->
                  line (fromIntegral x) (fromIntegral y) + noise * fromMaybe 0 (index dice x y)
              (a, b) = (seen rough, seen other)
              (xx, xy, yy) = products a b
              along t = let (i, j) = (cos t, sin t) in xx * i * i + 2 * xy * i * j + yy * j * j
              -- To a twentieth of a degree.
              turns = [pi * k / 3600 | k <- [0 .. 3599]]
              least = minimum (map along turns)
              most = maximum (map along turns)
              noiseOf image =
                let values = V.toList (rasterValues image)
                 in max (frameNoise [image]) (0.001 * (maximum values - minimum values))
              limit = 4.5 * slopeNoise * noiseOf a * noiseOf b * sqrt (42 * alikeness)
              -- Values this near to a limit may fall on either side.
              near t = abs t < 1e-3 * (most - least)
           in classify (noise >= 0.3) "noisy" $
                case straightness (0, 0) a b of
                  Nothing ->
                    counterexample "nothing" $
                      least >= limit || most < 4 * limit || near (most - 4 * limit)
                  Just (i, j) ->
                    counterexample (show (i, j, least, most, limit)) $
                      abs (i * i + j * j - 1) < 1e-9
                        && (least < limit || near (least - limit))
                        && (most >= 4 * limit || near (most - 4 * limit))
                        && near (xx * i * i + 2 * xy * i * j + yy * j * j - least)
  it "only the overlap counts: the result is that of the images cut to it" $
    forAll ((,) <$> choose (-3, 3) <*> choose (-3, 3)) $ \(dx, dy) ->
      let edge x = if x < (5 :: Int) then 0 else 1
          a = generate 9 9 (\x _ -> edge x)
          b = generate 9 9 (\x _ -> edge (x + dx))
       in fmap (\(i, j) -> abs i < 1e-9 && abs (abs j - 1) < 1e-9) (straightness (dx, dy) a b)
            === Just True
  where
    -- Sums over the inner pixels of the products of both images' slopes, by Sobel's weights, an
    -- eighth each.
    products a b =
      let inner = [(x, y) | y <- [1 .. rasterHeight a - 2], x <- [1 .. rasterWidth a - 2]]
          slope weight image (x, y) =
            sum
              [ weight i j / 8 * fromMaybe 0 (index image (x + i) (y + j))
                | (i, j) <- nearest
              ]
          at weightA weightB = sum [slope weightA a p * slope weightB b p | p <- inner]
       in (at across across, (at across down + at down across) / 2, at down down)
    nearest = [(i, j) | j <- [-1 .. 1], i <- [-1 .. 1]]
    across i j = fromIntegral (i * (2 - abs j)) :: Double
    down i j = across j i
    -- The variance of a slope by white noise, and the squares of its correlations with all others.
    autocorrelation (i, j) =
      sum
        [ across u v * across (u + i) (v + j) / 64
          | (u, v) <- nearest,
            (u + i, v + j) `elem` nearest
        ]
    slopeNoise = autocorrelation (0, 0)
    alikeness =
      sum
        [ (autocorrelation (i, j) / slopeNoise) ^ (2 :: Int)
          | i <- [-2 .. 2],
            j <- [-2 .. 2]
        ]

turnSpec :: Spec
turnSpec =
  it "a turned frame is the largest upright part of its proportions, by interpolation" $
    forAll ((,) <$> choose (3, 12) <*> choose (3, 12)) $ \(w, h) ->
      forAll (genRasterOf w h) $ \image ->
        forAll (oneof [choose (-180, 180), elements [0, 45, 90, -90, 180, 30]]) $ \degrees ->
          let turn = degrees * pi / 180
              (c, s) = (cos turn, sin turn)
              (wide, high) = (fromIntegral (w - 1), fromIntegral (h - 1)) :: (Double, Double)
              -- Whether the place that is so far right and down of the centre, upright, is on the
              -- frame.
              onFrame (x, y) = (c * x + s * y, c * y - s * x)
              holds part =
                and
                  [ abs u <= wide / 2 + 1e-9 && abs v <= high / 2 + 1e-9
                    | (i, j) <- [(-1, -1), (1, -1), (-1, 1), (1, 1)],
                      let (u, v) = onFrame (part * i * wide / 2, part * j * high / 2)
                  ]
              share = last (filter holds (map (/ 2000) [0 .. 2000]))
              -- The least and the greatest number of whole pixels that the part has.
              pixels sides extra = 1 + floor (sides * (share + extra) + 1e-6) :: Int
              sizes = [(pixels wide e, pixels high e) | e <- [0, 1 / 2000]]
              close v t = abs (v - t) < 1e-9
           in counterexample (show sizes) $ case turnedBack degrees image of
                Nothing -> any (\(m, n) -> min m n < 4) sizes
                Just found ->
                  let (m, n) = rasterSize found
                      middle k = fromIntegral (k - 1) / 2 :: Double
                      wanted =
                        [ sample image (wide / 2 + u) (high / 2 + v)
                          | y <- [0 .. n - 1],
                            x <- [0 .. m - 1],
                            let fromMiddle = (fromIntegral x - middle m, fromIntegral y - middle n),
                            let (u, v) = onFrame fromMiddle
                        ]
                   in min m n >= 4
                        && m `elem` map fst sizes
                        && n `elem` map snd sizes
                        && and (zipWith close (V.toList (rasterValues found)) wanted)
