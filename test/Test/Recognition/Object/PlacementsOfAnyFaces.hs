{-# LANGUAGE OverloadedStrings #-}

-- | Placements of any objects: what lies where, cell by cell; the search; the files; and faces of
-- any form pressed and recognised.
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
import PraTactile.Object.Packing (Reason (..))
import PraTactile.Object.Placement
import PraTactile.Object.Placement.Search
import PraTactile.Object.Placement.Windows
import PraTactile.Object.WingedEdge
import PraTactile.Profile
import PraTactile.Recognise
import PraTactile.Sensor (idealSensor)
import Test.Hspec
import Test.QuickCheck
import Test.Support
import Test.Touch.Paper (paperAlphabet, paperNetwork)

spec :: Spec
spec = do
  describe "of drawn solids, laid by search" lookUpSpec
  describe "windows counted" countSpec
  describe "the search" searchSpec
  describe "files" fileSpec
  describe "faces of any form" touchSpec

-- | Solids of every kind of face, some of which have one cell, some many.
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

-- | Some of them, laid from any of their vertices on 63 x 65 cells, of symbols of some size.
placements :: Gen (Either String Placement)
placements = do
  chosen <- sublistOf solids `suchThat` (not . null)
  size <- elements [1, 3 / 4, 1 / 2]
  begun <- elements [AsNamed, AnyVertex]
  seed <- choose (1, 99)
  pure (laidBy seed size begun chosen)

laidBy :: Int -> Rational -> Begun -> [Named] -> Either String Placement
laidBy seed size begun chosen = do
  bodies <- either (Left . show) Right (traverse (solid . namedDescription) chosen)
  case layingsOf seed sheet pitch [] bodies (facesOf pitch begun bodies) of
    LaidSo layings -> either (Left . show) Right (placement sheet pitch bodies layings)
    other -> Left (show other)
  where
    Pitch right' down = canonicalPitch
    pitch = Pitch (size * right') (size * down)

sheet :: Shape
sheet = Shape 63 65

-- | Of each cell of the array that a face has: the face, and the cell of its block.
owners :: Placement -> Map.Map (Integer, Integer) (LaidFace, (Integer, Integer))
owners place =
  Map.fromList
    [ ((toInteger (row at + i), toInteger (column at + j)), (laid, (toInteger i, toInteger j)))
      | laid <- laidFaces place,
        let at = laidAt laid,
        Position i j <- blockCells (laidBlock laid)
    ]

shape :: Integer -> Integer -> Shape
shape high wide = Shape (fromInteger high) (fromInteger wide)

position :: Integer -> Integer -> Position
position r c = Position (fromInteger r) (fromInteger c)

lookUpSpec :: Spec
lookUpSpec = do
  it "all the faces' cells are there, and lie where their grid has them" $
    holds 20 . forAllShow placements (fromLeft "a placement") $ \made ->
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
  it "a window is on a face, on several or on none as its cells are, one by one" $
    holds 20 . forAllShow placements (fromLeft "a placement") $ \made ->
      forAll ((,) <$> choose (1, 4) <*> choose (1, 4)) $ \window ->
        forAll (vectorOf 60 ((,) <$> choose (0, 62) <*> choose (0, 64))) $ \spots ->
          whenRight made $ \place ->
            let own = owners place
             in conjoin
                  [ kindOf (whereabouts place (uncurry shape window) (uncurry position spot))
                      === expected (map laidFace (laidFaces place)) own window spot
                    | spot <- spots
                  ]
  it "every cell leads to the face and back" $
    holds 10 . forAllShow placements (fromLeft "a placement") $ \made ->
      whenRight made $ \place ->
        conjoin
          [ arrayPosition place (laidFace laid) (Position (fromInteger i) (fromInteger j))
              === Right (Position (fromInteger r) (fromInteger c))
            | ((r, c), (laid, (i, j))) <- Map.toList (owners place)
          ]

-- | What is told of a window: the face and the cell of its block, the faces, or nothing.
data Lies = On Face (Integer, Integer) | OnSeveral [Face] | None
  deriving stock (Eq, Show)

kindOf :: Whereabouts -> Lies
kindOf found = case found of
  OnFace place ->
    On (placeFace place) (toInteger (row (placeCell place)), toInteger (column (placeCell place)))
  Straddles faces -> OnSeveral faces
  OnNoObject -> None

-- | By the cells of the window: all of one face, side by side; or some of several, in the order of
-- layings.
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
  it "are those that are told one by one, on any placement" $
    holds 4 . forAllShow placements (fromLeft "a placement") $ \made ->
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
  it "up to 2^26 cells, and no more" $ do
    body <- right (solid (namedDescription (Box 60 90 40)))
    for_ [(Shape 8192 8192, True), (Shape 8192 8193, False), (Shape 8193 8192, False)] $
      \(whole, counted) -> do
        place <- right (placement whole canonicalPitch [body] [])
        (whole, isJust (windowCounts place (Shape 2 2))) `shouldBe` (whole, counted)
  it "the least press of 2 x 2 windows is 40 x 52 taxels" $
    leastPress (Shape 2 2) `shouldBe` (40, 48 + 4)

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
  it "leaves what lies where it is" $ do
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
  it "says what is impossible" $ do
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
  it "what is written is read again as it was" $
    holds 20 . forAllShow placements (fromLeft "a placement") $ \made ->
      whenRight made $ \place ->
        let profile = canonicalProfile {profileShape = sheet}
         in decodePlacement (encodePlacement profile place) === Right (profile, place)
  it "a face may be laid at a margin, begun at any vertex, on some of its cells" $ do
    body <- right (solid (namedDescription Cube))
    let face = Face "cube" (readFaceName "C2 C3 C4 C1")
        some = Block (Shape 2 3) (Just (Set.fromList [Position 0 1, Position 1 0, Position 1 2]))
        laying = Laying face (Position 3 4) (Margin (1 / 3) 20) some
    place <- right (placement (Shape 15 17) canonicalPitch [body] [laying])
    decodePlacement (encodePlacement canonicalProfile place)
      `shouldBe` Right (canonicalProfile, place)
    windowCounts place (Shape 1 1) `shouldBe` Just (WindowCounts 3 0 252)
  it "cells that do not lie on the face are refused, by name" $ do
    body <- right (solid (namedDescription Cube))
    let face = Face "cube" (readFaceName "C1 C2 C3 C4")
        at margin block =
          placement (Shape 15 17) canonicalPitch [body] [Laying face (Position 0 0) margin block]
    fmap (const ()) (at (Margin 0 0) (wholeBlock (Shape 4 5))) `shouldBe` Right ()
    fmap (const ()) (at (Margin (1 / 1000) 0) (wholeBlock (Shape 4 5)))
      `shouldBe` Left (CellsOffFace face [Position i 4 | i <- [0 .. 3]])

touchSpec :: Spec
touchSpec = do
  it "are pressed and recognised, with symbols of any size" $ do
    recognised AnyVertex 1 [Octahedron 250]
    recognised AnyVertex (1 / 2) [LShape 120 60 120, Prism 5 100 80]
  it "are recognised where they are two rows high and the window three" $
    recognised AsNamed 1 [Box 250 250 80]
  where
    recognised begun size chosen = do
      alphabet <- right paperAlphabet
      network <- right paperNetwork
      place <- right (laidBy 1 size begun chosen)
      let profile =
            canonicalProfile
              { profilePolynomial = [2, 1, 1, 0, 0, 0, 1],
                profileState = [0, 0, 0, 0, 0, 1],
                profileShape = sheet,
                profileWindow = Shape 3 2
              }
          experiment =
            (standardExperiment idealSensor)
              { experimentPresses = 8,
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
      length [() | Correct _ <- outcomes] `shouldSatisfy` (>= 6)
