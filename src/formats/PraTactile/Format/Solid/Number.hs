{-# OPTIONS_HADDOCK hide #-}

-- | Exact numbers of files: decimal numbers are integers times a power of 10, machine numbers are
-- integers times a power of 2.
module PraTactile.Format.Solid.Number
  ( -- * Reading
    Number (..),
    decimal,
    machine,
    whole,
    Base (..),
    overCommon,

    -- * Writing
    exactText,
    decimalText,
  )
where

import Data.Bifunctor (first)
import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Char8
import Data.Ratio (denominator, numerator)
import qualified Data.Scientific as Scientific
import qualified Data.Vector as V
import Math.NumberTheory.Logarithms (integerLog2)
import PraTactile.Decimal hiding (Decimal (Decimal))
import PraTactile.Format.Solid.Error
import PraTactile.Object.Vector

-- | The product of an integer and a power of the base: the integer, and the power's exponent.
data Number = Number !Integer !Int
  deriving stock (Eq, Show)

-- | The base of a number's power: 10 or 2.
data Base = Decimal | Binary
  deriving stock (Eq, Show)

-- | Reads a decimal number, such as @-1.25e3@. Refuses other texts ('NotNumber'), numbers beyond
-- any range ('NotFinite'), and numbers that are not 'inReach' ('TooLargeOrFine').
decimal :: ByteString -> Either Fault Number
decimal text = first fault $ do
  number <- readDecimal text >>= inReach
  Right (Number (decimalCoefficient number) (fromInteger (decimalExponent number)))
  where
    fault why = case why of
      Malformed -> NotNumber
      Infinite -> NotFinite
      OutOfReach -> TooLargeOrFine

-- | A machine number exactly. Refuses NaN and infinities.
machine :: RealFloat a => a -> Either Fault Number
machine value
  | isNaN value || isInfinite value = Left NotFinite
  | otherwise = Right (Number mantissa exponent')
  where
    (mantissa, exponent') = decodeFloat value

-- | Reads an integer, with or without a sign, of at most 18 characters.
whole :: ByteString -> Either Fault Int
whole text = case readWhole text of
  Just n | Char8.length text <= 18 -> Right (fromInteger n)
  _ -> Left NotNumber

-- | The common denominator of points whose numbers have this base, a power of it; and the points'
-- coordinates times the denominator.
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

-- | A fraction as text: a decimal number if that is exact and has at most 40 characters, otherwise
-- a quotient.
--
-- >>> map exactText [31.75, 1 / 3, -2]
-- ["31.75","1/3","-2"]
exactText :: Rational -> String
exactText value
  | Just text <- decimalText value, length text <= 40 = text
  | otherwise = show (numerator value) ++ "/" ++ show (denominator value)

-- | A fraction as a decimal number, if that is exact.
decimalText :: Rational -> Maybe String
decimalText value
  | denominator value == 1 = Just (show (numerator value))
  | otherwise = case Scientific.fromRationalRepetendLimited
    (integerLog2 (denominator value) + 1)
    value of
    Right (exact, Nothing) -> Just (Scientific.formatScientific Scientific.Fixed Nothing exact)
    _ -> Nothing
