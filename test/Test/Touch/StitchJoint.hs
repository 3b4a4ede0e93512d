-- | The parts of the joint registration of frames to a lattice, each against its definition: the
-- phase of the lattice, the displacements of a frame, what frames make of each other, and where
-- each is in the end.
module Test.Touch.StitchJoint (spec) where

import Control.Monad (forM)
import Data.List (maximumBy, sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Data.Ord (Down (..), comparing)
import qualified Data.Vector.Storable as V
import qualified Data.Vector.Unboxed as Unboxed
import PraTactile.Image (constant)
import PraTactile.Registration.Joint.Consensus
import PraTactile.Registration.Joint.Grid
import PraTactile.Registration.Joint.Located
import PraTactile.Registration.Joint.Option
import PraTactile.Registration.Joint.Phase
import PraTactile.Registration.Lattice.Evidence (Evidence (..), evidence)
import PraTactile.Registration.Lattice.Layout (layoutGrid)
import PraTactile.Registration.Lattice.Symbols (symbolsClasses)
import PraTactile.Registration.Lattice.Template
import PraTactile.Registration.Posterior (Hypothesis (..))
import PraTactile.Registration.Search (Registration (..), standardRegistration)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (classes, scale, tables, total)

spec :: Spec
spec = do
  gridSpec
  modifyMaxSuccess (const 24) phaseSpec
  modifyMaxSuccess (const 40) optionSpec
  modifyMaxSuccess (const 400) consensusSpec
  modifyMaxSuccess (const 300) locatedSpec

-- | What a frame of nothing tells, to be told otherwise.
blank :: Evidence
blank = evidence (tablesOf 0 (16, 16)) (constant 16 16 0)
  where
    tablesOf = fromMaybe (error "the alphabet has tables") paperTemplates

-- | Half taxels to the lattice's pitch, across and down.
across, down :: Int
(across, down) = (2 * 16, 2 * 20)

-- | The number of a phase: orientation, row and column.
phaseAt :: (Int, Int, Int) -> Int
phaseAt (o, y, x) = (o * down + y `mod` down) * across + x `mod` across

genPlace :: Gen (Double, Double)
genPlace = (,) <$> choose (-40, 40) <*> choose (-40, 40)

-- | The grid point nearest to a place, in half taxels, and how far the place lies beyond it.
nearest :: Double -> (Int, Double)
nearest x = let n = round (2 * x) in (n, 2 * x - fromIntegral n)

-- | The logarithm of the density of a displacement by half taxels from the nearest grid point, up
-- to a constant: normal around the place, of the deviation in taxels.
priorOf :: Double -> Double -> Int -> Double
priorOf sigma beyond d = negate (((fromIntegral d - beyond) / 2) ^ (2 :: Int)) / (2 * sigma * sigma)

gridSpec :: Spec
gridSpec =
  it "the displacements reach as far as the search, by half taxels: from 2 to 64 of them" $
    [ gridReach (gridOf standardRegistration {registrationSigma = s, registrationReach = r})
      | (s, r) <- [(1, 4.5), (0.1, 1), (0.5, 2.2), (2, 4.5), (7, 4.5), (7.2, 4.5), (1, 0)]
    ]
      `shouldBe` [9, 2, 3, 18, 63, 64, 2]

phaseSpec :: Spec
phaseSpec =
  it "the lattice lies where all frames, each where its prior lets it be, have it likeliest" $
    forAllBlind (choose (2, 3) >>= (`vectorOf` ((,) <$> genPlace <*> genPhases))) $ \frames ->
      forAll (choose (0.2, 0.5)) $ \sigma ->
        let settings = standardRegistration {registrationSigma = sigma, registrationReach = 3}
            reach = gridReach (gridOf settings)
            score (o, (y, x)) = sum (map (told o y x) frames)
            told o y x ((px, py), phases) =
              let ((nx, rx), (ny, ry)) = (nearest px, nearest py)
               in log . (1e-300 +) . sum $
                    [ exp (priorOf sigma rx dx + priorOf sigma ry dy + here - V.maximum phases)
                      | dy <- [negate reach .. reach],
                        dx <- [negate reach .. reach],
                        let here = phases V.! phaseAt (o, y - ny - dy, x - nx - dx)
                    ]
            best =
              maximumBy
                (comparing score)
                [(o, (y, x)) | o <- [0, 1], y <- [0 .. down - 1], x <- [0 .. across - 1]]
         in commonPhase (gridOf settings) [(p, blank {evidencePhases = v}) | (p, v) <- frames]
              === best
  where
    genPhases = do
      wide <- elements [6, 5000, 20000, 20000]
      V.fromList <$> vectorOf (2 * across * down) (choose (negate wide, 0))

optionSpec :: Spec
optionSpec =
  it "a frame may lie where that is not less likely than its best by e^12, and sees cells there" $
    forAllBlind genSeen $ \(phases, classes, place@(px, py), sigma) ->
      forAll (elements [0, 1]) $ \o ->
        forAll ((,) <$> choose (0, down - 1) <*> choose (0, across - 1)) $ \(phaseY, phaseX) ->
          let settings = standardRegistration {registrationSigma = sigma, registrationReach = 3}
              reach = gridReach (gridOf settings)
              told = blank {evidencePhases = phases, evidenceClasses = classes}
              ((nx, rx), (ny, ry)) = (nearest px, nearest py)
              (columns, rows) = layoutGrid (templateLayout (evidenceTables told))
              prior (dx, dy) = priorOf sigma rx dx + priorOf sigma ry dy
              score d@(dx, dy) =
                prior d
                  + phases V.! phaseAt (o, phaseY - ny - dy, phaseX - nx - dx)
              all' = [(dx, dy) | dy <- [negate reach .. reach], dx <- [negate reach .. reach]]
              wanted = [d | d <- all', score d >= maximum (map score all') - 12]
              -- The cells of the lattice on the composite that lie on the frame's places.
              cells (dx, dy) =
                [ ((i, j), classesAt ((o * rows + y) * columns + x))
                  | i <- [-9 .. 9],
                    let y = phaseY + down * i - ny - dy,
                    y >= 0 && y < rows,
                    j <- [-9 .. 9],
                    let x = phaseX + across * j - nx - dx,
                    x >= 0 && x < columns
                ]
              classesAt k = V.toList (V.slice (k * count) count classes)
              found = optionsOf (gridOf settings) o (phaseY, phaseX) (place, told)
           in conjoin $
                (map optionShift found === wanted) :
                concat
                  [ [ property (abs (optionPrior option - prior d) < 1e-9),
                      map (Unboxed.toList . snd) (optionCells option) === map snd (cells d),
                      map (cell . fst) (optionCells option) === map fst (cells d)
                    ]
                    | option <- found,
                      let d = optionShift option
                  ]
  where
    count = symbolsClasses (templateSymbols (evidenceTables blank))
    -- A cell's row and column from its one number.
    cell k = let (i, j) = (k + 524288) `divMod` 1048576 in (i, j - 524288)
    -- Numbers of which some are exactly 12 below the best, or any.
    genSeen = do
      classes <- V.fromList <$> vectorOf (V.length (evidenceClasses blank)) (choose (-9, 9))
      let phases = fmap V.fromList . vectorOf (2 * across * down)
          halves k = fromIntegral <$> choose (negate k, k :: Int)
      wide <- elements [10, 60]
      oneof
        [ (,,,) <$> phases ((/ 2) <$> halves 30) <*> pure classes
            <*> ((,) <$> ((/ 2) <$> halves 80) <*> ((/ 2) <$> halves 80))
            <*> pure 0.5,
          (,,,) <$> phases (choose (negate wide, 0)) <*> pure classes <*> genPlace
            <*> choose (0.2, 1.5)
        ]

-- | Options of frames: displacement, logarithm of the prior, and by cell what is told of classes.
type Told = [((Int, Int), Double, [(Int, [Double])])]

consensusSpec :: Spec
consensusSpec =
  it "frames weigh their displacements by what all others say, until none changes its mind" $
    forAll (choose (1, 4) >>= (`vectorOf` genTold)) $ \frames ->
      let found = swept (map (map option) frames)
          rounds = iterate (anew frames) (map (shares . map alone) frames)
          wanted =
            head
              [ next
                | (k, now, next) <- zip3 [0 :: Int ..] rounds (drop 1 rounds),
                  k == 4 || map leader now == map leader next
              ]
          close a b = abs (a - b) < 1e-9
       in counterexample (show (map (map snd) found, wanted)) $
            map (map (optionShift . fst)) found === map (map (\(d, _, _) -> d)) frames
              .&&. property (and (zipWith (\f w -> and (zipWith close (map snd f) w)) found wanted))
  where
    option (d, prior, cells) = Option d prior [(c, Unboxed.fromList l) | (c, l) <- cells]
    alone (_, prior, cells) = prior + sum [likely (replicate 3 0) l | (_, l) <- cells]
    shares scores =
      let weights = map (exp . subtract (maximum scores)) scores in map (/ sum weights) weights
    leader ps = snd (maximumBy (comparing fst) (zip ps (map Down [0 :: Int ..])))
    -- What the other frames say of cells, each by its displacements that are likelier than a
    -- fiftieth; where one of them says something.
    anew :: [Told] -> [[Double]] -> [[Double]]
    anew frames weights =
      [ shares
          [ prior + sum [likely (Map.findWithDefault [0, 0, 0] c others) l | (c, l) <- cells]
            | (_, prior, cells) <- told
          ]
        | (k, told) <- zip [0 :: Int ..] frames,
          let others =
                Map.fromListWith
                  (zipWith (+))
                  [ (c, map (p *) l)
                    | (k', (told', ps)) <- zip [0 ..] (zip frames weights),
                      k' /= k,
                      ((_, _, cells'), p) <- zip told' ps,
                      p > 0.02,
                      (c, l) <- cells'
                  ]
      ]
    -- A cell is empty with probability 0.01, else of any class; by Bayes' rule once others have
    -- said something; and with probability 1e-12 they spoke of another cell.
    likely :: [Double] -> [Double] -> Double
    likely others mine =
      let first = 0.01 : map (const (0.99 / 3)) others
          known = shares (zipWith (+) (map log first) (0 : others))
          mixed = zipWith (\f k -> 1e-12 * f + (1 - 1e-12) * k) first known
          top = maximum (0 : mine)
       in top + log (sum (zipWith (\m l -> m * exp (l - top)) mixed (0 : mine)))
    genTold :: Gen Told
    genTold = do
      count <- choose (1, 4)
      strength <- elements [1, 5, 60, 900]
      places <- take count <$> shuffle [(x, y) | x <- [-5 .. 5], y <- [-5, 0, 5]]
      forM places $ \place ->
        (,,) place <$> choose (-6, 0)
          <*> (sublistOf [1, 2, 3] >>= mapM (\c -> (,) c <$> vectorOf 3 (symmetric strength)))
    symmetric strength = choose (negate strength, strength)

locatedSpec :: Spec
locatedSpec = do
  it "a frame is nowhere more probably than 1, for all rounding" $
    forAll (vectorOf 9 (choose (0.1, 1))) $ \weights ->
      let places = [(i, j) | j <- [-1 .. 1], i <- [-1 .. 1]]
          found = locatedAt (0, 0) (zip places (map (/ sum weights) weights))
       in locatedProbability found <= 1 && locatedProbability found > 0.999
  it "a frame is in the mean of the places around where most lies; others lie two taxels off" $
    forAll genPlace $ \place@(px, py) -> forAll genMasses $ \options ->
      let masses = Map.fromListWith (+) options
          beside (x, y) =
            [((i, j), p) | ((i, j), p) <- Map.toList masses, abs (i - x) <= 1, abs (j - y) <= 1]
          mass = sum . map snd . beside
          -- The first, where several have as much.
          best = head [d | d <- Map.keys masses, mass d >= most - 1e-9]
          most = maximum (map mass (Map.keys masses))
          mean part = sum [p * part d | (d, p) <- beside best] / mass best
          (meanX, meanY) = (mean (fromIntegral . fst), mean (fromIntegral . snd))
          -- From the nominal place, in eighths of a taxel.
          told (x, y) = (eighths ((x - snd (nearest px)) / 2), eighths ((y - snd (nearest py)) / 2))
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
          Located shift (alongX, alongY) probability hypotheses' = locatedAt place options
          close a b = counterexample (show (a, b)) (abs (a - b) < 1e-9)
       in conjoin
            [ shift === told (meanX, meanY),
              close alongX (deviation (fromIntegral . fst) meanX),
              close alongY (deviation (fromIntegral . snd) meanY),
              close probability (mass best),
              map hypothesisShift hypotheses' === map (told . exact) (take 2 others),
              conjoin (zipWith close (map hypothesisProbability hypotheses') (map mass others))
            ]
  where
    eighths t = fromIntegral (round (8 * t) :: Int) / 8 :: Double
    -- Some that count and some that hardly do, in parts of 2^14, so that sums are exact.
    genMasses = do
      reach <- elements [1, 2, 6, 12]
      count <- choose (1, 30)
      small <- elements [512, 64, 20, 12]
      weights <- vectorOf count (elements [512, small])
      places <- vectorOf count ((,) <$> choose (-reach, reach) <*> choose (-reach, reach))
      pure (zip places (map (/ 16384) weights))
