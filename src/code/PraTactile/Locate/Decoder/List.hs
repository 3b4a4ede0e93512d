{-# OPTIONS_HADDOCK hide #-}

-- | Locates patches by probabilities on arrays of any size. The result is that of
-- "PraTactile.Locate.Decoder.Posterior", which compares with every position. Here a list of likely
-- words is made (M. P. C. Fossorier and S. Lin 1995). The surest independent cells are an
-- information set. Its contents are searched from the likeliest on; each determines all other
-- cells, and so the likelihood of the whole word. Further sets, from the remaining cells, are
-- searched in the same way. The total likelihood of unlisted positions is bounded, so the doubt is
-- never too small: see Note [What is not in the list] in "PraTactile.Locate.Decoder.List.Bounds".
module PraTactile.Locate.Decoder.List
  ( listPatch,
    standardListing,
  )
where

import PraTactile.Array
import PraTactile.Field
import PraTactile.Locate.Answer
import PraTactile.Locate.Belief
import PraTactile.Locate.Decoder.Algebra
import PraTactile.Locate.Decoder.List.Bounds
import PraTactile.Locate.Decoder.List.Letters
import PraTactile.Locate.Decoder.List.Result
import PraTactile.Locate.Decoder.List.Search
import PraTactile.Locate.Decoder.ObservedCode
import PraTactile.Locate.Patch
import PraTactile.Polynomial (period, primitiveDegree)
import PraTactile.Symmetry

-- | The most words that are searched, 2^16, which takes some tenths of a second.
standardListing :: Int
standardListing = 2 ^ (16 :: Int)

-- | @listPatch most tolerated algebra symmetries patch@ is the posterior of a patch as seen, from a
-- list of likely candidates. The list ends when the doubt is within the tolerated one or cannot
-- become so, or when the most words were searched. On the sheet, only positions with all observed
-- cells on it count. Refuses too many cells.
listPatch ::
  forall k.
  KnownField k =>
  Int ->
  Double ->
  Algebra k ->
  [Symmetry] ->
  Patch (Belief k) ->
  Either AlgebraError (Posterior Candidate)
listPatch most tolerated algebra possible observed
  | null known =
    Right
      impossible
        { posteriorMany = Just everything,
          posteriorEqualDoubt = 0,
          posteriorUnlisted = Just 0
        }
  | otherwise = summary setting <$> traverse branch shown
  where
    h = arrayPrimitive (algebraArray algebra)
    everything = case possible of
      [_] -> (period h, Just (fromIntegral (primitiveDegree h)))
      several -> (period h * fromIntegral (length several), Nothing)
    known = observedCells observed
    setting =
      Setting
        { settingMost = most,
          settingTolerated = tolerated,
          settingSheet = algebraSurface algebra == Sheet
        }
    -- A symmetry that a cell makes impossible has no words.
    shown = [o | o <- possible, all ((> 0) . symmetryChance o . snd) known]
    branch o =
      let letters = lettersIn o (map snd known)
       in branchOf letters
            <$> observedCode
              algebra
              [ onPosition (invert o) (patchShape observed) offset
                | (offset, _) <- surestFirst letters known
              ]
