-- | Certificates that lie, sealed anew: of a polynomial whose root has a proper divisor of q^n - 1
-- as its order. Row by row on the twisted torus the powers of the root under a window of 1 x n are
-- 1, x, ..., x^(n - 1) whatever the polynomial, so that the evidence of rank n is in order, and
-- nothing but the order of the root is wrong.
module Test.Code.Certificate.ForgeriesRefused (spec, forgedCertificates) where

import Control.Monad (forM, forM_)
import Data.Either (isLeft)
import Data.Proxy (Proxy (..))
import PraTactile.Array
import PraTactile.Certificate
import PraTactile.Certificate.Check
import PraTactile.Field
import PraTactile.Format.Certificate
import PraTactile.Polynomial
import PraTactile.Profile
import PraTactile.Window
import Test.Code.Certificate.CheckerInPython
import Test.Code.Generators
import Test.Hspec

spec :: Spec
spec = forM_ [(2, 6), (2, 8), (3, 4), (3, 6), (4, 3), (4, 4), (5, 3), (7, 2), (9, 2)] $ \(q, n) ->
  describe ("over GF(" ++ show q ++ "), n = " ++ show n) $
    forM_ (lookup q everyField) $ \(SomeField (k :: Proxy k)) -> beforeAll (forgeries k n) $ do
      it "both checkers refuse a root of order (q^n - 1) / l, for each prime l" $
        \(genuine, forged) -> do
          checkCertificate genuine `shouldBe` Right ()
          forM_ forged $ \(factor, lie) ->
            checkCertificate lie `shouldBe` Left (RootOrderFault (orderPrime factor))
          inPython (map encodeCertificate (genuine : map snd forged))
            `shouldReturn` (True : map (const False) forged)
      it "both refuse it with another residue, without the prime l, or with 1 in its place" $
        \(_, forged) -> do
          let lies = concatMap (uncurry liesAbout) forged
          forM_ lies $ \lie -> checkCertificate lie `shouldSatisfy` isLeft
          inPython (map encodeCertificate lies) `shouldReturn` map (const False) lies

-- | Ways to hide a factor l with x^((q^n - 1) / l) = 1.
liesAbout :: OrderFactor -> Certificate -> [Certificate]
liesAbout factor forged =
  [ withFactors (map (instead factor)),
    withFactors (filter ((/= l) . orderPrime)),
    withFactors (map (instead factor {orderPrime = 1})),
    withFactors (const [OrderFactor (certificatePeriod forged) 1 (orderResidue factor)])
  ]
  where
    l = orderPrime factor
    withFactors change = forged {certificateFactors = change (certificateFactors forged)}
    instead lie this = if orderPrime this == l then lie else this

-- | The certificates forged over a field of this order for polynomials of this degree.
forgedCertificates :: (Int, Int) -> IO [Certificate]
forgedCertificates (q, n) = case lookup q everyField of
  Nothing -> fail "there is no field of this order"
  Just (SomeField k) -> map snd . snd <$> forgeries k n

-- | A genuine certificate, and for each of its factors l the one made to speak of a polynomial
-- whose root has order (q^n - 1) / l.
forgeries ::
  KnownField k => Proxy k -> Int -> IO (Certificate, [(OrderFactor, Certificate)])
forgeries k n = do
  genuine <- certificateOfFirst k n
  forged <- forM (certificateFactors genuine) $ \factor ->
    case polynomialOfOrder k n (fromIntegral (certificatePeriod genuine `div` orderPrime factor)) of
      Nothing -> fail "no polynomial of that order"
      Just h -> pure (factor, forgedFor h genuine)
  pure (genuine, forged)

-- | The certificate by rank of the array of the first primitive polynomial, folded row by row.
certificateOfFirst :: forall k. KnownField k => Proxy k -> Int -> IO Certificate
certificateOfFirst k n = do
  h <- right (firstPrimitive (fromIntegral n)) :: IO (Primitive k)
  profile <-
    right
      ( chooseProfile
          ( profileChoice
              (fromIntegral (fieldOrder k))
              (map (fromIntegral . toCode) (coefficients (primitivePolynomial h)))
              (Shape 1 (period h))
          )
            { chosenWindow = Just (Shape 1 (fromIntegral n))
            }
      )
  window <- right (rectangle (Shape 1 (fromIntegral n)))
  right
    ( certify
        RankMethod
        profile {profileFolding = RowMajor, profileSurface = TwistedTorus}
        window
    )

-- | The certificate made to speak of another polynomial, with the residues that it has.
forgedFor :: KnownField k => [GF k] -> Certificate -> Certificate
forgedFor h genuine =
  genuine
    { certificateProfile =
        (certificateProfile genuine) {profilePolynomial = codes (h ++ [one])},
      certificateFactors =
        [ factor
            { orderResidue = codes (powersOfX h !! fromIntegral (terms `div` orderPrime factor))
            }
          | factor <- certificateFactors genuine
        ]
    }
  where
    terms = certificatePeriod genuine
    codes = map (fromIntegral . toCode)

-- | The first polynomial x^n + lower terms, constant first, modulo which x has this order.
polynomialOfOrder :: KnownField k => Proxy k -> Int -> Int -> Maybe [GF k]
polynomialOfOrder _ n order =
  lookup order [(orderOfX h, h) | h@(c : _) <- mapM (const elements) [1 .. n], c /= zero]

orderOfX :: KnownField k => [GF k] -> Int
orderOfX h = 1 + length (takeWhile (/= take (length h) (one : repeat zero)) (drop 1 (powersOfX h)))

-- | 1, x, x^2, ... modulo x^n + the lower terms, by n coefficients, constant first: multiplied by
-- x, the n-th coefficient goes over the polynomial.
powersOfX :: KnownField k => [GF k] -> [[GF k]]
powersOfX h = iterate timesX (take (length h) (one : repeat zero))
  where
    timesX a = zipWith (\lower c -> lower - last a * c) (zero : a) h
