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

command :: Subcommand
command =
  subcommand
    "certificate"
    "Write a proof that all windows are distinct"
    "Prove that every window has a content of its own, and write the proof so that others can \
    \check it: by 'pra-tactile check', or by data/check_certificate.py, which needs only Python."
    [arrayGroup]
    [ "pra-tactile certificate --output paper.json",
      "pra-tactile certificate --mask '##./.##' --surface sheet --enumeration --output sheet.json"
    ]
    ( run <$> maskOption <*> surfaceOption <*> evidence
        <*> outputFileOption
        <*> jsonSwitch "With --output, report as JSON what was written"
        <*> arrayChoice
    )
  where
    evidence =
      flag'
        RankMethod
        ( long "rank"
            <> help
              "Prove it by the rank of the window's cells, for arrays of any size"
        )
        <|> flag'
          EnumerationMethod
          ( long "enumeration"
              <> help
                "Prove it by visiting all windows, and give the digest of the sorted windows"
          )
        <|> pure AnyMethod

run ::
  Maybe Mask ->
  Maybe Surface ->
  Method ->
  Maybe FilePath ->
  AnswerForm ->
  ArrayChoice ->
  IO ExitStatus
run drawn on evidence output form choice = do
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

-- | Report what was written to a file.
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
