{-# LANGUAGE BangPatterns #-}

-- | The symbols of an alphabet as a sensor sees them, at every place on a frame: what a frame is
-- held against to find the lattice of cells under it.
--
-- A symbol at (x, y), the place of the centre of its upper left taxel, makes a taxel at (u, v) read
-- the sum over its embossed taxels (i, j) of g (u - x - i) g (v - y - j), where g is the share of a
-- taxel's width that a normal blur brings there. Places lie on a grid of that many to the taxel.
module PraTactile.Stitch.Template
  ( Templates (..),
    templates,
    paperTemplates,
    placesPerTaxel,
    coarser,
    correlations,
    cellIndex,
    firstColumn,
    firstRow,
  )
where

import Data.Maybe (fromMaybe)
import qualified Data.Vector as Boxed
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import PraTactile.Geometry (sensorSide)
import PraTactile.Image (Raster, constant, rasterValues)
import PraTactile.Shape
  ( Alphabet,
    embossedAt,
    halfTurned,
    paperAlphabet,
    shapes,
    symbolHeight,
    symbolWidth,
  )

-- | An alphabet's symbols, upright and half turned, at all places of frames of one size.
data Templates = Templates
  { -- | The size of the frames.
    templateFrame :: !(Int, Int),
    -- | The number of classes.
    templateClasses :: !Int,
    -- | Places to the taxel.
    templatePlaces :: !Int,
    -- | The number of places across and down.
    templateGrid :: !(Int, Int),
    -- | For each orientation and class, the offsets of its embossed taxels on the padded grid.
    templateOffsets :: !(Boxed.Vector (Vector Int)),
    -- | The sum of each template over the frame, indexed by 'cellIndex' and class.
    templateSums :: !(Vector Double),
    -- | The sum of its squares, likewise.
    templateSquares :: !(Vector Double),
    -- | The same at whole taxels only.
    templateCoarse :: Maybe Templates
  }

-- | How finely places are told apart, in places to the taxel.
placesPerTaxel :: Int
placesPerTaxel = 2

-- | The standard deviation, in taxels, of the blur that is supposed: that of an elastic overlay and
-- of an element's aperture. Assumption; a half more or less changes little.
blurDeviation :: Double
blurDeviation = 0.75

-- | How far from its own taxels a symbol still counts, in taxels.
fringe :: Int
fringe = 2

-- | The place of the first column and of the first row of places, in taxels from the centre of the
-- frame's upper left taxel.
firstColumn, firstRow :: Int
firstColumn = negate (symbolWidth + fringe)
firstRow = negate (symbolHeight + fringe)

-- | The same at whole taxels, if these are finer.
coarser :: Templates -> Templates
coarser fine = fromMaybe fine (templateCoarse fine)

-- | Where an orientation (0 upright, 1 half turned), a row and a column of places lie in the
-- tables, to be multiplied by the number of classes where these have one number a class.
cellIndex :: Templates -> Int -> Int -> Int -> Int
cellIndex tables orientation y x = (orientation * rows + y) * columns + x
  where
    (columns, rows) = templateGrid tables
{-# INLINE cellIndex #-}

-- | The tables for an alphabet and frames of that width and height.
templates :: Alphabet -> Int -> Int -> Templates
templates alphabet w h = (tabled placesPerTaxel) {templateCoarse = Just (tabled 1)}
  where
    bitmaps = Boxed.fromList (shapes alphabet ++ map halfTurned (shapes alphabet))
    count = length (shapes alphabet)
    tabled q = tables
      where
        bare =
          Templates
            { templateFrame = (w, h),
              templateClasses = count,
              templatePlaces = q,
              templateGrid = (columns, rows),
              templateOffsets = fmap offsets bitmaps,
              templateSums = V.empty,
              templateSquares = V.empty,
              templateCoarse = Nothing
            }
        tables =
          bare
            { templateSums = correlations bare (constant w h 1),
              templateSquares = squaresOf bare (fmap embossedAt bitmaps)
            }
        columns = (w + symbolWidth + 2 * fringe) * q
        rows = (h + symbolHeight + 2 * fringe) * q
        offsets b =
          V.fromList
            [ (y * paddedWidth bare + x) * q
              | y <- [0 .. symbolHeight - 1],
                x <- [0 .. symbolWidth - 1],
                embossedAt b x y
            ]

-- | The tables for the shipped alphabet, those for frames of the sensor's size made once for all.
-- 'Nothing' where that alphabet cannot be read, which a test excludes.
paperTemplates :: Int -> Int -> Maybe Templates
paperTemplates w h
  | w == sensorSide && h == sensorSide = ofTheSensor
  | otherwise = paper w h

ofTheSensor :: Maybe Templates
ofTheSensor = paper sensorSide sensorSide
{-# NOINLINE ofTheSensor #-}

paper :: Int -> Int -> Maybe Templates
paper w h = either (const Nothing) (\known -> Just (templates known w h)) paperAlphabet

-- | The width of the grid of places, padded so that a symbol at any place lies on it.
paddedWidth :: Templates -> Int
paddedWidth tables = fst (templateGrid tables) + (symbolWidth - 1) * templatePlaces tables

-- | The share of a unit taxel, blurred, that is seen at this distance from its centre.
seenAt :: Double -> Double
seenAt u = cumulative ((u + 0.5) / blurDeviation) - cumulative ((u - 0.5) / blurDeviation)

-- | The normal distribution function, to 1e-7 (Abramowitz and Stegun, formula 26.2.17).
cumulative :: Double -> Double
cumulative x
  | x < 0 = 1 - cumulative (negate x)
  | otherwise =
    1 - exp (negate (x * x) / 2) / sqrt (2 * pi)
      * t
      * ( 0.319381530
            + t * (-0.356563782 + t * (1.781477937 + t * (-1.821255978 + t * 1.330274429)))
        )
  where
    t = 1 / (1 + 0.2316419 * x)

-- | The sum over the frame of its values times each template: by class, at each place, in each
-- orientation. The image has the size that the tables are for.
correlations :: Templates -> Raster -> Vector Double
correlations tables image = V.generate (2 * rows * columns * count) at
  where
    (columns, rows) = templateGrid tables
    count = templateClasses tables
    blurred = spread tables image
    wide = paddedWidth tables
    at i =
      let (cell, k) = i `quotRem` count
          (row, x) = cell `quotRem` columns
          (o, y) = row `quotRem` rows
          offsets = Boxed.unsafeIndex (templateOffsets tables) (o * count + k)
          start = y * wide + x
       in -- Note [Bounds of templates]
          V.foldl' (\s d -> s + V.unsafeIndex blurred (start + d)) 0 offsets

{- Note [Bounds of templates] A place's column is below the grid's width and an offset reaches at
   most 7 taxels further, which the padding holds; likewise for rows, 11. Orientation and class come
   from an index of 2 * rows * columns * count, and there are 2 * count lists of offsets. -}

-- | What each place of the padded grid would read of the frame, blurred.
spread :: Templates -> Raster -> Vector Double
spread tables image = V.generate (wide * high) down
  where
    (w, h) = templateFrame tables
    q = templatePlaces tables
    (_, rows) = templateGrid tables
    wide = paddedWidth tables
    high = rows + (symbolHeight - 1) * q
    values = rasterValues image
    across = V.generate (wide * h) $ \i ->
      let (y, x) =
            i `quotRem` wide
       in along firstColumn w x (\u -> V.unsafeIndex values (y * w + u))
    down i =
      let (y, x) = i `quotRem` wide
       in along firstRow h y (\v -> V.unsafeIndex across (v * wide + x))
    along start n place value = go lowest 0
      where
        (whole, part) = place `quotRem` q
        centre = start + whole
        lowest = max 0 (centre - 3)
        highest = min (n - 1) (centre + 4)
        go !u !s
          | u > highest = s
          | otherwise =
            go (u + 1) (s + V.unsafeIndex shares (part * 8 + u - centre + 3) * value u :: Double)
    {-# INLINE along #-}
    shares =
      V.generate (8 * q) $ \i ->
        let (part, u) = i `quotRem` 8
         in seenAt (fromIntegral (u - 3) - fromIntegral part / fromIntegral q)

-- | The sum over the frame of the squares of each template at each place.
squaresOf :: Templates -> Boxed.Vector (Int -> Int -> Bool) -> Vector Double
squaresOf tables bitmaps = V.generate (2 * rows * columns * count) at
  where
    (w, h) = templateFrame tables
    (columns, rows) = templateGrid tables
    count = templateClasses tables
    q = templatePlaces tables
    at i =
      let (cell, k) = i `quotRem` count
          (row, x) = cell `quotRem` columns
          (o, y) = row `quotRem` rows
          (bx, px) = x `quotRem` q
          (by, py) = y `quotRem` q
          table = Boxed.unsafeIndex integrals (((o * count + k) * q + py) * q + px)
          left = firstColumn + bx
          top = firstRow + by
          x0 = bounded boxWide (negate left)
          x1 = bounded boxWide (w - left)
          y0 = bounded boxHigh (negate top)
          y1 = bounded boxHigh (h - top)
          corner v u = V.unsafeIndex table (v * (boxWide + 1) + u)
       in corner y1 x1 - corner y0 x1 - corner y1 x0 + corner y0 x0
    bounded most t = max 0 (min most (t + margin))
    -- The sums of the squares left of and above each corner, of each bitmap at each part of a
    -- taxel.
    integrals =
      Boxed.generate (2 * count * q * q) $ \i ->
        let (bitmapAndRow, px) = i `quotRem` q
            (b, py) = bitmapAndRow `quotRem` q
         in integral (rendered (Boxed.unsafeIndex bitmaps b) px py)
    rendered embossed px py =
      V.generate (boxWide * boxHigh) $ \i ->
        let (v, u) = i `quotRem` boxWide
         in squared
              ( sum
                  [ share px (u - margin - a) * share py (v - margin - b)
                    | b <- [max 0 (v - 2 * margin) .. min (symbolHeight - 1) v],
                      a <- [max 0 (u - 2 * margin) .. min (symbolWidth - 1) u],
                      embossed a b
                  ]
              )
    -- The distances are from minus to plus the margin.
    share part u = V.unsafeIndex shares (part * (2 * margin + 1) + u + margin)
    shares =
      V.generate (q * (2 * margin + 1)) $ \i ->
        let (part, u) = i `quotRem` (2 * margin + 1)
         in seenAt (fromIntegral (u - margin) - fromIntegral part / fromIntegral q)
    squared t = t * t

-- | How far around a symbol its squares are summed, in taxels, and the box that this makes.
margin, boxWide, boxHigh :: Int
margin = 3
boxWide = symbolWidth + 2 * margin
boxHigh = symbolHeight + 2 * margin

-- | The sums left of and above each corner of a box.
integral :: Vector Double -> Vector Double
integral values = V.fromList (concat (scanl below (replicate (boxWide + 1) 0) [0 .. boxHigh - 1]))
  where
    below above v =
      zipWith (+) above (scanl (+) 0 (V.toList (V.slice (v * boxWide) boxWide values)))
