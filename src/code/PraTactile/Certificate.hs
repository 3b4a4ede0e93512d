-- | A proof of the window property as data that a stranger can check: everything that the proof
-- stands on is written down so that checking it takes no search. "PraTactile.Certificate.Check"
-- checks it, and so does @data/check_certificate.py@, which shares nothing with this library.
module PraTactile.Certificate
  ( -- * Certificates
    Certificate (..),
    OrderFactor (..),
    PrimeProof (..),
    PrimeWitness (..),
    Evidence (..),
    RankEvidence (..),

    -- * Certifying
    certify,
    Method (..),
    CertificateError (..),
  )
where

import Control.Monad (unless)
import Data.Bifunctor (first)
import Data.List (find)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Certificate.Digest
import PraTactile.Extension
import PraTactile.Factorisation
import PraTactile.Field
import PraTactile.LinearCode.Elimination
import PraTactile.Polynomial
import PraTactile.Profile
import PraTactile.Window
import PraTactile.Window.Proof
import PraTactile.Window.Visit (visitedShape)

-- | All windows of a mask on an array are distinct, and why. With N = q^n - 1, h is primitive
-- because x has order N modulo h: x^N is 1, and x^(N/l) is not for any prime l that divides N;
-- whence the sequence has period N, and fills the array.
data Certificate = Certificate
  { -- | the array and the surface; the window is the smallest rectangle that holds the mask
    certificateProfile :: Profile,
    -- | the cells of the window, by their offsets, in reading order
    certificateMask :: [Position],
    -- | how many windows the surface has, all of them distinct
    certificateWindows :: Natural,
    -- | N = q^n - 1
    certificatePeriod :: Natural,
    -- | the factorisation of N, ascending
    certificateFactors :: [OrderFactor],
    -- | the primes used that are not below 'millerRabinDomain', each after those that its proof
    -- uses
    certificatePrimes :: [PrimeProof],
    -- | why the windows are distinct
    certificateEvidence :: Evidence
  }
  deriving stock (Eq, Show)

-- | A prime l that divides N, its exponent, and x^(N/l) modulo h: n codes, constant term first.
data OrderFactor = OrderFactor
  { orderPrime :: Natural,
    orderExponent :: Natural,
    orderResidue :: [Natural]
  }
  deriving stock (Eq, Show)

-- | A number P shown to be prime by Pocklington's theorem: the prime powers l^e of the witnesses
-- divide P - 1, their product exceeds the square root of P, and for each a witness a has a^(P-1) =
-- 1 modulo P and a^((P-1)/l) - 1 coprime to P.
data PrimeProof = PrimeProof
  { shownPrime :: Natural,
    shownBy :: [PrimeWitness]
  }
  deriving stock (Eq, Show)

-- | A prime l with its exponent e in P - 1, and the witness a.
data PrimeWitness = PrimeWitness
  { witnessPrime :: Natural,
    witnessExponent :: Natural,
    witnessBase :: Natural
  }
  deriving stock (Eq, Show)

-- | Why the windows are distinct.
data Evidence
  = -- | The alpha^e(i, j) of the mask have rank n.
    ByRank RankEvidence
  | -- | Visiting all windows has seen them distinct: the 'digestOfWindows'.
    ByEnumeration String
  deriving stock (Eq, Show)

-- | That a mask has rank n.
data RankEvidence = RankEvidence
  { -- | alpha^e(i, j) for each cell of the mask, by n codes, the coefficient of 1 first
    rankVectors :: [[Natural]],
    -- | n of the cells, by their indices in the mask, ascending
    rankCells :: [Natural],
    -- | the inverse, by rows, of the matrix whose rows are the vectors of those cells
    rankInverse :: [[Natural]]
  }
  deriving stock (Eq, Show)

-- | By which method to certify.
data Method
  = -- | By rank where the rank decides, otherwise by enumeration.
    AnyMethod
  | RankMethod
  | EnumerationMethod
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | Why there is no certificate.
data CertificateError
  = -- | The profile describes no array.
    CertificateProfile ProfileError
  | -- | There is no verdict.
    CertificateProof ProofError
  | -- | The windows are not distinct.
    NotDistinct Verdict
  | -- | The rank decides nothing on this surface.
    RankUndecided Verdict
  | -- | Not all windows were visited, or they are too many for a digest.
    NotVisited Verdict
  | -- | N was not factored.
    PeriodNotFactored FactorError
  | -- | This prime is beyond 'millerRabinDomain', and its primality was not shown in a way that a
    -- certificate can state.
    PrimeNotShown Natural
  deriving stock (Eq, Show)

-- | Prove that all windows of a mask are distinct on the profile's surface, and write the proof
-- down. The profile's window becomes the extent of the mask. Refuses a profile without an array,
-- windows that are not distinct, and what cannot be shown on the method asked for. The cost is that
-- of 'prove' and 'factorisePowerMinusOne', and O(r (n^3 + q n^2)) for r primes that divide q^n - 1;
-- by enumeration the windows are put in order besides, with 4 bytes for each possible content or by
-- sorting.
certify :: Method -> Profile -> Mask -> Either CertificateError Certificate
certify method profile mask = do
  outcome <- first CertificateProfile (withProfile stated certified)
  outcome
  where
    certified :: KnownField k => PseudorandomArray k -> a -> Either CertificateError Certificate
    certified array _ = certifyArray method stated array mask
    stated = profile {profileWindow = maskExtent mask}

-- | The certificate for an array that the profile describes.
certifyArray ::
  forall k.
  KnownField k =>
  Method ->
  Profile ->
  PseudorandomArray k ->
  Mask ->
  Either CertificateError Certificate
certifyArray method profile array mask = do
  (verdict, _) <- first CertificateProof (prove (ArrayOn (profileSurface profile) array) mask)
  unless (proved verdict) (Left (NotDistinct verdict))
  evidence <- evidenceBy method profile array mask verdict
  factors <-
    first PeriodNotFactored (factorisePowerMinusOne p (m * fromIntegral (primitiveDegree h)))
  primes <- concat <$> traverse (primeProofs . fst) factors
  pure
    Certificate
      { certificateProfile = profile,
        certificateMask = maskOffsets mask,
        certificateWindows = area (visitedShape (profileSurface profile) (arrayShape array) mask),
        certificatePeriod = period h,
        certificateFactors = [OrderFactor l e (residueAt (period h `div` l)) | (l, e) <- factors],
        certificatePrimes = primes,
        certificateEvidence = evidence
      }
  where
    h = arrayPrimitive array
    p = fromIntegral (fieldCharacteristic array)
    m = fromIntegral (fieldDegree array)
    residueAt = codes . residueCoefficients h . powerOfRoot h

-- | Why all windows of an array are distinct, by a method, given the verdict that they are.
evidenceBy ::
  KnownField k =>
  Method ->
  Profile ->
  PseudorandomArray k ->
  Mask ->
  Verdict ->
  Either CertificateError Evidence
evidenceBy method profile array mask verdict = case method of
  EnumerationMethod -> enumerated
  RankMethod -> ranked
  AnyMethod -> either (const enumerated) Right ranked
  where
    enumerated = maybe (Left (NotVisited verdict)) (Right . ByEnumeration) $ do
      True <- enumeration verdict
      grid <- either (const Nothing) Just (toGrid array)
      digestOfWindows (profilePacking profile) (profileSurface profile) grid mask
    ranked = maybe (Left (RankUndecided verdict)) Right $ do
      True <- rankDecision verdict
      ByRank <$> rankEvidence array mask

-- | The evidence that a mask has rank n, which is known of it.
rankEvidence :: KnownField k => PseudorandomArray k -> Mask -> Maybe RankEvidence
rankEvidence array mask =
  evidence <$> inverseMatrix [x | (i, x) <- zip [0 ..] vectors, i `elem` cells]
  where
    n = primitiveDegree (arrayPrimitive array)
    vectors = windowVectors array mask
    cells = independentRows n (map rowFromList vectors)
    evidence inverse' =
      RankEvidence (map codes vectors) (map fromIntegral cells) (map codes inverse')

codes :: [GF k] -> [Natural]
codes = map (fromIntegral . toCode)

-- | The proof that a prime needs: none below 'millerRabinDomain', where the strong test decides.
primeProofs :: Natural -> Either CertificateError [PrimeProof]
primeProofs prime
  | prime < millerRabinDomain = Right []
  | product [l ^ e | (l, e) <- factors] ^ (2 :: Int) > prime,
    Just witnesses <- traverse witness factors =
    Right [PrimeProof prime witnesses]
  | otherwise = Left (PrimeNotShown prime)
  where
    factors = pocklingtonFactors prime
    witness (l, e) = PrimeWitness l e <$> find (isPocklingtonWitness prime l) [2 .. 200]
