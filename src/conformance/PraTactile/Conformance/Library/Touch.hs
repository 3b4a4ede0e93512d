{-# OPTIONS_HADDOCK hide #-}

-- | This library's stages of touch as an implementation under test.
module PraTactile.Conformance.Library.Touch
  ( libraryRegister,
    libraryStitch,
    librarySegment,
  )
where

import Control.Monad (unless)
import Data.Maybe (isNothing)
import qualified Data.Text as Text
import qualified Data.Vector as Vector
import Numeric.Natural (Natural)
import PraTactile.Conformance.Answer
import PraTactile.Conformance.Question
import PraTactile.Conformance.Shapes
import PraTactile.Image (Raster, fromRows, mapRaster, rasterHeight, rasterWidth)
import PraTactile.Recognise.Features (Featured (..), Features (..), features)
import qualified PraTactile.Registration as Stitch
import PraTactile.Registration.Pair
import PraTactile.Sensor.Frame (Frame (..), SensorPose (..), taxelPitch)
import PraTactile.Shape (Alphabet, ShapeError (UnreadableLine), alphabet, bitmap)

-- | Registration by the better one of its methods.
libraryRegister :: Maybe Drawings -> Pair -> Wire Registered
libraryRegister shapes pair = tablesOf shapes >>= (`registered` pair)

-- | Stitching with the settings for an exact sensor.
libraryStitch :: Maybe Drawings -> Natural -> [NominalFrame] -> Wire [Taxels]
libraryStitch shapes search frames = tablesOf shapes >>= \made -> stitched made search frames

-- | Grey values as shares of full scale. Refuses values above full scale, and an empty image.
image :: Rows -> Wire Raster
image rows = do
  unless (all (all (<= fullScale)) rows) (refuse "invalid")
  made <- either (const (refuse "invalid")) pure (fromRows (map (map fromIntegral) rows))
  if rasterWidth made > 0
    then pure (mapRaster (/ fromIntegral fullScale) made)
    else refuse "invalid"

registered :: AlphabetTables -> Pair -> Wire Registered
registered known (Pair a b (x, y) search) = do
  a' <- image a
  b' <- image b
  match <- do
    tables <- maybe (refuse "invalid") pure (tablesOfPairs known (rasterWidth a', rasterHeight a'))
    either (const (refuse "invalid")) pure $
      registerPair
        tables
        (standardPairing (fromInteger x, fromInteger y)) {pairingSearch = fromIntegral search}
        a'
        b'
  pure
    Registered
      { registeredReason = reasonOf <$> matchRefusal match,
        registeredBest = hypothesisShift (matchBest match),
        registeredFixed =
          if isNothing (matchRefusal match) then (True, True) else matchFixed match
      }
  where
    reasonOf refusal = case refusal of
      Blank -> "blank"
      OneAxis -> "one-axis"
      Ambiguous -> "ambiguous"
      NoOverlap -> "no-overlap"

-- | The tables of an alphabet, computed once.
data AlphabetTables = AlphabetTables
  { -- | for pairs of frames of a given width and height, if possible; those for small frames are
    -- computed once
    tablesOfPairs :: (Int, Int) -> Maybe Tables,
    tablesOfFrames :: Stitch.LatticeTables
  }

alphabetTables :: Alphabet -> AlphabetTables
alphabetTables known = AlphabetTables ofSize (Stitch.latticeTables known)
  where
    ofSize (w, h)
      | min w h < 4 || max w h > 256 = Nothing
      | max w h < 4 + smallSides = small Vector.!? ((w - 4) * smallSides + h - 4)
      | otherwise = Just (tablesFor known w h)
    -- Tables for frames of 4 to 31 taxels a side, by width, then height.
    small = Vector.generate (smallSides * smallSides) $ \i ->
      let (w, h) = i `quotRem` smallSides in tablesFor known (4 + w) (4 + h)
    smallSides = 28

-- | The tables of the given shapes, or of the default ones; those of shipped shapes are computed
-- once.
tablesOf :: Maybe Drawings -> Wire AlphabetTables
tablesOf shapes = case shapes of
  Nothing -> maybe (refuse "invalid") pure (lookup 4 [(q, made) | (q, _, made) <- shippedTables])
  Just drawings -> case [made | (_, known, made) <- shippedTables, known == drawings] of
    made : _ -> pure made
    [] -> either (const (refuse "invalid")) (pure . alphabetTables) (readDrawings drawings)

shippedTables :: [(Int, Drawings, AlphabetTables)]
shippedTables = [(q, drawingsOf known, alphabetTables known) | (q, known) <- knownAlphabets]

readDrawings :: Drawings -> Either ShapeError Alphabet
readDrawings drawings = traverse one (zip [1 :: Int ..] drawings) >>= alphabet
  where
    one (i, rows) = (,) (Text.pack (show i)) <$> (traverse (traverse marked) rows >>= bitmap)
    marked c = case c of
      '#' -> Right True
      '.' -> Right False
      _ -> Left (UnreadableLine 1 (Text.singleton c))

-- | The search distance is taken as two standard deviations of the robot's error.
stitched :: AlphabetTables -> Natural -> [NominalFrame] -> Wire [Taxels]
stitched known search frames = do
  placed <- traverse frame frames
  made <-
    either (const (refuse "invalid")) pure $
      Stitch.assemble (tablesOfFrames known) Stitch.Automatic settings placed
  pure (map Stitch.registeredShift (Stitch.assemblyFrames made))
  where
    settings =
      Stitch.standardRegistration
        { Stitch.registrationSigma = Just (max 0.5 (fromIntegral search / 2)),
          Stitch.registrationNoise = 0.0005
        }
    frame (NominalFrame rows (x, y)) = do
      made <- image rows
      let centre side whole = taxelPitch * (fromInteger whole + fromIntegral (side - 1) / 2)
          pose = SensorPose (centre (rasterWidth made) x) (centre (rasterHeight made) y) 0
      pure (Frame pose 0 made taxelPitch [])

-- | Segmentation at any angle.
librarySegment :: Rows -> Wire [Symbol]
librarySegment rows = do
  composite <- Stitch.compositeOf <$> image rows
  reader <- either (const (refuse "invalid")) pure agreedReader
  shown <- either (const (refuse "invalid")) pure (features reader composite)
  pure [Symbol (featuredAt symbol) (featuredAxis symbol) | symbol <- featuresSymbols shown]
