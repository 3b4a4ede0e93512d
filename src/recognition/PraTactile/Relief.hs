-- | What is embossed: the height map of an object's face, from the array, the placement and the
-- shapes of the symbols (the paper's section II.B, figures 7 and 9).
module PraTactile.Relief
  ( -- * The relief of a face
    relief,
    reliefOf,

    -- * The symbols of a face
    faceClasses,

    -- * What is refused
    ReliefError (..),
  )
where

import Data.Bifunctor (first)
import qualified Data.Map.Strict as Map
import Data.Ratio (denominator, numerator)
import PraTactile.Array (Position (..), PseudorandomArray, Shape (..), cellAt, naturalsBelow)
import PraTactile.Field (KnownField)
import PraTactile.Geometry (symbolHeight, symbolThickness, symbolWidth, taxelPitch)
import PraTactile.Image (generate)
import PraTactile.Object.Placement
import PraTactile.Sensor (HeightMap (..))
import PraTactile.Shape (Alphabet, ShapeError, embossedAt, shapeOf)
import PraTactile.Symbol (classOfElement)

-- | Why a face has no relief.
data ReliefError
  = -- | The array has an element for which the alphabet has no shape.
    NoShape ShapeError
  | -- | A length of the face (millimetres) is no whole number of taxels, so that the height map's
    -- cells would cut through symbols.
    OffTaxelGrid Rational
  | -- | The cell of the array is smaller than a symbol, in taxels.
    CellTooSmall Int Int
  deriving stock (Eq, Show)

-- | The classes embossed on a face, row by row as seen from outside, its grid's shape.
faceClasses :: KnownField k => PseudorandomArray k -> LaidFace -> [[Int]]
faceClasses array face =
  [ [ classOfElement (cellAt array (Position (row (laidAt face) + i) (column (laidAt face) + j)))
      | j <- naturalsBelow (columns (laidGrid face))
    ]
    | i <- naturalsBelow (rows (laidGrid face))
  ]

-- | The height map of a face, in millimetres, in cells of one taxel: each symbol lies in the middle
-- of its cell, and the grid of cells in the middle of the face. Refuses an element without a shape,
-- and lengths that are no whole number of taxels.
relief ::
  KnownField k =>
  PseudorandomArray k ->
  Placement ->
  Alphabet ->
  LaidFace ->
  Either ReliefError HeightMap
relief array layout alphabet face = reliefOf layout alphabet face (faceClasses array face)

-- | The same of any classes, row by row as seen from outside.
reliefOf :: Placement -> Alphabet -> LaidFace -> [[Int]] -> Either ReliefError HeightMap
reliefOf layout alphabet face classes = do
  width <- taxels (spotRight (laidExtent face))
  height <- taxels (spotDown (laidExtent face))
  left <- taxels (spotRight (laidMargin face))
  top <- taxels (spotDown (laidMargin face))
  across <- taxels (pitchRight (placementPitch layout))
  down <- taxels (pitchDown (placementPitch layout))
  if across < symbolWidth || down < symbolHeight then Left (CellTooSmall across down) else pure ()
  bitmaps <- traverse (traverse (first NoShape . shapeOf alphabet)) classes
  let laid =
        Map.fromList
          [ ((i, j), bitmap)
            | (i, line) <- zip [0 :: Int ..] bitmaps,
              (j, bitmap) <- zip [0 :: Int ..] line
          ]
      embossed x y =
        let (j, u) = (x - left) `divMod` across
            (i, v) = (y - top) `divMod` down
         in case Map.lookup (i, j) laid of
              Just bitmap ->
                embossedAt
                  bitmap
                  (u - (across - symbolWidth) `div` 2)
                  (v - (down - symbolHeight) `div` 2)
              Nothing -> False
  pure
    HeightMap
      { heightPitch = taxelPitch,
        heightValues = generate width height (\x y -> if embossed x y then symbolThickness else 0)
      }

-- | Millimetres to whole taxels.
taxels :: Rational -> Either ReliefError Int
taxels millimetres
  | denominator count == 1 = Right (fromInteger (numerator count))
  | otherwise = Left (OffTaxelGrid millimetres)
  where
    count = millimetres / taxelPitch
