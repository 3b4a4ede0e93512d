-- | Files in the formats of "PraTactile.Format". Each reader leaves with status 2 and the reason
-- where a file is not what it should be.
module FormatFile
  ( readProfile,
    readCertificate,
    readPlacement,
    writePlacement,
    readAnswerAndTruth,
    readPlane,
    readSensorFile,
    readCalibration,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString.Lazy as Lazy
import Data.Either (isRight)
import ExitStatus
import Files (readBytes, readBytesUpTo)
import Message (formatMessage, placementFileMessage, profileMessage)
import Output (writeWhole)
import PraTactile.Format
import PraTactile.Object.Placement (Placement)
import PraTactile.Pose (RigidMotion)
import PraTactile.Profile
import PraTactile.Sensor (Sensor)
import PraTactile.Sensor.Calibration (Calibration)
import PraTactile.Truth (Claim, Truth)

-- | The profile in a file, which must name an array.
readProfile :: FilePath -> IO Profile
readProfile file = do
  profile <-
    readAs
      (readBytesUpTo mebibyte)
      decodeProfile
      "a profile as 'pra-tactile profile' prints it"
      file
  orUnusable (\e -> file ++ ": " ++ profileMessage e) (withProfile profile (\_ _ -> ()))
  pure profile

-- | The certificate in a file, with its seal whole or broken. A window has at most 4096 cells; JSON
-- in memory takes up to seventy times its size on disk.
readCertificate :: FilePath -> IO CertificateFile
readCertificate = readAs (readBytesUpTo (4 * mebibyte)) decodeCertificate wanted
  where
    wanted = "a certificate as 'pra-tactile certificate' writes it"

-- | The placement in a file and the profile of its array, which must be one.
readPlacement :: FilePath -> IO (Profile, Placement)
readPlacement file = do
  bytes <- readBytesUpTo (256 * mebibyte) file
  (profile, layout) <- orUnusable (placementFileMessage file) (decodePlacement bytes)
  orUnusable (\e -> file ++ ": " ++ profileMessage e) (withProfile profile (\_ _ -> ()))
  pure (profile, layout)

-- | Write a placement on the array of a profile to a file, or to what else the name stands for.
writePlacement :: FilePath -> Profile -> Placement -> IO ()
writePlacement file profile layout =
  writeWhole file (Lazy.fromStrict (encodePlacement profile layout) <> Lazy.singleton 10)

-- | Where the robot's frame lies in the world.
readPlane :: FilePath -> IO RigidMotion
readPlane = readAs (readBytesUpTo mebibyte) decodePlane "a plane: a rotation and a translation"

-- | The sensor in a file.
readSensorFile :: FilePath -> IO Sensor
readSensorFile =
  readAs (readBytesUpTo mebibyte) decodeSensor "a sensor as 'pra-tactile sensor --json' prints it"

-- | The calibration in a file.
readCalibration :: FilePath -> IO Calibration
readCalibration =
  readAs
    (readBytesUpTo (8 * mebibyte))
    decodeCalibration
    "a calibration as 'pra-tactile calibrate' writes it"

-- | The claim and the pose in a file with an answer of @decode --json@, each 'Nothing' where it
-- names no place on a face; and the truth in another file. The files may be exchanged: a truth says
-- itself that it is one.
readAnswerAndTruth :: FilePath -> FilePath -> IO ((Maybe Claim, Maybe ObjectPose), Truth)
readAnswerAndTruth one other = do
  given <- (,) one <$> readBytes one
  beside <- (,) other <$> readBytes other
  let (answer, truth)
        | isTruth given && not (isTruth beside) = (beside, given)
        | otherwise = (given, beside)
  (,)
    <$> decoded claims "one answer as 'pra-tactile decode --json' prints it" answer
    <*> decoded decodeTruth "the truth as 'pra-tactile probe --truth' writes it" truth
  where
    isTruth = isRight . decodeTruth . snd
    claims bytes = (,) <$> decodeClaim bytes <*> decodeClaimedPose bytes
    decoded decoder wanted (file, bytes) = orUnusable (formatMessage file wanted) (decoder bytes)

-- | The value in a file, given the reader of its bytes, their decoder, and the description of the
-- wanted file for messages.
readAs ::
  (FilePath -> IO ByteString) ->
  (ByteString -> Either FormatError a) ->
  String ->
  FilePath ->
  IO a
readAs bytesOf decoder wanted file =
  bytesOf file >>= orUnusable (formatMessage file wanted) . decoder

mebibyte :: Int
mebibyte = 1024 * 1024
