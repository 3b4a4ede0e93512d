{-# OPTIONS_HADDOCK hide #-}

-- | The log-probabilities of a word's letters in one symmetry, from the observed cells.
module PraTactile.Locate.Decoder.List.Letters
  ( Letters (..),
    lettersIn,
    surestFirst,
    logLikelihood,
  )
where

import Data.List (sort, sortOn)
import Data.Ord (Down (..))
import Data.Proxy (Proxy (..))
import qualified Data.Vector.Primitive as Primitive
import PraTactile.Field
import PraTactile.LinearCode.Elimination
import PraTactile.Locate.Belief
import PraTactile.Symmetry

-- | The cells of a patch as letters of a word, the surest cells first.
data Letters = Letters
  { lettersSymmetry :: !Symmetry,
    -- | The log-probability that all cells together give this symmetry.
    lettersShown :: !Double,
    -- | For each letter, the log-probabilities of all symbols given the symmetry.
    lettersGiven :: [Primitive.Vector Double],
    -- | For each cell in the given order, the joint log-probabilities of all symbols and the
    -- symmetry.
    lettersJoint :: !(Primitive.Vector Double),
    -- | For each cell in the given order, the index of its letter.
    lettersPlaces :: !(Primitive.Vector Int)
  }

-- | The letters of cells in a symmetry, which no cell may make impossible.
lettersIn :: Symmetry -> [Belief k] -> Letters
lettersIn o cells =
  Letters
    { lettersSymmetry = o,
      lettersShown = sum (map log shown),
      lettersGiven = map snd byCertainty,
      lettersJoint = Primitive.concat (map (Primitive.map log . probabilitiesIn o) cells),
      lettersPlaces = Primitive.fromList (map snd (sort (zip (map fst byCertainty) [0 ..])))
    }
  where
    shown = map (symmetryChance o) cells
    given =
      [ Primitive.map (\p -> log (p / whole)) (probabilitiesIn o b)
        | (whole, b) <- zip shown cells
      ]
    byCertainty = sortOn (Down . Primitive.maximum . snd) (zip [0 :: Int ..] given)

-- | Reorders one element for each cell into the order of the letters.
surestFirst :: Letters -> [a] -> [a]
surestFirst letters cells =
  map snd (sortOn fst (zip (Primitive.toList (lettersPlaces letters)) cells))

-- | The log-likelihood of a word, summed in the same order as a comparison with all positions does.
logLikelihood :: forall k. KnownField k => Letters -> Row k -> Double
logLikelihood letters word =
  Primitive.ifoldl'
    (\total j place -> total + letter j (Primitive.unsafeIndex word place))
    0
    (lettersPlaces letters)
  where
    letter j a = Primitive.unsafeIndex (lettersJoint letters) (j * q + toCode a)
    q = fieldOrder (Proxy :: Proxy k)
