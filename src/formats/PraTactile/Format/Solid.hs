-- | Files of polyhedra, of all formats, as pure functions on bytes.
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

-- | The formats. What is read of STL and PLY may be of either kind; written is the one named.
data SolidFormat = Off | Obj | Stl | StlText | Ply | PlyText | Json
  deriving stock (Eq, Show, Enum, Bounded)

-- | What the format is called.
formatName :: SolidFormat -> String
formatName format = case format of
  Off -> "off"
  Obj -> "obj"
  Stl -> "stl"
  StlText -> "stl-ascii"
  Ply -> "ply"
  PlyText -> "ply-ascii"
  Json -> "json"

-- | The format of this name.
formatOfName :: String -> Maybe SolidFormat
formatOfName name = find ((== name) . formatName) [minBound ..]

-- | The format that a file's end tells.
--
-- >>> formatOfFile "part.STL"
-- Just Stl
formatOfFile :: FilePath -> Maybe SolidFormat
formatOfFile file =
  find
    (\format -> ('.' : formatName format) `isSuffixOf` map toLower file)
    [minBound ..]

-- | The polyhedron that the bytes are in a format; it has this name unless it says its own. Linear
-- in the length, but for STL, O(n log n).
readSolid :: SolidFormat -> ObjectName -> ByteString -> Either SolidFileError Contents
readSolid format name = case format of
  Off -> plain >=> readOff name
  Obj -> plain >=> readObj name
  Stl -> readStl name
  StlText -> readStl name
  Ply -> readPly name
  PlyText -> readPly name
  Json -> readObject

-- | The bytes of a polyhedron in a format.
writeSolid :: SolidFormat -> Mesh -> Written Builder.Builder
writeSolid format it = case format of
  Off -> writeOff it
  Obj -> writeObj it
  Stl -> writeStlBinary it
  StlText -> writeStlText it
  Ply -> writePlyBinary it
  PlyText -> writePlyText it
  Json -> Written (Builder.byteString (writeObject it) <> Builder.char7 '\n') 0
