-- | What laws of conformance ask where they exhaust what they are about: all of it, written down a
-- second time.
module Test.Conformance.Cases.Domains (domains, question, large) where

import Control.Monad (replicateM)
import Data.Aeson (Value (..), toJSON)
import Data.List (nub)
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..), Surface (..), area)
import PraTactile.Conformance
import PraTactile.Conformance.Definition (expected)
import PraTactile.Conformance.Question
import PraTactile.Conformance.Wire (questionInput)
import PraTactile.Profile

-- | A question as it stands among a law's cases.
question :: Question a -> Value
question one = toJSON [toJSON (operationName (operationOf one)), questionInput one]

-- | The domains of the laws that exhaust one, by the laws' ids.
domains :: Profile -> [(String, [Value])]
domains p = ofField p ++ ofPolynomials p ++ ofSequence p ++ ofArray p ++ ofMasks p ++ ofPatches p

ofField :: Profile -> [(String, [Value])]
ofField p =
  [ ("field/" ++ name, map ask (lists count))
    | (name, count, ask) <-
        [ ("addition-as-defined", 2, two Add),
          ("multiplication-as-defined", 2, two Multiply),
          ("negation-as-defined", 1, one Negate),
          ("inverse-as-defined", 1, one Inverse),
          ("logarithm-as-defined", 1, one Logarithm),
          ("trace-as-defined", 1, one Trace)
        ]
  ]
    ++ [ ("field/" ++ name, map toJSON (lists count))
         | (name, count) <-
             [ ("addition-associates", 3),
               ("addition-commutes", 2),
               ("zero-is-neutral", 1),
               ("negation-inverts-addition", 1),
               ("multiplication-associates", 3),
               ("multiplication-commutes", 2),
               ("one-is-neutral", 1),
               ("inverse-inverts-multiplication", 1),
               ("multiplication-distributes", 3),
               ("characteristic-is-p", 1),
               ("power-is-repeated-multiplication", 2),
               ("logarithm-of-a-product", 2),
               ("trace-is-additive", 2),
               ("trace-of-a-pth-power", 1)
             ]
       ]
    ++ [("field/power-as-defined", [question (Power a i) | i <- [-q' .. q'], a <- codesOf p])]
  where
    q' = toInteger (profileOrder p)
    lists count = replicateM count (codesOf p)
    two ask codes = case codes of
      [a, b] -> question (ask a b)
      _ -> Null
    one ask codes = case codes of
      [a] -> question (ask a)
      _ -> Null

codesOf :: Profile -> [Code]
codesOf p = [0 .. profileOrder p - 1]

ofPolynomials :: Profile -> [(String, [Value])]
ofPolynomials p =
  [ ( "polynomial/primitive-as-defined",
      [ question (Primitive (lower ++ [leading]))
        | n <- [0 .. 8],
          (q - 1) * q ^ n <= 700,
          lower <- replicateM n (codesOf p),
          leading <- [1 .. q - 1]
      ]
    ),
    ("polynomial/first-primitive-as-defined", map (question . FirstPrimitive) degrees),
    ("polynomial/first-primitive-is-primitive", [toJSON [n] | n <- degrees])
  ]
  where
    q = profileOrder p
    degrees = takeWhile (\n -> q ^ n <= 5000) [1 .. 8]

ofSequence :: Profile -> [(String, [Value])]
ofSequence p =
  [ ("sequence/term-as-defined", map (question . Term) [0 .. period - 1]),
    ( "sequence/terms-as-defined",
      [question (Terms from count) | from <- [0 .. n + 2], count <- [0 .. n + 2]]
    ),
    ("sequence/begins-with-the-state", indices [0]),
    ("sequence/obeys-the-recurrence", indices [0 .. min 600 (period - 1)]),
    ("sequence/counts-every-symbol", indices [1]),
    ("sequence/has-span-n", indices [1]),
    ("sequence/autocorrelates-by-minus-one", indices shifts),
    ("sequence/shifts-and-adds", indices shifts),
    ("sequence/decimates", indices shifts),
    ("sequence/is-its-own-qth-decimation", indices [1])
  ]
  where
    q = profileOrder p
    n = fromIntegral (length (profileState p)) :: Natural
    period = q ^ n - 1
    Shape n1 n2 = profileShape p
    indices = map toJSON :: [Natural] -> [Value]
    -- Of long periods those around which something changes, and some primes.
    shifts
      | period <= 100 = [1 .. period - 1]
      | otherwise =
        filter (< period) (nub [1, 2, 3, 5, 7, 11, q, n1, n2, period `div` 2, period - 1])

ofArray :: Profile -> [(String, [Value])]
ofArray p =
  [ ("array/cell-as-defined", [question (Cell r c) | r <- [0 .. n1 - 1], c <- [0 .. n2 - 1]]),
    ( "array/cell-at-the-edges",
      [question (Cell r c) | r <- nearEnd n1, c <- nearEnd n2, r >= n1 || c >= n2]
    ),
    ( "window/unpack-refuses-what-packs-no-window",
      map (question . Unpack) ([most, most + 1, 2 * most] ++ filter (>= most) large)
    )
  ]
    ++ [ answered
         | most <= 1024,
           answered <-
             [ ("window/pack-as-defined", map (question . Pack) (replicateM k (codesOf p))),
               ("window/unpack-as-defined", map (question . Unpack) [0 .. most - 1])
             ]
       ]
  where
    Shape n1 n2 = profileShape p
    k = fromIntegral (area (profileWindow p)) :: Int
    most = profileOrder p ^ k
    -- The first two, those at the end, and around two and three times the end.
    nearEnd n = [0, 1, n - 1, n, n + 1, 2 * n - 1, 2 * n, 3 * n + 1]

-- | Where words of 32 and 64 bits and the whole numbers of doubles end; and beyond all of them.
large :: [Natural]
large =
  [2147483648, 4294967296]
    ++ [9007199254740991, 9007199254740992, 9007199254740993]
    ++ [9223372036854775808, 18446744073709551615, 18446744073709551616]
    ++ [1000000000000000000000000000000]

ofMasks :: Profile -> [(String, [Value])]
ofMasks p =
  [ ("proof/" ++ name, map ask masks)
    | (end, masks) <- [("small-masks", small), ("special-masks", special)],
      (name, ask) <-
        [("prove-" ++ end, question . Prove), ("distance-" ++ end, question . Distance)]
  ]
  where
    Shape n1 n2 = profileShape p
    Shape h w = profileWindow p
    -- Those of at most six cells' room, and lines of four, whose first and last rows and columns
    -- are not blank.
    small =
      [ mask
        | (high, wide) <- [(a, b) | a <- [1 .. 3], b <- [1 .. 3], a * b <= 6] ++ lines4,
          mask <- replicateM high (replicateM wide "#."),
          let upright = [map (!! j) mask | j <- [0 .. wide - 1]],
          all (elem '#') ([head' mask, last mask] ++ [head' upright, last upright])
      ]
    lines4 = [(1, 4), (4, 1)]
    head' = concat . take 1
    special =
      [ replicate (fromIntegral h) (replicate (fromIntegral w) '#'),
        -- Blank rows and columns at the ends.
        ["##."],
        ["##", ".."],
        [".#"],
        ["..", ".#"],
        ["#.", ".."],
        ["##.", "...", "..."],
        ['#' : dots n2],
        ['#' : '#' : dots n2],
        "#" : replicate (fromIntegral n1) "."
      ]
        ++ [ ('#' : dots 8 ++ "#") : replicate 10 (dots 10) ++ [dots 8 ++ "#."]
             | n1 > 11,
               n2 > 9
           ]
        -- Two cells, as far apart as the array is large, one less, and one more.
        ++ map
          (uncurry apart)
          ( [(0, n2 - 1), (n1 - 1, 0), (n1 - 1, n2 - 1), (0, n2), (n1, 0), (n1, n2)]
              ++ [(0, n2 + 1), (n1 + 1, 0)]
          )
    dots n = replicate (fromIntegral (n :: Natural)) '.'
    apart r c =
      [ [if (i, j) `elem` [(0, 0), (r, c)] then '#' else '.' | j <- [0 .. c]]
        | i <- [0 .. r]
      ]

ofPatches :: Profile -> [(String, [Value])]
ofPatches p =
  [ ( "locate/every-window",
      map (located . seen p (profileWindow p)) (placesOf (profileWindow p))
    ),
    ("locate/small-patches", map located (small 700)),
    ("locate/zeros", map located zeros),
    ("locate/nothing-observed", map located nothing),
    ("locate/across-the-edges", map located across),
    ("damage/small-patches", map (near Nothing) (small 300)),
    ("damage/small-patches-within-a-radius", near . Just <$> [0, 1, 2] <*> small 130),
    ( "damage/zeros",
      near <$> [Nothing, Just 0, Just 1] <*> concat [[zero, withOne zero] | zero <- zeros]
    ),
    ("damage/nothing-observed", near <$> [Nothing, Just 0, Just 3] <*> nothing),
    ("damage/across-the-edges", near <$> [Nothing, Just 1] <*> across),
    ("chances/certain-cells", map certain (small 70)),
    ( "chances/certain-as-probabilities",
      [likely [[Probably [if a == b then 1 else 0 | b <- codesOf p]]] | a <- codesOf p]
    ),
    ( "chances/doubtful-cells",
      [ likely [[Probably [if c `elem` [a, b] then 0.5 else 0 | c <- codesOf p], beside]]
        | a <- take 4 (codesOf p),
          b <- take 4 (codesOf p),
          a /= b,
          beside <- [Unfelt, Certainly 1]
      ]
    ),
    ("chances/nothing-known", map certain nothing),
    ("chances/across-the-edges", map certain (take 24 across)),
    ( "chances/sums-are-divided-by",
      [ likely [[Probably (map (* factor) halved)], [Unfelt]]
        | factor <- [1.0005, 0.9995, 1.0009, 0.9991]
      ]
    )
  ]
  where
    q = profileOrder p
    Shape n1 n2 = profileShape p
    Shape h w = profileWindow p
    located = question . Locate
    near radius = question . Nearest radius
    likely = question . Posterior
    certain = likely . map (map (maybe Unfelt Certainly))
    placesOf (Shape high wide) = case profileSurface p of
      Sheet -> [Position r c | r <- upTo' (n1 - high), c <- upTo' (n2 - wide)]
      _ -> [Position r c | r <- upTo' (n1 - 1), c <- upTo' (n2 - 1)]
    upTo' n = [0 .. n]
    -- Of shapes of at most 4 x 4, of which there are at most so many.
    small most =
      [ patch
        | high <- [1 .. 4],
          wide <- [1 .. 4],
          (q + 1) ^ (high * wide) <= (most :: Natural),
          patch <- replicateM high (replicateM wide (Nothing : map Just (codesOf p)))
      ]
    -- To two rows and columns more than a window has, and 24 cells.
    shapes =
      [ (high, wide)
        | high <- [1 .. min n1 (h + 2)],
          wide <- [1 .. min n2 (w + 2)],
          high * wide <= 24
      ]
    constant value (high, wide) =
      replicate (fromIntegral high) (replicate (fromIntegral wide) value)
    zeros =
      map (constant (Just 0)) shapes
        ++ [map (\line -> drop 1 line ++ [Nothing]) (constant (Just 0) one) | one <- shapes]
    withOne lines' = case lines' of
      (_ : line) : rest -> (Just 1 : line) : rest
      _ -> lines'
    nothing = map (constant Nothing) shapes
    -- The corners first, and then along both edges, 24 at most of each shape.
    across = map fst overAll ++ map snd overAll
    overAll = concatMap overEdges larger
    larger = [Shape a b | a <- [h, h + 1], b <- [w, w + 1], a <= n1, b <= n2]
    overEdges shape@(Shape a b) =
      [ (whole, cut)
        | (r, c) <-
            take
              24
              [ (r, c)
                | (r, c) <-
                    [(n1 - 1, n2 - 1), (0, n2 - 1), (n1 - 1, 0)]
                      ++ concat [[(i, n2 - 1), (n1 - 1, i)] | i <- [1 .. 9], i < min n1 n2],
                  r + a > n1 || c + b > n2
              ],
          let whole = seen p shape (Position r c)
              cut =
                [ [ if r + i < n1 && c + j < n2 then code else Nothing
                    | (j, code) <- zip [0 ..] line
                  ]
                  | (i, line) <- zip [0 ..] whole
                ]
      ]
    halved =
      [0.5 ^ i | i <- [1 .. q - 1]] ++ [0.5 ^ (q - 1)] :: [Double]

-- | What is seen of a shape at a place, by the cells of the array, which goes on as a torus or as
-- the twisted one; a sheet as the torus.
seen :: Profile -> Shape -> Position -> Patch
seen p (Shape high wide) (Position r c) =
  [[Just (at (r + i) (c + j)) | j <- [0 .. wide - 1]] | i <- [0 .. high - 1]]
  where
    Shape n1 n2 = profileShape p
    at i j = case profileSurface p of
      TwistedTorus -> cellAt p ((i + j `div` n2) `mod` n1) (j `mod` n2)
      _ -> cellAt p (i `mod` n1) (j `mod` n2)

-- | The cell of the array, as the definition has it.
cellAt :: Profile -> Natural -> Natural -> Code
cellAt p r c =
  either (const 0) (\about -> either (const 0) id (expected about (Cell r c))) (known p)
