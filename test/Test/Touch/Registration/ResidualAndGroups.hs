-- | What is told of frames once they are placed, each part against its definition: how much they
-- differ, which of them hang together, what the others show, and what all pairs together say.
module Test.Touch.Registration.ResidualAndGroups (spec) where

import qualified Data.IntMap.Strict as IntMap
import Data.List (elemIndex, genericLength, nub)
import Data.List.NonEmpty (NonEmpty (..))
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as V
import PraTactile.Composite (blended, inFull)
import PraTactile.Composite.Blend
import PraTactile.Image
import PraTactile.Image.Correlate (referenceSums, referenceWeights)
import PraTactile.Registration.AllPairs (Link (..), solved)
import PraTactile.Registration.Arrangement
import PraTactile.Registration.Groups (groupsOf)
import PraTactile.Registration.Posterior (Hypothesis (..))
import PraTactile.Registration.Residual (residual)
import PraTactile.Registration.Rest (restOf)
import PraTactile.Registration.Rotation (smooth)
import PraTactile.Registration.Search (Registration (..), standardRegistration)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (generate)
import Test.Touch.Image.RastersAndCorrelation (genRasterOf, genRasterWithin)
import Test.Touch.Registration.Face (arranged)

spec :: Spec
spec = modifyMaxSuccess (const 100) $ do
  residualSpec
  groupSpec
  restSpec
  solvedSpec
  othersSpec

residualSpec :: Spec
residualSpec =
  it "the residual is the deviation of a frame from the mean of all that saw a pixel" $
    forAll (choose (1, 5) >>= (`vectorOf` genPlaced)) $ \placed ->
      let pixels =
            [ ((x + u, y + v), value)
              | ((x, y), image) <- placed,
                u <- [0 .. rasterWidth image - 1],
                v <- [0 .. rasterHeight image - 1],
                Just value <- [index image u v]
            ]
          -- What all frames saw at each pixel that more than one saw.
          seen =
            [ vs
              | p <- nub (map fst pixels),
                vs@(_ : _ : _) <- [[v | (p', v) <- pixels, p' == p]]
            ]
          -- The sum of the squares from the mean, over one less than there are, is the variance; it
          -- counts for as many pixels as there are frames.
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
  it "groups are what overlaps, directly or through others, numbered as they come" $
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
  it "frames that meet in an edge or a corner are apart; a hair nearer they are together" $
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

restSpec :: Spec
restSpec =
  it "the rest is what the other frames alone would make, smoothed; beyond them nothing is known" $
    forAll (choose (1, 4) >>= (`vectorOf` genPlaced)) $ \others ->
      forAll genPlaced $ \own ->
        forAll ((,) <$> choose (-3, 3) <*> choose (-3, 3)) $ \(left, top) ->
          forAll ((,) <$> choose (8, 14) <*> choose (8, 14)) $ \(wide, high) ->
            let composite = blended (0, 0) (fmap (\p -> (p, inFull)) (own :| others)) []
                corner part = floor (minimum (map (part . fst) (own : others))) :: Int
                onGrid (i, j) ((x, y), image) =
                  ((x - fromIntegral (corner fst + i), y - fromIntegral (corner snd + j)), image)
                Blend sums weights = blend wide high (map (onGrid (left, top)) others)
                differences a b = V.zipWith (-) (rasterValues a) (rasterValues b)
                close a b = V.all ((< 1e-9) . abs) (differences a b)
             in case restOf composite (left, top) (wide, high) (onGrid (left, top) own) of
                  Nothing -> counterexample "nothing" False
                  Just rest ->
                    counterexample (show (referenceWeights rest, smooth weights)) $
                      close (referenceWeights rest) (smooth weights)
                        && close (referenceSums rest) (smooth sums)
  where
    -- Eighths, so that no pixel is seen by so little that it counts as not touched.
    genPlaced = (,) <$> ((,) <$> place <*> place) <*> genRasterWithin (1, 6)
    place = (/ 8) . fromIntegral <$> choose (-16, 16 :: Int)

solvedSpec :: Spec
solvedSpec = do
  it "what pairs say mirrored, or with the axes exchanged, puts the frames where that has them" $
    forAll (choose (2, 5)) $ \count ->
      forAll (elements [1, 2, 3]) $ \sigma ->
        forAll (undecided count) $ \links ->
          conjoin
            [ counterexample (show (found, seen)) $
                and (zipWith close (map (move . fst) found) (map fst seen))
              | move <-
                  [\(x, y) -> (x, -y), \(x, y) -> (-x, y), \(x, y) -> (y, x)],
                let found = IntMap.elems (solved sigma count links),
                let seen =
                      IntMap.elems
                        ( solved
                            sigma
                            count
                            [ Link k l [Hypothesis (move e) p | Hypothesis e p <- said]
                              | Link k l said <- links
                            ]
                        )
            ]
  it "where all pairs agree, and the robot may be anywhere, frames lie as they say" $
    forAll (choose (2, 6)) $ \count ->
      forAll (vectorOf count (bothOf (choose (-1, 1)))) $ \truth ->
        let found = solved 1e3 count [Link k l [Hypothesis step 1] | (k, l, step) <- steps truth]
            placed = [maybe (0, 0) fst (IntMap.lookup k found) | k <- [0 .. count - 1]]
         in counterexample (show found) . conjoin $
              [ counterexample (show (k, l)) (apart (less (placed !! k) (placed !! l)) step < 1e-3)
                | (k, l, step) <- steps truth
              ]
  it "a pair that is wrong counts for nothing beside those that agree" $
    forAll (choose (4, 6)) $ \count ->
      forAll (vectorOf count (bothOf (choose (-1, 1)))) $ \truth ->
        forAll (elements (steps truth)) $ \wrong@(k, l, (x, y)) ->
          forAll (elements [(6, 0), (-6, 0), (0, 6), (4.5, -4.5)]) $ \(far, off) ->
            let others = [Link i j [Hypothesis e 1] | one@(i, j, e) <- steps truth, one /= wrong]
                stray = Link k l [Hypothesis (x + far, y + off) 1]
                -- From the first frame.
                places links =
                  let found = map fst (IntMap.elems (solved 2 count links))
                   in map (less (head found)) found
             in counterexample (show (places others, places (stray : others))) $
                  and (zipWith (\p q -> apart p q < 0.01) (places others) (places (stray : others)))
  it "of places between which a pair cannot decide the others' is taken, however far it is" $
    forAll (choose (1, 4)) $ \far -> forAll (elements [-1, 1]) $ \side ->
      forAllBlind (elements [id, \(x, y) -> (y, x)]) $ \turn ->
        -- The second frame lies so far off; the pair has it as probably where the robot has it.
        let truth = map turn [(0, 0), (side * far, 0), (0, 0), (0, 0)]
            links =
              [ Link k l (if (k, l) == (0, 1) then map half [step, (0, 0)] else [Hypothesis step 1])
                | (k, l, step) <- steps truth
              ]
            half e = Hypothesis e 0.5
            placed = map fst (IntMap.elems (solved 3 4 links))
         in counterexample (show placed) $
              apart (less (placed !! 0) (placed !! 1)) (turn (side * far, 0)) < 0.5
  it "of two places of one pair alike the one nearer to where the robot has the frame is taken" $
    forAll (choose (0, 1)) $ \near -> forAll (choose (3, 6)) $ \far ->
      forAllBlind (elements [id, \(x, y) -> (y, -x)]) $ \turn ->
        let link = Link 0 1 [Hypothesis (turn (near, 0)) 0.5, Hypothesis (turn (-far, 0)) 0.5]
            placed = map fst (IntMap.elems (solved 2 2 [link]))
         in counterexample (show placed) $
              apart (less (placed !! 0) (placed !! 1)) (turn (near, 0)) < 0.2
  it "without pairs a frame is where the robot has it, with the robot's deviation" $
    solved 0.7 2 [] `shouldBe` IntMap.fromList [(k, ((0, 0), 0.7)) | k <- [0, 1]]
  it "each frame of all pairs is in the end where its pairs and the robot have it in the mean" $
    forAll (choose (2, 5)) $ \count ->
      forAll (elements [1, 2]) $ \sigma ->
        forAll (vectorOf count (bothOf (choose (-sigma, sigma)))) $ \truth ->
          forAll (linksOf truth) $ \links ->
            let found = solved sigma count links
                placeOf k = maybe (0, 0) fst (IntMap.lookup k found)
                -- A pair's hypotheses as normal distributions of half a taxel around where they
                -- have the frame, each by its own probability and by how well it fits; and a pair
                -- that is wrong altogether, of probability 0.02.
                told k =
                  (1 / (sigma * sigma), (0, 0)) :
                  concat
                    [ [(4 * s / (sum (map fst fits) + 0.02), p) | (s, p) <- fits]
                      | Link a b said <- links,
                        k `elem` [a, b],
                        let (ox, oy) = placeOf (if k == b then a else b),
                        let side = if k == b then 1 else -1,
                        let fits =
                              [ (p * exp (-2 * squared (placeOf k) place), place)
                                | Hypothesis (ex, ey) p <- said,
                                  let place = (ox + side * ex, oy + side * ey)
                              ]
                    ]
                squared (x, y) (u, v) = (x - u) ^ (2 :: Int) + (y - v) ^ (2 :: Int)
                expected k =
                  let weight = sum (map fst (told k))
                      along part = sum [m * part p | (m, p) <- told k] / weight
                   in ((along fst, along snd), sqrt (1 / weight))
                near (x, y) (u, v) = max (abs (x - u)) (abs (y - v)) < 0.02
             in counterexample (show [(placeOf k, expected k) | k <- [0 .. count - 1]]) $
                  IntMap.keys found == [0 .. count - 1]
                    && and
                      [ near (placeOf k) (fst (expected k))
                          && abs (maybe 0 snd (IntMap.lookup k found) - snd (expected k)) < 0.01
                        | k <- [0 .. count - 1]
                      ]
  where
    bothOf one = (,) <$> one <*> one
    -- By how much each frame's displacement exceeds those of the ones before it.
    steps truth =
      [ (k, l, less p q)
        | (k, p) <- zip [0 :: Int ..] truth,
          (l, q) <- zip [0 ..] truth,
          k < l
      ]
    less (x, y) (u, v) = (u - x, v - y)
    apart (x, y) (u, v) = max (abs (x - u)) (abs (y - v)) :: Double
    close (x, y) (u, v) = max (abs (x - u)) (abs (y - v)) < 1e-9
    -- Pairs that cannot decide, some between a place and its mirror image.
    undecided count =
      sequence
        [ do
            places <- choose (1, 3) >>= (`vectorOf` bothOf (choose (-5, 5)))
            (x, y) <- elements places
            said <- elements [places, [(x, y), (x, -y)], [(x, y), (-x, y)]]
            pure (Link k l [Hypothesis e (1 / genericLength said) | e <- said])
          | l <- [1 .. count - 1],
            k <- [0 .. l - 1]
        ]
    -- Every pair says where the frames are, nearly, and with less probability another place.
    linksOf truth =
      sequence
        [ do
            (i, j) <- bothOf (choose (-0.3, 0.3))
            (far, side) <- (,) <$> choose (1, 5) <*> elements [-1, 1]
            p <- choose (0.6, 1)
            let step = (x' - x + i, y' - y + j)
                elsewhere = (fst step + side * far, snd step)
            pure (Link k l [Hypothesis step p, Hypothesis elsewhere (1 - p)])
          | (k, (x, y)) <- zip [0 ..] truth,
            (l, (x', y')) <- zip [0 ..] truth,
            k < l
        ]

othersSpec :: Spec
othersSpec =
  it "where relief repeats along one axis, other places along it are told, two taxels off or more" $
    forAll (genRasterOf 40 4) $ \stripes -> forAll (elements [False, True]) $ \upright ->
      let settings = standardRegistration {registrationSigma = Just 2, registrationNoise = 0.05}
          -- Any relief along one axis, and every four taxels the same along the other.
          relief along across = fromMaybe 0 (index stripes along (across `mod` 4))
          seen x y = if upright then relief (x + 4) y else relief (y + 4) x
          frame (dx, dy) = generate 16 16 (\x y -> seen (x + dx) (y + dy))
          step = if upright then (0, 8) else (8, 0)
          place (x, y) = (fromIntegral x, fromIntegral y)
          found =
            arranged Incremental settings [(place at, frame at) | at <- [(0, 0), step]]
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
