-- | Segmentation (the paper's section IV): cuts the symbols that lie wholly in a composite into
-- images 8 wide and 12 tall, each with its position and its axes.
module PraTactile.Segmentation
  ( -- * Symbols
    SymbolImage (..),

    -- * Segmentation
    segment,
    Segmentation (..),
    Reject (..),
    Cause (..),

    -- * Along an axis
    onComposite,
    segmentAlong,

    -- * Foreign regions
    maskForeign,
    ForeignMasked (..),

    -- * Parts of symbols
    Part (..),
    partAt,
    leastSeen,
    leastTouched,
  )
where

import PraTactile.Segmentation.Along (onComposite, segmentAlong)
import PraTactile.Segmentation.Foreign (ForeignMasked (..), maskForeign)
import PraTactile.Segmentation.Part (Part (..), leastSeen, partAt)
import PraTactile.Segmentation.Symbol
import PraTactile.Segmentation.Upright (leastTouched, segment)
