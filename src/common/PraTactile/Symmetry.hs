-- | The eight symmetries of the square: how a face, a patch or a symbol may be seen rotated or
-- mirrored. They are the dihedral group of order 8, with composition as '<>'. They act on rows of
-- cells, on the shapes of rectangles and the cells within them, on places in images, and on
-- displacements.
--
-- A square with the letters a to d at its corners, clockwise from the upper left, is seen as:
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

-- | How something is seen: first mirrored or not, with left and right exchanged, then rotated.
data Symmetry = Symmetry
  { -- | Whether left and right are exchanged before the rotation.
    mirrored :: !Bool,
    -- | The quarter turns clockwise: 0, 1, 2 or 3.
    quarterTurns :: !Int
  }
  deriving stock (Eq, Ord, Show)

-- | @g <> h@ applies h, then g.
instance Semigroup Symmetry where
  Symmetry flipped turns <> Symmetry flipped' turns' =
    Symmetry (flipped /= flipped') ((turns + (if flipped then negate turns' else turns')) `mod` 4)

instance Monoid Symmetry where
  mempty = identity

-- | Neither mirrored nor rotated.
identity :: Symmetry
identity = Symmetry False 0

-- | Rotated clockwise by this number of quarter turns, which may be negative.
turned :: Int -> Symmetry
turned turns = Symmetry False (turns `mod` 4)

-- | Left and right exchanged.
mirror :: Symmetry
mirror = Symmetry True 0

-- | The inverse of a symmetry; mirrored ones are their own inverses.
invert :: Symmetry -> Symmetry
invert symmetry
  | mirrored symmetry = symmetry
  | otherwise = turned (negate (quarterTurns symmetry))

-- | Whether rows are seen as columns, and columns as rows.
exchangesAxes :: Symmetry -> Bool
exchangesAxes = odd . quarterTurns

-- | The rotation in degrees clockwise, after any mirroring: 0, 90, 180 or 270.
degreesClockwise :: Num degrees => Symmetry -> degrees
degreesClockwise symmetry = fromIntegral (90 * quarterTurns symmetry)

-- | The rotation clockwise by this many degrees; 'Nothing' unless they are a multiple of 90.
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

-- | The quarter turn nearest to an angle in degrees clockwise, and the degrees beyond it, from -45
-- up to 45.
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

-- | All eight symmetries: the rotations, and those of the mirror image.
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

-- | The cell where a cell of a rectangle of this shape is seen, in the rectangle with the shape
-- that 'onShape' gives. The cell must lie within the rectangle.
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
    -- The index as far from the last of n as k is from the first.
    less n k = if k < n then n - 1 - k else 0

-- | Where a place of an image of this width and height is seen. Places count to the right and down
-- from (0, 0), the centre of the upper left pixel.
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

-- | How a displacement, (right, down), is seen.
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
