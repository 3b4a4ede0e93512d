-- | Reads decimal numbers as people and programs write them. All files, options and names are read
-- through this module.
--
-- A number is an optional sign, then digits with at most one point before, among or after them,
-- then an optional exponent: @.5@, @1.@, @+1@, @-1.25e3@. Forms of other languages are refused:
-- @0x10@, @1_000@, spaces, digits other than 0 to 9.
module PraTactile.Decimal
  ( -- * Decimal numbers
    Decimal (..),
    NotDecimal (..),
    readDecimal,
    longestDecimal,

    -- * As other numbers
    inReach,
    exactDecimal,
    nearestDouble,

    -- * Readers
    readDouble,
    readFraction,
    readExact,
    readWhole,
    asciiOf,
  )
where

import Control.Monad ((>=>))
import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Char8
import Data.Char (isAscii, isDigit, toLower)

-- | An integer times a power of 10.
data Decimal = Decimal
  { -- | it does not end in the digit 0, unless it is 0
    decimalCoefficient :: !Integer,
    -- | the number of digits of the coefficient; 0 for the coefficient 0
    decimalDigits :: !Int,
    -- | the exponent of 10; 0 for the coefficient 0
    decimalExponent :: !Integer
  }
  deriving stock (Eq, Show)

-- | Why a text is not accepted as a number.
data NotDecimal
  = -- | It is not a number.
    Malformed
  | -- | It is infinity or not-a-number, as machines write these.
    Infinite
  | -- | It has more than 'longestDecimal' characters, is 10^300 or more, or has more than 400
    -- decimal places.
    OutOfReach
  deriving stock (Eq, Show)

-- | The most characters of a number that is read: 1000.
longestDecimal :: Int
longestDecimal = 1000

-- | Reads a decimal number of at most 'longestDecimal' characters, with an exponent of any size.
--
-- >>> readDecimal (asciiOf "-12.50e3")
-- Right (Decimal {decimalCoefficient = -125, decimalDigits = 3, decimalExponent = 2})
readDecimal :: ByteString -> Either NotDecimal Decimal
readDecimal text
  | Char8.length text > longestDecimal =
    Left (if Char8.all (`elem` "+-.0123456789eE") text then OutOfReach else Malformed)
  | Char8.null (before <> after) = Left notFinite
  | Just power <- exponentOf rest = Right (decimal power)
  | otherwise = Left Malformed
  where
    (negative, unsigned) = signOf text
    (before, fraction) = Char8.span isDigit unsigned
    (after, rest) = case Char8.uncons fraction of
      Just ('.', others) -> Char8.span isDigit others
      _ -> (Char8.empty, fraction)
    notFinite
      | Char8.map toLower unsigned `elem` map Char8.pack machineWords = Infinite
      | otherwise = Malformed
    machineWords = ["nan", "inf", "infinity", "nan(ind)", "1.#inf", "1.#qnan", "1.#ind"]
    decimal power
      | Char8.null significant = Decimal 0 0 0
      | otherwise =
        Decimal
          (if negative then negate magnitude else magnitude)
          (Char8.length significant)
          (power + toInteger (Char8.length digits - Char8.length trimmed - Char8.length after))
      where
        digits = before <> after
        trimmed = Char8.dropWhileEnd (== '0') digits
        significant = Char8.dropWhile (== '0') trimmed
        magnitude = digitsValue significant

-- | Reads the exponent after the digits, 0 if nothing follows; 'Nothing' for any other text.
exponentOf :: ByteString -> Maybe Integer
exponentOf text = case Char8.uncons text of
  Nothing -> Just 0
  Just (e, power) | e == 'e' || e == 'E' -> readWhole power
  _ -> Nothing

-- | Whether a text begins with a minus, and the text after its sign.
signOf :: ByteString -> (Bool, ByteString)
signOf text = case Char8.uncons text of
  Just ('-', rest) -> (True, rest)
  Just ('+', rest) -> (False, rest)
  _ -> (False, text)

-- | The number with these digits; 0 without digits.
digitsValue :: ByteString -> Integer
digitsValue = maybe 0 fst . Char8.readInteger

-- | Refuses numbers of 10^300 or more, and those with more than 400 decimal places.
inReach :: Decimal -> Either NotDecimal Decimal
inReach number
  | decimalExponent number < -400 = Left OutOfReach
  | decimalExponent number + toInteger (decimalDigits number) > 300 = Left OutOfReach
  | otherwise = Right number

-- | The exact value of a decimal number. Refuses what 'inReach' refuses.
exactDecimal :: Decimal -> Either NotDecimal Rational
exactDecimal = fmap power . inReach
  where
    power (Decimal n _ e) = fromInteger n * 10 ^^ e

-- | The nearest machine number; infinite if the number is too large for one.
nearestDouble :: Decimal -> Double
nearestDouble (Decimal n digits e)
  | magnitude > 310 = fromInteger (signum n) / 0
  | magnitude < -400 = 0
  | otherwise = fromRational (fromInteger n * 10 ^^ e)
  where
    magnitude = e + toInteger digits

-- | Reads a decimal number as the nearest machine number. A number too large for one is
-- 'OutOfReach'.
--
-- >>> map (readDouble . asciiOf) [".5", "1.", "+1", "-2.5e-1"]
-- [Right 0.5,Right 1.0,Right 1.0,Right (-0.25)]
-- >>> map (readDouble . asciiOf) ["1e309", "0x10", "nan"]
-- [Left OutOfReach,Left Malformed,Left Infinite]
readDouble :: ByteString -> Either NotDecimal Double
readDouble = readDecimal >=> finite . nearestDouble
  where
    finite value = if isInfinite value then Left OutOfReach else Right value

-- | Reads a decimal number that is 'inReach', or a quotient of two, such as @127/4@. In a quotient,
-- whole numbers may have as many digits as 'longestDecimal'.
readFraction :: ByteString -> Either NotDecimal Rational
readFraction text = case Char8.split '/' text of
  [one] -> exactly one
  [over, under] -> do
    n <- part over
    d <- part under
    if d == 0 then Left Malformed else Right (n / d)
  _ -> Left Malformed
  where
    exactly = readDecimal >=> exactDecimal
    part side
      | Char8.length side <= longestDecimal, Just n <- readWhole side = Right (fromInteger n)
      | otherwise = exactly side

-- | The exact value of a text that is a fraction or a decimal number.
--
-- >>> map readExact ["127/4", "1e-2", ".5", "x"]
-- [Just (127 % 4),Just (1 % 100),Just (1 % 2),Nothing]
readExact :: String -> Maybe Rational
readExact = either (const Nothing) Just . readFraction . asciiOf

-- | Reads a whole number: digits with an optional sign.
--
-- >>> map (readWhole . asciiOf) ["12", "+1", "-03", "1.", ""]
-- [Just 12,Just 1,Just (-3),Nothing,Nothing]
readWhole :: ByteString -> Maybe Integer
readWhole text
  | Char8.null digits || not (Char8.all isDigit digits) = Nothing
  | otherwise = Just ((if negative then negate else id) (digitsValue digits))
  where
    (negative, digits) = signOf text

-- | A text as bytes for these readers. A character beyond ASCII becomes @?@; neither occurs in a
-- number.
asciiOf :: String -> ByteString
asciiOf = Char8.pack . map (\c -> if isAscii c then c else '?')
