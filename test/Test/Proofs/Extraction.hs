-- | The definitions and the checker that Coq extracted, in the types of this library: what
-- @proofs/@ proves theorems about is asked the same questions as the library is.
module Test.Proofs.Extraction
  ( profileInCoq,
    powerInCoq,
    checkedInCoq,
  )
where

import qualified Extracted as Coq
import Numeric.Natural (Natural)
import PraTactile.Array (Folding (..), Position (..), Shape (..), Surface (..))
import PraTactile.Certificate
import PraTactile.Profile (Profile (..), Reading (..))

-- | The profile without its window and packing, of which the definitions know nothing.
profileInCoq :: Profile -> Coq.Profile0
profileInCoq p =
  Coq.Profile
    (toInteger (profileOrder p))
    (numbers (profileModulus p))
    (numbers (profilePolynomial p))
    (case profileReading p of Characteristic -> Coq.Characteristic; Reciprocal -> Coq.Reciprocal)
    (numbers (profileState p))
    (toInteger (rows (profileShape p)))
    (toInteger (columns (profileShape p)))
    (case profileFolding p of Diagonal -> Coq.Diagonal; RowMajor -> Coq.RowMajor)
    ( case profileSurface p of
        Torus -> Coq.Torus
        TwistedTorus -> Coq.TwistedTorus
        Sheet -> Coq.Sheet
    )

-- | A power of x modulo the profile's polynomial, by its codes, constant term first.
powerInCoq :: Profile -> Natural -> [Natural]
powerInCoq p e = map fromInteger (Coq.rootPower (Coq.field it) (Coq.lower it) (toInteger e))
  where
    it = profileInCoq p

-- | Whether the checker that is proved sound finds a certificate by rank good. It does not look at
-- the seal, and refuses a certificate by enumeration.
checkedInCoq :: Certificate -> Bool
checkedInCoq c = case certificateEvidence c of
  ByEnumeration _ -> False
  ByRank evidence ->
    Coq.check $
      Coq.Certificate
        (profileInCoq (certificateProfile c))
        (pair (profileWindow (certificateProfile c)))
        [(toInteger i, toInteger j) | Position i j <- certificateMask c]
        (toInteger (certificateWindows c))
        (toInteger (certificatePeriod c))
        [ ((toInteger l, toInteger e), numbers residue)
          | OrderFactor l e residue <- certificateFactors c
        ]
        [(toInteger l, map witness witnesses) | PrimeProof l witnesses <- certificatePrimes c]
        (map numbers (rankVectors evidence))
        (numbers (rankCells evidence))
        (map numbers (rankInverse evidence))
  where
    pair (Shape high wide) = (toInteger high, toInteger wide)
    witness (PrimeWitness l e a) = ((toInteger l, toInteger e), toInteger a)

numbers :: [Natural] -> [Integer]
numbers = map toInteger
