{-# LANGUAGE OverloadedStrings #-}

-- | What is said of arguments and names, and what is read of a standard input that is no text.
module Test.CommandLine.Arguments (argumentsSpec, inputSpec) where

import CommandLine (commandLine, misunderstood, preferences)
import Data.Aeson (Value (..))
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Bytes8
import Data.Char (isLower, isUpper)
import Data.Either (fromLeft)
import Data.Foldable (for_)
import Data.List (isInfixOf, isPrefixOf, isSuffixOf)
import Data.Maybe (fromMaybe)
import Options.Applicative (ParserResult (..), execParserPure)
import Readers
import System.Directory
import System.FilePath (takeExtension, (</>))
import Test.CommandLine.Run
import Test.Effort
import Test.Hostile.Arguments
import Test.Hspec
import Test.QuickCheck hiding (Failure, Success)
import Test.Support
import Visible

argumentsSpec :: Spec
argumentsSpec = describe "arguments" $ do
  it "the help has a line of at most 70 characters for each command, and the most used first" $ do
    (0, text, "") <- pra ["--help"]
    let entries = [entry | entry@(' ' : ' ' : first : _) <- lines text, isLower first]
    map (takeWhile (/= ' ') . drop 2) (take 3 entries) `shouldBe` words "decode locate conform"
    length entries `shouldBe` length commandsOfHelp
    [entry | entry <- entries, length entry > 70] `shouldBe` []
  it "a command's help has its own options first, and those of the array last" $
    for_ (words "decode locate array place") $ \name -> do
      (0, text, "") <- pra [name, "--help"]
      let (own, ofArray) = break ("The array" `isPrefixOf`) (lines text)
          options =
            [ "  --" ++ option ++ " "
              | option <- words "q modulus polynomial shape window state folding profile"
            ]
          listed part = [option | option <- options, any (option `isPrefixOf`) part]
      (name, listed own) `shouldBe` (name, [])
      (name, listed ofArray) `shouldBe` (name, options)
  it "a wrong value is reported on one line, which ends by naming the help" $
    pra ["array", "--shape", "15by17"]
      `shouldReturn` ( 2,
                       "",
                       "pra-tactile: option --shape: \"15by17\" is not a shape; write \
                       \ROWSxCOLUMNS, as in 15x17; try 'pra-tactile array --help'\n"
                     )
  it "wrong and missing arguments of any command are reported in this way" $ do
    pra [] `shouldReturn` (2, "", "pra-tactile: name a command; try 'pra-tactile --help'\n")
    for_ commandsOfHelp $ \(Command name _ _) -> do
      for_ [["--nothing"], ["--", "--nothing", "x", "y"], ["---"], []] $ \others ->
        case execParserPure preferences commandLine (name : others) of
          Failure failure -> do
            -- Of options, those of all commands may follow a command that lacks nothing.
            let endings = ["; try 'pra-tactile " ++ of' ++ "--help'" | of' <- [name ++ " ", ""]]
                said = fromLeft "help" (misunderstood "pra-tactile" failure)
            (said, length (lines said)) `shouldSatisfy` ((== 1) . snd)
            said `shouldSatisfy` (\text -> any (`isSuffixOf` text) endings)
            said `shouldSatisfy` (\text -> not (any (`isPrefixOf` text) endings))
          _ -> others `shouldSatisfy` (`elem` [[], ["--", "--nothing", "x", "y"]])
    for_ (words "decode check stitch compare") $ \name ->
      pra [name] >>= (`refuses` ("--help'" :: String))
  it "arguments that contradict each other, and values out of range, are reported in this way" $
    for_
      ( [ "evaluate --presses 0",
          "rates --trials 0",
          "locate --doubt 2 3",
          "locate 3 2 / 3 1",
          "table --q 3",
          "prove array.csv",
          "polynomials --q 2 --degree 0",
          "synthesise --q 2 --modulus 1,1,1",
          "probe --object cube --seed 1 --noise=-1 --output out",
          "probe --dark 0 --seed 1 --output out",
          "stitch frames",
          "stitch frames --output out.jpg",
          "decode a.pgm --picture - --json",
          "decode a.pgm --picture out.png",
          "objects --at 1,1 --write out",
          "merge README.md --output README.md",
          "conform",
          "conform --list -- true",
          "serve --json"
        ]
          -- To find no law of a name, all laws are made for all profiles.
          ++ ["conform --run no-such-law -- true" | effort == Full]
      )
      $ \line -> do
        outcome@(_, _, err) <- praWith (words line) "0 1"
        outcome `refuses` ("; try 'pra-tactile " ++ takeWhile (/= ' ') line ++ " --help'")
        (line, "--help'\n" `isSuffixOf` err) `shouldBe` (line, True)
  it "an option that would change nothing is refused, by its name and with the reason" $
    inFolder $ \folder -> do
      copyFile "data/worked-example/composite.pgm" (folder </> "whole.pgm")
      (0, _, "") <- pra ["array", "--format", "csv", "--output", folder </> "a.csv"]
      for_
        [ ("decode whole.pgm --axes x,-y", ["--axes"]),
          ("decode whole.pgm --no-stitching --noise 0.1", ["--no-stitching", "--noise"]),
          ( "decode whole.pgm --position-error 1 --slip 0 --axes-doubt 0",
            ["--position-error", "--slip", "--axes-doubt"]
          ),
          ("decode whole.pgm --at 0,0", ["--at"]),
          ("decode whole.pgm --plane plane.json", ["--plane"]),
          ("segment whole.pgm --noise 0.1 --axes y,x", ["--noise", "--axes"]),
          ("stitch frames --no-stitching --method joint --output o.pgm", ["--method"]),
          ("stitch frames --method nominal --noise 0.1 --output o.pgm", ["--noise"]),
          ("stitch frames --method incremental --q 9 --output o.pgm", ["--q"]),
          ("stitch frames --method lattice --noise 0.1 --output o.pgm", ["--noise"]),
          ( "probe --dark 4 --seed 1 --face A --at 0,0 --size 16x16 --upright --tilt 1 --output o",
            ["--face", "--at", "--size", "the turn", "--tilt"]
          ),
          ( "probe --flat 4 --seed 1 --placement p --shapes s --output o",
            ["--placement", "--shapes"]
          ),
          ("probe --flat 4 --seed 1 --q 4 --output o", ["the array's options"]),
          ("probe --object cube --mesh m.stl --shapes s --seed 1 --output o", ["--shapes"]),
          ("probe --object cube --bend-axis x --seed 1 --output o", ["--bend"]),
          ("draw solid --shapes s --output o.svg", ["--shapes"]),
          ("draw sheet --from 0,0 --output o.svg", ["--from"]),
          ("emboss --object cube --json --output -", ["--json"]),
          ("emboss --object cube --page 100x100 --output o", ["--net"]),
          ("solid cube --json --output -", ["--json"]),
          ("solid cube --format off", ["--format"]),
          ("solid cube --format off --output o.obj", ["--format"]),
          ("nets cube --format off", ["--format"]),
          ("place lid=box:30x30x40 --format off", ["--format"]),
          ("shapes --seed 3", ["--seed"]),
          ("shapes --check s --q 4 --seed 3", ["--q", "--seed"]),
          ("certificate --json", ["--json"]),
          ("merge a.csv --json", ["--json"]),
          ("serve --impostors --one-shot", ["--one-shot"]),
          ("rates --plot - --format csv", ["--format"]),
          ("sequence --q 2 --polynomial 1,1,1 --window 1x2", ["--window"]),
          ("locate --doubt 0.2 [[3,2],[3,1]]", ["--doubt"]),
          ("locate --radius 1 " ++ doubtful, ["--radius"]),
          ("conform --list --seed 2 --badge b", ["--seed", "--badge"]),
          ("prove a.csv --window 2x2 --shape 15x17", ["--q and --window"]),
          ("classify whole.pgm --classifier means --network n", ["--network"])
        ]
        $ \(line, named) -> do
          outcome <- pra (map (inside folder) (words line))
          for_ named $ \name -> (line, outcome) `names` name
      -- What acts is not refused.
      listDirectory folder >>= (`shouldMatchList` ["a.csv", "whole.pgm"])
  it "a complaint names an option by the name that was given, new or older" $
    for_ [("--image-noise", "--foreign-shapes"), ("--noise", "--foreign")] $ \(noise, other) -> do
      let images = words "images --set bitmap --count 1 --seed 1 --output out"
      pra (images ++ [noise ++ "=-1"]) >>= (`refuses` ("pra-tactile: " ++ noise ++ " must be"))
      pra (images ++ [other, "97"]) >>= (`refuses` ("pra-tactile: " ++ other ++ " must be"))
  it "an option's older name does what the new one does, and the help does not show it" $
    for_ olderNames $ \(line, older') -> do
      let renamed = [fromMaybe given (lookup given older') | given <- words line]
      older <- pra renamed
      (,) line <$> pra (words line) `shouldReturn` (line, older)
      (_, text, _) <- pra (take 1 (words line) ++ ["--help"])
      [old | (_, old) <- older', old `elem` map bare (words text)] `shouldBe` []
  it "an empty text is refused as the name of a file or a folder, by every option" $ do
    for_ commandsOfHelp $ \(Command name options arguments) -> do
      let paths =
            [ [optionName option, ""]
              | option <- options,
                Just called <- [optionValue option],
                takeWhile isUpper called `elem` ["FILE", "FOLDER"]
            ]
              ++ [[""] | called <- arguments, called `elem` ["FILE", "FOLDER", "PATH", "A.pgm"]]
      for_ paths $ \given ->
        case execParserPure preferences commandLine (name : given) of
          Failure failure ->
            either id id (misunderstood "pra-tactile" failure)
              `shouldSatisfy` ("an empty text names no file or folder" `isInfixOf`)
          _ -> expectationFailure (unwords (name : map show given) ++ " is understood")
    inFolder $ \folder -> do
      outcome <- scripted folder "pra vectors --output ''"
      outcome `refuses` "an empty text names no file or folder"
      listDirectory folder `shouldReturn` []
  it "a whole number is refused in the forms of programming languages, such as 0x10 and 1_000" $
    for_ ["0x10", " 1", "1 ", "1_000", "1e2", "(1)", "", "\x661", "1.0"] $ \text -> do
      (status, _, err) <- pra ["rates", "--trials", text]
      (text, status) `shouldBe` (text, 2)
      err `shouldSatisfy` ("--trials" `isInfixOf`)
  it "a decimal number is refused in the forms of programming languages, such as NaN and 0x1" $
    for_
      [ "0x1",
        " 0.1",
        "NaN",
        "Infinity",
        "1e400",
        ".",
        "1e",
        "0.1.2",
        "--1",
        "(0.1)",
        "1e99999999999999"
      ]
      $ \text -> do
        (status, _, err) <- pra ["locate", "--doubt", text, doubtful]
        (text, status) `shouldBe` (text, 2)
        err `shouldSatisfy` ("--doubt" `isInfixOf`)
  it "a number may have a sign, and a point without digits on one side" $ do
    map readDecimal [".5", "+.5", "5.", "+5", "-5.e-1"]
      `shouldBe` map Right [0.5, 0.5, 5, 5, -0.5 :: Double]
    map readDecimal ["+12", "-0"] `shouldBe` map Right [12, 0 :: Int]
    for_ [".1", "1.e-1", "+.1"] $ \text -> do
      (status, _, _) <- pra ["locate", "--doubt", text, doubtful]
      (text, status < 2) `shouldBe` (text, True)
    exactly <- pra ["solid", "box:0.5x1x2", "--scale", "2", "--tolerance", "0.1"]
    pra ["solid", "box:.5x1.x+2", "--scale", "+2.", "--tolerance", ".1"] `shouldReturn` exactly
  it "a whole number that was shown is read back" $
    property (\n -> readDecimal (show (n :: Int)) === Right n)
  it "a decimal number that was shown is read back" $
    property (\x -> readDecimal (show (x :: Double)) === Right x)
  it "a patch without quotation marks is refused, with the marks that it needs" $ do
    outcome <- pra (words "locate 3 2 / 3 1")
    outcome
      `refuses` "pra-tactile: a patch is one argument; write it between quotation marks: '3 2 / 3 \
                \1'"
  it "an object whose file name is not UTF-8 has the same name in all commands" $
    inFolder $ \folder -> do
      -- The name was bytes in options, and U+FFFD in placements, and nothing found it again.
      let given name = "n=$(printf 'part\\351'); " ++ name
      (status, _, err) <-
        scripted folder . given $
          "pra solid box:130x163x101.6 --output \"$n.obj\" > log && pra place \"$n.obj\" --symbols "
            ++ byEffort "1" "1/2"
            ++ " --smallest --output p.json > log"
      (status, err) `shouldBe` (0, "")
      scripted folder "pra objects --placement p.json | head -1"
        `shouldReturn` (0, "part\\xe9\n", "")
      for_ ["\"$n\"", "'part\\xe9'"] $ \name -> do
        outcome <-
          scripted folder . given $
            "pra emboss --placement p.json --object " ++ name ++ " --output e.stl | cut -d: -f1"
        (name, outcome) `shouldBe` (name, (0, "wrote e.stl\n", ""))
      outcome <-
        scripted folder (given "pra emboss --placement p.json --object \"$n$n\" --output e.stl")
      outcome
        `refuses` "there is no object \"part\\xe9part\\xe9\"; 'pra-tactile objects' lists them"
  it "a name that is unprintable or very long fits on one line, in every locale" $
    inFolder $ \folder ->
      for_ ["LC_ALL=C", "LC_ALL=C.UTF-8"] $ \locale -> do
        named <- scripted folder (locale ++ " pra-tactile decode \"$(printf 'a\\nb\\377.pgm')\"")
        named `refuses` "there is no file or folder a\\nb\\xff.pgm"
        long <- scripted folder (locale ++ " pra-tactile decode \"$(printf '%05000d' 0)\"")
        long `refuses` "(5000 characters)"
        let (_, _, err) = long in length err `shouldSatisfy` (< 600)
        german <- scripted folder (locale ++ " pra-tactile decode Größe.pgm")
        german `refuses` "there is no file or folder Größe.pgm"
  it "JSON is UTF-8, whatever the bytes of a file's name" $
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
  it "shown text has no control characters, and text without them is not changed" $
    property $ \text ->
      let shown = visible text
       in counterexample
            shown
            (all (>= ' ') shown .&&. (if all plain text then shown === text else property True))
  where
    (line, (status, out, err)) `names` name =
      (line, status, out, name `isInfixOf` err, length (lines err))
        `shouldBe` (line :: String, 2, "", True, 1)
    plain c = c `elem` [' ' .. '~']
    -- A file or folder that an example names lies in this folder.
    inside folder argument
      | argument `elem` words "whole.pgm a.csv plane.json m.stl a.pgm frames b n o p s"
          || takeExtension argument `elem` words ".svg .obj .pgm" =
        folder </> argument
      | otherwise = argument
    -- A patch of probabilities, of which --doubt says something.
    doubtful = "[[[0,0,0.1,0.9],2],[3,1]]"

-- | Commands with options that have an older name, each name with the older one.
olderNames :: [(String, [(String, String)])]
olderNames =
  [ ( "rates --trials 5 --patch 2x2 --errors 2 --erasures 0 --picture -",
      [("--patch", "--size"), ("--picture", "--plot")]
    ),
    ("sensor --sensor hard", [("--sensor", "--preset")]),
    ("shapes --examine data/shapes.txt", [("--examine", "--check")]),
    ("objects --cell 6,5", [("--cell", "--at")]),
    ("objects --verify --database none.sqlite", [("--verify", "--check")]),
    ( "decode --together data/worked-example/composite.pgm --origin 3,4 --json",
      [("--origin", "--at")]
    ),
    ("segment data/worked-example/frames --frame-noise 0.1", [("--frame-noise", "--noise")]),
    ( "stitch data/worked-example/frames --method joint --frame-noise 0.1 --picture -",
      [("--frame-noise", "--noise"), ("--picture", "--report")]
    ),
    ("evaluate --presses 1 --foreign-presses 1", [("--foreign-presses", "--foreign")]),
    ( "place lid=box:120x80x20 --face lid:V1,V2,V3,V4 --as-named",
      [("--as-named", "--upright")]
    ),
    ("vectors --compare none", [("--compare", "--check")]),
    ( "train --output - --network-calibration -",
      [("--network-calibration", "--calibration")]
    )
  ]

-- | A word of a usage without its brackets.
bare :: String -> String
bare = filter (\c -> c `notElem` ("[]()" :: String))

inputSpec :: Spec
inputSpec = describe "the standard input" $ do
  it "locate --batch: a line that is not UTF-8 is invalid, and the others are answered" $
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
  it "locate --batch: a line above 1 MiB is invalid, and the others are answered" $
    inFolder $ \folder -> do
      (status, out, _) <-
        scripted
          folder
          "(echo '3 2 / 3 1'; for n in 1048576 1048577; do head -c $n /dev/zero | tr '\\0' '?'; \
          \echo; done; head -c 3000000 \
          \/dev/zero | tr '\\0' ' '; echo; echo '3 2 / 3 1'; head -c 2000000 /dev/zero) | pra \
          \locate --batch"
      status `shouldBe` 2
      map (key ["outcome"]) (lines out)
        `shouldBe` map
          (Just . String)
          ["located", "invalid", "invalid", "invalid", "located", "invalid"]
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
  it "synthesise: bytes that are not text are reported on one line" $
    inFolder $ \folder -> do
      outcome <- scripted folder "printf '0 1 \\377' | pra synthesise --q 4"
      outcome `refuses` "not UTF-8 text"
