{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Polyhedra as JSON, @pra-tactile/object/1@, with names and exact numbers.
module PraTactile.Format.Solid.Json
  ( readObject,
    writeObject,

    -- * Parts of other formats
    describedCodec,
    tooFine,
    exact,
  )
where

import Control.Monad (foldM)
import Data.Aeson (Value (String))
import qualified Data.Aeson as Aeson
import Data.Bifunctor (first)
import Data.ByteString (ByteString)
import Data.Char (isSpace)
import Data.Maybe (isNothing)
import Data.Ratio (denominator)
import qualified Data.Text as Text
import Math.NumberTheory.Logarithms (integerLog2)
import PraTactile.Decimal (readExact)
import PraTactile.Format.Error
import PraTactile.Format.Json.Codec hiding (writeObject)
import qualified PraTactile.Format.Json.Schema as Schema
import PraTactile.Format.Solid.Contents
import PraTactile.Format.Solid.Error
import PraTactile.Format.Solid.Number
import PraTactile.Object.Description
import PraTactile.Object.Mesh

-- | Reads a polyhedron from JSON. Refuses another form, and coordinates that are 'tooFine' (told as
-- line 1). Whether it is a solid is not checked.
readObject :: ByteString -> Either SolidFileError Contents
readObject bytes = do
  described <- first ObjectRefused (decodeWith keys bytes)
  if tooFine described
    then Left (SolidFileError (AtLine 1) NoCommonDenominator)
    else Right (Contents (fromDescription described) [])

-- | Whether the common denominator of the coordinates is 2^20000 or more. With many more bits, the
-- coordinates of a file of some megabytes would fill the memory.
tooFine :: Description -> Bool
tooFine described =
  isNothing
    ( foldM
        common
        1
        [denominator c | (_, Point x y z) <- describedVertices described, c <- [x, y, z]]
    )
  where
    common over under =
      let both = lcm over under in if integerLog2 both >= 20000 then Nothing else Just both

-- | A polyhedron as JSON on one line, without its line end.
writeObject :: Mesh -> ByteString
writeObject = writeLine keys . toDescription

keys :: Keys Description Description
keys =
  (\() name vertices faces -> Description (ObjectName name) vertices (map FaceName faces))
    <$> schemaKey "pra-tactile/object/1"
    <*> key "name" text (objectText . describedName)
    <*> key "vertices" (listOf (object vertexKeys)) describedVertices
    <*> key "faces" (listOf (listOf vertexName)) (map faceVertices . describedFaces)

-- | A polyhedron as part of another format.
describedCodec :: Codec Description
describedCodec = object keys

vertexKeys :: Keys (VertexName, Point) (VertexName, Point)
vertexKeys = (,) <$> key "name" vertexName fst <*> key "at" point snd

-- | A vertex name without spaces: faces are named by their vertices' names, separated by spaces.
vertexName :: Codec VertexName
vertexName =
  via vertexText (Right . VertexName) $
    satisfying (\name -> not (null name || any isSpace name)) NotVertexName text

point :: Codec Point
point = via (\(Point x y z) -> [x, y, z]) three (listOf exact)
  where
    three given = case given of
      [x, y, z] -> Right (Point x y z)
      _ -> refuse NotPoint

-- | An exact number: a text such as @127/4@ or @31.75@, or a JSON number.
exact :: Codec Rational
exact = Codec (Schema.AnyOf [Schema.Text [], Schema.Real []]) exactText $ \value -> case value of
  String given -> exactly (Text.unpack given)
  Aeson.Number given -> exactly (show given)
  _ -> refuse NotExact
  where
    exactly = maybe (refuse NotExact) Right . readExact
