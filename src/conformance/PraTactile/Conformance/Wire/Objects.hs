{-# LANGUAGE OverloadedStrings #-}

-- | Questions about objects and their answers as JSON values. The answers are objects with some of
-- the keys that @pra-tactile solid@, @objects@ and @decode@ print, and further keys do not matter.
module PraTactile.Conformance.Wire.Objects
  ( -- * Questions
    polyhedronValue,
    readPolyhedron,
    faceValue,
    readFace,
    windowValue,
    readWindow,
    feltValue,
    readFelt,

    -- * Answers
    reportValue,
    readReport,
    readCells,
    whereaboutsValue,
    readWhereabouts,
    poseValue,
    readPose,
  )
where

import Control.Monad (guard, (>=>))
import Data.Aeson (Object, Value (..), object, toJSON, (.=))
import Data.Aeson.Types (Pair)
import Data.Char (isSpace)
import Data.Ratio (denominator, numerator)
import qualified Data.Text as Text
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Conformance.Question.Objects
import PraTactile.Conformance.Wire.Read
import PraTactile.Format.Json (integerValue, naturalValue)
import PraTactile.Format.Json.Codec (readKeys, readValue, writeObject, writeValue)
import PraTactile.Format.Object
import PraTactile.Format.Placement (Drawing (..))
import PraTactile.Format.Pose (motionCodec, poseCodec)
import PraTactile.Format.Solid.Report (defectValue)
import PraTactile.Object.Defect
import PraTactile.Object.Description
import PraTactile.Object.Placement (Face (..))
import PraTactile.Object.Validity (Component (..), Report (..), reportValid)
import PraTactile.Pose (Pose)

-- | An exact number: a text of an integer, or of two with a slash between.
exactValue :: Rational -> Value
exactValue x = toJSON (show (numerator x) ++ under)
  where
    under = if denominator x == 1 then "" else "/" ++ show (denominator x)

readExact :: Value -> Maybe Rational
readExact value = case value of
  String given -> case Text.splitOn "/" given of
    [whole] -> fromInteger <$> readWhole (String whole)
    [over, under] -> do
      n <- readWhole (String over)
      d <- readNatural (String under)
      guard (d > 0)
      pure (fromInteger n / fromIntegral d)
    _ -> Nothing
  _ -> Nothing

pointValue :: Point -> Value
pointValue (Point x y z) = toJSON (map exactValue [x, y, z])

readPoint :: Value -> Maybe Point
readPoint =
  readItems readExact >=> \given -> case given of
    [x, y, z] -> Just (Point x y z)
    _ -> Nothing

polyhedronValue :: Description -> Value
polyhedronValue = object . polyhedronPairs

polyhedronPairs :: Description -> [Pair]
polyhedronPairs it =
  [ "vertices"
      .= [object ["name" .= vertexText v, "at" .= pointValue p] | (v, p) <- describedVertices it],
    "faces" .= map walkValue (describedFaces it)
  ]

walkValue :: FaceName -> Value
walkValue = toJSON . map vertexText . faceVertices

readWalk :: Value -> Maybe FaceName
readWalk = fmap FaceName . readItems readVertexName

readVertexName :: Value -> Maybe VertexName
readVertexName value = do
  name <- readText value
  guard (not (null name) && not (any isSpace name))
  pure (VertexName name)

readPolyhedron :: Object -> Maybe Description
readPolyhedron fields =
  Description (ObjectName "") <$> readKey "vertices" (readItems (readObject >=> vertex)) fields
    <*> readKey "faces" (readItems readWalk) fields
  where
    vertex given =
      (,) <$> readKey "name" readVertexName given <*> readKey "at" readPoint given

faceValue :: [Point] -> (Rational, Rational) -> Value
faceValue corners pitch =
  object ["corners" .= map pointValue corners, "pitch_mm" .= pairValue exactValue pitch]

readFace :: Object -> Maybe ([Point], (Rational, Rational))
readFace fields =
  (,) <$> readKey "corners" (readItems readPoint) fields
    <*> readKey "pitch_mm" (readTwo readExact) fields

pairValue :: (a -> Value) -> (a, a) -> Value
pairValue value (a, b) = toJSON [value a, value b]

-- | The window's shape and the position of its upper left cell, and what is laid where.
windowValue :: Mapped -> Shape -> Position -> Value
windowValue mapped window at =
  object
    [ "shape" .= shapeValue (mappedShape mapped),
      "pitch_mm" .= pairValue exactValue (mappedPitch mapped),
      "objects" .= map objectValue (mappedObjects mapped),
      "layings" .= map layingValue (mappedLayings mapped),
      "window" .= shapeValue window,
      "row" .= naturalValue (row at),
      "column" .= naturalValue (column at)
    ]
  where
    shapeValue (Shape high wide) = toJSON [naturalValue high, naturalValue wide]
    objectValue it = object ("name" .= objectText (describedName it) : polyhedronPairs it)
    layingValue laid =
      object
        [ "object" .= objectText (faceObject (drawnFace laid)),
          "face" .= walkValue (faceName (drawnFace laid)),
          "row" .= integerValue (drawnRow laid),
          "column" .= integerValue (drawnColumn laid),
          "margin_mm" .= fmap (pairValue exactValue) (drawnMargin laid),
          "cells" .= drawnCells laid
        ]

readWindow :: Object -> Maybe (Mapped, Shape, Position)
readWindow fields =
  (,,)
    <$> ( Mapped
            <$> readKey "shape" readShape fields
            <*> readKey "pitch_mm" (readTwo readExact) fields
            <*> readKey "objects" (readItems (readObject >=> polyhedron)) fields
            <*> readKey "layings" (readItems (readObject >=> laying)) fields
        )
    <*> readKey "window" readShape fields
    <*> (Position <$> readKey "row" readNatural fields <*> readKey "column" readNatural fields)
  where
    readShape = fmap (uncurry Shape) . readTwo readNatural
    polyhedron given = do
      name <- readKey "name" readText given
      it <- readPolyhedron given
      pure it {describedName = ObjectName name}
    laying given =
      Drawing
        <$> ( Face <$> (ObjectName <$> readKey "object" readText given)
                <*> readKey "face" readWalk given
            )
        <*> readKey "row" readWhole given
        <*> readKey "column" readWhole given
        <*> readKey "margin_mm" (readNullable (readTwo readExact)) given
        <*> (readKey "cells" readCells given >>= \cells -> cells <$ guard (evenly cells))

feltValue :: Felt -> Value
feltValue felt =
  object
    [ "corners" .= map pointValue (feltCorners felt),
      "seen" .= [object ["on_face" .= q, "by_robot" .= p] | (q, p) <- feltSeen felt],
      "sd_mm" .= feltError felt,
      "plane" .= fmap (writeValue motionCodec) (feltPlane felt)
    ]

-- | Whether all rows have as many cells.
evenly :: [[a]] -> Bool
evenly cells = all ((== length (concat (take 1 cells))) . length) cells

readFelt :: Object -> Maybe Felt
readFelt fields =
  Felt
    <$> readKey "corners" (readItems readPoint) fields
    <*> readKey "seen" (readItems (readObject >=> seen)) fields
    <*> (readKey "sd_mm" readReal fields >>= \sd -> sd <$ guard (sd > 0))
    <*> readKey "plane" (readNullable (known . readValue motionCodec)) fields
  where
    seen given =
      (,) <$> readKey "on_face" (readTwo readReal) given
        <*> readKey "by_robot" (readTwo readReal) given

known :: Either e a -> Maybe a
known = either (const Nothing) Just

reportValue :: Report -> Value
reportValue it =
  object
    [ "valid" .= reportValid it,
      "vertices" .= reportVertices it,
      "edges" .= reportEdges it,
      "faces" .= reportFaces it,
      "components" .= map pieceValue (reportComponents it),
      "defects" .= map defectValue (reportDefects it)
    ]
  where
    pieceValue piece =
      object
        [ "vertices" .= componentVertices piece,
          "edges" .= componentEdges piece,
          "faces" .= componentFaces piece,
          "genus" .= componentGenus piece,
          "volume_mm3" .= fmap exactValue (componentVolume piece),
          "convex" .= componentConvex piece,
          "inside" .= componentInside piece
        ]

-- | Whether it is valid is said twice, and both must say the same.
readReport :: Object -> Maybe Report
readReport fields = do
  valid <- readKey "valid" readBool fields
  it <-
    Report
      <$> count "vertices" fields
      <*> count "edges" fields
      <*> count "faces" fields
      <*> readKey "components" (readItems (readObject >=> piece)) fields
      <*> readKey "defects" (readItems (readObject >=> defect)) fields
      <*> pure []
  guard (valid == reportValid it)
  pure it
  where
    count name = readKey name (fmap fromIntegral . readNatural)
    piece given = do
      (v, e, f) <- (,,) <$> count "vertices" given <*> count "edges" given <*> count "faces" given
      Component v e f (v - e + f)
        <$> readKey "genus" (readNullable (fmap fromInteger . readWhole)) given
        <*> readKey "volume_mm3" (readNullable readExact) given
        <*> readKey "convex" (readNullable readBool) given
        <*> readKey "inside" (readNullable (fmap fromIntegral . readNatural)) given
    defect given =
      Defect
        <$> (readKey "kind" readText given >>= (`lookup` [(kindName k, k) | k <- [minBound ..]]))
        <*> readKey "faces" (readItems readWalk) given
        <*> readKey "vertices" (readItems readVertexName) given
        <*> readKey "measure_mm" (readNullable readReal) given

-- | Rows of cells, those that are taken marked by @#@, the others by @.@.
readCells :: Value -> Maybe [String]
readCells = readItems (readText >=> \line -> line <$ guard (all (`elem` ("#." :: String)) line))

whereaboutsValue :: WhereaboutsReport -> Value
whereaboutsValue = Object . writeObject whereaboutsKeys

readWhereabouts :: Object -> Maybe WhereaboutsReport
readWhereabouts = known . readKeys whereaboutsKeys

poseValue :: Pose -> Value
poseValue = writeValue poseCodec

readPose :: Value -> Maybe Pose
readPose = known . readValue poseCodec
