{-# LANGUAGE RankNTypes #-}

-- | What the tests of recognition share: the paper's array, or another, with its placement and its
-- reader; its faces as reliefs; and pictures of its symbols.
module Test.Recognition.Setting
  ( -- * An array and what is on it
    Setting (..),
    onPaper,
    onPaperWith,
    onArray,
    paperReader,
    recogniserOf,
    recogniserOn,
    facesFelt,

    -- * Its cells
    everywhere,
    classesOf,

    -- * Pictures of symbols
    Drawn,
    asDrawn,
    drawingOf,
    pasted,
    inCells,

    -- * What was recognised
    recognisedIn,
    foundIn,
    refusedIn,
    locatedAround,
  )
where

import Data.Maybe (fromMaybe)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Classification.Reader (Reader (..))
import PraTactile.Evaluate
import PraTactile.Explore (Turns (..))
import PraTactile.Field (KnownField, toCode)
import PraTactile.Image
import PraTactile.Object.Canonical (canonicalPlacement)
import PraTactile.Object.Placement
import PraTactile.Object.Plate (plateName)
import PraTactile.Pressing
import PraTactile.Profile
import PraTactile.Recognise
import PraTactile.Registration (Composite, standardRegistration)
import PraTactile.Relief
import PraTactile.Sensor (standardSensor)
import PraTactile.Sensor.Frame (taxelPitch)
import PraTactile.Shape (Alphabet, shapes, toRaster)
import PraTactile.Symmetry (identity)
import PraTactile.Truth (truthRegion)
import PraTactile.Window (Mask)
import Test.Effort
import Test.QuickCheck hiding (generate)
import Test.Support (below, whenRight)
import Test.Touch.Paper (paperReader)

-- | An array with its window, the objects laid on it, and the reader of its symbols.
data Setting k = Setting
  { settingArray :: PseudorandomArray k,
    settingWindow :: Mask,
    settingLayout :: Placement,
    settingReader :: Reader
  }

-- | The paper's array with the shipped placement, shapes and network.
onPaper :: (forall k. KnownField k => Setting k -> a) -> a
onPaper = onPaperWith (profileWindow canonicalProfile)

-- | The paper's setting with windows of another shape.
onPaperWith :: Shape -> (forall k. KnownField k => Setting k -> a) -> a
onPaperWith window =
  onArray canonicalProfile {profileWindow = window} (orError canonicalPlacement) paperReader

-- | The array of a profile with objects laid on it, and its reader.
onArray :: Profile -> Placement -> Reader -> (forall k. KnownField k => Setting k -> a) -> a
onArray profile layout reader test =
  orError (withProfile profile (\array mask -> test (Setting array mask layout reader)))

-- | The recogniser of the array on its own surface.
recogniserOf :: KnownField k => Setting k -> Recogniser k
recogniserOf setting = recogniserOn surface setting
  where
    ArrayOn surface _ = naturally (settingArray setting)

-- | The recogniser of the array on a surface.
recogniserOn :: KnownField k => Surface -> Setting k -> Recogniser k
recogniserOn surface (Setting array mask layout reader) =
  orError (recogniser (ArrayOn surface array) mask layout reader)

-- | The result, for shipped parts, which fit together.
orError :: Show e => Either e a -> a
orError = either (error . show) id

-- | The faces laid on the array, each with its relief.
facesFelt :: KnownField k => Setting k -> [(LaidFace, Relief)]
facesFelt (Setting array _ layout reader) =
  [ (face, orError (relief array layout (readerAlphabet reader) face))
    | face <- laidFaces layout
  ]

-- | The positions of the paper's array.
everywhere :: [Position]
everywhere = [Position r c | r <- [0 .. 14], c <- [0 .. 16]]

-- | The classes that an array has in rows and columns of cells from a position on.
classesOf :: KnownField k => PseudorandomArray k -> Natural -> Natural -> Position -> [[Int]]
classesOf array high wide (Position r c) =
  [[toCode (cellAt array (Position (r + i) (c + j))) | j <- below wide] | i <- below high]

-- | The content of each cell: nothing, or a class with a change of its shape.
type Drawn = [[Maybe (Int, Raster -> Raster)]]

-- | Classes with unchanged shapes.
asDrawn :: [[Int]] -> Drawn
asDrawn = map (map (\c -> Just (c, id)))

-- | Cells of 16 x 20 taxels with symbols in their middle.
drawingOf :: Alphabet -> Drawn -> Raster
drawingOf known cells =
  inCells known (16, 20) (length cells, maximum (0 : map length cells)) $
    [ ((i, j), c, change)
      | (i, line) <- zip [0 ..] cells,
        (j, Just (c, change)) <- zip [0 ..] line
    ]

-- | A picture of rows and columns of cells of a width and a height, with symbols in the middle of
-- those by row and column.
inCells ::
  Alphabet -> (Int, Int) -> (Int, Int) -> [((Int, Int), Int, Raster -> Raster)] -> Raster
inCells known (across, down) (high, wide) cells =
  pasted
    (wide * across, high * down)
    [ ( j * across + (across - rasterWidth shape) `div` 2,
        i * down + (down - rasterHeight shape) `div` 2,
        shape
      )
      | ((i, j), c, change) <- cells,
        let shape = change (toRaster (shapes known !! c))
    ]

-- | A picture of a width and a height, flat but for images with their left and upper edges there.
pasted :: (Int, Int) -> [(Int, Int, Raster)] -> Raster
pasted (wide, high) images = generate wide high $ \x y ->
  sum [fromMaybe 0 (index image (x - left) (y - top)) | (left, top, image) <- images]

-- | The recognition of composites of one face.
recognisedIn :: KnownField k => Recogniser k -> Tolerance -> [Composite] -> IO Recognition
recognisedIn reader how = either (fail . show) pure . recogniseWith how reader

-- | What was found, if that is a single place.
foundIn :: Recognition -> Maybe Finding
foundIn recognition = case recognisedAnswer recognition of
  Right (Found found) -> Just found
  _ -> Nothing

-- | The reason for no answer.
refusedIn :: Recognition -> Maybe Refusal
refusedIn = either Just (const Nothing) . recognisedAnswer

-- | Expects that presses in the corners and along the edges of an array's plate are decoded at
-- their places, with regions of this size. A quick run presses two opposite corners, which contain
-- a part of each edge.
locatedAround :: KnownField k => Setting k -> (Int, Int) -> Property
locatedAround setting (w, h) =
  once $
    conjoin
      [ whenRight (pressed (how at) (readerAlphabet reader) array plate plateName) $
          \(frames, truth) ->
            let t = Trial face (truthRegion truth) frames Nothing False
             in case runTrial standardTolerance known standardRegistration t of
                  TrialResult (Correct _) _ -> property True
                  other -> counterexample (show (at, other)) False
        | face <- laidFaces plate,
          let (right', bottom) = spotMillimetres (laidExtent face),
          let free = right' - taxelPitch * fromIntegral w,
          let below' = bottom - taxelPitch * fromIntegral h,
          at <-
            byEffort
              [(0, 0), (free, below')]
              ((,) <$> [0, free / 2, free] <*> [0, below' / 2, below']),
          at /= (free / 2, below' / 2)
      ]
  where
    Setting array _ plate reader = setting
    known = recogniserOf setting
    how at =
      (pressingWith standardSensor 3)
        { pressingAt = Just at,
          pressingSize = (w, h),
          pressingTurns = AmongTurns [identity]
        }
