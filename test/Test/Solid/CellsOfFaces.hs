-- | Tests the cells on a face: figures worked out elsewhere, faces with holes, and the grid with
-- the most cells. The conformance suite compares each cell of other faces with its definition.
module Test.Solid.CellsOfFaces (spec) where

import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Conformance.Laws.Solids (solids)
import PraTactile.Object.Cells
import PraTactile.Object.Mesh
import PraTactile.Object.Named
import Test.Effort
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck
import Test.Solid.Drilled

spec :: Spec
spec = do
  it "the cube has 4 x 5 on each face" $
    gridsOf Cube `shouldBe` replicate 6 (4, 5, Just 20)
  it "the parallelepiped has 3 x 7 and 3 x 4" $
    gridsOf Parallelepiped `shouldBe` replicate 4 (3, 7, Just 21) ++ replicate 2 (3, 4, Just 12)
  it "P1 P2 P3 P4 has 3 x 7 and, begun at P2, 5 x 4" $
    [ shape (gridOf paper pitch (turned k))
      | let paper = fromDescription (namedDescription Parallelepiped)
            turned k' = let walk = meshWalks paper V.! 0 in U.drop k' walk U.++ U.take k' walk,
        k <- [0, 1]
    ]
      `shouldBe` [(3, 7, Just 21), (5, 4, Just 20)]
  it "a tetrahedron in a cube of 200 mm and its octahedron have 28: 9, 7, 5, 3, 3, 1, 0 of 11" $
    do
      gridsOf (Tetrahedron 200) `shouldBe` replicate 4 (7, 11, Just 28)
      gridsOf (Octahedron 200) `shouldBe` replicate 8 (7, 11, Just 28)
      map rowsOf (take 1 (grids (Tetrahedron 200))) `shouldBe` [[9, 7, 5, 3, 3, 1, 0]]
  it "the L face of l:200x100x200 has 30 of 6 x 7" $
    take 1 (gridsOf (LShape 200 100 200)) `shouldBe` [(6, 7, Just 30)]
  withCases 10 100 . prop "a plate with holes has those of the whole plate that meet no hole" $
    forAll drilled $ \plate ->
      let it_ = fromDescription (plateOf plate)
          grid = gridOf it_ (2, 3) (meshWalks it_ V.! 0)
          -- The face begins at its lower left corner and ends above that: right is along y.
          (high, wide) = outer plate !! 2
          (rows', columns) = (floor (high / 3), floor (wide / 2)) :: (Integer, Integer)
          top r = (high - 3 * fromInteger rows') / 2 + 3 * fromInteger r
          left c = (wide - 2 * fromInteger columns) / 2 + 2 * fromInteger c
          free r c =
            and
              [ top r >= maximum xs || top r + 3 <= minimum xs
                  || left c >= maximum ys
                  || left c + 2 <= minimum ys
                | hole <- holes plate,
                  let (xs, ys) = unzip hole
              ]
       in gridCells grid
            === [(r, c) | r <- [0 .. rows' - 1], c <- [0 .. columns - 1], free r c]
  withCases 20 100 . prop "are counted if that takes at most this many tests of a side and a cell" $
    forAll (elements [LShape 200 100 200, Tetrahedron 200, Prism 7 150 40, Octahedron 90]) $
      \solid -> forAll (elements (walks solid)) $ \walk ->
        let upTo most = gridWithin most (fromDescription (namedDescription solid)) pitch walk
            whole = upTo 1000000
            count = toInteger (length (gridCells whole))
            tests = gridRows whole * gridColumns whole * toInteger (U.length walk)
            few = upTo (tests - 1)
            -- A rectangle has all cells of its grid, without a test.
            full = count == gridRows whole * gridColumns whole
         in map gridCount [whole, upTo tests, few]
              === [Just count, Just count, if full then Just count else Nothing]
              .&&. counterexample (show (gridAtLeast few, count)) (gridAtLeast few <= count)
  withCases 10 100 . prop "are those from the first vertex that gives the face the most" $
    forAll solids $ \drawn ->
      let it_ = fromDescription drawn
          begun walk =
            [ gridOf it_ pitch (U.drop k walk U.++ U.take k walk)
              | k <- [0 .. U.length walk - 1]
            ]
          first found = take 1 [one | one <- found, gridCount one == maximum (map gridCount found)]
          -- Fewer tests than would leave some cells uncounted.
          few walk = and [tests one * toInteger (U.length walk) < most | one <- begun walk]
          most = byEffort 10000 100000
          tests grid = gridRows grid * gridColumns grid * toInteger (U.length (gridWalk grid))
          counted = filter few (V.toList (meshWalks it_))
       in map (bestGrid it_ pitch) counted === concatMap (first . begun) counted
  where
    shape grid = (gridRows grid, gridColumns grid, gridCount grid)
    gridsOf = map shape . grids
    grids solid = map (bestGrid (fromDescription (namedDescription solid)) pitch) (walks solid)
    walks = V.toList . meshWalks . fromDescription . namedDescription
    rowsOf grid =
      [length (filter ((== r) . fst) (gridCells grid)) | r <- [0 .. gridRows grid - 1]]

pitch :: (Rational, Rational)
pitch = (127 / 5, 127 / 4)
