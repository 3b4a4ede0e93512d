{-# OPTIONS_HADDOCK hide #-}

-- | The inputs of test vectors about networks. Numbers have few digits, so that the files are
-- short.
module PraTactile.Conformance.Vectors.Network
  ( outputsGroups,
  )
where

import PraTactile.Conformance.Operation (Group (..), Inputs (..))
import PraTactile.Conformance.Question

outputsGroups :: [Group (Weights, Values)]
outputsGroups =
  [ Group
      "Images of one network, and of one with a unit a layer."
      (Chosen [(weights, rows) | weights <- [one, two], rows <- [flat, stroke, corner, noisy]]),
    Group
      "What is no network, and no image."
      ( Chosen
          [ (Weights [] [[1]], flat),
            (Weights (weightsHidden one) [], flat),
            (Weights (map (drop 1) (weightsHidden one)) (weightsOutput one), flat),
            (Weights (weightsHidden one) [[1, 2, 3]], flat),
            (one, drop 1 flat),
            (one, map (drop 1) flat),
            (one, replicate 8 (replicate 12 0))
          ]
      )
  ]
  where
    one = Weights [[fromIntegral (k * 7 `mod` 5 - 2) / 8 | k <- [0 .. 96 :: Int]]] [[2, -1]]
    two =
      Weights
        [ [fromIntegral (k * m `mod` 7 - 3) / 10 | k <- [0 .. 96 :: Int]]
          | m <- [3, 11 :: Int]
        ]
        [[1, -1, 0.5], [-2, 0.5, 0], [0.5, 1, -1]]
    flat = image (\_ _ -> 0)
    stroke = image (\_ c -> if c `elem` [2, 3] then 1 else 0)
    corner = image (\r c -> if r < 4 || c > 5 then 1 else 0)
    noisy = image (\r c -> fromIntegral ((r * 5 + c * 3) `mod` 7 - 1) / 5)
    image :: (Int -> Int -> Double) -> Values
    image f = [[f r c | c <- [0 .. 7]] | r <- [0 .. 11]]
