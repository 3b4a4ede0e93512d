{-# LANGUAGE OverloadedStrings #-}

-- | Pictures of how frames were put together: every frame where it was said to be, and where it was
-- found.
module Test.App.AssembliesDrawn (spec) where

import Data.List (isInfixOf)
import Data.Text (Text)
import Drawing
import Picture.Assembly
import PraTactile.Image
import PraTactile.Registration hiding (assemble)
import PraTactile.Sensor.Frame
import Test.Hspec hiding (around)
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck hiding (generate)
import Test.Touch.Paper (assemble)

spec :: Spec
spec = modifyMaxSuccess (const 40) $ do
  prop "the correction is the found place minus the nominal one, and the arrow points along it" $
    forAll poses $ \at -> withAssembly Incremental (frames at) $ \drawing made ->
      let shifts = map registeredShift (assemblyFrames made)
          nominal = centres "nominal" drawing
          found = centres "found" drawing
          corrections = zipWith minus found nominal
          unit = widthOf "nominal" drawing / 16
       in counterexample (show (shifts, corrections)) $
            length nominal === length at
              .&&. conjoin (zipWith (near 1e-6) corrections (map (times unit) shifts))
              .&&. conjoin
                [ counterexample (show (a, b)) (abs (fst a * snd b - snd a * fst b) < 1e-3)
                  | (Just a, b) <- zip (arrows drawing) shifts
                ]
  prop "nominal places lie to one another as the poses do, and each frame has its number" $
    forAll poses $ \at -> withAssembly Nominal (frames at) $ \drawing _ ->
      let nominal = centres "nominal" drawing
          unit = widthOf "nominal" drawing / 16
          from (x, y) = [(unit * (u - x), unit * (v - y)) | (u, v) <- at]
          apart = concat [map (`minus` c) nominal | c <- take 1 nominal]
       in conjoin (zipWith (near 1e-6) apart (concatMap from (take 1 at)))
            .&&. [w | Mark "number" (Words _ _ _ w) <- drawing]
              === map show (take (length at) [0 :: Int ..])
  it "a frame that overlaps no other is dashed, and named in words" $ do
    let at = [(0, 0), (8, 0), (60, 50)]
    either (expectationFailure . show) id $ do
      made <- assemble Nominal standardRegistration (frames at)
      let drawing = assemblyDrawing "folder" (named (frames at)) made
          texts = [w | Mark "note" (Words _ _ _ w) <- drawing]
          found = [dashed paint | Mark "found" (Rectangle paint _) <- drawing]
      pure $ do
        found `shouldBe` [False, False, True]
        filter ("file2" `isInfixOf`) texts `shouldSatisfy` ((== 1) . length)
        filter ("2 groups" `isInfixOf`) texts `shouldSatisfy` ((== 1) . length)
  it "without an overlap there is no residual, and a correction of 0 has no arrow" $
    either (expectationFailure . show) id $ do
      made <- assemble Nominal standardRegistration (frames [(0, 0), (40, 0)])
      let drawing = assemblyDrawing "folder" (named (frames [(0, 0), (40, 0)])) made
      pure $ do
        [w | Mark "note" (Words _ _ _ w) <- drawing, "No two frames" `isInfixOf` w]
          `shouldSatisfy` ((== 1) . length)
        length [() | Mark "correction" (Rectangle _ _) <- drawing] `shouldBe` 2
  where
    -- Taxels.
    poses = do
      n <- choose (2, 5 :: Int)
      jitters <- vectorOf n ((,) <$> choose (-1, 1) <*> choose (-1, 1))
      pure [(8 * fromIntegral k + u, v) | (k, (u, v)) <- zip [0 :: Int ..] jitters]
    frames at =
      [ Frame pose 10 (relief (round x) (round y)) taxelPitch []
        | (x, y) <- at,
          let pose = SensorPose (taxelPitch * x) (taxelPitch * y) 0
      ]
    relief x y =
      generate 16 16 $ \i j ->
        if ((x + i) * (x + i) + 3 * (y + j) * (x + i + 7)) `mod` 11 < 4 then 0.8 else 0 :: Double
    named these = [("file" ++ show k, f) | (k, f) <- zip [0 :: Int ..] these]
    withAssembly way these judge = case assemble way standardRegistration these of
      Left e -> counterexample (show e) False
      Right made -> judge (assemblyDrawing "folder" (named these) made) made
    times u (x, y) = (u * x, u * y)
    near tiny (x, y) (u, v) =
      counterexample (show ((x, y), (u, v))) (abs (x - u) < tiny && abs (y - v) < (tiny :: Double))

minus :: (Double, Double) -> (Double, Double) -> (Double, Double)
minus (x, y) (u, v) = (x - u, y - v)

-- | The centres of rectangles of a class.
centres :: Text -> Drawing -> [(Double, Double)]
centres name drawing =
  [ ((leftEdge e + rightEdge e) / 2, (topEdge e + bottomEdge e) / 2)
    | Mark name' (Rectangle _ e) <- drawing,
      name' == name
  ]

widthOf :: Text -> Drawing -> Double
widthOf name drawing = sum (take 1 [width e | Mark n (Rectangle _ e) <- drawing, n == name])

-- | The directions of the arrows, from where they begin to their tips; nothing of dots.
arrows :: Drawing -> [Maybe (Double, Double)]
arrows drawing = go [form | Mark "correction" form <- drawing]
  where
    go forms = case forms of
      Line _ (start : _) : Outline _ (tip : _) : rest -> Just (tip `minus` start) : go rest
      _ : rest -> Nothing : go rest
      [] -> []
