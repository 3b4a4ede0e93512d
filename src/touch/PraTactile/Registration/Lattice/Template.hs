{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The symbols of an alphabet as a sensor sees them, at every place on a frame: what a frame is
-- held against to find the lattice of cells under it.
--
-- A symbol at (x, y), the place of the centre of its upper left taxel, makes a taxel at (u, v) read
-- the sum over its embossed taxels (i, j) of g (u - x - i) g (v - y - j), where g is the share of a
-- taxel's width that a normal blur brings there. Places lie on a grid of that many to the taxel.
-- The symbols' axes may be turned from the frame's: then places are turned with them, and the blur,
-- which is nearly the same in all directions, is not.
module PraTactile.Registration.Lattice.Template
  ( Templates (..),
    Outline,
    templates,
    LatticeTables,
    latticeTables,
    tablesAt,
    coarser,

    -- * Frames held against them
    correlations,
    correlationsOf,
    Moments (..),
    momentsAt,
    productsAt,
    weighed,
  )
where

import Data.Maybe (fromMaybe)
import qualified Data.Vector as Boxed
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import qualified Data.Vector.Storable.Mutable as M
import PraTactile.Geometry (sensorSide)
import PraTactile.Image (Raster, constant)
import PraTactile.Registration.Lattice.Blur (areaSums)
import PraTactile.Registration.Lattice.Places
import PraTactile.Registration.Lattice.Symbols
import PraTactile.Registration.Loops (tabulate)
import PraTactile.Registration.Numbers (placesPerTaxel)
import PraTactile.Shape (Alphabet)

-- | An alphabet's symbols, upright and half turned, at all places of frames of one size, along axes
-- that are turned from the frames'. Each table is made when it is first looked at.
data Templates = Templates
  { templatePlaces :: !Places,
    templateSymbols :: !Symbols,
    -- | For each orientation and class, its shape.
    templateOutlines :: !(Boxed.Vector Outline),
    -- | What the frame covers.
    templateCover :: Cover,
    -- | 'areaSums' of a frame that is 1 everywhere.
    templateAreas :: Vector Double,
    -- | The sum of each template over the frame, indexed by 'cellIndex' and class.
    templateSums :: Vector Double,
    -- | The sum of its squares, likewise.
    templateSquares :: Vector Double,
    -- | All phases of the lattice.
    templatePhases :: Phases,
    -- | The same at whole taxels only.
    templateCoarse :: Maybe Templates
  }

-- | The corners of a shape ('symbolsCorners') as steps from its place on the grid of the sums of
-- areas, and how often each counts.
data Outline = Outline !(Vector Int) !(Vector Double)

-- | The same at whole taxels, if these are finer.
coarser :: Templates -> Templates
coarser fine = fromMaybe fine (templateCoarse fine)

-- | The tables for an alphabet whose axes are turned by so many degrees clockwise, and frames of
-- that width and height.
templates :: Alphabet -> Double -> Int -> Int -> Templates
templates = templatesOf . symbolsOf

templatesOf :: Symbols -> Double -> Int -> Int -> Templates
templatesOf symbols angle w h =
  (tabled symbols (placesAt angle w h placesPerTaxel))
    { templateCoarse = Just (tabled symbols (placesAt angle w h 1))
    }

-- | The tables for those places alone.
tabled :: Symbols -> Places -> Templates
tabled symbols places = tables
  where
    tables =
      Templates
        { templatePlaces = places,
          templateSymbols = symbols,
          templateOutlines = Boxed.fromList (map outline (symbolsCorners symbols)),
          templateCover = coverOf places,
          templateAreas = areaSums places (uncurry constant (placesFrame places) 1),
          templateSums = correlationsOf tables (templateAreas tables),
          templateSquares =
            squaresOf tables (V.enumFromN 0 (2 * uncurry (*) (placesGrid places))),
          templatePhases = phasesOf places [0 .. phaseTotal places - 1],
          templateCoarse = Nothing
        }
    outline corners =
      Outline
        ( V.fromList
            [(y * areasWidth places + x) * placesFineness places | (x, y, _) <- corners]
        )
        (V.fromList [count | (_, _, count) <- corners])

-- | The tables of an alphabet at any angle and for frames of any size: those for upright frames of
-- the sensor's size are made once, when they are first looked at.
data LatticeTables = LatticeTables Symbols Templates

-- | Those of an alphabet, to be kept by whoever puts frames together again and again.
latticeTables :: Alphabet -> LatticeTables
latticeTables alphabet =
  LatticeTables symbols (templatesOf symbols 0 sensorSide sensorSide)
  where
    symbols = symbolsOf alphabet

-- | The tables for axes turned by so many degrees clockwise, and frames of that width and height.
tablesAt :: LatticeTables -> Double -> (Int, Int) -> Templates
tablesAt (LatticeTables symbols usual) angle (w, h)
  | angle == 0 && w == sensorSide && h == sensorSide = usual
  | otherwise = templatesOf symbols angle w h

-- | The sum over the frame of its values times each template: by class, at each place, in each
-- orientation. The image has the size that the tables are for.
correlations :: Templates -> Raster -> Vector Double
correlations tables = correlationsOf tables . areaSums (templatePlaces tables)

-- | The same from the frame's 'areaSums'.
correlationsOf :: Templates -> Vector Double -> Vector Double
correlationsOf tables !areas = V.create $ do
  sums <- M.unsafeNew (2 * rows * columns * count)
  let orientation !o
        | o >= 2 = pure ()
        | otherwise = class' o 0 >> orientation (o + 1)
      class' !o !k
        | k >= count = pure ()
        | otherwise = do
          row (Boxed.unsafeIndex outlines (o * count + k)) 0 (cellIndex places o 0 0 * count + k)
          class' o (k + 1)
      row !shape !y !i
        | y >= rows = pure ()
        | otherwise = four shape y i 0 >> row shape (y + 1) (i + columns * count)
      -- Four places at a time, the last of which may be among those before.
      four shape@(Outline steps counts) !y !i !x
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
                  let from = V.unsafeDrop (start + V.unsafeIndex steps c) areas
                      n = V.unsafeIndex counts c
                   in summed
                        (c + 1)
                        (s0 + n * V.unsafeIndex from 0)
                        (s1 + n * V.unsafeIndex from 1)
                        (s2 + n * V.unsafeIndex from 2)
                        (s3 + n * V.unsafeIndex from 3)
          summed 0 0 0 0 0
          four shape y i (x + 4)
  -- Note [Bounds of outlines]
  orientation (0 :: Int)
  pure sums
  where
    places = templatePlaces tables
    !outlines = templateOutlines tables
    !(!columns, !rows) = placesGrid places
    !count = symbolsClasses (templateSymbols tables)
    !wide = areasWidth places

{- Note [Bounds of outlines] A place's column is below the grid's width and a step reaches at most 8
   taxels further, which the width of the sums of areas holds; likewise for rows, 12. There are
   2 * count outlines, and one sum for each cell and class. A row has more than four places, as a
   symbol is wider. -}

-- | The sum over the frame of the squares of each template of some cells, by 'cellIndex'.
squaresOf :: Templates -> Vector Int -> Vector Double
squaresOf tables cells = V.create $ do
  sums <- M.unsafeNew (count * V.length cells)
  let write = writeSquares (templateSymbols tables) places (templateCover tables) sums
      cell !c
        | c >= V.length cells = pure ()
        | otherwise = do
          placeOf tables (V.unsafeIndex cells c) (write (c * count))
          cell (c + 1)
  cell (0 :: Int)
  pure sums
  where
    places = templatePlaces tables
    count = symbolsClasses (templateSymbols tables)

-- | For some cells and all classes, in this order: the correlations of a frame, the sums of the
-- templates and those of their squares.
data Moments = Moments
  { momentsProducts :: !(Vector Double),
    momentsSums :: !(Vector Double),
    momentsSquares :: !(Vector Double)
  }

-- | The numbers of a few cells, by 'cellIndex', from a frame's 'areaSums'.
momentsAt :: Templates -> Vector Double -> Vector Int -> Moments
momentsAt tables areas cells =
  Moments
    (productsAt tables areas cells)
    (productsAt tables (templateAreas tables) cells)
    (squaresOf tables cells)

-- | The correlations alone.
productsAt :: Templates -> Vector Double -> Vector Int -> Vector Double
productsAt tables areas cells =
  tabulate (symbolsClasses (templateSymbols tables)) (V.length cells) $ \c ->
    placeOf tables (V.unsafeIndex cells c) (outlinedAt tables areas)

-- | That of an orientation, a row and a column of places, and a class.
outlinedAt :: Templates -> Vector Double -> Int -> Int -> Int -> Int -> Double
outlinedAt tables !areas !o !y !x !k = go 0 0
  where
    -- Note [Bounds of outlines]
    !(Outline !steps !counts) =
      Boxed.unsafeIndex
        (templateOutlines tables)
        (o * symbolsClasses (templateSymbols tables) + k)
    !start = y * areasWidth (templatePlaces tables) + x
    go !c !s
      | c >= V.length steps = s
      | otherwise =
        go
          (c + 1)
          (s + V.unsafeIndex counts c * V.unsafeIndex areas (start + V.unsafeIndex steps c))

-- | What is made of the orientation, the row and the column of a cell that is given by 'cellIndex'.
placeOf :: Templates -> Int -> (Int -> Int -> Int -> a) -> a
placeOf tables cell made = made o y x
  where
    (columns, rows) = placesGrid (templatePlaces tables)
    (row, !x) = cell `quotRem` columns
    (!o, !y) = row `quotRem` rows
{-# INLINE placeOf #-}

-- | Where taxels count w each: the correlations are those of w z, the sums of the templates those
-- of w, which are given; and the sums of their squares as much less as these.
weighed :: Vector Double -> Moments -> Moments
weighed shares (Moments products sums squares) =
  Moments products shares (V.zipWith3 less shares sums squares)
  where
    less w s q = if s > 1e-6 then q * w / s else q
