-- | The height map of an object's face, from the array, the placement and the shapes of the symbols
-- (the paper's section II.B, figures 7 and 9). Lengths are those of symbols of the paper's size: if
-- a placement's symbols are s times as large, all its lengths are divided by s ('symbolScale').
module PraTactile.Relief
  ( -- * The size of symbols
    symbolScale,
    symbolTaxel,

    -- * The relief of a face
    Relief (..),
    relief,
    reliefOf,
    reliefByHeights,
    reliefHeights,
    heightsUnder,
    onRelief,

    -- * The symbols of a face
    classOn,

    -- * What is refused
    ReliefError (..),
  )
where

import Control.Monad (join)
import Data.Bifunctor (first)
import Data.Maybe (fromMaybe)
import qualified Data.Vector as Boxed
import PraTactile.Array (Position (..), PseudorandomArray, cellAt)
import PraTactile.Explore (ProbedRegion (..), insidePolygon, regionMotion)
import PraTactile.Field (KnownField, fieldOrder)
import PraTactile.Geometry
  ( columnPitch,
    rowPitch,
    symbolHeight,
    symbolThickness,
    symbolWidth,
    taxelPitch,
  )
import PraTactile.Image (Raster, generate)
import PraTactile.Object.Canonical (canonicalPitch)
import PraTactile.Object.Placement
import PraTactile.Sensor (Bend, HeightMap (..), Sensor, sensorReach)
import PraTactile.Sensor.Frame (movePoint)
import PraTactile.Shape (Alphabet, ShapeError, embossedAt, shapeOf)
import PraTactile.Symbol (classOfElement)

-- | Why a face has no relief.
data ReliefError
  = -- | The array has an element for which the alphabet has no shape.
    NoShape ShapeError
  | -- | The pitch is not the paper's times one factor, so the symbols cannot be felt.
    PitchNotFelt Pitch
  deriving stock (Eq, Show)

-- | The size of a placement's symbols relative to the paper's. 'Nothing' if the two distances of
-- the pitch do not have the same ratio to the paper's.
--
-- >>> symbolScale (Pitch 12.7 15.875)
-- Just (1 % 2)
symbolScale :: Pitch -> Maybe Rational
symbolScale (Pitch right down)
  | right * pitchDown canonicalPitch == down * pitchRight canonicalPitch =
    Just (right / pitchRight canonicalPitch)
  | otherwise = Nothing

-- | The side, in millimetres, of a taxel of symbols with these distances: an eighth of a symbol's
-- width.
--
-- >>> symbolTaxel (Pitch 12.7 15.875)
-- 0.79375
symbolTaxel :: Pitch -> Double
symbolTaxel between = fromRational (pitchRight between / columnPitch)

-- | The heights of a face. Only the parts asked for are computed.
data Relief = Relief
  { -- | where the first taxel begins: millimetres right of and below the face's first vertex, for
    -- symbols of the paper's size
    reliefOrigin :: (Double, Double),
    -- | the number of taxels to the right and down
    reliefSize :: (Int, Int),
    -- | the number of cells along each side of a taxel; the height is constant within a cell
    reliefFineness :: Int,
    -- | the heights in millimetres of a rectangle of cells; NaN beyond the face. Arguments: the
    -- column and row of its first cell; its numbers of columns and rows
    reliefDrawn :: (Int, Int) -> (Int, Int) -> Raster,
    -- | the cylinder that the face is wrapped on, if any; the heights are those of the unrolled
    -- face
    reliefBend :: Maybe Bend
  }

-- | The heights of a whole face.
reliefHeights :: Relief -> HeightMap
reliefHeights whole =
  HeightMap (cellSide whole) (0, 0) (reliefDrawn whole (0, 0) (cellCount whole)) (reliefBend whole)

-- | The side of a cell, millimetres.
cellSide :: Relief -> Double
cellSide whole = taxelPitch / fromIntegral (reliefFineness whole)

-- | The number of cells to the right and down.
cellCount :: Relief -> (Int, Int)
cellCount whole = (reliefFineness whole * wide, reliefFineness whole * high)
  where
    (wide, high) = reliefSize whole

-- | The part of a face's heights that presses of a sensor on a region may feel. O(taxels of the
-- region and its surroundings).
heightsUnder :: Sensor -> ProbedRegion -> Relief -> HeightMap
heightsUnder sensor region whole =
  HeightMap
    (cellSide whole)
    (left, top)
    (reliefDrawn whole (left, top) (right' - left, bottom - top))
    (reliefBend whole)
  where
    (left, right') = reached (fst (cellCount whole)) (map fst corners)
    (top, bottom) = reached (snd (cellCount whole)) (map snd corners)
    corners =
      [ movePoint (regionMotion (onRelief whole region)) (x, y)
        | x <- [0, taxelPitch * fromIntegral (regionWidth region)],
          y <- [0, taxelPitch * fromIntegral (regionHeight region)]
      ]
    -- The sensor's centre is meant to be within the region. On a cylinder, half a circle is the
    -- furthest that the end of a chord can be.
    reach = sensorReach sensor * maybe 1 (const (pi / 2)) (reliefBend whole)
    reached size along =
      ( clipped (floor ((minimum along - reach) / cellSide whole)),
        clipped (ceiling ((maximum along + reach) / cellSide whole))
      )
      where
        clipped k = max 0 (min size k)

-- | A region of the face, in the coordinates of the height map.
onRelief :: Relief -> ProbedRegion -> ProbedRegion
onRelief whole region =
  region
    { regionRight = regionRight region - x / taxelPitch,
      regionDown = regionDown region - y / taxelPitch
    }
  where
    (x, y) = reliefOrigin whole

-- | The class that the array has in a cell of a face's block, by row and column as seen from
-- outside. It is embossed in the cells that the face has.
classOn :: KnownField k => PseudorandomArray k -> LaidFace -> Position -> Int
classOn array face (Position i j) =
  classOfElement (cellAt array (Position (row (laidAt face) + i) (column (laidAt face) + j)))

-- | The relief of a face, with cells of one taxel. Each symbol lies in the middle of its cell, and
-- beyond the face there is nothing. Refuses an element without a shape, and a pitch that is not the
-- paper's times one factor.
relief ::
  KnownField k =>
  PseudorandomArray k ->
  Placement ->
  Alphabet ->
  LaidFace ->
  Either ReliefError Relief
relief array layout alphabet face =
  reliefOf layout alphabet face (fieldOrder array) (classOn array face)

-- | 'relief' for any classes in the cells. Arguments: the placement; the alphabet; the face; the
-- number of classes; a function from the row and column in the face's block to a class below that
-- number.
reliefOf ::
  Placement -> Alphabet -> LaidFace -> Int -> (Position -> Int) -> Either ReliefError Relief
reliefOf layout alphabet face classes classAt = do
  scale <- maybe (Left (PitchNotFelt pitch)) (Right . fromRational) (symbolScale pitch)
  bitmaps <- Boxed.fromList <$> traverse (first NoShape . shapeOf alphabet) [0 .. classes - 1]
  let Ground taxels (across, down) (originX, originY) size = groundOf scale face
      bitmapIn i j
        | i >= 0 && j >= 0 && hasCell (laidBlock face) cell = bitmaps Boxed.!? classAt cell
        | otherwise = Nothing
        where
          cell = Position (fromIntegral i) (fromIntegral j)
      inside = insidePolygon (map (taxels . snd) (laidCorners face))
      middle origin k = origin + fromIntegral k + 0.5
      drawn (x0, y0) (w, h) = generate w h (\x y -> height (x0 + x) (y0 + y))
        where
          (i0, i1) = ((y0 - down) `div` rowPitch, (y0 + h - 1 - down) `div` rowPitch)
          (j0, j1) = ((x0 - across) `div` columnPitch, (x0 + w - 1 - across) `div` columnPitch)
          -- The symbols of the cells that overlap the area.
          met = Boxed.fromList [bitmapIn i j | i <- [i0 .. i1], j <- [j0 .. j1]]
          height x y
            | not (inside (middle originX x, middle originY y)) = 0 / 0
            | maybe False (\b -> embossedAt b (u - besides) (v - above)) symbol = symbolThickness
            | otherwise = 0
            where
              (j, u) = (x - across) `divMod` columnPitch
              (i, v) = (y - down) `divMod` rowPitch
              symbol = join (met Boxed.!? ((i - i0) * (j1 - j0 + 1) + j - j0))
      besides = (columnPitch - symbolWidth) `div` 2
      above = (rowPitch - symbolHeight) `div` 2
  pure
    Relief
      { reliefOrigin = (originX * taxelPitch, originY * taxelPitch),
        reliefSize = size,
        reliefFineness = 1,
        reliefDrawn = drawn,
        reliefBend = Nothing
      }
  where
    pitch = placementPitch layout

-- | The relief of a face by a function of heights, with symbols of the paper's size. Arguments: the
-- number of cells along each side of a taxel; the face; the function. It takes millimetres right of
-- and below the face's first vertex, and gives the height in millimetres, or 'Nothing' beyond the
-- face. A cell has the height of its centre.
reliefByHeights :: Int -> LaidFace -> (Double -> Double -> Maybe Double) -> Relief
reliefByHeights fineness face heightAt =
  Relief
    { reliefOrigin = (originX * taxelPitch, originY * taxelPitch),
      reliefSize = size,
      reliefFineness = fineness,
      reliefDrawn = \(x0, y0) (w, h) ->
        generate w h $ \x y ->
          fromMaybe (0 / 0) (heightAt (middle originX (x0 + x)) (middle originY (y0 + y))),
      reliefBend = Nothing
    }
  where
    Ground _ _ (originX, originY) size = groundOf 1 face
    middle origin k = taxelPitch * (origin + (fromIntegral k + 0.5) / fromIntegral fineness)

-- | The taxels of a face: a map from spots to taxels; the number of taxels before its block, to the
-- right and down; where the first taxel begins, in taxels from the face's first vertex; and the
-- number of taxels.
data Ground = Ground (Spot -> (Double, Double)) (Int, Int) (Double, Double) (Int, Int)

-- | The taxels of a face whose symbols are this many times as large as the paper's.
groundOf :: Double -> LaidFace -> Ground
groundOf scale face =
  Ground
    taxels
    (across, down)
    (originX, originY)
    (reach boxLeft wide originX, reach boxTop high originY)
  where
    taxels spot =
      let (x, y) = spotMillimetres spot in (x / scale / taxelPitch, y / scale / taxelPitch)
    (boxLeft, boxTop) = taxels (laidBox face)
    (wide, high) = taxels (laidExtent face)
    (left, top) = taxels (laidMargin face)
    -- Whole taxels before the block: as many as the face has room for, or one more.
    before from at = ceiling (at - from - tiny) :: Int
    (across, down) = (before boxLeft left, before boxTop top)
    (originX, originY) = (left - fromIntegral across, top - fromIntegral down)
    reach from size origin = ceiling (from + size - origin - tiny)
    tiny = 1e-9 :: Double
