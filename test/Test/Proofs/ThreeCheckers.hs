-- | Three checkers, one verdict: the library's, the one in Python and the one that is proved sound
-- say the same of certificates by rank, of good ones and of such as were changed anywhere.
module Test.Proofs.ThreeCheckers (spec) where

import Control.Monad (forM_, zipWithM_)
import Data.Either (isRight)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Certificate
import PraTactile.Certificate.Check
import PraTactile.Format.Certificate (encodeCertificate)
import PraTactile.Profile
import PraTactile.Window
import Test.Code.Certificate.CheckerInPython
import Test.Code.Certificate.ForgeriesRefused (forgedCertificates)
import Test.Code.Generators (right)
import Test.Effort
import Test.Hspec
import Test.Proofs.Extraction

spec :: Spec
spec = do
  forM_ (zip [1 :: Int ..] (byEffort (take 2) id profiles)) $ \(i, profile) ->
    it ("of a good one and of all with one number changed, " ++ show i) $ do
      genuine <- right (rectangle (profileWindow profile)) >>= right . certify RankMethod profile
      checkedInCoq genuine `shouldBe` True
      let others = changed genuine
      length others `shouldSatisfy` (> 50)
      alike (genuine : others)
  it "of those about a polynomial whose root has a smaller order" $ do
    forged <- concat <$> mapM forgedCertificates [(2, 6), (3, 4), (4, 3)]
    length forged `shouldSatisfy` (> 5)
    map checkedInCoq forged `shouldBe` map (const False) forged
    alike forged
  it "of composites in the place of primes, with the residues that they have" $ do
    genuine <- right (rectangle (Shape 2 2)) >>= right . certify RankMethod canonicalProfile
    [three, five, seventeen] <- pure (certificateFactors genuine)
    let withFactors factors = genuine {certificateFactors = factors}
        -- x^17 is x^(255 / 15), and not 1.
        composite = OrderFactor 15 1 (powerInCoq canonicalProfile 17)
        shown = genuine {certificatePrimes = [PrimeProof 341 [PrimeWitness 2 2 3]]}
        lies =
          [withFactors [composite, seventeen], withFactors [three, five], shown]
            ++ [withFactors [five, three, seventeen], withFactors [three, three, five, seventeen]]
    map checkedInCoq lies `shouldBe` map (const False) lies
    alike lies
  it "except that a prime of 2^34 or more is beyond the one that is proved" $ do
    let wide =
          canonicalProfile
            { profileOrder = 2,
              profileModulus = [1, 1],
              profilePolynomial = [if i `elem` [0, 38, 89] then 1 else 0 | i <- [0 .. 89 :: Int]],
              profileState = replicate 88 0 ++ [1],
              profileShape = Shape 1 (2 ^ (89 :: Int) - 1),
              profileFolding = RowMajor,
              profileSurface = TwistedTorus,
              profileWindow = Shape 1 89
            }
    c <- right (rectangle (Shape 1 89)) >>= right . certify RankMethod wide
    (checkCertificate c, checkedInCoq c) `shouldBe` (Right (), False)

-- | The three verdicts on each certificate are the same.
alike :: [Certificate] -> Expectation
alike certificates = do
  let here = map (isRight . checkCertificate) certificates
  zipWithM_ (\c verdict -> (checkedInCoq c, c) `shouldBe` (verdict, c)) certificates here
  elsewhere <- inPython (map encodeCertificate certificates)
  [c | (c, verdict, other) <- zip3 certificates here elsewhere, verdict /= other] `shouldBe` []

-- | Both foldings, a sheet, a reciprocal polynomial, and other fields.
profiles :: [Profile]
profiles =
  [ canonicalProfile,
    canonicalProfile
      { profileOrder = 9,
        profileModulus = [2, 2, 1],
        profilePolynomial = [3, 1, 1],
        profileReading = Reciprocal,
        profileState = [5, 0],
        profileShape = Shape 5 16,
        profileFolding = RowMajor,
        profileSurface = TwistedTorus,
        profileWindow = Shape 1 2
      },
    canonicalProfile {profileSurface = Sheet, profileState = [3, 1, 0, 2]},
    canonicalProfile
      { profileOrder = 5,
        profileModulus = [3, 1],
        profilePolynomial = [2, 3, 0, 1],
        profileState = [0, 0, 4],
        profileShape = Shape 4 31,
        profileWindow = Shape 1 3
      }
  ]

-- | All certificates with one number or name changed.
changed :: Certificate -> [Certificate]
changed c =
  [c {certificateProfile = p} | p <- profilesBeside (certificateProfile c)]
    ++ [c {certificateMask = m} | m <- one cell (certificateMask c)]
    ++ [c {certificateWindows = w} | w <- nudged (certificateWindows c)]
    ++ [c {certificatePeriod = n} | n <- nudged (certificatePeriod c)]
    ++ [c {certificateFactors = f} | f <- one factor (certificateFactors c)]
    ++ [c {certificateFactors = drop 1 (certificateFactors c)}]
    ++ [ c {certificateEvidence = ByRank e'}
         | ByRank e <- [certificateEvidence c],
           e' <-
             [e {rankVectors = v} | v <- one numbers (rankVectors e)]
               ++ [e {rankCells = i} | i <- numbers (rankCells e)]
               ++ [e {rankInverse = i} | i <- one numbers (rankInverse e)]
               ++ [e {rankInverse = rankVectors e}, e {rankVectors = reverse (rankVectors e)}]
       ]
  where
    cell (Position i j) = [Position i' j | i' <- nudged i] ++ [Position i j' | j' <- nudged j]
    factor (OrderFactor l e residue) =
      [OrderFactor l' e residue | l' <- nudged l]
        ++ [OrderFactor l e' residue | e' <- nudged e]
        ++ [OrderFactor l e residue' | residue' <- numbers residue]

profilesBeside :: Profile -> [Profile]
profilesBeside p =
  [p {profileOrder = q} | q <- nudged (profileOrder p)]
    ++ [p {profileModulus = f} | f <- numbers (profileModulus p)]
    ++ [p {profilePolynomial = h} | h <- numbers (profilePolynomial p)]
    ++ [p {profileState = s} | s <- numbers (profileState p)]
    ++ [p {profileShape = s} | s <- shape (profileShape p)]
    ++ [p {profileWindow = s} | s <- shape (profileWindow p)]
    ++ [p {profileFolding = f} | f <- [minBound .. maxBound], f /= profileFolding p]
    ++ [p {profileSurface = s} | s <- [Torus, TwistedTorus, Sheet], s /= profileSurface p]
    ++ [p {profileReading = r} | r <- [minBound .. maxBound], r /= profileReading p]
  where
    shape (Shape high wide) =
      Shape wide high : [Shape h wide | h <- nudged high] ++ [Shape high w | w <- nudged wide]

-- | The lists in which one element is changed.
one :: (a -> [a]) -> [a] -> [[a]]
one change list = case list of
  [] -> []
  a : others -> map (: others) (change a) ++ map (a :) (one change others)

numbers :: [Natural] -> [[Natural]]
numbers = one nudged

nudged :: Natural -> [Natural]
nudged n = (n + 1) : [n - 1 | n > 0]
