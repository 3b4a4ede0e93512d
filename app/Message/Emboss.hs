-- | Messages about embossing.
module Message.Emboss
  ( embossMessage,
    misshapenMessage,
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
    show count ++ " symbols are too many to raise at once; lay at most " ++ show mostSymbols
      ++ ", or name one --face"
  TooThin height thickness ->
    "the symbols are " ++ exactText height ++ " mm high; a plate of " ++ exactText thickness
      ++ " mm is not thicker than that: choose another --thickness"

-- | Why an object cannot be written with coordinates of this precision.
misshapenMessage :: ObjectName -> Precision -> Misshapen -> String
misshapenMessage object precision e = case e of
  Melted points cut ->
    held ++ counted points "point" "points" ++ " would become others, and "
      ++ counted cut "triangle" "triangles"
      ++ " lose their area or turn: "
      ++ instead
  Shifted most height ->
    held ++ "a point would move by " ++ show most ++ " mm, of a relief of " ++ exactText height
      ++ " mm, and no more than a hundredth is accepted: "
      ++ instead
  Deflated found true ->
    held ++ "the " ++ visible (objectText object) ++ " would have a volume of "
      ++ show (fromRational found :: Double)
      ++ " mm^3 in place of "
      ++ show (nearestVolume true)
      ++ ": "
      ++ instead
  Cut -> held ++ "triangles would cut each other: " ++ instead
  Collided ->
    "symbols raised on the " ++ visible (objectText object)
      ++ " would run into another of its faces, or into the symbols there; lay other faces, or \
         \smaller symbols"
  Irrational points ->
    "coordinates of " ++ counted points "point" "points"
      ++ " are no fractions, but the format json holds only fractions; choose another --format, or \
         \another ending of the file's name"
  where
    (held, instead) = case precision of
      Binary32 ->
        ( "with coordinates of 32 bits ",
          "lay larger symbols, move the object nearer to the origin, or choose --format ascii-stl"
        )
      _ ->
        ( "with coordinates of 64 bits ",
          "lay larger symbols, or move the object nearer to the origin"
        )

-- | Why an object is not drawn unfolded.
noNetMessage :: ObjectName -> NoNet -> String
noNetMessage object why =
  "the " ++ visible (objectText object) ++ " is not drawn as a net: " ++ case why of
    EveryOneOverlaps -> "every unfolding overlaps"
    NoneFound -> "no net was found, and there may be one"
    SeveralPieces -> "it is of several pieces, which cannot be unfolded together"

-- | The message that a face has no room on a page of this size.
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
