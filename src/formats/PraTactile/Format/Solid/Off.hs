{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The Object File Format of Geomview, as text, in millimetres. After the word @OFF@, on its line
-- or the next, come the numbers of vertices, faces and edges. Then there is one line per vertex and
-- one line per face: the number of its vertices and their indices, from 0.
module PraTactile.Format.Solid.Off
  ( readOff,
    writeOff,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as Char8
import Data.Char (isDigit)
import Data.List (find)
import Data.Maybe (mapMaybe)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Format.Solid.Contents
import PraTactile.Format.Solid.Error
import PraTactile.Format.Solid.Number
import PraTactile.Format.Solid.Text
import PraTactile.Object.Description (ObjectName)
import PraTactile.Object.Mesh

-- | Reads the polyhedron of an OFF file; the first argument becomes its name. Equal points become
-- one vertex. Text after @#@, lines after the last face, colours, normals and texture coordinates
-- are ignored. Whether the faces form a solid is not checked.
--
-- Refuses, with the line, a first word other than @OFF@ and its variants (such as @COFF@), a
-- missing number, a word that is not a number, and a vertex of a face that does not exist.
readOff :: ObjectName -> ByteString -> Either SolidFileError Contents
readOff name bytes = do
  (counts, after) <- header (linesOf bytes)
  (vertexTotal, faceTotal) <-
    atLine
      counts
      ( case lineWords counts of
          v : f : _ -> (,) <$> natural v <*> natural f
          _ -> Left (Needed "the numbers of vertices, faces and edges")
      )
  (points, further) <- taking "vertices" vertexTotal (numbers . lineWords) after
  (walks, _) <- taking "faces" faceTotal (walkOf (length points)) further
  let beside =
        [Passed "what follows the coordinates of vertices" | long vertexTotal 3 after]
          ++ [Passed "colours of faces" | any coloured (take faceTotal further)]
  Right (contents name Decimal beside (V.fromList points) (V.fromList walks))
  where
    end = SolidFileError (AtLine (length (Char8.split '\n' bytes)))
    header given = case given of
      line@(Line at (word : after)) : others
        | Just glued <- headerWord word,
          let rest = [glued | not (Char8.null glued)] ++ after ->
          if null rest
            then case others of
              next : further -> Right (next, further)
              [] -> Left (end (Ends "the numbers of vertices and faces"))
            else Right (Line at rest, others)
        | otherwise -> Left (SolidFileError (AtLine (lineNumber line)) (Needed "the word OFF"))
      _ -> Left (end (Ends "the word OFF"))
    -- The rest of the word OFF: empty, or the number of vertices, as in OFF216 of ModelNet.
    headerWord word =
      find
        (maybe True (isDigit . fst) . Char8.uncons)
        (mapMaybe (`Char8.stripPrefix` word) headerWords)
    headerWords = ["OFF", "COFF", "NOFF", "CNOFF", "STOFF", "STCOFF", "STNOFF", "STCNOFF"]
    natural word = do
      n <- whole word
      if n < 0 then Left NotNumber else Right n
    -- The given number of lines, each read by the function. The text names what they are.
    taking what count one given = go (0 :: Int) [] given
      where
        go n found left
          | n == count = Right (reverse found, left)
          | otherwise = case left of
            line : others -> do
              value <- atLine line (one line)
              value `seq` go (n + 1) (value : found) others
            [] -> Left (end (Ends (show (count - n) ++ " of its " ++ show count ++ " " ++ what)))
    walkOf vertices line = case lineWords line of
      [] -> Left (Needed "a face")
      size : rest -> do
        k <- natural size
        let own = take k rest
        if length own < k
          then Left (Needed (show k ++ " vertices"))
          else U.fromList <$> traverse (index vertices) own
    index vertices word = do
      i <- whole word
      if i < 0 || i >= vertices then Left (NoSuchVertex (toInteger i) vertices) else Right i
    long count size = any ((> size) . length . lineWords) . take count
    coloured line = case lineWords line of
      size : rest | Right k <- whole size -> not (null (drop k rest))
      _ -> False

-- | A polyhedron as an OFF file.
writeOff :: Mesh -> Written Builder.Builder
writeOff it = texts {writtenBytes = header <> vertices <> faces}
  where
    texts = asDecimals it
    header =
      "OFF\n" <> textLine (map show [V.length (meshPoints it), V.length (meshWalks it), 0])
    vertices = foldMap textLine (writtenBytes texts)
    faces = foldMap (\walk -> textLine (map show (U.length walk : U.toList walk))) (meshWalks it)
