-- | Repairs a polyhedron that is not a solid, in these steps: join near vertices and leave out
-- faces on a line, turn faces, flatten faces, and merge faces of one plane. Each step is optional.
module PraTactile.Object.Mend
  ( Mending (..),
    Merging (..),
    mergedBy,
    asItIs,
    mended,
    Mended (..),
    Changes (..),
    noChanges,
    wouldMend,
  )
where

import Data.List (sort)
import Data.Maybe (listToMaybe, mapMaybe, maybeToList)
import Data.Ratio ((%))
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Defect
import PraTactile.Object.Description (FaceName)
import PraTactile.Object.Merge
import PraTactile.Object.Mesh
import PraTactile.Object.Orientation
import PraTactile.Object.Surface
import PraTactile.Object.Tolerance
import PraTactile.Object.Validity
import PraTactile.Object.Vector

-- | The repairs to make.
data Mending = Mending
  { -- | the tolerance of 'settled', in millimetres
    mendTolerance :: Maybe Rational,
    -- | whether faces are turned, by 'oriented'
    mendOrientation :: Bool,
    mendMerging :: Merging
  }
  deriving stock (Eq, Show)

-- | Which faces of one plane are merged if they share sides.
data Merging
  = AsWritten
  | -- | only triangles
    TrianglesMerged
  | CoplanarMerged
  deriving stock (Eq, Show)

-- | No repair.
asItIs :: Mending
asItIs = Mending Nothing False AsWritten

-- | The changes that were made.
data Changes = Changes
  { -- | the number of vertices that moved, and the largest distance in millimetres
    movedVertices :: Int,
    movedMost :: Double,
    -- | the number of faces that were left out, because they lost their area
    leftOutFaces :: Int,
    -- | the faces that were turned, as they are now
    turnedFaces :: [FaceName]
  }
  deriving stock (Eq, Show)

-- | No changes.
noChanges :: Changes
noChanges = Changes 0 0 0 []

-- | A repaired polyhedron and its changes.
data Mended = Mended {mendedMesh :: Mesh, mendedChanges :: Changes}

-- | Repairs a polyhedron. Refuses if its new points have a common denominator that is too large to
-- compute with.
mended :: Mending -> Mesh -> Either TooFine Mended
mended how it = do
  near <- maybe (Right (Settled it 0 0 0)) (`joined` it) (mendTolerance how)
  let (turned, faces)
        | mendOrientation how = oriented (settledMesh near)
        | otherwise = (settledMesh near, [])
      flat = maybe Right (`levelled` together) (mendTolerance how)
  Settled level count most left <- flat near {settledMesh = turned}
  Right
    ( Mended
        (mergedBy (mendMerging how) level)
        (Changes count most left (map (faceAt turned) faces))
    )
  where
    together = case mendMerging how of
      AsWritten -> False
      TrianglesMerged -> V.any ((== 3) . U.length) (meshWalks it)
      CoplanarMerged -> True

-- | Merges faces.
mergedBy :: Merging -> Mesh -> Mesh
mergedBy merging = case merging of
  AsWritten -> id
  TrianglesMerged -> mergeTriangles
  CoplanarMerged -> mergeCoplanar

-- | The additional repairs that would make a polyhedron a solid; 'Nothing' if neither a tolerance
-- nor turning faces does. Arguments: the repairs made so far; the polyhedron before them; its
-- report after them. The tolerance is the one that flattens the faces, or else the least sufficient
-- power of 10, from 10^-9 to 10^-3 of the polyhedron's size.
wouldMend :: Mending -> Mesh -> Report -> Maybe Mending
wouldMend done it report
  | null kinds || any (`notElem` mendable) kinds = Nothing
  | otherwise = listToMaybe (mapMaybe sound (turning ++ moving))
  where
    kinds = kindsOf report
    kindsOf = map defectKind . reportDefects
    turning = [done {mendOrientation = True} | any (`elem` aboutSides) kinds]
    moving = [done {mendTolerance = Just tolerance} | tolerance <- tolerances]
    aboutSides = [FacesDisagree, InsideOut]
    mendable =
      aboutSides
        ++ [CoincidentVertices, TooFewVertices, VertexTwiceOnFace, RepeatedFace, NoArea, NotPlanar]
        ++ [FaceCrossesItself, EdgeWithoutTwoFaces, VertexOnEdge, PinchedVertex, FacesIntersect]
    -- This repair alone, or together with turning faces.
    sound how = case mended how it of
      Right (Mended whole _)
        | closed whole,
          let after = examine whole ->
          if reportValid after
            then Just how
            else
              if not (mendOrientation how) && all (`elem` aboutSides) (kindsOf after)
                then sound how {mendOrientation = True}
                else Nothing
      _ -> Nothing
    -- A quick test first: no solid has another edge.
    closed whole =
      let sides = surface (meshWalks whole)
       in all ((== 2) . length . edgeSides sides) [0 .. edgeCount sides - 1]
    tolerances =
      filter
        (maybe (const True) (<) (mendTolerance done))
        (sort (maybeToList (sufficient it) ++ powers (size it)))
    powers far
      | far <= 0 = []
      | otherwise = [10 ^^ (order far + k) | k <- [-9 .. -3]]
    order far = (floor :: Double -> Int) (logBase 10 far)

-- | The longest side of the vertices' bounding box, in millimetres.
size :: Mesh -> Double
size it = fromRational (maximum (0 : mapMaybe extent axes))
  where
    axes = [\(V3 x _ _) -> x, \(V3 _ y _) -> y, \(V3 _ _ z) -> z]
    extent axis
      | V.null (meshPoints it) = Nothing
      | otherwise =
        let values = V.map axis (meshPoints it)
         in Just ((V.maximum values - V.minimum values) % meshDenominator it)
