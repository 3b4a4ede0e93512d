{-# LANGUAGE OverloadedStrings #-}

-- | The numbers of the protocol in JSON. A count or a code is written as an integer or as a
-- decimal string: @2@ or @"2"@, but neither @2.0@ nor @true@. A value of the right form may still
-- be refused under a profile, such as a code that is too large.
module PraTactile.Conformance.Forms
  ( natural,
    integer,
    readWhole,
    exact,
    shapeForm,
    positionForm,
    alone,
    ofAtLeast,
  )
where

import Data.Aeson (Key, Value (..), (.=))
import Data.Char (isDigit)
import Data.Ratio (denominator, numerator)
import Data.Scientific (base10Exponent, coefficient)
import Data.Text (Text)
import qualified Data.Text as Text
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Conformance.Wire.Line (mostDigits)
import PraTactile.Format.Error (Misfit (NotExact, NotInteger, NotNatural))
import PraTactile.Format.Json (integerValue, naturalValue)
import PraTactile.Format.Json.Codec hiding (integer, natural)
import qualified PraTactile.Format.Json.Schema as Schema

-- | A natural number of at most 'mostDigits' digits.
natural :: Codec Natural
natural =
  Codec
    ( Schema.Named "read-natural" $
        Schema.Described "A natural number in either form, as the program reads it." Schema.Natural
    )
    naturalValue
    $ \value -> case readWhole value of
      Just i | i >= 0 -> Right (fromInteger i)
      _ -> refuse NotNatural

-- | An integer of at most 'mostDigits' digits.
integer :: Codec Integer
integer =
  Codec
    ( Schema.Named "read-integer" $
        Schema.Described "An integer in either form, as the program reads it." Schema.Integer
    )
    integerValue
    (maybe (refuse NotInteger) Right . readWhole)

-- | A whole number, written as an integer or as a decimal string of at most 'mostDigits' digits. A
-- JSON number with a fraction or an exponent is refused, whatever its value.
-- "PraTactile.Conformance.Wire.Line" reads texts so that the notation is known here.
readWhole :: Value -> Maybe Integer
readWhole value = case value of
  Number n | base10Exponent n == 0 -> Just (coefficient n)
  String given
    | Just digits <- Text.stripPrefix "-" given -> negate <$> decimal digits
    | otherwise -> decimal given
  _ -> Nothing
  where
    decimal digits
      | not (Text.null digits),
        Text.all isDigit digits,
        Text.compareLength digits mostDigits /= GT =
        Just (read (Text.unpack digits))
      | otherwise = Nothing

-- | An exact number: a text of an integer, or of two integers with a slash between.
exact :: Codec Rational
exact = withSchema (const schema) (via written fraction text)
  where
    schema =
      Schema.Named "exact"
        . Schema.Described "A number as a text: an integer, or two with a slash between."
        $ Schema.Text ["pattern" .= ("^-?[0-9]+(/[0-9]+)?$" :: Text)]
    written x =
      show (numerator x) ++ (if denominator x == 1 then "" else '/' : show (denominator x))
    fraction given = case Text.splitOn "/" (Text.pack given) of
      [whole] -> fromInteger <$> readValue integer (String whole)
      [over, under] -> do
        n <- readValue integer (String over)
        d <- readValue natural (String under)
        if d > 0 then Right (fromInteger n / fromIntegral d) else refuse NotExact
      _ -> refuse NotExact

-- | A shape as a list of two numbers: rows and columns.
shapeForm :: Codec Shape
shapeForm = via (\(Shape high wide) -> (high, wide)) (Right . uncurry Shape) (pairOf natural)

-- | A position as @{"row": r, "column": c}@.
positionForm :: Codec Position
positionForm =
  withSchema (Schema.Named "read-position") $
    object (Position <$> key "row" natural row <*> key "column" natural column)

-- | An object with a single key.
alone :: Key -> Codec a -> Codec a
alone name codec = object (key name codec id)

-- | Adds a least length to the schema of a list.
ofAtLeast :: Int -> Codec [a] -> Codec [a]
ofAtLeast n = withSchema $ \schema -> case schema of
  Schema.List bounds item -> Schema.List ("minItems" .= n : bounds) item
  other -> other
