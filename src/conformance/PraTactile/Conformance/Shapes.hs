-- | The shapes that the questions of touch are about, and that scenes are drawn with.
module PraTactile.Conformance.Shapes
  ( agreedAlphabet,
  )
where

import PraTactile.Classification.Shipped (ShippedError, shippedAlphabet)
import PraTactile.Shape (Alphabet)

-- | Those for GF(4): the protocol names them by their file, @data/shapes.txt@.
agreedAlphabet :: Either ShippedError Alphabet
agreedAlphabet = shippedAlphabet 4
