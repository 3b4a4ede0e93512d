{-# LANGUAGE OverloadedStrings #-}

-- | Tests the merging of triangles into the faces they came from, and the moving of vertices so
-- that faces are flat.
module Test.Solid.MergedAndSettled (spec) where

import Data.List (nub, sort, unfoldr, (\\))
import Data.Maybe (fromMaybe, mapMaybe)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Conformance.Laws.Solids
import PraTactile.Object.Description
import PraTactile.Object.Mend
import PraTactile.Object.Merge
import PraTactile.Object.Mesh
import PraTactile.Object.Named
import PraTactile.Object.Orientation
import PraTactile.Object.Rims
import PraTactile.Object.Sliver
import PraTactile.Object.Tolerance
import PraTactile.Object.Triangles
import PraTactile.Object.Validity
import PraTactile.Object.Vector (plus, zero)
import System.Random (mkStdGen, uniformR)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck
import Test.Solid.Drilled

spec :: Spec
spec = do
  describe "coplanar faces" $ do
    prop "cut into triangles are merged into the solid's own faces, if none has a hole" $
      forAll (elements whole) $ \solid ->
        let it_ = fromDescription (namedDescription solid)
         in faces (mergeCoplanar (cut it_)) === faces it_
    prop "cut into triangles and merged, form a valid solid of the same volume" $
      forAllBlind solids $ \drawn ->
        let it_ = fromDescription drawn
         in map volumes [cut it_, mergeCoplanar (cut it_)] === [volumes it_, volumes it_]
              .&&. map (reportValid . examine) [cut it_, mergeCoplanar (cut it_)] === [True, True]
    prop "with holes, cut into triangles, are merged into the plate's own faces, rim by rim" $
      forAllBlind drilled $ \plate ->
        forAllBlind affine $ \way ->
          let it_ = fromDescription (moved way (plateOf plate))
              merged = mergeCoplanar (cut it_)
           in (rimsOf merged, reportDefects (examine merged)) === (rimsOf it_, [])
    it "of a frame's rings are merged into one face each" $
      V.length (meshWalks (mergeCoplanar (fromDescription (namedDescription (Frame 9 9 3)))))
        `shouldBe` 2 + 4 + 4
    it "with holes that touch at a vertex become polygons without holes there" $ do
      let it_ = fromDescription pitted
          merged = mergeCoplanar it_
      map (reportValid . examine) [it_, merged] `shouldBe` [True, True]
      map volumes [merged] `shouldBe` [volumes it_]
      [U.length walk | walk <- V.toList (meshWalks merged), not (null (repeated walk))]
        `shouldBe` []
    prop "with holes are cut into faces without holes, which are parts of one face and fill it" $
      forAllBlind drilled $ \plate ->
        let it_ = fromDescription (plateOf plate)
            areas mesh_ = map (doubleArea . cornersOf mesh_) (V.toList (meshWalks mesh_))
         in conjoin
              [ (reportDefects (examine parts), concatMap repeated (V.toList (meshWalks parts)))
                  === ([], [])
                  .&&. [ foldr plus zero [n | (g, n) <- zip owners (areas parts), g == f]
                         | f <- [0 .. V.length (meshWalks it_) - 1]
                       ]
                  === areas it_
                | (owners, parts) <- withoutHoles it_
              ]
    it "are flat: two saddles with a common side, first corner and area vector stay two" $ do
      let saddles =
            fromDescription . Description "saddles" corners $
              map FaceName [["A", "B", "C", "D"], ["C", "B", "E", "F"]]
          corners =
            [ ("A", Point 0 0 0),
              ("B", Point 1 0 1),
              ("C", Point 1 1 0),
              ("D", Point 0 1 1),
              ("E", Point 2 0 0),
              ("F", Point 2 1 1)
            ]
      faces (mergeCoplanar saddles) `shouldBe` faces saddles
    it "lose a vertex in the middle of an edge, and begin at the first vertex" $
      faces (mergeCoplanar (fromDescription halved))
        `shouldBe` faces
          (fromDescription (namedDescription Cube))
  describe "a tolerance" $ do
    prop "makes solids that were rounded to thousandths flat again, moving less than it allows" $
      forAllBlind flatter $ \(drawn, digits) ->
        let rounded = fromDescription (moved (roundTo digits) drawn)
         in counterexample (show drawn) $
              case settled 0.01 False rounded of
                Left why -> counterexample (show why) False
                Right (Settled flat _ most _) -> (most <= 0.01) .&&. map defects [flat] === [[]]
    it "leaves a cube unchanged" $ do
      let it_ = fromDescription (namedDescription Cube)
      fmap
        (\(Settled same count most left) -> (same, count, most, left))
        (settled 0.5 True it_)
        `shouldBe` Right (it_, 0, 0, 0)
    it "joins vertices up to its distance, and no others" $ do
      let it_ = fromDescription (namedDescription (Box 100 100 0.5))
          left mm = V.length . meshPoints . settledMesh <$> settled mm False it_
      map left [0.5, 0.499] `shouldBe` [Right 4, Right 8]
    it "refuses coordinates of more than 2^28 binary digits, states it, and moves nothing" $ do
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
    it "is suggested where one suffices" $
      forAllMoved $ \off ->
        fromMaybe 0 (sufficient (fromDescription off)) `shouldSatisfy` (\mm -> mm > 0 && mm < 1)
  modifyMaxSuccess (const 25) . describe "triangles without area" $ do
    prop "beside any edges, halved repeatedly, are removed, and the solid is unchanged" $
      forAllBlind solids $ \drawn ->
        forAll (listOf (choose (0, 1000))) $ \places ->
          let it_ = cut (fromDescription drawn)
              spoilt' = foldl (split (Point 0 0 0)) it_ places
           in either
                (\why -> counterexample (show why) False)
                ( \(Settled made _ most left) ->
                    (left, most) === (length places, 0)
                      .&&. V.length (meshWalks made) === V.length (meshWalks it_) + length places
                      .&&. (reportValid (examine made), volumes made) === (True, volumes it_)
                )
                (settled 1e-6 False spoilt')
    prop "with a small area are removed, and their vertex is moved to the line" $
      forAll (elements [Cube, Box 100 60 40, Prism 5 60 20, LShape 100 50 80]) $ \solid ->
        forAll ((,) <$> choose (0, 1000) <*> vectorOf 3 (choose (-9, 9 :: Integer))) $
          \(place, off) ->
            let it_ = cut (fromDescription (namedDescription solid))
                little = [fromInteger n / 10 ^ (6 :: Int) | n <- off]
                spoilt' = case little of
                  [x, y, z] -> split (Point x y z) it_ place
                  _ -> it_
             in either
                  (\why -> counterexample (show why) False)
                  (\made -> faces (mergeCoplanar (settledMesh made)) === faces (mergeCoplanar it_))
                  (settled 0.001 True spoilt')
    it "leave a walk without the steps that it takes back at once" $
      [ if length kept < 3 then [] else kept
        | kept <-
            map tidied [[1, 2, 3], [1, 2, 1], [1, 2, 3, 2], [1, 2, 2, 3, 4, 3], [1, 1, 2, 3, 1], []]
      ]
        `shouldBe` [[1, 2, 3], [], [], [1, 2, 3], [1, 2, 3], []]
  modifyMaxSuccess (const 25) . describe "reversed faces" $ do
    prop "are all found and turned back, also in solids within hollows" $
      forAllBlind solids $ \drawn ->
        forAll (infiniteListOf arbitrary) $ \which ->
          let it_ = fromDescription drawn
              wrong = [f | (f, True) <- zip [0 .. V.length (meshWalks it_) - 1] which]
              (back, found) = oriented (turnedAt wrong it_)
           in (found, faces back) === (wrong, faces it_)
    it "a hollow is inward" $ do
      let inner = labelled "inner" (moved (shifted 3) (namedDescription (Box 3 3 3)))
          (right, found) = oriented (fromDescription (both (namedDescription (Box 9 9 9)) inner))
      (found, reportValid (examine right)) `shouldBe` ([6 .. 11], True)
    it "a one-sided surface is unchanged; one with a rim has the fewer faces turned" $ do
      let strip walks =
            fromDescription
              ( Description
                  "strip"
                  [ (VertexName (show v), Point (fromInteger v) (fromInteger (v * v)) 0)
                    | v <- [0 .. 4 :: Integer]
                  ]
                  (map readFaceName walks)
              )
          moebius = strip ["0 1 2", "1 3 2", "2 3 4", "3 0 4", "4 0 1"]
          rim = strip ["0 1 2", "1 2 3", "2 3 4"]
      oriented moebius `shouldBe` (moebius, [])
      oriented rim `shouldBe` (strip ["0 1 2", "1 3 2", "2 3 4"], [1])
  modifyMaxSuccess (const 25) . describe "the advice" $ do
    let advice it_ = wouldMend asItIs it_ (examine it_)
        followed it_ how =
          either (const False) (reportValid . examine . mendedMesh) (mended how it_)
    prop "for separate triangles with small errors is a tolerance, which mends the solid" $
      forAllBlind (elements [Cube, Box 100 60 40, LShape 100 50 80]) $ \solid ->
        forAllBlind (infiniteListOf (choose (-9, 9 :: Integer))) $ \noise ->
          let it_ = scattered noise (cut (fromDescription (namedDescription solid)))
           in case advice it_ of
                Just how ->
                  (mendOrientation how, followed it_ how) === (False, True)
                    .&&. (mendTolerance how `elem` [Just 1e-6, Just 1e-5, Just 1e-4]) === True
                Nothing -> counterexample "no advice" False
    it "for reversed faces, alone or with small errors, is to turn them" $ do
      let box = cut (fromDescription (namedDescription (Box 100 60 40)))
          turned = turnedAt [1, 4] box
          apart = scattered (cycle [3, -2, 5, 0, 7]) turned
      advice turned `shouldBe` Just asItIs {mendOrientation = True}
      fmap mendOrientation (advice apart) `shouldBe` Just True
      map (\it_ -> fmap (followed it_) (advice it_)) [turned, apart]
        `shouldBe` [Just True, Just True]
    it "is Nothing if a face is missing or nothing is wrong" $ do
      let box = fromDescription (namedDescription (Box 100 60 40))
          described = toDescription box
          open = fromDescription described {describedFaces = drop 1 (describedFaces described)}
      map advice [box, open] `shouldBe` [Nothing, Nothing]
  where
    shifted by (Point x y z) = Point (by + x) (by + y) (by + z)
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

-- | The vertices that a walk visits more than once.
repeated :: U.Vector Int -> [Int]
repeated walk = let visited = U.toList walk in visited \\ nub visited

-- | The faces by the rims of each, those by their vertices' places from the least.
rimsOf :: Mesh -> [[[Point]]]
rimsOf it_ =
  sort
    [ sort (map (minimum . rotations . map (pointAt it_)) (rims (U.toList walk)))
      | walk <- V.toList (meshWalks it_)
    ]

-- | A block with two pits in its upper face, each an inverted pyramid, that share one vertex. That
-- face is made of unit squares.
pitted :: Description
pitted =
  Description
    "block"
    [(name at, Point x y z) | at@(x, y, z) <- nub (concat walks)]
    (map (FaceName . map name) walks)
  where
    name (x, y, z) = VertexName (show (map fromRational [x, y, z] :: [Double]))
    pits = [(1, 1), (2, 2)]
    above (i, j) = [(i, j, 1), (i + 1, j, 1), (i + 1, j + 1, 1), (i, j + 1, 1)] :: [Corner]
    walks =
      [above (i, j) | i <- [0 .. 3], j <- [0 .. 3], (i, j) `notElem` pits]
        ++ [ [p, q, (i + 1 / 2, j + 1 / 2, 1 / 2)]
             | (i, j) <- pits,
               (p, q) <- cyclicPairs (above (i, j))
           ]
        ++ [ reverse upper ++ [below (take 1 upper), below (drop 4 upper)]
             | upper <-
                 [ [(x, 0, 1) | x <- [0 .. 4]],
                   [(4, y, 1) | y <- [0 .. 4]],
                   [(4 - x, 4, 1) | x <- [0 .. 4]],
                   [(0, 4 - y, 1) | y <- [0 .. 4]]
                 ]
           ]
        ++ [[(0, 0, 0), (0, 4, 0), (4, 4, 0), (4, 0, 0)]]
    below corners = case corners of
      (x, y, _) : _ -> (x, y, 0)
      [] -> (0, 0, 0)

type Corner = (Rational, Rational, Rational)

-- | The faces by their vertices' places, each from its least.
faces :: Mesh -> [[Point]]
faces it_ =
  sort [least (map (pointAt it_) (U.toList walk)) | walk <- V.toList (meshWalks it_)]
  where
    least = minimum . rotations

-- | The mesh with some faces reversed.
turnedAt :: [Int] -> Mesh -> Mesh
turnedAt which it_ =
  withShape
    (meshNames it_)
    (meshDenominator it_)
    (meshPoints it_)
    (V.imap (\f walk -> if f `elem` which then U.reverse walk else walk) (meshWalks it_))
    it_

-- | Triangles, of which one is halved by a vertex in the middle of its first side, moved by this
-- vector. A triangle of that vertex and the side's ends, of nearly no area, lies between the halves
-- and the face across the side, as exporters leave it.
split :: Point -> Mesh -> Int -> Mesh
split (Point dx dy dz) it_ place =
  fromDescription
    described
      { describedVertices = describedVertices described ++ [(middle, halfway)],
        describedFaces = concat (zipWith other [0 ..] (describedFaces described))
      }
  where
    described = toDescription it_
    middle = VertexName ("M" ++ show (length (describedVertices described)))
    -- A triangle that has an area.
    chosen = wide !! (place `mod` length wide)
    wide =
      [ f
        | (f, walk) <- zip [0 ..] (V.toList (meshWalks it_)),
          doubleArea (cornersOf it_ walk) /= zero
      ]
    halfway = case describedFaces described !! chosen of
      FaceName (a : b : _)
        | [Point x y z, Point x' y' z'] <- mapMaybe (`lookup` describedVertices described) [a, b] ->
          Point ((x + x') / 2 + dx) ((y + y') / 2 + dy) ((z + z') / 2 + dz)
      _ -> Point 0 0 0
    other f (FaceName walk) = case walk of
      [a, b, c] | f == chosen -> map FaceName [[a, middle, c], [middle, b, c], [a, b, middle]]
      _ -> [FaceName walk]

-- | The mesh whose faces have their own vertices, each a few millionths from its place.
scattered :: [Integer] -> Mesh -> Mesh
scattered noise it_ =
  fromDescription
    ( Description
        (meshName it_)
        [ (VertexName (show i), Point (x + far a) (y + far b) (z + far c))
          | (i, Point x y z, (a, b, c)) <- zip3 [0 :: Int ..] corners (triples noise)
        ]
        [ FaceName (map (VertexName . show) [3 * f .. 3 * f + 2])
          | f <- [0 .. length corners `div` 3 - 1]
        ]
    )
  where
    corners = [pointAt it_ v | walk <- V.toList (meshWalks it_), v <- U.toList walk]
    far n = fromInteger n / 10 ^ (6 :: Int)
    triples list = case list of
      a : b : c : others -> (a, b, c) : triples others
      _ -> []

-- | The mesh with every face cut into triangles.
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

-- | Solids with at most three faces of more than three corners at a vertex, turned, and the number
-- of digits to keep.
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
