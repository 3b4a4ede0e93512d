{-# LANGUAGE OverloadedStrings #-}

-- | What laws of conformance ask where they exhaust what they are about: exactly what they say,
-- written down a second time.
module Test.Conformance.Cases (spec) where

import Control.Monad (replicateM)
import Data.Aeson (Value (..), decode, encode, object, toJSON)
import Data.Aeson.Key (Key, fromString)
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Foldable (for_, toList)
import Data.List (isSuffixOf, nub, sort)
import Data.Maybe (fromMaybe)
import qualified Data.Vector as Vector
import Numeric.Natural (Natural)
import PraTactile.Array (Folding (..), Position (..), Shape (..), Surface (..), area)
import PraTactile.Conformance
import PraTactile.Conformance.Definition (expected)
import PraTactile.Conformance.Law (Cases (..), Domain (..))
import PraTactile.Conformance.Question
import PraTactile.Conformance.Wire (questionInput)
import PraTactile.Format.Json.Codec (writeValue)
import PraTactile.Format.Profile (profileValue)
import PraTactile.Profile
import Test.Hspec

spec :: Spec
spec = do
  for_ under $ \(name, p) ->
    it ("is all that there is, where a law says so: " ++ name) $ do
      Right about <- pure (known p)
      everyCase (filter (not . ofInvalid) laws) about `isExactly` domains p
  for_ under $ \(name, p) ->
    it ("is of what is no input all that is wrong in one place: " ++ name) $ do
      Right about <- pure (known p)
      everyCase (filter ofInvalid laws) about `isExactly` spoilt p
  it "is of profiles each of them, and each with every change that leaves no array" $
    everyCase openingLaws (map snd defaultProfiles)
      `isExactly` [ (law, map profileValue cases)
                    | (law, cases) <-
                        ("profile/possible-ones-are-opened", map snd defaultProfiles) : impossible
                  ]
  it "smaller patches and polynomials come before larger ones" $
    for_ under $ \(_, p) -> do
      Right about <- pure (known p)
      for_ ["locate/small-patches", "damage/small-patches", "chances/certain-cells"] $ \law ->
        for_ [found | one <- laws, lawId one == law, Just found <- [every (lawCases one about)]] $
          \found -> map cellsIn found `shouldBe` sort (map cellsIn found)
  where
    under =
      [ one
        | one@(name, _) <- defaultProfiles,
          name
            `elem` ["gf2-3x5", "gf2-3x5-row-major", "gf3-2x13", "gf9-5x16", "paper", "paper-sheet"]
      ]
    ofInvalid law = "-refuses-what-is-invalid" `isSuffixOf` lawId law
    cellsIn value = length [() | c <- show (encode value), c == ',']

-- | The cases of the laws that exhaust them, by the laws' ids.
everyCase :: [Law known] -> known -> [(String, [Value])]
everyCase those about =
  [(lawId law, found) | law <- those, Just found <- [every (lawCases law about)]]

-- | The same laws, each with the same cases, in any order.
isExactly :: [(String, [Value])] -> [(String, [Value])] -> Expectation
asked `isExactly` wanted = do
  sort (map fst asked) `shouldBe` sort (map fst wanted)
  for_ wanted $ \(law, cases) ->
    (law, sorted <$> lookup law asked) `shouldBe` (law, Just (sorted cases))
  where
    sorted = sort . map encode

every :: Cases -> Maybe [Value]
every (Cases form domain _) = case domain of
  Every cases -> Just (map (writeValue form) cases)
  Some _ _ -> Nothing

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

-- | Profiles that name no array, by the laws' ids: of each default profile, one key changed.
impossible :: [(String, [Profile])]
impossible =
  [ ("profile/" ++ name, map snd defaultProfiles >>= change)
    | (name, change) <- ofField' ++ ofSequence' ++ ofArray'
  ]
  where
    ofField' =
      [ ("order-is-a-prime-power", \p -> [p {profileOrder = q} | q <- [0, 1, 6, 10, 12]]),
        ( "modulus-has-the-degree",
          \p -> [p {profileModulus = h} | h <- [1 : profileModulus p, [1], []]]
        ),
        ( "modulus-is-monic",
          \p ->
            [ p {profileModulus = lower (profileModulus p) ++ [leading]}
              | leading <- 0 : [2 | odd (profileOrder p)]
            ]
        ),
        ( "modulus-is-irreducible",
          \p ->
            [ p {profileModulus = h}
              | h <-
                  [0 : drop 1 (lower (map (const 0) (profileModulus p))) ++ [1] | isExtension p]
                    -- (x + 1)^2, (x + 1)^3, (x + 1)(x - 1).
                    ++ [ h
                         | (q, h) <- [(4, [1, 0, 1]), (8, [1, 1, 1, 1]), (9, [2, 0, 1])],
                           q == profileOrder p
                       ]
            ]
        ),
        ( "modulus-is-over-the-prime-field",
          \p -> [p {profileModulus = (c + profileOrder p) : h} | c : h <- [profileModulus p]]
        )
      ]
    ofSequence' =
      [ ( "polynomial-is-monic",
          \p ->
            [ p {profilePolynomial = lower (profilePolynomial p) ++ [c]}
              | c <- 0 : [2 | profileOrder p > 2]
            ]
        ),
        ( "polynomial-is-primitive",
          \p ->
            [ p {profilePolynomial = h}
              | let n = length (profileState p),
                h <-
                  -- Divisible by x; x^n - 1; x^4 + x^3 + x^2 + x + 1, with roots of order 5.
                  [ 0 : drop 1 (profilePolynomial p),
                    minusOne p : replicate (n - 1) 0 ++ [1]
                  ]
                    ++ [[1, 1, 1, 1, 1] | profileOrder p == 2, n == 4]
            ]
        ),
        ( "coefficients-are-elements",
          \p -> [p {profilePolynomial = (c + profileOrder p) : h} | c : h <- [profilePolynomial p]]
        ),
        ("state-is-not-zero", \p -> [p {profileState = map (const 0) (profileState p)}]),
        ( "state-has-n-terms",
          \p -> [p {profileState = s} | s <- [0 : profileState p, drop 1 (profileState p)]]
        ),
        ( "state-has-elements",
          \p -> [p {profileState = (c + profileOrder p) : s} | c : s <- [profileState p]]
        )
      ]
    ofArray' =
      [ ( "cells-are-a-period",
          \p ->
            [ p {profileShape = shape}
              | let Shape a b = profileShape p,
                shape <- [Shape (a + 1) b, Shape a (b + 1), Shape b (a + b), Shape 0 b],
                area shape /= area (profileShape p)
            ]
        ),
        ( "sides-are-coprime",
          \p ->
            [larger | p == canonicalProfile]
              ++ [ p {profileShape = Shape a (area (profileShape p) `div` a)}
                   | profileFolding p == Diagonal,
                     a <- [2 .. 12],
                     area (profileShape p) `mod` a == 0,
                     gcd a (area (profileShape p) `div` a) /= 1
                 ]
        ),
        ("window-has-cells", \p -> [p {profileWindow = w} | w <- [Shape 0 2, Shape 2 0]])
      ]
    lower xs = take (length xs - 1) xs
    isExtension p = length (profileModulus p) > 2
    minusOne p = fromMaybe 1 (lookup (profileOrder p) [(3, 2), (5, 4), (9, 2)])
    -- The larger example of the paper.
    larger =
      canonicalProfile
        { profilePolynomial = [2, 1, 1, 0, 0, 0, 1],
          profileState = [0, 0, 0, 0, 0, 1],
          profileShape = Shape 15 273,
          profileWindow = Shape 2 3
        }

-- | What is no input of an operation, by the laws' ids.
spoilt :: Profile -> [(String, [Value])]
spoilt p =
  [ ( "field/" ++ name ++ "-refuses-what-is-invalid",
      concatMap ask (q : q + 1 : large) ++ wrong one ++ [with "a" minus one]
    )
    | (name, ask, one) <-
        [ ("add", \a -> [question (Add a 0), question (Add 0 a)], question (Add 1 1)),
          ( "multiply",
            \a -> [question (Multiply a 0), question (Multiply 0 a)],
            question (Multiply 1 1)
          ),
          ("negate", \a -> [question (Negate a)], question (Negate 1)),
          ("inverse", \a -> [question (Inverse a)], question (Inverse 1)),
          ("power", \a -> [question (Power a i) | i <- [-1 .. 2]], question (Power 1 1)),
          ("logarithm", \a -> [question (Logarithm a)], question (Logarithm 1)),
          ("trace", \a -> [question (Trace a)], question (Trace 1))
        ]
  ]
    ++ [ ( "polynomial/primitive-refuses-what-is-invalid",
           [ question (Primitive codes)
             | a <- q : q + 1 : large,
               codes <- [[a, 1], [1, a], [1, 0, a, 1]]
           ]
             ++ [with "polynomial" (toJSON [-1, 1 :: Int]) (question (Primitive [1, 1]))]
             ++ wrong (question (Primitive [1, 1]))
         ),
         ( "polynomial/first-primitive-refuses-what-is-invalid",
           question (FirstPrimitive 0) :
           with "degree" minus (question (FirstPrimitive 1)) :
           wrong (question (FirstPrimitive 1))
         ),
         ( "sequence/term-refuses-what-is-invalid",
           with "index" minus (question (Term 0)) : wrong (question (Term 1))
         ),
         ( "sequence/terms-refuses-what-is-invalid",
           [with name minus (question (Terms 0 1)) | name <- ["from", "length"]]
             ++ wrong (question (Terms 1 1))
         ),
         ( "array/cell-refuses-what-is-invalid",
           [with name minus (question (Cell 0 0)) | name <- ["row", "column"]]
             ++ wrong (question (Cell 1 1))
         ),
         ( "window/pack-refuses-what-is-invalid",
           [question (Pack (zeros count)) | count <- [0, k - 1, k + 1, 2 * k], count /= k]
             ++ [question (Pack (take k (a : zeros k))) | a <- q : q + 1 : large]
             ++ [question (Pack (zeros (k - 1) ++ [q]))]
             ++ [with "cells" (toJSON (replicate k (-1 :: Int))) (question (Pack [0]))]
             ++ wrong (question (Pack (zeros k)))
         ),
         ( "window/unpack-refuses-what-is-invalid",
           with "packed" minus (question (Unpack 0)) : wrong (question (Unpack 1))
         )
       ]
    ++ [ ( "proof/" ++ name ++ "-refuses-what-is-invalid",
           [with "mask" (String drawing) one | drawing <- noMasks] ++ wrong one
         )
         | (name, one) <-
             [("prove", question (Prove ["#"])), ("distance", question (Distance ["#"]))]
       ]
    ++ spoiltPatches p
  where
    q = profileOrder p
    k = fromIntegral (area (profileWindow p)) :: Int
    minus = Number (-1)
    zeros count = replicate count 0
    -- No cell, rows of different lengths, other characters, no cell that is in it.
    noMasks =
      ["", "/", "#/", "/#", "##/#", "#/##", "#x", "# #", "01", "#\n#", "##//##", ".", "../.."]

spoiltPatches :: Profile -> [(String, [Value])]
spoiltPatches p =
  [ ( "locate/locate-refuses-what-is-invalid",
      ofPatch (question (Locate felt'))
    ),
    ( "damage/nearest-refuses-what-is-invalid",
      [ with "radius" radius (question (Nearest Nothing [[Just 1]]))
        | radius <- [Number (-1), oneAsFraction, Bool True, toJSON ([] :: [Int])]
      ]
        ++ ofPatch (question (Nearest Nothing felt'))
        ++ ofPatch (question (Nearest (Just 1) felt'))
    ),
    ( "chances/posterior-refuses-what-is-invalid",
      [question (Posterior [[Probably chances]]) | chances <- noChances]
        ++ [ question (Posterior [[Unfelt, Probably chances], [Certainly 0, Unfelt]])
             | chances <- noChances
           ]
        ++ [question (Posterior [[Certainly code]]) | code <- [q, q + 1, q + 2]]
        ++ [ with
               "patch"
               (toJSON [[[toJSON True, toJSON (0 :: Int)]]])
               (question (Posterior [[Unfelt]]))
           ]
        ++ ofPatch (question (Posterior (map (map (maybe Unfelt Certainly)) felt')))
    )
  ]
  where
    q = profileOrder p
    q' = fromIntegral q :: Int
    Shape h w = profileWindow p
    felt' = [[Just 1, Nothing], [Just 0, Just 1]]
    ofPatch one =
      [ with "patch" patch one
        | patch <-
            map toJSON ([[], [[]], [[], []], [[0, 1], [1]], [[1], [0, 1]], [[0, 1], []]] :: [Ints])
              ++ [toJSON [[no]] | no <- [Number (-1), Bool True, Number 1.5, toJSON [String "0"]]]
              ++ [toJSON (replicate (fromIntegral h) (replicate (fromIntegral w) q))]
              ++ [toJSON [[0, q + 1]], toJSON [[Nothing, Just q]], Null]
      ]
        ++ wrong one
    -- Too many, none that is not 0, a negative one; sums beyond a thousandth of 1; too few.
    noChances =
      [replicate (q' + 1) (1 / fromIntegral (q' + 1)), replicate q' 0]
        ++ [[2, -1] ++ replicate (q' - 2) 0]
        ++ [map (* factor) halved | factor <- [1.002, 0.998, 2]]
        ++ [[], replicate (q' - 1) (1 / fromIntegral (q' - 1))]
    halved = [0.5 ^ i | i <- [1 .. q' - 1]] ++ [0.5 ^ (q' - 1)] :: [Double]

-- | A question with another value under a key.
with :: String -> Value -> Value -> Value
with name value one = changed one (insertAt name value)

-- | A question without each of its keys, and with a value of each wrong type in each place: the
-- first of a list stands for all of them.
wrong :: Value -> [Value]
wrong one =
  [changed one (KeyMap.delete name) | name <- keysOf one]
    ++ [ changed one (KeyMap.insert name other)
         | (name, inner) <- fieldsOf one,
           other <- others inner
       ]
  where
    others value = case value of
      Number _ -> [Bool True, oneAsFraction, Number 1.5, object []]
      String _ -> [Bool True, Number 1, object []]
      Array items ->
        [Bool True, Number 1, object []]
          ++ [ Array (Vector.fromList (other : rest))
               | first : rest <- [toList items],
                 other <- others first
             ]
      _ -> [Bool True, object []]

-- | 1 in a form that no whole number has.
oneAsFraction :: Value
oneAsFraction = fromMaybe Null (decode "1.0")

insertAt :: String -> Value -> KeyMap.KeyMap Value -> KeyMap.KeyMap Value
insertAt name = KeyMap.insert (fromString name)

changed :: Value -> (KeyMap.KeyMap Value -> KeyMap.KeyMap Value) -> Value
changed one change = case one of
  Array parts | [name, Object fields] <- toList parts -> toJSON [name, Object (change fields)]
  _ -> Null

fieldsOf :: Value -> [(Key, Value)]
fieldsOf one = case one of
  Array parts | [_, Object fields] <- toList parts -> KeyMap.toList fields
  _ -> []

keysOf :: Value -> [Key]
keysOf = map fst . fieldsOf

type Ints = [[Int]]
