-- | Why nothing is embossed, in words.
module Message.Emboss
  ( embossMessage,
    misshapenMessage,
    collisionMessage,
    noNetMessage,
    pageMessage,
  )
where

import Counted
import Drawing (hundredths)
import Message.Objects
import PraTactile.Emboss
import PraTactile.Emboss.Rounding
import PraTactile.Format.Solid (exactText)
import PraTactile.Object.Net (NoNet (..))
import PraTactile.Object.WingedEdge
import Visible

-- | Why an object or a face cannot be made.
embossMessage :: EmbossError -> String
embossMessage e = case e of
  NotThere why -> placementMessage why
  NothingRaised object ->
    "no face of the " ++ visible (objectText object)
      ++ " is laid on the array, so that nothing is raised"
  NotEmbossed why -> reliefMessage why
  CornerContact shape (x, y) ->
    "two taxels of the shape " ++ quoted shape ++ " meet at a corner only, "
      ++ show x
      ++ " taxels right of and "
      ++ show y
      ++ " below its upper left corner: no solid is so thin"
  TooManySymbols count ->
    show count ++ " symbols are more than are raised at once, " ++ show mostSymbols
      ++ "; lay fewer, or name one --face"
  TooThin height thickness ->
    "the symbols are " ++ exactText height ++ " mm high; a plate of " ++ exactText thickness
      ++ " mm is not thicker than that: choose another --thickness"

-- | Why it cannot be written with such coordinates.
misshapenMessage :: Misshapen -> String
misshapenMessage e = case e of
  Melted points cut ->
    "with coordinates of 32 bits " ++ counted points "point" "points"
      ++ " would become others, and "
      ++ counted cut "triangle" "triangles"
      ++ " lose their area: lay larger symbols, or choose --format ascii-stl"
  Irrational points ->
    "coordinates of " ++ counted points "point" "points"
      ++ " are no fractions, and the format json has fractions alone; choose --format stl or \
         \ascii-stl"

-- | Why the symbols of an object have no room.
collisionMessage :: ObjectName -> String
collisionMessage object =
  "symbols raised on the " ++ visible (objectText object)
    ++ " would run into another of its faces, or into the symbols there; lay other faces, or \
       \smaller symbols"

-- | Why an object is not drawn unfolded.
noNetMessage :: ObjectName -> NoNet -> String
noNetMessage object why =
  "the " ++ visible (objectText object) ++ " is not drawn as a net: " ++ case why of
    EveryOneOverlaps -> "every unfolding overlaps"
    NoneFound -> "no net was found, and there may be one"
    SeveralPieces -> "it is of several pieces, which cannot be unfolded together"

-- | That a face has no room on a page of this size.
pageMessage :: ObjectName -> (Double, Double) -> FaceName -> String
pageMessage object (wide, high) face =
  "the face " ++ visible (faceText face) ++ " of the " ++ visible (objectText object)
    ++ " has no room on a page of "
    ++ millimetres wide
    ++ " x "
    ++ millimetres high
    ++ " mm, with its margins, heading and ruler: choose a larger --page"
  where
    millimetres = hundredths
