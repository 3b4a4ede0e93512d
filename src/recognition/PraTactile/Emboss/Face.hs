{-# OPTIONS_HADDOCK hide #-}

-- | A face with its symbols raised, as triangles. It has three kinds of them. The ground, at height
-- 0, is its polygon less all that an odd number of the symbols' outlines has inside; along each
-- side of an outline stands a wall; the tops, at the height of the relief, are what the outlines
-- have inside.
--
-- >          b'------- a'   top
-- >         /|        /|
-- >        / b ----- / a    wall: a b b' and a b' a', where a b has the symbol to its left
-- >       /         /
-- > ---------------------   ground
--
-- Each side of a triangle belongs to another one, too, which walks it the other way: a side of the
-- polygon to the neighbouring face, a side of an outline to its wall.
module PraTactile.Emboss.Face
  ( -- * Symbols
    Stamp (..),
    stampOf,
    outlineSpot,

    -- * Faces
    Surface (..),
    raisedFace,
    region,
  )
where

import qualified Data.IntMap.Strict as IntMap
import Data.List (mapAccumL)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Array (Position (..))
import PraTactile.Geometry
import PraTactile.Object.Chart
import PraTactile.Object.Description (cyclicPairs)
import PraTactile.Object.Polygon (V2 (..))
import PraTactile.Object.Rims
import PraTactile.Object.Triangulation
import PraTactile.Shape (Bitmap, area)
import PraTactile.Shape.Outline

-- | A shape, ready to be raised.
data Stamp = Stamp
  { -- | how many taxels it raises
    stampArea :: Int,
    -- | the width of its finest stroke, in taxels
    stampStroke :: Int,
    -- | by their corners
    stampOutlines :: [[Corner]],
    -- | what they have inside, by the places of the corners of all of them
    stampTop :: [(Int, Int, Int)]
  }

-- | The stamp of a shape; refuses one of which two taxels meet at a corner only.
stampOf :: Bitmap -> Either Contact Stamp
stampOf bitmap = stamp <$> outlines bitmap
  where
    stamp loops =
      Stamp
        { stampArea = area bitmap,
          stampStroke = finestStroke bitmap,
          stampOutlines = loops,
          stampTop =
            triangulation
              (Metric 1 1)
              (V.fromList [V2 (toInteger x) (toInteger (negate y)) | (x, y) <- concat loops])
              (numberedFrom 0 loops)
        }

-- | Numbers in the place of things, from this one on.
numberedFrom :: Int -> [[a]] -> [[Int]]
numberedFrom from = snd . mapAccumL numbered from
  where
    numbered k things = let next = k + length things in (next, [k .. next - 1])

-- | A corner of an outline of the symbol in a cell, by row and column of its block, where steps of
-- the lattice are taxels: the symbol lies in the middle of its cell.
outlineSpot :: Position -> Corner -> Spot
outlineSpot (Position i j) (x, y) =
  Lattice
    (columnPitch * toInteger j + toInteger ((columnPitch - symbolWidth) `div` 2 + x))
    (rowPitch * toInteger i + toInteger ((rowPitch - symbolHeight) `div` 2 + y))

-- | Points beside the corners that are known already, and triangles by the numbers of points,
-- counter-clockwise seen from outside.
data Surface = Surface
  { surfacePoints :: [ExactPoint],
    surfaceTriangles :: [(Int, Int, Int)]
  }

-- | A face whose corners have these numbers, with symbols so many millimetres high in these cells
-- of its block; new points are numbered from this number on.
raisedFace :: Rational -> Chart -> U.Vector Int -> Int -> [(Position, Stamp)] -> Surface
raisedFace height chart walk from symbols =
  Surface
    { surfacePoints = [pointOn chart z spot | spot <- outlined, z <- [0, height]],
      surfaceTriangles =
        [(base a, base b, base c) | (a, b, c) <- ground]
          ++ concat
            [ [(base a, base b, top b), (base a, top b, top a)]
              | (a, b) <- concatMap cyclicPairs loops
            ]
          ++ [ (top (k + a), top (k + b), top (k + c))
               | (k, (_, stamp)) <- zip begun symbols,
                 (a, b, c) <- stampTop stamp
             ]
    }
  where
    corners = U.length walk
    outlined =
      [outlineSpot cell corner | (cell, stamp) <- symbols, corner <- concat (stampOutlines stamp)]
    begun = scanl (+) corners [length (concat (stampOutlines stamp)) | (_, stamp) <- symbols]
    loops = numberedFrom corners (concatMap (stampOutlines . snd) symbols)
    ground = region chart (map Corner [0 .. corners - 1] ++ outlined) (rimsOf ++ loops)
    -- By the first place of each corner: places of one vertex are one point.
    rimsOf = map (map (places IntMap.!)) (rims (U.toList walk))
    places = IntMap.fromListWith (\_ first -> first) (zip (U.toList walk) [0 ..])
    base k
      | k < corners = walk U.! k
      | otherwise = from + 2 * (k - corners)
    top k = base k + 1

-- | The triangles of what an odd number of loops of a face's points has inside, by the places of
-- the points: made on a stretched face, with roots ever finer until they are certain.
region :: Chart -> [Spot] -> [[Int]] -> [(Int, Int, Int)]
region chart listed loops = certain 64
  where
    spots = V.fromList listed
    certain digits
      | and [sameTurn plane (spots V.! a) (spots V.! b) (spots V.! c) | (a, b, c) <- found] = found
      | otherwise = certain (2 * digits)
      where
        plane = planeOf digits chart
        found = triangulation (planeMetric plane) (V.map (planePoint plane) spots) loops
