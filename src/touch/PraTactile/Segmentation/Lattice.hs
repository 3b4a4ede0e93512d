{-# OPTIONS_HADDOCK hide #-}

-- | The lattice of the symbols (the paper's section II.B, feature 3): "the distances along the
-- symbol axes to the neighbouring symbols" show which symbols are neighbours in a row or a column,
-- and so each symbol's place relative to the others.
--
-- Rows and columns are counted along the symbols' axes as the composite shows them. Only
-- recognising the symbols decides whether the lattice is upright or half-turned. 'halfTurned' gives
-- the other reading.
module PraTactile.Segmentation.Lattice
  ( -- * Arranging
    ClusterCell,
    Cluster (..),
    Conflict (..),
    arrange,
    neighbour,

    -- * The other reading
    halfTurned,

    -- * The lattice's tolerance
    pitchTolerance,
  )
where

import Data.List (sortOn)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import PraTactile.Geometry (columnPitch, rotated, rowPitch)
import PraTactile.Segmentation.Symbol (SymbolImage (..))

-- | A row and a column, counted from 0 from the topmost row and the leftmost column of a cluster.
type ClusterCell = (Int, Int)

-- | Symbols connected by neighbourhood.
data Cluster symbol
  = -- | Each symbol in its cell.
    Cluster !(Map ClusterCell symbol)
  | -- | The distances contradict each other: the contradiction, and all symbols of the cluster.
    Contradiction !(Conflict symbol) ![symbol]
  deriving stock (Eq, Show)

-- | A contradiction of the distances between symbols. Cells are counted from an arbitrary symbol
-- of the cluster.
data Conflict symbol
  = -- | Two paths from neighbour to neighbour lead to different cells for this symbol. The cell of
    -- the shorter path comes first.
    TwoCells !symbol !ClusterCell !ClusterCell
  | -- | Two symbols lie in one cell.
    SharedCell !ClusterCell !symbol !symbol
  deriving stock (Eq, Show)

-- | The greatest distance of a neighbour from its place in the lattice, in taxels along each axis:
-- half the clear space between symbols.
pitchTolerance :: Double
pitchTolerance = 4

-- | Arranges symbols in clusters, ordered by their first symbols from top to bottom and left to
-- right. The function gives the image of a symbol. Symbols without a chain of neighbours between
-- them are in different clusters, since the number of cells between them is unknown.
arrange :: (symbol -> SymbolImage) -> [symbol] -> [Cluster symbol]
arrange image symbols = go (Set.fromList (Map.keys numbered))
  where
    ordered = sortOn (\s -> let (x, y) = symbolCentre (image s) in (y, x)) symbols
    numbered = Map.fromList (zip [0 :: Int ..] ordered)
    go waiting = case Set.minView waiting of
      Nothing -> []
      Just (first, _) ->
        let (cells, conflict) = walk image numbered first
            members = Map.restrictKeys numbered (Map.keysSet cells)
            cluster = maybe (settle members cells) (`Contradiction` Map.elems members) conflict
         in cluster : go (waiting `Set.difference` Map.keysSet cells)

-- | All symbols that neighbourhood connects to the given one, each with its cell by the shortest
-- path, and the first contradiction found.
walk ::
  (symbol -> SymbolImage) ->
  Map Int symbol ->
  Int ->
  (Map Int ClusterCell, Maybe (Conflict symbol))
walk image symbols first = go [first] (Map.singleton first (0, 0)) Nothing
  where
    go [] cells conflict = (cells, conflict)
    go (here : queue) cells conflict =
      go (queue ++ Map.keys new) (cells `Map.union` new) (conflict `orElse` contradiction)
      where
        reached = Map.fromList (maybe [] (uncurry steps) (Map.lookup here cells))
        steps row column =
          [ (there, (row + i, column + j))
            | Just symbol <- [Map.lookup here symbols],
              (there, other) <- Map.toList symbols,
              Just (i, j) <- [neighbour (image symbol) (image other)]
          ]
        new = reached `Map.difference` cells
        contradiction = case filter
          (uncurry (/=) . snd)
          (Map.toList (Map.intersectionWith (,) cells reached)) of
          (there, (a, b)) : _ -> (\symbol -> TwoCells symbol a b) <$> Map.lookup there symbols
          [] -> Nothing
    orElse (Just c) _ = Just c
    orElse Nothing c = c

-- | The step (rows, columns) from one symbol to another, if they are neighbours in a row or a
-- column by the axes of both.
neighbour :: SymbolImage -> SymbolImage -> Maybe ClusterCell
neighbour here there = case (step here there, step there here) of
  (Just (i, j), Just (i', j')) | (i, j) == (negate i', negate j') -> Just (i, j)
  _ -> Nothing

-- | The step from the first symbol to the second, if they are neighbours by the axes of the first.
step :: SymbolImage -> SymbolImage -> Maybe ClusterCell
step here there
  | close across columnPitch && close down 0 = Just (0, 1)
  | close across (negate columnPitch) && close down 0 = Just (0, -1)
  | close across 0 && close down rowPitch = Just (1, 0)
  | close across 0 && close down (negate rowPitch) = Just (-1, 0)
  | otherwise = Nothing
  where
    close distance pitch = abs (distance - pitch) <= pitchTolerance
    (x, y) = symbolCentre here
    (x', y') = symbolCentre there
    (across, down) = rotated (negate (symbolAxis here)) (x' - x, y' - y)

-- | The symbols by their cells, counted from the upper left. A contradiction if two share a cell.
settle :: Map Int symbol -> Map Int ClusterCell -> Cluster symbol
settle members cells = case [SharedCell cell a b | (cell, a : b : _) <- Map.toList occupants] of
  conflict : _ -> Contradiction conflict (Map.elems members)
  [] ->
    Cluster
      (Map.mapKeys (\(row, column) -> (row - top, column - left)) (Map.mapMaybe single occupants))
  where
    occupants =
      Map.fromListWith
        (flip (++))
        (Map.elems (Map.intersectionWith (\cell symbol -> (cell, [symbol])) cells members))
    top = minimum (0 : map fst (Map.elems cells))
    left = minimum (0 : map snd (Map.elems cells))
    single occupant = case occupant of
      [symbol] -> Just symbol
      _ -> Nothing

-- | The cells after the lattice is turned by 180 degrees. The symbols stay as they are.
halfTurned :: Map ClusterCell a -> Map ClusterCell a
halfTurned cells = Map.mapKeys (\(row, column) -> (bottom - row, right - column)) cells
  where
    bottom = maximum (0 : map fst (Map.keys cells))
    right = maximum (0 : map snd (Map.keys cells))
