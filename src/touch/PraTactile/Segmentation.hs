-- | Segmentation (the paper's section IV): a composite tactile image to the 8 wide x 12 tall images
-- of the symbols that lie wholly in it, each with its position and its axes.
module PraTactile.Segmentation
  ( -- * Symbols
    SymbolImage (..),

    -- * Segmentation
    segment,
    Segmentation (..),
    Reject (..),
    Cause (..),

    -- * On the side
    onComposite,
    segmentAlong,

    -- * What is none of the symbols'
    cleaned,
    Cleaned (..),

    -- * Parts of symbols
    Part (..),
    partAt,
    leastSeen,
  )
where

import Control.Applicative ((<|>))
import Data.Either (isRight, partitionEithers)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, isJust, mapMaybe)
import Data.Set (Set)
import qualified Data.Set as Set
import qualified Data.Vector.Storable as V
import PraTactile.Composite (Composite (..), weighted)
import PraTactile.Composite.Level (Levels (..), contrast, levels, noiseFrom, smoothing, threshold)
import PraTactile.Image
  ( Raster,
    generate,
    index,
    onRaster,
    rasterHeight,
    rasterValues,
    rasterWidth,
  )
import PraTactile.Image.Correlate (Reference, referenceAt)
import PraTactile.Segmentation.Box
import PraTactile.Segmentation.Component (Pixel, components)
import PraTactile.Segmentation.Foreign (Cleaned (..), withoutForeign)
import PraTactile.Segmentation.Reject
import PraTactile.Shape (symbolHeight, symbolWidth)
import PraTactile.Symmetry

-- | One symbol found in a composite.
data SymbolImage = SymbolImage
  { -- | The centre of its box, x and y in the composite's pixels.
    symbolCentre :: !(Double, Double),
    -- | 8 x 12 taxels, resampled along the symbol's axis from its box: background 0, embossing
    -- about 1, not clipped.
    symbolPixels :: !Raster,
    -- | The direction of its x axis, degrees clockwise from the composite's, up to a half turn,
    -- which only recognising the symbol decides. Upright boxes: 0; boxes on their side: 90.
    symbolAxis :: !Double,
    -- | The width and height that were measured, in pixels.
    symbolSize :: !(Double, Double)
  }
  deriving stock (Eq, Show)

-- | What a composite holds.
data Segmentation = Segmentation
  { -- | The complete symbols, from left to right.
    segmentedSymbols :: ![SymbolImage],
    segmentedRejects :: ![Reject],
    -- | The background's intensity; 0 when nothing embossed was found.
    segmentedBackground :: !Double,
    -- | The embossing's intensity above the background's; likewise.
    segmentedContrast :: !Double
  }
  deriving stock (Eq, Show)

-- | The symbols of a composite. A blank composite has none. The levels are taken from the whole
-- composite; what rises above their middle is cut into components, and each component whose box
-- fits a symbol's becomes one. A noisy composite is smoothed for that; the symbols' images are not.
segment :: Composite -> Segmentation
segment composite = case levelled noise touched of
  Just found | contrast found >= leastClear * noise -> cut touched found
  unclear
    | noise > 0,
      Just found <- levelled (noise * smoothing) smooth <|> unclear ->
      cut smooth found
  _ -> Segmentation [] [] 0 0
  where
    touched = touchedPixels composite
    noise = noiseIn touched
    smooth = smoothed touched
    levelled noiseThere = levels noiseThere . V.fromList . Map.elems
    cut pixels found =
      let scene = Scene (`Map.lookup` pixels) (threshold found)
          upper = levelBackground found + upperShare * contrast found
          embossed = Map.keysSet (Map.filter (>= threshold found) pixels)
          whole = filter ((>= leastPixels) . Set.size) (components largestGap embossed)
          (rejects, symbols) =
            partitionEithers
              (concatMap (judgedAgain (judged (weighted composite) found) scene upper) whole)
       in Segmentation symbols rejects (levelBackground found) (contrast found)

-- | The composite with what is none of the symbols' making taken for untouched, and what that is:
-- what is longer than any symbol, and what is sunk beside it. Most composites are as they were.
cleaned :: Composite -> Cleaned
cleaned = withoutForeign leastCoverage

-- | The standard deviation of the pixels' noise: the larger of what changes along the rows and
-- along the columns show, for a row may have noise in common, or a column.
noiseIn :: Map Pixel Double -> Double
noiseIn pixels = max (noiseFrom (differences (1, 0))) (noiseFrom (differences (0, 1)))
  where
    differences (i, j) =
      V.fromList
        [ a - 2 * b + c
          | ((x, y), b) <- Map.toList pixels,
            Just a <- [Map.lookup (x - i, y - j) pixels],
            Just c <- [Map.lookup (x + i, y + j) pixels]
        ]

-- | Each pixel as the mean of the touched ones around it, those beside it with half its weight and
-- those across with a quarter.
smoothed :: Map Pixel Double -> Map Pixel Double
smoothed pixels = Map.mapWithKey (\(x, y) _ -> around x y) pixels
  where
    around x y = sum [k * v | (k, v) <- near x y] / sum (map fst (near x y))
    near x y =
      [ (weight i * weight j, v)
        | j <- [-1, 0, 1],
          i <- [-1, 0, 1],
          Just v <- [Map.lookup (x + i, y + j) pixels]
      ]
    weight i = if i == 0 then 2 else 1 :: Double

-- | A contrast of fewer standard deviations of the noise is not clear enough for single pixels.
leastClear :: Double
leastClear = 6

-- | The composite as it is seen turned or mirrored; its origin is left as it was.
onComposite :: Symmetry -> Composite -> Composite
onComposite symmetry composite =
  composite
    { compositeImage = onRaster symmetry (compositeImage composite),
      compositeCoverage = onRaster symmetry (compositeCoverage composite)
    }

-- | The intensities of the pixels that got at least 'leastCoverage' of a sensor's weight.
touchedPixels :: Composite -> Map Pixel Double
touchedPixels Composite {compositeImage = image, compositeCoverage = coverage} =
  Map.fromDistinctAscList
    [ ((x, y), v)
      | x <- [0 .. rasterWidth image - 1],
        y <- [0 .. rasterHeight image - 1],
        Just m <- [index coverage x y],
        m >= leastCoverage,
        Just v <- [index image x y]
    ]

-- | The segmentation of a composite along an axis: of symbols that are turned so, or by 180 degrees
-- more. It is also given for the composite turned upright, in the pixels of that. Centres and boxes
-- are in the composite's pixels; images and sizes are as seen along the axis.
segmentAlong :: Symmetry -> Composite -> (Composite, Segmentation, Segmentation)
segmentAlong axis composite = (upright, found, back)
  where
    upright = onComposite (invert axis) composite
    found = segment upright
    back =
      found
        { segmentedSymbols = map symbolBack (segmentedSymbols found),
          segmentedRejects = map boxBack (segmentedRejects found)
        }
    pixelBack = onPixel axis (size rasterWidth, size rasterHeight)
    size side = fromIntegral (side (compositeImage upright))
    symbolBack s =
      s {symbolCentre = pixelBack (symbolCentre s), symbolAxis = degreesClockwise axis}
    boxBack (Reject (l, t, r, b) why) =
      let (x, y) = pixelBack (l, t)
          (x', y') = pixelBack (r, b)
       in Reject (min x x', min y y', max x x', max y y') why

-- | What was touched of a place where a symbol is expected.
data Part = Part
  { -- | 8 x 12 taxels, background 0 and embossing about 1; 0 where nothing was touched.
    partPixels :: !Raster,
    -- | 1 where it was touched, and 0 elsewhere.
    partSeen :: !Raster
  }
  deriving stock (Eq, Show)

-- | What was touched of the upright box of a symbol with its centre at a place, x and y in pixels,
-- given the composite's segmentation. 'Nothing' where that is less than 'leastSeen' taxels, or
-- nothing embossed was found. What is computed once a composite is computed when it is given.
partAt :: Composite -> Segmentation -> (Double, Double) -> Maybe Part
partAt composite found = look
  where
    image = weighted composite
    look (x, y)
      | segmentedContrast found > 0 && V.sum (rasterValues seen) >= fromIntegral leastSeen =
        Just (Part pixels seen)
      | otherwise = Nothing
      where
        here i j = case referenceAt
          image
          (x + fromIntegral i - (fromIntegral symbolWidth - 1) / 2)
          (y + fromIntegral j - (fromIntegral symbolHeight - 1) / 2) of
          Just (v, m)
            | m >= leastCoverage ->
              Just ((v - segmentedBackground found) / segmentedContrast found)
          _ -> Nothing
        pixels = generate symbolWidth symbolHeight (\i j -> fromMaybe 0 (here i j))
        seen = generate symbolWidth symbolHeight (\i j -> if isJust (here i j) then 1 else 0)

-- | The fewest taxels of a symbol's 96 that are looked at.
leastSeen :: Int
leastSeen = 6

-- | A component as a symbol, or why it is none, given the scene and a higher threshold. If it is
-- too large for one, it may be a symbol with something near it, or a blurred one: then its
-- connected pieces are judged, first all but the smallest of them together, then each by itself;
-- then what of it is above the higher threshold.
judgedAgain ::
  (Scene -> Set Pixel -> Maybe (Either Reject SymbolImage)) ->
  Scene ->
  Double ->
  Set Pixel ->
  [Either Reject SymbolImage]
judgedAgain judge scene upper component = case judge scene component of
  Nothing -> []
  Just (Left (Reject box WrongSize))
    | Set.size component >= leastPixels * leastPixels,
      found : _ <- filter (any isRight) others ->
      found
    | otherwise -> [Left (Reject box WrongSize)]
  Just found -> [found]
  where
    others = [judges scene [Set.unions pieces], judges scene pieces, judges raised [high]]
    judges = mapMaybe . judge
    pieces = filter ((>= leastPixels) . Set.size) (components 0 component)
    raised = scene {sceneThreshold = upper}
    high = Set.filter (any (>= upper) . sceneAt scene) component

-- | Where a blurred symbol is cut off, as a share of the contrast above the background.
upperShare :: Double
upperShare = 0.65

-- | A component as a symbol, or why it is none.
judged :: Reference -> Levels -> Scene -> Set Pixel -> Maybe (Either Reject SymbolImage)
judged image found scene component = do
  across <- horizontalExtent scene component
  down <- verticalExtent scene component
  pure $ case (fitted sizeTolerance width across, fitted sizeTolerance height down) of
    (Just x, Just y) ->
      Right (SymbolImage (x, y) (pixelsAt (x, y) across down) 0 (size across down))
    _ -> Left (Reject (box across down) (cause across down))
  where
    width = fromIntegral symbolWidth
    height = fromIntegral symbolHeight
    size across down = (extentLength across, extentLength down)
    box (Extent l r) (Extent t b) = (sidePlace l, sidePlace t, sidePlace r, sidePlace b)
    cause across down
      | any
          cut
          [ (across, width),
            (down, height)
          ]
          && all notTooLarge [(across, width), (down, height)] =
        CutOff
      | otherwise = WrongSize
    cut (extent@(Extent from to), full) =
      extentLength extent < full && (sideOpen from || sideOpen to)
    notTooLarge (extent, full) = extentLength extent <= full + sizeTolerance
    pixelsAt (x, y) across down =
      generate symbolWidth symbolHeight $ \i j ->
        let px = within across (x + fromIntegral i - (width - 1) / 2)
            py = within down (y + fromIntegral j - (height - 1) / 2)
         in maybe
              0
              (\(v, _) -> (v - levelBackground found) / contrast found)
              (referenceAt image px py)

-- | The place itself, or, where it lies beyond an open side, the last pixel centre before that
-- side: what was not touched is taken to go on as it was seen last.
within :: Extent -> Double -> Double
within (Extent from to) = atMost . atLeast
  where
    atLeast t = if sideOpen from then max (sidePlace from + 0.5) t else t
    atMost t = if sideOpen to then min (sidePlace to - 0.5) t else t

-- | The least weight with which a pixel counts as touched.
leastCoverage :: Double
leastCoverage = 0.4

-- | Fewer pixels than this are noise.
leastPixels :: Int
leastPixels = 4

-- | Embossed pixels this many pixels apart still belong to one symbol; symbols are eight taxels
-- apart.
largestGap :: Int
largestGap = 2

-- | How far a measured width or height may be from a symbol's, in taxels: less than the two taxels
-- that a symbol's strokes are wide.
sizeTolerance :: Double
sizeTolerance = 1.6
