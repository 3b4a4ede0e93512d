{-# LANGUAGE GADTs #-}
{-# LANGUAGE OverloadedStrings #-}

-- | What this library says of solids, of faces laid on an array, and of poses.
module PraTactile.Conformance.Library.Objects
  ( libraryObjects,
  )
where

import Control.Monad (unless, when)
import Data.List (sort)
import qualified Data.Set as Set
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as Unboxed
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Question
import PraTactile.Conformance.Wire.Line (longestLine)
import PraTactile.Emboss
import PraTactile.Emboss.Face (stampOf)
import PraTactile.Format.Object (whereaboutsReport)
import PraTactile.Format.Placement (Drawing (..), drawnPlacement)
import PraTactile.Geometry (taxelPitch)
import PraTactile.Object.Cells (Grid (..), gridOf)
import PraTactile.Object.Defect
import PraTactile.Object.Description
import PraTactile.Object.Mesh (Mesh, fromDescription)
import PraTactile.Object.Net (Census (..), census, mostTrees, spanningTrees)
import PraTactile.Object.Placement
  ( Face (..),
    Pitch (..),
    laidFaces,
    placementSolids,
    whereabouts,
  )
import PraTactile.Object.Validity (Report (..), examine)
import PraTactile.Object.WingedEdge (Solid, outwardNormal, solid)
import PraTactile.Pose (Pose, Seen (..), faceFrame, poseOf, rigidFit, thenPose)
import PraTactile.Pose.Matrix (diagonal)
import PraTactile.Shape (bitmapWhere)

libraryObjects :: Question a -> Wire a
libraryObjects question = case question of
  SolidReport it -> pure (examine (fromDescription it))
  FaceCells corners pitch -> cellsOf corners pitch
  Whereabouts (Mapped shape (right, down) objects layings) window at ->
    case drawnPlacement shape (Pitch right down) objects layings of
      Left _ -> refuse "impossible-placement"
      Right place -> pure (whereaboutsReport (Just (whereabouts place window at)))
  FacePose felt -> poseFelt felt
  Unfold it -> either (const (refuse "impossible-solid")) (pure . unfoldedBy) (solid it)
  Emboss it -> platedBy it
  _ -> notOffered

-- | The face with these corners as a polyhedron's only one.
oneFace :: [Point] -> Wire Mesh
oneFace corners = do
  when (any ((`elem` faults) . defectKind) (reportDefects (examine it))) $
    refuse "impossible-face"
  pure it
  where
    it = fromDescription (Description (ObjectName "") (zip names corners) [FaceName names])
    names = [VertexName (show i) | i <- [1 .. length corners]]
    faults = [CoincidentVertices, TooFewVertices, NoArea, NotPlanar, FaceCrossesItself]

cellsOf :: [Point] -> (Rational, Rational) -> Wire [String]
cellsOf corners pitch@(right, down) = do
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

poseFelt :: Felt -> Wire Pose
poseFelt (Felt corners seen sd plane) = do
  _ <- oneFace corners
  case (,) <$> faceFrame corners <*> rigidFit points of
    Nothing -> refuse "undetermined"
    Just (face, fit) -> pure (maybe id thenPose plane (poseOf face fit))
  where
    points = [Seen q p (diagonal [sd * sd, sd * sd]) | (q, p) <- seen]

unfoldedBy :: Solid -> Unfolded
unfoldedBy whole = Unfolded trees (if trees <= mostTrees then Just numbers else Nothing)
  where
    trees = spanningTrees whole
    found = census whole
    numbers =
      (censusOverlapping found, fromIntegral (length (censusNets found)), censusUpToRotation found)

-- | The plate of a face, made on a prism that has it.
platedBy :: Plate -> Wire Plated
platedBy (Plate corners taxel thickness shapes symbols) = do
  _ <- oneFace corners
  unless (taxel > 0) (refuse "impossible-face")
  when (length cells > fromIntegral mostSymbols) (refuse "too-many-symbols")
  (whole, laid) <- case drawnPlacement size (Pitch (16 * taxel) (20 * taxel)) [prism] [laying] of
    Right place | [found] <- zip (placementSolids place) (laidFaces place) -> pure found
    _ -> refuse "impossible-plate"
  stamps <- traverse stamped cells
  made <-
    either (const (refuse "impossible-plate")) pure $
      embossedPlate (taxel / taxelPitch) (Just thickness) whole laid stamps
  let Volume r s = embossedVolume made
      cut = V.toList (embossedTriangles made)
      sides = concat [[sort [a, b], sort [b, c], sort [c, a]] | (a, b, c) <- cut]
  pure
    Plated
      { platedVolume = (r, s),
        platedVertices = fromIntegral (V.length (embossedPoints made)),
        platedEdges = fromIntegral (Set.size (Set.fromList sides)),
        platedFaces = fromIntegral (length cut)
      }
  where
    cells = [(Position r c, k) | (r, line) <- zip [0 ..] symbols, (c, Just k) <- zip [0 ..] line]
    stamped (cell, k) =
      either (const (refuse "corner-contact")) (pure . (,) cell) . stampOf . bitmapWhere $
        \x y -> '#' `elem` nth x (concat (nth y (concat (nth (fromIntegral k) shapes))))
    nth i list = take 1 (drop i list)
    size = Shape (atLeastOne symbols) (atLeastOne (concat (take 1 symbols)))
    atLeastOne list = fromIntegral (max 1 (length list))
    laying =
      Drawing (Face "" (FaceName above)) 0 0 Nothing (map (map (maybe '.' (const '#'))) symbols)
    prism =
      Description
        ""
        (zip above corners ++ zip below (map (`less` outwardNormal corners) corners))
        ( FaceName above :
          FaceName (reverse below) :
            [ FaceName [b, a, c, d]
              | ((a, b), (c, d)) <- zip (cyclicPairs above) (cyclicPairs below)
            ]
        )
    (above, below) = (named "a", named "b")
    named level = [VertexName (level ++ show i) | i <- [1 .. length corners]]
    less (Point x y z) (Point u v w) = Point (x - u) (y - v) (z - w)
