-- | Room for words on a polygon.
module Picture.Room
  ( Place (..),
    roomOn,
    besideSide,
    boxOf,
  )
where

import Data.List (find, sortOn)
import Data.Maybe (fromMaybe, listToMaybe)
import Drawing
import Picture.Style
import PraTactile.Object.Description (cyclicPairs)

-- | The size of letters, and the middle of the words.
data Place = Place
  { placeSize :: Double,
    placeMiddle :: (Double, Double)
  }

-- | The rectangle that words take there.
boxOf :: String -> Place -> Extent
boxOf words' (Place size at) = around (textWidth plain {fontSize = size} words', size) at

-- | The largest letters, of these at most, in which the words have room on the polygon beside these
-- rectangles, as near to its middle as may be; none if they have none in any that one can read.
roomOn :: Double -> [Extent] -> [(Double, Double)] -> String -> Maybe Place
roomOn largest taken corners words' =
  listToMaybe
    [ place
      | size <- takeWhile (>= 2) (iterate (* 0.85) largest),
        place <- map (Place size) spots,
        free taken corners (boxOf words' place)
    ]
  where
    Extent l t r b = extentOf [Mark mempty (Outline (filled ink 1) corners)]
    count = fromIntegral (length corners)
    (x, y) = (sum (map fst corners) / count, sum (map snd corners) / count)
    spots =
      (x, y) :
      sortOn
        (\(u, v) -> (u - x) * (u - x) + (v - y) * (v - y))
        [(l + i * (r - l) / 24, t + j * (b - t) / 24) | i <- [1 .. 23], j <- [1 .. 23]]

-- | The largest letters, of these at most, in which words have room inside the polygon near the
-- middle of one of its sides.
besideSide ::
  Double ->
  [Extent] ->
  [(Double, Double)] ->
  ((Double, Double), (Double, Double)) ->
  String ->
  Place
besideSide largest taken corners ((x, y), (x', y')) words' =
  fromMaybe (at 0.4 0) (find (free taken corners . boxOf words') places)
  where
    places =
      [ at part k
        | part <- [1, 0.8, 0.6, 0.4],
          k <- [0, 0.15, -0.15, 0.3, -0.3]
      ]
    at part k = Place (part * largest) (spot (part * largest) k)
    long = max 1e-9 (sqrt ((x' - x) * (x' - x) + (y' - y) * (y' - y)))
    -- Seen from outside the face is on the left of its sides.
    (nx, ny) = ((y' - y) / long, (x - x') / long)
    spot size k =
      let far = 4 + (abs nx * textWidth plain {fontSize = size} words' + abs ny * size) / 2
       in (x + (0.5 + k) * (x' - x) + far * nx, y + (0.5 + k) * (y' - y) + far * ny)

-- | Whether a rectangle lies on a polygon and overlaps none of the taken rectangles.
free :: [Extent] -> [(Double, Double)] -> Extent -> Bool
free taken corners box@(Extent l t r b) =
  not (any (meets box) taken) && not (any within corners)
    && all inside [(u, v) | u <- [l, (l + r) / 2, r], v <- [t, (t + b) / 2, b]]
  where
    within (u, v) = u > l && u < r && v > t && v < b
    inside (u, v) =
      odd . length $
        [ ()
          | ((x1, y1), (x2, y2)) <- cyclicPairs corners,
            (y1 > v) /= (y2 > v),
            u < x1 + (v - y1) * (x2 - x1) / (y2 - y1)
        ]

meets :: Extent -> Extent -> Bool
meets (Extent l t r b) (Extent l' t' r' b') = l < r' && l' < r && t < b' && t' < b
