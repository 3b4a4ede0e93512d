{-# OPTIONS_HADDOCK hide #-}

-- | An unfolding: which edges are glued, and where the faces lie.
module PraTactile.Object.Net.Unfolding
  ( Unfolding,
    unfoldingSides,
    gluedSides,
    laidFlat,

    -- * Face by face
    Growing,
    grown,
    grownMeeting,
    hasFace,
    firstFace,
    glue,
  )
where

import qualified Data.IntMap.Strict as IntMap
import qualified Data.IntSet as IntSet
import Data.List (foldl')
import qualified Data.Vector as V
import PraTactile.Object.Net.Meeting
import PraTactile.Object.Net.Template
import PraTactile.Object.Net.Unfolder
import PraTactile.Object.Surface
import PraTactile.Object.Vector (squareRoot)

-- | A spanning tree of the faces, by the edges along which they are glued. Each edge is given by
-- the number of its side on the face nearer to the first face. The edges are in an order in which
-- that face is already laid.
newtype Unfolding = Unfolding {unfoldingSides :: [Int]}
  deriving stock (Eq, Show)

-- | The numbers of both sides of each edge that is glued.
gluedSides :: Unfolder -> Unfolding -> IntSet.IntSet
gluedSides it tree =
  IntSet.fromList (concat [[s, gluedTo (unfolderSides it) s] | s <- unfoldingSides tree])

-- | Some faces, laid into the plane of the first one, face 0.
data Growing = Growing
  { -- | the sides of earlier faces along which later ones are glued, the last one first
    grownSides :: [Int],
    grownFaces :: IntMap.IntMap Laid,
    -- | the worst meeting of any two of the faces
    grownMeeting :: Meeting
  }

-- | A face in the plane: its corners; their bounding box, as the least and greatest x and the least
-- and greatest y; and for each of its sides the face across it as it lies if glued there.
data Laid = Laid
  { laidCorners :: V.Vector Corner,
    laidBox :: ((Double, Double), (Double, Double)),
    laidAcross :: V.Vector Laid
  }

-- | The unfolding of the faces laid so far.
grown :: Growing -> Unfolding
grown = Unfolding . reverse . grownSides

-- | Whether the face with this number is laid already.
hasFace :: Growing -> Int -> Bool
hasFace growing f = IntMap.member f (grownFaces growing)

-- | The first face alone.
firstFace :: Unfolder -> Growing
firstFace it = Growing [] (IntMap.singleton 0 (laid it 0 lyingStill id)) Apart

-- | Glues the face across this side of a laid face. That face must not be laid already, which is
-- not checked.
glue :: Unfolder -> Growing -> Int -> Growing
glue it (Growing tree faces worst) s =
  Growing
    { grownSides = s : tree,
      grownFaces = maybe id (IntMap.insert g) new faces,
      grownMeeting = if worst == Overlapping then worst else worstOf (worst : found)
    }
  where
    sides = unfolderSides it
    g = sideFace sides (gluedTo sides s)
    new = (V.! placeOnWalk sides s) . laidAcross <$> IntMap.lookup (sideFace sides s) faces
    found =
      [ meetingOf it (part g, laidCorners one) (part h, laidCorners other)
        | Just one <- [new],
          (h, other) <- IntMap.toList faces,
          laidBox one `near` laidBox other
      ]
    part f = unfolderParts it V.! f
    near (across, down) (across', down') = meets across across' && meets down down'
    meets (from, to) (from', to') = from <= to' && from' <= to

-- | The face with this number, laid by this map. The function gives, for the number of each side of
-- the face, the number of the point where the side begins.
laid :: Unfolder -> Int -> Lying -> (Int -> Int) -> Laid
laid it f lying point =
  Laid
    { laidCorners = corners,
      laidBox = ((minimum xs - room, maximum xs + room), (minimum ys - room, maximum ys + room)),
      laidAcross = V.fromList (map across (sidesOfFace sides f))
    }
  where
    sides = unfolderSides it
    corners = cornersLying it point lying f
    (xs, ys) = unzip (map cornerNearly (V.toList corners))
    -- Machine numbers are far more precise than the border around each face.
    room = 1e-6 * (1 + maximum (map abs (xs ++ ys)))
    across s = laid it (sideFace sides t) (lying `lyingOn` lyingAcross it s) glued
      where
        t = gluedTo sides s
        -- The ends of the edge are points of this face.
        glued side
          | side == t = point (nextSide sides s)
          | side == nextSide sides t = point s
          | otherwise = side

-- | The corners of each face in millimetres, counter-clockwise, with x to the right and y up. The
-- first face has its first corner at the origin and its second to the right of that.
laidFlat :: Unfolder -> Unfolding -> V.Vector (V.Vector (Double, Double))
laidFlat it (Unfolding tree) =
  V.generate (faceCount it) $ \f ->
    maybe V.empty (V.map (inMillimetres . cornerNearly) . laidCorners) (IntMap.lookup f faces)
  where
    faces = grownFaces (foldl' (glue it) (firstFace it) tree)
    inMillimetres (x, y) = (unit * x, unit * y)
    unit = maybe 1 (squareRoot . templateUnit) (unfolderTemplates it V.!? 0)
