-- | Tests the skew of a composite, and the composite set upright, against their definitions.
module Test.Touch.Composite.SkewByDefinition (spec) where

import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import PraTactile.Composite
import PraTactile.Composite.Skew
import PraTactile.Image
import PraTactile.Sensor.Manifest (standardConventions)
import Test.Effort (withCases)
import Test.Hspec
import Test.QuickCheck hiding (generate, sample)
import Test.Touch.Image.RastersAndCorrelation (genRasterOf)

spec :: Spec
spec = withCases 7 60 $ do
  skewSpec
  uprightSpec

-- | Any image anywhere, some of whose pixels were hardly touched.
genComposite :: (Int, Int) -> Gen Composite
genComposite sides = do
  (w, h) <- (,) <$> choose sides <*> choose sides
  image <- genRasterOf w h
  covered <- vectorOf (w * h) (frequency [(12, elements [0.4, 0.7, 1, 2]), (1, elements [0, 0.39])])
  origin <- (,) <$> choose (-90, 90) <*> choose (-90, 90)
  pure
    Composite
      { compositeImage = image,
        compositeCoverage = generate w h (\x y -> covered !! (y * w + x)),
        compositeStep = 0,
        compositeOrigin = origin,
        compositeDisplacements = [(0, 0)],
        compositePositionError = Nothing,
        compositeUnregisteredError = 0,
        compositeAxesStated = False,
        compositeConventions = standardConventions,
        compositeAlternatives = [],
        compositeContradiction = Nothing,
        compositeAgreeing = Nothing,
        compositeFrames = [],
        compositeLattice = Nothing
      }

at :: Raster -> Int -> Int -> Double
at image x y = fromMaybe 0 (index image x y)

skewSpec :: Spec
skewSpec =
  it "the skew maximises the squared sums of Scharr's gradient along lines, as defined" $
    forAllBlind (choose (1, 2) >>= (`vectorOf` genComposite (3, 9))) $ \composites ->
      let angle = defined composites
          slopes = concatMap gradients composites
          (found, wanted) = (fromMaybe 0 (skew composites), fromMaybe 0 angle)
          -- Up to rounding, which may exchange the ends of the range.
          close = abs (found - wanted) < 1e-6 || min (abs (found - 45)) (abs (found + 45)) < 1e-6
       in counterexample (show (skew composites, angle)) $
            label (maybe "none" (const "some") angle) $
              if null slopes
                then skew composites === Nothing
                else property close

-- | The best of angles a degree and a half apart, then of those half a degree apart up to a degree
-- from there. Then the vertex of the parabola through the scores a degree around, if it has one, at
-- most a degree away.
defined :: [Composite] -> Maybe Double
defined composites = if all null found then Nothing else Just (folded vertex)
  where
    found = map gradients composites
    score angle = sum (map (squares angle) found)
    coarse = best [1.5 * k - 45 | k <- [0 .. 59]]
    fine = best [coarse + 0.5 * k | k <- [-2 .. 2]]
    best angles = snd (maximum [(score a, a) | a <- angles])
    (below, here, above) = (score (fine - 1), score fine, score (fine + 1))
    curve = (below + above) / 2 - here
    vertex
      | curve < 0 = fine + max (-1) (min 1 ((below - above) / (4 * curve)))
      | otherwise = fine
    folded a
      | a < -45 = folded (a + 90)
      | a >= 45 = folded (a - 90)
      | otherwise = a

-- | The sum of the squares of the sums along lines a pixel apart, in both directions. A pixel
-- between two lines counts in parts for both.
squares :: Double -> [((Double, Double), (Double, Double))] -> Double
squares angle found = along (cos turn, sin turn) + along (-(sin turn), cos turn)
  where
    turn = angle * pi / 180
    along (u, v) =
      sum . map (^ (2 :: Int)) . Map.elems $
        Map.fromListWith
          (+)
          [ (line, (1 - abs (place - fromIntegral line)) * (u * gx + v * gy))
            | ((x, y), (gx, gy)) <- found,
              let place = u * x + v * y,
              line <- [floor place, floor place + 1 :: Int]
          ]

-- | The pixels whose nine neighbours were touched, from the composite's middle, with the gradient.
gradients :: Composite -> [((Double, Double), (Double, Double))]
gradients Composite {compositeImage = image, compositeCoverage = coverage} =
  [ ( (fromIntegral x - fromIntegral w / 2, fromIntegral y - fromIntegral h / 2),
      ( (10 * (p 1 0 - p (-1) 0) + 3 * (p 1 1 - p (-1) 1 + p 1 (-1) - p (-1) (-1))) / 32,
        (10 * (p 0 1 - p 0 (-1)) + 3 * (p 1 1 - p 1 (-1) + p (-1) 1 - p (-1) (-1))) / 32
      )
    )
    | x <- [1 .. w - 2],
      y <- [1 .. h - 2],
      and [at coverage (x + i) (y + j) >= 0.4 | i <- [-1 .. 1], j <- [-1 .. 1]],
      let p i j = at image (x + i) (y + j)
  ]
  where
    (w, h) = rasterSize image

uprightSpec :: Spec
uprightSpec =
  it "a composite set upright is as large as its corners need, with interpolated pixels" $
    forAllBlind (genComposite (1, 9)) $ \composite ->
      forAll (oneof [choose (-180, 180), elements [0, 30, 90, -90, 180]]) $ \angle ->
        let (upright, _) = setUpright angle composite
            (w, h) = rasterSize (compositeImage composite)
            corners =
              [ turnedPlace (negate angle) (placeOf composite (x, y))
                | x <- [0, fromIntegral (w - 1)],
                  y <- [0, fromIntegral (h - 1)]
              ]
            (left, top) = (minimum (map fst corners), minimum (map snd corners))
            -- As many pixels as reach the last corner, up to rounding.
            enough part from = 1 + ceiling ((maximum (map part corners) - from) / pitch - 1e-6)
            (wide, high) = (enough fst left, enough snd top) :: (Int, Int)
            seen x y =
              between composite (onto composite (turnedPlace angle (placeOf upright (x, y))))
            close (u, v) = abs (u - v) < 1e-6
         in counterexample (show (compositeOrigin upright, (left, top), wide, high)) $
              rasterSize (compositeImage upright) === (wide, high)
                .&&. rasterSize (compositeCoverage upright) === (wide, high)
                .&&. close (fst (compositeOrigin upright), left)
                .&&. close (snd (compositeOrigin upright), top)
                .&&. conjoin
                  [ counterexample (show (x, y, seen (fromIntegral x) (fromIntegral y))) $
                      close (weight, at (compositeCoverage upright) x y)
                        && (weight < 1e-6 || close (value, at (compositeImage upright) x y))
                    | x <- [0 .. wide - 1],
                      y <- [0 .. high - 1],
                      let (value, weight) = seen (fromIntegral x) (fromIntegral y)
                  ]
  where
    pitch = 1.5875 :: Double
    placeOf composite (x, y) =
      let (left, top) = compositeOrigin composite in (left + pitch * x, top + pitch * y)
    onto composite (x, y) =
      let (left, top) = compositeOrigin composite in ((x - left) / pitch, (y - top) / pitch)
    turnedPlace angle (x, y) =
      let (c, s) = (cos (angle * pi / 180), sin (angle * pi / 180))
       in (c * x - s * y, s * x + c * y) :: (Double, Double)
    -- The mean of the four pixels around, weighted by their distance and their coverage.
    between composite (x, y) =
      let shares =
            [ (share * at (compositeCoverage composite) i j, at (compositeImage composite) i j)
              | i <- [floor x, floor x + 1],
                j <- [floor y, floor y + 1],
                let share = near (x - fromIntegral i) * near (y - fromIntegral j)
            ]
          near t = max 0 (1 - abs t)
          weight = sum (map fst shares)
       in (if weight > 0 then sum [m * v | (m, v) <- shares] / weight else 0, weight)
