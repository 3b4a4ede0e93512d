{-# LANGUAGE OverloadedStrings #-}

-- | The JSON of @shapes@: the distances of shapes and their faults.
module PraTactile.Format.Shapes
  ( encodeShapes,
    faultName,
    transformationName,
  )
where

import Data.Aeson (Value, object, (.=))
import Data.ByteString (ByteString)
import Data.Foldable (toList)
import Data.Text (Text)
import PraTactile.Format.Json (encodeSchema)
import PraTactile.Shape (Drawings)
import PraTactile.Shape.Check
import PraTactile.Shape.Distance (Nearest (..))
import PraTactile.Symmetry

-- | The distances and faults of drawings, by the shapes' names, as one line without its line end.
-- All keys are always there.
encodeShapes :: Drawings -> ByteString
encodeShapes a =
  encodeSchema "shapes/1" $
    "least_distance" .= leastDistance a
      <> "greatest_possible" .= greatestPossible (length a)
      <> "pairs" .= map pairValue (pairs a)
      <> "faults" .= map faultValue (faults a)
  where
    pairValue :: ClassPair -> Value
    pairValue (ClassPair i j (Nearest d symmetry (x, y))) =
      object
        [ "a" .= mconcat (named i),
          "b" .= mconcat (named j),
          "transformation" .= transformationName symmetry,
          "shift" .= [x, y],
          "distance" .= d
        ]
    named :: Int -> [Text]
    named i = take 1 (drop i (map fst (toList a)))
    faultValue :: Fault -> Value
    faultValue (Fault name kind) = object ["shape" .= name, "kind" .= faultName kind]

-- | The stable name of a kind of fault.
faultName :: ShapeFault -> Text
faultName kind = case kind of
  Side -> "side"
  Stroke -> "stroke"
  Pieces -> "pieces"
  Hole -> "hole"
  Area -> "area"
  OwnImage -> "own-image"
  TooNear -> "too-near"

-- | The stable name of a symmetry. Mirroring (left and right exchanged) comes before the clockwise
-- rotation.
transformationName :: Symmetry -> Text
transformationName symmetry
  | mirrored symmetry = if turns == 0 then "mirror" else "mirror-" <> turn
  | turns == 0 = "identity"
  | otherwise = turn
  where
    turns = degreesClockwise symmetry :: Int
    turn = case turns of
      90 -> "turn-90"
      180 -> "turn-180"
      _ -> "turn-270"
