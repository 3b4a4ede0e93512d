{-# OPTIONS_HADDOCK hide #-}

-- | What the symbols read on a grid say: which way up the face may lie, and what the array then has
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

-- | What a symbol is, if that is certain: the network knows it, and that leaves less than a tenth
-- of doubt, also that it is none of ours, or it is a part of at least a third that leaves
-- less than a thousandth: of less, frames that were put together a taxel wrong may make another
-- symbol. What else lies on a face, a symbol's rest beside an edge or one that two frames show in
-- two places, the network may know all the same: such a symbol stands against no others.
certain :: ReadSymbol -> Maybe (Symmetry, Int)
certain s
  | readSeen s < 1 =
    if readSeen s >= 1 / 3 && readDoubt s < 0.001 then Just (readLikeliest s) else Nothing
  | readDoubt s < 0.1 && readNone s < 0.1 && readClass s == Just (readLikeliest s) = readClass s
  | otherwise = Nothing

-- | How the symbols' axis lies: 'identity', or @turned 1@.
axisOf :: Cells -> Symmetry
axisOf cells
  | or [exchangesAxes (fst (readLikeliest s)) | here <- Map.elems cells, s <- here] = turned 1
  | otherwise = identity

-- | The two ways up that symbols may lie along their axis, as a grid of them is seen.
waysUp :: [Symmetry]
waysUp = [identity, turned 2]

-- | What the symbols of a cell say, independent looks at it, of the way up along an axis and of the
-- classes. 'Nothing' if nothing is possible.
beliefAlong :: forall k. KnownField k => Symmetry -> [ReadSymbol] -> Maybe (Belief k)
beliefAlong axis here = traverse look here >>= combined
  where
    look s = either (const Nothing) Just (oriented [(way, chances s way) | way <- waysUp])
    chances s way =
      [ sum [p | (what, p) <- readChances s, what == (axis <> way, c)]
        | c <- [0 .. fieldOrder (Proxy :: Proxy k) - 1]
      ]

-- | The symbols of this orientation that the network knows, where all of a cell agree. Refuses no
-- cells.
knownPatch :: KnownField k => Cells -> Symmetry -> Either LocateError (Patch (GF k))
knownPatch cells orientation = patch (map (map (>>= agreed)) (gridRows cells))
  where
    agreed here = case [c | s <- here, Just (o, c) <- [readClass s], o == orientation] of
      c : others | all (== c) others -> either (const Nothing) Just (elementOfClass c)
      _ -> Nothing
