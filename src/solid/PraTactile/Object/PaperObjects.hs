{-# LANGUAGE OverloadedStrings #-}

-- | The paper's two objects: a cube of 127 mm (5 in) and a parallelepiped of 177.8 x 101.6 x 95.25
-- mm (7 x 4 x 3 3/4 in) (section IV). Figure 6, which numbers their vertices, is lost; the
-- numbering is the canonical profile's.
module PraTactile.Object.PaperObjects
  ( cube,
    cubeDescription,
    parallelepiped,
    parallelepipedDescription,

    -- * Boxes
    box,
    boxFaces,
  )
where

import PraTactile.Object.WingedEdge

-- | The cube C1 ... C8, 127 mm a side. C1 C2 C3 C4 is the top face, with C1 far left and C2 near
-- left; C5 ... C8 lie below C1 ... C4. It is always 'Right', because its description is a valid
-- polyhedron.
--
-- >      C1 ---------- C4
-- >     / |           / |
-- >   C2 ---------- C3  |
-- >    |  |          |  |
-- >    | C5 -------- | C8
-- >    | /           | /
-- >   C6 ---------- C7
cube :: Either Defect Solid
cube = solid cubeDescription

-- | The description of 'cube'.
cubeDescription :: Description
cubeDescription =
  box
    "cube"
    'C'
    (Point 127 127 127)
    boxFaces

-- | The parallelepiped P1 ... P8, numbered as the cube is: 177.8 mm along P2 P3, 101.6 mm along P1
-- P2, 95.25 mm tall. It is always 'Right'.
parallelepiped :: Either Defect Solid
parallelepiped = solid parallelepipedDescription

-- | The description of 'parallelepiped'.
parallelepipedDescription :: Description
parallelepipedDescription =
  box
    "parallelepiped"
    'P'
    (Point 177.8 101.6 95.25)
    ["1 2 3 4", "6 5 8 7", "2 6 7 3", "4 8 5 1", "3 7 8 4", "1 5 6 2"]

-- | The faces of a box, in the cube's order.
boxFaces :: [String]
boxFaces = ["2 6 7 3", "3 7 8 4", "4 8 5 1", "1 2 3 4", "1 5 6 2", "6 5 8 7"]

-- | The description of a box. Arguments: its name; the first letter of its vertices; its extents in
-- millimetres; its faces by the numbers of their vertices, from the upper left one,
-- counter-clockwise as seen from outside. Vertices 1 to 4 are the top as seen from above: far left,
-- near left, near right, far right; 5 to 8 lie below them. The near left bottom vertex is the
-- origin.
box :: ObjectName -> Char -> Point -> [String] -> Description
box named letter (Point across deep tall) numbered =
  Description
    { describedName = named,
      describedVertices =
        [ (VertexName (letter : number), Point x y z)
          | (number, (x, y, z)) <-
              zip
                (map show [1 :: Int ..])
                [ (x, y, z)
                  | z <- [tall, 0],
                    (x, y) <- [(0, deep), (0, 0), (across, 0), (across, deep)]
                ]
        ],
      describedFaces = [FaceName (map (VertexName . (letter :)) (words face)) | face <- numbered]
    }
