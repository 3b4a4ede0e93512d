-- | One unfolding: which edges are glued, and where all faces come to lie.
module PraTactile.Object.Net.Unfolding
  ( Unfolding,
    unfoldingAlong,
    unfoldingSides,
    gluedSides,
    placed,
    worstMeeting,
    planarCorners,
  )
where

import qualified Data.IntSet as IntSet
import Data.List (foldl', tails)
import qualified Data.List.NonEmpty as NonEmpty
import qualified Data.Map.Strict as Map
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Enclosure
import PraTactile.Object.Net.Meeting
import PraTactile.Object.Net.Template
import PraTactile.Object.Net.Unfolder
import PraTactile.Object.Number
import PraTactile.Object.Radicals
import PraTactile.Object.Surface
import PraTactile.Object.Vector (squareRoot)

-- | A spanning tree of the faces: the edges that are glued, each by that of its sides whose face is
-- nearer to the first face, in an order in which that face is there already.
newtype Unfolding = Unfolding {unfoldingSides :: [Int]}
  deriving stock (Eq, Show)

-- | The unfolding along these sides, which must be a spanning tree in such an order.
unfoldingAlong :: [Int] -> Unfolding
unfoldingAlong = Unfolding

-- | Both sides of each edge that is glued.
gluedSides :: Unfolder -> Unfolding -> IntSet.IntSet
gluedSides it tree =
  IntSet.fromList (concat [[s, gluedTo (unfolderSides it) s] | s <- unfoldingSides tree])

-- | How each face lies in the plane of the first one.
placed :: Unfolder -> Unfolding -> V.Vector Lying
placed it tree = V.generate (faceCount it) (\f -> Map.findWithDefault still f places)
  where
    sides = unfolderSides it
    places = foldl' lay (Map.singleton 0 still) (unfoldingSides tree)
    lay there s =
      Map.insert
        (sideFace sides (gluedTo sides s))
        (Map.findWithDefault still (sideFace sides s) there `lyingOn` lyingAcross it s)
        there
    still =
      Lying
        (identity (Just . fraction))
        (NonEmpty.map (\digits -> identity (\q -> enclosed digits q 1)) rungPlaces)
    identity make = Similarity (Planar (make 1) (make 0)) (Planar (make 0) (make 0))

-- | How the two faces lie that meet worst, of all pairs.
worstMeeting :: Unfolder -> Unfolding -> Meeting
worstMeeting it tree
  | Overlapping `elem` found = Overlapping
  | otherwise = foldl' max Apart found
  where
    found =
      [ meetingOf it 0 (faces V.! f) (faces V.! g)
        | f : others <- tails [0 .. faceCount it - 1],
          g <- others,
          boxes V.! f `near` (boxes V.! g)
      ]
    sides = unfolderSides it
    lying = placed it tree
    faces =
      V.imap
        (\f at -> (convexParts (unfolderMesh it) f, cornersLying it (point f) (Just at) f))
        lying
    -- Corners that are one point because of the edges that are glued.
    point f v = lookup v [(sideStart sides s, points U.! s) | s <- sidesOfFace sides f]
    points =
      classes
        (sideCount sides)
        ( concat
            [ [(s, nextSide sides t), (nextSide sides s, t)]
              | s <- unfoldingSides tree,
                let t = gluedTo sides s
            ]
        )
    -- Machine numbers are far nearer than the room that is left round each face.
    boxes = V.map box (planarCorners it lying)
    box corners =
      let (xs, ys) = (map fst (V.toList corners), map snd (V.toList corners))
          room = 1e-6 * (1 + maximum (map abs (xs ++ ys)))
       in ((minimum xs - room, maximum xs + room), (minimum ys - room, maximum ys + room))
    near (across, down) (across', down') = meets across across' && meets down down'
    meets (from, to) (from', to') = from <= to' && from' <= to

-- | The corners of each face in millimetres, counter-clockwise with y up, its first one at the
-- origin and its second one to the right of that where it is the first face.
planarCorners :: Unfolder -> V.Vector Lying -> V.Vector (V.Vector (Double, Double))
planarCorners it lying = V.imap (\f at -> V.imap (\i _ -> corner f i at) (corners f)) lying
  where
    corners f = templateCorners (unfolderTemplates it V.! f)
    unit = maybe 1 (squareRoot . templateUnit) (unfolderTemplates it V.!? 0)
    corner f i at =
      fineEnough
        ( NonEmpty.zipWith
            (\to rung -> onPoint to (rungCorners rung V.! f V.! i))
            (lyingRungs at)
            (unfolderRungs it)
        )
    fineEnough rungs = case NonEmpty.dropWhile rough rungs of
      Planar x y : _ -> (unit * fromRational (middle x), unit * fromRational (middle y))
      [] -> (0, 0)
    rough (Planar x y) = radius x > tiny || radius y > tiny
    tiny = 1 / 10 ^ (14 :: Int)
