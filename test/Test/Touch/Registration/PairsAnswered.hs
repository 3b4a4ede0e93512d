-- | What is answered of two frames, stated once more as a whole from what is known of the place by
-- each method, and asked at the confidence at which the answer changes.
module Test.Touch.Registration.PairsAnswered (spec) where

import Data.List (nub)
import qualified Data.Vector.Storable as V
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Image
import PraTactile.Registration.Lattice.Fit (likelihood)
import PraTactile.Registration.Lattice.Likelihood
import PraTactile.Registration.Lattice.Template (Templates, templates)
import PraTactile.Registration.Pair
import PraTactile.Registration.Pair.Alike
import PraTactile.Registration.Pair.Blind
import PraTactile.Registration.Pair.Lattice
import PraTactile.Registration.Pair.Straight
import PraTactile.Registration.Posterior
import PraTactile.Registration.Rotation
import PraTactile.Registration.Spectrum
import PraTactile.Shape (paperAlphabet)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (Blind, generate, tables)
import Test.Support
import Test.Touch.Registration.Reliefs (genFrames)

spec :: Spec
spec = do
  askedSpec
  straightSpec
  matchSpec

askedSpec :: Spec
askedSpec = do
  it "by default is asked within 3 taxels, by the better method, with 99 % confidence" $
    standardPairing (1, 2) `shouldBe` Pairing (1, 2) 3 Auto 0.99
  it "frames of other sizes than the tables', or out of 4 to 256 taxels, are refused by name" $ do
    known <- right paperAlphabet
    let asked (w, h) (m, n) (u, v) =
          ()
            <$ registerPair
              (tablesFor known w h)
              (standardPairing (2, 0))
              (generate m n (\x y -> fromIntegral ((x * 3 + y * 5) `mod` 7)))
              (generate u v (\x y -> fromIntegral ((x * 3 + y * 5) `mod` 7)))
        same size = asked size size size
    map same [(4, 4), (4, 5), (5, 4)] `shouldBe` replicate 3 (Right ())
    map (\size -> asked (4, 4) size size) [(3, 4), (4, 3), (257, 4), (4, 257), (5, 4), (4, 5)]
      `shouldBe` map (Left . PairFrameSize) [(3, 4), (4, 3), (257, 4), (4, 257), (5, 4), (4, 5)]
    asked (4, 4) (4, 4) (4, 5) `shouldBe` Left (PairSizes (4, 4) (4, 5))
  it "values that are not finite are refused, and settings out of their ranges, by name" $ do
    known <- right paperAlphabet
    let frame = generate 5 5 (\x y -> fromIntegral ((x * 3 + y * 5) `mod` 7))
        with v = generate 5 5 (\x y -> if (x, y) == (4, 4) then v else 0.5)
        tables = tablesFor known 5 5
        asked pairing a b = fmap (const ()) (registerPair tables pairing a b)
        usual = standardPairing (2, 0)
    [asked usual a b | v <- [0 / 0, 1 / 0, -1 / 0], (a, b) <- [(with v, frame), (frame, with v)]]
      `shouldBe` replicate 6 (Left PairNotFinite)
    let refused pairing = asked pairing frame frame == Left (UnusablePairing pairing)
    [refused usual {pairingConfidence = c} | c <- [-0.001, 0, 1, 1.001, 0 / 0]]
      `shouldBe` [True, False, False, True, False]
    [refused usual {pairingSearch = s} | s <- [-0.001, 0, 64.5]] `shouldBe` [True, False, True]
    [refused usual {pairingStep = s} | s <- [(1000.5, 0), (-1000.5, 0), (0, 1000.5), (0, -1000.5)]]
      `shouldBe` replicate 4 True

-- | Whether posteriors are the same to rounding.
alike :: Posterior -> Posterior -> Property
alike (Posterior o s n m) (Posterior o' s' n' m') =
  counterexample (show (m, m')) $
    (o, s, n) == (o', s', n') && V.and (V.zipWith (\p q -> abs (p - q) < 1e-9) m m')

straightSpec :: Spec
straightSpec =
  modifyMaxSuccess (const 100)
    . it "along a straight edge the prior shares out what lies on the line through each place"
    $ forAll (genFrames 9 8) $ \((a, b), (dx, dy)) ->
      forAll (elements [1, 2, 3]) $ \search ->
        let step = (fromIntegral dx, fromIntegral dy) :: Taxels
            found = correlationPosterior step search a b
            Posterior origin@(ox, oy) _ size@(columns, rows) masses = found
            (row0, column0) = V.maxIndex masses `quotRem` columns
            best = (round ox + column0, round oy + row0)
            priorAt (x, y) =
              exp
                ( priorAround
                    search
                    (ox + fromIntegral x - fst step, oy + fromIntegral y - snd step)
                )
            massAt (x, y) = masses V.! (y * columns + x)
            wanted (i, j) =
              posterior origin 1 size $
                V.fromList
                  [ log (priorAt (x, y) * sum (map massAt line) / sum (map priorAt line))
                    | y <- [0 .. rows - 1],
                      x <- [0 .. columns - 1],
                      let line =
                            [ p
                              | t <- [-9 .. 9],
                                abs t <= fromIntegral (max columns rows),
                                let p = (x + round (t * i), y + round (t * j)) :: (Int, Int),
                                fst p `elem` [0 .. columns - 1],
                                snd p `elem` [0 .. rows - 1]
                            ]
                  ]
            came = alongStraight step search (a, b) found
         in case straightness best a b of
              Just along -> label "straight" (alike came (wanted along))
              Nothing -> came === found

-- | What frames of 16 x 16 are asked with, made once.
tables16 :: Maybe (Tables, Templates)
tables16 = either (const Nothing) (Just . made) paperAlphabet
  where
    made known = (tablesFor known 16 16, templates known 0 16 16)

spectra16 :: Spectra
spectra16 = spectra 16 16

matchSpec :: Spec
matchSpec =
  modifyMaxSuccess (const 20)
    . it "a pair is answered from its posterior, or refused for the first reason that there is"
    $ forAllBlind (genFrames 16 16) $ \(frames, (dx, dy)) ->
      forAll (elements [minBound .. maxBound]) $ \method ->
        forAll ((,) <$> elements [0, 0.3, 9, 20] <*> elements [0, 1, 2]) $ \(off, search) ->
          let pairing = Pairing (fromIntegral dx + off, fromIntegral dy) search method 0.99
              told@(_, _, sure) = posteriors pairing frames
              best = foldr const (Hypothesis (0, 0) 0) (hypotheses 1 0 sure)
              -- The confidences at which an answer, or an axis, is just sure enough.
              limits =
                [fst (marginals sure), snd (marginals sure)]
                  ++ [probabilityAround sure (hypothesisShift best)]
              asked c = do
                (tables, _) <- tables16
                either (const Nothing) Just $
                  uncurry (registerPair tables pairing {pairingConfidence = c}) frames
           in label (show (matchRefusal <$> asked 0.99)) $
                conjoin
                  [ case asked c of
                      Just found -> answered pairing {pairingConfidence = c} frames found told
                      Nothing -> property False
                    | c <- nub (0.99 : filter (<= 1) limits)
                  ]

-- | The method, what it makes of the place, and how much of that is sure.
posteriors :: Pairing -> (Raster, Raster) -> (PairMethod, Posterior, Posterior)
posteriors (Pairing step search method _) (a, b) = (used, found, sure)
  where
    process = processOf spectra16 0 (map (coefficientsOf spectra16) [a, b])
    told = case tables16 of
      Just (_, known) -> map (likelihood known) [a, b]
      Nothing -> []
    -- Whether the lattice is likelier than relief of any other kind.
    latticed = sum (map logDensity told) > sum (processLogs process)
    used
      | method == Auto = if latticed then Lattice else Blind
      | otherwise = method
    found = case (used, told) of
      (Lattice, [one, other]) -> latticePosterior step search one other
      (Correlation, _) -> correlationPosterior step search a b
      _ -> blindPosterior spectra16 process step search (a, b)
    sure
      | used == Blind = alongStraight step search (a, b) found
      | used == Lattice, not latticed = priorAlone search step found
      | otherwise = found

answered ::
  Pairing -> (Raster, Raster) -> Match -> (PairMethod, Posterior, Posterior) -> Property
answered (Pairing step search _ confidence) (a, b) match (used, found, sure) =
  conjoin
    [ matchMethod match === used,
      matchRefusal match === refusal,
      matchFixed match === fixed,
      map hypothesisShift (matchHypotheses match) === map hypothesisShift listed,
      conjoin
        ( zipWith
            near
            (map hypothesisProbability (matchHypotheses match))
            (map surely listed)
        ),
      hypothesisShift (matchBest match) === shift,
      near (hypothesisProbability (matchBest match)) (surely best),
      nearPlace (matchDeviations match) (deviations sure),
      matchRotation match === rotation
    ]
  where
    listed = hypotheses 5 0.001 found
    best = foldr const (Hypothesis step 0) (hypotheses 1 0 found)
    shift = hypothesisShift best
    surely = probabilityAround sure . hypothesisShift
    (severalX, severalY) = apart (agreements step search a b)
    (surelyX, surelyY) = marginals sure
    fixed = (surelyX >= confidence && not severalX, surelyY >= confidence && not severalY)
    oneAxis = fst fixed /= snd fixed
    reaches part = abs (part step) - search <= 15
    flat image =
      let values = V.toList (rasterValues image)
       in maximum values - minimum values <= 1e-9
    coefficients = map (coefficientsOf spectra16) [a, b]
    process = processOf spectra16 0 coefficients
    noiseAlone =
      or (zipWith (\logs c -> logs - whiteness c < 5) (processLogs process) coefficients)
    refusal
      | not (reaches fst && reaches snd) = Just NoOverlap
      | flat a || flat b = Just Blank
      | severalX || severalY = Just (if oneAxis then OneAxis else Ambiguous)
      | surely best >= confidence = Nothing
      | noiseAlone = Just Blank
      | oneAxis = Just OneAxis
      | otherwise = Just Ambiguous
    rotation = case refusal of
      Nothing -> aligned rotationPrior (valueInside (smooth a)) shift (smooth b) >>= certainRotation
      Just _ -> Nothing
    near p q = counterexample (show (p, q)) (abs (p - q) < 1e-9)
    nearPlace (x, y) (x', y') = near x x' .&&. near y y'
