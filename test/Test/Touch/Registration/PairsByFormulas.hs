{-# OPTIONS_GHC -O1 #-}

-- | Tests the posterior of one frame's place in another, blind and by correlation, against the
-- formulas.
module Test.Touch.Registration.PairsByFormulas (spec) where

import qualified Data.Vector.Storable as V
import PraTactile.Image
import PraTactile.Registration.AllPairs (pairsEvidence)
import PraTactile.Registration.Definition.Pairs
import qualified PraTactile.Registration.Overlap as Overlap
import PraTactile.Registration.Pair.Methods
import PraTactile.Registration.Posterior
import PraTactile.Registration.Settings (Registration (..), standardRegistration)
import PraTactile.Registration.Spectrum
import Test.Effort (withCases)
import Test.Hspec
import Test.QuickCheck hiding (generate, tables)
import Test.Touch.Registration.Reliefs (genFrames)

spec :: Spec
spec = do
  withCases 3 25 processSpec
  withCases 3 50 pairSpec

tables :: Spectra
tables = spectra 9 8

processSpec :: Spec
processSpec = do
  it "the noise's share is at least the given one, or 125 if that is more" $
    forAllBlind (genFrames 9 8) $ \((a, b), _) ->
      conjoin
        [ counterexample (show least) $
            property (processNoise process >= min least 125)
          | least <- [0, 1e-7, 4, 5, 5.1, 7, 24.9, 25, 60, 125, 126, 1e9],
            let process = processOf tables least (map (coefficientsOf tables) [a, b])
        ]
  it "a frame's likelihood is that of the likeliest process, or of white noise, by the formulas" $
    forAllBlind (genFrames 9 8) $ \((a, b), _) ->
      let coefficients = map (coefficientsOf tables) [a, b]
          process = processOf tables 0 coefficients
          fits = map (fitTo tables process) coefficients
          wanted = reliefOf [a, b]
          varying = [image | image <- [a, b], (> 1e-9) `any` standardDeviation image]
       in conjoin
            [ near [processNoise process] [reliefNoise wanted],
              near (map reliefScale fits) (reliefScales wanted),
              near (map densityLog fits) (reliefLogs wanted),
              near (map (whiteness . coefficientsOf tables) varying) (map whiteNoise varying)
            ]

pairSpec :: Spec
pairSpec = do
  it "blind, the posterior of a place follows from all heights and the prior" $
    forAllBlind (genAsked [0, 0.25, 1]) $ \((a, b), step, search) ->
      let relief = Overlap.reliefOf tables 0 [a, b]
       in known (blindPosterior relief step search) (blindly step search a b)
  it "a layout in which two frames overlap has the likelihood of their displacements" $
    forAllBlind (genAsked [0, 0.25]) $ \((a, b), (x, y), search) ->
      forAll (elements [0.5, 1, 2]) $ \sigma ->
        let step = (if abs x < 2 then 3 else x, y) :: (Double, Double)
            settings = standardRegistration {registrationSigma = Just sigma}
            relief = Overlap.reliefOf tables 0 [a, b]
            -- A pair that shares a smaller part of a frame is left out.
            shared = (9 - abs (fst step)) * (8 - abs (snd step)) / 72 :: Double
         in search >= (0 :: Double) && shared >= 0.2
              ==> near
                [pairsEvidence settings relief [((0, 0), a), (step, b)]]
                [pairEvidence (sqrt 2 * sigma) step a b]
  it "by correlation, the posterior of a place follows from rho and the prior" $
    forAllBlind (genAsked [0, 1]) $ \((a, b), step, search) ->
      known (correlationPosterior step search a b) (byCorrelation step search a b)
  where
    genAsked off = do
      (frames, (dx, dy)) <- genFrames 9 8
      search <- elements [0, 1, 2, 3]
      -- Without a search the step is whole.
      let near0 = if search > 0 then off else [0]
      (ex, ey) <- (,) <$> elements near0 <*> elements (map negate near0)
      pure (frames, (fromIntegral dx + ex, fromIntegral dy + ey), search)
    known (GridPosterior (ox, oy) spacing (columns, rows) masses) wanted =
      spacing === 1
        .&&. [(round ox + x, round oy + y) | y <- [0 .. rows - 1], x <- [0 .. columns - 1]]
          === map fst wanted
        .&&. near (V.toList masses) (map snd wanted)

near :: [Double] -> [Double] -> Property
near found wanted =
  counterexample (show (found, wanted)) $
    length found == length wanted
      && and (zipWith (\p q -> abs (p - q) <= 1e-6 * max 1 (abs q)) found wanted)
