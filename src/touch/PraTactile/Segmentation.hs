-- | Segmentation (the paper's section IV): a composite tactile image to the 8 wide x 12 tall images
-- of the symbols that lie wholly in it, each with its position and its axes.
module PraTactile.Segmentation
  ( -- * Symbols
    SymbolImage (..),

    -- * Segmentation
    segment,
    Segmentation (..),
    Reject (..),
    Cause (..),

    -- * On the side
    onComposite,
    segmentAlong,

    -- * What is none of the symbols'
    cleaned,
    Cleaned (..),

    -- * Parts of symbols
    Part (..),
    partAt,
    leastSeen,
    leastTouched,
  )
where

import PraTactile.Segmentation.Along (onComposite, segmentAlong)
import PraTactile.Segmentation.Foreign (Cleaned (..), cleaned)
import PraTactile.Segmentation.Part (Part (..), leastSeen, partAt)
import PraTactile.Segmentation.Symbol
import PraTactile.Segmentation.Upright (leastTouched, segment)
