{-# LANGUAGE RankNTypes #-}

-- | All arrays of a size. For an alphabet and a degree n it lists every primitive polynomial, every
-- shape that its sequence fills, and every window of interest, with two results: whether the
-- windows are distinct, by both methods, and how many errors they can correct.
module PraTactile.Census
  ( -- * What is asked
    Scope (..),
    standardScope,
    scopeText,
    scopeShapes,
    scopeWindowsOf,
    scopePlaces,
    largestShapes,
    CensusError (..),

    -- * What there is
    census,
    censusSize,
    Entry (..),
  )
where

import Control.Monad (when)
import Data.Bifunctor (first)
import Data.List (intercalate, nub, sort)
import Data.Proxy (Proxy (..))
import Numeric.Natural (Natural)
import PraTactile.Advise.Layout (divisors)
import PraTactile.Array
import PraTactile.Factorisation
import PraTactile.Field
import PraTactile.Field.Named (conwayModulus, modulusDegrees)
import PraTactile.Polynomial
import PraTactile.Sequence
import PraTactile.Window
import PraTactile.Window.Distance
import PraTactile.Window.Proof

-- | The alphabet, degree, foldings and windows that a census covers.
data Scope = Scope
  { -- | q, the number of symbols
    scopeOrder :: Natural,
    -- | the modulus of GF(q)
    scopeModulus :: [Natural],
    -- | n: the sequences have q^n - 1 terms
    scopeDegree :: Natural,
    -- | how they are folded; the windows are those of the folding's natural surface
    scopeFoldings :: [Folding],
    -- | the windows; empty for the standard ones of 'scopeWindowsOf'
    scopeWindows :: [Shape]
  }
  deriving stock (Eq, Show)

-- | The scope of q and n with the default modulus, both foldings and the standard windows. Refuses
-- a q that is not a prime power up to 256.
standardScope :: Natural -> Natural -> Either CensusError Scope
standardScope q n = do
  (_, modulus) <- first CensusField (conwayModulus q)
  pure (Scope q modulus n [minBound .. maxBound] [])

-- | The scope as text; equal scopes have equal texts.
--
-- >>> scopeText <$> standardScope 4 4
-- Right "q=4 modulus=1,1,1 degree=4 foldings=diagonal,row-major windows=standard"
scopeText :: Scope -> String
scopeText scope =
  unwords
    [ "q=" ++ show (scopeOrder scope),
      "modulus=" ++ commas (map show (scopeModulus scope)),
      "degree=" ++ show (scopeDegree scope),
      "foldings="
        ++ commas
          [if folding == Diagonal then "diagonal" else "row-major" | folding <- foldingsOf scope],
      "windows="
        ++ if null (scopeWindows scope)
          then "standard"
          else commas (map byName (windowsOf scope))
    ]
  where
    commas = intercalate ","
    byName (Shape k1 k2) = show k1 ++ "x" ++ show k2

foldingsOf :: Scope -> [Folding]
foldingsOf = nub . sort . scopeFoldings

windowsOf :: Scope -> [Shape]
windowsOf = nub . sort . scopeWindows

-- | Why there is no census.
data CensusError
  = -- | There is no such alphabet.
    CensusField FieldError
  | -- | The modulus has the first degree, but it should have the second, m in q = p^m.
    CensusModulus Natural Natural
  | -- | There are no primitive polynomials of the degree, or they are unknown.
    CensusPolynomial PolynomialError
  | -- | There is no such window.
    CensusWindow WindowError
  | -- | Each sequence folds into this many shapes, more than the second number, 'largestShapes'.
    CensusTooManyShapes Natural Natural
  deriving stock (Eq, Show)

-- | The shapes that a sequence of q^n - 1 terms fills, by increasing number of rows, given the
-- prime factors of q^n - 1. Row by row every divisor gives a shape; along the diagonal the sides
-- must be coprime. O(d log d) for d divisors.
scopeShapes :: Folding -> [(Natural, Natural)] -> [Shape]
scopeShapes folding factors =
  [ shape
    | n1 <- divisors factors,
      let shape = Shape n1 (terms `div` n1),
      folding == RowMajor || coprime shape
  ]
  where
    terms = product [l ^ e | (l, e) <- factors]
    coprime (Shape n1 n2) = gcd n1 n2 == 1

-- | The windows of a scope that fit an array of this shape. The standard ones are the rectangles of
-- n cells, the fewest that can determine all positions, and those with one row or column more,
-- which can correct errors.
--
-- >>> let shown (Shape a b) = show a ++ "x" ++ show b
-- >>> map shown . (`scopeWindowsOf` Shape 15 17) <$> standardScope 4 4
-- Right ["1x4","1x5","2x2","2x3","2x4","3x2","4x1","4x2","5x1"]
scopeWindowsOf :: Scope -> Shape -> [Shape]
scopeWindowsOf scope (Shape n1 n2)
  | null (scopeWindows scope) =
    filter
      fits
      (nub (sort (concat [[Shape a b, Shape (a + 1) b, Shape a (b + 1)] | (a, b) <- sides])))
  | otherwise = filter fits (windowsOf scope)
  where
    n = scopeDegree scope
    sides = [(a, n `div` a) | a <- takeWhile (<= n) [1 ..], n `mod` a == 0]
    fits (Shape k1 k2) = k1 <= n1 && k2 <= n2

-- | The foldings, shapes and windows for each polynomial, in order. Entry i of a census has the one
-- with index i modulo their number. Refuses what 'censusSize' refuses. q^n - 1 is factored
-- ('factorisePowerMinusOne'); then O(d log d + p) for its d divisors and p places.
--
-- >>> length <$> (standardScope 4 4 >>= scopePlaces)
-- Right 104
scopePlaces :: Scope -> Either CensusError [(Folding, Shape, Shape)]
scopePlaces scope = overField scope (placesOver scope)

placesOver :: KnownField k => Scope -> Proxy k -> Either CensusError [(Folding, Shape, Shape)]
placesOver scope k = do
  shapes <- shapesOf k scope
  pure [(folding, shape, window) | (folding, shape) <- shapes, window <- scopeWindowsOf scope shape]

-- | An array and a window, with the results for them.
data Entry = Entry
  { -- | its number in the census, from 0
    entryNumber :: Natural,
    -- | the characteristic polynomial, as codes
    entryPolynomial :: [Natural],
    entryFolding :: Folding,
    entryShape :: Shape,
    entryWindow :: Shape,
    -- | whether the windows on the natural surface are distinct
    entryVerdict :: Either ProofError WindowVerdict,
    -- | the minimum distance between them
    entryDistance :: Either DistanceError Distance
  }
  deriving stock (Eq, Show)

-- | The number of entries of a census. Refuses what 'census' refuses. q^n - 1 is factored
-- ('factorisePowerMinusOne').
censusSize :: Scope -> Either CensusError Natural
censusSize scope = overField scope $ \k -> do
  places <- placesOver scope k
  polynomials <- first CensusPolynomial (countPrimitive k (scopeDegree scope))
  pure (polynomials * fromIntegral (length places))

-- | The entries of a census whose numbers satisfy the condition, computed lazily. They are ordered
-- by polynomial, then folding, shape and window. Refuses unknown alphabets, degree 0, degrees for
-- which q^n - 1 is not factored or has too many divisors, and invalid windows.
-- 'primitivePolynomials' finds the polynomials, including those whose entries are not wanted. Each
-- wanted entry costs 'prove' and 'minimumDistance'.
census :: (Natural -> Bool) -> Scope -> Either CensusError [Entry]
census wanted scope = overField scope (\k -> entriesOver k wanted scope)

entriesOver ::
  forall k.
  KnownField k =>
  Proxy k ->
  (Natural -> Bool) ->
  Scope ->
  Either CensusError [Entry]
entriesOver k wanted scope = do
  shapes <- shapesOf k scope
  masks <-
    traverse
      (\window -> (,) window <$> first CensusWindow (rectangle window))
      (nub (concatMap (scopeWindowsOf scope . snd) shapes))
  polynomials <- first CensusPolynomial (primitivePolynomials (scopeDegree scope))
  let arrays =
        [ array
          | h <- polynomials :: [Primitive k],
            (folding, shape) <- shapes,
            Right array <- [fold folding shape h (canonicalState h)]
        ]
      places =
        [ (array, window, mask)
          | array <- arrays,
            window <- scopeWindowsOf scope (arrayShape array),
            Just mask <- [lookup window masks]
        ]
  pure
    [ entryOf number array window mask
      | (number, (array, window, mask)) <- zip [0 ..] places,
        wanted number
    ]

-- | The entry with this number for an array and a window, given by its shape and its mask.
entryOf :: KnownField k => Natural -> PseudorandomArray k -> Shape -> Mask -> Entry
entryOf number array window mask =
  Entry
    { entryNumber = number,
      entryPolynomial = map (fromIntegral . toCode) (coefficients (primitivePolynomial h)),
      entryFolding = arrayFolding array,
      entryShape = arrayShape array,
      entryWindow = window,
      entryVerdict = fst <$> prove (ArrayOn (naturalSurface (arrayFolding array)) array) mask,
      entryDistance = minimumDistance array mask
    }
  where
    h = arrayPrimitive array

-- | The most divisors of q^n - 1 that are used, 2^16.
largestShapes :: Natural
largestShapes = 2 ^ (16 :: Int)

-- | The foldings with the shapes that they fill.
shapesOf :: KnownField k => Proxy k -> Scope -> Either CensusError [(Folding, Shape)]
shapesOf k scope = do
  when (scopeDegree scope == 0) (Left (CensusPolynomial PolynomialConstant))
  factors <-
    first (CensusPolynomial . OrderNotFactored) (factorisePowerMinusOne p (m * scopeDegree scope))
  let shapes = product [e + 1 | (_, e) <- factors]
  when (shapes > largestShapes) (Left (CensusTooManyShapes shapes largestShapes))
  pure [(folding, shape) | folding <- foldingsOf scope, shape <- scopeShapes folding factors]
  where
    p = fromIntegral (fieldCharacteristic k)
    m = fromIntegral (fieldDegree k)

-- | Brings the alphabet into scope.
overField ::
  Scope ->
  (forall k. KnownField k => Proxy k -> Either CensusError r) ->
  Either CensusError r
overField scope use = do
  (p, given, needs) <-
    first CensusField (modulusDegrees (scopeOrder scope) (take 10 (scopeModulus scope)))
  when (given /= needs) (Left (CensusModulus given needs))
  inField <- first CensusField (withField p (scopeModulus scope) use)
  inField
