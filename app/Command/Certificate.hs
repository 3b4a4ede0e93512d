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
import Described
import Ending
import Json
import MaskChoice
import Message
import Options.Applicative hiding (command)
import Output
import PraTactile.Array (Surface)
import PraTactile.Certificate
import PraTactile.Format (encodeCertificate)
import PraTactile.Profile (Profile (..))
import PraTactile.Window (Mask)
import Visible

command :: Mod CommandFields (IO Ending)
command =
  described
    "certificate"
    "Prove that the content of every window tells its position, and write the proof down so that \
    \a stranger can check it ('pra-tactile check', or data/check_certificate.py, which needs \
    \Python alone)."
    [ "pra-tactile certificate --output paper.json",
      "pra-tactile certificate --mask '##./.##' --surface sheet --enumeration --output sheet.json"
    ]
    ( run <$> arrayChoice <*> maskOption <*> surfaceOption <*> road
        <*> optional
          ( strOption
              ( long "output"
                  <> metavar "FILE"
                  <> action "file"
                  <> help "Write to a file instead of the standard output"
              )
          )
        <*> switch (long "json" <> help "With --output, tell as JSON what was written")
    )
  where
    road =
      flag' RankMethod (long "rank" <> help "Show the rank of the window's cells, at any size")
        <|> flag'
          EnumerationMethod
          (long "enumeration" <> help "Give the digest of all windows, sorted")
        <|> pure AnyMethod

run :: ArrayChoice -> Maybe Mask -> Maybe Surface -> Method -> Maybe FilePath -> Bool -> IO Ending
run choice drawn on road output asJson = do
  (profile, mask) <- chosenMask choice drawn on
  case certify road profile mask of
    Left why
      | refused why -> warn (certificateMessage why) >> pure NotAnswered
      | otherwise -> unusable (certificateMessage why)
    Right certificate -> do
      let text = encodeCertificate certificate <> "\n"
      maybe (Bytes.putStr text) (`writeWhole` Lazy.fromStrict text) output
      maybe (pure ()) (report certificate) output
      pure Answered
  where
    report certificate file
      | asJson = unless (file == "-") (printJson (writtenJson certificate file))
      | otherwise =
        sayWritten
          file
          ( ": all "
              ++ show (certificateWindows certificate)
              ++ " windows, by "
              ++ roadName certificate
          )
    writtenJson certificate file =
      "schema" .= ("pra-tactile/certificate-written/1" :: String)
        <> "file" .= nameInJson file
        <> "road" .= roadName certificate
        <> "windows" .= naturalValue (certificateWindows certificate)
        <> "surface" .= surfaceName (profileSurface (certificateProfile certificate))
        <> "shape" .= shapeText (profileShape (certificateProfile certificate))

-- | Whether the question was well formed, but the answer is no.
refused :: CertificateError -> Bool
refused e = case e of
  NotDistinct _ -> True
  RankUndecided _ -> True
  NotVisited _ -> True
  PeriodNotFactored _ -> True
  PrimeNotShown _ -> True
  _ -> False

roadName :: Certificate -> String
roadName certificate = case certificateEvidence certificate of
  ByRank _ -> "rank"
  ByEnumeration _ -> "enumeration"
