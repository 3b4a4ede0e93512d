{-# LANGUAGE OverloadedStrings #-}

-- | Tests placements: the canonical one, both look-ups against its definition, and refusals.
module Test.Recognition.Object.FacesOnTheArray (spec) where

import Data.Foldable (for_)
import Data.List (sort)
import qualified Data.Map.Strict as Map
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Object.Canonical
import PraTactile.Object.PaperObjects (cube)
import PraTactile.Object.Placement hiding (Block, blockCells)
import PraTactile.Object.WingedEdge
import Test.Effort
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck
import Test.Recognition.Object.Support

spec :: Spec
spec = describe "placement" $ do
  describe "the canonical one" $ do
    it "is laid as the profile's table says, each grid centred on its face" $
      thePlacement $ \it_ ->
        laidFaces it_
          `shouldBe` [ LaidFace
                         { laidFace = blockFace b,
                           laidAt = Position (blockRow b) (blockColumn b),
                           laidAnchor = Centred,
                           laidBlock = wholeBlock (Shape (blockRows b) (blockColumns b)),
                           laidCorners =
                             zip
                               (faceVertices (faceName (blockFace b)))
                               [spotAt 0 0, spotAt 0 high, spotAt wide high, spotAt wide 0],
                           laidBox = spotAt 0 0,
                           laidExtent = spotAt wide high,
                           laidMargin =
                             spotAt
                               (wide / 2 - fromIntegral (blockColumns b) * 12.7)
                               (high / 2 - fromIntegral (blockRows b) * 15.875)
                         }
                       | b <- blocks,
                         let (wide, high) = (mm (blockWidth b), mm (blockHeight b))
                     ]
    it "lays every face of both objects" $
      thePlacement $ \it_ ->
        Map.keysSet (Map.fromList [(laidFace laid, ()) | laid <- laidFaces it_])
          `shouldBe` Map.keysSet
            ( Map.fromList
                [(Face (solidName o) face, ()) | o <- placementSolids it_, face <- solidFaces o]
            )
    it "takes 228 of the 255 cells, none twice" $ do
      Map.size owners `shouldBe` 228
      filter ((/= 1) . length) (Map.elems owners) `shouldBe` []
    it "puts the worked example's window, at (6, 5), at corner C2 of C1 C2 C3 C4 of the cube" $
      thePlacement $ \it_ ->
        whereabouts it_ canonicalWindow (Position 6 5)
          `shouldBe` OnFace
            ( Place
                (Face "cube" (readFaceName "C1 C2 C3 C4"))
                (Position 2 0)
                (spotAt 25.4 95.25)
                ["C2"]
            )

  describe "from the array to the objects" $ do
    it "all 255 windows of 2 x 2 are where the definition, cell by cell, says" $
      thePlacement $ \it_ ->
        for_ everyPosition $ \at ->
          whereabouts it_ canonicalWindow at `shouldBe` expectedWhereabouts canonicalWindow at
    it "132 of them lie on a face, of which 28 have no single nearest corner" $
      thePlacement $ \it_ -> do
        let places =
              [place | at <- everyPosition, OnFace place <- [whereabouts it_ canonicalWindow at]]
        length places `shouldBe` 132
        length (filter ((== Nothing) . corner) places) `shouldBe` 28
    it "windows of every shape up to 6 x 9, and some beyond the torus, follow the definition" $
      thePlacement $ \it_ ->
        for_
          ( [Shape r c | r <- [0 .. 6], c <- [0 .. 9]]
              ++ [Shape 1 17, Shape 15 1, Shape 15 17, Shape 16 18]
          )
          $ \window ->
            for_ everyPosition $ \at ->
              (window, at, whereabouts it_ window at)
                `shouldBe` (window, at, expectedWhereabouts window at)
    it "a cell at the array's edge has no neighbour beyond it, on a face that spans it" $
      theCube $ \solid_ ->
        right
          ( placement
              (Shape 4 5)
              canonicalPitch
              [solid_]
              [laidWhole topFace (Position 0 0) (Shape 4 5)]
          )
          >>= \it_ -> do
            whereabouts it_ canonicalWindow (Position 0 4) `shouldBe` OnNoObject
            whereabouts it_ canonicalWindow (Position 3 0) `shouldBe` OnNoObject
            whereabouts it_ (Shape 4 5) (Position 0 0) `shouldSatisfy` isOnFace
    prop "whereabouts (r, c) = whereabouts (r + 15 i, c + 17 j), however large" $
      \(NonNegative r, NonNegative c) (NonNegative i, NonNegative j) -> case canonicalPlacement of
        Left fault -> counterexample (show fault) False
        Right it_ ->
          let near = Position (fromInteger r) (fromInteger c)
              far = Position (fromInteger (r + 15 * huge * i)) (fromInteger (c + 17 * huge * j))
              huge = 10 ^ (30 :: Int)
           in whereabouts it_ canonicalWindow near === whereabouts it_ canonicalWindow far
    it "a window of 10^30 x 10^30 cells is answered at once" $
      thePlacement $ \it_ ->
        let huge = 10 ^ (30 :: Int)
         in whereabouts it_ (Shape huge huge) (Position 3 4)
              `shouldBe` Straddles (map blockFace blocks)

  describe "from the objects to the array" $ do
    it "every cell of every face: face -> position -> face" $
      thePlacement $ \it_ ->
        for_ blocks $ \block -> for_ (blockCells block) $ \(cell, local) -> do
          arrayPosition it_ (blockFace block) local `shouldBe` Right cell
          case whereabouts it_ (Shape 1 1) cell of
            OnFace place -> (placeFace place, placeCell place) `shouldBe` (blockFace block, local)
            other -> expectationFailure (show other)
    it "every cell of the array: position -> face -> position, or no object" $
      thePlacement $ \it_ ->
        for_ everyPosition $ \at -> case whereabouts it_ (Shape 1 1) at of
          OnFace place -> arrayPosition it_ (placeFace place) (placeCell place) `shouldBe` Right at
          other -> (other, Map.member at owners) `shouldBe` (OnNoObject, False)
    it "a face is found wherever its name starts" $
      thePlacement $ \it_ ->
        (laidFace <$> findFace it_ "cube" (readFaceName "C3 C4 C1 C2")) `shouldBe` Right topFace
    it "unknown objects and faces, clockwise names, and cells beyond the face are refused" $
      thePlacement $ \it_ -> do
        let alien = readFaceName "P1 P2 P3 P4"
            clockwise = readFaceName "C4 C3 C2 C1"
        fmap solidName (findObject it_ "sphere") `shouldBe` Left (UnknownObject "sphere")
        findFace it_ "cube" alien `shouldBe` Left (UnknownFace (Face "cube" alien))
        findFace it_ "cube" clockwise
          `shouldBe` Left (WrongVertexOrder (Face "cube" clockwise) (faceName topFace))
        arrayPosition it_ topFace (Position 4 0)
          `shouldBe` Left (CellOffFace topFace (Position 4 0))
        arrayPosition it_ topFace (Position 0 5)
          `shouldBe` Left (CellOffFace topFace (Position 0 5))

  describe "a placement is refused for" $
    for_ mutations $ \(sentence, build, fault) ->
      it sentence $
        theCube $ \solid_ ->
          theParallelepiped $ \other -> build [solid_, other] `shouldBe` Left fault

  describe "any placement" layingSpec

-- | Blocks of any size, anywhere on the array and on the cube's faces, which are squares of 127 mm,
-- at any pitch.
layingSpec :: Spec
layingSpec =
  withCases 100 400 . it "is laid with each block in its place, or refused for the first fault" $
    whenRight cube $ \it_ ->
      forAll (Pitch <$> elements pitches <*> elements pitches) $ \between ->
        forAll (choose (0, 3) >>= (`vectorOf` genLaying between (solidFaces it_))) $ \layings ->
          placed between it_ layings === defined between layings
  where
    pitches = [127 / 5, 127 / 4, 127 / 2, 30]
    sheet = Shape 9 11
    genLaying between names = do
      named <- elements (take 3 names)
      at <- Position <$> elements [0, 3, 4, 5, 6] <*> elements [0, 4, 6, 7, 8]
      grid <- Shape <$> elements [0 .. 5] <*> elements [0 .. 5]
      let margin side count = elements [0, -1 / 1000, 1 / 3, least, least + 1 / 1000]
            where
              -- The block ends where the face does.
              least = 127 - fromIntegral (count grid) * side between
      anchor <- oneof [pure Centred, Margin <$> margin pitchRight columns <*> margin pitchDown rows]
      pure (laidWhole (Face "cube" named) at grid) {layAnchor = anchor}
    placed between it_ layings = laidFaces <$> placement sheet between [it_] layings
    defined between layings = do
      laid <- traverse (one between) layings
      let two = [(a, b) | (k, a) <- zip [0 :: Int ..] laid, b <- drop (k + 1) laid]
      mapM_ Left (take 1 [FaceLaidTwice (laidFace a) | (a, b) <- two, laidFace a == laidFace b])
      mapM_
        Left
        ( take
            1
            [ FacesOverlap (laidFace a) (laidFace b) (filter (`elem` cellsIn b) (cellsIn a))
              | cell <- sort (concatMap cellsIn laid),
                a : b : _ <- [filter ((cell `elem`) . cellsIn) laid]
            ]
        )
      pure laid
    cellsIn laid =
      [ Position (row (laidAt laid) + i) (column (laidAt laid) + j)
        | Position i j <- cellsOf (laidGrid laid)
      ]
    one between (Laying face at anchor given)
      | high == 0 || wide == 0 = Left (EmptyGrid face grid)
      | row at + high > 9 || column at + wide > 11 = Left (OutsideArray face at grid)
      | not (null off) = Left (CellsOffFace face off)
      | otherwise =
        Right
          LaidFace
            { laidFace = face,
              laidAt = at,
              laidAnchor = anchor,
              laidBlock = wholeBlock grid,
              laidCorners =
                zip
                  (faceVertices (faceName face))
                  [spotAt 0 0, spotAt 0 127, spotAt 127 127, spotAt 127 0],
              laidBox = spotAt 0 0,
              laidExtent = spotAt 127 127,
              laidMargin = spotAt left top
            }
      where
        grid@(Shape high wide) = blockShape given
        (left, top) = case anchor of
          Margin x y -> (x, y)
          _ -> ((127 - across) / 2, (127 - down) / 2)
        off =
          [ Position i j
            | Position i j <- cellsOf grid,
              not (on (left + fromIntegral j * pitchRight between) (pitchRight between))
                || not (on (top + fromIntegral i * pitchDown between) (pitchDown between))
          ]
        on from size = from >= 0 && from + size <= 127
        across = fromIntegral wide * pitchRight between
        down = fromIntegral high * pitchDown between

mm :: Integer -> Rational
mm micrometres = fromInteger micrometres / 1000

isOnFace :: Whereabouts -> Bool
isOnFace (OnFace _) = True
isOnFace _ = False

topFace, nearFace :: Face
topFace = Face "cube" (readFaceName "C1 C2 C3 C4")
nearFace = Face "cube" (readFaceName "C2 C6 C7 C3")

mutations :: [(String, [Solid] -> Either PlacementError Placement, PlacementError)]
mutations =
  [ ("an array without rows", with' (Shape 0 17) canonicalPitch [], EmptyArray (Shape 0 17)),
    ("an array without columns", with' (Shape 15 0) canonicalPitch [], EmptyArray (Shape 15 0)),
    ("a pitch of zero along rows", with' sheet (Pitch 0 1) [], PitchNotPositive (Pitch 0 1)),
    ("a pitch of zero along columns", with' sheet (Pitch 1 0) [], PitchNotPositive (Pitch 1 0)),
    ( "two objects of one name",
      \objects -> placement sheet canonicalPitch (objects ++ take 1 objects) [],
      RepeatedObject "cube"
    ),
    ( "an unknown object",
      laying [lay (Face "sphere" (FaceName ["S1"])) (0, 0) (1, 1)],
      UnknownObject "sphere"
    ),
    ( "a face of another object",
      laying [lay alien (0, 0) (1, 1)],
      UnknownFace alien
    ),
    ( "a face named clockwise",
      laying [lay clockwise (0, 0) (1, 1)],
      WrongVertexOrder clockwise (faceName topFace)
    ),
    ( "a face without cells",
      laying [lay topFace (0, 0) (0, 5)],
      EmptyGrid topFace (Shape 0 5)
    ),
    ( "a grid larger than its face",
      laying [lay topFace (0, 0) (4, 6)],
      CellsOffFace topFace [Position i j | i <- [0 .. 3], j <- [0, 5]]
    ),
    ( "a face over the sheet's right edge",
      laying [lay topFace (0, 13) (4, 5)],
      OutsideArray topFace (Position 0 13) (Shape 4 5)
    ),
    ( "a face over the sheet's lower edge",
      laying [lay topFace (12, 0) (4, 5)],
      OutsideArray topFace (Position 12 0) (Shape 4 5)
    ),
    ( "a face laid twice",
      laying [lay topFace (0, 0) (4, 5), lay topFace (8, 0) (4, 5)],
      FaceLaidTwice topFace
    ),
    ( "two faces on the same cells",
      laying [lay topFace (0, 0) (4, 5), lay nearFace (2, 4) (4, 5)],
      FacesOverlap topFace nearFace [Position 2 4, Position 3 4]
    )
  ]
  where
    sheet = Shape 15 17
    with' shape between layings objects = placement shape between objects layings
    laying = with' sheet canonicalPitch
    lay face (r, c) (high, wide) = laidWhole face (Position r c) (Shape high wide)
    alien = Face "cube" (readFaceName "P1 P2 P3 P4")
    clockwise = Face "cube" (readFaceName "C4 C3 C2 C1")
