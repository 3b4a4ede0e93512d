{-# OPTIONS_HADDOCK hide #-}

-- | What comes of recognising composites: symbols, an answer or a refusal, and what is done to all
-- of them together.
module PraTactile.Recognise.Recognition
  ( Recognition (..),
    unanswered,
    certainty,
    preferred,
    recognisedAngle,
    relocated,
    axesTilted,

    -- * The answer
    Identification (..),
    Misplaced (..),
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
import PraTactile.Locate (LocatorError (..), Reason (..), foreignBut, reasonName, reasons)
import PraTactile.Recognise.FaceGrid (Cells)
import PraTactile.Recognise.Finding
import PraTactile.Recognise.Instead (Instead)
import PraTactile.Recognise.Likeliest
import PraTactile.Recognise.Reading
import PraTactile.Recognise.Support
import PraTactile.Recognise.Tolerance
import PraTactile.Registration (Contradiction (..))
import PraTactile.Segmentation (SymbolImage (..))
import PraTactile.Sensor.Manifest (Remedy)
import PraTactile.Symmetry

-- | What was recognised, whether or not it led to an answer.
data Recognition = Recognition
  { -- | every complete symbol of the composites
    recognisedSymbols :: [ReadSymbol],
    -- | symbols beside them that are not complete, or were not cut out, as far as they tell
    -- anything
    recognisedParts :: [ReadSymbol],
    -- | symbols and parts by their cells, along the symbols' axes, where they lie on one grid
    recognisedCells :: Cells,
    -- | where the centre of cell (0, 0) is along the symbols' axes, in pixels across and down on
    -- the first composite's grid; of composites that were set upright for reading, on theirs
    recognisedAnchor :: (Double, Double),
    -- | for the likeliest position, where there is one
    recognisedSupport :: Maybe Support,
    -- | that position
    recognisedLikeliest :: Maybe Likeliest,
    -- | by how many degrees, clockwise, the symbols' axes are turned from the composites', beside
    -- quarter turns: the orientations of symbols and answer come on top of it
    recognisedTilt :: Double,
    recognisedAnswer :: Either Refusal Identification
  }
  deriving stock (Eq, Show)

-- | What was touched.
data Identification
  = Found Finding
  | -- | The orientation, and the several positions of the patch's upper left cell that fit what was
    -- recognised (only where the array lacks the window property).
    Several Symmetry [Position]
  deriving stock (Eq, Show)

-- | Why there is no answer; each has a stable name, 'refusalName'.
data Refusal
  = -- | the composite shows no complete symbol
    NoSymbols
  | -- | there are symbols, but the network recognised none
    SymbolsUnclear
  | -- | no symbols or unclear ones, and what the composites show instead
    ShownInstead Instead Refusal
  | -- | the network recognises most symbols in the composite's mirror image, and none as it is;
    -- what undoes that
    Mirrored [Remedy]
  | -- | symbols disagree about the orientation of the grid
    OrientationContradicts
  | -- | the symbols do not lie on one grid of the array's pitch
    GridContradicts
  | -- | separate groups of symbols lead to different places
    WindowsContradict
  | -- | the frames show different things where they should overlap
    FramesContradict Contradiction
  | -- | the recognised cells lead to no position
    NotLocated Reason
  | -- | the recognised cells cannot be decoded on an array of that size
    NotDecoded LocatorError
  deriving stock (Eq, Show)

-- | All refusals, those of frames and of decoding once.
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

-- | The stable name of a refusal, as JSON has it.
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

-- | Symbols without an answer, and why.
unanswered :: [ReadSymbol] -> Refusal -> Recognition
unanswered symbols = Recognition symbols [] Map.empty (0, 0) Nothing Nothing 0 . Left

-- | How much symbols say together, in nats: the fewer doubts they leave, the better they were cut
-- out.
certainty :: [ReadSymbol] -> Double
certainty = sum . map (negate . log . max 1e-300 . readDoubt)

-- | Of what was recognised as the composites are, whose symbols lie at an angle (degrees), and of
-- what was recognised from them set upright: an answer before a refusal, but as the composites are
-- only where that may be read; else what leaves less doubt about the symbols.
preferred :: Double -> Recognition -> Recognition -> Recognition
preferred angle asGiven setRight
  | isAnswered setRight && not (isAnswered asGiven) = setRight
  | isAnswered asGiven && not (isAnswered setRight) && abs angle <= mostTilt = asGiven
  | certaintyOf setRight > certaintyOf asGiven = setRight
  | otherwise = asGiven
  where
    certaintyOf = certainty . recognisedSymbols
    isAnswered = isRight . recognisedAnswer

-- | Symbols that are turned by no more than this, in degrees, are still read as they are without
-- error, if not as often.
mostTilt :: Double
mostTilt = 7

-- | What was recognised in composites that were set upright by an angle, as of the composites as
-- they were given, by where the places of the one are on the other.
relocated :: Double -> [(Double, Double) -> (Double, Double)] -> Recognition -> Recognition
relocated angle places recognition =
  recognition
    { recognisedSymbols = map symbol (recognisedSymbols recognition),
      recognisedParts = map symbol (recognisedParts recognition),
      recognisedCells = Map.map (map symbol) (recognisedCells recognition),
      recognisedTilt = angle + recognisedTilt recognition,
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

-- | The symbols with the tilt of their grid in their axes, which were cut out along the
-- composites'.
axesTilted :: Recognition -> Recognition
axesTilted recognition =
  recognition
    { recognisedSymbols = map tilted (recognisedSymbols recognition),
      recognisedParts = map tilted (recognisedParts recognition)
    }
  where
    tilted s = s {readImage = (readImage s) {symbolAxis = symbolAxis (readImage s) + by}}
    by = recognisedTilt recognition

-- | By how many degrees, clockwise and in [0, 360), the face is turned as the composites show it,
-- given the orientation that was found.
recognisedAngle :: Recognition -> Symmetry -> Double
recognisedAngle recognition orientation
  | angle < 0 = angle + 360
  | angle >= 360 = angle - 360
  | otherwise = angle
  where
    angle = degreesClockwise orientation + recognisedTilt recognition

-- | How probable it is that frames lie otherwise, and then show something else.
data Misplaced = Misplaced
  { -- | one of them
    oneMisplaced :: !Double,
    -- | all, along other axes or at another scale
    axesMisplaced :: !Double,
    -- | some, by a slip
    slipped :: !Double,
    -- | the likeliest other layout of all frames, where it is more probable than the robot's
    likelierLayout :: Maybe Contradiction
  }
  deriving stock (Eq, Show)

-- | The recognition where its frames may lie otherwise. Beyond the doubt that is tolerated, it is
-- refused.
doubting :: Tolerance -> Misplaced -> Recognition -> Recognition
doubting _ (Misplaced 0 0 0 _) recognition = recognition
doubting tolerance (Misplaced stitched axes slip layout) recognition =
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
                doubtsOfOrigin = foreignBut (1 - put) (doubtsOfOrigin (supportDoubts support))
              }
        }
