{-# LANGUAGE OverloadedStrings #-}

-- | Tests reports made by hand: how they are written in words, as JSON and as JUnit's XML, and
-- whether they certify.
module Test.Conformance.Report (spec) where

import Data.Aeson (Value, decodeStrict, object, toJSON, (.=))
import Data.Foldable (for_)
import Data.List (isInfixOf, isPrefixOf, isSuffixOf)
import PraTactile.Conformance.Law (Stage (..))
import PraTactile.Conformance.Question
import PraTactile.Conformance.Report
import PraTactile.Conformance.Report.Badge
import PraTactile.Conformance.Report.Json
import PraTactile.Conformance.Report.Junit
import PraTactile.Conformance.Report.Words
import PraTactile.Conformance.Subject
import PraTactile.Conformance.Version
import Test.Hspec

spec :: Spec
spec = do
  it "the last line counts each outcome, the cases and the seconds" $ do
    summaryLine whole
      `shouldBe` "not certified: 2 held, 2 failed, 1 skipped, 2 errored, 1 known to fail; \
                 \19 cases in 2.3 seconds"
    summaryLine whole {reportLaws = [held "a" 1]}
      `shouldBe` "not certified: 1 held; 1 case in 2.3 seconds"
    summaryLine right' `shouldBe` "certified: 2 held; 7 cases in 2.3 seconds"
    summaryLine right' {reportPartial = True}
      `shouldBe` "what was chosen held: 2 held; 7 cases in 2.3 seconds"
    summaryLine right' {reportLaws = []} `shouldBe` "not certified: 0 held; 0 cases in 2.3 seconds"
    summaryLine right' {reportOffers = []} `shouldBe` "not certified: nothing is offered"
  it "an operation is certified if offered, if a law of it held, and if nothing is wrong" $ do
    certified right' `shouldBe` True
    for_
      [ right' {reportOffers = []},
        right' {reportLaws = []},
        right' {reportLaws = take 1 (reportLaws right')},
        right' {reportUnexpected = ["field/*"]},
        right' {reportLaws = reportLaws right' ++ [(held "c" 1) {lawReportOutcome = Failed}]},
        right' {reportLaws = reportLaws right' ++ [(held "c" 1) {lawReportOutcome = Errored}]},
        right' {reportLaws = [one {lawReportOutcome = Skipped} | one <- reportLaws right']}
      ]
      $ \report -> certified report `shouldBe` False
    for_ [Skipped, KnownFailure] $ \outcome ->
      certified
        right' {reportLaws = reportLaws right' ++ [(held "c" 1) {lawReportOutcome = outcome}]}
        `shouldBe` True
    uncovered right' {reportOffers = [SomeOp Add, SomeOp Term, SomeOp Negate]}
      `shouldBe` [SomeOp Negate]
  it "the text has a heading, a line per stage, the failures, and the notes" $
    reportText ("try " ++) whole
      `shouldBe` unlines
        [ "subject: 2 operations of 3 offered, 2 profiles, seed 5",
          "",
          "  field       2 held, 2 failed, 1 skipped; 17 cases",
          "  sequence    2 errored, 1 known to fail; 2 cases",
          "",
          "field/c failed under p, and under q",
          "  must hold       sentence",
          "  source          source",
          "  asked           add {\"a\":1,\"b\":2}",
          "  then            {\"end\":true}",
          "  yours           0",
          "  the definition  3",
          "  why             reason",
          "  made smaller    1 time",
          "  again           try token",
          "",
          "sequence/e errored",
          "  must hold       sentence",
          "  source          source",
          "  yours           crashed: detail",
          "  expected        refused: why",
          "  by              a theorem",
          "  why             reason",
          "",
          "not offered: negate; their laws were skipped",
          "1 law skipped: note <&\"",
          "offered, but not known here: x y",
          "held, but must fail: field/*",
          "offered, but no law of it held: term",
          "",
          "not certified: 2 held, 2 failed, 1 skipped, 2 errored, 1 known to fail; \
          \19 cases in 2.3 seconds"
        ]
  it "the text says if a failure depends on earlier requests, unseen in a fresh process" $ do
    let one = failed "field/c" Nothing
        depends shown = shown {counterDepends = True}
        said =
          failureText id one {lawReportCounterexample = depends <$> lawReportCounterexample one}
    [line | line <- lines said, "  depends on" `isPrefixOf` line]
      `shouldSatisfy` all ("a fresh process that is asked this alone" `isInfixOf`)
  it "the text shows the first ten failures, the names of five more, and the number of the others" $
    for_ [0, 1, 9, 10, 11, 12, 15, 16] $ \count -> do
      let names = ["field/" ++ show i | i <- [1 .. count :: Int]]
          report = whole {reportLaws = [failed name Nothing | name <- names]}
          text = lines (reportText id report)
          hidden = drop 10 names
          told line = "field/" `isPrefixOf` line && " failed" `isSuffixOf` line
      length (filter told text) `shouldBe` min 10 count
      [line | line <- text, take 4 line == "and "]
        `shouldBe` [ "and " ++ show (length hidden)
                       ++ (if length hidden == 1 then " law" else " laws")
                       ++ " more, of which --json tells: "
                       ++ unwords (take 5 hidden)
                       ++ (if length hidden > 5 then " ..." else "")
                     | not (null hidden)
                   ]
  it "the JSON has every count and every law" $
    decodeStrict (encodeReport whole) `shouldBe` Just json
  it "as a badge: certified, what was chosen held, or the number of wrong laws, each once" $
    [ decodeStrict
        ( encodeBadge
            right' {reportLaws = some, reportPartial = partial, reportUnexpected = unexpected}
        )
      | (some, partial, unexpected) <-
          [ (reportLaws right', False, []),
            (take 1 (reportLaws right'), True, []),
            (take 1 (reportLaws right'), False, []),
            -- A law that must fail holds.
            (take 1 (reportLaws right'), True, ["field/c"]),
            (failed "field/c" (Just "p") : reportLaws right', True, []),
            (errored "field/d" : [failed "field/c" (Just p) | p <- ["p", "q"]], False, [])
          ]
    ]
      `shouldBe` [ Just . object $
                     [ "schemaVersion" .= (1 :: Int),
                       "label" .= ("conformance" :: String),
                       "message" .= (message :: String),
                       "color" .= (color :: String)
                     ]
                   | (message, color) <-
                       [ ("certified, suite " ++ suiteVersion, "brightgreen"),
                         ("chosen laws held, suite " ++ suiteVersion, "blue"),
                         ("not certified", "red"),
                         ("not certified", "red"),
                         ("1 law wrong", "red"),
                         ("2 laws wrong", "red")
                       ]
                 ]
  it "XML shows a character as itself, by its name, or as a question mark if XML has none" $ do
    let every =
          concat
            [['\0' .. '\x2FFF'], ['\xD7F0' .. '\xE010'], ['\xFFF0' .. '\x1000F'], [maxBound]]
        text = junitText (const every) whole {reportLaws = [failed "field/c" Nothing]}
        -- The characters of XML 1.0, section 2.2.
        allowed c =
          c `elem` ("\t\n\r" :: String)
            || or
              [ low <= c && c <= high
                | (low, high) <-
                    [('\x20', '\xD7FF'), ('\xE000', '\xFFFD'), ('\x10000', '\x10FFFF')]
              ]
        written c = case lookup c names of
          Just name -> "&" ++ name ++ ";"
          Nothing -> [if allowed c then c else '?']
        names = zip "<>&\"\t\n\r" ["lt", "gt", "amp", "quot", "#9", "#10", "#13"]
    -- The text has the end of a line only where an element ends.
    [line | line <- lines text, "<failure" `isPrefixOf` line]
      `shouldBe` ["<failure message=\"sentence\">" ++ concatMap written every ++ "</failure>"]
  it "JUnit's XML has one suite per profile with its counts, and one case per law" $
    junitText lawReportId whole
      `shouldBe` unlines
        [ "<?xml version=\"1.0\" encoding=\"UTF-8\"?>",
          "<testsuites name=\"conformance of subject\" tests=\"8\" failures=\"2\" errors=\"2\" \
          \skipped=\"2\">",
          "<testsuite name=\"p\" tests=\"3\" failures=\"1\" errors=\"0\" skipped=\"0\">",
          "<testcase classname=\"p\" name=\"field/a\"/>",
          "<testcase classname=\"p\" name=\"field/b\"/>",
          "<testcase classname=\"p\" name=\"field/c\">",
          "<failure message=\"sentence\">field/c</failure>",
          "</testcase>",
          "</testsuite>",
          "<testsuite name=\"q\" tests=\"2\" failures=\"1\" errors=\"0\" skipped=\"1\">",
          "<testcase classname=\"q\" name=\"field/c\">",
          "<failure message=\"sentence\">field/c</failure>",
          "</testcase>",
          "<testcase classname=\"q\" name=\"field/d\">",
          "<skipped message=\"note &lt;&amp;&quot;\"/>",
          "</testcase>",
          "</testsuite>",
          "<testsuite name=\"all profiles\" tests=\"3\" failures=\"0\" errors=\"2\" skipped=\"1\">",
          "<testcase classname=\"\" name=\"sequence/e\">",
          "<error message=\"sentence\">sequence/e</error>",
          "</testcase>",
          "<testcase classname=\"\" name=\"sequence/f\">",
          "<error message=\"sentence\">sequence/f</error>",
          "</testcase>",
          "<testcase classname=\"\" name=\"sequence/g\">",
          "<skipped message=\"known to fail\"/>",
          "</testcase>",
          "</testsuite>",
          "</testsuites>"
        ]

-- | A report with every outcome.
whole :: Report
whole =
  Report
    { reportSubject = "subject",
      reportAsks = [SomeOp Add, SomeOp Negate, SomeOp Term],
      reportOffers = [SomeOp Add, SomeOp Term],
      reportUnknown = ["x", "y"],
      reportSeed = 5,
      reportPartial = False,
      reportSeconds = 2.3456,
      reportUnexpected = ["field/*"],
      reportLaws =
        [ (held "a" 3) {lawReportNeeds = [SomeOp Add]},
          (held "b" 4) {lawReportNeeds = [SomeOp Add], lawReportExhaustive = True},
          failed "field/c" (Just "p"),
          (failed "field/c" (Just "q")) {lawReportCases = 2},
          (held "d" 0)
            { lawReportProfile = Just "q",
              lawReportOutcome = Skipped,
              lawReportNote = Just "note <&\""
            },
          (errored "sequence/e") {lawReportCases = 1},
          errored "sequence/f",
          (errored "sequence/g") {lawReportOutcome = KnownFailure, lawReportCases = 1}
        ]
    }

-- | A report without failures.
right' :: Report
right' =
  whole
    { reportUnexpected = [],
      reportLaws =
        [ (held "a" 3) {lawReportNeeds = [SomeOp Add]},
          (held "b" 4) {lawReportNeeds = [SomeOp Term]}
        ]
    }

held :: String -> Int -> LawReport
held name count =
  (untried ("field/" ++ name) OnField "sentence" "source")
    { lawReportProfile = Just "p",
      lawReportOutcome = Held,
      lawReportCases = count
    }

failed :: String -> Maybe String -> LawReport
failed name profile =
  (untried name OnField "sentence" "source")
    { lawReportProfile = profile,
      lawReportOutcome = Failed,
      lawReportCases = 8,
      lawReportCounterexample =
        Just
          ( counterexample
              [ object
                  ["operation" .= add, "input" .= object ["a" .= one', "b" .= (one' + one')]],
                object ["end" .= True]
              ]
              (Just (ResponseResult (toJSON (one' + one' + one'))))
              "the definition"
              (Right (ResponseResult (toJSON (one' - one'))))
              "reason"
          )
            { counterShrinks = 1,
              counterToken = Just "token"
            }
    }
  where
    add = "add" :: String
    one' = 1 :: Int

errored :: String -> LawReport
errored name =
  (untried name OnSequence "sentence" "source")
    { lawReportOutcome = Errored,
      lawReportCounterexample =
        Just
          ( counterexample
              []
              (Just (ResponseRefused "why"))
              "a theorem"
              (Left (Fault Crashed "detail"))
              "reason"
          )
    }

json :: Value
json =
  object
    [ "schema" .= text "pra-tactile/conform/1",
      "suite" .= suiteVersion,
      "subject" .= text "subject",
      "seed" .= five,
      "certified" .= False,
      "held" .= (five - 3),
      "failed" .= (five - 3),
      "skipped" .= (five - 4),
      "errored" .= (five - 3),
      "known_failures" .= (five - 4),
      "cases" .= (five + 14),
      "at_a_glance" .= False,
      "seconds" .= (2.346 :: Double),
      "offered" .= [text "add", "term"],
      "not_offered" .= [text "negate"],
      "not_held" .= [text "term"],
      "unknown" .= [text "x", "y"],
      "unexpected" .= [text "field/*"],
      "laws"
        .= [ law "field/a" "field" (Just "p") "held" 3 False Nothing,
             law "field/b" "field" (Just "p") "held" 4 True Nothing,
             law "field/c" "field" (Just "p") "failed" 8 False (Just wrong),
             law "field/c" "field" (Just "q") "failed" 2 False (Just wrong),
             law "field/d" "field" (Just "q") "skipped" 0 False Nothing,
             law "sequence/e" "sequence" Nothing "errored" 1 False (Just broken),
             law "sequence/f" "sequence" Nothing "errored" 0 False (Just broken),
             law "sequence/g" "sequence" Nothing "known-failure" 1 False (Just broken)
           ]
    ]
  where
    five = 5 :: Int
    text = id :: String -> String
    law :: String -> String -> Maybe String -> String -> Int -> Bool -> Maybe Value -> Value
    law name stage profile outcome count exhaustive counter =
      object
        [ "law" .= name,
          "stage" .= stage,
          "profile" .= profile,
          "outcome" .= outcome,
          "cases" .= count,
          "exhaustive" .= exhaustive,
          "counterexample" .= counter,
          "likely" .= (Nothing :: Maybe String),
          "note" .= (if outcome == "skipped" then Just (text "note <&\"") else Nothing)
        ]
    wrong =
      object
        [ "requests"
            .= [ object
                   [ "operation" .= text "add",
                     "input" .= object ["a" .= (five - 4), "b" .= (five - 3)]
                   ],
                 object ["end" .= True]
               ],
          "expected" .= object ["result" .= (five - 2)],
          "got" .= object ["result" .= (five - 5)],
          "road" .= text "the definition",
          "reason" .= text "reason",
          "shrinks" .= (five - 4),
          "earlier" .= (Nothing :: Maybe Int),
          "token" .= text "token"
        ]
    broken =
      object
        [ "requests" .= ([] :: [Value]),
          "expected" .= object ["refused" .= text "why"],
          "got" .= object ["fault" .= text "crashed", "detail" .= text "detail"],
          "road" .= text "a theorem",
          "reason" .= text "reason",
          "shrinks" .= (five - 5),
          "earlier" .= (Nothing :: Maybe Int),
          "token" .= (Nothing :: Maybe String)
        ]
