-- | Where two faces lie beside each other in an unfolding depends on nothing but the path of glued
-- edges from the one to the other. So whether they overlap is decided once for each path, of which
-- there are far fewer than there are trees: from each face a tree of all paths is made, as far as
-- it is asked for.
module PraTactile.Object.Net.Paths
  ( Paths,
    paths,
    pathEnd,
    pathMeeting,
    onward,
  )
where

import Data.List (intersect)
import qualified Data.Vector as V
import PraTactile.Object.Net.Meeting
import PraTactile.Object.Net.Unfolder
import PraTactile.Object.Surface

-- | A path of glued edges, and those that go on from it to faces that it does not have.
data Paths = Paths
  { -- | the face at its end
    pathEnd :: !Int,
    -- | how the face at its end lies beside the one at its begin
    pathMeeting :: Meeting,
    -- | a path for each side of the face at its end; none where the face across is on it already
    pathsOnward :: V.Vector (Maybe Paths)
  }

-- | The path that goes on across a side of the face at the end, if the face there is not on it.
onward :: Unfolder -> Paths -> Int -> Maybe Paths
onward it path s = pathsOnward path V.! placeOnWalk (unfolderSides it) s

-- | All paths from each face.
paths :: Unfolder -> V.Vector Paths
paths it = V.generate (faceCount it) (pathsFrom it parts)
  where
    parts = V.generate (faceCount it) (convexParts (unfolderMesh it))

pathsFrom :: Unfolder -> V.Vector [Part] -> Int -> Paths
pathsFrom it parts first = Paths first Apart (beyond first [first] Nothing)
  where
    sides = unfolderSides it
    beyond end visited before = V.fromList (map going (sidesOfFace sides end))
      where
        going s
          | next `elem` visited = Nothing
          | otherwise = Just (arriving next (next : visited) (further before s))
          where
            next = sideFace sides (gluedTo sides s)
    arriving end visited reached@(lying, hinges) =
      Paths
        { pathEnd = end,
          pathMeeting =
            meetingOf
              it
              first
              (parts V.! first, cornersLying it hinged Nothing first)
              (parts V.! end, cornersLying it hinged (Just lying) end),
          pathsOnward = beyond end visited (Just reached)
        }
      where
        -- A vertex that all edges of the path have is one point.
        hinged v = if v `elem` hinges then Just v else Nothing
    further before s = case before of
      Nothing -> (across s, ends)
      Just (lying, hinges) -> (lying `lyingOn` across s, hinges `intersect` ends)
      where
        ends = [sideStart sides s, sideEnd sides s]
    across = lyingAcross it
