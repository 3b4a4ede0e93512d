-- | Objects to be laid, as the command line names them, and messages about faces that are not laid.
module NamedSolid
  ( namedSolid,
    sourceOf,
    symbolsText,
    nothingCarries,
    noRoomOn,
    whyNot,
    noneFound,
  )
where

import Control.Monad (guard, when)
import Counted
import Data.Foldable (for_)
import Data.Maybe (fromMaybe, isNothing)
import qualified Data.Vector as V
import ExitStatus
import Json (shapeText)
import Message
import Polyhedra
import PraTactile.Array (Shape (..))
import PraTactile.Format.Solid (exactText)
import PraTactile.Object.Mend
import PraTactile.Object.Mesh
import PraTactile.Object.Packing (Reason (..))
import PraTactile.Object.Placement
import PraTactile.Object.Placement.Search
import PraTactile.Object.Vector (V3 (..))
import PraTactile.Object.WingedEdge
import Visible

-- | The solid that @[NAME=]SOLID|FILE@ names. The sheet has room for an array of this shape with
-- this pitch; without a shape, the sheet is refused. Warns of triangles that are nearly one face.
-- Leaves with status 2 if there is no such solid.
namedSolid :: Maybe Shape -> Pitch -> SolidReading -> String -> IO Solid
namedSolid known between reading subject = do
  when (isNothing known && from == "sheet") . misused $
    "the sheet is as large as its array, so --smallest cannot choose the array; name another solid"
  it <- polyhedronMesh <$> polyhedron (fromMaybe (Shape 1 1) known) between reading from
  when (mendMerging mending == TrianglesMerged && isNothing (mendTolerance mending)) $
    for_ (nearlyMerged it) $ \(mm, faces) ->
      warn
        ( "warning: " ++ visibleName subject
            ++ ": triangles that are nearly in one plane stay apart; --tolerance "
            ++ exactText mm
            ++ " makes "
            ++ show faces
            ++ " faces of "
            ++ show (V.length (meshWalks it))
        )
  orUnusable
    (\why -> visibleName subject ++ ": " ++ objectMessage why)
    (solidOf (maybe id (named . objectCalled) name it))
  where
    (name, from) = nameAndSource subject
    mending = readingMending reading

-- | The name or the file of a polyhedron, without the name that its object is given.
sourceOf :: String -> String
sourceOf = snd . nameAndSource

-- | The name that @NAME=@ gives an object, and what follows.
nameAndSource :: String -> (Maybe String, String)
nameAndSource subject = case break (== '=') subject of
  (given@(_ : _), '=' : rest) | '/' `notElem` given -> (Just given, rest)
  _ -> (Nothing, subject)

-- | A tolerance that merges more triangles than lie exactly in one plane, and the number of faces
-- then. It is a power of ten above the rounding of coordinates in single precision.
nearlyMerged :: Mesh -> Maybe (Rational, Int)
nearlyMerged it = do
  guard (largest > 0)
  flat <- either (const Nothing) Just (mended (Mending (Just mm) False TrianglesMerged) it)
  let faces = V.length (meshWalks (mendedMesh flat))
  guard (faces < V.length (meshWalks it))
  Just (mm, faces)
  where
    largest = V.maximum (V.cons 0 (V.map (\(V3 x y z) -> maximum (map abs [x, y, z])) points))
    points = meshPoints it
    -- Rounding to 24 binary digits errs by 2^-25 of the largest coordinate at most.
    rounding = fromInteger largest / (fromInteger (meshDenominator it) * 2 ^ (22 :: Int)) :: Double
    mm = 10 ^^ (ceiling (logBase 10 rounding) :: Int)

-- | The number of symbols of a face, and the rows and columns of their block.
--
-- >>> symbolsText (wholeBlock (Shape 3 4))
-- "12 symbols on 3x4 cells"
symbolsText :: Block -> String
symbolsText block =
  counted (length (blockCells block)) "symbol" "symbols"
    ++ " on "
    ++ shapeText (blockShape block)
    ++ " cells"

-- | The message that no face has room for a symbol, with the unit that the files may have.
nothingCarries :: Pitch -> [Solid] -> String
nothingCarries between objects =
  "no face has room for " ++ symbolText between
    ++ case [unit | unit@(k, _) <- units, carrying k] of
      (k, name) : _ -> "; is the file in " ++ name ++ "? give --scale " ++ exactText k
      [] -> ""
  where
    units = [(127 / 5, "inches"), (10, "centimetres"), (1000, "metres")]
    carrying k =
      or
        [ maybe True ((> 0) . fst) (mostSymbols between larger face)
          | larger <- map (scaledSolid k) objects,
            face <- solidFaces larger
        ]

-- | The message that a face has no room for a symbol.
noRoomOn :: Pitch -> Face -> String
noRoomOn between (Face owner walk) =
  "the face " ++ visible (faceText walk) ++ " of the " ++ visible (objectText owner)
    ++ " has no room for "
    ++ symbolText between

symbolText :: Pitch -> String
symbolText (Pitch right down) =
  "a symbol of " ++ exactText right ++ " x " ++ exactText down ++ " mm"

-- | Why there is no placement, in words.
whyNot :: [Wanted] -> Reason -> String
whyNot wishes reason = case reason of
  TakenOutside _ -> "what lies already reaches beyond the array"
  TakenOverlaps _ -> "what lies already overlaps"
  PieceTooLarge i -> faceOf i ++ " is larger than the array"
  TooFewCells needed free ->
    "the faces need " ++ counted needed "cell" "cells" ++ ", and " ++ show free ++ " are free"
  NoRoom i -> faceOf i ++ " fits nowhere beside what lies already"
  Exhausted -> "every way was tried, and none has room for all faces"
  where
    faceOf i =
      concat
        [ "the face " ++ faceText walk ++ " of the " ++ objectText owner
          | Wanted (Face owner walk) _ <- take 1 (drop i wishes)
        ]

-- | The message that a search gave up.
noneFound :: String
noneFound = "no placement was found, and it is not proved that there is none"
