-- | What is embossed: the height map of an object's face, from the array, the placement and the
-- shapes of the symbols (the paper's section II.B, figures 7 and 9). Its lengths are those of a
-- placement whose symbols have the paper's size: of one with symbols s times as large, all lengths
-- are divided by s ('symbolScale').
module PraTactile.Relief
  ( -- * The size of symbols
    symbolScale,

    -- * The relief of a face
    Relief (..),
    relief,
    reliefOf,
    onRelief,

    -- * The symbols of a face
    faceClasses,

    -- * What is refused
    ReliefError (..),
  )
where

import Data.Bifunctor (first)
import qualified Data.Map.Strict as Map
import PraTactile.Array (Position (..), PseudorandomArray, Shape (..), cellAt, naturalsBelow)
import PraTactile.Explore (Region (..), insidePolygon)
import PraTactile.Field (KnownField)
import PraTactile.Geometry
  ( columnPitch,
    rowPitch,
    symbolHeight,
    symbolThickness,
    symbolWidth,
    taxelPitch,
  )
import PraTactile.Image (generate)
import PraTactile.Object.Canonical (canonicalPitch)
import PraTactile.Object.Placement
import PraTactile.Sensor (HeightMap (..))
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

-- | The heights of a face, and where on the face the height map begins: millimetres right of and
-- below the face's first vertex, of symbols of the paper's size.
data Relief = Relief
  { reliefHeights :: HeightMap,
    reliefOrigin :: (Double, Double)
  }
  deriving stock (Eq, Show)

-- | A region of the face as one of the height map.
onRelief :: Relief -> Region -> Region
onRelief (Relief _ (x, y)) region =
  region
    { regionRight = regionRight region - x / taxelPitch,
      regionDown = regionDown region - y / taxelPitch
    }

-- | The classes that the array has on a face's block, row by row as seen from outside; those of
-- cells that the face has are embossed on it.
faceClasses :: KnownField k => PseudorandomArray k -> LaidFace -> [[Int]]
faceClasses array face =
  [ [ classOfElement (cellAt array (Position (row (laidAt face) + i) (column (laidAt face) + j)))
      | j <- naturalsBelow (columns (laidGrid face))
    ]
    | i <- naturalsBelow (rows (laidGrid face))
  ]

-- | The height map of a face, in cells of one taxel: each symbol lies in the middle of its cell.
-- Beyond the face there is nothing to touch. Refuses an element without a shape, and distances of
-- symbols that are not the paper's times a factor.
relief ::
  KnownField k =>
  PseudorandomArray k ->
  Placement ->
  Alphabet ->
  LaidFace ->
  Either ReliefError Relief
relief array layout alphabet face = reliefOf layout alphabet face (faceClasses array face)

-- | The same of any classes, row by row of the face's block as seen from outside.
reliefOf :: Placement -> Alphabet -> LaidFace -> [[Int]] -> Either ReliefError Relief
reliefOf layout alphabet face classes = do
  scale <- maybe (Left (PitchNotFelt pitch)) (Right . fromRational) (symbolScale pitch)
  bitmaps <- traverse (traverse (first NoShape . shapeOf alphabet)) classes
  let laid =
        Map.fromList
          [ ((i, j), bitmap)
            | (i, line) <- zip [0 :: Int ..] bitmaps,
              (j, bitmap) <- zip [0 :: Int ..] line,
              hasCell (laidBlock face) (Position (fromIntegral i) (fromIntegral j))
          ]
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
      embossed x y =
        let (j, u) = (x - across) `divMod` columnPitch
            (i, v) = (y - down) `divMod` rowPitch
         in case Map.lookup (i, j) laid of
              Just bitmap ->
                embossedAt
                  bitmap
                  (u - (columnPitch - symbolWidth) `div` 2)
                  (v - (rowPitch - symbolHeight) `div` 2)
              Nothing -> False
      inside = insidePolygon (map (taxels . snd) (laidCorners face))
      middle origin k = origin + fromIntegral k + 0.5
      height x y
        | not (inside (middle originX x, middle originY y)) = 0 / 0
        | embossed x y = symbolThickness
        | otherwise = 0
  pure
    Relief
      { reliefHeights =
          HeightMap
            { heightPitch = taxelPitch,
              heightValues =
                generate (reach boxLeft wide originX) (reach boxTop high originY) height
            },
        reliefOrigin = (originX * taxelPitch, originY * taxelPitch)
      }
  where
    pitch = placementPitch layout
    tiny = 1e-9
