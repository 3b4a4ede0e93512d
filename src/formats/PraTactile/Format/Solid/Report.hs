{-# LANGUAGE OverloadedStrings #-}

-- | The JSON of @solid@, the report on a polyhedron.
module PraTactile.Format.Solid.Report
  ( encodeReport,
    defectValue,
  )
where

import Data.Aeson (Value, object, toJSON, (.=))
import Data.ByteString (ByteString)
import Data.Function (on)
import Data.List (groupBy)
import qualified Data.Map.Strict as Map
import Data.String (fromString)
import qualified Data.Vector.Unboxed as U
import PraTactile.Format.Json
import PraTactile.Format.Solid.Contents
import PraTactile.Format.Solid.Number
import PraTactile.Object.Cells
import PraTactile.Object.Defect
import PraTactile.Object.Description
import PraTactile.Object.Mend
import PraTactile.Object.Mesh
import PraTactile.Object.Validity

-- | Limits of the list of defects of each kind: their number (also of turned faces), and the number
-- of vertex names at which the list ends. All defects are counted.
mostOfAKind, mostNames :: Int
mostOfAKind = 1000
mostNames = 100000

-- | The report on a polyhedron as one line, without its line end. The arguments are the
-- polyhedron, the ignored things of its file, the changes made to it, the mending that would make
-- it a solid, its grids and the findings.
encodeReport :: Mesh -> [Passed] -> Changes -> Maybe Mending -> [Grid] -> Report -> ByteString
encodeReport it passed changes mending grids report =
  encodeSchema "solid/1" $
    "name" .= objectText (meshName it)
      <> "valid" .= reportValid report
      <> "vertices" .= reportVertices report
      <> "edges" .= reportEdges report
      <> "faces" .= reportFaces report
      <> "passed_over" .= [what | Passed what <- passed]
      <> "moved" .= object ["vertices" .= movedVertices changes, "most_mm" .= movedMost changes]
      <> "left_out" .= leftOutFaces changes
      <> "turned"
        .= object
          [ "count" .= length (turnedFaces changes),
            "faces" .= map (map vertexText . faceVertices) (take mostOfAKind (turnedFaces changes))
          ]
      <> "mended_by" .= fmap mendingValue mending
      <> "components" .= map componentValue (reportComponents report)
      <> "carrying" .= map gridValue grids
      <> "counts"
        .= object
          [ fromString (kindName kind) .= Map.findWithDefault 0 kind counts
            | kind <- [minBound .. maxBound]
          ]
      <> "defects" .= map defectValue (concatMap listed byKind)
      <> "not_examined"
        .= [ object ["kind" .= kindName kind, "because" .= map kindName causes]
             | Unexamined kind causes <- reportNotExamined report
           ]
  where
    byKind = groupBy ((==) `on` defectKind) (reportDefects report)
    listed defects =
      map fst . takeWhile ((< mostNames) . snd) $
        zip (take mostOfAKind defects) (scanl (+) 0 (map names defects))
    names (Defect _ faces vertices _) =
      length vertices + sum (map (length . faceVertices) faces)
    counts = Map.fromListWith (+) [(defectKind defect, 1 :: Int) | defect <- reportDefects report]
    gridValue grid =
      object
        [ "face" .= map (vertexText . vertexAt it) (U.toList (gridWalk grid)),
          "size_mm" .= [fst (gridSize grid), snd (gridSize grid)],
          "cells" .= fmap integerValue (gridCount grid)
        ]

-- | The options that would make a polyhedron a solid.
mendingValue :: Mending -> Value
mendingValue mending =
  object
    [ "tolerance_mm" .= fmap (fromRational :: Rational -> Double) (mendTolerance mending),
      "fix_orientation" .= mendOrientation mending
    ]

-- | One defect.
defectValue :: Defect -> Value
defectValue (Defect kind faces vertices measure) =
  object
    [ "kind" .= kindName kind,
      "faces" .= map (map vertexText . faceVertices) faces,
      "vertices" .= map vertexText vertices,
      "measure_mm" .= measure
    ]

componentValue :: Component -> Value
componentValue it =
  object
    [ "vertices" .= componentVertices it,
      "edges" .= componentEdges it,
      "faces" .= componentFaces it,
      "euler" .= componentEuler it,
      "genus" .= componentGenus it,
      "volume_mm3" .= fmap exactText (componentVolume it),
      "convex" .= componentConvex it,
      "inside" .= toJSON (componentInside it)
    ]
