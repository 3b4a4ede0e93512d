-- | Some of a list.
module PraTactile.Composite.Spaced
  ( spacedOut,
  )
where

-- | At most so many of a list, evenly.
spacedOut :: Int -> [a] -> [a]
spacedOut most xs
  | n <= most = xs
  | otherwise = [x | (k, x) <- zip [0 ..] xs, (k * most) `div` n /= ((k - 1) * most) `div` n]
  where
    n = length xs
