{-# LANGUAGE OverloadedStrings #-}

-- | The simulated sensor, its calibration and frames of other sensors, as scripts use them.
module Test.CommandLine.Sensor (spec) where

import Data.Aeson
import qualified Data.ByteString as Bytes
import Data.Foldable (for_)
import Data.List (isInfixOf, isSuffixOf)
import qualified Data.Text as Text
import qualified Data.Text.IO as Text
import System.Directory (listDirectory)
import System.FilePath ((</>))
import Test.CommandLine.Run
import Test.Effort
import Test.Hspec
import Test.Support

spec :: Spec
spec = do
  it "the paper's sensor is the one without options, by whatever name" $
    inFolder $ \folder -> do
      (0, constants, "") <- pra ["sensor", "--json"]
      writeFile (folder </> "paper.json") constants
      let pressed name options = do
            (status, _, err) <- pra (pressing ++ options ++ ["--output", folder </> name])
            (name, status, err) `shouldBe` (name, 0, "")
            files <- listDirectory (folder </> name)
            mapM (\file -> (,) file <$> Bytes.readFile (folder </> name </> file)) files
      usual <- pressed "usual" []
      for_
        [ ("named", ["--sensor", "paper"]),
          ("filed", ["--sensor", folder </> "paper.json"]),
          ("spelt", words "--frame 16x16 --taxel 1.5875 --spacing 8 --rotation-error 0 --noise 0.1")
        ]
        $ \(name, options) -> pressed name options >>= (`shouldBe` usual)
  it "an option beside a preset replaces its constant" $
    inFolder $ \folder -> do
      (0, constants, "") <- pra (words "sensor --preset real --json")
      -- How large the region is does not matter here: that of one frame is the smallest.
      (0, out, "") <-
        pra
          ( words "evaluate --presses 1 --sensor real --noise 0.25 --position-error 0.5 --json"
              ++ ["--size", "16x16"]
          )
      (key ["noise"] out, key ["position_error_taxels"] out, key ["sensor"] out)
        `shouldBe` (Just (Number 0.25), Just (Number 0.5), Just "real")
      writeFile (folder </> "real.json") constants
      (0, again, "") <- pra ["sensor", "--preset", folder </> "real.json", "--json"]
      (key ["constants"] again, key ["preset"] again)
        `shouldBe` (key ["constants"] constants, Just Null)
  it "the region follows a sensor that is larger than the usual one" $
    inFolder $ \folder ->
      -- Of 64 mm a side and presses 32 mm apart the region is 41 x 52 taxels of 1.5875 mm.
      for_ [("64x64", "1.5875", 1), ("16x16", "4", 4), ("48x16", "1.5875", 6 :: Int)] $
        \(size, taxel, presses) -> do
          let made = folder </> size
          (status, _, err) <-
            pra
              ( words "probe --object cube --seed 7 --frame"
                  ++ [size, "--taxel", taxel, "--output", made]
              )
          (size, status, err) `shouldBe` (size, 0, "")
          frames <- filter (".pgm" `isSuffixOf`) <$> listDirectory made
          (size, length frames) `shouldBe` (size, presses)
  it "faces with too few symbols to be told apart are named, and none is pressed for nothing" $
    inFolder $ \folder -> do
      outcome <-
        scripted
          folder
          "pra place box:30x40x50 --output p.json > log 2>&1; pra evaluate --presses 4 \
          \--placement p.json"
      outcome `shouldSatisfy` \(status, out, err) ->
        (status, out, length (lines err)) == (1, "", 1) && "4 cannot be read" `isInfixOf` err
  it "a face at a few degrees more than a quarter turn is where the truth says" $
    inFolder $ \folder -> do
      (status, out, err) <-
        scripted
          folder
          "pra probe --object cube --seed 7 --turn 93 --noise 0.02 --output f --truth t.json > log \
          \&& pra decode --json f > a.json && pra compare a.json t.json; cat t.json >&2"
      (status, "they agree" `isInfixOf` out) `shouldBe` (0, True)
      (key ["orientation_deg"] err, key ["angle_deg"] err)
        `shouldBe` (Just (Number 90), Just (Number 93))
  it "--axes replaces what a manifest states, of either form" $
    inFolder $ \folder -> do
      (status, out, err) <-
        scripted folder $
          "pra probe --object cube --seed 7 --frame 8x8 --taxel 3.175 --output f"
            ++ byEffort " --at 0,0 --size 16x20 > log; " " > log; "
            ++ "pra probe --object cube --seed 7 --output g"
            -- Four whole cells.
            ++ byEffort " --at 0,0 --size 32x40 > log; " " > log; "
            ++ "for i in f g; do pra stitch $i --output $i.pgm > log; done; "
            ++ "cat > flip.py <<'END'\n"
            ++ unlines
              [ "import json",
                "m = json.load(open('f/manifest.json'))",
                "m['axes'] = '-x,y'",
                "for e in m['frames']: e['y_mm'] = -e['y_mm']",
                "json.dump(m, open('f/manifest.json', 'w'))",
                "rows = [l.split(',') for l in open('g/manifest.csv').read().split()]",
                "for r in rows[1:]: r[1], r[2] = r[2], r[1]",
                "open('g/manifest.csv', 'w').write(''.join(','.join(r) + '\\n' for r in rows))"
              ]
            ++ "END\npython3 flip.py; pra stitch f --axes x,-y --output f2.pgm > log && "
            ++ "pra stitch g --axes y,x --output g2.pgm > log && cmp f.pgm f2.pgm"
            ++ " && cmp g.pgm g2.pgm && pra decode --axes y,x g > log"
      (status, out, err) `shouldBe` (0, "", "")
  it "register corrects both frames first" $
    inFolder $ \folder -> do
      (status, out, err) <-
        scripted folder $
          "pra probe --object cube --seed 7 --position-error 0 --noise 0.01 --output f > log; "
            ++ "pra register f/frame_000.pgm f/frame_001.pgm --step 8,0 --json > a; "
            ++ "cat > worse.py <<'END'\n"
            ++ unlines
              [ "import json",
                "gain = [[1 if (i + j) % 3 else 0.5 for j in range(16)] for i in range(16)]",
                "for k in '01':",
                "    b = open('f/frame_00%s.pgm' % k, 'rb').read()",
                "    v = [round(x * g) for x, g in zip(b[-256:], sum(gain, []))]",
                "    open(k + '.pgm', 'wb').write(b[:-256] + bytes(v))",
                "c = {'schema': 'pra-tactile/calibration/1', 'dead': [], 'gain': gain}",
                "json.dump(dict(c, offset=[[0] * 16] * 16), open('c', 'w'))"
              ]
            ++ "END\npython3 worse.py; "
            ++ "pra register 0.pgm 1.pgm --step 8,0 --calibration c --json > b; cat a; cat b >&2"
      status `shouldBe` 0
      (key ["outcome"] out, key ["best"] out) `shouldBe` (key ["outcome"] err, key ["best"] err)
  it "compare says at which angle a face lies" $
    inFolder $ \folder -> do
      (status, out, _) <-
        scripted
          folder
          "pra probe --object cube --seed 7 --turn 30 --noise 0.02 --output f --truth t > log; \
          \pra decode --json f > a; pra compare a t"
      status `shouldBe` 0
      take 1 (lines out)
        `shouldSatisfy` all ("turned by 30.0 degrees" `isInfixOf`)
      [line | line <- lines out, "answer" `isInfixOf` line]
        `shouldSatisfy` all ("turned by " `isInfixOf`)
      out `shouldSatisfy` not . ("upright" `isInfixOf`)
  it "calibrated, the dead taxels are those that were, and frames are corrected first" $
    inFolder $ \folder -> do
      let sensor = " --sensor hard --seed 7 "
      (status, out, err) <-
        scripted folder $
          "pra probe --dark 8" ++ sensor ++ "--output dark > log; pra probe --flat 8" ++ sensor
            ++ "--output flat > log; pra calibrate --dark dark --flat flat --output c.json > log; "
            ++ "pra probe --object cube"
            ++ sensor
            ++ "--position-error 0.5 --rotation-error 0 --output f --truth t.json > log; "
            ++ "pra decode --json f --calibration c.json > a.json; "
            ++ "pra compare a.json t.json --json; "
            ++ "cat c.json >&2"
      (status, key ["agree"] out) `shouldBe` (0, Just (Bool True))
      case (key ["dead"] err, key ["gain"] err) of
        (Just (Array dead), Just (Array gain)) -> (length dead, length gain) `shouldBe` (2, 16)
        other -> expectationFailure (show other)
  it "presses on foreign arrangements are never right, and do not change the other presses" $ do
    let presses = byEffort (words "--presses 2 --size 32x40") ["--presses", "12"]
        -- Of these only the keys are looked at: a region of one frame will do.
        one = words "evaluate --presses 1 --seed 2 --size 16x16 --json"
    (0, foreign', "") <- pra (words "evaluate --seed 2 --foreign 1 --json" ++ presses)
    (key ["stitching", "right"] foreign', key ["foreign"] foreign')
      `shouldBe` (Just (Number 0), Just (Number 1))
    (0, without, "") <- pra one
    (0, none, "") <- pra (one ++ ["--turn", "0"])
    (0, others, "") <-
      pra (words "evaluate --seed 2 --foreign 1 --foreign-arrays 1 --json" ++ presses)
    (key ["stitching", "right"] others, key ["foreign_arrays"] others)
      `shouldBe` (Just (Number 0), Just (Number 1))
    map (key ["foreign"]) [without, others] `shouldBe` [Nothing, Just (Number 1)]
    key ["any_angle"] without `shouldBe` Nothing
    key ["turn_deg"] none `shouldBe` Just (Number 0)
  it "a bent face is found where the truth says, in arc length, and has no pose" $
    inFolder $ \folder -> do
      (status, out, err) <-
        scripted
          folder
          "pra probe --object cube --seed 7 --bend 100 --bend-axis x --output f --truth t > log; \
          \pra decode --json f > a; pra compare a t --json; cat t >&2"
      (status, key ["agree"] out, key ["pose_mm"] out) `shouldBe` (0, Just (Bool True), Just Null)
      map (`key` err) [["pose"], ["bend", "radius_mm"], ["bend", "axis"]]
        `shouldBe` [Just Null, Just (Number 100), Just "x"]
      let presses = byEffort 1 2 :: Int
      (0, counted, "") <-
        pra (words "evaluate --seed 1 --bend 100 --json --presses" ++ [show presses])
      map (`key` counted) [["pose"], ["bend", "axis"], ["stitching", "right"]]
        `shouldBe` [Just Null, Just "y", Just (toJSON presses)]
  it "under symbols half as large half the radius is as sharp a bend" $
    inFolder $ \folder -> do
      (status, out, err) <-
        scripted folder $
          "pra place b=box:90x90x90 --symbols 1/2 --output p.json > log; press() { "
            ++ "pra probe --object b --placement p.json --taxel 0.79375 --seed 3 \"$@\"; }; "
            ++ "press --bend 40 --output f --truth t > log && pra decode --placement p.json f "
            ++ "--json > a; pra compare --placement p.json a t --json; press --bend 8.9 --output g"
      (status, key ["agree"] out) `shouldBe` (2, Just (Bool True))
      err `shouldSatisfy` ("more than 8.98 mm" `isInfixOf`)
  describe "impossible options are reported on one line" bad

pressing :: [String]
pressing = words "probe --object cube --seed 7"

bad :: Spec
bad = do
  for_
    [ ("sensor --preset nought", "nought"),
      ("probe --object cube --seed 1 --output x --sensor nought", "nought"),
      ("probe --object cube --seed 1 --output x --frame 3x16", "--frame"),
      ("probe --object cube --seed 1 --output x --frame 16x257", "--frame"),
      ("probe --object cube --seed 1 --output x --taxel 0", "--taxel"),
      ("probe --object cube --seed 1 --output x --taxel 30 --size 40x52", "sensor"),
      ("probe --object cube --seed 1 --output x --spacing 0", "--spacing"),
      ("probe --object cube --seed 1 --output x --rotation-error -1", "--rotation-error"),
      ("probe --object cube --seed 1 --output x --tilt 61", "--tilt"),
      ("probe --dark 0 --seed 1 --output x", "--dark"),
      ("probe --flat 1 --seed 1 --output x --tell", "--tell"),
      ("probe --object cube --seed 1 --output x --bend 17.9", "more than 17.96 mm"),
      ("probe --object cube --seed 1 --output x --bend 0", "--bend"),
      ("probe --object cube --seed 1 --output x --bend nan", "--bend"),
      ("probe --object cube --seed 1 --output x --bend 100 --bend-axis z", "--bend-axis"),
      ("probe --object cube --seed 1 --output x --bend-axis x", "--bend"),
      ("probe --dark 1 --seed 1 --output x --bend 100", "--bend"),
      ("evaluate --presses 1 --bend 17.9", "more than 17.96 mm"),
      ("evaluate --presses 1 --bend 2e9", "--bend"),
      ("evaluate --foreign 1.5", "--foreign"),
      ("evaluate --foreign-arrays 1.5", "--foreign-arrays"),
      ("evaluate --foreign 0.2 --foreign-arrays 0.3", "--foreign-arrays"),
      ("decode data/worked-example/frames --taxel 0", "from 0.05 to 50"),
      ("decode data/worked-example/frames --taxel 50.1", "from 0.05 to 50"),
      ("decode data/worked-example/frames --calibration data/shapes.txt", "data/shapes.txt")
    ]
    $ \(arguments, about) -> it arguments (words arguments `complains` about)
  it "invalid manifests in JSON are refused" $
    inFolder $ \folder -> do
      let frames = folder </> "f"
          manifest = frames </> "manifest.json"
      (0, _, "") <-
        pra
          ( words "probe --object cube --seed 1 --frame 8x8 --taxel 3.175 --output"
              ++ [frames]
          )
      written <- Text.readFile manifest
      for_
        [ (Text.replace "\"taxel_mm\":3.175" "\"taxel_mm\":0", "taxel_mm"),
          (Text.replace "\"taxel_mm\":3.175" "\"taxel_mm\":50.1", "from 0.05 to 50"),
          (Text.replace "\"taxel_mm\":3.175" "\"taxel_mm\":NaN", "JSON"),
          (Text.replace "\"x,y\"" "\"x,z\"", "axes"),
          (Text.replace "\"frame\":[8,8]" "\"frame\":[8,9]", "8 x 9"),
          ((<> "\"frames\":[]}\n") . fst . Text.breakOn "\"frames\":", "names no frame"),
          (Text.replace "frame_000.pgm" "../f.pgm", "not a file in the manifest's folder")
        ]
        $ \(change, about) -> do
          Text.writeFile manifest (change written)
          outcome <- pra ["decode", frames]
          outcome `refuses` about
  it "frames that do not go together, or say nothing: an answer or one line" $
    inFolder $ \folder -> do
      writeFile (folder </> "make.py") badFrames
      (0, _, "") <- scripted folder "python3 make.py"
      -- What decode does with frames is the method without a name; full scale is as blank as dead.
      let methods = byEffort [lattice] [[], lattice]
          lattice = ["--method", "lattice"]
      for_
        ( [ ("unequal", Just "15 x 16"),
            ("apart", Nothing),
            ("dead", Nothing),
            ("same", Nothing),
            ("nan", Just "not a finite number"),
            ("far", Just "lie so far apart")
          ]
            ++ [("saturated", Nothing) | effort == Full]
        )
        $ \(name, complaint) -> do
          let decoding = pra ["decode", "--json", folder </> name]
              stitching method = pra (["stitch", folder </> name, "--json"] ++ method)
          case complaint of
            Just about -> do
              decoding >>= (`refuses` about)
              for_ methods $ \method -> stitching method >>= (`refuses` about)
            Nothing -> do
              (status, out, _) <- decoding
              (name, status, key ["outcome"] out) `shouldBe` (name, 1, Just "refused")
              for_ methods $ \method -> do
                (stitched, told, err) <- stitching method
                (name, stitched, err) `shouldBe` (name, 0, "")
                key ["schema"] told `shouldBe` Just "pra-tactile/stitch/1"
      let registering name =
            pra $
              words "register --json --step 8,0"
                ++ [folder </> name </> file | file <- ["0.pgm", "1.pgm"]]
          calibrating dark flat =
            pra
              ["calibrate", "--dark", folder </> dark, "--flat", folder </> flat, "--output", made]
          made = folder </> "c.json"
      for_ [("dead", "blank"), ("saturated", "blank")] $ \(name, reason) -> do
        (status, out, _) <- registering name
        (status, key ["reason"] out) `shouldBe` (1, Just reason)
      registering "unequal" >>= (`refuses` "differ in size")
      calibrating "dead" "saturated" >>= (`refuses` "full scale")
      calibrating "unequal" "saturated" >>= (`refuses` "15 x 16")
  it "another sensor's calibration, and frames that calibrate nothing" $
    inFolder $ \folder -> do
      let file name = folder </> name
          calibrating flat output =
            pra ["calibrate", "--dark", file "dark", "--flat", file flat, "--output", file output]
          folders =
            [ ("--dark 2 --sensor ideal", "dark"),
              ("--flat 2 --sensor ideal", "flat"),
              ("--flat 2 --sensor ideal --frame 8x8", "small"),
              ("--object cube --frame 8x8 --taxel 3.175", "f")
            ]
      for_ folders $ \(options, name) -> do
        (status, _, _) <- pra (words "probe --seed 1" ++ words options ++ ["--output", file name])
        (name, status) `shouldBe` (name, 0)
      (0, _, _) <- calibrating "flat" "c.json"
      let calibrated = ["--calibration", file "c.json"]
          two = map (file "f" </>) ["frame_000.pgm", "frame_001.pgm"]
      for_
        [ (pra (["decode", file "f"] ++ calibrated), "16 x 16"),
          (calibrating "dark" "d.json", "all are dead"),
          (calibrating "small" "d.json", "8 x 8"),
          (pra (("register" : two) ++ ["--step", "4,0"] ++ calibrated), "16 x 16"),
          (calibrating "nowhere" "d.json", "nowhere")
        ]
        $ \(refused, about) -> refused >>= (`refuses` about)

-- | Makes folders of frames of which something is wrong, in Python.
badFrames :: String
badFrames =
  unlines
    [ "import os",
      "def folder(name, frames):",
      "    os.makedirs(name)",
      "    rows = ['file,x_mm,y_mm,rotation_deg,force_n']",
      "    for k, (w, value, x) in enumerate(frames):",
      "        image = bytes(value(i, j) for j in range(16) for i in range(w))",
      "        open('%s/%d.pgm' % (name, k), 'wb').write(b'P5 %d 16 255\\n' % w + image)",
      "        rows.append('%d.pgm,%s,12.7,0,10' % (k, x))",
      "    open(name + '/manifest.csv', 'w').write('\\n'.join(rows) + '\\n')",
      "stripes = lambda i, j: 200 * ((i // 3 + j // 4) % 3 == 0)",
      "at = lambda k: 12.7 * (k + 1)",
      "folder('unequal', [(16, stripes, at(0)), (15, stripes, at(1))])",
      "folder('apart', [(16, stripes, at(8 * k)) for k in range(3)])",
      "folder('dead', [(16, lambda i, j: 0, at(k)) for k in range(8)])",
      "folder('saturated', [(16, lambda i, j: 255, at(k)) for k in range(8)])",
      "folder('same', [(16, stripes, at(0))] * 2)",
      "folder('nan', [(16, stripes, at(0)), (16, stripes, 'nan')])",
      "folder('far', [(16, stripes, at(0)), (16, stripes, 1e300)])"
    ]
