{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The operations of objects: polyhedra, cells of faces, places on them, poses.
module PraTactile.Conformance.Operations.Objects
  ( solidReport,
    faceCells,
    whereabouts,
    facePose,
    feltForm,
  )
where

import Data.Aeson ((.=))
import Data.Char (isSpace)
import Data.List (sort, sortOn)
import Data.Maybe (isNothing)
import Data.Text (Text)
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Conformance.Definition.Objects
import PraTactile.Conformance.Definition.Pose
import PraTactile.Conformance.Definition.Solid
import PraTactile.Conformance.Forms
import PraTactile.Conformance.Library.Objects
import PraTactile.Conformance.Operation
import PraTactile.Conformance.Operations.Conventions
import PraTactile.Conformance.Question
import PraTactile.Conformance.Stage
import PraTactile.Conformance.Vectors.Objects
import PraTactile.Format.Error (Misfit (NotAmong, NotDrawnCells, NotPoint, NotReal, NotVertexName))
import PraTactile.Format.Json.Codec hiding (integer, natural)
import qualified PraTactile.Format.Json.Schema as Schema
import PraTactile.Format.Object (WhereaboutsReport (..), whereaboutsKeys)
import PraTactile.Format.Placement (Drawing (..))
import PraTactile.Format.Pose (motionCodec, poseCodec)
import PraTactile.Object.Defect
import PraTactile.Object.Description
import PraTactile.Object.Named
import PraTactile.Object.Placement (Face (..))
import PraTactile.Object.Validity (Component (..), Report (..), reportValid)
import PraTactile.Pose (Pose (..), RigidMotion (..))

-- Polyhedra.

point :: Codec Point
point = withSchema (const schema) (via (\(Point x y z) -> [x, y, z]) three (listOf exact))
  where
    schema = Schema.Named "exact-point" (Schema.listOfLength 3 (schemaOf exact))
    three given = case given of
      [x, y, z] -> Right (Point x y z)
      _ -> refuse NotPoint

-- | A name of at least one character and no space.
vertexName :: Codec VertexName
vertexName =
  withSchema (const (Schema.Text ["pattern" .= ("^\\S+$" :: Text)])) $
    via vertexText (Right . VertexName) (satisfying isName NotVertexName text)
  where
    isName name = not (null name || any isSpace name)

walk :: Codec FaceName
walk = via faceVertices (Right . FaceName) (listOf vertexName)

polyhedronKeys :: Keys Description Description
polyhedronKeys =
  Description (ObjectName "")
    <$> key "vertices" (listOf (object vertexKeys)) describedVertices
    <*> key "faces" (listOf walk) describedFaces
  where
    vertexKeys = (,) <$> key "name" vertexName fst <*> key "at" point snd

solidReport :: Operation Description Report
solidReport =
  Operation
    { operationName = "solid",
      operationStage = OnObjects,
      operationSays = "`valid`, `vertices`, `edges`, `faces`, `components`, `defects`",
      operationInput = object polyhedronKeys,
      operationOutput = reportForm,
      operationReasons = [],
      operationLeast = const 1,
      operationWays =
        WithoutProfile
          (meaning (const (Right . reportOf)) (const why) ways (const nothing))
            { likened = \_ _ got wanted -> if sameReport wanted got then got else wanted,
              smaller = lessSolid,
              asked =
                const
                  ( solidGroups
                      ++ [otherForms (object polyhedronKeys) (namedDescription (Tetrahedron 1))]
                  )
            }
          librarySolid
    }
  where
    why = "each kind of defect is looked for unless another leaves it without meaning"
    ways = ("sweeps and trees of boxes", "everything compared with everything")
    nothing = Description (ObjectName "") [] []

-- | Inputs of other forms, made of this one.
otherForms :: Codec i -> i -> Group i
otherForms codec = Group "Inputs of the wrong form, or nearly so." . OtherForms . malformedOf codec

-- | Whether the polyhedron is valid is stated twice, and both must agree.
reportForm :: Codec Report
reportForm =
  via (\it -> (reportValid it, it)) agreeing . object $
    (,) <$> key "valid" bool fst <*> withKeys snd keys
  where
    agreeing (isValid, it)
      | isValid == reportValid it = Right it
      | otherwise = refuse (NotAmong [show (reportValid it)] (show isValid))
    keys =
      (\v e f pieces defects -> Report v e f pieces defects [])
        <$> key "vertices" count reportVertices
        <*> key "edges" count reportEdges
        <*> key "faces" count reportFaces
        <*> key "components" (listOf (object piece)) reportComponents
        <*> key "defects" (listOf (object defect)) reportDefects
    count = via fromIntegral (Right . fromIntegral) natural
    piece =
      (\v e f -> Component v e f (v - e + f))
        <$> key "vertices" count componentVertices
        <*> key "edges" count componentEdges
        <*> key "faces" count componentFaces
        <*> key "genus" (nullable (via toInteger (Right . fromInteger) integer)) componentGenus
        <*> key "volume_mm3" (nullable exact) componentVolume
        <*> key "convex" (nullable bool) componentConvex
        <*> key "inside" (nullable count) componentInside
    defect =
      Defect
        <$> key "kind" (named kindName) defectKind
        <*> key "faces" (listOf walk) defectFaces
        <*> key "vertices" (listOf vertexName) defectVertices
        <*> key "measure_mm" (nullable real) defectMeasure

-- | Without one of the faces, without the vertices that no face has, or with simpler coordinates.
lessSolid :: Description -> [Description]
lessSolid it =
  [it {describedFaces = less} | less <- lessList (const []) (describedFaces it)]
    ++ [it {describedVertices = used} | length used < length (describedVertices it)]
    ++ [it {describedVertices = less} | less <- oneLess (traverse lessPoint) (describedVertices it)]
  where
    used = filter ((`elem` concatMap faceVertices (describedFaces it)) . fst) (describedVertices it)

-- | A point with whole coordinates.
lessPoint :: Point -> [Point]
lessPoint p@(Point x y z) = filter (/= p) [Point (whole x) (whole y) (whole z)]
  where
    whole = fromInteger . round

-- Cells.

-- | Rows of cells, those that are taken marked by @#@, the others by @.@.
cellsForm :: Codec [String]
cellsForm = listOf (withSchema (const schema) (satisfying (all (`elem` marks)) NotDrawnCells text))
  where
    schema = Schema.Text ["pattern" .= ("^[#.]*$" :: Text)]
    marks = "#." :: String

-- | The reason where corners are no face.
impossibleFace :: (String, String)
impossibleFace =
  ( "impossible-face",
    "the corners are no simple polygon in one plane, or a distance is not positive"
  )

faceCells :: Operation ([Point], (Rational, Rational)) [String]
faceCells =
  Operation
    { operationName = "cells",
      operationStage = OnObjects,
      operationSays = "rows of text: `#` on the face, `.` off it",
      operationInput = form,
      operationOutput = cellsForm,
      operationReasons = [impossibleFace, tooLong],
      operationLeast = const 1,
      operationWays =
        WithoutProfile
          (meaning (const (uncurry cellsOf)) (const why) ways (const ([], (1, 1))))
            { smaller = \(corners, pitch) ->
                [(less, pitch) | less <- lessList lessPoint corners],
              asked = const (cellsGroups ++ [otherForms form (square, (1, 1))])
            }
          (uncurry libraryCells)
    }
  where
    form =
      object ((,) <$> key "corners" (listOf point) fst <*> key "pitch_mm" (pairOf exact) snd)
    why = "a cell is on the face if all of it, rim included, lies in the polygon"
    ways = ("lines that separate sides and cells", "strips between corners")

-- Windows.

-- | The window's shape and the position of its upper left cell, and what is laid where.
whereabouts :: Operation (Mapped, Shape, Position) WhereaboutsReport
whereabouts =
  Operation
    { operationName = "whereabouts",
      operationStage = OnObjects,
      operationSays = "`on`, `object`, `face`, `faces`, `corner`, `corners`, `place_mm`",
      operationInput = form,
      operationOutput = object whereaboutsKeys,
      operationReasons =
        [("impossible-placement", "a side, distance, object or laying is invalid")],
      operationLeast = const 1,
      operationWays =
        WithoutProfile
          (meaning (const (uncurried whereaboutsOf)) (const why) ways (const nothing))
            { likened = \_ _ got wanted -> if sameWhereabouts wanted got then got else wanted,
              smaller = lessWindow,
              asked =
                const
                  (whereaboutsGroups ++ [otherForms form (mapped, Shape 1 1, Position 0 0)])
            }
          (uncurried libraryWhereabouts)
    }
  where
    nothing = (Mapped (Shape 1 1) (1, 1) [] [], Shape 1 1, Position 0 0)
    uncurried f (a, b, c) = f a b c
    why =
      "the window's cells are compared with those of every face; a face does not go round the torus"
    ways = ("runs of cells", "lists of cells")
    form =
      object
        ( (,,)
            <$> withKeys (\(laid, _, _) -> laid) mappedKeys
            <*> key "window" shapeForm (\(_, window, _) -> window)
            <*> withKeys
              (\(_, _, at) -> at)
              (Position <$> key "row" natural row <*> key "column" natural column)
        )
    mappedKeys =
      Mapped
        <$> key "shape" shapeForm mappedShape
        <*> key "pitch_mm" (pairOf exact) mappedPitch
        <*> key "objects" (listOf (object objectKeys)) mappedObjects
        <*> key "layings" (listOf (object layingKeys)) mappedLayings
    objectKeys =
      (\name it -> it {describedName = name})
        <$> key "name" objectName describedName
        <*> polyhedronKeys
    objectName = via objectText (Right . ObjectName) text
    layingKeys =
      Drawing
        <$> ( Face
                <$> key "object" objectName (faceObject . drawnFace)
                <*> key "face" walk (faceName . drawnFace)
            )
        <*> key "row" integer drawnRow
        <*> key "column" integer drawnColumn
        <*> key "margin_mm" (nullable (pairOf exact)) drawnMargin
        <*> key "cells" (satisfying evenly NotDrawnCells cellsForm) drawnCells
    evenly cells = all ((== length (concat (take 1 cells))) . length) cells

-- | Fewer layings, a smaller window, or a position nearer to the first.
lessWindow :: (Mapped, Shape, Position) -> [(Mapped, Shape, Position)]
lessWindow (laid, window@(Shape high wide), at@(Position r c)) =
  [ (laid {mappedLayings = less}, window, at)
    | less <- lessList (const []) (mappedLayings laid)
  ]
    ++ [ (laid, Shape high' wide', at)
         | (high', wide') <- pairsLess (high, wide),
           high' > 0 && wide' > 0
       ]
    ++ [(laid, window, Position r' c') | (r', c') <- pairsLess (r, c)]

-- Poses.

feltForm :: Codec Felt
feltForm =
  object
    ( Felt
        <$> key "corners" (listOf point) feltCorners
        <*> key "seen" (listOf (object seenKeys)) feltSeen
        <*> key "sd_mm" deviation feltError
        <*> key "plane" (nullable motionCodec) feltPlane
    )
  where
    seenKeys = (,) <$> key "on_face" (pairOf real) fst <*> key "by_robot" (pairOf real) snd
    deviation =
      withSchema (const (Schema.Real ["exclusiveMinimum" .= (0 :: Int)])) $
        satisfying (> 0) NotReal real

facePose :: Operation Felt Pose
facePose =
  Operation
    { operationName = "pose",
      operationStage = OnObjects,
      operationSays = "`rotation`, `translation_mm`, `covariance`",
      operationInput = feltForm,
      operationOutput = poseCodec,
      operationReasons =
        [ impossibleFace,
          ("undetermined", "fewer than two different `on_face` are given")
        ],
      operationLeast = const 1,
      operationWays =
        WithoutProfile
          (meaning (const poseOf) (const why) ways (const (Felt [] [] 1 Nothing)))
            { likened = \_ _ got wanted -> if samePose wanted got then got else wanted,
              smaller = \it ->
                [it {feltPlane = Nothing} | Just _ <- [feltPlane it]]
                  ++ [ it {feltSeen = less}
                       | less <- lessList (const []) (feltSeen it),
                         length less > 1
                     ],
              asked = const poseGroups,
              -- Far finer than answers are compared, and free of the last digits of sines.
              stated = \(Pose (RigidMotion turned by) covariance) _ ->
                Pose
                  (RigidMotion (map (map toTenPlaces) turned) (map toTenPlaces by))
                  (map (map toTenPlaces) covariance)
            }
          libraryPose
    }
  where
    why = "the sum of squared distances is least, and errors are those of the object's frame"
    ways = ("Gauss and Newton", "the closed form")

-- Agreement: defects, and the faces and vertices of each, may come in any order, and so may the
-- faces and vertices of a place; lengths are held to 10^-9 of themselves and of a millimetre.

near :: Double -> Double -> Bool
near a b = abs (a - b) <= 1e-9 * (1 + abs a)

sameReport :: Report -> Report -> Bool
sameReport wanted got =
  numbers wanted == numbers got
    && reportComponents wanted == reportComponents got
    && map what (inOrder wanted) == map what (inOrder got)
    && and (zipWith measured (inOrder wanted) (inOrder got))
  where
    numbers it = (reportVertices it, reportEdges it, reportFaces it)
    inOrder = sortOn what . map sorted . reportDefects
    sorted (Defect kind faces vertices measure) = Defect kind (sort faces) (sort vertices) measure
    what (Defect kind faces vertices _) = (kind, faces, vertices)
    measured a b = case (defectMeasure a, defectMeasure b) of
      (Just x, Just y) -> near x y
      (x, y) -> isNothing x && isNothing y

sameWhereabouts :: WhereaboutsReport -> WhereaboutsReport -> Bool
sameWhereabouts wanted got =
  said wanted == said got
    && sort (whereFaces wanted) == sort (whereFaces got)
    && sort (whereCorners wanted) == sort (whereCorners got)
    && case (whereMillimetres wanted, whereMillimetres got) of
      (Just (x, y), Just (x', y')) -> near x x' && near y y'
      (a, b) -> isNothing a && isNothing b
  where
    said it = (whereOn it, whereFace it, whereCorner it)

samePose :: Pose -> Pose -> Bool
samePose (Pose motion covariance) (Pose motion' covariance') =
  and (zipWith near (numbers motion) (numbers motion'))
    && and (zipWith alike (concat covariance) (concat covariance'))
  where
    numbers it = concat (motionRows it) ++ motionBy it
    alike a b = abs (a - b) <= 1e-9 * maximum (map abs (concat covariance))
