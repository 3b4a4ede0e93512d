-- | What test vectors ask about networks: with numbers of few digits, so that the files are short.
module PraTactile.Conformance.Vectors.Network
  ( networkGroups,
  )
where

import PraTactile.Conformance.Question
import PraTactile.Conformance.Vectors.Inputs (Group (..), Kind (..))

-- | What is asked of an operation of networks.
networkGroups :: Operation -> [Group]
networkGroups operation = case operation of
  OfOutputs ->
    [ chosen
        "Images of one network, and of one with a unit a layer."
        [Outputs weights rows | weights <- [one, two], rows <- [flat, stroke, corner, noisy]],
      chosen
        "What is no network, and no image."
        [ Outputs weights rows
          | (weights, rows) <-
              [ (Weights [] [[1]], flat),
                (Weights (weightsHidden one) [], flat),
                (Weights (map (drop 1) (weightsHidden one)) (weightsOutput one), flat),
                (Weights (weightsHidden one) [[1, 2, 3]], flat),
                (one, drop 1 flat),
                (one, map (drop 1) flat),
                (one, replicate 8 (replicate 12 0))
              ]
        ]
    ]
  _ -> []
  where
    chosen source questions = Group source Chosen (map SomeQuestion questions)
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
