-- | This library's side of the comparisons of locating; "Bench.Ours" has the other comparisons.
module Bench.Locating
  ( locating,
  )
where

import Bench.Clock
import Bench.Input
import Control.Exception (evaluate)
import Data.List (sortOn)
import qualified Data.Vector.Primitive as Primitive
import Data.Word (Word32)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Locate
import PraTactile.Locate.Bulk
import PraTactile.Locate.Decision
import PraTactile.Locate.Decoder.Algebra
import PraTactile.Locate.Decoder.Codebook
import PraTactile.Locate.Decoder.InformationSet
import PraTactile.Locate.Decoder.List
import PraTactile.Locate.Decoder.Nearest
import PraTactile.Locate.Decoder.Posterior
import PraTactile.Polynomial
import PraTactile.Sequence
import PraTactile.Symmetry
import PraTactile.Window

-- | The measurements by name. The outer action prepares.
locating :: [(String, IO (IO Measurement))]
locating =
  [ ("bulk-15x17", bulk 4 (Shape 15 17) (Shape 2 2)),
    ("bulk-63x65", bulk 6 (Shape 63 65) (Shape 3 2)),
    ("bulk-63x266305", bulk 12 (Shape 63 266305) (Shape 3 4)),
    ("algebra-gf4-30", algebraEach),
    ("algebra-gf4-30-once", algebraOnce),
    ("decoding-gf4-30", decodingEach),
    ("decoding-gf4-30-once", decodingOnce),
    ("listing-gf4-30", listingEach),
    ("nearest-4x4", nearestEach),
    ("soft-4x4", softEach)
  ]

-- | The array of the first primitive polynomial.
arrayOf :: Natural -> Shape -> PseudorandomArray GF4
arrayOf n shape = sure (fold Diagonal shape h (canonicalState h))
  where
    h = sure (firstPrimitive n)

-- | The time to locate 10^7 windows on the torus by the table, without making the table.
bulk :: Natural -> Shape -> Shape -> IO (IO Measurement)
bulk n shape window = do
  memory <-
    evaluate
      ( memoryOf
          ( sure
              ( buildTable
                  MostSignificantFirst
                  (naturally (arrayOf n shape))
                  (sure (rectangle window))
              )
          )
      )
  let size = fromIntegral (memorySize memory)
  windows <-
    evaluate (Primitive.generate 10000000 (\i -> fromIntegral (mixed i `mod` size) :: Word32))
  pure $ do
    (seconds, places) <- timed (locateWindows memory) windows
    let weighted =
          Primitive.ifoldl' (\total i place -> total + i `mod` 257 * fromIntegral place) 0 places
    pure
      ( Measurement
          (fromIntegral (Primitive.length windows) / seconds)
          (PerSecond "windows")
          (show weighted)
      )

-- | An array of 2^60 - 1 cells, for a window of 15 x 2.
vast :: PseudorandomArray GF4
vast = arrayOf 30 (Shape (4 ^ (15 :: Int) - 1) (4 ^ (15 :: Int) + 1))

-- | The mean time over 64 windows from all over the array.
algebraEach :: IO (IO Measurement)
algebraEach = do
  algebra <- evaluate (sure (prepareAlgebra (ArrayOn Torus vast) (sure (rectangle (Shape 15 2)))))
  let places = [Position (part (2 * i) rows) (part (2 * i + 1) columns) | i <- [1 .. 64]]
      part i side = fromIntegral (mixed i) * 0x9e3779b9 `mod` side (arrayShape vast)
      at (Position r c) =
        sure
          (patch [[Just (cellAt vast (Position (r + i) (c + j))) | j <- [0, 1]] | i <- [0 .. 14]])
  patches <- mapM (evaluate . at) places
  pure $ do
    (seconds, _) <- timedEach (located . sure . algebraPatch algebra) 0 patches
    let wrong =
          length
            [ ()
              | (place, p) <- zip places patches,
                algebraPatch algebra p /= Right (Unique place [Position 0 0])
            ]
    pure (Measurement seconds Seconds (show wrong ++ " wrong"))

-- | The time of the algebra's computation once per array, with the first window.
algebraOnce :: IO (IO Measurement)
algebraOnce = do
  array <- evaluate vast
  window <-
    evaluate
      ( sure
          ( patch
              [ [Just (cellAt array (Position (123456789 + i) (987654321 + j))) | j <- [0, 1]]
                | i <- [0 .. 14]
              ]
          )
      )
  pure $ do
    (seconds, place) <-
      timed
        ( \mask ->
            located (sure (prepareAlgebra (naturally array) mask >>= (`algebraPatch` window)))
        )
        (sure (rectangle (Shape 15 2)))
    pure (Measurement seconds Seconds (show place))

-- | The offsets of 8 x 8 cells.
eight :: [Position]
eight = [Position i j | i <- [0 .. 7], j <- [0 .. 7]]

-- | Positions all over the large array with their 8 x 8 cells, and for each cell a number below
-- 2^32.
felt :: [(Position, [(GF GF4, Int)])]
felt =
  [ (place, zip (map (at place) eight) (map (\j -> fromIntegral (mixed (1000 * i + j))) [0 ..]))
    | i <- [1 .. 64],
      let place = Position (part (2 * i) rows) (part (2 * i + 1) columns)
  ]
  where
    part i side = fromIntegral (mixed i) * 0x9e3779b9 `mod` side (arrayShape vast)
    at (Position r c) (Position i j) = cellAt vast (Position (r + i) (c + j))

-- | The mean time over 64 patches of 8 x 8 cells, five of them wrong, without the preparation for
-- the cells.
decodingEach :: IO (IO Measurement)
decodingEach = do
  algebra <- evaluate (sure (prepareAlgebra (ArrayOn Torus vast) (sure (rectangle (Shape 15 2)))))
  ready <- evaluate (sure (decoder standardEffort algebra eight))
  _ <- evaluate (atLeast (decoderDistance ready))
  patches <- mapM (evaluate . sure . patch . square' . damage . snd) felt
  pure $ do
    (seconds, _) <-
      timedEach (located . decisionOutcome . sure . decodeWith ready Guaranteed) 0 patches
    let wrong =
          length
            [ ()
              | ((place, _), p) <- zip felt patches,
                fmap decisionOutcome (decodeWith ready Guaranteed p) /= Right (Unique place [])
            ]
    pure (Measurement seconds Seconds (show wrong ++ " wrong"))
  where
    damage cells =
      [Just (if i `elem` worst cells then a + 1 else a) | (i, (a, _)) <- zip [0 ..] cells]
    worst cells = map snd (take 5 (sortOn fst (zip (map snd cells) [0 :: Int ..])))

-- | The time of that preparation: the cells' code, its information sets, and the bound on its
-- distance.
decodingOnce :: IO (IO Measurement)
decodingOnce = do
  algebra <- evaluate (sure (prepareAlgebra (ArrayOn Torus vast) (sure (rectangle (Shape 15 2)))))
  pure $ do
    (seconds, d) <- timed (atLeast . decoderDistance . sure . decoder standardEffort algebra) eight
    pure (Measurement seconds Seconds (show d))

-- | The mean time over the same patches from probabilities, where in one of eight cells another
-- symbol is equally likely.
listingEach :: IO (IO Measurement)
listingEach = do
  algebra <- evaluate (sure (prepareAlgebra (ArrayOn Torus vast) (sure (rectangle (Shape 15 2)))))
  patches <- mapM (evaluate . sure . patch . square' . map (Just . doubtful) . snd) felt
  pure $ do
    (seconds, _) <-
      timedEach
        ( located
            . fmap candidatePosition
            . decide 0.001
            . sure
            . listPatch standardListing 0.001 algebra [identity]
        )
        0
        patches
    let refused =
          length
            [ ()
              | p <- patches,
                Refused _ <-
                  [decide 0.001 (sure (listPatch standardListing 0.001 algebra [identity] p))]
            ]
    pure (Measurement seconds Seconds (show refused ++ " refused"))
  where
    doubtful (a, x)
      | x `mod` 8 == 0 = sure (belief [if b == a || b == a + 1 then 0.49 else 0.01 | b <- elements])
      | otherwise = sure (belief [if b == a then 0.97 else 0.01 | b <- elements])

square' :: [a] -> [[a]]
square' cells = case splitAt 8 cells of
  (_, []) -> [cells]
  (line, others) -> line : square' others

-- | The row plus the column, fully evaluated; 1000 for a refusal.
located :: Outcome Position -> Natural
located outcome = case outcome of
  Unique (Position r c) _ -> r + c
  _ -> 1000

-- | The paper's array with everything that is computed before the first patch.
codebook :: Codebook GF4
codebook =
  sure (buildCodebook (naturally (arrayOf 4 (Shape 15 17))) (sure (rectangle (Shape 2 2))))

-- | 1000 patches of 4 x 4 cells of the paper's array, as codes, with 0 to 4 wrong cells, and a
-- number for each cell.
damaged :: [[(Int, Double)]]
damaged = map one' [0 .. 999]
  where
    one' i =
      [ ( ( toCode
              ( cellAt
                  (codebookArray codebook)
                  (Position (fromIntegral (r + a)) (fromIntegral (c + b)))
              )
              + wrong (4 * a + b)
          )
            `mod` 4,
          unit (4 * a + b)
        )
        | a <- [0 .. 3],
          b <- [0 .. 3]
      ]
      where
        at j = fromIntegral (mixed (32 * i + j)) :: Int
        (r, c) = (at 0 `mod` 255) `divMod` 17
        -- Up to four cells, some perhaps the same.
        wrong cell = sum [1 | j <- [1 .. i `mod` 5], at j `mod` 16 == cell]
        unit cell = fromIntegral (at (16 + cell)) / 4294967296

nearestEach :: IO (IO Measurement)
nearestEach = do
  patches <- mapM (evaluate . sure . patch . square . map (Just . sure . fromCode . fst)) damaged
  pure $ do
    (seconds, _) <- timedEach (answer . nearest codebook Guaranteed) 0 patches
    pure
      ( Measurement
          seconds
          Seconds
          (weightedSum (map (answer . nearest codebook Guaranteed) patches))
      )
  where
    answer found =
      packed (decisionOutcome found) + 1000 * length (corrected (decisionDistances found))

softEach :: IO (IO Measurement)
softEach = do
  patches <- mapM (evaluate . sure . patch . square . map (Just . doubtful)) damaged
  pure $ do
    (seconds, _) <- timedEach (answer . posterior codebook) 0 patches
    pure (Measurement seconds Seconds (weightedSum (map (answer . posterior codebook) patches)))
  where
    -- The probability of the symbol that was read: 0.5 to 0.95.
    doubtful (code, x) =
      sure (belief [if a == code then 0.5 + 0.45 * x else (0.5 - 0.45 * x) / 3 | a <- [0 .. 3]])
    -- The position, and whether the doubt is above 0.001.
    answer found = packed (decide 1 found) + 1000 * (if posteriorDoubt found > 0.001 then 1 else 0)

square :: [a] -> [[a]]
square cells = case splitAt 4 cells of
  (_, []) -> [cells]
  (line, others) -> line : square others

packed :: Outcome Position -> Int
packed outcome = case outcome of
  Unique (Position r c) _ -> fromIntegral (17 * r + c)
  _ -> -1

weightedSum :: [Int] -> String
weightedSum = show . sum . zipWith (*) [1 ..]
