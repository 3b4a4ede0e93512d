{-# OPTIONS_HADDOCK hide #-}

-- | The evidence of symbols read on a grid: which way up the face may lie, and what the array has
-- in each cell, as a symbol or as probabilities.
module PraTactile.Recognise.SymbolBelief
  ( certain,
    axisOf,
    waysUp,
    beliefAlong,
    knownPatch,
  )
where

import qualified Data.Map.Strict as Map
import Data.Proxy (Proxy (..))
import PraTactile.Field
import PraTactile.Locate (Belief, LocateError, Patch, combined, oriented, patch)
import PraTactile.Recognise.FaceGrid
import PraTactile.Recognise.Reading
import PraTactile.Symbol (elementOfClass)
import PraTactile.Symmetry

-- | The orientation and class of a symbol that counts as a witness; 'Nothing' for any other.
--
-- A complete symbol counts if the network knows it as its likeliest class, its doubt ('readDoubt')
-- is below 0.1, and its probability of being a foreign shape ('readForeignProbability') is below
-- 0.1. A part counts if at least a third of it was touched and its doubt is below 0.001. Smaller
-- parts do not count: frames that are a taxel off may turn one symbol's part into another's. The
-- network may also know things that are not symbols, such as a remnant at an edge or a symbol that
-- two frames show in two places. These do not count, so they contradict no symbol.
certain :: ReadSymbol -> Maybe (Symmetry, Int)
certain s
  | readSeen s < 1 =
    if readSeen s >= 1 / 3 && readDoubt s < 0.001 then Just (readLikeliest s) else Nothing
  | readDoubt s < 0.1 && readForeignProbability s < 0.1 && readClass s == Just (readLikeliest s) =
    readClass s
  | otherwise = Nothing

-- | The axis of the symbols: 'identity', or @turned 1@ if the likeliest orientation of any lies on
-- its side.
axisOf :: Cells -> Symmetry
axisOf cells
  | or [exchangesAxes (fst (readLikeliest s)) | here <- Map.elems cells, s <- here] = turned 1
  | otherwise = identity

-- | The two ways up that a grid of symbols along one axis may have.
waysUp :: [Symmetry]
waysUp = [identity, turned 2]

-- | The belief about what a cell holds and which way up it is ('waysUp'), from the symbols read in
-- it along an axis. The symbols count as independent observations. 'Nothing' if nothing is
-- possible.
beliefAlong :: forall k. KnownField k => Symmetry -> [ReadSymbol] -> Maybe (Belief k)
beliefAlong axis here = traverse look here >>= combined
  where
    look s = either (const Nothing) Just (oriented [(way, chances s way) | way <- waysUp])
    chances s way =
      [ sum [p | (what, p) <- readChances s, what == (axis <> way, c)]
        | c <- [0 .. fieldOrder (Proxy :: Proxy k) - 1]
      ]

-- | The patch of the symbols that the network knows in this orientation. A cell is observed if all
-- its symbols known in this orientation have one class. Refuses a grid without cells.
knownPatch :: KnownField k => Cells -> Symmetry -> Either LocateError (Patch (GF k))
knownPatch cells orientation = patch (map (map (>>= agreed)) (gridRows cells))
  where
    agreed here = case [c | s <- here, Just (o, c) <- [readClass s], o == orientation] of
      c : others | all (== c) others -> either (const Nothing) Just (elementOfClass c)
      _ -> Nothing
