-- | Registration one frame after the other, against its definition.
module Test.Touch.Registration.FrameByFrame (spec) where

import Data.List (maximumBy, sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Data.Ord (Down (..), comparing)
import PraTactile.Composite.Blend
import PraTactile.Image hiding (mean)
import PraTactile.Image.Correlate
import PraTactile.Registration.Incremental
import PraTactile.Registration.Posterior (Hypothesis (..))
import PraTactile.Registration.Search
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (generate)
import Test.Touch.Image.RastersAndCorrelation (genRasterOf)

spec :: Spec
spec =
  modifyMaxSuccess (const 200) $
    it "frames are placed one after the other and then swept over, as defined" $
      forAllBlind genFrames $ \frames ->
        forAll ((,) <$> elements [0.5, 1, 2] <*> elements [0, 0.1]) $ \(sigma, noise) ->
          forAll (elements [0, 1, 2, 3, 5]) $ \count ->
            let settings = Registration sigma noise 2 count
                found = register settings frames
                wanted = defined settings frames
                alike (p, hs) (q, gs) =
                  p == q && length hs == length gs && and (zipWith near hs gs)
                near (Hypothesis d p) (Hypothesis e q) = d == e && abs (p - q) < 1e-6
             in counterexample (show (found, wanted)) $
                  length found == length wanted && and (zipWith alike found wanted)
  where
    -- Parts of one relief, some hardly to be seen, near their places or far from all others.
    genFrames = do
      relief <- referenceOf <$> genRasterOf 13 13
      count <- choose (1, 6)
      wide <- elements [5, 5, 14]
      vectorOf count $ do
        (x, y) <- (,) <$> choose (0, wide) <*> choose (0, 5)
        (dx, dy) <- (,) <$> choose (-1, 1) <*> choose (-1, 1)
        contrast <- elements [1, 1, 0.2, 0]
        rough <- genRasterOf 6 5
        share <- elements [0, 0.2, 1]
        far <- frequency [(9, pure 0), (1, pure 60)]
        let real = fromIntegral :: Int -> Double
            half t = (t + 1) / 2
            seen u v =
              maybe 0 fst (referenceAt relief (half (x + dx + real u)) (half (y + dy + real v)))
            noise u v = share * fromMaybe 0 (index rough u v)
            image = generate 6 5 (\u v -> contrast * (seen u v + noise u v))
        pure ((x + far, y), image)

defined :: Registration -> [(Taxels, Raster)] -> [(Taxels, [Hypothesis])]
defined settings given = [(placed Map.! k, others k) | (_, k) <- sortOn fst (zip order [0 ..])]
  where
    -- Whatever order they are given in, they are taken by rows.
    (order, frames) =
      unzip (sortOn (\(_, ((x, y), image)) -> (y, x, toRows image)) (zip [0 :: Int ..] given))
    count = length frames
    placeOf k = fst (frames !! k)
    imageOf k = snd (frames !! k)
    sigma = registrationSigma settings
    reach = registrationReach settings * sigma
    placed = swept (registrationSweeps settings) True [0 .. count - 1] (centred (grown Map.empty))

    -- How much two frames tell at their nominal places.
    telling k l =
      let Overlap n a b _ =
            overlapAt
              (referenceOf (imageOf k))
              (imageOf l)
              (fst (placeOf l) - fst (placeOf k))
              (snd (placeOf l) - snd (placeOf k))
       in n * sqrt (a * b)
    -- Those that may touch it.
    linked k l = k /= l && squares k l
    squares k l = and [abs (square part k - square part l) <= 1 | part <- [fst, snd]]
    square part k = floor (part (placeOf k) / (2 * sqrt 2 * reach + 6)) :: Int
    inAll k = sum [telling k l | l <- [0 .. count - 1], linked k l]

    -- The one is next that has most in common with those placed; of equals that which has most in
    -- common with all, and of equals the first.
    grown known
      | Map.size known == count = known
      | otherwise = grown (Map.insert next (located next known prior window start) known)
      where
        next =
          maximumBy
            (comparing (\k -> (inCommon k, inAll k, Down k)))
            (filter (`Map.notMember` known) [0 .. count - 1])
        inCommon k = sum [telling l k | l <- Map.keys known, linked l k]
        -- They are known up to a common shift: that of their mean, whose variance is the less the
        -- more there are.
        middle = mean known
        unsure = 1 + 1 / fromIntegral (max 1 (Map.size known))
        prior = Prior middle (unsure * sigma * sigma)
        window = Window middle (sqrt unsure * reach)
        start = whole middle

    -- Each against all others, those whose neighbours have moved: first as far as while growing,
    -- then a taxel around, until none moves.
    swept left first unsettled known
      | left <= 0 || null unsettled = centred known
      | otherwise =
        let (unsettled', known') = foldl sweep (unsettled, known) [0 .. count - 1]
         in swept (left - 1) False unsettled' (centred known')
      where
        sweep (these, now) k
          | k `notElem` these = (these, now)
          | new == old = (filter (/= k) these, now)
          | otherwise =
            (filter (/= k) these ++ filter (linked k) [0 .. count - 1], Map.insert k new now)
          where
            old@(x, y) = now Map.! k
            (wx, wy) = whole old
            new
              | first = located k now nominal (Window (0, 0) reach) (x - wx, y - wy)
              | otherwise = located k now nominal (Window old 1) old

    nominal = Prior (0, 0) (sigma * sigma)

    -- Whole taxels from the start, on the mean of the others, each pixel of which counts as
    -- surely as it is known.
    located k known prior window start = case behind k known farthest start of
      Nothing -> start
      Just (there, onGrid) -> mostProbable settings there (imageOf k) onGrid prior window start
      where
        farthest = ceiling (windowRadius window)
    behind k known farthest (sx, sy) =
      let (w, h) = rasterSize (imageOf k)
          border = farthest + 3
          (x0, y0) = placeOf k
          Blend sums weights =
            blend
              (w + 2 * border)
              (h + 2 * border)
              [ ( ( fst (placeOf l) + dx - x0 - sx + fromIntegral border,
                    snd (placeOf l) + dy - y0 - sy + fromIntegral border
                  ),
                  imageOf l
                )
                | (l, (dx, dy)) <- Map.toList known,
                  linked k l
              ]
          sure =
            either (const Nothing) Just $ do
              values <- zipRaster (\s m -> s / (1 + m)) sums weights
              reference values (mapRaster (\m -> m / (1 + m)) weights)
          onGrid (x, y) = (x - sx + fromIntegral border, y - sy + fromIntegral border)
       in (\r -> (r, onGrid)) <$> sure

    -- The two most probable places two taxels off or more, each by a thousandth at least.
    others k = case behind k placed reached start of
      Nothing -> []
      Just (there, onGrid) ->
        take 2 . apart . sortOn (negate . hypothesisProbability) $
          [ Hypothesis d p
            | (d, p) <-
                probabilities settings there (imageOf k) onGrid nominal reached start,
              p >= 0.001,
              far d start
          ]
      where
        start = placed Map.! k
        reached = max 2 (ceiling (2 / 3 * reach))
    far (x, y) (u, v) = max (abs (x - u)) (abs (y - v)) >= 2
    apart [] = []
    apart (h : rest) = h : apart [g | g <- rest, far (hypothesisShift h) (hypothesisShift g)]

    whole (x, y) = (fromIntegral (round x :: Int), fromIntegral (round y :: Int))
    -- To eighths of a taxel.
    mean known
      | Map.null known = (0, 0)
      | otherwise = (eighths (map fst (Map.elems known)), eighths (map snd (Map.elems known)))
    eighths ts = fromIntegral (round (8 * sum ts / fromIntegral (length ts)) :: Int) / 8
    centred known = let (mx, my) = mean known in Map.map (\(x, y) -> (x - mx, y - my)) known
