{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The symbols of an alphabet as tables are made of them, whatever the frames' size and angle:
-- their outlines, and the squares of what they read.
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
    -- | For each orientation and class its corners: column, row, and how often the sum of the area
    -- up to there counts, so that what remains is the sum over the shape. That is the second
    -- difference of the shape's bitmap, across and down.
    symbolsCorners :: [[(Int, Int, Double)]],
    -- | For each orientation, and each part of a taxel, down and across, by which a symbol lies
    -- further: what taxels read of each class, squared, in a box that begins the margin before it.
    symbolsSquares :: !(Vector Double)
  }

-- | The symbols of an alphabet.
symbolsOf :: Alphabet -> Symbols
symbolsOf alphabet =
  Symbols count (map corners (upright ++ turned)) (V.concat (map squares [upright, turned]))
  where
    count = length upright
    upright = shapes alphabet
    turned = map halfTurned upright
    -- The classes beside one another.
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

{- Note [Bounds of boxes] A taxel of the box is at most three taxels from those that are looked at
   for it. -}

-- | How far the taxels lie that a taxel reads something of, and how much nearer the edge of a box
-- is to its symbol.
far, within :: Int
far = 3
within = far - margin

-- | How far around a symbol its squares are summed, in taxels, and the box that this makes: beyond,
-- less than the least share is read of it.
margin, boxWide, boxHigh :: Int
margin = 2
boxWide = symbolWidth + 2 * margin
boxHigh = symbolHeight + 2 * margin

-- | How much of a taxel the frame has at each place of a grid that begins the margin before the
-- first: of each row of places those at whole taxels, of all rows; then those a place further, and
-- so on. In each of these lines, where the frame begins and where it has ended.
data Cover = Cover !(Vector Double) !(Vector Int) !(Vector Int)

-- | What a frame covers.
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

-- | The length of a line of what a frame covers, in taxels, and how many there are.
coverWidth, coverHeight :: Places -> Int
coverWidth places = fst (placesGrid places) `quot` placesFineness places + boxWide - 1
coverHeight places = snd (placesGrid places) + (boxHigh - 1) * placesFineness places

-- | The sums over the frame of the squares of all classes' templates in a cell of an orientation,
-- a row and a column of places, written from an index on. Along the frame's axes they are those at
-- its pixels. Turned, they are those at whole taxels from the template's place, each counted for as
-- much of a taxel as the frame has there, which differs at the frame's edge only. Unchecked: there
-- must be that cell, and room.
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
    -- Then each of the places within a taxel has a box by itself.
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

-- | Classes are summed four at a time: so many of which some may be none.
inFours :: Int -> Int
inFours count = 4 * ((count + 3) `quot` 4)

{- Note [Bounds of squares] A place's column, in taxels, is below the grid's width and a step
   reaches at most the box's width less one further, which the lines of what the frame covers hold;
   likewise for rows. There are as many boxes as orientations and parts, each of as many numbers as
   taxels and classes in fours. -}
