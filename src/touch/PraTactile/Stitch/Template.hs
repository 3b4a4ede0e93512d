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
import qualified Data.Vector.Storable.Mutable as M
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
    -- | For each orientation and class, its shape.
    templateOutlines :: !(Boxed.Vector Outline),
    -- | The sum of each template over the frame, indexed by 'cellIndex' and class.
    templateSums :: !(Vector Double),
    -- | The sum of its squares, likewise.
    templateSquares :: !(Vector Double),
    -- | The same at whole taxels only.
    templateCoarse :: Maybe Templates
  }

-- | The corners of a shape: steps from its place on the grid of the sums of areas, and how often
-- the sum of the area up to there counts, so that what remains is the sum over the shape. That is
-- the second difference of the shape's bitmap, across and down.
data Outline = Outline !(Vector Int) !(Vector Double)

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
          templateOutlines = fmap outline bitmaps,
          templateSums = V.empty,
          templateSquares = V.empty,
          templateCoarse = Nothing
        }
    tables =
      bare
        { templateSums = correlations bare (constant w h 1),
          templateSquares = squaresOf bare (fmap embossedAt bitmaps)
        }
    outline b = Outline (V.fromList (map fst corners')) (V.fromList (map snd corners'))
      where
        corners' =
          [ ((y * areasWidth bare + x) * q, count)
            | y <- [0 .. symbolHeight],
              x <- [0 .. symbolWidth],
              let before = covered (x - 1) (y - 1) - covered x (y - 1)
                  count = before - covered (x - 1) y + covered x y,
              count /= 0
          ]
        covered x y = if embossedAt b x y then 1 else 0

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

-- | Its height.
paddedHeight :: Templates -> Int
paddedHeight tables = snd (templateGrid tables) + (symbolHeight - 1) * templatePlaces tables

-- | The width of the grid of the sums of areas, which begins a taxel before the padded grid.
areasWidth :: Templates -> Int
areasWidth tables = paddedWidth tables + templatePlaces tables

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
correlations tables image = V.concat [orientation o | o <- [0, 1]]
  where
    (columns, rows) = templateGrid tables
    count = templateClasses tables
    areas = areaSums tables (spread tables image)
    wide = areasWidth tables
    orientation o = V.create $ do
      sums <- M.unsafeNew (rows * columns * count)
      let outlines = Boxed.slice (o * count) count (templateOutlines tables)
          row !y !i
            | y >= rows = pure ()
            | otherwise = column y 0 i >>= row (y + 1)
          column !y !x !i
            | x >= columns = pure i
            | otherwise = class' (y * wide + x) 0 i >>= column y (x + 1)
          class' !start !k !i
            | k >= count = pure i
            | otherwise = do
              M.unsafeWrite sums i (outlined start (Boxed.unsafeIndex outlines k))
              class' start (k + 1) (i + 1)
      row 0 (0 :: Int)
      pure sums
    -- Note [Bounds of outlines]
    outlined start (Outline steps counts) = go 0 0
      where
        go !c !s
          | c >= V.length steps = s :: Double
          | otherwise =
            go
              (c + 1)
              ( s
                  + V.unsafeIndex counts c
                    * V.unsafeIndex areas (start + V.unsafeIndex steps c)
              )

{- Note [Bounds of outlines] A place's column is below the grid's width and a step reaches at most 8
   taxels further, which the width of the sums of areas holds; likewise for rows, 12. There are
   2 * count outlines. -}

-- | Of values on the padded grid, one each whole taxel before a place, across and down, up to its
-- own: their sum over the rectangle that ends there. The first row and column of taxels are 0.
areaSums :: Templates -> Vector Double -> Vector Double
areaSums tables values = V.create $ do
  sums <- M.replicate (wide * high) 0
  let row !y
        | y >= high = pure ()
        | otherwise = column y q >> row (y + 1)
      -- Note [Bounds of areas]
      column !y !x
        | x >= wide = pure ()
        | otherwise = do
          let i = y * wide + x
          left <- M.unsafeRead sums (i - q)
          above <- M.unsafeRead sums (i - q * wide)
          both <- M.unsafeRead sums (i - q * wide - q)
          let value = V.unsafeIndex values ((y - q) * (wide - q) + x - q)
          M.unsafeWrite sums i (value + left + above - both)
          column y (x + 1)
  row q
  pure sums
  where
    q = templatePlaces tables
    wide = areasWidth tables
    high = paddedHeight tables + q

{- Note [Bounds of areas] Rows and columns begin with q, a taxel, so that what lies a taxel before
   is in the grid; the values lack the first taxel's rows and columns. -}

-- | What each place of the padded grid would read of the frame, blurred: along the frame's axes by
-- rows first and then by columns, else at each place by itself.
spread :: Templates -> Raster -> Vector Double
spread tables image
  | templateAngle tables == 0 =
    everywhere high $ \x y ->
      blurredAt h (\v -> V.unsafeIndex across (v * wide + x)) (snd (place 0 y))
  | otherwise =
    everywhere high $ \x y -> let (u, v) = place x y in blurredAt h (`inRow` u) v
  where
    (w, h) = templateFrame tables
    wide = paddedWidth tables
    high = paddedHeight tables
    values = rasterValues image
    place = onFrame tables
    across = everywhere h $ \x v -> inRow v (fst (place x 0))
    inRow v = blurredAt w (\u -> V.unsafeIndex values (v * w + u))
    everywhere rows at = V.generate (wide * rows) $ \i -> let (y, x) = i `quotRem` wide in at x y
    {-# INLINE everywhere #-}

-- | What lies at a place along an axis, blurred, of so many taxels that are given by their number.
blurredAt :: Int -> (Int -> Double) -> Double -> Double
blurredAt n value t = go (max 0 (whole - 3)) 0
  where
    (whole, share) = parted t
    end = min (n - 1) (whole + 4)
    -- Note [Bounds of shares]
    go !u !s
      | u > end = s
      | otherwise = go (u + 1) (s + V.unsafeIndex shares (share + u - whole + 3) * value u)
{-# INLINE blurredAt #-}

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
