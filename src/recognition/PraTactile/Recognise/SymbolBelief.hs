-- | What the symbols read on a grid say: in which orientation the face is seen, and what the array
-- has in each cell, as a symbol or as probabilities.
module PraTactile.Recognise.SymbolBelief
  ( certain,
    likeliestOrientation,
    beliefIn,
    knownPatch,
  )
where

import Data.List (foldl')
import qualified Data.Map.Strict as Map
import PraTactile.Field
import PraTactile.Locate (Belief, LocateError, Patch, belief, patch)
import PraTactile.Recognise.FaceGrid
import PraTactile.Recognise.Reading
import PraTactile.Symbol (elementOfClass)
import PraTactile.Symmetry

-- | What a symbol is, if that is certain: the network knows it and its shape leaves less than a
-- tenth of doubt, or it is a part of at least a third that leaves less than a thousandth: of less,
-- frames that were put together a taxel wrong may make another symbol. What else lies on a face, a
-- symbol's rest beside an edge or one that two frames show in two places, the network may know all
-- the same: such a symbol stands against no others.
certain :: ReadSymbol -> Maybe (Symmetry, Int)
certain s
  | readSeen s < 1 =
    if readSeen s >= 1 / 3 && readDoubt s < 0.001 then Just (readLikeliest s) else Nothing
  | readDoubt s < 0.1 = readClass s
  | otherwise = Nothing

-- | The orientation of the symbols' axis that fits them best, and the probability that it is the
-- other one, by what the symbols themselves show. Upright symbols decide for themselves; the code
-- is not asked.
likeliestOrientation :: Int -> Cells -> (Symmetry, Double)
likeliestOrientation q cells
  | difference >= 0 = (this, doubt difference)
  | otherwise = (other, doubt (negate difference))
  where
    sideways = or [exchangesAxes (fst (readLikeliest s)) | here <- Map.elems cells, s <- here]
    (this, other) = if sideways then (turned 1, turned 3) else (identity, turned 2)
    difference =
      sum
        [ log (sum (chances q this here)) - log (sum (chances q other here))
          | here <- Map.elems cells
        ]
    doubt d = 1 / (1 + exp d)

-- | What the symbols read in a cell say of each class if the face lies so, up to a factor: the
-- product over the symbols, which were seen independently.
chances :: Int -> Symmetry -> [ReadSymbol] -> [Double]
chances q orientation here = foldl' (zipWith (*)) (replicate q 1) (map ofSymbol here)
  where
    ofSymbol s =
      [sum [p | (what, p) <- readChances s, what == (orientation, c)] | c <- [0 .. q - 1]]

-- | The probabilities of the classes in a cell.
beliefIn :: KnownField k => Int -> Symmetry -> [ReadSymbol] -> Maybe (Belief k)
beliefIn q orientation here
  | null here || total <= 0 = Nothing
  | otherwise = either (const Nothing) Just (belief (map (/ total) weights))
  where
    weights = chances q orientation here
    total = sum weights

-- | The symbols of this orientation that the network knows, where all of a cell agree. Refuses no
-- cells.
knownPatch :: KnownField k => Cells -> Symmetry -> Either LocateError (Patch (GF k))
knownPatch cells orientation = patch (map (map (>>= agreed)) (gridRows cells))
  where
    agreed here = case [c | s <- here, Just (o, c) <- [readClass s], o == orientation] of
      c : others | all (== c) others -> either (const Nothing) Just (elementOfClass c)
      _ -> Nothing
