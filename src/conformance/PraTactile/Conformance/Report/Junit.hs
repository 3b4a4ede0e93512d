-- | Reports as JUnit XML, which build servers read: one suite per profile, one case per law.
module PraTactile.Conformance.Report.Junit
  ( junitText,
  )
where

import Data.List (nub)
import Data.Maybe (fromMaybe)
import PraTactile.Conformance.Report

-- | The report as an XML document. The function describes a failed law.
junitText :: (LawReport -> String) -> Report -> String
junitText explained report =
  unlines ("<?xml version=\"1.0\" encoding=\"UTF-8\"?>" : element "testsuites" attributes suites)
  where
    attributes = ("name", "conformance of " ++ reportSubject report) : totals (reportLaws report)
    suites = concatMap suite names
    names = nub (map lawReportProfile (reportLaws report))
    suite name =
      let own = filter ((== name) . lawReportProfile) (reportLaws report)
       in element
            "testsuite"
            (("name", fromMaybe "all profiles" name) : totals own)
            (concatMap (testCase explained) own)

totals :: [LawReport] -> [(String, String)]
totals own =
  [ ("tests", show (length own)),
    ("failures", number Failed),
    ("errors", number Errored),
    ("skipped", show (length (filter (`elem` [Skipped, KnownFailure]) (map lawReportOutcome own))))
  ]
  where
    number outcome = show (length (filter ((== outcome) . lawReportOutcome) own))

testCase :: (LawReport -> String) -> LawReport -> [String]
testCase explained one = element "testcase" named $ case lawReportOutcome one of
  Held -> []
  Failed -> [told "failure"]
  Errored -> [told "error"]
  Skipped -> element "skipped" [("message", fromMaybe "" (lawReportNote one))] []
  KnownFailure -> element "skipped" [("message", "known to fail")] []
  where
    named = [("classname", fromMaybe "" (lawReportProfile one)), ("name", lawReportId one)]
    told name =
      opening name [("message", lawReportSentence one)] ++ ">" ++ escaped (explained one) ++ "</"
        ++ name
        ++ ">"

element :: String -> [(String, String)] -> [String] -> [String]
element name attributes content
  | null content = [opening name attributes ++ "/>"]
  | otherwise = [opening name attributes ++ ">"] ++ content ++ ["</" ++ name ++ ">"]

-- | The opening tag of an element, without its closing bracket.
opening :: String -> [(String, String)] -> String
opening name attributes =
  '<' : unwords (name : [key ++ "=\"" ++ escaped value ++ "\"" | (key, value) <- attributes])

-- | A text, escaped for content and attributes. Characters that XML cannot represent become
-- question marks.
escaped :: String -> String
escaped = concatMap one
  where
    one c = case c of
      '<' -> "&lt;"
      '>' -> "&gt;"
      '&' -> "&amp;"
      '"' -> "&quot;"
      '\n' -> "&#10;"
      '\r' -> "&#13;"
      '\t' -> "&#9;"
      _
        | c < ' ' || c == '\xFFFE' || c == '\xFFFF' || (c >= '\xD800' && c <= '\xDFFF') -> "?"
        | otherwise -> [c]
