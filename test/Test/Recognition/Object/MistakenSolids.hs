{-# LANGUAGE OverloadedStrings #-}

-- | Descriptions of solids with mistakes.
module Test.Recognition.Object.MistakenSolids
  ( mutations,
    tetrahedron,
    together,
    reversing,
    turn,
  )
where

import Data.List (nub)
import PraTactile.Object.PaperObjects
import PraTactile.Object.WingedEdge

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

reversing :: [Int] -> Description -> Description
reversing which it_ = it_ {describedFaces = zipWith reversed [0 ..] (describedFaces it_)}
  where
    reversed k face = if k `elem` which then FaceName (reverse (faceVertices face)) else face

turn :: Int -> FaceName -> FaceName
turn by (FaceName walk) = FaceName (take (length walk) (drop (by `mod` length walk) (cycle walk)))

-- | The smallest example of each kind of mistake, with the defect that is reported.
mutations :: [(String, Description, Defect)]
mutations =
  [ ("no faces", cubeDescription {describedFaces = []}, Defect NoFaces [] [] Nothing),
    ( "a vertex's name used twice",
      withVertex ("C1", Point 1 2 3),
      Defect RepeatedName [] ["C1"] Nothing
    ),
    ( "two vertices at one point",
      withVertex ("C9", Point 0 127 127),
      Defect CoincidentVertices [] ["C1", "C9"] Nothing
    ),
    ("a vertex on no face", withVertex ("C9", Point 1 2 3), Defect UnusedVertex [] ["C9"] Nothing),
    ( "a face with an unknown vertex",
      withFace "C1 C2 C9",
      Defect UnknownVertex [readFaceName "C1 C2 C9"] ["C9"] Nothing
    ),
    ( "a face of two vertices",
      withFace "C1 C2",
      Defect TooFewVertices [readFaceName "C1 C2"] [] Nothing
    ),
    ( "a face that visits a vertex twice",
      withFace "C1 C2 C3 C2",
      Defect VertexTwiceOnFace [readFaceName "C1 C2 C3 C2"] ["C2"] Nothing
    ),
    ( "a face given twice",
      withFace "C3 C4 C1 C2",
      Defect RepeatedFace (map readFaceName ["C1 C2 C3 C4", "C3 C4 C1 C2"]) [] Nothing
    ),
    ( "a face whose vertices lie on a line",
      flattened,
      Defect NoArea [FaceName ["A", "C", "B"]] [] Nothing
    ),
    ( "a face that is not flat: its normal is along (1, -1, 254), its mean at (63.5, 63.5, 127.25)",
      moved "C1" (Point 0 127 128),
      Defect NotPlanar [readFaceName "C1 C2 C3 C4"] [] (Just (63.5 / sqrt 64518))
    ),
    ( "a face that crosses itself, at (4/3, 4/3)",
      Description
        "bow"
        [("A", Point 0 0 0), ("B", Point 4 4 0), ("C", Point 4 0 0), ("D", Point 0 2 0)]
        [readFaceName "A B C D"],
      Defect FaceCrossesItself [readFaceName "A B C D"] ["A", "B", "C", "D"] Nothing
    ),
    ( "a face missing",
      cubeDescription {describedFaces = drop 1 (describedFaces cubeDescription)},
      Defect EdgeWithoutTwoFaces [readFaceName "C1 C2 C3 C4"] ["C2", "C3"] Nothing
    ),
    ( "three faces at an edge",
      withFace "C1 C2 C7 C8",
      Defect
        EdgeWithoutTwoFaces
        (map readFaceName ["C1 C2 C3 C4", "C1 C5 C6 C2", "C1 C2 C7 C8"])
        ["C1", "C2"]
        Nothing
    ),
    ( "a vertex of one face on a side of another",
      (withVertex ("C9", Point 50 0 127))
        { describedFaces = readFaceName "C2 C6 C7 C3 C9" : drop 1 (describedFaces cubeDescription)
        },
      Defect VertexOnEdge [] ["C9", "C2", "C3"] Nothing
    ),
    ( "a face clockwise seen from outside",
      reversing [3] cubeDescription,
      Defect FacesDisagree (map readFaceName ["C4 C8 C5 C1", "C4 C3 C2 C1"]) ["C1", "C4"] Nothing
    ),
    ( "two solids that share a vertex",
      tetrahedron ["A", "B", "C", "D"] (Point 0 0 0)
        `together` tetrahedron ["E", "F", "G", "A"] (Point 0 0 (-1)),
      Defect PinchedVertex [] ["A"] Nothing
    ),
    ( "all faces clockwise",
      reversing [0 .. 5] cubeDescription,
      Defect InsideOut [readFaceName "C3 C7 C6 C2"] [] Nothing
    ),
    ( "a solid within another, facing outward like that one",
      cubeDescription `together` tetrahedron ["A", "B", "C", "D"] (Point 60 60 60),
      Defect InsideOut [FaceName ["A", "C", "B"]] [] Nothing
    ),
    ( "a solid that touches another with one vertex, which it does not share",
      cubeDescription
        `together` (tetrahedron ["A", "B", "C", "D"] (Point 60 60 127))
          { describedVertices =
              [ ("A", Point 60 60 127),
                ("B", Point 61 60 128),
                ("C", Point 60 61 128),
                ("D", Point 60 60 128)
              ]
          },
      Defect FacesIntersect [readFaceName "C1 C2 C3 C4", FaceName ["A", "C", "B"]] [] (Just 0)
    ),
    ( "a needle of 3 by 4 mm through a face: its face at the front cuts it over 3 mm",
      cubeDescription `together` needle,
      Defect FacesIntersect (map readFaceName ["C1 C2 C3 C4", "N2 N6 N7 N3"]) [] (Just 3)
    )
  ]
  where
    needle =
      let it_ = box "needle" 'N' (Point 3 4 100) boxFaces
       in it_
            { describedVertices =
                [(v, Point (x + 60) (y + 60) (z + 100)) | (v, Point x y z) <- describedVertices it_]
            }
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
    flattened =
      (tetrahedron ["A", "B", "C", "D"] (Point 0 0 0))
        { describedVertices =
            [("A", Point 0 0 0), ("B", Point 1 0 0), ("C", Point 2 0 0), ("D", Point 0 0 1)]
        }
