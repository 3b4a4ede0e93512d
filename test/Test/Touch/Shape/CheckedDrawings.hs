{-# LANGUAGE OverloadedStrings #-}

-- | Tests drawings against the rules: in the library, and with an independent checker in Python.
module Test.Touch.Shape.CheckedDrawings (spec) where

import Control.Monad (when)
import qualified Data.ByteString.Char8 as Bytes
import Data.Foldable (for_)
import Data.List (tails)
import Data.Text (Text)
import qualified Data.Text as T
import qualified Data.Text.Encoding as T
import qualified Data.Text.IO as T
import PraTactile.Classification.Shipped
import PraTactile.Format.Shapes
import PraTactile.Shape
import PraTactile.Shape.Check
import PraTactile.Shape.Clique
import PraTactile.Shape.Design
import PraTactile.Shape.Distance
import PraTactile.Symmetry
import System.Directory (findExecutable)
import System.Exit (ExitCode (..))
import System.FilePath ((</>))
import System.Process (readProcessWithExitCode)
import Test.Effort (byEffort, whenFull)
import Test.Hspec
import Test.QuickCheck
import Test.Support

spec :: Spec
spec = do
  for_ shippedSizes $ \q -> describe ("the alphabet shipped for GF(" ++ show q ++ ")") $ do
    it "has a shape for each element, no fault, and the greatest possible least distance" $ do
      a <- right (shippedAlphabet q)
      (alphabetSize a, faults (alphabetDrawings a)) `shouldBe` (q, [])
      Just (separation a) `shouldBe` greatestPossible q
    it "has the faults and distances that the checker in Python finds" $ do
      a <- right (shippedAlphabet q)
      checkedInPython (alphabetDrawings a) >>= mapM_ (`shouldBe` ExitSuccess)
  it "library and checker find each fault where it is the only possible one" $
    for_ drawnFaults $ \(kinds, rows) -> do
      a <- right (drawing [("x", rows)])
      faults a `shouldBe` map (Fault "x") kinds
      -- One that is drawn by taxels, and one of several faults.
      when (byEffort (kinds `elem` [[Stroke], [Side, Area, OwnImage]]) True) $
        checkedInPython a >>= mapM_ (`shouldBe` ExitFailure 1)
  it "shapes are too near below 32 taxels, however each is turned, mirrored or shifted" $ do
    four <- right (shippedAlphabet 4)
    let first = take 1 (zip ["a"] (shapes four))
        second kept =
          [ ("b", bitmapWhere (\x y -> embossedAt (mirroredRows b) x y /= kept x y))
            | (_, b) <- first
          ]
    for_ [second (\x y -> x < 2 && y < 2), [("b", b) | (_, b) <- first]] $ \other -> do
      near <- right (toDrawings (first ++ other))
      [fault | fault@(Fault _ TooNear) <- faults near] `shouldBe` [Fault "b" TooNear]
      checkedInPython near >>= mapM_ (`shouldBe` ExitFailure 1)
  it "nearest gives the least distance by definition, and where it is attained" $
    property . withMaxSuccess 30 $
      forAll ((,) <$> shape <*> shape) $ \(a, b) ->
        let Nearest d symmetry (x, y) = nearest symmetries a b
         in conjoin
              [ d === minimum [distance s a b | s <- symmetries],
                d === distance symmetry a b,
                d
                  === length
                    [() | u <- [-4 .. 12], v <- [-4 .. 16], differ symmetry (x, y) u v a b],
                property (abs x <= 1 && abs y <= 1)
              ]
  whenFull $ do
    it "three shapes are never 50 apart, four never 46, five never 42: by all shapes" $ do
      let all' = [(b, selfDistance b, prepared b) | b <- families]
          -- One of each family: all of a family are equally far from any shape.
          families = [b | b <- admissible paperParameters, b == minimum (family b)]
          apart d = [p | (_, self, p) <- all', self >= d]
          none count d = maybe True (const False) (clique count (farApart d) (apart d))
      map (uncurry none) [(2, 50), (4, 46), (5, 42)] `shouldBe` [True, True, True]
      map (uncurry none) [(1, 56), (3, 48), (4, 44)] `shouldBe` [False, False, False]
    it "the shapes for three elements are the design's from its seed" $ do
      shipped <- T.readFile "data/alphabets/gf3/shapes.txt"
      fmap (renderAlphabet . fst) (design paperSeed (parametersFor ["0", "1", "A"]))
        `shouldBe` Right shipped
  it "for more than four shapes the design picks one by its seed, and states that" $ do
    -- There are few shapes of few blocks, so that this is quick.
    let few = (parametersFor ["a", "b", "c", "d", "e"]) {leastBlocks = 12, mostBlocks = 12}
    (a, report) <- right (design 1 few)
    reportAlphabets report `shouldBe` Nothing
    reportSeparation report `shouldBe` separation a
    whenFull $ do
      (b, _) <- right (design 2 few)
      separation b `shouldBe` separation a
  where
    -- Whether taxel (u, v) of the first's box, or beside it, differs from that of the second, which
    -- is transformed about the boxes' common middle and then shifted.
    differ symmetry (x, y) u v a b = embossedAt a u v /= turnedAt symmetry b (u - x) (v - y)
    turnedAt symmetry b u v = case drop' (v - top) seen of
      row : _ | on : _ <- drop' (u - left) row -> on
      _ -> False
      where
        seen = onRows symmetry (bitmapRows b)
        (top, left) = if exchangesAxes symmetry then (2, -2) else (0, 0)
    drop' n list = if n < 0 then [] else drop n list
    shape = do
      rows <- vectorOf 12 (vectorOf 8 arbitrary)
      pure (bitmapWhere (\x y -> (rows !! y) !! x))

-- | The result of the checker in Python on the drawings and on the program's statements. The
-- example is pending without Python.
checkedInPython :: Drawings -> IO [ExitCode]
checkedInPython a = do
  python <- findExecutable "python3"
  case python of
    Nothing -> [] <$ pendingWith "python3 is not installed here, so its checker was not tried"
    Just executable -> inFolder $ \folder -> do
      let file = folder </> "shapes.txt"
          report = folder </> "report.json"
      T.writeFile file (renderDrawings a)
      Bytes.writeFile report (encodeShapes a)
      (status, out, err) <-
        readProcessWithExitCode executable ["data/check_shapes.py", file, report] ""
      (err, "wrong is" `elem` pairsOfWords out) `shouldBe` ("", False)
      pure [status]
  where
    pairsOfWords text = [unwords two | two@[_, _] <- map (take 2) (tails (words text))]

drawing :: [(Text, [String])] -> Either ShapeError Drawings
drawing named = decodeDrawings (T.encodeUtf8 (T.unlines (concatMap one named)))
  where
    one (name, rows) = ("symbol " <> name) : concatMap twice rows
    twice row = if length row == 8 then [T.pack row] else [doubled row, doubled row]
    doubled = T.pack . concatMap (\c -> [c, c])

-- | Drawings with one fault each: a row of 4 blocks, or of 8 taxels. Where whole blocks meet only
-- at a corner, two flat blocks of one piece are separated as well; and a blank shape has nothing
-- along its sides and is its own image.
drawnFaults :: [([ShapeFault], [String])]
drawnFaults =
  [ ([Side], ["...#", "#.##", "#.#.", "###.", "..##", "###."]),
    ( [Stroke],
      concatMap (replicate 2) ["######..", "..##....", "########"]
        ++ ["##......", ".#......"]
        ++ concatMap (replicate 2) ["####....", "..######"]
    ),
    ([Stroke, Hole], ["..##", "..#.", "###.", "#..#", "####", "#..#"]),
    ([Pieces], ["#..#", "..##", "#.#.", "###.", "..#.", ".##."]),
    ([Hole], ["#..#", "####", "#.#.", "###.", "..#.", ".##."]),
    ([Area], ["###.", "####", "#.##", "#..#", "##..", "##.."]),
    ([OwnImage], ["###.", "##..", ".##.", "..##", "...#", ".###"]),
    ([Side, Area, OwnImage], replicate 6 "....")
  ]
