{-# LANGUAGE TypeApplications #-}

-- | Series of growing sizes, including worst cases, for criterion: how the cost of each part
-- grows.
module Bench.Ladder
  ( ladder,
  )
where

import Bench.Input
import Criterion.Main
import Data.Proxy (Proxy (..))
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Factorisation
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Locate (buildTable, tableSize)
import PraTactile.Polynomial
import PraTactile.Sequence
import PraTactile.Window
import PraTactile.Window.Proof

-- | Runs criterion, which reads the command line.
ladder :: IO ()
ladder =
  defaultMain
    [ bgroup
        "tables of a field"
        [ bench
            (show p ++ "^" ++ show (length f - 1))
            (whnf (\m -> either (const 0) id (withField p m fieldOrder)) f)
          | (p, f) <-
              [(2, [1, 1]), (2, [1, 1, 1]), (251, [245, 1]), (2, [1, 0, 1, 1, 1, 0, 0, 0, 1])]
        ],
      bgroup
        "products"
        [ bgroup "GF(4)" (map (products (Proxy @GF4)) sizes),
          bgroup "GF(9)" (map (products (Proxy @GF9)) sizes),
          bgroup "GF(256)" (map (products (Proxy @GF256)) sizes)
        ],
      bgroup
        "sequence, 2^16 terms"
        [ terms "GF(2), n = 16" (Proxy @GF2) 16,
          terms "GF(2), n = 64" (Proxy @GF2) 64,
          terms "GF(4), n = 12" (Proxy @GF4) 12,
          terms "GF(9), n = 6" (Proxy @GF9) 6,
          terms "GF(256), n = 4" (Proxy @GF256) 4
        ],
      bgroup
        "one cell, row-major"
        [ cell "GF(2), n = 16 (in memory)" (canonical (Proxy @GF2) 16),
          cell "GF(2), n = 32" (canonical (Proxy @GF2) 32),
          cell "GF(2), n = 64" (canonical (Proxy @GF2) 64),
          cell "GF(2), n = 128" (canonical (Proxy @GF2) 128),
          cell "GF(4), n = 32" (canonical (Proxy @GF4) 32),
          cell "GF(4), n = 64" (canonical (Proxy @GF4) 64),
          cell
            "GF(256), n = 8"
            ( sure
                ( checkPrimitive
                    (sure (polynomialFromCodes [232, 32, 17, 159, 27, 1, 174, 189, 1]))
                ) ::
                Primitive
                  GF256
            )
        ],
      bgroup
        "proof by enumeration"
        [ enumerated (show on) on folding shape window
          | (on, folding, shape, window) <-
              [ (Torus, Diagonal, Shape 15 17, Shape 2 2),
                (Torus, Diagonal, Shape 63 65, Shape 3 2),
                (Sheet, Diagonal, Shape 63 65, Shape 3 2),
                (TwistedTorus, RowMajor, Shape 15 273, Shape 2 3),
                (Torus, Diagonal, Shape 255 257, Shape 4 2),
                (Torus, Diagonal, Shape 1023 1025, Shape 5 2)
              ]
        ],
      bgroup
        "proof by rank, GF(2)"
        [ ranked 32 (Shape 65535 65537) (Shape 16 2),
          ranked 64 (Shape 255 ((2 ^ (64 :: Int) - 1) `div` 255)) (Shape 8 8),
          ranked 128 (Shape (2 ^ (64 :: Int) - 1) (2 ^ (64 :: Int) + 1)) (Shape 64 2)
        ],
      bgroup
        "first primitive polynomial"
        [ first "GF(2), n = 16" (Proxy @GF2) 16,
          first "GF(2), n = 64" (Proxy @GF2) 64,
          first "GF(2), n = 127" (Proxy @GF2) 127,
          first "GF(3), n = 10" (Proxy @GF3) 10,
          first "GF(4), n = 12" (Proxy @GF4) 12,
          first "GF(9), n = 8" (Proxy @GF9) 8,
          sure (withField 2 [1, 1, 0, 1, 1, 0, 1] (\k -> first "GF(64), n = 8" k 8)),
          first "GF(256), n = 4" (Proxy @GF256) 4,
          first "GF(256), n = 8" (Proxy @GF256) 8,
          first "GF(256), n = 12" (Proxy @GF256) 12,
          sure (withField 3 [1, 2, 0, 0, 0, 1] (\k -> first "GF(243), n = 10, the worst" k 10))
        ],
      bgroup
        "factors of 2^n - 1"
        [ bench (show n) (whnf (either (const 0) length . factorisePowerMinusOne 2) n)
          | n <- [32, 61, 64, 67, 96, 127, 128]
        ],
      bgroup
        "memory table"
        [ tabled (Shape 15 17) (Shape 2 2),
          tabled (Shape 63 65) (Shape 3 2),
          tabled (Shape 255 257) (Shape 4 2),
          tabled (Shape 63 266305) (Shape 3 4)
        ]
    ]
  where
    sizes = [1000, 100000, 10000000]

products :: forall k. KnownField k => Proxy k -> Int -> Benchmark
products k size =
  env (pure (Primitive.force (Primitive.take size (scrambled k 2654435761)))) $ \x ->
    bench (show size) (whnf (Primitive.zipWith (*) x) x)

canonical :: KnownField k => Proxy k -> Natural -> Primitive k
canonical _ n = sure (firstPrimitive n)

terms :: KnownField k => String -> Proxy k -> Natural -> Benchmark
terms name k n = bench name (whnf (sequenceVector h (canonicalState h)) 65536)
  where
    h = canonical k n

cell :: KnownField k => String -> Primitive k -> Benchmark
cell name h = bench name (whnf (cellAt array) (Position 0 (0x9E3779B97F4A7C15 `mod` period h)))
  where
    array = sure (fold RowMajor (Shape 1 (period h)) h (canonicalState h))

-- | An enumeration over GF(4). The area determines the degree.
enumerated :: String -> Surface -> Folding -> Shape -> Shape -> Benchmark
enumerated name on folding shape window =
  bench
    (sized shape ++ ", " ++ sized window ++ ", " ++ name)
    (whnf (either (const False) allDistinct . flip (enumerate on) mask) grid)
  where
    h = canonical (Proxy @GF4) (degree 1)
    degree n = if 4 ^ n - 1 == area shape then n else degree (n + 1 :: Natural)
    grid = sure (toGrid (sure (fold folding shape h (canonicalState h))))
    mask = sure (rectangle window)

ranked :: Natural -> Shape -> Shape -> Benchmark
ranked n shape window = bench (sized shape ++ ", " ++ sized window) (whnf (windowRank array) mask)
  where
    h = canonical (Proxy @GF2) n
    array = sure (fold Diagonal shape h (canonicalState h))
    mask = sure (rectangle window)

first :: forall k. KnownField k => String -> Proxy k -> Natural -> Benchmark
first name _ n =
  bench
    name
    ( whnf
        ( either (const 0) primitiveDegree
            . (firstPrimitive :: Natural -> Either PolynomialError (Primitive k))
        )
        n
    )

tabled :: Shape -> Shape -> Benchmark
tabled shape window =
  bench
    (sized shape ++ ", " ++ sized window)
    (whnf (either (const 0) tableSize . buildTable MostSignificantFirst (ArrayOn Torus array)) mask)
  where
    h = canonical (Proxy @GF4) (degree 1)
    degree n = if 4 ^ n - 1 == area shape then n else degree (n + 1 :: Natural)
    array = sure (fold Diagonal shape h (canonicalState h))
    mask = sure (rectangle window)

sized :: Shape -> String
sized (Shape n1 n2) = show n1 ++ " x " ++ show n2
