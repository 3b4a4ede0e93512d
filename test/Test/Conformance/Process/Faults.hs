{-# LANGUAGE OverloadedStrings #-}

-- | Runs @conform@ on real processes: right ones, wrong ones, and ones that do anything but reply.
-- Also tests what a run leaves behind.
module Test.Conformance.Process.Faults (spec, usageSpec) where

import Data.Aeson (Value (..))
import Data.Foldable (for_)
import Data.List (intercalate, isInfixOf)
import GHC.Clock (getMonotonicTime)
import System.Directory (findExecutable)
import System.FilePath ((</>))
import System.Process (readProcess)
import Test.CommandLine.Run
import Test.Conformance.Process.Subjects
import Test.Effort
import Test.Hspec
import Test.Support (inFolder)

spec :: Spec
spec = do
  python <- runIO (findExecutable "python3")
  case python of
    Nothing ->
      it "conform is tried on small subjects" $
        pendingWith "python3 is not installed here, so that these subjects were not run"
    Just _ -> do
      faultSpec
      oneShotSpec
      choiceSpec
      replaySpec
      endSpec
      signalSpec
      limitSpec

-- | What a process can do instead of replying, and the name of that fault.
instead :: [(String, String)]
instead =
  [ ("crash", "crashed"),
    ("signal", "crashed"),
    ("children", "crashed"),
    ("hang", "timeout"),
    ("garbage", "not-json"),
    ("nan", "not-json"),
    ("deep", "not-json"),
    ("digits", "not-json"),
    ("half-line", "half-line"),
    ("no-line-end", "half-line"),
    ("long-line", "line-too-long"),
    ("endless-line", "endless-output"),
    ("endless", "endless-output"),
    ("order", "out-of-order"),
    ("twice", "answered-twice"),
    ("both", "not-a-reply"),
    ("neither", "not-a-reply"),
    ("type", "wrong-type"),
    ("closed-output", "closed-pipe"),
    ("closed-input", "closed-pipe"),
    ("last-word", "output-after-stop"),
    ("killed-at-the-end", "crashed"),
    ("stays", "does-not-stop")
  ]

faultSpec :: Spec
faultSpec = describe "in a session" $ do
  for_ (byEffort (filter ((`notElem` waiting) . fst)) id instead) $ \(fault, name) ->
    it (fault ++ " is " ++ name) $ do
      (status, out, err) <- adder ["--timeout", patience fault, "--json"] [fault]
      (status, err) `shouldBe` (1, "")
      faults out `shouldContain` [name]
      reported "certified" out `shouldBe` Just (Bool False)
  it "conform certifies a right adder, whatever its standard error and its exit status" $
    for_ (byEffort id ("none" :) ["flood", "status-3"]) $ \fault -> do
      (status, out, _) <- adder ["--json"] [fault]
      (status, faults out, reported "certified" out) `shouldBe` (0, [], Just (Bool True))
      reported "failed" out `shouldBe` Just (Number 0)
  it "a law fails if the process skips an operation that it offers" $ do
    (status, out, _) <- adder ["--json"] ["skips"]
    (status, lookup "field/addition-as-defined" (outcomes out)) `shouldBe` (1, Just "failed")
  it "a law is errored if the process answers with an error" $ do
    (status, out, _) <- adder ["--json"] ["errs"]
    (status, lookup "field/addition-as-defined" (outcomes out)) `shouldBe` (1, Just "errored")
  it "a law fails on an answer of another type, and is errored without an answer" $
    for_
      ( [("type", "failed"), ("crash", "errored")]
          ++ byEffort [] [("garbage", "errored"), ("both", "errored")]
      )
      $ \(fault, outcome) -> do
        (_, out, _) <- adder ["--json"] [fault]
        lookup "field/addition-as-defined" (outcomes out) `shouldBe` Just outcome
  it "checks of how a process ends, and of what it does without a profile, can be run by name" $
    for_ ["none-in-force-after-a-refusal", "ends-with-its-input", "ends-when-stopped"] $ \name -> do
      (status, out, err) <-
        conform
          ["--json", "--profile", paperFile, "--run", "protocol/" ++ name]
          ["python3", "test/subjects/faulty.py", "none"]
      (status, err, outcomes out) `shouldBe` (0, "", [("protocol/" ++ name, "held")])
  it "a process that skips all, offers nothing or refuses possible profiles is not certified" $
    for_ ["skips-all", "offers-nothing", "refuses-all"] $ \fault -> do
      (status, out, _) <- adder ["--json"] [fault]
      (status, reported "certified" out) `shouldBe` (1, Just (Bool False))
  it "the report quotes the last text on the process's standard error" $ do
    (_, out, _) <- adder [] ["crash"]
    out `shouldSatisfy` isInfixOf "on its standard error: the table is not there"
  -- "Test.Conformance.Process.Output" tests this on scripts, with the words, in a quick run.
  whenFull . it "the report gives in seconds how long the runner waited" $
    for_ [("0.5", "0.5 seconds"), ("1", "1 second"), ("1.5", "1.5 seconds")] $
      \(limit, said) -> do
        (_, out, _) <- adder ["--timeout", limit] ["hang"]
        out `shouldSatisfy` isInfixOf ("no reply within " ++ said ++ "\n")
  it "the report shows the first hundred bytes of a line that is too long" $ do
    (_, out, _) <- adder [] ["long-line"]
    out `shouldSatisfy` isInfixOf (": " ++ replicate 100 ' ' ++ " ...")
  it "the time of all laws together is limited as well" $ do
    (status, out, _) <- adder ["--timeout", "60", "--limit", byEffort "0.5" "2", "--json"] ["hang"]
    (status, take 1 (faults out)) `shouldBe` (1, ["too-slow"])
  it "conform --parallel finds the same failures and tokens as a single process" $ do
    (_, alone, _) <- adder ["--json"] ["order"]
    (_, several, _) <- adder ["--json", "--parallel", "3"] ["order"]
    (outcomes several, tokens several) `shouldBe` (outcomes alone, tokens alone)
  where
    -- A quick run waits only for a process that hangs and for one that closes its output. The
    -- others take as long, or the five seconds that a process has to end.
    -- "Test.Conformance.Process.Output" tests scripts that do the same.
    waiting = ["children", "no-line-end", "closed-input", "stays"]

-- | The seconds that an adder with a fault is given for an answer. They are few only where the
-- fault is that it never ends, because a busy machine may be slow to start one.
patience :: String -> String
patience fault
  | fault `elem` ["hang", "stays", "closed-input", "no-line-end"] = byEffort "1.5" "3"
  | otherwise = "60"

oneShotSpec :: Spec
oneShotSpec = describe "with a process per request" $ do
  for_ (byEffort (filter ((`elem` unlike) . fst)) id oneShotFaults) $ \(fault, name) ->
    it (fault ++ " is " ++ name) $ do
      (status, out, _) <- once ["--timeout", patience fault, "--json"] [fault]
      (status, faults out) `shouldBe` (1, [name])
  it "conform certifies a right adder" $ do
    (status, out, _) <- once ["--json"] []
    (status, reported "certified" out) `shouldBe` (0, Just (Bool True))
  where
    -- One reply too few, no reply in time, a wrong reply, one too many, and no end after the reply.
    -- "Test.Conformance.Process.Output" tests the other faults on scripts.
    unlike = ["crash", "hang", "wrong-number", "lines-after-1003", "stays"]
    oneShotFaults =
      [ ("crash", "crashed"),
        ("silent", "crashed"),
        ("status", "crashed"),
        ("hang", "timeout"),
        ("wrong-number", "out-of-order"),
        ("twice", "answered-twice"),
        ("garbage-after", "not-a-reply"),
        -- The first reply and 1002 more.
        ("lines-after-1002", "not-a-reply"),
        ("lines-after-1003", "endless-output"),
        ("half-line-after", "half-line"),
        ("long-line-after", "line-too-long"),
        ("stays", "does-not-stop")
      ]

choiceSpec :: Spec
choiceSpec = describe "laws that fail" $ do
  it "are not a failure if listed as known, but a listed law that passes is one" $
    inFolder $ \folder -> do
      let file = folder </> "known"
      writeFile file "# what is known\n\nfield/addition-as-*  # not yet\n"
      (status, out, _) <- adder ["--known-failures", file, "--json"] ["errs"]
      lookup "field/addition-as-defined" (outcomes out) `shouldBe` Just "known-failure"
      status `shouldBe` 0
      (status', out', _) <- adder ["--known-failures", file] ["none"]
      status' `shouldBe` 1
      out' `shouldSatisfy` isInfixOf "held, but must fail: field/addition-as-*"
  it "are run even if skipped, and must fail, if that is requested" $ do
    let skip = ["--skip", "field/addition-as-defined", "--skip-must-fail"]
    (held, _, _) <- adder skip ["none"]
    (_, out, _) <- adder ("--json" : skip) ["errs"]
    held `shouldBe` 1
    lookup "field/addition-as-defined" (outcomes out) `shouldBe` Just "known-failure"
  it "end the run at once, if that is requested" $ do
    (_, out, _) <- adder ["--json", "--fail-fast"] ["errs"]
    map snd (outcomes out) `shouldBe` ["errored", "held", "held", "held"]
    -- This subject is given the five seconds that a process has to end.
    whenFull $ do
      (_, out', _) <- adder ["--json", "--fail-fast"] ["stays"]
      map snd (outcomes out') `shouldBe` ["skipped", "held", "errored", "skipped"]
  it "are written as XML for build servers" $
    inFolder $ \folder -> do
      let file = folder </> "report.xml"
      _ <- adder ["--junit", file] ["garbage"]
      counts <- readProcess "python3" ["-c", countCases, file] ""
      counts `shouldBe` "[4, 0, 1, 0]\n"
      _ <- adder ["--junit", file, "--skip", "field/addition-as-defined"] ["none"]
      counts' <- readProcess "python3" ["-c", countCases, file] ""
      counts' `shouldBe` "[4, 0, 0, 1]\n"
  where
    -- The counts in the root and in the suites equal the number of elements.
    countCases =
      "import sys, xml.etree.ElementTree as x\n\
      \t = x.parse(sys.argv[1]).getroot()\n\
      \kinds = ('testcase', 'failure', 'error', 'skipped')\n\
      \def found(e): return [len(e.findall('.//' + k)) for k in kinds]\n\
      \def told(e): return [int(e.get(k)) for k in ('tests', 'failures', 'errors', 'skipped')]\n\
      \assert all(found(e) == told(e) for e in [t] + t.findall('testsuite'))\n\
      \print(found(t))"

replaySpec :: Spec
replaySpec = describe "a token" $ do
  it "is enough to try the case again" $ do
    (_, out, _) <- adder ["--json"] ["type"]
    let replayed token fault =
          conform
            ["--json", "--profile", paperFile, "--replay", token]
            ["python3", "test/subjects/faulty.py", fault]
    length (tokens out) `shouldBe` 1
    for_ (tokens out) $ \token -> do
      (status, again, _) <- replayed token "skips-all"
      (status, map snd (outcomes again)) `shouldBe` (1, ["failed"])
      (status', again', _) <- replayed token "none"
      (status', map snd (outcomes again'), reported "cases" again')
        `shouldBe` (0, ["held"], Just (Number 1))
  it "is rejected in words if it is malformed" $ do
    (status, out, err) <- conform ["--replay", "abc"] ["true"]
    (status, out) `shouldBe` (2, "")
    err `shouldSatisfy` isInfixOf "abc is no token"

endSpec :: Spec
endSpec = describe "nothing is left behind" $
  for_ ["SIGINT", "SIGTERM", "SIGHUP"] $ \signal -> it ("after " ++ signal) $
    inFolder $ \folder -> do
      let run =
            ["pra-tactile", "conform", "--timeout", "60", "--profile", paperFile, "--"]
              ++ ["python3", "test/subjects/faulty.py", "hang", folder]
      said <-
        readProcess
          "env"
          ( ["TMPDIR=" ++ folder, "python3", "test/subjects/interrupted.py", signal, folder]
              ++ run
          )
          ""
      said `shouldBe` "True 0 0\n"

signalSpec :: Spec
signalSpec = describe "signals" $ do
  it "end conform at any time, as they end any program" $
    for_ ["SIGINT", "SIGTERM", "SIGHUP"] $ \signal -> do
      said <-
        readProcess
          "python3"
          ( ["test/subjects/signalled.py", signal]
              ++ map show (byEffort [0, 8 .. 39] [0 :: Int .. 39])
              ++ words "-- pra-tactile conform -- sleep 5"
          )
          ""
      (signal, words said) `shouldBe` (signal, [signal])
  it "that are ignored when conform starts stay ignored" $ do
    let second = byEffort 0.4 1 :: Double
    said <-
      readProcess
        "sh"
        [ "-c",
          "trap '' HUP INT TERM; pra-tactile conform --profile " ++ paperFile
            ++ (" --run field/addition-commutes -- sh -c 'sleep " ++ show second)
            ++ ("; exec pra-tactile serve' > /dev/null & sleep " ++ show (second / 2))
            ++ "; kill -HUP $!; kill -INT $!; kill -TERM $!; wait $!; echo $?"
        ]
        ""
    said `shouldBe` "0\n"

limitSpec :: Spec
limitSpec = describe "the time limit of a whole run" $
  it "includes the wait for the first reply" $
    for_ [[], ["--one-shot"], ["--parallel", "3"]] $ \how -> do
      begun <- getMonotonicTime
      outcome <-
        praAlone
          ( words ("conform --timeout 60 --limit " ++ byEffort "0.2" "0.5")
              ++ (["--profile", paperFile] ++ how ++ words "-- sleep 90")
          )
      ended <- getMonotonicTime
      outcome `refuses` "the time of --limit was over"
      -- Long enough for a busy machine, and half of the wait for a reply.
      ended - begun `shouldSatisfy` (< 30)

-- | Tests what only the command shows.
usageSpec :: Spec
usageSpec = describe "usage" $ do
  it "conform reports a command that cannot be started or never answers" $ do
    conforming ["--", "./no-such-subject"] `complains` "there is no such program"
    conforming ["--", "README.md"] `complains` "there is no such program"
    conforming ["--", "./README.md"] `complains` "it is no program that may be run"
    conforming ["--", "true"] `complains` "never answered start: crashed"
    conforming ["--one-shot", "--", "true"] `complains` "never answered start: crashed"
    conforming ["--timeout", "0.2", "--", "sleep", "60"] `complains` "never answered start: timeout"
    conforming ["--timeout", "0.2", "--", "sleep", "60"] `complains` "flush its standard output"
  it "a mistake that a fresh process repeats does not depend on earlier requests" $
    for_ [[], ["--one-shot"]] $ \how -> do
      (status, out, _) <-
        inOrder
          (["--cases", byEffort "4" "20"] ++ how)
          (words "pra-tactile serve --impostor reduces-by-another-modulus" ++ how)
      (status, lookup "field/in-any-order" (outcomes out))
        `shouldSatisfy` (`elem` [(0, Just "held"), (1, Just "skipped")])
  it "a mistake that comes only after a refusal depends on earlier requests" $ do
    (status, out, _) <-
      inOrder
        ["--cases", "20"]
        [ "sh",
          "-c",
          "pra-tactile serve | sed -u '/\"refused\"/{n;s/\"result\":\\([0-9]\\)/\"result\":1\\1/}'"
        ]
    (status, lookup "field/in-any-order" (outcomes out)) `shouldBe` (1, Just "failed")
  it "conform refuses to run without a command, or with a name that no law has" $ do
    conforming [] `complains` "name the command"
    conforming ["--run", "no-such-law", "--", "true"]
      `complains` "no law is called \"no-such-law\""
    conforming ["--cases", "0", "--", "true"] `complains` "--cases must be a number, 1 or more"
    inFolder $ \folder -> do
      writeFile (folder </> "known") "field/no-such-law\n"
      conforming ["--known-failures", folder </> "known", "--", "true"]
        `complains` "no law is called \"field/no-such-law\""
  it "conform refuses a profile whose array is too large for the definition" $
    inFolder $ \folder -> do
      (_, profile, _) <- pra (words "profile --q 2 --shape 4095x4097 --polynomial" ++ [pentanomial])
      writeFile (folder </> "large.json") profile
      ["conform", "--profile", folder </> "large.json", "--", "true"]
        `complains` "large: this profile's array has more than 2^20 cells"
  it "conform lists each law once" $ do
    (status, out, _) <- pra (conforming ["--list", "--stage", "field"])
    status `shouldBe` 0
    length (filter (isInfixOf "field/addition-commutes") (lines out)) `shouldBe` 1
  where
    conforming options = "conform" : "--profile" : paperFile : options
    inOrder how =
      conform (words "--json --run field/in-any-order --profile" ++ paperFile : how)
    -- x^24 + x^7 + x^2 + x + 1
    pentanomial = intercalate "," (words "1 1 1 0 0 0 0 1" ++ replicate 16 "0" ++ ["1"])
