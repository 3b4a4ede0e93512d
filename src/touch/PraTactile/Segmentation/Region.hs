{-# LANGUAGE BangPatterns #-}

-- | Connected regions of an image's pixels, as the numbers of the pixels, and how far they extend.
module PraTactile.Segmentation.Region
  ( -- * Pixels
    Field (..),
    fieldOf,
    marked,
    touchedValues,
    pixelNoise,
    placeOf,
    beside,
    around,
    grown,

    -- * Regions
    Region,
    regions,
    extentAlong,
    regionBox,
  )
where

import Control.Monad (forM_, when)
import Control.Monad.ST (ST, runST)
import Data.List (foldl')
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import qualified Data.Vector.Storable.Mutable as M
import PraTactile.Composite (Composite (..))
import PraTactile.Composite.Level (noiseFrom)
import PraTactile.Geometry (cosineSine)
import PraTactile.Image

-- | An image's pixels, numbered row by row from 0.
data Field = Field
  { fieldWidth :: !Int,
    fieldHeight :: !Int,
    -- | whether each was touched
    fieldTouched :: !(Vector Bool),
    -- | each as the mean of the touched ones around it, those beside it with half its weight and
    -- those across with a quarter
    fieldValues :: !(Vector Double)
  }

-- | The pixels of a composite that got at least this weight, smoothed.
fieldOf :: Double -> Composite -> Field
fieldOf least composite = Field w h touched (V.generate (w * h) smooth)
  where
    image = compositeImage composite
    (w, h) = rasterSize image
    touched = V.map (>= least) (rasterValues (compositeCoverage composite))
    values = rasterValues image
    smooth p = if total > 0 then sum (map snd near) / total else 0
      where
        total = sum (map fst near)
        near =
          [ (k, k * (values V.! p'))
            | (i, j) <- [(i, j) | j <- [-1, 0, 1], i <- [-1, 0, 1]],
              Just p' <- [shifted w h p (i, j)],
              touched V.! p',
              let k = (if i == 0 then 2 else 1) * (if j == 0 then 2 else 1)
          ]

-- | The touched pixels whose values are so.
marked :: Field -> (Double -> Bool) -> V.Vector Bool
marked field test = V.zipWith (\t v -> t && test v) (fieldTouched field) (fieldValues field)

-- | The values of the touched pixels, in order.
touchedValues :: Field -> Vector Double
touchedValues field = V.ifilter (\p _ -> fieldTouched field V.! p) (fieldValues field)

-- | The number of the pixel so far right of and below another one.
beside :: Field -> Int -> (Int, Int) -> Maybe Int
beside field = shifted (fieldWidth field) (fieldHeight field)
{-# INLINE beside #-}

-- | The same in an image of that width and height.
shifted :: Int -> Int -> Int -> (Int, Int) -> Maybe Int
shifted w h p (i, j)
  | x >= 0 && x < w && y >= 0 && y < h = Just (y * w + x)
  | otherwise = Nothing
  where
    (v, u) = p `quotRem` w
    (x, y) = (u + i, v + j)
{-# INLINE shifted #-}

-- | The standard deviation of a composite's noise, of pixels that are not smoothed: the larger of
-- what changes along the rows and along the columns show, for a row may have noise in common, or a
-- column.
pixelNoise :: Field -> Raster -> Double
pixelNoise field image = max (noiseFrom (differences 1 0)) (noiseFrom (differences 0 1))
  where
    values = rasterValues image
    differences i j =
      V.fromList
        [ values V.! a - 2 * values V.! p + values V.! b
          | p <- [0 .. V.length values - 1],
            fieldTouched field V.! p,
            Just a <- [beside field p (negate i, negate j)],
            fieldTouched field V.! a,
            Just b <- [beside field p (i, j)],
            fieldTouched field V.! b
        ]

-- | The column and the row of a pixel.
placeOf :: Field -> Int -> (Int, Int)
placeOf field p = (p `mod` max 1 (fieldWidth field), p `div` max 1 (fieldWidth field))

-- | The pixels whose distance from some, the larger one of that in columns and that in rows, is at
-- most this. Each once, in order.
grown :: Field -> Int -> [Int] -> [Int]
grown field distance = V.toList . V.elemIndices True . around field distance

-- | Whether each pixel is one of them.
around :: Field -> Int -> [Int] -> Vector Bool
around field distance pixels = V.create $ do
  marks <- M.replicate (fieldWidth field * fieldHeight field) False
  forM_ pixels $ \p ->
    forM_ [(i, j) | j <- [-distance .. distance], i <- [-distance .. distance]] $ \by ->
      mapM_ (\p' -> M.write marks p' True) (beside field p by)
  pure marks

-- | The pixels of a connected region.
type Region = [Int]

-- | The connected regions of the marked pixels. Two pixels are connected when neither their columns
-- nor their rows differ by more than the gap and one.
regions :: Field -> Int -> Vector Bool -> [Region]
regions field gap these = runST (V.thaw padded >>= go 0)
  where
    (w, h) = (fieldWidth field, fieldHeight field)
    -- With a margin around, of pixels that are not marked, as wide as what is looked at from one.
    margin = gap + 1
    wide = w + 2 * margin
    padded = V.generate (wide * (h + 2 * margin)) $ \i ->
      let (y, x) = i `quotRem` wide
       in x >= margin && x < w + margin && y >= margin && y < h + margin
            && these V.! ((y - margin) * w + x - margin)
    pixel i = let (y, x) = i `quotRem` wide in (y - margin) * w + x - margin
    steps = V.fromList [j * wide + i | j <- [-margin .. margin], i <- [-margin .. margin]]
    go :: Int -> M.MVector s Bool -> ST s [Region]
    go !p left
      | p >= V.length padded = pure []
      | otherwise = do
        isFirst <- M.read left p
        if isFirst
          then do
            M.write left p False
            region <- flood left [p] []
            (region :) <$> go (p + 1) left
          else go (p + 1) left
    flood :: M.MVector s Bool -> [Int] -> [Int] -> ST s Region
    flood _ [] found = pure found
    flood left (p : queue) found = do
      near <- newAround left p 0 queue
      flood left near (pixel p : found)
    newAround :: M.MVector s Bool -> Int -> Int -> [Int] -> ST s [Int]
    newAround left !p !k queue
      | k >= V.length steps = pure queue
      | otherwise = do
        let p' = p + steps V.! k
        isNew <- M.read left p'
        when isNew (M.write left p' False)
        newAround left p (k + 1) (if isNew then p' : queue else queue)

-- | How far a region extends along a direction, in degrees clockwise from the x axis, in pixels. 0
-- for an empty one.
extentAlong :: Field -> Region -> Double -> Double
extentAlong field region angle
  | null region = 0
  | otherwise = let (least, most) = foldl' reaching (1 / 0, -1 / 0) region in most - least + 1
  where
    (c, s) = cosineSine angle
    reaching (!least, !most) p =
      let (y, x) = p `quotRem` max 1 (fieldWidth field)
          t = c * fromIntegral x + s * fromIntegral y
       in (min least t, max most t)

-- | The box around a region's pixels: left, top, right, bottom. At the origin for an empty one.
regionBox :: Field -> Region -> (Double, Double, Double, Double)
regionBox field region
  | null region = (0, 0, 0, 0)
  | otherwise = (least fst - 0.5, least snd - 0.5, most fst + 0.5, most snd + 0.5)
  where
    places = map (placeOf field) region
    least part = fromIntegral (minimum (map part places))
    most part = fromIntegral (maximum (map part places))
