{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The symbols of an alphabet, prepared for tables of any frame size and angle: their outlines,
-- and their squared readings.
module PraTactile.Registration.Lattice.Symbols
  ( Symbols (..),
    symbolsOf,

    -- * Squares over a frame
    Cover,
    coverOf,
    writeSquares,
  )
where

import Control.Monad (when)
import Control.Monad.ST (ST)
import Data.Maybe (fromMaybe)
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import qualified Data.Vector.Storable.Mutable as M
import PraTactile.Registration.Lattice.Blur (seenAt)
import PraTactile.Registration.Lattice.Places
import PraTactile.Registration.Loops (tabulate)
import PraTactile.Registration.Numbers (leastShare, placesPerTaxel)
import PraTactile.Shape
  ( Alphabet,
    embossedAt,
    halfTurned,
    shapes,
    symbolHeight,
    symbolWidth,
  )

-- | The symbols of an alphabet, upright and then half turned.
data Symbols = Symbols
  { -- | The number of classes.
    symbolsClasses :: !Int,
    -- | For each orientation and class the corners of its shape: column, row, and the factor of the
    -- summed area there. The factors are the second difference of the bitmap, across and down, so
    -- that their total is the sum over the shape.
    symbolsCorners :: [[(Int, Int, Double)]],
    -- | The squared readings of each class in a box that begins 'margin' before the symbol. There
    -- is a box for each orientation, and for each fraction of a taxel, down and across, by which
    -- the symbol is shifted.
    symbolsSquares :: !(Vector Double)
  }

-- | Prepares the symbols of an alphabet.
symbolsOf :: Alphabet -> Symbols
symbolsOf alphabet =
  Symbols count (map corners (upright ++ turned)) (V.concat (map squares [upright, turned]))
  where
    count = length upright
    upright = shapes alphabet
    turned = map halfTurned upright
    -- The classes side by side, filled up to a multiple of four.
    squares bitmaps =
      let byClass = V.concat (map drawn bitmaps)
          size = V.length byClass `quot` max 1 count
       in tabulate (inFours count) size $ \i k ->
            if k < count then V.unsafeIndex byClass (k * size + i) else 0
    corners b =
      [ (x, y, often)
        | y <- [0 .. symbolHeight],
          x <- [0 .. symbolWidth],
          let before = covered (x - 1) (y - 1) - covered x (y - 1)
              often = before - covered (x - 1) y + covered x y,
          often /= 0
      ]
      where
        covered x y = if embossedAt b x y then 1 else 0
    parts = [fromIntegral i / fromIntegral placesPerTaxel | i <- [0 .. placesPerTaxel - 1]]
    drawn b = V.concat [boxOf b x y | y <- parts, x <- parts]
    boxOf b partX partY =
      tabulate boxWide boxHigh $ \v u ->
        squared
          ( sum
              [ V.unsafeIndex across (j * boxWide + u) * V.unsafeIndex downShares (v + within - j)
                | j <- [max 0 (v + within - 2 * far) .. min (symbolHeight - 1) (v + within)]
              ]
          )
      where
        -- Note [Bounds of boxes]
        across =
          tabulate boxWide symbolHeight $ \j u ->
            sum
              [ V.unsafeIndex acrossShares (u + within - i)
                | i <- [max 0 (u + within - 2 * far) .. min (symbolWidth - 1) (u + within)],
                  embossedAt b i j
              ]
        acrossShares = sharesAround partX
        downShares = sharesAround partY
    sharesAround :: Double -> Vector Double
    sharesAround t = V.generate (2 * far + 1) (\d -> seenAt (fromIntegral (d - far) - t))
    squared t = if t * t > leastShare * leastShare then t * t else 0

{- Note [Bounds of boxes] A taxel of the box is at most three taxels from the taxels that are summed
   for it. -}

-- | far: how many taxels away a taxel still reads something. within: how much nearer to its symbol
-- the edge of a box is.
far, within :: Int
far = 3
within = far - margin

-- | margin: the taxels around a symbol over which its squares are summed; beyond, less than
-- 'leastShare' is read. boxWide, boxHigh: the size of the box.
margin, boxWide, boxHigh :: Int
margin = 2
boxWide = symbolWidth + 2 * margin
boxHigh = symbolHeight + 2 * margin

-- | The share of each taxel that lies on the frame, on a grid of places that begins 'margin' before
-- the first. Its lines are all rows of places at whole taxels, then all rows one place further, and
-- so on. The last two vectors have where the frame begins and ends in each line.
data Cover = Cover !(Vector Double) !(Vector Int) !(Vector Int)

-- | The cover of a frame.
coverOf :: Places -> Cover
coverOf places =
  Cover
    there
    (V.fromList [fromMaybe wide (V.findIndex (> 0) l) | l <- rows])
    (V.fromList [wide - fromMaybe wide (V.findIndex (> 0) (V.reverse l)) | l <- rows])
  where
    !(!w, !h) = placesFrame places
    !q = placesFineness places
    wide = coverWidth places
    !high = coverHeight places
    !axes = axesOf places
    there =
      tabulate wide (q * high) $ \line ->
        let (part, y) = line `quotRem` high
         in \x ->
              let (u, v) = onFrame axes ((x - margin) * q + part) (y - margin * q)
               in covered w u * covered h v
    covered n t = max 0 (min 1 (min (t + 1) (fromIntegral n - t)))
    rows = [V.slice (wide * i) wide there | i <- [0 .. q * high - 1]]

-- | coverWidth: the length of a cover's lines, taxels. coverHeight: the number of lines for each
-- fraction of a taxel.
coverWidth, coverHeight :: Places -> Int
coverWidth places = fst (placesGrid places) `quot` placesFineness places + boxWide - 1
coverHeight places = snd (placesGrid places) + (boxHigh - 1) * placesFineness places

-- | Writes the sums over the frame of the squares of all classes' templates in one cell, from an
-- index on. The arguments are the symbols, places, cover, target, index, orientation, row and
-- column. Along the frame's axes the sums go over its pixels. At an angle they go over whole taxels
-- from the template's place, weighted by the share of each on the frame; the weights matter at the
-- frame's edge only. Unchecked: the cell must exist, and the target must have room.
writeSquares ::
  Symbols -> Places -> Cover -> M.MVector s Double -> Int -> Int -> Int -> Int -> ST s ()
writeSquares symbols places (Cover !there !begins !ends) !sums = at
  where
    !boxes = symbolsSquares symbols
    !count = symbolsClasses symbols
    !fours = inFours count
    !q = placesFineness places
    !wide = coverWidth places
    !high = coverHeight places
    -- Upright, each fraction of a taxel has a box of its own.
    !upright = placesAngle places == 0
    !boxSize = boxWide * boxHigh * fours
    !halfTurnedAfter = boxSize * placesPerTaxel * placesPerTaxel
    at !start !o !y !x = four 0
      where
        (!x', !partX) = x `quotRem` q
        !partY = y `rem` q
        !box =
          o * halfTurnedAfter + (if upright then boxSize * (partY * placesPerTaxel + partX) else 0)
        !line = if upright then y - partY else partX * high + y
        four !k
          | k >= count = pure ()
          | otherwise = down k 0 line 0 0 0 0 >> four (k + 4)
        -- Note [Bounds of squares]
        down !k !b !i !s0 !s1 !s2 !s3
          | b >= boxHigh = do
            M.unsafeWrite sums (start + k) s0
            when (k + 1 < count) (M.unsafeWrite sums (start + k + 1) s1)
            when (k + 2 < count) (M.unsafeWrite sums (start + k + 2) s2)
            when (k + 3 < count) (M.unsafeWrite sums (start + k + 3) s3)
          | otherwise = along (max 0 (V.unsafeIndex begins i - x')) s0 s1 s2 s3
          where
            !end = min boxWide (V.unsafeIndex ends i - x')
            along !a !t0 !t1 !t2 !t3
              | a >= end = down k (b + 1 :: Int) (i + q) t0 t1 t2 t3
              | otherwise =
                let share = V.unsafeIndex there (i * wide + x' + a)
                    from = V.unsafeDrop (box + (b * boxWide + a) * fours + k) boxes
                 in along
                      (a + 1)
                      (t0 + share * V.unsafeIndex from 0)
                      (t1 + share * V.unsafeIndex from 1)
                      (t2 + share * V.unsafeIndex from 2)
                      (t3 + share * V.unsafeIndex from 3)

-- | The number of classes, rounded up to a multiple of four, since four are summed at a time.
inFours :: Int -> Int
inFours count = 4 * ((count + 3) `quot` 4)

{- Note [Bounds of squares] A place's column, in taxels, is below the grid's width, and a step
   reaches at most boxWide - 1 further; a line of the cover is that long. The same holds for rows.
   There are as many boxes as orientations and fractions, each with a number for every taxel and
   class, in fours. -}
