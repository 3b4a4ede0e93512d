{-# LANGUAGE OverloadedStrings #-}

-- | Contradictions in stores, and the statements that make them.
module Test.Store.Damage (contradictions, duplicates) where

import Data.Text (Text)
import qualified Data.Text as Text
import PraTactile.Object.Placement hiding (blockCells)
import PraTactile.Object.WingedEdge
import PraTactile.Store
import Test.Recognition.Object.Support

-- | Contradictions in rows with correct seals, and the answer to each.
contradictions :: [([Text], StoreError)]
contradictions =
  [ (["DELETE FROM metadata"], UnreadableRow MetadataTable),
    ( ["UPDATE run SET to_column = to_column - 1 WHERE band = 0 AND from_column = 0"],
      RowsDisagree RunTable
    ),
    ( ["DELETE FROM run WHERE band = (SELECT MAX(from_row) FROM band) AND laying IS NULL"],
      RowsDisagree RunTable
    ),
    (["UPDATE run SET laying = 99 WHERE band = 0 AND from_column = 0"], UnreadableRow RunTable),
    (["UPDATE band SET from_row = -1 WHERE from_row = 0"], UnreadableRow BandTable),
    (["UPDATE laying SET at_row = 1 WHERE number = 1"], RowsDisagree RunTable),
    ( ["UPDATE run SET laying = NULL WHERE laying = 2", "DELETE FROM laying WHERE number = 2"],
      RowsDisagree FaceTable
    ),
    (["UPDATE laying SET begins_at = 9 WHERE number = 7"], RowsDisagree LayingTable),
    (["UPDATE face SET name = 'lid' WHERE object = 1 AND number = 3"], RowsDisagree FaceTable),
    ( ["UPDATE edge SET left_face = right_face WHERE object = 1 AND number = 2"],
      RowsDisagree EdgeTable
    ),
    (["DELETE FROM edge WHERE object = 2 AND number = 11"], RowsDisagree EdgeTable),
    ( ["UPDATE corner SET vertex = 99 WHERE object = 1 AND face = 0 AND number = 0"],
      UnreadableRow CornerTable
    ),
    (["UPDATE object SET next_name = NULL WHERE number = 1"], RowsDisagree ObjectTable),
    (["UPDATE object SET name = 'box' WHERE number = 1"], RowsDisagree MetadataTable),
    ( ["UPDATE vertex SET z = '127001/1000' WHERE object = 1 AND name = 'C1'"],
      -- The face's normal is along (d, -d, 254) with d = 0.001 mm, and C1 is 63.5 d / |n| off.
      NotSolid
        "cube"
        (Defect NotPlanar [readFaceName "C1 C2 C3 C4"] [] (Just 2.49999999996125e-4))
    ),
    ( ["INSERT INTO vertex VALUES (1, 8, 'C9', '1', '2', '3', 0)"],
      NotSolid "cube" (Defect UnusedVertex [] ["C9"] Nothing)
    ),
    ( ["UPDATE laying SET grid_rows = 40, drawn_rows = 40 WHERE number = 1"],
      NotPlaced (CellsOffFace (blockFace (blocks !! 0)) (map snd (blockCells (blocks !! 0))))
    )
  ]

-- | The columns of each table.
duplicates :: [(Text, [Text])]
duplicates =
  [ ( "metadata",
      Text.words
        "schema_version profile array_rows array_columns pitch_right pitch_down first_name seal"
    ),
    ("object", Text.words "number name next_name vertices faces edges seal"),
    ("vertex", Text.words "object number name x y z seal"),
    ("face", Text.words "object number name corners laid seal"),
    ("corner", Text.words "object face number vertex seal"),
    ("edge", Text.words "object number start_vertex end_vertex left_face right_face seal"),
    ( "laying",
      Text.words
        "number object face begins_at at_row at_column grid_rows grid_columns drawn_rows \
        \drawn_columns drawn_from_row drawn_from_column margin_right margin_down seal"
    ),
    ("band", Text.words "from_row to_row seal"),
    ("run", Text.words "band from_column to_column laying seal")
  ]
