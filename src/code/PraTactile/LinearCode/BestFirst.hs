{-# OPTIONS_HADDOCK hide #-}

-- | Lists the words of independent letters by decreasing probability, lazily. Each option of each
-- letter has a cost, and the cost of a word is the sum of its options' costs.
module PraTactile.LinearCode.BestFirst
  ( bestFirst,
  )
where

import Data.List (sortOn)
import qualified Data.Map.Strict as Map

{- Note [Each word once]
   ~~~~~~~~~~~~~~~~~~~~~
   Sort the letters by the cost of their second option. Then changing a later letter instead of an
   earlier one never costs less. Take a word with some changed letters, the last of which is letter
   i. Define its unique predecessor:

   * If i has its third option or a later one, the word with the option before.
   * Else, if the letter before i is changed, the word in which i is not changed.
   * Else, the word in which the letter before i has its second option instead of i.

   No predecessor costs more than its successors. So all words come out in order if each word, when
   it comes out, adds its successors to the queue (E. L. Lawler 1972). -}

-- | All words, the cheapest first, each with its cost and its changed letters. Each letter is given
-- by its number and the ascending costs of its options, the first of which is 0. A changed letter,
-- one that does not have its first option, is listed with the option's index from 1.
bestFirst :: [(Int, [Double])] -> [(Double, [(Int, Int)])]
bestFirst letters = (0, []) : go (0 :: Int) Map.empty (starts 0 [] ordered)
  where
    ordered = sortOn (take 1 . drop 1 . snd) [(i, costs) | (i, costs@(_ : _ : _)) <- letters]
    -- The first of these letters gets its second option, in addition to the earlier changes.
    starts before changed later = case later of
      (i, _ : costs@(cost : _)) : rest -> [Changed (before + cost) before changed i 1 costs rest]
      _ -> []
    go made queue new = case Map.minViewWithKey added of
      Nothing -> []
      Just ((_, x), others) ->
        (changedCost x, (changedLetter x, changedOption x) : changedBefore x) :
        go count others (following x)
      where
        count = made + length new
        added = foldr (\(i, x) -> Map.insert (changedCost x, i) x) queue (zip [made ..] new)
    following x =
      dearer x
        ++ starts
          (changedCost x)
          ((changedLetter x, changedOption x) : changedBefore x)
          (changedLater x)
        ++ instead x
    dearer x =
      [ x
          { changedCost = changedRest x + cost,
            changedOption = changedOption x + 1,
            changedCosts = costs
          }
        | costs@(cost : _) <- [drop 1 (changedCosts x)]
      ]
    instead x =
      if changedOption x == 1 then starts (changedRest x) (changedBefore x) (changedLater x) else []

-- | A word, by its changed letters.
data Changed = Changed
  { -- | the word's cost
    changedCost :: !Double,
    -- | the cost without the last changed letter
    changedRest :: !Double,
    -- | the changed letters before the last one, each with its option's index
    changedBefore :: [(Int, Int)],
    -- | the number of the last changed letter
    changedLetter :: !Int,
    -- | the index of its option
    changedOption :: !Int,
    -- | the costs of that letter's options from this one on
    changedCosts :: [Double],
    -- | the letters after that one, as 'bestFirst' takes them
    changedLater :: [(Int, [Double])]
  }
