{-# LANGUAGE OverloadedStrings #-}

-- | Files of the 3D Manufacturing Format (3MF Consortium, core specification 1.3): a zip archive
-- with a model in XML, a list of the archive's file types, and the model's path.
module PraTactile.Format.Solid.ThreeMf
  ( writeThreeMf,
  )
where

import Codec.Archive.Zip
import qualified Data.ByteString.Builder as Builder
import Data.Char (ord)
import PraTactile.Format.Solid.Contents
import PraTactile.Format.Solid.Stl (allTriangles)
import PraTactile.Object.Description (objectText)
import PraTactile.Object.Mesh

-- | A polyhedron as a 3MF file of its triangles. Coordinates are decimal numbers of millimetres,
-- exact if possible. Equal polyhedra give equal bytes.
writeThreeMf :: Mesh -> Written Builder.Builder
writeThreeMf it = written {writtenBytes = archived (writtenBytes written)}
  where
    written = model it

archived :: Builder.Builder -> Builder.Builder
archived it =
  Builder.lazyByteString . fromArchive $
    foldr
      (addEntryToArchive . entry)
      emptyArchive
      [("[Content_Types].xml", contentTypes), ("_rels/.rels", relations), (modelPath, it)]
  where
    -- The earliest time that the archive can store.
    entry (path, text) = toEntry path 315532800 (Builder.toLazyByteString (declaration <> text))

modelPath :: FilePath
modelPath = "3D/3dmodel.model"

declaration :: Builder.Builder
declaration = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"

-- | The file types of the archive, by extension.
contentTypes :: Builder.Builder
contentTypes =
  "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\n\
  \<Default Extension=\"rels\" \
  \ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\n\
  \<Default Extension=\"model\" \
  \ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>\n\
  \</Types>\n"

-- | The model's path.
relations :: Builder.Builder
relations =
  "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\n\
  \<Relationship Id=\"rel0\" \
  \Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\" Target=\"/"
    <> Builder.string7 modelPath
    <> "\"/>\n</Relationships>\n"

-- | The polyhedron as the only object of a model.
model :: Mesh -> Written Builder.Builder
model it = texts {writtenBytes = beginning <> vertices <> middle <> triangles <> end}
  where
    texts = asDecimals it
    beginning =
      "<model unit=\"millimeter\" xml:lang=\"en-US\" \
      \xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n\
      \<resources><object id=\"1\" type=\"model\" name=\""
        <> foldMap escaped (objectText (meshName it))
        <> "\"><mesh>\n<vertices>\n"
    vertices = foldMap (element "vertex" . zip ["x", "y", "z"]) (writtenBytes texts)
    middle = "</vertices>\n<triangles>\n"
    triangles = foldMap (element "triangle" . zip ["v1", "v2", "v3"] . map show) (allTriangles it)
    end =
      "</triangles>\n</mesh></object></resources>\n\
      \<build><item objectid=\"1\"/></build>\n</model>\n"

-- | An empty element with these attributes, on a line.
element :: Builder.Builder -> [(Builder.Builder, String)] -> Builder.Builder
element name attributes =
  "<" <> name <> foldMap attribute attributes <> "/>\n"
  where
    attribute (key, text) = " " <> key <> "=\"" <> Builder.string7 text <> "\""

-- | A character of an attribute. Characters that XML 1.0 does not have become @?@.
escaped :: Char -> Builder.Builder
escaped c = case c of
  '&' -> "&amp;"
  '<' -> "&lt;"
  '"' -> "&quot;"
  _
    | has (ord c) -> Builder.charUtf8 c
    | otherwise -> Builder.char7 '?'
  where
    has k = k >= 0x20 && (k < 0xD800 || k > 0xDFFF) && k /= 0xFFFE && k /= 0xFFFF
