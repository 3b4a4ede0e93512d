{-# LANGUAGE OverloadedStrings #-}

-- | Networks as JSON for other languages: every weight is a number. Digests identify the shapes of
-- the training and the contents.
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

-- | A network and its origin.
data NetworkFile = NetworkFile
  { fileNetwork :: Network,
    -- | 'alphabetDigest' of the shapes of its training
    fileAlphabet :: String,
    -- | turns its outputs into probabilities
    fileCalibration :: Calibration,
    -- | the seed and the regimen of its training, if known
    fileSeed :: Maybe Int,
    fileRegimen :: Maybe String
  }
  deriving stock (Eq, Show)

-- | The SHA-256 of the drawings, class by class, without names. Each row of a shape is a line of 8
-- characters, @#@ where embossed and @.@ elsewhere. @grep '^[#.]'@ on a drawing file prints the
-- text that is digested.
alphabetDigest :: Alphabet -> String
alphabetDigest = digestOf . encodeUtf8 . Text.concat . map drawBitmap . shapes

-- | A network as one line, without its line end.
encodeNetwork :: NetworkFile -> ByteString
encodeNetwork file = writeLine (keys <* key "digest" text snd) (file, contentsDigest fields)
  where
    keys = withKeys fst networkKeys
    fields = writeObject networkKeys file

-- | Reads a network from JSON. Refuses another schema, dimensions that do not fit the weights,
-- other than 96 inputs, another activation than the sigmoid, and a wrong digest.
decodeNetworkFile :: ByteString -> Either FormatError NetworkFile
decodeNetworkFile = decodeObject $ \fields -> do
  given <- readKeys networkKeys fields
  stated <- field "digest" text fields
  file <- asNetwork given
  unless (stated == contentsDigest fields) (refuse OtherDigest)
  pure file

-- | The SHA-256 of all keys but @digest@: keys sorted, no white space, each number as the 16
-- hexadecimal digits of its IEEE 754 double. So the notation of numbers does not matter.
contentsDigest :: Object -> String
contentsDigest =
  digestOf
    . Lazy.toStrict
    . Builder.toLazyByteString
    . canonicalWith (Builder.doubleHexFixed . toRealFloat)
    . Object
    . KeyMap.delete "digest"

-- | The contents of a file, before they are checked to be a network.
data Written = Written
  { writtenClasses :: Int,
    writtenInputs :: Int,
    writtenHidden :: Int,
    writtenOutputs :: Int,
    writtenUnits :: ([[Double]], [[Double]]),
    writtenCalibration :: Calibration,
    -- | the file for this network
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
    sigmoidAlone = satisfying (== "sigmoid") (NotAmong ["sigmoid"] "another activation") text
    -- Zeros lose their sign, because readers differ in keeping it.
    unsigned = map (map (+ 0))

-- | The calibration. Its numbers are at most a million, so that no sum of their multiples
-- overflows a double.
calibration :: Codec Calibration
calibration =
  object $
    Calibration
      <$> key "per_logit" number perLogit
      <*> key "per_likeness" number perLikeness
      <*> key "classes" (listOf number) classOffsets
      <*> key "none" (listOf number) ofOthers
  where
    number = satisfying ((<= 1e6) . abs) BeyondMillion real

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
