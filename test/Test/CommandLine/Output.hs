{-# LANGUAGE OverloadedStrings #-}

-- | Where output goes, what is said of arguments and names, and what is read of a standard input
-- that is no text.
module Test.CommandLine.Output (spec) where

import Control.Monad (when)
import Data.Aeson (Value (..))
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Bytes8
import Data.Foldable (for_)
import Data.List (isInfixOf, isPrefixOf, sort)
import Readers
import System.Directory
import System.Exit (ExitCode (..))
import System.FilePath ((</>))
import System.Posix.Files
import System.Posix.User (getEffectiveUserID)
import System.Process (callProcess, readProcessWithExitCode)
import Test.CommandLine.Run
import Test.Hspec
import Test.QuickCheck
import Test.Support
import Visible

spec :: Spec
spec = do
  filesSpec
  standardOutputSpec
  databasesSpec
  foldersSpec
  argumentsSpec
  inputSpec

-- | A script in a folder of its own, within 20 seconds: nothing hangs. The program is @pra@ there.
scripted :: FilePath -> String -> IO Outcome
scripted folder script = do
  (code, out, err) <-
    readProcessWithExitCode
      "timeout"
      ["20", "sh", "-c", "cd '" ++ folder ++ "'; pra() { pra-tactile \"$@\"; }; " ++ script]
      ""
  pure (case code of ExitSuccess -> 0; ExitFailure n -> n, out, err)

-- | Nothing on the standard output, one line with this in it, status 2.
refuses :: Outcome -> String -> Expectation
refuses (status, out, err) about = do
  (status, out, length (lines err)) `shouldBe` (2, "", 1)
  err `shouldSatisfy` (about `isInfixOf`)
  err `shouldSatisfy` ("pra-tactile: " `isPrefixOf`)

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
  it "behind links that go round is refused" $
    inFolder $ \folder -> do
      createSymbolicLink "b" (folder </> "a")
      createSymbolicLink "a" (folder </> "b")
      outcome <- scripted folder "pra array --output a"
      outcome `refuses` "links"
  it "that is a FIFO is written to as it is" $
    inFolder $ \folder -> do
      createNamedPipe (folder </> "pipe") 0o600
      (status, out, err) <- scripted folder "cat pipe & pra array --output pipe; wait"
      (_, expected, _) <- pra ["array"]
      (status, out, err) `shouldBe` (0, expected, "")
      isNamedPipe <$> getFileStatus (folder </> "pipe") `shouldReturn` True
  it "that is a device is written to as it is, by every command" $
    asRoot $
      inFolder $ \folder -> do
        callProcess "mknod" [folder </> "null", "c", "1", "3"]
        callProcess "mknod" [folder </> "full", "c", "1", "7"]
        for_ writers $ \command -> do
          (status, _, err) <- scripted folder (command "null")
          (command "null", status, err) `shouldBe` (command "null", 0, "")
          (isCharacterDevice <$> getFileStatus (folder </> "null")) `shouldReturn` True
          (status', _, err') <- scripted folder (command "full")
          (command "full", status', length (lines err')) `shouldBe` (command "full", 2, 1)
          err' `shouldSatisfy` ("no space left on device" `isInfixOf`)
          (isCharacterDevice <$> getFileStatus (folder </> "full")) `shouldReturn` True
  it "called - is the standard output, and nothing else is said there" $
    inFolder $ \folder ->
      for_ writers $ \command -> do
        outcome <-
          scripted
            folder
            ( "rm -f file && "
                ++ command "- > stdout && "
                ++ command "file > said && cmp file stdout && test -s file"
            )
        (command "-", outcome) `shouldBe` (command "-", (0, "", ""))
  it "that may not be written is refused, and left as it is" $
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
writers :: [FilePath -> String]
writers =
  [ \file -> command ++ " --output " ++ file
    | command <-
        [ "pra array",
          "pra array --format pgm",
          "pra table",
          "pra certificate",
          "pra certificate --json",
          "pra shapes --svg",
          "pra shapes",
          "pra census --q 2 --degree 3",
          "pra census --q 2 --degree 3 --json"
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
    printers =
      [ "array",
        "array --format json",
        "prove",
        "prove --json",
        "table",
        "field --q 4",
        "shapes",
        "objects",
        "profile",
        "certificate",
        "sequence",
        "polynomials --q 4 --degree 4",
        "advise --rows 10 --columns 10 --q 4",
        "--version",
        "--help",
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
        (status, _, err) <- scripted folder ("pra probe --object cube --seed 1 --output " ++ name)
        (name, status, err) `shouldBe` (name, 0, "")
        there <- doesFileExist (folder </> name </> "manifest.csv")
        (name, there) `shouldBe` (name, True)
      pathIsSymbolicLink (folder </> "link") `shouldReturn` True
      writeFile (folder </> "file") "file"
      createNamedPipe (folder </> "pipe") 0o600
      createSymbolicLink "file" (folder </> "toFile")
      for_ (words "new file pipe toFile") $ \name -> do
        outcome <- scripted folder ("pra probe --object cube --seed 1 --output " ++ name)
        outcome `refuses` "name a folder that is new or empty"
      readFile (folder </> "file") `shouldReturn` "file"
  it "that could not be finished is gone, or is called NAME.part and used up by the next run" $
    inFolder $ \folder -> do
      createDirectory (folder </> "frames.part")
      writeFile (folder </> "frames.part" </> "frame_000.pgm") "half"
      (status, _, _) <- scripted folder "pra probe --object cube --seed 1 --output frames"
      status `shouldBe` 0
      listDirectory folder `shouldReturn` ["frames"]

argumentsSpec :: Spec
argumentsSpec = describe "arguments" $ do
  it "an error in one of them is that line and one that points to the help" $ do
    (status, out, err) <- pra ["array", "--shape", "15by17"]
    (status, out) `shouldBe` (2, "")
    lines err
      `shouldBe` [ "pra-tactile: option --shape: \"15by17\" is not a shape; write ROWSxCOLUMNS, \
                   \as in 15x17",
                   "pra-tactile: try 'pra-tactile array --help'"
                 ]
  it "what is no number is refused, whatever a programming language makes of it" $
    for_ ["0x10", " 1", "1 ", "1_000", "1e2", "(1)", "+1", "", "\x661", "1.0"] $ \text -> do
      (status, _, err) <- pra ["rates", "--trials", text]
      (text, status) `shouldBe` (text, 2)
      err `shouldSatisfy` ("--trials" `isInfixOf`)
  it "what is no number with a point is refused likewise" $
    for_
      [ "0x1",
        " 0.1",
        "NaN",
        "Infinity",
        "1e400",
        ".5",
        "5.",
        "1e",
        "0.1.2",
        "--1",
        "(0.1)",
        "1e99999999999999"
      ]
      $ \text -> do
        (status, _, err) <- pra ["locate", "--doubt", text, "3 2 / 3 1"]
        (text, status) `shouldBe` (text, 2)
        err `shouldSatisfy` ("--doubt" `isInfixOf`)
  it "a number is read back as it was shown" $
    property (\n -> readDecimal (show (n :: Int)) === Right n)
  it "a number with a point likewise" $
    property (\x -> readDecimal (show (x :: Double)) === Right x)
  it "a patch that the shell took apart is told so" $ do
    outcome <- pra (words "locate 3 2 / 3 1")
    outcome
      `refuses` "pra-tactile: a patch is one argument; write it between quotation marks: '3 2 / 3 \
                \1'"
  it "a name that cannot be printed, or of 5000 characters, is one line in every locale" $
    inFolder $ \folder ->
      for_ ["LC_ALL=C", "LC_ALL=C.UTF-8"] $ \locale -> do
        named <- scripted folder (locale ++ " pra-tactile decode \"$(printf 'a\\nb\\377.pgm')\"")
        named `refuses` "there is no file or folder a\\nb\\xff.pgm"
        long <- scripted folder (locale ++ " pra-tactile decode \"$(printf '%05000d' 0)\"")
        long `refuses` "(5000 characters)"
        let (_, _, err) = long in length err `shouldSatisfy` (< 600)
        german <- scripted folder (locale ++ " pra-tactile decode Größe.pgm")
        german `refuses` "there is no file or folder Größe.pgm"
  it "JSON is UTF-8 whatever a file is called" $
    inFolder $ \folder -> do
      composite <- makeAbsolute "data/worked-example/composite.pgm"
      _ <-
        scripted
          folder
          ( "cp "
              ++ composite
              ++ " \"$(printf 'a\\377\\n.pgm')\"; pra decode --json * > out; LC_ALL=C pra decode \
                 \--json *.pgm > out2"
          )
      shown <- Bytes.readFile (folder </> "out")
      Bytes.readFile (folder </> "out2") `shouldReturn` shown
      key ["source"] (Bytes8.unpack shown) `shouldBe` Just (String "a\\xff\n.pgm")
  it "what is visible has no control characters, and nothing is changed that has none" $
    property $ \text ->
      let shown = visible text
       in counterexample
            shown
            (all (>= ' ') shown .&&. (if all plain text then shown === text else property True))
  where
    plain c = c `elem` [' ' .. '~']

inputSpec :: Spec
inputSpec = describe "the standard input" $ do
  it "locate --batch: a line that is no UTF-8 is invalid, the others are answered" $
    inFolder $ \folder ->
      for_ ["LC_ALL=C", "LC_ALL=C.UTF-8"] $ \locale -> do
        (status, out, err) <-
          scripted
            folder
            ( "printf '3 2 / 3 1\\n3 \\377 / 3 1\\nA^2 A / A^2 1\\n3 2 / 3 1' | "
                ++ locale
                ++ " pra-tactile locate --batch"
            )
        (status, err) `shouldBe` (2, "")
        map (key ["outcome"]) (lines out)
          `shouldBe` map (Just . String) ["located", "invalid", "located", "located"]
  it "locate --batch: a line beyond 1 MiB is invalid; the others are answered" $
    inFolder $ \folder -> do
      (status, out, _) <-
        scripted
          folder
          "(echo '3 2 / 3 1'; head -c 1048577 /dev/zero | tr '\\0' '?'; echo; head -c 3000000 \
          \/dev/zero | tr '\\0' ' '; echo; echo '3 2 / 3 1'; head -c 2000000 /dev/zero) | pra \
          \locate --batch"
      status `shouldBe` 2
      map (key ["outcome"]) (lines out)
        `shouldBe` map (Just . String) ["located", "invalid", "invalid", "located", "invalid"]
      let found =
            [ message
              | Just (String message) <- map (key ["message"]) (lines out),
                "bytes" `isInfixOf` show message
            ]
      found
        `shouldBe` [ "the line has 1048577 bytes; at most 1048576 are read",
                     "the line has 3000000 bytes; at most 1048576 are read",
                     "the line has 2000000 bytes; at most 1048576 are read"
                   ]
  it "synthesise: bytes that are no text are one line" $
    inFolder $ \folder -> do
      outcome <- scripted folder "printf '0 1 \\377' | pra synthesise --q 4"
      outcome `refuses` "not UTF-8 text"
