-- | The shapes that the questions of touch are about, and that scenes are drawn with.
module PraTactile.Conformance.Shapes
  ( agreedAlphabet,
    agreedReader,
    knownAlphabets,
    drawingsOf,
  )
where

import qualified Data.Text as Text
import PraTactile.Classification.Reader (Reader)
import PraTactile.Classification.Shipped
  ( ShippedError,
    shippedAlphabet,
    shippedReader,
    shippedSizes,
  )
import PraTactile.Conformance.Question (Drawings)
import PraTactile.Shape (Alphabet, drawBitmap, shapes)

-- | Those for GF(4): the protocol names them by their file, @data/shapes.txt@.
agreedAlphabet :: Either ShippedError Alphabet
agreedAlphabet = shippedAlphabet 4

-- | What their symbols are read with.
agreedReader :: Either ShippedError Reader
agreedReader = shippedReader 4

-- | All that are shipped, by the number of classes.
knownAlphabets :: [(Int, Alphabet)]
knownAlphabets = [(q, known) | q <- shippedSizes, Right known <- [shippedAlphabet q]]

-- | As a question has them.
drawingsOf :: Alphabet -> Drawings
drawingsOf = map (map Text.unpack . Text.lines . drawBitmap) . shapes
