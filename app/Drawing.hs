{-# LANGUAGE OverloadedStrings #-}

-- | Drawings as data: marks with their bounding boxes, so that drawings are put side by side
-- without overlap. Units are those of the picture, x to the right and y down.
module Drawing
  ( -- * Extents
    Extent (..),
    around,
    width,
    height,

    -- * Marks
    Mark (..),
    Form (..),
    Paint (..),
    outlined,
    filled,
    Font (..),
    Weight (..),
    Anchor (..),
    markExtent,

    -- * Drawings
    Drawing,
    extentOf,
    shifted,
    turnedAbout,
    beside,
    above,
    flowing,

    -- * Words
    textWidth,
    wrapped,
    hundredths,
  )
where

import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.List.NonEmpty as NonEmpty
import Data.Maybe (fromMaybe, mapMaybe)
import Data.Semigroup (sconcat)
import Data.Text (Text)
import Numeric (showFFloat)
import PraTactile.Geometry (cosineSine)
import PraTactile.Image (Raster)

-- | A rectangle, by its sides.
data Extent = Extent
  { leftEdge :: !Double,
    topEdge :: !Double,
    rightEdge :: !Double,
    bottomEdge :: !Double
  }
  deriving stock (Eq, Show)

-- | The smallest rectangle that contains both.
instance Semigroup Extent where
  Extent l t r b <> Extent l' t' r' b' = Extent (min l l') (min t t') (max r r') (max b b')

-- | The rectangle of this width and height round a centre.
around :: (Double, Double) -> (Double, Double) -> Extent
around (w, h) (x, y) = Extent (x - w / 2) (y - h / 2) (x + w / 2) (y + h / 2)

width, height :: Extent -> Double
width e = rightEdge e - leftEdge e
height e = bottomEdge e - topEdge e

-- | A mark with its class in the SVG, a word that says what it is.
data Mark = Mark
  { markClass :: !Text,
    markForm :: !Form
  }
  deriving stock (Eq, Show)

-- | A shape or a text to draw.
data Form
  = Rectangle !Paint !Extent
  | -- | rectangles as one path
    Patches !Paint [Extent]
  | -- | a closed polygon
    Outline !Paint [(Double, Double)]
  | -- | closed polygons as one path
    Region !Paint [[(Double, Double)]]
  | -- | an open one
    Line !Paint [(Double, Double)]
  | -- | an image: white for 0, dark for 1; each pixel a sharp square
    Grey !Raster !Extent
  | -- | one line of text, from a point of its baseline
    Words !Anchor !Font !(Double, Double) String
  deriving stock (Eq, Show)

-- | Colours as CSS has them, and how thick and opaque.
data Paint = Paint
  { fillColour :: !Text,
    strokeColour :: !Text,
    strokeWidth :: !Double,
    dashed :: !Bool,
    opacity :: !Double
  }
  deriving stock (Eq, Show)

-- | A line of a colour and a width, nothing within.
outlined :: Text -> Double -> Paint
outlined colour thickness = (filled "none" 1) {strokeColour = colour, strokeWidth = thickness}

-- | A surface of a colour, and how opaque it is.
filled :: Text -> Double -> Paint
filled colour opaque =
  Paint
    { fillColour = colour,
      strokeColour = "none",
      strokeWidth = 0,
      dashed = False,
      opacity = opaque
    }

data Font = Font
  { fontSize :: !Double,
    fontWeight :: !Weight,
    fontColour :: !Text
  }
  deriving stock (Eq, Show)

data Weight = Regular | Bold
  deriving stock (Eq, Show)

-- | Which end of a line of text lies at its point.
data Anchor = FromLeft | FromMiddle | FromRight
  deriving stock (Eq, Show)

-- | The bounding box of a mark, with half its stroke. Text has the width that it has in the widest
-- of the usual sans-serif fonts. 'Nothing' for a mark without patches or points.
markExtent :: Mark -> Maybe Extent
markExtent (Mark _ form) = case form of
  Rectangle paint e -> Just (stroked paint e)
  Patches paint es -> stroked paint <$> hull es
  Outline paint points -> stroked paint <$> hull (map point points)
  Region paint polygons -> stroked paint <$> hull (map point (concat polygons))
  Line paint points -> stroked paint <$> hull (map point points)
  Grey _ e -> Just e
  Words anchor font (x, y) words' ->
    let w = textWidth font words'
        left = case anchor of FromLeft -> x; FromMiddle -> x - w / 2; FromRight -> x - w
     in Just (Extent left (y - 0.8 * fontSize font) (left + w) (y + 0.24 * fontSize font))
  where
    point (x, y) = Extent x y x y
    stroked paint (Extent l t r b) =
      let s = strokeWidth paint / 2 in Extent (l - s) (t - s) (r + s) (b + s)

hull :: [Extent] -> Maybe Extent
hull = fmap sconcat . NonEmpty.nonEmpty

-- | Marks, the later ones over the earlier ones.
type Drawing = [Mark]

-- | The bounding box of a drawing; a point for an empty one.
extentOf :: Drawing -> Extent
extentOf drawing = fromMaybe (Extent 0 0 0 0) (hull (mapMaybe markExtent drawing))

-- | A drawing moved to the right and down.
shifted :: (Double, Double) -> Drawing -> Drawing
shifted (dx, dy) = map move
  where
    move (Mark name form) = Mark name $ case form of
      Rectangle paint e -> Rectangle paint (rectangle e)
      Patches paint es -> Patches paint (map rectangle es)
      Outline paint points -> Outline paint (map point points)
      Region paint polygons -> Region paint (map (map point) polygons)
      Line paint points -> Line paint (map point points)
      Grey image e -> Grey image (rectangle e)
      Words anchor font at words' -> Words anchor font (point at) words'
    point (x, y) = (x + dx, y + dy)
    rectangle (Extent l t r b) = Extent (l + dx) (t + dy) (r + dx) (b + dy)

-- | A drawing turned about a point, by degrees clockwise: what is written stays level, and images
-- stay as they are.
turnedAbout :: (Double, Double) -> Double -> Drawing -> Drawing
turnedAbout (x0, y0) degrees drawing
  | degrees == 0 = drawing
  | otherwise = concatMap turn drawing
  where
    (c, s) = cosineSine degrees
    point (x, y) = (x0 + c * (x - x0) - s * (y - y0), y0 + s * (x - x0) + c * (y - y0))
    corners (Extent l t r b) = map point [(l, t), (r, t), (r, b), (l, b)]
    turn (Mark name form) =
      Mark name <$> case form of
        Rectangle paint e -> [Outline paint (corners e)]
        Patches paint es -> [Outline paint (corners e) | e <- es]
        Outline paint points -> [Outline paint (map point points)]
        Region paint polygons -> [Region paint (map (map point) polygons)]
        Line paint points -> [Line paint (map point points)]
        Grey image e -> [Grey image e]
        Words anchor font at words' -> [Words anchor font (point at) words']

-- | The second drawing moved to the right of the first, this far away, their tops level.
beside :: Double -> Drawing -> Drawing -> Drawing
beside gap first second = shifted (rightEdge a + gap - leftEdge b, topEdge a - topEdge b) second
  where
    a = extentOf first
    b = extentOf second

-- | Drawings one below the other, this far apart, their left sides flush with that of the first;
-- none if they are empty.
above :: Double -> [Drawing] -> Drawing
above gap drawings = case NonEmpty.nonEmpty (filter (not . null) drawings) of
  Nothing -> []
  Just (first :| others) -> concat (go first others)
  where
    go first others =
      first : case others of
        [] -> []
        next : rest ->
          let a = extentOf first
              b = extentOf next
           in go (shifted (leftEdge a - leftEdge b, bottomEdge a + gap - topEdge b) next) rest

-- | Drawings one after the other as words are, this far apart, in rows no wider than the width; a
-- drawing that is wider has a row of its own.
flowing :: Double -> Double -> [Drawing] -> Drawing
flowing gap room = above gap . rows []
  where
    rows line drawings = case drawings of
      [] -> [line | not (null line)]
      next : rest
        | null line -> rows next rest
        | width (extentOf (line ++ placed)) > room -> line : rows next rest
        | otherwise -> rows (line ++ placed) rest
        where
          placed = beside (2 * gap) line next

-- | How wide a line of text is at most in the usual sans-serif fonts: letters of DejaVu Sans, which
-- is among the widest, average less.
textWidth :: Font -> String -> Double
textWidth font words' =
  fontSize font * (if fontWeight font == Bold then 0.7 else 0.62) * fromIntegral (length words')

-- | Text in lines that are no wider than the width, where its words allow.
wrapped :: Double -> Font -> String -> [String]
wrapped room font = go . words
  where
    go [] = []
    go (first : rest) = let (line, others) = fill first rest in line : go others
    fill line (next : rest)
      | textWidth font (line ++ " " ++ next) <= room =
        fill (line ++ " " ++ next) rest
    fill line rest = (line, rest)

-- | A number to a hundredth, without trailing zeros.
hundredths :: Double -> String
hundredths v = case (whole, reverse (dropWhile (== '.') (dropWhile (== '0') (reverse fraction)))) of
  ("-0", "") -> "0"
  (kept, rest) -> kept ++ rest
  where
    (whole, fraction) = span (/= '.') (showFFloat (Just 2) v "")
