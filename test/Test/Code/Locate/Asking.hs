-- | The one question, as the tests ask it, and when an answer about probabilities is right.
module Test.Code.Locate.Asking
  ( -- * Asking
    On,
    Patches,
    ask,
    alone,
    symbolsOf,

    -- * Judging
    bayesHolds,
    listingHolds,
  )
where

import Data.List (sortOn)
import Data.Maybe (fromMaybe)
import Data.Ord (Down (..))
import PraTactile.Array
import PraTactile.Field
import PraTactile.Locate
import PraTactile.Symmetry
import PraTactile.Window
import Test.QuickCheck

-- | An array on a surface, with its window.
type On k = (Surface, PseudorandomArray k, Mask)

-- | Patches, each with its displacement.
type Patches a = [((Integer, Integer), Patch a)]

-- | The answer of a decoder about patches in these symmetries, with this radius and this doubt
-- tolerated. What is prepared for the array is so once.
ask ::
  KnownField k =>
  Maybe DecoderName ->
  On k ->
  [Symmetry] ->
  Radius ->
  Double ->
  Patches (Cell k) ->
  Either LocatorError Answer
ask decoder (surface, array, mask) =
  let theLocator = locator decoder MostSignificantFirst (ArrayOn surface array) mask
   in \possible radius tolerated patches ->
        locate theLocator (Query patches possible radius tolerated Nothing (-1 / 0) Nothing)

-- | One patch alone.
alone :: a -> [((Integer, Integer), a)]
alone p = [((0, 0), p)]

-- | Patches of symbols, as they are asked about.
symbolsOf :: Patches (GF k) -> Patches (Cell k)
symbolsOf = map (fmap (fmap Symbol))

-- | A posterior, and the outcome that it leads to with this doubt tolerated, hold of the exact
-- probabilities of all candidates.
bayesHolds ::
  (Eq place, Show place) =>
  [(place, Rational)] ->
  Double ->
  Posterior place ->
  Outcome place ->
  Property
bayesHolds exact tolerated found outcome =
  counterexample (show found {posteriorRanking = take 9 (posteriorRanking found)}) $
    conjoin
      [ maybe complete (listingHolds of' exact found) (posteriorUnlisted found),
        case outcome of
          Unique place _ ->
            property (near (of' place) highest && 1 - of' place <= tolerated + 1e-9)
          Ambiguous places _ ->
            property (length places > 1 && 1 - sum (map of' places) <= tolerated + 1e-9)
          AmbiguousMany count _ ->
            property (fromIntegral (length (filter (near highest . of' . fst) exact)) <= count)
          Refused Contradiction -> property (null exact)
          Refused why ->
            why === BelowThreshold
              .&&. (posteriorUnlisted found /= Nothing || 1 - highest > tolerated - 1e-9)
      ]
  where
    of' place = fromRational (fromMaybe 0 (lookup place exact)) :: Double
    highest = fromRational (maximum (0 : map snd exact))
    complete =
      conjoin
        [ length (posteriorRanking found) === length exact,
          property (and [near p (of' place) | (place, p) <- posteriorRanking found]),
          property $ case posteriorBest found of
            Nothing -> null exact
            Just best -> near (of' best) highest && near (posteriorDoubt found) (1 - of' best),
          property . and $
            zipWith
              (\(_, p) (_, p') -> near p (fromRational p'))
              (posteriorRanking found)
              (sortOn (Down . snd) exact)
        ]

-- | What a list says of the doubt, the margin and of what is not listed, holds of the exact
-- probabilities.
listingHolds ::
  (Eq place, Show place) =>
  (place -> Double) ->
  [(place, Rational)] ->
  Posterior place ->
  Double ->
  Property
listingHolds of' exact found unlisted =
  conjoin
    [ property (null exact || unlisted >= 1 - among (map fst (posteriorRanking found)) - 1e-9),
      property (and [p <= of' place + 1e-9 | (place, p) <- posteriorRanking found]),
      case posteriorBest found of
        Nothing -> posteriorRanking found === []
        Just best ->
          let others = [fromRational p | (other, p) <- exact, other /= best]
           in conjoin
                [ property (posteriorDoubt found >= 1 - of' best - 1e-9),
                  property $
                    maybe
                      True
                      (<= log (of' best / maximum (0 : others)) + 1e-9)
                      (posteriorMargin found),
                  property
                    ( null (posteriorEqual found)
                        || best `elem` posteriorEqual found
                          && posteriorEqualDoubt found >= 1 - among (posteriorEqual found) - 1e-9
                    ),
                  property (all (near (of' best) . of') (posteriorEqual found))
                ]
    ]
  where
    among = sum . map of'

near :: Double -> Double -> Bool
near a b = abs (a - b) < 1e-9
