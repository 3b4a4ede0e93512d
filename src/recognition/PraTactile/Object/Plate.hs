{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Any array as a flat plate, whose upper face carries the whole array.
module PraTactile.Object.Plate
  ( plateName,
    plateSize,
    platePlacement,
  )
where

import Data.Bifunctor (first)
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Object.Canonical (canonicalPitch)
import PraTactile.Object.Named (Named (..), namedDescription)
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge

-- | The name of the plate's object.
plateName :: ObjectName
plateName = "sheet"

-- | The width and depth in millimetres of the plate for an array of this shape and pitch.
plateSize :: Shape -> Pitch -> (Rational, Rational)
plateSize shape (Pitch right down) =
  (right * fromIntegral (columns shape), down * fromIntegral (rows shape))

-- | The array of this shape on the upper face S1 S2 S3 S4 of a box 25.4 mm thick. Cell (0, 0) lies
-- in the corner S1, and the face is as large as all cells together. Refuses an array without cells.
-- O(rows).
--
-- >      S1 ---------- S4
-- >     /            /  |
-- >   S2 ---------- S3  |
-- >    |            |   S8
-- >   S6 ---------- S7
platePlacement :: Shape -> Either PlacementError Placement
platePlacement shape
  | rows shape == 0 || columns shape == 0 = Left (EmptyArray shape)
  | otherwise = do
    plate <- first BrokenObject (solid (namedDescription (uncurry Sheet size)))
    placement shape canonicalPitch [plate] [laidWhole upper (Position 0 0) shape]
  where
    size = plateSize shape canonicalPitch
    upper = Face plateName (readFaceName "S1 S2 S3 S4")
