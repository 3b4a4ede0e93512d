{-# LANGUAGE OverloadedStrings #-}

-- | Descriptions of solids, and mistakes in them.
module Test.Recognition.Object.MistakenSolids
  ( mutations,
    cubeDescription,
    tetrahedron,
    together,
    handle,
    reversing,
    turn,
  )
where

import Data.List (nub)
import PraTactile.Object.Solid
import PraTactile.Object.WingedEdge

cubeDescription :: Description
cubeDescription =
  box
    "cube"
    'C'
    (Point 127 127 127)
    ["2 6 7 3", "3 7 8 4", "4 8 5 1", "1 2 3 4", "1 5 6 2", "6 5 8 7"]

tetrahedron :: [VertexName] -> Point -> Description
tetrahedron names (Point x y z) =
  Description
    "tetrahedron"
    (zip names [Point x y z, Point (x + 1) y z, Point x (y + 1) z, Point x y (z + 1)])
    [FaceName [names !! i | i <- face] | face <- [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]]

together :: Description -> Description -> Description
together a b =
  Description
    (describedName a)
    (nub (describedVertices a ++ describedVertices b))
    (describedFaces a ++ describedFaces b)

-- Nine quadrilaterals on a torus of 3 x 3 vertices, nowhere flat: its only topological fault is its
-- handle.
handle :: Description
handle =
  Description
    "handle"
    [ (named i j, Point (fromIntegral i) (fromIntegral j) (fromIntegral (i * j)))
      | i <- [0 .. 2],
        j <- [0 .. 2]
    ]
    [ FaceName [named i j, named (i + 1) j, named (i + 1) (j + 1), named i (j + 1)]
      | i <- [0 .. 2],
        j <- [0 .. 2]
    ]
  where
    named :: Int -> Int -> VertexName
    named i j = VertexName (show (i `mod` 3) ++ show (j `mod` 3))

reversing :: [Int] -> Description -> Description
reversing which it_ = it_ {describedFaces = zipWith reversed [0 ..] (describedFaces it_)}
  where
    reversed k face = if k `elem` which then FaceName (reverse (faceVertices face)) else face

turn :: Int -> FaceName -> FaceName
turn by (FaceName walk) = FaceName (take (length walk) (drop (by `mod` length walk) (cycle walk)))

mutations :: [(String, Description, ObjectError)]
mutations =
  [ ("no faces", cubeDescription {describedFaces = []}, NoFaces),
    ("a vertex's name used twice", withVertex ("C1", Point 1 2 3), RepeatedVertex "C1"),
    ("two vertices at one point", withVertex ("C9", Point 0 127 127), CoincidentVertices "C1" "C9"),
    ("a face of two vertices", withFace "C1 C2", TooFewVertices (readFaceName "C1 C2")),
    ( "a face with a vertex there is not",
      withFace "C1 C2 C9",
      UnknownVertex (readFaceName "C1 C2 C9") "C9"
    ),
    ( "a face that visits a vertex twice",
      withFace "C1 C2 C3 C2",
      VertexTwiceOnFace (readFaceName "C1 C2 C3 C2") "C2"
    ),
    ( "a face given twice",
      withFace "C3 C4 C1 C2",
      RepeatedFace (readFaceName "C1 C2 C3 C4") (readFaceName "C3 C4 C1 C2")
    ),
    ("a vertex on no face", withVertex ("C9", Point 1 2 3), UnusedVertex "C9"),
    ( "a face missing",
      cubeDescription {describedFaces = drop 1 (describedFaces cubeDescription)},
      EdgeWithoutTwoFaces "C2" "C3" [readFaceName "C1 C2 C3 C4"]
    ),
    ( "three faces at an edge",
      withFace "C1 C2 C7 C8",
      EdgeWithoutTwoFaces "C1" "C2" (map readFaceName ["C1 C2 C3 C4", "C1 C5 C6 C2", "C1 C2 C7 C8"])
    ),
    ( "a face clockwise seen from outside",
      reversing [3] cubeDescription,
      FacesDisagree "C1" "C4" (readFaceName "C4 C8 C5 C1") (readFaceName "C4 C3 C2 C1")
    ),
    ( "two solids that share a vertex",
      tetrahedron ["A", "B", "C", "D"] (Point 0 0 0)
        `together` tetrahedron ["E", "F", "G", "A"] (Point 0 0 (-1)),
      PinchedVertex "A"
    ),
    ( "two solids apart",
      tetrahedron ["A", "B", "C", "D"] (Point 0 0 0)
        `together` tetrahedron ["E", "F", "G", "H"] (Point 5 5 5),
      NotConnected (FaceName ["A", "C", "B"]) (FaceName ["E", "G", "F"])
    ),
    ("a handle", handle, EulerFails 9 18 9),
    ( "a face whose vertices lie on a line",
      flattened,
      NoArea (FaceName ["A", "C", "B"])
    ),
    ( "a face that is not flat",
      moved "C1" (Point 0 127 128),
      NotPlanar (readFaceName "C1 C2 C3 C4")
    ),
    ("all faces clockwise", reversing [0 .. 5] cubeDescription, NotOutward),
    ("all vertices in one plane, so that nothing is enclosed", inOnePlane, NotOutward)
  ]
  where
    withVertex new =
      cubeDescription {describedVertices = describedVertices cubeDescription ++ [new]}
    withFace new =
      cubeDescription {describedFaces = describedFaces cubeDescription ++ [readFaceName new]}
    moved which to =
      cubeDescription
        { describedVertices =
            [ (vertex, if vertex == which then to else at)
              | (vertex, at) <- describedVertices cubeDescription
            ]
        }
    inOnePlane =
      (tetrahedron ["A", "B", "C", "D"] (Point 0 0 0))
        { describedVertices =
            [("A", Point 0 0 1), ("B", Point 3 0 1), ("C", Point 0 3 1), ("D", Point 1 1 1)]
        }
    flattened =
      (tetrahedron ["A", "B", "C", "D"] (Point 0 0 0))
        { describedVertices =
            [("A", Point 0 0 0), ("B", Point 1 0 0), ("C", Point 2 0 0), ("D", Point 0 0 1)]
        }
