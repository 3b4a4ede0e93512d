{-# OPTIONS_HADDOCK hide #-}

-- | Defects of the names of vertices and of the walks of faces, whatever the vertices' places.
module PraTactile.Object.Validity.Walks
  ( repeatedNames,
    coincident,
    unused,
    unknown,
    tooFew,
    twice,
    facesAlike,
  )
where

import Data.List (sort, sortOn)
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Defect
import PraTactile.Object.Mesh
import PraTactile.Object.Subject

repeatedNames, coincident, unused, unknown, tooFew, twice :: Mesh -> [Defect]
repeatedNames it =
  [Defect RepeatedName [] [vertexAt it i] Nothing | i <- Set.toList (repeatedFirsts it)]
coincident it =
  [ Defect CoincidentVertices [] (map (vertexAt it) alike) Nothing
    | alike <- alikeGroups (meshPoints it)
  ]
unused it =
  [ Defect UnusedVertex [] [vertexAt it i] Nothing
    | i <- [0 .. count - 1],
      not (used U.! Map.findWithDefault i i (meshRepeated it))
  ]
  where
    count = V.length (meshPoints it)
    used =
      U.accumulate
        (\_ now -> now)
        (U.replicate (V.length (meshNames it)) False)
        (U.map (\i -> (i, True)) (U.concat (V.toList (meshWalks it))))
unknown it =
  [ Defect UnknownVertex [faceAt it f] [vertexAt it i] Nothing
    | (f, walk) <- V.toList (V.indexed (meshWalks it)),
      not (ofVertices it walk),
      i <- Set.toList (Set.fromList (U.toList walk)),
      i >= V.length (meshPoints it)
  ]
tooFew it =
  [ Defect TooFewVertices [faceAt it f] [] Nothing
    | (f, walk) <- V.toList (V.indexed (meshWalks it)),
      U.length walk < 3
  ]
twice it =
  [ Defect VertexTwiceOnFace [faceAt it f] [vertexAt it i] Nothing
    | (f, walk) <- V.toList (V.indexed (meshWalks it)),
      U.length walk > 1,
      i <- if U.length walk == 2 then [walk U.! 0 | walk U.! 0 == walk U.! 1] else repeats walk
  ]

-- | The groups of faces with the same vertices.
facesAlike :: Mesh -> [[Int]]
facesAlike = alikeGroups . V.map (U.fromList . sort . U.toList) . meshWalks

-- | The indices of equal elements, in groups of at least two, sorted by their first ones.
alikeGroups :: Ord a => V.Vector a -> [[Int]]
alikeGroups things =
  sortOn
    (take 1)
    [ group
      | group@(_ : _ : _) <-
          Map.elems
            ( Map.fromListWith
                (++)
                [ (first, [i])
                  | (i, first) <- reverse (U.toList (U.indexed firsts)),
                    shared U.! first > 1
                ]
            )
    ]
  where
    firsts = firstAlike things
    shared =
      U.accumulate (+) (U.replicate (V.length things) (0 :: Int)) (U.map (\f -> (f, 1)) firsts)
