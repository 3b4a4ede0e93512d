{-# LANGUAGE BangPatterns #-}

-- | The symbols of an alphabet as tables are made of them, whatever the frames' size and angle:
-- their outlines, and the squares of what they read.
module PraTactile.Registration.Lattice.Symbols
  ( Symbols (..),
    symbolsOf,

    -- * Squares over a frame
    Cover,
    coverOf,
    squaresAt,
  )
where

import Data.Maybe (fromMaybe)
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import PraTactile.Registration.Lattice.Blur (seenAt)
import PraTactile.Registration.Lattice.Places
import PraTactile.Registration.Loops (tabulate)
import PraTactile.Registration.Model (leastShare, placesPerTaxel)
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
    -- | For each orientation and class, and each part of a taxel, down and across, by which it lies
    -- further: the squares of what taxels read of it, in a box that begins the margin before it.
    symbolsSquares :: !(Vector Double)
  }

-- | The symbols of an alphabet.
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
    (w, h) = placesFrame places
    q = placesFineness places
    wide = coverWidth places
    high = coverHeight places
    there =
      tabulate wide (q * high) $ \line ->
        let (part, y) = line `quotRem` high
         in \x ->
              let (u, v) = onFrame places ((x - margin) * q + part) (y - margin * q)
               in covered w u * covered h v
    covered n t = max 0 (min 1 (min (t + 1) (fromIntegral n - t)))
    rows = [V.slice (wide * i) wide there | i <- [0 .. q * high - 1]]

-- | The length of a line of what a frame covers, in taxels, and how many there are.
coverWidth, coverHeight :: Places -> Int
coverWidth places = fst (placesGrid places) `quot` placesFineness places + boxWide - 1
coverHeight places = snd (placesGrid places) + (boxHigh - 1) * placesFineness places

-- | The sum over the frame of the squares of a class's template at a row and a column of places,
-- upright and half turned. Along the frame's axes it is that at its pixels. Turned, it is that at
-- whole taxels from the template's place, each counted for as much of a taxel as the frame has
-- there, which differs at the frame's edge only. Unchecked: there must be that class and place.
squaresAt :: Symbols -> Places -> Cover -> Int -> Int -> Int -> (Double, Double)
squaresAt symbols places (Cover there begins ends) = at
  where
    boxes = symbolsSquares symbols
    q = placesFineness places
    wide = coverWidth places
    high = coverHeight places
    -- Then each of the places within a taxel has a box by itself.
    upright = placesAngle places == 0
    boxSize = boxWide * boxHigh
    shapeSize = boxSize * placesPerTaxel * placesPerTaxel
    halfTurnedAfter = symbolsClasses symbols * shapeSize
    at !y !x !k = down 0 line 0 0
      where
        (!x', !partX) = x `quotRem` q
        !partY = y `rem` q
        !box = k * shapeSize + (if upright then boxSize * (partY * placesPerTaxel + partX) else 0)
        !line = if upright then y - partY else partX * high + y
        -- Note [Bounds of squares]
        down :: Int -> Int -> Double -> Double -> (Double, Double)
        down !b !i !s !t
          | b >= boxHigh = (s, t)
          | otherwise = along (max 0 (V.unsafeIndex begins i - x')) s t
          where
            end = min boxWide (V.unsafeIndex ends i - x')
            along :: Int -> Double -> Double -> (Double, Double)
            along !a !s' !t'
              | a >= end = down (b + 1) (i + q) s' t'
              | otherwise =
                let share = V.unsafeIndex there (i * wide + x' + a)
                    j = box + b * boxWide + a
                 in along
                      (a + 1)
                      (s' + V.unsafeIndex boxes j * share)
                      (t' + V.unsafeIndex boxes (j + halfTurnedAfter) * share)

{- Note [Bounds of squares] A place's column, in taxels, is below the grid's width and a step
   reaches at most the box's width less one further, which the lines of what the frame covers hold;
   likewise for rows. There are as many boxes as classes, orientations and parts. -}
