{-# OPTIONS_HADDOCK hide #-}

-- | Defects where faces meet at edges and vertices.
module PraTactile.Object.Validity.Edges
  ( withoutTwo,
    disagreements,
    pinchedVertices,
    verticesOnEdges,
  )
where

import Data.List (sort)
import Data.Maybe (isJust)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Boxes
import PraTactile.Object.Defect
import PraTactile.Object.Mesh
import PraTactile.Object.Subject
import PraTactile.Object.Surface
import PraTactile.Object.Vector

withoutTwo, disagreements, pinchedVertices, verticesOnEdges :: SidedMesh -> [Defect]
withoutTwo subject =
  [ Defect
      EdgeWithoutTwoFaces
      (map (faceAt (whole subject) . sideFace (sides subject)) together)
      (map (vertexAt (whole subject)) (endsOf subject s))
      Nothing
    | e <- [0 .. edgeCount (sides subject) - 1],
      let together = edgeSides (sides subject) e,
      length together /= 2,
      s <- take 1 together
  ]
disagreements subject =
  [ Defect
      FacesDisagree
      (map (faceAt (whole subject) . sideFace (sides subject)) [s, t])
      (map (vertexAt (whole subject)) [sideStart (sides subject) s, sideEnd (sides subject) s])
      Nothing
    | e <- [0 .. edgeCount (sides subject) - 1],
      [s, t] <- [edgeSides (sides subject) e],
      sideStart (sides subject) s == sideStart (sides subject) t
  ]
-- Corners at a vertex are connected across the sides that leave it and arrive at it.
pinchedVertices subject =
  [ Defect PinchedVertex [] [vertexAt (whole subject) v] Nothing
    | v <- U.toList (U.findIndices (> 1) ringsAt),
      closed U.! v
  ]
  where
    it = sides subject
    every = [0 .. sideCount it - 1]
    corners =
      classes
        (sideCount it)
        [ (s, if sideStart it mate == sideStart it s then mate else nextSide it mate)
          | s <- every,
            side <- [s, previousSide it s],
            Just mate <- [mateOf it side]
        ]
    ringsAt =
      U.accum
        (+)
        (U.replicate (V.length (meshPoints (whole subject))) (0 :: Int))
        [(sideStart it s, 1) | s <- every, corners U.! s == s]
    closed =
      U.accum
        (&&)
        (U.replicate (V.length (meshPoints (whole subject))) True)
        [(v, False) | s <- every, not (isJust (mateOf it s)), v <- endsOf subject s]
verticesOnEdges subject =
  [ Defect VertexOnEdge [] (map (vertexAt it) (v : ends)) Nothing
    | (v, ends) <-
        sort
          [ (v, endsOf subject s)
            | e <- [0 .. edgeCount (sides subject) - 1],
              s <- take 1 (edgeSides (sides subject) e),
              let (from, to) = (sideStart (sides subject) s, sideEnd (sides subject) s)
                  (a, b) = (place from, place to),
              v <- map (used U.!) (along tree (box a) (box b)),
              v /= from,
              v /= to,
              let p = place v,
              dot (a `minus` p) (b `minus` p) < 0,
              cross (a `minus` p) (b `minus` p) == zero
          ]
  ]
  where
    it = whole subject
    place = (meshPoints it V.!)
    box = boxOf (rounding subject)
    used = U.findIndices id (U.update_ none visited (U.map (const True) visited))
    none = U.replicate (V.length (meshPoints it)) False
    visited = U.concat (V.toList (formed subject))
    tree = boxes (V.map (box . place) (V.convert used))

-- | The ends of a side, the one with the smaller index first.
endsOf :: SidedMesh -> Int -> [Int]
endsOf subject s = sort [sideStart (sides subject) s, sideEnd (sides subject) s]
