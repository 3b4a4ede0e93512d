-- | Tests the basis of recognition case by case: the common grid of all symbols, room on a face,
-- cells too small for symbols, and which refusal is reported when.
module Test.Recognition.GridsAndRefusals (spec) where

import Data.Foldable (for_)
import Data.List (nub, partition, sort)
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust)
import qualified Data.Set as Set
import PraTactile
import PraTactile.Explore
import PraTactile.Field (KnownField, toCode)
import PraTactile.Files (readFolder)
import PraTactile.Image (constant, generate)
import PraTactile.Locate (ForeignDoubts (..), Known (..))
import PraTactile.Object.Canonical (canonicalLayings)
import PraTactile.Object.Placement hiding (more)
import PraTactile.Recognise (refusalName)
import PraTactile.Recognise.FaceGrid
import PraTactile.Recognise.GridLocation
import PraTactile.Recognise.GridOutcome
import PraTactile.Recognise.Reading
import PraTactile.Recognise.SymbolBelief (certain)
import PraTactile.Relief
import PraTactile.Segmentation (SymbolImage (..))
import PraTactile.Symmetry
import System.Random (mkStdGen)
import Test.Hspec
import Test.QuickCheck hiding (generate)
import Test.Recognition.Setting
import Test.Recognition.Symbols
import Test.Support
import Test.Touch.Paper (paperAlphabet)

spec :: Spec
spec = do
  describe "the grid of a face" gridSpec
  describe "certain symbols" certainSpec
  describe "room on a face" roomSpec
  describe "distances of symbols" $
    it "must be the paper's times one factor, or are refused" $
      onPaper (notFelt . settingArray)
  describe "reported answers" saidSpec

gridSpec :: Spec
gridSpec = do
  it "has each symbol in its cell, counted from the uppermost row and the leftmost column" $
    forAllShrink (sublistOf anywhere) (filter (not . null) . shrinkList (const [])) $ \some ->
      forAll (shuffle (if null some then [(0, 0)] else some)) $ \cells ->
        let symbols = zipWith symbolIn [0 ..] cells
            top = minimum (map fst cells)
            left = minimum (map snd cells)
         in fmap (Map.map (map readNumber) . gridCells) (faceGrid (groups symbols))
              === Just (Map.fromList [((i - top, j - left), [n]) | (n, (i, j)) <- zip [0 ..] cells])
              .&&. fmap (Set.unions . gridGroups) (faceGrid (groups symbols))
                === Just (Set.fromList [0 .. length cells - 1])
              .&&. fmap (map readNumber . gridStrays) (faceGrid (groups symbols)) === Just []
  it "has the groups that lie whole cells from the best known one, within four taxels" $
    forAll (elements [identity, turned 1]) $ \axis ->
      forAll genGroups $ \drawn ->
        forAllBlind (shuffle (concat (zipWith (members axis) [0 ..] drawn))) $ \seen ->
          let (joined, strays) = partition (onGrid . snd . snd) (zip [0 :: Int ..] drawn)
              placed =
                [ ((i + di, j + dj), [10 * n + m])
                  | (n, ((i, j), _)) <- joined,
                    (m, (di, dj)) <- take (sizeOf n) (zip [0 ..] block)
                ]
              found = faceGrid (groups seen)
           in conjoin
                [ fmap (Map.map (map readNumber) . gridCells) found === Just (Map.fromList placed),
                  fmap (sort . gridGroups) found
                    === Just (sort [Set.fromList (numbersOf n) | (n, _) <- joined]),
                  fmap (sort . map readNumber . gridStrays) found
                    === Just (concat [numbersOf n | (n, _) <- strays])
                ]
  it "is Nothing if the distances within a group contradict each other" $ do
    let sound = Group (Just (Map.singleton (0, 0) one)) (0, 0) [one]
        unsound = Group Nothing (0, 0) [one]
        one = symbolAt 0 (0, 0) (identity, 0)
    map (isJust . faceGrid) [[sound], [sound, unsound], [unsound, sound], []]
      `shouldBe` [True, False, False, True]
  where
    -- A group of four symbols that the network knows, and up to three groups of two that it does
    -- not, each off the grid by these taxels.
    genGroups = do
      others <- sublistOf [(0, 6), (6, 0), (6, 6)]
      offs <- traverse (const ((,) <$> genOff <*> genOff)) others
      pure (((0, 0), (0, 0)) : zip others offs)
    genOff = elements [0, 4, -4, 4.001, -4.001, 2, -7] :: Gen Double
    onGrid (dx, dy) = abs dx <= 4 && abs dy <= 4
    block = [(0, 0), (0, 1), (1, 0), (1, 1)]
    sizeOf n = if n == 0 then 4 else 2 :: Int
    numbersOf n = [10 * n + m | m <- [0 .. sizeOf n - 1]]
    members axis n ((i, j), (dx, dy)) =
      [ (symbolOf (10 * n + m) (onOffset axis (x + dx + e, y + dy - e)) (axis, 0))
          { readSource = n `mod` 2,
            readImage = SymbolImage (0, 0) (constant 8 12 0) (degreesClockwise axis) (8, 12),
            readClass = if n == 0 then Just (axis, 0) else Nothing
          }
        | (m, (di, dj), e) <- take (sizeOf n) (zip3 [0 ..] block (taxelOff n)),
          let (x, y) = (16 * fromIntegral (j + dj), 20 * fromIntegral (i + di))
      ]
    -- Two symbols off by a taxel each way: whether their mean is on the grid decides.
    taxelOff n = if n == 0 then [0, 0, 0, 0] else [1, -1]
    anywhere = [(i, j) | i <- [0 .. 4], j <- [0 .. 4]]
    -- The network knows every third one.
    symbolIn n cell = (symbolAt n cell (identity, 0)) {readClass = known n}
    known n = if n `mod` 3 == 0 then Just (identity, 0) else Nothing

-- | A certain symbol with this number, known to the network, in a cell.
symbolAt :: Int -> (Int, Int) -> (Symmetry, Int) -> ReadSymbol
symbolAt n (i, j) = symbolOf n centre
  where
    centre = (16 * fromIntegral j, 20 * fromIntegral i)

-- | The symbol with this doubt, shared by its alternatives.
doubtful :: Double -> ReadSymbol -> ReadSymbol
doubtful p s = s {readChances = (what, 1 - p) : [(other, p / 7) | other <- others]}
  where
    what = readLikeliest s
    others = filter (/= what) ((,) <$> [identity, turned 2] <*> [0 .. 3])

certainSpec :: Spec
certainSpec = do
  it "are those the network knows with a doubt below 0.1, and clear parts of at least a third" $
    for_ ((,) <$> [0, 0.0009, 0.0011, 0.09, 0.11, 0.7] <*> knowing) $ \(p, known) -> do
      let symbol = (doubtful p (symbolAt 0 (0, 0) (turned 2, 3))) {readClass = known}
      certain symbol `shouldBe` (if p < 0.1 then known else Nothing)
      for_ [86, 32, 31 :: Int] $ \taxels ->
        certain symbol {readSeen = fromIntegral taxels / 96, readClass = Nothing}
          `shouldBe` (if p < 0.001 && taxels >= 32 then Just (turned 2, 3) else Nothing)
  it "contradict an answer from beside the grid or along the other axis; doubtful ones do not" $ do
    onPaper $ \setting -> do
      let reader = recogniserOf setting
          classOf r c = toCode (cellAt (settingArray setting) (Position (6 + r) (5 + c)))
          block =
            [ symbolAt (3 * i + j) (i, j) (identity, classOf r c)
              | (i, r) <- [(0, 0), (1, 1)],
                (j, c) <- [(0, 0), (1, 1), (2, 2)]
            ]
          located among strays along =
            locationOutcome
              (locateGrid reader standardTolerance along (gridOf (block ++ among) strays))
          gridOf symbols strays =
            FaceGrid
              { gridCells = Map.fromList [(readNumber s `divMod` 3, [s]) | s <- symbols],
                gridGroups = [Set.fromList (map readNumber symbols)],
                gridStrays = strays,
                gridAnchor = (0, 0)
              }
          turnedOver = symbolAt 8 (2, 2) (turned 2, 1)
          sideways = symbolAt 9 (5, 5) (turned 1, 1)
          placed = Placed (Position 6 5)
      [located [] [] [], located [doubtful 0.6 turnedOver] [] [], located [turnedOver] [] []]
        `shouldBe` [placed, placed, WrongWayUp]
      [located [] [doubtful p turnedOver] [] | p <- [0.3, 0]] `shouldBe` [placed, OffTheGrid]
      [located [] [] [doubtful p sideways] | p <- [0.3, 0]] `shouldBe` [placed, WrongWayUp]
  where
    knowing = [Nothing, Just (turned 2, 3)]

roomSpec :: Spec
roomSpec = do
  it "a region as large as the face lies at its corner; one a taxel larger contains it" $ do
    layout <- right canonicalPlacement
    let wrong =
          [ (laidFace face, symmetry, width, height)
            | face <- laidFaces layout,
              symmetry <- rotations,
              seed <- [1 .. 5],
              let (across, down) = both taxelsOf (spotMillimetres (laidExtent face)),
              let (w, h) = if exchangesAxes symmetry then (down, across) else (across, down),
              (width, height) <- [(w, h), (w + 1, h), (w, h + 1)],
              let r = fst (randomRegion [symmetry] (width, height) face (mkStdGen seed)),
              regionSymmetry r /= symmetry
                || not (beside (regionRight r) (fst (regionExtent r) - across))
                || not (beside (regionDown r) (snd (regionExtent r) - down))
          ]
    wrong `shouldBe` []
  where
    -- The region extends before the face by no more than it is larger than the face.
    beside at more = at < 1e-9 && at > -1e-9 - fromIntegral (more :: Int)
    taxelsOf millimetres = round (millimetres / (127 / 80)) :: Int
    both f (x, y) = (f x, f y)

notFelt :: KnownField k => PseudorandomArray k -> Expectation
notFelt array = do
  layout <- right canonicalPlacement
  alphabetOfAll <- right paperAlphabet
  sequence_
    [ do
        let pitch = Pitch (taxels across) (taxels down)
        laid <-
          right (placement (Shape 15 17) pitch (placementSolids layout) canonicalLayings)
        let told = either Just (const Nothing) . relief array laid alphabetOfAll
        nub (map told (laidFaces laid))
          `shouldBe` [if 20 * across == 16 * down then Nothing else Just (PitchNotFelt pitch)]
      | across <- [4, 6, 8, 12, 16],
        down <- [5, 8, 10, 15, 20]
    ]
  where
    taxels n = fromIntegral (n :: Int) * 127 / 80

saidSpec :: Spec
saidSpec = do
  it "symbols of the right size but of no class are refused as unclear" $ do
    said <- saying (compositeOf (boxes [(0, 0), (0, 1), (1, 0), (1, 1)]))
    said `shouldSatisfy` unclear
    alone <- saying (compositeOf (boxes [(1, 0)]))
    alone `shouldSatisfy` unclear
  it "a refusal, or several places that fit, are reported with their doubt, if there is one" $ do
    let said answer support = summary (Recognition [] [] Map.empty (0, 0) support Nothing 0 answer)
        several = Right (Several identity [Position 1 2, Position 3 4])
        alien = ForeignDoubts 0.03 0.02 True 0
        unsure = Just (Support (Doubts 0.2 0 0 0 alien) 4 [] [] (Exactly 3) 1 Nothing Nothing)
    said (Left NoSymbols) Nothing `shouldBe` ["refused: no-symbols"]
    map (take 3 . words) (said several Nothing)
      `shouldBe` [["ambiguous:", "2", "positions"], ["upright", "in", "the"]]
    map (drop 1) [said (Left NoSymbols) unsure, drop 1 (said several unsure)]
      `shouldBe` replicate 2 ["doubt 2.5e-1"]
  it "the lines of README.md are the program's for the worked example" $ do
    text <- lines <$> readFile "README.md"
    let printed = takeWhile (/= "") (drop 2 (dropWhile (/= "It prints") text))
    frames <- readFolder "data/worked-example/frames" >>= right
    reader <- right canonicalRecogniser
    recognition <- right (decodeFolder reader frames)
    map ("    " ++) (summary recognition) `shouldBe` printed
  where
    unclear = maybe False ((== "symbols-unclear") . refusalName) . refusedIn
    saying composite =
      onPaper $ \setting -> recognisedIn (recogniserOf setting) standardTolerance [composite]
    -- Boxes of 8 x 12 in cells of 16 x 20.
    boxes cells = generate 40 48 $ \x y ->
      if (y `div` 20, x `div` 16) `elem` cells
        && x `mod` 16 >= 4
        && x `mod` 16 < 12
        && y `mod` 20 >= 4
        && y `mod` 20 < 16
        then 1
        else 0
