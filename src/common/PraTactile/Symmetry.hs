-- | The eight symmetries of the square: how a face, a patch or a symbol may be seen turned or
-- mirrored. They are the dihedral group of order 8, with composition as '<>', and act on rows of
-- cells, on the shapes of rectangles and on the cells within them.
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

    -- * Its elements
    rotations,
    symmetries,

    -- * Actions
    onRows,
    onShape,
    onPosition,
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

-- | The four rotations of an object seen from outside, the identity first.
rotations :: [Symmetry]
rotations = map turned [0 .. 3]

-- | All eight: the rotations, and those of the mirror image.
symmetries :: [Symmetry]
symmetries = rotations ++ map (<> mirror) rotations

-- | Rows of cells as they are seen.
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
onShape symmetry (Shape h w) = if odd (quarterTurns symmetry) then Shape w h else Shape h w

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
    -- As far from the last of so many as the index is from the first.
    less n k = if k < n then n - 1 - k else 0
