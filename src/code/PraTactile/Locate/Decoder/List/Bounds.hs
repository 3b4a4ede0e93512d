{-# OPTIONS_HADDOCK hide #-}

-- | The words of a patch in each symmetry in which it may be seen, the next one where that lowers
-- most what is not in the list; and bounds of that: Note [What is not in the list].
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
   letters. Over all u the P(u) add up to 1, because each u stands for exactly one word. If the u
   that were gone through add up to M, the words that are not listed have in all a likelihood of at
   most

   (1 - M) times the largest possible R,

   and R is at most the product of the largest probability of each other cell. With further
   information sets C, ..., disjoint from B and each other, the largest possible R is smaller: a
   word that is not listed has not been gone through at C either, so that its letters at C have at
   most the probability of the next ones in the order there. This is so for each set in the place of
   B, and the least of the bounds holds. All likelihoods are in proportion to the probabilities of
   positions, which are equally likely beforehand. Where a set has been gone through to its end, as
   far as probabilities are not zero, every possible word is listed.

   In several symmetries each has a code and lists of its own. Beforehand they are equally likely,
   and each likelihood is a product over the same cells, so that likelihoods of different symmetries
   are in the same proportion to the probabilities of candidates. Where cells show how they lie,
   their probabilities together with the symmetry are the product of that of the symmetry and of
   those given it: all that was said above holds of the latter, and the likelihoods of the symmetry
   have the product of the former as a factor. So what is unlisted in all of them
   together is at most the sum of the bounds, and a word that is unlisted in any of them is at most
   as likely as the largest of the bounds for one word. The next word is taken where the bound is
   largest, because only that lowers the sum by much; so a symmetry in which nothing is likely is
   soon left alone.

   On the sheet some words are at no position. Which is looked up for the likeliest ones; of the
   others the likelihoods count as doubt all the same, which only adds to it. Sums of floating-point
   numbers: M is summed with a correction (W. Kahan 1965), and 1 - M is taken 1e-11 larger, more
   than what the logarithms and the correction can be wrong by in a set of some hundred cells. -}

-- | The words of one symmetry.
data Branch (k :: Field) = Branch
  { branchLetters :: !Letters,
    branchCode :: !(ObservedCode k),
    -- | At how many positions a word is that is not zero; zero is at one less.
    branchEach :: !Double,
    -- | The best that the cells of no set can be.
    branchOutside :: !Double,
    branchSources :: [Source k]
  }

type role Branch nominal

-- | The symmetry of its words.
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

-- | Of what is not listed: the logarithms of the likelihood of all words added up, and of the
-- likeliest one, at most.
data Bounds = Bounds {massBound :: !Double, wordBound :: !Double}

-- | What is not listed of a symmetry; 'Nothing' where everything possible is.
branchBounds :: Branch k -> Maybe Bounds
branchBounds branch
  | any sourceAtEnd sources = Nothing
  | otherwise =
    -- The second with more than the rounding of logarithms, so that equal likelihoods do not count
    -- as less.
    Just
      ( Bounds
          (shown + (unlistedMass sources outside + log (branchEach branch)))
          (shown + (sum (map nextMass sources) + outside + 1e-9))
      )
  where
    sources = branchSources branch
    outside = branchOutside branch
    shown = lettersShown (branchLetters branch)

-- | What is not listed of several symmetries.
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

-- | By Note [What is not in the list], given the best that the cells of no set can be.
unlistedMass :: [Source k] -> Double -> Double
unlistedMass sources outside = outside + minimum (0 : map bound (picked sources))
  where
    bound (s, others) = log (unseenMass s) + sum (map nextMass others)
    picked xs = case xs of
      [] -> []
      x : rest -> (x, rest) : [(y, x : others) | (y, others) <- picked rest]

-- | The next word of a symmetry: from the set where one word more lowers the logarithm of the bound
-- most. That is 1 - M for the surest set; for the others the probability of the next letters, which
-- falls about like a power of how many have been gone through.
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
