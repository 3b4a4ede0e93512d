-- | What is embossed or sunk in a composite and is no complete symbol.
module PraTactile.Segmentation.Reject
  ( Reject (..),
    Cause (..),
    causeName,
  )
where

-- | Something that is no complete symbol: its box (left, top, right, bottom, in pixels), and why.
data Reject = Reject !(Double, Double, Double, Double) !Cause
  deriving stock (Eq, Show)

-- | Why something is no complete symbol.
data Cause
  = -- | It is too small and reaches the edge of what was touched.
    CutOff
  | -- | Its box is not of a symbol's size.
    WrongSize
  | -- | It is embossed, and longer than any symbol: a bar, a rim, a plateau.
    TooLarge
  | -- | It lies deeper than the background: a hole, or what is beyond the object's edge.
    Hollow
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | The stable name of a cause.
causeName :: Cause -> String
causeName cause = case cause of
  CutOff -> "cut-off"
  WrongSize -> "wrong-size"
  TooLarge -> "too-large"
  Hollow -> "hollow"
