{-# OPTIONS_HADDOCK hide #-}

-- | The search for words of a patch in each possible symmetry, and bounds on what is unlisted: see
-- Note [What is not in the list].
module PraTactile.Locate.Decoder.List.Bounds
  ( -- * Words of a symmetry
    Branch (..),
    branchSymmetry,
    branchOf,
    step,

    -- * Bounds
    Bounds (..),
    branchBounds,
    allBounds,
  )
where

import Data.List (maximumBy, minimumBy)
import Data.Ord (comparing)
import Data.Proxy (Proxy (..))
import qualified Data.Vector as Boxed
import qualified Data.Vector.Primitive as Primitive
import PraTactile.Field
import PraTactile.LinearCode.Elimination
import PraTactile.LinearCode.InformationSet
import PraTactile.Locate.Decoder.List.Letters
import PraTactile.Locate.Decoder.List.Source
import PraTactile.Locate.Decoder.ObservedCode
import PraTactile.Symmetry

{- Note [What is not in the list]
   ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
   The likelihood of a word is the product of the probabilities of its letters. Let B be an
   information set, P(u) the product for the letters u at B, and R the product for all other
   letters. Over all u the P(u) add up to 1, because each u belongs to exactly one word. If the u
   searched so far add up to M, the unlisted words have a total likelihood of at most

     (1 - M) times the largest possible R,

   and R is at most the product of the largest probabilities of the other cells. Further information
   sets C, ..., disjoint from B and each other, lower the largest possible R: an unlisted word was
   not searched at C either, so its letters at C have at most the probability of the next ones in
   C's order. This holds with each set in the role of B, and the smallest bound is used. Likelihoods
   are proportional to the probabilities of positions, since the prior is uniform. If a set has been
   searched to its end, as far as probabilities are not zero, every possible word is listed.

   With several symmetries, each has its own code and lists. Their prior is uniform too, and each
   likelihood is a product over the same cells, so likelihoods of different symmetries are
   comparable. If cells show their symmetry, a joint probability is that of the symmetry times that
   of the symbol given the symmetry. The bounds hold for the latter; the likelihoods of a symmetry
   get the product of the former as a factor. So the total that is unlisted is at most the sum of
   the bounds, and an unlisted word is at most as likely as the largest bound for one word. The next
   word is taken in the symmetry with the largest bound, because only that lowers the sum much;
   symmetries in which nothing is likely are soon left alone.

   On the sheet some words have no position. The likeliest words are checked for that; the
   likelihoods of the others count as doubt, which is then only larger. Rounding: M is summed with
   compensation (W. Kahan 1965), and 1 - M is increased by 1e-11, more than the error of the
   logarithms and the summation in a set of some hundred cells. -}

-- | The words of one symmetry.
data Branch (k :: Field) = Branch
  { branchLetters :: !Letters,
    branchCode :: !(ObservedCode k),
    -- | The number of positions of a nonzero word; the zero word has one less.
    branchEach :: !Double,
    -- | The largest log-probability of the cells that are in no set.
    branchOutside :: !Double,
    branchSources :: [SetSearch k]
  }

type role Branch nominal

-- | The symmetry of a branch's words.
branchSymmetry :: Branch k -> Symmetry
branchSymmetry = lettersSymmetry . branchLetters

-- | The words of a symmetry, given the letters of its code.
branchOf :: forall k. KnownField k => Letters -> ObservedCode k -> Branch k
branchOf letters code =
  Branch
    { branchLetters = letters,
      branchCode = code,
      branchEach = fromIntegral (fieldOrder (Proxy :: Proxy k) :: Int) ^ wordFreedom code,
      branchOutside = sum [Primitive.maximum x | (i, x) <- zip [0 ..] ordered, i `notElem` taken],
      branchSources = map (sourceOf (Boxed.fromList ordered)) sets
    }
  where
    ordered = lettersGiven letters
    sets = filter ((== 0) . setDeficit) (informationSets (length ordered) (codeRows code))
    taken = concatMap (Primitive.toList . setPlaces) sets

-- | Upper bounds on the log-likelihood of unlisted words: of all together, and of the likeliest
-- one.
data Bounds = Bounds {massBound :: !Double, wordBound :: !Double}

-- | The bounds for one symmetry; 'Nothing' if everything possible is listed.
branchBounds :: Branch k -> Maybe Bounds
branchBounds branch
  | any sourceAtEnd sources = Nothing
  | otherwise =
    -- The second bound allows for rounding of the logarithms, so that equal likelihoods do not
    -- count as less.
    Just
      ( Bounds
          (shown + (unlistedMass sources outside + log (branchEach branch)))
          (shown + (sum (map nextMass sources) + outside + 1e-9))
      )
  where
    sources = branchSources branch
    outside = branchOutside branch
    shown = lettersShown (branchLetters branch)

-- | The bounds for several symmetries together.
allBounds :: [Bounds] -> Maybe Bounds
allBounds several = case several of
  [] -> Nothing
  [only] -> Just only
  _
    | isInfinite most -> Just (Bounds most word)
    | otherwise -> Just (Bounds (most + log (sum [exp (massBound b - most) | b <- several])) word)
  where
    most = maximum (map massBound several)
    word = maximum (map wordBound several)

-- | The log-bound of Note [What is not in the list] on all unlisted words. The number is the
-- largest log-probability of the cells in no set.
unlistedMass :: [SetSearch k] -> Double -> Double
unlistedMass sources outside = outside + minimum (0 : map bound (picked sources))
  where
    bound (s, others) = log (unseenMass s) + sum (map nextMass others)
    picked xs = case xs of
      [] -> []
      x : rest -> (x, rest) : [(y, x : others) | (y, others) <- picked rest]

-- | The next word of a symmetry, from the set where one more word lowers the logarithm of the bound
-- most. For the surest set that is by 1 - M; for the others by the probability of the next letters,
-- which falls roughly like a power of the number of searched words.
step :: KnownField k => Branch k -> Maybe (Row k, Branch k)
step branch = case splitAt next sources of
  (before, source : after) ->
    let (word, advanced) = advance source
     in Just (word, branch {branchSources = before ++ advanced : after})
  _ -> Nothing
  where
    sources = branchSources branch
    next =
      snd (maximumBy (comparing fst) ((-1 / 0, 0) : [(gain i s, i) | (i, s) <- zip [0 ..] sources]))
    gain i s
      | i == surest = exp (nextMass s) / unseenMass s
      | otherwise =
        let n = fromIntegral (sourceCount s)
         in nextLoss s / ((n + 1) * log (n + 2))
    surest = snd (minimumBy (comparing fst) ((1 / 0, -1) : zip (map unsureness sources) [0 ..]))
    unsureness s = log (unseenMass s) - nextMass s
