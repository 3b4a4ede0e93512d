{-# LANGUAGE OverloadedStrings #-}

-- | Checks of a process that do not depend on any question: how it ends, and what it does without
-- a profile.
module PraTactile.Conformance.Process.Checks
  ( sessionChecks,
    oneShotChecks,
    checkTexts,
  )
where

import Data.Aeson (Value (..), object, toJSON, (.=))
import qualified Data.Aeson.KeyMap as KeyMap
import qualified Data.Aeson.Types as Aeson (Pair)
import qualified Data.ByteString as Bytes
import Data.ByteString.Builder (toLazyByteString)
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (toUpper)
import Data.Scientific (scientific)
import GHC.Clock (getMonotonicTime)
import PraTactile.Conformance.Laws.Forms (otherForms, otherText)
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Process.Await
import PraTactile.Conformance.Process.Child
import PraTactile.Conformance.Process.Lines
import PraTactile.Conformance.Process.OneShot
import PraTactile.Conformance.Process.Reply
import PraTactile.Conformance.Process.Session
import PraTactile.Conformance.Question
import PraTactile.Conformance.Subject
import PraTactile.Format.Profile (profileValue)
import PraTactile.Profile (Profile (..), canonicalProfile)
import System.Exit (ExitCode (..))

-- | The ids and sentences of all checks.
checkTexts :: [(String, String)]
checkTexts =
  [ (noProfileId, "anything that is not a profile is refused: invalid"),
    ( formsId,
      "the integers of a profile are JSON numbers or decimal strings; other keys are ignored"
    ),
    (answersFirstId, "requests before stop, in one write with it, are answered"),
    (noneInForceId, "after a refused profile no profile is in force, and a run is errored"),
    ( inputEndsId,
      "at the end of its input the process ends within 5 seconds and writes nothing more"
    ),
    (stoppedId, "after stop the process ends within 5 seconds and writes nothing more"),
    (unknownId, "an unknown operation is skipped"),
    (textId, "white space, the order of keys and escapes in strings do not change a request")
  ]

noProfileId, formsId, answersFirstId, noneInForceId, inputEndsId, stoppedId, unknownId :: String
noProfileId = "protocol/refuses-what-is-no-profile"
formsId = "protocol/takes-profiles-in-either-form"
answersFirstId = "protocol/answers-before-it-stops"
noneInForceId = "protocol/none-in-force-after-a-refusal"
inputEndsId = "protocol/ends-with-its-input"
stoppedId = "protocol/ends-when-stopped"
unknownId = "protocol/unknown-operation-is-skipped"

textId :: String
textId = "protocol/reads-any-json-text"

check :: String -> IO Checked -> Check
check name = Check name (concat (lookup name checkTexts))

-- | The checks of a process that answers many requests. Each uses a new process.
sessionChecks :: Limits -> Session -> [Check]
sessionChecks limits session =
  [ check noProfileId (profilesOf limits session "invalid" noProfiles),
    check formsId . profilesOf limits session "" $
      map with (otherForms (profileValue canonicalProfile)),
    check answersFirstId (answersFirst limits session),
    check noneInForceId (noneInForce limits session),
    check inputEndsId (judged [startRequest] <$> withStarted session (endsBy closeInput)),
    check stoppedId (judged [stopRequest] <$> withStarted session (endsBy stop)),
    check unknownId (unknownInSession limits session),
    check textId (otherwiseWritten limits session)
  ]
  where
    with profile = case profile of
      Object fields -> Object (KeyMap.insert "another" (toJSON [Null]) fields)
      _ -> profile
    stop child = send child (requestLine stopRequest)
    judged requests = either (CheckErred requests) (const CheckHeld)

-- | Makes a process end by the given action, and checks that it ends without output.
endsBy :: (Child -> IO ()) -> Child -> IO (Either Fault ())
endsBy ask child = do
  ask child
  now <- getMonotonicTime
  let deadline = now + 5
  line <- nextLine child deadline
  case line of
    NoMore rest | Bytes.null rest -> waitExit child deadline >>= maybe goesOn ended
    Unfinished rest | Bytes.null rest -> goesOn
    NoMore rest -> wrote rest
    Unfinished rest -> wrote rest
    Line rest -> wrote rest
    Oversized rest -> wrote rest
  where
    goesOn = fault DoesNotStop "it still runs 5 seconds later"
    wrote rest = fault OutputAfterStop (excerpt rest)
    ended code = case code of
      ExitFailure n | n < 0 -> fault Crashed (exitText code)
      _ -> pure (Right ())
    fault kind detail = Left <$> withErrors child (Fault kind detail)

-- | Opens these profiles one after the other. Each must be refused with the reason, or accepted if
-- the reason is empty.
profilesOf :: Limits -> Session -> String -> [Value] -> IO Checked
profilesOf limits session reason profiles =
  eachReplied limits session [(profileRequestOf one, (== wanted), wanted) | one <- profiles]
  where
    wanted = if null reason then ResponseResult (Bool True) else ResponseRefused reason

-- | Sends these requests one after the other, each with a test of its reply and an example of a
-- right one.
eachReplied :: Limits -> Session -> [(Value, Response -> Bool, Response)] -> IO Checked
eachReplied limits session requests = do
  got <- repliesTo limits session [requestLine one | (one, _, _) <- requests]
  pure $ case got of
    Left why -> CheckErred [startRequest] why
    Right replies -> foldr worse CheckHeld (zip requests replies)
  where
    worse ((request, does, wanted), came) others = case came of
      Left why -> CheckErred [request] why
      Right response
        | does response -> others
        | otherwise -> CheckFailed [request] wanted response

-- | The replies of one process to these lines, up to the first fault. Each line is sent after the
-- reply to the one before.
repliesTo :: Limits -> Session -> [Lazy.ByteString] -> IO (Either Fault [Either Fault Response])
repliesTo limits session requests =
  withStarted session $ \child ->
    Right <$> upToFault [send child request >> reply child | request <- requests]
  where
    reply child = do
      line <- awaitLine child (limitReply limits)
      pure (line >>= fmap replyResponse . readReply)

-- | Checks that a profile and a question of each operation have the same answers in usual and in
-- unusual JSON notation.
otherwiseWritten :: Limits -> Session -> IO Checked
otherwiseWritten limits session = compared <$> told usual <*> told other
  where
    told = repliesTo limits session
    usual = map requestLine requests
    other = [toLazyByteString (otherText one <> "\n") | one <- requests]
    requests =
      profileRequest canonicalProfile : zipWith runRequest [1 ..] (startedQuestions session)
    compared here there =
      either (CheckErred [startRequest]) (foldr worse CheckHeld . zip requests) $
        zip <$> here <*> there
    worse (request, answers) others = case answers of
      (Right wanted, Right came)
        | wanted == came -> others
        | otherwise -> CheckFailed [request] wanted came
      (Left why, _) -> CheckErred [request] why
      (_, Left why) -> CheckErred [request] why

-- | Invalid profiles: the paper's with a missing key, a value of another type, an unknown word,
-- another schema, or one or three numbers instead of two.
noProfiles :: [Value]
noProfiles =
  Null :
  Array mempty :
    [ Object (maybe (KeyMap.delete name) (KeyMap.insert name) wrong fields)
      | Object fields <- [profileValue canonicalProfile],
        name <- KeyMap.keys fields,
        wrong <- Nothing : map Just (wrongs ++ lengths name)
    ]
  where
    wrongs =
      [Bool True, Null, String "another", Number (scientific 40 (-1)), Number (-1), object []]
        ++ [Array (pure (String "x")), Array (pure (Number (scientific 10 (-1))))]
    lengths name =
      [ Array (mconcat (replicate count (pure (Number 1))))
        | name `elem` ["shape", "window"],
          count <- [1, 3]
      ]

-- | Many questions and @stop@ in one write, with more replies than a pipe holds: a program that
-- exits at once loses replies that it has not yet written.
answersFirst :: Limits -> Session -> IO Checked
answersFirst limits session = case startedQuestions session of
  [] -> pure CheckHeld
  question : _ -> do
    let long = SomeQuestion (Terms :? (0, 100000))
        offered = startedOperations (sessionStarted session)
        last' = if nameOf (SomeOp Terms) `elem` offered then long else question
        runs = zipWith runRequest [1 ..] (replicate 2000 question ++ [last', last'])
        requests = profileRequest canonicalProfile : runs
    got <- withStarted session $ \child -> do
      send child (foldMap requestLine (requests ++ [stopRequest]))
      Right <$> upToFault (map (const (awaitLine child (limitReply limits))) requests)
    pure $ case got of
      Left why -> CheckErred [startRequest] why
      Right replies ->
        foldr
          const
          CheckHeld
          [CheckErred [one, stopRequest] why | (one, Left why) <- zip requests replies]

-- | A possible profile, an impossible one and a question, reported together.
noneInForce :: Limits -> Session -> IO Checked
noneInForce limits session = case startedQuestions session of
  [] -> pure CheckHeld
  question : _ -> together <$> eachReplied limits session requests
    where
      requests =
        [ (profileRequest canonicalProfile, const True, none),
          (profileRequest canonicalProfile {profileOrder = 6}, isRefused, none),
          (runRequest 1 question, isErrored, none)
        ]
      together checked = case checked of
        CheckHeld -> CheckHeld
        CheckFailed _ wanted came -> CheckFailed asked wanted came
        CheckErred _ why -> CheckErred asked why
      asked = [request | (request, _, _) <- requests]
      none = ResponseErrored "no profile is in force"

-- | Unknown operation names between two questions: names that a look-up by name finds in many
-- languages by inheritance, and misspelt names.
unknownInSession :: Limits -> Session -> IO Checked
unknownInSession limits session =
  eachReplied limits session $
    (profileRequest canonicalProfile, (== inForce), inForce) :
    zipWith ($) (known ++ map unknown (inherited ++ misspelt) ++ known) [1 ..]
  where
    inForce = ResponseResult (Bool True)
    offered = startedOperations (sessionStarted session)
    example = take 1 (startedQuestions session)
    known = [\i -> (runRequest i one, const True, notKnown) | one <- example]
    unknown name i = (inSession (unknownQuestion i name), isSkipped, notKnown)
    inSession keys = object (("command" .= ("run" :: String)) : keys)
    inherited =
      filter
        (`notElem` offered)
        ["no-such-operation", "", "length", "toString", "constructor", "__proto__", "__class__"]
    misspelt =
      [ change (nameOf (operationOf one))
        | SomeQuestion one <- example,
          change <- [(++ " "), (++ "s"), map toUpper]
      ]

isSkipped, isRefused, isErrored :: Response -> Bool
isSkipped response = case response of
  ResponseSkipped _ -> True
  _ -> False
isRefused response = case response of
  ResponseRefused _ -> True
  _ -> False
isErrored response = case response of
  ResponseErrored _ -> True
  _ -> False

notKnown :: Response
notKnown = ResponseSkipped "not known"

-- | The keys of a question with an unknown operation, in either mode.
unknownQuestion :: Int -> String -> [Aeson.Pair]
unknownQuestion number name =
  ["sequence" .= number, "operation" .= name, "input" .= object []]

-- | Questions of the offered operations of the code.
startedQuestions :: Session -> [SomeQuestion]
startedQuestions session =
  [ question
    | question@(SomeQuestion asked) <- map exampleOf allOperations,
      operationOf asked `elem` codeOperations,
      nameOf (operationOf asked) `elem` startedOperations (sessionStarted session)
  ]

-- | The checks of a command that answers one request.
oneShotChecks :: Limits -> Command -> [Check]
oneShotChecks limits command =
  [check unknownId (judged <$> runOnce limits command request)]
  where
    request =
      object
        (("profile" .= profileValue canonicalProfile) : unknownQuestion 1 "no-such-operation")
    judged got = case replyResponse <$> got of
      Left why -> CheckErred [request] why
      Right response
        | isSkipped response -> CheckHeld
        | otherwise -> CheckFailed [request] notKnown response
