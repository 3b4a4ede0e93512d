{-# LANGUAGE OverloadedStrings #-}

-- | Reports as JSON, of the schema @pra-tactile/conform/1@.
module PraTactile.Conformance.Report.Json
  ( encodeReport,
  )
where

import Data.Aeson
import Data.ByteString (ByteString)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Operations (nameOf)
import PraTactile.Conformance.Report
import PraTactile.Conformance.Subject
import PraTactile.Conformance.Version
import PraTactile.Format.Json (encodeSchema)

-- | The report as one line, without its line end.
encodeReport :: Report -> ByteString
encodeReport report =
  encodeSchema "conform/1" $
    "suite" .= suiteVersion
      <> "subject" .= reportSubject report
      <> "seed" .= reportSeed report
      <> "certified" .= certified report
      <> "held" .= countOf Held report
      <> "failed" .= countOf Failed report
      <> "skipped" .= countOf Skipped report
      <> "errored" .= countOf Errored report
      <> "known_failures" .= countOf KnownFailure report
      <> "cases" .= casesOf report
      <> "at_a_glance" .= False
      <> "seconds" .= rounded (reportSeconds report)
      <> "offered" .= map nameOf (reportOffers report)
      <> "not_offered"
        .= map nameOf (filter (`notElem` reportOffers report) (reportAsks report))
      <> "not_held" .= map nameOf (uncovered report)
      <> "unknown" .= reportUnknown report
      <> "unexpected" .= reportUnexpected report
      <> "laws" .= map lawValue (reportLaws report)

-- | Rounded to a millisecond.
rounded :: Double -> Double
rounded seconds = fromInteger (round (seconds * 1000)) / 1000

lawValue :: LawReport -> Value
lawValue one =
  object
    [ "law" .= lawReportId one,
      "stage" .= stageName (lawReportStage one),
      "profile" .= lawReportProfile one,
      "outcome" .= outcomeName (lawReportOutcome one),
      "cases" .= lawReportCases one,
      "exhaustive" .= lawReportExhaustive one,
      "counterexample" .= fmap counterexampleValue (lawReportCounterexample one),
      "likely" .= Null,
      "note" .= lawReportNote one
    ]

counterexampleValue :: Counterexample -> Value
counterexampleValue counter =
  object
    [ "requests" .= counterRequests counter,
      "expected" .= fmap responseValue (counterExpected counter),
      "got" .= either faultValue responseValue (counterGot counter),
      "road" .= counterRoad counter,
      "reason" .= counterReason counter,
      "shrinks" .= counterShrinks counter,
      "earlier" .= (if counterDepends counter then Just (0 :: Int) else Nothing),
      "token" .= counterToken counter
    ]

-- | A reply as in the protocol.
responseValue :: Response -> Value
responseValue response = let (name, value) = responseItem response in object [name .= value]

faultValue :: Fault -> Value
faultValue fault =
  object ["fault" .= faultName (faultKind fault), "detail" .= faultDetail fault]
