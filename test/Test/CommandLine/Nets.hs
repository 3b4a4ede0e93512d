-- | Nets and pictures of solids, as scripts ask for them.
module Test.CommandLine.Nets (spec) where

import Data.Foldable (for_)
import Data.List (isInfixOf, isPrefixOf, stripPrefix, tails)
import Data.Maybe (isNothing, mapMaybe)
import System.Directory
import System.FilePath ((</>))
import System.Process (readProcess)
import Test.CommandLine.Run
import Test.Hspec
import Test.Support

spec :: Spec
spec = do
  it "a solid of several pieces has no unfolding, which is status 1" $
    inFolder $ \folder -> do
      (status, out, err) <-
        scripted
          folder
          "pra solid box:9x9x9 --output a.obj > log; \
          \{ cat a.obj; \
          \awk '/^v /{print \"v\", $2 + 50, $3, $4} \
          \/^f /{print \"f\", $2 + 8, $3 + 8, $4 + 8, $5 + 8}' a.obj; } > two.obj; \
          \pra nets two.obj --svg nets"
      (status, take 1 (lines out), err)
        `shouldBe` (1, ["two: 0 unfoldings, since it is of several pieces"], "")
      doesPathExist (folder </> "nets") `shouldReturn` False
  it "an object that is no solid is refused, with the first of its defects" $
    inFolder $ \folder -> do
      (status, out, err) <-
        scripted
          folder
          "pra solid tetrahedron:9 --output t.off > log; sed '$d; s/^4 4/4 3/' t.off > o.off; \
          \pra nets o.off"
      (status, out, length (lines err)) `shouldBe` (2, "", 1)
  it "a folder that holds files is refused and not changed" $
    inFolder $ \folder -> do
      writeFile (folder </> "mine") "mine"
      complains ["nets", "tetrahedron:9", "--svg", folder] "not empty"
      listDirectory folder `shouldReturn` ["mine"]
  it "a net is drawn at true scale" $
    inFolder $ \folder -> do
      _ <- pra ["nets", "box:20x30x50", "--svg", folder </> "b"]
      listDirectory (folder </> "b") `shouldReturn` ["net.svg"]
      drawing <- readFile (folder </> "b" </> "net.svg")
      let page = attribute "viewBox" drawing
          size = attribute "width" drawing ++ attribute "height" drawing
      -- Four units are a millimetre.
      map (4 *) size `shouldSatisfy` and . zipWith near (drop 2 page)
      -- The faces have 2 (20 x 30 + 20 x 50 + 30 x 50) square millimetres.
      abs (signedArea (pairs (points "cut" drawing))) `shouldSatisfy` near (16 * 6200)
  it "every picture is read by another program" $
    inFolder $ \folder -> do
      drawn folder
      there <- findExecutable "rsvg-convert"
      if isNothing there
        then pendingWith "rsvg-convert is not installed here (librsvg2-bin)"
        else for_ pictures $ \(name, _) -> do
          bytes <- readProcess "rsvg-convert" ["--format=svg", folder </> name] ""
          length bytes `shouldSatisfy` (> 1000)
  it "nothing is drawn beyond the page" $
    inFolder $ \folder -> do
      drawn folder
      _ <- pra ["nets", "l:30x20x40", "--svg", folder </> "nets"]
      for_ (("nets" </> "net.svg") : map fst pictures) $ \name -> do
        picture <- readFile (folder </> name)
        let places = pairs (concatMap (attribute "points") (lines picture))
        case attribute "viewBox" picture of
          [0, 0, wide, high] ->
            [p | p@(x, y) <- places, x < 0 || y < 0 || x > wide || y > high] `shouldBe` []
          other -> expectationFailure (show other)
  it "a picture of a solid has the names of the vertices that are seen" $
    inFolder $ \folder -> do
      drawn folder
      seen <- readFile (folder </> "cube.svg")
      [v | k <- [1 .. 8 :: Int], let v = "C" ++ show k, (">" ++ v ++ "<") `isInfixOf` seen]
        `shouldBe` ["C1", "C2", "C3", "C4", "C6", "C7", "C8"]
  it "the array is drawn in as many symbols as it has, and the faces by their names" $
    inFolder $ \folder -> do
      drawn folder
      sheet <- readFile (folder </> "sheet.svg")
      occurrences "class=\"symbol\"" sheet `shouldBe` 255
      placed <- readFile (folder </> "placement.svg")
      occurrences "class=\"taken\"" placed `shouldBe` 228
      occurrences "class=\"face\"" placed `shouldBe` 12
  it "an encoded object has its symbols on the faces that are seen, and no other" $
    inFolder $ \folder -> do
      drawn folder
      seen <- readFile (folder </> "encoded.svg")
      -- Each of the three faces has one path, and each of its symbols several rows.
      occurrences "class=\"embossed\"" seen `shouldBe` 3
  it "a solid is seen from 30,25 unless --from says another place" $
    inFolder $ \folder -> do
      let seen name from = do
            (status, _, _) <- pra (["draw", "solid", "--output", folder </> name] ++ from)
            status `shouldBe` 0
            readFile (folder </> name)
      usual <- seen "usual.svg" []
      seen "told.svg" ["--from", "30,25"] `shouldReturn` usual
      seen "other.svg" ["--from", "25,30"] >>= (`shouldNotBe` usual)
  it "options that a picture does not use are refused" $ do
    complains ["draw", "sheet", "--from", "1,2", "--output", "x.svg"] "--from"
    complains ["draw", "placement", "--object", "cube", "--output", "x.svg"] "--object"
    complains ["draw", "encoded", "--object", "l:9x9x9", "--output", "x.svg"] "l:9x9x9"
    complains ["draw", "solid", "--output", "x.png"] ".svg"
    complains ["draw", "cube", "--output", "x.svg"] "solid"
  where
    drawn folder =
      for_ pictures $ \(name, arguments) ->
        pra (("draw" : arguments) ++ ["--output", folder </> name])
          `shouldReturn` (0, "wrote " ++ folder </> name ++ "\n", "")
    near a b = abs (a - b) < 0.1 * max 1 (abs b / 1000)
    occurrences what text = length (filter (what `isPrefixOf`) (tails text))

pictures :: [(FilePath, [String])]
pictures =
  [ ("cube.svg", ["solid"]),
    ("l.svg", ["solid", "--object", "l:200x100x200", "--from=-40,30"]),
    ("sheet.svg", ["sheet"]),
    ("placement.svg", ["placement"]),
    ("encoded.svg", ["encoded", "--object", "cube"])
  ]

-- | The numbers of the first attribute of this name.
attribute :: String -> String -> [Double]
attribute name text =
  case mapMaybe (stripPrefix (' ' : name ++ "=\"")) (tails text) of
    found : _ -> numbers (takeWhile (/= '"') found)
    [] -> []

-- | The numbers of the points of a mark of this class.
points :: String -> String -> [Double]
points name text =
  concat
    [ attribute "points" line
      | line <- lines text,
        ("class=\"" ++ name ++ "\"") `isInfixOf` line,
        "<polygon" `isPrefixOf` line
    ]

numbers :: String -> [Double]
numbers text = case dropWhile (`notElem` numeric) text of
  "" -> []
  rest -> let (one, others) = span (`elem` numeric) rest in read (padded one) : numbers others
  where
    numeric = "-.0123456789"
    padded one = case one of
      '-' : more -> '-' : padded more
      '.' : _ -> '0' : one
      _ -> one

pairs :: [a] -> [(a, a)]
pairs (x : y : rest) = (x, y) : pairs rest
pairs _ = []
