{-# OPTIONS_HADDOCK hide #-}

-- | Segmentation of a composite on which symbols lie upright: Otsu's threshold, connected
-- components, and of these the ones whose box fits a symbol's and was touched.
module PraTactile.Segmentation.Upright
  ( segment,
    leastTouched,
  )
where

import Control.Applicative ((<|>))
import Data.Either (isRight, partitionEithers)
import Data.List (sortOn)
import Data.Maybe (mapMaybe)
import qualified Data.Vector.Storable as V
import PraTactile.Composite (Composite (..), leastCoverage, weighted)
import PraTactile.Composite.Level
import PraTactile.Geometry (symbolHeight, symbolWidth)
import PraTactile.Image (generate, rasterValues)
import PraTactile.Image.Correlate (Reference, referenceAt)
import PraTactile.Segmentation.Box
import PraTactile.Segmentation.Masked
import PraTactile.Segmentation.Region
import PraTactile.Segmentation.Symbol

-- | The symbols of a composite. A blank composite has none. The levels are taken from the whole
-- composite; what rises above their middle is cut into connected components, and each component
-- whose box fits a symbol's becomes one. A noisy composite is smoothed for that; the symbols'
-- images are not.
segment :: Composite -> Segmentation
segment composite = case levelled noise touched of
  Just found | contrast found >= leastClear * noise -> cut touched found
  unclear
    | noise > 0,
      Just found <- levelled (noise * smoothing) smooth <|> unclear ->
      cut smooth found
  _ -> Segmentation [] [] 0 0
  where
    touched = masked composite
    noise = pixelNoise touched
    smooth = smoothed touched
    levelled noiseThere =
      levels (leastContrast (compositeStep composite) noiseThere) . touchedValues
    cut pixels found =
      Segmentation symbols rejects (levelBackground found) (contrast found)
      where
        (rejects, symbols) = partitionEithers (concatMap (inComponent scene) embossed)
        scene =
          Scene
            { sceneImage = weighted composite,
              sceneLevels = found,
              scenePixels = pixels
            }
        embossed = pieces pixels largestGap (touchedWhere (>= threshold found) pixels)

-- | A contrast of fewer standard deviations of the noise is not clear enough for single pixels.
leastClear :: Double
leastClear = 6

-- | What symbols are cut out of.
data Scene = Scene
  { -- | what their images are sampled from
    sceneImage :: !Reference,
    sceneLevels :: !Levels,
    -- | what their boxes are measured in
    scenePixels :: !Masked
  }

-- | The connected components of at least @leastPixels@, from left to right.
pieces :: Masked -> Int -> Region -> [Region]
pieces pixels gap =
  sortOn (minimum . map (placeOf pixels)) . filter (atLeast leastPixels) . components pixels gap

-- | Whether a region has that many pixels or more.
atLeast :: Int -> Region -> Bool
atLeast count = not . null . drop (count - 1)

-- | A component as a symbol, or why it is none. If it is too large for one, it may be a symbol with
-- something near it, or a blurred one: then its connected pieces are judged, first all but the
-- smallest of them together, then each by itself; then what of it is above a higher threshold.
inComponent :: Scene -> Region -> [Either Reject SymbolImage]
inComponent scene component = case judged middle component of
  Nothing -> []
  Just (Left (Reject box WrongSize))
    | atLeast (leastPixels * leastPixels) component,
      better : _ <- filter (any isRight) others ->
      better
    | otherwise -> [Left (Reject box WrongSize)]
  Just answer -> [answer]
  where
    judged = judgedAt scene
    (found, pixels) = (sceneLevels scene, scenePixels scene)
    middle = threshold found
    upper = levelBackground found + upperShare * contrast found
    others =
      [ mapMaybe (judged middle) [concat parts],
        mapMaybe (judged middle) parts,
        mapMaybe (judged upper) [high]
      ]
    parts = pieces pixels 0 component
    high = filter (any (>= upper) . valueAt pixels . placeOf pixels) component

-- | Where a blurred symbol is cut off, as a share of the contrast above the background.
upperShare :: Double
upperShare = 0.65

-- | A region as a symbol, or why it is none, by its box at a threshold. 'Nothing' where it is
-- empty.
judgedAt :: Scene -> Double -> Region -> Maybe (Either Reject SymbolImage)
judgedAt scene level region = do
  across <- horizontalExtent pixels level region
  down <- verticalExtent pixels level region
  pure $ case (fitted sizeTolerance width across, fitted sizeTolerance height down) of
    (Just x, Just y)
      | touchedAt (x, y) >= leastTouched ->
        Right (SymbolImage (x, y) (pixelsAt (x, y) across down) 0 (size across down))
      | otherwise -> Left (Reject (box across down) CutOff)
    _ -> Left (Reject (box across down) (cause across down))
  where
    (found, pixels) = (sceneLevels scene, scenePixels scene)
    width = fromIntegral symbolWidth
    height = fromIntegral symbolHeight
    size across down = (extentLength across, extentLength down)
    box (Extent l r) (Extent t b) = (sidePlace l, sidePlace t, sidePlace r, sidePlace b)
    cause across down
      | any cutOff sides && all notTooLarge sides = CutOff
      | otherwise = WrongSize
      where
        sides = [(across, width), (down, height)]
    cutOff (extent@(Extent from to), full) =
      extentLength extent < full && (sideOpen from || sideOpen to)
    notTooLarge (extent, full) = extentLength extent <= full + sizeTolerance
    pixelsAt place across down =
      taxelsAt place $ \px py ->
        maybe
          0
          (\(v, _) -> (v - levelBackground found) / contrast found)
          (referenceAt (sceneImage scene) (clamped across px) (clamped down py))
    touchedAt place =
      V.sum . rasterValues . taxelsAt place $ \px py ->
        case referenceAt (sceneImage scene) px py of
          Just (_, coverage) | coverage >= leastCoverage -> 1
          _ -> 0
    taxelsAt (x, y) value =
      generate symbolWidth symbolHeight $ \i j ->
        value (x + fromIntegral i - (width - 1) / 2) (y + fromIntegral j - (height - 1) / 2)

-- | The fewest taxels of a symbol's 96 that must have been touched: all but a row of them. A box
-- may fit that is a column or two short, and at an angle the edge of what was touched leaves boxes
-- of any size; what they show of a symbol is a part. When none had to be touched, about half of the
-- symbols that were told wrong, and most that were like no shape, were such parts.
leastTouched :: Double
leastTouched = 0.9 * fromIntegral (symbolWidth * symbolHeight)

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
