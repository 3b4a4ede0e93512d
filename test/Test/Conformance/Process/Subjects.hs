{-# LANGUAGE OverloadedStrings #-}

-- | Runs @conform@ on the small subjects in @test/subjects@ and reads its report.
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

-- | Runs @conform@ with these options on this command.
conform :: [String] -> [String] -> IO Outcome
conform options subject = praAlone ("conform" : options ++ "--" : subject)

-- | Runs @conform@ in a session on an adder with this fault, under the paper's profile. It tries
-- only the laws that concern adding.
adder :: [String] -> [String] -> IO Outcome
adder options arguments =
  python ("test/subjects/faulty.py" : arguments)
    >>= conform (words tried ++ "--profile" : paperFile : options)
  where
    tried = "--run field/addition-as-defined --run protocol/none-in-force --run protocol/ends-*"

-- | Runs @conform@ with a process per request on an adder with this fault.
once :: [String] -> [String] -> IO Outcome
once options arguments =
  python ("test/subjects/once.py" : arguments)
    >>= conform
      (words "--one-shot --run field/addition-as-defined --profile" ++ paperFile : options)

-- | The command of a subject in Python. It names the interpreter itself, because what is called
-- python3 may be a script that starts more slowly.
python :: [String] -> IO [String]
python arguments = do
  found <- findExecutables "python3" >>= filterM (fmap (/= "#!") . beginning)
  pure (take 1 (found ++ ["python3"]) ++ "-S" : arguments)
  where
    beginning file = withBinaryFile file ReadMode (`Bytes.hGet` 2)

-- | The paper's profile. Without a profile the definition first prepares all default ones, which
-- takes most of a second.
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

-- | The value of a key in a report.
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
