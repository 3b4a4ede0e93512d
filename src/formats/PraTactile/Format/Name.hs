-- | The names of conventions in all texts: on the command line, in JSON and in CSV.
module PraTactile.Format.Name
  ( surfaceName,
    foldingName,
    layoutName,
    readingName,
    packingName,
    differenceName,
    shapeText,
  )
where

import PraTactile.Advise (Layout (..))
import PraTactile.Array (Folding (..), Shape (..), Surface (..))
import PraTactile.Profile (Reading (..))
import PraTactile.Truth (Difference (..))
import PraTactile.Window (Packing (..))

-- | The name of a surface.
surfaceName :: Surface -> String
surfaceName surface = case surface of
  Torus -> "torus"
  TwistedTorus -> "twisted-torus"
  Sheet -> "sheet"

-- | The name of a folding.
foldingName :: Folding -> String
foldingName folding = case folding of
  Diagonal -> "diagonal"
  RowMajor -> "row-major"

-- | The name of a layout: its folding's, or that of several arrays with common windows.
layoutName :: Layout -> String
layoutName layout = case layout of
  Single folding -> foldingName folding
  Joint _ -> "joint"

-- | The name of how a profile's polynomial is read.
readingName :: Reading -> String
readingName reading = case reading of
  Characteristic -> "characteristic"
  Reciprocal -> "reciprocal"

-- | The name of a packing.
packingName :: Packing -> String
packingName packing = case packing of
  MostSignificantFirst -> "most-significant-first"
  LeastSignificantFirst -> "least-significant-first"

-- | The name of a difference between an answer and the truth.
differenceName :: Difference -> String
differenceName difference = case difference of
  OtherFace -> "other-face"
  OtherWayUp -> "other-orientation"
  Elsewhere _ -> "elsewhere"

-- | A shape as rows x columns.
--
-- >>> shapeText (Shape 15 17)
-- "15x17"
shapeText :: Shape -> String
shapeText (Shape high wide) = show high ++ "x" ++ show wide
