-- | Tests the registration of pairs: every refusal by construction, and changes that must not
-- matter.
module Test.Touch.Registration.PairsRefused (spec) where

import Data.Either (isLeft)
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as V
import PraTactile.Image
import PraTactile.Random (normals)
import PraTactile.Registration.Lattice.Fit (likelihood, whole)
import PraTactile.Registration.Lattice.Template (templates)
import PraTactile.Registration.Pair
import PraTactile.Registration.Pair.Methods (latticePosterior)
import PraTactile.Registration.Posterior (hypotheses)
import PraTactile.Shape (Alphabet, embossedAt, shapes)
import System.Random (mkStdGen)
import Test.Effort (withCases)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck hiding (Blind, generate, tables)
import Test.Touch.Paper (paperAlphabet)

spec :: Spec
spec = do
  it "frames without relief are blank" $ refusalOf (const (const 0.3)) `shouldBe` Just Blank
  it "frames with noise only are blank" $
    fmap (matchRefusal . found) (Just (noisy 1 (const (const 0)))) `shouldBe` Just (Just Blank)
  it "a straight edge is refused as one axis: upright it fixes x and not y, level y and not x" $ do
    let upright = found (clean (\x _ -> if x < 12 then 0 else 1))
        level = found (clean (\_ y -> if y < 7 then 0 else 1))
    (matchRefusal upright, matchFixed upright) `shouldBe` (Just OneAxis, (True, False))
    (matchRefusal level, matchFixed level) `shouldBe` (Just OneAxis, (False, True))
  withCases 7 60 straight
  withCases 2 20 turnedAbout
  withCases 2 10 byLattice
  it "a pattern that repeats within the search is ambiguous, and fixes neither axis" $
    refusalOf (\x y -> if even (x `div` 2 + y `div` 2) then 0 else 1) `shouldBe` Just Ambiguous
  it "frames further apart than they are wide have no overlap" $
    fmap matchRefusal (ask (standardPairing (40, 0)) (clean symbols))
      `shouldBe` Right (Just NoOverlap)
  it "symbols are registered to their places by each method" $
    [ near (found' method (clean symbols))
      | method <- [Correlation, Blind, Lattice, Auto]
    ]
      `shouldBe` replicate 4 True
  it "an affine change of either frame's grey values changes nothing" $
    sequence_
      [ close
          (found' method (a, b))
          (found' method (mapRaster (\v -> 3 * v - 1) a, mapRaster (\v -> 0.2 * v + 7) b))
          `shouldBe` True
        | method <- [Correlation, Blind, Lattice],
          let (a, b) = noisy 0.1 symbols
      ]
  it "frames of unequal size, NaN, senseless settings and far steps are refused" $ do
    let (a, b) = clean symbols
    isLeft (withTables (\t -> registerPair t (standardPairing (8, 0)) a (constant 8 8 0)))
      `shouldBe` True
    isLeft (withTables (\t -> registerPair t (standardPairing (8, 0)) a (mapRaster (/ 0) b)))
      `shouldBe` True
    isLeft (ask (standardPairing (0 / 0, 0)) (a, b)) `shouldBe` True
    isLeft (ask (standardPairing (8, 0)) {pairingSearch = -1} (a, b)) `shouldBe` True
    -- Steps of 1000 taxels and searches of 64, to either side, and no longer ones.
    [isLeft (ask (standardPairing (x, y)) (a, b)) | (x, y) <- steps 1000 ++ steps 1000.5]
      `shouldBe` replicate 4 False ++ replicate 4 True
    let searching search = ask (standardPairing (900, 0)) {pairingSearch = search} (a, b)
    map (isLeft . searching) [0, 64, 64.5] `shouldBe` [False, False, True]
  where
    steps d = [(d, 0), (-d, 0), (0, d), (0, -d)]
    refusalOf = matchRefusal . found . clean
    near match =
      let (x, y) = hypothesisShift (matchBest match)
       in matchRefusal match == Nothing && abs (x - 9) <= 0.75 && abs (y + 1) <= 0.75
    close m n =
      let ((x, y), (x', y')) = (hypothesisShift (matchBest m), hypothesisShift (matchBest n))
       in abs (x - x') < 1e-3 && abs (y - y') < 1e-3
            && abs (hypothesisProbability (matchBest m) - hypothesisProbability (matchBest n))
              < 1e-3

straight :: Spec
straight = do
  prop "a straight edge with noise up to a tenth of it is refused as one axis, wherever seen" $
    \seed -> forAll ((,) <$> choose (11, 13) <*> choose (0, 0.1)) $ \(edge, sd) ->
      let match = found' Blind (noisyBy seed sd (\x _ -> if x < edge then 0 else 1))
       in (matchRefusal match, matchFixed match) === (Just OneAxis, (True, False))
  prop "an oblique straight edge with noise is refused: it may lie anywhere along itself" $
    \seed -> forAll (choose (20, 70)) $ \degrees ->
      let (c, s) = (cos (degrees * pi / 180), sin (degrees * pi / 180)) :: (Double, Double)
          edge x y = 1 / (1 + exp (-2 * (c * (fromIntegral x - 12) + s * (fromIntegral y - 7))))
       in matchRefusal (found' Blind (noisyBy seed 0.03 edge)) =/= Nothing

-- | Blind and by correlation the axes and their directions are equivalent. Frames that are turned
-- about their diagonal or by half, or exchanged, have the same answer, turned alike, with the same
-- probability.
turnedAbout :: Spec
turnedAbout =
  prop "frames transposed, half-turned or exchanged have the answer so changed, with any step" $
    \seed -> forAll ((,) <$> elements [Correlation, Blind] <*> elements steps) $ \(method, step) ->
      let frames = roughened seed 0.2 (movedPair step seed)
          told step' = fmap summed . ask (standardPairing step') {pairingMethod = method}
          about (u, v) = (v, u)
          back (u, v) = (negate u, negate v)
          wanted = told step frames
       in conjoin
            [ counterexample what $
                like (fmap (onShift move) wanted) (told (move step) (change frames))
              | (what, move, change) <-
                  [ ("about", about, \(a, b) -> (diagonal a, diagonal b)),
                    ("by half", back, \(a, b) -> (half a, half b)),
                    ("exchanged", back, \(a, b) -> (b, a))
                  ]
            ]
  where
    steps = [(6, 0), (-6, 0), (0, 6), (0, -6), (5, 4), (-4, 6)]
    summed match =
      ( hypothesisShift (matchBest match),
        hypothesisProbability (matchBest match),
        show (matchRefusal match)
      )
    onShift move (shift, p, refusal) = (move shift, p, refusal)
    like a b = counterexample (show (a, b)) $ case (a, b) of
      (Right ((x, y), p, why), Right ((x', y'), p', why')) ->
        abs (x - x') < 1e-6 && abs (y - y') < 1e-6 && abs (p - p') < 1e-6 && why == why'
      _ -> False
    diagonal image = generate 16 16 (\x y -> fromMaybe 0 (index image y x))
    half image = generate 16 16 (\x y -> fromMaybe 0 (index image (15 - x) (15 - y)))

-- | Two frames of round bumps, the second this far right and down of the first.
movedPair :: (Double, Double) -> Int -> (Raster, Raster)
movedPair (dx, dy) seed = (frame 0 0, frame dx dy)
  where
    frame left top =
      generate 16 16 (\i j -> bumpsOf seed (left + fromIntegral i) (top + fromIntegral j))

-- | A relief of round bumps.
bumpsOf :: Int -> Double -> Double -> Double
bumpsOf seed x y = sum [exp (negate ((x - p) * (x - p) + (y - r) * (y - r)) / 6) | (p, r) <- bumps]
  where
    bumps =
      [ (fromIntegral i * 5 + 1.5 * drawn V.! k, fromIntegral j * 5 + 1.5 * drawn V.! (k + 1))
        | (i, j, k) <-
            zip3 (concatMap (replicate 6) [-1 .. 5 :: Int]) (cycle [-1 .. 4 :: Int]) [0, 2 ..]
      ]
    (drawn, _) = normals 84 (mkStdGen seed)

-- | Frames of a relief, the second 9 right and 1 up of the first.
clean :: (Int -> Int -> Double) -> (Raster, Raster)
clean relief = (generate 16 16 relief, generate 16 16 (\x y -> relief (x + 9) (y - 1)))

-- | Frames of a relief with noise of this standard deviation, the second 9 right and 1 up of the
-- first.
noisy :: Double -> (Int -> Int -> Double) -> (Raster, Raster)
noisy = noisyBy 5

-- | Tests registration by the lattice, from the likelihoods of both frames for upright symbols.
byLattice :: Spec
byLattice =
  prop "by the lattice the hypotheses are those of the phases of upright symbols" $
    \seed -> forAll (choose (0, 0.3)) $ \sd ->
      let (a, b) = noisyBy seed sd symbols
          tables known = templates known 0 16 16
          told known =
            latticePosterior (8, 0) 3 (alone known a) (alone known b)
          alone known = likelihood (tables known) . whole
          shifts = map hypothesisShift
       in shifts (matchHypotheses (found' Lattice (a, b)))
            === either (const []) (shifts . hypotheses 5 0.001 . told) paperAlphabet

noisyBy :: Int -> Double -> (Int -> Int -> Double) -> (Raster, Raster)
noisyBy seed sd relief = roughened seed sd (clean relief)

-- | Frames with noise of this standard deviation.
roughened :: Int -> Double -> (Raster, Raster) -> (Raster, Raster)
roughened seed sd (a, b) = (with 0 a, with 256 b)
  where
    (drawn, _) = normals 512 (mkStdGen seed)
    with from image =
      generate 16 16 (\x y -> fromMaybe 0 (index image x y) + sd * drawn V.! (from + y * 16 + x))

-- | Symbols in the middle of cells of 16 x 20 taxels, a class for each cell.
symbols :: Int -> Int -> Double
symbols x y = case paperAlphabet of
  Right known -> embossed known
  Left _ -> 0
  where
    (j, u) = (x + 5) `divMod` 16
    (i, v) = (y + 23) `divMod` 20
    embossed :: Alphabet -> Double
    embossed known = case drop ((3 * i + 2 * j) `mod` 4) (shapes known) of
      shape : _ | embossedAt shape (u - 4) (v - 4) -> 1
      _ -> 0

withTables :: (Tables -> Either PairError a) -> Either String a
withTables f = do
  known <- either (Left . show) Right paperAlphabet
  either (Left . show) Right (f (tablesFor known 16 16))

ask :: Pairing -> (Raster, Raster) -> Either String Match
ask pairing (a, b) = withTables (\t -> registerPair t pairing a b)

found :: (Raster, Raster) -> Match
found = found' Auto

found' :: PairMethod -> (Raster, Raster) -> Match
found' method frames =
  either
    (const (Match (Just NoOverlap) (Hypothesis (0, 0) 0) (0, 0) (False, False) Auto []))
    id
    (ask (standardPairing (8, 0)) {pairingMethod = method} frames)
