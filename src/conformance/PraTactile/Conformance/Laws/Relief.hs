{-# OPTIONS_HADDOCK hide #-}

-- | Scenes with known truth: unbounded reliefs from which frames are cut, and composites with
-- symbols at known places.
module PraTactile.Conformance.Laws.Relief
  ( -- * Reliefs
    Relief,
    bumpy,
    edged,
    periodic,
    lattice,
    frameOf,

    -- * Whether frames determine their displacement
    telling,

    -- * Changes
    Affine (..),
    affinely,
    seen,

    -- * Drawn cases
    genSeed,
    genError,
    genShapes,
    shapesFor,
    smallerWhole,
  )
where

import Data.List (foldl')
import Data.Maybe (fromMaybe)
import Numeric.Natural (Natural)
import PraTactile.Conformance.Question
import PraTactile.Conformance.Shapes
import PraTactile.Symmetry (Symmetry, onRows, symmetries)
import System.Random (mkStdGen, randomR, randomRs)
import Test.QuickCheck (Gen, chooseInt, chooseInteger, elements, frequency, shrinkIntegral)

-- | The grey value, 0 to 'highest', at a whole place of an unbounded surface.
type Relief = WholeTaxels -> Natural

-- | The greatest grey value of a relief, which leaves room for gain and offset.
highest :: Double
highest = 20000

-- | A height, with 0 in the middle, as a grey value.
grey :: Double -> Natural
grey height = fromInteger (max 0 (min (round highest) (round (highest / 2 + 4000 * height))))

-- | A relief of round bumps and dents, from a seed. They lie at random places between (-24, -24)
-- and (48, 48), about one per 28 square taxels, with radii of 1 to 3 taxels.
bumpy :: Int -> Relief
bumpy seed = \(x, y) -> grey (sum [rise (fromInteger x) (fromInteger y) bump | bump <- bumps])
  where
    bumps = take 184 (fours (randomRs (0, 1) (mkStdGen seed)))
    fours numbers = case numbers of
      a : b : c : d : rest -> (72 * a - 24, 72 * b - 24, 1 + 2 * c, 2 * d - 1) : fours rest
      _ -> []

-- | The height of a bump at a place: a Gaussian, cut off at four radii.
rise :: Double -> Double -> (Double, Double, Double, Double) -> Double
rise x y (bx, by, radius, height)
  | abs (x - bx) > 4 * radius || abs (y - by) > 4 * radius = 0
  | otherwise = height * exp (negate ((x - bx) ^ two + (y - by) ^ two) / (2 * radius * radius))
  where
    two = 2 :: Int

-- | A relief of straight edges perpendicular to one axis. The list has the place of each edge, in
-- tenths of a taxel, and whether it rises.
edged :: (WholeTaxels -> Integer) -> [(Int, Bool)] -> Relief
edged axis edges place = grey (sum [height edge | edge <- edges])
  where
    height (at, rises) =
      (if rises then 1 else -1) * tanh (fromInteger (axis place) - fromIntegral at / 10 :: Double)

-- | A relief that repeats with the given periods to the right and down. The second argument is the
-- place of its maximum, in tenths of a taxel.
periodic :: WholeTaxels -> (Int, Int) -> Relief
periodic (p, q) (i, j) (x, y) = grey (wave p i x + wave q j y)
  where
    wave :: Integer -> Int -> Integer -> Double
    wave period at t = cos (2 * pi * (fromInteger t - fromIntegral at / 10) / fromInteger period)

-- | A relief of random symbols, 16 taxels apart along a row and 20 along a column, sharp or
-- blurred by 1, 2, 1 along both axes. The seed also determines the lattice's place.
lattice :: Drawings -> Int -> Relief
lattice shapes seed (x, y)
  | even seed = 4000 + 12000 * raised x y
  | otherwise = 4000 + 750 * sum [by i * by j * raised (x + i) (y + j) | i <- side, j <- side]
  where
    side = [-1, 0, 1]
    by i = if i == 0 then 2 else 1
    (x0, y0) = (toInteger seed `div` 2 `mod` 16, toInteger seed `div` 32 `mod` 20)
    raised u v
      | i < 8 && j < 12 && shape !! fromInteger j !! fromInteger i == '#' = 1 :: Natural
      | otherwise = 0
      where
        (column, i) = (u - x0) `divMod` 16
        (row, j) = (v - y0) `divMod` 20
        cell = mkStdGen (seed + fromInteger (7919 * column + 104729 * row))
        shape = shapes !! fst (randomR (0, length shapes - 1) cell)

-- | The frame of a given size whose upper left taxel is at a place.
frameOf :: (Integer, Integer) -> Relief -> WholeTaxels -> Rows
frameOf (w, h) relief (x, y) = [[relief (x + i, y + j) | i <- [0 .. w - 1]] | j <- [0 .. h - 1]]

-- | Whether a pair determines the displacement of the second frame. At every other whole
-- displacement within the search, the common part must correlate by less than 0.9; one taxel away,
-- by less than 0.97.
telling :: Pair -> WholeTaxels -> Bool
telling (Pair a b (sx, sy) search) (dx, dy) =
  and
    [ correlation (common (x, y) a b) < if away == 1 then 0.97 else 0.9
      | x <- [sx - r .. sx + r],
        y <- [sy - r .. sy + r],
        let away = max (abs (x - dx)) (abs (y - dy)),
        away > 0
    ]
  where
    r = toInteger search

-- | The pairs of grey values in the overlap of two frames at a displacement of the second.
common :: WholeTaxels -> Rows -> Rows -> [(Double, Double)]
common (dx, dy) a b =
  [ (fromIntegral u, fromIntegral v)
    | (rowA, rowB) <- zip (from dy a) (from (negate dy) b),
      (u, v) <- zip (from dx rowA) (from (negate dx) rowB)
  ]
  where
    from n = drop (fromInteger (max 0 n))

-- | The normalised correlation; 1 if one side is constant, because then everything fits.
correlation :: [(Double, Double)] -> Double
correlation pairs
  | n < 2 || varianceA <= 0 || varianceB <= 0 = 1
  | otherwise = (ab - a * b / n) / sqrt (varianceA * varianceB)
  where
    (n, a, b, aa, bb, ab) = foldl' with (0, 0, 0, 0, 0, 0) pairs
    with (k, s, t, ss, tt, st) (u, v) = (k + 1, s + u, t + v, ss + u * u, tt + v * v, st + u * v)
    varianceA = aa - a * a / n
    varianceB = bb - b * b / n

-- | A gain for grey values, and an offset to add.
data Affine = Affine Natural Natural
  deriving stock (Eq, Show)

-- | Applies a gain and an offset to all grey values.
affinely :: Affine -> Rows -> Rows
affinely (Affine gain offset) = map (map (\v -> gain * v + offset))

-- | The symmetry with this number, and rows transformed by it.
seen :: Int -> (Symmetry, Rows -> Rows)
seen number = (symmetry, onRows symmetry)
  where
    symmetry = cycle symmetries !! (number `mod` 8)

-- | A seed of a relief.
genSeed :: Gen Int
genSeed = chooseInt (0, 999999)

-- | The number of classes whose shapes a question gives, if it does.
genShapes :: Gen (Maybe Int)
genShapes = frequency [(1, pure Nothing), (1, Just . fst <$> elements knownAlphabets)]

-- | The given shapes for a number of classes, and the shapes for drawing scenes. Without a number,
-- no shapes are given, and scenes use the default ones.
shapesFor :: Maybe Int -> (Maybe Drawings, Drawings)
shapesFor stated = (known <$ stated, known)
  where
    known = concat [drawingsOf one | (q, one) <- knownAlphabets, q == fromMaybe 4 stated]

-- | A random error of at most the given number of taxels along each axis.
genError :: Integer -> Gen WholeTaxels
genError most = (,) <$> chooseInteger (-most, most) <*> chooseInteger (-most, most)

-- | Displacements nearer to 0.
smallerWhole :: WholeTaxels -> [WholeTaxels]
smallerWhole (x, y) = [(x', y) | x' <- shrinkIntegral x] ++ [(x, y') | y' <- shrinkIntegral y]
