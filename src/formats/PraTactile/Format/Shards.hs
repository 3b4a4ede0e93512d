{-# OPTIONS_HADDOCK hide #-}

-- | Shards: files that each hold some numbered parts of a whole.
module PraTactile.Format.Shards
  ( together,
    PartsError (..),
  )
where

import Control.Monad (foldM, unless)
import qualified Data.Map.Strict as Map
import Numeric.Natural (Natural)

-- | Why shards do not form a whole.
data PartsError
  = -- | This part is in both files. They may be the same file.
    PartTwice Natural FilePath FilePath
  | -- | Of this number of parts some are missing: those from the first to the second number of
    -- each pair, ascending.
    PartsMissing Natural [(Natural, Natural)]
  deriving stock (Eq, Show)

-- | All parts in order. The arguments are the number of the first part, the number of parts, and
-- the parts with their files and numbers. Refuses missing and repeated parts. Numbers before the
-- first part or after the last are not checked: callers must exclude them.
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
