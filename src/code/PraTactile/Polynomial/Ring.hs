{-# OPTIONS_HADDOCK hide #-}

-- | The ring of polynomials over GF(q). Internal; "PraTactile.Polynomial" exports it.
module PraTactile.Polynomial.Ring
  ( Polynomial,
    polynomial,
    polynomialFromCodes,
    coefficients,
    constant,
    variable,
    polynomialDegree,
    leadingCoefficient,
    isMonic,
    valueAt,
    quotientRemainder,
    greatestCommonDivisor,
    bezout,
    normalising,
    powerModulo,
    modulusOf,
    fromResidue,
  )
where

import Data.List (dropWhileEnd)
import Data.Maybe (listToMaybe)
import Data.Ord (comparing)
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Field
import PraTactile.Polynomial.Modulus

-- | A polynomial over the field k: its coefficients, constant term first; the last one is nonzero.
-- 'Ord' compares degrees, then the coefficients from the highest degree down.
newtype Polynomial (k :: Field) = Polynomial [GF k]
  deriving stock (Eq)

type role Polynomial nominal

instance Ord (Polynomial k) where
  compare = comparing (\(Polynomial cs) -> (length cs, reverse cs))

instance KnownField k => Show (Polynomial k) where
  showsPrec d (Polynomial cs) = showParen (d > 10) (showString "polynomial " . shows cs)

-- | 'fromInteger' gives the constants that are images of integers; 'abs' is the identity and
-- 'signum' is 1 except at 0. Products take O(n^2).
instance KnownField k => Num (Polynomial k) where
  Polynomial a + Polynomial b = polynomial (zipLong (+) a b)
  Polynomial a - Polynomial b = polynomial (zipLong (-) a b)
  Polynomial a * Polynomial b =
    polynomial (foldr (\x rest -> zipLong (+) (map (x *) b) (zero : rest)) [] a)
  negate (Polynomial a) = Polynomial (map negate a)
  abs = id
  signum (Polynomial a) = if null a then Polynomial [] else constant one
  fromInteger = constant . fromInteger

-- | Combines two lists coefficientwise; the shorter one is continued by zeros.
zipLong :: (GF k -> GF k -> GF k) -> [GF k] -> [GF k] -> [GF k]
zipLong f (a : as) (b : bs) = f a b : zipLong f as bs
zipLong f [] bs = map (f zero) bs
zipLong f as [] = map (`f` zero) as

-- | The polynomial with these coefficients, constant term first; zeros at the end are dropped.
polynomial :: [GF k] -> Polynomial k
polynomial = Polynomial . dropWhileEnd (== zero)

-- | The polynomial whose coefficients have these codes, constant term first. Refuses codes not
-- below q.
polynomialFromCodes :: KnownField k => [Natural] -> Either FieldError (Polynomial k)
polynomialFromCodes = fmap polynomial . elementsFromCodes

-- | The coefficients, constant term first, the last one not zero; none for the zero polynomial.
coefficients :: Polynomial k -> [GF k]
coefficients (Polynomial cs) = cs

-- | The polynomial of degree 0 with this value, or the zero polynomial.
constant :: GF k -> Polynomial k
constant c = polynomial [c]

-- | The polynomial x.
variable :: Polynomial k
variable = Polynomial [zero, one]

-- | The degree; 'Nothing' for the zero polynomial. O(n).
polynomialDegree :: Polynomial k -> Maybe Int
polynomialDegree (Polynomial cs) = if null cs then Nothing else Just (length cs - 1)

-- | The coefficient of the highest degree; 'Nothing' for the zero polynomial. O(n).
leadingCoefficient :: Polynomial k -> Maybe (GF k)
leadingCoefficient (Polynomial cs) = listToMaybe (reverse cs)

-- | Whether the leading coefficient is 1.
isMonic :: Polynomial k -> Bool
isMonic a = leadingCoefficient a == Just one

-- | The quotient and the remainder, whose degree is below the divisor's. 'Nothing' exactly if the
-- divisor is zero. O(n d) for a quotient of degree d - 1.
quotientRemainder ::
  KnownField k =>
  Polynomial k ->
  Polynomial k ->
  Maybe (Polynomial k, Polynomial k)
quotientRemainder (Polynomial a) (Polynomial b) = case reverse b of
  [] -> Nothing
  leading : lower -> do
    inverted <- either (const Nothing) Just (inverse leading)
    let steps = length a - length lower
        (quotient, rest) = longDivision steps (map (inverted *) lower) (reverse a)
    pure (polynomial (reverse (map (inverted *) quotient)), polynomial (reverse rest))

-- | This number of steps of the division by a monic polynomial, given its lower coefficients. All
-- lists have the highest degree first.
longDivision :: KnownField k => Int -> [GF k] -> [GF k] -> ([GF k], [GF k])
longDivision steps lower a = case a of
  top : rest
    | steps > 0 ->
      let (quotient, remainder) =
            longDivision (steps - 1) lower (zipLong (-) rest (map (top *) lower))
       in (top : quotient, remainder)
  _ -> ([], a)

-- | The monic greatest common divisor, by Euclid's algorithm; zero if both are zero. It ends
-- because every remainder has a lower degree than the one before. O(n^2).
greatestCommonDivisor :: KnownField k => Polynomial k -> Polynomial k -> Polynomial k
greatestCommonDivisor a b = case quotientRemainder a b of
  Just (_, r) -> greatestCommonDivisor b r
  Nothing -> constant (normalising a) * a

-- | @bezout a b@ is (g, u, v), where g is the 'greatestCommonDivisor' of a and b, and u a + v b =
-- g. If neither a nor b is zero, u and v have the least possible degrees. O(n^2).
bezout :: KnownField k => Polynomial k -> Polynomial k -> (Polynomial k, Polynomial k, Polynomial k)
bezout a b = case quotientRemainder a b of
  -- From u b + v r = g and r = a - quotient b.
  Just (quotient, r) -> let (g, u, v) = bezout b r in (g, v, u - quotient * v)
  Nothing -> let c = constant (normalising a) in (c * a, c, 0)

-- | The inverse of the leading coefficient; 1 for the zero polynomial.
normalising :: KnownField k => Polynomial k -> GF k
normalising a = maybe one (either (const one) id . inverse) (leadingCoefficient a)

-- | The value at an element, by Horner's rule. O(n).
valueAt :: KnownField k => Polynomial k -> GF k -> GF k
valueAt (Polynomial cs) a = foldr (\c rest -> c + a * rest) zero cs

-- | @powerModulo h a e@ is a^e modulo h. 'Nothing' exactly if h is zero. O(n^2 (q + log e)), where
-- n is the degree of h; over GF(2), 64 coefficients are handled at once.
powerModulo :: KnownField k => Polynomial k -> Polynomial k -> Natural -> Maybe (Polynomial k)
powerModulo h a e
  | null (coefficients h) = Nothing
  | otherwise = Just (maybe 0 power' (modulusOf h))
  where
    power' modulus = fromResidue (powerOf modulus (residueFrom modulus (coefficients a)) e)

-- | The arithmetic modulo a polynomial. 'Nothing' for the zero polynomial, and for degree 0, where
-- all residues are 0.
modulusOf :: KnownField k => Polynomial k -> Maybe (Modulus k)
modulusOf h = case reverse (map (normalising h *) (coefficients h)) of
  _ : upper@(_ : _) -> Just (modulusFrom (map negate (reverse upper)))
  _ -> Nothing

-- | The representative of lowest degree of a residue.
fromResidue :: Coefficients k -> Polynomial k
fromResidue = polynomial . Primitive.toList
