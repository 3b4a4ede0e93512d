-- | Polyhedra for computing: vertices and faces by index, with coordinates as integers over one
-- common denominator. 'fromDescription' and 'toDescription' convert names and fractions. Nothing is
-- checked here.
module PraTactile.Object.Mesh
  ( -- * Polyhedra by index
    Mesh,
    Walk,
    mesh,
    unnamed,
    meshName,
    meshDenominator,
    meshPoints,
    meshWalks,
    meshNames,
    meshRepeated,
    ofVertices,
    cornersOf,
    firstOf,
    doubleArea,
    flatAlong,
    withShape,
    scaledBy,
    named,

    -- * Names and fractions
    fromDescription,
    toDescription,
    vertexAt,
    faceAt,
    pointAt,
    overOne,
    lowestTerms,

    -- * Equal things
    firstAlike,
  )
where

import Data.List (foldl')
import qualified Data.Map.Strict as Map
import Data.Ratio (denominator, numerator, (%))
import qualified Data.Set as Set
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Description
import PraTactile.Object.Vector

-- | The vertices of a face by their indices, counter-clockwise as seen from outside.
type Walk = U.Vector Int

-- | A polyhedron by index.
data Mesh = Mesh
  { -- | the object's name
    meshName :: ObjectName,
    -- | the denominator of the coordinates in millimetres: positive, in lowest terms with all
    -- coordinates
    meshDenominator :: !Integer,
    -- | the vertices' coordinates, times the denominator
    meshPoints :: !(V.Vector V3),
    -- | the walk around each face; an index beyond the vertices stands for a name without a vertex
    meshWalks :: !(V.Vector Walk),
    -- | the vertices' names in order, then the names without a vertex
    meshNames :: V.Vector VertexName,
    -- | the vertices with a repeated name, each with the first vertex of that name
    meshRepeated :: Map.Map Int Int
  }
  deriving stock (Eq, Show)

-- | A polyhedron. Arguments: its name; the names of the vertices, which must be distinct; the
-- denominator of the coordinates in millimetres, which must not be 0; the vertices' coordinates,
-- times the denominator; the walks. The conditions are not checked.
mesh ::
  ObjectName -> V.Vector VertexName -> Integer -> V.Vector V3 -> V.Vector Walk -> Mesh
mesh name names over points walks = Mesh name lowest reduced walks names Map.empty
  where
    (lowest, reduced) = lowestTerms over points

-- | Reduces a denominator and the coordinates over it to lowest terms, with a positive denominator.
lowestTerms :: Integer -> V.Vector V3 -> (Integer, V.Vector V3)
lowestTerms over points
  | common == 1 = (over, points)
  | otherwise = (over `quot` common, V.map divided points)
  where
    common = signum over * V.foldl' shared (abs over) points
    shared 1 _ = 1
    shared g (V3 a b c) = gcd c (gcd b (gcd a g))
    divided (V3 a b c) = V3 (a `quot` common) (b `quot` common) (c `quot` common)

-- | Default names for this number of vertices: V1, V2, ...
unnamed :: Int -> V.Vector VertexName
unnamed count = V.generate count (\i -> VertexName ('V' : show (i + 1)))

-- | Whether all vertices of a walk exist.
ofVertices :: Mesh -> Walk -> Bool
ofVertices it = U.all (< V.length (meshPoints it))

-- | The points of a walk, whose vertices must all exist.
cornersOf :: Mesh -> Walk -> V.Vector V3
cornersOf it walk = V.map (meshPoints it V.!) (V.convert walk)

-- | The first point of a walk; the origin for an empty one.
firstOf :: V.Vector V3 -> V3
firstOf = V.foldr const zero

-- | Twice the vector area of a polygon (Newell's formula). It points to the side from which the
-- polygon is counter-clockwise.
doubleArea :: V.Vector V3 -> V3
doubleArea corners
  | V.length corners < 3 = zero
  | otherwise = V.foldl' plus zero (V.zipWith cross arms (V.drop 1 arms))
  where
    arms = V.map (`minus` firstOf corners) (V.drop 1 corners)

-- | Whether all points lie in one plane to which the vector is normal.
flatAlong :: V3 -> V.Vector V3 -> Bool
flatAlong n corners = V.all ((== dot n (firstOf corners)) . dot n) corners

-- | The object with other vertices and walks; the arguments before the object are those of 'mesh'
-- after the name.
withShape :: V.Vector VertexName -> Integer -> V.Vector V3 -> V.Vector Walk -> Mesh -> Mesh
withShape names over points walks old = mesh (meshName old) names over points walks

-- | Multiplies all coordinates by a positive number.
scaledBy :: Rational -> Mesh -> Mesh
scaledBy k old = old {meshDenominator = lowest, meshPoints = reduced}
  where
    (lowest, reduced) =
      lowestTerms
        (meshDenominator old * denominator k)
        (V.map (scaled (numerator k)) (meshPoints old))

-- | The polyhedron under another name.
named :: ObjectName -> Mesh -> Mesh
named name old = old {meshName = name}

-- | A description by index. A repeated name means the first vertex with it.
fromDescription :: Description -> Mesh
fromDescription described =
  Mesh
    { meshName = describedName described,
      meshDenominator = over,
      meshPoints = points,
      meshWalks =
        V.fromList [U.fromList (map index walk) | FaceName walk <- describedFaces described],
      meshNames = V.fromList (own ++ alien),
      meshRepeated =
        Map.fromList [(i, j) | (i, name) <- zip [0 ..] own, let j = index name, i /= j]
    }
  where
    own = map fst (describedVertices described)
    places = Map.fromListWith (\_ first -> first) (zip own [0 :: Int ..])
    alien =
      Set.toList
        ( Set.fromList
            [ name
              | FaceName walk <- describedFaces described,
                name <- walk,
                Map.notMember name places
            ]
        )
    beyond = Map.fromList (zip alien [length own ..])
    index name = Map.findWithDefault (Map.findWithDefault 0 name beyond) name places
    (over, points) = overOne (map snd (describedVertices described))

-- | Points over their least common denominator.
overOne :: [Point] -> (Integer, V.Vector V3)
overOne places = (over, V.fromList (map whole places))
  where
    over =
      foldl'
        (\common (Point x y z) -> foldl' lcm common (map denominator [x, y, z]))
        1
        places
    whole (Point x y z) = V3 (times x) (times y) (times z)
    times x = numerator x * (over `quot` denominator x)

-- | The description of a polyhedron; the inverse of 'fromDescription'.
toDescription :: Mesh -> Description
toDescription it =
  Description
    { describedName = meshName it,
      describedVertices =
        [(vertexAt it i, pointAt it i) | i <- [0 .. V.length (meshPoints it) - 1]],
      describedFaces = [faceAt it f | f <- [0 .. V.length (meshWalks it) - 1]]
    }

-- | The name of a vertex.
vertexAt :: Mesh -> Int -> VertexName
vertexAt it i = meshNames it V.! i

-- | The name of a face: its vertices in the order of its walk.
faceAt :: Mesh -> Int -> FaceName
faceAt it f = FaceName (map (vertexAt it) (U.toList (meshWalks it V.! f)))

-- | The position of a vertex in millimetres.
pointAt :: Mesh -> Int -> Point
pointAt it i = Point (part x) (part y) (part z)
  where
    V3 x y z = meshPoints it V.! i
    part n = n % meshDenominator it

-- | For each item the index of the first equal one, which may be its own. O(n log n).
firstAlike :: Ord a => V.Vector a -> U.Vector Int
firstAlike items = U.fromListN (V.length items) (go Map.empty (zip [0 ..] (V.toList items)))
  where
    go seen ((i, item) : others) = case Map.lookup item seen of
      Just first -> first : go seen others
      Nothing -> i : go (Map.insert item i seen) others
    go _ [] = []
{-# INLINEABLE firstAlike #-}
