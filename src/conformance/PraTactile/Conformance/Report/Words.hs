-- | Reports in words: one line per stage, each failure with its requests and answers, and a
-- summary.
module PraTactile.Conformance.Report.Words
  ( reportText,
    failureText,
    summaryLine,
    valueText,
    responseText,
  )
where

import Data.Aeson (Value, encode, toJSON)
import qualified Data.Aeson as Json
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (toList)
import Data.List (intercalate, nub, sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (listToMaybe)
import Data.Ord (Down (..))
import Data.Scientific (isInteger)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import qualified Data.Text.Encoding.Error as Text
import PraTactile.Conformance.Law
import PraTactile.Conformance.Operations (nameOf)
import PraTactile.Conformance.Question
import PraTactile.Conformance.Report
import PraTactile.Conformance.Subject

-- | The whole report as text. The function gives the command that replays a token.
reportText :: (String -> String) -> Report -> String
reportText again report =
  unlines . intercalate [""] . filter (not . null) $
    [heading report, map (stageLine report) (stagesOf report)]
      ++ map (failureLines again) shown
      ++ [more, notes report, [summaryLine report]]
  where
    (shown, hidden) = splitAt mostShown (failures report)
    more = case hidden of
      [] -> []
      _ ->
        [ "and " ++ counted (length hidden) "law" ++ " more, of which --json tells: "
            ++ unwords (take 5 (map (lawReportId . fst) hidden))
            ++ (if length hidden > 5 then " ..." else "")
        ]

-- | The greatest number of failures that are described.
mostShown :: Int
mostShown = 10

-- | The description of one failed law as text. The function gives the command that replays a
-- token.
failureText :: (String -> String) -> LawReport -> String
failureText again one = unlines (failureLines again (one, []))

heading :: Report -> [String]
heading report =
  [ reportSubject report ++ ": " ++ counted (length (reportOffers report)) "operation" ++ " of "
      ++ show (length (reportAsks report))
      ++ " offered, "
      ++ counted (length profiles) "profile"
      ++ ", seed "
      ++ show (reportSeed report)
  ]
  where
    profiles = nub [name | one <- reportLaws report, Just name <- [lawReportProfile one]]

stagesOf :: Report -> [Stage]
stagesOf report =
  [ stage
    | stage <- [minBound ..],
      stage `elem` map lawReportStage (reportLaws report)
  ]

-- | A stage and the outcomes of its laws.
stageLine :: Report -> Stage -> String
stageLine report stage =
  "  " ++ padded 12 (stageName stage) ++ intercalate ", " (concatMap count [minBound ..])
    ++ ("; " ++ counted (sum (map lawReportCases own)) "case")
  where
    own = filter ((== stage) . lawReportStage) (reportLaws report)
    count outcome = case length (filter ((== outcome) . lawReportOutcome) own) of
      0 -> []
      n -> [show n ++ " " ++ outcomeText outcome]

outcomeText :: LawOutcome -> String
outcomeText outcome = if outcome == KnownFailure then "known to fail" else outcomeName outcome

-- | The failed and erred laws, each with its profiles, in the order of trying. Reports of one law
-- with one outcome are grouped, and so are those with the same fault.
failures :: Report -> [(LawReport, [String])]
failures report =
  [ (one, concatMap (maybe [] pure . lawReportProfile) others)
    | key <- nub (map alike failing),
      (one : others) <- [filter ((== key) . alike) failing]
  ]
  where
    failing = filter ((`elem` [Failed, Errored]) . lawReportOutcome) (reportLaws report)
    alike one = case lawReportCounterexample one of
      Just counter | null (counterRequests counter) -> ("", lawReportOutcome one)
      _ -> (lawReportId one, lawReportOutcome one)

failureLines :: (String -> String) -> (LawReport, [String]) -> [String]
failureLines again (one, others) =
  (lawReportId one ++ " " ++ outcomeName (lawReportOutcome one) ++ under) :
  map item ([("must hold", lawReportSentence one), ("source", lawReportSource one)] ++ counter)
  where
    under = maybe "" (" under " ++) (lawReportProfile one) ++ also
    also = case nub others of
      [] -> ""
      names -> ", and under " ++ commas names
    item (name, text) = "  " ++ padded 16 name ++ text
    counter = maybe [] (counterItems again) (lawReportCounterexample one)

counterItems :: (String -> String) -> Counterexample -> [(String, String)]
counterItems again counter =
  concat
    [ zip ("asked" : repeat "then") (map requestText (counterRequests counter)),
      [("yours", yours)],
      [(side, theirs) | Just _ <- [counterExpected counter]],
      [("by", counterRoad counter) | side == "expected", counterRoad counter /= ""],
      [("why", counterReason counter)],
      [("depends on", onEarlier) | counterDepends counter],
      [("made smaller", counted (counterShrinks counter) "time") | counterShrinks counter > 0],
      [("again", again token) | Just token <- [counterToken counter]]
    ]
  where
    (yours, theirs) = case (counterGot counter, counterExpected counter) of
      (Right got, Just wanted)
        | Just texts <- apartMost counter got wanted -> texts
        | otherwise -> apartText got wanted
      (got, wanted) -> (either faultText responseText got, maybe "" responseText wanted)
    side = if counterRoad counter == "the definition" then "the definition" else "expected"

-- | The note on a failure that a fresh process does not show.
onEarlier :: String
onEarlier = "earlier requests: a fresh process that is asked this alone answers it rightly"

-- | A request without the keys that every request has.
requestText :: Value -> String
requestText request = case request of
  Json.Object keys
    | Just (Json.String name) <- KeyMap.lookup (key "operation") keys,
      Just input <- KeyMap.lookup (key "input") keys ->
      Text.unpack name ++ " " ++ valueText input
    | Just profile <- KeyMap.lookup (key "profile") keys -> "profile " ++ longer profile
  _ -> valueText request
  where
    key = Key.fromString
    longer = cut 600 . whole

-- | A response in words.
responseText :: Response -> String
responseText response = case response of
  ResponseResult value -> valueText value
  ResponseRefused why -> "refused: " ++ why
  ResponseSkipped why -> "skipped: " ++ why
  ResponseErrored why -> "errored: " ++ why

-- | Two responses in words. Long lists begin at the first item in which they differ, with its
-- index.
apartText :: Response -> Response -> (String, String)
apartText got wanted = case (got, wanted) of
  (ResponseResult one, ResponseResult other)
    | Just (these, those) <- (,) <$> itemsOf one <*> itemsOf other,
      any ((> 200) . length . whole) [one, other] ->
      let same = length (takeWhile id (zipWith (==) these those))
          from items =
            "from item " ++ show same ++ " on: " ++ valueText (toJSON (drop same items))
       in (from these, from those)
  _ -> (responseText got, responseText wanted)
  where
    itemsOf value = case value of
      Json.Array items -> Just (toList items)
      Json.Object fields
        | Just (Json.Array items) <- KeyMap.lookup (Key.fromString "positions") fields ->
          Just (toList items)
      _ -> Nothing

-- | Two responses that are lists of real numbers, in words: the entry in which they differ most.
-- For @posterior@ an entry is that of a position.
apartMost :: Counterexample -> Response -> Response -> Maybe (String, String)
apartMost counter got wanted = case (got, wanted) of
  (ResponseResult one, ResponseResult other) -> do
    these <- entriesOf one
    those <- entriesOf other
    let far key = abs (Map.findWithDefault 0 key these - Map.findWithDefault 0 key those)
        keys = [key | key <- Map.keys (these <> those), far key > 0]
    (key, _) <- listToMaybe (sortOn (Down . snd) [(key, far key) | key <- keys])
    let entry value entries =
          valueText value ++ "; " ++ keyText key ++ ": "
            ++ maybe "nothing" (valueText . Json.Number) (Map.lookup key entries)
    Just (entry one these, entry other those)
  _ -> Nothing
  where
    ofPositions =
      nameOf (SomeOp Posterior)
        `elem` map (takeWhile (/= ' ') . requestText) (counterRequests counter)
    entriesOf value = case value of
      Json.Array items
        | ofPositions -> Map.fromList <$> traverse positioned (toList items)
        | otherwise -> do
          numbers <- traverse number (toList items)
          if all isInteger numbers
            then Nothing
            else Just (Map.fromList (zip (map pure (iterate (+ 1) 0)) numbers))
      _ -> Nothing
    positioned item = case item of
      Json.Array values -> case traverse number (toList values) of
        Just [row, column, chance] -> Just ([row, column], chance)
        _ -> Nothing
      _ -> Nothing
    number value = case value of
      Json.Number n -> Just n
      _ -> Nothing
    keyText key = case map (valueText . Json.Number) key of
      [row, column] -> "at row " ++ row ++ ", column " ++ column
      others -> "item " ++ unwords others

faultText :: Fault -> String
faultText fault = faultName (faultKind fault) ++ ": " ++ faultDetail fault

-- | A value as JSON; the middle of a long one is cut out.
valueText :: Value -> String
valueText = cut 200 . whole

whole :: Value -> String
whole = Text.unpack . Text.decodeUtf8With Text.lenientDecode . Lazy.toStrict . encode

cut :: Int -> String -> String
cut most text
  | null (drop most text) = text
  | otherwise =
    take (most - 40) text ++ " ... " ++ drop (length text - 30) text ++ " (" ++ show (length text)
      ++ " characters)"

-- | Further notes on the run.
notes :: Report -> [String]
notes report =
  concat
    [ [ "not offered: " ++ unwords (map nameOf missing) ++ "; their laws were skipped"
        | missing@(_ : _) <- [filter (`notElem` reportOffers report) (reportAsks report)]
      ],
      [ counted (length (filter (== why) others)) "law" ++ " skipped: " ++ why
        | why <- nub others
      ],
      [ "offered, but not known here: " ++ unwords unknown
        | unknown@(_ : _) <- [reportUnknown report]
      ],
      ["held, but must fail: " ++ pattern' | pattern' <- reportUnexpected report],
      [ "offered, but no law of it held: " ++ unwords (map nameOf none)
        | not (reportPartial report),
          none@(_ : _) <- [uncovered report]
      ]
    ]
  where
    others =
      [ why
        | one <- reportLaws report,
          lawReportOutcome one == Skipped,
          all (`elem` reportOffers report) (lawReportNeeds one),
          Just why <- [lawReportNote one]
      ]

-- | The summary in one line.
summaryLine :: Report -> String
summaryLine report
  | reportPartial report && sound report = "what was chosen held: " ++ tally
  | certified report = "certified: " ++ tally
  | null (reportOffers report) = "not certified: nothing is offered"
  | otherwise = "not certified: " ++ tally
  where
    tally =
      intercalate ", " (concatMap count [minBound ..])
        ++ ("; " ++ counted (casesOf report) "case" ++ " in " ++ seconds)
    count outcome = case countOf outcome report of
      0 | outcome /= Held -> []
      n -> [show n ++ " " ++ outcomeText outcome]
    seconds = show (fromInteger (round (10 * reportSeconds report)) / 10 :: Double) ++ " seconds"

counted :: Int -> String -> String
counted n what = show n ++ " " ++ what ++ (if n == 1 then "" else "s")

commas :: [String] -> String
commas = intercalate ", "

padded :: Int -> String -> String
padded width text = text ++ replicate (max 1 (width - length text)) ' '
