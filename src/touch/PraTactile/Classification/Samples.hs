{-# OPTIONS_HADDOCK hide #-}

-- | Synthetic images of symbols and of impostors as the classifier meets them: slightly misplaced,
-- blurred, torn by stitching, of varying contrast, and noisy.
module PraTactile.Classification.Samples
  ( -- * What is seen
    SampleSurface,
    symbolScene,
    featureScene,
    sidewaysScene,
    besideScene,
    overScene,
    flatScene,

    -- * How it is seen
    SampleView (..),
    exactView,
    stitchedView,
    see,

    -- * What spoils it
    withNoise,
    Unseen (..),
    Corner (..),
    withUnseen,
  )
where

import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as V
import PraTactile.Image (Raster, generate, index, rasterHeight, rasterValues, rasterWidth, sample)
import PraTactile.Random (normals, uniform)
import PraTactile.Shape
import PraTactile.Shape.Distance (Feature, raises)
import System.Random (StdGen)

-- | A surface around the box of a symbol, in cells of one taxel: 0 flat, 1 embossed. Outside the
-- stored cells the surface is as in the nearest stored cell.
newtype SampleSurface = SampleSurface Raster

-- | The width of the stored surface on each side of the box, in cells.
margin :: Int
margin = 8

-- | The scene that is embossed where the function says so. The function's arguments are column and
-- row, counted from the box's upper left taxel.
sceneWhere :: (Int -> Int -> Bool) -> SampleSurface
sceneWhere f =
  SampleSurface
    ( generate
        (symbolWidth + 2 * margin)
        (symbolHeight + 2 * margin)
        (\x y -> if f (x - margin) (y - margin) then 1 else 0)
    )

-- | A shape alone on a flat face.
symbolScene :: Bitmap -> SampleSurface
symbolScene = sceneWhere . embossedAt

-- | An ordinary feature of an object, such as an edge.
featureScene :: Feature -> SampleSurface
featureScene = sceneWhere . raises

-- | A shape turned by 90 degrees clockwise about the box's centre.
sidewaysScene :: Bitmap -> SampleSurface
sidewaysScene b = sceneWhere (\x y -> embossedAt b (y - inset) (symbolHeight - 1 - (x + inset)))
  where
    inset = (symbolHeight - symbolWidth) `div` 2

-- | The left half of one shape and the right half of another.
besideScene :: Bitmap -> Bitmap -> SampleSurface
besideScene a b = sceneWhere (\x y -> embossedAt (if x < symbolWidth `div` 2 then a else b) x y)

-- | The upper half of one shape and the lower half of another.
overScene :: Bitmap -> Bitmap -> SampleSurface
overScene a b = sceneWhere (\x y -> embossedAt (if y < symbolHeight `div` 2 then a else b) x y)

-- | A face without anything on it.
flatScene :: SampleSurface
flatScene = sceneWhere (\_ _ -> False)

-- | How a scene is imaged. Lengths are in taxels.
data SampleView = SampleView
  { -- | The displacement of the scene, to the right and down.
    viewShift :: !(Double, Double),
    -- | The displacement of the right half against the left half, to the right and down. The halves
    -- are blended over the image's width.
    viewTear :: !(Double, Double),
    -- | The share of each taxel's value that comes from its two neighbours in its row, and the
    -- share from those in its column: 0 to 0.5 each, as resampling leaves it.
    viewBlur :: !(Double, Double),
    -- | The value of an embossed taxel.
    viewGain :: !Double,
    -- | The value of a flat taxel.
    viewBase :: !Double
  }
  deriving stock (Eq, Show)

-- | The view without displacement, tear or blur, with values 0 and 1.
exactView :: SampleView
exactView =
  SampleView {viewShift = (0, 0), viewTear = (0, 0), viewBlur = (0, 0), viewGain = 1, viewBase = 0}

-- | A random view as stitching and segmentation produce it, and the next generator. All parameters
-- are uniform: displacements up to the given number of taxels either way, tears up to 0.5 taxels
-- either way, blurs 0 to 0.4. The value of embossed taxels is 0.85 to 1.1, of flat ones -0.03 to
-- 0.05.
stitchedView :: Double -> StdGen -> (SampleView, StdGen)
stitchedView misplacement g0 = (SampleView (x, y) (u, v) (a, b) gain base, g8)
  where
    (x, g1) = between (-misplacement) misplacement g0
    (y, g2) = between (-misplacement) misplacement g1
    (u, g3) = between (-0.5) 0.5 g2
    (v, g4) = between (-0.5) 0.5 g3
    (a, g5) = between 0 0.4 g4
    (b, g6) = between 0 0.4 g5
    (gain, g7) = between 0.85 1.1 g6
    (base, g8) = between (-0.03) 0.05 g7
    between low high g = let (t, g') = uniform g in (low + (high - low) * t, g')

-- | The 8 x 12 image of a scene under a view. A displacement by part of a taxel interpolates
-- linearly between cells, as if each taxel were the mean over its area.
see :: SampleView -> SampleSurface -> Raster
see view (SampleSurface cells) = generate symbolWidth symbolHeight $ \x y ->
  let right = (fromIntegral x + 0.5) / fromIntegral symbolWidth
      at i = fromMaybe 0 (index down i y)
   in viewBase view
        + (viewGain view - viewBase view) * ((1 - right) * at x + right * at (symbolWidth + x))
  where
    -- The resampling is separable: rows first (the two halves' columns side by side), then columns.
    across = generate (2 * symbolWidth) (rasterHeight cells) $ \i y ->
      let (half, x) = i `quotRem` symbolWidth
       in blurred
            (fst (viewBlur view))
            (\t -> sample cells t (fromIntegral y))
            (fromIntegral (x + margin) - fst (placed half))
    down = generate (2 * symbolWidth) symbolHeight $ \i y ->
      blurred
        (snd (viewBlur view))
        (sample across (fromIntegral i))
        (fromIntegral (y + margin) - snd (placed (i `quot` symbolWidth)))
    blurred share f t = (1 - share) * f t + share / 2 * (f (t - 1) + f (t + 1))
    placed half =
      let sign =
            if half == 0 then -0.5 else 0.5
       in ( fst (viewShift view) + sign * fst (viewTear view),
            snd (viewShift view) + sign * snd (viewTear view)
          )

-- | A part of an image that the sensor never touched.
data Unseen
  = -- | This corner is unknown and counts as flat: its pixels become 0.
    CornerUnseen !Corner
  | -- | Columns at the right edge if the flag is set, else at the left edge; and their number. They
    -- repeat the nearest observed column.
    ColumnsUnseen !Bool !Int
  | -- | Rows at the bottom edge if the flag is set, else at the top edge; and their number. They
    -- repeat the nearest observed row.
    RowsUnseen !Bool !Int
  deriving stock (Eq, Show)

-- | A rectangle in a corner of an image.
data Corner = Corner
  { cornerAtRight :: !Bool,
    cornerAtBottom :: !Bool,
    -- | in taxels
    cornerWidth :: !Int,
    -- | in taxels
    cornerHeight :: !Int
  }
  deriving stock (Eq, Show)

-- | The image with the given part not observed.
withUnseen :: Unseen -> Raster -> Raster
withUnseen unseen image = generate w h value
  where
    w = rasterWidth image
    h = rasterHeight image
    value x y = case unseen of
      CornerUnseen (Corner right bottom n m)
        | inStrip right w n x && inStrip bottom h m y -> 0
        | otherwise -> at x y
      ColumnsUnseen right n -> at (nearestSeen right w n x) y
      RowsUnseen bottom n -> at x (nearestSeen bottom h n y)
    at x y = fromMaybe 0 (index image x y)
    inStrip far size n t = if far then t >= size - n else t < n
    nearestSeen far size n t = if far then min (size - 1 - n) t else max n t

-- | The image with white noise of the given standard deviation, clipped to 0..1 and rounded to the
-- 256 levels of a frame; and the next generator.
withNoise :: Double -> Raster -> StdGen -> (Raster, StdGen)
withNoise deviation image g = (generate (rasterWidth image) (rasterHeight image) noisy, g')
  where
    (noise, g') = normals (V.length (rasterValues image)) g
    noisy x y = rounded (value (rasterValues image) + deviation * value noise)
      where
        value v = fromMaybe 0 (v V.!? (y * rasterWidth image + x))
    rounded t = fromIntegral (round (255 * max 0 (min 1 t)) :: Int) / 255
