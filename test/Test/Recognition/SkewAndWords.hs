-- | Tests the use of symbols on a grid, each step against its definition: the skew of the grid,
-- changes of recognitions, and the words for them.
module Test.Recognition.SkewAndWords (spec) where

import Data.Foldable (for_)
import qualified Data.Map.Strict as Map
import PraTactile.Array (Position (..))
import PraTactile.Image (constant)
import PraTactile.Locate (Known (..), Reason (..))
import PraTactile.Object.Placement
import PraTactile.Recognise
import PraTactile.Recognise.FaceGrid
import PraTactile.Recognise.Recognition
import PraTactile.Recognise.Summary
import PraTactile.Segmentation (SymbolImage (..))
import PraTactile.Symmetry
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck hiding (certainty, elements, generate)
import qualified Test.QuickCheck as QuickCheck
import Test.Recognition.Symbols

spec :: Spec
spec = do
  describe "The skew of a grid" skewSpec
  describe "Recognitions" recognitionSpec
  describe "In words" wordSpec

elements :: [a] -> Gen a
elements = QuickCheck.elements

near :: Double -> Double -> Property
near a b = counterexample (show (a, b)) (abs (a - b) <= 1e-9 * (1 + abs b))

skewSpec :: Spec
skewSpec =
  it "is the mean over both errors that an image may have, weighted by the symbols' likelihood" $
    forAll (elements [Nothing, Just (), Just ()]) $ \given ->
      forAll ((,) <$> choose (-20, 20) <*> elements [0, 2, -5]) $ \(angle, off) ->
        forAll (choose (1, 8) >>= (`vectorOf` genSymbol)) $ \drawn ->
          let grid = FaceGrid (Map.fromListWith (flip (++)) placed) [] [] (0, 0)
              placed =
                [ (cell, [symbolOf n (spot cell jitter) (identity, 0)])
                  | (n, (cell, jitter)) <- zip [0 ..] drawn
                ]
              spot (i, j) (dx, dy) =
                let (x, y) = (16 * fromIntegral j, 20 * fromIntegral i)
                    (c, s) = (cos (radians angle), sin (radians angle))
                 in (c * x - s * y + dx + 40, s * x + c * y + dy - 7)
              shown = (angle + off) <$ given
              told =
                [ ((16 * fromIntegral j, 20 * fromIntegral i), readAt s)
                  | ((i, j), here) <- Map.toList (gridCells grid),
                    s <- here
                ]
           in near (gridSkew shown grid) (defined shown told)
  where
    genSymbol =
      (,)
        <$> ((,) <$> choose (0, 2 :: Int) <*> choose (0, 3 :: Int))
        <*> ((,) <$> choose (-1, 1) <*> choose (-1, 1))
    radians t = t * pi / 180 :: Double
    centred places =
      let mean part = sum (map part places) / fromIntegral (length places)
       in [(x - mean fst, y - mean snd) | (x, y) <- places]
    defined shown told = case shown of
      Nothing -> if length told < 2 then 0 else turn
      Just angle ->
        let weighed =
              [ (share * density (turn - angle) (sd * sd + variance), mode angle sd)
                | (share, sd) <- [(0.99, 1.5), (0.01, 4)]
              ]
         in sum (map (uncurry (*)) weighed) / sum (map fst weighed)
      where
        (from, to) = (centred (map fst told), centred (map snd told))
        along = sum [x * x' + y * y' | ((x, y), (x', y')) <- zip from to]
        across = sum [x * y' - y * x' | ((x, y), (x', y')) <- zip from to]
        -- The rotation, in degrees, that brings the grid's places nearest to the symbols', and its
        -- variance if each is half a taxel off along each axis.
        turn = if null told then 0 else atan2 across along * 180 / pi
        variance = (180 / pi * 0.5) ** 2 / max 1e-9 along
        density d v = exp (negate d * d / (2 * v)) / sqrt v
        mode angle sd = (angle * variance + turn * sd * sd) / (sd * sd + variance)

recognitionSpec :: Spec
recognitionSpec = do
  prop "set upright are taken back by an angle, each composite by its own map" $
    forAll ((,) <$> choose (-45, 45) <*> choose (-3, 3)) $ \(angle, skew') ->
      forAll (vectorOf 4 ((,) <$> choose (0, 30) <*> choose (0, 30))) $ \places ->
        let back k (x, y) = (2 * y + k, x - 3 * k) :: (Double, Double)
            symbols =
              [ (symbolOf n place (identity, n))
                  { readSource = n,
                    readImage = SymbolImage (fst place + 1, snd place) (constant 8 12 0) 7 (8, 12)
                  }
                | (n, place) <- zip [0 ..] places
              ]
            (whole, parts) = splitAt 2 symbols
            windows = [windowAt (Position 0 n) place | (n, place) <- zip [0 ..] places]
            found = Finding (turned 2) (windowAt (Position 9 9) (4, 5)) windows Map.empty
            given =
              Recognition whole parts Map.empty (0, 0) Nothing Nothing skew' (Right (Found found))
            -- The maps of further composites are unknown.
            moved = relocated angle [back 0, back 1, back 2] given
            placed n = if n < 3 then back (fromIntegral n) else id
            wanted s =
              s
                { readAt = back 0 (readAt s),
                  readImage =
                    (readImage s)
                      { symbolCentre = placed (readSource s) (symbolCentre (readImage s)),
                        symbolAxis = 7 + angle
                      }
                }
            there w = w {windowSeenAt = back 0 (windowSeenAt w)}
         in recognisedSymbols moved === map wanted whole
              .&&. recognisedParts moved
              === map wanted parts
              .&&. recognisedSkew moved
              === angle + skew'
              .&&. recognisedAnswer moved
              === Right
                ( Found
                    found
                      { foundWindow = there (foundWindow found),
                        foundWindows = map there windows
                      }
                )
              .&&. recognisedAnswer (relocated angle [back 0] given {recognisedAnswer = several})
              === several
  it "have the skew in their symbols' axes if that is requested" $ do
    let axis n s = s {readImage = (readImage s) {symbolAxis = n}}
        one = symbolOf 0 (0, 0) (identity, 0)
        given =
          (unanswered [axis 90 one, axis 1 one] NoSymbols)
            { recognisedParts = [axis (-3) one],
              recognisedSkew = 2.5
            }
    axesSkewed given
      `shouldBe` given
        { recognisedSymbols = [axis 92.5 one, axis 3.5 one],
          recognisedParts = [axis (-0.5) one]
        }
  it "turn the face by the orientation plus the skew, from 0 up to 360 degrees" $
    for_ [-90, -45, -10, -0.25, 0, 0.25, 44, 90, 100] $ \skew' -> for_ [0 .. 3] $ \quarters -> do
      let whole = 90 * fromIntegral quarters + skew'
          recognition = (unanswered [] NoSymbols) {recognisedSkew = skew'}
      recognisedAngle recognition (turned quarters)
        `shouldBe` head' [a | a <- [whole, whole + 360, whole - 360], a >= 0, a < 360]
  prop "are refused exactly if other layouts raise the doubt above what is tolerated" $
    forAll (vectorOf 3 (choose (0, 0.2))) $ \doubts ->
      forAll (vectorOf 3 (elements [0, 0.05, 0.2])) $ \elsewhere ->
        let (position, origin) = (sum (take 1 doubts), sum (drop 2 doubts))
            (stitching, axes, slip) = case elsewhere of
              [a, b, c] -> (a, b, c)
              _ -> (0, 0, 0)
            alien part = ForeignDoubts (origin / 4 * part) (3 * origin / 4 * part) True 0
            unsure = Doubts position 0 0 0 (alien 1)
            support = Support unsure 4 [3] [1] (Exactly 3) 1 Nothing Nothing
            weighed = doubtsOf <$> recognisedSupport (asked 1 given)
            doubtsOf one =
              let Doubts p st ax sl o = supportDoubts one
               in [p, st, ax, sl, doubtOfRandom o, doubtOfOtherArrays o]
            put = 1 - stitching - axes - slip
            wanted =
              [position * put, stitching, axes, slip]
                ++ [part * origin / 4 * put | part <- [1, 3]]
            given = Recognition [] [] Map.empty (0, 0) (Just support) Nothing 0 several
            asked tolerated =
              doubting
                (standardTolerance {toleratedDoubt = tolerated})
                (LayoutDoubts stitching axes slip Nothing)
            close a b = abs (a - b) < 1e-12
            doubt = maybe 0 supportDoubt (recognisedSupport (asked 1 given))
         in if sum elsewhere == 0
              then asked 0 given === given
              else
                counterexample
                  (show (weighed, wanted))
                  (maybe False (and . zipWith close wanted) weighed)
                  .&&. [recognisedAnswer (asked (doubt * share) given) | share <- [1, 0.999]]
                  === [several, Left (NotLocated BelowThreshold)]
                  .&&. recognisedAnswer (asked 1 given {recognisedSupport = Nothing})
                  === Left (NotLocated BelowThreshold)
  it "have a certainty of - sum (log doubt) over their symbols, with doubts of at least 1e-300" $ do
    let doubtful p =
          (symbolOf 0 (0, 0) (identity, 0))
            { readChances = [((identity, 0), 1 - p), ((identity, 1), p / 2), ((turned 2, 0), p / 2)]
            }
        of' = certainty . map doubtful
    abs (of' [0.1, 0.02] - negate (log 0.002)) `shouldSatisfy` (< 1e-9)
    abs (of' [0] - 300 * log 10) `shouldSatisfy` (< 1e-9)
    of' [] `shouldBe` 0
  it "without an answer have their symbols, the refusal, and no skew" $ do
    let symbols = [symbolOf n (1, 2) (identity, n) | n <- [0, 1]]
    unanswered symbols (Mirrored [])
      `shouldBe` Recognition symbols [] Map.empty (0, 0) Nothing Nothing 0 (Left (Mirrored []))
  it "have each refusal in the list of refusals once" $
    for_ ([NoSymbols, SymbolsUnclear, Mirrored [], OrientationContradicts] ++ later) $ \refusal ->
      length (filter ((== refusalName refusal) . refusalName) refusals) `shouldBe` 1
  where
    head' = foldr const (-1)
    several = Right (Several identity [Position 0 1])
    later = [GridContradicts, WindowsContradict]
    windowAt position place = ReadWindow position [] place OnNoObject

wordSpec :: Spec
wordSpec = do
  it "a skew of more than three degrees is mentioned" $
    for_ [0, 2.999, 3, 3.001, -3, -3.001, 30] $ \skew' -> do
      let recognition = (unanswered [] NoSymbols) {recognisedSkew = skew'}
          said = abs skew' > 3
      leastSkew `shouldBe` 3
      shownSkew recognition `shouldBe` (if said then skew' else 0)
      (lieText recognition (turned 1) == "turned by 90 degrees") `shouldBe` not said
  it "orientations, positions and doubts" $ do
    map orientationText (concat [[turned k, turned k <> mirror] | k <- [0 .. 3]])
      `shouldMatchList` [ "upright",
                          "turned by 90 degrees",
                          "turned by 180 degrees",
                          "turned by 270 degrees",
                          "mirrored",
                          "mirrored and turned by 90 degrees",
                          "mirrored and turned by 180 degrees",
                          "mirrored and turned by 270 degrees"
                        ]
    positionsText [Position 6 5, Position 7 0] `shouldBe` "6,5 7,0"
    map doubtText [0, 1e-310, 0.0123, 1] `shouldBe` ["below 1e-300", "1.0e-310", "1.2e-2", "1.0e0"]
