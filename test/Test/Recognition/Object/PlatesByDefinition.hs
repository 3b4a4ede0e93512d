{-# LANGUAGE OverloadedStrings #-}

-- | The definition of a plate with raised symbols as a union of boxes: the part below the face and
-- a cube on each raised taxel, united by counting. The library's plates are compared with it.
module Test.Recognition.Object.PlatesByDefinition (spec) where

import Data.Foldable (for_)
import Data.List (genericIndex, genericLength, sort)
import qualified Data.Set as Set
import qualified Data.Vector as V
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Conformance.Definition.Solid (exactRoot, normalOf, (<.>))
import PraTactile.Emboss hiding (volume)
import PraTactile.Emboss.Face (stampOf)
import PraTactile.Format.Placement (Drawing (..), drawnPlacement)
import PraTactile.Geometry (taxelPitch)
import PraTactile.Object.Description
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge (outwardNormal)
import PraTactile.Shape (bitmapWhere)
import Test.Effort
import Test.Hspec hiding (around)
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck
import Test.Recognition.Object.Plates

spec :: Spec
spec = do
  it "plates of a few blocks have their known volumes and counts" $
    for_ knownPlates $ \(plate, made) -> do
      platedOf plate `shouldBe` made
      embossedBy plate `shouldBe` Right made
  withCases 60 300
    . prop "a plate's volume is its face times its thickness, plus a cube for each raised taxel"
    $ forAll plates $ \plate -> embossedBy plate === Right (platedOf plate)

-- | The volume of a plate, and the numbers of corners, sides and triangles of its surface.
--
-- It is a prism over the face, of half the length of the normal times the thickness, and a cube for
-- each raised taxel. On a surface of triangles each side belongs to two, so 3 F = 2 E; V - E + F is
-- that of the boxes' own surface.
platedOf :: Plate -> Plated
platedOf it_ = Plated volume vertices (3 * faces `div` 2) faces
  where
    t = plateTaxel it_
    shapes = [plateShapes it_ `genericIndex` k | Just k <- concat (plateSymbols it_)]
    raised = genericLength (filter (== '#') (concat (concat shapes))) :: Rational
    vertices = 2 * (genericLength (plateCorners it_) + sum (map turns shapes)) :: Natural
    turns shape = genericLength [() | four <- around shape, odd (length (filter id four))]
    -- A ball, except for what the boxes' surface adds.
    euler = 2 + sum [patchEuler shape - 1 | shape <- shapes]
    faces = fromInteger (2 * (toInteger vertices - euler))
    volume = (raised * t * t * t + rational, root)
    normal = normalOf [(x, y, z) | Point x y z <- plateCorners it_]
    squared = plateThickness it_ * plateThickness it_ * (normal <.> normal) / 4
    (rational, root) = maybe (0, squared) (\s -> (s, 0)) (exactRoot squared)

-- | The four taxels round each corner of taxels: upper left and right, lower left and right.
around :: [String] -> [[Bool]]
around shape = [[on x y | y <- [j - 1, j], x <- [i - 1, i]] | (i, j) <- spots shape]
  where
    on = raisedAt shape

spots :: [String] -> [(Int, Int)]
spots shape = [(i, j) | j <- [0 .. length shape], i <- [0 .. length (concat (take 1 shape))]]

raisedAt :: [String] -> Int -> Int -> Bool
raisedAt shape x y = take 1 (drop x (concat (take 1 (drop y shape)))) == "#" && x >= 0 && y >= 0

-- | V - E + F of the squares that are visible from above and from the side on the taxels of a shape
-- and on those next to it: one on each taxel, at its height, and a wall between two of different
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

-- | The library's plate over the face of a prism.
embossedBy :: Plate -> Either String Plated
embossedBy (Plate corners taxel thickness shapes symbols) = do
  (whole, laid) <- case drawnPlacement size (Pitch (16 * taxel) (20 * taxel)) [prism] [laying] of
    Right place | [found] <- zip (placementSolids place) (laidFaces place) -> Right found
    other -> Left (either show (const "several faces") other)
  stamps <- traverse stamped cells
  made <- shown (embossedPlate (taxel / taxelPitch) (Just thickness) whole laid stamps)
  let Volume r s = embossedVolume made
      cut = V.toList (embossedTriangles made)
      sides = concat [[sort [a, b], sort [b, c], sort [c, a]] | (a, b, c) <- cut]
  pure
    Plated
      { platedVolume = (r, s),
        platedVertices = fromIntegral (V.length (embossedPoints made)),
        platedEdges = fromIntegral (Set.size (Set.fromList sides)),
        platedFaces = fromIntegral (length cut)
      }
  where
    cells = [(Position r c, k) | (r, line) <- zip [0 ..] symbols, (c, Just k) <- zip [0 ..] line]
    shown :: Show e => Either e a -> Either String a
    shown = either (Left . show) Right
    stamped (cell, k) =
      fmap ((,) cell) . shown . stampOf . bitmapWhere $
        \x y -> '#' `elem` nth x (concat (nth y (concat (nth (fromIntegral k) shapes))))
    nth i list = take 1 (drop i list)
    size = Shape (atLeastOne symbols) (atLeastOne (concat (take 1 symbols)))
    atLeastOne list = fromIntegral (max 1 (length list))
    laying =
      Drawing (Face "" (FaceName above)) 0 0 Nothing (map (map (maybe '.' (const '#'))) symbols)
    prism =
      Description
        ""
        (zip above corners ++ zip below (map (`less` outwardNormal corners) corners))
        ( FaceName above :
          FaceName (reverse below) :
            [ FaceName [b, a, c, d]
              | ((a, b), (c, d)) <- zip (cyclicPairs above) (cyclicPairs below)
            ]
        )
    (above, below) = (named "a", named "b")
    named level = [VertexName (level ++ show i) | i <- [1 .. length corners]]
    less (Point x y z) (Point u v w) = Point (x - u) (y - v) (z - w)
