-- | Tests the schemas in data/schemas with a validator of others, Python's jsonschema: the output
-- of every command obeys its schema, and spoilt output does not.
module Test.Schemas
  ( spec,
    validated,
    spoilt,
  )
where

import Control.Monad (filterM, forM)
import qualified Data.ByteString.Char8 as Bytes
import Data.Char (isDigit)
import Data.List (isSuffixOf, nub, sort)
import System.Directory
import System.Exit (ExitCode (..))
import System.FilePath (takeBaseName, (</>))
import System.Process (readProcessWithExitCode)
import Test.Effort (byEffort)
import Test.Hspec
import Test.Support

spec :: Spec
spec = do
  beforeAll samples $ do
    it "the output of each command obeys its schema" $ \printed ->
      validated printed >>= mapM_ (\found -> filter ((/= "good") . snd) found `shouldBe` [])
    it "each schema refuses spoilt output: a missing key, an extra key, another type" $ \printed ->
      spoilt printed >>= mapM_ (\found -> filter ((/= "good") . snd) found `shouldBe` [])
    it "every form of output has a schema and occurs in these samples" $ \printed -> do
      files <- filter (".json" `isSuffixOf`) <$> listDirectory ("data" </> "schemas")
      named <- formsOfSources
      filter (`notElem` map takeBaseName files) named `shouldBe` []
      filter (`notElem` nub (map fst printed) ++ ofConformance) named `shouldBe` []
  where
    -- Tested where these are made.
    ofConformance = ["vectors"]

-- | The faults of lines of JSON under the schemas of these names, or @good@. Without a validator
-- there is no result, and the test is pending.
validated :: [(String, String)] -> IO (Maybe [(String, String)])
validated = validator []

-- | The results for all ways of spoiling each line: @good@ if the schema refuses every one. A quick
-- run tries each way on one line of each schema.
spoilt :: [(String, String)] -> IO (Maybe [(String, String)])
spoilt = validator ("--spoil" : byEffort ["--once"] [])

validator :: [String] -> [(String, String)] -> IO (Maybe [(String, String)])
validator options values = do
  found <- filterM hasPackage ["python3", "/usr/bin/python3"]
  case found of
    [] -> Nothing <$ pendingWith "python3-jsonschema is not installed here"
    python : _ -> do
      (status, out, err) <-
        readProcessWithExitCode python ("test/data/validate.py" : options) (concatMap line values)
      (status, err) `shouldBe` (ExitSuccess, "")
      length (lines out) `shouldBe` length values
      pure (Just (zip (map shown values) (lines out)))
  where
    line (schema, value) =
      "{\"schema\": " ++ show schema ++ ", \"value\": " ++ value ++ "}\n"
    shown (schema, value) = schema ++ ": " ++ take 200 value
    hasPackage python = do
      there <- findExecutable python
      case there of
        Nothing -> pure False
        Just _ -> do
          (status, _, _) <- readProcessWithExitCode python ["-c", "import jsonschema"] ""
          pure (status == ExitSuccess)

-- | The output of commands, with the names of the schemas.
samples :: IO [(String, String)]
samples = inFolder $ \folder -> do
  top <- getCurrentDirectory
  createDirectoryLink (top </> "data") (folder </> "data")
  createDirectoryLink (top </> "examples") (folder </> "examples")
  copyFile
    (top </> "test" </> "data" </> "solids" </> "annulus.stl")
    (folder </> "annulus.stl")
  concat
    <$> forM
      commands
      ( \(schema, script) -> do
          (status, out, err) <- readProcessWithExitCode "timeout" (shell folder script) ""
          (script, status, err)
            `shouldSatisfy` (\(_, code, _) -> code `elem` [ExitSuccess, ExitFailure 1])
          out `shouldSatisfy` (not . null)
          pure [(schema, text) | text <- lines out]
      )
  where
    -- On a busy machine the processes of a one-shot subject are slow.
    shell folder script =
      ["120", "sh", "-c", "cd '" ++ folder ++ "'; pra() { pra-tactile \"$@\"; }; " ++ script]

-- | Scripts that print JSON of one form, in the order in which they are run. @pra@ is the program.
-- A quick run leaves out slow scripts whose form others print.
commands :: [(String, String)]
commands =
  concat
    [ [ ("profile", "pra profile; pra profile " ++ small ++ " --folding row-major"),
        ("array", "pra array --format json " ++ small),
        ("field", "pra field --q 9 --json; pra field --q 5 --json"),
        ("sequence", "pra sequence --from=-3 --length 4 --json"),
        ("sequence", "pra sequence --from 1000000000000000000 --length 0 --json"),
        ("synthesise", "echo '0 0 1 0 1 1 1' | pra synthesise --q 2 --json"),
        ("synthesise", "echo '0 1 A' | pra synthesise --q 4 --json"),
        ("polynomials", "pra polynomials --q 4 --degree 2 --json"),
        ("polynomials", "pra polynomials --q 2 --degree 3 --irreducible --count --json"),
        ("advise", "pra advise --json --q 2 --rows 3 --columns 5"),
        ("advise", "pra advise --json --q 4 --rows 15 --columns 273 --window 2x3"),
        ("census", "pra census --q 2 --degree 4 --output census.csv --json"),
        ("census", "pra merge census.csv --output whole.csv --json")
      ],
      proofs,
      [("locate", "pra locate --json " ++ arguments) | arguments <- locating],
      [ ("locate", "printf '3 2 / 3 1\\n0 0\\n3 9\\n\\n' | pra locate --batch; true"),
        ("rates", "pra rates --format json --trials 20 --size 3x3 --errors 2"),
        ("rates", "pra rates --format json --trials 20 --size 2x2 --errors 5 --radius 1")
      ],
      touching,
      conforming,
      asking
    ]
  where
    small = "--q 2 --polynomial 1,1,0,0,1 --shape 3x5"

proofs :: [(String, String)]
proofs =
  [ ("prove", "pra prove --json; pra prove --json --mask '##/.#'"),
    ("prove", "pra prove --json --surface sheet"),
    ("prove", "pra array --format csv --output a.csv; pra prove --json a.csv --window 2x2"),
    ("certificate", "pra certificate --rank; pra certificate --enumeration"),
    ("certificate-written", "pra certificate --output c.json --json"),
    ("check", "pra check c.json --json"),
    ("check", "sed 's/\"windows\":255/\"windows\":254/' c.json > d.json; pra check d.json --json")
  ]

-- | Arguments of @locate@: each outcome, by each decoder.
locating :: [String]
locating =
  [ "'3 2 / 3 1'",
    "'0 0 / 0 0'",
    "--explain '3 2 0 / 3 0 2 / 0 1 3'",
    "'3 ?'",
    "'? ?'",
    "--surface sheet --road table '3 2 / 3 1'",
    "--road algebra '3 2 / 3 1'",
    "--road search '3 2 / 3 1'",
    "--orientation turned '1 0 3 3 / 0 1 1 2 / 2 3 2 0 / 2 0 1 1'",
    "--orientation any '3 2 / 3 1'",
    "--doubt 0.2 '[[[0,0,0.1,0.9], 2], [3, 1]]'",
    "--orientation any '[[[0,0,0.1,0.9], 2], [3, 1]]'",
    "'3 2 / 3 1 ; 0,3: 1 1 / 1 1 ; 4,0: 2 2 / 3 0'",
    "--foreign 0.005 --doubt 0.01 '3 2 / 3 1'",
    "--foreign 0.005 '[[[0,0,0.1,0.9], 2], [3, 1]]'",
    vast ++ "'3 1 3 3 0 / 2 1 3 3 3 / 3 2 2 2 0 / 3 1 1 1 0 / 2 0 2 0 3'",
    vast ++ "'3 1 3 3 0'",
    vast ++ "'[[[0.1,0.1,0.1,0.7], 2,2,1,3,1,2,3,1,2,3], [1,2,3,2,1,2,3,1,2,3,2]]'"
  ]
  where
    vast = "--q 4 --polynomial 2,0,1,1,1,0,0,0,0,0,0,0,1 --shape 4095x4097 "

touching :: [(String, String)]
touching =
  [ ("decode", "pra decode --json " ++ worked ++ " data/worked-example/composite.pgm"),
    ("decode", "{ echo P2 40 52 255; yes 0 | head -2080; } > b.pgm; pra decode --json b.pgm"),
    ("plane", "echo '" ++ plane ++ "'"),
    ( "decode",
      "echo '" ++ plane ++ "' > plane.json; pra decode --json --plane plane.json " ++ worked
    ),
    ("shapes", "pra shapes --json; pra shapes --check data/shapes.txt --json"),
    ("segment", "pra segment --json " ++ worked ++ " data/worked-example/composite.pgm"),
    ("segment", "{ echo P2 40 52 255; yes 0 | head -2080; } > e.pgm; pra segment --json e.pgm"),
    ("register", "pra register " ++ frame "000" ++ frame "001" ++ "--step 8,0 --json"),
    ("register", "pra register " ++ frame "000" ++ frame "001" ++ "--step 40,0 --json || true"),
    ( "stitch",
      ("pra stitch " ++ worked ++ " --json")
        ++ byEffort "" ("; pra stitch " ++ worked ++ " --method lattice --json")
    ),
    ("placement", "pra place octahedron:80 box:100x80x60 --symbols 3/4 --output -"),
    ("place", "pra place cube --json; pra place octahedron:150 --json"),
    ("place", "pra place a=cube b=cube --json; pra place cube --smallest --json"),
    ("truth", "pra probe --object cube --seed 7 --output frames --truth t.json > log; cat t.json"),
    ("compare", "pra decode --json frames > a.json; pra compare a.json t.json --json"),
    ("evaluate", "pra evaluate --json --seed 1 --presses " ++ byEffort "1" "2"),
    ("evaluate", "pra evaluate --json --presses 1 --sensor real --any-angle --foreign 0.5"),
    ( "evaluate",
      "pra evaluate --json --presses 2 --seed 1 --noise 0.4 --shard 1/1 | tr -d '\\n'; echo"
    ),
    ( "evaluate-written",
      "pra evaluate --json --presses 1 --output e.json; pra merge e.json --output m.json --json"
    ),
    ( "truth",
      "pra probe --object cube --seed 7 --bend 80 --output bent --truth v.json > log; cat v.json"
    ),
    ("network", "pra network --json; pra network --q 9 data/alphabets/gf9/network.txt --json"),
    ( "classify",
      "pra images --set bitmap --count 1 --seed 1 --output bits > log; "
        ++ "pra classify bits/2_0.pgm --levels 0.25,0.75 --json; "
        ++ "printf 'bits/1_0.pgm\\nbits/9.pgm\\n' | pra classify --batch --json || true"
    ),
    ( "experiment",
      "pra experiment --training manual --vary formula --set bitmap --seeds 1 --json"
    ),
    ( "sensor",
      "pra sensor --json; pra sensor --preset real --json > r.json; "
        ++ "pra sensor --preset r.json --json"
    ),
    ( "manifest",
      "pra probe --dark 2 --sensor hard --frame 8x6 --seed 1 --output dark > log; "
        ++ "cat dark/manifest.json"
    ),
    ( "manifest",
      "sed 's/,\"axes\":\"x,y\"//; s/\"frame\":.8,6.,//' dark/manifest.json > m.json; "
        ++ "cp m.json dark/manifest.json; pra stitch dark --output d.pgm > log; cat m.json"
    ),
    ( "calibration",
      "pra probe --flat 2 --sensor hard --frame 8x6 --seed 1 --output flat > log; "
        ++ "pra calibrate --dark dark --flat flat --output k.json > log; cat k.json"
    ),
    ("objects", "pra objects --json; pra objects --json --at 6,5; pra objects --json --at 14,16"),
    ("objects", "printf '6,5\\n15,0\\nx\\n' | pra objects --batch || true"),
    ("objects-written", "pra objects --write o.sqlite --json"),
    ( "objects-database",
      "pra objects --write o.sqlite > o.txt; pra objects --database o.sqlite --check --json; \
      \pra objects --database o.sqlite --replace cube=box:90x90x90 --json; \
      \pra objects --database o.sqlite --add box:300x300x300 --json"
    ),
    ("nets", "pra nets cube --json; pra nets pyritohedron:9 --json; pra nets prism:80,90,9 --json"),
    ( "emboss",
      "pra emboss --output e --json; pra emboss --format svg --object cube --output f --json; "
        ++ "pra place tetrahedron:120 --output tetrahedron.json > log; "
        ++ "pra emboss --placement tetrahedron.json --object tetrahedron --face V1,V2,V3 "
        ++ "--output t.stl --json"
    ),
    ("object", "pra solid prism:5,70,1/3 --output p.json > log; cat p.json"),
    ("solid", "pra solid cube frame:9x9x3 --json; pra solid p.json --json --symbols 1/8"),
    ("solid", "pra solid annulus.stl --json --merge-coplanar --tolerance 0.01"),
    ("solid", "sed 's/V4/V9/' p.json > q.json; pra solid q.json --json; true"),
    ( "solid",
      "pra solid cube --output c.obj > log; "
        ++ "awk '/^f/ {print $1, $5, $4, $3, $2; next} {print}' c.obj > i.obj; "
        ++ "pra solid i.obj --json; pra solid i.obj --json --fix-orientation --tolerance 0.1"
    ),
    ( "solid",
      "printf 'v 0 0 0\\nv 9 0 0\\nv 0 9 0\\nv 9 9 1\\nf 1 2 4 3\\nf 1 4 2\\n' > r.obj; "
        ++ "pra solid r.obj --json; true"
    )
  ]
    ++ byEffort [] atLength
  where
    atLength =
      [ ("decode", "pra decode --json --together " ++ worked ++ " " ++ worked),
        ( "compare",
          "pra decode --json " ++ worked ++ " > b.json; pra compare b.json t.json --json"
        ),
        ( "decode",
          "pra probe --profile data/profiles/gf9.json --object sheet --seed 4 --output f9 > log; "
            ++ "pra decode --profile data/profiles/gf9.json --json f9"
        ),
        ("evaluate", "pra evaluate --json --object sheet --presses 1"),
        ("evaluate", "pra evaluate --json --presses 1 --foreign-arrays 0.5"),
        ("evaluate", "pra evaluate --json --presses 1 --bend 80 --bend-axis x"),
        ("evaluate", "pra evaluate --json --presses 1 --rotation-error 1 --tilt 1 --turn 5"),
        ( "truth",
          "pra probe --object cube --seed 7 --turn 5 --output f5 --truth u.json > log; cat u.json"
        ),
        ( "network",
          "pra train --uncalibrated --regimen manual --seed 5 --output n.json > log; cat n.json"
        )
      ]
    plane =
      "{\"schema\": \"pra-tactile/plane/1\", \"rotation\": [[0, 1, 0], [1, 0, 0], [0, 0, -1]], "
        ++ "\"translation_mm\": [400, 250, 75]}"
    worked = "data/worked-example/frames"
    frame n = worked ++ "/frame_" ++ n ++ ".pgm "

-- | Reports of a right subject, of a wrong one, and of one that ends at once.
conforming :: [(String, String)]
conforming =
  [ ("conform-laws", "pra conform --list --json" ++ quickly),
    ("suite", "tr -d '\\n' < data/suite.json"),
    ("impostors", "pra serve --impostors --json"),
    ("conform", conform ("--run window/pack" ++ paper) "pra-tactile serve"),
    ("conform", python ++ conform ("--one-shot --run field/negation-as-defined" ++ paper) adapter),
    ( "conform",
      conform ("--stage touch --run displacement --cases 2" ++ quickly) "pra-tactile serve"
    ),
    ("conform-laws", "pra conform --list --stage touch --json" ++ quickly),
    ( "badge",
      "pra conform --badge badge.json --run window/pack" ++ paper ++ " -- pra-tactile serve > log"
        ++ "; cat badge.json"
    ),
    ("conform", started ++ conform ("--stage window" ++ paper) ended)
  ]
  where
    conform options subject = "pra conform --json " ++ options ++ " -- " ++ subject
    paper = " --profile examples/adapter/paper.json"
    -- Without a profile the definition prepares all default profiles.
    quickly = byEffort paper ""
    -- What is called python3 may be a script that starts more slowly than the interpreter.
    python = "python=$(python3 -c 'import sys; print(sys.executable)'); "
    adapter = "\"$python\" -S examples/adapter/adapter.py"
    started =
      "echo '{\"protocol\": 1, \"name\": \"brief\", \"operations\": [\"pack\"], \"in_flight\": 1}'"
        ++ " > started; "
    ended = "sh -c 'read line; cat started' brief"

-- | Requests, and the replies of this library and of the example in Python.
asking :: [(String, String)]
asking =
  [ ("request", profile ++ "cat > requests <<END\n" ++ unlines requests ++ "END\ncat requests"),
    ("reply", "pra serve < requests"),
    ("reply", "python3 -B examples/python/subject.py < requests"),
    ("request", profile ++ "cat > one <<END\n" ++ one ++ "\nEND\ncat one"),
    ("reply", "pra serve --one-shot < one; python3 -B examples/python/subject.py --one-shot < one")
  ]
  where
    profile = "profile=$(pra profile); "
    requests =
      [ "{\"command\": \"start\", \"protocol\": 1}",
        "{\"command\": \"profile\", \"profile\": $profile}"
      ]
        ++ [ "{\"command\": \"run\", \"sequence\": " ++ show i ++ ", " ++ asked ++ "}"
             | (i, asked) <- zip [1 :: Int ..] (map operation inputs)
           ]
        ++ ["{\"command\": \"stop\"}"]
    one = "{\"profile\": $profile, \"sequence\": 7, " ++ operation ("trace", "{\"a\": 2}") ++ "}"
    operation (name, input) = "\"operation\": \"" ++ name ++ "\", \"input\": " ++ input

-- | Each operation with an input, and some inputs that are refused.
inputs :: [(String, String)]
inputs =
  [ ("add", "{\"a\": 1, \"b\": \"2\"}"),
    ("multiply", "{\"a\": 2, \"b\": 3}"),
    ("negate", "{\"a\": 1}"),
    ("inverse", "{\"a\": 0}"),
    ("power", "{\"a\": 2, \"exponent\": \"-1000000000000000000000\"}"),
    ("logarithm", "{\"a\": 3}"),
    ("trace", "{\"a\": 2}"),
    ("primitive", "{\"polynomial\": [3, 2, 1, 0, 1]}"),
    ("first-primitive", "{\"degree\": 4}"),
    ("term", "{\"index\": \"1000000000000000000\"}"),
    ("terms", "{\"from\": 5, \"length\": 4}"),
    ("cell", "{\"row\": 6, \"column\": 5}"),
    ("pack", "{\"cells\": [3, 2, 3, 1]}"),
    ("unpack", "{\"packed\": 237}"),
    ("unpack", "{\"packed\": 256}"),
    ("locate", "{\"patch\": [[3, 2], [3, 1]]}"),
    ("locate", "{\"patch\": [[0, 0], [0, 0]]}"),
    ("nearest", "{\"patch\": [[3, 2, 0], [3, 0, 2], [0, 1, null]], \"radius\": null}"),
    ("nearest", "{\"patch\": [[3, null, 2]], \"radius\": 0}"),
    ("posterior", "{\"patch\": [[[0, 0, 0.1, 0.9], 2], [3, 1]]}"),
    ("prove", "{\"mask\": \"##/.#\"}"),
    ("distance", "{\"mask\": \"###/###/###\"}"),
    ("register", "{\"a\": " ++ rows ++ ", \"b\": " ++ rows ++ ", \"step\": [2, 0], \"search\": 1}"),
    ("stitch", "{\"frames\": [{\"rows\": " ++ rows ++ ", \"place\": [-3, \"4\"]}], \"search\": 1}"),
    ( "register",
      "{\"a\": " ++ rows ++ ", \"b\": " ++ rows ++ ", \"step\": [2, 0], \"search\": 1, "
        ++ ("\"alphabet\": " ++ drawings ++ "}")
    ),
    ("segment", "{\"rows\": " ++ rows ++ "}"),
    ("segment", "{\"rows\": [[65536]]}"),
    ("outputs", "{" ++ weights ++ ", \"rows\": " ++ image ++ "}")
  ]
  where
    weights = "\"hidden\": " ++ show [hidden] ++ ", \"output\": [[1, 0], [0, 1]]"
    hidden = replicate 97 (0.1 :: Double)
    image = show (replicate 12 (replicate 8 (0.5 :: Double)))
    drawings = show [replicate 12 "####....", replicate 12 "....####"]
    rows = show [[1000 * (i * i + 2 * j) | i <- [0 .. 3]] | j <- [0 .. 3 :: Int]]

-- | The names of the forms of output in the sources: the text between @pra-tactile/@ and a slash,
-- and the argument of @encodeSchema@.
formsOfSources :: IO [String]
formsOfSources = do
  files <- concat <$> mapM sourcesIn ["app", "src"]
  nub . sort . concatMap forms <$> mapM Bytes.readFile files
  where
    forms text = [name | mark <- marks, Just name <- map named (behind (Bytes.pack mark) text)]
    marks = ["\"pra-tactile/", "encodeSchema \"", "schema = \""]
    -- The texts that follow a mark.
    behind mark text
      | Bytes.null found = []
      | otherwise = rest : behind mark rest
      where
        found = snd (Bytes.breakSubstring mark text)
        rest = Bytes.drop (Bytes.length mark) found
    named rest
      | (name, end) <- Bytes.span (`elem` '-' : ['a' .. 'z']) rest,
        ['/', digit, '"'] <- Bytes.unpack (Bytes.take 3 end),
        isDigit digit,
        not (Bytes.null name) =
        Just (Bytes.unpack name)
      | otherwise = Nothing
    sourcesIn folder = do
      entries <- map (folder </>) <$> listDirectory folder
      folders <- filterM doesDirectoryExist entries
      (filter (".hs" `isSuffixOf`) entries ++) . concat <$> mapM sourcesIn folders
