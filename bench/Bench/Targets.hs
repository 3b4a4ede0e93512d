-- | The performance targets of the library, with the programs that it is compared with.
module Bench.Targets
  ( -- * Targets
    Target (..),
    Goal (..),
    targets,

    -- * Peers
    Peer (..),
  )
where

-- | The goal of a measurement.
data Goal
  = -- | At least this many times as fast as the peer, by the median of the ratios of paired runs.
    TimesAsFast Double Peer
  | -- | At most this many seconds, by the median.
    WithinSeconds Double
  | -- | At least this rate per second, by the median.
    AtLeast Double
  | -- | At most this many MiB of memory at any time, for the whole process.
    WithinMebibytes Double
  | -- | No goal; the figure is recorded.
    Recorded
  deriving stock (Eq, Show)

-- | A program that does the same work when it gets a line on standard input.
data Peer
  = -- | A script of @bench/peers@ and its arguments.
    Script String FilePath [String]
  | -- | A C program and its arguments.
    Program String FilePath [String]
  deriving stock (Eq, Show)

-- | A measurement of "Bench.Ours" and its goals.
data Target = Target
  { -- | its name on the command line
    targetName :: String,
    targetWhat :: String,
    -- | the measurement's name
    targetOurs :: String,
    -- | options for the run-time system
    targetRunTime :: [String],
    targetGoals :: [Goal]
  }

-- | All targets, in the order of the report.
targets :: [Target]
targets =
  [ Target
      "products-gf4"
      "products of 10^7 pairs, GF(4)"
      "products-gf4"
      one
      [TimesAsFast 1.8 (galoisProducts 4)],
    Target
      "products-gf256"
      "products of 10^7 pairs, GF(256)"
      "products-gf256"
      one
      [TimesAsFast 1.8 (galoisProducts 256)],
    Target
      "products-run-time"
      "the same, GF(4) chosen at run time"
      "products-run-time"
      one
      [TimesAsFast 1.8 (galoisProducts 4)],
    Target
      "sequence"
      "m-sequence, GF(4), n = 12, a period"
      "sequence-gf4-12"
      one
      [ TimesAsFast 10 (Script "galois FLFSR" "register.py" []),
        TimesAsFast 1 (Program "C register" "register" (words "2 0 1 1 1 0 0 0 0 0 0 0"))
      ],
    Target
      "sequence-constant"
      "the same, beside a polynomial compiled in"
      "sequence-gf4-12"
      one
      [TimesAsFast 0 (Program "C register, compiled in" "register" ["constant"])],
    Target
      "sequence-dense"
      "the same, no coefficient zero"
      "sequence-gf4-12-dense"
      one
      [TimesAsFast 1 (Program "C register" "register" (words "2 1 3 3 3 1 2 3 1 3 1 3"))],
    Target
      "proof"
      "sequence, fold and proof, GF(4), 63 x 266305, 3 x 4"
      "proof-gf4"
      one
      [ TimesAsFast 15 (Script "galois + numpy" "proof.py" []),
        TimesAsFast (1 / 1.3) (Program "C" "enumerate" []),
        WithinMebibytes 64
      ],
    Target
      "proof-all-cores"
      "the same on all cores"
      "proof-gf4"
      ["-N"]
      [ TimesAsFast 15 (Script "galois + numpy" "proof.py" []),
        TimesAsFast 1 (Program "C" "enumerate" []),
        WithinMebibytes 64
      ],
    Target
      "proof-mask"
      "the same, 12 cells that are no rectangle"
      "proof-gf4-mask"
      one
      [Recorded, WithinMebibytes 64],
    Target
      "rank"
      "proof by rank, GF(2), 2^64 - 1 cells, 8 x 8 window"
      "rank-gf2-8x8"
      one
      [WithinSeconds 10e-3],
    Target "rank-tall" "the same, 32 x 2 window" "rank-gf2-32x2" one [WithinSeconds 10e-3],
    Target "cell-gf2" "one cell of 2^64 - 1, GF(2)" "cell-gf2-64" one [WithinSeconds 10e-6],
    Target "cell-gf3" "one cell of 3^40 - 1, GF(3)" "cell-gf3-40" one [WithinSeconds 1e-3],
    Target "cell-gf4" "one cell of 4^32 - 1, GF(4)" "cell-gf4-32" one [WithinSeconds 1e-3],
    Target "cell-gf256" "one cell of 256^8 - 1, GF(256)" "cell-gf256-8" one [WithinSeconds 1e-3],
    Target
      "first-gf2"
      "first primitive polynomial, GF(2), n = 128"
      "first-gf2-128"
      one
      [TimesAsFast 1 (Script "galois" "primitive.py" ["first", "2", "128"])],
    Target
      "first-gf3"
      "first primitive polynomial, GF(3), n = 20"
      "first-gf3-20"
      one
      [TimesAsFast 1 (Script "galois" "primitive.py" ["first", "3", "20"])],
    Target
      "quartics"
      "all 32 primitive quartics, GF(4)"
      "quartics-gf4"
      one
      [WithinSeconds 50e-3, TimesAsFast 1 (Script "galois" "primitive.py" ["all", "4", "4"])],
    Target
      "bulk-15x17"
      "10^7 windows by the table, 15 x 17, 2 x 2"
      "bulk-15x17"
      one
      [AtLeast 20e6, TimesAsFast 0 (numpyTable "15 17 2 2 3 2 1 0")],
    Target
      "bulk-63x65"
      "the same, 63 x 65, 3 x 2"
      "bulk-63x65"
      one
      [AtLeast 20e6, TimesAsFast 0 (numpyTable "63 65 3 2 2 1 1 0 0 0")],
    Target
      "bulk-63x266305"
      "the same, 63 x 266305, 3 x 4, beyond the cache"
      "bulk-63x266305"
      one
      [AtLeast 20e6, TimesAsFast 0 (numpyTable "63 266305 3 4 2 0 1 1 1 0 0 0 0 0 0 0")],
    Target
      "algebra"
      "a 15 x 2 window by algebra, GF(4), 2^60 - 1 cells"
      "algebra-gf4-30"
      one
      [WithinSeconds 5e-3],
    Target
      "algebra-once"
      "what that computes once an array, and one window"
      "algebra-gf4-30-once"
      one
      [Recorded],
    Target
      "decoding"
      "8 x 8 cells of it, 5 wrong, by information sets"
      "decoding-gf4-30"
      one
      [Recorded],
    Target
      "decoding-once"
      "what that computes once for the cells"
      "decoding-gf4-30-once"
      one
      [Recorded],
    Target "listing" "the same cells from probabilities, by a list" "listing-gf4-30" one [Recorded],
    Target
      "nearest"
      "a 4 x 4 patch, 0 to 4 cells wrong, on 15 x 17"
      "nearest-4x4"
      one
      [WithinSeconds 50e-6, TimesAsFast 0 (numpyNearest "hard")],
    Target
      "soft"
      "the same from probabilities"
      "soft-4x4"
      one
      [WithinSeconds 100e-6, TimesAsFast 0 (numpyNearest "soft")],
    Target "decode" "decode the worked example's composite" "decode" asShipped [Recorded],
    Target
      "evaluate"
      "100 simulated presses, decoded twice each"
      "evaluate-100"
      asShipped
      [Recorded],
    Target "evaluate-all-cores" "the same on all cores" "evaluate-100" ["-N", "-A2m"] [Recorded],
    Target
      "packing-paper"
      "packing: the paper's two objects, as walked, 15 x 17"
      "packing-paper"
      asShipped
      [WithinSeconds 0.2],
    Target
      "packing-boxes"
      "packing: the 1200 faces of 200 boxes, two ways each, 255 x 257"
      "packing-boxes"
      asShipped
      [WithinSeconds 5],
    Target
      "packing-walked"
      "the same, one way each"
      "packing-walked"
      asShipped
      [TimesAsFast 1 (rectpack "MaxRectsBl"), TimesAsFast 0 (rectpack "SkylineBlWm")],
    Target
      "packing-cubes"
      "packing: 10 000 cubes, 2047 x 2049"
      "packing-cubes"
      asShipped
      [WithinSeconds 5, WithinMebibytes 512]
  ]
  where
    one = ["-N1"]
    -- The nursery size of the shipped command line.
    asShipped = ["-N1", "-A2m"]
    numpyTable = Script "numpy" "table.py" . words
    rectpack algorithm = Script ("rectpack " ++ algorithm) "packing.py" [algorithm]
    numpyNearest kind = Script "numpy" "nearest.py" [kind]
    galoisProducts q = Script "galois" "products.py" [show (q :: Int)]
