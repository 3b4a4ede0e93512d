{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RankNTypes #-}

-- | Tests embossed plates and solids. A plate is the points below its face and the boxes of its
-- raised taxels, each tested. A solid with symbols is a solid again, with the expected corners and
-- volume.
module Test.Recognition.Object.EmbossedByCounting (spec) where

import Data.Foldable (for_)
import Data.Maybe (mapMaybe)
import Data.Ratio ((%))
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Array (Position (..), PseudorandomArray, Shape (..))
import PraTactile.Conformance.Laws.Solids (moved)
import PraTactile.Emboss
import PraTactile.Emboss.Rounding
import PraTactile.Explore (insidePolygon)
import PraTactile.Field (KnownField)
import PraTactile.Object.Canonical
import PraTactile.Object.Cells (Grid (..), bestGrid, cellsOn)
import PraTactile.Object.Frame (frameOf)
import PraTactile.Object.Mesh hiding (named)
import PraTactile.Object.Named
import PraTactile.Object.Placement hiding (corner)
import PraTactile.Object.Validity
import PraTactile.Object.WingedEdge
import PraTactile.Profile
import PraTactile.Relief (classOn)
import PraTactile.Shape
import PraTactile.Shape.Outline (outlines)
import Test.Effort
import Test.Hspec hiding (before)
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck hiding (within)
import Test.Recognition.Object.Support (layingFor)
import Test.Solid.Drilled (drilledWith, plateOf)
import Test.Support
import Test.Touch.Paper (paperAlphabet)

spec :: Spec
spec = do
  it "the paper's solids stay closed surfaces, with the volume of the solid and its raised taxels" $
    withArray $ \array -> do
      layout <- right canonicalPlacement
      paper <- right paperAlphabet
      for_
        ( byEffort
            (drop 1)
            id
            [("cube", 6480, 13275570223 % 6400), ("parallelepiped", 5840, 11161638967 % 6400)]
        )
        $ \(name, taxels, size) -> do
          made <- right (embossed paper array layout (WholeObject name))
          embossedTaxels made `shouldBe` taxels
          embossedVolume made `shouldBe` Volume size 0
          it' <- right (rounded Fractions made)
          let report = examine (roundedMesh it')
          (reportDefects report, map componentVolume (reportComponents report))
            `shouldBe` ([], [Just size])
          map componentEuler (reportComponents report) `shouldBe` [2]
          roundedMost it' `shouldBe` 0
  withCases 10 30 . prop "a point is in a plate just if it is below its face or in a taxel" $
    withScene $ \array given layout laid ->
      forAll (elements [2, 3, 7 % 2]) $ \thick ->
        let Face object face = laidFace laid
            thickness = thick * pitchRight (placementPitch layout) / 16
         in whenRight (findObject layout object) $ \whole ->
              whenRight (embossed given array layout (plated object face thickness)) $ \made ->
                whenRight (rounded Decimals made) $ \found ->
                  let surface = onFace (cornersBy whole face) (roundedMesh found)
                      defined = inPlate (shapeOn given array laid) layout laid thickness
                   in forAll (vectorOf 60 (genPoint laid (fromRational thickness))) $ \points ->
                        conjoin
                          [counterexample (show p) (within surface p === defined p) | p <- points]
  withCases 10 30 . prop "a solid with symbols is a solid with the counted number of corners" $
    withScene $ \array given layout laid ->
      let object = faceObject (laidFace laid)
       in whenRight (embossed given array layout (WholeObject object)) $ \made ->
            whenRight (findObject layout object) $ \whole ->
              whenRight (rounded Decimals made) $ \found ->
                let report = examine (roundedMesh found)
                    before = examine (solidMesh whole)
                    outlined =
                      [ corner
                        | cell <- blockCells (laidBlock laid),
                          Just shape <- [shapeOn given array laid cell],
                          Right loops <- [outlines shape],
                          corner <- concat loops
                      ]
                    vertices = reportVertices before + 2 * length outlined
                    euler = sum (map componentEuler (reportComponents before))
                    size = sum (mapMaybe componentVolume (reportComponents report))
                    told = nearestVolume (embossedVolume made)
                 in conjoin
                      [ reportDefects report === [],
                        reportVertices report === vertices,
                        reportFaces report === 2 * (vertices - euler),
                        counterexample
                          (show (size, told))
                          (abs (fromRational size / told - 1) < 1e-9)
                      ]
  describe "emboss refuses" $ do
    it "shapes of which two taxels meet only at a corner, by name" $
      withArray $ \array -> do
        layout <- right canonicalPlacement
        given <- right paperAlphabet
        let checkered = bitmapWhere (\x y -> x < 4 && y < 4 && (x < 2) == (y < 2))
        spoilt <-
          right . alphabet $
            zip ["a", "b", "pair", "d"] (take 2 (shapes given) ++ checkered : drop 3 (shapes given))
        fmap embossedTaxels (embossed spoilt array layout (WholeObject "cube"))
          `shouldBe` Left (CornerContact "pair" (2, 2))
    it "plates no thicker than their symbols are high, and unknown faces and objects" $
      withArray $ \array -> do
        layout <- right canonicalPlacement
        given <- right paperAlphabet
        let made = fmap embossedTaxels . embossed given array layout
            top = readFaceName "C1 C2 C3 C4"
        made (PlateOf "cube" top (Just (127 / 80))) `shouldBe` Left (TooThin (127 / 80) (127 / 80))
        made (PlateOf "cube" top (Just (127 / 80 + 1 % 1000))) `shouldBe` Right 1096
        made (PlateOf "cube" (readFaceName "C1 C2 C3") Nothing)
          `shouldBe` Left (NotThere (UnknownFace (Face "cube" (readFaceName "C1 C2 C3"))))
        made (WholeObject "ball") `shouldBe` Left (NotThere (UnknownObject "ball"))
    it "more raised symbols than the limit" $
      withArray $ \array -> do
        given <- right paperAlphabet
        for_ [(128, 128, False), (129, 128, True)] $ \(high, wide, tooMany) -> do
          slab <- right (solid (namedDescription (Box 4000 50 4200)))
          let front = Face "box" (readFaceName "V2 V6 V7 V3")
              laying = laidWhole front (Position 0 0) (Shape high wide)
          layout <- right (placement (Shape 200 200) canonicalPitch [slab] [laying])
          let made = embossed given array layout (WholeObject "box")
          either (== TooManySymbols (high * wide)) (const False) made
            `shouldBe` tooMany
    it "symbols that run into those of a face across a slot, but not those of a wider one" $
      withArray $ \array -> do
        given <- right paperAlphabet
        for_ [(2, True), (3, True), (4, False), (20, False)] $ \(wide, runs) -> do
          whole <- right (solid (slotted wide))
          layout <-
            right
              ( placement
                  (Shape 15 17)
                  canonicalPitch
                  [whole]
                  [ laidWhole (Face "slotted" (readFaceName face)) (Position 0 c) (Shape 1 1)
                    | (face, c) <- [("A5 A4 B4 B5", 0), ("A7 A6 B6 B7", 1)]
                  ]
              )
          made <- right (embossed given array layout (WholeObject "slotted"))
          let outcome = rounded Binary32 made >>= uncut whole made
          (wide, outcome) `shouldBe` (wide, if runs then Left Collided else Right ())
    it "coordinates of 32 bits if symbols are too small for them" $
      withArray $ \array -> do
        given <- right paperAlphabet
        let away (Point x y z) = Point (x + 100000000) y z
        far <- right (solid (moved away (namedDescription (Box 30 40 5))))
        let top = Face "box" (readFaceName "V1 V2 V3 V4")
            laying = laidWhole top (Position 0 0) (Shape 1 1)
        layout <- right (placement (Shape 15 17) canonicalPitch [far] [laying])
        made <- right (embossed given array layout (WholeObject "box"))
        either show (const "") (rounded Binary32 made) `shouldStartWith` "Melted"
        fmap roundedMost (rounded Fractions made) `shouldBe` Right 0
    it "fractions that are not exact coordinates" $
      withArray $ \array -> do
        given <- right paperAlphabet
        slanted <- right (solid (namedDescription (Tetrahedron 200)))
        let grid = gridOn canonicalPitch slanted 0
            laid = layingFor slanted grid (gridCells grid)
        layout <- right (placement (Shape 15 17) canonicalPitch [slanted] [laid])
        made <- right (embossed given array layout (WholeObject "tetrahedron"))
        either show (const "") (rounded Fractions made) `shouldStartWith` "Irrational"
  where
    plated object face = PlateOf object face . Just

-- | A point near a face, right of and below its first vertex and above it.
genPoint :: LaidFace -> Double -> Gen (Double, Double, Double)
genPoint laid thickness =
  (,,) <$> along left wide <*> along top high <*> choose (-1.2 * thickness, thickness)
  where
    (left, top) = spotMillimetres (laidBox laid)
    (wide, high) = spotMillimetres (laidExtent laid)
    along from size = choose (from - size / 10, from + 1.1 * size)

-- | The shape of the symbol in a cell.
shapeOn ::
  KnownField k => Alphabet -> PseudorandomArray k -> LaidFace -> Position -> Maybe Bitmap
shapeOn given array laid = either (const Nothing) Just . shapeOf given . classOn array laid

-- | Whether a point is in a plate of this thickness: it is below its face, or in a raised taxel of
-- the symbol in the middle of its cell.
inPlate ::
  (Position -> Maybe Bitmap) ->
  Placement ->
  LaidFace ->
  Rational ->
  (Double, Double, Double) ->
  Bool
inPlate shapeAt layout laid thickness (x, y, z)
  | z <= 0 = z > negate (fromRational thickness) && insidePolygon corners (x, y)
  | r < 0 || c < 0 || not (hasCell (laidBlock laid) cell) = False
  | otherwise = z < taxel && maybe False (\b -> embossedAt b (u - 4) (v - 4)) (shapeAt cell)
  where
    corners = map (spotMillimetres . snd) (laidCorners laid)
    taxel = fromRational (pitchRight (placementPitch layout) / 16)
    (left, top) = spotMillimetres (laidMargin laid)
    (r, v) = floor ((y - top) / taxel) `divMod` 20
    (c, u) = floor ((x - left) / taxel) `divMod` 16 :: (Int, Int)
    cell = Position (fromIntegral (r :: Int)) (fromIntegral c)

-- | A block with a slot of this width in millimetres, whose walls are 60 mm high and 40 mm long.
slotted :: Rational -> Description
slotted wide =
  Description
    { describedName = "slotted",
      describedVertices =
        [ (VertexName (side : show k), Point x y z)
          | (side, y) <- [('A', 0), ('B', 40)],
            (k, (x, z)) <- zip [1 :: Int ..] outline
        ],
      describedFaces =
        FaceName [VertexName ('A' : show k) | k <- [1 .. 8 :: Int]] :
        FaceName [VertexName ('B' : show k) | k <- [8, 7 .. 1 :: Int]] :
          [ FaceName (map VertexName ['A' : show j, 'A' : show k, 'B' : show k, 'B' : show j])
            | (k, j) <- zip [1 .. 8 :: Int] ([2 .. 8 :: Int] ++ [1])
          ]
    }
  where
    -- Seen from y = 0, counter-clockwise; the slot is between the fourth and the seventh one.
    outline = (0, 0) : map ((,) (100 + wide)) [0, 80] ++ slot ++ [(0, 80)]
    slot = [(50 + wide, 80), (50 + wide, 20), (50, 20), (50, 80)]

-- | The canonical array.
withArray :: (forall k. KnownField k => PseudorandomArray k -> IO a) -> IO a
withArray test = either (fail . show) id (withProfile canonicalProfile (\array _ -> test array))

-- | A face of some solid, laid on the array in the middle of the face or at a margin. It covers as
-- many cells as there is room for, with symbols of some size and random shapes.
withScene ::
  Testable p =>
  (forall k. KnownField k => PseudorandomArray k -> Alphabet -> Placement -> LaidFace -> p) ->
  Property
withScene test =
  forAllBlind genAlphabet $ \given ->
    forAll (elements [1 / 2, 1, 3 / 2]) $ \size ->
      forAll (elements solids) $ \which ->
        whenRight (solid which) $ \whole ->
          forAll (choose (0, V.length (meshWalks (solidMesh whole)) - 1)) $ \f ->
            forAll ((,) <$> choose (0, 4) <*> choose (0, 4)) $ \(i, j) ->
              forAll (elements [Centred, Centred, Margin 9 (11 / 3), Margin (size * 20) 5]) $
                \anchor ->
                  let between@(Pitch right' down) = Pitch (size * 127 / 5) (size * 127 / 4)
                      grid = gridOn between whole f
                      cells =
                        [ (r, c)
                          | Just frame <- [frameOf (solidMesh whole) (gridWalk grid)],
                            (r, c) <-
                              cellsOn frame (right', down) anchor (gridRows grid, gridColumns grid),
                            r + i < 15,
                            c + j < 17
                        ]
                      laying =
                        (layingFor whole grid cells)
                          { layAt = Position (fromInteger i) (fromInteger j),
                            layAnchor = anchor
                          }
                   in not (null cells)
                        ==> whenRight (placement (Shape 15 17) between [whole] [laying])
                        $ \layout -> conjoin (map (tested given layout) (laidFaces layout))
  where
    solids =
      plateOf (drilledWith 40 (160, 190) [(30, 60, 70, 100), (90, 60, 130, 120)]) :
      map
        namedDescription
        ( [Cube, Tetrahedron 150, Prism 5 90 70, LShape 120 100 80, Pyramid 100 110 120]
            ++ [Frame 200 160 60]
        )
    tested given layout laid =
      either (\e -> counterexample (show e) False) id $
        withProfile canonicalProfile (\array _ -> property (test array given layout laid))

-- | The best grid of a face.
gridOn :: Pitch -> Solid -> Int -> Grid
gridOn (Pitch right' down) whole f =
  bestGrid (solidMesh whole) (right', down) (meshWalks (solidMesh whole) V.! f)

-- | Four shapes made of rectangles and holes, of which no two taxels meet only at a corner.
genAlphabet :: Gen Alphabet
genAlphabet = do
  drawn <- vectorOf 4 (genShape `suchThat` usable)
  either (const genAlphabet) pure (alphabet (zip ["a", "b", "c", "d"] drawn))
  where
    usable shape = area shape > 0 && either (const False) (const True) (outlines shape)
    genShape = do
      boxes <- resize 5 (listOf1 ((,) <$> frequency [(3, pure True), (1, pure False)] <*> genBox))
      pure (bitmapWhere (\x y -> foldl (put x y) False boxes))
    put x y on (raised, box) = if inBox box x y then raised else on
    genBox = do
      (x, y) <- (,) <$> choose (0, 7) <*> choose (0, 11)
      (w, h) <- (,) <$> choose (1, 4) <*> choose (1, 6)
      pure (x, y, x + w, y + h)
    inBox (x0, y0, x1, y1) x y = x0 <= x && x < x1 && y0 <= y && y < (y1 :: Int)

cornersBy :: Solid -> FaceName -> [Point]
cornersBy whole face =
  maybe [] (map (pointAt (solidMesh whole)) . U.toList) (walkNamed whole face)

type Triangle = [(Double, Double, Double)]

-- | The triangles of a polyhedron in coordinates right of, below and above the first corner of a
-- face.
onFace :: [Point] -> Mesh -> [Triangle]
onFace corners made =
  [map (placed . pointAt made) (U.toList walk) | walk <- V.toList (meshWalks made)]
  where
    placed p = let v = way p in (v `along` right', v `along` down, v `along` up)
    way (Point x y z) = case corners of
      Point x0 y0 z0 : _ -> (fromRational (x - x0), fromRational (y - y0), fromRational (z - z0))
      [] -> (0, 0, 0)
    right' = unit (way (last corners))
    up = unit (double (outwardNormal corners))
    double (Point a b c) = (fromRational a, fromRational b, fromRational c)
    down = crossed right' up
    crossed (a, b, c) (d, e, f) = (b * f - c * e, c * d - a * f, a * e - b * d)
    along (a, b, c) (d, e, f) = a * d + b * e + c * f
    unit v@(a, b, c) = let l = sqrt (along v v) in (a / l, b / l, c / l)

-- | Whether a point is within a closed surface: on the line straight up from it, more triangles
-- face up than down.
within :: [Triangle] -> (Double, Double, Double) -> Bool
within surface (x, y, z) = sum (map passed surface) == (1 :: Int)
  where
    passed triangle = case triangle of
      [(ax, ay, az), (bx, by, bz), (cx, cy, cz)]
        | whole /= 0 && u > 0 && v > 0 && w > 0 && u * az + v * bz + w * cz > z ->
          -- Rows go down, so that counter-clockwise from above turns right.
          if whole < 0 then 1 else -1
        where
          whole = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
          v = ((x - ax) * (cy - ay) - (y - ay) * (cx - ax)) / whole
          w = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / whole
          u = 1 - v - w
      _ -> 0
