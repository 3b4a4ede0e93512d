{-# LANGUAGE OverloadedStrings #-}

-- | The stitching of frames as a picture: the composite, where each frame should have been and
-- where it was found, the groups of overlapping frames, and remarks.
module Picture.Assembly
  ( assemblyDrawing,
    assemblySvg,
  )
where

import Counted
import qualified Data.ByteString.Lazy as Lazy
import Data.List (nub, sort)
import Data.Text (Text)
import Drawing
import Drawing.Svg
import Picture.Style
import PraTactile.Format.Registration (groupsOf, reasonsOf, stitchMethodName)
import PraTactile.Geometry (taxelPitch)
import PraTactile.Image (rasterHeight, rasterSize, rasterWidth)
import PraTactile.Registration
import PraTactile.Sensor.Frame (Frame (..), SensorPose (..))
import Text.Printf (printf)
import Visible (visibleName)

-- | A frame on the page.
data Shown = Shown
  { shownFile :: FilePath,
    shownFrame :: Registered,
    -- | its name among the reasons, if there is one to doubt it
    shownReason :: Maybe String,
    -- | the index of its group
    shownGroup :: Int,
    -- | its centre as the robot had it, pixels of the composite
    shownCentre :: (Double, Double),
    -- | its width and height, taxels
    shownSize :: (Double, Double),
    -- | degrees clockwise
    shownRotation :: Double
  }

-- | The frames, each with its file's name, and what was made of them.
shownFrames :: [(FilePath, Frame)] -> Assembly -> [Shown]
shownFrames files made = zipWith3 shown files (assemblyFrames made) (reasonsOf made)
  where
    (originX, originY) = compositeOrigin (assemblyComposite made)
    numbers = nub (sort (map registeredGroup (assemblyFrames made)))
    shown (file, frame) arranged reason =
      Shown
        { shownFile = visibleName file,
          shownFrame = arranged,
          shownReason = reason,
          shownGroup = length (takeWhile (< registeredGroup arranged) numbers),
          shownCentre =
            ( (poseX (framePose frame) - originX) / taxelPitch,
              (poseY (framePose frame) - originY) / taxelPitch
            ),
          shownSize = (side rasterWidth frame, side rasterHeight frame),
          shownRotation = poseRotation (framePose frame)
        }
    side of' frame = fromIntegral (of' (frameImage frame)) * frameTaxel frame / taxelPitch

-- | The picture as an SVG file, given the name of what was put together.
assemblySvg :: String -> [(FilePath, Frame)] -> Assembly -> Lazy.ByteString
assemblySvg name files made =
  svgFile 16 (name ++ ": " ++ titleOf made) (assemblyDrawing name files made)

titleOf :: Assembly -> String
titleOf made = counted (length (assemblyFrames made)) "frame" "frames" ++ " put together " ++ how
  where
    how = case assemblyMethod made of
      Nominal -> "as the robot had them"
      ByLattice -> "by the lattice of symbols"
      ByPairs -> "by all pairs that overlap, together"
      Incremental -> "by correlation, one after the other"
      other -> stitchMethodName other

-- | The composite with the frames over it; below it, what is to be said of them.
assemblyDrawing :: String -> [(FilePath, Frame)] -> Assembly -> Drawing
assemblyDrawing name files made = above 16 [picture, legend room frames enlarged unit, words']
  where
    frames = shownFrames files made
    image = compositeImage (assemblyComposite made)
    (wide, high) = rasterSize image
    -- Picture units a taxel.
    unit = max 1 (min 12 (1000 / fromIntegral (maximum [wide, high, 1])))
    edge = Extent 0 0 (unit * fromIntegral wide) (unit * fromIntegral high)
    enlarged = enlargement frames
    picture =
      panel (titleOf made) note body (unit / taxelPitch)
    note = name ++ ": " ++ show wide ++ " x " ++ show high ++ " taxels"
    body =
      [ Mark "composite" (Grey image edge),
        Mark "composite-edge" (Rectangle (outlined pale 1) edge)
      ]
        ++ concatMap (nominalMark unit) frames
        ++ concatMap (foundMark unit) frames
        ++ concatMap (arrowMark unit enlarged) frames
        ++ concat [numberMark unit i f | length frames <= mostNumbered, (i, f) <- zip [0 ..] frames]
    room = max 640 (width (extentOf picture))
    words' = above 6 (map (paragraph room) (remarks made frames))

-- | The most frames that are numbered.
mostNumbered :: Int
mostNumbered = 100

paragraph :: Double -> String -> Drawing
paragraph room content =
  above 4 [[Mark "note" (Words FromLeft plain (0, 0) line)] | line <- wrapped room plain content]

-- | A pixel as picture units.
onPage :: Double -> (Double, Double) -> (Double, Double)
onPage unit (x, y) = (unit * (x + 0.5), unit * (y + 0.5))

-- | A frame's outline round a centre.
outline :: Text -> Paint -> Double -> Shown -> (Double, Double) -> Drawing
outline name paint unit frame centre =
  turnedAbout
    at
    (shownRotation frame)
    [Mark name (Rectangle paint (around (unit * w, unit * h) at))]
  where
    at = onPage unit centre
    (w, h) = shownSize frame

nominalMark, foundMark :: Double -> Shown -> Drawing
nominalMark unit frame = outline "nominal" (outlined robots 1) unit frame (shownCentre frame)
foundMark unit frame =
  outline "found" (paintOf frame) unit frame (moved 1 frame)

-- | The grey of nominal places.
robots :: Text
robots = "#8a9099"

-- | Where a frame's centre is if its correction is enlarged by this factor.
moved :: Double -> Shown -> (Double, Double)
moved times frame = (x + times * dx, y + times * dy)
  where
    (x, y) = shownCentre frame
    (dx, dy) = registeredShift (shownFrame frame)

-- | Frames to doubt are dashed.
paintOf :: Shown -> Paint
paintOf frame = case shownReason frame of
  Nothing -> (outlined (groupColour (shownGroup frame)) 1.5) {opacity = 0.7}
  Just _ -> (outlined contradicting 2.5) {dashed = True}

-- | The colours of groups; after the last the first again.
groupColour :: Int -> Text
groupColour group = case drop (group `mod` length colours) colours of
  colour : _ -> colour
  [] -> ink
  where
    colours = [recognised, answering, unrecognised, "#8a6d00", "#3b8fc2", "#5b5b5b"]

-- | An arrow from a frame's nominal centre in the direction of its correction.
arrowMark :: Double -> Double -> Shown -> Drawing
arrowMark unit times frame =
  arrow (maybe (groupColour (shownGroup frame)) (const contradicting) (shownReason frame)) from to
  where
    from = onPage unit (shownCentre frame)
    to = onPage unit (moved times frame)

-- | An arrow; a dot where it has no length.
arrow :: Text -> (Double, Double) -> (Double, Double) -> Drawing
arrow colour (x, y) (u, v)
  | long < 2 = [Mark "correction" (Rectangle (filled colour 1) (around (4, 4) (x, y)))]
  | otherwise =
    [ Mark "correction" (Line (outlined colour 2.5) [(x, y), along (long - tip)]),
      Mark
        "correction"
        ( Outline
            (filled colour 1)
            [(u, v), aside (long - tip) (0.45 * tip), aside (long - tip) (-0.45 * tip)]
        )
    ]
  where
    long = sqrt ((u - x) ^ (2 :: Int) + (v - y) ^ (2 :: Int))
    tip = min 9 long
    (dx, dy) = ((u - x) / long, (v - y) / long)
    along s = (x + s * dx, y + s * dy)
    aside s t = (x + s * dx - t * dy, y + s * dy + t * dx)

-- | A frame's number, at its centre as the robot had it.
numberMark :: Double -> Int -> Shown -> Drawing
numberMark unit i frame =
  [ Mark "number-ground" (Rectangle (filled "#ffffff" 0.75) ground),
    Mark "number" (Words FromMiddle (Font size Regular ink) (x, y - 0.35 * size) (show i))
  ]
  where
    (x, y) = onPage unit (shownCentre frame)
    size = max 7 (min 13 (1.4 * unit))
    ground =
      around (textWidth plain {fontSize = size} (show i), 0.95 * size) (x, y - 0.7 * size)

-- | How many times corrections are enlarged, so that the longest is some ten taxels on the page.
enlargement :: [Shown] -> Double
enlargement frames = maximum (1 : [times | times <- [2, 5, 10, 20, 50, 100], times * longest <= 10])
  where
    longest = maximum (1e-6 : map (size . registeredShift . shownFrame) frames)
    size (dx, dy) = sqrt (dx * dx + dy * dy)

-- | The legend of the marks, and of the corrections with their scale.
legend :: Double -> [Shown] -> Double -> Double -> Drawing
legend room frames times unit = flowing 10 room (map entry entries)
  where
    entry (swatch, content) =
      swatch ++ beside 8 swatch [Mark "legend" (Words FromLeft plain (0, 0) content)]
    box paint = [Mark "legend" (Rectangle paint (Extent 0 0 24 13))]
    groups = nub (sort [shownGroup f | f <- frames, shownReason f == Nothing])
    fewGroups = take 6 groups
    entries =
      (box (outlined robots 1), "where the robot had a frame") :
      [ ( box ((outlined (groupColour g) 1.5) {opacity = 0.7}),
          "where it was found" ++ (if length groups == 1 then "" else ": group " ++ show g)
        )
        | g <- fewGroups
      ]
        ++ [ (box ((outlined contradicting 2.5) {dashed = True}), "a frame to doubt")
             | any ((/= Nothing) . shownReason) frames
           ]
        ++ [ ( arrow ink (0, 0) (unit * times, 0),
               "a correction of one taxel"
                 ++ (if times > 1 then printf " (enlarged %.0f times)" times else "")
             )
           ]

-- | Remarks on the assembly, in words.
remarks :: Assembly -> [Shown] -> [String]
remarks made frames = residual : correction : groups ++ doubtful
  where
    residual = case assemblyResidual made of
      Just sd ->
        printf
          "Residual %.3f of full scale: by so much a frame differs from what the others felt there."
          sd
      Nothing -> "No two frames overlap, so that nothing tells how well they agree."
    shifts = map (registeredShift . shownFrame) frames
    n = fromIntegral (max 1 (length shifts)) :: Double
    rms side = sqrt (sum [side s * side s | s <- shifts] / n)
    correction =
      printf
        "Corrections: %.2f taxel across and %.2f taxel down (root of the mean square)."
        (rms fst)
        (rms snd)
    parted = groupsOf (map registeredGroup (assemblyFrames made))
    groups =
      [ show (length parted) ++ " groups of frames that overlap among themselves alone."
        | length parted > 1
      ]
    doubtful =
      map reasonText (take mostTold strays)
        ++ [ "And " ++ show (length strays - mostTold) ++ " others."
             | length strays > mostTold
           ]
    strays = [(i, f) | (i, f) <- zip [0 :: Int ..] frames, shownReason f /= Nothing]
    mostTold = 12
    reasonText (i, f) =
      concat ["Frame ", show i, " (", shownFile f, ") ", maybe "" (inWords f) (shownReason f), "."]
    inWords f reason = case reason of
      "no-overlap" -> "overlaps no other frame"
      "ambiguous" ->
        "fits several places nearly alike"
          ++ maybe "" (printf " (probability %.2f)") (registeredProbability (shownFrame f))
      other -> "is to be doubted: " ++ other
