{-# LANGUAGE OverloadedStrings #-}

-- | Runs of the program: hostile files and standard inputs for each command that reads any, and
-- hostile arguments.
module Test.Hostile.Processes
  ( readExample,
    hostileRun,
    harmlessRun,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Bytes8
import Data.List (isInfixOf, isPrefixOf, sort)
import System.Directory (listDirectory)
import System.FilePath ((</>))
import Test.Hostile.Arguments
import Test.Hostile.Mutation
import Test.Hostile.Parsers
import Test.Hostile.Runs
import Test.QuickCheck

-- | The files beside the hostile one: the worked example's composite, and some of its frames with
-- their manifest.
readExample :: IO [(FilePath, ByteString)]
readExample = do
  names <- take 6 . sort . filter (/= "manifest.csv") <$> listDirectory (example </> "frames")
  table <- Bytes8.lines <$> Bytes.readFile (example </> "frames" </> "manifest.csv")
  let kept = [line | line <- table, any (`Bytes.isPrefixOf` line) ("file," : map Bytes8.pack names)]
  images <- traverse (Bytes.readFile . (example </>)) (composite : map ("frames" </>) names)
  pure $
    ("frames" </> "manifest.csv", Bytes8.unlines kept) :
    zip (composite : map ("frames" </>) names) images
  where
    example = "data" </> "worked-example"
    composite = "composite.pgm"

-- | A run on a hostile input of a kind that commands read; it is the standard input, too.
hostileRun :: Kind -> [(FilePath, ByteString)] -> [ByteString] -> Gen Run
hostileRun kind files specimens = do
  bytes <- specimenOf specimens <$> hostile (length specimens)
  command <- elements (kindRuns kind)
  let others = filter ((/= kindFile kind) . fst) files
  pure (Run (words command) bytes ((kindFile kind, bytes) : others))

-- | A run with arguments that can neither do harm nor ask for long work: files are named within the
-- folder, and amounts of work and of memory are left as they are or small.
harmlessRun :: [(FilePath, ByteString)] -> Gen Run
harmlessRun example = run <$> (argumentList value quick `suchThat` all harmlessOne)
  where
    run arguments = Run arguments "3 2 / 3 1\n" example
    quick =
      [ command
          { commandOptions = filter ((`notElem` laborious) . optionName) (commandOptions command)
          }
        | command <- commandsOfHelp,
          commandName command `notElem` ["train", "evaluate", "rates", "experiment", "images"]
      ]
    laborious =
      words "--presses --trials --length --degree --count --cases --design --size --window --shape"
        ++ words "--rows --columns --radius"
    value called
      | any (`isPrefixOf` called) ["FILE", "FOLDER", "PATH"] =
        elements (words "composite.pgm frames nothing out out.svg out.pgm - new/er")
      | otherwise = valueFor called
    harmlessOne argument =
      not (".." `isInfixOf` argument) && take 1 argument /= "/" && not ("=/" `isInfixOf` argument)
        && '\0' `notElem` argument
        && length argument < 50000
