{-# LANGUAGE OverloadedStrings #-}

-- | Tests processes and their pipes on small shell scripts: what is read of their output, how their
-- end is described, and which of several waiting questions is at fault.
module Test.Conformance.Process.Output (spec, aloneSpec) where

import Control.Concurrent (threadDelay)
import Control.Exception (IOException, bracket, try)
import Control.Monad (forM_, replicateM, replicateM_)
import Data.Aeson (Value (..), toJSON)
import qualified Data.ByteString.Char8 as Bytes
import GHC.Clock (getMonotonicTime)
import PraTactile.Conformance.Operations (allOperations)
import PraTactile.Conformance.Process
import PraTactile.Conformance.Process.Await
import PraTactile.Conformance.Process.Child
import PraTactile.Conformance.Process.Lines
import PraTactile.Conformance.Process.OneShot
import PraTactile.Conformance.Question
import PraTactile.Conformance.Subject
import PraTactile.Conformance.Wire.Line (longestLine)
import PraTactile.Profile (Profile (..), canonicalProfile)
import System.Directory (listDirectory)
import System.Exit (ExitCode (..))
import System.FilePath ((</>))
import System.Timeout (timeout)
import Test.Effort
import Test.Hspec
import Test.Support (inFolder)

spec :: Spec
spec = do
  describe "a session" sessionSpec
  describe "one process per request" oneShotSpec
  describe "what a process writes" outputSpec

sessionSpec :: Spec
sessionSpec = do
  it "a session takes its name, its operations and its batch size from the reply to start" $
    forM_ [(1, 64), (8, 64), (9, 72), (128, 1024), (5000, 1024)] $ \(flight, batch) -> do
      said <- session (adding flight "") $ \subject ->
        pure
          ( (subjectName subject, subjectBatch subject),
            (subjectOffers subject, subjectUnknown subject)
          )
      said `shouldBe` Right (("shell", batch), ([SomeOp Add, SomeOp Term], ["fly", "sit"]))
  it "the question that ends the process is at fault, however many wait for replies" $
    forM_ [(flight, bad) | flight <- [1, 3, 8], bad <- [0, 2, 5]] $ \(flight, bad) -> do
      came <- session (adding flight (onceAsked bad "exit 3")) (`asked` map adds [0 .. 5])
      ((flight, bad), came)
        `shouldBe` ((flight, bad), Right (map sumOf [0 .. bad - 1] ++ [Left ended]))
  it "a first fault is reported for a single question; of several, each is asked alone again" $
    forM_ [(flight, count) | flight <- [1, 4], count <- [1, 2, 4]] $ \(flight, count) ->
      forM_ ["exit 4", "true"] $ \later ->
        inFolder $ \folder -> do
          let flag = folder </> "flag"
              first = "if [ -e " ++ flag ++ " ]; then " ++ later ++ "; else " ++ begun ++ "; fi"
              begun = ": > " ++ flag ++ "; exit 3"
              status = if later == "exit 4" && flight > 1 && count > 1 then "4" else "3"
          came <- session (adding flight (onceAsked 0 first)) (`asked` map adds [0 .. count - 1])
          ((flight, count), came)
            `shouldBe` ( (flight, count),
                         Right [Left ended {faultDetail = "it ended, with status " ++ status}]
                       )
  it "after a fault the last profile is put in force again, unless it was refused" $
    forM_ [([], False), ([1], True), ([0], False), ([1, 0], False), ([0, 1], True)] $
      \(profiles, inForce) -> do
        came <- session (adding 1 (onceAsked 3 "exit 3")) $ \subject -> do
          put <- mapM (subjectProfile subject . profileOf) profiles
          first <- subjectAsk subject [adds 1]
          _ <- subjectAsk subject [adds 3]
          then' <- subjectAsk subject [adds 1]
          pure (put, first, then')
        let sum' = [if inForce then sumOf 1 else Right (ResponseErrored "no profile")]
            put =
              [ Right (if i == 1 then ResponseResult (Bool True) else ResponseRefused "no")
                | i <- profiles
              ]
        (profiles, came) `shouldBe` (profiles, Right (put, sum', sum'))
  it "1002 surplus lines count as output without end, and 1001 do not" $
    forM_
      [ ("x", NotJson),
        ("{}", NotAReply),
        ("{\"sequence\":9,\"result\":0}", OutOfOrder),
        ("{\"sequence\":1,\"result\":0}", AnsweredTwice)
      ]
      $ \(line, kind) ->
        forM_ ((,) <$> [1, 3] <*> [1001, 1002 :: Int]) $ \(flight, more) -> do
          let say = floodOf line more
          came <- session (adding flight (onceAsked 1 say)) (`asked` map adds [0, 1])
          ((line, flight, more), map (either faultKind (const TooSlow)) . drop 1 <$> came)
            `shouldBe` ((line, flight, more), Right [if more < 1002 then kind else EndlessOutput])
  it "1002 lines in place of the reply to start or to a profile are output without end, too" $
    forM_ [(1001, NotJson), (1002, EndlessOutput)] $ \(more, kind) -> do
      start <- session (shell (floodOf "x" more)) (const (pure ()))
      either faultKind (const TooSlow) start `shouldBe` kind
      put <-
        session (instead 1 ("*'\"profile\"'*) " ++ floodOf "x" more ++ " ;;") "") $ \subject ->
          subjectProfile subject canonicalProfile
      fmap (either faultKind (const TooSlow)) put `shouldBe` Right kind
  it "a batch has as many questions as the process takes; if it ends, each is asked alone" $
    forM_ [2, 4] $ \flight -> inFolder $ \folder -> do
      let flag = folder </> "flag"
          others = concat (replicate (flight - 1) "read -r line; ")
          first =
            "if [ -e " ++ flag ++ " ]; then " ++ onceAsked (flight - 1) "exit 4"
              ++ ("; else : > " ++ flag ++ "; " ++ others ++ "exit 3; fi")
      came <- session (adding flight first) (`asked` map adds [0 .. flight + 1])
      came
        `shouldBe` Right
          (map sumOf [0 .. flight - 2] ++ [Left ended {faultDetail = "it ended, with status 4"}])
  it "requests are numbered from 1, however many are asked together" $ do
    came <- session (adding 3 "a=$n") $ \subject -> do
      _ <- subjectProfile subject canonicalProfile
      mapM (subjectAsk subject . map adds) [[9, 9], [9], [], [9, 9, 9, 9]]
    came `shouldBe` Right (map (map sumOf) [[1, 2], [3], [], [4 .. 7]])
  it "a reply must have the number of the first question without a reply" $
    forM_ ["-1", "0", "1", "2", "3", "none"] $ \number -> do
      let other =
            if number == "none"
              then "echo '{\"result\":3}'; exit"
              else "echo '{\"sequence\":" ++ number ++ ",\"result\":3}'; exit"
      came <- session (adding 1 (onceAsked 1 other)) (`asked` map adds [0, 1])
      fmap (map (either (Left . faultKind) Right)) came
        `shouldBe` Right
          [ Right (ResponseResult (toJSON (0 :: Int))),
            case number of
              "1" -> Left AnsweredTwice
              "2" -> Right (ResponseResult (toJSON (3 :: Int)))
              "none" -> Left NotAReply
              _ -> Left OutOfOrder
          ]
  where
    ended = Fault Crashed "it ended, with status 3"

oneShotSpec :: Spec
oneShotSpec = do
  it "a process offers what it does not skip" $ do
    offers <-
      offeredOneShot
        (Limits 20 60)
        ( shell . unwords $
            [ "read -r line; case $line in",
              "*'\"add\"'*|*'\"stitch\"'*) echo '{\"sequence\":1,\"skipped\":\"\"}' ;;",
              "*) echo '{\"sequence\":1,\"errored\":\"\"}' ;; esac"
            ]
        )
        canonicalProfile
    offers `shouldBe` Right [o | o <- allOperations, o `notElem` [SomeOp Add, SomeOp Stitch]]

  it "a process that ends at an operation offers it; one that cannot be started offers nothing" $ do
    let script =
          "read -r line; case $line in *'\"add\"'*) exit 5 ;; \
          \*'\"pack\"'*) echo '{\"sequence\":1,\"skipped\":\"\"}' ;; \
          \*) echo '{\"sequence\":1,\"result\":0}' ;; esac"
    offers <- offeredOneShot (Limits 20 60) (shell script) canonicalProfile
    offers `shouldBe` Right [o | o <- allOperations, o /= SomeOp Pack]
    none <- offeredOneShot (Limits 20 60) (Command "./no-such-program" []) canonicalProfile
    none `shouldBe` Left (Fault CannotStart "there is no such program")
  it "a request has a number that its only reply repeats; a second reply is a fault" $ do
    let numbered = "n=${line##*:}; n=${n%?}; "
        reply number =
          "echo \"{\\\"sequence\\\":" ++ number ++ ",\\\"result\\\":" ++ number ++ "}\""
        script more =
          shell . unwords $
            [ "read -r line; case $line in",
              "*sequence*) " ++ numbered ++ reply "$n" ++ more ++ " ;;",
              "*) echo '{\"result\":true}' ;; esac"
            ]
    came <- withProcess OneShot (Limits 20 60) (script "") $ \subject -> do
      put <- subjectProfile subject canonicalProfile
      (,,) (subjectName subject) put <$> subjectAsk subject (map adds [5, 6, 7])
    came `shouldBe` Right ("sh", Right (ResponseResult (Bool True)), map sumOf [1, 2, 3])
    forM_
      [ ("; " ++ reply "$n", AnsweredTwice),
        ("; echo x", NotAReply),
        ("; printf x", HalfLine),
        ("; exit 1", Crashed)
      ]
      $ \(more, kind) -> do
        one <- oneShot (Limits 20 60) (script more) canonicalProfile (Just (1, adds 1))
        either faultKind (const TooSlow) one `shouldBe` kind
    forM_ [(0, OutOfOrder), (1, TooSlow), (2, OutOfOrder)] $ \(number, kind) -> do
      let fixed = shell ("cat > /dev/null; " ++ sayFixed number)
      one <- oneShot (Limits 20 60) fixed canonicalProfile (Just (1, adds 1))
      either faultKind (const TooSlow) one `shouldBe` kind
  it "one limit covers the time from the request through the reply to the process's end" $
    forM_ [(20, "result"), (2 * second, faultName DoesNotStop)] $ \(patience, came) -> do
      let sleep = "sleep " ++ show (1.2 * second)
          slow = shell ("cat > /dev/null; " ++ sleep ++ "; " ++ sayFixed 1 ++ "; exec " ++ sleep)
      one <- oneShot (Limits patience 60) slow canonicalProfile (Just (1, adds 1))
      either (faultName . faultKind) (const "result") one `shouldBe` came
  where
    second = byEffort 0.6 1 :: Double
    sayFixed number = "echo '{\"sequence\":" ++ show (number :: Int) ++ ",\"result\":0}'"

-- | Tests what holds only while nothing else runs in this process.
aloneSpec :: Spec
aloneSpec =
  it "all pipes of a process are closed after it has ended" $ do
    let descriptors = length <$> listDirectory "/proc/self/fd"
    before' <- descriptors
    replicateM_ 9 (bracket (begin (Command "cat" [])) (mapM_ end) (const (pure ())))
    descriptors `shouldReturn` before'

outputSpec :: Spec
outputSpec = do
  it "all processes of a group are ended, whether their leader still runs or has ended" $
    forM_ ["wait", "exit"] $ \then' -> do
      started <- child ("sleep 600 & echo $!; " ++ then') $ \running -> do
        line <- getMonotonicTime >>= nextLine running . (+ 20)
        (status, named) <- case line of
          Line bytes | then' == "exit" -> (\code -> (code, bytes)) <$> waitExit running 1e9
          Line bytes -> pure (Nothing, bytes)
          _ -> fail "no line"
        pure (status, Bytes.unpack named)
      ends <- endsWithin 20 (snd started)
      (then', fst started, ends)
        `shouldBe` (then', if then' == "exit" then Just ExitSuccess else Nothing, True)
  it "output is read line by line, up to a mebibyte each" $
    forM_ [(0, 3), (1, 1), (32767, 2), (32768, 2), (longestLine - 1, 1), (longestLine, 1)] $
      \(size, count) -> do
        let one = "head -c " ++ show size ++ " /dev/zero | tr '\\0' a; echo; "
        found <- child (concat (replicate count one) ++ "printf end") $ \running -> do
          deadline <- (+ 20) <$> getMonotonicTime
          lines' <- replicateM (count + 1) (nextLine running deadline)
          pure (map said lines')
        let ls = replicate count ("line", size) ++ [("no more", 3)]
        (size, found) `shouldBe` (size, ls)
  describe "more than sixteen mebibytes are output without end, even in few lines" $
    forM_
      ( [ ("zeros without end", "cat /dev/zero", EndlessOutput),
          ("sixteen mebibytes", zeros longestFlood, NotJson),
          ("sixteen mebibytes and a byte", zeros (longestFlood + 1), EndlessOutput)
        ]
          -- These are read for two seconds.
          ++ byEffort [] [("a few bytes without end", fewWithoutEnd, NotJson)]
      )
      $ \(what, script, kind) -> it what $ do
        fault <- child script $ \running -> flooded running 1 (Fault NotJson "detail")
        let more = if kind == EndlessOutput then "more output than was asked for: " else ""
        fault `shouldBe` Fault kind (more ++ "detail")
  it "a fault after which nobody can read on is never output without end" $
    forM_ (filter (`notElem` [NotJson, NotAReply, OutOfOrder, AnsweredTwice]) [minBound ..]) $
      \kind ->
        child "cat /dev/zero" (\running -> flooded running 1 (Fault kind "detail"))
          `shouldReturn` Fault kind "detail"
  it "a line that is too long is shown by its first hundred bytes" $ do
    let text' = take 200 (cycle ['a' .. 'z'])
    found <- child ("printf '%s' " ++ text' ++ "; " ++ zeros (longestLine - 199)) $ \running -> do
      line <- getMonotonicTime >>= nextLine running . (+ 20)
      pure $ case line of
        Oversized bytes -> Just bytes
        _ -> Nothing
    found `shouldBe` Just (Bytes.pack (take 100 text'))
  it "a line of more than a mebibyte is too long, even if its end has been read" $
    forM_ [(longestLine, "line"), (longestLine + 1, "oversized")] $ \(size, what) ->
      inFolder $ \folder -> do
        let file = folder </> "line"
        Bytes.writeFile file (Bytes.replicate size 'a' <> "\n")
        found <- child ("cat " ++ file) $ \running ->
          getMonotonicTime >>= nextLine running . (+ 20)
        (size, fst (said found)) `shouldBe` (size, what)
  it "surplus output is counted in lines and bytes, up to a number of lines" $
    forM_ [1, 4, 5, 6, 100] $ \most -> do
      flood <- child "printf 'ab\\nc\\n\\n\\ndef\\ngh'" $ \running -> do
        _ <- waitExit running 1e9
        drain running 0.2 5 most
      (most, floodLines flood, floodBytes flood) `shouldBe` (most, 5, 13)
  it "surplus output is read for a limited time, even if it goes on" $ do
    read' <- child fewWithoutEnd (\running -> timeout 10000000 (drain running 20 0.3 5))
    floodLines <$> read' `shouldBe` Just 0
  describe "if no line comes in time, the report says what came instead" $
    forM_
      [ ( "a part of a line",
          "printf ab; sleep 20",
          Fault HalfLine "no end of the line within 0.5 seconds: ab"
        ),
        ("nothing", "sleep 20", Fault TimedOut "no reply within 0.5 seconds"),
        ( "a closed input",
          "exec <&-; sleep 20",
          Fault ClosedPipe "it closed its standard input and did not answer"
        ),
        ("an end within a line", "printf ab", Fault HalfLine "its output ends within a line: ab"),
        ("an end without a word", "exit 0", Fault Crashed "it ended, with status 0"),
        ("an end by a signal", "kill -9 $$", Fault Crashed "it was ended by signal 9"),
        ( "an end with a word",
          "echo sorry >&2; exit 2",
          Fault Crashed "it ended, with status 2; on its standard error: sorry"
        )
      ]
      $ \(what, script, fault) ->
        it what $ child script (`awaitLine` 0.5) `shouldReturn` Left fault
  it "a line of several mebibytes is reported as too long, though it ends" $ do
    let letters = "head -c " ++ show (3 * longestLine) ++ " /dev/zero | tr '\\0' a; echo"
    child letters (`awaitLine` 20)
      `shouldReturn` Left
        (Fault LineTooLong ("a line of more than 1 MiB: " ++ replicate 100 'a' ++ " ..."))
  it "a long line that goes on for sixteen mebibytes more is output without end, however slow" $
    forM_ [(0, LineTooLong), (longestFlood, EndlessOutput)] $ \(more, kind) -> do
      found <-
        child (zeros (longestLine + 1) ++ "; sleep 0.4; " ++ zeros (more + 1)) (`awaitLine` 20)
      (more, either faultKind (const TooSlow) found) `shouldBe` (more, kind)
  it "a line and an end are waited for only until the limit" $ do
    found <- child "printf ab; sleep 20" $ \running -> do
      now <- getMonotonicTime
      first <- nextLine running (now + 0.1)
      code <- waitExit running now
      pure (said first, code)
    found `shouldBe` (("unfinished", 2), Nothing)
  it "the last 4 KiB of standard error are kept" $
    forM_ [0, 1, 4095, 4096, 4097, 100000] $ \size -> do
      let written = take size (cycle ['a' .. 'z'])
      found <- child ("printf '%s' " ++ written ++ " >&2") $ \running -> do
        code <- waitExit running 1e9
        _ <- withErrors running (Fault Crashed "")
        (,) code <$> errorsTail running
      found `shouldBe` (Just ExitSuccess, Bytes.pack (drop (size - 4096) written))
  it "standard error that arrives soon after the end is reported, too" $ do
    found <- child "(sleep 0.05; printf late >&2) & exit 3" $ \running -> do
      code <- waitExit running 1e9
      (,) code . faultDetail <$> withErrors running (Fault Crashed "it")
    found `shouldBe` (Just (ExitFailure 3), "it; on its standard error: late")
    held <- child "(printf one; sleep 20) >&2 & exit 3" $ \running -> do
      _ <- waitExit running 1e9
      faultDetail <$> withErrors running (Fault Crashed "it")
    held `shouldBe` "it; on its standard error: one"
  it "a fault quotes the last 300 characters of standard error, without blanks at the end" $
    forM_
      [ ("", ""),
        (" \n", ""),
        ("x \n\n", "x"),
        (text 299, text 299),
        (text 300, text 300),
        (text 301, "... " ++ drop 1 (text 301)),
        (text 1000, "... " ++ drop 700 (text 1000))
      ]
      $ \(complaint, told) -> do
        came <- session (shell ("printf '%s' '" ++ complaint ++ "' >&2; exit 4")) (const (pure ()))
        came
          `shouldBe` Left
            ( Fault
                Crashed
                ( "it ended, with status 4"
                    ++ (if null told then "" else "; on its standard error: " ++ told)
                )
            )
  it "the end of a process is described in words" $ do
    map exitText [ExitSuccess, ExitFailure 1, ExitFailure 255, ExitFailure (-1), ExitFailure (-9)]
      `shouldBe` ["it ended, with status 0", "it ended, with status 1", "it ended, with status 255"]
        ++ ["it was ended by signal 1", "it was ended by signal 9"]
    map secondsText [0, 0.5, 1, 1.5, 2, 60]
      `shouldBe` ["0 seconds", "0.5 seconds", "1 second", "1.5 seconds", "2 seconds", "60 seconds"]
  where
    fewWithoutEnd = "while :; do printf x; sleep 0.05; done"
    text size = take size (cycle (['a' .. 'z'] ++ ['0' .. '9'] ++ ['A' .. 'Z']))
    said line = case line of
      Line bytes -> ("line" :: String, Bytes.length bytes)
      NoMore bytes -> ("no more", Bytes.length bytes)
      Unfinished bytes -> ("unfinished", Bytes.length bytes)
      Oversized bytes -> ("oversized", Bytes.length bytes)

-- | A subject that is a shell script.
session :: Command -> (Subject -> IO a) -> IO (Either Fault a)
session = withProcess InSession (Limits 20 60)

shell :: String -> Command
shell script = Command "sh" ["-c", script]

-- | A shell command that writes a line and this many more at once, so that a busy machine cannot
-- separate them.
floodOf :: String -> Int -> String
floodOf line more = "echo '" ++ line ++ concat (replicate more "\nx") ++ "'; exit"

-- | The answers to questions under a profile that was put in force.
asked :: Subject -> [SomeQuestion] -> IO [Either Fault Response]
asked subject questions = subjectProfile subject (profileOf 1) >> subjectAsk subject questions

-- | A profile that can be put in force; for 0 one that is refused.
profileOf :: Int -> Profile
profileOf i = if i == 0 then canonicalProfile {profileOrder = 6} else canonicalProfile

-- | Whether the process of this number ends, or is only to be waited for, within this many seconds.
endsWithin :: Double -> String -> IO Bool
endsWithin seconds number = getMonotonicTime >>= go . (+ seconds)
  where
    go deadline = do
      said' <- try (Bytes.readFile ("/proc/" ++ number ++ "/stat"))
      now <- getMonotonicTime
      case said' :: Either IOException Bytes.ByteString of
        Right stat | not (ended stat), now < deadline -> threadDelay 10000 >> go deadline
        Right stat -> pure (ended stat)
        Left _ -> pure True
    -- The state follows the name, which stands in parentheses.
    ended stat = Bytes.take 1 (Bytes.drop 1 (snd (Bytes.breakEnd (== ')') stat))) `elem` ["Z", "X"]

-- | A process that is a shell script.
child :: String -> (Child -> IO a) -> IO a
child script use =
  bracket (begin (shell script)) (mapM_ end) (either fail use)

-- | A subject that takes this many requests at once, answers @a + b@ with @a@, and first runs this
-- command.
adding :: Int -> String -> Command
adding flight = instead flight ""

-- | 'adding' with one more case of requests, tried before all others but the start.
instead :: Int -> String -> String -> Command
instead flight before' first =
  shell . unlines $
    [ "while read -r line; do",
      "  n=${line##*:}; n=${n%?}; a=${line#*\\\"a\\\":}; a=${a%%,*}",
      "  case $line in",
      "    *'\"start\"'*) echo '{\"protocol\":1,\"name\":\"shell\",\"in_flight\":" ++ show flight
        ++ ",\"operations\":[\"fly\",\"term\",\"add\",\"sit\"]}' ;;",
      before',
      "    *'\"q\":6'*) p=; echo '{\"refused\":\"no\"}' ;;",
      "    *'\"profile\"'*) p=1; echo '{\"result\":true}' ;;",
      "    *) " ++ first,
      "      [ -n \"$p\" ] ||",
      "        { echo \"{\\\"sequence\\\":$n,\\\"errored\\\":\\\"no profile\\\"}\"; continue; }",
      "      echo \"{\\\"sequence\\\":$n,\\\"result\\\":$a}\" ;;",
      "  esac",
      "done"
    ]

-- | A command that writes this many bytes of value zero.
zeros :: Int -> String
zeros count = "head -c " ++ show count ++ " /dev/zero"

-- | A shell command that runs this action on requests whose @a@ is this number.
onceAsked :: Int -> String -> String
onceAsked a action = "if [ $a = " ++ show a ++ " ]; then " ++ action ++ "; fi"

adds :: Int -> SomeQuestion
adds a = SomeQuestion (Add :? (fromIntegral a, 1))

sumOf :: Int -> Either Fault Response
sumOf = Right . ResponseResult . toJSON
