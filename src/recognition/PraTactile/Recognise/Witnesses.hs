{-# OPTIONS_HADDOCK hide #-}

-- | The witnesses of a grid: its certain symbols ('certain'), which support a position or
-- contradict it. Probabilities depend on a model of the sensor; the minimum distance of the
-- witnesses' cells does not.
module PraTactile.Recognise.Witnesses
  ( -- * A grid on a face
    GridOnFace (..),

    -- * Witnesses
    Witnesses (..),
    witnessesOf,
    bySource,

    -- * For and against a position
    WitnessSplit (..),
    witnessesAt,
    mostlyWrong,
  )
where

import Data.List (partition)
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust)
import Data.Set (Set)
import qualified Data.Set as Set
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Locate
import PraTactile.Recognise.FaceGrid
import PraTactile.Recognise.Reading
import PraTactile.Recognise.Recogniser
import PraTactile.Recognise.SymbolBelief
import PraTactile.Recognise.Tolerance
import PraTactile.Segmentation.Lattice (ClusterCell)
import PraTactile.Symmetry

-- | A grid of symbols as it lies on the face.
data GridOnFace = GridOnFace
  { -- | the orientation in which the face is seen
    onFaceOrientation :: Symmetry,
    -- | the symbols in each cell of the face, set upright; an ignored cell is present without
    -- symbols
    onFaceCells :: Cells,
    -- | for each group of connected symbols, their 'readNumber's
    onFaceGroups :: [Set Int],
    -- | the symbols along the other axis than the grid's
    onFaceSideways :: [ReadSymbol],
    -- | the symbols off the grid
    onFaceStrays :: [ReadSymbol]
  }

-- | The certain symbols of a grid.
data Witnesses = Witnesses
  { -- | the witnesses of the face's orientation, each with its cell of the face
    witnessesKnown :: [(ClusterCell, ReadSymbol)],
    -- | the witnesses of another orientation
    witnessesOtherWayUp :: [ReadSymbol],
    -- | the witnesses off the grid
    witnessesStray :: [ReadSymbol],
    -- | the cells of 'witnessesKnown', each once
    witnessesCells :: [Position],
    -- | the minimum distance of these cells
    witnessesDistance :: Known,
    -- | how many witnesses may be wrong: what the tolerance states, or what that distance
    -- guarantees
    witnessesRadius :: Natural
  }

-- | The witnesses of a grid on a face.
witnessesOf :: KnownField k => Recogniser k -> Tolerance -> GridOnFace -> Witnesses
witnessesOf reader tolerance face =
  Witnesses
    { witnessesKnown = [(cell, s) | (cell, s, o) <- inCells, o == orientation],
      witnessesOtherWayUp =
        [s | (_, s, o) <- inCells, o /= orientation]
          ++ filter (isJust . certain) (onFaceSideways face),
      witnessesStray = filter (isJust . certain) (onFaceStrays face),
      witnessesCells = offsets,
      witnessesDistance = distance,
      witnessesRadius = radiusFor (toleratedErrors tolerance) (atLeast distance)
    }
  where
    orientation = onFaceOrientation face
    inCells =
      [ (cell, s, o)
        | (cell, here) <- Map.toList (onFaceCells face),
          s <- here,
          Just (o, _) <- [certain s]
      ]
    offsets =
      map offsetOf (Set.toAscList (Set.fromList [cell | (cell, _, o) <- inCells, o == orientation]))
    distance = cellsDistance (recogniserLocator reader) offsets

-- | The cells of 'witnessesKnown', one list for each composite that has any. A face may be read
-- from several composites.
bySource :: Witnesses -> [[Position]]
bySource witnesses =
  Map.elems $
    Map.fromListWith
      (++)
      [(readSource s, [offsetOf cell]) | (cell, s) <- witnessesKnown witnesses]

-- | The witnesses that support a position and those that contradict it.
data WitnessSplit = WitnessSplit
  { -- | those that agree with the array
    agreeingWitnesses :: [ReadSymbol],
    -- | those that disagree with the array, have another orientation, or lie off the grid
    wrongWitnesses :: [ReadSymbol]
  }

-- | Sorts the witnesses by whether they support a position. The position is that of the grid's
-- upper left cell in the array.
witnessesAt :: KnownField k => Recogniser k -> Witnesses -> Position -> WitnessSplit
witnessesAt reader witnesses position =
  WitnessSplit
    { agreeingWitnesses = map snd agreeing,
      wrongWitnesses =
        map snd misfits ++ witnessesOtherWayUp witnesses ++ witnessesStray witnesses
    }
  where
    (agreeing, misfits) = partition agrees (witnessesKnown witnesses)
    agrees (cell, s) = codeIn cell == fmap snd (certain s)
    codeIn cell = toCode . snd <$> cellFrom reader position cell

-- | The numbers, from 0, of the composites that have more wrong witnesses than agreeing ones.
mostlyWrong :: WitnessSplit -> [Int]
mostlyWrong (WitnessSplit agreeing wrong) =
  [ source
    | (source, n) <- Map.toAscList (counts wrong),
      n > Map.findWithDefault 0 source (counts agreeing)
  ]
  where
    counts symbols = Map.fromListWith (+) [(readSource s, 1 :: Int) | s <- symbols]
