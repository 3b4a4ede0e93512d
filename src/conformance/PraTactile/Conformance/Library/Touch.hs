{-# LANGUAGE GADTs #-}

-- | The stages of touch of this library as an implementation under test.
module PraTactile.Conformance.Library.Touch
  ( libraryTouch,
  )
where

import Control.Applicative ((<|>))
import Control.Monad (unless)
import Data.Maybe (isNothing)
import qualified Data.Vector as Vector
import Numeric.Natural (Natural)
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Question
import PraTactile.Conformance.Shapes (agreedAlphabet)
import PraTactile.Image (Raster, fromRows, mapRaster, rasterHeight, rasterWidth)
import qualified PraTactile.Registration as Stitch
import PraTactile.Registration.Pair
import PraTactile.Segmentation.Turned (Featured (..), TurnedSegmentation (..), segmentTurned)
import PraTactile.Sensor.Frame (Frame (..), Pose (..), taxelPitch)

-- | Registration by the better of its methods, stitching as for an exact sensor, and segmentation
-- at any angle.
libraryTouch :: Question a -> Wire a
libraryTouch question = case question of
  Register pair -> registered pair
  Stitch search frames -> stitched search frames
  Segment rows -> segmented rows
  _ -> notOffered

-- | Grey values as shares of full scale.
image :: Rows -> Wire Raster
image rows = do
  unless (all (all (<= fullScale)) rows) (refuse "invalid")
  made <- either (const (refuse "invalid")) pure (fromRows (map (map fromIntegral) rows))
  if rasterWidth made > 0
    then pure (mapRaster (/ fromIntegral fullScale) made)
    else refuse "invalid"

registered :: Pair -> Wire Registered
registered (Pair a b (x, y) search) = do
  a' <- image a
  b' <- image b
  match <- do
    tables <- maybe (refuse "invalid") pure (tablesOf (rasterWidth a', rasterHeight a'))
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

-- | The tables for frames of a width and height, if these are possible; those of small frames are
-- made once.
tablesOf :: (Int, Int) -> Maybe Tables
tablesOf (w, h)
  | min w h < 4 || max w h > 256 = Nothing
  | otherwise = small <|> made
  where
    made = either (const Nothing) (\known -> Just (tablesFor known w h)) agreedAlphabet
    small
      | max w h < 4 + smallSides = smallTables Vector.!? ((w - 4) * smallSides + h - 4)
      | otherwise = Nothing

-- | Those of frames of 4 to 31 taxels a side, by width and then height.
smallTables :: Vector.Vector Tables
smallTables = case agreedAlphabet of
  Left _ -> Vector.empty
  Right known -> Vector.generate (smallSides * smallSides) $ \i ->
    let (w, h) = i `quotRem` smallSides in tablesFor known (4 + w) (4 + h)

smallSides :: Int
smallSides = 28

-- | The tables that frames are stitched by, made once.
agreedTables :: Maybe Stitch.LatticeTables
agreedTables = either (const Nothing) (Just . Stitch.latticeTables) agreedAlphabet

-- | The search is taken for two standard deviations of the robot's error.
stitched :: Natural -> [Placed] -> Wire [Taxels]
stitched search frames = do
  placed <- traverse frame frames
  tables <- maybe (refuse "invalid") pure agreedTables
  made <-
    either (const (refuse "invalid")) pure (Stitch.assemble tables Stitch.Automatic settings placed)
  pure (map Stitch.registeredShift (Stitch.assemblyFrames made))
  where
    settings =
      Stitch.standardRegistration
        { Stitch.registrationSigma = Just (max 0.5 (fromIntegral search / 2)),
          Stitch.registrationNoise = 0.0005
        }
    frame (Placed rows (x, y)) = do
      made <- image rows
      let centre side whole = taxelPitch * (fromInteger whole + fromIntegral (side - 1) / 2)
          pose = Pose (centre (rasterWidth made) x) (centre (rasterHeight made) y) 0
      pure (Frame pose 0 made taxelPitch [])

segmented :: Rows -> Wire [Symbol]
segmented rows = do
  composite <- Stitch.compositeOf <$> image rows
  pure
    [ Symbol (featuredAt symbol) (featuredAxis symbol)
      | symbol <- turnedSymbols (segmentTurned composite)
    ]
