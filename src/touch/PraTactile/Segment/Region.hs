{-# LANGUAGE BangPatterns #-}

-- | Connected regions of an image's pixels, as the numbers of the pixels, and how far they extend.
module PraTactile.Segment.Region
  ( -- * Pixels
    Field (..),
    fieldOf,
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
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import qualified Data.Vector.Storable.Mutable as M
import PraTactile.Image
import PraTactile.Segment.Level (noiseFrom)
import PraTactile.Stitch.Composite (Composite (..))

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
    (w, h) = (rasterWidth image, rasterHeight image)
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

-- | The number of the pixel so far right of and below another one.
beside :: Field -> Int -> (Int, Int) -> Maybe Int
beside field = shifted (fieldWidth field) (fieldHeight field)

-- | The same in an image of that width and height.
shifted :: Int -> Int -> Int -> (Int, Int) -> Maybe Int
shifted w h p (i, j)
  | x >= 0 && x < w && y >= 0 && y < h = Just (y * w + x)
  | otherwise = Nothing
  where
    (x, y) = (p `mod` w + i, p `div` w + j)

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
grown field distance pixels = [p | (p, True) <- zip [0 ..] (V.toList marks)]
  where
    marks = around field distance pixels

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
regions field gap marked = runST (V.thaw marked >>= go 0)
  where
    size = V.length marked
    reach = [(i, j) | j <- [-gap - 1 .. gap + 1], i <- [-gap - 1 .. gap + 1]]
    go :: Int -> M.MVector s Bool -> ST s [Region]
    go !p left
      | p >= size = pure []
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
      near <- newAround left p reach queue
      flood left near (p : found)
    newAround _ _ [] queue = pure queue
    newAround left p (by : others) queue = case beside field p by of
      Nothing -> newAround left p others queue
      Just p' -> do
        isNew <- M.read left p'
        when isNew (M.write left p' False)
        newAround left p others (if isNew then p' : queue else queue)

-- | How far a region extends along a direction, in degrees clockwise from the x axis, in pixels. 0
-- for an empty one.
extentAlong :: Field -> Region -> Double -> Double
extentAlong field region angle
  | null region = 0
  | otherwise = maximum along - minimum along + 1
  where
    (c, s) = (cos (angle * pi / 180), sin (angle * pi / 180))
    along =
      [ c * fromIntegral x + s * fromIntegral y
        | (x, y) <- map (placeOf field) region
      ]

-- | The box around a region's pixels: left, top, right, bottom. At the origin for an empty one.
regionBox :: Field -> Region -> (Double, Double, Double, Double)
regionBox field region
  | null region = (0, 0, 0, 0)
  | otherwise = (least fst - 0.5, least snd - 0.5, most fst + 0.5, most snd + 0.5)
  where
    places = map (placeOf field) region
    least part = fromIntegral (minimum (map part places))
    most part = fromIntegral (maximum (map part places))
