-- | The sequence obeys its recurrence, and is a maximal-length one (MacWilliams and Sloane, 1976).
module PraTactile.Conformance.Laws.Sequence
  ( sequenceLaws
  ) where

import Control.Monad (foldM)
import qualified Data.Map.Strict as Map
import Numeric.Natural (Natural)
import Test.QuickCheck

import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Law
import PraTactile.Profile (Profile (..), Reading (..))

-- | The laws of the sequence.
sequenceLaws :: [Law Session]
sequenceLaws =
  [ Law "s(0), ..., s(n-1) are the initial state" (\s -> equal (traverse (term s) [0 .. degree s - 1]) (pure (profileState (profile s))))
  , Law "c0 s(i) + c1 s(i+1) + ... + cn s(i+n) = 0, with c read backwards for a reciprocal polynomial" (\s ->
      forTerms s (\i -> equal (combination s (recurrence s) (traverse (\k -> term s (i + k)) [0 .. degree s])) (pure 0)))
  , Law "s(i + q^n - 1) = s(i)" (\s -> forTerms s (\i -> equal (term s (i + period s)) (term s i)))
  , Law "in a period 0 occurs q^(n-1) - 1 times and every other element q^(n-1) times" (\s ->
      period s <= 4096 ==>
        let often = profileOrder (profile s) ^ (degree s - 1)
            expected = Map.fromList (filter ((> 0) . snd) ((0, often - 1) : [ (a, often) | a <- [1 .. profileOrder (profile s) - 1] ]))
        in equal (Map.fromListWith (+) . map (\a -> (a, 1)) <$> traverse (term s) [0 .. period s - 1]) (pure expected))
  ]
  where
    polynomialOf = profilePolynomial . profile
    degree :: Session -> Natural
    degree s = fromIntegral (length (polynomialOf s)) - 1
    period s = profileOrder (profile s) ^ degree s - 1
    -- The reciprocal's coefficients are those of the polynomial backwards, up to a factor that does not matter here.
    recurrence s = case profileReading (profile s) of
      Characteristic -> polynomialOf s
      Reciprocal -> reverse (polynomialOf s)
    combination s coefficients terms = do
      values <- terms
      products <- sequence (zipWith (multiply s) coefficients values)
      foldM (add s) 0 products
