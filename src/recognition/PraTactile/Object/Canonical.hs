{-# LANGUAGE OverloadedStrings #-}

-- | The canonical placement: the paper's two objects on its 15 x 17 array. The paper's own
-- placement, in Figure 8, is lost. This one puts the window of the worked example, at (6, 5), where
-- the paper finds it: at corner C2 of face C1 C2 C3 C4.
module PraTactile.Object.Canonical
  ( canonicalPlacement,
    canonicalPitch,
    canonicalLayings,
    canonicalWindow,
  )
where

import Data.Bifunctor (first)
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Geometry (columnPitch, rowPitch, taxelPitch)
import PraTactile.Object.PaperObjects (cube, parallelepiped)
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge

-- | The pitch at which symbols are read: 25.4 mm (1 in) along a row and 31.75 mm (1 1/4 in) along a
-- column (section IV; its second \"horizontal\" is a slip of the pen).
--
-- >>> canonicalPitch
-- Pitch {pitchRight = 127 % 5, pitchDown = 127 % 4}
canonicalPitch :: Pitch
canonicalPitch = Pitch (columnPitch * taxelPitch) (rowPitch * taxelPitch)

-- | The paper's window: 2 rows, 2 columns.
canonicalWindow :: Shape
canonicalWindow = Shape 2 2

-- | The twelve faces on the array of 15 rows and 17 columns; they take 228 of its 255 cells. It is
-- always 'Right': both objects are valid solids, and the faces do not overlap.
canonicalPlacement :: Either PlacementError Placement
canonicalPlacement = do
  objects <- first BrokenObject (sequence [cube, parallelepiped])
  placement (Shape 15 17) canonicalPitch objects canonicalLayings

-- | The faces with the cells that they take: object, face, upper left cell, rows and columns.
canonicalLayings :: [Laying]
canonicalLayings =
  [ laidWhole (Face object (readFaceName face)) at grid
    | (object, face, at, grid) <-
        [ ("cube", "C2 C6 C7 C3", Position 0 0, Shape 4 5),
          ("cube", "C3 C7 C8 C4", Position 0 5, Shape 4 5),
          ("cube", "C4 C8 C5 C1", Position 4 0, Shape 4 5),
          ("cube", "C1 C2 C3 C4", Position 4 5, Shape 4 5),
          ("cube", "C1 C5 C6 C2", Position 8 0, Shape 4 5),
          ("cube", "C6 C5 C8 C7", Position 8 5, Shape 4 5),
          ("parallelepiped", "P1 P2 P3 P4", Position 0 10, Shape 3 7),
          ("parallelepiped", "P6 P5 P8 P7", Position 3 10, Shape 3 7),
          ("parallelepiped", "P2 P6 P7 P3", Position 6 10, Shape 3 7),
          ("parallelepiped", "P4 P8 P5 P1", Position 9 10, Shape 3 7),
          ("parallelepiped", "P3 P7 P8 P4", Position 12 0, Shape 3 4),
          ("parallelepiped", "P1 P5 P6 P2", Position 12 4, Shape 3 4)
        ]
  ]
