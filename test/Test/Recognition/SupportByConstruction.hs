-- | Tests the basis of an answer, and the reasons for none, on grids built by hand, whose results
-- follow from their construction.
module Test.Recognition.SupportByConstruction (spec) where

import Data.Foldable (for_)
import Data.List (sort)
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import PraTactile.Array
import PraTactile.Classification.Reader (readerOf)
import PraTactile.Field (KnownField, toCode)
import PraTactile.Locate (Chance (..), Known (..), Radius (..), Reason (..))
import PraTactile.Object.Canonical (canonicalPitch, canonicalPlacement)
import PraTactile.Object.Placement (placement)
import PraTactile.Recognise
import PraTactile.Recognise.FaceGrid
import PraTactile.Recognise.GridLocation
import PraTactile.Recognise.GridOutcome
import PraTactile.Symmetry
import PraTactile.Window (Mask, rectangle)
import Test.Code.Generators (right)
import Test.Effort (withCases)
import Test.Hspec
import Test.QuickCheck hiding (tolerance)
import Test.Recognition.Scenes
import Test.Recognition.Symbols
import Test.Support (whenRight)
import Test.Touch.Paper (paperAlphabet, paperNetwork)

spec :: Spec
spec = onRecognisers $ \array readers -> do
  for_ (take 1 readers) $ \(_, reader) -> do
    describe "The support" (supportSpec array reader)
    describe "Why there is no answer" (refusalSpec array reader)
  for_ (lookup Sheet readers) $ \reader ->
    it "without a possible position, the orientation is that of the symbols" $
      for_ rotations $ \orientation -> do
        -- One symbol more in a row than the sheet has columns.
        let row' = zipWith (\n (at, what) -> (at, clear n what)) [0 ..] (blockOf array 1 18 (3, 4))
            found = locateGrid reader standardTolerance [] (gridOf (seenAs orientation row') [])
        locationSupport found `shouldBe` Nothing
        locationOrientation found `shouldBe` orientation
        locationOutcome found `shouldSatisfy` (`notElem` [WrongWayUp, OffTheGrid, GroupsApart])

-- | The content of the cells of a face, with rows and columns from 0.
type Block = [((Int, Int), (Symmetry, Int))]

-- | A symbol with its cell.
type InCell = ((Int, Int), ReadSymbol)

-- | The array's content in this many rows and columns from a position on, seen upright.
blockOf :: KnownField k => PseudorandomArray k -> Int -> Int -> (Int, Int) -> Block
blockOf array high wide (r, c) =
  [ ((i, j), (identity, classAt array (r + i, c + j)))
    | i <- [0 .. high - 1],
      j <- [0 .. wide - 1]
  ]

classAt :: KnownField k => PseudorandomArray k -> (Int, Int) -> Int
classAt array (r, c) =
  toCode (cellAt array (Position (fromIntegral (r `mod` 15)) (fromIntegral (c `mod` 17))))

-- | A symbol with this reading, a doubt of one in a million, and known to the network.
clear :: Int -> (Symmetry, Int) -> ReadSymbol
clear n what = unsure 1e-6 (symbolOf n (0, 0) what)

-- | The symbol with this doubt, shared by its alternatives.
unsure :: Double -> ReadSymbol -> ReadSymbol
unsure p s = s {readChances = (what, 1 - p) : [(other, p / 7) | other <- axis, other /= what]}
  where
    what = readLikeliest s
    axis = [(o, c) | o <- [fst what, fst what <> turned 2], c <- [0 .. 3]]

-- | A grid with these symbols in cells, all of one group.
gridOf :: [InCell] -> [ReadSymbol] -> FaceGrid
gridOf placed strays =
  FaceGrid
    (Map.fromListWith (flip (++)) [(at, [s]) | (at, s) <- placed])
    [Set.fromList (map (readNumber . snd) placed)]
    strays
    (0, 0)

-- | A block seen in an orientation, as recognition finds it: cells along the symbols' axes.
seenAs :: Symmetry -> [InCell] -> [InCell]
seenAs orientation placed =
  [(if quarterTurns orientation >= 2 then about at else at, looked s) | (at, s) <- placed]
  where
    about (i, j) = (furthest fst - i, furthest snd - j)
    furthest part = maximum (map (part . fst) placed)
    seen (o, c) = (orientation <> o, c)
    looked s =
      s
        { readClass = seen <$> readClass s,
          readLikeliest = seen (readLikeliest s),
          readChances = [(seen what, p) | (what, p) <- readChances s]
        }

-- | Additions to the symbols of a block, which are all clear and of the first composite.
data Beside
  = -- | another look at a cell, with the same reading
    Again
  | -- | another look with another class
    Otherwise
  | -- | another look with the same class, the other way up
    TurnedOver
  | -- | another look with another class, too unsure to count
    Blurred
  | -- | a symbol off the grid
    Stray
  | -- | a symbol of the other axis
    Sideways
  deriving stock (Eq, Show, Enum, Bounded)

-- | A block somewhere, seen in an orientation, with random additions: the composite of each and, if
-- it is another look, the cell.
data Drawn = Drawn
  { drawnSize :: (Int, Int),
    drawnAt :: (Int, Int),
    drawnOrientation :: Symmetry,
    drawnBeside :: [(Beside, Int, (Int, Int))]
  }
  deriving stock (Show)

genDrawn :: (Int, Int) -> Gen Drawn
genDrawn size@(high, wide) =
  Drawn size
    <$> ((,) <$> choose (0, 14) <*> choose (0, 16))
    <*> elements rotations
    <*> (choose (0, 6) >>= (`vectorOf` genBeside))
  where
    genBeside =
      (,,)
        <$> elements [minBound ..]
        <*> choose (0, 2)
        <*> ((,) <$> choose (0, high - 1) <*> choose (0, wide - 1))

-- | The symbols of a block, numbered from 0, and the additions, numbered on.
symbolsOf :: KnownField k => PseudorandomArray k -> Drawn -> ([InCell], [(Beside, InCell)])
symbolsOf array (Drawn (high, wide) at@(r, c) _ beside) =
  ( block,
    [ (which, (cell, (lookAt n (classAt array (r + i, c + j)) which) {readSource = source}))
      | (n, (which, source, cell@(i, j))) <- zip [length block ..] beside
    ]
  )
  where
    block = [(cell, clear n what) | (n, (cell, what)) <- zip [0 ..] (blockOf array high wide at)]
    lookAt n class' which = case which of
      Again -> clear n (identity, class')
      Otherwise -> clear n (identity, (class' + 1) `mod` 4)
      TurnedOver -> clear n (turned 2, class')
      Blurred -> unsure 0.6 (symbolOf n (0, 0) (identity, (class' + 2) `mod` 4))
      Stray -> clear n (identity, class')
      Sideways -> clear n (turned 1, class')

supportSpec :: KnownField k => PseudorandomArray k -> Recogniser k -> Spec
supportSpec array reader =
  withCases 37 300 $
    it "counts agreeing and wrong symbols of each composite, and states the cells' distance" $
      forAll (elements [((3, 3), 4), ((3, 4), 6), ((4, 4), 9), ((5, 5), 16)]) $ \(size, distance) ->
        forAll (elements [Guaranteed, Guaranteed, UpTo 0, UpTo 1, UpTo 3]) $ \stated ->
          forAll (genDrawn size) $ \drawn ->
            let (block, beside) = symbolsOf array drawn
                limits = standardTolerance {toleratedErrors = stated}
                found = locatedAs reader limits drawn block beside
                isWrong which = which `notElem` [Again, Blurred]
                wrong = [readNumber s | (which, (_, s)) <- beside, isWrong which]
                agreeing = map snd block ++ [s | (Again, (_, s)) <- beside]
                inSource source = length . filter ((== source) . readSource)
                radius = case stated of
                  Guaranteed -> (distance - 1) `div` 2
                  UpTo n -> n
                few = fromIntegral (length wrong) <= radius
             in classify few "few wrong" $
                  case locationSupport found of
                    Nothing -> counterexample "no support" False
                    Just e ->
                      conjoin
                        [ locationOrientation found === drawnOrientation drawn,
                          supportAgreeing e === length agreeing,
                          sort (supportWrong e) === wrong,
                          supportInconsistent e
                            === [ source
                                  | source <- [0 .. 2],
                                    inSource source [s | (which, (_, s)) <- beside, isWrong which]
                                      > inSource source agreeing
                                ],
                          supportDistance e === Exactly distance,
                          supportRadius e === radius,
                          fmap chanceExact (supportChance e) === Just False,
                          near (maybe 0 chanceShare (supportChance e)) (among size radius),
                          (locationOutcome found == Placed (position (drawnAt drawn))) === few
                        ]
  where
    position (r, c) = Position (fromIntegral r) (fromIntegral c)
    -- 255 spheres among all contents, as docs/explanation/locating.md has it.
    among (high, wide) radius =
      min 1 (255 * sum [over m i * 3 ^ i | i <- [0 .. min m (toInteger radius)]] `ratio` (4 ^ m))
      where
        m = toInteger (high * wide)
    over m i = product [m - i + 1 .. m] `div` product [1 .. i]
    ratio a b = fromInteger a / fromInteger b :: Double

-- | The location of a block's symbols with additions, seen as they were drawn.
locatedAs ::
  KnownField k =>
  Recogniser k ->
  Tolerance ->
  Drawn ->
  [InCell] ->
  [(Beside, InCell)] ->
  GridLocation
locatedAs reader tolerance drawn block beside =
  locateGrid reader tolerance (only Sideways) (gridOf (seen (block ++ looks)) (only Stray))
  where
    seen = seenAs (drawnOrientation drawn)
    looks = [placed | (which, placed) <- beside, which `notElem` [Stray, Sideways]]
    only kind = map snd (seen [((0, 0), s) | (which, (_, s)) <- beside, which == kind])

near :: Double -> Double -> Property
near a b = counterexample (show (a, b)) (abs (a - b) <= 1e-9 * (1 + abs b))

refusalSpec :: KnownField k => PseudorandomArray k -> Recogniser k -> Spec
refusalSpec array reader = do
  it "too many symbols with another way up are WrongWayUp" $ do
    -- Two of a certain place, and one of either axis; as many as lie the first way.
    told (block 3 3) {sceneBeside = [((0, 0), turnedOver 0), ((1, 1), turnedOver 1)]}
      `shouldBe` WrongWayUp
    told (block 3 3) {sceneAside = [sideways 0, sideways 1]} `shouldBe` WrongWayUp
    told (block 2 2) {sceneBeside = [((0, 2), turnedOver 1), ((1, 2), turnedOver 3)]}
      `shouldBe` WrongWayUp
    told (block 3 3) {sceneBeside = [((0, 0), turnedOver 0)]} `shouldBe` placed
  it "too many symbols off the grid are OffTheGrid" $ do
    told (block 3 3) {sceneStrays = [stray 1, stray 3]} `shouldBe` OffTheGrid
    told (block 2 2) {sceneStrays = [stray 1]} `shouldBe` OffTheGrid
    told (block 3 3) {sceneStrays = [stray 1]} `shouldBe` placed
  it "if both reasons apply, WrongWayUp is reported" $ do
    told (block 3 3) {sceneStrays = [stray 1], sceneAside = [sideways 0]} `shouldBe` WrongWayUp
    told (block 3 3) {sceneStrays = [stray 1, stray 2], sceneAside = [sideways 0]}
      `shouldBe` OffTheGrid
  it "groups that are placed differently are GroupsApart" $ do
    -- Beside a larger group, and beside one of the same size.
    told (block 3 3) {sceneGroup = moved (0, 3) (blockOf array 2 2 (1, 1))} `shouldBe` GroupsApart
    told (block 2 2) {sceneGroup = moved (0, 3) (blockOf array 2 2 (1, 1))} `shouldBe` GroupsApart
    told (block 2 2) {sceneGroup = moved (0, 3) (blockOf array 2 2 (6, 8))} `shouldBe` placed
  it "more wrong symbols than the radius are beyond-radius" $
    for_ [((0, 0), (2, 2)), ((0, 1), (1, 1)), ((1, 0), (2, 1))] $ \(a, b) ->
      told (block 3 3) {sceneChanged = [a, b]} `shouldBe` Unplaced BeyondRadius
  it "too many wrong looks at cells that others place are a contradiction" $
    told (block 3 3) {sceneBeside = [((0, 0), otherwise' 0), ((2, 2), otherwise' 2)]}
      `shouldBe` Unplaced Contradiction
  it "a place that fits but is not likely enough is below-threshold" $
    locationOutcome (asked standardTolerance {foreignPrior = 0.5} (block 2 2))
      `shouldBe` Unplaced BelowThreshold
  it "zeros alone are a zero-window" $
    told (block 2 2) {sceneBlock = [(at, (identity, 0)) | (at, _) <- blockOf array 2 2 (6, 5)]}
      `shouldBe` Unplaced ZeroWindow
  it "fewer symbols than a window are no-complete-window" $
    for_ [1, 2, 3] $ \n ->
      told (block 2 2) {sceneBlock = take n (blockOf array 2 2 (6, 5))}
        `shouldBe` Unplaced NoCompleteWindow
  it "symbols unknown to the network, without a likely place, are no-complete-window" $
    locationOutcome (locateGrid reader standardTolerance [] (gridOf unknown []))
      `shouldBe` Unplaced NoCompleteWindow
  it "without a certain complete symbol the answer is below-threshold, however sure the parts" $
    -- Anywhere on the array, on a face or not.
    whenRight (placement (Shape 15 17) canonicalPitch [] []) $ \nothingLaid ->
      forAll ((,) <$> choose (0, 12) <*> choose (0, 13)) $ \(r, c) ->
        forAll (sublistOf [0 .. 11]) $ \complete ->
          let at = Position (fromIntegral r) (fromIntegral c)
              part n s
                | n `elem` complete = s
                | otherwise = s {readSeen = 0.9, readClass = Nothing}
              seen =
                [ (cell, part n (clear n what))
                  | (n, (cell, what)) <- zip [0 ..] (blockOf array 3 4 (r, c))
                ]
              anywhere = reader {recogniserPlacement = nothingLaid}
           in locationOutcome (locateGrid anywhere standardTolerance [] (gridOf seen []))
                === (if null complete then Unplaced BelowThreshold else Placed at)
  it "several places with all complete windows, if windows are too small, are Undecided" $ do
    window <- right (rectangle (Shape 1 2))
    reader' <- recogniserWith array window
    let pair = blockOf array 1 2 (6, 5)
        same =
          [ Position (fromIntegral r) (fromIntegral c)
            | r <- [0 .. 14],
              c <- [0 .. 16],
              blockOf array 1 2 (r, c) == pair
          ]
    length same `shouldBe` 16
    locationOutcome (locateGrid reader' standardTolerance [] (gridOf (numbered 0 pair) []))
      `shouldBe` Undecided same
  where
    told = locationOutcome . asked standardTolerance
    placed = Placed (Position 6 5)
    block high wide = Built (blockOf array high wide (6, 5)) [] [] [] [] []
    turnedOver n = (turned 2, n)
    otherwise' i = (identity, (classAt array (6 + i, 5 + i) + 1) `mod` 4)
    sideways n = (turned 1, n)
    stray n = (identity, n)
    moved (di, dj) those = [((i + di, j + dj), what) | ((i, j), what) <- those]
    asked tolerance built =
      locateGrid
        reader
        tolerance
        (zipWith clear [400 ..] (sceneAside built))
        (gridOf (own ++ group ++ beside) strays)
          { gridGroups = [Set.fromList (map (readNumber . snd) those) | those <- [own, group]]
          }
      where
        own = numbered 0 (map changed (sceneBlock built))
        group = numbered 100 (sceneGroup built)
        beside = numbered 200 (sceneBeside built)
        strays = zipWith clear [300 ..] (sceneStrays built)
        changed (at, (o, c)) =
          (at, (o, if at `elem` sceneChanged built then (c + 1) `mod` 4 else c))
    unknown =
      [ (at, (unsure 0.5 (clear 0 what)) {readClass = Nothing})
        | (at, what) <- blockOf array 2 2 (6, 5)
      ]
    numbered from those = [(at, clear n what) | (n, (at, what)) <- zip [from ..] those]

-- | A block and its additions.
data Built = Built
  { sceneBlock :: Block,
    -- | cells of the block that hold another class
    sceneChanged :: [(Int, Int)],
    -- | a second group
    sceneGroup :: Block,
    -- | further symbols, of no group
    sceneBeside :: Block,
    -- | off the grid
    sceneStrays :: [(Symmetry, Int)],
    -- | along the other axis
    sceneAside :: [(Symmetry, Int)]
  }

-- | The shipped recogniser with another window.
recogniserWith :: KnownField k => PseudorandomArray k -> Mask -> IO (Recogniser k)
recogniserWith array window = do
  layout <- right canonicalPlacement
  net <- right paperNetwork
  known <- right paperAlphabet
  right (recogniser (ArrayOn Torus array) window layout (readerOf known net))
