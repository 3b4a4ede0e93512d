-- | Files in the formats of "PraTactile.Format". Each reader leaves with status 2 and the reason where
-- a file is not what it should be.
module FormatFile
  ( readProfile
  , readCertificate
  , readTruth
  , readClaim
  ) where

import Data.ByteString (ByteString)

import Ending
import Files (readBytes)
import Message (formatMessage, profileMessage)
import PraTactile.Format
import PraTactile.Profile
import PraTactile.Truth (Claim, Truth)

-- | The profile in a file, which must name an array.
readProfile :: FilePath -> IO Profile
readProfile file = do
  profile <- readAs decodeProfile "a profile as 'pra-tactile profile' prints it" file
  orUnusable (\e -> file ++ ": " ++ profileMessage e) (withProfile profile (\_ _ -> ()))
  pure profile

-- | The certificate in a file, with its seal whole or broken.
readCertificate :: FilePath -> IO CertificateFile
readCertificate = readAs decodeCertificate "a certificate as 'pra-tactile certificate' writes it"

-- | The truth in a file.
readTruth :: FilePath -> IO Truth
readTruth = readAs decodeTruth "the truth as 'pra-tactile probe --truth' writes it"

-- | The claim in a file with an answer of @decode --json@; 'Nothing' where it names no place on a face.
readClaim :: FilePath -> IO (Maybe Claim)
readClaim = readAs decodeClaim "one answer as 'pra-tactile decode --json' prints it"

-- | A file, by its bytes and what it should be.
readAs :: (ByteString -> Either FormatError a) -> String -> FilePath -> IO a
readAs decoder wanted file = readBytes file >>= orUnusable (formatMessage file wanted) . decoder
