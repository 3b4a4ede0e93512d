{-# LANGUAGE OverloadedStrings #-}

-- | An unfolded solid as a picture at true scale: what is cut, what is folded and to which side,
-- what is glued to what, and which face is which.
module Picture.Net
  ( netSvg,
    cutOutSvg,
    pagesSvg,
    netRounding,
  )
where

import qualified Data.ByteString.Lazy as Lazy
import Data.List (find, sortOn)
import Data.Maybe (fromMaybe, isJust, isNothing)
import Data.Text (Text)
import Drawing
import Drawing.Svg
import Picture.Polygon
import Picture.Room
import Picture.Style
import PraTactile.Object.Description
import PraTactile.Object.Net
import Visible (visible)

-- | The raised parts of a face: counter-clockwise polygons in millimetres of the page, with their
-- holes clockwise.
type Raised = NetFace -> [[(Double, Double)]]

-- | The picture of a net as an SVG file that is as large as the net, given its title.
netSvg :: String -> Net -> Lazy.ByteString
netSvg title net = asLarge title (outline ++ concatMap (faceMarks []) (netFaces net)) meanings
  where
    outline =
      Mark "net" (Outline (filled paper 1) (map units (netOutline net))) :
      concatMap foldMark (netFolds net)
        ++ [Mark "cut" (Outline (outlined ink 2) (map units (netOutline net)))]
    meanings = cutMeaning : bendMeanings (netFolds net)

-- | A net with what is raised on it, and with tabs, to be cut out in one piece.
cutOutSvg :: String -> Raised -> Net -> Lazy.ByteString
cutOutSvg title raised net = asLarge title (partMarks raised 1 part) (partMeanings [part])
  where
    part = wholePart 8 net

-- | A net cut into pages of this width and height, in millimetres: the faces on each page, and the
-- file. Refuses a face that has no room on a page.
pagesSvg ::
  (Double, Double) -> String -> Raised -> Net -> Either FaceName [([NetFace], Lazy.ByteString)]
pagesSvg (wide, high) title raised net = map page . numbered <$> partsFor room net
  where
    numbered parts = [(k, length parts, parts, part) | (k, part) <- zip [1 ..] parts]
    -- What stands at the foot depends on the parts; there is room for all that may stand there.
    room = (across, (bottom - top - height (extentOf fullest)) / perMillimetre)
    across = (right - left) / perMillimetre
    (left, right) = (margin, perMillimetre * wide - margin)
    (top, bottom) = (margin + 24, perMillimetre * high - margin - 8)
    margin = 8 * perMillimetre
    fullest = foot (cutMeaning : bendMeanings (netFolds net) ++ [tabMeaning, awayMeaning])
    foot meanings =
      above 10 [flowing 8 (right - left) (map meaningMark meanings), ruler across]
    page (k, count, parts, part) =
      ( partFaces part,
        svgPage perMillimetre (wide, high) titled $
          concat
            [ [Mark "heading" (Words FromLeft heading (left, margin + 12) titled)],
              shifted (left, top) (partMarks raised k part),
              shifted (left - leftEdge below, bottom + 8 - bottomEdge below) feet
            ]
      )
      where
        titled = title ++ ": page " ++ show (k :: Int) ++ " of " ++ show (count :: Int)
        feet = foot (partMeanings parts)
        below = extentOf feet

-- | Units for a millimetre; words are as large on paper as in the other pictures.
perMillimetre :: Double
perMillimetre = 4

-- | By how many millimetres a number of such a file is off at most: half a hundredth of a unit.
netRounding :: Double
netRounding = 0.005 / perMillimetre

-- | A drawing on paper as large as it is, with a title, a ruler, and what its lines mean below.
asLarge :: String -> Drawing -> [Meaning] -> Lazy.ByteString
asLarge title body meanings =
  svgToScale perMillimetre 16 title $
    above
      20
      [ [Mark "heading" (Words FromLeft heading (0, 0) title)],
        body,
        ruler 200,
        flowing 10 (max 400 (width (extentOf body))) (map meaningMark meanings)
      ]

-- | A part on its page, which has this number.
partMarks :: Raised -> Int -> NetPart -> Drawing
partMarks raised page part =
  [Mark "net" (Outline (filled paper 1) (map units (netCorners face))) | face <- partFaces part]
    ++ concatMap symbolMarks (partFaces part)
    ++ concatMap foldMark (partFolds part)
    ++ concatMap rimMarks (partRims part)
    ++ concatMap (\face -> faceMarks (taken face) face) (partFaces part)
    ++ concatMap numberMark (partRims part)
  where
    symbolMarks face =
      [ Mark "symbol" (Outline (filled (if hollow loop then paper else ink) 1) (map units loop))
        | loop <- sortOn hollow (raised face)
      ]
    hollow loop = signedArea loop > 0
    symbolsOf face =
      [extentOf [Mark "" (Outline (filled ink 1) (map units loop))] | loop <- raised face]
    -- The name leaves room for symbols and numbers.
    taken face =
      symbolsOf face
        ++ [boxOf (numberText rim) (placeOf rim) | rim <- rimsOf face, isNothing (rimTab rim)]
    rimsOf face = [rim | rim <- partRims part, rimEnds rim `elem` cyclicPairs (netCorners face)]
    rimMarks rim = case rimTab rim of
      Nothing -> [Mark "cut" (Line (outlined ink 2) (sideOf rim))]
      Just tab ->
        [ Mark "tab" (Outline (filled "#ffffff" 1) (map units tab)),
          Mark "tab" (Line tabPaint (sideOf rim)),
          Mark "cut" (Line (outlined ink 2) (map units tab))
        ]
    sideOf rim = let (p, q) = rimEnds rim in [units p, units q]
    numberText rim =
      show (rimNumber rim) ++ (if rimPart rim == page then "" else " p." ++ show (rimPart rim))
    numberMark rim =
      [Mark "number" (Words FromMiddle font {fontSize = size} (x, y + 0.35 * size) words')]
      where
        words' = numberText rim
        Place size (x, y) = placeOf rim
    font = plain {fontColour = recognised}
    placeOf rim = case rimTab rim of
      Just tab ->
        let corners = map units tab
         in fromMaybe (Place 2 (middle corners)) (roomOn 9 [] corners (numberText rim))
      Nothing ->
        let face = find (elem (rimEnds rim) . cyclicPairs . netCorners) (partFaces part)
            (p, q) = rimEnds rim
         in besideSide
              8
              (maybe [] symbolsOf face)
              (maybe [] (map units . netCorners) face)
              (units p, units q)
              (numberText rim)
    middle corners =
      let n = fromIntegral (length corners)
       in (sum (map fst corners) / n, sum (map snd corners) / n)

-- | The kind of a line: its class, its paint and its meaning.
data Meaning = Meaning Text Paint String

meaningMark :: Meaning -> Drawing
meaningMark (Meaning name paint words') =
  swatch ++ beside 8 swatch [Mark "legend" (Words FromLeft plain (0, 0) words')]
  where
    swatch = [Mark name (Line paint [(0, 6), (36, 6)])]

cutMeaning, tabMeaning, awayMeaning :: Meaning
cutMeaning = Meaning "cut" (outlined ink 2) "cut"
tabMeaning = Meaning "tab" tabPaint "fold, and glue under the edge of the same number"
awayMeaning = Meaning "number" (outlined recognised 1) "p.2: that edge is on page 2"

partMeanings :: [NetPart] -> [Meaning]
partMeanings parts =
  cutMeaning :
  bendMeanings (concatMap partFolds parts)
    ++ [tabMeaning | any (isJust . rimTab) (concatMap partRims parts)]
    ++ [awayMeaning | length parts > 1]

bendMeanings :: [Fold] -> [Meaning]
bendMeanings folds =
  [ Meaning (bendClass bend) (bendPaint bend) (bendWords bend)
    | bend <- [Ridge, Valley, Flat],
      bend `elem` map foldBend folds
  ]

foldMark :: Fold -> Drawing
foldMark it = [Mark (bendClass bend) (Line (bendPaint bend) [units from, units to])]
  where
    (from, to) = foldEnds it
    bend = foldBend it

bendClass :: Bend -> Text
bendClass bend = case bend of
  Ridge -> "ridge"
  Valley -> "valley"
  Flat -> "flat"

bendPaint :: Bend -> Paint
bendPaint bend = case bend of
  Ridge -> outlined recognised 1.5
  Valley -> (outlined contradicting 1.5) {dashed = True}
  Flat -> outlined pale 1.5

bendWords :: Bend -> String
bendWords bend = case bend of
  Ridge -> "fold away from you"
  Valley -> "fold towards you"
  Flat -> "do not fold"

tabPaint :: Paint
tabPaint = (outlined answering 1) {dashed = True}

paper :: Text
paper = "#f6f7f9"

units :: (Double, Double) -> (Double, Double)
units (x, y) = (perMillimetre * x, perMillimetre * y)

-- | A face's name, where it has room beside these, and a mark in its upper left corner, the first
-- of its name.
faceMarks :: [Extent] -> NetFace -> Drawing
faceMarks taken face =
  corner
    ++ [ Mark "face" (Words FromMiddle plain {fontSize = size} (x, y + 0.35 * size) name)
         | Just (Place size (x, y)) <- [roomOn 13 (extentOf corner : taken) corners name]
       ]
  where
    corners = map units (netCorners face)
    name = visible (faceText (netFaceName face))
    corner = case (corners, reverse corners) of
      (a : b : _, c : _) ->
        [Mark "upper-left" (Outline (filled ink 1) [a, towards a b, towards a c])]
      _ -> []
    towards (u, v) (u', v') =
      let k = min 0.25 (10 / max 1e-9 (sqrt ((u' - u) ^ (2 :: Int) + (v' - v) ^ (2 :: Int))))
       in (u + k * (u' - u), v + k * (v' - v))

-- | A line of 100 mm, to see whether it was printed at its scale; a shorter one where there is not
-- so much room.
ruler :: Double -> Drawing
ruler room =
  Mark "ruler" (Line line [(0, 0), (end, 0)]) :
  [ Mark "ruler" (Line line [(u, 0), (u, if mm `mod` 50 == 0 then -10 else -6)])
    | mm <- [0, 10 .. long],
      let u = perMillimetre * fromIntegral mm
  ]
    ++ [Mark "ruler" (Words FromLeft plain (end + 8, 3) (show long ++ " mm"))]
  where
    end = perMillimetre * fromIntegral long
    line = outlined ink 1
    long = fromMaybe 10 (find (\mm -> fromIntegral mm + 20 <= room) [100, 50, 20]) :: Int
