{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | This library's answers about solids, faces laid on an array, and poses.
module PraTactile.Conformance.Library.Objects
  ( librarySolid,
    libraryCells,
    libraryWhereabouts,
    libraryPose,
  )
where

import Control.Monad (unless, when)
import qualified Data.Set as Set
import qualified Data.Vector.Unboxed as Unboxed
import PraTactile.Array (Position, Shape)
import PraTactile.Conformance.Answer
import PraTactile.Conformance.Question
import PraTactile.Conformance.Wire.Line (longestLine)
import PraTactile.Format.Object (WhereaboutsReport, whereaboutsReport)
import PraTactile.Format.Placement (drawnPlacement)
import PraTactile.Object.Cells (Grid (..), gridOf)
import PraTactile.Object.Defect
import PraTactile.Object.Description
import PraTactile.Object.Mesh (Mesh, fromDescription)
import PraTactile.Object.Placement (Pitch (..), whereabouts)
import PraTactile.Object.Validity (Report (..), examine)
import PraTactile.Pose (Pose, Seen (..), faceFrame, poseOf, rigidFit, thenPose)
import PraTactile.Pose.Matrix (diagonal)

-- | The report on a polyhedron.
librarySolid :: Description -> Wire Report
librarySolid = pure . examine . fromDescription

-- | The whereabouts of a window, by its shape and upper left cell. Refuses faces that cannot be
-- laid so: @impossible-placement@.
libraryWhereabouts :: Mapped -> Shape -> Position -> Wire WhereaboutsReport
libraryWhereabouts (Mapped shape (right, down) objects layings) window at =
  case drawnPlacement shape (Pitch right down) objects layings of
    Left _ -> refuse "impossible-placement"
    Right place -> pure (whereaboutsReport (Just (whereabouts place window at)))

-- | A polyhedron whose only face has these corners. Refuses corners that are no polygon in a plane:
-- @impossible-face@.
oneFace :: [Point] -> Wire Mesh
oneFace corners = do
  when (any ((`elem` faults) . defectKind) (reportDefects (examine it))) $
    refuse "impossible-face"
  pure it
  where
    it = fromDescription (Description (ObjectName "") (zip names corners) [FaceName names])
    names = [VertexName (show i) | i <- [1 .. length corners]]
    faults = [CoincidentVertices, TooFewVertices, NoArea, NotPlanar, FaceCrossesItself]

-- | The cells of symbols on a face with these corners, at these distances along a row and a column:
-- rows of @#@ for a cell on the face and @.@ for any other. Refuses what 'oneFace' refuses and
-- distances that are not positive (@impossible-face@), and rows that together do not fit in a line
-- of the protocol (@too-long@).
libraryCells :: [Point] -> (Rational, Rational) -> Wire [String]
libraryCells corners pitch@(right, down) = do
  it <- oneFace corners
  unless (right > 0 && down > 0) (refuse "impossible-face")
  let grid = gridOf it pitch (Unboxed.fromList [0 .. length corners - 1])
      taken = Set.fromList (gridCells grid)
  when (gridRows grid * (gridColumns grid + 3) > fromIntegral longestLine) (refuse "too-long")
  pure
    [ [ if (r, c) `Set.member` taken then '#' else '.'
        | c <- [0 .. gridColumns grid - 1]
      ]
      | r <- [0 .. gridRows grid - 1]
    ]

-- | The pose of an object from felt points of a face: in the world if a plane is given, else in the
-- robot's frame. Refuses what 'oneFace' refuses, and points that leave the rotation open
-- (@undetermined@).
libraryPose :: Felt -> Wire Pose
libraryPose (Felt corners seen sd plane) = do
  _ <- oneFace corners
  case (,) <$> faceFrame corners <*> rigidFit points of
    Nothing -> refuse "undetermined"
    Just (face, fit) -> pure (maybe id thenPose plane (poseOf face fit))
  where
    points = [Seen q p (diagonal [sd * sd, sd * sd]) | (q, p) <- seen]
