{-# LANGUAGE OverloadedStrings #-}

-- | Tests the checks of the protocol on small shell scripts: what a process must do whatever it is
-- asked, how it ends, and what it does without a profile.
module Test.Conformance.Process.Checks (spec) where

import Control.Monad (forM, forM_)
import Data.Aeson (Value (..), object, toJSON, (.=))
import Data.List (nub)
import PraTactile.Conformance.Operations (exampleOf)
import PraTactile.Conformance.Process
import PraTactile.Conformance.Process.Reply
import PraTactile.Conformance.Question
import PraTactile.Conformance.Subject
import PraTactile.Format.Profile (profileValue)
import PraTactile.Profile (Profile (..), canonicalProfile)
import System.Posix.Signals (Handler (..), installHandler, sigHUP)
import Test.Hspec

spec :: Spec
spec = do
  it "a process may end with any status, but not by a signal or with output; stop must end it" $ do
    -- A process that ignores a signal starts children that ignore it too.
    before' <- installHandler sigHUP Default Nothing
    forM_
      [ ("exit 0", Nothing),
        ("exit 1", Nothing),
        ("exit 255", Nothing),
        ("kill -1 $$", Just (Fault Crashed "it was ended by signal 1")),
        ("kill -9 $$", Just (Fault Crashed "it was ended by signal 9")),
        ("echo; exit 0", Just (Fault OutputAfterStop "")),
        ("printf x; exit 0", Just (Fault OutputAfterStop "x"))
      ]
      $ \(ending, fault) -> do
        let script =
              "while read -r line; do case $line in *start*) " ++ started ""
                ++ (" ;; *stop*) " ++ ending ++ " ;; esac; done; ")
                ++ ending
            judged request = maybe CheckHeld (CheckErred [request]) fault
        came <-
          tried
            script
            ["none-in-force-after-a-refusal", "ends-with-its-input", "ends-when-stopped"]
        (ending, came)
          `shouldBe` (ending, Right [CheckHeld, judged startRequest, judged stopRequest])
    _ <- installHandler sigHUP before' Nothing
    pure ()
  it "no profile is in force after a refusal; an answer given all the same is reported" $ do
    let impossible = canonicalProfile {profileOrder = 6}
        operands = exampleOf (SomeOp Add)
        requests =
          [profileRequest canonicalProfile, profileRequest impossible, runRequest 1 operands]
        noProfile = ResponseErrored "no profile is in force"
        answers possible' refusal run =
          unlines
            [ "while read -r line; do case $line in",
              "  *'\"start\"'*) " ++ started "\"add\"" ++ " ;;",
              "  *'\"q\":6'*) " ++ refusal ++ " ;;",
              "  *'\"profile\"'*) " ++ possible' ++ " ;;",
              "  *) " ++ run ++ " ;;",
              "esac; done"
            ]
        yes = "echo '{\"result\":true}'"
        no = "echo '{\"refused\":\"no\"}'"
        three = "echo '{\"sequence\":1,\"result\":3}'"
        ends = "exit 3"
        gone = Fault Crashed "it ended, with status 3"
        kept = ResponseResult (toJSON (3 :: Int))
    forM_
      [ (answers yes no "echo '{\"sequence\":1,\"errored\":\"none\"}'", CheckHeld),
        (answers no no "echo '{\"sequence\":1,\"errored\":\"none\"}'", CheckHeld),
        (answers yes no three, CheckFailed requests noProfile kept),
        ( answers yes no "echo '{\"skipped\":\"s\"}'",
          CheckFailed requests noProfile (ResponseSkipped "s")
        ),
        (answers yes yes three, CheckFailed requests noProfile (ResponseResult (Bool True))),
        (answers ends no three, CheckErred requests gone),
        (answers yes ends three, CheckErred requests gone),
        (answers yes no ends, CheckErred requests gone)
      ]
      $ \(script, wanted) -> do
        came <- tried script ["none-in-force-after-a-refusal"]
        came `shouldBe` Right [wanted]
  it "an invalid profile must be refused, and a valid one accepted in either form" $
    forM_ [("{\"result\":true}", [False, True]), ("{\"refused\":\"invalid\"}", [True, False])] $
      \(reply, wanted) -> do
        let script =
              ("read -r line; " ++ started "")
                ++ ("; while read -r line; do echo '" ++ reply ++ "'; done")
        came <- held script ["refuses-what-is-no-profile", "takes-profiles-in-either-form"]
        (reply, came) `shouldBe` (reply, Right wanted)
  it "a process must answer everything that was asked before stop; one that ends earlier fails" $
    forM_ [("2002", True), ("2001", False), ("0", False)] $ \(count, wanted) -> do
      let script =
            unlines
              [ "read -r line; " ++ started "\"add\"",
                "read -r line; echo '{\"result\":true}'",
                "i=1; while [ $i -le " ++ count ++ " ]; do",
                "  echo \"{\\\"sequence\\\":$i,\\\"result\\\":0}\"; i=$((i+1)); done"
              ]
      came <- held script ["answers-before-it-stops"]
      (count, came) `shouldBe` (count, Right [wanted])
  it "one process per request: an unknown operation must be skipped; anything else is reported" $ do
    let request =
          object
            [ "profile" .= profileValue canonicalProfile,
              "sequence" .= (1 :: Int),
              "operation" .= ("no-such-operation" :: String),
              "input" .= object []
            ]
        zero = "echo '{\"sequence\":1,\"result\":0}'"
        answering reply =
          "read -r line; case $line in *no-such*) " ++ reply ++ " ;; *) " ++ zero ++ " ;; esac"
        notKnown = ResponseSkipped "not known"
    forM_
      [ ("echo '{\"sequence\":1,\"skipped\":\"s\"}'", CheckHeld),
        (zero, CheckFailed [request] notKnown (ResponseResult (toJSON (0 :: Int)))),
        ("exit 3", CheckErred [request] (Fault Crashed "it ended, with status 3"))
      ]
      $ \(reply, wanted) -> do
        came <-
          withProcess OneShot (Limits 20 60) (shell (answering reply)) $ \subject ->
            forM (subjectChecks subject) checkTry
        (reply, came) `shouldBe` (reply, Right [wanted])
  it "a session must skip an unknown operation, whatever its name" $ do
    let answering unknown =
          unlines
            [ "n=0; read -r line; " ++ started "\"add\"",
              "read -r line; echo '{\"result\":true}'",
              "while read -r line; do n=$((n+1)); case $line in",
              "  *'\"add\"'*) echo \"{\\\"sequence\\\":$n,\\\"result\\\":1}\" ;;",
              "  " ++ unknown ++ " ;;",
              "  *) echo \"{\\\"sequence\\\":$n,\\\"skipped\\\":\\\"\\\"}\" ;;",
              "esac; done"
            ]
        zero = ") echo \"{\\\"sequence\\\":$n,\\\"result\\\":0}\""
    forM_
      [ ("*never*" ++ zero, True),
        ("*no-such*" ++ zero, False),
        ("*'\"\"'*" ++ zero, False),
        ("*to*" ++ zero, False),
        ("*'\"add '*" ++ zero, False),
        ("*ADD*) exit 3", False)
      ]
      $ \(unknown, wanted) -> do
        came <- held (answering unknown) ["unknown-operation-is-skipped"]
        (unknown, came) `shouldBe` (unknown, Right [wanted])
  it "a request means the same in any JSON text; a process that searches the text is reported" $
    forM_
      [ ("*", True),
        ("*'\"add\"'*", False),
        ("*'\"a\":'*", False),
        ("'{\"'*", False),
        ("*'\"input\"'*'\"operation\"'*", False)
      ]
      $ \(sought, wanted) -> do
        let script =
              unlines
                [ "read -r line; " ++ started "\"add\"",
                  "read -r line; echo '{\"result\":true}'; read -r line; case $line in",
                  "  " ++ sought ++ ") echo '{\"sequence\":1,\"result\":1}' ;;",
                  "  *) echo '{\"sequence\":1,\"skipped\":\"\"}' ;; esac"
                ]
        came <- held script ["reads-any-json-text"]
        (sought, came) `shouldBe` (sought, Right [wanted])
  it "each check of the protocol states its demand in a sentence" $ do
    let ids = map checkId
        once' = "echo '{\"sequence\":1,\"result\":0}'"
        answering = "read -r line; " ++ started "" ++ "; read -r line"
        texts those = [(checkId one, checkSentence one) | one <- those]
    Right inSession <- session (shell answering) (pure . subjectChecks)
    ids inSession
      `shouldBe` ["protocol/refuses-what-is-no-profile", "protocol/takes-profiles-in-either-form"]
        ++ ["protocol/answers-before-it-stops"]
        ++ ["protocol/none-in-force-after-a-refusal", "protocol/ends-with-its-input"]
        ++ ["protocol/ends-when-stopped", "protocol/unknown-operation-is-skipped"]
        ++ ["protocol/reads-any-json-text"]
    Right alone <-
      withProcess OneShot (Limits 20 60) (shell once') $ \subject -> do
        (subjectBatch subject, subjectUnknown subject) `shouldBe` (32, [])
        pure (subjectChecks subject)
    ids alone `shouldBe` ["protocol/unknown-operation-is-skipped"]
    nub (texts (inSession ++ alone)) `shouldBe` checkTexts
    map snd checkTexts `shouldSatisfy` notElem ""

-- | Runs the checks of these names (after @protocol/@) on a script.
tried :: String -> [String] -> IO (Either Fault [Checked])
tried script names = session (shell script) $ \subject ->
  sequence
    [checkTry one | name <- names, one <- subjectChecks subject, checkId one == "protocol/" ++ name]

held :: String -> [String] -> IO (Either Fault [Bool])
held script = fmap (fmap (map (== CheckHeld))) . tried script

-- | A subject that is a shell script.
session :: Command -> (Subject -> IO a) -> IO (Either Fault a)
session = withProcess InSession (Limits 20 60)

shell :: String -> Command
shell script = Command "sh" ["-c", script]

-- | The reply to the start request, with these operations.
started :: String -> String
started operations =
  "echo '{\"protocol\":1,\"name\":\"s\",\"in_flight\":1,\"operations\":[" ++ operations ++ "]}'"
