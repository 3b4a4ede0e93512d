-- | Mistakes on the way from the profile to the array and its packed windows.
module PraTactile.Conformance.Impostors.Arrays
  ( sequenceImpostors,
    arrayImpostors,
    windowImpostors,
  )
where

import Data.List (genericLength, genericTake)
import PraTactile.Array (Folding (..), Position (..), Shape (..), Surface (..), area)
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Impostors.Impostor
import PraTactile.Conformance.Impostors.Ways
import PraTactile.Profile (Profile (..), Reading (..))
import PraTactile.Window (Packing (..))

-- | In the sequence.
sequenceImpostors :: [Impostor]
sequenceImpostors = recurrences ++ indices

recurrences :: [Impostor]
recurrences =
  [ misstepped
      "forgets-to-negate-the-taps"
      "takes the sum of the terms for the next one, not its negative"
      $ \ways ->
        ways {nextTerm = \_ a -> a},
    misstepped
      "reads-every-polynomial-as-characteristic"
      "takes the reciprocal polynomial for the characteristic one"
      $ \ways ->
        ways {taps = statedTaps (const Characteristic)},
    misstepped
      "reads-every-polynomial-as-reciprocal"
      "takes the characteristic polynomial for the reciprocal one"
      $ \ways ->
        ways {taps = statedTaps (const Reciprocal)},
    misstepped
      "forgets-to-make-the-reciprocal-monic"
      "reads a reciprocal polynomial backwards, and no more"
      $ \ways ->
        ways
          { taps = \p ->
              if profileReading p == Reciprocal
                then
                  map
                    fromIntegral
                    (take (degree p) (reverse (profilePolynomial p)))
                else taps ways p
          },
    misstepped "reverses-the-state" "begins with the profile's state backwards" $ \ways ->
      ways {start = reverse . start ways},
    misstepped
      "begins-with-the-usual-state"
      "begins with 0, ..., 0, 1 whatever the profile's state"
      $ \ways ->
        ways {start = \p -> replicate (degree p - 1) 0 ++ [1]},
    misstepped "begins-with-one-first" "begins with 1, 0, ..., 0" $ \ways ->
      ways {start = \p -> 1 : replicate (degree p - 1) 0},
    misstepped "shifts-the-taps" "takes each coefficient with the term beside its own" $ \ways ->
      ways {taps = \p -> let cs = taps ways p in drop 1 cs ++ take 1 cs},
    misstepped "begins-one-term-late" "begins with s(1)" $ \ways ->
      ways {withinPeriod = \p i -> withinPeriod ways p (i + 1)},
    misstepped "runs-backwards" "counts the terms of a period from its end" $ \ways ->
      ways {withinPeriod = \p i -> withinPeriod ways p (-i)},
    misstepped
      "exchanges-a-and-a-squared"
      "takes A^2 for A, and the conjugates of other fields, in polynomial and state"
      $ \ways ->
        ways
          { taps = \p -> map (conjugate p) (taps ways p),
            start = \p -> map (conjugate p) (start ways p)
          }
  ]
  where
    degree p = length (profilePolynomial p) - 1
    -- The element to the power of the characteristic.
    conjugate p a = iterate (times rightWays p a) 1 !! characteristic p

indices :: [Impostor]
indices =
  [ misstepped "has-a-period-of-q-to-the-n" "takes indices modulo q^n, not q^n - 1" $ \ways ->
      ways
        { withinPeriod = \p i ->
            i
              `mod` (toInteger (profileOrder p) ^ (length (profilePolynomial p) - 1))
        },
    mistaken "takes-indices-in-32-bits" "reads indices in 32 bits, cut off" (cutTo 32),
    mistaken "takes-indices-in-64-bits" "reads indices in 64 bits, cut off" (cutTo 64),
    mistaken "takes-indices-as-doubles" "reads indices as floating point numbers" $ \s ->
      s {term = term s . rounded, terms = terms s . rounded},
    mistaken "counts-a-run-to-its-end" "takes the length of a run for the index of its last term" $
      \s ->
        s {terms = \from count -> terms s from (if count > from then count - from else 0)},
    mistaken "has-one-term-more" "counts a run's last term in" $ \s ->
      s {terms = \from count -> terms s from (count + 1)},
    mistaken
      "stops-at-the-end-of-a-period"
      "tells the terms of a run up to the end of the period"
      $ \s ->
        let period = profileOrder (profile s) ^ (length (profilePolynomial (profile s)) - 1) - 1
         in s
              { terms =
                  \from count -> genericTake (period - from `mod` period) <$> terms s from count
              }
  ]
  where
    cutTo bits s =
      let cut i = i `mod` 2 ^ (bits :: Int)
       in s
            { term = term s . cut,
              terms = terms s . cut,
              cell = \(Position r c) ->
                cell
                  s
                  (Position (cut r) (cut c))
            }
    rounded i = if i == 0 then 0 else truncate (fromIntegral i :: Double)

-- | In the array.
arrayImpostors :: [Impostor]
arrayImpostors = folds ++ edges

folds :: [Impostor]
folds =
  [ misstepped
      "transposes-the-fold"
      "counts rows by the number of columns, and columns by that of rows"
      $ \ways ->
        ways
          { folded = \p (r, c) -> case profileFolding p of
              Diagonal -> remainders (snd (sizes p), r) (fst (sizes p), c)
              RowMajor -> c * fst (sizes p) + r
          },
    misstepped "folds-backwards" "folds the sequence from its end" $ \ways ->
      ways
        { folded = \p at ->
            let (n1, n2) = sizes p
             in (n1 * n2 - folded ways p at)
                  `mod` (n1 * n2)
        },
    misstepped "folds-from-one" "has s(0) in the second row and column" $ \ways ->
      ways
        { folded = \p (r, c) ->
            let (n1, n2) = sizes p
             in folded
                  ways
                  p
                  ((r - 1) `mod` n1, (c - 1) `mod` n2)
        },
    misstepped "counts-terms-from-one" "has s(1) in the first cell" $ \ways ->
      ways {folded = \p at -> folded ways p at + 1},
    misstepped "folds-row-by-row" "folds row by row whatever the profile's folding" $ \ways ->
      ways {folded = \p (r, c) -> r * snd (sizes p) + c},
    misstepped
      "folds-diagonally"
      "folds diagonally whatever the profile's folding, where that fills the array"
      $ \ways ->
        ways {folded = \p -> folded ways p {profileFolding = Diagonal}},
    misstepped "folds-column-by-column" "folds column by column in place of row by row" $ \ways ->
      ways
        { folded = \p (r, c) ->
            if profileFolding p == RowMajor
              then c * fst (sizes p) + r
              else folded ways p (r, c)
        },
    misstepped "mirrors-the-columns" "has the columns from right to left" $ \ways ->
      ways {folded = \p (r, c) -> folded ways p (r, snd (sizes p) - 1 - c)},
    misstepped "turns-the-array" "has the array turned by half a turn" $ \ways ->
      ways {folded = \p (r, c) -> folded ways p (fst (sizes p) - 1 - r, snd (sizes p) - 1 - c)}
  ]

-- | The index that leaves these remainders: modulus and remainder, twice; 0 if there is none.
remainders :: (Integer, Integer) -> (Integer, Integer) -> Integer
remainders (m1, r1) (m2, r2) = case [ i
                                      | i <- [0 .. m1 * m2 - 1],
                                        i `mod` m1 == r1 `mod` m1,
                                        i `mod` m2 == r2 `mod` m2
                                    ] of
  i : _ -> i
  [] -> 0

edges :: [Impostor]
edges =
  [ misstepped "ends-at-the-edges" "refuses cells beyond the edges" $ \ways ->
      ways
        { goesOn = onSheet
        },
    misstepped
      "goes-on-as-the-profiles-surface"
      "continues cells on the profile's surface, not on the folding's own"
      $ \ways ->
        ways {goesOn = \p -> surfaceStep (profileSurface p) p},
    misstepped "wraps-round-the-torus" "continues every array as the torus" $ \ways ->
      ways
        { goesOn = onTorus
        },
    misstepped "wraps-round-the-twisted-torus" "continues every array in the next row" $ \ways ->
      ways {goesOn = onTwisted},
    misstepped "wraps-off-by-one" "counts one row and column too many before it begins again" $
      \ways ->
        ways
          { goesOn = \p (r, c) ->
              let (n1, n2) = sizes p
               in Just
                    (min (n1 - 1) (r `mod` (n1 + 1)), min (n2 - 1) (c `mod` (n2 + 1)))
          },
    misstepped "wraps-once" "takes one width off beyond the edges, and no more" $ \ways ->
      ways
        { goesOn = \p (r, c) ->
            let (n1, n2) = sizes p
             in onTorus p (min r (2 * n1 - 1), min c (2 * n2 - 1))
        },
    mistaken "counts-cells-from-one" "counts rows and columns from 1" $ \s ->
      s
        { cell = \(Position r c) ->
            cell
              s
              ( Position
                  (before (rows (profileShape (profile s))) r)
                  (before (columns (profileShape (profile s))) c)
              )
        },
    mistaken "exchanges-row-and-column" "takes the row for the column" $ \s ->
      s {cell = \(Position r c) -> cell s (Position c r)},
    misstepped "takes-the-sheet-for-the-torus" "looks on where the sheet ends" $ \ways ->
      ways
        { lies = \p ->
            surfaceStep
              (if profileSurface p == Sheet then Torus else profileSurface p)
              p
        },
    misstepped "takes-the-torus-for-a-sheet" "stops at the edges of the torus" $ \ways ->
      ways {lies = \p -> if profileSurface p == Torus then onSheet p else lies ways p},
    misstepped
      "takes-the-twisted-torus-for-the-plain-one"
      "goes on in the same row behind the last column"
      $ \ways ->
        ways {lies = \p -> if profileSurface p == TwistedTorus then onTorus p else lies ways p},
    misstepped
      "twists-every-torus"
      "goes on in the next row behind the last column of every torus"
      $ \ways ->
        ways {lies = \p -> if profileSurface p == Torus then onTwisted p else lies ways p}
  ]
  where
    before n i = if i == 0 then n - 1 else i - 1

-- | In packing windows.
windowImpostors :: [Impostor]
windowImpostors =
  [ misstepped "packs-in-the-other-order" "has the first cell at the other end of the number" $
      \ways ->
        ways {packed = \p -> reverse . packed ways p},
    misstepped
      "packs-the-first-cell-highest"
      "has the first cell as the most significant digit whatever the profile's packing"
      $ \ways ->
        ways {packed = const id},
    misstepped
      "packs-the-first-cell-lowest"
      "has the first cell as the least significant digit whatever the profile's packing"
      $ \ways ->
        ways {packed = const reverse},
    elsewhereIn "packs-to-the-base-ten" "packs cells as decimal digits" id $ \_ s ->
      s {pack = \codes -> pack s codes >> pure (decimal s codes)},
    mistaken "packs-column-by-column" "takes a window's cells column by column" $ \s ->
      let Shape h w = profileWindow (profile s)
       in s
            { pack = \codes -> pack s (byColumns h w codes),
              unpack =
                fmap (byColumns w h)
                  . unpack s
            },
    mistaken "packs-in-doubles" "computes packed numbers in floating point" $ \s ->
      s {pack = fmap (\n -> if n == 0 then 0 else truncate (fromIntegral n :: Double)) . pack s},
    mistaken "drops-leading-zeros" "unpacks as many cells as the number has digits" $ \s ->
      s {unpack = fmap (dropZeros (profilePacking (profile s))) . unpack s},
    mistaken "unpacks-modulo" "unpacks any number by its lowest digits" $ \s ->
      s {unpack = \n -> unpack s (n `mod` most s)},
    mistaken "unpacks-one-too-many" "takes the number of all windows for one that packs one" $ \s ->
      s {unpack = \n -> unpack s (if n > most s then n else min n (most s - 1))},
    mistaken "packs-any-number-of-cells" "packs cells of any number, as many as it is given" $ \s ->
      s {pack = \codes -> mapM_ (\a -> add s a 0) codes >> pure (number s codes)}
  ]
  where
    most s = profileOrder (profile s) ^ area (profileWindow (profile s))
    ordered s = if profilePacking (profile s) == MostSignificantFirst then id else reverse
    number s = foldl (\n code -> n * profileOrder (profile s) + code) 0 . ordered s
    decimal s = foldl (\n code -> n * 10 + code) 0 . ordered s
    dropZeros packing codes = case packing of
      MostSignificantFirst -> dropWhile (== 0) codes
      LeastSignificantFirst -> reverse (dropWhile (== 0) (reverse codes))
    byColumns h w codes
      | genericLength codes /= h * w = codes
      | otherwise =
        [ codes !! fromIntegral (i * w + j) | w > 0, h > 0, j <- [0 .. w - 1], i <-
                                                                                 [0 .. h - 1]
        ]
