{-# OPTIONS_HADDOCK hide #-}

-- | Patches for test vectors: pieces of the array with missing and wrong cells.
module PraTactile.Conformance.Vectors.Patches
  ( patchAt,
    somePatch,
    someChances,
  )
where

import Control.Monad (replicateM)
import Data.List (sort)
import Numeric.Natural (Natural)
import PraTactile.Array (Shape (..), naturalsBelow)
import PraTactile.Conformance.Definition.Array
import PraTactile.Conformance.Question
import PraTactile.Conformance.Vectors.Draw
import PraTactile.Profile (Profile (..))

-- | The array's cells in a rectangle at a position, on the folding's own surface.
patchAt :: ProfileFacts -> Natural -> Natural -> Shape -> Patch
patchAt k r c (Shape high wide) =
  [ [Just (fromIntegral (cellOf k (r + i) (c + j))) | j <- naturalsBelow wide]
    | i <- naturalsBelow high
  ]

-- | A patch about as large as the window, with none or some cells missing, and none or some wrong.
somePatch :: ProfileFacts -> Draw Patch
somePatch k = do
  r <- below n1
  c <- below n2
  shape <- Shape <$> around high <*> around wide
  missing <- chosen 0 [0, 10, 30, 70]
  wrong <- chosen 0 [0, 5, 20]
  traverse (traverse (damaged missing wrong)) (patchAt k r c shape)
  where
    Shape n1 n2 = profileShape (knownProfile k)
    Shape high wide = profileWindow (knownProfile k)
    around n = chosen n [n, n + 1, n + 1, n + 2]
    damaged missing wrong cell =
      shareOf missing (pure Nothing) $
        shareOf wrong (Just <$> below (profileOrder (knownProfile k))) (pure cell)

-- | Knowledge of the cells of a patch: a certain symbol, or the probabilities of all or of two
-- symbols in 64ths.
someChances :: ProfileFacts -> Patch -> Draw Chances
someChances k = traverse (traverse chance)
  where
    q = profileOrder (knownProfile k)
    chance cell = case cell of
      Nothing -> pure Unfelt
      Just a
        | q > 16 -> pure (Certainly a)
        | otherwise ->
          below 3 >>= \kind -> case kind of
            0 -> pure (Certainly a)
            1 -> Probably . oneOfTwo a <$> below q
            _ -> Probably <$> ofAll
    oneOfTwo a b = [is c a 0.75 + is c b 0.25 | c <- naturalsBelow q]
    is c a share = if c == a then share else 0
    ofAll = do
      cuts <- sort <$> replicateM (fromIntegral q - 1) (below 65)
      pure (map ((/ 64) . fromIntegral) (zipWith (-) (cuts ++ [64]) (0 : cuts)))
