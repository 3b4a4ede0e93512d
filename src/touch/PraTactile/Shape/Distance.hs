{-# OPTIONS_HADDOCK hide #-}

-- | How far apart shapes are, and how unlike the ordinary features of objects: the numbers behind
-- the paper's three conditions on its symbols (section II.B).
module PraTactile.Shape.Distance
  ( -- * Distance between shapes
    distance,
    Nearest (..),
    nearest,
    selfDistance,
    separation,

    -- * Many comparisons
    Prepared,
    prepared,
    farApart,

    -- * Likeness to ordinary features
    Feature (..),
    ordinaryFeatures,
    raises,
    likeness,
    greatestLikeness,
  )
where

import Data.Bits (popCount, setBit, shift, xor)
import Data.List (foldl', minimumBy, tails)
import Data.Ord (comparing)
import PraTactile.Shape
import PraTactile.Symmetry

-- | The least number of taxels in which the first shape differs from the second, transformed and
-- then shifted by -1, 0 or 1 taxel in each direction; what a shift pushes out of the box still
-- counts.
distance :: Symmetry -> Bitmap -> Bitmap -> Int
distance symmetry a b = minimum (differences symmetry a b)

-- | The differences for the nine shifts.
differences :: Symmetry -> Bitmap -> Bitmap -> [Int]
differences symmetry a b =
  [popCount (xor (canvas identity a) (shift there (shiftBits k))) | k <- shifts]
  where
    there = canvas symmetry b

-- | Where two shapes are nearest: the second transformed, then shifted by so many taxels to the
-- right and down, and in how many taxels the first then differs from it.
data Nearest = Nearest
  { nearestDistance :: !Int,
    nearestSymmetry :: !Symmetry,
    nearestShift :: !(Int, Int)
  }
  deriving stock (Eq, Show)

-- | The least of the distances under some symmetries, identity if there are none; the first of
-- those that are as little.
nearest :: [Symmetry] -> Bitmap -> Bitmap -> Nearest
nearest among a b = minimumBy (comparing nearestDistance) (concatMap under (headed among))
  where
    under symmetry = zipWith (\d k -> Nearest d symmetry k) (differences symmetry a b) shifts
    headed list = if null list then [identity] else list

-- | A shape made ready to be compared with many others: on its canvas, and everywhere it is taken
-- for under a symmetry and a shift.
data Prepared = Prepared !Integer [Integer]

-- | Prepares a shape.
prepared :: Bitmap -> Prepared
prepared b =
  Prepared
    (canvas identity b)
    [shift (canvas symmetry b) (shiftBits k) | symmetry <- symmetries, k <- shifts]

-- | Whether the 'distance' between two shapes is at least this under every symmetry. Stops where
-- they are first seen to be nearer.
farApart :: Int -> Prepared -> Prepared -> Bool
farApart d (Prepared here _) (Prepared _ there) =
  all (\moved -> popCount (xor here moved) >= d) there

-- | The nine shifts, in taxels to the right and down.
shifts :: [(Int, Int)]
shifts = [(x, y) | y <- [0, -1, 1], x <- [0, -1, 1]]

-- | The same of a canvas.
shiftBits :: (Int, Int) -> Int
shiftBits (x, y) = x + canvasSide * y

-- | The side of a square canvas that keeps at least 2 flat taxels around a shape, upright or lying,
-- so that no shift by a taxel wraps.
canvasSide :: Int
canvasSide = 16

-- | The transformed shape in the middle of a canvas, as the set of its embossed taxels.
canvas :: Symmetry -> Bitmap -> Integer
canvas symmetry b =
  foldl'
    setBit
    0
    [(y + top) * canvasSide + x + left | (y, row) <- zip [0 ..] rows, (x, True) <- zip [0 ..] row]
  where
    rows = onRows symmetry (bitmapRows b)
    top = (canvasSide - length rows) `div` 2
    left = (canvasSide - maximum (0 : map length rows)) `div` 2

-- | The least distance of a shape from itself turned or mirrored: how plainly it shows its
-- orientation and handedness.
selfDistance :: Bitmap -> Int
selfDistance b = minimum [distance symmetry b b | symmetry <- drop 1 symmetries]

-- | The least distance in an alphabet: between any two shapes under all eight symmetries, and from
-- each shape to itself under the seven others than the identity.
separation :: Alphabet -> Int
separation a =
  minimum
    ( map selfDistance these
        ++ [distance symmetry x y | x : others <- tails these, y <- others, symmetry <- symmetries]
    )
  where
    these = shapes a

-- | A feature that objects without any code have too, as it may lie across an 8 x 12 window.
-- Lengths are in half taxels from the window's centre, x to the right and y down, so that all of it
-- is exact.
data Feature
  = -- | Everything raised.
    Full
  | -- | A half plane raised: a x + b y >= c for the direction (a, b).
    StepEdge (Int, Int) Int
  | -- | A ridge or groove's wall to wall: c <= a x + b y < d.
    Ridge (Int, Int) Int Int
  | -- | A right-angled corner raised: a x + b y >= c and a y - b x >= d.
    Corner (Int, Int) Int Int
  | -- | A disc raised, with its centre and radius.
    Disc (Int, Int) Int
  deriving stock (Eq, Show)

-- | Step edges and right-angled corners in 16 directions (the axes, the diagonals and those
-- between) at every taxel, up to 5 and 4 from the window's middle; ridges 2, 3, 4 and 6 taxels wide
-- in the same directions, which begin at every half taxel from 6 before the middle to 5 behind;
-- discs from 3 to 6 taxels in radius around every taxel up to 2 from the middle across and 4 down;
-- and the full window. The set is closed under the symmetries of the window, so likeness need not
-- be tried under them.
ordinaryFeatures :: [Feature]
ordinaryFeatures =
  Full :
  [StepEdge n c | n <- directions, c <- places n [-10, -8 .. 10]]
    ++ [ Ridge n c e
         | n <- directions,
           c <- places n [-12, -11 .. 10],
           width <- [4, 6, 8, 12],
           e <- map (+ c) (places n [width])
       ]
    ++ [Corner n c d | n <- directions, c <- places n [-8, -6 .. 8], d <- places n [-8, -6 .. 8]]
    ++ [Disc (x, y) r | x <- [-4, -2 .. 4], y <- [-8, -6 .. 8], r <- [6, 8, 10, 12]]
  where
    directions = [(a, b) | a <- [-2 .. 2], b <- [-2 .. 2], gcd a b == 1]
    -- Lengths along a direction whose vector is not of length 1: to the nearest that integers
    -- allow.
    places (a, b) = map (\c -> (c * norm (a, b) + 50) `div` 100)
    norm (a, b) = case a * a + b * b of
      1 -> 100
      2 -> 141
      _ -> 224 :: Int

-- | Whether a feature raises the taxel at this column and row, counted from the window's upper left
-- one; it goes on beyond the window.
raises :: Feature -> Int -> Int -> Bool
raises feature column row = case feature of
  Full -> True
  StepEdge (a, b) c -> a * x + b * y >= c
  Ridge (a, b) c d -> let t = a * x + b * y in t >= c && t < d
  Corner (a, b) c d -> a * x + b * y >= c && a * y - b * x >= d
  Disc (u, v) r -> (x - u) * (x - u) + (y - v) * (y - v) <= r * r
  where
    x = 2 * column - symbolWidth + 1
    y = 2 * row - symbolHeight + 1

-- | The normalised cross-correlation (Pearson's, -1 to 1) of a shape with a feature, taxel by
-- taxel; 0 where the feature is constant over the window.
likeness :: Bitmap -> Feature -> Double
likeness b feature
  | spread == 0 = 0
  | otherwise = fromIntegral (n * both - a * f) / sqrt (fromIntegral spread)
  where
    embossed = concat (bitmapRows b)
    raised = [raises feature x y | y <- [0 .. symbolHeight - 1], x <- [0 .. symbolWidth - 1]]
    n = symbolWidth * symbolHeight
    a = count embossed
    f = count raised
    both = count (zipWith (&&) embossed raised)
    spread = a * (n - a) * f * (n - f)
    count = length . filter id

-- | The greatest likeness of a shape to any ordinary feature, raised or sunk, and that feature.
greatestLikeness :: Bitmap -> (Double, Feature)
greatestLikeness b = foldl' nearer (0, Full) [(abs (likeness b f), f) | f <- ordinaryFeatures]
  where
    nearer best new = if fst new > fst best then new else best
