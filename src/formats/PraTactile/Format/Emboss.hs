{-# LANGUAGE OverloadedStrings #-}

-- | The JSON of @emboss@.
module PraTactile.Format.Emboss
  ( MadeFile (..),
    volumeText,
    encodeEmbossed,
  )
where

import Data.Aeson (Value, object, (.=))
import Data.ByteString (ByteString)
import PraTactile.Emboss (Volume (..))
import PraTactile.Format.Json
import PraTactile.Format.Solid (exactText)
import PraTactile.Object.WingedEdge

-- | A file that was written. Fields that a drawing does not have are 'Nothing'.
data MadeFile = MadeFile
  { madeFile :: FilePath,
    madeObject :: ObjectName,
    -- | for a plate or a drawing
    madeFace :: Maybe FaceName,
    madeVertices :: Maybe Int,
    madeTriangles :: Maybe Int,
    -- | before coordinates were rounded
    madeVolume :: Maybe Volume,
    -- | the number of raised taxels
    madeTaxels :: Int,
    -- | the width of the narrowest raised stroke along a row or a column, millimetres
    madeStroke :: Rational,
    -- | the height of the relief, millimetres
    madeHeight :: Maybe Rational,
    -- | the greatest change of a coordinate by rounding, millimetres
    madeMostRounded :: Double
  }

-- | The exact text of a volume in cubic millimetres: a fraction, and a square root if there is one.
--
-- >>> map volumeText [Volume 31.75 0, Volume (1 / 3) 2]
-- ["31.75","1/3+sqrt(2)"]
volumeText :: Volume -> String
volumeText (Volume r s)
  | s == 0 = exactText r
  | otherwise = exactText r ++ "+sqrt(" ++ exactText s ++ ")"

-- | The files as one line, without its line end.
encodeEmbossed :: [MadeFile] -> ByteString
encodeEmbossed files = encodeSchema "emboss/1" ("files" .= map fileValue files)

fileValue :: MadeFile -> Value
fileValue made =
  object
    [ "file" .= madeFile made,
      "object" .= objectText (madeObject made),
      "face" .= fmap (map vertexText . faceVertices) (madeFace made),
      "vertices" .= madeVertices made,
      "triangles" .= madeTriangles made,
      "volume_mm3" .= fmap volumeText (madeVolume made),
      "raised_taxels" .= madeTaxels made,
      "stroke_mm" .= double (madeStroke made),
      "height_mm" .= fmap double (madeHeight made),
      "most_rounded_mm" .= madeMostRounded made
    ]
  where
    double = fromRational :: Rational -> Double
