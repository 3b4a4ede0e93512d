{-# OPTIONS_HADDOCK hide #-}

-- | A face with its symbols raised, as triangles of three kinds. The ground, at height 0, is the
-- face's polygon minus everything inside an odd number of the symbols' outlines. Along each side of
-- an outline stands a wall. The tops, at the height of the relief, are the insides of the outlines.
--
-- >          b'------- a'   top
-- >         /|        /|
-- >        / b ----- / a    wall: a b b' and a b' a', where a b has the symbol to its left
-- >       /         /
-- > ---------------------   ground
--
-- Each side of a triangle belongs to one other triangle, which walks it the other way. For a side
-- of the polygon, that one is on the neighbouring face; for a side of an outline, it is a wall.
module PraTactile.Emboss.Face
  ( -- * Symbols
    Stamp (..),
    stampOf,
    outlineSpot,

    -- * Faces
    RaisedMesh (..),
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

-- | A shape prepared for embossing.
data Stamp = Stamp
  { -- | the number of taxels that it raises
    stampArea :: Int,
    -- | the width of its finest stroke, in taxels
    stampStroke :: Int,
    -- | the outlines by their corners
    stampOutlines :: [[Corner]],
    -- | the triangles inside the outlines, by the indices of all outlines' corners
    stampTop :: [(Int, Int, Int)]
  }

-- | The stamp of a shape. Refuses a shape with two taxels that meet only at a corner.
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

-- | Replaces the elements by consecutive numbers from the given one.
numberedFrom :: Int -> [[a]] -> [[Int]]
numberedFrom from = snd . mapAccumL numbered from
  where
    numbered k things = let next = k + length things in (next, [k .. next - 1])

-- | The spot of an outline's corner, for the symbol in a cell given by row and column of its block.
-- The lattice's steps are taxels, and the symbol lies in the middle of its cell.
outlineSpot :: Position -> Corner -> Spot
outlineSpot (Position i j) (x, y) =
  Lattice
    (columnPitch * toInteger j + toInteger ((columnPitch - symbolWidth) `div` 2 + x))
    (rowPitch * toInteger i + toInteger ((rowPitch - symbolHeight) `div` 2 + y))

-- | What a raised face adds to a mesh. The points are new: the corners of the face are not among
-- them. The triangles are counter-clockwise as seen from outside, by indices in the mesh:
-- 'raisedFace' is given the indices of the face's corners, and the first one for new points.
data RaisedMesh = RaisedMesh
  { surfacePoints :: [ExactPoint],
    surfaceTriangles :: [(Int, Int, Int)]
  }

-- | A face with its symbols raised. Arguments: the symbols' height in millimetres; the face's
-- chart; the indices of the face's corners; the first index for new points; the symbols and their
-- cells.
raisedFace :: Rational -> Chart -> U.Vector Int -> Int -> [(Position, Stamp)] -> RaisedMesh
raisedFace height chart walk from symbols =
  RaisedMesh
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
    -- The index of a corner is its first place, because several places of one vertex are one point.
    rimsOf = map (map (places IntMap.!)) (rims (U.toList walk))
    places = IntMap.fromListWith (\_ first -> first) (zip (U.toList walk) [0 ..])
    base k
      | k < corners = walk U.! k
      | otherwise = from + 2 * (k - corners)
    top k = base k + 1

-- | The triangles that fill everything inside an odd number of loops. Arguments: the face's chart;
-- spots; the loops, by indices in that list of spots. The triangles consist of such indices too.
-- They are made in a plane in which lengths of the face are rounded ('planeOf'). Its precision is
-- doubled until every triangle is certain to turn the right way.
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
