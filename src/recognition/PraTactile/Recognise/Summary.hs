-- | A recognition in a few lines for people. Its 'Show' instance has everything, which is pages.
module PraTactile.Recognise.Summary
  ( summary,

    -- * Its parts
    whereText,
    centreText,
    upperLeftVertex,
    orientationText,
    lieText,
    shownTilt,
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

-- | Object, face and corner; the place on the face and how it lies; the position in the array; the
-- doubt. Or, of a refusal, its name and the doubt of the likeliest position, if there is one. No
-- line ends in a line break.
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

-- | What lies at a position.
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

-- | Where a window's centre is on the face, from its upper left vertex.
centreText :: Place -> String
centreText place = printf "%.2f mm to the right of and %.2f mm below %s" x y upperLeft
  where
    upperLeft = upperLeftVertex (placeFace place)
    (x, y) = spotMillimetres (placeCentre place)

-- | The name of a face's upper left vertex, from which places on it are measured.
upperLeftVertex :: Face -> String
upperLeftVertex = concatMap vertexText . take 1 . faceVertices . faceName

-- | How something is seen.
orientationText :: Symmetry -> String
orientationText symmetry = case (mirrored symmetry, degreesClockwise symmetry :: Int) of
  (False, 0) -> "upright"
  (True, 0) -> "mirrored"
  (flipped, degrees) ->
    (if flipped then "mirrored and " else "") ++ "turned by " ++ show degrees ++ " degrees"

-- | How a face that was recognised in this orientation lies: by its angle, if that is not nearly a
-- quarter turn.
lieText :: Recognition -> Symmetry -> String
lieText recognition orientation
  | shownTilt recognition == 0 = orientationText orientation
  | otherwise = printf "turned by %.1f degrees" (recognisedAngle recognition orientation)

-- | The tilt of what was recognised, where it is more than 'leastTilt'; else 0.
shownTilt :: Recognition -> Double
shownTilt recognition
  | abs (recognisedTilt recognition) > leastTilt = recognisedTilt recognition
  | otherwise = 0

-- | Positions as the command line takes them: @6,5 7,0@.
positionsText :: [Position] -> String
positionsText positions = unwords [show r ++ "," ++ show c | Position r c <- positions]

-- | A probability that may be too small for a 'Double'.
doubtText :: Double -> String
doubtText doubt
  | doubt > 0 = printf "%.1e" doubt
  | otherwise = "below 1e-300"
