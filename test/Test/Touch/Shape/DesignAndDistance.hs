{-# LANGUAGE OverloadedStrings #-}

-- | Tests shapes: bitmaps, alphabets, distances, the design, and ordinary features.
module Test.Touch.Shape.DesignAndDistance (spec) where

import Control.Monad (replicateM)
import Data.Bits (testBit)
import Data.List (nub, sort, tails, transpose)
import qualified Data.Set as Set
import qualified Data.Text as T
import qualified Data.Text.IO as T
import PraTactile.Image (toRows)
import PraTactile.Shape
import PraTactile.Shape.Clique
import PraTactile.Shape.Design
import PraTactile.Shape.Distance
import PraTactile.Shape.Report
import PraTactile.Symmetry
import Test.Effort (byEffort, whenFull)
import Test.Hspec
import Test.QuickCheck
import Test.Support (right)
import Test.Touch.Paper (paperAlphabet)

spec :: Spec
spec = do
  describe "Bitmap" $ do
    it "takes 12 rows of 8 and gives them back" $
      property $ forAll rowsOfBits $ \rows -> fmap bitmapRows (bitmap rows) === Right rows
    it "refuses any other number of rows" $
      fmap area (bitmap (replicate 11 (replicate 8 True))) `shouldBe` Left (WrongRowCount 11)
    it "refuses a row of any other width, and names it" $
      fmap
        area
        ( bitmap
            ( replicate 5 (replicate 8 True)
                ++ [replicate 9 True]
                ++ replicate 6 (replicate 8 False)
            )
        )
        `shouldBe` Left (WrongRowWidth 5 9)
    it "embosses nothing outside its box" $
      property $
        forAll shapeGen $ \b ->
          and
            [ not (embossedAt b x y)
              | x <- [-2 .. 9],
                y <- [-2 .. 13],
                x < 0 || x > 7 || y < 0 || y > 11
            ]
    it "has as its area the number of embossed taxels" $
      property $ forAll shapeGen $ \b -> area b === length (filter id (concat (bitmapRows b)))
    it "is an image of ones and zeros" $
      property $
        forAll shapeGen $ \b ->
          toRows (toRaster b) === map (map (\e -> if e then 1 else 0)) (bitmapRows b)

  describe "Symmetries" $ do
    it "turn clockwise: the first row of a quarter turn is the first column from below" $
      property $
        forAll shapeGen $ \b ->
          take 1 (onRows (turned 1) (bitmapRows b)) === [reverse (map (head' False) (bitmapRows b))]
    it "have as many embossed taxels as the shape" $
      property $
        forAll shapeGen $ \b ->
          [length (filter id (concat (onRows s (bitmapRows b)))) | s <- symmetries]
            === (area b <$ symmetries)
    it "are eight different ones" $
      length (nub [onRows s (bitmapRows corner) | s <- symmetries]) `shouldBe` 8
    it "half turn = both mirrors, and each is its own inverse" $
      property $
        forAll shapeGen $ \b ->
          (halfTurned b, map (\f -> f (f b)) [halfTurned, mirroredColumns, mirroredRows])
            === (mirroredRows (mirroredColumns b), [b, b, b])

  describe "Alphabet" $ do
    it "is read as it was drawn" $
      property $ forAll alphabetGen $ \a -> parseAlphabet (renderAlphabet a) === Right a
    it "refuses an empty alphabet, a blank or repeated shape, a repeated name, and a line break" $
      map
        (either Just (const Nothing) . alphabet)
        [ [],
          [("a", blank)],
          [("a", corner), ("a", halfTurned corner)],
          [("a", corner), ("b", corner)],
          [("a\nb", corner)]
        ]
        `shouldBe` map
          Just
          [EmptyAlphabet, BlankShape "a", RepeatedName "a", RepeatedShape "a" "b", BadName "a\nb"]
    it "has at most 256 shapes" $ do
      let drawn n = bitmapWhere (\x y -> y == 2 || y < 2 && testBit n (x + 8 * y))
          alphabetOf count = alphabet [(T.pack (show n), drawn n) | n <- [1 .. count :: Int]]
      map (fmap alphabetSize . alphabetOf) [256, 257] `shouldBe` [Right 256, Left TooManyShapes]
    it "has a shape for each class and no other" $
      property $
        forAll alphabetGen $ \a ->
          map (shapeOf a) [-1 .. alphabetSize a]
            === [Left (UnknownClass (-1) n) | n <- [alphabetSize a]]
              ++ map Right (shapes a)
              ++ [Left (UnknownClass n n) | n <- [alphabetSize a]]
    it "a drawing may have comments, empty lines and spaces at the ends of lines" $
      parseAlphabet ("; a comment\n\nsymbol x  \n" <> T.replace "\n" " \r\n" (drawBitmap corner))
        `shouldBe` alphabet [("x", corner)]
    it "a malformed drawing is refused with its line" $
      map
        (either Just (const Nothing) . parseAlphabet)
        [ "",
          "########\n",
          "symbol x\n#.x\n",
          "symbol x\n##\n",
          "symbol a\n" <> drawBitmap corner <> "symbol b\n" <> T.replicate 12 ".......\n"
        ]
        `shouldBe` map
          Just
          [ EmptyAlphabet,
            RowWithoutSymbol 1,
            UnreadableLine 2 "#.x",
            BadDrawing 1 (WrongRowCount 1),
            BadDrawing 14 (WrongRowWidth 0 7)
          ]

  describe "Distance" $ do
    it "equals its definition: taxels counted one by one over all nine shifts" $
      property $
        withMaxSuccess 30 $
          forAll ((,,) <$> elements symmetries <*> shapeGen <*> shapeGen) $ \(s, a, b) ->
            distance s a b === countedDistance s a b
    it "is symmetric for the symmetries that are their own inverses" $
      property $
        forAll ((,) <$> shapeGen <*> shapeGen) $ \(a, b) ->
          [distance s a b | s <- selfInverse] === [distance s b a | s <- selfInverse]
    it "is 0 between a shape and itself" $
      property $ forAll shapeGen $ \b -> distance identity b b === 0
    it "is 0 between a shape and its copy shifted by a taxel" $
      property $
        forAll shapeGen $ \b ->
          let inner = bitmapWhere (\x y -> x > 0 && embossedAt b x y)
              shifted = bitmapWhere (\x y -> x < 7 && embossedAt b (x + 1) y)
           in distance identity inner shifted === 0
    it "farApart d holds just when every distance is at least d" $
      property $
        withMaxSuccess 50 $
          forAll ((,) <$> shapeGen <*> shapeGen) $ \(a, b) ->
            let d =
                  minimum [distance s a b | s <- symmetries]
             in (farApart d (prepared a) (prepared b), farApart (d + 1) (prepared a) (prepared b))
                  === (True, False)

  describe "The shipped alphabet" $ do
    it "is read without refusal: four shapes named 0, 1, A, A^2" $
      fmap shapeNames paperAlphabet `shouldBe` Right ["0", "1", "A", "A^2"]
    whenFull $
      it "is the design's from its seed, to the bit" $ do
        shipped <- T.readFile "data/shapes.txt"
        fmap (renderAlphabet . fst) designed `shouldBe` Right shipped
    it "condition 1, orientation shows: turned or mirrored, 44 of 96 taxels differ" $
      onShipped $ \these ->
        minimum [countedDistance s b b | b <- these, s <- drop 1 symmetries] `shouldBe` 44
    it "condition 2, robust to position: turned and shifted, any two differ in 44 taxels" $
      onShipped $ \these ->
        minimum [countedDistance s a b | a : others <- tails these, b <- others, s <- symmetries]
          `shouldBe` 44
    it "condition 3, unlike ordinary features: no correlation with one exceeds 0.58" $
      onShipped $ \these ->
        maximum
          [ abs (correlation taxels other)
            | taxels <- map (map bit . concat . bitmapRows) these,
              other <- byEffort (everyNth 4) id windows
          ]
          `shouldSatisfy` (<= 0.58)
    it "symbol 0 is a real embossing, and all have 12 to 14 of 24 blocks: 48 to 56 taxels" $
      onShipped $ \these ->
        map area these `shouldSatisfy` all (\n -> n >= 48 && n <= 56 && n `mod` 4 == 0)
    it "every shape touches each side of its box along at least 4 taxels" $
      onShipped $ \these ->
        [ length (filter id side)
          | b <- these,
            let r = bitmapRows b,
            side <- take 1 r ++ drop 11 r ++ take 1 (transpose r) ++ drop 7 (transpose r)
        ]
          `shouldSatisfy` all (>= 4)
    it "every shape is connected by sides, and so is the flat part around it" $
      onShipped $ \these -> do
        map (pieces . embossedSet) these `shouldBe` map (const 1) these
        map (pieces . flatAround) these `shouldBe` map (const 1) these
    it "the separation of the shipped shapes is 44" $
      fmap separation paperAlphabet `shouldBe` Right 44

  describe "Design" $ do
    whenFull $ do
      -- A separate program counted the four numbers by visiting all 2^24 drawings and all sets of
      -- four. It found 2560 alphabets, ten times 4^4, at a separation of 44 and none at 46.
      -- Differences between shapes of whole blocks of four taxels are even.
      it "visits all 43608 admissible shapes; no separation exceeds 44, 10 alphabets have it" $
        fmap snd designed `shouldBe` Right (Report paperSeed 43608 10948 44 (Just 10))
      it "another seed only turns, mirrors and exchanges the shapes" $ do
        let familiesOf = Set.fromList . map family . shapes
        (found, _) <- right (design 1 paperParameters)
        familiesOf found `shouldBe` either (const Set.empty) familiesOf paperAlphabet
    it "the admissible shapes are whole families" $ do
      let found = admissible paperParameters {mostBlocks = byEffort 12 14}
          every = Set.fromList found
      null found `shouldBe` False
      filter (not . (`Set.isSubsetOf` every) . family) found `shouldBe` []
    it "draws every stack of rows that share a block and never meet only at a corner" $ do
      let rows = filter or (replicateM 4 [False, True])
          mayLie a b = or (zipWith (&&) a b) && not (any diagonal (zip (pairs a) (pairs b)))
          pairs list = zip list (drop 1 list)
          diagonal ((a, b), (c, d)) = a /= b && c /= d && a /= c
          -- The number of stacks that begin with each row, from those with one row less.
          more counts = [sum [n | (b, n) <- zip rows counts, mayLie a b] | a <- rows]
          counted = iterate more (map (const 1) rows)
      fmap sum (take 1 (drop 5 counted)) `shouldBe` [drawings]
    it "refuses constraints that no shape meets" $
      fmap fst (design 1 paperParameters {leastBlocks = 3, mostBlocks = 5})
        `shouldBe` Left NoAlphabet
    it "cliques are all sets of pairwise related items" $
      property $
        forAll (choose (0, 4)) $ \size -> forAll (listOf (choose (1, 30 :: Int))) $ \list ->
          let items = take 9 list
              related a b = odd (a + b) || a == b
           in cliques size related items
                === [ c
                      | c <- sublists items,
                        length c == size,
                        and [related a b | a : others <- tails c, b <- others]
                    ]
    it "clique finds one of the cliques, and none exactly if there is none" $
      property $
        forAll (choose (0, 5)) $ \size -> forAll (listOf (choose (1, 60 :: Int))) $ \list ->
          let items = take 12 list
              related a b = gcd a b == 1 || a == b
              all' = cliques size related items
           in case clique size related items of
                Nothing -> all' === []
                Just found ->
                  counterexample (show found) (sort found `elem` map sort all')
    it "the drawing shows as many taxels as the shapes have" $
      onShipped $ \these ->
        fmap (T.count "#" . drawAlphabet) paperAlphabet `shouldBe` Right (sum (map area these))
    it "the SVG picture has a square for every taxel, and a frame for every shape" $
      onShipped $ \these ->
        fmap (T.count "<rect" . alphabetSvg . alphabetDrawings) paperAlphabet
          `shouldBe` Right (sum (map area these) + length these)
    it "the SVG picture has the taxels of each shape in its frame, its name below, equal margins" $
      onShipped $ \these -> do
        picture <- either (fail . show) (pure . alphabetSvg . alphabetDrawings) paperAlphabet
        let rectangles = map rectangleOf (drop 1 (T.splitOn "<rect" picture))
            frames = [r | (r, True) <- rectangles]
            inFrame (x, y, w, h) =
              [ (row, column)
                | ((u, v, 10, 10), False) <- rectangles,
                  u >= x && v >= y && u + 10 <= x + w && v + 10 <= y + h,
                  (column, 0) <- [(u - x) `divMod` 10],
                  (row, 0) <- [(v - y) `divMod` 10]
              ]
            raised shape =
              [ (i, j)
                | (i, row) <- zip [0 ..] (bitmapRows shape),
                  (j, True) <- zip [0 ..] row
              ]
            names = map (valueOf "x" . fst . T.breakOn ">") (drop 1 (T.splitOn "<text" picture))
            heights = map (valueOf "y" . fst . T.breakOn ">") (drop 1 (T.splitOn "<text" picture))
            size = valueOf "font-size" picture
        map (sort . inFrame) frames `shouldBe` map raised these
        names `shouldBe` [x + w `div` 2 | (x, _, w, _) <- frames]
        heights `shouldSatisfy` \ys -> and [b - size > y + h | (b, (_, y, _, h)) <- zip ys frames]
        T.null (attribute "font-family" picture) `shouldBe` False
        map (attribute "text-anchor" . fst . T.breakOn ">") (drop 1 (T.splitOn "<text" picture))
          `shouldBe` map (const "middle") these
        case (map number (T.words (attribute "viewBox" picture)), frames, reverse frames) of
          ([left, top, width, height], (x, y, _, _) : others, (u, v, w, _) : _) -> do
            (left, top) `shouldBe` (0, 0)
            width - (u + w) `shouldBe` x
            [y' | (_, y', _, _) <- others] `shouldBe` map (const y) others
            height `shouldSatisfy` (> maximum (v : heights))
            zipWith (\(a, _, wide, _) (b, _, _, _) -> b - (a + wide)) frames others
              `shouldSatisfy` \gaps -> all (> 0) gaps && length (nub gaps) == 1
          other -> expectationFailure (show other)

  describe "Ordinary features" $ do
    it "are perfectly like themselves" $
      [ likeness b f
        | f <- ordinaryFeatures,
          let b = bitmapWhere (raises f),
          area b > 0,
          area b < 96
      ]
        `shouldSatisfy` all (\l -> abs (l - 1) < 1e-12)
    it "are edges, ridges, corners and discs, at every taxel or half of one, and the full window" $
      ordinaryFeatures
        `shouldMatchList` ( Full :
                            [StepEdge n c | n <- directions, c <- map (far n) [-10, -8 .. 10]]
                              ++ [ Ridge n (far n c) (far n c + far n wide)
                                   | n <- directions,
                                     c <- [-12 .. 10],
                                     wide <- [4, 6, 8, 12]
                                 ]
                              ++ [ Corner n (far n c) (far n d)
                                   | n <- directions,
                                     c <- [-8, -6 .. 8],
                                     d <- [-8, -6 .. 8]
                                 ]
                              ++ [ Disc (x, y) r
                                   | x <- [-4, -2 .. 4],
                                     y <- [-8, -6 .. 8],
                                     r <- [6, 8, 10, 12]
                                 ]
                          )
    it "likeness is Pearson's correlation of the taxels" $
      property $
        forAll ((,) <$> shapeGen <*> elements ordinaryFeatures) $ \(b, f) ->
          abs (likeness b f - correlation (map bit (concat (bitmapRows b))) (window f)) < 1e-9
    it "the set of ordinary features is closed under the half turn and the window's mirrors" $ do
      let images = Set.fromList [bitmapWhere (raises f) | f <- ordinaryFeatures]
      Set.unions (map family (Set.toList images)) `shouldBe` images

-- | Sixteen directions: along the axes, along the diagonals, and between.
directions :: [(Int, Int)]
directions =
  nub
    [ (s * a, t * b)
      | (a, b) <- [(1, 0), (0, 1), (1, 1), (1, 2), (2, 1)],
        s <- [1, -1],
        t <- [1, -1]
    ]

-- | This many half taxels along a direction, as its vector's multiple: to the nearest whole number.
far :: (Int, Int) -> Int -> Int
far (a, b) c = floor (fromIntegral c * sqrt (fromIntegral (a * a + b * b)) + 0.5 :: Double)

-- | The rectangle of an SVG element from its attributes on, and whether it is a frame.
rectangleOf :: T.Text -> ((Int, Int, Int, Int), Bool)
rectangleOf text =
  ( (valueOf "x" text, valueOf "y" text, valueOf "width" text, valueOf "height" text),
    attribute "fill" (fst (T.breakOn ">" text)) == "none"
  )

-- | The value of an attribute at its first occurrence.
attribute :: T.Text -> T.Text -> T.Text
attribute name text =
  T.takeWhile (/= '"') (T.drop (T.length name + 3) (snd (T.breakOn (" " <> name <> "=\"") text)))

valueOf :: T.Text -> T.Text -> Int
valueOf name = number . attribute name

number :: T.Text -> Int
number = read . T.unpack

-- | The distance by its definition: transformed rows placed by their middle, every taxel of a wide
-- surround compared.
countedDistance :: Symmetry -> Bitmap -> Bitmap -> Int
countedDistance symmetry a b =
  minimum
    [ length
        [ ()
          | x <- [-4 .. 11],
            y <- [-2 .. 13],
            at one x y /= at other (x - dx) (y - dy)
        ]
      | dx <- [-1, 0, 1],
        dy <- [-1, 0, 1]
    ]
  where
    (one, other) = (bitmapRows a, onRows symmetry (bitmapRows b))
    -- Columns and rows counted from the upper left of the upright box; a lying box of 12 x 8 starts
    -- 2 to the left and 2 down.
    at :: [[Bool]] -> Int -> Int -> Bool
    at rows x y = case drop' (y - (12 - length rows) `div` 2) rows of
      row : _ -> case drop' (x - (8 - length row) `div` 2) row of
        e : _ -> e
        [] -> False
      [] -> False
    drop' n list = if n < 0 then [] else drop n list

-- | Pearson's correlation by its definition; 0 where either is constant.
correlation :: [Double] -> [Double] -> Double
correlation xs ys
  | spread <= 0 = 0
  | otherwise = sum (zipWith (*) dx dy) / sqrt spread
  where
    dx = fromMean xs
    dy = fromMean ys
    fromMean zs = map (subtract (sum zs / fromIntegral (length zs))) zs
    spread = sum (map (^ (2 :: Int)) dx) * sum (map (^ (2 :: Int)) dy)

bit :: Bool -> Double
bit e = if e then 1 else 0

window :: Feature -> [Double]
window f = [bit (raises f x y) | y <- [0 .. 11], x <- [0 .. 7]]

-- | The images of ordinary features in the window, each once.
windows :: [[Double]]
windows = Set.toList (Set.fromList (map window ordinaryFeatures))

-- | The first of a list, and every n-th of those after it.
everyNth :: Int -> [a] -> [a]
everyNth n list = [one | (i, one) <- zip [0 ..] list, i `mod` n == 0]

-- | The design run once for all tests.
designed :: Either ShapeError (Alphabet, Report)
designed = design paperSeed paperParameters

embossedSet :: Bitmap -> Set.Set (Int, Int)
embossedSet b = Set.fromList [(x, y) | x <- [0 .. 7], y <- [0 .. 11], embossedAt b x y]

flatAround :: Bitmap -> Set.Set (Int, Int)
flatAround b = Set.fromList [(x, y) | x <- [-1 .. 8], y <- [-1 .. 12], not (embossedAt b x y)]

-- | The number of connected pieces of a set of taxels.
pieces :: Set.Set (Int, Int) -> Int
pieces set = case Set.minView set of
  Nothing -> 0
  Just (start, _) -> 1 + pieces (set `Set.difference` grown (Set.singleton start))
  where
    grown reached =
      let next =
            Set.intersection
              set
              ( Set.unions
                  ( reached :
                      [ Set.map (\(x, y) -> (x + dx, y + dy)) reached
                        | (dx, dy) <- [(1, 0), (-1, 0), (0, 1), (0, -1)]
                      ]
                  )
              )
       in if next == reached then reached else grown next

selfInverse :: [Symmetry]
selfInverse = [s | s <- symmetries, invert s == s]

sublists :: [a] -> [[a]]
sublists [] = [[]]
sublists (x : xs) = map (x :) (sublists xs) ++ sublists xs

onShipped :: ([Bitmap] -> Expectation) -> Expectation
onShipped check = either (expectationFailure . show) (check . shapes) paperAlphabet

head' :: a -> [a] -> a
head' none = foldr const none

blank, corner :: Bitmap
blank = bitmapWhere (\_ _ -> False)
corner = bitmapWhere (\x y -> y == 0 && x < 3 || x == 0 && y < 2)

rowsOfBits :: Gen [[Bool]]
rowsOfBits = vectorOf 12 (vectorOf 8 arbitrary)

shapeGen :: Gen Bitmap
shapeGen = do
  rows <- rowsOfBits
  pure (bitmapWhere (\x y -> or [e | row <- take 1 (drop y rows), e <- take 1 (drop x row)]))

alphabetGen :: Gen Alphabet
alphabetGen =
  suchThatMap
    (listOf1 ((,) <$> elements ["0", "1", "A", "A^2", "some name", "symbol", "#"] <*> shapeGen))
    (either (const Nothing) Just . alphabet)
