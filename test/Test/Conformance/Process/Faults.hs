{-# LANGUAGE OverloadedStrings #-}

-- | @conform@ on real processes: those that are right, those that are wrong, and those that do
-- anything but reply; and what it leaves behind.
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
      it "is tried on small subjects" $
        pendingWith "python3 is not installed here, so that these subjects were not run"
    Just _ -> do
      faultSpec
      oneShotSpec
      choiceSpec
      replaySpec
      endSpec
      signalSpec
      limitSpec

-- | What a process can do instead of replying, and the name that it gets.
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
  it "what is right is certified, whatever it writes to its standard error, and its status" $
    for_ (byEffort id ("none" :) ["flood", "status-3"]) $ \fault -> do
      (status, out, _) <- adder ["--json"] [fault]
      (status, faults out, reported "certified" out) `shouldBe` (0, [], Just (Bool True))
      reported "failed" out `shouldBe` Just (Number 0)
  it "what is skipped though it is offered fails" $ do
    (status, out, _) <- adder ["--json"] ["skips"]
    (status, lookup "field/addition-as-defined" (outcomes out)) `shouldBe` (1, Just "failed")
  it "what errs is errored" $ do
    (status, out, _) <- adder ["--json"] ["errs"]
    (status, lookup "field/addition-as-defined" (outcomes out)) `shouldBe` (1, Just "errored")
  it "what answers with another type fails, and what does not answer is errored" $
    for_
      ( [("type", "failed"), ("crash", "errored")]
          ++ byEffort [] [("garbage", "errored"), ("both", "errored")]
      )
      $ \(fault, outcome) -> do
        (_, out, _) <- adder ["--json"] [fault]
        lookup "field/addition-as-defined" (outcomes out) `shouldBe` Just outcome
  it "how it ends, and what it does without a profile, is asked by name" $
    for_ ["none-in-force-after-a-refusal", "ends-with-its-input", "ends-when-stopped"] $ \name -> do
      (status, out, err) <-
        conform
          ["--json", "--profile", paperFile, "--run", "protocol/" ++ name]
          ["python3", "test/subjects/faulty.py", "none"]
      (status, err, outcomes out) `shouldBe` (0, "", [("protocol/" ++ name, "held")])
  it "whoever skips everything, offers nothing or refuses possible profiles is not certified" $
    for_ ["skips-all", "offers-nothing", "refuses-all"] $ \fault -> do
      (status, out, _) <- adder ["--json"] [fault]
      (status, reported "certified" out) `shouldBe` (1, Just (Bool False))
  it "what it said last on its standard error is told" $ do
    (_, out, _) <- adder [] ["crash"]
    out `shouldSatisfy` isInfixOf "on its standard error: the table is not there"
  -- In a quick run "Test.Conformance.Process.Output" has this of scripts, and of the words.
  whenFull . it "what was waited for is told in seconds" $
    for_ [("0.5", "0.5 seconds"), ("1", "1 second"), ("1.5", "1.5 seconds")] $
      \(limit, said) -> do
        (_, out, _) <- adder ["--timeout", limit] ["hang"]
        out `shouldSatisfy` isInfixOf ("no reply within " ++ said ++ "\n")
  it "of a line that is too long the first hundred bytes are told" $ do
    (_, out, _) <- adder [] ["long-line"]
    out `shouldSatisfy` isInfixOf (": " ++ replicate 100 ' ' ++ " ...")
  it "time is limited for all together as well" $ do
    (status, out, _) <- adder ["--timeout", "60", "--limit", byEffort "0.5" "2", "--json"] ["hang"]
    (status, take 1 (faults out)) `shouldBe` (1, ["too-slow"])
  it "several processes of it find the same" $ do
    (_, alone, _) <- adder ["--json"] ["order"]
    (_, several, _) <- adder ["--json", "--parallel", "3"] ["order"]
    (outcomes several, tokens several) `shouldBe` (outcomes alone, tokens alone)
  where
    -- A quick run waits for one that hangs and one that closes its output. The others are waited
    -- for as long, or for the five seconds that a process has to end; but for that, scripts that do
    -- the like are tested in "Test.Conformance.Process.Output".
    waiting = ["children", "no-line-end", "closed-input", "stays"]

-- | How many seconds an adder with a fault is given for an answer: few only where it is the fault
-- that it never ends, for a busy machine may take its time to start one.
patience :: String -> String
patience fault
  | fault `elem` ["hang", "stays", "closed-input", "no-line-end"] = byEffort "0.5" "3"
  | otherwise = "60"

oneShotSpec :: Spec
oneShotSpec = describe "with a process a request" $ do
  for_ (byEffort (filter ((`elem` unlike) . fst)) id oneShotFaults) $ \(fault, name) ->
    it (fault ++ " is " ++ name) $ do
      (status, out, _) <- once ["--timeout", patience fault, "--json"] [fault]
      (status, faults out) `shouldBe` (1, [name])
  it "what is right is certified" $ do
    (status, out, _) <- once ["--json"] []
    (status, reported "certified" out) `shouldBe` (0, Just (Bool True))
  where
    -- A reply too few, none in time, a wrong one, too many, and no end after it. Scripts that do
    -- the others are tested in "Test.Conformance.Process.Output".
    unlike = ["crash", "hang", "wrong-number", "lines-after-1003", "stays"]
    oneShotFaults =
      [ ("crash", "crashed"),
        ("silent", "crashed"),
        ("status", "crashed"),
        ("hang", "timeout"),
        ("wrong-number", "out-of-order"),
        ("twice", "answered-twice"),
        ("garbage-after", "not-a-reply"),
        -- The first of them, and 1002 more.
        ("lines-after-1002", "not-a-reply"),
        ("lines-after-1003", "endless-output"),
        ("half-line-after", "half-line"),
        ("long-line-after", "line-too-long"),
        ("stays", "does-not-stop")
      ]

choiceSpec :: Spec
choiceSpec = describe "laws that fail" $ do
  it "are no failure where they are known, and one where they pass all the same" $
    inFolder $ \folder -> do
      let file = folder </> "known"
      writeFile file "# what is known\n\nfield/addition-as-*  # not yet\n"
      (status, out, _) <- adder ["--known-failures", file, "--json"] ["errs"]
      lookup "field/addition-as-defined" (outcomes out) `shouldBe` Just "known-failure"
      status `shouldBe` 0
      (status', out', _) <- adder ["--known-failures", file] ["none"]
      status' `shouldBe` 1
      out' `shouldSatisfy` isInfixOf "held, but must fail: field/addition-as-*"
  it "must fail where they are skipped, if that is asked for" $ do
    let skip = ["--skip", "field/addition-as-defined", "--skip-must-fail"]
    (held, _, _) <- adder skip ["none"]
    (_, out, _) <- adder ("--json" : skip) ["errs"]
    held `shouldBe` 1
    lookup "field/addition-as-defined" (outcomes out) `shouldBe` Just "known-failure"
  it "end the run at once, if that is asked for" $ do
    (_, out, _) <- adder ["--json", "--fail-fast"] ["errs"]
    map snd (outcomes out) `shouldBe` ["errored", "held", "held", "held"]
    -- For this one the five seconds are waited that a process has to end.
    whenFull $ do
      (_, out', _) <- adder ["--json", "--fail-fast"] ["stays"]
      map snd (outcomes out') `shouldBe` ["skipped", "held", "errored", "skipped"]
  it "are written for build servers as XML" $
    inFolder $ \folder -> do
      let file = folder </> "report.xml"
      _ <- adder ["--junit", file] ["garbage"]
      counts <- readProcess "python3" ["-c", countCases, file] ""
      counts `shouldBe` "[4, 0, 1, 0]\n"
      _ <- adder ["--junit", file, "--skip", "field/addition-as-defined"] ["none"]
      counts' <- readProcess "python3" ["-c", countCases, file] ""
      counts' `shouldBe` "[4, 0, 0, 1]\n"
  where
    -- What the root and the suites state is what there is in them.
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
  it "is all that is needed to try the case again" $ do
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
  it "that is none is said to be" $ do
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
  it "end it whenever they come, as they end any program" $
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
  it "that are ignored when it starts stay so" $ do
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
limitSpec = describe "the time for all of it" $
  it "holds before the first reply, too" $
    for_ [[], ["--one-shot"], ["--parallel", "3"]] $ \how -> do
      begun <- getMonotonicTime
      outcome <-
        praAlone
          ( words ("conform --timeout 60 --limit " ++ byEffort "0.2" "0.5")
              ++ (["--profile", paperFile] ++ how ++ words "-- sleep 90")
          )
      ended <- getMonotonicTime
      outcome `refuses` "the time of --limit was over"
      -- Long enough for a busy machine, and half of what it would wait for a reply.
      ended - begun `shouldSatisfy` (< 30)

-- | What commands alone show.
usageSpec :: Spec
usageSpec = describe "usage" $ do
  it "a command that cannot be started, or never answers" $ do
    conforming ["--", "./no-such-subject"] `complains` "there is no such program"
    conforming ["--", "README.md"] `complains` "there is no such program"
    conforming ["--", "./README.md"] `complains` "it is no program that may be run"
    conforming ["--", "true"] `complains` "never answered start: crashed"
    conforming ["--one-shot", "--", "true"] `complains` "never answered start: crashed"
    conforming ["--timeout", "0.2", "--", "sleep", "60"] `complains` "never answered start: timeout"
    conforming ["--timeout", "0.2", "--", "sleep", "60"] `complains` "flush its standard output"
  it "a mistake that a fresh process makes too does not depend on what was asked before" $
    for_ [[], ["--one-shot"]] $ \how -> do
      (status, out, _) <-
        inOrder
          (["--cases", byEffort "4" "20"] ++ how)
          (words "pra-tactile serve --impostor reduces-by-another-modulus" ++ how)
      (status, lookup "field/in-any-order" (outcomes out))
        `shouldSatisfy` (`elem` [(0, Just "held"), (1, Just "skipped")])
  it "but one that comes after a refusal alone does" $ do
    (status, out, _) <-
      inOrder
        ["--cases", "20"]
        [ "sh",
          "-c",
          "pra-tactile serve | sed -u '/\"refused\"/{n;s/\"result\":\\([0-9]\\)/\"result\":1\\1/}'"
        ]
    (status, lookup "field/in-any-order" (outcomes out)) `shouldBe` (1, Just "failed")
  it "no command, and names of no law" $ do
    conforming [] `complains` "name the command"
    conforming ["--run", "no-such-law", "--", "true"]
      `complains` "no law is called \"no-such-law\""
    conforming ["--cases", "0", "--", "true"] `complains` "--cases is a number from 1 up"
    inFolder $ \folder -> do
      writeFile (folder </> "known") "field/no-such-law\n"
      conforming ["--known-failures", folder </> "known", "--", "true"]
        `complains` "no law is called \"field/no-such-law\""
  it "a profile of an array that is too large for the definition" $
    inFolder $ \folder -> do
      (_, profile, _) <- pra (words "profile --q 2 --shape 4095x4097 --polynomial" ++ [pentanomial])
      writeFile (folder </> "large.json") profile
      ["conform", "--profile", folder </> "large.json", "--", "true"]
        `complains` "large: this profile's array has more than 2^20 cells"
  it "the laws are listed, each once" $ do
    (status, out, _) <- pra (conforming ["--list", "--stage", "field"])
    status `shouldBe` 0
    length (filter (isInfixOf "field/addition-commutes") (lines out)) `shouldBe` 1
  where
    conforming options = "conform" : "--profile" : paperFile : options
    inOrder how =
      conform (words "--json --run field/in-any-order --profile" ++ paperFile : how)
    -- x^24 + x^7 + x^2 + x + 1
    pentanomial = intercalate "," (words "1 1 1 0 0 0 0 1" ++ replicate 16 "0" ++ ["1"])
