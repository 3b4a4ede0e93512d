-- | The data formats of the command line, as functions from values to bytes and back. What these
-- functions write, the command reads, and the reverse. Each text is one line without its line end,
-- except census files.
--
-- >>> import PraTactile.Array (Shape (..))
-- >>> import PraTactile.Certificate (Method (..), certificateWindows, certify)
-- >>> import PraTactile.Profile (canonicalProfile)
-- >>> import PraTactile.Window (rectangle)
-- >>> let Right window = rectangle (Shape 2 2)
-- >>> let Right certificate = certify RankMethod canonicalProfile window
-- >>> certificateWindows . fileCertificate <$> decodeCertificate (encodeCertificate certificate)
-- Right 255
--
-- The modules below have the parts: "PraTactile.Format.Json.Codec" for other JSON in this style,
-- "PraTactile.Format.Census.Continue" and "PraTactile.Format.Census.Merge" for unfinished census
-- files.
module PraTactile.Format
  ( -- * Errors
    FormatError (..),
    JsonError (..),
    Misfit (..),
    CensusFileError (..),
    RowError (..),

    -- * Profiles
    encodeProfile,
    decodeProfile,

    -- * Certificates
    encodeCertificate,
    decodeCertificate,
    CertificateFile (..),
    encodeProof,
    Subject (..),
    encodeCheck,

    -- * Answers of @locate@
    encodeAnswer,
    decodeAnswer,
    AnswerReport (..),
    answerReport,
    AnswerContext (..),

    -- * Answers of @decode@ and the truth
    encodeRecognition,
    decodeRecognition,
    RecognitionReport (..),
    recognitionReport,
    RecognitionContext (..),
    decodeClaim,
    encodeTruth,
    encodePosedTruth,
    decodeTruth,
    decodeClaimedPose,
    ObjectPose (..),
    decodePlane,
    encodeComparison,

    -- * Sensors and their frames
    encodeSensor,
    decodeSensor,
    encodeCalibration,
    decodeCalibration,
    encodeManifest,
    decodeManifest,
    folderFiles,

    -- * Rates and objects
    encodeRates,
    RatesReport (..),
    encodeObjects,
    encodeWhereabouts,
    encodePlacement,
    decodePlacement,
    PlacementFileError (..),

    -- * Fields, polynomials and sequences
    encodeField,
    encodePolynomials,
    PolynomialKind (..),
    encodeArray,
    encodeTerms,
    encodeSynthesis,
    SynthesisReport (..),

    -- * Advice
    encodeAdvice,

    -- * Census files
    encodeCensus,
    decodeCensus,
    Row (..),
  )
where

import PraTactile.Format.Advice
import PraTactile.Format.Answer
import PraTactile.Format.Answer.Report
import PraTactile.Format.Calibration
import PraTactile.Format.Census
import PraTactile.Format.Census.Row (Row (..))
import PraTactile.Format.Certificate
import PraTactile.Format.Error
import PraTactile.Format.Manifest
import PraTactile.Format.Object
import PraTactile.Format.Placement
import PraTactile.Format.Pose (ObjectPose (..), decodePlane)
import PraTactile.Format.Profile
import PraTactile.Format.Proof
import PraTactile.Format.Rates
import PraTactile.Format.Recognition
import PraTactile.Format.Sensor
import PraTactile.Format.Sequence
import PraTactile.Format.Truth
