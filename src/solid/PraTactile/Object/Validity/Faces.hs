{-# OPTIONS_HADDOCK hide #-}

-- | Defects of single faces, and intersections of two faces.
module PraTactile.Object.Validity.Faces
  ( noAreas,
    notPlanar,
    crossingSelf,
    intersections,
  )
where

import Control.Applicative ((<|>))
import Data.List (sort)
import Data.Ratio ((%))
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Boxes
import PraTactile.Object.Crossing
import PraTactile.Object.Defect
import PraTactile.Object.Intersection
import PraTactile.Object.Mesh
import PraTactile.Object.Polygon
import PraTactile.Object.Subject
import PraTactile.Object.Vector

-- | Defects of single faces, each with the face's index.
noAreas, notPlanar :: SidedMesh -> [(Int, Defect)]
noAreas subject =
  [ (f, Defect NoArea [faceAt (whole subject) f] [] Nothing)
    | f <- facesWhere (not . U.null) subject,
      normals subject V.! f == zero
  ]
notPlanar subject =
  [ (f, Defect NotPlanar [faceAt (whole subject) f] [] (Just (furthest n corners)))
    | f <- facesWhere ((> 3) . U.length) subject,
      let n = normals subject V.! f
          corners = cornersOf (whole subject) (formed subject V.! f),
      n /= zero,
      not (flatAlong n corners)
  ]
  where
    -- With k corners of sum s, k n . v - n . s is k |n| times the distance of v.
    furthest n corners =
      let k = toInteger (V.length corners)
          s = V.foldl' plus zero corners
          over = maximum [abs (k * dot n v - dot n s) | v <- V.toList corners]
       in squareRoot
            (over * over % (k * k * dot n n * meshDenominator (whole subject) ^ (2 :: Int)))

crossingSelf :: SidedMesh -> [Int] -> [(Int, Defect)]
crossingSelf subject flatFaces =
  [ (f, Defect FaceCrossesItself [faceAt it f] (map (vertexAt it . (walk U.!)) ends) Nothing)
    | f <- flatFaces,
      let walk = formed subject V.! f,
      U.length walk > 3,
      let corners = V.map (flat (normals subject V.! f)) (cornersOf it walk),
      Just (i, j) <- [firstCrossing [walk] corners <|> firstWithin walk corners],
      let ends = [i, following corners i, j, following corners j]
  ]
  where
    it = whole subject

-- | The intersections of faces that do not cross themselves, and whether the search stopped early.
-- The first number limits the intersections that are found, the second the pairs that are compared.
intersections :: Int -> Int -> SidedMesh -> [Int] -> ([Defect], Bool)
intersections mostFound mostCompared subject good = look mostFound mostCompared near
  where
    near =
      [ (i, j)
        | i <- [0 .. V.length faces - 1],
          j <- sort (filter (> i) (meeting tree (around' V.! i)))
      ]
    look :: Int -> Int -> [(Int, Int)] -> ([Defect], Bool)
    look _ _ [] = ([], False)
    look toFind toCompare ((i, j) : others)
      | toFind == 0 || toCompare == 0 = ([], True)
      | otherwise = case overlap (plates V.! i) (plates V.! j) of
        Nothing -> look toFind (toCompare - 1) others
        Just square ->
          let (found, more) = look (toFind - 1) (toCompare - 1) others
           in (defect i j square : found, more)
    defect i j square =
      Defect FacesIntersect (map (faceAt it . (faces V.!)) [i, j]) [] (Just (measure square))
    it = whole subject
    faces = V.fromList good
    around' = V.map (boxOfFace subject) faces
    tree = boxes around'
    plates = V.map (plateOf subject) faces
    measure square = squareRoot (square / fromInteger (meshDenominator it) ^ (2 :: Int))

plateOf :: SidedMesh -> Int -> Plate
plateOf subject f = plate walk (cornersOf (whole subject) walk) (normals subject V.! f)
  where
    walk = formed subject V.! f
