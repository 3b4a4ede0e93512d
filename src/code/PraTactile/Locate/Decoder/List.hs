{-# OPTIONS_HADDOCK hide #-}

-- | Locating from probabilities on arrays of any size: what "PraTactile.Locate.Decoder.Posterior"
-- finds by comparing with every position, found in a list of likely words (M. P. C. Fossorier and
-- S. Lin 1995). The surest independent cells are an information set; its contents are gone through
-- from the likeliest on, each determines all other cells, and so how likely the whole word is.
-- Further sets, of the cells left, do likewise. How likely all positions are that are not in the
-- list is bounded, so that the doubt is never given too small: Note [What is not in the list] in
-- "PraTactile.Locate.Decoder.List.Bounds".
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

-- | 2^16: the most words that are looked at: some tenths of a second.
standardListing :: Int
standardListing = 2 ^ (16 :: Int)

-- | @listPatch most tolerated algebra symmetries patch@: the list of likely candidates of a patch
-- as it is seen, made until the doubt is at most as large as tolerated, or cannot become so, or
-- until the most words have been looked at. On the sheet, positions are those at which all observed
-- cells lie on it. Refuses too many cells.
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
