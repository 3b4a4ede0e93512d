{-# LANGUAGE GADTs #-}
{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The laws of objects: the defects of a polyhedron, the cells on a face, the whereabouts of a
-- window, and the pose from a felt face.
module PraTactile.Conformance.Laws.Objects
  ( objectLaws,
  )
where

import Data.Aeson (Value (..), object, toJSON, (.=))
import PraTactile.Array (Position (..), Shape (Shape))
import PraTactile.Conformance.Ask
import PraTactile.Conformance.Definition (agreesWithoutProfile, expectedWithoutProfile)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Faces
import PraTactile.Conformance.Laws.Judge
import PraTactile.Conformance.Laws.Lying
import PraTactile.Conformance.Laws.Malformed
import PraTactile.Conformance.Laws.Placements
import PraTactile.Conformance.Laws.Solids
import PraTactile.Conformance.Operations (smallerQuestions)
import PraTactile.Conformance.Question
import PraTactile.Object.Description
import PraTactile.Object.Named
import PraTactile.Object.Validity (Component (..), Report (..))
import PraTactile.Pose (Pose (..))
import Test.QuickCheck

-- | The laws of objects.
objectLaws :: [Law ()]
objectLaws = solidLaws ++ cellLaws ++ whereaboutsLaws ++ poseLaws

-- Polyhedra.

solidLaws :: [Law ()]
solidLaws =
  [ definedWithoutProfile
      OnObjects
      "solid-as-defined"
      SolidReport
      "the report on a polyhedron has exactly its defects, each with its faces, vertices and \
      \measure, and the figures of its pieces that have a meaning"
      "the definitions of the defects; Euler and Poincare; the divergence theorem"
      "each kind of defect is looked for where no other leaves it without meaning"
      (Some (SomeQuestion . (SolidReport :?) <$> polyhedra) smallerQuestions),
    law
      OnObjects
      "solid-of-known-measures"
      [SomeOp SolidReport]
      "solids with many sides, with many handles, nested, or with very large and fine coordinates \
      \have the pieces and volumes with which they were made"
      "how they were made"
      $ \() ->
        Cases questionForm (Every (map (SomeQuestion . (SolidReport :?) . fst) measured)) measure,
    invalid OnObjects "solid-refuses-what-is-invalid" SolidReport (const badSolids)
  ]
  where
    polyhedra = frequency [(1, solids), (4, eachKind >>= \kind -> solids >>= spoilt kind)]
    -- Sizes grow by one from case to case, so every kind occurs.
    eachKind = sized (\size -> pure (cycle [minBound ..] !! size))
    measure :: SomeQuestion -> Ask Verdict
    measure (SomeQuestion question) = case question of
      SolidReport :? it
        | Just wanted <- lookup it measured ->
          judge question (Right wanted) (agreesWithoutProfile question wanted) road why
            <$> ask question
      _ -> pure Inapplicable
    road = "the construction" :: String
    why = "a prism over the points (i, i^2), nested boxes, or a plate with holes" :: String
    badSolids =
      [rawWith plain "vertices" (vertex name (String "0")) | name <- ["", "a b", "a\t"]]
        ++ [rawWith plain "vertices" (vertex "A" number) | number <- notExact]
        ++ malformed plain
    plain = SolidReport :? Description "" [("A", Point 1 2 (1 / 3))] [FaceName ["A"]]
    vertex :: String -> Value -> Value
    vertex name number = toJSON [object ["name" .= name, "at" .= [number, String "0", String "0"]]]

-- | Texts that are not exact numbers.
notExact :: [Value]
notExact = map String ["", "1.5", "1e3", "+1", " 1", "1/0", "1/-2", "1/2/3", "/2", "0x1", "one"]

-- | Solids whose report is known from how they were made.
measured :: [(Description, Report)]
measured =
  [ ( grown k (prism m),
      Report
        (2 * m)
        (3 * m)
        (m + 2)
        [piece (2 * m, 3 * m, m + 2) (k ^ (3 :: Int) * volume m) 0]
        []
        []
    )
    | (m, k) <- [(3, 1), (5, 10 ^ (40 :: Int)), (5, 1 / 10 ^ (40 :: Int)), (100, 1), (260, 1)]
  ]
    ++ [ ( nested n,
           Report
             (8 * n)
             (12 * n)
             (6 * n)
             [piece (8, 12, 6) (sign i * side i ^ (3 :: Int)) i | i <- [0 .. n - 1]]
             []
             []
         )
         | n <- [2, 5]
       ]
    ++ [ let (v, f) = (length (describedVertices it), length (describedFaces it))
             e = v + f - 2 + 2 * holes
             size = fromIntegral (6 * (5 * holes + 3))
             alone = Component v e f (2 - 2 * holes) (Just holes) (Just size)
          in (it, Report v e f [alone (Just False) (Just 0)] [] [])
         | holes <- [2, 5],
           let it = plate holes
       ]
  where
    -- A plate of squares of 1 x 2 mm in three rows, 3 mm high; every other square of the middle row
    -- is a hole.
    plate :: Int -> Description
    plate holes =
      Description
        ""
        [ (corner level p, Point (fromIntegral x) (2 * fromIntegral y) z)
          | (level, z) <- [('a', 0), ('b', 3)],
            p@(x, y) <- (,) <$> [0 .. 2 * holes + 1] <*> [0 .. 3]
        ]
        ( [FaceName (map (corner 'b') s) | s <- squares]
            ++ [FaceName (map (corner 'a') (reverse s)) | s <- squares]
            ++ [ FaceName [corner 'b' q, corner 'b' p, corner 'a' p, corner 'a' q]
                 | (p, q) <- sides,
                   (q, p) `notElem` sides
               ]
        )
      where
        sides = concatMap cyclicPairs squares
        squares =
          [ [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)]
            | x <- [0 .. 2 * holes],
              y <- [0 .. 2],
              even x || y /= 1
          ]
    corner :: Char -> (Int, Int) -> VertexName
    corner level (x, y) = VertexName (level : show x ++ "." ++ show y)
    piece (v, e, f) size = Component v e f 2 (Just 0) (Just size) (Just True) . Just
    volume m = let n = fromIntegral m in 7 * n * (n - 1) * (n - 2) / 6
    prism :: Int -> Description
    prism m =
      Description
        ""
        [ (VertexName (level : show i), Point (fromIntegral i) (fromIntegral i ^ (2 :: Int)) z)
          | (level, z) <- [('a', 0), ('b', 7)],
            i <- [0 .. m - 1]
        ]
        ( FaceName (map (at 'b') [0 .. m - 1]) :
          FaceName (map (at 'a') (reverse [0 .. m - 1])) :
            [ FaceName [at 'a' i, at 'a' j, at 'b' j, at 'b' i]
              | (i, j) <- cyclicPairs [0 .. m - 1]
            ]
        )
    at level i = VertexName (level : show i)
    grown k = moved (\(Point x y z) -> Point (k * x + 9 * k) (k * y - 4 * k) (k * z))
    -- Nested boxes: box i lies inside i others, and every other one is a cavity.
    side i = fromIntegral (10 * (6 - i)) :: Rational
    sign i = if even i then 1 else -1 :: Rational
    nested n = foldr (both . one) (one (n - 1)) [0 .. n - 2]
    one :: Int -> Description
    one i =
      (if even i then id else reversed)
        . labelled (show i ++ ".")
        . moved (\(Point x y z) -> Point (x + shift) (y + shift) (z + shift))
        $ (namedDescription (Box (side i) (side i) (side i))) {describedName = ""}
      where
        shift = fromIntegral (5 * i)

-- Cells.

cellLaws :: [Law ()]
cellLaws =
  [ definedWithoutProfile
      OnObjects
      "cells-as-defined"
      FaceCells
      "the cells are those of the grid, centred on the face's bounding box, that lie wholly on \
      \the face"
      "the face's frame: x from the walk's first vertex to its last, y into the face"
      "a cell, its rim included, lies in the polygon; irrational lengths are compared exactly"
      ( Some
          ( faces >>= \corners ->
              SomeQuestion . (FaceCells :?) . (,) corners <$> pitchFor corners
          )
          smallerQuestions
      ),
    definedWithoutProfile
      OnObjects
      "cells-at-the-rim"
      FaceCells
      "cells that touch a face's rim from inside lie on the face, and columns and rows that fit \
      \exactly are counted"
      "the face's frame: x from the walk's first vertex to its last, y into the face"
      "a cell, its rim included, lies in the polygon"
      (Some (SomeQuestion <$> rims) smallerQuestions),
    definedWithoutProfile
      OnObjects
      "cells-refuses-what-is-no-face"
      FaceCells
      "corners that are not a simple polygon in a plane, and distances that are not positive, are \
      \refused as impossible-face"
      "the protocol, cells"
      "it is not a face of a solid that can carry symbols"
      (Some (SomeQuestion <$> noFaces) smallerQuestions),
    invalid OnObjects "cells-refuses-what-is-invalid" FaceCells . const $
      [rawWith plain "pitch_mm" (toJSON [number, String "1"]) | number <- notExact]
        ++ malformed plain
  ]
  where
    plain = FaceCells :? ([Point 0 0 0, Point 0 3 0, Point 4 0 0], (1, 1))
    -- A pitch with room for a few cells.
    pitchFor corners = do
      n <- fromInteger <$> chooseInteger (2, 8)
      -- Sometimes with many columns or rows.
      (right, down) <-
        frequency
          [ (8, elements [(1, 5 / 4), (1, 1), (7 / 3, 1 / 2)]),
            (1, elements [(1 / 40, 3), (3, 1 / 80)])
          ]
      let across part = maximum (map part corners) - minimum (map part corners)
          widest =
            maximum
              [ across (\(Point x _ _) -> x),
                across (\(Point _ y _) -> y),
                across
                  (\(Point _ _ z) -> z)
              ]
      pure (widest * right / n, widest * down / n)
    -- A staircase with steps of whole cells, in a plane in which they are rational.
    rims = do
      (right, down) <- elements [(1, 1), (127 / 5, 127 / 4), (2 / 3, 5)]
      steps <- map (\(x, y) -> (x * right, y * down)) <$> staircase (chooseInteger (1, 4))
      place <- elements [((1, 0, 0), (0, 1, 0)), ((1 / 3, 2 / 3, 2 / 3), (2 / 3, 1 / 3, -2 / 3))]
      pure (FaceCells :? (inPlane place (Point 5 0 0) steps, (right, down)))
    noFaces = do
      corners <- faces
      pitch <- pitchFor corners
      i <- chooseInt (0, length corners - 1)
      let (before, after) = splitAt i corners
      elements
        [ FaceCells :? (before ++ take 1 after ++ after, pitch),
          FaceCells :? (take 2 corners, pitch),
          FaceCells
            :? ( before ++ [Point x y (z + 1 / 7) | Point x y z <- take 1 after]
                   ++ drop 1 after
                   ++ [Point 0 0 1],
                 pitch
               ),
          FaceCells :? (corners, (0, snd pitch)),
          FaceCells :? (corners, (fst pitch, negate (snd pitch))),
          FaceCells :? ([], pitch)
        ]

-- Windows.

whereaboutsLaws :: [Law ()]
whereaboutsLaws =
  [ definedWithoutProfile
      OnObjects
      "whereabouts-as-defined"
      Whereabouts
      "a window whose cells all belong to one face is on that face, with its place there and all \
      \vertices nearest to its middle; a window on several faces straddles them; any other is on \
      \no object"
      "section II.B of the paper; the face's frame"
      "the window's cells are compared with those of every face; a face does not go round the torus"
      (Some (SomeQuestion <$> (placements >>= windowOn)) smallerQuestions),
    definedWithoutProfile
      OnObjects
      "whereabouts-refuses-what-cannot-be-laid"
      Whereabouts
      "faces that cannot be laid as stated are refused as impossible-placement"
      "the protocol, whereabouts"
      "cells are shared, off the face or off the sheet, or an object or a face is none"
      (Some (SomeQuestion <$> (placements >>= impossible >>= windowOn)) smallerQuestions),
    invalid OnObjects "whereabouts-refuses-what-is-invalid" Whereabouts . const $
      malformed plain
        ++ [rawWith plain "layings" (toJSON [changed name value]) | (name, value) <- wrongLayings]
  ]
  where
    plain = Whereabouts :? (Mapped (Shape 3 3) (1, 1) [] [], Shape 1 1, Position 1 1)
    changed name value =
      object
        [ key .= (if key == name then value else usual)
          | (key, usual) <-
              [ ("object", "a"),
                ("face", toJSON ["p" :: String]),
                ("row", Number 0),
                ("column", Number 0),
                ("margin_mm", Null),
                ("cells", toJSON ["#" :: String])
              ]
        ]
    wrongLayings =
      [ ("row", Number 1.5),
        ("column", String "x"),
        ("margin_mm", toJSON [String "1"]),
        ("margin_mm", toJSON [String "1.5", String "1"]),
        ("cells", toJSON ["#", "##" :: String]),
        ("cells", toJSON ["#x" :: String]),
        ("face", toJSON ["a b" :: String]),
        ("object", Null)
      ]

-- Poses.

poseLaws :: [Law ()]
poseLaws =
  [ law
      OnObjects
      "pose-of-exact-places"
      [SomeOp FacePose]
      "for points that were felt without error, the pose is the object's true one"
      "how it was made: the object was moved, and the face with it"
      ( \() -> Cases lyingForm (Some lying smallerLying) $ \(Lying felt motion) ->
          let question = FacePose :? felt
           in case expectedWithoutProfile question of
                Just (Right it) ->
                  let wanted = it {poseMotion = motion}
                   in judge
                        question
                        (Right wanted)
                        (agreesWithoutProfile question wanted)
                        "the scene"
                        why
                        <$> ask question
                _ -> pure Inapplicable
      ),
    definedWithoutProfile
      OnObjects
      "pose-by-least-squares"
      FacePose
      "for points that were felt with errors, the answer is the most probable pose and its \
      \covariance"
      "least squares of a rigid motion in the plane (Procrustes); first-order errors"
      "the sum of squared distances is least, and errors are carried to the object's frame"
      (Some (SomeQuestion . (FacePose :?) <$> (lying >>= noisy . lyingFelt)) smallerQuestions),
    invalid OnObjects "pose-refuses-what-is-invalid" FacePose . const $
      [ rawWith plain name value
        | (name, value) <-
            [ ("sd_mm", Number 0),
              ("sd_mm", Number (-1)),
              ("sd_mm", String "1"),
              ("plane", object []),
              ("plane", plane [[1, 0, 0], [0, 1, 0], [0, 0, -1]]),
              ("plane", plane [[1, 0, 0], [0, 1, 0], [0, 0.001, 1]]),
              ("plane", plane [[1, 0], [0, 1]]),
              ("plane", Bool True),
              ("seen", Null),
              ("seen", toJSON [object ["on_face" .= [0 :: Int, 0]]]),
              ("seen", toJSON [object ["on_face" .= [0 :: Int, 0], "by_robot" .= [0 :: Int]]]),
              ("corners", toJSON [[String "0", String "0"]]),
              ("corners", toJSON [map String ["0", "1.5", "0"]])
            ]
      ],
    definedWithoutProfile
      OnObjects
      "pose-refuses-what-is-undetermined"
      FacePose
      "fewer than two different points of the face are refused as undetermined, and corners that \
      \are not a simple polygon in a plane as impossible-face"
      "the protocol, pose"
      "one point does not determine the face's rotation"
      (Every ([SomeQuestion (FacePose :? felt) | felt <- unfit]))
  ]
  where
    why = "the points were moved with the object"
    plane :: [[Double]] -> Value
    plane rows = object ["rotation" .= rows, "translation_mm" .= [0 :: Double, 0, 0]]
    square = [Point 0 0 0, Point 0 (-30) 0, Point 30 (-30) 0, Point 30 0 0]
    plain = FacePose :? Felt square [((0, 0), (1, 2)), ((10, 0), (11, 2))] 1 Nothing
    unfit =
      [ Felt square seen 1 Nothing
        | seen <-
            [[], [((1, 1), (2, 2))], [((1, 1), (2, 2)), ((1, 1), (2, 3))]]
      ]
        ++ [ Felt corners [((0, 0), (1, 2)), ((10, 0), (11, 2))] 1 Nothing
             | corners <-
                 [[], take 2 square, map (square !!) [0, 2, 1, 3]]
           ]
