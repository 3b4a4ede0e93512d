{-# LANGUAGE OverloadedStrings #-}

-- | Triangles put together to the faces that they were, and vertices moved so that faces are flat.
module Test.Solid.MergedAndSettled (spec) where

import Data.List (sort, unfoldr)
import Data.Maybe (fromMaybe)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Conformance.Laws.Solids
import PraTactile.Object.Description
import PraTactile.Object.Merge
import PraTactile.Object.Mesh
import PraTactile.Object.Named
import PraTactile.Object.Tolerance
import PraTactile.Object.Triangles
import PraTactile.Object.Validity
import System.Random (mkStdGen, uniformR)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "coplanar faces" $ do
    prop "cut into triangles, are the solid's own faces again, where none has a hole" $
      forAll (elements whole) $ \solid ->
        let it_ = fromDescription (namedDescription solid)
         in faces (mergeCoplanar (cut it_)) === faces it_
    prop "cut into triangles, a solid is one of the same volume, and so it is merged" $
      forAllBlind solids $ \drawn ->
        let it_ = fromDescription drawn
         in map volumes [cut it_, mergeCoplanar (cut it_)] === [volumes it_, volumes it_]
              .&&. map (reportValid . examine) [cut it_, mergeCoplanar (cut it_)] === [True, True]
    it "the rings of a frame stay in two polygons each, as grow from their first faces" $
      V.length (meshWalks (mergeCoplanar (cut (fromDescription (namedDescription (Frame 9 9 3))))))
        `shouldBe` 4 + 4 + 2 + 2
    it "a vertex in the middle of an edge goes, and the walk begins at the first vertex" $
      faces (mergeCoplanar (fromDescription halved))
        `shouldBe` faces
          (fromDescription (namedDescription Cube))
  describe "a tolerance" $ do
    prop "makes solids flat again that were rounded to thousandths, moving less than that" $
      forAllBlind flatter $ \(drawn, digits) ->
        let rounded = fromDescription (moved (roundTo digits) drawn)
         in counterexample (show drawn) $
              case settled 0.01 False rounded of
                Left why -> counterexample (show why) False
                Right (Settled flat _ most) -> (most <= 0.01) .&&. map defects [flat] === [[]]
    it "leaves a cube as it is" $ do
      let it_ = fromDescription (namedDescription Cube)
      fmap (\(Settled same count most) -> (same, count, most)) (settled 0.5 True it_)
        `shouldBe` Right (it_, 0, 0)
    it "puts vertices together that are no further apart, and no others" $ do
      let it_ = fromDescription (namedDescription (Box 100 100 0.5))
          left mm = V.length . meshPoints . settledMesh <$> settled mm False it_
      map left [0.5, 0.499] `shouldBe` [Right 4, Right 8]
    it "refuses coordinates of more than 2^28 binary digits, which is told, and moves nothing" $ do
      -- Parallelograms, each with a corner a millimetre off, in planes that have nothing in common.
      let quads = 1500
          drawn = take (9 * quads) (unfoldr (Just . uniformR (-4096, 4096)) (mkStdGen 7))
          names = [VertexName (show i) | i <- [1 .. 4 * quads]]
          points =
            [ Point (coordinate a p) (coordinate b q) (coordinate c r)
              | [a, b, c, x, y, z, x', y', z'] <- chunks 9 drawn,
                (p, q, r) <- [(0, 0, 0), (x, y, z), (x + x', y + y', z + z' + 1), (x', y', z')]
            ]
          coordinate far near = fromInteger (256 * far + near)
          it_ =
            fromDescription
              (Description (ObjectName "q") (zip names points) (map FaceName (chunks 4 names)))
      either (\(TooFine bits) -> bits > 2 ^ (28 :: Int)) (const False) (settled 1 False it_)
        `shouldBe` True
      sufficient it_ `shouldBe` Nothing
    it "tells what would do" $
      forAllMoved $ \off ->
        fromMaybe 0 (sufficient (fromDescription off)) `shouldSatisfy` (\mm -> mm > 0 && mm < 1)
  where
    chunks n list = case splitAt n list of
      (front, rest) | length front == n -> front : chunks n rest
      _ -> []
    whole =
      [Cube, Parallelepiped, Box 3 4 5, Pyramid 3 4 5, Tetrahedron 2, Octahedron 3, Pyritohedron 2]
        ++ [LShape 4 2 4, Prism 7 10 3]
    volumes it_ = map componentVolume (reportComponents (examine it_))
    defects = map show . reportDefects . examine
    forAllMoved check =
      check
        ( let cube' = namedDescription Cube
           in cube'
                { describedVertices =
                    [ (v, if v == "C1" then Point x y (z + 1 / 2) else Point x y z)
                      | (v, Point x y z) <- describedVertices cube'
                    ]
                }
        )

-- | The faces by their vertices' places, each from its least.
faces :: Mesh -> [[Point]]
faces it_ =
  sort [least (map (pointAt it_) (U.toList walk)) | walk <- V.toList (meshWalks it_)]
  where
    least = minimum . rotations

-- | Every face as triangles.
cut :: Mesh -> Mesh
cut it_ =
  withShape
    (meshNames it_)
    (meshDenominator it_)
    (meshPoints it_)
    ( V.fromList
        [ U.fromList [i, j, k]
          | walk <- V.toList (meshWalks it_),
            (i, j, k) <- triangles it_ walk
        ]
    )
    it_

-- | Solids with three faces of more than three corners at a vertex at most, turned, and how many
-- digits are kept of them.
flatter :: Gen (Description, Int)
flatter = do
  solid <- elements [Cube, Box 100 60 40, Prism 5 60 20, LShape 100 50 80, Pyritohedron 90]
  (a, b) <- (,) <$> part <*> part
  -- Rotations about z and then x, by rational sines and cosines.
  let (c, s) = ((1 - a * a) / (1 + a * a), 2 * a / (1 + a * a))
      (d, t) = ((1 - b * b) / (1 + b * b), 2 * b / (1 + b * b))
      turned (Point x y z) =
        let (u, v) = (c * x - s * y, s * x + c * y) in Point u (d * v - t * z) (t * v + d * z)
  pure (moved turned (namedDescription solid), 3)
  where
    part = (/ 7) . fromInteger <$> choose (1, 6)

roundTo :: Int -> Point -> Point
roundTo digits (Point x y z) = Point (near x) (near y) (near z)
  where
    near v = fromInteger (round (v * 10 ^ digits)) / 10 ^ digits

-- | A cube with a vertex in the middle of C1 C2, and its left face in two.
halved :: Description
halved =
  cube'
    { describedVertices =
        describedVertices cube'
          ++ [("M", Point 0 (127 / 2) 127), ("N", Point 0 (127 / 2) 0)],
      describedFaces = concatMap other (describedFaces cube')
    }
  where
    cube' = namedDescription Cube
    other face = case faceText face of
      "C1 C5 C6 C2" -> map readFaceName ["C1 C5 N M", "M N C6 C2"]
      "C1 C2 C3 C4" -> [readFaceName "C1 M C2 C3 C4"]
      "C6 C5 C8 C7" -> [readFaceName "C6 N C5 C8 C7"]
      _ -> [face]
