-- | Tests the parts of stitching, each against its definition: the posterior of a displacement,
-- which frames overlap, and the noise of frames.
module Test.Touch.Registration.HypothesesAndNoise (spec) where

import Data.List (genericLength, nub, sort)
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as V
import PraTactile.Composite.Noise
import PraTactile.Image
import PraTactile.Registration.Lattice.Places (Places (..), placesAt)
import PraTactile.Registration.Levelling (randomEffects)
import PraTactile.Registration.Neighbours
import PraTactile.Registration.Posterior
import Test.Effort (withCases)
import Test.Hspec
import Test.QuickCheck hiding (generate)

spec :: Spec
spec = do
  describe "The posterior of a displacement" $ withCases 25 200 posteriorSpec
  describe "Pairs of overlapping frames" neighbourSpec
  describe "The noise of frames" noiseSpec
  describe "The places of symbols" placesSpec
  describe "Numbers with errors" effectsSpec

near :: Double -> Double -> Property
near wanted came = counterexample (show (wanted, came)) (abs (wanted - came) < 1e-9)

-- | Masses on a grid, some of them 0.
genPosterior :: Gen GridPosterior
genPosterior = do
  columns <- choose (1, 9)
  rows <- choose (1, 9)
  origin <- (,) <$> choose (-20, 20) <*> choose (-20, 20)
  spacing <- elements [0.25, 0.5, 1]
  logs <- vectorOf (columns * rows) (frequency [(3, choose (-12, 0)), (1, pure (-1 / 0))])
  pure (posterior origin spacing (columns, rows) (V.fromList (0 : drop 1 logs)))

-- | The points of the grid, each with its probability.
pointsOf :: GridPosterior -> [((Double, Double), Double)]
pointsOf (GridPosterior (ox, oy) spacing (columns, rows) masses) =
  zip
    [ (ox + spacing * fromIntegral x, oy + spacing * fromIntegral y)
      | y <- [0 .. rows - 1],
        x <- [0 .. columns - 1]
    ]
    (V.toList masses)

posteriorSpec :: Spec
posteriorSpec = do
  it "is proportional to the exponentials, and ignores NaN" $
    forAll (listOf1 (frequency [(6, choose (-800, 800)), (1, pure (0 / 0)), (1, pure (-1 / 0))])) $
      \logs ->
        let GridPosterior _ _ _ masses = posterior (0, 0) 1 (length logs, 1) (V.fromList logs)
            finite = [l | l <- logs, not (isNaN l || isInfinite l)]
            share l = if isNaN l then 0 else 1 / sum [exp (l' - l) | l' <- finite]
         in conjoin
              ( zipWith
                  near
                  (map (if null finite then const (1 / genericLength logs) else share) logs)
                  (V.toList masses)
              )
  it "around a place is the sum of all within three quarters of a taxel, along both axes" $
    forAll genPosterior $ \known ->
      forAll ((,) <$> choose (-2, 10) <*> choose (-2, 10)) $ \(dx, dy) ->
        let (ox, oy) = posteriorOrigin known
            (x, y) = (ox + dx, oy + dy)
         in near
              (sum [m | ((u, v), m) <- pointsOf known, abs (u - x) <= 0.75, abs (v - y) <= 0.75])
              (probabilityAround known (x, y))
  it "is greatest around its best place, within a hundredth" $
    forAll genPosterior $ \known ->
      let best = hypothesisProbability <$> take 1 (hypotheses 1 0 known)
          -- Any place is as good as one of these, at whose edges points lie.
          places =
            [ (u + i, v + j)
              | ((u, v), _) <- pointsOf known,
                i <- [0, 0.75],
                j <- [0, 0.75]
            ]
          most = maximum (map (probabilityAround known) places)
       in counterexample (show (best, most)) $
            all (\p -> p <= most + 1e-9 && p >= 0.99 * most) best && length best == 1
  it "has hypotheses with the probability around each that those before leave" $
    forAll genPosterior $ \known -> forAll (choose (1, 5)) $ \count ->
      forAll (elements [0, 0.01, 0.1, 0.4]) $ \least ->
        let found = hypotheses count least known
            -- Points at the edge count, up to rounding.
            apart (x, y) (u, v) = max (abs (x - u)) (abs (y - v)) > 0.75 + 1e-7
            left firsts place =
              sum
                [ m
                  | (point, m) <- pointsOf known,
                    all (apart point) firsts,
                    not (apart point place)
                ]
            earlier = scanl (flip ((:) . hypothesisShift)) [] found
         in conjoin
              ( property (not (null found) && length found <= count) :
                property (all ((>= least) . hypothesisProbability) (drop 1 found)) :
                  [ counterexample (show (h, left firsts (hypothesisShift h))) $
                      abs (left firsts (hypothesisShift h) - hypothesisProbability h) < 1e-9
                    | (firsts, h) <- zip earlier found
                  ]
              )
  it "has at least one hypothesis, whatever the number and the probability requested" $
    forAll genPosterior $ \known ->
      map length [hypotheses 0 0 known, hypotheses 1 1.5 known, hypotheses 3 1.5 known]
        === [1, 1, 1]
  it "has the deviations of its axes, with that of a cell of the grid" $
    forAll genPosterior $ \known ->
      let cell = posteriorSpacing known ^ (2 :: Int) / 12
          deviation part =
            let middle = sum [m * part p | (p, m) <- pointsOf known]
             in sqrt (cell + sum [m * (part p - middle) ^ (2 :: Int) | (p, m) <- pointsOf known])
          (alongX, alongY) = deviations known
          close a b = counterexample (show (a, b)) (abs (a - b) < 1e-6)
       in close (deviation fst) alongX .&&. close (deviation snd) alongY
  it "has marginals: for each axis by itself, the greatest probability around a place" $
    forAll genPosterior $ \known ->
      let best part =
            maximum
              [ sum [m | (q, m) <- pointsOf known, abs (part q - (part p + 0.75)) <= 0.75 + 1e-9]
                | (p, _) <- pointsOf known
              ]
          (alongX, alongY) = marginals known
       in near (best fst) alongX .&&. near (best snd) alongY
  it "is initially normal around the step, with half of the search as deviation" $
    forAll genPosterior $ \known -> forAll (elements [0, 1, 3, 8]) $ \search ->
      forAll ((,) <$> choose (-20, 20) <*> choose (-20, 20)) $ \(stepX, stepY) ->
        let weight (x, y)
              | search <= 0 = 0
              | otherwise =
                -((x - stepX) ^ (2 :: Int) + (y - stepY) ^ (2 :: Int)) * 2 / (search * search)
            top = maximum (map (weight . fst) (pointsOf known))
            weights = [exp (weight p - top) | (p, _) <- pointsOf known]
            GridPosterior origin spacing size masses = priorAlone search (stepX, stepY) known
         in conjoin (zipWith near (map (/ sum weights) weights) (V.toList masses))
              .&&. (origin, spacing, size)
              === (posteriorOrigin known, posteriorSpacing known, posteriorSize known)
              .&&. near (weight (stepX + 1.5, stepY - 2)) (priorAround search (1.5, -2))

neighbourSpec :: Spec
neighbourSpec = do
  it "are listed once, with the step and the overlap as a share of the smaller frame" $
    forAll (choose (0, 12) >>= (`vectorOf` genFrame)) $ \placed ->
      let numbered = zip [0 ..] placed
          meeting a m b n = max 0 (min (a + m) (b + n) - max a b) / max 1 (min m n)
          wanted =
            [ (k, l, (x' - x, y' - y), share)
              | (k, ((x, y), a)) <- numbered,
                (l, ((x', y'), b)) <- numbered,
                k < l,
                let share =
                      meeting x (width a) x' (width b) * meeting y (height a) y' (height b),
                share > 1e-12
            ]
          found =
            [ (k, l, step, share)
              | OverlappingPair k l step share <- neighbours placed,
                share > 1e-12
            ]
          alike (k, l, (x, y), s) (k', l', (x', y'), s') =
            (k, l) == (k', l') && maximum (map abs [x - x', y - y', s - s']) < 1e-9
       in counterexample (show (wanted, found)) $
            length wanted == length found && and (zipWith alike (sort wanted) (sort found))
  it "are found around this many of the frames, evenly taken, and no others" $
    forAll (choose (1, 16)) $ \n -> forAll (choose (1, 20)) $ \most ->
      let placed = replicate n ((0, 0), constant 4 4 0)
          firsts = nub [k | OverlappingPair k _ _ _ <- neighboursAround most placed]
          step k = (k * most) `div` n
          taken = [k | k <- [0 .. n - 1], n <= most || step k /= step (k - 1)]
       in -- The last one has none after it.
          firsts === filter (< n - 1) taken .&&. length taken === min n most
  it "are found among sixteen of the frames in one square" $
    forAll (choose (17, 60)) $ \n ->
      let placed = replicate n ((0, 0), constant 4 4 0)
       in length (nub [l | OverlappingPair 0 l _ _ <- neighbours placed]) === 15
  where
    genFrame = do
      w <- choose (1, 6)
      h <- choose (1, 6)
      place <- (,) <$> choose (-12, 12) <*> choose (-12, 12)
      pure (place, constant w h 0)
    width = fromIntegral . rasterWidth :: Raster -> Double
    height = fromIntegral . rasterHeight :: Raster -> Double

noiseSpec :: Spec
noiseSpec = do
  it "is the median size of a - b - c + d over 2 x 0.6745, to a 512th of the largest" $
    forAll (choose (1, 3) >>= (`vectorOf` genImage)) $ \images ->
      let sizes =
            sort
              [ abs (v x y - v (x + 1) y - v x (y + 1) + v (x + 1) (y + 1))
                | image <- images,
                  let v i j = fromMaybe 0 (index image i j),
                  y <- [0 .. rasterHeight image - 2],
                  x <- [0 .. rasterWidth image - 2]
              ]
          count = length sizes
          bin = maximum (0 : sizes) / 512 + 1e-12
          (lower, upper) = (sizes !! ((count - 1) `div` 2), sizes !! (count `div` 2))
          found = frameNoise images * 2 * 0.6745
       in if null sizes
            then frameNoise images === 0
            else
              counterexample (show (lower, found, upper)) $
                found >= lower - bin && found <= upper + bin
  it "is from at most 256 of the frames, evenly taken of different ones, in any order" $
    forAll (choose (1, 4 :: Int)) $ \every ->
      -- Of 256 times 'every' images, one in 'every' has noise.
      let image k = generate 2 2 $ \x y ->
            fromIntegral k / 2048 + (if (x, y) == (1, 1) && k `mod` every == 0 then 0.5 else 0)
          images = map image [0 .. 256 * every - 1]
       in forAllBlind (shuffle (images ++ take 3 images)) $ \shuffled ->
            near (0.5 / 1.349) (frameNoise shuffled * 512 / 511.5)
  where
    genImage = do
      w <- choose (1, 7)
      h <- choose (1, 7)
      values <- vectorOf (w * h) (choose (0, 1))
      pure (generate w h (\x y -> values !! (y * w + x)))

-- | For equal errors, by the variance s^2 of the numbers: tau^2 is s^2 - e^2 or 0.
effectsSpec :: Spec
effectsSpec =
  it "shrink towards their mean by the share of the variance that their errors explain" $
    forAll (choose (2, 9) >>= \n -> vectorOf n (choose (-2, 2))) $ \xs ->
      forAll (choose (0.01, 4)) $ \e ->
        forAll (choose (0, length xs)) $ \k ->
          let n = fromIntegral (length xs)
              middle = sum xs / n
              variance = sum [(x - middle) * (x - middle) | x <- xs] / (n - 1)
              left = max 0 (1 - e / variance)
              -- A number without information changes nothing, and is estimated like the others.
              (those, these) = splitAt k [(x, e) | x <- xs]
              (found, each) = randomEffects (those ++ [(100, 1 / 0)] ++ these)
              wanted = [middle + left * (x - middle) | x <- xs]
           in classify (left > 0) "differ" $
                near middle found
                  .&&. conjoin (zipWith near (take k wanted ++ [middle] ++ drop k wanted) each)

placesSpec :: Spec
placesSpec = do
  it "reach from ten taxels before the frame to three behind, along their own axes" $
    forAll ((,) <$> choose (4, 20) <*> choose (4, 20)) $ \(w, h) ->
      forAll (oneof [choose (-90, 90), elements [0, 90, -90, 45]]) $ \angle ->
        forAll (elements [1, 2]) $ \q ->
          let turn = angle * pi / 180
              corners =
                [ (cos turn * x + sin turn * y, cos turn * y - sin turn * x)
                  | x <- [0, fromIntegral (w - 1)],
                    y <- [0, fromIntegral (h - 1)]
                ]
              -- Whole taxels around the range of the corners, up to rounding.
              whole part =
                let ts = map part corners
                 in (floor (minimum ts + 1e-7), ceiling (maximum ts - 1e-7)) :: (Int, Int)
              ((left, right'), (top, bottom)) = (whole fst, whole snd)
              places = placesAt angle w h q
              ((x0, y0), (columns, rows)) = (placesFirst places, placesGrid places)
           in -- A symbol's 8 x 12 taxels lie behind its place, and count two taxels around.
              ((x0, y0), (x0 + columns `div` q, y0 + rows `div` q), (columns `mod` q, rows `mod` q))
                === ((left - 10, top - 14), (right' + 3, bottom + 3), (0, 0))
