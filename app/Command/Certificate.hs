{-# LANGUAGE OverloadedStrings #-}

-- | @pra-tactile certificate@: the proof of the window property as data.
module Command.Certificate
  ( command,
  )
where

import ArrayChoice
import Control.Monad (unless)
import Data.Aeson ((.=))
import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (for_)
import Data.Maybe (isJust)
import ExitStatus
import Json
import MaskChoice
import Message
import Options
import Output
import PraTactile.Array (Surface)
import PraTactile.Certificate
import PraTactile.Format (encodeCertificate)
import PraTactile.Profile (Profile (..))
import PraTactile.Window (Mask)

command :: Mod CommandFields (IO ExitStatus)
command =
  subcommand
    "certificate"
    "Prove that the content of every window tells its position, and write the proof down so that \
    \a stranger can check it ('pra-tactile check', or data/check_certificate.py, which needs \
    \Python alone)."
    [ "pra-tactile certificate --output paper.json",
      "pra-tactile certificate --mask '##./.##' --surface sheet --enumeration --output sheet.json"
    ]
    ( run <$> arrayChoice <*> maskOption <*> surfaceOption <*> evidence
        <*> outputFileOption
        <*> jsonSwitch "With --output, tell as JSON what was written"
    )
  where
    evidence =
      flag' RankMethod (long "rank" <> help "Show the rank of the window's cells, at any size")
        <|> flag'
          EnumerationMethod
          (long "enumeration" <> help "Give the digest of all windows, sorted")
        <|> pure AnyMethod

run ::
  ArrayChoice ->
  Maybe Mask ->
  Maybe Surface ->
  Method ->
  Maybe FilePath ->
  AnswerForm ->
  IO ExitStatus
run choice drawn on evidence output form = do
  unless (isJust output) $
    leaveOut "the certificate itself is JSON" [("--json", form == AsJson)]
  (profile, mask) <- chosenMask choice drawn on
  case certify evidence profile mask of
    Left why
      | refused why -> warn (certificateMessage why) >> pure NotAnswered
      | otherwise -> unusable (certificateMessage why)
    Right certificate -> do
      let text = encodeCertificate certificate <> "\n"
      maybe (Bytes.putStr text) (`writeWhole` Lazy.fromStrict text) output
      for_ output (report form certificate)
      pure Answered

-- | What was written to a file.
report :: AnswerForm -> Certificate -> FilePath -> IO ()
report form certificate file = sayWrittenAs form file inWords "certificate-written/1" keys
  where
    windows = certificateWindows certificate
    profile = certificateProfile certificate
    evidence = evidenceName certificate
    inWords = ": all " ++ show windows ++ " windows, by " ++ evidence
    keys =
      "road" .= evidence
        <> "windows" .= naturalValue windows
        <> "surface" .= surfaceName (profileSurface profile)
        <> "shape" .= shapeText (profileShape profile)

-- | Whether the question was well formed, but the answer is no.
refused :: CertificateError -> Bool
refused e = case e of
  NotDistinct _ -> True
  RankUndecided _ -> True
  NotVisited _ -> True
  PeriodNotFactored _ -> True
  PrimeNotShown _ -> True
  _ -> False

evidenceName :: Certificate -> String
evidenceName certificate = case certificateEvidence certificate of
  ByRank _ -> "rank"
  ByEnumeration _ -> "enumeration"
