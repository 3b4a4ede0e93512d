-- | The eight symmetries of the square: how a face, a patch or a symbol may be seen turned or
-- mirrored. They are the dihedral group of order 8, with composition as '<>', and act on rows of
-- cells, on the shapes of rectangles and on the cells within them, on places in images and on
-- displacements.
--
-- The corners of a square with the letters a to d, clockwise from the upper left, and how they are
-- seen:
--
-- > identity     turned 1     turned 2     turned 3     mirror     turned 1 <> mirror
-- >   a b          d a          c d          b c          b a          c b
-- >   d c          c b          b a          a d          c d          d a
module PraTactile.Symmetry
  ( -- * The group
    Symmetry,
    mirrored,
    quarterTurns,
    identity,
    turned,
    mirror,
    invert,
    exchangesAxes,

    -- * Turns in degrees
    degreesClockwise,
    turnedByDegrees,
    nearestQuarter,

    -- * Its elements
    rotations,
    symmetries,

    -- * Actions
    onRows,
    onShape,
    onPosition,
    onPixel,
    onOffset,
  )
where

import Data.List (transpose)
import PraTactile.Position

-- | How something is seen: mirrored or not, left and right exchanged; and then turned.
data Symmetry = Symmetry
  { -- | Whether left and right are exchanged before turning.
    mirrored :: !Bool,
    -- | Clockwise: 0, 1, 2 or 3.
    quarterTurns :: !Int
  }
  deriving stock (Eq, Ord, Show)

-- | @g <> h@ is g after h.
instance Semigroup Symmetry where
  Symmetry flipped turns <> Symmetry flipped' turns' =
    Symmetry (flipped /= flipped') ((turns + (if flipped then negate turns' else turns')) `mod` 4)

instance Monoid Symmetry where
  mempty = identity

-- | Neither mirrored nor turned.
identity :: Symmetry
identity = Symmetry False 0

-- | Turned clockwise by this many quarter turns, any number of them.
turned :: Int -> Symmetry
turned turns = Symmetry False (turns `mod` 4)

-- | Left and right exchanged.
mirror :: Symmetry
mirror = Symmetry True 0

-- | What undoes a symmetry: the mirrored ones undo themselves.
invert :: Symmetry -> Symmetry
invert symmetry
  | mirrored symmetry = symmetry
  | otherwise = turned (negate (quarterTurns symmetry))

-- | Whether rows are seen as columns and columns as rows.
exchangesAxes :: Symmetry -> Bool
exchangesAxes = odd . quarterTurns

-- | By how many degrees clockwise something is turned, after being mirrored if it is: 0, 90, 180 or
-- 270.
degreesClockwise :: Num degrees => Symmetry -> degrees
degreesClockwise symmetry = fromIntegral (90 * quarterTurns symmetry)

-- | Turned clockwise by this many degrees, if they are a multiple of 90.
--
-- >>> quarterTurns <$> turnedByDegrees (-90)
-- Just 3
turnedByDegrees :: Double -> Maybe Symmetry
turnedByDegrees degrees = case degrees - 360 * fromIntegral (floor (degrees / 360) :: Integer) of
  0 -> Just identity
  90 -> Just (turned 1)
  180 -> Just (turned 2)
  270 -> Just (turned 3)
  _ -> Nothing

-- | An angle in degrees clockwise as the nearest quarter turn and the degrees beyond it, which are
-- from -45 up to 45.
--
-- >>> nearestQuarter 350
-- (Symmetry {mirrored = False, quarterTurns = 0},-10.0)
nearestQuarter :: Double -> (Symmetry, Double)
nearestQuarter degrees =
  (turned (fromInteger (quarters `mod` 4)), degrees - 90 * fromInteger quarters)
  where
    quarters = floor (degrees / 90 + 0.5) :: Integer

-- | The four rotations of an object seen from outside, the identity first.
rotations :: [Symmetry]
rotations = map turned [0 .. 3]

-- | All eight: the rotations, and those of the mirror image.
symmetries :: [Symmetry]
symmetries = rotations ++ map (<> mirror) rotations

-- | Rows of cells as they are seen. O(N) for N cells.
--
-- >>> onRows (turned 1) ["ab", "cd"]
-- ["ca","db"]
onRows :: Symmetry -> [[a]] -> [[a]]
onRows (Symmetry flipped turns) cells =
  iterate clockwise (if flipped then map reverse cells else cells) !! turns
  where
    clockwise = map reverse . transpose

-- | The shape of a rectangle as it is seen.
--
-- >>> onShape (turned 1) (Shape 2 3)
-- Shape {rows = 3, columns = 2}
onShape :: Symmetry -> Shape -> Shape
onShape symmetry (Shape h w) = if exchangesAxes symmetry then Shape w h else Shape h w

-- | Where a cell of a rectangle of this shape is seen, in the rectangle of the shape that 'onShape'
-- tells; for cells within it.
--
-- >>> onPosition (turned 1) (Shape 2 3) (Position 0 2)
-- Position {row = 2, column = 1}
onPosition :: Symmetry -> Shape -> Position -> Position
onPosition (Symmetry flipped turns) (Shape h w) (Position i j) = case turns of
  0 -> Position i j'
  1 -> Position j' (h `less` i)
  2 -> Position (h `less` i) (w `less` j')
  _ -> Position (w `less` j') i
  where
    j' = if flipped then w `less` j else j
    -- As far from the last of n as the index is from the first.
    less n k = if k < n then n - 1 - k else 0

-- | Where a place of an image of this width and height is seen: to the right and down, both from 0
-- at the centre of the upper left pixel.
--
-- >>> onPixel (turned 1) (3, 2) (2, 0)
-- (1,2)
onPixel :: Num a => Symmetry -> (a, a) -> (a, a) -> (a, a)
onPixel (Symmetry flipped turns) (w, h) (x, y) = case turns of
  0 -> (x', y)
  1 -> (h - 1 - y, x')
  2 -> (w - 1 - x', h - 1 - y)
  _ -> (y, w - 1 - x')
  where
    x' = if flipped then w - 1 - x else x
{-# INLINE onPixel #-}

-- | How a displacement, to the right and down, is seen.
--
-- >>> onOffset (turned 1) (1, 0)
-- (0,1)
onOffset :: Num a => Symmetry -> (a, a) -> (a, a)
onOffset (Symmetry flipped turns) (across, down) = case turns of
  0 -> (across', down)
  1 -> (negate down, across')
  2 -> (negate across', negate down)
  _ -> (down, negate across')
  where
    across' = if flipped then negate across else across
