{-# OPTIONS_HADDOCK hide #-}

-- | What segmentation finds in a composite: complete symbols, and what is embossed or sunk and is
-- none.
module PraTactile.Segmentation.Symbol
  ( -- * Symbols
    SymbolImage (..),

    -- * What is no complete symbol
    Reject (..),
    Cause (..),
    causeName,

    -- * Both
    Segmentation (..),
  )
where

import PraTactile.Image (Raster)

-- | One symbol found in a composite.
data SymbolImage = SymbolImage
  { -- | The centre of its box, x and y in the composite's pixels.
    symbolCentre :: !(Double, Double),
    -- | 8 x 12 taxels, resampled along the symbol's axis from its box: background 0, embossing
    -- about 1, not clipped.
    symbolPixels :: !Raster,
    -- | The direction of its x axis, degrees clockwise from the composite's, up to a half turn,
    -- which only recognising the symbol decides. Upright boxes: 0; boxes on their side: 90.
    symbolAxis :: !Double,
    -- | The width and height that were measured, in pixels.
    symbolSize :: !(Double, Double)
  }
  deriving stock (Eq, Show)

-- | Something that is no complete symbol: its box (left, top, right, bottom, in pixels), and why.
data Reject = Reject !(Double, Double, Double, Double) !Cause
  deriving stock (Eq, Show)

-- | Why something is no complete symbol.
data Cause
  = -- | It reaches the edge of what was touched, and is too small, or too little of its box was
    -- touched.
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

-- | What a composite holds.
data Segmentation = Segmentation
  { -- | The complete symbols, from left to right.
    segmentedSymbols :: ![SymbolImage],
    segmentedRejects :: ![Reject],
    -- | The background's intensity; 0 when nothing embossed was found.
    segmentedBackground :: !Double,
    -- | The embossing's intensity above the background's; likewise.
    segmentedContrast :: !Double
  }
  deriving stock (Eq, Show)
