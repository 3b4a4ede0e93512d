{-# OPTIONS_HADDOCK hide #-}

-- | Shards: files that each have some of the numbered parts of a whole.
module PraTactile.Format.Shards
  ( together,
    PartsError (..),
  )
where

import Control.Monad (foldM, unless)
import qualified Data.Map.Strict as Map
import Numeric.Natural (Natural)

-- | Why parts are not a whole.
data PartsError
  = -- | This part is in both files; they may be the same file.
    PartTwice Natural FilePath FilePath
  | -- | Of this number of parts, those from the first to the second number of each pair, ascending,
    -- are missing.
    PartsMissing Natural [(Natural, Natural)]
  deriving stock (Eq, Show)

-- | All parts in order, given the number of the first one and how many there are; each with the
-- file that it is in and its number. There must be each of them once.
together :: Natural -> Natural -> [(FilePath, Natural, a)] -> Either PartsError [a]
together start count given = do
  found <- foldM insert Map.empty given
  let missing =
        [ (a, b - 1)
          | (a, b) <- zip (start : map (+ 1) (Map.keys found)) (Map.keys found ++ [start + count]),
            a < b
        ]
  unless (null missing) (Left (PartsMissing count missing))
  pure (map snd (Map.elems found))
  where
    insert found (file, number, part) = case Map.lookup number found of
      Just (file', _) -> Left (PartTwice number file' file)
      Nothing -> Right (Map.insert number (file, part) found)
