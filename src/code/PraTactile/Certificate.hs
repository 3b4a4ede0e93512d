-- | Proofs of the window property as data that a stranger can check. They contain everything that
-- the proof rests on, so that checking needs no search. "PraTactile.Certificate.Check" checks them,
-- and so does @data/check_certificate.py@, which shares no code with this library.
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

-- | A proof that all windows of a mask on an array are distinct. Let N = q^n - 1. The polynomial h
-- is primitive because x has order N modulo h: x^N is 1, and x^(N/l) is not 1 for any prime l that
-- divides N. So the sequence has period N and fills the array.
data Certificate = Certificate
  { -- | the array and the surface; the window is the smallest rectangle that holds the mask
    certificateProfile :: Profile,
    -- | the cells of the window, by their offsets, in reading order
    certificateMask :: [Position],
    -- | the number of windows of the surface, all distinct
    certificateWindows :: Natural,
    -- | N = q^n - 1
    certificatePeriod :: Natural,
    -- | the factorisation of N, ascending
    certificateFactors :: [OrderFactor],
    -- | the primes in use that are not below 'millerRabinDomain', each after the primes that its
    -- proof uses
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

-- | A proof by Pocklington's theorem that a number P is prime. The prime powers l^e of the
-- witnesses divide P - 1, and their product exceeds the square root of P. For each witness a,
-- a^(P-1) = 1 modulo P, and a^((P-1)/l) - 1 is coprime to P.
data PrimeProof = PrimeProof
  { shownPrime :: Natural,
    shownBy :: [PrimeWitness]
  }
  deriving stock (Eq, Show)

-- | A prime l with its exponent e in P - 1, and the witness a for it.
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
  | -- | All windows were visited and are distinct; the text is their 'digestOfWindows'.
    ByEnumeration String
  deriving stock (Eq, Show)

-- | A proof that a mask has rank n.
data RankEvidence = RankEvidence
  { -- | alpha^e(i, j) for each cell of the mask, by n codes, the coefficient of 1 first
    rankVectors :: [[Natural]],
    -- | n of the cells, by ascending indices in the mask
    rankCells :: [Natural],
    -- | the inverse of the matrix whose rows are the vectors of those cells, by rows
    rankInverse :: [[Natural]]
  }
  deriving stock (Eq, Show)

-- | The method of a certificate.
data Method
  = -- | By rank if the rank decides, otherwise by enumeration.
    AnyMethod
  | RankMethod
  | EnumerationMethod
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | Why there is no certificate.
data CertificateError
  = -- | The profile does not describe an array.
    CertificateProfile ProfileError
  | -- | There is no verdict.
    CertificateProof ProofError
  | -- | The windows are not distinct.
    NotDistinct WindowVerdict
  | -- | The rank does not decide on this surface.
    RankUndecided WindowVerdict
  | -- | Not all windows were visited, or they are too many for a digest.
    NotVisited WindowVerdict
  | -- | N could not be factored.
    PeriodNotFactored FactorError
  | -- | This prime is not below 'millerRabinDomain', and no proof of its primality was found that a
    -- certificate can state.
    PrimeNotShown Natural
  deriving stock (Eq, Show)

-- | Proves that all windows of a mask are distinct on the profile's surface, and returns the proof.
-- The profile's window becomes the extent of the mask. Refuses a profile without an array, windows
-- that are not distinct, and what the given method cannot prove. The cost is that of 'prove' and
-- 'factorisePowerMinusOne', and O(r (n^3 + q n^2)) for r primes that divide q^n - 1. By enumeration
-- the windows are also sorted, with 4 bytes for each possible content or by a sorting algorithm.
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

-- | The evidence, by a method, that all windows of an array are distinct. The verdict says that
-- they are.
evidenceBy ::
  KnownField k =>
  Method ->
  Profile ->
  PseudorandomArray k ->
  Mask ->
  WindowVerdict ->
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

-- | The evidence that a mask has rank n; 'Nothing' if it has not.
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
