{-# OPTIONS_HADDOCK hide #-}

-- | What the observed cells say of the letters of a word, in one symmetry.
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

-- | The cells of a patch as the letters of a word, the surest cells first.
data Letters = Letters
  { lettersSymmetry :: !Symmetry,
    -- | The logarithm of how probable all cells together make this symmetry.
    lettersShown :: !Double,
    -- | Of each letter the logarithms of the probabilities of all symbols, given the symmetry.
    lettersGiven :: [Primitive.Vector Double],
    -- | Cell by cell, as the cells were given, those of all symbols together with the symmetry.
    lettersJoint :: !(Primitive.Vector Double),
    -- | Of each of these cells, which letter of a word it is.
    lettersPlaces :: !(Primitive.Vector Int)
  }

-- | The letters that cells are in a symmetry, which none of them makes impossible.
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

-- | What is given of cells, in their order, in the order of the letters.
surestFirst :: Letters -> [a] -> [a]
surestFirst letters cells =
  map snd (sortOn fst (zip (Primitive.toList (lettersPlaces letters)) cells))

-- | The logarithm of the likelihood of a word, summed in the order in which a comparison with all
-- positions sums.
logLikelihood :: forall k. KnownField k => Letters -> Row k -> Double
logLikelihood letters word =
  Primitive.ifoldl'
    (\total j place -> total + letter j (Primitive.unsafeIndex word place))
    0
    (lettersPlaces letters)
  where
    letter j a = Primitive.unsafeIndex (lettersJoint letters) (j * q + toCode a)
    q = fieldOrder (Proxy :: Proxy k)
