-- | What can be done for a polyhedron that is no solid, all of it or a part, in this order:
-- vertices near each other are put together and faces on a line left out, faces are turned, faces
-- are made flat, and faces of one plane are put together.
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

-- | What is to be done.
data Mending = Mending
  { -- | the tolerance of 'settled', millimetres
    mendTolerance :: Maybe Rational,
    -- | whether faces are turned as 'oriented' turns them
    mendOrientation :: Bool,
    mendMerging :: Merging
  }
  deriving stock (Eq, Show)

-- | Which faces of one plane that share sides are put together.
data Merging
  = AsWritten
  | -- | triangles alone
    TrianglesMerged
  | CoplanarMerged
  deriving stock (Eq, Show)

-- | Nothing is done.
asItIs :: Mending
asItIs = Mending Nothing False AsWritten

-- | What was changed.
data Changes = Changes
  { -- | how many vertices were moved, and how far at most, millimetres
    movedVertices :: Int,
    movedMost :: Double,
    -- | how many faces were left out, which had no area left
    leftOutFaces :: Int,
    -- | the faces that were turned, as they are now
    turnedFaces :: [FaceName]
  }
  deriving stock (Eq, Show)

-- | That nothing was changed.
noChanges :: Changes
noChanges = Changes 0 0 0 []

-- | A polyhedron, and what was changed to have it.
data Mended = Mended {mendedMesh :: Mesh, mendedChanges :: Changes}

-- | A polyhedron with this done. Refuses where its new points have no common denominator that one
-- can compute with.
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

-- | Faces put together.
mergedBy :: Merging -> Mesh -> Mesh
mergedBy merging = case merging of
  AsWritten -> id
  TrianglesMerged -> mergeTriangles
  CoplanarMerged -> mergeCoplanar

-- | What has to be done in addition for a polyhedron to be a solid, or nothing where neither a
-- tolerance nor turning its faces makes it one. Given are what was done, the polyhedron before
-- that, and the report of it after. The tolerance is the one that makes its faces flat, or else the
-- least power of 10 that will do, from 10^-9 to 10^-3 of its size.
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
    -- This, or this and that faces are turned.
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
    -- What is quickly seen: no solid has another edge.
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

-- | The longest side of the box round all vertices, millimetres.
size :: Mesh -> Double
size it = fromRational (maximum (0 : mapMaybe extent axes))
  where
    axes = [\(V3 x _ _) -> x, \(V3 _ y _) -> y, \(V3 _ _ z) -> z]
    extent axis
      | V.null (meshPoints it) = Nothing
      | otherwise =
        let values = V.map axis (meshPoints it)
         in Just ((V.maximum values - V.minimum values) % meshDenominator it)
