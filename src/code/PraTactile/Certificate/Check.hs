-- | Checks a certificate step by step, from its content and the definitions alone. It searches for
-- nothing, and its arithmetic modulo h is not the one that made the certificate. Only the windows
-- of a certificate by enumeration are visited by the library's usual code.
module PraTactile.Certificate.Check
  ( checkCertificate,
    Fault (..),
    isShownPrime,
  )
where

import Control.Monad (forM_, unless, when)
import Data.Bifunctor (first)
import Data.List (foldl', transpose)
import Data.Proxy (Proxy (..))
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Certificate
import PraTactile.Certificate.Digest
import PraTactile.Certificate.Residue
import PraTactile.Factorisation
import PraTactile.Field
import PraTactile.Profile
import PraTactile.Window
import PraTactile.Window.Visit (visitedShape)

-- | The first step of a check that fails.
data Fault
  = -- | This q is not the power of a prime whose exponent is the modulus's degree.
    OrderNotOfModulus Natural
  | -- | There is no such field, or a code is not an element of it.
    FieldFault FieldError
  | -- | The polynomial with these codes is not monic of degree at least 1 with a nonzero constant
    -- term.
    PolynomialFault [Natural]
  | -- | The stated N, and the true one, q^n - 1.
    PeriodFault Natural Natural
  | -- | The product of the prime powers is not this N.
    FactorsFault Natural
  | -- | This factor is not proved to be prime.
    PrimeFault Natural
  | -- | x^N is not 1 modulo h.
    OrderFault
  | -- | For this prime l, x^(N/l) is not as stated.
    ResidueFault Natural
  | -- | For this prime l, x^(N/l) is 1, so h is not primitive.
    RootOrderFault Natural
  | -- | The initial state, these codes, does not have n elements of the field, or all are 0.
    StateFault [Natural]
  | -- | This shape does not have N cells.
    AreaFault Shape
  | -- | The fold is diagonal, but the numbers of rows and columns have this common divisor.
    CommonDivisorFault Natural
  | -- | There is no such mask.
    MaskFault WindowError
  | -- | The mask has this extent, which is not the profile's window.
    ExtentFault Shape
  | -- | The stated number of windows, and the surface's.
    WindowsFault Natural Natural
  | -- | The rank does not decide on this surface.
    SurfaceFault Surface
  | -- | The vector of the mask's cell with this index is not as stated.
    VectorFault Natural
  | -- | The chosen cells, these indices, are not n ascending indices of the mask's cells.
    CellsFault [Natural]
  | -- | The stated matrix is not the inverse of the chosen vectors.
    InverseFault
  | -- | The array whose windows should be visited cannot be made.
    ArrayFault ProfileError
  | -- | The array whose windows should be visited is too large.
    SizeFault FoldError
  | -- | Two windows are equal, or there are too many for a digest.
    RepeatedFault
  | -- | The stated digest, and the computed one.
    DigestFault String String
  deriving stock (Eq, Show)

-- | Checks every step of a certificate. 'Right' means that all windows of the mask are distinct on
-- the profile's surface. O(n^3 log q (r + m)) for r primes that divide N = q^n - 1 and m cells of
-- the mask. By enumeration the array is also made, by 'withProfile', and all windows are visited in
-- O(m N).
checkCertificate :: Certificate -> Either Fault ()
checkCertificate certificate = do
  when (m <= 0 || p ^ m /= q) (Left (OrderNotOfModulus q))
  inField <- first FieldFault (withField p (profileModulus profile) (\k -> checkOver k certificate))
  inField
  where
    profile = certificateProfile certificate
    q = profileOrder profile
    m = length (take 10 (profileModulus profile)) - 1
    p = if q < 2 || q > 256 then 0 else sum (take 1 [d | d <- [2 .. q], q `mod` d == 0])

checkOver :: forall k. KnownField k => Proxy k -> Certificate -> Either Fault ()
checkOver k certificate = do
  h <- characteristic k profile
  let n = degree h
      terms = fromIntegral (fieldOrder k) ^ n - 1
  when (period' /= terms) (Left (PeriodFault period' terms))
  checkOrder h certificate
  checkShape n certificate
  mask <- checkMask certificate
  case certificateEvidence certificate of
    ByRank evidence -> do
      unless
        (profileSurface profile `elem` [naturalSurface (profileFolding profile), Sheet])
        (Left (SurfaceFault (profileSurface profile)))
      checkRank h profile mask evidence
    ByEnumeration stated -> checkDigest profile mask stated
  where
    profile = certificateProfile certificate
    period' = certificatePeriod certificate

-- | The characteristic polynomial of a profile.
characteristic :: KnownField k => Proxy k -> Profile -> Either Fault (Modulus k)
characteristic _ profile = do
  stated <- first FieldFault (elementsFromCodes (profilePolynomial profile))
  maybe (Left (PolynomialFault (profilePolynomial profile))) Right $ case profileReading profile of
    Characteristic -> modulusFrom stated
    Reciprocal -> modulusFrom stated >>= reversed

-- | Checks that x has order N modulo h.
checkOrder :: KnownField k => Modulus k -> Certificate -> Either Fault ()
checkOrder h certificate = do
  forM_ (zip [0 ..] primes) $ \(i, proof) -> do
    let before = map shownPrime (take i primes)
    unless (isShownPrime before proof) (Left (PrimeFault (shownPrime proof)))
  forM_ factors $ \factor ->
    unless
      (knownPrime (map shownPrime primes) (orderPrime factor))
      (Left (PrimeFault (orderPrime factor)))
  -- The product is computed step by step, so that absurd exponents take no time.
  unless
    (boundedProduct terms [(orderPrime f, orderExponent f) | f <- factors] == Just terms)
    (Left (FactorsFault terms))
  when (rootPower h terms /= rootPower h 0) (Left OrderFault)
  forM_ factors $ \(OrderFactor l _ stated) -> do
    let residue = rootPower h (terms `div` l)
    when (map (fromIntegral . toCode) residue /= stated) (Left (ResidueFault l))
    when (residue == rootPower h 0) (Left (RootOrderFault l))
  where
    terms = certificatePeriod certificate
    factors = certificateFactors certificate
    primes = certificatePrimes certificate

-- | Checks the initial state, that the shape has as many cells as the sequence has terms, and that
-- a diagonal fold reaches all of them.
checkShape :: Int -> Certificate -> Either Fault ()
checkShape n certificate = do
  when
    (length state /= n || all (== 0) state || any (>= profileOrder profile) state)
    (Left (StateFault state))
  when (area shape /= certificatePeriod certificate) (Left (AreaFault shape))
  when (profileFolding profile == Diagonal && g /= 1) (Left (CommonDivisorFault g))
  where
    profile = certificateProfile certificate
    state = profileState profile
    shape = profileShape profile
    g = gcd (rows shape) (columns shape)

-- | Checks the mask, and that the surface has the stated number of its windows, at least one.
checkMask :: Certificate -> Either Fault Mask
checkMask certificate = do
  mask <- first MaskFault (maskFrom (certificateMask certificate))
  let there = area (visitedShape (profileSurface profile) (profileShape profile) mask)
  when (maskExtent mask /= profileWindow profile) (Left (ExtentFault (maskExtent mask)))
  when
    (there /= certificateWindows certificate || there == 0)
    (Left (WindowsFault (certificateWindows certificate) there))
  pure mask
  where
    profile = certificateProfile certificate

-- | Checks that the alpha^e(i, j) are as stated, and that n of them have the stated inverse.
checkRank ::
  forall k.
  KnownField k =>
  Modulus k ->
  Profile ->
  Mask ->
  RankEvidence ->
  Either Fault ()
checkRank h profile mask (RankEvidence stated cells inverted) = do
  when
    (length stated /= maskSize mask)
    (Left (VectorFault (fromIntegral (min (length stated) (maskSize mask)))))
  forM_ (zip3 [0 ..] (powersAt h exponents) stated) $ \(i, computed, codes) ->
    when (map (fromIntegral . toCode) computed /= codes) (Left (VectorFault i))
  unless
    ( length cells == n
        && and (zipWith (<) cells (drop 1 cells))
        && all (< fromIntegral (maskSize mask)) cells
    )
    (Left (CellsFault cells))
  chosen <-
    first FieldFault (traverse elementsFromCodes [x | (i, x) <- zip [0 ..] stated, i `elem` cells])
  inverse' <- first FieldFault (traverse elementsFromCodes inverted) :: Either Fault [[GF k]]
  unless
    (map length inverse' == replicate n n && product' inverse' chosen == unit)
    (Left InverseFault)
  where
    n = degree h
    Shape n1 n2 = profileShape profile
    exponents = map (cellExponent (profileFolding profile)) (maskOffsets mask)
    -- e(i, j) is i modulo n1 and j modulo n2. With u n2 = 1 modulo n1 it is j + n2 (u (i - j)).
    cellExponent RowMajor (Position i j) = i * n2 + j
    cellExponent Diagonal (Position i j) =
      fromInteger
        ( toInteger j
            + toInteger n2 * ((inverseOf n2 n1 * (toInteger i - toInteger j)) `mod` toInteger n1)
        )
    product' a b = [[sum (zipWith (*) x y) | y <- transpose b] | x <- a]
    unit = [[if i == j then one else zero | j <- [1 .. n]] | i <- [1 .. n]]

-- | The inverse of a modulo m, which must be coprime; 0 modulo 1.
inverseOf :: Natural -> Natural -> Integer
inverseOf a m = go (toInteger m) 0 (toInteger a `mod` toInteger m) 1 `mod` toInteger m
  where
    -- The invariant: t a = r and t' a = r' modulo m.
    go :: Integer -> Integer -> Integer -> Integer -> Integer
    go _ t 0 _ = t
    go r t r' t' = go r' t' (r `mod` r') (t - (r `div` r') * t')

-- | Checks that the windows are distinct and have the stated digest.
checkDigest :: Profile -> Mask -> String -> Either Fault ()
checkDigest profile mask stated = do
  grid <- first ArrayFault (withProfile profile (\array _ -> toGrid array)) >>= first SizeFault
  computed <-
    maybe
      (Left RepeatedFault)
      Right
      (digestOfWindows (profilePacking profile) (profileSurface profile) grid mask)
  when (computed /= stated) (Left (DigestFault stated computed))

-- | Whether a number is known to be prime: it is among those proved before, which come first, or it
-- is below 'millerRabinDomain' and passes the strong test, which decides there.
knownPrime :: [Natural] -> Natural -> Bool
knownPrime shown n = n `elem` shown || n < millerRabinDomain && isPrime n == Right True

-- | Whether a proof shows its number to be prime by Pocklington's theorem. The list has the numbers
-- proved before. O(w log P) products modulo P for w witnesses.
isShownPrime :: [Natural] -> PrimeProof -> Bool
isShownPrime before (PrimeProof prime witnesses) =
  prime > 3
    && maybe False (\f -> f * f > prime && (prime - 1) `mod` f == 0) factored
    && all shows' witnesses
  where
    factored = boundedProduct prime [(l, e) | PrimeWitness l e _ <- witnesses]
    shows' (PrimeWitness l e a) =
      e > 0
        && knownPrime before l
        && powerModulo a (prime - 1) == 1
        && gcd prime (powerModulo a ((prime - 1) `div` l) + prime - 1) == 1
    -- This does not use the factorisation's function, so that the check is independent of what it
    -- checks.
    powerModulo a e
      | e == 0 = 1
      | odd e = a * powerModulo a (e - 1) `mod` prime
      | otherwise = let b = powerModulo a (e `div` 2) in b * b `mod` prime

-- | The product of powers, given by bases and exponents. 'Nothing' if it exceeds the bound, the
-- bases are not ascending and above 1, or an exponent is not positive.
boundedProduct :: Natural -> [(Natural, Natural)] -> Maybe Natural
boundedProduct bound powers
  | and
      ( zipWith
          (<)
          (map fst powers)
          (drop 1 (map fst powers))
      )
      && all (\(l, e) -> l > 1 && e > 0) powers =
    foldl' (\acc (l, e) -> acc >>= times l e) (Just 1) powers
  | otherwise = Nothing
  where
    times _ 0 acc = Just acc
    times l e acc
      | acc * l > bound = Nothing
      | otherwise = times l (e - 1) (acc * l)
