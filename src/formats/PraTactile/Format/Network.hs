{-# LANGUAGE OverloadedStrings #-}

-- | Networks as JSON that other languages read: every weight a number, with the shapes that the
-- network was trained on and its own contents each as a digest.
module PraTactile.Format.Network
  ( NetworkFile (..),
    encodeNetwork,
    decodeNetworkFile,
    alphabetDigest,
  )
where

import Control.Monad (unless)
import Data.Aeson (Object, Value (..))
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Aeson.Types (JSONPathElement (..))
import Data.ByteString (ByteString)
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import Data.Scientific (toRealFloat)
import qualified Data.Text as Text
import Data.Text.Encoding (encodeUtf8)
import PraTactile.Classification.Calibration (Calibration (..))
import PraTactile.Classification.Network
import PraTactile.Format.Digest
import PraTactile.Format.Error
import PraTactile.Format.Json.Canonical
import PraTactile.Format.Json.Codec
import PraTactile.Shape (Alphabet, drawBitmap, shapes)

-- | A network and where it comes from.
data NetworkFile = NetworkFile
  { fileNetwork :: Network,
    -- | 'alphabetDigest' of the shapes that it was trained on
    fileAlphabet :: String,
    -- | how sure its estimates are
    fileCalibration :: Calibration,
    -- | the seed of its training, and how that was made, where they are known
    fileSeed :: Maybe Int,
    fileRegimen :: Maybe String
  }
  deriving stock (Eq, Show)

-- | The SHA-256 of the drawings, class by class: each row of a shape as a line of 8 characters, @#@
-- where it is embossed and @.@ elsewhere. Names do not matter. It is that of what @grep '^[#.]'@
-- prints of a drawing file.
alphabetDigest :: Alphabet -> String
alphabetDigest = digestOf . encodeUtf8 . Text.concat . map drawBitmap . shapes

-- | A network on one line, without its end.
encodeNetwork :: NetworkFile -> ByteString
encodeNetwork file = writeLine (keys <* key "digest" text snd) (file, contentsDigest fields)
  where
    keys = withKeys fst networkKeys
    fields = writeObject networkKeys file

-- | The network in a JSON text. Refuses another schema, a dimension that is not that of the
-- weights, other inputs than 96, another activation than the sigmoid, and a digest that is not that
-- of the contents.
decodeNetworkFile :: ByteString -> Either FormatError NetworkFile
decodeNetworkFile = decodeObject $ \fields -> do
  given <- readKeys networkKeys fields
  stated <- field "digest" text fields
  file <- asNetwork given
  unless (stated == contentsDigest fields) (refuse OtherDigest)
  pure file

-- | The SHA-256 of all keys but @digest@ as one text: keys sorted, no white space, and each number
-- as the 16 hexadecimal digits of its IEEE 754 double, so that it does not matter how it was
-- written.
contentsDigest :: Object -> String
contentsDigest =
  digestOf
    . Lazy.toStrict
    . Builder.toLazyByteString
    . canonicalWith (Builder.doubleHexFixed . toRealFloat)
    . Object
    . KeyMap.delete "digest"

-- | What stands in a file, before it is known whether it is a network.
data Written = Written
  { writtenClasses :: Int,
    writtenInputs :: Int,
    writtenHidden :: Int,
    writtenOutputs :: Int,
    writtenUnits :: ([[Double]], [[Double]]),
    writtenCalibration :: Calibration,
    -- | of this network
    writtenOf :: Network -> NetworkFile
  }

networkKeys :: Keys NetworkFile Written
networkKeys =
  written
    <$> (schemaKey "pra-tactile/network/1" *> key "q" int (outputCount . fileNetwork))
    <*> key "alphabet" text fileAlphabet
    <*> key "inputs" int (const inputCount)
    <*> key "hidden" int (hiddenCount . fileNetwork)
    <*> key "outputs" int (outputCount . fileNetwork)
    <*> key "activation" sigmoidAlone (const "sigmoid")
    <*> key "hidden_units" (listOf (listOf real)) (unsigned . fst . unitRows . fileNetwork)
    <*> key "output_units" (listOf (listOf real)) (unsigned . snd . unitRows . fileNetwork)
    <*> key "calibration" calibration fileCalibration
    <*> key "seed" (nullable int) fileSeed
    <*> key "regimen" (nullable text) fileRegimen
  where
    written q shapesOf inputs hidden outs _ w1 w2 sure seed regimen =
      Written q inputs hidden outs (w1, w2) sure (\n -> NetworkFile n shapesOf sure seed regimen)
    sigmoidAlone = such (== "sigmoid") (NotAmong ["sigmoid"] "another activation") text
    -- A zero has no sign here: readers differ in whether they keep it.
    unsigned = map (map (+ 0))

-- | How outputs and likenesses become probabilities: by numbers of at most a million, so that no
-- sum of their multiples is too large for a double.
calibration :: Codec Calibration
calibration =
  object $
    Calibration
      <$> key "per_logit" number perLogit
      <*> key "per_likeness" number perLikeness
      <*> key "classes" (listOf number) classOffsets
      <*> key "none" (listOf number) ofOthers
  where
    number = such ((<= 1e6) . abs) BeyondMillion real

asNetwork :: Written -> Either FormatError NetworkFile
asNetwork given = do
  at "q" (writtenClasses given == writtenOutputs given) (OtherCount (writtenOutputs given))
  at "inputs" (writtenInputs given == inputCount) (OtherCount inputCount)
  at "calibration" (counts == (writtenOutputs given, 4)) (OtherCount (writtenOutputs given))
  units "hidden_units" (writtenHidden given) (inputCount + 1) w1
  units "output_units" (writtenOutputs given) (writtenHidden given + 1) w2
  n <- either (const (refuse NotReal)) Right (networkOfRows w1 w2)
  pure (writtenOf given n)
  where
    (w1, w2) = writtenUnits given
    counts = (length (classOffsets sure), length (ofOthers sure))
    sure = writtenCalibration given
    at name holds why = unless holds (Left (Misfit [Key name] why))
    units name r c rows' =
      at name (r > 0 && length rows' == r && all ((== c) . length) rows') (NotMatrix r c)
