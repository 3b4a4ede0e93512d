{-# LANGUAGE OverloadedStrings #-}

-- | What the program is run on: hostile files and standard inputs for each command that reads any,
-- and hostile arguments.
module Test.Hostile.Processes
  ( Examples,
    readExamples,
    RunKind (..),
    runKinds,
    hostileRun,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Bytes8
import Data.List (isInfixOf, isPrefixOf, sort)
import System.Directory (listDirectory)
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import System.Process (readProcess)
import Test.Hostile.Arguments
import Test.Hostile.Mutation
import Test.Hostile.Runs
import Test.Hostile.Specimens
import Test.QuickCheck

-- | What valid inputs are made of that the library does not make here: the worked example's
-- composite and some of its frames with their manifest, and a database.
data Examples = Examples
  { composite :: ByteString,
    manifest :: ByteString,
    frames :: [(FilePath, ByteString)],
    database :: ByteString
  }

readExamples :: IO Examples
readExamples = do
  names <- take 6 . sort . filter (/= "manifest.csv") <$> listDirectory (example </> "frames")
  Examples
    <$> Bytes.readFile (example </> "composite.pgm")
    <*> (listed names . Bytes8.lines <$> Bytes.readFile (example </> "frames" </> "manifest.csv"))
    <*> traverse
      (\name -> (,) ("frames" </> name) <$> Bytes.readFile (example </> "frames" </> name))
      names
    <*> withSystemTempDirectory
      "pra-tactile"
      ( \folder -> do
          let file = folder </> "mapping.sqlite"
          _ <- readProcess "pra-tactile" ["objects", "--write", file] ""
          Bytes.readFile file
      )
  where
    example = "data" </> "worked-example"
    listed names =
      Bytes8.unlines
        . filter (\line -> any (`Bytes.isPrefixOf` line) ("file," : map Bytes8.pack names))

-- | A kind of run: what it is called, what share of all it gets, in thousandths, valid inputs, and
-- what is run on one that is not.
data RunKind = RunKind
  { runKindName :: String,
    runKindShare :: Int,
    runKindSpecimens :: Examples -> [ByteString],
    runKindOn :: Examples -> ByteString -> Gen Run
  }

runKinds :: [RunKind]
runKinds =
  [ RunKind "PGM files" 120 (\e -> composite e : pgms) $
      onFile
        [ "decode input",
          "decode --json input",
          "decode --json -",
          "decode input --picture out.svg",
          "decode --together input input --at 0,0 --at 76.2,0 --json"
        ],
    RunKind "frames" 60 (\e -> manifest e : map snd (take 1 (frames e))) onFrames,
    RunKind "certificates" 100 (const certificates) $ \e bytes ->
      oneof [onFile ["check input", "check --json input"] e bytes, onInput ["check -"] bytes],
    RunKind "arrays as CSV" 80 (const grids) $
      onFile
        [ "prove input --window 2x2",
          "prove input --mask ##./.## --json",
          "prove input --window 1x2 --surface sheet --q 4"
        ],
    RunKind "census files" 100 (const (censuses ++ shards)) $
      onFile
        [ "merge input",
          "merge input input",
          "merge input --output out.csv --json",
          "census --q 2 --degree 4 --output input"
        ],
    RunKind "profiles" 100 (const profiles) $
      onFile
        [ "array --profile input",
          "locate --profile input 1",
          "sequence --profile input --length 9",
          "profile --profile input",
          "objects --profile input"
        ],
    RunKind "networks" 40 (const networks) (onFile ["decode --network input composite.pgm"]),
    RunKind "databases" 60 (pure . database) $
      onFile
        [ "objects --database input",
          "objects --database input --at 6,5",
          "decode --json composite.pgm --database input"
        ],
    RunKind
      "patches"
      100
      (const patches)
      (const (onInput ["locate --batch", "locate --batch --explain --orientation any"])),
    RunKind "symbols" 60 (const ["0 0 1 0 1 1 1", "3 2 1 0 A A^2\n1,1,1"]) $
      const (onInput ["synthesise --q 4", "synthesise --q 2 --json"]),
    RunKind "arguments" 180 (const []) (\e _ -> harmless e)
  ]
  where
    onFile commands e bytes =
      on [("input", bytes), ("composite.pgm", composite e)] bytes <$> elements commands
    onInput commands bytes = on [] bytes <$> elements commands
    on files bytes command = Run (words command) bytes files

-- | A folder of frames, whose manifest or one of whose frames is hostile.
onFrames :: Examples -> ByteString -> Gen Run
onFrames e bytes = do
  arguments <-
    elements
      [["decode", "frames"], words "stitch frames --output out.pgm", "decode" : "--json" : one]
  spoilt <- elements (("frames" </> "manifest.csv") : one)
  pure
    ( Run
        arguments
        ""
        [(name, if name == spoilt then bytes else content) | (name, content) <- files]
    )
  where
    files = ("frames" </> "manifest.csv", manifest e) : frames e
    one = map fst (take 1 (frames e))

-- | A hostile input of a kind.
hostileRun :: Examples -> RunKind -> Gen Run
hostileRun e kind = case runKindSpecimens kind e of
  [] -> runKindOn kind e ""
  specimens -> hostile (length specimens) >>= runKindOn kind e . specimenOf specimens

-- | Arguments that cannot do any harm, nor ask for long work in good faith: files are named within
-- the folder, and amounts of work and of memory are left as they are or small.
harmless :: Examples -> Gen Run
harmless e = run <$> (argumentList value quick `suchThat` all harmlessOne)
  where
    run arguments =
      Run arguments "3 2 / 3 1\n" [("input", composite e), ("composite.pgm", composite e)]
    quick =
      [ command
          { commandOptions = filter ((`notElem` laborious) . optionName) (commandOptions command)
          }
        | command <- commandsOfHelp,
          commandName command `notElem` ["train", "evaluate", "rates", "experiment", "images"]
      ]
    laborious =
      [ "--presses",
        "--trials",
        "--length",
        "--degree",
        "--count",
        "--cases",
        "--design",
        "--size",
        "--window",
        "--shape",
        "--rows",
        "--columns",
        "--radius"
      ]
    value called
      | any (`isPrefixOf` called) ["FILE", "FOLDER", "PATH"] = elements files
      | otherwise = valueFor called
    files = words "input composite.pgm nothing out out.svg out.pgm - new/er"
    harmlessOne argument =
      not (".." `isInfixOf` argument) && take 1 argument /= "/" && not ("=/" `isInfixOf` argument)
        && '\0' `notElem` argument
        && length argument < 50000
