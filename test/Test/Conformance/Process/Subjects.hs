{-# LANGUAGE OverloadedStrings #-}

-- | Running @conform@ on the small subjects in @test/subjects@, and reading its report.
module Test.Conformance.Process.Subjects
  ( -- * Running
    conform,
    adder,
    once,
    paperFile,

    -- * Reading reports
    outcomes,
    faults,
    tokens,
    reported,
  )
where

import Control.Monad (filterM)
import Data.Aeson
import qualified Data.Aeson.KeyMap as KeyMap
import qualified Data.ByteString as Bytes
import Data.Foldable (toList)
import qualified Data.Text as Text
import System.Directory (findExecutables)
import System.IO (IOMode (..), withBinaryFile)
import Test.CommandLine.Run

-- | @conform@ with these options on this command.
conform :: [String] -> [String] -> IO Outcome
conform options subject = praAlone ("conform" : options ++ "--" : subject)

-- | @conform@ on a subject that adds, with a fault, in a session, under the paper's profile; only
-- what concerns it is tried.
adder :: [String] -> [String] -> IO Outcome
adder options arguments =
  python ("test/subjects/faulty.py" : arguments)
    >>= conform (words tried ++ "--profile" : paperFile : options)
  where
    tried = "--run field/addition-as-defined --run protocol/none-in-force --run protocol/ends-*"

-- | The same with a process a request.
once :: [String] -> [String] -> IO Outcome
once options arguments =
  python ("test/subjects/once.py" : arguments)
    >>= conform
      (words "--one-shot --run field/addition-as-defined --profile" ++ paperFile : options)

-- | The command that runs this in Python: the interpreter itself, as what is called python3 may be
-- a script that takes longer than the interpreter to start.
python :: [String] -> IO [String]
python arguments = do
  found <- findExecutables "python3" >>= filterM (fmap (/= "#!") . beginning)
  pure (take 1 (found ++ ["python3"]) ++ "-S" : arguments)
  where
    beginning file = withBinaryFile file ReadMode (`Bytes.hGet` 2)

-- | The paper's profile. Where no profile is named, the definition prepares all default ones first,
-- which takes most of a second.
paperFile :: FilePath
paperFile = "examples/adapter/paper.json"

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
