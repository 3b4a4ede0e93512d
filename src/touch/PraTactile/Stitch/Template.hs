{-# LANGUAGE BangPatterns #-}

-- | The symbols of an alphabet as a sensor sees them, at every place on a frame: what a frame is
-- held against to find the lattice of cells under it.
--
-- A symbol at (x, y), the place of the centre of its upper left taxel, makes a taxel at (u, v) read
-- the sum over its embossed taxels (i, j) of g (u - x - i) g (v - y - j), where g is the share of a
-- taxel's width that a normal blur brings there. Places lie on a grid of that many to the taxel.
-- The symbols' axes may be turned from the frame's: then places are turned with them, and the blur,
-- which is nearly the same in all directions, is not.
module PraTactile.Stitch.Template
  ( Templates (..),
    templates,
    PaperTables (..),
    paperTemplates,
    placesPerTaxel,
    coarser,
    correlations,
    cellIndex,
    turnedBy,
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

-- | An alphabet's symbols, upright and half turned, at all places of frames of one size, along axes
-- that are turned from the frames'.
data Templates = Templates
  { -- | The size of the frames.
    templateFrame :: !(Int, Int),
    -- | By how many degrees, clockwise, the symbols' axes are turned from the frames'.
    templateAngle :: !Double,
    -- | The number of classes.
    templateClasses :: !Int,
    -- | Places to the taxel.
    templatePlaces :: !Int,
    -- | The first column and the first row of places, along the symbols' axes, in taxels from the
    -- centre of the frame's upper left taxel.
    templateFirst :: !(Int, Int),
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

-- | The tables for an alphabet whose axes are turned by so many degrees clockwise, and frames of
-- that width and height.
templates :: Alphabet -> Double -> Int -> Int -> Templates
templates alphabet angle w h =
  (fine placesPerTaxel) {templateCoarse = Just (coarseTemplates alphabet angle w h)}
  where
    fine = tabled alphabet angle w h

-- | The same at whole taxels only.
coarseTemplates :: Alphabet -> Double -> Int -> Int -> Templates
coarseTemplates alphabet angle w h = tabled alphabet angle w h 1

-- | The same at so many places to the taxel.
tabled :: Alphabet -> Double -> Int -> Int -> Int -> Templates
tabled alphabet angle w h q = tables
  where
    bitmaps = Boxed.fromList (shapes alphabet ++ map halfTurned (shapes alphabet))
    corners =
      [ turnedBy (negate angle) (fromIntegral x, fromIntegral y)
        | x <- [0, w - 1],
          y <- [0, h - 1]
      ]
    (left, wide) = extent (map fst corners)
    (top, high) = extent (map snd corners)
    -- The first whole number, and how many reach to the last.
    extent :: [Double] -> (Int, Int)
    extent ts =
      let first = floor (minimum ts + 1e-9) in (first, ceiling (maximum ts - 1e-9) - first + 1)
    bare =
      Templates
        { templateFrame = (w, h),
          templateAngle = angle,
          templateClasses = length (shapes alphabet),
          templatePlaces = q,
          templateFirst = (left - symbolWidth - fringe, top - symbolHeight - fringe),
          templateGrid =
            ((wide + symbolWidth + 2 * fringe) * q, (high + symbolHeight + 2 * fringe) * q),
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
    offsets b =
      V.fromList
        [ (y * paddedWidth bare + x) * q
          | y <- [0 .. symbolHeight - 1],
            x <- [0 .. symbolWidth - 1],
            embossedAt b x y
        ]

-- | A displacement, right and down, turned clockwise by so many degrees.
turnedBy :: Double -> (Double, Double) -> (Double, Double)
turnedBy 0 place = place
turnedBy angle (x, y) = (c * x - s * y, s * x + c * y)
  where
    c = cos (angle * pi / 180)
    s = sin (angle * pi / 180)

-- | The tables of an alphabet at any angle, for frames of any width and height, and those at whole
-- taxels only.
data PaperTables = PaperTables
  { paperTables :: Double -> (Int, Int) -> Templates,
    paperCoarse :: Double -> (Int, Int) -> Templates
  }

-- | The tables for the shipped alphabet, those for upright frames of the sensor's size made once
-- for all. 'Nothing' where that alphabet cannot be read, which a test excludes.
paperTemplates :: Maybe PaperTables
paperTemplates = either (const Nothing) (Just . made) paperAlphabet
  where
    made known = PaperTables at (\angle (w, h) -> coarseTemplates known angle w h)
      where
        at angle (w, h)
          | angle == 0 && w == sensorSide && h == sensorSide = usual
          | otherwise = templates known angle w h
        usual = templates known 0 sensorSide sensorSide
{-# NOINLINE paperTemplates #-}

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
spread tables image = V.generate (wide * high) at
  where
    (w, h) = templateFrame tables
    q = templatePlaces tables
    (_, rows) = templateGrid tables
    wide = paddedWidth tables
    high = rows + (symbolHeight - 1) * q
    values = rasterValues image
    place = onFrame tables
    at i = let (y, x) = i `quotRem` wide in uncurry seen (place x y)
    seen x y = down (max 0 (row - 3)) 0
      where
        (column, shareX) = parted x
        (row, shareY) = parted y
        lastRow = min (h - 1) (row + 4)
        firstColumn = max 0 (column - 3)
        lastColumn = min (w - 1) (column + 4)
        -- Note [Bounds of shares]
        down !v !s
          | v > lastRow = s :: Double
          | otherwise =
            down (v + 1) (s + V.unsafeIndex shares (shareY + v - row + 3) * across v firstColumn 0)
        across !v !u !s
          | u > lastColumn = s :: Double
          | otherwise =
            across
              v
              (u + 1)
              ( s
                  + V.unsafeIndex shares (shareX + u - column + 3)
                    * V.unsafeIndex values (v * w + u)
              )

-- | Where a column and a row of places lie on the frame, taxels.
onFrame :: Templates -> Int -> Int -> (Double, Double)
onFrame tables = \x y -> turned' (firstX + fromIntegral x / q) (firstY + fromIntegral y / q)
  where
    q = fromIntegral (templatePlaces tables)
    (firstX, firstY) = let (x, y) = templateFirst tables in (fromIntegral x, fromIntegral y)
    (c, s) = turnedBy (templateAngle tables) (1, 0)
    turned' x y = (c * x - s * y, s * x + c * y)

-- | A place along an axis as a whole number of taxels, and where the shares of the taxels around it
-- begin, the first of them three before it.
parted :: Double -> (Int, Int)
parted t = (whole, 8 * round (fromIntegral partsOfTaxel * (t - fromIntegral whole)))
  where
    whole = floor t :: Int

-- | The shares of the eight taxels around a place, by the part of a taxel that it lies beyond the
-- fourth of them.
shares :: Vector Double
shares =
  V.generate (8 * (partsOfTaxel + 1)) $ \i ->
    let (part, u) = i `quotRem` 8
     in seenAt (fromIntegral (u - 3) - fromIntegral part / fromIntegral partsOfTaxel)

-- | How finely the place between two taxels is told for that.
partsOfTaxel :: Int
partsOfTaxel = 32

{- Note [Bounds of shares] A row or column lies within 0 .. side - 1 of the frame and at most three
   before and four behind the place's own; the shares of each of the 33 parts are eight. -}

-- | The sum over the frame of the squares of each template at each place. Along the frame's axes it
-- is that at its pixels. Turned, it is that at whole taxels from the template's place, each counted
-- for as much of a taxel as the frame has there, which differs at the frame's edge only.
squaresOf :: Templates -> Boxed.Vector (Int -> Int -> Bool) -> Vector Double
squaresOf tables bitmaps = V.generate (2 * rows * columns * count) at
  where
    (w, h) = templateFrame tables
    (columns, rows) = templateGrid tables
    count = templateClasses tables
    q = templatePlaces tables
    -- Of how many places to the taxel each is drawn by itself.
    parts = if templateAngle tables == 0 then q else 1
    at i =
      let (cell, k) = i `quotRem` count
          (row, x) = cell `quotRem` columns
          (o, y) = row `quotRem` rows
          (partX, partY) = (x `rem` parts, y `rem` parts)
          start = (y - partY) * wide + x - partX
       in summed
            start
            (Boxed.unsafeIndex drawn (((o * count + k) * parts + partY) * parts + partX))
    -- Note [Bounds of squares]
    summed start (steps, values) = go 0 0
      where
        go !j !s
          | j >= V.length steps = s :: Double
          | otherwise =
            let t = V.unsafeIndex there (start + V.unsafeIndex steps j)
             in go (j + 1) (s + V.unsafeIndex values j * t)
    -- How much of a taxel the frame has at each place, of a grid that begins the margin before.
    wide = columns + (boxWide - 1) * q
    high = rows + (boxHigh - 1) * q
    there =
      V.generate (wide * high) $ \i ->
        let (y, x) = i `quotRem` wide
            (u, v) = onFrame tables (x - margin * q) (y - margin * q)
         in within w u * within h v
    within n t = max 0 (min 1 (min (t + 1) (fromIntegral n - t)))
    drawn =
      Boxed.fromList
        [ sparse (rendered embossed (part x) (part y))
          | embossed <- Boxed.toList bitmaps,
            y <- [0 .. parts - 1],
            x <- [0 .. parts - 1]
        ]
    part :: Int -> Double
    part t = fromIntegral t / fromIntegral q
    -- Only where there is anything, and each step on the grid.
    sparse values =
      let kept = V.findIndices (> 1e-4) values
       in (V.map stepTo kept, V.map (values V.!) kept)
    stepTo i = let (b, a) = i `quotRem` boxWide in (b * wide + a) * q
    -- At whole taxels from the margin before the symbol on, if it lies that part of one further.
    rendered embossed partX partY =
      V.generate (boxWide * boxHigh) $ \i ->
        let (v, u) = i `quotRem` boxWide
         in squared
              ( sum
                  [ V.unsafeIndex acrossShares (u - a) * V.unsafeIndex downShares (v - b)
                    | b <- [max 0 (v - 2 * margin) .. min (symbolHeight - 1) v],
                      a <- [max 0 (u - 2 * margin) .. min (symbolWidth - 1) u],
                      embossed a b
                  ]
              )
      where
        acrossShares = sharesAround partX
        downShares = sharesAround partY
    sharesAround t =
      V.generate (2 * margin + 1) (\d -> seenAt (fromIntegral (d - margin) - t)) :: Vector Double
    squared t = t * t

{- Note [Bounds of squares] A place's column is below the grid's width and a step reaches at most
   the box's width less one further, which the grid of what the frame has there holds; likewise for
   rows. There are as many drawn templates as classes, orientations and parts. A pixel of the box is
   at most the margin from the taxels that are looked at for it. -}

-- | How far around a symbol its squares are summed, in taxels, and the box that this makes.
margin, boxWide, boxHigh :: Int
margin = 3
boxWide = symbolWidth + 2 * margin
boxHigh = symbolHeight + 2 * margin
