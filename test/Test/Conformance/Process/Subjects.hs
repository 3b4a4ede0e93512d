{-# LANGUAGE OverloadedStrings #-}

-- | Running @conform@ on the small subjects in @test/subjects@, and reading its report.
module Test.Conformance.Process.Subjects
  ( -- * Running
    conform,
    adder,
    once,
    withProfile,

    -- * Reading reports
    outcomes,
    faults,
    tokens,
    reported,
  )
where

import Data.Aeson
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Foldable (toList)
import qualified Data.Text as Text
import System.FilePath ((</>))
import System.Process (readProcess)
import Test.CommandLine.Run
import Test.Support (inFolder)

-- | @conform@ with these options on this command.
conform :: [String] -> [String] -> IO Outcome
conform options subject = praAlone ("conform" : options ++ "--" : subject)

-- | @conform@ on a subject that adds, with a fault, in a session, under the paper's profile; only
-- what concerns it is tried.
adder :: [String] -> [String] -> IO Outcome
adder options arguments =
  withProfile $ \profile ->
    python ("test/subjects/faulty.py" : arguments)
      >>= conform
        (words tried ++ "--profile" : profile : options)
  where
    tried = "--run field/addition-as-defined --run protocol/none-in-force --run protocol/ends-*"

-- | The same with a process a request.
once :: [String] -> [String] -> IO Outcome
once options arguments =
  withProfile $ \profile ->
    python ("test/subjects/once.py" : arguments)
      >>= conform
        (words "--one-shot --run field/addition-as-defined --profile" ++ profile : options)

-- | The command that runs this in Python: the interpreter itself, as what is called python3 may be
-- a script that takes longer than the interpreter to start.
python :: [String] -> IO [String]
python arguments = do
  found <- readProcess "python3" ["-c", "import sys; print(sys.executable)"] ""
  pure (takeWhile (/= '\n') found : "-S" : arguments)

-- | With a file that has the paper's profile.
withProfile :: (FilePath -> IO a) -> IO a
withProfile use = inFolder $ \folder -> do
  (_, profile, _) <- praAlone ["profile"]
  writeFile (folder </> "paper.json") profile
  use (folder </> "paper.json")

-- | The laws of a report with their outcomes.
outcomes :: String -> [(String, String)]
outcomes report = concat [zip (textAt ["law"] law) (textAt ["outcome"] law) | law <- lawsIn report]

-- | The names of the faults in a report.
faults :: String -> [String]
faults = concatMap (textAt ["counterexample", "got", "fault"]) . lawsIn

-- | The tokens in a report.
tokens :: String -> [String]
tokens = concatMap (textAt ["counterexample", "token"]) . lawsIn

-- | What a report has under a key.
reported :: Key -> String -> Maybe Value
reported name = key [name]

lawsIn :: String -> [Object]
lawsIn report = case reported "laws" report of
  Just (Array laws) -> [law | Object law <- toList laws]
  _ -> []

textAt :: [Key] -> Object -> [String]
textAt path object' = case path of
  [] -> []
  [name] -> [Text.unpack text | Just (String text) <- [KeyMap.lookup name object']]
  name : others ->
    concat [textAt others inner | Just (Object inner) <- [KeyMap.lookup name object']]
