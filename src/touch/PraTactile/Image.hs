-- | Tactile images as rasters of real values: row 0 at the top, 0 for no contact, 1 for full
-- scale. "PraTactile.Image.File" reads and writes files.
--
-- In every pair x (the column, to the right) comes before y (the row, downwards). Pixel centres lie
-- at the integers.
module PraTactile.Image
  ( -- * Rasters
    Raster,
    rasterWidth,
    rasterHeight,
    rasterSize,
    rasterValues,
    ImageError (..),

    -- * Making one
    raster,
    fromRows,
    generate,
    generateAt,
    constant,

    -- * Looking at it
    toRows,
    index,
    sample,
    pixelsWhere,
    valuesAt,

    -- * Parts and symmetries
    crop,
    onRaster,

    -- * Value by value
    mapRaster,
    zipRaster,

    -- * Statistics
    mean,
    standardDeviation,
    minimumValue,
    maximumValue,
    quantile,
  )
where

import qualified Data.IntMap.Strict as IntMap
import Data.List (sort)
import Data.Maybe (fromMaybe)
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import PraTactile.Image.Ascending (placeIn)
import PraTactile.Image.Error (ImageError (..))
import PraTactile.Symmetry

-- | An image: its width, its height and one value per pixel. Pixels are numbered row by row from
-- 0.
data Raster
  = -- | All values, width times height of them.
    Raster !Int !Int !(Vector Double)
  | -- | The value of most pixels; then the numbers of the other pixels, ascending, and their
    -- values. It saves memory for a large image of which little was touched.
    Sparse !Int !Int !Double !(Vector Int) !(Vector Double)
  deriving stock (Show)

-- | Rasters are equal if they have one size and the same values.
instance Eq Raster where
  a == b = rasterSize a == rasterSize b && rasterValues a == rasterValues b

-- | The number of columns.
rasterWidth :: Raster -> Int
rasterWidth = fst . rasterSize
{-# INLINE rasterWidth #-}

-- | The number of rows.
rasterHeight :: Raster -> Int
rasterHeight = snd . rasterSize
{-# INLINE rasterHeight #-}

-- | The number of columns and the number of rows.
rasterSize :: Raster -> (Int, Int)
rasterSize image = case image of
  Raster w h _ -> (w, h)
  Sparse w h _ _ _ -> (w, h)
{-# INLINE rasterSize #-}

-- | The values, row by row from the top, each row from the left.
rasterValues :: Raster -> Vector Double
rasterValues image = case image of
  Raster _ _ v -> v
  Sparse w h most numbers values ->
    V.update_ (V.replicate (w * h) most) numbers values
{-# INLINE rasterValues #-}

-- | A raster of the given width and height from its values, row by row. Refuses ('WrongValueCount')
-- any other number of values.
raster :: Int -> Int -> Vector Double -> Either ImageError Raster
raster w h v
  | w < 0 || h < 0 || toInteger w * toInteger h /= toInteger (V.length v) =
    Left (WrongValueCount w h (V.length v))
  | otherwise = Right (Raster w h v)

-- | A raster from its rows. Refuses ('RaggedRow') rows of different length.
--
-- >>> rasterWidth <$> fromRows [[0, 1, 0], [1, 0, 1]]
-- Right 3
fromRows :: [[Double]] -> Either ImageError Raster
fromRows rows = case [(i, n) | (i, n) <- zip [0 ..] lengths, n /= width] of
  (i, n) : _ -> Left (RaggedRow i n width)
  [] -> Right (Raster width (length rows) (V.fromList (concat rows)))
  where
    lengths = map length rows
    width = case lengths of
      n : _ -> n
      [] -> 0

-- | The raster of the given width and height whose value at x, y is the function's. Negative sizes
-- count as 0.
generate :: Int -> Int -> (Int -> Int -> Double) -> Raster
generate w h f
  | w <= 0 || h <= 0 = Raster (max 0 w) (max 0 h) V.empty
  | otherwise = Raster w h (V.generate (w * h) (\i -> let (y, x) = i `quotRem` w in f x y))
{-# INLINE generate #-}

-- | 'generate' for a function that is 0 except at the pixels with the given numbers (ascending). A
-- large raster takes memory for these pixels only.
generateAt :: Int -> Int -> Vector Int -> (Int -> Int -> Double) -> Raster
generateAt w h numbers f
  | w * h <= leastSparse = generate w h f
  | otherwise =
    Sparse w h 0 numbers (V.map (\i -> let (y, x) = i `quotRem` w in f x y) numbers)

-- | The number of pixels up to which a raster stores each value.
leastSparse :: Int
leastSparse = 1048576

-- | The raster of the given width and height with one value throughout.
constant :: Int -> Int -> Double -> Raster
constant w h value = generate w h (\_ _ -> value)

-- | The rows, from the top.
toRows :: Raster -> [[Double]]
toRows image = [V.toList (V.slice (y * w) w v) | y <- [0 .. h - 1]]
  where
    (w, h) = rasterSize image
    v = rasterValues image

-- | The value at column x and row y; 'Nothing' outside the image.
index :: Raster -> Int -> Int -> Maybe Double
index image x y
  | x < 0 || y < 0 || x >= w || y >= h = Nothing
  | otherwise = case image of
    Raster _ _ v -> v V.!? (y * w + x)
    Sparse _ _ most numbers values -> Just (sparseAt most numbers values (y * w + x))
  where
    (w, h) = rasterSize image
{-# INLINE index #-}

-- | The value of pixel @i@ of a sparse raster. The first three arguments are the value of most
-- pixels, and the numbers and values of the others.
sparseAt :: Double -> Vector Int -> Vector Double -> Int -> Double
sparseAt most numbers values i = maybe most (values V.!) (placeIn numbers i)

-- | The numbers of the pixels whose values satisfy the test, ascending. For a sparse image it
-- looks only at the stored pixels, if the value of most fails the test.
pixelsWhere :: (Double -> Bool) -> Raster -> Vector Int
pixelsWhere test image = case image of
  Sparse _ _ most numbers values
    | not (test most) -> V.ifilter (\k _ -> test (values V.! k)) numbers
  _ -> V.findIndices test (rasterValues image)

-- | The values of the pixels with the given numbers; 0 for a number outside the image.
valuesAt :: Raster -> Vector Int -> Vector Double
valuesAt image = case image of
  Raster _ _ v -> V.map (fromMaybe 0 . (v V.!?))
  Sparse _ _ most numbers values -> V.map (sparseAt most numbers values)

-- | The value at a real place, interpolated bilinearly between the four nearest pixel centres.
-- Outside the image it is the nearest edge pixel's value. 0 for an empty image and for a NaN
-- coordinate.
sample :: Raster -> Double -> Double -> Double
sample image x y
  | w == 0 || h == 0 || isNaN x || isNaN y = 0
  | otherwise = case image of
    -- Note [Bounds]
    Raster _ _ v -> between (V.unsafeIndex v)
    Sparse _ _ most numbers values -> between (sparseAt most numbers values)
  where
    (w, h) = rasterSize image
    (x0, x1, fx) = bracket w x
    (y0, y1, fy) = bracket h y
    between at = (1 - fy) * row y0 + fy * row y1
      where
        row r = (1 - fx) * at (r * w + x0) + fx * at (r * w + x1)
    {-# INLINE between #-}
{-# INLINE sample #-}

-- | The two pixels around a place on an axis of n >= 1 pixels, and the second one's share of the
-- interpolated value.
bracket :: Int -> Double -> (Int, Int, Double)
bracket n t = (i, min (n - 1) (i + 1), t' - fromIntegral i)
  where
    t' = max 0 (min (fromIntegral (n - 1)) t)
    i = truncate t' :: Int
{-# INLINE bracket #-}

{- Note [Bounds] 'bracket' clamps the place to [0, n - 1] before it takes the integer part, so both
   its indices lie in [0, n - 1]. The constructor is hidden, and every function here keeps width *
   height values. So r * w + x is an index of the vector. -}

-- | The part of an image with the given upper left pixel (x, y) and the given width and height.
-- Refuses ('OutsideImage') a part that is not wholly in the image.
crop :: (Int, Int) -> (Int, Int) -> Raster -> Either ImageError Raster
crop (x, y) (cw, ch) image
  | x < 0 || y < 0 || cw < 0 || ch < 0 || x > w - cw || y > h - ch =
    Left (OutsideImage (x, y, cw, ch) (w, h))
  | otherwise = Right (rearranged cw ch (\i j -> (x + i, y + j)) image)
  where
    (w, h) = rasterSize image

-- | The image rotated or mirrored by a symmetry.
--
-- >>> toRows . onRaster (turned 1) <$> fromRows [[1, 2], [3, 4]]
-- Right [[3.0,1.0],[4.0,2.0]]
onRaster :: Symmetry -> Raster -> Raster
onRaster symmetry image
  | symmetry == identity = image
  | otherwise = case image of
    Raster w h v | symmetry == turned 2 -> Raster w h (V.reverse v)
    Raster {} -> rearranged wide high (curry (onPixel (invert symmetry) (wide, high))) image
    Sparse w h most numbers values ->
      let there i =
            let (y, x) = i `quotRem` w
                (x', y') = onPixel symmetry (w, h) (x, y)
             in y' * wide + x'
          moved = IntMap.fromList (zip (map there (V.toList numbers)) (V.toList values))
       in Sparse wide high most (V.fromList (IntMap.keys moved)) (V.fromList (IntMap.elems moved))
  where
    (wide, high)
      | exchangesAxes symmetry = (rasterHeight image, rasterWidth image)
      | otherwise = rasterSize image

-- | A raster of the given size that takes each pixel from the place that the function names; 0 if
-- that lies outside the image.
rearranged :: Int -> Int -> (Int -> Int -> (Int, Int)) -> Raster -> Raster
rearranged w h place image = generate w h (\x y -> fromMaybe 0 (uncurry (index image) (place x y)))
{-# INLINE rearranged #-}

-- | The function applied to each value.
mapRaster :: (Double -> Double) -> Raster -> Raster
mapRaster f image = case image of
  Raster w h v -> Raster w h (V.map f v)
  Sparse w h most numbers values -> Sparse w h (f most) numbers (V.map f values)
{-# INLINE mapRaster #-}

-- | The function applied to the two values at each place. Refuses ('SizesDiffer') rasters of
-- different sizes.
zipRaster :: (Double -> Double -> Double) -> Raster -> Raster -> Either ImageError Raster
zipRaster f a b
  | rasterSize a /= rasterSize b = Left (SizesDiffer (rasterSize a) (rasterSize b))
  | otherwise = Right $ case (a, b) of
    (Sparse _ _ most numbers values, Sparse _ _ most' numbers' values')
      | numbers == numbers' -> Sparse w h (f most most') numbers (V.zipWith f values values')
    _ -> Raster w h (V.zipWith f (rasterValues a) (rasterValues b))
  where
    (w, h) = rasterSize a
{-# INLINE zipRaster #-}

-- | The mean of the values; 'Nothing' for an empty image.
mean :: Raster -> Maybe Double
mean = ifAny (\v -> V.sum v / fromIntegral (V.length v))

-- | The standard deviation of the values (the root of the mean squared difference from their
-- mean); 'Nothing' for an empty image.
standardDeviation :: Raster -> Maybe Double
standardDeviation image = do
  m <- mean image
  sqrt <$> mean (mapRaster (\x -> (x - m) * (x - m)) image)

-- | The smallest value; 'Nothing' for an empty image.
minimumValue :: Raster -> Maybe Double
minimumValue = ifAny V.minimum

-- | The largest value; 'Nothing' for an empty image.
maximumValue :: Raster -> Maybe Double
maximumValue = ifAny V.maximum

-- | The quantile for a share (clipped to 0..1), interpolated between the two nearest values in
-- order; 'Nothing' for an empty image.
--
-- >>> fromRows [[4, 1, 3, 2]] >>= Right . quantile 0.5
-- Right (Just 2.5)
quantile :: Double -> Raster -> Maybe Double
quantile share = ifAny $ \v ->
  let sorted = V.fromList (sort (V.toList v))
      line = Raster (V.length sorted) 1 sorted
   in sample line (share * fromIntegral (V.length v - 1)) 0

ifAny :: (Vector Double -> a) -> Raster -> Maybe a
ifAny f image
  | V.null v = Nothing
  | otherwise = Just (f v)
  where
    v = rasterValues image
{-# INLINE ifAny #-}
