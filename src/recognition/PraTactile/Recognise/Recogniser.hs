{-# OPTIONS_HADDOCK hide #-}

-- | What recognition needs: a locator for the array, the placement of the faces, and a reader for
-- the symbols.
module PraTactile.Recognise.Recogniser
  ( Recogniser (..),
    recogniser,
    recogniserUpTo,
    recogniserWindow,
    recogniserScale,
    cellFrom,
    RecogniserError (..),
  )
where

import Data.Bifunctor (first)
import Data.Maybe (fromMaybe)
import Numeric.Natural (Natural)
import PraTactile.Array (ArrayOn (..), Position (..), Shape (..), arrayShape, cellAt)
import PraTactile.Classification.Network (outputCount)
import PraTactile.Classification.Reader (Reader (..))
import PraTactile.Field (GF, KnownField, fieldOrder)
import PraTactile.Grid (canonicalPosition)
import PraTactile.Locate
  ( Locator,
    LocatorError,
    decoderOfProbabilities,
    largestSearchedArray,
    locatorArray,
    locatorMask,
    locatorUpTo,
  )
import PraTactile.Object.Canonical (canonicalPitch)
import PraTactile.Object.Placement (Pitch, Placement, placementPitch, placementShape)
import PraTactile.Relief (symbolScale)
import PraTactile.Segmentation.Lattice (ClusterCell)
import PraTactile.Shape (alphabetSize)
import PraTactile.Window (Mask, Packing (..), maskExtent)

-- | A locator for an array, the placement of faces on that array, and a reader of symbols.
data Recogniser k = Recogniser
  { -- | for the array on its surface, with its window
    recogniserLocator :: Locator k,
    -- | the faces on the array, to look positions up in
    recogniserPlacement :: Placement,
    -- | the trained network and its calibration, to read symbols with
    recogniserReader :: Reader
  }

-- | The rows and columns of the array's window.
recogniserWindow :: Recogniser k -> Shape
recogniserWindow = maskExtent . locatorMask . recogniserLocator

-- | The size of the placement's symbols relative to the paper's.
recogniserScale :: Recogniser k -> Rational
recogniserScale = fromMaybe 1 . symbolScale . placementPitch . recogniserPlacement

-- | The position in the array of a cell of a grid, and the symbol there. The first position is that
-- of the grid's upper left cell. 'Nothing' beyond the sheet.
cellFrom :: KnownField k => Recogniser k -> Position -> ClusterCell -> Maybe (Position, GF k)
cellFrom reader (Position r c) (i, j) = (\place -> (place, cellAt array place)) <$> at
  where
    ArrayOn surface array = locatorArray (recogniserLocator reader)
    at =
      canonicalPosition
        surface
        (arrayShape array)
        (toInteger r + toInteger i)
        (toInteger c + toInteger j)

-- | Why there is no recogniser.
data RecogniserError
  = -- | No decoder can locate probabilities in this array: it is too large for a codebook, and its
    -- logarithms cannot be taken.
    RecogniserArray LocatorError
  | -- | The network has this many outputs, the alphabet this many shapes, and the field this many
    -- elements. The three must be equal.
    ClassesDiffer Int Int Int
  | -- | The objects are laid on an array of the first shape, but the array has the second.
    ArraysDiffer Shape Shape
  | -- | The objects' symbols have the first pitch, which is not a multiple of the second, the
    -- paper's.
    PitchesDiffer Pitch Pitch
  deriving stock (Eq, Show)

-- | Builds a recogniser from an array on a surface, a rectangular window, a placement and a reader.
--
-- Arrays of up to 2^16 cells are searched whole by a codebook. Larger ones are decoded as in
-- "PraTactile.Locate", so that a press costs time by what was touched, not by the array's size. If
-- the array's logarithms cannot be taken, or its surface is foreign, the codebook serves up to
-- 'largestSearchedArray' cells.
--
-- Refuses larger arrays of the last kind, a number of classes that differs from the field's, a
-- placement on an array of another shape, and a pitch that is not the paper's times one factor.
recogniser ::
  KnownField k =>
  ArrayOn k ->
  Mask ->
  Placement ->
  Reader ->
  Either RecogniserError (Recogniser k)
recogniser on window layout reader = case upTo (2 ^ (16 :: Int)) of
  Left (RecogniserArray _) -> upTo largestSearchedArray
  made -> made
  where
    upTo most = recogniserUpTo most on window layout reader

-- | 'recogniser' with a limit of its own, in cells: a codebook searches no larger array.
recogniserUpTo ::
  KnownField k =>
  Natural ->
  ArrayOn k ->
  Mask ->
  Placement ->
  Reader ->
  Either RecogniserError (Recogniser k)
recogniserUpTo most on@(ArrayOn _ array) window layout reader
  | any (/= q) [given, shaped] = Left (ClassesDiffer given shaped q)
  | placementShape layout /= arrayShape array =
    Left (ArraysDiffer (placementShape layout) (arrayShape array))
  | Nothing <- symbolScale (placementPitch layout) =
    Left (PitchesDiffer (placementPitch layout) canonicalPitch)
  | otherwise = do
    _ <- first RecogniserArray (decoderOfProbabilities decoding)
    Right
      Recogniser
        { recogniserLocator = decoding,
          recogniserPlacement = layout,
          recogniserReader = reader
        }
  where
    q = fieldOrder array
    -- No table of windows is used here, so the order of cells in it does not matter.
    decoding = locatorUpTo most Nothing MostSignificantFirst on window
    given = outputCount (readerNetwork reader)
    shaped = alphabetSize (readerAlphabet reader)
