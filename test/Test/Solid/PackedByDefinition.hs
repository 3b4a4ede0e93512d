-- | Tests packing against its definition. On small sheets a search on lists decides; for larger
-- sheets there are a theorem, sheets that were cut into pieces, and puzzles with known answers. The
-- cells of each packing are counted on lists.
module Test.Solid.PackedByDefinition (spec) where

import qualified Data.IntSet as IntSet
import Data.List (nub, sort, (\\))
import Data.Maybe (fromMaybe)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Cells
import PraTactile.Object.Mesh
import PraTactile.Object.Named hiding (Sheet)
import PraTactile.Object.Packing
import Test.Effort
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "a mask" $ do
    prop "has the cells that it was made of, each once, row by row" $
      forAll shape $ \(size, cells) ->
        forAll (shuffle (cells ++ take 2 cells)) $ \told ->
          fmap maskCells (maskOf size told) === Just (sort cells)
    prop "has a cell, and none outside its block" $
      forAll ((,) <$> side <*> side) $ \size ->
        forAll (smallList ((,) <$> side <*> side)) $ \cells ->
          (maskOf size cells == Nothing) === (null cells || not (all (inside size) cells))
    it "of all cells equals the block" $
      and [maskOf (r, c) (allCells (r, c)) == Just (block (r, c)) | r <- [1 .. 4], c <- [1 .. 4]]
  describe "on small sheets" $ do
    withCases 1000 10000 . prop "packing is decided, with its reason, as the definition decides" $
      byEffort property checkCoverage . asDefined
    it "packing follows the definition for all threes of pieces of up to three cells, up to 4 x 5" $
      [ question
        | size <- allCells (4, 5),
          chosen <- upToThree polyominoes,
          let question = Question (fst size + 1, snd size + 1) [] (map (: []) chosen),
          not (agrees question (expected question) (answered 1 question))
      ]
        `shouldBe` []
  describe "on larger sheets" $ do
    prop "at most as many equal blocks are packed as a grid has" blocksOfAGrid
    prop "single cells fill what a block of any length leaves" besideALongBlock
    withCases 30 200 . prop "packing is never called impossible for the pieces of a sheet" $ cutUp
    prop "the answer does not depend on the order of pieces and alternatives" anyOrder
  describe "puzzles" $ do
    it "all twelve pentominoes fill 3 x 20, 4 x 15, 5 x 12 and 6 x 10" $
      [ outcomeOf (Question size [] (map turnedAndMirrored pentominoes))
        | size <- [(3, 20), (4, 15), (5, 12), (6, 10)]
      ]
        `shouldBe` replicate 4 "packed"
    it "the pentominoes fill 8 x 8 without the middle four cells" $
      outcomeOf
        (Question (8, 8) [(((2, 2), allCells (2, 2)), (3, 3))] (map turnedAndMirrored pentominoes))
        `shouldBe` "packed"
    it "the five tetrominoes fill no rectangle: one of them has three dark cells" $
      [ outcomeOf (Question size [] (map turnedAndMirrored tetrominoes))
        | size <- [(4, 5), (2, 10), (5, 4)]
      ]
        `shouldBe` replicate 3 "Impossible Exhausted"
    it "dominoes do not fill squares without two opposite corners" $
      [ outcomeOf
          ( Question
              (n, n)
              [(((1, 1), [(0, 0)]), (0, 0)), (((1, 1), [(0, 0)]), (n - 1, n - 1))]
              (replicate (n * n `div` 2 - 1) (turnedAndMirrored [(0, 0), (0, 1)]))
          )
        | n <- [4, 6]
      ]
        `shouldBe` replicate 2 "Impossible Exhausted"
    it "squares of nine sizes fill 32 x 33" $
      outcomeOf (Question (32, 33) [] [[rectangle n n] | n <- [18, 15, 14, 10, 9, 8, 7, 4, 1]])
        `shouldBe` "packed"
  describe "objects" $ do
    it "the paper's two lie on 15 x 17, with all 228 cells as walked, and from other vertices" $ do
      let paper = concatMap facesOf [Cube, Parallelepiped]
      outcomeOf (Question (15, 17) [] (map (take 1) paper)) `shouldBe` "packed"
      sum [length cells | ((_, cells) : _) <- paper] `shouldBe` 228
      outcomeOf (Question (15, 17) [] paper) `shouldBe` "packed"
    it "no second cube fits beside the paper's two" $
      outcomeOf (Question (15, 17) [] (concatMap facesOf [Cube, Cube, Parallelepiped]))
        `shouldBe` "Impossible (TooFewCells 328 255)"
    withCases 1 3 . prop "200 boxes on 255 x 257 fill 95 % of their rows" $
      forAllBlind (concat <$> vectorOf 200 box) $ \faces ->
        filled (Question (255, 257) [] faces) >= 0.95
    withCases 1 3 . prop "triangles, L shapes and hexagons are packed beside boxes" $
      forAllBlind (concat <$> vectorOf 20 box) $ \faces ->
        let others = concatMap facesOf [Tetrahedron 200, LShape 200 100 200, Prism 6 150 40]
            layings =
              [ (piece !! i, at)
                | (piece, Laid i at) <- zip faces (laidBy (Question (80, 65) [] faces))
              ]
         in not (null layings)
              .&&. outcomeOf (Question (144, 65) layings (concat (replicate 4 others)))
                === "packed"
    it "thousands of cubes on over a million cells fill 99 % of their rows" $
      let (size, cubes) = byEffort ((1023, 1025), 1025) ((2047, 2049), 10000)
       in filled (Question size [] (replicate (6 * cubes) [rectangle 4 5]))
            `shouldSatisfy` (>= 0.99)
    it "objects are packed on a sheet of more cells than there is memory" $
      outcomeOf (Question (1000000007, 1000000009) [] (concatMap facesOf [Cube, Parallelepiped]))
        `shouldBe` "packed"

-- * Questions

type Cell = (Int, Int)

-- | The rows and columns of a block, and cells within it.
type Shape = (Cell, [Cell])

-- | The rows and columns of a sheet; the taken cells, by block and place; pieces by their
-- alternatives.
data Question = Question Cell [(Shape, Cell)] [[Shape]]
  deriving stock (Eq, Show)

answered :: Int -> Question -> PackingResult
answered seed (Question (rows, columns) taken pieces) =
  packed
    seed
    (Sheet rows columns [(mask s, at) | (s, at) <- taken])
    (map (map mask) pieces)
  where
    mask (size, cells) = fromMaybe (error "a shape without cells") (maskOf size cells)

-- | The cells of a shape whose block begins at a row and column.
from :: Cell -> Shape -> [Cell]
from (r, c) (_, cells) = [(r + i, c + j) | (i, j) <- cells]

inside :: Cell -> Cell -> Bool
inside (rows, columns) (r, c) = r >= 0 && r < rows && c >= 0 && c < columns

allCells :: Cell -> [Cell]
allCells (rows, columns) = [(r, c) | r <- [0 .. rows - 1], c <- [0 .. columns - 1]]

-- | Whether these layings are a packing: one of each piece's alternatives, no cell twice, none
-- outside, none on a taken cell.
isPacking :: Question -> [Laid] -> Bool
isPacking question@(Question size@(_, columns) taken pieces) laid =
  length laid == length pieces
    && and [i >= 0 && i < length piece | (piece, Laid i _) <- zip pieces laid]
    && all (inside size) cells
    && IntSet.size (IntSet.fromList [r * columns + c | (r, c) <- cells]) == length cells
  where
    cells = concat [from at s | (s, at) <- taken] ++ concat (cellsLaid question laid)

-- | The cells of each piece as it lies.
cellsLaid :: Question -> [Laid] -> [[Cell]]
cellsLaid (Question _ _ pieces) laid =
  [from at (piece !! i) | (piece, Laid i at) <- zip pieces laid]

laidBy :: Question -> [Laid]
laidBy question = case answered 1 question of
  Packed laid | isPacking question laid -> laid
  _ -> []

-- | The answer of the search; of a packing only that it is one.
outcomeOf :: Question -> String
outcomeOf question = case answered 1 question of
  Packed laid -> if isPacking question laid then "packed" else "packed wrongly: " ++ show laid
  other -> show other

-- | The filled share of the rows up to the last used one; 0 unless it is a packing.
filled :: Question -> Double
filled question@(Question (_, columns) _ _) = case concat (cellsLaid question (laidBy question)) of
  [] -> 0
  cells -> fromIntegral (length cells) / fromIntegral (columns * (1 + maximum (map fst cells)))

-- * The definition

-- | Whether these free cells have a packing: the first piece lies somewhere, and the others can be
-- packed on the rest.
possible :: [Cell] -> [[Shape]] -> Bool
possible free pieces = case pieces of
  [] -> True
  piece : others -> or [possible (free \\ cells) others | cells <- concatMap (places free) piece]

-- | All sets of free cells that a shape can cover.
places :: [Cell] -> Shape -> [[Cell]]
places free (_, cells) =
  [ moved
    | (r, c) <- free,
      let moved = [(r + i - top, c + j - left) | (i, j) <- cells],
      all (`elem` free) moved
  ]
  where
    (top, left) = minimum cells

-- | The reason for no packing, if there is none.
expected :: Question -> Maybe Reason
expected (Question size taken pieces)
  | i : _ <- holding [not (all (inside size) (from at s)) | (s, at) <- taken] =
    Just (TakenOutside i)
  | i : _ <- holding [any (`elem` earlier i) (from at s) | (i, (s, at)) <- zip [0 ..] taken] =
    Just (TakenOverlaps i)
  | i : _ <- holding [not (possible everything [piece]) | piece <- pieces] =
    Just (PieceTooLarge i)
  | needed > length free = Just (TooFewCells needed (length free))
  | i : _ <- holding [not (possible free [piece]) | piece <- pieces] = Just (NoRoom i)
  | not (possible free pieces) = Just Exhausted
  | otherwise = Nothing
  where
    holding truths = [i | (i, True) <- zip [0 ..] truths]
    earlier i = concat [from at s | (s, at) <- take i taken]
    everything = allCells size
    free = everything \\ earlier (length taken)
    needed =
      sum [minimum [length cells | s@(_, cells) <- p, possible everything [[s]]] | p <- pieces]

agrees :: Question -> Maybe Reason -> PackingResult -> Bool
agrees question why outcome = case (why, outcome) of
  (Nothing, Packed laid) -> isPacking question laid
  (Just one, Impossible other) -> one == other
  _ -> False

asDefined :: Int -> Property
asDefined seed =
  forAllShrink smallQuestion shrunk $ \question ->
    let why = expected question
        outcome = answered seed question
     in cover 25 (null why) "packed"
          . cover 2 (why == Just Exhausted) "exhausted"
          . cover 0.3 (why `elem` map (Just . NoRoom) [0 .. 4]) "no room"
          . counterexample (show why ++ ", and the search says " ++ show outcome)
          $ agrees question why outcome

-- * Laws

-- | Upright blocks of h x w on R x C each contain one of the cells (i h - 1, j w - 1). So there are
-- at most floor (R / h) floor (C / w), and a grid has as many.
blocksOfAGrid :: Property
blocksOfAGrid =
  forAll ((,,) <$> size 9 <*> size 5 <*> choose (-1, 1)) $ \((rows, columns), (h, w), more) ->
    let most = (rows `div` h) * (columns `div` w)
        n = max 1 (most + more)
        question = Question (rows, columns) [] (replicate n [rectangle h w])
     in (outcomeOf question == "packed") === (n <= most)
  where
    size k = (,) <$> choose (1, k) <*> choose (1, k)

-- | Two rows, one with a block that already lies.
besideALongBlock :: Property
besideALongBlock =
  forAll ((,,) <$> choose (1, 300) <*> choose (0, 70) <*> choose (0, 70)) $
    \(long, left, right) ->
      let columns = left + long + right
          singles = replicate (2 * columns - long) [rectangle 1 1]
       in outcomeOf (Question (2, columns) [(rectangle 1 long, (0, left))] singles) === "packed"

-- | A sheet cut into pieces, some of which already lie and some of which are left out. A quick run
-- has too few sheets to test the packed share.
cutUp :: Property
cutUp =
  forAll cutSheet $ \question ->
    let said = outcomeOf question
     in byEffort property checkCoverage . cover 90 (said == "packed") "packed" $
          counterexample said (said `elem` ["packed", "NotFound"])

-- | Pieces in another order, and their alternatives, cover the same sets of cells.
anyOrder :: Property
anyOrder =
  forAll cutSheet $ \(Question size taken pieces) ->
    let several = zipWith (\piece other -> piece ++ take 1 other) pieces (drop 1 pieces ++ [[]])
     in forAll (mapM shuffle several >>= shuffle) $ \others ->
          cellsTaken (Question size taken several) === cellsTaken (Question size taken others)
  where
    cellsTaken question = case answered 1 question of
      Packed laid -> Right (sort (map sort (cellsLaid question laid)))
      Impossible _ -> Left "impossible"
      NotFound -> Left "not found"

-- * Random questions

side :: Gen Int
side = choose (-1, 3)

smallList :: Gen a -> Gen [a]
smallList gen = choose (0, 4) >>= \n -> vectorOf n gen

-- | A few cells of a block, in no order.
shape :: Gen Shape
shape = do
  size <- (,) <$> choose (1, 3) <*> choose (1, 4)
  cells <- shuffle (allCells size)
  count <- choose (1, 6)
  pure (size, take count cells)

-- | A small sheet with pieces that were cut out of it, or are random; some have an alternative.
smallQuestion :: Gen Question
smallQuestion = do
  size <- (,) <$> choose (1, 4) <*> choose (1, 5)
  parts <- cutInto 6 (allCells size)
  lie <- frequency [(3, pure 0), (2, choose (0, 2))]
  strange <- frequency [(9, pure []), (1, (: []) <$> ((,) <$> shape <*> ((,) <$> side <*> side)))]
  kept <- take 5 <$> shuffle (drop lie parts)
  pieces <- mapM piece kept
  -- Half of the time in pairs of equal ones.
  paired <- arbitrary
  let pairs = take (length pieces) (concatMap (replicate 2) pieces)
  pure (Question size (map lying (take lie parts) ++ strange) (if paired then pairs else pieces))
  where
    piece cells = do
      alternative <- frequency [(4, pure []), (1, (: []) <$> other (length cells))]
      first <- frequency [(1, blocked cells), (1, other (length cells))]
      shuffle (first : alternative)
    other count = (\(size, cells) -> (size, take count cells)) <$> shape

-- | A larger sheet cut into pieces of about eight cells, of which some already lie, and some of the
-- others are left out.
cutSheet :: Gen Question
cutSheet = do
  size <- (,) <$> choose (2, 10) <*> choose (2, 10)
  parts <- cutInto 9 (allCells size) >>= shuffle
  lie <- choose (0, length parts `div` 3)
  left <- choose (0, length parts `div` 3)
  pieces <- mapM (fmap (: []) . blocked) (drop (lie + left) parts)
  pure (Question size (map lying (take lie parts)) pieces)

-- | The taken cells with their least block.
lying :: [Cell] -> (Shape, Cell)
lying cells = ((size, [(r - top, c - left) | (r, c) <- cells]), (top, left))
  where
    size = (1 + bottom - top, 1 + right - left)
    (top, bottom) = (minimum (map fst cells), maximum (map fst cells))
    (left, right) = (minimum (map snd cells), maximum (map snd cells))

-- | The taken cells in a block that may be larger.
blocked :: [Cell] -> Gen Shape
blocked cells = do
  ((above, left), (below, right)) <- (,) <$> margins <*> margins
  let (((height, width), own), _) = lying cells
  pure
    ( (height + above + below, width + left + right),
      [(r + above, c + left) | (r, c) <- own]
    )
  where
    margins = frequency [(2, pure (0, 0)), (1, (,) <$> choose (0, 2) <*> choose (0, 2))]

-- | Cells cut into connected parts of at most this size.
cutInto :: Int -> [Cell] -> Gen [[Cell]]
cutInto most cells = case cells of
  [] -> pure []
  first : others -> do
    count <- choose (1, most)
    part <- grown count [first] others
    (part :) <$> cutInto most (cells \\ part)
  where
    grown count part left
      | length part >= count || null beside = pure part
      | otherwise = elements beside >>= \next -> grown count (next : part) (left \\ [next])
      where
        beside = [cell | cell <- left, any (neighbours cell) part]
    neighbours (r, c) (r', c') = abs (r - r') + abs (c - c') == 1

-- | Fewer pieces, alternatives, taken cells or cells; a smaller sheet.
shrunk :: Question -> [Question]
shrunk (Question (rows, columns) taken pieces) =
  [Question (rows - 1, columns) taken pieces | rows > 1]
    ++ [Question (rows, columns - 1) taken pieces | columns > 1]
    ++ [Question (rows, columns) fewer pieces | fewer <- shrinkList (const []) taken]
    ++ [Question (rows, columns) taken fewer | fewer <- shrinkList smaller pieces]
  where
    smaller piece = filter (not . null) (shrinkList smallerShape piece)
    smallerShape (size, cells) = [(size, fewer) | fewer <- shrinkList (const []) cells, fewer /= []]

rectangle :: Int -> Int -> Shape
rectangle h w = ((h, w), allCells (h, w))

-- | The connected pieces of up to three cells, in every rotation and mirror image.
polyominoes :: [Shape]
polyominoes =
  rectangle 1 1 :
  concatMap turnedAndMirrored [[(0, 0), (0, 1)], [(0, 0), (0, 1), (0, 2)], [(0, 0), (0, 1), (1, 0)]]

-- | All choices of one, two or three of a list, with repetition.
upToThree :: [a] -> [[a]]
upToThree list = concatMap choices [1 .. 3 :: Int]
  where
    choices n = go n list
    go 0 _ = [[]]
    go n left = [x : more | (x, k) <- zip left [0 ..], more <- go (n - 1) (drop k left)]

turnedAndMirrored :: [Cell] -> [Shape]
turnedAndMirrored cells =
  nub
    [ (size, sort own)
      | turned <- turns cells ++ turns (map mirror cells),
        let ((size, own), _) = lying turned
    ]
  where
    turns = take 4 . iterate (map (\(r, c) -> (c, negate r)))
    mirror (r, c) = (r, negate c)

-- | I, O, T, S and L, each in one of its forms.
tetrominoes :: [[Cell]]
tetrominoes =
  map
    drawing
    [ ["####"],
      ["##", "##"],
      ["###", ".#."],
      [".##", "##."],
      ["###", "#.."]
    ]

-- | F, I, L, N, P, T, U, V, W, X, Y and Z, each in one of its forms.
pentominoes :: [[Cell]]
pentominoes =
  map
    drawing
    [ [".##", "##.", ".#."],
      ["#####"],
      ["####", "#..."],
      ["##..", ".###"],
      ["###", "##."],
      ["###", ".#.", ".#."],
      ["#.#", "###"],
      ["#..", "#..", "###"],
      ["#..", "##.", ".##"],
      [".#.", "###", ".#."],
      ["####", ".#.."],
      ["##.", ".#.", ".##"]
    ]

drawing :: [String] -> [Cell]
drawing picture = [(r, c) | (r, line) <- zip [0 ..] picture, (c, '#') <- zip [0 ..] line]

-- | The faces of a solid, each begun at each of its vertices.
facesOf :: Named -> [[Shape]]
facesOf solid = map begun (V.toList (meshWalks it_))
  where
    it_ = fromDescription (namedDescription solid)
    begun walk =
      [ ((fromInteger (gridRows grid), fromInteger (gridColumns grid)), map small (gridCells grid))
        | k <- [0 .. U.length walk - 1],
          let grid = gridOf it_ (127 / 5, 127 / 4) (U.drop k walk U.++ U.take k walk),
          not (null (gridCells grid))
      ]
    small (r, c) = (fromInteger r, fromInteger c)

-- | The faces of a box with sides of 100 to 250 mm.
box :: Gen [[Shape]]
box = do
  sides <- vectorOf 3 ((/ 8) . fromInteger <$> choose (800, 2000))
  pure (concat [facesOf (Box w d h) | [w, d, h] <- [sides]])
