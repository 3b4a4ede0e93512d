{-# LANGUAGE OverloadedStrings #-}

-- | The object that was recognised, as it lies before the robot.
module Picture.Posed
  ( posedPanel,
  )
where

import Data.List (transpose)
import Drawing
import Picture.Solid
import Picture.Style
import PraTactile.Array (Position)
import PraTactile.Object.Placement
import PraTactile.Object.View
import PraTactile.Object.WingedEdge
import PraTactile.Pose (RigidMotion (..))
import PraTactile.Shape (Alphabet)

-- | The object with its symbols, if they are no more than can be seen, as it lies in the robot's
-- frame, to which the motion leads: seen over the sensor's plane as over a table, x to the right, y
-- towards the viewer. The face of the place stands out, and the place is marked.
posedPanel ::
  Alphabet ->
  Placement ->
  (LaidFace -> Position -> Int) ->
  (Solid, RigidMotion) ->
  Place ->
  Drawing
posedPanel alphabet layout classesOf (whole, motion) place =
  above
    12
    [ [Mark "heading" (Words FromLeft heading (0, 0) title)],
      [Mark "note" (Words FromLeft plain (0, 0) "seen obliquely from the sensor's side")],
      [Mark "note" (Words FromLeft plain (0, 0) "x to the right, y towards you")],
      solidDrawing shown whole ++ placeMarks (onDrawing shown whole spot)
    ]
  where
    Face object name = placeFace place
    title = "How it lies: " ++ objectText object
    shown =
      Shown
        { shownView = viewAlong (back (unit (0.3, 0.9, -1))) (back (0, 0, -1)) (Just 4),
          shownSymbols =
            if fewSymbols 1000 layout whole
              then embossedOn alphabet layout classesOf whole
              else mempty,
          shownTinted = [i | (i, face) <- zip [0 ..] (solidFaces whole), sameFace face name],
          shownSize = 320
        }
    spot = onFaceOf whole name (spotMillimetres (placeCentre place))
    -- A direction of the robot's frame in the object's own: the rotation undone.
    back (x, y, z) = case map (sum . zipWith (*) [x, y, z]) (transpose (motionRows motion)) of
      [a, b, c] -> (a, b, c)
      _ -> (x, y, z)
    unit (x, y, z) = let long = sqrt (x * x + y * y + z * z) in (x / long, y / long, z / long)
