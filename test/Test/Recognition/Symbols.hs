-- | Symbols as recognition has them, made by hand.
module Test.Recognition.Symbols
  ( symbolOf,
  )
where

import PraTactile.Image (constant)
import PraTactile.Recognise.Reading (ReadSymbol (..))
import PraTactile.Segmentation (SymbolImage (..))
import PraTactile.Symmetry

-- | A symbol with this number at this place of the first composite, with this orientation and
-- class, known to the network.
symbolOf :: Int -> (Double, Double) -> (Symmetry, Int) -> ReadSymbol
symbolOf n place what =
  ReadSymbol
    { readNumber = n,
      readSource = 0,
      readImage = SymbolImage place (constant 8 12 0) 0 (8, 12),
      readAt = place,
      readClass = Just what,
      readSeen = 1,
      readLikeliest = what,
      readChances = [(what, 1)],
      readForeignShape = -10
    }
