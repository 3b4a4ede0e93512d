{-# OPTIONS_HADDOCK hide #-}

-- | Every number that decides in registration, with its unit and its source: a derivation, a
-- measurement by a command, or "assumption". Settings of the user are in
-- "PraTactile.Registration.Settings", limits of size in "PraTactile.Registration".
module PraTactile.Registration.Numbers
  ( -- * Readings: gains in standard deviations of a frame's values
    leastGain,
    leastVariance,
    leastShare,
    blurDeviation,
    pressGainVariance,
    pressOffsetVariance,

    -- * Tilted presses
    leastTouch,
    independentShare,
    mostAsked,
    pressSteps,

    -- * The lattice
    absence,
    placesPerTaxel,
    sure,
    misfit,
    negligible,
    leastWeight,
    cellShare,
    phaseFrames,
    keptPixels,

    -- * Displacements
    sigmasPerOctave,
    tolerance,
    outlier,
    unlikely,
    heardOfCells,
    mostSweeps,
    mostReach,
    mostCandidates,
    leastOther,

    -- * Overlaps
    independent,
    tempering,
    gainVariance,
    alike,
    mostNoise,
    interpolated,
    highest,
    mostOfProcess,
    keptPatches,
    leastOverlap,
    mostPairs,
    pairSweeps,
    heardOfPairs,
    mostSteps,

    -- * Layouts
    refuted,
    hopeless,
    mostLog,
    decisive,
    largeError,
    mostScales,
    scaleFrames,
    leastExtent,
    greatestExtent,
    framesOfLayout,
    pairsOfLayout,
    mostElsewhere,
    mostTied,
    groupShare,
    mostLines,
    mostGroups,
    leastGap,
  )
where

-- | Lower limit of estimated gains. Assumption: no frame is pure noise.
leastGain :: Double
leastGain = 0.3

-- | Lower limit of estimated noise variances. Assumption: no frame is without noise.
leastVariance :: Double
leastVariance = 2e-3

-- | A taxel that reads less of a symbol than this is left out of sums of squares. It saves time.
leastShare :: Double
leastShare = 0.01

-- | beta, taxels: standard deviation of the blur by an elastic overlay and an element's aperture.
-- Assumption: half as much more, or half, changes little. The pose depends on edges, which finite
-- elements show sharper; "PraTactile.Pose" therefore takes 0.3.
blurDeviation :: Double
blurDeviation = 0.75

-- | Variance of log gains among one sensor's presses. Assumption: 30 %.
pressGainVariance :: Double
pressGainVariance = 0.09

-- | Variance of offset / gain among one sensor's presses. Assumption: 5 %.
pressOffsetVariance :: Double
pressOffsetVariance = 0.0025

-- | A taxel touches if its t ("PraTactile.Registration.Contact") is at least this. Assumption.
leastTouch :: Double
leastTouch = 0.25

-- | Share of the taxels that counts in the test for tilted presses. Assumption: neighbouring taxels
-- have residual relief in common.
independentShare :: Double
independentShare = 0.2

-- | At most this many frames are tested for tilt. It saves time.
mostAsked :: Int
mostAsked = 12

-- | EM steps of a quick fit of a press; the final fit takes 15. It saves time.
pressSteps :: Int
pressSteps = 8

-- | epsilon, the prior probability that a cell is empty: beyond the face, or worn off. Assumption.
absence :: Double
absence = 0.01

-- | Grid points per taxel of displacements and phases. Half a taxel is a quarter of the blur's
-- width.
placesPerTaxel :: Int
placesPerTaxel = 2

-- | Log posterior odds above which registration accepts the lattice against any other relief. They
-- belong to 0.99, the posterior that users are given.
sure :: Double
sure = log 99

-- | Lower limit of the rival process's noise share when frames are tested for the lattice.
-- Assumption: sensors do not feel symbols quite as they are drawn.
misfit :: Double
misfit = 0.1

-- | Hypotheses e^30 less likely than the best are dropped. It saves time.
negligible :: Double
negligible = 30

-- | Phases and symbols of a lower probability are left out of an M step. It saves time.
leastWeight :: Double
leastWeight = 1e-6

-- | Share of a cell's log-likelihood that counts when classes are reported and layouts compared.
-- Measured: as many symbols are wrong as their probabilities predict (@bench/calibration.py@).
cellShare :: Double
cellShare = 0.05

-- | At most this many frames determine the phase. It saves time.
phaseFrames :: Int
phaseFrames = 64

-- | Log-likelihoods stay in memory for up to 'phaseFrames' frames of this many pixels each. It
-- saves memory.
keptPixels :: Int
keptPixels = 1024

-- | Values of sigma per octave. Half their spacing, a twelfth of an octave, is 6 %.
sigmasPerOctave :: Int
sigmasPerOctave = 6

-- | A displacement counts as right within this many taxels of the truth along each axis.
-- Definition.
tolerance :: Double
tolerance = 0.75

-- | delta, the probability that a frame is an outlier in a cell or an overlap: unrelated to what
-- all others show there. Assumption. Such a frame lies elsewhere, or has only the edge of a symbol,
-- felt otherwise than the model has it. With delta = 0 it would move by a whole cell.
outlier :: Double
outlier = 1e-3

-- | Displacements and phases e^12 less likely than the best, by the frame alone, are left out. It
-- saves time.
unlikely :: Double
unlikely = 12

-- | Displacements of a lower probability are left out of a frame's message about cells. It saves
-- time.
heardOfCells :: Double
heardOfCells = 0.02

-- | At most this many sweeps of the mean field over cells. Most runs end after two.
mostSweeps :: Int
mostSweeps = 5

-- | Largest displacement on the grid of pairs, taxels: three times the largest standard deviation
-- of an unknown position error.
mostReach :: Int
mostReach = 12

-- | At most this many pairs of a displacement and a phase are summed for two frames. It saves time.
mostCandidates :: Int
mostCandidates = 30000

-- | Alternative displacements of a lower probability are not reported.
leastOther :: Double
leastOther = 0.001

-- | Independent pairs of values that one pixel is worth in a correlation, because neighbouring
-- pixels of relief resemble each other. Measured: of the pairs given at 99 %, at least 99 % are
-- right (@bench/peers/stitching.py@).
independent :: Double
independent = 0.4

-- | Share of an overlap's log-likelihood that counts, because coefficients are not quite
-- independent. Measured: of the pairs given at 99 %, 99 % are right (@bench/peers/stitching.py@).
tempering :: Double
tempering = 0.8

-- | Prior variance of g, the log ratio of two frames' gains. Assumption: 40 %.
gainVariance :: Double
gainVariance = 0.16

-- | Share of a coefficient's relief that two frames have in common if they feel it differently.
-- Assumption. Without it overlaps of interpolated frames contradict each other (8 x 8 frames of
-- 3.175 mm).
alike :: Double
alike = 0.85

-- | Upper limit of the noise share fitted to frames. Rough relief looks like noise in each.
mostNoise :: Double
mostNoise = 5

-- | Interpolated pixels of two frames differ by this share of the relief's variance. Assumption.
interpolated :: Double
interpolated = 0.05

-- | Frequencies used along each side. It saves time.
highest :: Int
highest = 32

-- | At most this many frames determine the process. It saves time.
mostOfProcess :: Int
mostOfProcess = 64

-- | Patch weights are kept for frames of at most this many pixels. It saves memory.
keptPatches :: Int
keptPatches = 400

-- | Pairs that share less of a frame are not compared. Diagonal steps of half a frame leave 0.25.
leastOverlap :: Double
leastOverlap = 0.2

-- | Each frame chooses at most this many pairs: as many as it has at steps of half a frame.
mostPairs :: Int
mostPairs = 8

-- | At most this many sweeps of the mean field over pairs.
pairSweeps :: Int
pairSweeps = 10

-- | Displacements of a lower probability are left out of a frame's message to its partner. It saves
-- time.
heardOfPairs :: Double
heardOfPairs = 0.002

-- | Number of sweeps of the least squares that place frames between grid points.
mostSteps :: Int
mostSteps = 40

-- | Layouts of a lower log-likelihood ratio are dropped. It saves time.
refuted :: Double
refuted = -12

-- | Layouts whose quick log-likelihood ratio, by phases alone, is lower are not scored by F. It
-- saves time.
hopeless :: Double
hopeless = -30

-- | Upper limit of reported log-likelihood ratios, so that products stay finite.
mostLog :: Double
mostLog = 300

-- | From this log-likelihood ratio on, frames contradict their positions, whatever the array says.
-- Assumption.
decisive :: Double
decisive = 20

-- | Registration tries other scales if sigma (taxels) is larger. Assumption: robots err less.
largeError :: Double
largeError = 1.5

-- | At most this many scales are scored by F. It saves time.
mostScales :: Int
mostScales = 4

-- | At most this many frames are used to find scales. It saves time.
scaleFrames :: Int
scaleFrames = 32

-- | Least distance between the outermost frames at a scale, taxels: half a frame.
leastExtent :: Double
leastExtent = 8

-- | Greatest distance between the outermost frames at a scale, taxels: 16 cells.
greatestExtent :: Double
greatestExtent = 256

-- | At most this many frames score a layout by F. It saves time.
framesOfLayout :: Int
framesOfLayout = 256

-- | At most this many pairs score a layout. It saves time.
pairsOfLayout :: Int
pairsOfLayout = 16

-- | At most this many alternative places of single frames are reported.
mostElsewhere :: Int
mostElsewhere = 4

-- | Above this many frames, all count as one group. It saves time.
mostTied :: Int
mostTied = 256

-- | Prior of a slip of one group, relative to a slip of a row or column. Assumption.
groupShare :: Double
groupShare = 0.5

-- | Slips are tried beyond at most this many lines along each axis. It saves time.
mostLines :: Int
mostLines = 8

-- | Slips are tried of at most this many groups. It saves time.
mostGroups :: Int
mostGroups = 16

-- | Rows of frames less than this apart (taxels) are one row.
leastGap :: Double
leastGap = 2
