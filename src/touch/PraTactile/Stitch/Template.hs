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
    thinned,
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
import PraTactile.Stitch.Tabulate (tabulate)

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

-- | Of numbers by 'cellIndex' and class those at whole taxels, in the same order.
thinned :: Templates -> Vector Double -> Vector Double
thinned fine numbers = tabulate (count * columns) (2 * rows) $ \y ->
  let (o, r) = y `quotRem` rows
      !start = cellIndex fine o (q * r) 0 * count
   in \i -> let (x, k) = i `quotRem` count in V.unsafeIndex numbers (start + q * x * count + k)
  where
    q = templatePlaces fine
    count = templateClasses fine
    (columns, rows) = let (across, down) = templateGrid fine in (across `quot` q, down `quot` q)

-- | The symbols of an alphabet as the tables need them, whatever their angle and the frames' size.
data Symbols = Symbols
  { symbolsClasses :: !Int,
    -- | For each orientation and class, its corners: column, row, and how often the sum of the area
    -- up to there counts.
    symbolsCorners :: [[(Int, Int, Double)]],
    -- | For each orientation and class, and each part of a taxel down and across that it may lie
    -- further, the squares of the template on a box of 'boxWide' columns and 'boxHigh' rows, whose
    -- first lie the margin before the symbol's.
    symbolsSquares :: !(Vector Double)
  }

symbolsOf :: Alphabet -> Symbols
symbolsOf alphabet =
  Symbols (length (shapes alphabet)) (map corners bitmaps) (V.concat (map drawn bitmaps))
  where
    bitmaps = shapes alphabet ++ map halfTurned (shapes alphabet)
    corners b =
      [ (x, y, count)
        | y <- [0 .. symbolHeight],
          x <- [0 .. symbolWidth],
          let before = covered (x - 1) (y - 1) - covered x (y - 1)
              count = before - covered (x - 1) y + covered x y,
          count /= 0
      ]
      where
        covered x y = if embossedAt b x y then 1 else 0
    parts = [fromIntegral i / fromIntegral placesPerTaxel | i <- [0 .. placesPerTaxel - 1]]
    drawn b = V.concat [squaresAt b x y | y <- parts, x <- parts]
    squaresAt b partX partY =
      tabulate boxWide boxHigh $ \v u ->
        squared
          ( sum
              [ V.unsafeIndex acrossRows (u + boxWide * j) * V.unsafeIndex downShares (v - j)
                | j <- [max 0 (v - 2 * margin) .. min (symbolHeight - 1) v]
              ]
          )
      where
        acrossRows =
          tabulate boxWide symbolHeight $ \j u ->
            sum
              [ V.unsafeIndex acrossShares (u - i)
                | i <- [max 0 (u - 2 * margin) .. min (symbolWidth - 1) u],
                  embossedAt b i j
              ]
        acrossShares = sharesAround partX
        downShares = sharesAround partY
    sharesAround t =
      V.generate (2 * margin + 1) (\d -> seenAt (fromIntegral (d - margin) - t)) :: Vector Double
    -- Next to nothing is nothing.
    squared t = if t * t > 1e-4 then t * t else 0

-- | The tables for an alphabet whose axes are turned by so many degrees clockwise, and frames of
-- that width and height.
templates :: Alphabet -> Double -> Int -> Int -> Templates
templates = fineTemplates . symbolsOf

fineTemplates :: Symbols -> Double -> Int -> Int -> Templates
fineTemplates symbols angle w h = fine {templateCoarse = Just coarse}
  where
    fine = tabled symbols angle w h placesPerTaxel
    coarse =
      (bareTemplates symbols angle w h 1)
        { templateSums = thinned fine (templateSums fine),
          templateSquares = thinned fine (templateSquares fine)
        }

-- | The tables at so many places to the taxel.
tabled :: Symbols -> Double -> Int -> Int -> Int -> Templates
tabled symbols angle w h q =
  bare
    { templateSums = correlations bare (constant w h 1),
      templateSquares = squaresOf bare (symbolsSquares symbols)
    }
  where
    bare = bareTemplates symbols angle w h q

-- | The same without the sums.
bareTemplates :: Symbols -> Double -> Int -> Int -> Int -> Templates
bareTemplates symbols angle w h q = bare
  where
    bare =
      Templates
        { templateFrame = (w, h),
          templateAngle = angle,
          templateClasses = symbolsClasses symbols,
          templatePlaces = q,
          templateFirst = (left - symbolWidth - fringe, top - symbolHeight - fringe),
          templateGrid =
            ((wide + symbolWidth + 2 * fringe) * q, (high + symbolHeight + 2 * fringe) * q),
          templateOutlines = Boxed.fromList (map outline (symbolsCorners symbols)),
          templateSums = V.empty,
          templateSquares = V.empty,
          templateCoarse = Nothing
        }
    outline corners =
      Outline
        (V.fromList [(y * areasWidth bare + x) * q | (x, y, _) <- corners])
        (V.fromList [count | (_, _, count) <- corners])
    ends =
      [ turnedBy (negate angle) (fromIntegral x, fromIntegral y)
        | x <- [0, w - 1],
          y <- [0, h - 1]
      ]
    (left, wide) = extent (map fst ends)
    (top, high) = extent (map snd ends)
    -- The first whole number, and how many reach to the last.
    extent :: [Double] -> (Int, Int)
    extent ts =
      let first = floor (minimum ts + 1e-9) in (first, ceiling (maximum ts - 1e-9) - first + 1)

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
    made known = PaperTables at (\angle (w, h) -> tabled symbols angle w h 1)
      where
        at angle (w, h)
          | angle == 0 && w == sensorSide && h == sensorSide = usual
          | otherwise = fineTemplates symbols angle w h
        usual = fineTemplates symbols 0 sensorSide sensorSide
        symbols = symbolsOf known
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
correlations tables image = V.create $ do
  sums <- M.unsafeNew (2 * rows * columns * count)
  let orientation !o
        | o >= 2 = pure ()
        | otherwise = class' o 0 >> orientation (o + 1)
      class' !o !k
        | k >= count = pure ()
        | otherwise = do
          let Outline steps counts = Boxed.unsafeIndex (templateOutlines tables) (o * count + k)
          row steps counts 0 (cellIndex tables o 0 0 * count + k)
          class' o (k + 1)
      row steps counts !y !i
        | y >= rows = pure ()
        | otherwise = four steps counts y i 0 >> row steps counts (y + 1) (i + columns * count)
      -- Four places at a time, the last of which may be among those before.
      four steps counts !y !i !x
        | x >= columns = pure ()
        | otherwise = do
          let x' = min x (columns - 4)
              start = y * wide + x'
              summed !c !s0 !s1 !s2 !s3
                | c >= V.length steps = do
                  let j = i + x' * count
                  M.unsafeWrite sums j s0
                  M.unsafeWrite sums (j + count) s1
                  M.unsafeWrite sums (j + 2 * count) s2
                  M.unsafeWrite sums (j + 3 * count) s3
                | otherwise =
                  let j = start + V.unsafeIndex steps c
                      n = V.unsafeIndex counts c
                   in summed
                        (c + 1)
                        (s0 + n * V.unsafeIndex areas j)
                        (s1 + n * V.unsafeIndex areas (j + 1))
                        (s2 + n * V.unsafeIndex areas (j + 2))
                        (s3 + n * V.unsafeIndex areas (j + 3))
          summed 0 0 0 0 0
          four steps counts y i (x + 4)
  -- Note [Bounds of outlines]
  orientation (0 :: Int)
  pure sums
  where
    (columns, rows) = templateGrid tables
    count = templateClasses tables
    areas = areaSums tables (spread tables image)
    wide = areasWidth tables

{- Note [Bounds of outlines] A place's column is below the grid's width and a step reaches at most 8
   taxels further, which the width of the sums of areas holds; likewise for rows, 12. There are
   2 * count outlines, and for each cell and class one sum. A row has more than four places, as a
   symbol is wider. -}

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
    tabulate wide high $ \y ->
      let !near = parted (snd (place 0 y))
       in \x -> blurredAt h (\v -> V.unsafeIndex across (x * h + v)) near
  | otherwise =
    tabulate wide high $ \y x ->
      let (u, v) = place x y
          near = parted u
       in blurredAt h (\v' -> inRow v' near) (parted v)
  where
    (w, h) = templateFrame tables
    wide = paddedWidth tables
    high = paddedHeight tables
    values = rasterValues image
    place = onFrame tables
    -- By columns.
    across =
      tabulate h wide $ \x -> let !near = parted (fst (place x 0)) in \v -> inRow v near
    inRow v = blurredAt w (\u -> V.unsafeIndex values (v * w + u))

-- | What lies at a place along an axis, as 'parted', blurred, of so many taxels that are given by
-- their number.
blurredAt :: Int -> (Int -> Double) -> Parted -> Double
blurredAt n value (Parted whole share) = go (max 0 (whole - 3)) 0
  where
    end = min (n - 1) (whole + 4)
    first = share - whole + 3
    -- Note [Bounds of shares]
    go !u !s
      | u > end = s
      | otherwise = go (u + 1) (s + V.unsafeIndex shares (first + u) * value u)
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
data Parted = Parted !Int !Int

parted :: Double -> Parted
parted t = Parted whole (8 * round (fromIntegral partsOfTaxel * (t - fromIntegral whole)))
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

-- | The sum over the frame of the squares of each template at each place, from those on a box
-- around it. Along the frame's axes it is that at its pixels. Turned, it is that at whole taxels
-- from the template's place, each counted for as much of a taxel as the frame has there, which
-- differs at the frame's edge only.
squaresOf :: Templates -> Vector Double -> Vector Double
squaresOf tables boxes = V.create $ do
  sums <- M.unsafeNew (2 * rows * columns * count)
  let row !y
        | y >= rows = pure ()
        | otherwise = column y 0 >> row (y + 1)
      column !y !x
        | x >= columns = pure ()
        | otherwise = do
          let (x', partX) = x `quotRem` q
              partY = y `rem` q
              -- Which of the boxes, and the grid's lines of the box's rows.
              box = if upright then partY * placesPerTaxel + partX else 0
              line = if upright then y - partY else partX * high + y
          class' y x (box * boxSize) line x' 0
          column y (x + 1)
      class' !y !x !box !line !x' !k
        | k >= count = pure ()
        | otherwise = do
          let first = box + k * boxSize * partCount
              second = first + count * boxSize * partCount
              summed !b !i !s !t
                | b >= boxHigh = do
                  M.unsafeWrite sums (cellIndex tables 0 y x * count + k) s
                  M.unsafeWrite sums (cellIndex tables 1 y x * count + k) t
                | otherwise =
                  let from = max 0 (V.unsafeIndex begins i - x')
                      to = min boxWide (V.unsafeIndex ends i - x')
                      cells = i * wide + x'
                      along !a !s' !t'
                        | a >= to = summed (b + 1) (i + q) s' t'
                        | otherwise =
                          let share = V.unsafeIndex there (cells + a)
                              at = b * boxWide + a
                           in along
                                (a + 1)
                                (s' + V.unsafeIndex boxes (first + at) * share)
                                (t' + V.unsafeIndex boxes (second + at) * share)
                   in along from s t
          summed (0 :: Int) line 0 (0 :: Double)
          class' y x box line x' (k + 1)
  -- Note [Bounds of squares]
  row 0
  pure sums
  where
    (w, h) = templateFrame tables
    (columns, rows) = templateGrid tables
    count = templateClasses tables
    q = templatePlaces tables
    -- Then each of the places within a taxel has a box by itself.
    upright = templateAngle tables == 0
    boxSize = boxWide * boxHigh
    partCount = placesPerTaxel * placesPerTaxel
    -- How much of a taxel the frame has at each place, of a grid that begins the margin before: of
    -- each row the columns at whole taxels, of all rows; then those a place further, and so on.
    wide = columns `quot` q + boxWide - 1
    high = rows + (boxHigh - 1) * q
    there =
      tabulate wide (q * high) $ \line ->
        let (part, y) = line `quotRem` high
         in \x ->
              let (u, v) = onFrame tables ((x - margin) * q + part) (y - margin * q)
               in within w u * within h v
    within n t = max 0 (min 1 (min (t + 1) (fromIntegral n - t)))
    -- In each of its lines, where the frame begins and where it has ended.
    lines' = [V.slice (wide * i) wide there | i <- [0 .. q * high - 1]]
    begins = V.fromList [fromMaybe wide (V.findIndex (> 0) l) | l <- lines']
    ends = V.fromList [wide - fromMaybe wide (V.findIndex (> 0) (V.reverse l)) | l <- lines']

{- Note [Bounds of squares] A place's column, in taxels, is below the grid's width and a step reaches
   at most the box's width less one further, which the grid of what the frame has there holds;
   likewise for rows. There are as many boxes as classes, orientations and parts. -}

-- | How far around a symbol its squares are summed, in taxels, and the box that this makes.
margin, boxWide, boxHigh :: Int
margin = 3
boxWide = symbolWidth + 2 * margin
boxHigh = symbolHeight + 2 * margin
