{-# OPTIONS_HADDOCK hide #-}

-- | The results of segmentation: complete symbols, and embossed or sunken regions that are not
-- symbols.
module PraTactile.Segmentation.Symbol
  ( -- * Symbols
    SymbolImage (..),

    -- * Rejected regions
    Reject (..),
    Cause (..),
    causeName,

    -- * The result
    Segmentation (..),
  )
where

import PraTactile.Image (Raster)

-- | One symbol found in a composite.
data SymbolImage = SymbolImage
  { -- | The centre of its box, x and y in the composite's pixels.
    symbolCentre :: !(Double, Double),
    -- | 8 x 12 taxels, resampled from its box along the symbol's axis: background 0, embossing
    -- about 1, not clipped.
    symbolPixels :: !Raster,
    -- | The direction of its x axis, in degrees clockwise from the composite's: 0 for upright
    -- boxes, 90 for boxes on their side. It is determined up to a half turn; only recognition
    -- decides which way up the symbol is.
    symbolAxis :: !Double,
    -- | The measured width and height, in pixels.
    symbolSize :: !(Double, Double)
  }
  deriving stock (Eq, Show)

-- | A region that is not a complete symbol: its box (left, top, right, bottom, in pixels) and the
-- reason.
data Reject = Reject !(Double, Double, Double, Double) !Cause
  deriving stock (Eq, Show)

-- | Why a region is not a complete symbol.
data Cause
  = -- | It reaches the edge of the touched pixels and is too small, or too little of its box was
    -- touched.
    CutOff
  | -- | Its box is not of a symbol's size.
    WrongSize
  | -- | It is embossed and longer than any symbol: a bar, a rim or a plateau.
    TooLarge
  | -- | It lies below the background: a hole, or beyond the object's edge.
    Hollow
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | The stable name of a cause.
causeName :: Cause -> String
causeName cause = case cause of
  CutOff -> "cut-off"
  WrongSize -> "wrong-size"
  TooLarge -> "too-large"
  Hollow -> "hollow"

-- | The result of segmenting a composite.
data Segmentation = Segmentation
  { -- | The complete symbols, from left to right.
    segmentedSymbols :: ![SymbolImage],
    segmentedRejects :: ![Reject],
    -- | The intensity of the background; 0 if nothing embossed was found.
    segmentedBackground :: !Double,
    -- | The difference of embossing and background; 0 if nothing embossed was found.
    segmentedContrast :: !Double
  }
  deriving stock (Eq, Show)
