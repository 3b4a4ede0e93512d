{-# OPTIONS_HADDOCK hide #-}

-- | The certain symbols of a grid, which support a position or contradict it. Probabilities depend
-- on a model of the sensor; the minimum distance of these symbols' cells does not.
module PraTactile.Recognise.Witnesses
  ( -- * A grid on a face
    GridOnFace (..),

    -- * Witnesses
    Witnesses (..),
    witnessesOf,
    bySource,

    -- * For and against a position
    Standing (..),
    standingAt,
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
import PraTactile.Locate hiding (Cell)
import PraTactile.Recognise.FaceGrid
import PraTactile.Recognise.Reading
import PraTactile.Recognise.Recogniser
import PraTactile.Recognise.SymbolBelief
import PraTactile.Recognise.Tolerance
import PraTactile.Segmentation.Lattice (Cell)
import PraTactile.Symmetry

-- | A grid of symbols as it lies on the face.
data GridOnFace = GridOnFace
  { -- | the orientation in which the face is seen
    onFaceOrientation :: Symmetry,
    -- | by cells of the face; an ignored cell is present without symbols
    onFaceCells :: Cells,
    -- | the 'readNumber's of the symbols of each group
    onFaceGroups :: [Set Int],
    -- | symbols along the other axis
    onFaceSideways :: [ReadSymbol],
    -- | symbols off the grid
    onFaceStrays :: [ReadSymbol]
  }

-- | The certain symbols of a grid.
data Witnesses = Witnesses
  { -- | those of the face's orientation, each with its cell
    witnessesKnown :: [(Cell, ReadSymbol)],
    -- | those of another orientation
    witnessesOtherWayUp :: [ReadSymbol],
    -- | those off the grid
    witnessesStray :: [ReadSymbol],
    -- | the cells of those of the face's orientation
    witnessesCells :: [Position],
    -- | the minimum distance of these cells
    witnessesDistance :: Known,
    -- | how many witnesses may be wrong
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

-- | The cells of the witnesses of the face's orientation, one list for each composite.
bySource :: Witnesses -> [[Position]]
bySource witnesses =
  Map.elems $
    Map.fromListWith
      (++)
      [(readSource s, [offsetOf cell]) | (cell, s) <- witnessesKnown witnesses]

-- | The witnesses that support a position and those that contradict it.
data Standing = Standing
  { standingAgreeing :: [ReadSymbol],
    -- | those that disagree with the array, have another orientation, or lie off the grid
    standingWrong :: [ReadSymbol]
  }

-- | Sorts the witnesses by whether they support a position of the grid's upper left cell.
standingAt :: KnownField k => Recogniser k -> Witnesses -> Position -> Standing
standingAt reader witnesses position =
  Standing
    { standingAgreeing = map snd agreeing,
      standingWrong =
        map snd misfits ++ witnessesOtherWayUp witnesses ++ witnessesStray witnesses
    }
  where
    (agreeing, misfits) = partition agrees (witnessesKnown witnesses)
    agrees (cell, s) = codeIn cell == fmap snd (certain s)
    codeIn cell = toCode . snd <$> cellFrom reader position cell

-- | The composites, counted from 0, with more wrong than agreeing witnesses.
mostlyWrong :: Standing -> [Int]
mostlyWrong (Standing agreeing wrong) =
  [ source
    | (source, n) <- Map.toAscList (counts wrong),
      n > Map.findWithDefault 0 source (counts agreeing)
  ]
  where
    counts symbols = Map.fromListWith (+) [(readSource s, 1 :: Int) | s <- symbols]
