{-# LANGUAGE OverloadedStrings #-}

-- | Databases that contradict themselves, and how they are made.
module Test.Store.Damage (contradictions, duplicates) where

import Data.Text (Text)
import qualified Data.Text as Text
import PraTactile.Array (Position (..))
import PraTactile.Object.Placement
import PraTactile.Object.Relation
import PraTactile.Object.WingedEdge
import PraTactile.Store
import Test.Recognition.Object.Support

-- What may not be written into a store, and the answer.
contradictions :: [(String, Text, StoreError)]
contradictions =
  [ ("no metadata", "DELETE FROM metadata", UnreadableRow MetadataTable),
    ( "a cell moved on its face",
      "UPDATE cell SET local_column = 99 WHERE id = 7",
      InconsistentRows (RowsDisagree CellTable)
    ),
    ( "a cell missing",
      "DELETE FROM cell WHERE id = 228",
      -- A face may have fewer cells than there is room for; but it had this one.
      ChangedRows
    ),
    ("a cell of no face", "UPDATE cell SET laying = 99 WHERE id = 7", UnreadableRow CellTable),
    ( "a cell in a negative row",
      "UPDATE cell SET array_row = -1 WHERE id = 7",
      UnreadableRow CellTable
    ),
    ( "a face laid over another",
      "UPDATE laying SET at_row = 1, at_column = 5 WHERE id = 1",
      InconsistentRows
        ( NotPlaced
            ( FacesOverlap
                (blockFace (blocks !! 0))
                (blockFace (blocks !! 1))
                [Position r c | r <- [1 .. 3], c <- [5 .. 9]]
            )
        )
    ),
    ( "a face wider than its vertices are apart",
      "UPDATE laying SET width_um = 127001 WHERE id = 2",
      InconsistentRows (RowsDisagree LayingTable)
    ),
    ( "a face by another name",
      "UPDATE face SET name = 'lid' WHERE id = 4",
      InconsistentRows (RowsDisagree FaceTable)
    ),
    ( "an edge between other faces",
      "UPDATE edge SET left_face = right_face WHERE id = 3",
      InconsistentRows (RowsDisagree EdgeTable)
    ),
    ( "an edge missing",
      "DELETE FROM edge WHERE id = 24",
      InconsistentRows (RowsDisagree EdgeTable)
    ),
    ( "an edge to no vertex",
      "UPDATE edge SET end_vertex = 99 WHERE id = 3",
      UnreadableRow EdgeTable
    ),
    ( "an object with a vertex moved",
      "UPDATE vertex SET z_um = z_um + 1 WHERE name = 'C1'",
      -- The face's normal is along (d, -d, 254) with d = 0.001 mm, and C1 is 63.5 d / |n| off.
      InconsistentRows
        ( NotSolid
            "cube"
            (Defect NotPlanar [readFaceName "C1 C2 C3 C4"] [] (Just 2.49999999996125e-4))
        )
    ),
    ( "an object with a vertex too many",
      "INSERT INTO vertex (object, name, x_um, y_um, z_um) VALUES (1, 'C9', 1, 2, 3)",
      InconsistentRows (NotSolid "cube" (Defect UnusedVertex [] ["C9"] Nothing))
    )
  ]

duplicates :: [(Text, [Text])]
duplicates =
  [ ( "metadata",
      Text.words "schema_version profile array_rows array_columns pitch_right_um pitch_down_um"
    ),
    ("object", ["name"]),
    ("vertex", Text.words "object name x_um y_um z_um"),
    ("face", ["object", "name"]),
    ("corner", ["face", "number", "vertex"]),
    ("edge", Text.words "object start_vertex end_vertex left_face right_face"),
    ( "laying",
      Text.words "face at_row at_column grid_rows grid_columns width_um height_um"
    ),
    ("cell", Text.words "array_row array_column laying local_row local_column")
  ]
