-- | Each step of the check of a certificate by itself: what alone is wrong is what is found.
module Test.Code.Certificate.EachFlawFound (spec) where

import Control.Exception (evaluate)
import Control.Monad (forM_, replicateM)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Certificate
import PraTactile.Certificate.Check
import PraTactile.Certificate.Digest
import PraTactile.Factorisation (isPrime)
import PraTactile.Grid (Grid)
import PraTactile.Profile
import PraTactile.Window
import System.Timeout (timeout)
import Test.Code.Generators
import Test.Effort
import Test.Hspec

spec :: Spec
spec = do
  primesSpec
  describe "a certificate with one wrong step is refused" $ do
    it "the state: too short, too long, all zeros, or with a term that is not a code" $ do
      c <- paper
      forM_ [[0, 0, 1], [0, 0, 0, 0, 1], [0, 0, 0, 0], [0, 0, 0, 4], [4, 0, 0, 1], [1, 5, 0, 0]] $
        \state ->
          checkCertificate (ofProfile c (\p -> p {profileState = state}))
            `shouldBe` Left (StateFault state)
    it "the fold: diagonal with a common divisor g of the sides, in every shape of four sizes" $
      forM_ [(2, [1, 1, 0, 0, 0, 0, 1]), (3, [2, 1, 1]), (3, [2, 0, 0, 2, 1]), (5, [2, 4, 1])] $
        \(q, h) -> do
          let n = fromIntegral (length h) - 1
              size = q ^ n - 1
              shapes =
                [ (shape, g)
                  | k <- [1 .. size],
                    size `mod` k == 0,
                    let shape = Shape k (size `div` k),
                    let g = gcd k (size `div` k),
                    g > 1
                ]
          shapes `shouldNotBe` []
          forM_ shapes $ \(shape, g) -> do
            rowByRow <- certificateIn q h shape RowMajor (Shape 1 n)
            checkCertificate rowByRow `shouldBe` Right ()
            checkCertificate
              ( ofProfile rowByRow $ \p ->
                  p {profileFolding = Diagonal, profileSurface = Torus}
              )
              `shouldBe` Left (CommonDivisorFault g)
    it "the factors: repeated, out of order, to the power 0, or to a huge power" $ do
      c <- certificateOver [1, 1, 0, 0, 0, 0, 1] (Shape 3 21) RowMajor (Shape 1 6)
      -- 63 = 3^2 7.
      [three, seven] <- pure (certificateFactors c)
      let once = three {orderExponent = 1}
          lies =
            [ [once, once, seven],
              [OrderFactor 2 0 (orderResidue three), three, seven],
              [seven, three],
              [three, seven, seven {orderExponent = 0}],
              [three {orderExponent = 0}, seven],
              [three, seven {orderExponent = 2}],
              [three {orderExponent = 10 ^ (9 :: Int)}, seven],
              [three, seven {orderExponent = 10 ^ (30 :: Int)}]
            ]
      checkCertificate c `shouldBe` Right ()
      forM_ lies $ \lie -> do
        said <- timeout 5000000 (evaluate (checkCertificate c {certificateFactors = lie}))
        said `shouldBe` Just (Left (FactorsFault 63))
    it "the cells: too few or many, repeated, out of order, or outside the mask" $ do
      c <- certificateOver [1, 1, 0, 0, 0, 0, 1] (Shape 7 9) Diagonal (Shape 3 3)
      [cells] <- pure [rankCells e | ByRank e <- [certificateEvidence c]]
      let twice = take 1 cells ++ take 5 cells
      checkCertificate c `shouldBe` Right ()
      forM_ [take 5 cells, cells ++ [8], twice, reverse cells, take 5 cells ++ [9]] $ \others ->
        checkCertificate
          c
            { certificateEvidence = case certificateEvidence c of
                ByRank e -> ByRank e {rankCells = others}
                other -> other
            }
          `shouldBe` Left (CellsFault others)
    it "the field: more than 256 elements, or a modulus of the wrong degree" $ do
      let choice = profileChoice 256 [2, 1] (Shape 15 17)
      one' <- right (chooseProfile choice {chosenWindow = Just (Shape 1 1)})
      c <- right (rectangle (Shape 1 1)) >>= right . certify AnyMethod one'
      checkCertificate c `shouldBe` Right ()
      let modulus = profileModulus one'
          others = [(256, h) | h <- [modulus ++ [1], drop 1 modulus, [], [1]]]
      forM_ ([(257, [254, 1]), (1, [1]), (1, [])] ++ others) $
        \(q, h) ->
          checkCertificate (ofProfile c (\p -> p {profileOrder = q, profileModulus = h}))
            `shouldBe` Left (OrderNotOfModulus q)
      forM_ [1, 6, 12] $ \q ->
        checkCertificate (ofProfile c (\p -> p {profileOrder = q}))
          `shouldBe` Left (OrderNotOfModulus q)
    it "the windows: none; a single one is accepted" $ do
      one' <- certificateOver [1, 1, 0, 0, 1] (Shape 3 5) Diagonal (Shape 2 2)
      forM_ [(3, 5, Right ()), (3, 6, Left (WindowsFault 0 0)), (4, 5, Left (WindowsFault 0 0))] $
        \(high, wide, wanted) -> do
          window <- right (rectangle (Shape high wide))
          c <- right (certify RankMethod (certificateProfile one') window)
          let there = if wanted == Right () then 1 else 0
          checkCertificate
            (ofProfile c (\p -> p {profileSurface = Sheet})) {certificateWindows = there}
            `shouldBe` wanted
    it "the polynomial: x to the number of cells is not 1 modulo it" $
      forM_ [4, 6] $ \n -> do
        let cells = 2 ^ n - 1 :: Natural
            line h = certificateOver h (Shape 1 cells) RowMajor (Shape 1 (fromIntegral n))
        genuine <- line (if n == 4 then [1, 1, 0, 0, 1] else [1, 1, 0, 0, 0, 0, 1])
        forM_ (replicateM (n - 1) [0, 1]) $ \inner -> do
          let h = 1 : inner ++ [1]
              closes = timesRoot h (fromIntegral cells) == 1 : replicate (n - 1) (0 :: Natural)
              said = checkCertificate (ofProfile genuine (\p -> p {profilePolynomial = h}))
          (h, said == Left OrderFault) `shouldBe` (h, not closes)
  it "repeated windows have no digest, by a table or by sorting" $ do
    -- The cells at which the sequence is 0 span a hyperplane of GF(2)^6: 31 of them, or 5.
    grid <- lineOf 6
    h <- firstOver gf2 6
    array <- right (folded RowMajor (Shape 1 63) h)
    terms <- concat <$> right (toRows array)
    let zeros = [Position 0 i | (i, 0) <- zip [0 ..] terms]
    length zeros `shouldBe` 31
    forM_ [31, 27, 8] $ \count -> do
      m <- right (maskFrom (take count zeros))
      digestOfWindows MostSignificantFirst TwistedTorus grid m `shouldBe` Nothing
  it "up to 2^26 contents go by a table, and with more, up to 2^20 windows by sorting" $
    [ roadOf contents positions
      | contents <- [1, 2 ^ (26 :: Int), 2 ^ (26 :: Int) + 1, 2 ^ (100 :: Int)],
        positions <- [1, 2 ^ (20 :: Int), 2 ^ (20 :: Int) + 1, 2 ^ (40 :: Int)]
    ]
      `shouldBe` replicate 8 (Just ByTable)
        ++ concat (replicate 2 [Just BySorting, Just BySorting, Nothing, Nothing])
  it "windows larger than the sheet have no digest, by a table or by sorting" $ do
    grid <- lineOf 4
    forM_ [(1, 16), (2, 1), (1, 40), (2, 14)] $ \(high, wide) -> do
      m <- right (rectangle (Shape high wide))
      digestOfWindows MostSignificantFirst Sheet grid m `shouldBe` Nothing
  it "2^21 - 1 windows have a digest if there are at most 2^26 contents" $ do
    grid <- lineOf 21
    fmap (fmap length) (digest grid 21) `shouldReturn` Just 64
    digest grid 27 `shouldReturn` Nothing
  it "cells beyond those that separate all windows do not change the digest" $
    forM_ ((12, 17) : byEffort [] [(21, 26)]) $ \(n, more) -> do
      grid <- lineOf n
      few <- digest grid n
      digest grid more `shouldReturn` few
  it "repeated windows have no certificate, by any method" $ do
    window <- right (rectangle (Shape 1 2))
    forM_ [minBound .. maxBound] $ \method ->
      [() | Left (NotDistinct _) <- [certify method canonicalProfile window]] `shouldBe` [()]

-- | Of the windows of so many cells in a row.
digest :: Grid -> Natural -> IO (Maybe String)
digest grid count =
  digestOfWindows MostSignificantFirst TwistedTorus grid <$> right (rectangle (Shape 1 count))

-- | x to a power modulo a polynomial over GF(2), by as many shifts.
timesRoot :: [Natural] -> Int -> [Natural]
timesRoot h count = iterate shift (1 : replicate (n - 1) 0) !! count
  where
    n = length h - 1
    shift a = [(b + c * last a) `mod` 2 | (b, c) <- zip (0 : a) (take n h)]

-- | Pocklington's theorem.
primesSpec :: Spec
primesSpec = describe "a number is shown to be prime" $ do
  it "exactly if the theorem says so: numbers to 40, all proofs by one or two small factors" $
    [ (n, proof)
      | n <- [0 .. 40],
        proof <- proofs,
        isShownPrime [] (PrimeProof n proof) /= byTheorem n proof
    ]
      `shouldBe` []
  it "by a prime shown before it, not after it" $ do
    mersenne <- certificateOfMersenne
    [big] <- pure (certificatePrimes mersenne)
    let -- 136 (2^89 - 1) + 1.
        larger = 84179922671405858693140447097
        above = PrimeProof larger [PrimeWitness (shownPrime big) 1 2]
    larger `shouldBe` 136 * shownPrime big + 1
    isShownPrime [shownPrime big] above `shouldBe` True
    isShownPrime [] above `shouldBe` False
    checkCertificate mersenne {certificatePrimes = [big, above]} `shouldBe` Right ()
    forM_ [[above, big], [above]] $ \primes ->
      checkCertificate mersenne {certificatePrimes = primes}
        `shouldBe` Left (PrimeFault larger)
  it "not by the strong test from 3317044064679887385961981 on, where it proves nothing" $ do
    -- That number is composite, and the next prime is 142 more; both divide a prime less one.
    forM_
      [ (3317044064679887385961981, 159218115104634594526175089),
        (3317044064679887385962123, 305168053950549639508515317)
      ]
      $ \(l, n) -> do
        let proof = PrimeProof n [PrimeWitness l 1 2]
        (isShownPrime [] proof, isShownPrime [l] proof) `shouldBe` (False, True)
  it "by the least base for each factor" $ do
    mersenne <- certificateOfMersenne
    forM_ (certificatePrimes mersenne) $ \(PrimeProof n used) -> do
      length used `shouldSatisfy` (> 5)
      forM_ used $ \(PrimeWitness l _ a) ->
        (l, take 1 (filter (shows' n l) [2 ..])) `shouldBe` (l, [a])
  where
    shows' n l a =
      raised n a (n - 1) == 1 && gcd n (raised n a ((n - 1) `div` l) + n - 1) == 1
    raised n a e
      | e == 0 = 1
      | even e = raised n (a * a `mod` n) (e `div` 2)
      | otherwise = a * raised n (a * a `mod` n) (e `div` 2) `mod` n
    proofs =
      [[w] | w <- witnesses] ++ [[v, w] | v <- witnesses, w <- witnesses, sameBase v w] ++ [[]]
    witnesses =
      [ PrimeWitness l e a
        | l <- [0, 1, 2, 3, 4, 5, 7, 9, 11, 13],
          e <- [0 .. 4],
          a <- [0, 1, 2, 3, 5]
      ]
    sameBase v w = witnessBase v == witnessBase w

-- | The theorem, word for word; of numbers of at least 5.
byTheorem :: Natural -> [PrimeWitness] -> Bool
byTheorem n proof =
  n > 3
    && and (zipWith (<) primes (drop 1 primes))
    && all (\w -> isPrime (witnessPrime w) == Right True && witnessExponent w > 0) proof
    && (n - 1) `mod` whole == 0
    && whole * whole > n
    && and
      [ a ^ (n - 1) `mod` n == 1 && gcd n (a ^ ((n - 1) `div` l) `mod` n + n - 1) == 1
        | PrimeWitness l _ a <- proof
      ]
  where
    primes = map witnessPrime proof
    whole = product [witnessPrime w ^ witnessExponent w | w <- proof]

ofProfile :: Certificate -> (Profile -> Profile) -> Certificate
ofProfile c change = c {certificateProfile = change (certificateProfile c)}

-- | Of the paper's array, by rank.
paper :: IO Certificate
paper = right (rectangle (Shape 2 2)) >>= right . certify RankMethod canonicalProfile

-- | Over GF(2), by rank, of a polynomial, a shape, a folding and a window.
certificateOver :: [Natural] -> Shape -> Folding -> Shape -> IO Certificate
certificateOver = certificateIn 2

-- | Over GF(q), by rank, of a polynomial, a shape, a folding and a window.
certificateIn :: Natural -> [Natural] -> Shape -> Folding -> Shape -> IO Certificate
certificateIn q h shape folding window = do
  let choice = profileChoice q h (Shape 1 (area shape))
  chosen <- right (chooseProfile choice {chosenWindow = Just window'})
  let profile =
        chosen
          { profileShape = shape,
            profileFolding = folding,
            profileSurface = naturalSurface folding,
            profileWindow = window
          }
  right (rectangle window) >>= right . certify RankMethod profile
  where
    window' = Shape 1 1

-- | Of the 2^89 - 1 cells of a line, whose number is prime.
certificateOfMersenne :: IO Certificate
certificateOfMersenne =
  certificateOver
    [if i `elem` [0, 38, 89] then 1 else 0 | i <- [0 .. 89 :: Int]]
    (Shape 1 (2 ^ (89 :: Int) - 1))
    RowMajor
    (Shape 1 89)

-- | The sequence of the first primitive polynomial over GF(2) of a degree as one row.
lineOf :: Natural -> IO Grid
lineOf n = do
  h <- firstOver gf2 n
  array <- right (folded RowMajor (Shape 1 (2 ^ n - 1)) h)
  right (toGrid array)
