{-# LANGUAGE DataKinds #-}
{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE KindSignatures #-}
{-# LANGUAGE RoleAnnotations #-}
{-# LANGUAGE ScopedTypeVariables #-}

-- |
-- Locating from probabilities: of each cell is known how likely each symbol is, and what follows is
-- how likely each position is (Bayes' theorem). Exact: the patch is compared with every position.
--
-- A cell's probabilities are those that a classifier gives on seeing its image when all symbols are
-- equally frequent, independently of other cells'; all positions are equally likely beforehand. Then
-- the probability of a position is proportional to the product of the probabilities of the symbols that
-- it would have in the observed cells.
module PraTactile.Locate.Soft
  ( -- * What is known of a cell
    Belief
  , belief
  , certainly
  , combined
  , likeliest
  , probabilities
  , possibleIn
  , isCertain
  , BeliefError (..)

    -- * What is known of a patch
  , SoftPatch
  , softPatch
  , softPatchWith
  , softShape
  , softRows
  , softCells
  , softShape
  , hardened

    -- * Positions
  , posterior
  , Posterior
  , PosteriorOver (..)
  , likelihoods
  , ranked

    -- * Deciding
  , decide
  , decideAmong
  ) where

import Data.List (foldl', sortOn)
import qualified Data.Map.Lazy as Map
import Data.Ord (Down (..))
import Data.Proxy (Proxy (..))
import qualified Data.Vector.Primitive as Primitive
import PraTactile.Field
import PraTactile.Grid
import PraTactile.Locate.Book
import PraTactile.Locate.Outcome
import PraTactile.Locate.Patch

-- | The probability of each symbol in a cell, by its code; they add up to 1.
newtype Belief (k :: Field) = Belief (Primitive.Vector Double)
  deriving stock (Eq, Show)

type role Belief nominal

-- | Why numbers are no probabilities.
data BeliefError
  = -- | There are so many numbers, and so many symbols.
    BeliefLength Int Int
  | -- | The number at this index, from 0, is negative, or none.
    BeliefNegative Int Double
  | -- | The numbers add up to this, which is not 1 within 0.001.
    BeliefSum Double
  deriving stock (Eq, Show)

-- | The probabilities of the symbols, by their codes. Refuses another number of them than there are symbols,
-- negative ones, and a sum that is not 1 within 0.001; that much, which printing may have cost,
-- is put right.
belief :: forall k. KnownField k => [Double] -> Either BeliefError (Belief k)
belief numbers
  | given /= q = Left (BeliefLength given q)
  | (i, x) : _ <- filter (not . (>= 0) . snd) (zip [0 ..] numbers) = Left (BeliefNegative i x)
  | not (abs (total - 1) <= 0.001) = Left (BeliefSum total)
  | otherwise = Right (Belief (Primitive.fromListN q (map (/ total) numbers)))
 where
  q = fieldOrder (Proxy :: Proxy k)
  given = length (take (q + 1) numbers)
  total = sum numbers

-- | No doubt.
certainly :: forall k. KnownField k => GF k -> Belief k
certainly a = Belief (Primitive.generate (fieldOrder (Proxy :: Proxy k)) (\code -> if code == toCode a then 1 else 0))

-- | What several independent looks at one cell say together: the product of their probabilities, made to add up to 1. 'Nothing' if
-- that is zero for every symbol, so that the looks contradict each other, and of no looks.
combined :: [Belief k] -> Maybe (Belief k)
combined looks = case looks of
  [] -> Nothing
  [only] -> Just only
  Belief first' : others
    | Primitive.null logs || isInfinite best -> Nothing
    | otherwise -> Just (Belief (Primitive.map (/ Primitive.sum relative) relative))
   where
    -- By logarithms, so that products of small numbers do not vanish.
    logs = foldl' (Primitive.zipWith (+)) (Primitive.map log first') [Primitive.map log b | Belief b <- others]
    best = Primitive.maximum logs
    relative = Primitive.map (\x -> exp (x - best)) logs

-- | The likeliest symbol, the one of the lowest code if several are.
likeliest :: KnownField k => Belief k -> GF k
likeliest (Belief numbers) = either (const zero) id (fromCode (Primitive.maxIndex numbers))

-- | The probabilities of the symbols, by their codes.
probabilities :: Belief k -> Primitive.Vector Double
probabilities (Belief numbers) = numbers

-- | Whether a symbol has a probability above 0.
possibleIn :: GF k -> Belief k -> Bool
possibleIn a (Belief numbers) = maybe False (> 0) (numbers Primitive.!? toCode a)

-- | Whether one symbol alone has a probability above 0.
isCertain :: Belief k -> Bool
isCertain (Belief numbers) = Primitive.length (Primitive.filter (> 0) numbers) == 1

-- | A rectangle of cells of which something is known, and of such of which nothing is.
data SoftPatch (k :: Field) = SoftPatch
  { softShape :: !Shape
  -- ^ Its rows and columns; at least one each.
  , softRows :: [[Maybe (Belief k)]]
  -- ^ The rows, as 'softPatch' takes them; made when first asked for, because few cells far apart make large ones.
  , softCells :: [(Position, Belief k)]
  -- ^ What is known of the cells, by their offsets, row by row.
  }

type role SoftPatch nominal

-- | The patch with these rows; 'Nothing' is a cell that was not observed. Refuses no cells and rows
-- of different lengths.
softPatch :: [[Maybe (Belief k)]] -> Either LocateError (SoftPatch k)
softPatch cells = (\shape -> SoftPatch shape cells known) <$> rectangular cells
 where
  known = [(Position i j, b) | (i, line) <- zip [0 ..] cells, (j, Just b) <- zip [0 ..] line]

-- | The patch of this shape, at least one cell, in which these cells, row by row and all of them within it, are known.
softPatchWith :: Shape -> [(Position, Belief k)] -> SoftPatch k
softPatchWith shape known = SoftPatch shape cells known
 where
  cells = [[Map.lookup (Position i j) beliefs | j <- below (columns shape)] | i <- below (rows shape)]
  beliefs = Map.fromDistinctAscList known
  below n = takeWhile (< n) [0 ..]

-- | The patch with the 'likeliest' symbol of each observed cell.
hardened :: KnownField k => SoftPatch k -> Either LocateError (Patch k)
hardened observed = patch (map (map (fmap likeliest)) (softRows observed))

-- | How likely positions are.
type Posterior = PosteriorOver Position

-- | How likely places are: positions, or positions with an orientation.
data PosteriorOver place = Posterior
  { posteriorBest :: Maybe place
  -- ^ The likeliest position, the first of them if several are; 'Nothing' if none is possible.
  , posteriorDoubt :: Double
  -- ^ The probability that it is another one: 1 less the best's, without the rounding of that difference.
  , posteriorEqual :: [place]
  -- ^ The positions that are exactly as likely as the best, itself among them.
  , posteriorEqualDoubt :: Double
  -- ^ The probability that it is none of those.
  , posteriorMargin :: Maybe Double
  -- ^ The logarithm of how many times as likely the best is as the next one; infinite if no other one is
  -- possible, 'Nothing' if there is no other one.
  , posteriorRanking :: [(place, Double)]
  -- ^ All positions with their probabilities, the likeliest first; made when asked for.
  }
  deriving stock (Eq, Show)

-- | How likely each position of the book is; on the sheet those at which all observed cells lie on it.
posterior :: Book k -> SoftPatch k -> Posterior
posterior shelf observed = ranked (comparedPosition comparison) (comparedTotals comparison)
 where
  comparison = likelihoods shelf (softCells observed)

-- | The logarithms of what the probabilities of positions are proportional to, given what is known of cells by their offsets.
likelihoods :: Book k -> [(Position, Belief k)] -> Comparison Double
likelihoods shelf known =
  compareWith shelf [(offset, Primitive.map log numbers) | (offset, Belief numbers) <- known]

-- | How likely places are, given by their indices, from the logarithms of what their probabilities are proportional to.
ranked :: (Int -> place) -> Primitive.Vector Double -> PosteriorOver place
ranked placeAt logs
  | count == 0 || isInfinite best = Posterior Nothing 1 [] 1 Nothing []
  | otherwise =
      Posterior
        { posteriorBest = Just (placeAt bestIndex)
        , posteriorDoubt = others / (1 + others)
        , posteriorEqual = map placeAt equal
        , posteriorEqualDoubt = less / (fromIntegral (length equal) + less)
        , posteriorMargin = if count == 1 then Nothing else Just (best - next)
        , posteriorRanking = sortOn (Down . snd) (zipWith (\i x -> (placeAt i, x / (1 + others))) [0 ..] (Primitive.toList relative))
        }
 where
  count = Primitive.length logs
  bestIndex = Primitive.maxIndex logs
  best = logs Primitive.! bestIndex
  -- Relative to the best one, so that products of many small numbers do not vanish.
  relative = Primitive.map (\x -> exp (x - best)) logs
  others = Primitive.sum (Primitive.imap (\i x -> if i == bestIndex then 0 else x) relative)
  less = Primitive.sum (Primitive.zipWith (\x y -> if x == best then 0 else y) logs relative)
  equal = [i | (i, x) <- zip [0 ..] (Primitive.toList logs), x == best]
  next = Primitive.maximum (Primitive.imap (\i x -> if i == bestIndex then -1 / 0 else x) logs)

-- | @decide tolerated@: the likeliest position, if the probability that it is another one is at most
-- as large as tolerated; then of many answers at most that share is wrong, if the probabilities are honest. Several positions
-- equally likely, of which the same holds together, are 'Ambiguous'. Else 'BelowThreshold'; 'Contradiction' where
-- no position is possible.
decide :: Double -> Posterior -> Outcome
decide tolerated found = case decideAmong tolerated found of
  Right [place] -> Located place []
  Right places -> Ambiguous places []
  Left reason -> Refused reason

-- | The same of any places: the one or the several that are told, or the reason to refuse.
decideAmong :: Double -> PosteriorOver place -> Either Reason [place]
decideAmong tolerated found = case posteriorBest found of
  Nothing -> Left Contradiction
  Just place
    | posteriorDoubt found <= tolerated -> Right [place]
    | _ : _ : _ <- posteriorEqual found, posteriorEqualDoubt found <= tolerated -> Right (posteriorEqual found)
    | otherwise -> Left BelowThreshold
