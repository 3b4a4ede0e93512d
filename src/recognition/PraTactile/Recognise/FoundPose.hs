-- | The pose of an object, from composites and the face that was located in them ("PraTactile.Pose"
-- has the formulas).
module PraTactile.Recognise.FoundPose
  ( foundPose,
    Pose (..),
    RigidMotion (..),
    thenPose,
  )
where

import Control.Applicative ((<|>))
import Data.List (sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, listToMaybe, mapMaybe)
import qualified Data.Vector.Storable as V
import qualified Data.Vector.Unboxed as U
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), PseudorandomArray, Shape (..))
import PraTactile.Composite (leastCoverage)
import PraTactile.Field (KnownField)
import PraTactile.Geometry (columnPitch, rotated, rowPitch, taxelPitch)
import PraTactile.Image (constant, pixelsWhere, rasterSize, valuesAt)
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge (ObjectName)
import PraTactile.Pose
import PraTactile.Pose.Alignment
import PraTactile.Pose.Matrix (diagonal)
import PraTactile.Recognise.Finding
import PraTactile.Recognise.Reading
import PraTactile.Recognise.Recognition
import PraTactile.Recognise.Support
import PraTactile.Registration (Composite (..), CompositeFrame (..))
import PraTactile.Relief (classOn, symbolScale)
import PraTactile.Sensor.Frame (Motion (..), inverse, movePoint)
import PraTactile.Shape (Alphabet, shapeOf)

-- | The located object and its pose in the robot's frame, in millimetres. 'Nothing' if there is no
-- answer, if the answer is not on one face, or if too few symbols of the face were read right for a
-- fit.
--
-- Arguments: the placement; the symbols' shapes; the array; the standard deviation of a frame's
-- position error along each axis, in taxels; the composites that were recognised, with lengths
-- divided by the symbols' size; what was recognised in them. Without a standard deviation the
-- largest that registration found is used, or 1 if it found none.
--
-- The composites' pixels are aligned with the relief of the face ('aligned'). If that fails, the
-- centres at which symbols were cut out are fitted to the centres of their cells.
foundPose ::
  KnownField k =>
  Placement ->
  Alphabet ->
  PseudorandomArray k ->
  Maybe Double ->
  [Composite] ->
  Recognition ->
  Maybe (ObjectName, Pose)
foundPose layout alphabet array told composites recognition = do
  found <- located (recognisedAnswer recognition)
  place <- onFace (windowWhereabouts (foundWindow found))
  let Face object name = placeFace place
  laid <- either (const Nothing) Just (findFace layout object name)
  solid <- placementObject layout object
  frame <- faceFrameOf solid name
  origin <- compositeOrigin <$> listToMaybe composites
  scale <- fromRational <$> symbolScale (placementPitch layout)
  let millimetres = scale * taxelPitch
      taxels spot = let (x, y) = spotMillimetres spot in (x / millimetres, y / millimetres)
      wrong = maybe [] supportWrong (recognisedSupport recognition)
      symbols =
        [ (cell, s)
          | s <- recognisedSymbols recognition,
            Just there <- [Map.lookup (readNumber s) (foundPlaces found)],
            Just on <- [onFace (whereabouts layout (Shape 1 1) (symbolCell there))],
            placeFace on == placeFace place,
            let cell = placeCell on
        ]
      right = [one | one@(_, s) <- symbols, readNumber s `notElem` wrong]
      seen =
        [ Seen
            (taxels (cellCentre layout laid cell))
            (readAt s)
            (diagonal [readVariance, readVariance])
          | (cell, s) <- right
        ]
      begin = startingAt (recognisedAngle recognition (foundOrientation found)) seen
      shifts = [(shiftFrom origin c, c) | c <- composites]
      ground =
        groundUnder
          (taxels (laidMargin laid))
          [ (cell, classOn array laid cell)
            | cell <- cellsUnder (taxels (laidMargin laid)) (laidGrid laid) begin shifts,
              hasCell (laidBlock laid) cell,
              cell `notElem` [there | (there, s) <- symbols, readNumber s `elem` wrong]
          ]
      registered = sortOn negate (mapMaybe compositePositionError composites)
      sigma = fromMaybe 1 (told <|> listToMaybe registered)
  fit <-
    if null seen
      then Nothing
      else
        aligned ground (concatMap (touches origin sigma) composites) begin
          <|> bySymbols sigma seen
  pure (object, poseOf frame (onRobot millimetres (both (scale *) origin) fit))
  where
    located answer = case answer of
      Right (Found found) -> Just found
      _ -> Nothing
    onFace there = case there of
      OnFace place -> Just place
      _ -> Nothing
    shiftFrom (left, top) composite =
      let (x, y) = compositeOrigin composite in ((x - left) / taxelPitch, (y - top) / taxelPitch)
    both f (x, y) = (f x, f y)
    frames = sum (map (length . compositeFrames) composites)
    -- If the images cannot be aligned: the fit to the centres at which symbols were cut out.
    bySymbols sigma seen = moreError (common sigma) (common 1) <$> rigidFit seen
    common each = if frames == 0 then 0 else each / sqrt (fromIntegral frames)
    groundUnder from classes =
      Ground
        from
        ( Map.fromList
            [ ((fromIntegral i, fromIntegral j), shape)
              | (Position i j, c) <- classes,
                Right shape <- [shapeOf alphabet c]
            ]
        )

-- | The variance along each axis of the place at which a symbol was cut out, in square taxels
-- (assumption).
readVariance :: Double
readVariance = 0.25

-- | The motion with this rotation, in degrees, that takes the mean of the points to the mean of
-- where they were seen.
startingAt :: Double -> [Seen] -> Motion
startingAt degrees seen = Motion degrees (px - x) (py - y)
  where
    (x, y) = rotated degrees (centroid (map seenOnFace seen))
    (px, py) = centroid (map seenByRobot seen)

-- | The cells of a block that composites reach if the face lies as the motion has it. The corner of
-- the block is in taxels of the face. Each composite comes with its place.
cellsUnder ::
  (Double, Double) -> Shape -> Motion -> [((Double, Double), Composite)] -> [Position]
cellsUnder (left, top) (Shape high wide) motion composites =
  [Position i j | i <- range (map row' corners) high, j <- range (map column' corners) wide]
  where
    corners =
      [ movePoint (inverse motion) (x + across, y + down)
        | ((x, y), composite) <- composites,
          let (w, h) = rasterSize (compositeImage composite),
          across <- [0, fromIntegral w],
          down <- [0, fromIntegral h]
      ]
    column' (x, _) = (x - left) / columnPitch
    row' (_, y) = (y - top) / rowPitch
    range :: [Double] -> Natural -> [Natural]
    range values size =
      map
        fromInteger
        [ max 0 (floor (minimum values) - 1)
          .. min (toInteger size - 1) (ceiling (maximum values))
        ]

-- | The frames of a composite, in taxels from an origin in the robot's plane. A composite that is
-- one image counts as one frame without position or rotation error.
touches :: (Double, Double) -> Double -> Composite -> [Touch]
touches origin sigma composite = case compositeFrames composite of
  [] -> [touch (compositeOrigin composite) (0, 0) (0, Just 0) image (compositeCoverage composite)]
  frames ->
    [ touch
        (compositeFrameAt f)
        (compositeFrameShift f)
        (sigma, Nothing)
        (compositeFrameImage f)
        (fromMaybe (full f) (compositeFrameWeight f))
      | f <- frames
    ]
  where
    image = compositeImage composite
    full f = let (w, h) = rasterSize (compositeFrameImage f) in constant w h 1
    touch (x, y) moved errors readings felt =
      Touch
        { touchMiddle = (inTaxels fst x + halfWide, inTaxels snd y + halfHigh),
          touchMoved = moved,
          touchErrors = errors,
          touchPixels =
            U.fromList
              [ (fromIntegral i - halfWide, fromIntegral j - halfHigh, value)
                | (n, value) <- zip (V.toList pixels) (V.toList (valuesAt readings pixels)),
                  let (j, i) = n `quotRem` w
              ]
        }
      where
        (w, h) = rasterSize readings
        (halfWide, halfHigh) = (half w, half h)
        half side = fromIntegral (side - 1) / 2
        pixels = pixelsWhere (>= leastCoverage) felt
    inTaxels part t = (t - part origin) / taxelPitch
