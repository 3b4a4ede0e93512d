-- | Certificates and their check.
module Test.Code.Certificate.IssuedAndChecked (spec) where

import Control.Exception (evaluate)
import Control.Monad (forM_)
import qualified Data.ByteString as Bytes
import Data.Either (isLeft)
import Data.Word (Word8)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Certificate
import PraTactile.Certificate.Check
import PraTactile.Certificate.Digest
import PraTactile.Field
import PraTactile.Polynomial
import PraTactile.Profile
import PraTactile.Window
import System.Timeout (timeout)
import Test.Code.Generators
import Test.Hspec

spec :: Spec
spec = do
  describe "SHA-256" $ do
    it "has the digests of FIPS 180-4, among them that of a million a" $ do
      sha256OfText "" `shouldBe` "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"
      sha256OfText "abc"
        `shouldBe` "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"
      sha256OfText "abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"
        `shouldBe` "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1"
      sha256 (Bytes.replicate 1000000 97)
        `shouldBe` "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0"
    it "digests the positions of windows in the order of contents, eight bytes each" $ do
      -- The windows of 0 1 1 on the sheet, two cells each: 01 at 0, 11 at 1.
      h <- firstOver gf2 2
      array <- right (folded RowMajor (Shape 1 3) h)
      grid <- right (toGrid array)
      m <- right (rectangle (Shape 1 2))
      toRows array `shouldBe` Right [[0, 1, 1]]
      digestOfWindows MostSignificantFirst Sheet grid m
        `shouldBe` Just (sha256 (Bytes.concat (map eightBytes [0, 1])))
      digestOfWindows LeastSignificantFirst Torus grid m
        -- 01, 11 and 10, read backwards: 2, 3 and 1.
        `shouldBe` Just (sha256 (Bytes.concat (map eightBytes [2, 0, 1])))
    it "gives the same digest by sorting and by a table" $
      forM_ [(q, n) | (q, n) <- [(2, 6), (3, 4), (4, 4), (5, 3)]] $ \(q, n) ->
        overField q $ \k -> do
          h <- firstOver k n
          array <- right (folded RowMajor (Shape 1 (period h)) h)
          grid <- right (toGrid array)
          -- The first cells of a row, as many as a table still has room for, and one more.
          let contents = iterate (* fromIntegral q) (fromIntegral q) :: [Natural]
              most = length (takeWhile (<= 2 ^ (26 :: Int)) contents)
              digestOf count = do
                m <- right (rectangle (Shape 1 count))
                pure (digestOfWindows MostSignificantFirst TwistedTorus grid m)
          few <- digestOf n
          table <- digestOf (fromIntegral most)
          sorted' <- digestOf (fromIntegral most + 1)
          (q, table, sorted') `shouldBe` (q, few, few)
  describe "an issued certificate is accepted" $ do
    it "of the paper's array, by both methods, on the torus and on the sheet" $
      forM_ [(road, on) | road <- [minBound .. maxBound], on <- [Torus, Sheet]] $ \(road, on) ->
        made road canonicalProfile {profileSurface = on} (rectangle (Shape 2 2)) >>= \c -> do
          checkCertificate c `shouldBe` Right ()
          certificateWindows c `shouldBe` (if on == Torus then 255 else 224)
    it "of the mask of rank 3 whose 32 windows on the sheet differ: by enumeration only" $ do
      let m = mask [(0, 0), (0, 9), (11, 8)]
          sheet = canonicalProfile {profileSurface = Sheet}
      c <- made AnyMethod sheet m
      (checkCertificate c, certificateWindows c, isRank c) `shouldBe` (Right (), 32, False)
      certified RankMethod sheet m >>= (`shouldSatisfy` isLeft)
      certified AnyMethod canonicalProfile m >>= (`shouldSatisfy` isLeft)
    it "of other foldings, readings, packings, states and fields" $
      forM_
        [ canonicalProfile
            { profileFolding = RowMajor,
              profileSurface = TwistedTorus,
              profileWindow = Shape 2 2
            },
          canonicalProfile {profileReading = Reciprocal},
          canonicalProfile {profilePacking = LeastSignificantFirst, profileState = [3, 0, 2, 1]},
          canonicalProfile
            { profileOrder = 9,
              profileModulus = [2, 2, 1],
              profilePolynomial = [3, 1, 1],
              profileState = [5, 0],
              profileShape = Shape 1 80,
              profileWindow = Shape 1 2
            },
          canonicalProfile
            { profileOrder = 5,
              profileModulus = [3, 1],
              profilePolynomial = [2, 3, 0, 1],
              profileState = [0, 0, 4],
              profileShape = Shape 4 31,
              profileWindow = Shape 1 3
            }
        ]
        $ \profile -> forM_ [minBound .. maxBound] $ \road -> do
          c <- made road profile (rectangle (profileWindow profile))
          checkCertificate c `shouldBe` Right ()
    it "of 2^64 - 1 cells by rank, and of 2^89 - 1 with a prime beyond the strong test" $
      forM_
        [ (64, [0, 1, 3, 4], Shape 255 ((2 ^ (64 :: Int) - 1) `div` 255), Shape 8 8),
          (89, [0, 38], Shape 1 (2 ^ (89 :: Int) - 1), Shape 1 89)
        ]
        $ \(n, terms, shape, window) -> do
          profile <-
            right
              ( chooseProfile
                  ( profileChoice
                      2
                      [if i `elem` (n : terms) then 1 else 0 | i <- [0 .. n :: Int]]
                      shape
                  )
                    { chosenWindow = Just window
                    }
              )
          c <- made AnyMethod profile (rectangle window)
          (checkCertificate c, map shownPrime (certificatePrimes c))
            `shouldBe` (Right (), [2 ^ n - 1 | n == 89])
          forM_ (certificatePrimes c) $ \proof -> do
            isShownPrime [] proof `shouldBe` True
            isShownPrime [] proof {shownBy = drop 10 (shownBy proof)} `shouldBe` False
            isShownPrime [] proof {shownBy = [w {witnessBase = 1} | w <- shownBy proof]}
              `shouldBe` False
            isShownPrime [] proof {shownPrime = shownPrime proof + 2} `shouldBe` False
  it "the factor 1, to any power, proves nothing, and is refused at once" $
    forM_ [1, 2, 10 ^ (30 :: Int)] $ \e -> do
      let with (PrimeProof prime witnesses) = PrimeProof prime (PrimeWitness 1 e 1 : witnesses)
          shown = PrimeProof 7 [PrimeWitness 2 1 3, PrimeWitness 3 1 3]
      isShownPrime [] shown `shouldBe` True
      said <- timeout 5000000 (evaluate (isShownPrime [] (with shown)))
      said `shouldBe` Just False
  describe "a changed certificate is refused, with the reason" $ do
    it "by rank, in every field" $ do
      c <- made RankMethod canonicalProfile (rectangle (Shape 2 2))
      let p = certificateProfile c
          ofProfile change = c {certificateProfile = change}
          ofFactor change = c {certificateFactors = mapFirst change (certificateFactors c)}
          ofRank change =
            c
              { certificateEvidence =
                  case certificateEvidence c of ByRank e -> ByRank (change e); other -> other
              }
      map
        (() <$)
        [ checkCertificate (ofProfile p {profileOrder = 8}),
          checkCertificate (ofProfile p {profileModulus = [1, 0, 1]}),
          checkCertificate (ofProfile p {profilePolynomial = [3, 2, 1, 0, 2]}),
          checkCertificate (ofProfile p {profilePolynomial = [3, 2, 1, 1]}),
          checkCertificate (ofProfile p {profilePolynomial = [2, 2, 1, 0, 1]}),
          checkCertificate (ofProfile p {profileState = [0, 0, 0, 0]}),
          checkCertificate (ofProfile p {profileFolding = RowMajor}),
          checkCertificate (ofProfile p {profileShape = Shape 17 16}),
          checkCertificate (ofProfile p {profileWindow = Shape 2 3}),
          checkCertificate (ofProfile p {profileSurface = Sheet}),
          checkCertificate c {certificateMask = take 3 (certificateMask c)},
          checkCertificate c {certificateMask = take 3 (certificateMask c) ++ [Position 1 2]},
          checkCertificate c {certificateWindows = 254},
          checkCertificate c {certificatePeriod = 254},
          checkCertificate (ofFactor (\f -> f {orderPrime = 15})),
          checkCertificate (ofFactor (\f -> f {orderExponent = 2})),
          checkCertificate (ofFactor (\f -> f {orderResidue = [1, 0, 0, 0]})),
          checkCertificate c {certificateFactors = drop 1 (certificateFactors c)},
          checkCertificate
            c
              { certificatePrimes =
                  [PrimeProof 341 [PrimeWitness 2 2 3, PrimeWitness 5 1 3, PrimeWitness 17 1 3]]
              },
          checkCertificate (ofRank (\e -> e {rankVectors = reverse (rankVectors e)})),
          checkCertificate (ofRank (\e -> e {rankCells = [0, 1, 2, 4]})),
          checkCertificate (ofRank (\e -> e {rankCells = [0, 1, 2]})),
          checkCertificate (ofRank (\e -> e {rankInverse = rankVectors e}))
        ]
        `shouldBe` map
          Left
          [ OrderNotOfModulus 8,
            FieldFault (ModulusReducible 2 [1, 0, 1]),
            PolynomialFault [3, 2, 1, 0, 2],
            PeriodFault 255 63,
            ResidueFault 3,
            StateFault [0, 0, 0, 0],
            SurfaceFault Torus,
            AreaFault (Shape 17 16),
            ExtentFault (Shape 2 2),
            WindowsFault 255 224,
            VectorFault 3,
            ExtentFault (Shape 2 3),
            WindowsFault 254 255,
            PeriodFault 254 255,
            PrimeFault 15,
            FactorsFault 255,
            ResidueFault 3,
            FactorsFault 255,
            PrimeFault 341,
            VectorFault 0,
            CellsFault [0, 1, 2, 4],
            CellsFault [0, 1, 2],
            InverseFault
          ]
    it "by enumeration" $ do
      c <- made EnumerationMethod canonicalProfile (rectangle (Shape 2 2))
      let digest = [d | ByEnumeration d <- [certificateEvidence c]]
          p = certificateProfile c
          refuses changed = case checkCertificate changed of
            Left (DigestFault told _) -> [told] == digest
            _ -> False
      map
        (\change -> refuses c {certificateProfile = change})
        [ p {profileState = [0, 0, 1, 0]},
          p {profilePacking = LeastSignificantFirst},
          p {profileShape = Shape 17 15}
        ]
        `shouldBe` [True, True, True]
      checkCertificate
        c
          { certificateProfile = p {profileFolding = RowMajor, profileSurface = Torus}
          }
        `shouldSatisfy` isLeft
      checkCertificate
        c
          { certificateProfile = p {profileWindow = Shape 1 2},
            certificateMask = [Position 0 0, Position 0 1]
          }
        `shouldBe` Left RepeatedFault
  where
    mapFirst change list = map change (take 1 list) ++ drop 1 list
    isRank c = case certificateEvidence c of ByRank _ -> True; ByEnumeration _ -> False

certified ::
  Method ->
  Profile ->
  Either WindowError Mask ->
  IO (Either CertificateError Certificate)
certified road profile window = certify road profile <$> right window

made :: Method -> Profile -> Either WindowError Mask -> IO Certificate
made road profile window = certified road profile window >>= right

-- A number below 256 as a position is digested.
eightBytes :: Word8 -> Bytes.ByteString
eightBytes = Bytes.snoc (Bytes.replicate 7 0)
