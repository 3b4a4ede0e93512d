{-# OPTIONS_HADDOCK hide #-}

-- | The pieces of a polyhedron: faces that are connected by edges, what each piece bounds, and
-- which pieces are inside which.
--
-- With V vertices, E edges and F faces, a piece has the Euler number V - E + F = 2 - 2 g; its genus
-- g counts its handles. Six times its volume is the sum of n . v over its faces, where n is the
-- double area vector of a face and v one of its vertices (the cones from the origin; the divergence
-- theorem). It is positive if the faces are outward. An edge is convex if the direction from it
-- into its right face does not point to the outer side of its left face. A surface that does not
-- cut itself is convex if all its edges are.
module PraTactile.Object.Pieces
  ( Component (..),
    Asked (..),
    pieces,
  )
where

import qualified Data.Map.Strict as Map
import Data.Ratio ((%))
import qualified Data.Set as Set
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Boxes
import PraTactile.Object.Defect
import PraTactile.Object.Mesh
import PraTactile.Object.Subject
import PraTactile.Object.Surface
import PraTactile.Object.Vector

-- | Well-formed faces that are connected by edges. A field is 'Nothing' if a defect makes it
-- meaningless.
data Component = Component
  { componentVertices :: Int,
    componentEdges :: Int,
    componentFaces :: Int,
    componentEuler :: Int,
    -- | the number of handles
    componentGenus :: Maybe Int,
    -- | in cubic millimetres, negative if the piece is inward
    componentVolume :: Maybe Rational,
    -- | whether the bounded region is convex
    componentConvex :: Maybe Bool,
    -- | the number of other pieces that it is inside of
    componentInside :: Maybe Int
  }
  deriving stock (Eq, Show)

-- | The properties of a piece that can be asked for.
data Asked = Genus | Volume | Whereabouts

-- | The pieces of a polyhedron, and defects for those that are inside out. The function says which
-- properties are meaningful.
pieces :: SidedMesh -> (Asked -> Bool) -> ([Component], [Defect])
pieces subject told =
  ( [ Component
        { componentVertices = v,
          componentEdges = e,
          componentFaces = length faces,
          componentEuler = v - e + length faces,
          componentGenus =
            if told Genus then Just ((2 - (v - e + length faces)) `div` 2) else Nothing,
          componentVolume = if told Volume then Just (sixfold % sixfoldUnit) else Nothing,
          componentConvex =
            if told Whereabouts then Just (Set.notMember key notConvex) else Nothing,
          componentInside =
            if told Whereabouts then Just (Map.findWithDefault 0 key insides) else Nothing
        }
      | (key, faces) <- Map.toList members,
        let v = Map.findWithDefault 0 key vertices
            e = Map.findWithDefault 0 key edges
            sixfold = Map.findWithDefault 0 key volumes
    ],
    [ Defect InsideOut [faceAt it key] [] Nothing
      | key <- Map.keys members,
        let outward = even (Map.findWithDefault 0 key insides),
        (Map.findWithDefault 0 key volumes > 0) /= outward
    ]
  )
  where
    it = whole subject
    points = meshPoints it
    sixfoldUnit = 6 * meshDenominator it ^ (3 :: Int)
    formedFaces = facesWhere (not . U.null) subject
    belongs =
      classes
        (V.length (formed subject))
        [ (sideFace (sides subject) s, sideFace (sides subject) t)
          | e <- [0 .. edgeCount (sides subject) - 1],
            s : others <- [edgeSides (sides subject) e],
            t <- others
        ]
    pieceOf f = belongs U.! f
    members = Map.fromListWith (++) [(pieceOf f, [f]) | f <- reverse formedFaces]
    count pairs = Map.fromListWith (+) [(piece, 1 :: Int) | piece <- pairs]
    vertices =
      count . map fst . U.toList . U.uniq . sortedPairs $
        U.fromList [(pieceOf f, v) | f <- formedFaces, v <- U.toList (formed subject V.! f)]
    edges =
      count
        [ pieceOf (sideFace (sides subject) s)
          | e <- [0 .. edgeCount (sides subject) - 1],
            s <- take 1 (edgeSides (sides subject) e)
        ]
    volumes =
      Map.fromListWith
        (+)
        [ (pieceOf f, dot (normals subject V.! f) (points V.! (formed subject V.! f U.! 0)))
          | f <- formedFaces
        ]
    -- The edge as seen from inside the bounded region.
    notConvex =
      Set.fromList
        [ piece
          | e <- [0 .. edgeCount (sides subject) - 1],
            [s, t] <- [edgeSides (sides subject) e],
            let piece = pieceOf (sideFace (sides subject) s)
                left = normals subject V.! sideFace (sides subject) s
                right = normals subject V.! sideFace (sides subject) t
                back =
                  (points V.! sideStart (sides subject) s)
                    `minus` (points V.! sideEnd (sides subject) s),
            dot left (cross right back) * signum (Map.findWithDefault 0 piece volumes) > 0
        ]
    insides
      | Map.size members < 2 = Map.empty
      | otherwise =
        Map.fromList
          [ ( key,
              length
                [ ()
                  | (other, crossed) <- Map.toList (count (passed (formed subject V.! key U.! 0))),
                    other /= key,
                    odd crossed
                ]
            )
            | key <- Map.keys members
          ]
    -- The pieces of the faces through which a ray along x from a vertex passes. The ray is shifted
    -- by an infinitesimal amount along y, and by a smaller one along z.
    passed v =
      [ pieceOf f
        | i <- meeting tree (onward (boxOf (rounding subject) (points V.! v))),
          let f = indexed V.! i,
          leaves' f (points V.! v)
      ]
    indexed = V.fromList formedFaces
    tree = boxes (V.map (boxOfFace subject) indexed)
    onward (Box a b c _ e f) = Box a b c maxBound e f
    leaves' f (V3 px py pz)
      | nx == 0 = False
      | otherwise = odd (length (filter id (V.toList (V.zipWith cuts corners after)))) && ahead
      where
        V3 nx ny nz = normals subject V.! f
        corners = cornersOf it (formed subject V.! f)
        after = V.drop 1 corners V.++ V.take 1 corners
        -- The ray meets the face's plane at x = p + over / nx.
        over = dot (V3 nx ny nz) (firstOf corners) - (nx * px + ny * py + nz * pz)
        ahead = signum over * signum nx > 0
        -- Beyond the point along y.
        cuts (V3 _ y z) (V3 _ y' z')
          | (z > pz) == (z' > pz) = False
          | otherwise =
            let side = (y - py) * (z' - z) + (pz - z) * (y' - y)
             in signum side * signum (z' - z) > 0
