-- | What is embossed: the height map of an object's face, from the array, the placement and the
-- shapes of the symbols (the paper's section II.B, figures 7 and 9). Its lengths are those of a
-- placement whose symbols have the paper's size: of one with symbols s times as large, all lengths
-- are divided by s ('symbolScale').
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
import PraTactile.Explore (Region (..), insidePolygon, regionMotion)
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
  | -- | The distances between symbols are not those of the paper times one factor, so that symbols
    -- cannot be felt.
    PitchNotFelt Pitch
  deriving stock (Eq, Show)

-- | How much larger than the paper's the symbols are, where both distances between them are as much
-- larger.
--
-- >>> symbolScale (Pitch 12.7 15.875)
-- Just (1 % 2)
symbolScale :: Pitch -> Maybe Rational
symbolScale (Pitch right down)
  | right * pitchDown canonicalPitch == down * pitchRight canonicalPitch =
    Just (right / pitchRight canonicalPitch)
  | otherwise = Nothing

-- | The side of a taxel of the symbols, millimetres.
--
-- >>> symbolTaxel (Pitch 12.7 15.875)
-- 0.79375
symbolTaxel :: Pitch -> Double
symbolTaxel between = fromRational (pitchRight between / columnPitch)

-- | The heights of a face, of which only what is asked for is made.
data Relief = Relief
  { -- | where its first taxel begins: millimetres right of and below the face's first vertex, of
    -- symbols of the paper's size
    reliefOrigin :: (Double, Double),
    -- | how many taxels it has to the right and down
    reliefSize :: (Int, Int),
    -- | in how many cells each side of a taxel is cut, on which heights are constant
    reliefFineness :: Int,
    -- | the heights, in millimetres, of so many columns and rows of cells from a first one on; not
    -- a number beyond the face
    reliefDrawn :: (Int, Int) -> (Int, Int) -> Raster,
    -- | the cylinder that the face is wrapped on, if any; it is told unrolled
    reliefBend :: Maybe Bend
  }

-- | All of it.
reliefHeights :: Relief -> HeightMap
reliefHeights whole =
  HeightMap (cellSide whole) (0, 0) (reliefDrawn whole (0, 0) (cellCount whole)) (reliefBend whole)

-- | The side of a cell, millimetres.
cellSide :: Relief -> Double
cellSide whole = taxelPitch / fromIntegral (reliefFineness whole)

-- | How many cells it has to the right and down.
cellCount :: Relief -> (Int, Int)
cellCount whole = (reliefFineness whole * wide, reliefFineness whole * high)
  where
    (wide, high) = reliefSize whole

-- | As much of it as presses of a sensor may feel that cover a region of the face. O(taxels of the
-- region and round it).
heightsUnder :: Sensor -> Region -> Relief -> HeightMap
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
    -- The robot means the sensor's centre to be within the region. Round a cylinder it is at most
    -- half a circle to where a chord ends.
    reach = sensorReach sensor * maybe 1 (const (pi / 2)) (reliefBend whole)
    reached size along =
      ( clipped (floor ((minimum along - reach) / cellSide whole)),
        clipped (ceiling ((maximum along + reach) / cellSide whole))
      )
      where
        clipped k = max 0 (min size k)

-- | A region of the face as one of the height map.
onRelief :: Relief -> Region -> Region
onRelief whole region =
  region
    { regionRight = regionRight region - x / taxelPitch,
      regionDown = regionDown region - y / taxelPitch
    }
  where
    (x, y) = reliefOrigin whole

-- | The class that the array has in a cell of a face's block, by row and column as seen from
-- outside; in those that the face has it is embossed.
classOn :: KnownField k => PseudorandomArray k -> LaidFace -> Position -> Int
classOn array face (Position i j) =
  classOfElement (cellAt array (Position (row (laidAt face) + i) (column (laidAt face) + j)))

-- | The relief of a face, in cells of one taxel: each symbol lies in the middle of its cell.
-- Beyond the face there is nothing to touch. Refuses an element without a shape, and distances of
-- symbols that are not the paper's times a factor.
relief ::
  KnownField k =>
  PseudorandomArray k ->
  Placement ->
  Alphabet ->
  LaidFace ->
  Either ReliefError Relief
relief array layout alphabet face =
  reliefOf layout alphabet face (fieldOrder array) (classOn array face)

-- | The same of any classes, below a number, by row and column within the face's block.
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
          -- The symbols of the cells that are met.
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

-- | The relief of a face, of symbols of the paper's size, that has the height of its middle all
-- over a cell, so many cells along each side of a taxel: what the function says of a place so many
-- millimetres to the right of and below the face's first vertex, nothing where there is nothing.
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

-- | The taxels of a face: its spots in taxels, how many lie before its block to the right and down,
-- where the first of them begins, in taxels from the face's first vertex, and how many there are.
data Ground = Ground (Spot -> (Double, Double)) (Int, Int) (Double, Double) (Int, Int)

-- | Those of a face whose symbols are so many times as large as the paper's.
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
    -- Whole taxels before the block, as many as the face has room for or one more.
    before from at = ceiling (at - from - tiny) :: Int
    (across, down) = (before boxLeft left, before boxTop top)
    (originX, originY) = (left - fromIntegral across, top - fromIntegral down)
    reach from size origin = ceiling (from + size - origin - tiny)
    tiny = 1e-9 :: Double
