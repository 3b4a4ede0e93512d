-- | Files of polyhedra in all formats, as pure functions on bytes.
module PraTactile.Format.Solid
  ( -- * Formats
    SolidFormat (..),
    formatName,
    formatOfName,
    formatOfFile,

    -- * Reading
    readSolid,
    Contents (..),
    Passed (..),
    SolidFileError (..),
    Place (..),
    Fault (..),

    -- * Writing
    writeSolid,
    Written (..),

    -- * Exact numbers
    exactText,
  )
where

import Control.Monad ((>=>))
import Data.ByteString (ByteString)
import qualified Data.ByteString.Builder as Builder
import Data.Char (toLower)
import Data.List (find, isSuffixOf)
import PraTactile.Format.Solid.Contents
import PraTactile.Format.Solid.Error
import PraTactile.Format.Solid.Json (readObject, writeObject)
import PraTactile.Format.Solid.Number (exactText)
import PraTactile.Format.Solid.Obj
import PraTactile.Format.Solid.Off
import PraTactile.Format.Solid.Ply
import PraTactile.Format.Solid.Stl
import PraTactile.Format.Solid.Text (plain)
import PraTactile.Object.Description (ObjectName)
import PraTactile.Object.Mesh (Mesh)

-- | The formats. Reading STL and PLY accepts text and binary files; writing uses the named kind.
data SolidFormat = Off | Obj | Stl | StlText | Ply | PlyText | Json
  deriving stock (Eq, Show, Enum, Bounded)

-- | The name of a format.
formatName :: SolidFormat -> String
formatName format = case format of
  Off -> "off"
  Obj -> "obj"
  Stl -> "stl"
  StlText -> "stl-ascii"
  Ply -> "ply"
  PlyText -> "ply-ascii"
  Json -> "json"

-- | The format with this name.
formatOfName :: String -> Maybe SolidFormat
formatOfName name = find ((== name) . formatName) [minBound ..]

-- | The format for a file's extension, in capitals or not; 'Nothing' for another extension.
--
-- >>> formatOfFile "part.STL"
-- Just Stl
formatOfFile :: FilePath -> Maybe SolidFormat
formatOfFile file =
  find
    (\format -> ('.' : formatName format) `isSuffixOf` map toLower file)
    [minBound ..]

-- | Reads a polyhedron of this format. The name is that of the object, but for JSON, which has its
-- own. Refuses what is not of the format. O(n) in the length; for STL O(n log n).
readSolid :: SolidFormat -> ObjectName -> ByteString -> Either SolidFileError Contents
readSolid format name = case format of
  Off -> plain >=> readOff name
  Obj -> plain >=> readObj name
  Stl -> readStl name
  StlText -> readStl name
  Ply -> readPly name
  PlyText -> readPly name
  Json -> readObject

-- | Writes a polyhedron in a format.
writeSolid :: SolidFormat -> Mesh -> Written Builder.Builder
writeSolid format it = case format of
  Off -> writeOff it
  Obj -> writeObj it
  Stl -> writeStlBinary it
  StlText -> writeStlText it
  Ply -> writePlyBinary it
  PlyText -> writePlyText it
  Json -> Written (Builder.byteString (writeObject it) <> Builder.char7 '\n') 0
