{-# OPTIONS_HADDOCK hide #-}

-- | Registration straight from its formulas, on lists and maps. It draws every symbol at every
-- place, and sums over every phase, class and displacement. It is slow: use it for a few small
-- frames. The tests compare the fast stages with it.
module PraTactile.Registration.Definition
  ( -- * One frame
    SymbolReadings,
    drawings,
    SymbolMoments,
    Moments,
    drawn,
    standardised,
    firstTheta,
    mStep,
    classLogsOf,
    cellLogOf,
    phaseLogsOf,
    density,

    -- * Many frames
    FrameLikelihoods (..),
    Robot (..),
    commonPhase,
    likely,
    sigmas,
    meanField,
    togetherLog,
    estimate,

    -- * Two frames
    pairPosterior,

    -- * Numbers
    logMean,
    shares,
  )
where

import Data.List (maximumBy, sortOn, transpose)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Data.Ord (Down (..), comparing)
import qualified Data.Vector as Boxed
import qualified Data.Vector.Storable as V
import PraTactile.Image hiding (mean)
import PraTactile.Registration.Estimate (Estimate (..))
import PraTactile.Registration.Model (Theta (..))
import PraTactile.Registration.Posterior (Hypothesis (..))
import PraTactile.Shape (Alphabet, embossedAt, halfTurned, shapes)

-- | Sums over a frame's taxels for a frame z and a symbol T at a place: of z T, of T and of T^2.
type Moments = (Double, Double, Double)

-- | The moments of each class by orientation, row and column of its place. Places count from the
-- centre of the frame's upper left taxel.
type SymbolMoments = Map.Map (Int, Int, Int) [Moments]

-- | The moments of every symbol at every place from which it is felt, with q places per taxel (1 or
-- 2). Symbols lie along the frame's axes.
drawn :: SymbolReadings -> Int -> Raster -> SymbolMoments
drawn (SymbolReadings byOrientation) q image =
  Map.fromList
    [ ((o, y, x), [momentsAt shape y x | shape <- shapes'])
      | (o, shapes') <- zip [0 ..] byOrientation,
        -- A symbol's 8 x 12 taxels are felt up to two taxels around them.
        y <- [-14 * q .. (h + 2) * q - 1],
        x <- [-10 * q .. (w + 2) * q - 1]
    ]
  where
    (w, h) = rasterSize image
    momentsAt shape y x =
      let readings =
            [ (t, fromMaybe 0 (index image u v))
              | v <- [0 .. h - 1],
                u <- [0 .. w - 1],
                let t = shape (2 * u - halves x) (2 * v - halves y),
                t > 0
            ]
          halves k = 2 * k `div` q
       in ( sum [t * z | (t, z) <- readings],
            sum (map fst readings),
            -- A reading below a hundredth is left out.
            sum [t * t | (t, _) <- readings, t > 0.01]
          )

-- | By orientation and class: what a taxel reads of a symbol. The taxel's place is in half taxels,
-- right and down of the symbol's upper left taxel.
newtype SymbolReadings = SymbolReadings [[Int -> Int -> Double]]

-- | The drawings of an alphabet's symbols.
drawings :: Alphabet -> SymbolReadings
drawings known = SymbolReadings [map drawing upright, map (drawing . halfTurned) upright]
  where
    upright = shapes known
    drawing shape = \x y ->
      if inside x 8 && inside y 12 then table Boxed.! ((y + 8) * across + x + 8) else 0
      where
        inside t side = t >= -8 && t < 2 * side + 8
        across = 2 * 8 + 16
        table =
          Boxed.fromList
            [ sum
                [ blurred (x - 2 * i) * blurred (y - 2 * j)
                  | j <- [0 .. 11],
                    i <- [0 .. 7],
                    embossedAt shape i j
                ]
              | y <- [-8 .. 2 * 12 + 7],
                x <- [-8 .. 2 * 8 + 7]
            ]

-- | Reading of one embossed taxel at n half taxels from its centre, blurred with a standard
-- deviation of 0.75 taxels. It is 0 from six half taxels on. The integral is by Simpson's rule.
blurred :: Int -> Double
blurred n
  | abs n >= 6 = 0
  | otherwise = known Boxed.! (n + 5)
  where
    known = Boxed.fromList [share (fromIntegral k / 2) | k <- [-5 .. 5 :: Int]]
    share t = sum [c * normal (t - 0.5 + s / 40) | (c, s) <- zip simpson [0 .. 40]] / 120
    simpson = 1 : concat (replicate 19 [4, 2]) ++ [4, 1]
    normal d = exp (-(d * d) / (2 * 0.75 * 0.75)) / sqrt (2 * pi * 0.75 * 0.75)

-- | Scales a frame's readings to mean 0 and variance 1.
standardised :: Raster -> Raster
standardised image = mapRaster (\v -> (v - average) / sqrt (sum (map squared values) / n)) image
  where
    values = V.toList (rasterValues image)
    n = fromIntegral (length values)
    average = sum values / n
    squared v = (v - average) * (v - average)

-- | Starting point of EM. The noise comes from second differences, whose variance is four times
-- that of white noise. The gain and the offset are usual for symbols.
firstTheta :: Raster -> Theta
firstTheta image = Theta gain (-0.15 * gain) noise
  where
    (w, h) = rasterSize image
    at x y = fromMaybe 0 (index image x y)
    differences =
      [ at x y - at (x + 1) y - at x (y + 1) + at (x + 1) (y + 1)
        | y <- [0 .. h - 2],
          x <- [0 .. w - 2]
      ]
    squares = sum (map (^ (2 :: Int)) differences)
    noise = max 0.001 (min 0.95 (squares / (4 * fromIntegral (length differences))))
    gain = sqrt (max 0.02 (1 - noise)) / 0.36

-- | l_k of every class at each place.
classLogsOf :: Theta -> SymbolMoments -> Map.Map (Int, Int, Int) [Double]
classLogsOf (Theta a b v) = fmap (map (\(y, s, q) -> (a * y - a * b * s - a * a * q / 2) / v))

-- | l of a cell, classes summed, from l_k.
cellLogOf :: [Double] -> Double
cellLogOf ls = logSum ((log 0.01, 0) : [(log (0.99 / fromIntegral (length ls)), l) | l <- ls])
  where
    logSum terms = let top = maximum (map snd terms) in top + log (sum (map (from top) terms))
    from top (p, l) = exp (p + l - top)

-- | L of each phase, with q places per taxel. The cells of a phase lie 16 x 20 taxels apart.
phaseLogsOf :: Int -> Map.Map (Int, Int, Int) [Double] -> Map.Map (Int, Int, Int) Double
phaseLogsOf q = Map.mapKeysWith (+) (phaseOf q) . fmap cellLogOf

phaseOf :: Int -> (Int, Int, Int) -> (Int, Int, Int)
phaseOf q (o, y, x) = (o, y `mod` (20 * q), x `mod` (16 * q))

-- | log p(z) of a frame of n taxels, from theta, the number of all phases, and L of those summed.
density :: Double -> Theta -> Int -> [Double] -> Double
density n (Theta _ b v) count phases =
  logMean phases + log (fromIntegral (length phases) / fromIntegral count)
    - n * (1 + b * b) / (2 * v)
    - n / 2 * log (2 * pi * v)

-- | One EM step on a frame of n taxels, over the phases that the predicate accepts; q places per
-- taxel.
mStep :: Int -> Double -> ((Int, Int, Int) -> Bool) -> SymbolMoments -> Theta -> Theta
mStep q n counts felt theta@(Theta a b _) = Theta a' b' v'
  where
    classes = classLogsOf theta felt
    phases = Map.filterWithKey (\k _ -> counts k) (phaseLogsOf q classes)
    weights =
      Map.filter (>= 1e-6) (Map.fromList (zip (Map.keys phases) (shares (Map.elems phases))))
    expected =
      [ (w * p, m)
        | (place, moments) <- Map.toList felt,
          Just w <- [Map.lookup (phaseOf q place) weights],
          Just ls <- [Map.lookup place classes],
          let l = cellLogOf ls,
          (m, lk) <- zip moments ls,
          let p = 0.99 / fromIntegral (length ls) * exp (lk - l)
      ]
    ofClasses part = sum [p * part m | (p, m) <- expected]
    y' = ofClasses (\(y, _, _) -> y)
    s' = ofClasses (\(_, s, _) -> s)
    q' = ofClasses (\(_, _, t) -> t)
    varying = q' - s' * s' / n
    a' = if varying > 1e-6 then max 0.3 (y' / varying) else a
    b' = if varying > 1e-6 then -a' * s' / n else b
    v' = max 0.002 ((n * (1 + b' * b') - 2 * a' * (y' - b' * s') + a' * a' * q') / n)

-- | A frame's nominal place, in taxels, and its log-likelihoods at half taxels: L and l_k.
data FrameLikelihoods = FrameLikelihoods
  { framePlace :: !(Double, Double),
    framePhases :: !(Map.Map (Int, Int, Int) Double),
    seenClasses :: !(Map.Map (Int, Int, Int) [Double])
  }

-- | The grid point nearest to a coordinate, in half taxels, and the coordinate's offset from it.
nearest :: Double -> (Int, Double)
nearest x = let n = round (2 * x) in (n, 2 * x - fromIntegral n)

-- | The robot's error: the least and the greatest standard deviation, in taxels, and the largest
-- displacement, in half taxels.
data Robot = Robot !(Double, Double) !Int

-- | Values of sigma in half taxels, n per octave.
sigmas :: Int -> Robot -> [Double]
sigmas n (Robot (least, most) _) =
  takeWhile
    (<= 2 * most * 1.001)
    [2 * least * 2 ** (fromIntegral k / fromIntegral n) | k <- [0 :: Int ..]]

-- | Squared distance from a nominal place, by half taxels from the grid point nearest to it.
squaresAt :: Robot -> (Double, Double) -> Map.Map (Int, Int) Double
squaresAt (Robot _ reach) (px, py) =
  Map.fromList
    [ ((dx, dy), squared (off px dx) + squared (off py dy))
      | dy <- [-reach .. reach],
        dx <- [-reach .. reach]
    ]
  where
    off p d = fromIntegral d - snd (nearest p)
    squared t = t * t :: Double

-- | log pi, given sigma, from the square of a displacement, all in half taxels.
logPi :: Double -> Double -> Double
logPi sigma square = -square / (2 * v) - log (2 * pi * v)
  where
    v = sigma * sigma + 1 / 12

-- | The phase that all frames together make likeliest, in half taxels from the origin of their
-- places. Sigma takes one value per octave.
commonPhase :: Robot -> [FrameLikelihoods] -> (Int, Int, Int)
commonPhase robot frames =
  maximumBy (comparing (\phase -> logMean [sum (map ($ phase) told) | told <- bySigma])) all'
  where
    all' = [(o, y, x) | o <- [0, 1], y <- [0 .. 39], x <- [0 .. 31]]
    bySigma = [map (ofFrame sigma) frames | sigma <- sigmas 1 robot]
    ofFrame sigma (FrameLikelihoods place phases _) = \phase ->
      log . (\p -> 1e-3 + (1 - 1e-3) * p) . sum $
        [exp (prior + onFrame phases place d phase - top) | (d, prior) <- displacements]
      where
        top = maximum phases
        displacements = Map.toList (fmap (logPi sigma) (squaresAt robot place))

onFrame ::
  Map.Map (Int, Int, Int) Double -> (Double, Double) -> (Int, Int) -> (Int, Int, Int) -> Double
onFrame phases (px, py) (dx, dy) (o, y, x) =
  Map.findWithDefault 0 (phaseOf 2 (o, y - fst (nearest py) - dy, x - fst (nearest px) - dx)) phases

-- | The displacements whose log-probability by the frame alone is within the margin of the best.
-- Each comes with its square and with l_k of the cells that the frame sees. Cells are numbered by
-- row and column from the phase's first.
likely ::
  Double ->
  Robot ->
  (Int, Int, Int) ->
  FrameLikelihoods ->
  [((Int, Int), Double, Map.Map (Int, Int) [Double])]
likely margin robot phase@(o, y0, x0) (FrameLikelihoods place@(px, py) phases classes) =
  [(d, squares Map.! d, cells d) | d <- displacements, score d >= best - margin]
  where
    displacements = [(dx, dy) | dy <- [-reach .. reach], dx <- [-reach .. reach]]
    Robot _ reach = robot
    squares = squaresAt robot place
    score d =
      logMean [logPi s (squares Map.! d) | s <- sigmas 1 robot] + onFrame phases place d phase
    best = maximum (map score displacements)
    cells (dx, dy) =
      Map.fromList
        [ ((i `div` 40, j `div` 32), ls)
          | ((o', y, x), ls) <- Map.toList classes,
            o' == o,
            let (i, j) = (y + fst (nearest py) + dy - y0, x + fst (nearest px) + dx - x0),
            i `mod` 40 == 0 && j `mod` 32 == 0
        ]

-- | q_f of each frame over its displacements, and the posterior of the given values of sigma.
meanField ::
  Ord cell => [Double] -> [[(d, Double, Map.Map cell [Double])]] -> ([[Double]], [Double])
meanField bySigma frames = (qs', shares (robot (const True) qs'))
  where
    qs' = settled (5 :: Int) (map (shares . map alone) frames)
    settled k now
      | k <= 1 || map leader now == map leader next = next
      | otherwise = settled (k - 1) next
      where
        next = sweep now
    alone = given (map (const 0) bySigma) (const Nothing)
    leader ps = snd (maximumBy (comparing fst) (zip ps (map Down [0 :: Int ..])))
    given others' expected (_, square, cells) =
      logMean (zipWith (\l sigma -> l + logPi sigma square) others' bySigma)
        + sum [cellGiven (expected c) ls | (c, ls) <- Map.toList cells]
    sweep qs =
      [ shares (map (given (robot (/= k) qs) (`Map.lookup` others k qs)) told)
        | (k, told) <- zip [0 :: Int ..] frames
      ]
    -- Log-likelihood of each sigma by the frames that the predicate accepts.
    robot which qs =
      [ sum
          [ p * logPi sigma square
            | (k, told, ps) <- zip3 [0 :: Int ..] frames qs,
              which k,
              ((_, square, _), p) <- zip told ps
          ]
        | sigma <- bySigma
      ]
    others k qs =
      Map.unionsWith
        (zipWith (+))
        [ fmap (map (p *)) cells
          | (k', (told, ps)) <- zip [0 ..] (zip frames qs),
            k' /= k,
            ((_, _, cells), p) <- zip told ps,
            p > 0.02
        ]

-- | log P of what all frames show, up to a constant for each: the exact sum over their
-- displacements and over sigma. A frame is an outlier in a cell with probability delta.
togetherLog :: Ord cell => [Double] -> [[(d, Double, Map.Map cell [Double])]] -> Double
togetherLog bySigma frames =
  logOfSum
    [ sum [logPi sigma square + log (2 * pi) | (_, square, _) <- taken]
        + sum (map ofCell (Map.elems cells))
      | taken <- sequence frames,
        let cells = Map.unionsWith (++) [fmap (: []) told | (_, _, told) <- taken],
        sigma <- bySigma
    ]
  where
    ofCell told =
      logOfSum
        [ log p + sum [logOfSum [log 0.999 + l, log 1e-3 + cellGiven Nothing ls] | (l, ls) <- here]
          | (p, here) <- zip (0.01 : repeat (0.99 / classes)) (transpose (map each told))
        ]
      where
        each ls = [(l, ls) | l <- 0 : ls]
        classes = fromIntegral (maximum (map length told))

-- | Log-sum-exp.
logOfSum :: [Double] -> Double
logOfSum ls = let top = maximum ls in top + log (sum [exp (l - top) | l <- ls])

-- | Log-likelihood ratio of a cell to an empty one, from the others' expected l_k, if any see it,
-- and l_k of one frame.
cellGiven :: Maybe [Double] -> [Double] -> Double
cellGiven others mine = top + log (sum (zipWith (\m l -> m * exp (l - top)) mixed (0 : mine)))
  where
    prior = 0.01 : map (const (0.99 / fromIntegral (length mine))) mine
    known = shares (zipWith (+) (map log prior) (0 : fromMaybe (map (const 0) mine) others))
    mixed = zipWith (\p m -> 1e-3 * p + (1 - 1e-3) * m) prior known
    top = maximum (0 : mine)

-- | The estimate of a frame from its nominal place and the probabilities of its displacements, in
-- half taxels from the grid point nearest to that place. It is the mean of the 3 x 3 displacements
-- that hold most probability, the first of equals, to an eighth of a taxel. Standard deviations
-- include that of a grid cell. At most two alternatives follow.
estimate :: (Double, Double) -> [((Int, Int), Double)] -> Estimate
estimate (px, py) options =
  Estimate
    (eighths (meanX, meanY))
    (deviation (fromIntegral . fst) meanX, deviation (fromIntegral . snd) meanY)
    (min 1 (mass best))
    [Hypothesis (eighths (exact d)) (mass d) | d <- take 2 others]
    (take 2 others)
  where
    masses = Map.fromListWith (+) options
    beside (x, y) =
      [((i, j), p) | ((i, j), p) <- Map.toList masses, abs (i - x) <= 1, abs (j - y) <= 1]
    mass = sum . map snd . beside
    most = maximum (map mass (Map.keys masses))
    best = minimum [d | d <- Map.keys masses, mass d >= most - 1e-9]
    mean part = sum [p * part d | (d, p) <- beside best] / mass best
    (meanX, meanY) = (mean (fromIntegral . fst), mean (fromIntegral . snd))
    eighths (x, y) = (eighth ((x - snd (nearest px)) / 2), eighth ((y - snd (nearest py)) / 2))
    eighth t = fromIntegral (round (8 * t) :: Int) / 8
    deviation part middle =
      let squares = sum [p * (part d - middle) ^ (2 :: Int) | (d, p) <- Map.toList masses]
       in sqrt (squares + 1 / 12) / 2
    exact (x, y) = (fromIntegral x, fromIntegral y)
    far (x, y) (i, j) = max (abs (x - i)) (abs (y - j)) >= 4
    others = apart [(meanX, meanY)] (sortOn (Down . mass) (Map.keys masses))
    apart taken ds =
      case [d | d <- ds, all (`far` exact d) taken, mass d >= 0.001] of
        d : rest -> d : apart (exact d : taken) rest
        [] -> []

-- | Posterior of the second frame's displacements against the first, in half taxels. Given are the
-- log prior of each and l_k of both frames. All phases and the classes of each cell are summed.
pairPosterior ::
  [((Int, Int), Double)] ->
  Map.Map (Int, Int, Int) [Double] ->
  Map.Map (Int, Int, Int) [Double] ->
  [Double]
pairPosterior displacements a b = map (/ sum weights) weights
  where
    logs =
      [ map (prior +) (Map.elems (phaseLogsOf 2 (Map.unionWith (zipWith (+)) a (moved d))))
        | (d, prior) <- displacements
      ]
    moved (dx, dy) = Map.mapKeysMonotonic (\(o, y, x) -> (o, y + dy, x + dx)) b
    top = maximum (map maximum logs)
    weights = [sum [exp (l - top) | l <- some] | some <- logs]

-- | Log of the mean of numbers given by their logarithms.
logMean :: [Double] -> Double
logMean logs = top + log (sum [exp (l - top) | l <- logs] / fromIntegral (length logs))
  where
    top = maximum logs

-- | Normalises log weights to probabilities.
shares :: [Double] -> [Double]
shares logs = let weights = map (exp . subtract (maximum logs)) logs in map (/ sum weights) weights
