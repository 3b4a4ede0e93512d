-- | The meaning of embossed symbols, where touch and code meet: class @c@ of the alphabet stands
-- for the field element with code @c@ (the paper's section II.B, figure 3).
module PraTactile.Symbol
  ( elementOfClass,
    classOfElement,
  )
where

import PraTactile.Field (FieldError, GF, KnownField, fromCode, toCode)

-- | The field element that a symbol of this class stands for; refuses a class outside @0 .. q - 1@.
elementOfClass :: KnownField k => Int -> Either FieldError (GF k)
elementOfClass = fromCode

-- | The class of the symbol that is embossed for this element.
classOfElement :: GF k -> Int
classOfElement = toCode
