-- | Objects to be laid, as the command line names them, and why they are not laid.
module NamedSolid
  ( namedSolid,
    sourceOf,
    whyNot,
    noneFound,
  )
where

import Control.Monad (when)
import Counted
import Data.Maybe (fromMaybe, isNothing)
import ExitStatus
import Message
import Polyhedra
import PraTactile.Array (Shape (..))
import PraTactile.Format.Solid (Contents (..), SolidFormat)
import PraTactile.Object.Mesh (named)
import PraTactile.Object.Packing (Reason (..))
import PraTactile.Object.Placement
import PraTactile.Object.Placement.Search
import PraTactile.Object.WingedEdge
import Visible

-- | The solid that @[NAME=]SOLID|FILE@ is; the sheet has room for an array of this shape with
-- symbols so far apart, and without one there is none. Leaves with status 2 where there is no such
-- solid.
namedSolid :: Maybe Shape -> Pitch -> Maybe SolidFormat -> String -> IO Solid
namedSolid known between said subject = do
  when (isNothing known && from == "sheet") . misused $
    "the sheet is as large as its array, and has no size of its own for which --smallest could "
      ++ "look; name a box"
  Contents it _ <- polyhedron (fromMaybe (Shape 1 1) known) between said from
  orUnusable
    (\why -> visibleName subject ++ ": " ++ objectMessage why)
    (solidOf (maybe id (named . objectCalled) name it))
  where
    (name, from) = nameAndSource subject

-- | The name or the file of a polyhedron, without the name that its object is given.
sourceOf :: String -> String
sourceOf = snd . nameAndSource

-- | The name that @NAME=@ gives an object, and what follows.
nameAndSource :: String -> (Maybe String, String)
nameAndSource subject = case break (== '=') subject of
  (given@(_ : _), '=' : rest) | '/' `notElem` given -> (Just given, rest)
  _ -> (Nothing, subject)

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

-- | That a search came to no end.
noneFound :: String
noneFound = "no placement was found, and it is not proved that there is none"
