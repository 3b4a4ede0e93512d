-- | Benchmarks of packing faces: those of boxes in two orientations each, in one orientation as
-- the peer packs them, and ten thousand cubes.
module Bench.Packing
  ( packing,
  )
where

import Bench.Clock
import Bench.Input
import Control.Exception (evaluate)
import PraTactile.Object.Packing

-- | The measurements by name. The outer action prepares.
packing :: [(String, IO (IO Measurement))]
packing =
  [ ("packing-paper", laying (15, 17) (map block <$> paper)),
    ("packing-boxes", laying (255, 257) (map (map block) (faces 200))),
    ("packing-walked", laying (255, 257) (map (map block . take 1) (faces 200))),
    ("packing-cubes", laying (2047, 2049) (replicate 60000 [block (4, 5)]))
  ]
  where
    paper = replicate 6 [(4, 5)] ++ replicate 4 [(3, 7)] ++ replicate 2 [(3, 4)]

-- | The rows and columns of cells on the faces of the given number of boxes with sides of 100 to
-- 250 mm, each face in two orientations. Cells are 25.4 mm wide and 31.75 mm tall.
faces :: Int -> [[(Int, Int)]]
faces boxes =
  [ [cells w h, cells h w]
    | box <- [0 .. boxes - 1],
      (w, h) <- let (a, b, c) = sides box in [(a, b), (a, b), (a, c), (a, c), (b, c), (b, c)]
  ]
  where
    sides box = (side (3 * box), side (3 * box + 1), side (3 * box + 2))
    -- In eighths of a millimetre; a cell is 203.2 wide and 254 tall.
    side i = 800 + fromIntegral (mixed i `mod` 1201) :: Int
    cells wide high = (high `div` 254, wide * 5 `div` 1016)

-- | The number of these pieces that are laid on a sheet of the given rows and columns.
laying :: (Int, Int) -> [[BlockMask]] -> IO (IO Measurement)
laying (rows, columns) pieces = do
  _ <- evaluate (length (show pieces))
  pure $ do
    (seconds, laid) <- timed (counted . packed 1 (Sheet rows columns [])) pieces
    pure (Measurement seconds Seconds (show laid ++ " laid"))
  where
    counted outcome = case outcome of
      Packed laid -> sum [1 | Laid i (r, c) <- laid, i + r + c >= 0] :: Int
      _ -> 0
