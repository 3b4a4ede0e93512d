{-# LANGUAGE OverloadedStrings #-}

-- | Where output goes, what is said of arguments and names, and what is read of a standard input
-- that is no text.
module Test.CommandLine.Output (spec) where

import Control.Concurrent (threadDelay)
import Control.Monad (when)
import Data.Aeson (Value (..))
import Data.Foldable (for_)
import Data.List (isInfixOf, sort)
import Documents.Transcript (readText)
import System.Directory
import System.Exit (ExitCode (..))
import System.FilePath ((</>))
import System.Posix.Files
import System.Posix.Signals
import System.Posix.User (getEffectiveUserID)
import System.Process
import Test.CommandLine.Arguments
import Test.CommandLine.Run
import Test.Effort
import Test.Hspec
import Test.Support

spec :: Spec
spec = do
  filesSpec
  standardOutputSpec
  databasesSpec
  foldersSpec
  argumentsSpec
  inputSpec

filesSpec :: Spec
filesSpec = describe "a file" $ do
  it "is replaced whole and keeps its mode; a new one has that of the system" $
    inFolder $ \folder -> do
      writeFile (folder </> "a.csv") (replicate 5000 'x')
      setFileMode (folder </> "a.csv") 0o640
      scripted
        folder
        "pra array --format csv --output a.csv; pra array --format csv > b.csv; cmp a.csv b.csv"
        `shouldReturn` (0, "", "")
      mode <- fileMode <$> getFileStatus (folder </> "a.csv")
      mode `intersectFileModes` 0o777 `shouldBe` 0o640
      listDirectory folder >>= (`shouldBe` ["a.csv", "b.csv"]) . sort
  it "behind a link is the one that is replaced, also where the link leads to nothing yet" $
    inFolder $ \folder -> do
      createDirectory (folder </> "there")
      writeFile (folder </> "there" </> "old") "old"
      createSymbolicLink "there/old" (folder </> "link")
      createSymbolicLink "there/new" (folder </> "dangling")
      scripted
        folder
        "pra array --output link; pra array --output dangling; pra array > direct; cmp direct \
        \there/old; cmp direct there/new"
        `shouldReturn` (0, "", "")
      both <- traverse (pathIsSymbolicLink . (folder </>)) ["link", "dangling"]
      both `shouldBe` [True, True]
  it "behind a cycle of links is refused" $
    inFolder $ \folder -> do
      createSymbolicLink "b" (folder </> "a")
      createSymbolicLink "a" (folder </> "b")
      outcome <- scripted folder "pra array --output a"
      outcome `refuses` "links"
  it "that is a FIFO is written to directly" $
    inFolder $ \folder -> do
      createNamedPipe (folder </> "pipe") 0o600
      (status, out, err) <- scripted folder "cat pipe & pra array --output pipe; wait"
      (_, expected, _) <- pra ["array"]
      (status, out, err) `shouldBe` (0, expected, "")
      isNamedPipe <$> getFileStatus (folder </> "pipe") `shouldReturn` True
  it "that is a device is written to directly, by every command" $
    asRoot $
      inFolder $ \folder -> do
        callProcess "mknod" [folder </> "null", "c", "1", "3"]
        callProcess "mknod" [folder </> "full", "c", "1", "7"]
        for_ writers $ \command -> do
          (status, _, err) <- pra (command (folder </> "null"))
          (command "null", status, err) `shouldBe` (command "null", 0, "")
          (isCharacterDevice <$> getFileStatus (folder </> "null")) `shouldReturn` True
          (status', _, err') <- pra (command (folder </> "full"))
          (command "full", status', length (lines err')) `shouldBe` (command "full", 2, 1)
          err' `shouldSatisfy` ("no space left on device" `isInfixOf`)
          (isCharacterDevice <$> getFileStatus (folder </> "full")) `shouldReturn` True
  it "called - is the standard output, which then holds nothing else" $
    inFolder $ \folder -> do
      for_ textWriters $ \command -> do
        let file = folder </> "file"
        (status, _, err) <- pra (command file)
        written <- readText file
        (command "file", status, err, null written) `shouldBe` (command "file", 0, "", False)
        outcome <- pra (command "-")
        (command "-", outcome) `shouldBe` (command "-", (0, written, ""))
        removeFile file
      -- What is no text is compared outside of this process.
      let binary to = unwords ("pra" : binaryWriter to)
      scripted
        folder
        ( binary "- > stdout && " ++ binary "file > said && "
            ++ "cmp file stdout && test -s file"
        )
        `shouldReturn` (0, "", "")
  it "that may not be written is refused and not changed" $
    unlessRoot $
      inFolder $ \folder -> do
        writeFile (folder </> "mine") "mine"
        setFileMode (folder </> "mine") 0o400
        outcome <- scripted folder "pra array --output mine"
        outcome `refuses` "no permission to write mine"
        readFile (folder </> "mine") `shouldReturn` "mine"
  it "that does not fit on the disk is one line, and nothing is left or changed" $
    inFolder $ \folder -> do
      writeFile (folder </> "old") "old"
      outcome <- scripted folder "trap '' XFSZ; ulimit -f 1; pra table --output old"
      outcome `refuses` "cannot write old: file too large"
      listDirectory folder `shouldReturn` ["old"]
      readFile (folder </> "old") `shouldReturn` "old"
      composite <- makeAbsolute "data/worked-example/composite.pgm"
      picture <-
        scripted folder $
          "trap '' XFSZ; ulimit -f 16; pra decode " ++ composite ++ " --picture a.svg > /dev/null"
      picture `refuses` "cannot write a.svg: file too large"
      listDirectory folder `shouldReturn` ["old"]
      store <- scripted folder "trap '' XFSZ; ulimit -f 8; pra objects --write a.sqlite"
      store `refuses` "cannot write a.sqlite: "
      listDirectory folder `shouldReturn` ["old"]
  it "that a killed run left behind is called NAME.part, and the next run uses it up" $
    inFolder $ \folder -> do
      _ <- scripted folder "ulimit -f 1; pra table --output new"
      listDirectory folder `shouldReturn` ["new.part"]
      scripted folder "pra table --output new; pra table | cmp - new" `shouldReturn` (0, "", "")
      listDirectory folder `shouldReturn` ["new"]
  it "whose NAME.part is something else is refused" $
    inFolder $ \folder -> do
      createSymbolicLink "precious" (folder </> "new.part")
      writeFile (folder </> "precious") "precious"
      outcome <- scripted folder "pra array --output new"
      outcome `refuses` "new.part is in the way"
      readFile (folder </> "precious") `shouldReturn` "precious"

-- | Commands that write a file of this name, quickly.
writers :: [FilePath -> [String]]
writers = binaryWriter : textWriters

binaryWriter :: FilePath -> [String]
binaryWriter file = words "array --format pgm --output" ++ [file]

textWriters :: [FilePath -> [String]]
textWriters =
  [ \file -> words command ++ ["--output", file]
    | command <-
        [ "array",
          "table",
          "certificate",
          "certificate --json",
          "shapes --svg",
          "shapes",
          "census --q 2 --degree 3",
          "census --q 2 --degree 3 --json"
        ]
  ]

asRoot, unlessRoot :: Expectation -> Expectation
asRoot check = getEffectiveUserID >>= \user -> when (user == 0) check
unlessRoot check = getEffectiveUserID >>= \user -> when (user /= 0) check

standardOutputSpec :: Spec
standardOutputSpec = describe "the standard output" $ do
  it "that is full is one line and status 2, by every command" $
    inFolder $ \folder ->
      for_ printers $ \command -> do
        (status, _, err) <- scripted folder ("pra " ++ command ++ " > /dev/full")
        (command, status, lines err)
          `shouldBe` ( command,
                       2,
                       ["pra-tactile: cannot write the standard output: no space left on device"]
                     )
  it "that is closed is one line and status 2, by every command; nothing hangs" $
    inFolder $ \folder ->
      for_ printers $ \command -> do
        (status, _, err) <- scripted folder ("pra " ++ command ++ " >&-")
        (command, status, lines err)
          `shouldBe` ( command,
                       2,
                       ["pra-tactile: cannot write the standard output: bad file descriptor"]
                     )
  it "that nobody reads to the end ends the program quietly, as it does cat" $
    inFolder $ \folder -> do
      (_, out, err) <- scripted folder "pra sequence --length 10000000 | head -c 7"
      (out, err) `shouldBe` ("0 0 0 1", "")
  it "is answered where the standard error is closed, and the status is the same" $
    inFolder $ \folder -> do
      (status, out, err) <- scripted folder "pra locate '3 2 / 3 1' 2>&-"
      (status, take 1 (lines out), err) `shouldBe` (0, ["row 6, column 5"], "")
      (status', _, _) <- scripted folder "pra locate '3 2 / 3' 2>&-"
      status' `shouldBe` 2
      (status'', _, _) <- scripted folder "pra locate '3 2 / 3' 2>/dev/full"
      status'' `shouldBe` 2
  it "is what it is where the standard input is closed, which is then empty" $
    inFolder $ \folder -> do
      scripted folder "pra locate --batch <&-" `shouldReturn` (0, "", "")
      outcome <- scripted folder "pra synthesise --q 4 <&-"
      outcome `refuses` "no symbols"
      scripted folder "pra sequence --length 3 <&- 2>&-" `shouldReturn` (0, "0 0 0\n", "")
  where
    -- Lines, one line of JSON, what is printed as it is made, and what no command prints.
    printers =
      ["array", "prove --json", "sequence", "--help"]
        ++ byEffort
          []
          [ "array --format json",
            "prove",
            "table",
            "field --q 4",
            "shapes",
            "objects",
            "profile",
            "certificate",
            "polynomials --q 4 --degree 4",
            "advise --rows 10 --columns 10 --q 4",
            "--version",
            "locate --help"
          ]

databasesSpec :: Spec
databasesSpec = describe "a database" $ do
  it "is no stream, and is not written and asked at once" $
    inFolder $ \folder -> do
      streamed <- scripted folder "pra objects --write -"
      streamed `refuses` "standard output"
      both <- scripted folder "pra objects --write a.sqlite --database b.sqlite"
      both `refuses` "--database"
      listDirectory folder `shouldReturn` []
  it "that was written is told as JSON where that is asked for" $
    inFolder $ \folder -> do
      (status, out, _) <- scripted folder "pra objects --write a.sqlite --json"
      (status, key ["file"] out) `shouldBe` (0, Just (String "a.sqlite"))

foldersSpec :: Spec
foldersSpec = describe "a folder of frames" $ do
  it "is new or empty, also behind a link; anything else is refused and left as it is" $
    inFolder $ \folder -> do
      createDirectory (folder </> "empty")
      createDirectory (folder </> "empty2")
      createSymbolicLink "empty2" (folder </> "link")
      for_ (words "new deep/er empty link") $ \name -> do
        (status, _, err) <- pressing (folder </> name)
        (name, status, err) `shouldBe` (name, 0, "")
        there <- doesFileExist (folder </> name </> "manifest.csv")
        (name, there) `shouldBe` (name, True)
      pathIsSymbolicLink (folder </> "link") `shouldReturn` True
      writeFile (folder </> "file") "file"
      createNamedPipe (folder </> "pipe") 0o600
      createSymbolicLink "file" (folder </> "toFile")
      for_ (words "new file pipe toFile") $ \name -> do
        outcome <- pressing (folder </> name)
        outcome `refuses` "name a folder that is new or empty"
      readFile (folder </> "file") `shouldReturn` "file"
  it "that four runs write at once is that of one of them, whole; the others are refused" $
    for_ [1 .. byEffort 2 5 :: Int] $ \_ ->
      inFolder $ \folder -> do
        let writer n = "pra probe --flat 24 --seed " ++ n ++ " --output "
            writers' = words "1 2 3 4"
        (_, out, _) <-
          scripted folder $
            concat
              [ "(" ++ writer n ++ "frames 2> err" ++ n ++ "; echo " ++ n ++ " $? >> ends) > p & "
                | n <- writers'
              ]
              ++ "wait; cat ends"
        let winners = [n | [n, "0"] <- map words (lines out)]
        length winners `shouldBe` 1
        for_ (filter (`notElem` winners) writers') $ \n -> do
          (n, lines out) `shouldSatisfy` (\(m, ends) -> (m ++ " 2") `elem` ends)
          said <- readFile (folder </> "err" ++ n)
          (2 :: Int, "", said) `refuses` "frames is not empty; name a folder that is new or empty"
        let again = concatMap writer winners ++ "alone > said; "
        scripted folder (again ++ "diff -r frames alone") `shouldReturn` (0, "", "")
        filter ((== "frames") . take 6) <$> listDirectory folder `shouldReturn` ["frames"]
  it "that a run did not finish, because it was told to end, is gone" $
    for_ (byEffort [sigINT, sigTERM] [sigINT, sigTERM, sigHUP]) $ \signal ->
      inFolder $ \folder -> do
        status <-
          withCreateProcess
            (proc "pra-tactile" (words "probe --flat 10000 --seed 1 --output frames"))
              { cwd = Just folder,
                std_out = NoStream
              }
            $ \_ _ _ process -> do
              begun folder
              getPid process >>= mapM_ (signalProcess signal)
              waitForProcess process
        status `shouldBe` ExitFailure (negate (fromIntegral signal))
        listDirectory folder `shouldReturn` []
  where
    pressing output = pra (words "probe --object cube --seed 1 --output" ++ [output])
    begun folder = do
      there <- listDirectory folder
      when (null there) (threadDelay 1000 >> begun folder)
