{-# LANGUAGE OverloadedStrings #-}

-- | @pra-tactile check@: is a certificate good?
module Command.Check
  ( command,
  )
where

import Data.Aeson ((.=))
import Described
import Ending
import FormatFile
import Json
import Message (faultMessage)
import Options.Applicative hiding (command)
import PraTactile.Array (Shape)
import PraTactile.Certificate
import PraTactile.Certificate.Check
import PraTactile.Format (CertificateFile (..))
import PraTactile.Format.Profile (profileValue)
import PraTactile.Profile

command :: Mod CommandFields (IO Ending)
command =
  described
    "check"
    "Check a certificate step by step: the primes, the order of the polynomial's root, the fold, \
    \and the rank or the digest."
    ["pra-tactile check paper.json"]
    ( run
        <$> strArgument (metavar "FILE" <> action "file")
        <*> switch (long "json" <> help "Print the outcome as JSON")
    )

run :: FilePath -> Bool -> IO Ending
run path asJson = do
  CertificateFile certificate isSealed <- readCertificate path
  let outcome
        | not isSealed = Left "the seal is broken: the file was changed after it was written"
        | otherwise = either (Left . faultMessage) Right (checkCertificate certificate)
      profile = certificateProfile certificate
  if asJson
    then
      printJson
        ( "schema"
            .= ("pra-tactile/check/1" :: String)
            <> "good"
            .= either (const False) (const True) outcome
            <> "reason"
            .= either Just (const Nothing) outcome
            <> "windows"
            .= naturalValue (certificateWindows certificate)
            <> "surface"
            .= surfaceName (profileSurface profile)
            <> "profile"
            .= profileValue profile
        )
    else putStrLn (either ("bad: " ++) (const (good certificate (profileShape profile))) outcome)
  pure (either (const NotAnswered) (const Answered) outcome)
  where
    good :: Certificate -> Shape -> String
    good certificate shape =
      "good: all " ++ show (certificateWindows certificate) ++ " windows on the "
        ++ surfaceName (profileSurface (certificateProfile certificate))
        ++ " of "
        ++ shapeText shape
        ++ " are distinct"
