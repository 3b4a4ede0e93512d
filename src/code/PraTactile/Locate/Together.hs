{-# LANGUAGE DerivingStrategies #-}

-- |
-- Several patches of one face at known displacements from each other: their cells together tell the
-- position better than each alone, and a patch that does not belong is named.
module PraTactile.Locate.Together
  ( Together (..)
  , nearestTogether
  ) where

import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Locate.Book
import PraTactile.Locate.Nearest
import PraTactile.Locate.Patch
import PraTactile.Locate.Search (largestSearchedArray)

-- | Where patches are together, and what each is worth.
data Together = Together
  { togetherDecision :: Decision
  -- ^ Of all cells in one patch, whose upper left is that of the rectangle around all patches.
  , togetherOffsets :: [Position]
  -- ^ Where in it the upper left cell of each patch is, in the order given.
  , togetherDisputed :: [Position]
  -- ^ The cells of it, which count as not observed, that two patches saw differently.
  , togetherWrong :: [Int]
  -- ^ How many cells of each patch are wrong, disputed ones left out, if the patches are where they were located; a patch with many of
  -- them is not where its displacement says.
  }
  deriving stock (Eq, Show)

-- | Locate patches together, each given with its displacement, rows down and columns to the right, from a common point. Refuses no patches
-- ('PatchEmpty'), and a rectangle around them of more cells than a book has ('PatchTooLarge').
nearestTogether :: KnownField k => Book k -> Radius -> [((Integer, Integer), Patch k)] -> Either LocateError Together
nearestTogether shelf radius given
  | spanned > largestSearchedArray = Left (PatchTooLarge spanned largestSearchedArray)
  | otherwise = do
      joined <- patch [[Map.lookup (i, j) agreed | j <- [left .. right]] | i <- [top .. bottom]]
      let decision = nearest shelf radius joined
          wrong = Set.fromList (decisionWrong decision)
      pure
        Together
          { togetherDecision = decision
          , togetherOffsets = [placed at | (at, _) <- given]
          , togetherDisputed = map placed (Set.toAscList disputed)
          , togetherWrong = [length (filter ((`Set.member` wrong) . placed) (map fst (cellsOf g))) | g <- given]
          }
 where
  spanned = fromInteger ((bottom - top + 1) * (right - left + 1)) :: Natural
  cellsOf ((r, c), p) = [((r + toInteger i, c + toInteger j), a) | (Position i j, a) <- observedCells p]
  seen = Map.fromListWith Set.union [(at, Set.singleton a) | g <- given, (at, a) <- cellsOf g]
  disputed = Map.keysSet (Map.filter ((> 1) . Set.size) seen)
  agreed = Map.mapMaybe (\values -> if Set.size values == 1 then Set.lookupMin values else Nothing) seen
  placed (r, c) = Position (fromInteger (r - top)) (fromInteger (c - left))
  top = minimum' [r | ((r, _), _) <- given]
  left = minimum' [c | ((_, c), _) <- given]
  bottom = maximum' [r + toInteger (rows (patchShape p)) - 1 | ((r, _), p) <- given]
  right = maximum' [c + toInteger (columns (patchShape p)) - 1 | ((_, c), p) <- given]
  minimum' xs = if null xs then 0 else minimum xs
  maximum' xs = if null xs then -1 else maximum xs
