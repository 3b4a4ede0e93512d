{-# OPTIONS_HADDOCK hide #-}

-- | The result of recognition, with its answer or refusal, and operations on whole results.
module PraTactile.Recognise.Recognition
  ( Recognition (..),
    unanswered,
    certainty,
    preferred,
    recognisedAngle,
    relocated,
    axesSkewed,

    -- * The answer
    Identification (..),
    LayoutDoubts (..),
    doubting,

    -- * Refusals
    Refusal (..),
    refusals,
    refusalName,
  )
where

import Data.Either (isRight)
import qualified Data.Map.Strict as Map
import PraTactile.Array (Position)
import PraTactile.Locate (LocatorError (..), Reason (..), reasonName, reasons, scaledForeign)
import PraTactile.Recognise.Diagnosis (Diagnosis)
import PraTactile.Recognise.FaceGrid (Cells)
import PraTactile.Recognise.Finding
import PraTactile.Recognise.Likeliest
import PraTactile.Recognise.Reading
import PraTactile.Recognise.Support
import PraTactile.Recognise.Tolerance
import PraTactile.Registration (Contradiction (..))
import PraTactile.Segmentation (SymbolImage (..))
import PraTactile.Sensor.Manifest (Remedy)
import PraTactile.Symmetry

-- | All that was recognised, with or without an answer.
data Recognition = Recognition
  { -- | every complete symbol of the composites
    recognisedSymbols :: [ReadSymbol],
    -- | symbols beside them that are incomplete, or were not cut out, but still informative
    recognisedParts :: [ReadSymbol],
    -- | symbols and parts by cell, along the symbols' axes; empty if they do not lie on one grid
    recognisedCells :: Cells,
    -- | the centre of cell (0, 0) along the symbols' axes, in pixels across and down on the first
    -- composite's grid; for composites that were set upright, on the upright composite's grid
    recognisedAnchor :: (Double, Double),
    -- | the support of the likeliest position, if there is one
    recognisedSupport :: Maybe Support,
    -- | the likeliest position
    recognisedLikeliest :: Maybe Likeliest,
    -- | the angle from the composites' axes to the symbols', in degrees clockwise, beyond quarter
    -- turns. The orientations of symbols and answer come on top of it.
    recognisedSkew :: Double,
    recognisedAnswer :: Either Refusal Identification
  }
  deriving stock (Eq, Show)

-- | What was touched.
data Identification
  = Found Finding
  | -- | The orientation, and all positions of the patch's upper left cell that agree with what was
    -- recognised. Only arrays without the window property have several.
    Several Symmetry [Position]
  deriving stock (Eq, Show)

-- | Why there is no answer; each has a stable name, 'refusalName'.
data Refusal
  = -- | the composite shows no complete symbol
    NoSymbols
  | -- | there are symbols, but the network recognised none
    SymbolsUnclear
  | -- | no symbols or unclear ones, with what the composites show instead and the original refusal
    ShownInstead Diagnosis Refusal
  | -- | the network recognises most symbols in the composite's mirror image and none in the
    -- composite; with ways to undo that
    Mirrored [Remedy]
  | -- | too many symbols lie another way up than the rest
    OrientationContradicts
  | -- | the symbols do not lie on one grid of the array's pitch
    GridContradicts
  | -- | separate groups of symbols lead to different positions
    WindowsContradict
  | -- | the frames show different things where they overlap
    FramesContradict Contradiction
  | -- | the recognised cells have no position
    NotLocated Reason
  | -- | the decoder refuses the recognised cells
    NotDecoded LocatorError
  deriving stock (Eq, Show)

-- | All refusals, with one example each of 'FramesContradict' and 'NotDecoded'.
refusals :: [Refusal]
refusals =
  [ NoSymbols,
    SymbolsUnclear,
    Mirrored [],
    OrientationContradicts,
    GridContradicts,
    WindowsContradict,
    FramesContradict (AgreeingAnywhere 2 0 0),
    NotDecoded NoSymmetry
  ]
    ++ map NotLocated reasons

-- | The stable name of a refusal, as used in JSON.
refusalName :: Refusal -> String
refusalName refusal = case refusal of
  NoSymbols -> "no-symbols"
  SymbolsUnclear -> "symbols-unclear"
  ShownInstead _ why -> refusalName why
  Mirrored _ -> "mirrored"
  OrientationContradicts -> "orientation-contradiction"
  GridContradicts -> "grid-contradiction"
  WindowsContradict -> "windows-contradiction"
  FramesContradict _ -> "frames-contradiction"
  NotLocated reason -> reasonName reason
  NotDecoded _ -> "not-decoded"

-- | A recognition without an answer: its symbols and the refusal.
unanswered :: [ReadSymbol] -> Refusal -> Recognition
unanswered symbols = Recognition symbols [] Map.empty (0, 0) Nothing Nothing 0 . Left

-- | The total certainty of symbols, in nats: the sum of -log of their doubts. It is larger for
-- symbols that were cut out better.
certainty :: [ReadSymbol] -> Double
certainty = sum . map (negate . log . max 1e-300 . readDoubt)

-- | Chooses between the recognition of composites as given and as set upright, whose symbols are
-- turned by the angle in degrees. An answer goes before a refusal, but the answer of composites as
-- given counts only up to 'mostSkew'. Otherwise the recognition with the greater 'certainty' is
-- taken.
preferred :: Double -> Recognition -> Recognition -> Recognition
preferred angle asGiven setRight
  | isAnswered setRight && not (isAnswered asGiven) = setRight
  | isAnswered asGiven && not (isAnswered setRight) && abs angle <= mostSkew = asGiven
  | certaintyOf setRight > certaintyOf asGiven = setRight
  | otherwise = asGiven
  where
    certaintyOf = certainty . recognisedSymbols
    isAnswered = isRight . recognisedAnswer

-- | Up to this angle, in degrees, symbols are read without errors in composites as given, if less
-- often.
mostSkew :: Double
mostSkew = 7

-- | Transfers a recognition of composites that were set upright, by the angle, to the composites as
-- given. The list has, for each composite, the map from places of the upright one to the given one.
relocated :: Double -> [(Double, Double) -> (Double, Double)] -> Recognition -> Recognition
relocated angle places recognition =
  recognition
    { recognisedSymbols = map symbol (recognisedSymbols recognition),
      recognisedParts = map symbol (recognisedParts recognition),
      recognisedCells = Map.map (map symbol) (recognisedCells recognition),
      recognisedSkew = angle + recognisedSkew recognition,
      recognisedAnswer = answer <$> recognisedAnswer recognition
    }
  where
    onFirst = place 0
    place source = case drop source places of
      back : _ -> back
      [] -> id
    symbol s =
      s
        { readAt = onFirst (readAt s),
          readImage =
            (readImage s)
              { symbolCentre = place (readSource s) (symbolCentre (readImage s)),
                symbolAxis = symbolAxis (readImage s) + angle
              }
        }
    answer found = case found of
      Several _ _ -> found
      Found there ->
        Found
          there
            { foundWindow = window (foundWindow there),
              foundWindows = map window (foundWindows there)
            }
    window w = w {windowSeenAt = onFirst (windowSeenAt w)}

-- | Adds the grid's angle to the axes of the symbols, which were cut out along the composites'
-- axes.
axesSkewed :: Recognition -> Recognition
axesSkewed recognition =
  recognition
    { recognisedSymbols = map skewed (recognisedSymbols recognition),
      recognisedParts = map skewed (recognisedParts recognition)
    }
  where
    skewed s = s {readImage = (readImage s) {symbolAxis = symbolAxis (readImage s) + by}}
    by = recognisedSkew recognition

-- | The angle by which the face is turned in the composites, in degrees clockwise in [0, 360),
-- given the orientation that was found.
recognisedAngle :: Recognition -> Symmetry -> Double
recognisedAngle recognition orientation
  | angle < 0 = angle + 360
  | angle >= 360 = angle - 360
  | otherwise = angle
  where
    angle = degreesClockwise orientation + recognisedSkew recognition

-- | The probabilities that frames lie elsewhere and then show another place.
data LayoutDoubts = LayoutDoubts
  { -- | one frame is misplaced
    layoutDoubtOfFrame :: !Double,
    -- | all frames lie along other axes or at another scale
    layoutDoubtOfAxes :: !Double,
    -- | some frames slipped
    layoutDoubtOfSlip :: !Double,
    -- | the likeliest other layout of all frames, if it is more probable than the robot's
    likelierLayout :: Maybe Contradiction
  }
  deriving stock (Eq, Show)

-- | Adds the doubts of misplaced frames to a recognition. The answer is refused if its doubt then
-- exceeds the tolerance.
doubting :: Tolerance -> LayoutDoubts -> Recognition -> Recognition
doubting _ (LayoutDoubts 0 0 0 _) recognition = recognition
doubting tolerance (LayoutDoubts stitched axes slip layout) recognition =
  recognition
    { recognisedSupport = weighed <$> recognisedSupport recognition,
      recognisedAnswer =
        if maybe True (tooDoubtful . weighed) (recognisedSupport recognition)
          then Left (maybe (NotLocated BelowThreshold) FramesContradict layout)
          else recognisedAnswer recognition
    }
  where
    tooDoubtful support = supportDoubt support > toleratedDoubt tolerance
    put = 1 - stitched - axes - slip
    weighed support =
      support
        { supportDoubts =
            (supportDoubts support)
              { doubtOfPosition = put * doubtOfPosition (supportDoubts support),
                doubtOfStitching = stitched,
                doubtOfAxes = axes,
                doubtOfSlip = slip,
                doubtsOfOrigin = scaledForeign (1 - put) (doubtsOfOrigin (supportDoubts support))
              }
        }
