{-# OPTIONS_HADDOCK hide #-}

-- | The sequence and the array by definition: the recurrence and the folding formula.
module PraTactile.Conformance.Definition.Array
  ( -- * Arrays by definition
    ProfileFacts (..),
    Unknown (..),
    unknownText,
    known,
    positions,
    withTerms,
    recurrence,

    -- * Sequence and cells
    sequenceOf,
    termOf,
    cellOf,

    -- * Surfaces
    onSurface,
    canonical,
    ownSurface,
  )
where

import Data.List (foldl')
import Data.Maybe (fromMaybe)
import Data.Vector.Unboxed (Vector)
import qualified Data.Vector.Unboxed as Vector
import Numeric.Natural (Natural)
import PraTactile.Array (Folding (..), Shape (..), Surface (..))
import PraTactile.Conformance.Definition.Field
import PraTactile.Conformance.Definition.Polynomial
import PraTactile.Profile (Profile (..), Reading (..))

-- | Everything that follows from a profile, computed on first use.
data ProfileFacts = ProfileFacts
  { -- | The profile.
    knownProfile :: Profile,
    -- | Its field.
    knownField :: Field,
    -- | The numbers of rows and of columns.
    knownSize :: !(Int, Int),
    -- | A period of the sequence.
    knownTerms :: Vector Int,
    -- | The cells, row by row.
    knownCells :: Vector Int
  }

-- | All positions, row by row. The list is produced anew each time, so that it is never held in
-- memory.
positions :: ProfileFacts -> [(Int, Int)]
positions k = [(r, c) | r <- [0 .. n1 - 1], c <- [0 .. n2 - 1]]
  where
    (n1, n2) = knownSize k

-- | Why the definition is not available under a profile.
data Unknown
  = -- | The profile describes no array.
    NoArray
  | -- | Its array has more than 2^20 cells, for which the definition is too slow.
    TooManyCells
  deriving stock (Eq, Show)

-- | The reason in words.
unknownText :: Unknown -> String
unknownText why = case why of
  NoArray -> "this profile describes no array"
  TooManyCells ->
    "this profile's array has more than 2^20 cells; the definition, which answers are held \
    \against, is too slow for it"

-- | The array of a profile by definition. Refuses as 'Unknown' says.
known :: Profile -> Either Unknown ProfileFacts
known profile = do
  f <- maybe impossible Right (field (toInteger q) (map toInteger (profileModulus profile)))
  need (all (< q) (profilePolynomial profile ++ profileState profile))
  let stated = map fromIntegral (profilePolynomial profile)
      state = profileState profile
      n = degreeOf stated
  need (n >= 1 && n1 * n2 == q ^ n - 1)
  if n1 * n2 > 2 ^ (20 :: Int) then Left TooManyCells else Right ()
  need (isPrimitive f stated && length state == n && any (/= 0) state)
  need (profileFolding profile == RowMajor || gcd n1 n2 == 1)
  need (windowCells >= 1 && windowCells <= 4096)
  let size = (fromIntegral n1, fromIntegral n2)
      array = ProfileFacts profile f size Vector.empty Vector.empty
  pure (withTerms (uncurry (sequenceOf f) (recurrence array)) array)
  where
    q = profileOrder profile
    Shape n1 n2 = profileShape profile
    windowCells = rows (profileWindow profile) * columns (profileWindow profile)
    impossible = Left NoArray
    need holds = if holds then Right () else impossible

-- | Replaces the sequence of a profile; one period of it is folded.
withTerms :: [Int] -> ProfileFacts -> ProfileFacts
withTerms terms k =
  k {knownTerms = period, knownCells = folded (profileFolding (knownProfile k)) size period}
  where
    size = knownSize k
    period = Vector.fromListN (uncurry (*) size) terms

-- | The characteristic polynomial and the initial state.
recurrence :: ProfileFacts -> ([Int], [Int])
recurrence k = (characteristicOf (knownField k) (profileReading p) (take (n + 1) stated), state)
  where
    p = knownProfile k
    stated = map fromIntegral (profilePolynomial p)
    state = map fromIntegral (profileState p)
    n = length state

-- | The characteristic polynomial h(x). For a reciprocal one, x^n h(1/x) made monic.
characteristicOf :: Field -> Reading -> [Int] -> [Int]
characteristicOf f reading h = case reading of
  Characteristic -> h
  Reciprocal -> map (multiply f (inverseOf (sum (take 1 h)))) (reverse h)
  where
    inverseOf = fromMaybe 0 . inverse f

-- | The sequence of a field, a characteristic polynomial and a state: s(i+n) = - (c0 s(i) + ... +
-- c(n-1) s(i+n-1)). The polynomial has the constant term first.
sequenceOf :: Field -> [Int] -> [Int] -> [Int]
sequenceOf f h = concatMap (take 1) . iterate step
  where
    step state = drop 1 state ++ [negation f (foldl' (add f) 0 (zipWith (multiply f) h state))]

-- | The cells of the array, row by row, from the folding, the numbers of rows n1 and columns n2,
-- and a period of the sequence. Diagonal: a[i mod n1][i mod n2] = s(i). Row by row: a[r][c] = s(n2
-- r + c).
folded :: Folding -> (Int, Int) -> Vector Int -> Vector Int
folded folding (n1, n2) terms = case folding of
  RowMajor -> terms
  Diagonal ->
    Vector.replicate (n1 * n2) 0
      Vector.// [((i `mod` n1) * n2 + i `mod` n2, s) | (i, s) <- zip [0 ..] (Vector.toList terms)]

-- | s(i), for any i: the period is q^n - 1, because the polynomial is primitive.
termOf :: ProfileFacts -> Natural -> Int
termOf k i = knownTerms k Vector.! fromIntegral (i `mod` period)
  where
    period = fromIntegral (Vector.length (knownTerms k))

-- | The cell at any row and column, on the folding's own surface.
cellOf :: ProfileFacts -> Natural -> Natural -> Int
cellOf k r c = case profileFolding (knownProfile k) of
  Diagonal -> onSurface k Torus (r `modulo` n1) (c `modulo` n2)
  RowMajor -> termOf k (r * fromIntegral n2 + c)
  where
    (n1, n2) = knownSize k
    modulo a n = fromIntegral (a `mod` fromIntegral n)

-- | The folding's own surface: there the step to a neighbour advances the sequence by a constant
-- number of terms, also across the edges.
ownSurface :: ProfileFacts -> Surface
ownSurface k = case profileFolding (knownProfile k) of
  Diagonal -> Torus
  RowMajor -> TwistedTorus

-- | The code at a row and a column of a surface, which may be negative; -1 where there is no cell.
onSurface :: ProfileFacts -> Surface -> Int -> Int -> Int
onSurface k surface r c = case surface of
  Torus -> at (wrapped n1 r * n2 + wrapped n2 c)
  TwistedTorus -> at (wrapped (n1 * n2) (r * n2 + c))
  Sheet -> if r >= 0 && r < n1 && c >= 0 && c < n2 then at (r * n2 + c) else -1
  where
    (n1, n2) = knownSize k
    at = (knownCells k Vector.!)
    -- The remainder; the division is skipped where it changes nothing.
    wrapped side a = if a >= 0 && a < side then a else a `mod` side
{-# INLINE onSurface #-}

-- | The canonical position of a row and a column on a surface; unchanged on the sheet.
canonical :: ProfileFacts -> Surface -> (Int, Int) -> (Int, Int)
canonical k surface (r, c) = case surface of
  Torus -> (r `mod` n1, c `mod` n2)
  TwistedTorus -> ((r * n2 + c) `mod` (n1 * n2)) `divMod` n2
  Sheet -> (r, c)
  where
    (n1, n2) = knownSize k
