{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The symbols of an alphabet as a sensor sees them, at every place on a frame. Frames are
-- correlated with these templates to find the lattice of cells under them.
--
-- A symbol at (x, y), the place of the centre of its upper left taxel, makes a taxel at (u, v) read
-- the sum over its embossed taxels (i, j) of g (u - x - i) g (v - y - j). Here g is the share of a
-- taxel's width that a normal blur brings there. Places lie on a grid. If the symbols' axes are
-- turned from the frame's, places turn with them; the blur, nearly the same in all directions, does
-- not.
module PraTactile.Registration.Lattice.Template
  ( LatticeTemplates (..),
    Outline,
    templates,
    LatticeTables,
    latticeTables,
    tablesAt,
    coarser,

    -- * Frames held against them
    correlations,
    correlationsOf,
    TemplateSums (..),
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

-- | An alphabet's templates, upright and half turned, at all places of frames of one size, along
-- axes that are turned from the frames'. Each table is computed on first use.
data LatticeTemplates = LatticeTemplates
  { templatePlaces :: !Places,
    templateSymbols :: !Symbols,
    -- | The shape of each orientation and class.
    templateOutlines :: !(Boxed.Vector Outline),
    -- | What the frame covers.
    templateCover :: Cover,
    -- | 'areaSums' of a frame of ones.
    templateAreas :: Vector Double,
    -- | The sum of each template over the frame, by 'cellIndex' and class.
    templateSums :: Vector Double,
    -- | The sum of each template's squares over the frame, by 'cellIndex' and class.
    templateSquares :: Vector Double,
    -- | All phases of the lattice.
    templatePhases :: Phases,
    -- | The templates at whole taxels only; 'Nothing' if these are.
    templateCoarse :: Maybe LatticeTemplates
  }

-- | The corners of a shape ('symbolsCorners'): their offsets in 'areaSums' from the shape's place,
-- and their factors.
data Outline = Outline !(Vector Int) !(Vector Double)

-- | The templates at whole taxels.
coarser :: LatticeTemplates -> LatticeTemplates
coarser fine = fromMaybe fine (templateCoarse fine)

-- | The templates of an alphabet at an angle (degrees clockwise), for frames of the given width and
-- height.
templates :: Alphabet -> Double -> Int -> Int -> LatticeTemplates
templates = templatesOf . symbolsOf

templatesOf :: Symbols -> Double -> Int -> Int -> LatticeTemplates
templatesOf symbols angle w h =
  (tabled symbols (placesAt angle w h placesPerTaxel))
    { templateCoarse = Just (tabled symbols (placesAt angle w h 1))
    }

-- | The templates for the given places, without coarser ones.
tabled :: Symbols -> Places -> LatticeTemplates
tabled symbols places = tables
  where
    tables =
      LatticeTemplates
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

-- | The templates of an alphabet for any angle and frame size. Those for upright frames of the
-- sensor's size are computed once, on first use.
data LatticeTables = LatticeTables Symbols LatticeTemplates

-- | Prepares an alphabet's tables. Callers who stitch repeatedly should keep them.
latticeTables :: Alphabet -> LatticeTables
latticeTables alphabet =
  LatticeTables symbols (templatesOf symbols 0 sensorSide sensorSide)
  where
    symbols = symbolsOf alphabet

-- | The templates at an angle (degrees clockwise), for frames of the given width and height.
tablesAt :: LatticeTables -> Double -> (Int, Int) -> LatticeTemplates
tablesAt (LatticeTables symbols usual) angle (w, h)
  | angle == 0 && w == sensorSide && h == sensorSide = usual
  | otherwise = templatesOf symbols angle w h

-- | The correlation of an image with each template, by 'cellIndex' and class. The image has the
-- size that the tables are for.
correlations :: LatticeTemplates -> Raster -> Vector Double
correlations tables = correlationsOf tables . areaSums (templatePlaces tables)

-- | The correlations with each template, from the frame's 'areaSums'.
correlationsOf :: LatticeTemplates -> Vector Double -> Vector Double
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
      -- Four places at a time; the last four may overlap those before.
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

{- Note [Bounds of outlines] A place's column is below the grid's width, and a step reaches at most
   8 taxels further, which the width of 'areaSums' holds; for rows it is 12. There are 2 * count
   outlines, and one sum for each cell and class. A row has more than four places, as a symbol is
   wider. -}

-- | The sum over the frame of the squares of each template of some cells, by 'cellIndex'.
squaresOf :: LatticeTemplates -> Vector Int -> Vector Double
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

-- | For some cells and all classes: the correlations with a frame, the sums of the templates, and
-- the sums of their squares.
data TemplateSums = TemplateSums
  { momentsProducts :: !(Vector Double),
    momentsSums :: !(Vector Double),
    momentsSquares :: !(Vector Double)
  }

-- | The moments of a few cells, by 'cellIndex', from a frame's 'areaSums'.
momentsAt :: LatticeTemplates -> Vector Double -> Vector Int -> TemplateSums
momentsAt tables areas cells =
  TemplateSums
    (productsAt tables areas cells)
    (productsAt tables (templateAreas tables) cells)
    (squaresOf tables cells)

-- | The correlations of a few cells, by 'cellIndex', from a frame's 'areaSums'.
productsAt :: LatticeTemplates -> Vector Double -> Vector Int -> Vector Double
productsAt tables areas cells =
  tabulate (symbolsClasses (templateSymbols tables)) (V.length cells) $ \c ->
    placeOf tables (V.unsafeIndex cells c) (outlinedAt tables areas)

-- | The correlation of one template, given 'areaSums', its orientation, row and column of places,
-- and class.
outlinedAt :: LatticeTemplates -> Vector Double -> Int -> Int -> Int -> Int -> Double
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

-- | Applies a function to the orientation, the row and the column of a cell that is given by
-- 'cellIndex'.
placeOf :: LatticeTemplates -> Int -> (Int -> Int -> Int -> a) -> a
placeOf tables cell made = made o y x
  where
    (columns, rows) = placesGrid (templatePlaces tables)
    (row, !x) = cell `quotRem` columns
    (!o, !y) = row `quotRem` rows
{-# INLINE placeOf #-}

-- | Sums by weight, given the templates' sums by weight. The correlations must be by weight
-- already; the sums of squares shrink by the factor by which the sums do.
weighed :: Vector Double -> TemplateSums -> TemplateSums
weighed shares (TemplateSums products sums squares) =
  TemplateSums products shares (V.zipWith3 less shares sums squares)
  where
    less w s q = if s > 1e-6 then q * w / s else q
