-- | Registers two frames: where the second lies in the first, how certain that is, and if it is not
-- certain, why.
module PraTactile.Registration.Pair
  ( -- * What is asked
    Pairing (..),
    standardPairing,
    PairMethod (..),
    Tables,
    tablesFor,

    -- * What is answered
    Match (..),
    PairRefusal (..),
    Hypothesis (..),
    registerPair,
    PairError (..),
  )
where

import qualified Data.Vector.Storable as V
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Image (Raster, rasterSize, rasterValues)
import PraTactile.Registration.Lattice.Fit (likelihood, whole)
import PraTactile.Registration.Lattice.Likelihood
import PraTactile.Registration.Lattice.Places
import PraTactile.Registration.Lattice.Template
import PraTactile.Registration.Numbers (leastOther)
import PraTactile.Registration.Overlap
import PraTactile.Registration.Pair.Alike
import PraTactile.Registration.Pair.Methods
import PraTactile.Registration.Pair.Straight
import PraTactile.Registration.Posterior
import PraTactile.Registration.Spectrum
import PraTactile.Shape (Alphabet, symbolWidth)

-- | How two frames are registered.
data PairMethod
  = -- | by the paper's zero-mean normalised cross-correlation
    Correlation
  | -- | by the frames alone, whatever they show
    Blind
  | -- | By the lattice of cells of 16 x 20 taxels ("PraTactile.Geometry") along the frame's axes.
    -- The alphabet is known, the array is not. Frames of another pitch or rotation must be
    -- resampled first.
    Lattice
  | -- | by the lattice if the frames show it rather than anything else, otherwise blind
    Auto
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | The question: a nominal step, and how to search.
data Pairing = Pairing
  { -- | The nominal place of the second frame's upper left pixel in the first, taxels right and
    -- down.
    pairingStep :: !Taxels,
    -- | How far around it to search along each axis, taxels; it stands for two standard deviations
    -- of the robot's error.
    pairingSearch :: !Double,
    pairingMethod :: !PairMethod,
    -- | The least probability of an answer.
    pairingConfidence :: !Double
  }
  deriving stock (Eq, Show)

-- | A pairing at a nominal step: a search of 3 taxels, the better method, a confidence of 0.99.
standardPairing :: Taxels -> Pairing
standardPairing step = Pairing step 3 Auto 0.99

-- | Why a pair is not registered.
data PairRefusal
  = -- | A frame shows nothing but noise.
    Blank
  | -- | One axis is determined, the other is not.
    OneAxis
  | -- | No place is as probable as 'pairingConfidence', or several places are equally good.
    Ambiguous
  | -- | The frames do not overlap anywhere in the search.
    NoOverlap
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | The answer.
data Match = Match
  { matchRefusal :: !(Maybe PairRefusal),
    -- | The most probable place of the second frame's upper left pixel in the first, taxels right
    -- and down. It is given even if refused.
    matchBest :: !Hypothesis,
    -- | The standard deviations along both axes, taxels.
    matchDeviations :: !Taxels,
    -- | Whether the displacement along x, and along y, is determined, each by itself.
    matchFixed :: !(Bool, Bool),
    -- | The method that was used; never 'Auto'.
    matchMethod :: !PairMethod,
    -- | The best place and alternatives.
    matchHypotheses :: ![Hypothesis]
  }
  deriving stock (Eq, Show)

-- | Why a question is invalid.
data PairError
  = -- | The frames differ in size: width and height of each.
    PairSizes !(Int, Int) !(Int, Int)
  | -- | The frames are smaller than 4 x 4 or larger than 256 x 256 taxels, or the tables are for
    -- another size.
    PairFrameSize !(Int, Int)
  | -- | A frame has a value that is not finite.
    PairNotFinite
  | -- | The step is not finite or above a thousand taxels, the search negative or above 64 taxels,
    -- or the confidence not within 0..1.
    UnusablePairing !Pairing
  deriving stock (Eq, Show)

-- | Tables for frames of one size.
data Tables = Tables
  { tablesTemplates :: LatticeTemplates,
    tablesSpectra :: Spectra
  }

-- | The tables for an alphabet and frames of that width and height.
tablesFor :: Alphabet -> Int -> Int -> Tables
tablesFor known w h = Tables (templates known 0 w h) (spectra w h)

-- | Registers two frames. The tables must be for frames of their size.
registerPair :: Tables -> Pairing -> Raster -> Raster -> Either PairError Match
registerPair tables pairing a b
  | size /= rasterSize b = Left (PairSizes size (rasterSize b))
  | outside size || size /= placesFrame (templatePlaces (tablesTemplates tables)) =
    Left (PairFrameSize size)
  | not (all finite [a, b]) = Left PairNotFinite
  | not (sensible pairing) = Left (UnusablePairing pairing)
  | otherwise = Right (matched tables pairing a b)
  where
    size = rasterSize a
    outside (w, h) = min w h < 4 || max w h > 256
    finite = V.all (\v -> not (isNaN v || isInfinite v)) . rasterValues

sensible :: Pairing -> Bool
sensible (Pairing (x, y) search _ confidence) =
  abs x <= 1000
    && abs y <= 1000
    && search >= 0
    && search <= 64
    && confidence >= 0
    && confidence <= 1

matched :: Tables -> Pairing -> Raster -> Raster -> Match
matched tables (Pairing step search method confidence) a b =
  Match refusal best (deviations sure) fixed used (map surely (hypotheses 5 leastOther found))
  where
    (w, h) = rasterSize a
    coefficients = map (coefficientsOf (tablesSpectra tables)) [a, b]
    relief = reliefOf (tablesSpectra tables) 0 [a, b]
    densities = map (densityLog . fitTo (tablesSpectra tables) (reliefProcess relief)) coefficients
    evidences = map (likelihood (tablesTemplates tables) . whole) [a, b]
    used
      | method /= Auto = method
      | latticed = Lattice
      | otherwise = Blind
    -- Whether the frames are likelier under the lattice than under any other relief, if they are
    -- large enough for a symbol.
    latticed =
      min w h >= symbolWidth && sum (map logDensity evidences) > sum densities
    found = case (used, evidences) of
      (Lattice, [ea, eb]) -> latticePosterior step search ea eb
      (Correlation, _) -> correlationPosterior step search a b
      _ -> blindPosterior relief step search
    -- The best guess may come from noise along straight edges, or from a lattice that is not there.
    -- Its probability then comes from the corrected posterior.
    sure = case used of
      Blind -> alongStraight step search (a, b) found
      Lattice | not latticed -> priorAlone search step found
      _ -> found
    surely (Hypothesis shift' _) = Hypothesis shift' (probabilityAround sure shift')
    best = case hypotheses 1 0 found of
      first : _ -> surely first
      [] -> Hypothesis step 0
    (severalX, severalY) = apart (agreements step search a b)
    fixed =
      let (x, y) = marginals sure
       in (x >= confidence && not severalX, y >= confidence && not severalY)
    refusal
      | not (meeting (w, h) step search) = Just NoOverlap
      | any flat [a, b] = Just Blank
      | severalX || severalY = Just (if uncurry (/=) fixed then OneAxis else Ambiguous)
      | hypothesisProbability best >= confidence = Nothing
      | any blank (zip3 [a, b] coefficients densities) = Just Blank
      | uncurry (/=) fixed = Just OneAxis
      | otherwise = Just Ambiguous

-- | Whether frames of a size overlap anywhere in the search.
meeting :: (Int, Int) -> Taxels -> Double -> Bool
meeting (w, h) (x, y) search =
  abs x - search <= fromIntegral w - 1 && abs y - search <= fromIntegral h - 1

-- | Whether a frame shows only white noise: no process of relief is likelier than that by
-- 'telling'.
blank :: (Raster, V.Vector Double, Double) -> Bool
blank (image, coefficients, logs) =
  flat image || logs - whiteness coefficients < telling
  where
    telling = 5

-- | Whether a frame has one value throughout.
flat :: Raster -> Bool
flat image = V.maximum values - V.minimum values <= 1e-9
  where
    values = rasterValues image
