-- | The shortest way through the library: from bytes to a recognition, with standard choices.
-- "PraTactile.Recognise" leaves every choice to the caller.
module PraTactile.Decode
  ( -- * Recognisers
    SomeRecogniser,
    someRecogniser,
    canonicalRecogniser,
    Reader,
    readerOf,

    -- * Decoding
    Decoding (..),
    standardDecoding,
    decodeSources,
    sourceComposite,
    decodeFolder,
    decodeImage,
    decodeFrames,
    decodeComposites,

    -- * How frames are put together
    Stitching (..),
    standardStitching,
    nominalStitching,

    -- * What can be wrong
    DecodeError (..),
  )
where

import Control.Applicative ((<|>))
import Data.Bifunctor (first)
import Data.ByteString (ByteString)
import PraTactile.Array (ArrayOn (..))
import PraTactile.Classification.Network (NetworkError)
import PraTactile.Classification.Reader (Reader (..), readerOf)
import PraTactile.Classification.Shipped (ShippedError, shippedReader)
import PraTactile.Image.Error (ImageError)
import PraTactile.Object.Canonical (canonicalPlacement)
import PraTactile.Object.Placement (Placement, PlacementError)
import PraTactile.Profile
import PraTactile.Recognise
import PraTactile.Registration (Composite (..), LatticeTables, StitchError)
import PraTactile.Registration.Stitching
import PraTactile.Sensor.Calibration (withoutStuck)
import PraTactile.Sensor.Frame (Frame, scaledFrame)
import PraTactile.Source

-- | A recogniser whose field is hidden: its reader, the size of its symbols relative to the
-- paper's, and a function that recognises composites of one face together.
data SomeRecogniser
  = SomeRecogniser Reader Double (Tolerance -> [Composite] -> Either NetworkError Recognition)

-- | Why nothing was recognised. A composite that is read but not understood is not an error: its
-- 'Recognition' has a 'Refusal'.
data DecodeError
  = -- | The profile does not make an array.
    ArrayRefused ProfileError
  | -- | The objects cannot be laid on the array.
    PlacementRefused PlacementError
  | -- | There are no shapes, or no network for them.
    ShapesRefused ShippedError
  | -- | The network refuses an image.
    NetworkRefused NetworkError
  | -- | The array, the shapes and the network do not fit each other.
    PartsRefused RecogniserError
  | -- | The folder holds no frames, or the image is not as described.
    FolderRefused SourceError
  | -- | The file holds no image.
    FileRefused ImageError
  | -- | The frames cannot be stitched.
    FramesRefused StitchError
  deriving stock (Eq, Show)

-- | A recogniser for a profile's array, with objects laid on it and a reader for its symbols.
-- Refuses what 'withProfile' and 'recogniser' refuse: an array that cannot be made, and parts that
-- do not fit each other.
someRecogniser :: Profile -> Placement -> Reader -> Either DecodeError SomeRecogniser
someRecogniser profile layout reader = do
  made <-
    first
      ArrayRefused
      ( withProfile
          profile
          ( \array window ->
              let on = ArrayOn (profileSurface profile) array
               in decoding <$> recogniser on window layout reader
          )
      )
  first PartsRefused made
  where
    decoding made =
      SomeRecogniser reader (fromRational (recogniserScale made)) (`recogniseWith` made)

-- | The recogniser for the paper's array with the shipped placement, shapes and network. It is
-- always 'Right'; the tests build it.
canonicalRecogniser :: Either DecodeError SomeRecogniser
canonicalRecogniser = do
  layout <- first PlacementRefused canonicalPlacement
  reader <- first ShapesRefused (shippedReader (fromIntegral (profileOrder canonicalProfile)))
  someRecogniser canonicalProfile layout reader

-- | How sources are decoded.
data Decoding = Decoding
  { decodingPreparation :: Preparation,
    decodingStitching :: Stitching,
    decodingTolerance :: Tolerance
  }

-- | Frames as their manifest states them, stitched by 'standardStitching' and answered by
-- 'standardTolerance'.
standardDecoding :: Decoding
standardDecoding = Decoding asStated standardStitching standardTolerance

-- | The composite of a source: the frames of a folder, prepared and stitched, or one prepared
-- image.
--
-- Arguments: the tables of the symbols that may have been touched ('readerTables'); the size of
-- these symbols, where 2 is twice the paper's; the preparation; the stitching; the source. The
-- composite's lengths are divided by the size. Refuses what 'preparedFrames', 'stitchedBy',
-- 'wholeImage' and 'preparedImage' refuse.
sourceComposite ::
  LatticeTables -> Double -> Preparation -> Stitching -> Source -> Either DecodeError Composite
sourceComposite tables size known stitching source = case source of
  FrameFolder folder ->
    first FolderRefused (preparedFrames known folder)
      >>= fmap (stated folder) . framesComposite tables size stitching
  WholeImage bytes ->
    first FileRefused (wholeImage known bytes)
      >>= first FolderRefused . \(image, pixel) ->
        preparedImage size known {preparedTaxel = preparedTaxel known <|> pixel} image
  where
    stated folder composite =
      composite
        { compositeAxesStated = axesStated known folder,
          compositeConventions = takingOf known folder
        }

-- | The composite of frames, with lengths divided by the symbols' size.
framesComposite :: LatticeTables -> Double -> Stitching -> [Frame] -> Either DecodeError Composite
framesComposite tables size stitching =
  first FramesRefused . stitchedBy tables stitching . map (scaledFrame (1 / size))

-- | Recognises what sources of one face show together. Refuses what 'sourceComposite' and
-- 'decodeComposites' refuse.
decodeSources :: Decoding -> SomeRecogniser -> [Source] -> Either DecodeError Recognition
decodeSources how with@(SomeRecogniser reader size _) sources =
  traverse
    (sourceComposite (readerTables reader) size (decodingPreparation how) (decodingStitching how))
    sources
    >>= decodeComposites (decodingTolerance how) with

-- | Recognises the frames of a folder, by 'standardDecoding'. Refuses what 'decodeSources' refuses.
decodeFolder :: SomeRecogniser -> Folder -> Either DecodeError Recognition
decodeFolder with folder = decodeSources standardDecoding with [FrameFolder folder]

-- | Recognises the file of an image that is a whole composite, by 'standardDecoding'. Refuses what
-- 'decodeSources' refuses.
decodeImage :: SomeRecogniser -> ByteString -> Either DecodeError Recognition
decodeImage with bytes = decodeSources standardDecoding with [WholeImage bytes]

-- | Recognises frames, by 'standardDecoding'. Sensor elements that are stuck are ignored
-- ('withoutStuck'). Refuses what 'stitchedBy' and 'decodeComposites' refuse.
decodeFrames :: SomeRecogniser -> [Frame] -> Either DecodeError Recognition
decodeFrames with@(SomeRecogniser reader size _) frames =
  framesComposite (readerTables reader) size standardStitching (withoutStuck frames)
    >>= decodeComposites standardTolerance with . pure

-- | Recognises composites of one face together, as 'recogniseWith' does. Their lengths must be
-- divided by the symbols' size, as 'sourceComposite' makes them. Refuses images that the network
-- refuses.
decodeComposites :: Tolerance -> SomeRecogniser -> [Composite] -> Either DecodeError Recognition
decodeComposites tolerance (SomeRecogniser _ _ recognised) =
  first NetworkRefused . recognised tolerance
