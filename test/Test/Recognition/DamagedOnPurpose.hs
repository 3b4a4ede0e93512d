-- | Tests recognition when symbols are missing, wrong, unclear, in separate groups or in several
-- composites: pictures of cells of the array whose place is known, damaged on purpose.
module Test.Recognition.DamagedOnPurpose (spec) where

import Control.Monad (when)
import Data.Foldable (for_, toList)
import Data.List (nub, sort, sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (catMaybes, fromMaybe)
import qualified Data.Set as Set
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Classification.Calibration (standardCalibration)
import PraTactile.Classification.Estimate
import PraTactile.Classification.Part
import PraTactile.Classification.Reader (Reader (..))
import PraTactile.Classification.Templates
import PraTactile.Evaluate
import PraTactile.Explore
import PraTactile.Field
import PraTactile.Image
import PraTactile.Locate (Radius (..), Reason (..))
import PraTactile.Object.Placement
import PraTactile.Object.Radicals
import PraTactile.Recognise
import PraTactile.Registration hiding (stitch)
import PraTactile.Relief (classOn)
import PraTactile.Segmentation
import PraTactile.Sensor
import PraTactile.Sensor.Frame (movePoint, taxelPitch)
import PraTactile.Shape hiding (area)
import PraTactile.Symmetry
import Test.Effort
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck hiding (generate, tolerance)
import Test.Recognition.Setting
import Test.Support (below, rowsOf)
import Test.Touch.Paper (stitch)

spec :: Spec
spec = onPaper $ \setting -> do
  damageSpec setting
  doubtSpec setting

damageSpec :: KnownField k => Setting k -> Spec
damageSpec setting = do
  describe "missing symbols" $ do
    it "a 3 x 3 block may lack any four symbols, if four independent ones remain" $
      -- A quick run takes every fifth choice, which covers each of the places.
      for_
        ( everyNth (byEffort 5 1) $
            zip (choose4 [0 .. 8]) (cycle [Position 1 1, Position 5 6, Position 14 16])
        )
        $ \(gone, place) -> do
          let kept = [o | (i, o) <- zip [0 :: Int ..] offsets3, i `notElem` gone]
          let damaged = removing gone (cells 3 3 place)
          answer <- read' damaged
          let unique = and [differing kept place' place > 0 | place' <- everywhere, place' /= place]
          case answer of
            Right found@(Found _) -> (unique, placed place damaged found) `shouldBe` (True, True)
            other -> (unique, either refusalName (const "several") other) `shouldSatisfy` not . fst
    it "symbols in a row give the place if they suffice: five of a row, without a complete window" $
      for_ [Position 4 5, Position 8 0, Position 12 12] $ \place -> do
        let kept = [Position 0 j | j <- [0 .. 5]]
            unique = and [differing kept other place > 0 | other <- everywhere, other /= place]
        answer <- read' (cells 1 6 place)
        either (const False) (placed place (cells 1 6 place)) answer `shouldBe` unique
    it "an incomplete window is placed where the symbols are" $ do
      answer <- read' (removing [1, 3, 5, 7] (cells 3 3 (Position 4 5)))
      case answer of
        Right (Found found) -> do
          length (foundWindows found) `shouldBe` 0
          windowPosition (foundWindow found) `shouldBe` Position 4 5
          length (catMaybes (concat (windowClasses (foundWindow found)))) `shouldBe` 2
        _ -> expectationFailure "not located"
    it "symbols along an edge of a face are on that face, whichever windows they fill" $ do
      told <- mapM told' (concatMap edges (laidFaces (settingLayout setting)))
      [(face, spot, which) | (face, spot, Just which) <- told, which /= Just face] `shouldBe` []
      length [() | (_, _, Just _) <- told] `shouldSatisfy` (> 20)
  describe "wrong symbols" $ do
    it "any one symbol of a 3 x 3 block may be wrong or upside down, and is named" $
      for_ (zip [0 .. 8] (cycle [Position 0 0, Position 7 9, Position 13 15])) $ \(i, place) ->
        for_ wrongs $ \change -> do
          let damaged = changing i change (cells 3 3 place)
          recognition <- recognised damaged
          case recognisedAnswer recognition of
            Right found
              | placed place damaged found ->
                fmap (length . supportWrong) (recognisedSupport recognition) `shouldBe` Just 1
            Right _ -> expectationFailure "wrong"
            Left why -> expectationFailure (refusalName why)
    it "a block with two wrong symbols is never corrected to a third place: right, or refused" $
      for_ [(i, j) | i <- [0 .. 8], j <- [i + 1 .. 8]] $ \(i, j) -> do
        answer <- read' (changing i (otherBy 1) (changing j (otherBy 2) (cells 3 3 (Position 7 9))))
        answer
          `shouldSatisfy` either (const True) (placed (Position 7 9) (cells 3 3 (Position 7 9)))
    it "a 2 x 3 block, of distance 2, is refused with one wrong symbol" $
      for_ [0 .. 5] $ \i -> for_ [1, 2, 3] $ \by -> do
        answer <- read' (changing i (otherBy by) (cells 2 3 (Position 7 9)))
        answer `shouldSatisfy` either (const True) (const False)
    it "a radius beyond the guaranteed one answers more, at the caller's risk" $ do
      let damaged = changing 0 (otherBy 1) (cells 2 3 (Position 7 9))
          lax = Tolerance 0.9 (UpTo 1) 0 Nothing 0
      answer <- recognisedAnswer <$> recognisedWith lax [shown damaged]
      answer `shouldSatisfy` either (const False) (const True)
    it "there is no answer if no doubt is tolerated" $ do
      answer <-
        recognisedAnswer
          <$> recognisedWith
            (Tolerance 0 Guaranteed 0 Nothing 0)
            [shown (cells 2 2 (Position 6 5))]
      either Just (const Nothing) answer `shouldBe` Just (NotLocated BelowThreshold)
    it "a block of zeros is refused as zero-window" $ do
      answer <- read' (replicate 2 (replicate 2 (Just (0, id))))
      either Just (const Nothing) answer `shouldBe` Just (NotLocated ZeroWindow)
  describe "groups" $ do
    it "two groups a blank column apart are one patch, though neither suffices alone" $ do
      let apart = removing [1, 4] (cells 2 3 (Position 6 5))
      answer <- read' apart
      either (const False) (placed (Position 6 5) apart) answer `shouldBe` True
      alone <- read' (map (take 1) apart)
      either Just (const Nothing) alone `shouldBe` Just (NotLocated NoCompleteWindow)
    it "a group that is not a whole number of cells away contradicts the grid" $ do
      let image = beside 8 (drawing (cells 2 2 (Position 6 5))) (drawing (cells 2 2 (Position 6 8)))
      answer <- answerTo [compositeOf image]
      either Just (const Nothing) answer `shouldBe` Just GridContradicts
    it "whole groups that lead to different places are refused as contradicting windows" $ do
      let image =
            beside 16 (drawing (cells 2 2 (Position 6 5))) (drawing (cells 2 2 (Position 2 2)))
      answer <- answerTo [compositeOf image]
      either Just (const Nothing) answer `shouldBe` Just WindowsContradict
  describe "several composites of one face" $ do
    it "that are too small alone are enough together, whichever way the face lies" $
      for_
        [ (id, \c -> (25.4 * c, 0)),
          (onRaster (turned 2), \c -> (-25.4 * c, 0)),
          (onRaster (turned 1), \c -> (0, 25.4 * c))
        ]
        $ \(turn, shift) -> do
          let left = compositeOf (turn (drawing (cells 2 1 (Position 6 5))))
              right =
                (compositeOf (turn (drawing (cells 2 1 (Position 6 7)))))
                  { compositeOrigin = shift (2 :: Double)
                  }
          together <- answerTo [left, right]
          either
            (const False)
            (placed (Position 6 5) (removing [1, 4] (cells 2 3 (Position 6 5))))
            together
            `shouldBe` True
          for_ [left, right] $ \one' -> do
            alone <- answerTo [one']
            either Just (const Nothing) alone `shouldBe` Just (NotLocated NoCompleteWindow)
    it "count a symbol that both show twice" $ do
      let left = shown (cells 2 2 (Position 6 5))
          right = (shown (cells 2 2 (Position 6 6))) {compositeOrigin = (25.4, 0)}
      recognition <- recognisedWith standardTolerance [left, right]
      fmap supportAgreeing (recognisedSupport recognition) `shouldBe` Just 8
      fmap (map symbolCell . positionsOf) (rightOf (recognisedAnswer recognition))
        `shouldBe` Just (sort [Position (6 + i) (5 + j) | i <- [0, 1], j <- [0, 1, 1, 2]])
    it "outvote and name a composite that is a cell out of place beside larger ones" $ do
      let left = shown (cells 3 3 (Position 6 5))
          middle =
            (shown (cells 3 3 (Position 6 8))) {compositeOrigin = (3 * 25.4, 0)}
          right =
            (shown (cells 2 2 (Position 6 12))) {compositeOrigin = (6 * 25.4, 0)}
      recognition <- recognisedWith standardTolerance {toleratedDoubt = 0.1} [left, middle, right]
      fmap supportInconsistent (recognisedSupport recognition) `shouldBe` Just [2]
      either
        (const False)
        (placed (Position 6 5) (cells 3 6 (Position 6 5)) . withoutSource 2 recognition)
        (recognisedAnswer recognition)
        `shouldBe` True
    it "name a composite exactly if more than half of its certain symbols are wrong" $
      for_ [(1, 0), (1, 1), (2, 0), (2, 1), (3, 1), (3, 2)] $ \(n, wrong) -> do
        let left = shown (cells 3 3 (Position 6 5))
            line = foldr (\i -> changing i (otherBy 1)) (cells 1 n (Position 6 8)) [0 .. wrong - 1]
            right = (shown line) {compositeOrigin = (3 * 25.4, 0)}
        recognition <- recognisedWith standardTolerance [left, right]
        (n, wrong, fmap supportInconsistent (recognisedSupport recognition))
          `shouldBe` (n, wrong, Just [1 | 2 * wrong > fromIntegral n])
    it "contradict each other if they are a cell out of place" $ do
      let left = shown (cells 2 2 (Position 6 5))
          right =
            (shown (cells 2 2 (Position 6 8))) {compositeOrigin = (2 * 25.4, 0)}
      answer <- answerTo [left, right]
      answer `shouldSatisfy` either (const True) (const False)
  describe "parts of symbols" $ do
    it "a 2 x 2 block cut through its last row or column, or its first, is found by the rest" $
      for_ [Position 6 5, Position 4 5, Position 8 5] $ \place -> for_ [0 .. 5] $ \cut -> do
        let whole = drawing (cells 2 2 place)
            (w, h) = rasterSize whole
        for_
          [ (0, 0, w, h - 4 - cut),
            (0, 4 + cut, w, h),
            (0, 0, w - 4 - min 3 cut, h),
            (4 + min 3 cut, 0, w, h)
          ]
          $ \(l, t, r, b) -> do
            answer <- answerTo [compositeOf (cropped (l, t, r, b) whole)]
            (cut, fmap (map symbolCell . positionsOf) (rightOf answer))
              `shouldBe` (cut, Just (sort (blockFrom 2 2 place)))
    it "a part is not counted as a symbol, and a flat place is no part" $ do
      recognition <-
        recognisedWith
          standardTolerance
          [compositeOf (cropped (0, 0, 32, 32) (drawing (cells 2 2 (Position 6 5))))]
      (length (recognisedSymbols recognition), length (recognisedParts recognition))
        `shouldBe` (2, 2)
      map readClass (recognisedParts recognition) `shouldBe` [Nothing, Nothing]
      flat <- recognised (removing [3] (cells 2 2 (Position 6 5)))
      length (recognisedParts flat) `shouldBe` 0
    it "of any rectangle of a symbol the likeliest shape is one that contains it" $
      for_ (zip [0 ..] (shapes alphabetOfAll)) $ \(c, shape) ->
        for_ [identity, turned 2] $ \symmetry ->
          for_
            ( everyNth
                (byEffort 3 1)
                [ (l, t, r, b)
                  | l <- [0, 2, 4],
                    r <- [4, 6, 8],
                    r > l,
                    t <- [0, 3, 6],
                    b <- [6, 9, 12],
                    b > t
                ]
            )
            $ \(l, t, r, b) -> do
              let image = onRaster symmetry (toRaster shape)
                  seen = generate 8 12 (\x y -> if x >= l && x < r && y >= t && y < b then 1 else 0)
                  masked =
                    generate
                      8
                      12
                      (\x y -> fromMaybe 0 (index image x y) * fromMaybe 0 (index seen x y))
                  part = Part masked seen
                  e = estimatePart (templates alphabetOfAll) 0 part
                  (distances, _) = partDistances (templates alphabetOfAll) part
                  inPlace = lookup (c, symmetry) distances >>= lookup (0, 0)
                  bestInPlace = lookup (estimateLikeliest e) distances >>= lookup (0, 0)
              inPlace `shouldBe` Just 0
              -- Another shape that contains it is likelier if it also contains it when moved.
              bestInPlace `shouldBe` Just 0
              estimateChance e (c, symmetry)
                `shouldSatisfy` \p -> p > estimateChance e (estimateLikeliest e) / 8
              sum (map snd (estimateChances e)) `shouldSatisfy` \sum' -> abs (sum' - 1) < 1e-9
  describe "surfaces" $ do
    it "a window across the array's edge is on the torus, on no object, and not on the sheet" $
      for_ [Position 14 3, Position 5 16, Position 14 16] $ \place -> do
        onTorus <- read' (cells 2 2 place)
        case onTorus of
          Right (Found found) ->
            (windowPosition (foundWindow found), onFace (windowWhereabouts (foundWindow found)))
              `shouldBe` (place, False)
          _ -> expectationFailure "not on the torus"
        onSheet <- recognisedOn Sheet standardTolerance [compositeOf (drawing (cells 2 2 place))]
        recognisedAnswer onSheet `shouldSatisfy` either (const True) (const False)
    it "windows in the sheet's corners are found on the sheet" $
      for_ [Position r c | r <- [0, 13], c <- [0, 15]] $ \place -> do
        let cells' = cells 2 2 place
        onSheet <- recognisedOn Sheet standardTolerance [shown cells']
        either (const False) (placed place cells') (recognisedAnswer onSheet) `shouldBe` True
    it "windows of the torus are found, and lie on a face exactly if the face has them" $ do
      let onFaces =
            [ Position (row at + i) (column at + j)
              | face <- laidFaces (settingLayout setting),
                let (Shape high wide, at) = (laidGrid face, laidAt face),
                i <- [0 .. high - 2],
                j <- [0 .. wide - 2]
            ]
      (length onFaces, length (nub everywhere)) `shouldBe` (132, 255)
      for_ (everyNth (byEffort 8 1) everywhere) $ \place -> do
        answer <- read' (cells 2 2 place)
        let told = case answer of
              Right (Found found) ->
                Just
                  ( windowPosition (foundWindow found),
                    onFace (windowWhereabouts (foundWindow found))
                  )
              _ -> Nothing
        told `shouldBe` Just (place, place `elem` onFaces)
  where
    recognisedOn surface = recognisedIn (recogniserOn surface setting)
    recognisedWith = recognisedOn Torus
    answerTo composites = recognisedAnswer <$> recognisedWith standardTolerance composites
    recognised cells' = recognisedWith standardTolerance [shown cells']
    read' cells' = answerTo [shown cells']
    -- Rows and columns of cells along the edges of a face.
    edges laid =
      [ (laidFace laid, h, w, Position (row at + i) (column at + j))
        | let (Shape high wide, at) = (laidGrid laid, laidAt laid),
          (h, w, i, j) <-
            [ (1, wide, 0, 0),
              (1, wide, high - 1, 0),
              (high, 1, 0, 0),
              (high, 1, 0, wide - 1),
              (1, wide - 1, high - 1, 1)
            ]
      ]
    told' (face, h, w, at) = do
      answer <- read' (cells h w at)
      pure . (,,) face at $ case answer of
        Right (Found found) -> Just $ case windowWhereabouts (foundWindow found) of
          OnFace place -> Just (placeFace place)
          _ -> Nothing
        _ -> Nothing
    onFace w = case w of
      OnFace _ -> True
      _ -> False
    array = settingArray setting
    alphabetOfAll = readerAlphabet (settingReader setting)
    codeAt = classesOf array 1 1
    cells high wide = asDrawn . classesOf array high wide
    drawing = drawingOf alphabetOfAll
    shown = compositeOf . drawing
    blockFrom h w (Position r c) =
      [ Position ((r + i) `mod` 15) ((c + j) `mod` 17)
        | i <- below (h :: Natural),
          j <- below (w :: Natural)
      ]
    cropped (l, t, r, b) image =
      generate (r - l) (b - t) (\x y -> fromMaybe 0 (index image (x + l) (y + t)))
    withoutSource source recognition answer = case answer of
      Found found ->
        Found
          found
            { foundPlaces =
                Map.withoutKeys
                  (foundPlaces found)
                  ( Set.fromList
                      [readNumber s | s <- recognisedSymbols recognition, readSource s == source]
                  )
            }
      other -> other
    rightOf = either (const Nothing) Just
    positionsOf answer = case answer of
      Found found -> sortOn symbolCell (toList (foundPlaces found))
      Several _ _ -> []
    offsets3 = [Position i j | i <- [0 .. 2], j <- [0 .. 2]]
    differing kept (Position r c) (Position r' c') =
      length
        [ ()
          | Position i j <- kept,
            codeAt (Position (r + i) (c + j)) /= codeAt (Position (r' + i) (c' + j))
        ]
    wrongs = [otherBy 1, otherBy 2, otherBy 3, \(c, change) -> (c, onRaster (turned 2) . change)]
    otherBy by (c, change) = ((c + by) `mod` 4, change)
    -- Every drawn symbol is placed at its cell of the block whose upper left cell is at the
    -- position.
    placed :: Position -> Drawn -> Identification -> Bool
    placed (Position r c) drawn answer = case answer of
      Found found ->
        sort (map symbolCell (toList (foundPlaces found)))
          == sort
            [ Position ((r + i) `mod` 15) ((c + j) `mod` 17)
              | (i, line) <- zip [0 ..] drawn,
                (j, Just _) <- zip [0 ..] line
            ]
      Several _ _ -> False

-- | Two images side by side, with this many blank columns between them.
beside :: Int -> Raster -> Raster -> Raster
beside gap a b =
  pasted
    (rasterWidth a + gap + rasterWidth b, max (rasterHeight a) (rasterHeight b))
    [(0, 0, a), (rasterWidth a + gap, 0, b)]

removing :: [Int] -> Drawn -> Drawn
removing gone = numbered (\i cell -> if i `elem` gone then Nothing else cell)

changing :: Int -> ((Int, Raster -> Raster) -> (Int, Raster -> Raster)) -> Drawn -> Drawn
changing at change = numbered (\i cell -> if i == at then change <$> cell else cell)

numbered :: (Int -> a -> b) -> [[a]] -> [[b]]
numbered f cells =
  [[f (i * wide + j) cell | (j, cell) <- zip [0 ..] line] | (i, line) <- zip [0 ..] cells]
  where
    wide = maximum (0 : map length cells)

-- | Every n-th element, from the first on.
everyNth :: Int -> [a] -> [a]
everyNth n list = [item | (k, item) <- zip [0 ..] list, k `mod` n == 0]

choose4 :: [Int] -> [[Int]]
choose4 xs = [[a, b, c, d] | a <- xs, b <- xs, a < b, c <- xs, b < c, d <- xs, c < d]

-- | Are the doubts of symbols honest? Simulated explorations, whose truth is known.
doubtSpec :: KnownField k => Setting k -> Spec
doubtSpec setting = describe "the doubt of a symbol" $ do
  -- The bounds leave more room to the few trials of a quick run, which notices if many symbols are
  -- read wrong.
  for_ (byEffort [(0.1, 6), (0.4, 8)] [(0.1, 60), (0.3, 30), (0.4, 40)]) $ \(noise, count) ->
    it ("is at least the share of wrong symbols, with noise " ++ show noise) $ do
      let doubts =
            concatMap
              (judged noise)
              ( catMaybes
                  ( take
                      count
                      ( trials
                          ( exploration
                              standardSensor {sensorNoise = noise}
                              (AmongTurns halfTurns)
                              standardRegionSize
                          )
                          faces
                          77
                      )
                  )
              )
          expected = sum (map fst doubts)
          wrong = fromIntegral (length (filter snd doubts)) :: Double
      length doubts `shouldSatisfy` (> byEffort count 100)
      -- Wrong symbols come in clusters, several to a badly stitched composite, and so vary more
      -- than independent ones.
      wrong `shouldSatisfy` (<= expected + 5 * sqrt (expected + 1))
      when (noise > 0.35) $ wrong `shouldSatisfy` (>= expected - 5 * sqrt (expected + 1))
  -- Parts are often in doubt, and bounds for the few of a quick run would notice nothing.
  whenFull . it "is at least the share of wrong ones for parts of symbols, too" $ do
    let reader = recogniserOf setting
        ofParts t = case stitch standardRegistration (trialFrames t)
          >>= \c -> either (const (Left NoFrames)) (Right . (,) c) (recognise reader c) of
          Left _ -> []
          Right (composite, recognition) ->
            [ ( readDoubt part,
                (c, o) /= (truth, regionSymmetry (trialRegion t))
              )
              | part <- recognisedParts recognition,
                let (o, c) = readLikeliest part,
                Just truth <-
                  [ classAt
                      t
                      ( movePoint
                          (regionMotion (trialRegion t))
                          (compositePosition composite (symbolCentre (readImage part)))
                      )
                  ]
            ]
        doubts =
          concatMap
            ofParts
            (catMaybes (take 75 (trials smaller faces 78)))
        smaller = exploration standardSensor (AmongTurns rotations) (36, 46)
        expected = sum (map fst doubts)
        wrong = fromIntegral (length (filter snd doubts)) :: Double
    length doubts `shouldSatisfy` (> 150)
    wrong `shouldSatisfy` (<= expected + 5 * sqrt (expected + 1))
  withCases 25 200 $
    prop "is between 10^-7 and that of a blind choice, for any image" $
      forAll (vectorOf 96 (choose (-1, 2))) $ \values ->
        case fromRows (rowsOf 8 values) of
          Left e -> counterexample (show e) False
          Right image -> case estimate sure (templates alphabetOfAll) net image of
            Left e -> counterexample (show e) False
            Right e ->
              counterexample
                (show e)
                ( estimateDoubt e >= leastDoubt / 2
                    && estimateDoubt e <= 7 / 8 + 1e-9
                    && abs (sum (map snd (estimateChances e)) - 1) < 1e-9
                )
  it "is least for the shapes themselves, which are read right in both orientations" $
    for_ (zip [0 ..] (shapes alphabetOfAll)) $ \(c, shape) ->
      for_ [identity, turned 2] $ \symmetry ->
        case estimate
          sure
          (templates alphabetOfAll)
          net
          (onRaster symmetry (toRaster shape)) of
          Left e -> expectationFailure (show e)
          Right e -> do
            estimateLikeliest e `shouldBe` (c, symmetry)
            estimateDoubt e `shouldSatisfy` (< 1e-4)
  it "each shape matches itself, and no other shape nearly as well" $
    for_ (zip [0 ..] (shapes alphabetOfAll)) $ \(c, shape) ->
      for_ [0 .. 3] $ \other ->
        match (templates alphabetOfAll) other (toRaster shape)
          `shouldSatisfy` if other == c
            then (> 0.999)
            else (< 0.8)
  where
    faces = facesFelt setting
    alphabetOfAll = readerAlphabet (settingReader setting)
    net = readerNetwork (settingReader setting)
    sure = standardCalibration 4
    -- The doubt of each symbol, and whether its likeliest class is wrong.
    judged noise t = case stitch standardRegistration {registrationNoise = noise} (trialFrames t) of
      Left _ -> []
      Right composite ->
        [ (estimateDoubt e, estimateLikeliest e /= (truth, regionSymmetry (trialRegion t)))
          | symbol <- segmentedSymbols (segment composite),
            Right e <-
              [estimate sure (templates alphabetOfAll) net (symbolPixels symbol)],
            Just truth <-
              [ classAt
                  t
                  ( movePoint
                      (regionMotion (trialRegion t))
                      (compositePosition composite (symbolCentre symbol))
                  )
              ]
        ]
    classAt t (x, y)
      | i >= 0 && j >= 0 && i < fromIntegral (rows (laidGrid face)) && j
          < fromIntegral
            ( columns
                (laidGrid face)
            )
          && abs (fj - centre j)
          < 0.3
          && abs (fi - centre i)
          < 0.3 =
        Just (classOn (settingArray setting) face (Position (fromInteger i) (fromInteger j)))
      | otherwise = Nothing
      where
        face = trialFace t
        fj = (x - nearestDouble (spotRight (laidMargin face))) / (16 * taxelPitch)
        fi = (y - nearestDouble (spotDown (laidMargin face))) / (20 * taxelPitch)
        (i, j) = (floor fi, floor fj) :: (Integer, Integer)
        centre n = fromIntegral n + 0.5 :: Double
