{-# LANGUAGE OverloadedStrings #-}

-- | What a badge says of a report, in the form of the endpoints that badge services read
-- (<https://shields.io/badges/endpoint-badge>).
module PraTactile.Conformance.Report.Badge
  ( encodeBadge,
  )
where

import Data.Aeson
import Data.ByteString (ByteString)
import qualified Data.ByteString.Lazy as Lazy
import Data.List (nub)
import PraTactile.Conformance.Report
import PraTactile.Conformance.Version

-- | The badge on one line, without its end: certified by which version of the suite; or that of
-- chosen laws all held; or how many laws did not, each counted once.
encodeBadge :: Report -> ByteString
encodeBadge report =
  Lazy.toStrict . encode $
    object
      [ "schemaVersion" .= (1 :: Int),
        "label" .= ("conformance" :: String),
        "message" .= message,
        "color" .= color
      ]
  where
    message, color :: String
    (message, color)
      | not (null wrong) = (counted (length wrong) ++ " wrong", "red")
      | not (sound report) = ("not certified", "red")
      | reportPartial report = ("chosen laws held, suite " ++ suiteVersion, "blue")
      | certified report = ("certified, suite " ++ suiteVersion, "brightgreen")
      | otherwise = ("not certified", "red")
    wrong =
      nub
        [lawReportId one | one <- reportLaws report, lawReportOutcome one `elem` [Failed, Errored]]
    counted n = show n ++ (if n == 1 then " law" else " laws")
