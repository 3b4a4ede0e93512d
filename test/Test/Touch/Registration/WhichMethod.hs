-- | Tests which method registers frames, and what is then reported of them.
module Test.Touch.Registration.WhichMethod (spec) where

import Control.Exception (evaluate)
import Data.Foldable (for_)
import PraTactile.Composite.Noise
import PraTactile.Image
import PraTactile.Registration.AllPairs
import PraTactile.Registration.Arrangement hiding (arrange)
import PraTactile.Registration.Estimate (Estimate (..))
import PraTactile.Registration.Groups (groupsOf)
import PraTactile.Registration.Incremental (register)
import PraTactile.Registration.Lattice.Crop
import PraTactile.Registration.Residual (residual)
import PraTactile.Registration.Settings (Registration (..), standardRegistration)
import Test.Effort (whenFull)
import Test.Hostile.Judgement (withinBounds)
import Test.Hspec
import Test.QuickCheck hiding (generate, sample, tables)
import Test.Touch.Paper (arrange)
import Test.Touch.Registration.Face (arranged, frameAt, frameTurned)

spec :: Spec
spec = do
  spacedSpec
  waySpec

spacedSpec :: Spec
spacedSpec =
  it "spacedOut takes all of a short list, and else that many, evenly, the first among them" $
    forAll ((,) <$> choose (0, 12) <*> choose (0, 40)) $ \(most, n) ->
      let found = spacedOut most [0 .. n - 1] :: [Int]
          gaps = zipWith (-) (drop 1 found) found
       in if n <= most
            then found === [0 .. n - 1]
            else
              length found === most
                .&&. take 1 found === [0 | most > 0]
                .&&. counterexample
                  (show found)
                  (null gaps || (minimum gaps >= n `div` most && maximum gaps <= n `div` most + 1))

-- | Frames of a face of symbols, which lie at these places on it.
facing :: [(Double, Double)] -> [((Double, Double), Raster)]
facing places = [(place, frameAt (16, 16) place) | place <- places]

waySpec :: Spec
waySpec = do
  it "nominal frames are not moved, and neither are frames without relief" $ do
    let blanks = [((0, 0), constant 8 8 0.25), ((4, 1), constant 8 8 0.25)]
        told arranged' = (arrangementMethod arranged', map shown (arrangementFrames arranged'))
        shown (Registered shift deviation probability others _) =
          (shift, deviation, probability, others)
        unmoved = ((0, 0), Nothing, Nothing, [])
    told (arranged Nominal standardRegistration (facing places))
      `shouldBe` (Nominal, map (const unmoved) places)
    for_ [(Automatic, ByPairs), (ByLattice, ByLattice), (ByPairs, ByPairs)] $
      \(method, used) ->
        told (arranged method standardRegistration blanks) `shouldBe` (used, [unmoved, unmoved])
  it "Incremental and ByPairs give frames the results of these registrations" $ do
    let frames = facing places
        one = arranged Incremental standardRegistration frames
        all' = arranged ByPairs standardRegistration frames
    map registeredShift (arrangementFrames one) `shouldBe` register standardRegistration frames
    map registeredDeviation (arrangementFrames one) `shouldBe` map (const Nothing) places
    [(registeredShift a, registeredDeviation a) | a <- arrangementFrames all']
      `shouldBe` [ (estimateShift e, Just (estimateDeviation e))
                   | e <- pairwiseFrames (registerPairwise standardRegistration frames)
                 ]
    (arrangementMethod one, arrangementMethod all') `shouldBe` (Incremental, ByPairs)
    for_ [one, all'] $ \found -> do
      let moved =
            [ ((x + dx, y + dy), image)
              | (((x, y), image), a) <- zip frames (arrangementFrames found),
                let (dx, dy) = registeredShift a
            ]
      map registeredGroup (arrangementFrames found) `shouldBe` groupsOf moved
      arrangementResidual found `shouldBe` residual moved
  it "Automatic uses the lattice if frames show it, whatever the known error and noise" $ do
    let method settings = arrangementMethod (arranged Automatic settings (facing places))
        with sigma noise =
          standardRegistration {registrationSigma = Just sigma, registrationNoise = noise}
    map method (standardRegistration : [with sigma noise | sigma <- [0.5, 3], noise <- [0, 0.4]])
      `shouldBe` replicate 5 ByLattice
    -- A single frame is registered to nothing, nor are frames with any other relief.
    arrangementMethod (arranged Automatic (with 2 0.1) (facing [(20, 20)])) `shouldBe` ByPairs
    let noise = [((8 * fromIntegral k, 0), rough k) | k <- [0 .. 2 :: Int]]
        rough k = generate 16 16 (\x y -> wave 0.9 (x + 8 * k) + wave 0.7 y)
        wave by t = sin (by * fromIntegral t)
    map (\w -> arrangementMethod (arranged w (with 2 0.1) noise)) [Automatic, ByLattice]
      `shouldBe` [ByPairs, ByLattice]
  it "too many frames are refused by the methods that compare their pixels, and only by these" $ do
    let slope = generate 16 16 (\x y -> fromIntegral (x * y))
        many count = replicate count ((0, 0), slope)
        refused method count =
          refusal (arrange method standardRegistration (many count))
    refused Incremental 1448 `shouldBe` Nothing
    refused Incremental 1449 `shouldBe` Just (ComparedPixels (1449 * 1449 * 256))
    [refused method 1449 | method <- [Nominal, ByLattice]] `shouldBe` replicate 2 Nothing
    -- Nor in too many by pairs.
    let large = generate 256 256 (\x y -> fromIntegral (x * y))
    refusal (arrange ByPairs standardRegistration (replicate 100 ((0, 0), large)))
      `shouldSatisfy` \found -> case found of
        Just (PairPixels n) -> n > maxPairPixels
        _ -> False
    -- Frames far from each other are not compared.
    let apart = [((100 * fromIntegral k, 0), slope) | k <- [1 .. 3000 :: Int]]
    refusal (arrange Incremental standardRegistration apart) `shouldBe` Nothing
  it "the lattice's angle is estimated from the crop of a large frame with most contrast" $ do
    let strong x y = fromIntegral ((7 * x + 3 * y) `mod` 5) - 2
        image = generate 200 100 $ \x y -> strong x y * (if x >= 168 && y >= 68 then 1 else 0.1)
    (Right (variedCrop image) == crop (168, 68) (32, 32) image) `shouldBe` True
    for_ [(32, 32), (4, 256), (128, 8)] $ \(w, h) ->
      let small = generate w h strong in (variedCrop small == small) `shouldBe` True
  it "the lattice is also recognised in large frames, each turned a little in itself" $ do
    let frames =
          [ ((x, y), frameTurned angle (48, 48) (x, y))
            | (angle, x, y) <- [(2, 8, 8), (-1.5, 24, 8), (1, 8, 24), (-2, 24, 22)]
          ]
    arrangementMethod (arranged Automatic standardRegistration frames) `shouldBe` ByLattice
  whenFull . it "two large frames without a lattice are recognised as such in little memory" $ do
    let settings = standardRegistration {registrationSigma = Just 2}
        rough k = generate 200 200 (\x y -> grey (x + 200 * (y + 200 * k)))
        grey n = fromIntegral ((n * 1103515245 + 12345) `div` 65536 `mod` 256 :: Int) / 255
        frames = [((fromIntegral k * 20, 0), rough k) | k <- [0, 1]]
    found <- withinBounds (evaluate (arrangementMethod (arranged Automatic settings frames)))
    found `shouldBe` Right ByPairs
  it "ByLattice takes frames of 256 x 256 pixels, and no larger ones" $ do
    let image side = generate side 256 (\x y -> fromIntegral (x + y))
        refused side =
          refusal (arrange ByLattice standardRegistration (replicate 2 ((0, 0), image side)))
    map refused [256, 257] `shouldBe` [Nothing, Just (LatticePixels (257 * 256))]
  where
    refusal = either Just (const Nothing)
    places = [(10, 12), (18, 12), (10, 20), (18, 20)]
