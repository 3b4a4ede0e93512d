-- | What symbols are recognised and located with.
module PraTactile.Recognise.Recogniser
  ( Recogniser (..),
    recogniser,
    RecogniserError (..),
  )
where

import PraTactile.Array (PseudorandomArray, Shape (..), Surface, arrayShape)
import PraTactile.Classification.Network (Network, outputCount)
import PraTactile.Classification.Templates (templates)
import PraTactile.Field (KnownField, fieldOrder)
import PraTactile.Locate (LocateError, Locator, locator)
import PraTactile.Locate.Decoder.Codebook (Codebook)
import PraTactile.Locate.Locator (locatorCodebook)
import PraTactile.Object.Canonical (canonicalPitch)
import PraTactile.Object.Placement (Pitch, Placement, placementPitch, placementShape)
import PraTactile.Recognise.Reading (Reader (..))
import PraTactile.Shape (Alphabet, alphabetSize)
import PraTactile.Window (Mask, Packing (..), maskExtent)

-- | All that recognition needs: the array with its positions, the placement of the faces, the
-- shapes and the trained network.
data Recogniser k = Recogniser
  { -- | the array on its surface, with its window
    recogniserCodebook :: Codebook k,
    -- | that array's locator, which decodes by this codebook
    recogniserLocator :: Locator k,
    recogniserWindow :: Shape,
    -- | the placement that positions are looked up in
    recogniserPlacement :: Placement,
    recogniserReader :: Reader
  }

-- | Why there is no recogniser.
data RecogniserError
  = -- | The array cannot be compared with.
    RecogniserArray LocateError
  | -- | The network has this many outputs, the alphabet this many shapes, and the field this many
    -- elements, which must be as many.
    ClassesDiffer Int Int Int
  | -- | The objects are laid on an array of the first shape; the array has the second.
    ArraysDiffer Shape Shape
  | -- | The objects' symbols are the first distances apart; symbols are read at the second.
    PitchesDiffer Pitch Pitch
  deriving stock (Eq, Show)

-- | A recogniser for rectangular windows on an array and its surface. Refuses arrays too large for
-- a 'Codebook', classes that are not one an element, and a placement on an array of another shape
-- or with symbols at another pitch than 'canonicalPitch', at which they are read.
recogniser ::
  KnownField k =>
  Surface ->
  PseudorandomArray k ->
  Mask ->
  Placement ->
  Alphabet ->
  Network ->
  Either RecogniserError (Recogniser k)
recogniser surface array window layout alphabetOfAll network
  | any (/= q) [given, shaped] = Left (ClassesDiffer given shaped q)
  | placementShape layout /= arrayShape array =
    Left (ArraysDiffer (placementShape layout) (arrayShape array))
  | placementPitch layout /= canonicalPitch =
    Left (PitchesDiffer (placementPitch layout) canonicalPitch)
  | otherwise = do
    codebook <- either (Left . RecogniserArray) Right (locatorCodebook made surface)
    pure
      Recogniser
        { recogniserCodebook = codebook,
          recogniserLocator = made,
          recogniserWindow = maskExtent window,
          recogniserPlacement = layout,
          recogniserReader = Reader (templates alphabetOfAll) network
        }
  where
    q = fieldOrder array
    -- The codebook decodes; the order of cells in tables does not matter.
    made = locator Nothing MostSignificantFirst array window
    given = outputCount network
    shaped = alphabetSize alphabetOfAll
