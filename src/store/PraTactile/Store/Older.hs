{-# LANGUAGE OverloadedStrings #-}

-- | Stores of versions 1 and 2, which had whole micrometres and a row a cell: they are read, so as
-- to be asked, and to be replaced. All their faces are rectangles, begin at the first corner and
-- have their block in the middle.
module PraTactile.Store.Older
  ( selectOlder,
  )
where

import Control.Monad (unless)
import Control.Monad.IO.Class (MonadIO)
import Control.Monad.Trans.Class (lift)
import Control.Monad.Trans.Except (except, throwE)
import Data.Bifunctor (first)
import Data.Int (Int64)
import Data.List (sort)
import qualified Data.Map.Strict as Map
import Data.Maybe (listToMaybe)
import Data.Ratio ((%))
import Data.Text (Text)
import qualified Data.Text as Text
import Data.Traversable (for)
import Database.Persist.Sql (RawSql, Single (..), rawSql)
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Certificate.Digest (sha256OfText)
import PraTactile.Object.Placement
import PraTactile.Object.Surd (fraction)
import PraTactile.Object.WingedEdge
import PraTactile.Store.Error
import PraTactile.Store.Query (Query)
import Text.Read (readMaybe)

-- | The text of the profile, and the placement, of a store of this version. Version 2 has a digest
-- of all its rows, and what differs from it is refused. Version 1 has none: there what follows from
-- other rows (edges, names and sizes of faces, cells) must be what they imply, and a change of the
-- rest that leaves rectangles of those sizes is not noticed.
selectOlder :: MonadIO m => Int64 -> Query m (String, Placement)
selectOlder version = do
  sheets <-
    rowsOf $
      "SELECT profile, array_rows, array_columns, pitch_right_um, pitch_down_um, id, "
        <> (if version == 1 then "''" else "contents")
        <> " FROM metadata"
  (profile, (high, wide), (right, down), sheet, digest) <- case sheets of
    [(Single text, Single r, Single c, Single x, Single y, Single key, Single sum_)] ->
      pure (text :: Text, (r, c), (x, y), key :: Int64, sum_ :: Text)
    _ -> throwE (UnreadableRow MetadataTable)
  objects <- rowsOf "SELECT id, name FROM object ORDER BY id"
  vertices <- rowsOf "SELECT id, object, name, x_um, y_um, z_um FROM vertex ORDER BY id"
  faces <- rowsOf "SELECT id, object, name FROM face ORDER BY id"
  corners <- numbersOf "corner" "face, number, vertex"
  edges <- numbersOf "edge" "object, start_vertex, end_vertex, left_face, right_face"
  layings <-
    numbersOf "laying" "face, at_row, at_column, grid_rows, grid_columns, width_um, height_um"
  cells <- numbersOf "cell" "array_row, array_column, laying, local_row, local_column"
  let named = [(key, name :: Text) | (Single key, Single name) <- objects] :: [(Int64, Text)]
      points =
        [ (key, (object, name, [x, y, z]))
          | (Single key, Single object, Single name, Single x, Single y, Single z) <- vertices
        ] ::
          [(Int64, (Int64, Text, [Int64]))]
      walks =
        [(key, (object, name)) | (Single key, Single object, Single name) <- faces] ::
          [(Int64, (Int64, Text))]
      hashed =
        counted [(sheet, ((2 :: Int, profile), (high, wide), (right, down)))]
          ++ counted named
          ++ counted points
          ++ counted walks
          ++ concatMap counted [corners, edges, layings, cells]
  unless
    (version == 1 || Text.pack (sha256OfText (unlines hashed)) == digest)
    (throwE (ChangedRow MetadataTable))
  let vertexNames =
        Map.fromList [(key, VertexName (Text.unpack name)) | (key, (_, name, _)) <- points]
      objectNames = Map.fromList [(key, ObjectName (Text.unpack name)) | (key, name) <- named]
      faceNames =
        Map.fromList
          [ (face, Face owner (FaceName (Map.elems (Map.findWithDefault Map.empty face walked))))
            | (face, (object, _)) <- walks,
              Just owner <- [Map.lookup object objectNames]
          ]
      walked =
        Map.fromListWith
          Map.union
          [ (face, Map.singleton number name)
            | (_, [face, number, vertex]) <- corners,
              Just name <- [Map.lookup vertex vertexNames]
          ]
      taken =
        Map.fromListWith
          (++)
          [(laying, [Position (natural r) (natural c)]) | (_, [_, _, laying, r, c]) <- cells]
      described (object, name) =
        Description
          (ObjectName (Text.unpack name))
          [ (VertexName (Text.unpack vertex), Point (millimetres x) (millimetres y) (millimetres z))
            | (_, (owner, vertex, [x, y, z])) <- points,
              owner == object
          ]
          [ faceName name'
            | (face, (owner, _)) <- walks,
              owner == object,
              Just name' <- [Map.lookup face faceNames]
          ]
      wishes =
        [ Laying
            face
            (Position (natural r) (natural c))
            Centred
            (blockOf (Shape (natural h) (natural w)) (Map.findWithDefault [] laying taken))
          | (laying, [key, r, c, h, w, _, _]) <- layings,
            Just face <- [Map.lookup key faceNames]
        ]
      shape = Shape (natural high) (natural wide)
      between = Pitch (millimetres right) (millimetres down)
  solids <- for named $ \one -> do
    let it = described one
    except (first (NotSolid (describedName it)) (solid it))
  place <- except (first NotPlaced (placement shape between solids wishes))
  let numberOf face = lookup face [(named', key) | (key, named') <- Map.toList faceNames]
      vertexOf whole vertex =
        listToMaybe
          [ key
            | (key, (owner, name, _)) <- points,
              Map.lookup owner objectNames == Just (solidName whole),
              VertexName (Text.unpack name) == vertex
          ]
      -- From either of its ends.
      eitherWay edge@(from, to, l, r) = min edge (to, from, r, l)
  agree FaceTable [(key, Text.unpack name) | (key, (_, name)) <- walks] $
    Map.toList (fmap (faceText . faceName) faceNames)
  agree
    EdgeTable
    [eitherWay (Just from, Just to, Just l, Just r) | (_, [_, from, to, l, r]) <- edges]
    [ eitherWay
        ( vertexOf whole (edgeStart edge),
          vertexOf whole (edgeEnd edge),
          on edgeLeft,
          on
            edgeRight
        )
      | whole <- solids,
        edge <- solidEdges whole,
        let on side = numberOf (Face (solidName whole) (side edge))
    ]
  agree
    LayingTable
    [ (Map.lookup key faceNames, (fraction (millimetres w), fraction (millimetres h)))
      | (_, [key, _, _, _, _, w, h]) <- layings
    ]
    [ (Just (laidFace laid), (spotRight (laidExtent laid), spotDown (laidExtent laid)))
      | laid <- laidFaces place
    ]
  agree
    LayingTable
    [(laying, (r, c), (i, j)) | (_, [r, c, laying, i, j]) <- cells]
    [ (laying, (r + i, c + j), (i, j))
      | (laying, [_, r, c, h, w, _, _]) <- layings,
        i <- [0 .. h - 1],
        j <- [0 .. w - 1]
    ]
  pure (Text.unpack profile, place)
  where
    agree table found implied = unless (sort found == sort implied) (throwE (RowsDisagree table))
    -- The digest or what follows from them vouches for what they are.
    natural = fromInteger . max 0 . toInteger
    millimetres :: Int64 -> Rational
    millimetres micrometres = toInteger micrometres % 1000

rowsOf :: (MonadIO m, RawSql row) => Text -> Query m [row]
rowsOf sql = lift (rawSql sql [])

-- | The rows of a table of whole numbers, each as its key and its columns.
numbersOf :: MonadIO m => Text -> Text -> Query m [(Int64, [Int64])]
numbersOf table columns' = do
  found <-
    rowsOf $
      "SELECT '(' || id || ',[' || "
        <> Text.replace ", " " || ',' || " columns'
        <> " || '])' FROM "
        <> table
        <> " ORDER BY id"
  maybe
    (throwE (ChangedRow MetadataTable))
    pure
    (traverse (readMaybe . Text.unpack . unSingle) found)

-- | What is hashed of a table: how many rows it has, and each.
counted :: Show row => [row] -> [String]
counted given = show (length given) : map show given
