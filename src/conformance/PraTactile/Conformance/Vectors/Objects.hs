{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The inputs of test vectors about objects.
module PraTactile.Conformance.Vectors.Objects
  ( solidGroups,
    cellsGroups,
    whereaboutsGroups,
    poseGroups,
    square,
    mapped,
  )
where

import Data.List (nub)
import PraTactile.Array (Position (..), Shape (..), shapeCells)
import PraTactile.Conformance.Definition.Objects (rotations)
import PraTactile.Conformance.Laws.Solids
import PraTactile.Conformance.Operation (Group (..), Inputs (..))
import PraTactile.Conformance.Question
import PraTactile.Format.Placement (Drawing (..))
import PraTactile.Object.Description hiding (rotations)
import PraTactile.Object.Named
import PraTactile.Object.Placement (Face (..))
import PraTactile.Pose (RigidMotion (..))

solidGroups :: [Group Description]
solidGroups =
  [ Group "Solids by name." (Chosen valid),
    Group "A box with something wrong." (Chosen wrong)
  ]

cellsGroups :: [Group ([Point], (Rational, Rational))]
cellsGroups =
  [ Group
      "The faces of the solids, from the first of their vertices and from the second."
      ( Chosen
          [ (placesOf it from, (127 / 5, 127 / 4))
            | it <- valid,
              FaceName walk <- describedFaces it,
              length walk <= 12,
              from <- take 2 (rotations walk)
          ]
      ),
    Group
      "What is no face, and what leaves no room."
      ( Chosen
          [ ([], (1, 1)),
            (take 2 square, (1, 1)),
            (map (square !!) [0, 2, 1, 3], (1, 1)),
            (square ++ [Point 5 5 1], (1, 1)),
            (map (square !!) [0, 0, 1, 2, 3], (1, 1)),
            (square, (0, 1)),
            (square, (1, -1)),
            (square, (11, 1)),
            (square, (10, 10)),
            (square, (1 / 3, 7))
          ]
      )
  ]

whereaboutsGroups :: [Group (Mapped, Shape, Position)]
whereaboutsGroups =
  [ Group
      "Every other position of a small array, and beyond."
      ( Chosen
          [ (mapped, Shape 2 2, at)
            | at@(Position r c) <-
                shapeCells (mappedShape mapped) ++ [Position 7 9, Position 20 2],
              even (r + c)
          ]
      ),
    Group
      "Other windows."
      ( Chosen
          [ (mapped, window, at)
            | window <- [Shape 1 1, Shape 3 1, Shape 7 9, Shape 8 10],
              at <- [Position 1 1, Position 4 6]
          ]
      ),
    Group
      "What cannot be laid."
      (Chosen [(other, Shape 1 1, Position 0 0) | other <- impossible])
  ]

poseGroups :: [Group Felt]
poseGroups =
  [ Group "A face felt where it is, turned, with errors, and in a world." (Chosen felt),
    Group
      "What does not tell a pose."
      ( Chosen
          [ Felt corners seen 1 Nothing
            | (corners, seen) <-
                [ (square, []),
                  (square, [((1, 1), (2, 2))]),
                  (square, [((1, 1), (2, 2)), ((1, 1), (3, 2))]),
                  (take 2 square, [((0, 0), (1, 1)), ((1, 0), (2, 1))])
                ]
          ]
      )
  ]

square :: [Point]
square = [Point 0 0 0, Point 0 10 0, Point 10 10 0, Point 10 0 0]

placesOf :: Description -> [VertexName] -> [Point]
placesOf it walk = [p | v <- walk, (w, p) <- describedVertices it, v == w]

-- | Valid solids of every name.
valid :: [Description]
valid =
  map namedDescription $
    [Cube, Parallelepiped, Box 10 20 (1 / 3), Pyramid 200 100 150, Prism 3 80 50, Prism 7 150 40]
      ++ [Tetrahedron 200, Octahedron 200, Pyritohedron 100, LShape 200 100 200, Frame 300 250 90]
      ++ [Sheet 100 50]

-- | A box with each kind of defect, and with several defects.
wrong :: [Description]
wrong =
  [ it {describedFaces = []},
    it {describedVertices = drop 1 vertices},
    it {describedVertices = vertices ++ [("B9", Point 1 2 3)]},
    it {describedVertices = vertices ++ [("B8", Point 1 2 3)]},
    it {describedVertices = vertices ++ [("B9", Point 0 0 0)]},
    it {describedFaces = drop 1 faces},
    it {describedFaces = take 1 faces ++ faces},
    it {describedFaces = faces ++ [FaceName ["B1", "B2"]]},
    it {describedFaces = faces ++ [FaceName ["B1", "B2", "B1", "B3"]]},
    changed (take 2),
    changed reverse,
    changed (\walk -> map (walk !!) [0, 2, 1, 3]),
    it {describedVertices = [(v, if v == "B1" then up p else p) | (v, p) <- vertices]},
    reversed it,
    both it (reversed inner),
    both it inner,
    both it (labelled "o." (moved (\(Point x y z) -> Point (x + 5) (y + 5) (z + 5)) it)),
    both it (labelled "o." (moved (\(Point x y z) -> Point (x + 10) y z) it)),
    it
      { describedVertices = vertices ++ [("M", Point 5 0 0)],
        describedFaces = faces ++ [FaceName ["B6", "M", "B7"]]
      }
  ]
  where
    it = namedDescription (Box 10 20 30)
    vertices = describedVertices it
    faces = describedFaces it
    inner = labelled "i." (moved (\(Point x y z) -> Point (2 + x / 5) (2 + y / 5) (2 + z / 5)) it)
    up (Point x y z) = Point x y (z + 1 / 2)
    changed f =
      it
        { describedFaces =
            map (\(FaceName w) -> FaceName (f w)) (take 1 faces)
              ++ drop
                1
                faces
        }

-- | Three objects on an array of 7 x 9: a box, a tetrahedron of which a face takes some cells, and
-- one with its own margin.
mapped :: Mapped
mapped =
  Mapped
    { mappedShape = Shape 7 9,
      mappedPitch = (127 / 5, 127 / 4),
      mappedObjects = [named "box" (Box 80 60 70), named "spike" (Tetrahedron 150)],
      mappedLayings =
        [ Drawing (faceOf "box" 0) 0 0 Nothing ["###", "###"],
          Drawing (faceOf "box" 1) 0 3 (Just (4, 3)) ["##", "##"],
          Drawing (faceOf "box" 3) 2 (-1) Nothing [".##"],
          Drawing
            (faceOf "spike" 1)
            2
            1
            Nothing
            [".######.", "..####..", "...##...", "...##...", "........"],
          Drawing (faceOf "spike" 0) 0 6 (Just (70, 5)) ["##", "#."]
        ]
    }
  where
    named name shape = (namedDescription shape) {describedName = name}
    faceOf name k =
      Face
        name
        (head [describedFaces it !! k | it <- mappedObjects mapped, describedName it == name])

impossible :: [Mapped]
impossible = [mapped {mappedPitch = (1, 0)}, mapped {mappedShape = Shape 1 9}]

-- | A face of 10 x 10 mm with felt points.
felt :: [Felt]
felt =
  [ Felt corners seen sd world
    | (corners, k) <- [(level, 1), (tilted, 1), (tilted, -1)],
      seen <- nub [exact k, map (fmap bent) (exact k)],
      (sd, world) <- [(1 / 4, Nothing), (2, Just upright)]
  ]
  where
    level = [Point 0 10 0, Point 0 0 0, Point 10 0 0, Point 10 10 0]
    tilted = [Point 1 2 3, Point 9 6 (-1), Point 13 (-1) 0, Point 5 (-5) 4]
    exact k =
      [ ((x, y), (100 + 0.6 * x - 0.8 * k * y, -50 + 0.8 * k * x + 0.6 * y))
        | (x, y) <- [(0, 0), (8, 0), (8, 6), (1, 7)]
      ]
    bent (x, y) = (x + y / 1024, y - x / 512)
    upright = RigidMotion [[0, 0, 1], [1, 0, 0], [0, 1, 0]] [10, 20, 30]
