{-# OPTIONS_HADDOCK hide #-}

-- | The distances of shapes from each other, and their likeness to ordinary features of objects:
-- the numbers behind the paper's three conditions on its symbols (section II.B).
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

-- | The least number of taxels in which the first shape differs from the second, after the second
-- is transformed and shifted by -1, 0 or 1 taxel in each direction. Taxels shifted out of the box
-- still count.
distance :: Symmetry -> Bitmap -> Bitmap -> Int
distance symmetry a b = minimum (differences symmetry a b)

-- | The number of different taxels for each of the nine shifts.
differences :: Symmetry -> Bitmap -> Bitmap -> [Int]
differences symmetry a b =
  [popCount (xor (canvas identity a) (shift there (shiftBits k))) | k <- shifts]
  where
    there = canvas symmetry b

-- | How two shapes come nearest: the number of different taxels, the symmetry of the second shape,
-- and its shift to the right and down.
data Nearest = Nearest
  { nearestDistance :: !Int,
    nearestSymmetry :: !Symmetry,
    nearestShift :: !(Int, Int)
  }
  deriving stock (Eq, Show)

-- | The nearest comparison of two shapes over some symmetries (only the identity for an empty
-- list); the first one among equals.
nearest :: [Symmetry] -> Bitmap -> Bitmap -> Nearest
nearest among a b = minimumBy (comparing nearestDistance) (concatMap under (headed among))
  where
    under symmetry = zipWith (\d k -> Nearest d symmetry k) (differences symmetry a b) shifts
    headed list = if null list then [identity] else list

-- | A shape prepared for many comparisons: itself on a canvas, and all its transformed and shifted
-- copies.
data Prepared = Prepared !Integer [Integer]

-- | Prepares a shape.
prepared :: Bitmap -> Prepared
prepared b =
  Prepared
    (canvas identity b)
    [shift (canvas symmetry b) (shiftBits k) | symmetry <- symmetries, k <- shifts]

-- | Whether the 'distance' between two shapes is at least the given number under every symmetry.
-- It stops at the first smaller one.
farApart :: Int -> Prepared -> Prepared -> Bool
farApart d (Prepared here _) (Prepared _ there) =
  all (\moved -> popCount (xor here moved) >= d) there

-- | The nine shifts, in taxels to the right and down.
shifts :: [(Int, Int)]
shifts = [(x, y) | y <- [0, -1, 1], x <- [0, -1, 1]]

-- | A shift as a shift of a canvas's bits.
shiftBits :: (Int, Int) -> Int
shiftBits (x, y) = x + canvasSide * y

-- | The side of a square canvas. It keeps at least 2 flat taxels around a shape, upright or lying,
-- so that no shift by a taxel wraps around.
canvasSide :: Int
canvasSide = 16

-- | The transformed shape in the middle of a canvas, as a set of bits.
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

-- | The least distance of a shape from itself turned or mirrored, a measure of how clearly it
-- shows its orientation and handedness.
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

-- | A feature that objects without the code also have, as it may lie across an 8 x 12 window.
-- Lengths are in half taxels from the window's centre, x to the right and y down, so that
-- everything is an integer.
data Feature
  = -- | Everything raised.
    Full
  | -- | A raised half plane: a x + b y >= c for the direction (a, b).
    StepEdge (Int, Int) Int
  | -- | A ridge or groove, from wall to wall: c <= a x + b y < d.
    Ridge (Int, Int) Int Int
  | -- | A raised right-angled corner: a x + b y >= c and a y - b x >= d.
    Corner (Int, Int) Int Int
  | -- | A raised disc, with its centre and radius.
    Disc (Int, Int) Int
  deriving stock (Eq, Show)

-- | The ordinary features that shapes are compared with. Step edges and right-angled corners have
-- 16 directions (the axes, the diagonals and those between) and lie at every taxel, up to 5 and 4
-- taxels from the window's middle. Ridges are 2, 3, 4 and 6 taxels wide in the same directions, and
-- begin at every half taxel from 6 before the middle to 5 after. Discs have radii of 3 to 6 taxels
-- around every taxel up to 2 across and 4 down from the middle. The full window is one more. The
-- set is closed under the symmetries of the window, so likeness need not be computed under them.
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
    -- Lengths along a direction vector whose length is not 1, rounded to integers.
    places (a, b) = map (\c -> (c * norm (a, b) + 50) `div` 100)
    norm (a, b) = case a * a + b * b of
      1 -> 100
      2 -> 141
      _ -> 224 :: Int

-- | Whether a feature raises the taxel at a column and a row, counted from the window's upper
-- left; also defined beyond the window.
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

-- | The normalised cross-correlation (Pearson's, -1 to 1) of a shape and a feature over the
-- taxels; 0 if the feature or the shape is constant.
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

-- | The greatest absolute likeness of a shape to any ordinary feature (raised or sunken), and that
-- feature.
greatestLikeness :: Bitmap -> (Double, Feature)
greatestLikeness b = foldl' nearer (0, Full) [(abs (likeness b f), f) | f <- ordinaryFeatures]
  where
    nearer best new = if fst new > fst best then new else best
