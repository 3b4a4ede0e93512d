{-# LANGUAGE OverloadedStrings #-}

-- | The JSON of faces, of whereabouts (what lies at a position of the array), and of objects.
module PraTactile.Format.Object
  ( -- * Whereabouts
    WhereaboutsReport (..),
    On (..),
    whereaboutsReport,
    whereaboutsKeys,
    encodeWhereabouts,
    encodeNoWhereabouts,

    -- * All objects
    encodeObjects,

    -- * Parts of other formats
    faceKeys,
  )
where

import Data.Aeson (Value, (.=))
import qualified Data.Aeson as Aeson
import Data.ByteString (ByteString)
import Data.String (fromString)
import PraTactile.Array (Position)
import PraTactile.Format.Json
import PraTactile.Format.Json.Codec
import PraTactile.Format.Name
import PraTactile.Format.Profile
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge
import PraTactile.Profile

-- | 'Whereabouts' as one record with a field for each JSON key.
data WhereaboutsReport = WhereaboutsReport
  { -- | where the window lies; 'Nothing' if nothing was located
    whereOn :: Maybe On,
    -- | the face, if the window lies on a single one
    whereFace :: Maybe Face,
    -- | the face, or all faces that the window straddles, in the placement's order; empty if the
    -- window lies on no object, even if some of its cells lie on a face
    whereFaces :: [Face],
    -- | the nearest vertex, if only one is nearest
    whereCorner :: Maybe VertexName,
    -- | all nearest vertices
    whereCorners :: [VertexName],
    -- | the window's centre, in millimetres right of and below the face's upper left vertex
    whereMillimetres :: Maybe (Double, Double)
  }
  deriving stock (Eq, Show)

-- | Where a window lies.
data On = OneFace | SeveralFaces | NoObject
  deriving stock (Eq, Show, Enum, Bounded)

onName :: On -> String
onName on = case on of
  OneFace -> "face"
  SeveralFaces -> "straddles-faces"
  NoObject -> "no-object"

-- | The whereabouts as a report; all fields are empty if nothing was located.
whereaboutsReport :: Maybe Whereabouts -> WhereaboutsReport
whereaboutsReport found = case found of
  Nothing -> onNone Nothing []
  Just (Straddles faces) -> onNone (Just SeveralFaces) faces
  Just OnNoObject -> onNone (Just NoObject) []
  Just (OnFace place) ->
    WhereaboutsReport
      { whereOn = Just OneFace,
        whereFace = Just (placeFace place),
        whereFaces = [placeFace place],
        whereCorner = corner place,
        whereCorners = placeCorners place,
        whereMillimetres = Just (spotMillimetres (placeCentre place))
      }
  where
    onNone on faces = WhereaboutsReport on Nothing faces Nothing [] Nothing

-- | The keys of a whereabouts report.
whereaboutsKeys :: Keys WhereaboutsReport WhereaboutsReport
whereaboutsKeys =
  report
    <$> key "on" (nullable (named onName)) whereOn
    <*> key "object" (nullable objectName) (fmap faceObject . whereFace)
    <*> key "face" (nullable vertices) (fmap faceName . whereFace)
    <*> key "faces" (listOf (object faceKeys)) whereFaces
    <*> key "corner" (nullable vertex) whereCorner
    <*> key "corners" (listOf vertex) whereCorners
    <*> key "place_mm" (nullable millimetres) whereMillimetres
  where
    -- By way of 'Value', which writes 25 millimetres as 25 and not as 25.0.
    millimetres = case pairOf real of
      two -> Codec (schemaOf two) (writeValue two) (readValue two)
    report on object' face = WhereaboutsReport on (Face <$> object' <*> face)

-- | The keys @object@ and @face@ of a face.
faceKeys :: Keys Face Face
faceKeys = Face <$> key "object" objectName faceObject <*> key "face" vertices faceName

objectName :: Codec ObjectName
objectName = via objectText (Right . ObjectName) text

vertices :: Codec FaceName
vertices = via faceVertices (Right . FaceName) (listOf vertex)

vertex :: Codec VertexName
vertex = via vertexText (Right . VertexName) text

-- | The whereabouts of a window at a position in a profile's array, as one line without its line
-- end.
encodeWhereabouts :: Profile -> Position -> Whereabouts -> ByteString
encodeWhereabouts profile at place =
  encodeSchema schema $
    "profile" .= profileValue profile
      <> "position" .= positionValue at
      <> series whereaboutsKeys (whereaboutsReport (Just place))

-- | The line for a malformed request of a batch, without its line end: the outcome @invalid@, the
-- reason @bad-input@, and the given message to the user.
encodeNoWhereabouts :: Profile -> String -> ByteString
encodeNoWhereabouts profile why =
  encodeSchema schema $
    "profile" .= profileValue profile
      <> "outcome" .= ("invalid" :: String)
      <> "reason" .= ("bad-input" :: String)
      <> "message" .= why

schema :: String
schema = "objects/1"

-- | The objects and the positions of their faces in a profile's array, as one line without its
-- line end.
encodeObjects :: Profile -> Placement -> ByteString
encodeObjects profile layout =
  encodeSchema schema $
    "profile" .= profileValue profile
      <> "objects" .= map (solidValue layout) (placementSolids layout)

solidValue :: Placement -> Solid -> Value
solidValue layout body =
  Aeson.object
    [ "object" .= objectText (solidName body),
      "vertices"
        .= Aeson.object
          [ fromString (vertexText v) .= map double [pointX p, pointY p, pointZ p]
            | (v, p) <- solidVertices body
          ],
      "edges" .= map edgeValue (solidEdges body),
      "faces"
        .= [ faceValue laid
             | laid <- laidFaces layout,
               faceObject (laidFace laid) == solidName body
           ]
    ]
  where
    edgeValue edge =
      Aeson.object
        [ "vertices" .= map vertexText [edgeStart edge, edgeEnd edge],
          "faces" .= map (map vertexText . faceVertices) [edgeLeft edge, edgeRight edge]
        ]
    faceValue laid =
      Aeson.object
        [ "face" .= map vertexText (faceVertices (faceName (laidFace laid))),
          "position" .= positionValue (laidAt laid),
          "shape" .= shapeText (laidGrid laid),
          "size_mm" .= let (wide, high) = spotMillimetres (laidExtent laid) in [wide, high]
        ]
    double = fromRational :: Rational -> Double
