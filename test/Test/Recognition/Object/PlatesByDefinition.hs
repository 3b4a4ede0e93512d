-- | A face as a plate with symbols raised on it, of boxes: what is below the face, and a cube on
-- each raised taxel, united by counting.
module Test.Recognition.Object.PlatesByDefinition
  ( Plate (..),
    Plated (..),
    platedOf,
  )
where

import Data.List (genericIndex, genericLength)
import Numeric.Natural (Natural)
import PraTactile.Conformance.Definition.Face
import PraTactile.Conformance.Definition.Solid (exactRoot, normalOf, (<.>))
import PraTactile.Conformance.Question
import PraTactile.Object.Description (Point (..))

-- | A face to be embossed as a plate.
data Plate = Plate
  { -- | where the face's vertices are, in the order of its walk
    plateCorners :: [Point],
    -- | the side of a taxel of the symbols, and the height to which they are raised
    plateTaxel :: Rational,
    plateThickness :: Rational,
    -- | 12 rows of 8 taxels each, @#@ for one that is raised and @.@ for one that is not
    plateShapes :: [[String]],
    -- | rows of cells 16 taxels wide and 20 high, centred on the box round the corners: which shape
    -- stands in the middle of each, by its place among the shapes, if any does
    plateSymbols :: [[Maybe Natural]]
  }
  deriving stock (Eq, Show)

-- | A plate that was made.
data Plated = Plated
  { -- | r and s of r + sqrt s, cubic millimetres; s is 0 where the root is a fraction
    platedVolume :: (Rational, Rational),
    -- | the corners, sides and triangles of its surface
    platedVertices :: Natural,
    platedEdges :: Natural,
    platedFaces :: Natural
  }
  deriving stock (Eq, Show)

-- | How large the plate is and how many corners, sides and triangles its surface has.
--
-- It is a prism over the face, of half the length of the normal times the thickness, and a cube for
-- each raised taxel. A surface of triangles of which each side belongs to two has 3 F = 2 E, and
-- V - E + F is that of the boxes' own surface.
platedOf :: Plate -> Either Refusal Plated
platedOf it = case flat (plateCorners it) of
  Nothing -> Left (Refusal "impossible-face")
  Just face
    | t <= 0 -> Left (Refusal "impossible-face")
    | null cells || not (all (holds face block . fst) cells) -> Left (Refusal "impossible-plate")
    | any (any (`elem` crossed) . around) shapes -> Left (Refusal "corner-contact")
    | plateThickness it <= t -> Left (Refusal "impossible-plate")
    | otherwise -> Right (Plated volume vertices (3 * faces `div` 2) faces)
  where
    t = plateTaxel it
    symbols = plateSymbols it
    block =
      Block Middle (16 * t, 20 * t) (genericLength symbols, genericLength (concat (take 1 symbols)))
    cells = [((r, c), k) | (r, line) <- zip [0 ..] symbols, (c, Just k) <- zip [0 ..] line]
    shapes = [plateShapes it `genericIndex` k | (_, k) <- cells]
    raised = genericLength (filter (== '#') (concat (concat shapes))) :: Rational
    vertices = 2 * (genericLength (plateCorners it) + sum (map turns shapes)) :: Natural
    turns shape = genericLength [() | four <- around shape, odd (length (filter id four))]
    -- A ball, but for what the boxes' surface says otherwise.
    euler = 2 + sum [patchEuler shape - 1 | shape <- shapes]
    faces = fromInteger (2 * (toInteger vertices - euler))
    volume = (raised * t * t * t + rational, root)
    normal = normalOf [(x, y, z) | Point x y z <- plateCorners it]
    squared = plateThickness it * plateThickness it * (normal <.> normal) / 4
    (rational, root) = maybe (0, squared) (\s -> (s, 0)) (exactRoot squared)

-- | Taxels of which two meet at a corner only.
crossed :: [[Bool]]
crossed = [[True, False, False, True], [False, True, True, False]]

-- | The four taxels round each corner of taxels: upper left and right, lower left and right.
around :: [String] -> [[Bool]]
around shape = [[on x y | y <- [j - 1, j], x <- [i - 1, i]] | (i, j) <- spots shape]
  where
    on = raisedAt shape

spots :: [String] -> [(Int, Int)]
spots shape = [(i, j) | j <- [0 .. length shape], i <- [0 .. length (concat (take 1 shape))]]

raisedAt :: [String] -> Int -> Int -> Bool
raisedAt shape x y = take 1 (drop x (concat (take 1 (drop y shape)))) == "#" && x >= 0 && y >= 0

-- | V - E + F of the squares that one sees from above and from aside on the taxels of a shape, and
-- on those next to it: on each taxel one, at its height, and a wall between two of different
-- heights.
patchEuler :: [String] -> Integer
patchEuler shape = points - sides + squares
  where
    on = raisedAt shape
    (wide, high) = (length (concat (take 1 shape)), length shape)
    inPatch x y = x >= -1 && x <= wide && y >= -1 && y <= high
    heights taxels = [h | h <- [False, True], h `elem` [on x y | (x, y) <- taxels, inPatch x y]]
    count = genericLength :: [a] -> Integer
    points = sum [count (heights [(i - 1, j - 1), (i, j - 1), (i - 1, j), (i, j)]) | (i, j) <- grid]
    grid = [(i, j) | j <- [-1 .. high + 1], i <- [-1 .. wide + 1]]
    -- Along the rims of taxels, and upright where both heights meet.
    rims =
      [[(i - 1, j), (i, j)] | j <- [-1 .. high], i <- [-1 .. wide + 1]]
        ++ [[(i, j - 1), (i, j)] | j <- [-1 .. high + 1], i <- [-1 .. wide]]
    upright =
      [ ()
        | (i, j) <- grid,
          length (heights [(i - 1, j - 1), (i, j - 1), (i - 1, j), (i, j)]) == 2
      ]
    sides = sum [count (heights rim) | rim <- rims] + count upright
    squares =
      toInteger ((wide + 2) * (high + 2)) + count [() | rim <- rims, length (heights rim) == 2]
