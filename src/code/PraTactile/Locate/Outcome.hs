{-# LANGUAGE DerivingStrategies #-}

-- | What a road from observed cells to their position answers, and why it refuses. Every road
-- answers in these terms: the table, the search, and the algebra.
module PraTactile.Locate.Outcome
  ( -- * Outcomes
    Outcome (..)

    -- * Reasons
  , Reason (..)
  , reasonName
  , reasons
  ) where

import Numeric.Natural (Natural)
import PraTactile.Grid (Position)

-- | What is known of a patch's place. Positions are those of its upper left cell, observed or not.
data Outcome
  = -- | The only position that agrees with every observed cell; and the offsets in the patch of the
    -- complete windows that say so.
    Located Position [Position]
  | -- | All positions, two or more, that agree with every observed cell; and the offsets as above.
    Ambiguous [Position] [Position]
  | -- | So many positions agree with every observed cell, too many to list. They are the powers of
    -- alpha in a coset of a space over GF(q) of this dimension, the second number. Of the sheet that is
    -- those of the torus that it is cut from; two of them at least lie on it.
    AmbiguousCoset Natural Natural
  | -- | No position, and why.
    Refused Reason
  deriving stock (Eq, Show)

-- | Why a patch has no position. The list is closed; 'reasonName' is the name for other programs.
data Reason
  = -- | Every complete window is all zeros, which occurs nowhere: @zero-window@.
    ZeroWindow
  | -- | Fewer cells are observed than a window has: @too-few-cells@.
    TooFewCells
  | -- | Enough cells are observed, but no window is complete: @no-complete-window@.
    NoCompleteWindow
  | -- | No complete window occurs on the surface: @not-in-array@.
    NotInArray
  | -- | The windows, or the windows and other observed cells, do not fit one place: @contradiction@.
    Contradiction
  | -- | What lies on the sheet fits one place, but there the patch's upper left or an observed cell
    -- lies beyond the edge: @off-sheet@.
    OffSheet
  | -- | No position differs from the patch in as few cells as may be corrected: @beyond-radius@.
    BeyondRadius
  | -- | The likeliest position is not likely enough: @below-threshold@.
    BelowThreshold
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | The name of a reason in files and on the wire.
reasonName :: Reason -> String
reasonName reason = case reason of
  ZeroWindow -> "zero-window"
  TooFewCells -> "too-few-cells"
  NoCompleteWindow -> "no-complete-window"
  NotInArray -> "not-in-array"
  Contradiction -> "contradiction"
  OffSheet -> "off-sheet"
  BeyondRadius -> "beyond-radius"
  BelowThreshold -> "below-threshold"

-- | All reasons.
reasons :: [Reason]
reasons = [minBound .. maxBound]
