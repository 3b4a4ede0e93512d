{-# LANGUAGE GADTs #-}
{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RankNTypes #-}

-- | What the laws of registration and stitching show: of each scene that is drawn, what is asked is
-- what the law's sentence says, and exactly the answers within its tolerance pass.
module Test.Conformance.Scenes (spec) where

import Data.Aeson (Value (..))
import Data.Foldable (for_)
import Data.List (nub, sort, transpose)
import Data.Maybe (catMaybes, isJust, listToMaybe)
import Data.Traversable (for)
import Numeric.Natural (Natural)
import PraTactile.Conformance
import PraTactile.Conformance.Ask
import PraTactile.Conformance.Law (Verdict (..))
import PraTactile.Conformance.Question
import PraTactile.Symmetry
import System.Random (mkStdGen, randomRs)
import Test.Conformance.Asking
import Test.Hspec

spec :: Spec
spec = do
  describe "two frames" pairSpec
  describe "two frames that do not tell where they lie" refusedSpec
  describe "several frames" surveySpec

-- * Reliefs, by what is said of them

-- | 184 bumps and dents, of radii of 1 to 3 taxels, between (-24, -24) and (48, 48), each a bell
-- cut off at four radii; 10000 is the middle, 4000 the highest bump.
relief :: Int -> WholeTaxels -> Natural
relief seed = \(x, y) ->
  let heights =
        [ h * exp (-(dx * dx + dy * dy) / (2 * r * r))
          | (bx, by, r, h) <- bumps,
            let (dx, dy) = (fromInteger x - bx, fromInteger y - by),
            abs dx <= 4 * r && abs dy <= 4 * r
        ]
   in fromInteger (max 0 (min 20000 (round (10000 + 4000 * sum heights :: Double))))
  where
    numbers = randomRs (0, 1) (mkStdGen seed) :: [Double]
    bumps =
      take
        184
        [ (72 * a - 24, 72 * b - 24, 1 + 2 * c, 2 * d - 1)
          | [a, b, c, d] <- map (take 4) (iterate (drop 4) numbers)
        ]

cut :: (WholeTaxels -> Natural) -> WholeTaxels -> WholeTaxels -> Rows
cut surface (w, h) (x, y) = [[surface (i, j) | i <- [x .. x + w - 1]] | j <- [y .. y + h - 1]]

-- | Whether a pair tells by itself that the second frame lies there: at other whole displacements
-- within the search what both have in common correlates by less than 0.9, one taxel away by less
-- than 0.97.
tells :: Pair -> WholeTaxels -> Bool
tells (Pair a b (sx, sy) search) (dx, dy) =
  and
    [ correlation (x, y) < if max (abs (x - dx)) (abs (y - dy)) == 1 then 0.97 else 0.9
      | x <- [sx - toInteger search .. sx + toInteger search],
        y <- [sy - toInteger search .. sy + toInteger search],
        (x, y) /= (dx, dy)
    ]
  where
    values = map (map fromIntegral) :: Rows -> [[Double]]
    correlation (x, y) =
      let inBoth =
            [ (u, v)
              | (rowA, rowB) <- zip (skip y (values a)) (skip (-y) (values b)),
                (u, v) <- zip (skip x rowA) (skip (-x) rowB)
            ]
          centred part = map (subtract (sum part / fromIntegral (length part))) part
          (us, vs) = (centred (map fst inBoth), centred (map snd inBoth))
          product' ps qs = sum (zipWith (*) ps qs)
          size = product' us us * product' vs vs
       in if length inBoth < 2 || size < 1e-6 then 1 else product' us vs / sqrt size
    skip n = drop (fromInteger (max 0 n))

-- * Two frames

-- | A drawn press: its step, the displacement, its search, and its frames.
data Press = Press WholeTaxels WholeTaxels Rows Rows

press :: Value -> Press
press value = Press step shift (frame (0, 0)) (frame shift)
  where
    step = under "step" value
    shift = step `plus` under "error" value
    frame = cut (relief (under "relief" value)) (under "size" value)

pairSpec :: Spec
pairSpec = do
  for_ placed $ \(name, way) ->
    it (name ++ ": the pair that it says, where it tells how it lies; to half a taxel") $ do
      cases <- drawn 24 ("register/" ++ name)
      those <- traverse (judged name way) cases
      -- Some tell, and not all.
      catMaybes those `shouldSatisfy` ((> 8) . length)
  it "gains are 1 to 3, and symmetries all eight" $ do
    gains <- drawn 40 "register/gain-and-offset"
    sort (nub [gain | (value, trial) <- gains, Just (gain, _) <- [gainOf value trial]])
      `shouldBe` [1, 2, 3]
    turns <- drawn 60 "register/turned-and-mirrored"
    length (nub [s | (value, trial) <- turns, s <- take 1 (symmetriesOf value trial)])
      `shouldBe` 8
  where
    placed =
      [ ( "known-displacement",
          \(Press step shift a b) pair -> [shift | pair == Pair a b step 3]
        ),
        ( "gain-and-offset",
          \(Press step shift a b) (Pair a' b' step' search) ->
            [ shift
              | step == step',
                search == 3,
                isJust (affineOf a a'),
                isJust (affineOf b b')
            ]
        ),
        ( "exchanged",
          \(Press step shift a b) pair ->
            [(0, 0) `minus` shift | pair == Pair b a ((0, 0) `minus` step) 3]
        ),
        ( "turned-and-mirrored",
          \(Press step shift a b) pair ->
            [ onOffset s shift
              | s <- symmetries,
                pair == Pair (onRows s a) (onRows s b) (onOffset s step) 3
            ]
        ),
        ( "another-step",
          \(Press step shift a b) (Pair a' b' step' search) ->
            [ shift
              | (a, b, search) == (a', b', 3),
                let (x, y) = step' `minus` step,
                abs x + abs y == 1,
                let (i, j) = shift `minus` step',
                max (abs i) (abs j) <= 3
            ]
        )
      ]
    gainOf value trial =
      let Press _ _ a _ = press value
       in listToMaybe (pairsOf trial) >>= affineOf a . pairFirst
    symmetriesOf value trial =
      let Press _ _ a _ = press value
       in [s | Pair a' _ _ _ <- pairsOf trial, s <- symmetries, onRows s a == a']
    pairsOf = pairsIn . snd . asked (registering (Registered Nothing (0, 0) (True, True)))
    judged name way (value, trial) = case pairsOf trial of
      [] -> do
        -- What is not asked does not tell.
        let Press step shift a b = press value
        (name, name == "known-displacement" && tells (Pair a b step 3) shift)
          `shouldBe` (name, False)
        fst (asked (registering (Registered Nothing (0, 0) (True, True))) trial)
          `shouldBe` NotMeant
        pure Nothing
      [pair] -> case way (press value) pair of
        truth : _ -> do
          tells pair truth `shouldBe` True
          let verdict reason by =
                passes (registering (Registered reason (real truth `plus` by) (True, True))) trial
          [verdict Nothing by | by <- (0, 0) : within 0.49] `shouldSatisfy` and
          [verdict Nothing by | by <- within 0.51] `shouldSatisfy` not . or
          [verdict (Just r) (0, 0) | r <- ["blank", "one-axis", "ambiguous", "no-overlap"]]
            `shouldSatisfy` not . or
          pure (Just truth)
        [] -> Nothing <$ expectationFailure (name ++ ": another pair for " ++ show value)
      several -> Nothing <$ expectationFailure (show (length several) ++ " questions")

registering :: Registered -> Question b -> b
registering answer question = case question of
  Register _ -> answer
  _ -> error "another question"

pairsIn :: [Question'] -> [Pair]
pairsIn questions = [pair | Question' (Register pair) <- questions]

refusedSpec :: Spec
refusedSpec = do
  it "blank: of the relief's two frames one, or both, in one grey value" $ do
    cases <- drawn 30 "register/blank"
    shown <- for cases $ \(value, trial) -> do
      let Press step _ a b = press value
      pair <- only "blank" trial
      (pairStep pair, pairSearch pair) `shouldBe` (step, 3)
      let kept = (pairFirst pair == a, pairSecond pair == b)
          verdict reason = passes (registering (Registered reason (9, 9) (True, True))) trial
      [flat (pairFirst pair) | not (fst kept)] `shouldSatisfy` and
      [flat (pairSecond pair) | not (snd kept)] `shouldSatisfy` and
      map verdict (others "blank") `shouldSatisfy` not . or
      verdict (Just "blank") `shouldBe` True
      pure kept
    sort (nub shown) `shouldBe` [(False, False), (False, True), (True, False)]
  it "one-axis: alike along the other axis; the displacement across the edges counts alone" $ do
    cases <- drawn 40 "register/one-axis"
    shown <- for cases $ \(value, trial) ->
      for (pairsIn (snd (asked (registering (none "one-axis")) trial))) (oneAxis value trial)
    sort (nub (concat shown)) `shouldBe` [False, True]
    -- Edges rise and fall.
    let ends =
          [ (first', last')
            | (_, trial) <- cases,
              pair <- pairsIn (snd (asked (registering (none "one-axis")) trial)),
              first' : rest <- concatMap (take 1) [pairFirst pair, transpose (pairFirst pair)],
              not (flat' (first' : rest)),
              last' <- take 1 (reverse rest)
          ]
    sort (nub [first' < last' | (first', last') <- ends]) `shouldBe` [False, True]
  it "periodic: the same again after 4 to 6 taxels along both axes, within the search" $ do
    cases <- drawn 30 "register/periodic"
    for_ cases $ \(value, trial) -> do
      pair <- only "ambiguous" trial
      let (w, h) = under "size" value :: (Int, Int)
          again rows = [p | p <- [4 .. 6], and (zipWith (==) (drop p rows) rows)]
          frames = [pairFirst pair, pairSecond pair]
      (pairStep pair, pairSearch pair) `shouldBe` (under "step" value, 6)
      map (\rows -> (length (concat (take 1 rows)), length rows)) frames
        `shouldBe` [(w + 8, h + 8), (w + 8, h + 8)]
      map (null . again) frames `shouldBe` [False, False]
      map (null . again . transpose) frames `shouldBe` [False, False]
      map flat frames `shouldBe` [False, False]
      verdicts "ambiguous" trial
  it "no-overlap: every displacement within the search is as long as the frame, or longer" $ do
    cases <- drawn 40 "register/no-overlap"
    sides <- for cases $ \(value, trial) -> do
      pair <- only "no-overlap" trial
      let Press _ _ a b = press value
          (w, h) = under "size" value
          (x, y) = pairStep pair
      (pairFirst pair, pairSecond pair, pairSearch pair) `shouldBe` (a, b, 3)
      (abs x - 3 >= w || abs y - 3 >= h) `shouldBe` True
      (abs x <= w + 9 && abs y <= h + 9) `shouldBe` True
      verdicts "no-overlap" trial
      pure (abs x > abs y, signum (if abs x > abs y then x else y))
    length (nub sides) `shouldBe` 4
  where
    only reason trial = case pairsIn (snd (asked (registering (none reason)) trial)) of
      [pair] -> pure pair
      several -> fail (show (length several) ++ " questions")
    verdicts reason trial = do
      passes (registering (none reason)) trial `shouldBe` True
      [passes (registering (Registered r (0, 0) (False, False))) trial | r <- others reason]
        `shouldSatisfy` not . or
    flat rows = flat' (concat rows)

-- | A refusal for this reason.
none :: String -> Registered
none reason = Registered (Just reason) (0, 0) (False, False)

-- | What is answered instead of this reason.
others :: String -> [Maybe String]
others reason =
  Nothing : map Just (filter (/= reason) ["blank", "one-axis", "ambiguous", "no-overlap"])

flat' :: [Natural] -> Bool
flat' values = length (nub values) <= 1

-- | A pair of edges all along one axis, and what is taken for right of it; whether the axis across
-- the edges is x.
oneAxis :: Value -> Ask Verdict -> Pair -> IO Bool
oneAxis value trial pair = do
  (pairStep pair, pairSearch pair) `shouldBe` (step, 3)
  -- Both show the same edges, alike along them.
  map (length . nub) edges `shouldBe` [1, 1]
  and (zipWith (==) (drop by rowA) (drop (negate by) rowB)) `shouldBe` True
  [maximum row >= minimum row + 4000 | row <- [rowA, rowB]] `shouldBe` [True, True]
  [verdict (Just "one-axis") d fixed | d <- [(0, 0), (0.49, 0), (-0.49, 99)]]
    `shouldSatisfy` and
  [verdict (Just "one-axis") d fixed | d <- [(0.51, 0), (-0.51, 0)]] `shouldSatisfy` not . or
  [verdict r (0, 0) fixed | r <- others "one-axis"] `shouldSatisfy` not . or
  map (verdict (Just "one-axis") (0, 0)) [(True, True), (False, False), (not across, across)]
    `shouldSatisfy` not . or
  pure across
  where
    step = under "step" value
    shift = step `plus` under "error" value
    across = all flat' (transpose (pairFirst pair))
    edges = map (if across then id else transpose) [pairFirst pair, pairSecond pair]
    (rowA, rowB) = (line (take 1 edges), line (drop 1 edges))
    line = concat . concatMap (take 1)
    by = fromInteger (if across then fst shift else snd shift)
    fixed = (across, not across)
    at d = real shift `plus` (if across then d else (snd d, fst d))
    verdict reason d fixed' = passes (registering (Registered reason (at d) fixed')) trial

-- * Several frames

surveySpec :: Spec
surveySpec = do
  for_ ways $ \(name, tolerance, way) ->
    it (name ++ ": the frames that it says; to " ++ show tolerance ++ " taxels, up to a shift") $ do
      cases <- drawn 12 ("stitch/" ++ name)
      for_ cases $ \(value, trial) -> do
        let truth = surveyed name value
        case framesIn trial of
          [] -> fst (asked (stitching []) trial) `shouldBe` NotMeant
          [frames] -> case way truth frames of
            errors : _ -> do
              let found = map real errors
                  count = fromIntegral (length errors) :: Double
                  verdict answers = passes (stitching answers) trial
                  -- Off by this much from the mean of all.
                  moved d = case found of
                    one : rest -> (one `plus` d) : rest
                    [] -> []
                  off size = [moved (dx, dy) | (dx, dy) <- within (size * count / (count - 1))]
              verdict found `shouldBe` True
              verdict (map (plus (3.7, -2)) found) `shouldBe` True
              map verdict (off (tolerance - 0.01)) `shouldSatisfy` and
              map verdict (off (tolerance + 0.01)) `shouldSatisfy` not . or
              map verdict [drop 1 found, found ++ take 1 found, []] `shouldSatisfy` not . or
            [] -> expectationFailure (name ++ ": other frames for " ++ show value)
          several -> expectationFailure (show (length several) ++ " questions")
  it "symmetries are all eight, gains 1 to 3" $ do
    turns <- drawn 100 "stitch/turned-and-mirrored"
    let shown = [(surveyed "" value, framesOf trial) | (value, trial) <- turns]
    length (nub [s | (truth, frames) <- shown, s <- take 1 (symmetriesOf truth frames)])
      `shouldBe` 8
  where
    framesOf = concat . framesIn
    ways =
      [ ("truth-stays", 0.25, \truth frames -> [map snd truth | frames == map fst truth]),
        ("known-displacements", 0.5, \truth frames -> [map snd truth | frames == map fst truth]),
        ( "order",
          0.5,
          \truth frames ->
            [ errors
              | length frames == length truth,
                Just errors <- [traverse (`lookup'` truth) frames],
                all ((`elem` frames) . fst) truth
            ]
        ),
        ( "moved",
          0.5,
          \truth frames ->
            [ map snd truth
              | (Placed _ (x, y), Placed _ (x', y')) : _ <- [zip frames (map fst truth)],
                let by = (x - x', y - y'),
                frames == [Placed rows (place `plus` by) | (Placed rows place, _) <- truth]
            ]
        ),
        ( "gain-and-offset",
          0.5,
          \truth frames ->
            [ map snd truth
              | [place | Placed _ place <- frames] == [place | (Placed _ place, _) <- truth],
                [Just _] <-
                  [ nub
                      [ affineOf rows rows'
                        | ((Placed rows _, _), Placed rows' _) <- zip truth frames
                      ]
                  ]
            ]
        ),
        ( "turned-and-mirrored",
          0.5,
          \truth frames ->
            [map (onOffset s . snd) truth | s <- symmetriesOf truth frames]
        )
      ]
    symmetriesOf truth frames =
      [ s
        | s <- symmetries,
          frames == [Placed (onRows s rows) (onOffset s place) | (Placed rows place, _) <- truth]
      ]
    lookup' frame truth = listToMaybe [e | (one, e) <- truth, one == frame]

-- | What is asked to be stitched, with a search of 2 taxels.
framesIn :: Ask Verdict -> [[Placed]]
framesIn trial = [frames | Question' (Stitch 2 frames) <- snd (asked (stitching []) trial)]

stitching :: [Taxels] -> Question b -> b
stitching answer question = case question of
  Stitch _ _ -> answer
  _ -> error "another question"

-- | The frames of a survey, each 16 x 16, 8 taxels from the next, with the error it was cut with.
surveyed :: String -> Value -> [(Placed, WholeTaxels)]
surveyed name value =
  [ (Placed (cut surface (16, 16) (place `plus` e)) place, e)
    | (place, e) <- zip [(8 * c, 8 * r) | r <- [0 .. rows - 1], c <- [0 .. columns - 1]] errors
  ]
  where
    (columns, rows) = under "size" value
    surface = relief (under "relief" value)
    errors
      | name == "truth-stays" = repeat (0, 0)
      | otherwise = under "errors" value
