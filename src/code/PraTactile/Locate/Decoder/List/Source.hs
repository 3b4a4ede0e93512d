{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The codewords of one information set, in order of the probability of their letters at the set.
module PraTactile.Locate.Decoder.List.Source
  ( SetSearch,
    sourceOf,
    sourceCount,
    sourceAtEnd,
    nextLoss,
    nextMass,
    unseenMass,
    advance,
  )
where

import Data.List (foldl', sortOn)
import Data.Ord (Down (..))
import qualified Data.Vector as Boxed
import qualified Data.Vector.Primitive as Primitive
import PraTactile.Field
import PraTactile.Field.Vector (addScaled)
import PraTactile.LinearCode.BestFirst
import PraTactile.LinearCode.Elimination
import PraTactile.LinearCode.InformationSet

-- | The search through the codewords of one information set.
data SetSearch (k :: Field) = SetSearch
  { -- | the codewords that span the code
    sourceRows :: Boxed.Vector (Row k),
    -- | the codeword with the likeliest letter at each place of the set
    sourceFirst :: Row k,
    -- | the log-probability of its letters at the set
    sourceBest :: !Double,
    -- | the remaining codewords: the loss in that log-probability, and the combination of rows to
    -- add
    sourceNext :: [(Double, [(Int, GF k)])],
    -- | the sum M of the probabilities of the searched letters
    sourceMass :: !Double,
    -- | the rounding error of that sum, for compensation
    sourceCarry :: !Double,
    -- | the number of searched codewords
    sourceCount :: !Int
  }

type role SetSearch nominal

-- | Begins a search, from the log-probabilities of all cells.
sourceOf ::
  forall k.
  KnownField k =>
  Boxed.Vector (Primitive.Vector Double) ->
  InformationSet k ->
  SetSearch k
sourceOf logs set =
  SetSearch unit (combination set (zip [0 ..] (map firstLetter options))) best stream 0 0 0
  where
    places = Primitive.toList (setPlaces set)
    unit = Boxed.fromList [combination set [(i, one)] | i <- [0 .. length places - 1]]
    -- For each place its possible letters, the likeliest first, with their log-probabilities.
    options = [possible letters | place <- places, Just letters <- [logs Boxed.!? place]]
    possible letters =
      sortOn
        (Down . snd)
        [(a, x) | (a, x) <- zip elements (Primitive.toList letters), not (isInfinite x)] ::
        [(GF k, Double)]
    firstLetter letters = sum (take 1 (map fst letters))
    best = sum [x | (_, x) : _ <- options]
    stream = [(loss, concatMap difference changed) | (loss, changed) <- bestFirst costs]
    difference (i, option) =
      [ (i, b - a)
        | Just letters@((a, _) : _) <- [choices Boxed.!? i],
          (b, _) : _ <- [drop option letters]
      ]
    choices = Boxed.fromList options
    costs =
      [ (i, [x - y | (_, x) : _ <- [letters], (_, y) <- letters])
        | (i, letters) <- zip [0 ..] options
      ]

-- | Whether all codewords have been searched, as far as probabilities are not zero.
sourceAtEnd :: SetSearch k -> Bool
sourceAtEnd = null . sourceNext

-- | The loss in log-probability from the best letters to the next ones; 0 at the end.
nextLoss :: SetSearch k -> Double
nextLoss s = case sourceNext s of
  (loss, _) : _ -> loss
  [] -> 0

-- | 1 - M, increased by its possible error.
unseenMass :: SetSearch k -> Double
unseenMass s = max 0 (1 - sourceMass s) + 1e-11

-- | The log-probability of the next letters at the set; minus infinity at the end.
nextMass :: SetSearch k -> Double
nextMass s = case sourceNext s of
  (loss, _) : _ -> sourceBest s - loss
  [] -> -1 / 0

-- | The next codeword, and the search after it.
advance :: KnownField k => SetSearch k -> (Row k, SetSearch k)
advance source = case sourceNext source of
  [] -> (sourceFirst source, source)
  (loss, terms) : later ->
    let !mass = exp (sourceBest source - loss) - sourceCarry source
        !total = sourceMass source + mass
        !carry = (total - sourceMass source) - mass
        add x (i, a) = maybe x (\unit -> addScaled a unit x) (sourceRows source Boxed.!? i)
     in ( foldl' add (sourceFirst source) terms,
          source
            { sourceNext = later,
              sourceMass = total,
              sourceCarry = carry,
              sourceCount = sourceCount source + 1
            }
        )
