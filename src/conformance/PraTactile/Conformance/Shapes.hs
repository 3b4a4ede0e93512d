-- | The symbol shapes of questions about touch and of drawn scenes.
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

-- | The shapes for GF(4), which the protocol names by their file, @data/shapes.txt@.
agreedAlphabet :: Either ShippedError Alphabet
agreedAlphabet = shippedAlphabet 4

-- | The reader of these symbols.
agreedReader :: Either ShippedError Reader
agreedReader = shippedReader 4

-- | All shipped alphabets, by the number of classes.
knownAlphabets :: [(Int, Alphabet)]
knownAlphabets = [(q, known) | q <- shippedSizes, Right known <- [shippedAlphabet q]]

-- | The shapes of an alphabet in the form of questions.
drawingsOf :: Alphabet -> Drawings
drawingsOf = map (map Text.unpack . Text.lines . drawBitmap) . shapes
