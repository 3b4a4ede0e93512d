-- | A recognition in a few lines for people. Its 'Show' instance has everything, which is pages.
module PraTactile.Recognise.Summary
  ( summary,

    -- * Its parts
    whereText,
    centreText,
    upperLeftVertex,
    orientationText,
    lieText,
    shownSkew,
    positionsText,
    doubtText,
  )
where

import Data.List (intercalate)
import PraTactile.Array (Position (..))
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge
import PraTactile.Recognise
import PraTactile.Symmetry
import Text.Printf (printf)

-- | The lines of the summary. For an answer: object, face and corner; the place on the face and its
-- angle; the position in the array; the doubt. For a refusal: its name, and the doubt of the
-- likeliest position if there is one. Lines have no line breaks.
summary :: Recognition -> [String]
summary recognition = case recognisedAnswer recognition of
  Left refusal -> ("refused: " ++ refusalName refusal) : doubted
  Right (Several orientation positions) ->
    [ "ambiguous: " ++ show (length positions) ++ " positions fit: " ++ positionsText positions,
      lieText recognition orientation ++ " in the composite"
    ]
      ++ doubted
  Right (Found found) ->
    let window = foundWindow found
        Position r c = windowPosition window
     in whereText (windowWhereabouts window) :
        [centreText place | OnFace place <- [windowWhereabouts window]]
          ++ [ lieText recognition (foundOrientation found) ++ " in the composite",
               "row " ++ show r ++ ", column " ++ show c ++ " of the array"
             ]
          ++ doubted
  where
    doubted =
      [ "doubt " ++ doubtText (supportDoubt support)
        | Just support <- [recognisedSupport recognition]
      ]

-- | The object, the face and the nearest corners at a position, or why there is no object.
whereText :: Whereabouts -> String
whereText place = case place of
  OnFace on -> faceOf (placeFace on) ++ ", " ++ cornerText (placeCorners on)
  Straddles faces -> "on no object: the window straddles " ++ intercalate " and " (map faceOf faces)
  OnNoObject -> "on no object: no face has this window"
  where
    faceOf (Face object named) = objectText object ++ ", face " ++ faceText named
    cornerText nearest = case nearest of
      [only] -> "corner " ++ vertexText only
      _ -> "as near to " ++ intercalate " as to " (map vertexText nearest)

-- | The window's centre on its face, measured from the face's upper left vertex.
centreText :: Place -> String
centreText place = printf "%.2f mm to the right of and %.2f mm below %s" x y upperLeft
  where
    upperLeft = upperLeftVertex (placeFace place)
    (x, y) = spotMillimetres (placeCentre place)

-- | The name of a face's upper left vertex, from which places on it are measured.
upperLeftVertex :: Face -> String
upperLeftVertex = concatMap vertexText . take 1 . faceVertices . faceName

-- | An orientation in words, such as "turned by 90 degrees".
orientationText :: Symmetry -> String
orientationText symmetry = case (mirrored symmetry, degreesClockwise symmetry :: Int) of
  (False, 0) -> "upright"
  (True, 0) -> "mirrored"
  (flipped, degrees) ->
    (if flipped then "mirrored and " else "") ++ "turned by " ++ show degrees ++ " degrees"

-- | How a face lies that was recognised in this orientation, in words. The angle is given unless it
-- is nearly a quarter turn.
lieText :: Recognition -> Symmetry -> String
lieText recognition orientation
  | shownSkew recognition == 0 = orientationText orientation
  | otherwise = printf "turned by %.1f degrees" (recognisedAngle recognition orientation)

-- | The angle of the recognised symbols if it is more than 'leastSkew', else 0.
shownSkew :: Recognition -> Double
shownSkew recognition
  | abs (recognisedSkew recognition) > leastSkew = recognisedSkew recognition
  | otherwise = 0

-- | Positions in the command line's form: @6,5 7,0@.
positionsText :: [Position] -> String
positionsText positions = unwords [show r ++ "," ++ show c | Position r c <- positions]

-- | A probability as text. It may be too small for a 'Double'.
doubtText :: Double -> String
doubtText doubt
  | doubt > 0 = printf "%.1e" doubt
  | otherwise = "below 1e-300"
