-- | The data formats of the command line, as functions between values and bytes. Encoders write
-- what the command writes, and decoders read it; not every output has a decoder. Each text is one
-- line without its line end, except census files and what 'folderFiles' makes.
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

    -- | The conventions of an array.
    encodeProfile,
    decodeProfile,

    -- * Certificates

    -- | Proofs that windows are unique, and the check of such a file.
    encodeCertificate,
    decodeCertificate,
    CertificateFile (..),
    encodeProof,
    ProvedArray (..),
    encodeCheck,

    -- * Answers of @locate@

    -- | The place of a patch, or why there is none.
    encodeAnswer,
    decodeAnswer,
    AnswerReport (..),
    answerReport,
    AnswerContext (..),

    -- * Answers of @decode@ and the truth

    -- | The place of a press, the true place, and their comparison.
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

    -- | Simulated sensors, the calibration of real ones, and the manifest of a folder.
    encodeSensor,
    decodeSensor,
    encodeCalibration,
    decodeCalibration,
    encodeManifest,
    decodeManifest,
    folderFiles,

    -- * Rates and objects

    -- | How often patches are located; what lies at a position; the faces on an array.
    encodeRates,
    RatesReport (..),
    encodeObjects,
    encodeWhereabouts,
    encodePlacement,
    decodePlacement,
    PlacementFileError (..),

    -- * Fields, polynomials and sequences

    -- | Outputs of @field@, @polynomials@, @array@, @sequence@ and @synthesise@.
    encodeField,
    encodePolynomials,
    PolynomialKind (..),
    encodeArray,
    encodeTerms,
    encodeSynthesis,
    SynthesisReport (..),

    -- * Advice

    -- | Which arrays of at least a given size exist.
    encodeAdvice,

    -- * Census files

    -- | The arrays and windows of one size, with the proofs of each.
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
