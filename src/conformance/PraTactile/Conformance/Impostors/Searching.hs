-- | How the decoder written from the documentation finds a place: by the table of windows, by
-- comparing all positions, by probabilities. Each step can be exchanged.
module PraTactile.Conformance.Impostors.Searching
  ( Searching (..),
    rightSearching,
    locateBy,
    nearestBy,
    posteriorBy,
    distanceOf,
  )
where

import Data.List (foldl1', intersect, sort)
import qualified Data.Map.Strict as Map
import Data.Maybe (catMaybes, fromMaybe)
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Surface (..))
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Impostors.Made
import PraTactile.Conformance.Impostors.Ways
import PraTactile.Profile (Profile (..))

-- | The steps from a patch to a place.
data Searching = Searching
  { -- | the patch, as it is taken
    taken :: [[Maybe Int]] -> [[Maybe Int]],
    -- | the complete windows that are looked up, of those that the patch has
    lookedUp :: [(Cell, [Int])] -> [(Cell, [Int])],
    -- | the patch's place, given the array's sizes, a window's place and its offset in the patch
    origin :: Profile -> Cell -> Cell -> Cell,
    -- | whether a place is kept, given for each observed cell whether it agrees
    kept :: [Bool] -> Bool,
    -- | the places found, as an answer; none is a refusal for the reason given
    settled :: String -> [Cell] -> Wire Place,
    -- | how many of the observed cells differ: what was seen, and what is there
    differing :: [Int] -> [Int] -> Int,
    -- | the radius that a distance guarantees
    guaranteed :: Natural -> Natural,
    -- | the offsets whose distance counts, given the patch's rows
    measured :: [[Maybe Int]] -> [Cell],
    -- | whether a number of differences is within a radius
    within :: Natural -> Natural -> Bool,
    -- | a cell's probabilities, as they are taken
    believed :: [Double] -> [Double],
    -- | the likelihood of a place, given those of its cells
    together :: [Double] -> Double,
    -- | the likelihoods of all places, as they are told
    told :: [(Cell, Double)] -> [(Cell, Double)]
  }

rightSearching :: Searching
rightSearching =
  Searching
    { taken = id,
      lookedUp = id,
      origin = beforeOffset,
      kept = and,
      settled = \reason places -> case places of
        [] -> refuse reason
        [place] -> pure (At (position place))
        several -> pure (OneOf (map position several)),
      differing = \seen there -> length (filter id (zipWith (/=) seen there)),
      guaranteed = \d -> if d == 0 then 0 else (d - 1) `div` 2,
      measured = map fst . observedIn,
      within = (<=),
      believed = \chances -> map (/ sum chances) chances,
      together = product,
      told = \likelihoods -> map (fmap (/ sum (map snd likelihoods))) likelihoods
    }

position :: Cell -> Position
position (r, c) = Position (fromInteger (max 0 r)) (fromInteger (max 0 c))

-- | The place that an offset leads from to another one.
beforeOffset :: Profile -> Cell -> Cell -> Cell
beforeOffset p (r, c) (i, j) = case profileSurface p of
  Sheet -> (r - i, c - j)
  Torus -> ((r - i) `mod` n1, (c - j) `mod` n2)
  TwistedTorus -> ((r * n2 + c - i * n2 - j) `mod` (n1 * n2)) `divMod` n2
  where
    (n1, n2) = sizes p

observedIn :: [[Maybe Int]] -> [(Cell, Int)]
observedIn cells =
  [((i, j), code) | (i, line) <- zip [0 ..] cells, (j, Just code) <- zip [0 ..] line]

-- | Rows of one length, with a cell at least, and codes below q.
checked :: Profile -> [[Maybe Code]] -> Wire [[Maybe Int]]
checked p cells
  | all null cells || any ((/= width) . length) cells = refuse "invalid"
  | any (any (>= profileOrder p)) (concat cells) = refuse "invalid"
  | otherwise = pure (map (map (fmap fromIntegral)) cells)
  where
    width = length (concat (take 1 cells))

completeIn :: Profile -> [[Maybe Int]] -> [(Cell, [Int])]
completeIn p cells =
  [ ((i, j), content)
    | i <- [0 .. toInteger (length cells) - 1],
      j <- [0 .. width - 1],
      Just content <- [traverse (\(a, b) -> Map.lookup (i + a, j + b) seen) (window p)]
  ]
  where
    width = toInteger (length (concat (take 1 cells)))
    seen = Map.fromList (observedIn cells)

-- | By the table of windows.
locateBy :: Searching -> Made -> Patch -> Wire Place
locateBy how this given = do
  cells <- taken how <$> checked p given
  let observed = observedIn cells
      complete = completeIn p cells
      occurring = lookedUp how (filter ((`Map.member` madeTable this) . snd) complete)
      places =
        foldl1'
          intersect
          [map (\at -> origin how p at offset) (found content) | (offset, content) <- occurring]
      parts place = [(== code) . cellOf this <$> on place offset | (offset, code) <- observed]
      on (r, c) (i, j) = lies (madeWays this) p (r + i, c + j)
      whole place =
        maybe False (kept how) (sequence (parts place))
          && maybe
            False
            (const True)
            (on place (0, 0))
      partly place = kept how (catMaybes (parts place))
  case () of
    _
      | null observed -> refuse "too-few-cells"
      | null complete -> refuse "no-complete-window"
      | null occurring && all (all (== 0) . snd) complete -> settled how "zero-window" []
      | null occurring -> settled how "not-in-array" []
      | any whole places -> settled how "contradiction" (sort (filter whole places))
      | any partly places -> settled how "off-sheet" []
      | otherwise -> settled how "contradiction" []
  where
    p = madeProfile this
    found content = Map.findWithDefault [] content (madeTable this)

-- | By comparing all positions.
nearestBy :: Searching -> Made -> Maybe Natural -> Patch -> Wire Place
nearestBy how this stated given = do
  cells <- taken how <$> checked p given
  let (offsets, codes) = unzip (observedIn cells)
      radius = fromMaybe (guaranteed how (distanceOf this (measured how cells))) stated
      counted =
        [ (fromIntegral (differing how codes there), place)
          | place <- everywhere this,
            Just there <- [contentAt this offsets place]
        ]
      least = minimum (map fst counted)
      nonzero = fromIntegral (length (filter (/= 0) codes))
  case () of
    _
      | null codes -> refuse "too-few-cells"
      | not (null counted) && within how least radius ->
        settled how "beyond-radius" [place | (n, place) <- counted, n == least]
      | radius == 0 && not (null (completeIn p cells)) -> locateBy how this given
      | radius == 0 -> settled how (if nonzero == 0 then "zero-window" else "contradiction") []
      | nonzero <= radius -> settled how "zero-window" []
      | otherwise -> settled how "beyond-radius" []
  where
    p = madeProfile this

-- | The least number of cells in which two contents differ on the folding's own surface; those of
-- an array are a linear code, so that it is the least weight.
distanceOf :: Made -> [Cell] -> Natural
distanceOf this offsets = case map weight (ownContents this offsets) of
  [] -> 0
  weights -> minimum weights
  where
    weight = fromIntegral . length . filter (/= 0)

-- | By the rule of Bayes.
posteriorBy :: Searching -> Made -> [[Maybe [Double]]] -> Wire [(Position, Double)]
posteriorBy how this given
  | all null given || any ((/= width) . length) given = refuse "invalid"
  | any (any (not . proper)) (concat given) = refuse "invalid"
  | otherwise =
    if null likelihoods
      then refuse "contradiction"
      else
        pure
          [(position place, x) | (place, x) <- told how likelihoods]
  where
    p = madeProfile this
    width = length (concat (take 1 given))
    proper chances =
      length chances == fromIntegral (profileOrder p) && all (>= 0) chances
        && abs
          (sum chances - 1)
        <= 0.001
    known =
      [ ((i, j), believed how chances) | (i, line) <- zip [0 ..] given, (j, Just chances) <-
                                                                          zip [0 ..] line
      ]
    (offsets, beliefs) = unzip known
    likelihoods =
      [ (place, x)
        | place <- everywhere this,
          Just there <- [contentAt this offsets place],
          let x = together how (zipWith (!!) beliefs there),
          x > 0
      ]
