-- | Numbers of files as exactly what they are: decimal numbers as integers times a power of 10,
-- machine numbers as integers times a power of 2.
module PraTactile.Format.Solid.Number
  ( -- * Reading
    Number (..),
    decimal,
    machine,
    whole,
    fraction,
    exactNumber,
    Base (..),
    overCommon,

    -- * Writing
    exactText,
    decimalText,
  )
where

import Control.Applicative ((<|>))
import qualified Data.Attoparsec.ByteString.Char8 as Parse
import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Char8
import Data.Char (isAscii, toLower)
import Data.Ratio (denominator, numerator, (%))
import Data.Scientific (base10Exponent, coefficient, normalize)
import qualified Data.Scientific as Scientific
import qualified Data.Vector as V
import Math.NumberTheory.Logarithms (integerLog10, integerLog2)
import PraTactile.Format.Solid.Error
import PraTactile.Object.Vector

-- | An integer, times a power of the base.
data Number = Number !Integer !Int
  deriving stock (Eq, Show)

-- | Of what exponents are.
data Base = Decimal | Binary
  deriving stock (Eq, Show)

-- | A decimal number, such as @-1.25e3@.
decimal :: ByteString -> Either Fault Number
decimal text
  | Char8.length text > longest =
    Left (if Char8.all (`elem` "+-.0123456789eE") text then TooLargeOrFine else NotNumber)
  | otherwise = case Parse.parseOnly (Parse.scientific <* Parse.endOfInput) text of
    Right value -> bounded (normalize value)
    Left _
      | Char8.map toLower (Char8.dropWhile (`elem` "+-") text) `elem` notFinite -> Left NotFinite
      | otherwise -> Left NotNumber
  where
    notFinite = map Char8.pack ["nan", "inf", "infinity", "nan(ind)", "1.#inf", "1.#qnan", "1.#ind"]
    bounded value
      | coefficient value == 0 = Right (Number 0 0)
      | base10Exponent value < -400 || base10Exponent value > 300 = Left TooLargeOrFine
      | base10Exponent value + integerLog10 (abs (coefficient value)) >= 300 = Left TooLargeOrFine
      | otherwise = Right (Number (coefficient value) (base10Exponent value))

-- | No number that is read has more characters.
longest :: Int
longest = 1000

-- | A machine number.
machine :: RealFloat a => a -> Either Fault Number
machine value
  | isNaN value || isInfinite value = Left NotFinite
  | otherwise = Right (Number mantissa exponent')
  where
    (mantissa, exponent') = decodeFloat value

-- | A whole number, of at most 18 digits.
whole :: ByteString -> Either Fault Int
whole text = case Char8.readInt (Char8.take 19 (Char8.dropWhile (== '+') text)) of
  Just (n, rest) | Char8.null rest, Char8.length text <= 18 -> Right n
  _ -> Left NotNumber

-- | A fraction, such as @127/4@, or a decimal number.
fraction :: ByteString -> Either Fault Rational
fraction text = case Char8.split '/' text of
  [one] -> rational <$> decimal one
  [over, under] -> do
    n <- integer over
    d <- integer under
    if d == 0 then Left NotNumber else Right (n % d)
  _ -> Left NotNumber
  where
    rational (Number n e) = if e >= 0 then fromInteger (n * 10 ^ e) else n % (10 ^ negate e)
    integer digits
      | Char8.length digits > longest = Left TooLargeOrFine
      | otherwise =
        either (const (Left NotNumber)) Right (Parse.parseOnly signed digits)
    signed = (Parse.signed Parse.decimal <|> Parse.decimal) <* Parse.endOfInput

-- | An exact number as 'exactText' writes it, or any fraction or decimal number.
--
-- >>> map exactNumber ["127/4", "1e-2", "x"]
-- [Just (127 % 4),Just (1 % 100),Nothing]
exactNumber :: String -> Maybe Rational
exactNumber text
  | all isAscii text = either (const Nothing) Just (fraction (Char8.pack text))
  | otherwise = Nothing

-- | Points as integers over their common denominator.
overCommon :: Base -> V.Vector (Number, Number, Number) -> (Integer, V.Vector V3)
overCommon base points = (power places, V.map point points)
  where
    places =
      negate
        ( V.foldl'
            (\least (a, b, c) -> least `min` of' a `min` of' b `min` of' c)
            0
            points
        )
    of' (Number n e) = if n == 0 then 0 else e
    point (a, b, c) = V3 (times a) (times b) (times c)
    times (Number n e) = if n == 0 then 0 else n * power (e + places)
    power k = case base of
      Decimal -> 10 ^ k
      Binary -> 2 ^ k

-- | A fraction as it is read again: a decimal number where it is one of few digits.
--
-- >>> map exactText [31.75, 1 / 3, -2]
-- ["31.75","1/3","-2"]
exactText :: Rational -> String
exactText value
  | Just text <- decimalText value, length text <= 40 = text
  | otherwise = show (numerator value) ++ "/" ++ show (denominator value)

-- | A fraction as a decimal number, where it is one.
decimalText :: Rational -> Maybe String
decimalText value
  | denominator value == 1 = Just (show (numerator value))
  | otherwise = case Scientific.fromRationalRepetendLimited
    (integerLog2 (denominator value) + 1)
    value of
    Right (exact, Nothing) -> Just (Scientific.formatScientific Scientific.Fixed Nothing exact)
    _ -> Nothing
