-- | Mistakes in finding places, and in what is proved of masks.
module PraTactile.Conformance.Impostors.Places
  ( proofImpostors,
    locateImpostors,
    damageImpostors,
    chanceImpostors,
  )
where

import Data.List (maximumBy, transpose)
import Data.Maybe (fromMaybe, isJust)
import Data.Ord (comparing)
import PraTactile.Array (Position (..), Shape (..), Surface (..), naturalSurface)
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Impostors.Impostor
import PraTactile.Conformance.Impostors.Searching
import PraTactile.Profile (Profile (..))

-- | In proofs and distances.
proofImpostors :: [Impostor]
proofImpostors =
  [ mistaken "proves-by-rank-alone" "takes only masks of full rank for proved" $ \s ->
      s
        { prove =
            fmap (\proof -> proof {proofHolds = proofRank proof == Just (degree s)})
              . prove
                s
        },
    mistaken "counts-windows-without-zeros" "leaves the window of zeros out of the count" $ \s ->
      s
        { prove = \mask ->
            ( \proof ->
                proof
                  { proofWindows =
                      if proofRank proof == Just (degree s)
                        then
                          proofWindows
                            proof
                        else proofWindows proof - 1
                  }
            )
              <$> prove s mask
        },
    elsewhereIn
      "proves-on-the-torus"
      "counts the windows on the folding's own surface, whatever the profile's"
      own
      $ \other s ->
        s {prove = prove other},
    elsewhereIn
      "proves-on-the-sheet"
      "counts the windows that lie on the sheet, whatever the profile's surface"
      sheet
      $ \other s ->
        s {prove = prove other},
    mistaken "fills-the-mask" "takes the rectangle around a mask for the mask" $ \s ->
      s {prove = prove s . filled, distance = distance s . filled},
    mistaken "cuts-the-mask" "takes the first row of a mask for the mask" $ \s ->
      s {prove = prove s . take 1, distance = distance s . take 1},
    mistaken "counts-blank-columns" "counts blank rows and columns at a mask's end as part of it" $
      \s ->
        s {prove = \mask -> prove s mask >>= \proof -> prove s (corners mask) >> pure proof},
    mistaken
      "has-a-rank-on-every-surface"
      "tells the number of a mask's cells, or the degree if that is less, for the rank"
      $ \s ->
        s
          { prove = \mask ->
              (\proof -> proof {proofRank = Just (min (degree s) (cellsIn mask))})
                <$> prove s mask
          },
    mistaken
      "looks-at-different-windows-only"
      "takes the least distance above 0, also where two windows are the same"
      $ \s ->
        s {distance = \mask -> (\d -> if d == 0 then 1 else d) <$> distance s mask},
    mistaken
      "takes-cells-for-the-distance"
      "takes the Singleton bound for the distance: cells less degree plus one"
      $ \s ->
        s
          { distance = \mask ->
              distance s mask >>= \d ->
                pure
                  (if d == 0 then 0 else cellsIn mask + 1 - min (cellsIn mask) (degree s))
          }
  ]
  where
    degree s = fromIntegral (length (profilePolynomial (profile s))) - 1
    own p = p {profileSurface = naturalSurface (profileFolding p)}
    sheet p = p {profileSurface = Sheet}
    filled = map (map (\mark -> if mark == '.' then '#' else mark))
    cellsIn = fromIntegral . length . filter (== '#') . concat
    -- As large as the drawing.
    corners mask = case reverse mask of
      line : others -> reverse ((take (length line - 1) line ++ "#") : others)
      [] -> mask

-- | In locating by the table.
locateImpostors :: [Impostor]
locateImpostors =
  [ missearching
      "looks-at-the-first-window"
      "looks up the first complete window of a patch, and at no other cell"
      $ \how ->
        how {lookedUp = take 1, kept = const True},
    missearching
      "looks-at-the-windows-alone"
      "looks up all complete windows, and not at the cells beside them"
      $ \how ->
        how {kept = const True},
    missearching
      "lets-the-majority-decide"
      "keeps a place at which most of the observed cells agree"
      $ \how ->
        how {kept = \agrees -> 2 * length (filter id agrees) > length agrees},
    missearching "begins-at-the-origin" "has (0, 0) as the place until a better one is found" $
      \how ->
        how
          { settled = \reason places ->
              settled
                how
                reason
                (if null places then [(0, 0)] else places)
          },
    missearching "takes-the-first-of-several-places" "answers the first of several places" $ \how ->
      how {settled = \reason -> settled how reason . take 1},
    missearching "takes-the-last-of-several-places" "answers the last of several places" $ \how ->
      how {settled = \reason -> settled how reason . take 1 . reverse},
    missearching
      "tells-the-windows-place"
      "tells the place of the first window, not that of the patch"
      $ \how ->
        how {origin = \_ place _ -> place},
    missearching
      "adds-the-offset"
      "goes from a window's place on by its offset in the patch, not back"
      $ \how ->
        how {origin = \p place (i, j) -> origin how p place (-i, -j)},
    missearching
      "forgets-to-wrap"
      "goes back from a window's place over the edge without going round"
      $ \how ->
        how
          { origin = \p (r, c) (i, j) ->
              if profileSurface p == Sheet
                then
                  origin
                    how
                    p
                    (r, c)
                    (i, j)
                else (max 0 (r - i), max 0 (c - j))
          },
    missearching
      "drops-the-first-row"
      "takes the first row of a larger patch for a margin"
      $ \how ->
        how {taken = withoutFirst},
    mistaken
      "refuses-cells-not-felt"
      "refuses a patch of which a cell was not felt as one of which none was"
      $ \s ->
        s
          { locate = \cells ->
              locate
                s
                ( if any (any isJust) cells && any (elem Nothing) cells
                    then
                      map
                        (map (const Nothing))
                        cells
                    else cells
                )
          },
    missearching "takes-cells-not-felt-for-zeros" "takes a cell that was not felt for a 0" $ \how ->
      how {taken = map (map (Just . fromMaybe 0))},
    mistaken "transposes-patches" "takes the rows of a patch for its columns" $ \s ->
      s {locate = locate s . transpose, nearest = \radius -> nearest s radius . transpose},
    mistaken "mirrors-patches" "takes the rows of a patch from right to left" $ \s ->
      s
        { locate = locate s . map reverse,
          nearest = \radius -> nearest s radius . map reverse,
          posterior = posterior s . map reverse
        },
    mistaken "turns-patches" "takes a patch turned by half a turn" $ \s ->
      s
        { locate = locate s . reverse . map reverse,
          nearest = \radius ->
            nearest s radius
              . reverse
              . map reverse
        },
    mistaken "is-one-column-beside" "tells the place of the patch's second column" $ \s ->
      let beside = shifted (profileShape (profile s))
       in s
            { locate = fmap beside . locate s,
              nearest = \radius ->
                fmap beside
                  . nearest
                    s
                    radius
            },
    mistaken "counts-places-from-one" "counts the rows and columns of places from 1" $ \s ->
      s {locate = fmap fromOne . locate s, nearest = \radius -> fmap fromOne . nearest s radius}
  ]

-- | The first of three rows or more not felt.
withoutFirst :: [[Maybe Int]] -> [[Maybe Int]]
withoutFirst cells = case cells of
  line : rest@(_ : _ : _) -> map (const Nothing) line : rest
  _ -> cells

shifted :: Shape -> Place -> Place
shifted (Shape _ n2) = overPlace (\(Position r c) -> Position r ((c + 1) `mod` n2))

fromOne :: Place -> Place
fromOne = overPlace (\(Position r c) -> Position (r + 1) (c + 1))

overPlace :: (Position -> Position) -> Place -> Place
overPlace change place = case place of
  At at -> At (change at)
  OneOf several -> OneOf (map change several)
  Coset count dimension -> Coset count dimension

-- | In correcting.
damageImpostors :: [Impostor]
damageImpostors = radii ++ comparisons

radii :: [Impostor]
radii =
  [ missearching "corrects-one-too-many" "guarantees one cell more than the distance does" $ \how ->
      how {guaranteed = (+ 1) . guaranteed how},
    missearching "corrects-one-too-few" "guarantees one cell less than the distance does" $ \how ->
      how {guaranteed = \d -> let e = guaranteed how d in if e == 0 then 0 else e - 1},
    missearching "corrects-half-the-distance" "corrects e cells if 2 e <= d" $ \how ->
      how {guaranteed = (`div` 2)},
    missearching
      "corrects-the-whole-distance"
      "corrects as many cells as the distance less 1, as it detects"
      $ \how ->
        how {guaranteed = \d -> if d == 0 then 0 else d - 1},
    missearching
      "measures-the-whole-patch"
      "takes the distance of the whole patch, also where cells are missing"
      $ \how ->
        how
          { measured = \cells ->
              [(i, j) | (i, line) <- zip [0 ..] cells, (j, _) <- zip [0 ..] line]
          },
    missearching
      "measures-the-first-row"
      "takes the distance of the patch's first row that has an observed cell"
      $ \how ->
        how
          { measured = measured how . take 1 . filter (any isJust)
          },
    missearching "stops-before-the-radius" "takes a radius as a bound that is not reached" $ \how ->
      how {within = \n radius -> if radius == 0 then n == 0 else n < radius},
    missearching "corrects-beyond-the-radius" "corrects one cell more than the radius says" $
      \how ->
        how {within = \n radius -> n <= radius + 1},
    mistaken "knows-the-guaranteed-radius-alone" "takes the guaranteed radius for the stated one" $
      \s ->
        s {nearest = const (nearest s Nothing)},
    mistaken "takes-no-radius-for-none" "corrects nothing where no radius is stated" $ \s ->
      s {nearest = nearest s . Just . fromMaybe 0}
  ]

comparisons :: [Impostor]
comparisons =
  [ mistaken "takes-erasures-for-zeros" "takes a cell that was not felt for a 0 when it compares" $
      \s ->
        s {nearest = \radius -> nearest s radius . map (map (Just . fromMaybe 0))},
    missearching
      "counts-how-far-codes-are"
      "adds up how far the codes are from each other, not how many differ"
      $ \how ->
        how {differing = \seen there -> sum (map abs (zipWith (-) seen there))},
    missearching "forgives-zeros" "counts no difference where a 0 was seen" $ \how ->
      how
        { differing = \seen there ->
            length
              (filter id (zipWith (\a b -> a /= 0 && a /= b) seen there))
        },
    mistaken
      "corrects-what-is-complete"
      "compares complete patches only, and looks the others up"
      $ \s ->
        s
          { nearest = \radius cells ->
              if any (elem Nothing) cells && any (any isJust) cells
                then locate s cells
                else nearest s radius cells
          },
    mistaken
      "looks-up-instead-of-comparing"
      "looks a patch up in the table, and compares nothing"
      $ \s ->
        s {nearest = \_ -> locate s},
    mistaken "answers-a-tie" "answers the first of several nearest places" $ \s ->
      s {nearest = \radius cells -> firstOf <$> nearest s radius cells},
    mistaken "hides-the-places" "tells how many nearest places there are, with dimension 0" $ \s ->
      s {nearest = \radius cells -> counted <$> nearest s radius cells}
  ]
  where
    firstOf place = case place of
      OneOf (first : _) -> At first
      other -> other
    counted place = case place of
      OneOf several -> Coset (fromIntegral (length several)) 0
      other -> other

-- | In probabilities.
chanceImpostors :: [Impostor]
chanceImpostors =
  [ missearching
      "hears-the-likeliest-symbol"
      "takes of each cell the likeliest symbol for certain"
      $ \how ->
        how
          { believed = \chances ->
              let most = maximum chances
               in map
                    (\x -> if x == most then 1 else 0)
                    chances
          },
    missearching
      "multiplies-numbers-as-they-come"
      "multiplies probabilities that do not add up to 1 as they are, and tells the \
      \products"
      $ \how ->
        how {believed = id, told = map (fmap (/ 1))},
    missearching
      "adds-probabilities"
      "adds the probabilities of the cells instead of multiplying them"
      $ \how ->
        how {together = \chances -> if null chances then 1 else sum chances},
    missearching "averages-the-cells" "takes the geometric mean of the cells' probabilities" $
      \how ->
        how {together = \chances -> product chances ** (1 / fromIntegral (max 1 (length chances)))},
    missearching "tells-likelihoods" "tells the products without dividing by their sum" $ \how ->
      how {told = id},
    missearching "tells-the-likeliest-place" "tells the likeliest place alone" $ \how ->
      how {told = \likelihoods -> [maximumBy (comparing snd) (told how likelihoods)]},
    missearching "divides-by-the-largest" "divides by the largest likelihood instead of the sum" $
      \how ->
        how {told = \likelihoods -> map (fmap (/ maximum (map snd likelihoods))) likelihoods},
    missearching "smooths" "adds a thousandth to each probability, so that nothing is impossible" $
      \how ->
        how
          { believed = \chances ->
              map
                (\x -> (x + 0.001) / (sum chances + 0.001 * fromIntegral (length chances)))
                chances
          },
    mistaken
      "takes-the-unknown-for-zeros"
      "takes a cell of which nothing is known for a certain 0"
      $ \s ->
        s {posterior = posterior s . map (map (Just . fromMaybe (certainZero s)))},
    mistaken "takes-any-numbers-for-probabilities" "divides any numbers by their sum" $ \s ->
      s {posterior = posterior s . map (map (fmap forced))},
    mistaken "takes-the-unknown-for-any" "leaves out rows of which nothing is known" $ \s ->
      s
        { posterior = \cells ->
            posterior
              s
              (let known = filter (any isJust) cells in if null known then cells else known)
        }
  ]
  where
    certainZero s = 1 : replicate (fromIntegral (profileOrder (profile s)) - 1) 0
    forced chances =
      let total = sum (map (max 0) chances)
       in if total > 0 then map ((/ total) . max 0) chances else chances
