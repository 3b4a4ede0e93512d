-- | Which cells lie on a face: figures worked out elsewhere, what turning and moving a face must
-- leave as it is, and each cell on faces whose frames are rational, by its corners alone.
module Test.Solid.CellsOfFaces (spec) where

import Data.List (nub, sort)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Cells
import PraTactile.Object.Description
import PraTactile.Object.Mesh
import PraTactile.Object.Named
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck
import Test.Solid.Drawn (moved)

spec :: Spec
spec = do
  it "of the cube, 4 x 5 on each face" $
    gridsOf Cube `shouldBe` replicate 6 (4, 5, Just 20)
  it "of the parallelepiped, 3 x 7 and 3 x 4" $
    gridsOf Parallelepiped `shouldBe` replicate 4 (3, 7, Just 21) ++ replicate 2 (3, 4, Just 12)
  it "of P1 P2 P3 P4, 3 x 7, and begun at P2, 5 x 4" $
    [ shape (gridOf paper pitch (turned k))
      | let paper = fromDescription (namedDescription Parallelepiped)
            turned k' = let walk = meshWalks paper V.! 0 in U.drop k' walk U.++ U.take k' walk,
        k <- [0, 1]
    ]
      `shouldBe` [(3, 7, Just 21), (5, 4, Just 20)]
  it "of a tetrahedron in a cube of 200 mm and of its octahedron, 28: 9, 7, 5, 3, 3, 1, 0 of 11" $
    do
      gridsOf (Tetrahedron 200) `shouldBe` replicate 4 (7, 11, Just 28)
      gridsOf (Octahedron 200) `shouldBe` replicate 8 (7, 11, Just 28)
      map rowsOf (take 1 (grids (Tetrahedron 200))) `shouldBe` [[9, 7, 5, 3, 3, 1, 0]]
  it "of the L face of l:200x100x200, 30 of 6 x 7" $
    take 1 (gridsOf (LShape 200 100 200)) `shouldBe` [(6, 7, Just 30)]
  prop "are as many wherever the object is and however it is turned" $
    forAll (elements [LShape 200 100 200, Tetrahedron 200, Prism 7 150 40, Frame 300 250 90]) $
      \solid -> forAllBlind rotation $ \turn ->
        [ shape (bestGrid (fromDescription (moved turn (namedDescription solid))) pitch walk)
          | walk <-
              walks solid
        ]
          === gridsOf solid
  prop "are those whose corners, and those of the cells in them, are all in the polygon" $
    forAll polygon $ \corners ->
      let it_ = fromDescription (plate corners)
          grid = gridOf it_ (1, 1) (U.fromList [0 .. length corners - 1])
       in sort (gridCells grid) === sort (cellsOf corners)
  where
    shape grid = (gridRows grid, gridColumns grid, gridCount grid)
    gridsOf = map shape . grids
    grids solid = map (bestGrid (fromDescription (namedDescription solid)) pitch) (walks solid)
    walks = V.toList . meshWalks . fromDescription . namedDescription
    rowsOf grid =
      [length (filter ((== r) . fst) (gridCells grid)) | r <- [0 .. gridRows grid - 1]]

pitch :: (Rational, Rational)
pitch = (127 / 5, 127 / 4)

-- | A rotation by the quaternion of four small integers, and a shift.
rotation :: Gen (Point -> Point)
rotation = do
  (a, b) <- (,) <$> part <*> part
  (c, d) <- ((,) <$> part <*> part) `suchThat` (\(c, d) -> (a, b, c, d) /= (0, 0, 0, 0))
  s <- part
  let n = a * a + b * b + c * c + d * d
  pure $ \(Point x y z) ->
    Point
      ( s
          + ( (a * a + b * b - c * c - d * d) * x
                + 2 * (b * c - a * d) * y
                + 2 * (b * d + a * c) * z
            )
          / n
      )
      ( s
          + ( 2 * (b * c + a * d) * x
                + (a * a - b * b + c * c - d * d) * y
                + 2 * (c * d - a * b) * z
            )
          / n
      )
      ( s
          + ( 2 * (b * d - a * c) * x + 2 * (c * d + a * b) * y
                + (a * a - b * b - c * c + d * d) * z
            )
          / n
      )
  where
    part = fromInteger <$> choose (-5, 5)

-- | A polygon seen from above, x to the right and y down, from its upper left corner: to the left
-- of a staircase that goes down, and above one that comes back up, so that it is simple.
polygon :: Gen [(Rational, Rational)]
polygon = do
  width <- quarter (20, 40)
  depths <- (: []) <$> quarter (8, 30)
  steps <- choose (1, 4)
  lefts <- sort . nub <$> vectorOf steps (quarter (1, 19))
  heights <- vectorOf (length lefts) (quarter (2, 30))
  let floors = zip (0 : lefts) (depths ++ heights)
      below = concat [[(x, y), (x', y)] | ((x, y), x') <- zip floors (lefts ++ [width])]
  pure (distinct ((0, 0) : filter (/= (0, 0)) below ++ [(width, 0)]))
  where
    quarter (a, b) = (/ 4) . fromInteger <$> choose (a, b)
    distinct (p : q : more)
      | p == q = distinct (q : more)
      | otherwise = p : distinct (q : more)
    distinct few = few

-- | The polygon as a face seen from above: y points down there, towards the viewer here.
plate :: [(Rational, Rational)] -> Description
plate corners =
  Description
    (ObjectName "plate")
    [(VertexName (show i), Point x (negate y) 0) | (i, (x, y)) <- zip [0 :: Int ..] corners]
    [FaceName [VertexName (show i) | i <- [0 .. length corners - 1]]]

-- | The cells of one by one that lie in such a polygon, whose sides are along the axes: those all
-- of whose pieces, cut at every corner's x and y, have their middle in it.
cellsOf :: [(Rational, Rational)] -> [(Integer, Integer)]
cellsOf corners =
  [ (r, c)
    | r <- [0 .. rows - 1],
      c <- [0 .. columns - 1],
      let (x, y) = (left + fromInteger c, top + fromInteger r),
      and
        [ holds ((x1 + x2) / 2, (y1 + y2) / 2)
          | (x1, x2) <- pieces x (map fst corners),
            (y1, y2) <- pieces y (map snd corners)
        ]
  ]
  where
    (wide, high) = (maximum (map fst corners), maximum (map snd corners))
    (columns, rows) = (floor wide, floor high)
    left = (wide - fromInteger columns) / 2
    top = (high - fromInteger rows) / 2
    pieces from cuts =
      let marks = sort (from : from + 1 : [m | m <- cuts, m > from, m < from + 1])
       in zip marks (drop 1 marks)
    -- How many sides a ray to the right meets.
    holds (x, y) =
      odd
        ( length
            [ ()
              | ((x1, y1), (x2, y2)) <- zip corners (drop 1 corners ++ take 1 corners),
                x1 == x2,
                x1 > x,
                (y1 > y) /= (y2 > y)
            ]
        )
