-- | Tests regions of the plane cut into triangles: properties of each triangle, each side and each
-- point.
module Test.Solid.RegionsTriangulated (spec) where

import Data.List (mapAccumL, nub, sort)
import qualified Data.Map.Strict as Map
import qualified Data.Vector as V
import PraTactile.Object.Description (cyclicPairs)
import PraTactile.Object.Polygon
import PraTactile.Object.Triangulation
import Test.Hspec hiding (around)
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  prop "every triangle turns left, and there are n - 2 o + 2 h of them" $
    forAll genRegion $ \whole@(Region _ loops) ->
      let found = cut whole
       in conjoin
            [ conjoin [counterexample (show t) (turnOf whole t > 0) | t <- found],
              length found
                === length (concat loops) - 2 * outer whole + 2 * (length loops - outer whole)
            ]
  prop "every side is a loop's, or two triangles walk it in opposite directions" $
    forAll genRegion $ \whole@(Region _ loops) ->
      let sides = [side | (a, b, c) <- cut whole, side <- [(a, b), (b, c), (c, a)]]
          border = [normal side | loop <- loops, side <- cyclicPairs loop]
          normal (a, b) = (min a b, max a b)
          alone = [normal (a, b) | (a, b) <- sides, (b, a) `notElem` sides]
       in conjoin [sides === nub sides, sort alone === sort border]
  prop "a point of the region is in one triangle, and any other point in none" $
    forAll genRegion $ \whole@(Region points loops) ->
      forAll ((,) <$> choose (-10, 810) <*> choose (-10, 810)) $ \(x, y) ->
        -- Twice as fine as corners are, so that it is on no side of a lattice.
        let p = V2 (2 * x + 1) (2 * y + 1)
            doubled = V.map (\(V2 a b) -> V2 (2 * a) (2 * b)) points
            inOne (a, b, c) =
              standing (V.fromList [doubled V.! a, doubled V.! b, doubled V.! c]) p
            around = [standing (V.fromList (map (doubled V.!) loop)) p | loop <- loops]
            places = map inOne (cut whole)
         in OnRim `notElem` around && OnRim `notElem` places
              ==> length (filter (== Inside) places)
              === if odd (length (filter (== Inside) around)) then 1 else 0
  prop "no corner lies within the circle round a neighbouring triangle" $
    forAll genRegion $ \whole@(Region points _) ->
      let apexes =
            Map.fromList
              [ found
                | (a, b, c) <- cut whole,
                  found <- [((a, b), c), ((b, c), a), ((c, a), b)]
              ]
       in conjoin
            [ counterexample (show (a, b, c, d)) (not (inside (at a) (at b) (at c) (at d)))
              | ((a, b), c) <- Map.toList apexes,
                Just d <- [Map.lookup (b, a) apexes],
                let at = (points V.!)
            ]
  it "a square whose sides have corners on them loses none of them" $
    let square = [V2 0 0, V2 1 0, V2 3 0, V2 4 0, V2 4 2, V2 4 4, V2 2 4, V2 0 4, V2 0 3, V2 0 1]
        sides = Region (V.fromList square) [[0 .. 9]]
     in (length (cut sides), sum (map (turnOf sides) (cut sides))) `shouldBe` (8, 32)

-- | Points, and loops of them.
data Region = Region (V.Vector V2) [[Int]]
  deriving stock (Show)

cut :: Region -> [(Int, Int, Int)]
cut (Region points loops) = triangulation (Metric 1 1) points loops

turnOf :: Region -> (Int, Int, Int) -> Integer
turnOf (Region points _) (a, b, c) = turn (points V.! a) (points V.! b) (points V.! c)

-- | The number of loops with an even number of others round them.
outer :: Region -> Int
outer (Region points loops) =
  length
    [ ()
      | (i, corner : _) <- zip [0 :: Int ..] loops,
        even (length [() | (j, loop) <- zip [0 ..] loops, i /= j, holdsCorner loop corner])
    ]
  where
    holdsCorner loop corner =
      standing (V.fromList (map (points V.!) loop)) (points V.! corner) == Inside

-- | Whether the centre of the circle round three points that turn left is nearer to them than to
-- the fourth, by the lengths themselves.
inside :: V2 -> V2 -> V2 -> V2 -> Bool
inside (V2 ax ay) (V2 bx by) (V2 cx cy) (V2 dx dy) = far dx dy < far ax ay
  where
    twice = 2 * (q ax * (q by - q cy) + q bx * (q cy - q ay) + q cx * (q ay - q by))
    square x y = q x * q x + q y * q y
    (a, b, c) = (square ax ay, square bx by, square cx cy)
    x0 = (a * (q by - q cy) + b * (q cy - q ay) + c * (q ay - q by)) / twice
    y0 = (a * (q cx - q bx) + b * (q ax - q cx) + c * (q bx - q ax)) / twice
    far x y = (q x - x0) * (q x - x0) + (q y - y0) * (q y - y0)
    q = fromInteger :: Integer -> Rational

-- | A square, or a convex polygon, with pieces in some squares of a lattice: none, a square, a
-- corner, a ring, or a ring with a piece in its hole; walked either way.
genRegion :: Gen Region
genRegion = do
  rim <- elements [square (-1) 801, bulging]
  cells <- vectorOf 16 (elements [[], [square 20 60], [angle], take 2 nested, nested])
  loops <-
    mapM
      (\loop -> elements [loop, reverse loop])
      (rim : concat (zipWith inCell [0 ..] cells))
  let numbered from loop = (from + length loop, [from .. from + length loop - 1])
  pure (Region (V.fromList (map (uncurry V2) (concat loops))) (snd (mapAccumL numbered 0 loops)))
  where
    bulging = [(-500, 400), (300, -600), (1500, -100), (1200, 700), (700, 1600), (-100, 1200)]
    square from to = [(from, from), (to, from), (to, to), (from, to)]
    angle = [(10, 10), (50, 10), (50, 50), (90, 50), (90, 90), (10, 90)]
    nested = [square 10 80, square 20 70, square 30 50]
    inCell k = map (map (\(x, y) -> (200 * (k `div` 4) + 2 * x, 200 * (k `mod` 4) + 2 * y)))
