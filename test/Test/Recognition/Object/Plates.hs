-- | Plates with raised symbols: random ones, and some whose measures follow from their
-- construction.
module Test.Recognition.Object.Plates
  ( Plate (..),
    Plated (..),
    plates,
    knownPlates,
  )
where

import Data.Maybe (isJust)
import Numeric.Natural (Natural)
import PraTactile.Conformance.Definition.Face
import PraTactile.Conformance.Laws.Faces
import PraTactile.Object.Description
import Test.QuickCheck

-- | A face to be embossed as a plate.
data Plate = Plate
  { -- | the vertices of the face, in the order of its walk
    plateCorners :: [Point],
    -- | the side of a taxel of the symbols, and the height to which they are raised
    plateTaxel :: Rational,
    plateThickness :: Rational,
    -- | 12 rows of 8 taxels each, @#@ for a raised taxel and @.@ for a flat one
    plateShapes :: [[String]],
    -- | rows of cells 16 taxels wide and 20 high, centred on the box round the corners; each has
    -- the index of the shape in its middle, if any
    plateSymbols :: [[Maybe Natural]]
  }
  deriving stock (Eq, Show)

-- | A plate and its measures.
data Plated = Plated
  { -- | r and s of r + sqrt s, cubic millimetres; s is 0 where the root is a fraction
    platedVolume :: (Rational, Rational),
    -- | the corners, sides and triangles of its surface
    platedVertices :: Natural,
    platedEdges :: Natural,
    platedFaces :: Natural
  }
  deriving stock (Eq, Show)

-- | A square of 32 x 32 mm.
square :: [Point]
square = [Point 0 32 0, Point 0 0 0, Point 32 0 0, Point 32 32 0]

-- | A plate of 3 mm with taxels of 1 mm and one symbol, whose shape begins with these rows.
plateOn :: [Point] -> [[String]] -> Plate
plateOn corners shapes =
  Plate corners 1 3 [take 12 (shape ++ repeat "........") | shape <- shapes] [[Just 0]]

-- | Plates whose measures follow from their construction.
knownPlates :: [(Plate, Plated)]
knownPlates =
  [ (plateOn square [["##......", "##......"]], Plated (3072 + 4, 0) 16 42 28),
    (plateOn square [["########", "#......#", "########"]], Plated (3072 + 18, 0) 24 66 44),
    (plateOn square [["##.##...", "##.##..."]], Plated (3072 + 8, 0) 24 66 44),
    (plateOn square [["........"]], Plated (3072, 0) 8 18 12),
    (plateOn triangle [["#......."]], Plated (1, 9 * 3 * 80 ^ (4 :: Int) / 4) 14 36 24),
    ( (plateOn wide [["##......", "##......"], ["#......."]])
        { plateSymbols = [[Just 0, Nothing, Just 1]]
        },
      Plated (3 * 48 * 20 + 5, 0) 24 66 44
    )
  ]
  where
    -- With sides that are diagonals of squares of 80 mm.
    triangle = [Point 80 0 0, Point 0 80 0, Point 0 0 80]
    wide = [Point 0 20 0, Point 0 0 0, Point 48 0 0, Point 48 20 0]

-- | Plates over faces in any plane, each with a symbol.
plates :: Gen Plate
plates = drawnPlate `suchThat` (any (any isJust) . plateSymbols)

drawnPlate :: Gen Plate
drawnPlate = do
  corners <- faces
  n <- chooseInteger (1, 4)
  shapes <- vectorOf 3 genShape
  thick <- elements [2, 3, 5 / 4]
  -- As wide as this many symbols, at most.
  let across part = maximum (map part corners) - minimum (map part corners)
      widest =
        maximum (map across [\(Point x _ _) -> x, \(Point _ y _) -> y, \(Point _ _ z) -> z])
      taxel = widest / fromInteger (16 * n)
  chosen <- vectorOf 200 (frequency [(5, Just <$> chooseInteger (0, 2)), (1, pure Nothing)])
  pure
    Plate
      { plateCorners = corners,
        plateTaxel = taxel,
        plateThickness = thick * taxel,
        plateShapes = shapes,
        plateSymbols = case flat corners of
          Nothing -> []
          Just face ->
            let pitch = (16 * taxel, 20 * taxel)
                (high, wide) = roomFor face pitch
                onFace = holds face (Block Middle pitch (high, wide))
             in [ [ if onFace (r, c) then fromInteger <$> one else Nothing
                    | (c, one) <- zip [0 .. wide - 1] line
                  ]
                  | (r, line) <- zip [0 .. high - 1] (inParts 20 chosen)
                ]
      }
  where
    inParts k list = case splitAt k list of
      (part, []) -> [part]
      (part, others) -> part : inParts k others

-- | A shape of blocks and holes, of which no two taxels meet only at a corner.
genShape :: Gen [String]
genShape = drawnShape `suchThat` (not . any crossing . neighbours)
  where
    crossing four = four `elem` ["#..#", ".##."]

drawnShape :: Gen [String]
drawnShape = do
  count <- chooseInt (1, 4)
  blocks <- vectorOf count ((,) <$> frequency [(3, pure '#'), (1, pure '.')] <*> block)
  pure [[foldl (put x y) '.' blocks | x <- [0 .. 7]] | y <- [0 .. 11]]
  where
    block = do
      (x, y) <- (,) <$> chooseInt (0, 7) <*> chooseInt (0, 11)
      (w, h) <- (,) <$> chooseInt (1, 5) <*> chooseInt (1, 6)
      pure (x, y, x + w, y + h)
    put x y mark (on, (l, t, r, b)) = if x >= l && x < r && y >= t && y < b then on else mark

-- | All squares of two by two taxels of a shape, row by row.
neighbours :: [String] -> [String]
neighbours shape =
  [ concat [take 2 (drop x line) | line <- take 2 (drop y shape)]
    | y <- [0 .. length shape - 2],
      x <- [0 .. 6]
  ]
