{-# OPTIONS_HADDOCK hide #-}

-- | Segmentation of upright symbols: Otsu's threshold, connected components, and a check that a
-- component's bounding box has a symbol's size and was touched.
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

-- | The symbols of a composite; none for a blank one. The levels of background and embossing come
-- from the whole composite. The pixels above the middle of both levels are divided into connected
-- components, and each component whose box has a symbol's size becomes a symbol. A noisy composite
-- is smoothed for that, but the symbols' images are taken from the composite itself.
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

-- | The least contrast, in standard deviations of the noise, at which a composite is not smoothed.
leastClear :: Double
leastClear = 6

-- | The input from which symbols are cut. Its fields are those of one composite.
data Scene = Scene
  { -- | the image from which the symbols' images are sampled
    sceneImage :: !Reference,
    sceneLevels :: !Levels,
    -- | the pixels in which boxes are measured
    scenePixels :: !Masked
  }

-- | The connected components of at least 'leastPixels' pixels, from left to right. The number is
-- the gap of 'components'.
pieces :: Masked -> Int -> Region -> [Region]
pieces pixels gap =
  sortOn (minimum . map (placeOf pixels)) . filter (atLeast leastPixels) . components pixels gap

-- | Whether a region has at least the given number of pixels.
atLeast :: Int -> Region -> Bool
atLeast count = not . null . drop (count - 1)

-- | Judges a component: a symbol, or the reason why not. A component that is too large may be a
-- symbol with something close to it, or a blurred symbol. Then it is tried without its smallest
-- pieces, then each piece alone, then its pixels above a higher threshold. The list is empty only
-- if the component is.
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

-- | The threshold for blurred symbols: the background plus this share of the contrast.
upperShare :: Double
upperShare = 0.65

-- | Judges a region by its bounding box where the intensity crosses a threshold: a symbol, or the
-- reason why not. 'Nothing' for an empty region.
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

-- | The least number of touched taxels, of a symbol's 96: at most nine may be missing. With fewer,
-- a box may fit that lacks a column or two, and at an angle the edge of the touched pixels leaves
-- boxes of any size. Such boxes show parts of symbols: they made about half of the misread symbols,
-- and most images that resemble no shape.
leastTouched :: Double
leastTouched = 0.9 * fromIntegral (symbolWidth * symbolHeight)

-- | The least number of pixels of a component; fewer are noise.
leastPixels :: Int
leastPixels = 4

-- | Embossed pixels with at most this many pixels between them may belong to one symbol. Symbols
-- are eight taxels apart.
largestGap :: Int
largestGap = 2

-- | The greatest difference of a measured width or height from a symbol's, in taxels. It is less
-- than the two taxels of a symbol's strokes.
sizeTolerance :: Double
sizeTolerance = 1.6
