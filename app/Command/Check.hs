-- | @pra-tactile check@: is a certificate good?
module Command.Check
  ( command,
  )
where

import ExitStatus
import FormatFile
import Message (faultMessage)
import Options
import PraTactile.Certificate
import PraTactile.Certificate.Check
import PraTactile.Format (CertificateFile (..), encodeCheck)
import PraTactile.Format.Name (shapeText, surfaceName)
import PraTactile.Profile

command :: Subcommand
command =
  subcommand
    "check"
    "Check a certificate step by step"
    "Check a certificate step by step: the primes, the order of the polynomial's root, the fold, \
    \and the rank or the digest."
    []
    ["pra-tactile check paper.json"]
    ( run
        <$> pathArgument
          ( metavar "FILE" <> action "file"
              <> help "A certificate, as 'pra-tactile certificate' writes it"
          )
        <*> jsonSwitch "Print the outcome as JSON"
    )

run :: FilePath -> AnswerForm -> IO ExitStatus
run path form = do
  CertificateFile certificate isSealed <- readCertificate path
  let wrong
        | not isSealed = Just "the seal is broken: the file was changed after it was written"
        | otherwise = either (Just . faultMessage) (const Nothing) (checkCertificate certificate)
  printAs
    form
    (maybe (good certificate) ("bad: " ++) wrong ++ "\n")
    (encodeCheck certificate wrong)
  pure (maybe Answered (const NotAnswered) wrong)

good :: Certificate -> String
good certificate =
  "good: all " ++ show (certificateWindows certificate) ++ " windows on the "
    ++ surfaceName (profileSurface profile)
    ++ " of "
    ++ shapeText (profileShape profile)
    ++ " are distinct"
  where
    profile = certificateProfile certificate
