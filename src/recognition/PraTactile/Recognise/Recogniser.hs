{-# OPTIONS_HADDOCK hide #-}

-- | What symbols are recognised and located with.
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
import PraTactile.Segmentation.Lattice (Cell)
import PraTactile.Shape (alphabetSize)
import PraTactile.Window (Mask, Packing (..), maskExtent)

-- | All that recognition needs: what locates cells in the array, the placement of the faces, and
-- the trained network.
data Recogniser k = Recogniser
  { -- | of the array on its surface, with its window
    recogniserLocator :: Locator k,
    -- | the placement that positions are looked up in
    recogniserPlacement :: Placement,
    -- | what the symbols are read with
    recogniserReader :: Reader
  }

-- | The rows and columns of the array's window.
recogniserWindow :: Recogniser k -> Shape
recogniserWindow = maskExtent . locatorMask . recogniserLocator

-- | How much larger than the paper's the symbols of the placement are.
recogniserScale :: Recogniser k -> Rational
recogniserScale = fromMaybe 1 . symbolScale . placementPitch . recogniserPlacement

-- | The position in the array of a cell of a grid, and the symbol there, if the grid's upper left
-- cell is at the position given. 'Nothing' beyond the sheet.
cellFrom :: KnownField k => Recogniser k -> Position -> Cell -> Maybe (Position, GF k)
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
  = -- | Nothing decodes what is seen of the array: it has more cells than a codebook, and no
    -- algebra.
    RecogniserArray LocatorError
  | -- | The network has this many outputs, the alphabet this many shapes, and the field this many
    -- elements, which must be as many.
    ClassesDiffer Int Int Int
  | -- | The objects are laid on an array of the first shape; the array has the second.
    ArraysDiffer Shape Shape
  | -- | The objects' symbols are the first distances apart; symbols are read at the second.
    PitchesDiffer Pitch Pitch
  deriving stock (Eq, Show)

-- | A recogniser for rectangular windows on an array and its surface. Up to 2^16 cells what is seen
-- is compared with all positions; beyond, it is decoded as "PraTactile.Locate" has it, so that a
-- press costs what was touched, not the array. Arrays whose logarithms cannot be taken or that lie
-- on a foreign surface are compared up to 'largestSearchedArray' cells. Refuses larger ones of
-- these, classes that are not one an element, and a placement on an array of another shape or with
-- symbols at other distances than the paper's times a factor, at which they are read.
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

-- | The same that compares with all positions of arrays up to so many cells only.
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
    -- No table decodes; the order of cells in tables does not matter.
    decoding = locatorUpTo most Nothing MostSignificantFirst on window
    given = outputCount (readerNetwork reader)
    shaped = alphabetSize (readerAlphabet reader)
