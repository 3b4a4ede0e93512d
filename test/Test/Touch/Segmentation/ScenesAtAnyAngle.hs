{-# LANGUAGE OverloadedStrings #-}

-- | Tests segmentation at any angle, and beside foreign things.
module Test.Touch.Segmentation.ScenesAtAnyAngle (spec) where

import Data.Aeson (Value (..))
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Foldable (for_, toList)
import Data.List (isInfixOf, sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as V
import PraTactile.Array
import PraTactile.Classification.Shipped (shippedReader)
import PraTactile.Composite.Skew (skew, skews)
import PraTactile.Decode
import PraTactile.Field (toCode)
import PraTactile.Image
import PraTactile.Profile
import PraTactile.Random (normals)
import PraTactile.Recognise
import PraTactile.Recognise.Features
import PraTactile.Registration (Composite (..), compositeOf)
import PraTactile.Segmentation (Cause (..), Reject (..), SymbolImage (..), maskForeign)
import PraTactile.Segmentation.Foreign (ForeignMasked (..))
import System.Random (mkStdGen)
import Test.CommandLine.Run
import Test.Effort (byEffort)
import Test.Hspec
import Test.Support
import Test.Touch.Sensor.MeanHeights (embossing)

spec :: Spec
spec = do
  describe "at any angle" anyAngle
  describe "beside foreign things" besideForeign
  describe "the command segment" commandSpec

-- | A part of the paper's array in a composite of 'wide' x 'high' pixels: the array's cell that the
-- middle of cell (3, 3) of the scene is, the angle of its axes (degrees clockwise), and where that
-- middle lies from the composite's, in taxels along the symbols' axes.
data Scene = Scene (Int, Int) Double (Double, Double)

-- | The scene with this number.
sceneOf :: Int -> Double -> Scene
sceneOf k angle =
  Scene
    (k `mod` 15, (7 * k) `mod` 17)
    angle
    (fromIntegral (k * 5 `mod` 17) - 8, fromIntegral (k * 7 `mod` 21) - 10)

wide, high :: Int
(wide, high) = (56, 64)

-- | The codes of the paper's array.
codes :: [[Int]]
codes =
  either (const []) id $
    withProfile canonicalProfile $ \array _ ->
      [[toCode (cellAt array (Position r c)) | c <- [0 .. 16]] | r <- [0 .. 14]]

-- | The cells of the array in a scene, each with the centre of its symbol in the composite.
centres :: Scene -> [((Int, Int), (Double, Double))]
centres scene@(Scene (r, c) _ _) =
  [ (((r + i) `mod` 15, (c + j) `mod` 17), place scene (16 * fromIntegral j, 20 * fromIntegral i))
    | i <- [-3 .. 3],
      j <- [-4 .. 4]
  ]

-- | The place in the composite that is this many taxels from the scene's cell, along its axes.
place :: Scene -> (Double, Double) -> (Double, Double)
place (Scene _ angle (ox, oy)) (u, v) =
  (fromIntegral (wide - 1) / 2 + c * x - s * y, fromIntegral (high - 1) / 2 + s * x + c * y)
  where
    (x, y) = (u + ox, v + oy)
    (c, s) = (cos (angle * pi / 180), sin (angle * pi / 180))

-- | Whether a symbol's whole box lies in the composite.
whole :: Scene -> (Double, Double) -> Bool
whole (Scene _ angle _) (x, y) =
  and
    [ inside (x + c * u - s * v) wide && inside (y + s * u + c * v) high
      | u <- [-4, 4],
        v <- [-6, 6]
    ]
  where
    inside t size = t >= 0 && t <= fromIntegral size - 1
    (c, s) = (cos (angle * pi / 180), sin (angle * pi / 180))

-- | The composite of a scene: background 0.2, embossing 0.6, and over it the values of a function,
-- each pixel the mean of 16 points; with noise of this standard deviation.
drawnWith :: Int -> Double -> ((Double, Double) -> Maybe Double) -> Scene -> Composite
drawnWith seed sd foreign' (Scene (r, c) angle (ox, oy)) =
  compositeOf (generate wide high (\x y -> clip (pixel x y + sd * noiseAt x y)))
  where
    clip = max 0 . min 1
    (noise, _) = normals (wide * high) (mkStdGen seed)
    noiseAt x y = fromMaybe 0 (noise V.!? (y * wide + x))
    pixel x y =
      sum [at (fromIntegral x + a) (fromIntegral y + b) | a <- points, b <- points] / 16
    points = [-0.375, -0.125, 0.125, 0.375]
    at x y = fromMaybe (if embossed x y then 0.6 else 0.2) (foreign' (x, y))
    (co, si) = (cos (angle * pi / 180), sin (angle * pi / 180))
    embossed x y = fromMaybe False $ do
      let (dx, dy) = (x - fromIntegral (wide - 1) / 2, y - fromIntegral (high - 1) / 2)
          (u, v) = (co * dx + si * dy - ox + 8, co * dy - si * dx - oy + 10)
          (j, i) = (floor (u / 16), floor (v / 20)) :: (Int, Int)
      code <- Map.lookup ((r + i) `mod` 15, (c + j) `mod` 17) coded
      bitmap <- Map.lookup code shapesByCode
      value <- index bitmap (floor u - 16 * j - 4) (floor v - 20 * i - 4)
      pure (value > 0.5)

coded :: Map.Map (Int, Int) Int
coded = Map.fromList [((i, j), v) | (i, line) <- zip [0 ..] codes, (j, v) <- zip [0 ..] line]

shapesByCode :: Map.Map Int Raster
shapesByCode = Map.fromList (zip [0 ..] embossing)

apart :: (Double, Double) -> (Double, Double) -> Double
apart (x, y) (x', y') = sqrt ((x - x') ^ (2 :: Int) + (y - y') ^ (2 :: Int))

-- | The features that recognition uses before it asks the array.
shownBy :: Composite -> IO Features
shownBy composite =
  either (fail . show) (either (fail . show) pure . (`features` composite)) (shippedReader 4)

anyAngle :: Spec
anyAngle = do
  it "symbols are found in place, with their axes and neighbours" $
    for_ scenes $ \(k, scene@(Scene _ angle _)) -> do
      seen <- featuresSymbols <$> shownBy (drawnWith k 0.05 (const Nothing) scene)
      let true = map snd (centres scene)
          nearest at = take 1 (sortOn (apart at) true)
          expected = [at | at <- true, whole scene at]
      (k, [at | at <- expected, all ((> 0.7) . apart at . featuredAt) seen]) `shouldBe` (k, [])
      (k, [s | s <- seen, at <- nearest (featuredAt s), apart at (featuredAt s) > 0.7])
        `shouldBe` (k, [])
      for_ seen $ \s -> do
        let off = featuredAxis s - angle
        (k, abs (off - 180 * fromIntegral (round (off / 180) :: Int)))
          `shouldSatisfy` ((< 1) . snd)
        for_ (directions (featuredAxis s) (featuredNeighbours s)) $ \(given, there) -> do
          let target = featuredAt s `plus` there
              found = [featuredAt o | o <- seen, apart target (featuredAt o) < 2]
          (k, fmap (plus (featuredAt s)) given) `shouldSatisfy` agrees found . snd
  it "the skew lies in [-45, 45), and is right up to quarter turns" $
    for_ ((,) <$> byEffort [1] [1, 2] <*> ([-46, -45.4 .. -44] ++ [44, 44.6 .. 46])) $
      \(k, angle) ->
        case skew [drawnWith k 0.05 (const Nothing) (sceneOf k angle)] of
          Just found -> do
            (k, angle, found) `shouldSatisfy` (\(_, _, t) -> t >= -45 && t < 45)
            (k, angle, upToQuarters found angle) `shouldSatisfy` (\(_, _, t) -> t < 1)
          Nothing -> expectationFailure (show (k, angle))
  it "the skews of two scenes together are those of each, before any other" $
    for_ ((,) <$> byEffort [3] [1 .. 6] <*> [-40, -20 .. 40]) $ \(k, angle) -> do
      let own = [angle, angle + 30]
          found = take 2 (skews [drawnWith k 0.05 (const Nothing) (sceneOf k a) | a <- own])
      (k, angle, found)
        `shouldSatisfy` (\(_, _, ts) -> and [any ((< 1) . upToQuarters a) ts | a <- own])
  it "incomplete symbols are reported as parts, with the visible share" $
    for_ scenes $ \(k, scene) -> do
      segmented <- shownBy (drawnWith k 0.05 (const Nothing) scene)
      for_ (featuresParts segmented) $ \part -> do
        let at = incompleteAt part
        (k, at, minimum (map (apart at . snd) (centres scene)))
          `shouldSatisfy` (\(_, _, d) -> d < 1)
        (k, at, incompleteSeen part) `shouldSatisfy` (\(_, _, seen) -> seen >= 1 / 16 && seen <= 1)
        (k, whole scene at && all ((> 2) . apart at . featuredAt) (featuresSymbols segmented))
          `shouldBe` (k, False)
  where
    scenes =
      [ (k, sceneOf k (fromIntegral (k * 67 `mod` 720) / 2))
        | k <- byEffort [2, 7, 12] [1 .. 12]
      ]
    plus (x, y) (x', y') = (x + x', y + y')
    -- The difference between two angles, up to quarter turns.
    upToQuarters a b = let t = (a - b) / 90 in 90 * abs (t - fromIntegral (round t :: Int))
    directions axis beside =
      [ (neighbourRight beside, along 16 0),
        (neighbourLeft beside, along (-16) 0),
        (neighbourUp beside, along 0 (-20)),
        (neighbourDown beside, along 0 20)
      ]
      where
        along u v =
          ( cos (axis * pi / 180) * u - sin (axis * pi / 180) * v,
            sin (axis * pi / 180) * u + cos (axis * pi / 180) * v
          )
    -- Only if a symbol was found there, and then that symbol.
    agrees found given = case given of
      Nothing -> null found
      Just at -> any ((< 1e-6) . apart at) found

-- | A thing on a scene: its name, its height at places in pixels, the distance from it, and the
-- reason for rejecting it.
data Thing
  = Thing
      String
      ((Double, Double) -> Maybe Double)
      ((Double, Double) -> Double)
      (Maybe Cause)

things :: [Thing]
things =
  [ bar "a bar of twice the height" 1 (Just TooLarge),
    bar "a bar of the same height" 0.6 (Just TooLarge),
    bar "a bar of half the height" 0.4 Nothing,
    Thing "a hole" (covering hole 0) hole (Just Hollow),
    Thing "a screw head" screw (\at -> apart at (20, 40) - 5) Nothing,
    Thing "an edge, and nothing beyond" (covering edge 0) edge (Just Hollow),
    Thing "a saturated plateau" (covering plateau 1) plateau (Just TooLarge)
  ]
  where
    covering distance value at = if distance at <= 0 then Just value else Nothing
    bar name value = Thing name (covering line value) line
    line (x, y) = abs (0.8 * (x - 25) + 0.6 * (y - 30)) - 2.5
    hole at = apart at (30, 22) - 6
    edge (x, y) = 20 - (0.6 * x + 0.8 * y)
    plateau (x, y) = max (abs (x - 14) - 12) (abs (y - 40) - 14)
    screw (x, y)
      | apart (x, y) (20, 40) > 5 = Nothing
      | abs (x - 20 + y - 40) < 1.4 = Just 0.2
      | otherwise = Just 0.6

besideForeign :: Spec
besideForeign = do
  for_ things $ \(Thing name foreign' distance cause) ->
    it (name ++ " is no symbol, and hides none that is two taxels from it") $
      for_ scenes $ \(k, scene) -> do
        let composite = drawnWith k 0.05 foreign' scene
        segmented <- shownBy composite
        let seen = featuresSymbols segmented
            clear =
              [ at
                | (_, at) <- centres scene,
                  whole scene at,
                  -- The corner of a symbol is up to 7.2 taxels from its middle.
                  distance at > 9.2
              ]
        (k, [at | at <- clear, all ((> 1) . apart at . featuredAt) seen]) `shouldBe` (k, [])
        [why | Reject _ why <- featuresRejects segmented]
          `shouldSatisfy` (\whys -> maybe True (`elem` whys) cause)
        -- Whatever else was masked, recognition does not answer wrongly.
        case canonicalRecogniser of
          Left e -> expectationFailure (show e)
          Right reader -> do
            recognition <-
              either (fail . show) pure (decodeComposites standardTolerance reader [composite])
            (k, misplaced scene recognition) `shouldBe` (k, [])
  it "foreign regions do not depend on the sensor's gain and offset" $
    for_ aFew $ \(Thing name foreign' _ _) -> for_ (take 2 scenes) $ \(k, scene) -> do
      let composite = drawnWith k 0.03 foreign' scene
          image = mapRaster (\v -> 0.35 + 0.5 * v) (compositeImage composite)
          dimmed = composite {compositeImage = image}
          taken c = (compositeCoverage (maskedComposite c), maskedRejects c)
      (name, k, taken (maskForeign dimmed) == taken (maskForeign composite))
        `shouldBe` (name, k, True)
  it "a composite without foreign things is unchanged" $
    for_ scenes $ \(k, scene) -> do
      let composite = drawnWith k 0.05 (const Nothing) scene
      maskForeign composite `shouldBe` ForeignMasked composite Nothing []
  where
    -- One that stands beside the symbols, and one that is sunken.
    aFew = byEffort (take 2 (drop 2 things)) things
    scenes =
      [ (k, sceneOf k (if even k then 37 * fromIntegral k else 180))
        | k <- byEffort [4] [1 .. 4]
      ]
    -- The symbols of an answer that are said to be other cells of the array than they are.
    misplaced scene recognition = case recognisedAnswer recognition of
      Right (Found there) ->
        [ (at, symbolCell cell)
          | s <- recognisedSymbols recognition,
            let at = symbolCentre (readImage s),
            Just cell <- [Map.lookup (readNumber s) (foundPlaces there)],
            (true, nearest) <- take 1 (sortOn (apart at . snd) (centres scene)),
            apart at nearest < 3,
            symbolCell cell /= positionOf true
        ]
      _ -> []
    positionOf (i, j) = Position (fromIntegral i) (fromIntegral j)

commandSpec :: Spec
commandSpec = do
  it "finds the symbols that decode reads, where it reads them" $ do
    (0, found, "") <- praAlone ["segment", "--json", worked]
    (0, answer, "") <- praAlone ["decode", "--json", worked]
    let places out = case key ["symbols"] out of
          Just (Array list) ->
            [(KeyMap.lookup "x" o, KeyMap.lookup "y" o) | Object o <- toList list]
          _ -> []
    length (places found) `shouldSatisfy` (>= 4)
    places found `shouldBe` places answer
  it "describes symbols in words, and a blank composite, too" $
    inFolder $ \folder -> do
      (0, out, "") <- praAlone ["segment", worked]
      out `shouldSatisfy` ("symbol at" `isInfixOf`)
      writeFile (folder ++ "/blank.pgm") (unlines ("P2 40 52 255" : replicate 2080 "0"))
      praAlone ["segment", folder ++ "/blank.pgm"] >>= (`shouldBe` (1, "nothing is embossed\n", ""))
  where
    worked = "data/worked-example/composite.pgm"
