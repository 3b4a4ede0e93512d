{-# LANGUAGE OverloadedStrings #-}

-- | A badge of a report as JSON, in the format of badge endpoints
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

-- | The badge as one line, without its line end. It states the certifying version of the suite, or
-- that all chosen laws held, or how many laws did not hold (each counted once).
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
