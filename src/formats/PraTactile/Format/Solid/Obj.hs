{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The object files of Wavefront: @v X Y Z@ is a vertex; @f A B C ..@ is a face by its vertices,
-- counted from 1, or by negative numbers back from the last one.
module PraTactile.Format.Solid.Obj
  ( readObj,
    writeObj,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as Char8
import qualified Data.Set as Set
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Format.Solid.Contents
import PraTactile.Format.Solid.Error
import PraTactile.Format.Solid.Number
import PraTactile.Format.Solid.Text
import PraTactile.Object.Description (ObjectName)
import PraTactile.Object.Mesh

-- | The state of reading: the number of vertices; vertices and faces, newest first, each face with
-- its line; and the ignored things.
data Found = Found !Int [(Number, Number, Number)] [(Line, Walk)] !(Set.Set Passed)

-- | Reads the polyhedron of an OBJ file, all groups together. Everything else is ignored. Refuses
-- a text without vertices.
readObj :: ObjectName -> ByteString -> Either SolidFileError Contents
readObj name bytes = go (Found 0 [] [] Set.empty) (joined (linesOf bytes))
  where
    -- All other lines are ignored, so a text without vertices has probably another format.
    go (Found 0 _ _ _) [] =
      Left
        ( SolidFileError
            (AtLine (length (Char8.split '\n' bytes)))
            (Ends "its first vertex, a line v X Y Z")
        )
    go (Found count points faces passed) [] = do
      mapM_ (known count) faces
      Right
        ( contents
            name
            Decimal
            (Set.toList passed)
            (V.fromListN count (reverse points))
            (V.fromList (reverse (map snd faces)))
        )
    go (Found count points faces passed) (line : others) = case lineWords line of
      "v" : rest -> do
        point <- atLine line (numbers rest)
        let more = [Passed "what follows the coordinates of vertices" | not (null (drop 3 rest))]
        point `seq` go (Found (count + 1) (point : points) faces (adding more passed)) others
      "f" : rest -> do
        walk <- atLine line (U.fromList <$> traverse (index count) rest)
        let more = [Passed "texture coordinates and normals of faces" | any (Char8.elem '/') rest]
        walk
          `seq` go
            (Found count points ((line {lineWords = []}, walk) : faces) (adding more passed))
            others
      word : _ ->
        go (Found count points faces (adding [Passed ("lines of " ++ shown word)] passed)) others
      [] -> go (Found count points faces passed) others
    adding more passed = foldr Set.insert passed more
    shown = map printable . Char8.unpack . Char8.take 20
    printable c = if c > ' ' && c <= '~' then c else '?'
    -- Negative numbers count back from the vertices read so far.
    index count word = do
      i <- whole (Char8.takeWhile (/= '/') word)
      let place = if i > 0 then i - 1 else count + i
      if i == 0 || place < 0 then Left (NoSuchVertex (toInteger i) count) else Right place
    known count (line, walk) = case U.find (>= count) walk of
      Just i -> atLine line (Left (NoSuchVertex (toInteger i + 1) count))
      Nothing -> Right ()

-- | A polyhedron as an OBJ file.
writeObj :: Mesh -> Written Builder.Builder
writeObj it = texts {writtenBytes = vertices <> faces}
  where
    texts = asDecimals it
    vertices = foldMap (textLine . ("v" :)) (writtenBytes texts)
    faces = foldMap (\walk -> textLine ("f" : map (show . (+ 1)) (U.toList walk))) (meshWalks it)
