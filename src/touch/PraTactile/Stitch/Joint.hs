{-# LANGUAGE BangPatterns #-}

-- | Many frames registered to one lattice of cells: where the lattice lies is found from all of
-- them, each frame's displacement from the lattice and from the symbols that the other frames saw
-- in the cells that it sees. The array is not known here.
--
-- The cost is linear in the frames: the lattice's phase is found from at most 'phaseFrames' of
-- them, and of each frame only the displacements that may matter are kept.
module PraTactile.Stitch.Joint
  ( Located (..),
    registerJointly,
  )
where

import Data.IntMap.Strict (IntMap)
import qualified Data.IntMap.Strict as IntMap
import Data.List (foldl', sortOn)
import qualified Data.Map.Strict as Map
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import qualified Data.Vector.Unboxed as Unboxed
import PraTactile.Image (Raster, rasterSize, rasterValues)
import PraTactile.Stitch.Blend (Place)
import PraTactile.Stitch.Evidence
import PraTactile.Stitch.Held (Held (..))
import PraTactile.Stitch.Layout
import PraTactile.Stitch.Posterior (Hypothesis (..), tolerance)
import PraTactile.Stitch.Product (dotWithin)
import PraTactile.Stitch.Search (Registration (..), searchRadius)
import PraTactile.Stitch.Spaced (spacedOut)
import PraTactile.Stitch.Symbols (symbolsClasses)
import PraTactile.Stitch.Tabulate (tabulate)
import PraTactile.Stitch.Template

-- | Where a frame was found.
data Located = Located
  { -- | Its displacement from its nominal place, taxels right and down.
    locatedShift :: !Place,
    -- | The standard deviations, taxels.
    locatedDeviation :: !Place,
    -- | The probability that it is within 'tolerance' of the truth on both axes.
    locatedProbability :: !Double,
    -- | Displacements that it may have instead, at least two taxels away, with their probabilities,
    -- the most probable first: at most two, each of at least a thousandth.
    locatedOthers :: [Hypothesis]
  }
  deriving stock (Eq, Show)

-- | The most frames that the lattice's phase is found from.
phaseFrames :: Int
phaseFrames = 64

-- | Where each frame is, from the nominal places (taxels) of their upper left pixels, and what they
-- tell at the lattice's angle. The displacements have mean 0, since a shift common to all cannot be
-- seen. The order of the frames changes nothing.
registerJointly :: Registration -> Held -> [(Place, Raster)] -> [Located]
registerJointly settings against frames = map snd (sortOn fst (zip order centred))
  where
    angle = heldAngle against
    (order, ordered) =
      unzip
        ( sortOn
            (\(_, ((x, y), image, _)) -> (y, x, rasterValues image))
            [ (k, (firstPlace (tablesOf image) (turnedBy (negate angle) place), image, told))
              | (k, (place, image), told) <- zip3 [0 :: Int ..] frames (heldFrames against)
            ]
        )
    grid = gridOf settings
    -- What few frames tell is kept; of many it would take too much memory.
    kept = [(place, sightEvidence told) | (place, _, told) <- ordered]
    again
      | length ordered <= phaseFrames = kept
      | otherwise = [(place, evidence (tablesOf image) image) | (place, image, _) <- ordered]
    tablesOf image = heldTables against (rasterSize image)
    (orientation, phase) = commonPhase grid (spacedOut phaseFrames kept)
    options = [optionsOf grid orientation phase frame | frame <- again]
    settled = swept options
    located = map (turnedTo angle) (zipWith locatedAt [place | (place, _, _) <- ordered] settled)
    n = fromIntegral (max 1 (length located))
    mean part = eighth (sum (map (part . locatedShift) located) / n)
    centred =
      [ l {locatedShift = less (locatedShift l), locatedOthers = map lessen (locatedOthers l)}
        | l <- located
      ]
    less (x, y) = (x - mean fst, y - mean snd)
    lessen h = h {hypothesisShift = less (hypothesisShift h)}

-- | What was found along the lattice's axes, which are turned by that many degrees, along the
-- frames'.
turnedTo :: Double -> Located -> Located
turnedTo 0 l = l
turnedTo angle l =
  l
    { locatedShift = turnedBy angle (locatedShift l),
      locatedDeviation = (along c s, along s c),
      locatedOthers =
        [h {hypothesisShift = turnedBy angle (hypothesisShift h)} | h <- locatedOthers l]
    }
  where
    (c, s) = turnedBy angle (1, 0)
    (sx, sy) = locatedDeviation l
    along i j = sqrt (i * i * sx * sx + j * j * sy * sy)

-- | To the nearest eighth of a taxel.
eighth :: Double -> Double
eighth t = fromIntegral (round (8 * t) :: Int) / 8

-- | The displacements that are considered.
data Grid = Grid
  { -- | How far, in places.
    gridReach :: !Int,
    -- | The robot's standard deviation, in places.
    gridSigma :: !Double
  }

gridOf :: Registration -> Grid
gridOf settings =
  Grid
    (max 2 (min 64 (ceiling (q * searchRadius settings))))
    (q * registrationSigma settings)

-- | Places to the taxel.
q :: Double
q = fromIntegral placesPerTaxel

-- | Where the first of a frame's places lies, from where its upper left pixel does.
firstPlace :: Templates -> Place -> Place
firstPlace tables (x, y) = (x + fromIntegral i, y + fromIntegral j)
  where
    (i, j) = layoutFirst (templateLayout tables)

-- | A nominal place as the nearest grid point, and what is left, in places.
onGrid :: Place -> ((Int, Int), (Double, Double))
onGrid (x, y) = ((round x', round y'), (x' - whole x', y' - whole y'))
  where
    (x', y') = (x * q, y * q)
    whole t = fromIntegral (round t :: Int)

-- | The logarithm of the prior along one axis, for a displacement in places from the grid point.
priorAlong :: Grid -> Double -> Int -> Double
priorAlong grid rest d = negate (t * t) / (2 * gridSigma grid * gridSigma grid)
  where
    t = fromIntegral d - rest

-- | The orientation and the phase, row and column, of the lattice on the composite that the frames
-- make likeliest, each anywhere that the prior lets it be.
commonPhase :: Grid -> [(Place, Evidence)] -> (Int, (Int, Int))
commonPhase grid frames = (o, (y, x))
  where
    (across, down) = phaseCount placesPerTaxel
    total = foldl' (V.zipWith (+)) (V.replicate (2 * across * down) 0) (map told frames)
    best = V.maxIndex total
    (row, x) = best `quotRem` across
    (o, y) = row `quotRem` down
    told (place, given) = V.map (\m -> log (m + 1e-300)) (shifted (blurred masses))
      where
        phases = evidencePhases given
        top = V.maximum phases
        -- What is too small for the floor above is nothing: numbers near the smallest are slow.
        masses = V.map (\l -> if l - top < -700 then 0 else exp (l - top)) phases
        ((nx, ny), (rx, ry)) = onGrid place
        -- At the phase on the composite, what the frame says of its own.
        shifted v = tabulate across (2 * down) $ \r ->
          let (orient, py) = r `quotRem` down
              !start = ((py - ny) `mod` down) * across * 2 + orient
           in \px -> V.unsafeIndex v (start + 2 * ((px - nx) `mod` across))
        -- Over the displacements, with their prior; by row, column and orientation.
        blurred =
          ringed (2 * across) down (kernel down ry) . ringed (2 * down) across (kernel across rx)
        -- The prior of the displacements from one phase to another, by their difference, twice
        -- around.
        kernel period rest =
          let once =
                V.accum
                  (+)
                  (V.replicate period 0)
                  [ (negate d `mod` period, exp (priorAlong grid rest d))
                    | d <- [negate (gridReach grid) .. gridReach grid]
                  ]
           in once <> once

-- | So many rows of numbers, each a ring of that length, blurred by a kernel that is given twice
-- around; the rows become columns.
ringed :: Int -> Int -> Vector Double -> Vector Double -> Vector Double
ringed rows period kernel v =
  tabulate rows period $ \x y -> dotWithin period (y * period) v (period - x) kernel

-- | A displacement of a frame, in places from its grid point: the prior's logarithm and what the
-- frame says of each cell that it sees there, by the cell's number.
data Option = Option
  { optionShift :: !(Int, Int),
    optionPrior :: !Double,
    optionCells :: ![(Int, Classes)]
  }

-- | A number for each class of symbols. There are millions of them where there are thousands of
-- frames, and the garbage collector may move them together.
type Classes = Unboxed.Vector Double

-- | The displacements of a frame that may matter: those less than 'margin' below the likeliest, by
-- the frame alone.
optionsOf :: Grid -> Int -> (Int, Int) -> (Place, Evidence) -> [Option]
optionsOf grid orientation (phaseY, phaseX) (place, given) =
  [ Option (dx, dy) prior (cells dx dy)
    | (score, prior, dx, dy) <- scored,
      score >= best - margin
  ]
  where
    tables = evidenceTables given
    places = templateLayout tables
    (across, down) = phaseCount (layoutPlaces places)
    (columns, rows) = layoutGrid places
    count = symbolsClasses (templateSymbols tables)
    ((nx, ny), (rx, ry)) = onGrid place
    reach = gridReach grid
    scored =
      [ (prior + alone dx dy, prior, dx, dy)
        | dy <- [negate reach .. reach],
          dx <- [negate reach .. reach],
          let prior = priorAlong grid rx dx + priorAlong grid ry dy
      ]
    alone dx dy =
      V.unsafeIndex
        (evidencePhases given)
        ( (orientation * down + (phaseY - ny - dy) `mod` down) * across
            + (phaseX - nx - dx) `mod` across
        )
    best = maximum [s | (s, _, _, _) <- scored]
    margin = 12
    cells dx dy =
      [ ( cellNumber ((y + ny + dy - phaseY) `div` down) ((x + nx + dx - phaseX) `div` across),
          let start = cellIndex places orientation y x * count
           in Unboxed.generate count (\k -> V.unsafeIndex (evidenceClasses given) (start + k))
        )
        | y <- [(phaseY - ny - dy) `mod` down, (phaseY - ny - dy) `mod` down + down .. rows - 1],
          x <-
            [ (phaseX - nx - dx) `mod` across,
              (phaseX - nx - dx) `mod` across + across
              .. columns - 1
            ]
      ]

-- | One number for a cell's row and column.
cellNumber :: Int -> Int -> Int
cellNumber row column = row * 1048576 + column

-- | For each frame its options with their probabilities, once every frame has been weighed with
-- what all others say of the symbols, until none changes its mind.
swept :: [[Option]] -> [[(Option, Double)]]
swept frames = go (4 :: Int) first (beliefs first)
  where
    first =
      [ weighed
          (map (\o -> (o, optionPrior o + sum (map (marginal Nothing . snd) (optionCells o)))) os)
        | os <- frames
      ]
    go n now known
      | n <= 0 || unchanged = new
      | otherwise = go (n - 1) new (beliefs new)
      where
        new = [anew os known (said os) | os <- now]
        unchanged = map leader now == map leader new
    anew os known own =
      weighed
        [ ( o,
            optionPrior o
              + sum
                [ marginal (fmap (`less` IntMap.lookup c own) (IntMap.lookup c known)) l
                  | (c, l) <- optionCells o
                ]
          )
          | (o, _) <- os
        ]
    less total (Just mine) = Unboxed.zipWith (-) total mine
    less total Nothing = total
    leader os = fmap (optionShift . fst) (foldl' larger Nothing os)
    larger Nothing o = Just o
    larger (Just a) b = Just (if snd b > snd a then b else a)
    beliefs :: [[(Option, Double)]] -> IntMap Classes
    beliefs = foldl' (\m os -> IntMap.unionWith (Unboxed.zipWith (+)) m (said os)) IntMap.empty

-- | What a frame says of the cells, in the mean over its options; nothing where it is not sure
-- where it is.
said :: [(Option, Double)] -> IntMap Classes
said os =
  IntMap.fromListWith
    (Unboxed.zipWith (+))
    [(c, Unboxed.map (* p) l) | (o, p) <- os, p > 0.02, (c, l) <- optionCells o]

-- | The probability that a frame shows something else in a cell than all others do there, because
-- one of them is not where it is supposed to be (assumption). So however clear frames are, a stray
-- one has a place.
unlike :: Double
unlike = 1e-12

-- | How much likelier a cell is than nothing there: by what one frame says of its classes, and
-- where there is any by what the others say.
marginal :: Maybe Classes -> Classes -> Double
marginal others mine = logMean (maybe prior known others)
  where
    n = Unboxed.length mine
    share = (1 - absent) / fromIntegral n
    prior = (absent, Unboxed.replicate n share)
    known theirs =
      let top = max 0 (Unboxed.maximum theirs)
          likely = Unboxed.map (\l -> share * exp (l - top)) theirs
          nothing = absent * exp (negate top)
          total = nothing + Unboxed.sum likely
       in (besides absent (nothing / total), Unboxed.map (besides share . (/ total)) likely)
    besides alone told = (1 - unlike) * told + unlike * alone
    logMean (nothing, shares) =
      let top = max 0 (Unboxed.maximum mine)
       in top
            + log
              ( nothing * exp (negate top)
                  + Unboxed.sum (Unboxed.zipWith (\s l -> s * exp (l - top)) shares mine)
              )

weighed :: [(Option, Double)] -> [(Option, Double)]
weighed scored = [(o, exp (s - top) / total) | (o, s) <- scored]
  where
    top = maximum (map snd scored)
    total = sum [exp (s - top) | (_, s) <- scored]

-- | Where a frame is, by its options: the mean of those near the likeliest.
locatedAt :: Place -> [(Option, Double)] -> Located
locatedAt place options =
  Located
    (finally meanX rx, finally meanY ry)
    (spreadOf meanX fst, spreadOf meanY snd)
    (min 1 mass)
    (take 2 (instead (filter (far (meanX, meanY) . snd) (sortOn (negate . fst) held))))
  where
    instead found = case found of
      (p, (x, y)) : rest
        | p >= 0.001 ->
          Hypothesis (finally (fromIntegral x) rx, finally (fromIntegral y) ry) p :
          instead (filter (far (fromIntegral x, fromIntegral y) . snd) rest)
      _ -> []
    far (x, y) (x', y') = max (abs (x - fromIntegral x')) (abs (y - fromIntegral y')) >= 2 * q
    (_, (rx, ry)) = onGrid place
    masses = Map.fromListWith (+) [(optionShift o, p) | (o, p) <- options]
    reach = floor (q * tolerance + 1e-9) :: Int
    around (x, y) =
      [ ((x', y'), p)
        | y' <- [y - reach .. y + reach],
          x' <- [x - reach .. x + reach],
          Just p <- [Map.lookup (x', y') masses]
      ]
    held = [(sum (map snd (around d)), d) | d <- Map.keys masses]
    (mass, best) = foldl' (\a b -> if fst b > fst a + 1e-9 then b else a) (-1, (0, 0)) held
    near = around best
    meanX = sum [p * fromIntegral x | ((x, _), p) <- near] / mass
    meanY = sum [p * fromIntegral y | ((_, y), p) <- near] / mass
    finally mean rest = eighth ((mean - rest) / q)
    spreadOf :: Double -> ((Int, Int) -> Int) -> Double
    spreadOf mean part =
      sqrt (sum [p * squared (fromIntegral (part d) - mean) | (d, p) <- Map.toList masses] + 1 / 12)
        / q
    squared !t = t * t
