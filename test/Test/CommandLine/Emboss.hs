-- | What is made is read back by roads that share nothing with its making: as a polyhedron, by
-- pressing it, and as an image.
module Test.CommandLine.Emboss (spec) where

import Codec.Picture
import qualified Data.ByteString as Bytes
import Data.ByteString.Builder (toLazyByteString)
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (for_)
import Data.List (isInfixOf, isPrefixOf, isSuffixOf, sort, stripPrefix, tails)
import Data.Maybe (mapMaybe)
import Data.Traversable (for)
import PraTactile.Format.Solid
import PraTactile.Object.Mesh (fromDescription)
import System.Directory
import System.Exit (ExitCode (..))
import System.Process (readProcessWithExitCode)
import Test.CommandLine.Run
import Test.Effort
import Test.Hspec hiding (after)
import Test.Solid.Drilled (ring)
import Test.Support

spec :: Spec
spec = do
  it "every format holds the same cube, and is read back as a solid" $
    inFolder $ \folder ->
      for_
        -- Other tests read the cube as binary STL.
        ( ("", "c.OBJ") :
          byEffort [] [("", "c.stl"), ("", "c.json"), ("--format ascii-stl ", "d.stl")]
        )
        $ \(format, file) -> do
          (status, out, _) <-
            scripted folder $
              "pra emboss --object cube " ++ format ++ "--output " ++ file
                ++ (" && pra solid " ++ file ++ " | head -1")
          (status, lines out)
            `shouldBe` ( 0,
                         [ "wrote " ++ file
                             ++ ": 4192 vertices, 8380 triangles, 2074307.84734375 mm^3, 6480 "
                             ++ "raised taxels, strokes from 3.175 mm, 1.5875 mm high",
                           (if file == "c.json" then "cube" else take 1 file) ++ ": a solid"
                         ]
                       )
  it "a 3MF is an archive whose model has the closed surface and its volume, without a date" $
    findExecutable "python3" >>= \there -> case there of
      Nothing -> pendingWith "python3 is not installed here, which reads the archive"
      Just python -> inFolder $ \folder -> do
        (status, _, err) <-
          scripted folder "pra emboss --object cube --output c.3mf > log"
        (status, err) `shouldBe` (0, "")
        readProcessWithExitCode python ["-c", readModel, folder ++ "/c.3mf"] ""
          `shouldReturn` (ExitSuccess, "millimeter cube 4192 8380 0 13275570223/6400 [1980]\n", "")
  it "a tilted block far away is refused in 32 bits, and written in decimal numbers" $
    -- Along x alone no two points became one: it was written as a plane figure.
    inFolder $ \folder ->
      for_ (byEffort [[0]] [[0], [2], [0, 1], [0, 1, 2]]) $ \axes -> do
        writeFile (folder ++ "/part.obj") (tiltedBlock axes)
        outcome <-
          scripted folder $
            "pra place part=part.obj --output p.json > log 2>&1; "
              ++ "pra emboss --placement p.json --object part --output x"
        outcome `refuses` "with coordinates of 32 bits"
        (status, out, _) <-
          scripted folder $
            "pra emboss --placement p.json --object part --output made.obj && "
              ++ "pra solid made.obj | head -1"
        status `shouldBe` 0
        drop 1 (lines out) `shouldBe` ["made: a solid"]
  it "symbols on a net have the area of their taxels, also where faces with holes are cut" $
    inFolder $ \folder ->
      for_ (byEffort (take 1) id [(160, True), (220, False)]) $ \(wide, cut) -> do
        Lazy.writeFile
          (folder ++ "/ring.obj")
          (toLazyByteString (writtenBytes (writeSolid Obj (fromDescription (ring wide)))))
        (status, out, _) <-
          scripted folder $
            "rm -rf p.json net.svg nets; pra place ring.obj --output p.json > log 2>&1; "
              ++ "pra nets ring.obj --svg nets | tail -1; "
              ++ "pra emboss --placement p.json --object ring --net --output net.svg"
        (status, ["cut" `isSuffixOf` line | line <- take 1 (lines out)]) `shouldBe` (0, [cut])
        picture <- readFile (folder ++ "/net.svg")
        let taxels = [read count | line <- lines out, (count, "raised") <- neighbours line]
            neighbours line = zip (words line) (drop 1 (words line))
        -- Four units are a millimetre, and a taxel is a sixteenth of 25.4 mm.
        abs (sum (map signedArea (symbolsOn picture))) / 16 / (25.4 / 16) ^ (2 :: Int)
          `shouldSatisfy` \found -> [True] == [abs (one - found) < 0.5 | one <- taxels]
  it "objects and drawings go to a folder, each under a name of its own" $
    inFolder $ \folder -> do
      (status, _, _) <-
        scripted folder $
          "pra emboss --output made > log; "
            ++ "pra emboss --format svg --object cube --output drawn > log"
      status `shouldBe` 0
      made <- listDirectory (folder ++ "/made")
      sort made `shouldBe` ["cube.stl", "parallelepiped.stl"]
      drawn <- listDirectory (folder ++ "/drawn")
      length drawn `shouldBe` 6
      drawn `shouldSatisfy` elem "cube.C1-C2-C3-C4.svg"
  it "the embossed mesh, pressed in place of the object, gives the same frames on every face" $
    inFolder $ \folder -> do
      (status, _, _) <- scripted folder "pra emboss --output made > log"
      status `shouldBe` 0
      let chosen = byEffort (take 1 . drop 5) id (zip [1 :: Int ..] faces)
      for_ chosen $ \(seed, (object', face)) -> do
        let press =
              "pra probe --sensor ideal --seed " ++ show seed
                ++ (" --object " ++ object' ++ " --face '" ++ face ++ "' ")
        (_, out, _) <-
          scripted folder $
            "rm -rf f g; " ++ press ++ "--output f > log; "
              ++ press
              ++ ("--mesh made/" ++ object' ++ ".stl --output g > log; diff -r f g; ")
              ++ "pra decode g | head -1 | cut -d, -f1-2"
        out `shouldBe` object' ++ ", face " ++ face ++ "\n"
  it "a plate is pressed where its face was, also of symbols twice as large, at any angle" $
    inFolder $ \folder -> do
      (status, out, err) <-
        scripted folder $
          "pra place b=box:200x260x100 --symbols 2 --output p.json > log 2>&1; "
            ++ "on='--placement p.json --object b --face V1,V2,V3,V4'; "
            ++ "pra emboss $on --output b.stl > log; "
            ++ "pra probe $on --mesh b.stl --turn 30 --sensor real --taxel 3.175 --seed 3 "
            ++ "--output f --truth t > log; "
            ++ "pra decode --placement p.json f --json > a; pra compare --placement p.json a t"
      (status, err) `shouldBe` (0, "")
      lines out `shouldSatisfy` any ("they agree to " `isPrefixOf`)
  describe "a mesh that is not pressed" $ do
    it "is open" . refusedWith "is no closed surface" $
      "pra emboss --object cube --format json --output c.json > log; "
        ++ "sed 's/,\\[\"C1\",[^]]*\\]//' c.json > open.json; "
        ++ "pra probe --object cube --mesh open.json --seed 1 --output f"
    it "lies elsewhere" . refusedWith "does not lie where the placement has the face" $
      "pra emboss --object parallelepiped --output p.stl > log; "
        ++ "pra probe --object cube --mesh p.stl --seed 1 --output f"
    it "is a file of another kind" . refusedWith "needed here" $
      "(echo solid; echo facets) > c.stl; "
        ++ "pra probe --object cube --mesh c.stl --seed 1 --output f"
  describe "refused is" $
    for_
      [ ( "a net of a face",
          "--face",
          "pra emboss --net --object cube --face 'C1 C2 C3 C4' --output x"
        ),
        ( "a net as a surface",
          "--format",
          "pra emboss --net --object cube --format stl --output x"
        ),
        ( "a plate too thin",
          "--thickness",
          "pra emboss --object cube --face 'C1 C2 C3 C4' --thickness 1 --output x"
        ),
        ( "a thickness of a drawing",
          "--thickness",
          "pra emboss --format svg --object cube --face 'C1 C2 C3 C4' --thickness 9 --output x"
        ),
        ( "pages of what is no net",
          "--net",
          "pra emboss --object cube --page 210x297 --output x"
        ),
        ("a face of no object", "--object", "pra emboss --face 'C1 C2 C3 C4' --output x"),
        ("an object that there is not", "ball", "pra emboss --object ball --output x"),
        ( "a face that there is not",
          "C1 C2 C9",
          "pra emboss --object cube --face 'C1 C2 C9' --output x"
        ),
        ( "a face without a cell",
          "has no place on the array",
          "pra place t=box:60x60x40 --face 't:V1 V2 V3 V4' --output p.json > log 2>&1; "
            ++ "pra emboss --placement p.json --object t --face 'V5 V8 V7 V6' --output x"
        ),
        ( "a folder that holds files",
          "is not empty",
          "mkdir x; touch x/y; pra emboss --output x"
        ),
        ( "an ending that stands for no format",
          "c.step ends in none of .stl, .obj, .3mf, .json, .svg",
          "pra emboss --object cube --output c.step"
        ),
        ( "an ending of another format than is asked for",
          "c.obj does not end in .stl",
          "pra emboss --object cube --format stl --output c.obj"
        ),
        ( "a net that ends as a surface",
          "c.stl does not end in .svg",
          "pra emboss --net --object cube --output c.stl"
        ),
        ( "a folder that is called as a file",
          "out.3mf is the name of a file",
          "pra emboss --output out.3mf"
        ),
        ( "drawings of several faces as one file",
          "c.svg is the name of a file",
          "pra emboss --object cube --output c.svg"
        ),
        ("a full device", "no space left", "pra emboss --object cube --output /dev/full"),
        ( "a point that is no fraction, as one",
          "are no fractions",
          "pra place tetrahedron:120 --output p.json > log; "
            ++ "pra emboss --placement p.json --object tetrahedron --format json --output x"
        ),
        ( "what coordinates of 32 bits melt",
          "coordinates of 32 bits",
          "pra place t=box:3/1000000x4/1000000x1000 --symbols 1/10000000 "
            ++ "--face 't:V1 V2 V3 V4' --output p.json > log 2>&1; "
            ++ "pra emboss --placement p.json --object t --output x"
        )
      ]
      $ \(name, about, script) -> it name (refusedWith about script)
  it "a page too small for a face is refused: the question is well formed, the answer is no" $
    inFolder $ \folder -> do
      (status, out, err) <-
        scripted folder "pra emboss --net --page 120x297 --object cube --output x"
      (status, out, length (lines err)) `shouldBe` (1, "", 1)
      err
        `shouldSatisfy` isInfixOf
          "the face C2 C6 C7 C3 of the cube has no room on a page of 120 x 297 mm"
      listDirectory folder `shouldReturn` []
  it "admesh finds nothing to mend in it" $
    findExecutable "admesh" >>= \there -> case there of
      Nothing -> pendingWith "admesh is not installed here: apt-get install admesh"
      Just _ -> inFolder $ \folder -> do
        (status, out, _) <-
          scripted folder $
            "pra emboss --object cube --output c.stl > log; admesh c.stl | grep -E '^("
              ++ "Total disconnected|Degenerate|Edges fixed|Facets (removed|added|reversed)|"
              ++ "Backwards|Normals)'"
        (status, map (last . words) (lines out)) `shouldBe` (0, replicate 8 "0")
  it "the drawings of all faces, rasterised and turned to light on dark, are decoded" $
    findExecutable "rsvg-convert" >>= \there -> case there of
      Nothing -> pendingWith "rsvg-convert is not installed here: apt-get install librsvg2-bin"
      Just _ -> inFolder $ \folder -> do
        _ <- scripted folder "pra emboss --format svg --output drawn > log"
        drawn <- filter (".svg" `isSuffixOf`) <$> listDirectory (folder ++ "/drawn")
        length drawn `shouldBe` 12
        for_ (byEffort (take 3) id drawn) $ \file -> do
          (code, _, err) <-
            readProcessWithExitCode
              "rsvg-convert"
              (words "-d 16 -p 16 -b white -o" ++ [folder ++ "/r.png", folder ++ "/drawn/" ++ file])
              ""
          (code, err) `shouldBe` (ExitSuccess, "")
          picture <- readImage (folder ++ "/r.png") >>= either fail (pure . convertRGB8)
          Bytes.writeFile (folder ++ "/r.pgm") (negative picture)
          (_, out, _) <- pra ["decode", folder ++ "/r.pgm"]
          let (object', rest) = break (== '.') file
              face = map (\c -> if c == '-' then ' ' else c) (takeWhile (/= '.') (drop 1 rest))
          out `shouldStartWith` (object' ++ ", face " ++ face ++ ", corner ")
  it "a net has every symbol of the object, at true scale and within its paper" $
    inFolder $ \folder -> do
      (status, _, _) <- scripted folder "pra emboss --net --object cube --output n.svg > log"
      status `shouldBe` 0
      text <- readFile (folder ++ "/n.svg")
      let numbers mark = map read . words . map spaced . takeWhile (/= '"') <$> after mark text
          symbols = symbolsOn text
          -- Four units a millimetre.
          taxel = (4 * 1.5875) ^ (2 :: Int)
      length symbols `shouldBe` 120
      sum (map (abs . signedArea) symbols) / taxel
        `shouldSatisfy` \taxels -> abs (taxels - 6480) < 0.1
      case numbers "viewBox=\"" of
        [[0, 0, wide, high]] ->
          concat symbols `shouldSatisfy` all (\(x, y) -> x > 0 && x < wide && y > 0 && y < high)
        _ -> expectationFailure text
  it "on pages a net has each face and each edge, at true scale, and none beyond its page" $
    inFolder $ \folder -> do
      (status, _, _) <- scripted folder "pra emboss --net --page 210x297 --output pages > log"
      status `shouldBe` 0
      pages <- listDirectory (folder ++ "/pages")
      for_ [("cube", 6, 120, 12), ("parallelepiped", 6, 108, 12)] $
        \(object', faces', symbols', edges) -> do
          texts <- for (filter ((object' ++ ".") `isPrefixOf`) pages) $ \page ->
            readFile (folder ++ "/pages/" ++ page)
          let marks name = length (concatMap (after ("class=\"" ++ name ++ "\"")) texts)
              written name =
                [ takeWhile (/= '<') (drop 1 (dropWhile (/= '>') line))
                  | line <- concatMap lines texts,
                    "<text " `isPrefixOf` line,
                    ("class=\"" ++ name ++ "\"") `isInfixOf` line
                ]
              labels = map (takeWhile (/= ' ')) (written "number")
          (marks "symbol", length (written "face")) `shouldBe` (symbols', faces')
          -- What is not folded is cut, and has the same number on both faces.
          let folds = length (concatMap (after "class=\"ridge\"") texts) - legends texts
          sort labels
            `shouldBe` sort (concat [[show k, show k] | k <- [1 .. edges - folds]])
          for_ texts $ \text -> do
            take 1 (after "width=" text) `shouldSatisfy` all ("\"210mm\"" `isPrefixOf`)
            take 1 (after "height=" text) `shouldSatisfy` all ("\"297mm\"" `isPrefixOf`)
            let points = concatMap (inPairs . numbersOf) (after "points=\"" text)
            points `shouldSatisfy` all (\(x, y) -> x >= 0 && x <= 840 && y >= 0 && y <= 1188)
  it "all parts of a drawing lie on its paper" $
    inFolder $ \folder -> do
      _ <- scripted folder "pra emboss --format svg --output drawn > log"
      drawn <- listDirectory (folder ++ "/drawn")
      for_ drawn $ \file -> do
        text <- readFile (folder ++ "/drawn/" ++ file)
        let numbers mark = map read . words . map spaced . takeWhile (/= '"') <$> after mark text
            points = concatMap inPairs (numbers " d=\"")
        length points `shouldSatisfy` (> 100)
        case numbers "viewBox=\"" of
          [[0, 0, wide, high]] ->
            points `shouldSatisfy` all (\(x, y) -> x > 0 && x < wide && y > 0 && y < high)
          _ -> expectationFailure text
  where
    faces =
      [ ("cube", face)
        | face <-
            [ "C2 C6 C7 C3",
              "C3 C7 C8 C4",
              "C4 C8 C5 C1",
              "C1 C2 C3 C4",
              "C1 C5 C6 C2",
              "C6 C5 C8 C7"
            ]
      ]
        ++ [ ("parallelepiped", face)
             | face <-
                 [ "P1 P2 P3 P4",
                   "P6 P5 P8 P7",
                   "P2 P6 P7 P3",
                   "P4 P8 P5 P1",
                   "P3 P7 P8 P4",
                   "P1 P5 P6 P2"
                 ]
           ]
    -- What follows the mark, each time that it is there.
    after mark = mapMaybe (stripPrefix mark) . tails
    numbersOf = map read . words . map spaced . takeWhile (/= '"')
    -- The outlines of the symbols of a net. The order of attributes is no promise of the library
    -- that writes them.
    symbolsOn text =
      [ inPairs (numbersOf points)
        | element <- after "<" text,
          "class=\"symbol\"" `isInfixOf` takeWhile (/= '>') element,
          points <- take 1 (after "points=\"" (takeWhile (/= '>') element))
      ]
    -- A page that has folds shows one in its legend.
    legends = length . filter (not . null . after "fold away")
    spaced c = if c `elem` ("MLz," :: String) then ' ' else c
    inPairs given = case given of
      x : y : others -> (x, y) : inPairs others
      _ -> [] :: [(Double, Double)]

-- | A block of 110 mm, turned by the quaternion (7, 1, 2, 1), whose matrix has fractions over 55,
-- and moved by 10^12 mm along some axes.
tiltedBlock :: [Int] -> String
tiltedBlock axes =
  unlines $
    [ unwords ("v" : zipWith (\axis c -> show (c + away axis)) [0 ..] point)
      | (x, y, z) <- corners,
        let point = [90 * x - 20 * y + 60 * z, 36 * x + 102 * y - 20 * z, 36 * y + 90 * z - 52 * x]
    ]
      ++ ["f 4 3 2 1", "f 1 2 6 5", "f 2 3 7 6", "f 3 4 8 7", "f 4 1 5 8", "f 5 6 7 8"]
  where
    away axis = if axis `elem` axes then 10 ^ (12 :: Int) else 0 :: Integer
    corners = [(x, y, z) | z <- [1, 0], (x, y) <- [(0, 0), (0, 1), (1, 1), (1, 0)]]

-- | The program that reads a 3MF by Python's own libraries: the unit, the object's name, how many
-- vertices and triangles there are, how many sides have no other way back, the volume, and the
-- years of the archive's files.
readModel :: String
readModel =
  unlines
    [ "import sys, zipfile, collections, xml.etree.ElementTree as tree",
      "from fractions import Fraction",
      "archive = zipfile.ZipFile(sys.argv[1])",
      "years = sorted({file.date_time[0] for file in archive.infolist()})",
      "model = tree.fromstring(archive.read('3D/3dmodel.model'))",
      "space = '{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}'",
      "points = [[Fraction(v.get(k)) for k in 'xyz'] for v in model.iter(space + 'vertex')]",
      "triangles = model.iter(space + 'triangle')",
      "walks = [[int(t.get(k)) for k in ('v1', 'v2', 'v3')] for t in triangles]",
      "sides = collections.Counter((w[i], w[i - 2]) for w in walks for i in range(3))",
      "open_ = [s for s in sides if sides[s] != 1 or sides[s[::-1]] != 1]",
      "def determinant(a, b, c):",
      "    return (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])",
      "            + a[2] * (b[0] * c[1] - b[1] * c[0]))",
      "volume = sum(determinant(*(points[i] for i in w)) for w in walks) / 6",
      "named = next(model.iter(space + 'object')).get('name')",
      "print(model.get('unit'), named, len(points), len(walks), len(open_), volume, years)"
    ]

-- | The script ends with a refusal that says this, and writes nothing called x or f.
refusedWith :: String -> String -> Expectation
refusedWith about script = inFolder $ \folder -> do
  outcome <- scripted folder script
  outcome `refuses` about
  left <- listDirectory folder
  filter (`elem` ["f", "x.part"]) left `shouldBe` []

-- | A picture's negative as a PGM file.
negative :: Image PixelRGB8 -> Bytes.ByteString
negative picture =
  Char8.pack ("P5\n" ++ show wide ++ " " ++ show high ++ "\n255\n")
    <> Bytes.pack [255 - grey (pixelAt picture x y) | y <- [0 .. high - 1], x <- [0 .. wide - 1]]
  where
    (wide, high) = (imageWidth picture, imageHeight picture)
    grey (PixelRGB8 r g b) =
      let parts = zipWith (*) [299, 587, 114] (map fromIntegral [r, g, b])
       in fromIntegral (sum parts `div` 1000 :: Int)
