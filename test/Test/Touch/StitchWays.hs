-- | Which way frames are registered, and what is told of them then; and joint registration as a
-- whole, from its parts.
module Test.Touch.StitchWays (spec) where

import Control.Monad (forM)
import Data.Foldable (for_)
import Data.List (sortOn)
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as V
import PraTactile.Composite.Spaced
import PraTactile.Image
import PraTactile.Registration.AllPairs (registerPairwise)
import PraTactile.Registration.Arrangement
import PraTactile.Registration.Incremental (register)
import PraTactile.Registration.Joint
import PraTactile.Registration.Joint.Consensus (swept)
import PraTactile.Registration.Joint.Grid
import PraTactile.Registration.Joint.Located
import PraTactile.Registration.Joint.Option
import PraTactile.Registration.Joint.Phase
import PraTactile.Registration.Lattice.Evidence
import PraTactile.Registration.Lattice.Held
import PraTactile.Registration.Lattice.Layout
import PraTactile.Registration.Lattice.Template
import PraTactile.Registration.Posterior (Hypothesis (..))
import PraTactile.Registration.Search (Registration (..), standardRegistration)
import PraTactile.Registration.Spectrum (spectra)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (generate, sample, tables)
import Test.Touch.Image (genRasterOf)
import Test.Touch.Sensor (embossing)

spec :: Spec
spec = do
  spacedSpec
  waySpec
  modifyMaxSuccess (const 8) jointSpec

spacedSpec :: Spec
spacedSpec =
  it "some of a list are all where these are no more, else so many, evenly, the first among them" $
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

-- | Frames of a face of symbols, so many taxels apart from it.
facing :: [(Double, Double)] -> [((Double, Double), Raster)]
facing places = [(place, generate 16 16 (seen place)) | place <- places]
  where
    seen (x, y) i j = sample face (x + fromIntegral i) (y + fromIntegral j)
    face = generate 96 80 $ \x y ->
      let (c, u) = x `divMod` 16
          (r, v) = y `divMod` 20
          kind = (3 * r + 2 * c + r * c) `mod` 4
       in fromMaybe 0 (index (embossing !! kind) (u - 4) (v - 4))

waySpec :: Spec
waySpec = do
  it "what is not registered stays, and so do frames that show nothing" $ do
    let blanks = [((0, 0), constant 8 8 0.25), ((4, 1), constant 8 8 0.25)]
        told arranged' = (arrangedWay arranged', map shown (arrangedFrames arranged'))
        shown a = (arrangedShift a, arrangedDeviation a, arrangedProbability a, arrangedOthers a)
        unmoved = ((0, 0), Nothing, Nothing, [])
    told (arrange Nominal standardRegistration (facing places))
      `shouldBe` (Nominal, map (const unmoved) places)
    for_ [Automatic, ByLattice, Jointly, Incremental] $ \way ->
      told (arrange way standardRegistration blanks) `shouldBe` (Incremental, [unmoved, unmoved])
  it "one after the other and jointly, frames have what these registrations tell" $ do
    let frames = facing places
        one = arrange Incremental standardRegistration frames
        all' = arrange Jointly standardRegistration frames
        bySpectra (w, h) = spectra w h
    [(arrangedShift a, arrangedOthers a) | a <- arrangedFrames one]
      `shouldBe` register standardRegistration frames
    map arrangedDeviation (arrangedFrames one) `shouldBe` map (const Nothing) places
    [(arrangedShift a, arrangedDeviation a) | a <- arrangedFrames all']
      `shouldBe` [ (shift, Just (sd, sd))
                   | (shift, sd) <- registerPairwise standardRegistration bySpectra frames
                 ]
    (arrangedWay one, arrangedWay all') `shouldBe` (Incremental, Jointly)
    for_ [one, all'] $ \found -> do
      let moved =
            [ ((x + dx, y + dy), image)
              | (((x, y), image), a) <- zip frames (arrangedFrames found),
                let (dx, dy) = arrangedShift a
            ]
      map arrangedGroup (arrangedFrames found) `shouldBe` groupsOf moved
      arrangedResidual found `shouldBe` residual moved
  it "by the lattice if that is told; automatically, if error or noise is above its limit" $ do
    let way settings = arrangedWay (arrange Automatic settings (facing places))
        with sigma noise =
          standardRegistration {registrationSigma = sigma, registrationNoise = noise}
    [way (with sigma noise) | (sigma, noise) <- [(1.25, 0.25), (1.26, 0.1), (1, 0.26)]]
      `shouldBe` [Incremental, ByLattice, ByLattice]
    -- A single frame is not.
    arrangedWay (arrange Automatic (with 2 0.1) (facing [(20, 20)])) `shouldBe` Incremental
    -- Nor are frames that show something else, unless that is asked for.
    let noise = [((8 * fromIntegral k, 0), rough k) | k <- [0 .. 2 :: Int]]
        rough k = generate 16 16 (\x y -> wave 0.9 (x + 8 * k) + wave 0.7 y)
        wave by t = sin (by * fromIntegral t)
    map (\w -> arrangedWay (arrange w (with 2 0.1) noise)) [Automatic, ByLattice]
      `shouldBe` [Incremental, ByLattice]
  where
    places = [(10, 12), (18, 12), (10, 20), (18, 20)]

jointSpec :: Spec
jointSpec =
  it "jointly frames lie where their options, swept, have them, with shifts of mean nothing" $
    forAll (elements [0, 20]) $ \angle ->
      forAllBlind genFrames $ \frames ->
        let found = do
              tables <- paperTemplates
              let against = held tables (map snd frames) angle
                  settings = standardRegistration {registrationSigma = 0.7, registrationReach = 2}
              pure (registerJointly settings against frames, defined settings against frames)
         in case found of
              Nothing -> property False
              Just (came, wanted) ->
                length came === length wanted .&&. conjoin (zipWith alike came wanted)
  where
    genFrames = do
      count <- choose (1, 4)
      forM [1 .. count :: Int] $ \k -> do
        jitter <- (,) <$> choose (-1, 1) <*> choose (-1, 1)
        noise <- genRasterOf 16 16
        let place = (8 * fromIntegral (k `div` 2) + 6, 8 * fromIntegral (k `mod` 2) + 9)
            image = foldr (const . snd) (constant 16 16 0) (facing [place])
            rough x y = 0.4 * fromMaybe 0 (index noise x y) + fromMaybe 0 (index image x y)
        pure ((fst place + fst jitter, snd place + snd jitter), generate 16 16 rough)
    alike a b =
      counterexample (show (a, b)) $
        nearPlace (locatedShift a) (locatedShift b)
          && nearPlace (locatedDeviation a) (locatedDeviation b)
          && abs (locatedProbability a - locatedProbability b) < 1e-9
          && length (locatedOthers a) == length (locatedOthers b)
          && and (zipWith other (locatedOthers a) (locatedOthers b))
    other (Hypothesis s p) (Hypothesis s' p') = nearPlace s s' && abs (p - p') < 1e-9
    nearPlace (x, y) (x', y') = abs (x - x') < 1e-9 && abs (y - y') < 1e-9

-- | Joint registration along the lattice's axes: of frames from above to below and from left to
-- right the phase that all have in common, the options of each, what they make of each other.
defined :: Registration -> Held -> [((Double, Double), Raster)] -> [Located]
defined settings against frames = map snd (sortOn fst (zip order (map centred turned')))
  where
    angle = heldAngle against
    about degrees (x, y) =
      let (c, s) = (cos (degrees * pi / 180), sin (degrees * pi / 180))
       in (c * x - s * y, s * x + c * y)
    along =
      [ (k, place, image, sightEvidence told)
        | (k, (at, image), told) <- zip3 [0 :: Int ..] frames (heldFrames against),
          let (u, v) = layoutFirst (templateLayout (heldTables against (rasterSize image))),
          let (x, y) = about (negate angle) at,
          let place = (x + fromIntegral u, y + fromIntegral v)
      ]
    ordered = sortOn (\(_, (x, y), image, _) -> (y, x, V.toList (rasterValues image))) along
    order = [k | (k, _, _, _) <- ordered]
    seen = [(place, told) | (_, place, _, told) <- ordered]
    grid = gridOf settings
    (orientation, phase) = commonPhase grid seen
    settled = swept (map (optionsOf grid orientation phase) seen)
    turned' =
      [ turn (locatedAt place [(optionShift o, p) | (o, p) <- weights])
        | ((place, _), weights) <- zip seen settled
      ]
    -- Variances along the frames' axes are those along the lattice's by the squares of the cosines.
    turn l =
      let (c, s) = about angle (1, 0)
          (sx, sy) = locatedDeviation l
       in l
            { locatedShift = about angle (locatedShift l),
              locatedDeviation =
                (sqrt ((c * sx) ** 2 + (s * sy) ** 2), sqrt ((s * sx) ** 2 + (c * sy) ** 2)),
              locatedOthers = map (onShift (about angle)) (locatedOthers l)
            }
    onShift f h = h {hypothesisShift = f (hypothesisShift h)}
    -- To the nearest eighth of a taxel.
    middle part =
      let m = sum (map (part . locatedShift) turned') / fromIntegral (length turned')
       in fromIntegral (round (8 * m) :: Int) / 8
    less (x, y) = (x - middle fst, y - middle snd)
    centred l =
      l {locatedShift = less (locatedShift l), locatedOthers = map (onShift less) (locatedOthers l)}
