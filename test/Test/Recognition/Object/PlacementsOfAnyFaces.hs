{-# LANGUAGE OverloadedStrings #-}

-- | Tests placements of any objects: where everything lies, cell by cell; the search; the files;
-- and faces of any form pressed and recognised.
module Test.Recognition.Object.PlacementsOfAnyFaces (spec) where

import Data.Either (fromLeft)
import Data.Foldable (for_)
import Data.List (nub)
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust)
import qualified Data.Set as Set
import PraTactile.Array (ArrayOn (..), Position (..), Shape (..), Surface (..))
import PraTactile.Classification.Reader (readerOf)
import PraTactile.Evaluate
import PraTactile.Explore
import PraTactile.Format
import PraTactile.Object.Canonical
import PraTactile.Object.Cells (gridCells, gridColumns, gridOf, gridRows)
import PraTactile.Object.Named
import PraTactile.Object.Number (minus, plus, times)
import PraTactile.Object.Packing (Reason (..))
import PraTactile.Object.Placement
import PraTactile.Object.Placement.Search
import PraTactile.Object.Placement.Windows
import PraTactile.Object.Radicals (fraction)
import PraTactile.Object.WingedEdge
import PraTactile.Profile
import PraTactile.Recognise
import PraTactile.Sensor (idealSensor)
import Test.Effort
import Test.Hspec
import Test.QuickCheck
import Test.Support
import Test.Touch.Paper (paperAlphabet, paperNetwork)

spec :: Spec
spec = do
  describe "random solids, laid by search" lookUpSpec
  describe "windows counted" countSpec
  describe "the search" searchSpec
  describe "files" fileSpec
  describe "faces of any form" touchSpec

-- | Solids with every kind of face, some with one cell, some with many.
solids :: [Named]
solids =
  [ Box 60 90 40,
    Octahedron 110,
    Tetrahedron 200,
    LShape 150 60 150,
    Prism 7 120 50,
    Pyramid 150 120 90,
    Pyritohedron 90,
    Frame 200 200 40,
    Cube
  ]

-- | Some of these solids, half of the time two equal ones, laid from any of their vertices on 63 x
-- 65 cells, with symbols of some size.
placements :: Gen (Either String Placement)
placements = do
  chosen <- sublistOf solids `suchThat` (not . null)
  twice <- oneof [pure [], (: []) <$> elements (take 3 chosen)]
  size <- elements [1, 3 / 4, 1 / 2]
  begun <- elements [AsNamed, AnyVertex]
  seed <- choose (1, 99)
  let twins = [(namedDescription one) {describedName = "twin"} | one <- twice]
  pure (laidBy seed size begun (map namedDescription chosen ++ twins))

laidBy :: Int -> Rational -> Begun -> [Description] -> Either String Placement
laidBy seed size begun chosen = do
  bodies <- either (Left . show) Right (traverse solid chosen)
  case layingsOf seed sheet pitch [] bodies (facesOf pitch begun bodies) of
    LaidSo layings -> either (Left . show) Right (placement sheet pitch bodies layings)
    other -> Left (show other)
  where
    Pitch right' down = canonicalPitch
    pitch = Pitch (size * right') (size * down)

sheet :: Shape
sheet = Shape 63 65

-- | For each cell of the array that a face has: the face, and the cell of its block.
owners :: Placement -> Map.Map (Integer, Integer) (LaidFace, (Integer, Integer))
owners place =
  Map.fromList
    [ ((toInteger (row at + i), toInteger (column at + j)), (laid, (toInteger i, toInteger j)))
      | laid <- laidFaces place,
        let at = laidAt laid,
        Position i j <- blockCells (laidBlock laid)
    ]

-- | A window and where it begins: anywhere, or so that one of its corners is at the edge of a face,
-- or just beyond it.
genWindow ::
  Map.Map (Integer, Integer) (LaidFace, (Integer, Integer)) ->
  Gen ((Integer, Integer), (Integer, Integer))
genWindow own = do
  window@(high, wide) <- (,) <$> choose (1, 4) <*> choose (1, 4)
  let anywhere = (,) <$> choose (0, 62) <*> choose (0, 64)
      beside = do
        (r, c) <- elements edges
        (i, j) <- (,) <$> elements [0, high - 1, high] <*> elements [0, wide - 1, wide]
        pure ((r - i) `mod` 63, (c - j) `mod` 65)
  (,) window <$> oneof (anywhere : [beside | not (null edges)])
  where
    edges = [cell | (cell, (laid, _)) <- Map.toList own, any (elsewhere laid) (beside4 cell)]
    elsewhere laid cell = fmap (laidFace . fst) (Map.lookup cell own) /= Just (laidFace laid)
    beside4 (r, c) = [(r - 1, c), (r + 1, c), (r, c - 1), (r, c + 1)]

shape :: Integer -> Integer -> Shape
shape high wide = Shape (fromInteger high) (fromInteger wide)

position :: Integer -> Integer -> Position
position r c = Position (fromInteger r) (fromInteger c)

lookUpSpec :: Spec
lookUpSpec = do
  withCases 5 20 . it "all cells of the faces are there, and lie where their grid has them" $
    forAllShow placements (fromLeft "a placement") $ \made ->
      whenRight made $ \place ->
        conjoin
          [ counterexample (show (laidFace laid)) $
              length (blockCells (laidBlock laid)) === length (gridCells grid)
                .&&. (rows (laidGrid laid), columns (laidGrid laid))
                === (fromInteger (gridRows grid), fromInteger (gridColumns grid))
            | laid <- laidFaces place,
              Just body <- [placementObject place (faceObject (laidFace laid))],
              Just walk <- [walkNamed body (faceName (laidFace laid))],
              let Pitch a b = placementPitch place,
              let grid = gridOf (solidMesh body) (a, b) walk,
              laidAnchor laid == Centred
          ]
          .&&. Map.size (owners place)
          === sum (map (length . blockCells . laidBlock) (laidFaces place))
  withCases 5 20 . it "a window is on a face, on several or on none as its cells are, one by one" $
    forAllShow placements (fromLeft "a placement") $ \made ->
      whenRight made $ \place ->
        let own = owners place
         in forAll (vectorOf 60 (genWindow own)) $ \windows ->
              conjoin
                [ kindOf (whereabouts place (uncurry shape window) (uncurry position spot))
                    === expected (map laidFace (laidFaces place)) own window spot
                  | (window, spot) <- windows
                ]
  withCases 5 20 . it "a symbol lies half a pitch within its cell, a window amid its symbols" $
    forAllShow placements (fromLeft "a placement") $ \made ->
      whenRight made $ \place ->
        forAll ((,) <$> choose (1, 4) <*> choose (1, 4)) $ \(high, wide) ->
          forAll ((,) <$> choose (0, 9) <*> choose (0, 9)) $ \(r, c) ->
            let Pitch right' down = placementPitch place
                inCell laid side = side (centre laid 0 0) `minus` side (laidMargin laid)
                centre laid i j = cellCentre place laid (position i j)
                mean laid side =
                  times (1 / fromInteger (high * wide)) . foldr plus (fraction 0) $
                    [ side (centre laid (r + i) (c + j))
                      | i <- [0 .. high - 1],
                        j <- [0 .. wide - 1]
                    ]
             in conjoin
                  [ (inCell laid spotRight, inCell laid spotDown)
                      === (fraction (right' / 2), fraction (down / 2))
                      .&&. windowCentre place laid (shape high wide) (position r c)
                      === Spot (mean laid spotRight) (mean laid spotDown)
                    | laid <- laidFaces place
                  ]
  withCases 5 10 . it "every cell leads to the face and back" $
    forAllShow placements (fromLeft "a placement") $ \made ->
      whenRight made $ \place ->
        conjoin
          [ arrayPosition place (laidFace laid) (Position (fromInteger i) (fromInteger j))
              === Right (Position (fromInteger r) (fromInteger c))
            | ((r, c), (laid, (i, j))) <- Map.toList (owners place)
          ]

-- | The place of a window: the face and the cell of its block, several faces, or none.
data Lies = On Face (Integer, Integer) | OnSeveral [Face] | None
  deriving stock (Eq, Show)

kindOf :: Whereabouts -> Lies
kindOf found = case found of
  OnFace place ->
    On (placeFace place) (toInteger (row (placeCell place)), toInteger (column (placeCell place)))
  Straddles faces -> OnSeveral faces
  OnNoObject -> None

-- | The place by the cells of the window: all of one face, side by side; or some of several, in the
-- order of layings.
expected ::
  [Face] ->
  Map.Map (Integer, Integer) (LaidFace, (Integer, Integer)) ->
  (Integer, Integer) ->
  (Integer, Integer) ->
  Lies
expected order own (high, wide) (r, c)
  | all beside found, Just (laid, cell) <- Map.lookup (r, c) own = On (laidFace laid) cell
  | several@(_ : _ : _) <- inOrder = OnSeveral several
  | otherwise = None
  where
    found =
      [ (i, j, Map.lookup ((r + i) `mod` 63, (c + j) `mod` 65) own)
        | i <- [0 .. high - 1],
          j <- [0 .. wide - 1]
      ]
    beside (i, j, there) = case (there, Map.lookup (r, c) own) of
      (Just (laid, (a, b)), Just (first, (a0, b0))) ->
        laidFace laid == laidFace first && (a, b) == (a0 + i, b0 + j)
      _ -> False
    touched = nub [laidFace laid | (_, _, Just (laid, _)) <- found]
    inOrder = filter (`elem` touched) order

countSpec :: Spec
countSpec = do
  it "on the canonical placement: 132 of 255 on faces, 89 on several, 34 on none or in part" $ do
    place <- right canonicalPlacement
    windowCounts place canonicalWindow `shouldBe` Just (WindowCounts 132 89 34)
  withCases 2 4 . it "equal the counts of single windows, on any placement" $
    forAllShow placements (fromLeft "a placement") $ \made ->
      forAll (shape <$> choose (1, 4) <*> choose (1, 4)) $ \window ->
        whenRight made $ \place ->
          let kinds =
                [ kindOf (whereabouts place window (Position r c))
                  | r <- [0 .. 62],
                    c <- [0 .. 64]
                ]
           in windowCounts place window
                === Just
                  ( WindowCounts
                      (length [() | On _ _ <- kinds])
                      (length [() | OnSeveral _ <- kinds])
                      (length [() | None <- kinds])
                  )
  it "are counted on arrays of up to 2^26 cells" $ do
    body <- right (solid (namedDescription (Box 60 90 40)))
    for_ [(Shape 8192 8192, True), (Shape 8192 8193, False), (Shape 8193 8192, False)] $
      \(whole, counted) -> do
        place <- right (placement whole canonicalPitch [body] [])
        (whole, isJust (windowCounts place (Shape 2 2))) `shouldBe` (whole, counted)
  it "leastPress is the smallest press that has a whole window's symbols wherever it lies" $
    for_ [(h, w) | h <- [1 .. 5], w <- [1 .. 5]] $ \(h, w) ->
      leastPress (shape h w) `shouldBe` (leastAcross 16 8 w, leastAcross 20 12 h)
  where
    -- The least length along one axis, for this many symbols of a side in the middle of cells, in
    -- half taxels.
    leastAcross pitch side count =
      head
        [ long
          | long <- [1 ..],
            and [any (whole (2 * long) begin) [0 .. 2] | begin <- [0 .. 2 * pitch - 1]]
        ]
      where
        whole long begin first =
          2 * pitch * first + pitch - side >= begin
            && 2 * pitch * (first + count - 1) + pitch + side <= begin + long

searchSpec :: Spec
searchSpec = do
  it "lays the paper's objects on 15 x 17, each face with as many cells as it has" $ do
    bodies <- right (traverse (solid . namedDescription) [Cube, Parallelepiped])
    let wishes = facesOf canonicalPitch AnyVertex bodies
    case layingsOf 1 (Shape 15 17) canonicalPitch [] bodies wishes of
      LaidSo layings -> do
        place <- right (placement (Shape 15 17) canonicalPitch bodies layings)
        Map.size (owners place) `shouldBe` 228
      other -> expectationFailure (show other)
  it "leaves laid faces where they are" $ do
    lying <- right canonicalPlacement
    small <- right (solid ((namedDescription (Box 60 40 40)) {describedName = "small"}))
    let bodies = placementSolids lying ++ [small]
    case layingsOf
      1
      (Shape 15 17)
      canonicalPitch
      (laidFaces lying)
      bodies
      (take 2 (facesOf canonicalPitch AnyVertex [small])) of
      LaidSo layings -> do
        let earlier = map layingOf (laidFaces lying)
        place <- right (placement (Shape 15 17) canonicalPitch bodies (earlier ++ layings))
        take 12 (laidFaces place) `shouldBe` laidFaces lying
      other -> expectationFailure (show other)
  it "gives the reason if the layout is impossible" $ do
    for_
      [ ([Box 500 500 500], \why -> case why of PieceTooLarge 0 -> True; _ -> False),
        ( [LShape 200 200 200, Octahedron 200],
          \why -> case why of TooFewCells _ 255 -> True; _ -> False
        )
      ]
      $ \(chosen, wanted) -> do
        bodies <- right (traverse (solid . namedDescription) chosen)
        layingsOf 1 (Shape 15 17) canonicalPitch [] bodies (facesOf canonicalPitch AnyVertex bodies)
          `shouldSatisfy` \found -> case found of
            NoWay why -> wanted why
            _ -> False

fileSpec :: Spec
fileSpec = do
  withCases 5 20 . it "decodePlacement . encodePlacement = Right" $
    forAllShow placements (fromLeft "a placement") $ \made ->
      whenRight made $ \place ->
        let profile = canonicalProfile {profileShape = sheet}
         in decodePlacement (encodePlacement profile place) === Right (profile, place)
  it "a face at a margin, begun at any vertex, on some of its cells, is read as written" $ do
    body <- right (solid (namedDescription Cube))
    let face = Face "cube" (readFaceName "C2 C3 C4 C1")
        some = Block (Shape 2 3) (Just (Set.fromList [Position 0 1, Position 1 0, Position 1 2]))
        laying = Laying face (Position 3 4) (Margin (1 / 3) 20) some
    place <- right (placement (Shape 15 17) canonicalPitch [body] [laying])
    decodePlacement (encodePlacement canonicalProfile place)
      `shouldBe` Right (canonicalProfile, place)
    windowCounts place (Shape 1 1) `shouldBe` Just (WindowCounts 3 0 252)

touchSpec :: Spec
touchSpec = do
  it "are pressed and recognised, with symbols of any size" $ do
    whenFull $ recognised AnyVertex 1 [Octahedron 250]
    recognised AnyVertex (1 / 2) [LShape 120 60 120, Prism 5 100 80]
  it "are recognised where they are two rows high and the window three" $
    recognised AsNamed 1 [Box 250 250 80]
  where
    recognised begun size chosen = do
      alphabet <- right paperAlphabet
      network <- right paperNetwork
      place <- right (laidBy 1 size begun (map namedDescription chosen))
      let presses = byEffort 2 8
          profile =
            canonicalProfile
              { profilePolynomial = [2, 1, 1, 0, 0, 0, 1],
                profileState = [0, 0, 0, 0, 0, 1],
                profileShape = sheet,
                profileWindow = Shape 3 2
              }
          experiment =
            (standardExperiment idealSensor)
              { experimentPresses = presses,
                experimentExploration = exploration idealSensor AnyAngle (40, 72)
              }
      results <-
        right $
          withProfile profile $ \array mask -> do
            reader <-
              either
                (Left . show)
                Right
                ( recogniser
                    (ArrayOn Torus array)
                    mask
                    (scaledPlacement (1 / size) place)
                    (readerOf alphabet network)
                )
            either (Left . show) Right (evaluated experiment array reader)
      outcomes <- map withStitching <$> right results
      [() | Mistaken _ <- outcomes] `shouldBe` []
      -- A quick run leaves out all but a few.
      length [() | Correct _ <- outcomes]
        `shouldSatisfy` (>= presses - max 1 (presses `div` 4))
