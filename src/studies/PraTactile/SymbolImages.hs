-- | Images of symbols with known truth, to train and test networks. They are the shapes themselves,
-- or what remains of them after a plate is pressed and the frames are stitched, as in decoding.
module PraTactile.SymbolImages
  ( -- * Symbols
    Symbols (..),
    symbolsOf,

    -- * Images
    ImageSource (..),
    sourceName,
    sourceSensor,
    labelledImages,
    labelledSteps,
    Labelled (..),
    ImagesError (..),

    -- * Presses
    Cut (..),
    cuts,
  )
where

import Data.Bifunctor (first)
import Data.List (unfoldr)
import Data.Maybe (listToMaybe)
import qualified Data.Vector.Unboxed as Unboxed
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Composite.Skew (leastSkew, setUpright, skew)
import PraTactile.Explore
import PraTactile.Geometry (columnPitch, rowPitch, symbolHeight, symbolWidth, taxelPitch)
import PraTactile.Image (Raster, onRaster)
import PraTactile.Object.Placement
import PraTactile.Object.Plate (platePlacement)
import PraTactile.Pressing (pressRegion)
import PraTactile.Random (uniform)
import PraTactile.Registration (LatticeTables, compositePosition, latticeTables)
import PraTactile.Registration.Stitching (standardStitching, stitchedBy)
import PraTactile.Relief
import PraTactile.Segmentation
import PraTactile.Sensor (Sensor, drawSpecimen)
import PraTactile.Sensor.Calibration (withoutStuck)
import PraTactile.Sensor.Frame (inverse, movePoint)
import PraTactile.Shape (Alphabet, alphabetSize, shapes, toRaster)
import PraTactile.Steps
import PraTactile.Symmetry
import System.Random (StdGen, mkStdGen, split)

-- | The shapes that are pressed, and the tables by which registration finds them.
data Symbols = Symbols
  { symbolShapes :: Alphabet,
    symbolTables :: LatticeTables
  }

-- | The symbols of an alphabet.
symbolsOf :: Alphabet -> Symbols
symbolsOf alphabet = Symbols alphabet (latticeTables alphabet)

-- | The source of images.
data ImageSource
  = -- | the shapes themselves: 0 flat, 1 embossed
    Bitmaps
  | -- | presses of a sensor, with its name, on plates in these rotations
    Presses String Sensor Turns

-- | The name of a kind of images, which stays stable.
sourceName :: ImageSource -> String
sourceName source = case source of
  Bitmaps -> "bitmap"
  Presses {} -> "press"

-- | The name of the sensor, if there is one.
sourceSensor :: ImageSource -> Maybe String
sourceSensor source = case source of
  Bitmaps -> Nothing
  Presses name _ _ -> Just name

-- | Why there are no images.
data ImagesError
  = -- | There is no plate.
    NoPlate PlacementError
  | -- | The plate has no relief with these shapes.
    NoReliefOfPlate ReliefError
  | -- | In this number of presses too few symbols were found.
    TooFewFound Int
  deriving stock (Eq, Show)

-- | Upright images with their classes.
data Labelled = Labelled
  { labelledAs :: ![(Raster, Int)],
    -- | the number of symbols that lay wholly in the pressed region but were not found
    labelledLost :: !Int,
    labelledPresses :: !Int
  }

-- | Images of each class, sorted by class and then in the order found. Arguments: the symbols; the
-- source; the number of images of each class; a seed. Refuses sensors with which hardly any symbol
-- is found.
labelledImages :: Symbols -> ImageSource -> Int -> Int -> Either ImagesError Labelled
labelledImages symbols source count seed = result (labelledSteps symbols source count seed)

-- | The steps of 'labelledImages', one for each press, with the number of wanted images so far,
-- over all classes.
labelledSteps ::
  Symbols -> ImageSource -> Int -> Int -> Steps Int (Either ImagesError Labelled)
labelledSteps symbols source count seed = case source of
  Bitmaps ->
    Done . Right $
      Labelled
        [(toRaster b, c) | (c, b) <- zip [0 ..] (shapes alphabet), _ <- [1 .. count]]
        0
        0
  Presses _ sensor turns -> case cuts symbols sensor turns seed of
    Left why -> Done (Left why)
    Right pressed -> go (replicate classes 0) [] (take most pressed)
  where
    -- The number of images of each class so far, and the presses so far, the last one first.
    go have before pressed
      | all (>= count) have = Done (Right (chosenFrom (reverse before)))
      | one : others <- pressed =
        let have' = zipWith (plus one) [0 ..] have
         in made one `seq` Step (sum (map (min count) have')) (go have' (one : before) others)
      | otherwise = Done (Left (TooFewFound most))
    -- An image that is not computed yet keeps its frames in memory.
    made one = foldr (\(image, _) -> seq image) () (cutImages one)
    chosenFrom enough =
      Labelled
        (concatMap (ofClass (concatMap cutImages enough)) [0 .. classes - 1])
        (sum (map cutLost enough))
        (length enough)
    ofClass found c = take count [it | it <- found, snd it == c]
    alphabet = symbolShapes symbols
    classes = alphabetSize alphabet
    -- About five symbols are found in a press.
    most = 100 + 4 * classes * count
    plus one c n = n + length (filter ((== c) . snd) (cutImages one))

-- | The symbols that were cut out of a press.
data Cut = Cut
  { -- | 8 x 12 images, set upright, with their true classes
    cutImages :: [(Raster, Int)],
    -- | the number of symbols that lay wholly in the region but were not found
    cutLost :: Int
  }

-- | An infinite list of presses on plates of 15 x 17 symbols with random classes, in regions of the
-- default size. Arguments: the symbols; the sensor; the regions' rotations; a seed. The presses are
-- stitched by 'standardStitching' and cut as in decoding, but turned upright and labelled by the
-- truth.
cuts :: Symbols -> Sensor -> Turns -> Int -> Either ImagesError [Cut]
cuts symbols sensor turns seed = do
  layout <- first NoPlate (platePlacement (Shape 15 17))
  face <- maybe (Left (TooFewFound 0)) Right (listToMaybe (laidFaces layout))
  -- Whether there is a relief does not depend on the symbols.
  _ <- first NoReliefOfPlate (plate layout face (const 0))
  Right
    [ cut
      | g <- unfoldr (Just . split) (mkStdGen seed),
        let (classAt, g') = chanceArrangement (alphabetSize (symbolShapes symbols)) g,
        Right surface <- [plate layout face classAt],
        Just cut <- [cutFrom symbols sensor turns face classAt surface g']
    ]
  where
    plate :: Placement -> LaidFace -> (Position -> Int) -> Either ReliefError Relief
    plate layout face = reliefOf layout alphabet face (alphabetSize alphabet)
    alphabet = symbolShapes symbols

-- | A random class for each of 15 x 17 cells, with equal probabilities.
chanceArrangement :: Int -> StdGen -> (Position -> Int, StdGen)
chanceArrangement classes g = (\(Position i j) -> at (fromIntegral (17 * i + j)), g')
  where
    (own, g') = split g
    drawn = Unboxed.fromList (take 255 (unfoldr (Just . uniform) own)) :: Unboxed.Vector Double
    at k = maybe 0 (\u -> min (classes - 1) (floor (u * fromIntegral classes))) (drawn Unboxed.!? k)

-- | A region of the plate, pressed and cut. 'Nothing' if the frames cannot be stitched.
cutFrom ::
  Symbols -> Sensor -> Turns -> LaidFace -> (Position -> Int) -> Relief -> StdGen -> Maybe Cut
cutFrom symbols sensor turns face classAt surface g = do
  let (region, g') = drawnRegion turns standardRegionSize face g
      (specimen, g'') = drawSpecimen sensor g'
  frames <- right (pressRegion sensor (defaultSpacing sensor) specimen surface region g'')
  composite <- right (stitchedBy (symbolTables symbols) standardStitching (withoutStuck frames))
  let whole = maskedComposite (maskForeign composite)
      (upright, back, leftOver) = case skew [whole] of
        Just angle
          | abs angle > leastSkew ->
            let (it, places) = setUpright angle whole in (it, places, regionTurn region - angle)
        _ -> (whole, id, regionTurn region)
      quarters = round (leftOver / 90) `mod` 4 :: Int
      axis = if odd quarters then turned 1 else identity
      (_, _, found) = segmentAlong axis upright
      setRight = if quarters >= 2 then onRaster (turned 2) else id
      named =
        [ (cell, (setRight (symbolPixels s), classAt cell))
          | s <- segmentedSymbols found,
            let seen = compositePosition whole (back (symbolCentre s)),
            Just cell <- [cellUnder (movePoint (regionMotion region) seen)]
        ]
  pure (Cut (map snd named) (length (filter (`notElem` map fst named) (whollyIn region))))
  where
    right = either (const Nothing) Just

-- | The cell whose centre is within about a third of a pitch of a place of the plate, in
-- millimetres right and down.
cellUnder :: (Double, Double) -> Maybe Position
cellUnder (x, y)
  | i >= 0 && i < 15 && j >= 0 && j < 17 && near fi && near fj =
    Just (Position (fromInteger i) (fromInteger j))
  | otherwise = Nothing
  where
    (fi, fj) = (y / (rowPitch * taxelPitch), x / (columnPitch * taxelPitch)) :: (Double, Double)
    (i, j) = (floor fi, floor fj) :: (Integer, Integer)
    near f = abs (f - fromIntegral (floor f :: Integer) - 0.5) < 0.3

-- | The cells whose symbols lie wholly in a region of the plate.
whollyIn :: ProbedRegion -> [Position]
whollyIn region = [Position i j | i <- [0 .. 14], j <- [0 .. 16], all within (box i j)]
  where
    within place =
      let (x, y) = movePoint (inverse (regionMotion region)) place
       in x >= 0 && y >= 0 && x <= taxels (regionWidth region) && y <= taxels (regionHeight region)
    box i j =
      [ (taxels columnPitch * middle j + dx, taxels rowPitch * middle i + dy)
        | dx <- beside symbolWidth,
          dy <- beside symbolHeight
      ]
    middle k = fromIntegral k + 0.5
    beside size = [negate (taxels size) / 2, taxels size / 2]
    taxels :: Int -> Double
    taxels n = taxelPitch * fromIntegral n
