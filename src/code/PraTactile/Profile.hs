{-# LANGUAGE RankNTypes #-}

-- | All conventions of an array as data. Two implementations agree on an array, and on the meaning
-- of positions in it, when they agree on its profile. 'withProfile' checks a profile and makes the
-- typed array.
module PraTactile.Profile
  ( -- * Profiles
    Profile (..),
    Reading (..),
    canonicalProfile,
    ProfileChoice (..),
    profileChoice,
    chooseProfile,
    foldedBy,
    inferWindow,

    -- * From profiles to arrays
    withProfile,
    ProfileError (..),
  )
where

import Control.Monad (when)
import Data.Bifunctor (first)
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Proxy (Proxy (..))
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named (conwayModulus, modulusDegrees)
import PraTactile.Polynomial
import PraTactile.Sequence
import PraTactile.Window

-- | The meaning of a profile's polynomial.
data Reading
  = -- | The characteristic polynomial h: s(i+n) = - (c0 s(i) + ... + c(n-1) s(i+n-1)).
    Characteristic
  | -- | Its reciprocal x^n h(1/x), made monic, as part of the literature writes it.
    Reciprocal
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | An array with its conventions. Elements are given by their codes, polynomials by their
-- coefficients, constant term first. A value may state an impossible choice; 'withProfile' refuses
-- it.
data Profile = Profile
  { -- | q, the number of symbols
    profileOrder :: Natural,
    -- | the modulus of GF(q), over the integers modulo p
    profileModulus :: [Natural],
    -- | the polynomial over GF(q), of degree n
    profilePolynomial :: [Natural],
    -- | the meaning of that polynomial
    profileReading :: Reading,
    -- | s(0), ..., s(n-1)
    profileState :: [Natural],
    -- | how the sequence is folded
    profileFolding :: Folding,
    -- | n1 x n2 cells
    profileShape :: Shape,
    -- | k1 x k2 cells
    profileWindow :: Shape,
    -- | what lies beyond the edges
    profileSurface :: Surface,
    -- | how a window is packed into a number
    profilePacking :: Packing
  }
  deriving stock (Eq, Show)

-- | The paper's array: GF(4) with A^2 = A + 1, h = x^4 + x^2 + A x + A^2, 15 x 17 cells, 2 x 2
-- windows, on the torus.
canonicalProfile :: Profile
canonicalProfile =
  Profile
    { profileOrder = 4,
      profileModulus = [1, 1, 1],
      profilePolynomial = [3, 2, 1, 0, 1],
      profileReading = Characteristic,
      profileState = [0, 0, 0, 1],
      profileFolding = Diagonal,
      profileShape = Shape 15 17,
      profileWindow = Shape 2 2,
      profileSurface = Torus,
      profilePacking = MostSignificantFirst
    }

-- | Why a profile describes no array.
data ProfileError
  = -- | There is no such field, or a coefficient or a term of the state is not an element of it.
    ProfileField FieldError
  | -- | The modulus has the first degree, but it should have the second, m in q = p^m.
    ModulusDegree Natural Natural
  | -- | The polynomial is not primitive.
    ProfilePolynomial PolynomialError
  | -- | The initial state starts no m-sequence.
    ProfileState SequenceError
  | -- | The sequence does not fold into the shape.
    ProfileFold FoldError
  | -- | There is no such window.
    ProfileWindow WindowError
  | -- | No window was given, and none can be inferred: n1, the first number, is not q^k1 - 1 for a
    -- k1 that divides n, the second.
    WindowNotInferred Natural Natural
  deriving stock (Eq, Show)

-- | The choices that make a profile; all else is as in 'canonicalProfile'.
data ProfileChoice = ProfileChoice
  { -- | q.
    chosenOrder :: Natural,
    -- | The characteristic polynomial, as 'profilePolynomial' has it.
    chosenPolynomial :: [Natural],
    chosenShape :: Shape,
    -- | 'Nothing' for the Conway polynomial.
    chosenModulus :: Maybe [Natural],
    -- | 'Nothing' for the inferred one.
    chosenWindow :: Maybe Shape,
    -- | 'Nothing' for 0, ..., 0, 1.
    chosenState :: Maybe [Natural]
  }
  deriving stock (Eq, Show)

-- | The choice of q, a polynomial and a shape, with defaults for the rest.
profileChoice :: Natural -> [Natural] -> Shape -> ProfileChoice
profileChoice q h shape = ProfileChoice q h shape Nothing Nothing Nothing

-- | The profile for a choice. If no modulus is given, refuses a q that is not a prime power up to
-- 256. If no window is given, refuses if none can be inferred. 'withProfile' checks whether the
-- choice is possible.
chooseProfile :: ProfileChoice -> Either ProfileError Profile
chooseProfile (ProfileChoice q h shape givenModulus givenWindow givenState) = do
  modulus <- maybe (snd <$> first ProfileField (conwayModulus q)) Right givenModulus
  window <- maybe (maybe notInferred Right (inferWindow q n shape)) Right givenWindow
  pure
    canonicalProfile
      { profileOrder = q,
        profileModulus = modulus,
        profilePolynomial = h,
        profileState = fromMaybe (map (const 0) (drop 2 h) ++ [1]) givenState,
        profileShape = shape,
        profileWindow = window
      }
  where
    n = fromIntegral (max 1 (length h) - 1) :: Natural
    notInferred = Left (WindowNotInferred (rows shape) n)

-- | The profile with another folding and the surface that is natural for it.
foldedBy :: Folding -> Profile -> Profile
foldedBy folding profile =
  profile {profileFolding = folding, profileSurface = naturalSurface folding}

-- | The window k1 x k2 for n1 x n2 cells, where n1 = q^k1 - 1 and n = k1 k2 (MacWilliams and Sloane
-- 1976). The arguments are q, n and the shape. 'Nothing' if there is no such k1.
--
-- >>> inferWindow 4 4 (Shape 15 17)
-- Just (Shape {rows = 2, columns = 2})
inferWindow :: Natural -> Natural -> Shape -> Maybe Shape
inferWindow q n (Shape n1 _)
  | q < 2 = Nothing
  | otherwise =
    listToMaybe [Shape k1 (n `div` k1) | (k1, size) <- powers, n `mod` k1 == 0, size == n1 + 1]
  where
    powers = zip [1 .. n] (takeWhile (<= n1 + 1) (iterate (* q) q))

-- | Checks a profile and brings its field, array and window into scope. Refuses every impossible
-- choice, each with its own 'ProfileError'. It does not check whether the windows of the array are
-- distinct; "PraTactile.Window.Proof" proves that. The cost is that of 'withField' and
-- 'checkPrimitive'. A shape that does not have q^n - 1 cells is refused first.
--
-- >>> withProfile canonicalProfile (\array _ -> toCode (cellAt array (Position 6 5)))
-- Right 3
withProfile ::
  Profile -> (forall k. KnownField k => PseudorandomArray k -> Mask -> r) -> Either ProfileError r
withProfile profile use = do
  (p, given, needed) <- first ProfileField (modulusDegrees (profileOrder profile) (take 10 modulus))
  when (given /= needed) (Left (ModulusDegree given needed))
  mask <- first ProfileWindow (rectangle (profileWindow profile))
  checked <- first ProfileField (withField p modulus (\k -> (`use` mask) <$> arrayOver k profile))
  checked
  where
    modulus = profileModulus profile

-- | The array of a profile over its field. The number of cells is compared first, because the other
-- checks take long for large degrees.
arrayOver ::
  forall k.
  KnownField k =>
  Proxy k ->
  Profile ->
  Either ProfileError (PseudorandomArray k)
arrayOver k profile = do
  h <- first ProfileField (polynomialFromCodes (profilePolynomial profile))
  let terms = fromIntegral (fieldOrder k) ^ fromMaybe 0 (polynomialDegree (h :: Polynomial k)) - 1
  when (area shape /= terms) (Left (ProfileFold (WrongArea shape terms)))
  stated <- first ProfilePolynomial (checkPrimitive h)
  let characteristic = case profileReading profile of
        Characteristic -> stated
        Reciprocal -> reciprocal stated
  terms0 <- first ProfileField (elementsFromCodes (profileState profile))
  state <- first ProfileState (initialState characteristic terms0)
  first ProfileFold (fold (profileFolding profile) shape characteristic state)
  where
    shape = profileShape profile
