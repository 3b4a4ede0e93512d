{-# OPTIONS_HADDOCK hide #-}

-- | The minimum distance of a linear code: the weight of a lightest nonzero codeword.
module PraTactile.LinearCode.MinimumDistance
  ( Lightest (..),
    lightest,
    leastWeight,
  )
where

import Data.List (foldl')
import qualified Data.Map.Strict as Map
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Field
import PraTactile.LinearCode
import PraTactile.LinearCode.Elimination
import PraTactile.LinearCode.InformationSet
import PraTactile.LinearCode.Search
import PraTactile.LinearCode.Weights

-- | The result of a search for a lightest codeword.
data Lightest k
  = -- | A lightest nonzero codeword.
    Lightest (Row k)
  | -- | The search was given up; the least weight is at least the first number and at most the
    -- second.
    Between Int Int
  | -- | The code has no codeword but zero.
    NoCodeword

{- Note [Brouwer and Zimmermann]
   ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
   The search for a lightest codeword is that of Note [Disjoint information sets] in
   "PraTactile.LinearCode.Search" with zero as the word. The codewords seen are the combinations of
   few rows of one set; those not seen are at least as heavy as the sum in that note. The search
   ends when the lightest codeword seen is no heavier than that sum. (K.-H. Zimmermann 1996; M.
   Grassl in "Discovering Mathematics with Magma", 2006.) -}

-- | Finds a lightest nonzero codeword by the method of Note [Brouwer and Zimmermann]. The search is
-- given up before it tests more codewords than the effort.
lightest :: KnownField k => Natural -> LinearCode k -> Lightest k
lightest effort code
  | k == 0 = NoCodeword
  | otherwise =
    search effort 0 Nothing (schedule count (informationSets size (codeBasis code)))
  where
    k = dimension code
    size = codeLength code
    q = fieldOrder code
    -- Up to a factor, and without zero.
    count w = if w == 0 then 0 else changes q k w `div` fromIntegral (q - 1)
    -- All codewords lighter than the bound have been seen.
    search left bound best steps = case steps of
      _ | Just x <- best, weight x <= bound -> Lightest x
      [] -> maybe NoCodeword Lightest best
      step : later
        | stepWords step > left -> Between (max 1 bound) (maybe size weight best)
        | otherwise ->
          search
            (left - stepWords step)
            (maybe size (+ 1) (stepSeen step))
            (foldl' (lighter (stepSet step)) best (stepLevels step))
            later
    lighter set best w = case nearFound (nearAt OneLightest set zeros level) of
      (_, terms) : _ -> Just (combination set terms)
      [] -> best
      where
        zeros = Primitive.map (const zero) (setRest set)
        level = Level {levelRows = w, levelLimit = below - 1 - w}
        below = maybe (size + 1) weight best

-- | The least weight of a nonzero codeword, by 'lightest', or by visiting all codewords if that is
-- shorter. If it takes more codewords than the effort, the result is a lower bound. 0 if there is
-- no nonzero codeword.
leastWeight :: KnownField k => Natural -> LinearCode k -> Int
leastWeight effort code = case lightest (min effort all') code of
  Lightest x -> weight x
  NoCodeword -> 0
  Between low _
    | all' <= effort -> maybe low fst (Map.lookupMin (Map.delete 0 (weights code)))
    | otherwise -> low
  where
    q = fromIntegral (fieldOrder code) :: Natural
    -- Up to a factor.
    all' = (q ^ dimension code - 1) `div` (q - 1)
