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
    unlikeGain,
    unlikeOffset,

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

-- | The least gain that is found. Assumption: no frame is all noise.
leastGain :: Double
leastGain = 0.3

-- | The least noise variance that is found. Assumption: no frame is without any.
leastVariance :: Double
leastVariance = 2e-3

-- | The least share of a taxel that counts in a sum of squares. It saves time.
leastShare :: Double
leastShare = 0.01

-- | beta, taxels: the standard deviation of the blur of an elastic overlay and an element's
-- aperture. Assumption: half as much again, or half, changes little. The pose asks for edges,
-- which finite elements show sharper, and takes 0.3 ("PraTactile.Pose").
blurDeviation :: Double
blurDeviation = 0.75

-- | The variance of the logarithms of gains within one sensor's presses. Assumption: 30 %.
unlikeGain :: Double
unlikeGain = 0.09

-- | The variance of offsets, as shares of the gain, within one sensor's presses. Assumption: 5 %.
unlikeOffset :: Double
unlikeOffset = 0.0025

-- | The least t of a taxel that touches. Assumption.
leastTouch :: Double
leastTouch = 0.25

-- | What share of taxels counts where it is asked whether presses are tilted. Assumption: residual
-- relief is common to neighbouring taxels.
independentShare :: Double
independentShare = 0.2

-- | The most frames that are asked whether they are tilted. It saves time.
mostAsked :: Int
mostAsked = 12

-- | The steps of expectation and maximisation of a tilted press. It saves time.
pressSteps :: Int
pressSteps = 8

-- | epsilon, the probability that a cell is empty: beyond the face, or worn off. Assumption.
absence :: Double
absence = 0.01

-- | How finely phases and displacements are told apart. Half a taxel is a quarter of the blur's
-- width.
placesPerTaxel :: Int
placesPerTaxel = 2

-- | The least log posterior odds of the lattice against any other relief. 0.99 is the posterior
-- that users are told.
sure :: Double
sure = log 99

-- | The least noise share of any other relief where frames are asked for the lattice. Assumption:
-- symbols are not felt quite as they are drawn.
misfit :: Double
misfit = 0.1

-- | Hypotheses that are e^30 less likely do not count. It saves time.
negligible :: Double
negligible = 30

-- | The least probability of a phase or a symbol in a step of maximisation. It saves time.
leastWeight :: Double
leastWeight = 1e-6

-- | What share of a cell's log-likelihood counts where a symbol is told and where layouts are
-- weighed. Measured: as many symbols are wrong as are told to be (@bench/calibration.py@).
cellShare :: Double
cellShare = 0.05

-- | The most frames that the phase is found from. It saves time.
phaseFrames :: Int
phaseFrames = 64

-- | The most pixels of a frame, on average, whose log-likelihoods are kept. It saves memory.
keptPixels :: Int
keptPixels = 1024

-- | How finely sigma is told apart. A twelfth of an octave is 6 %.
sigmasPerOctave :: Int
sigmasPerOctave = 6

-- | How near to the truth a displacement counts as right, taxels along each axis. Definition.
tolerance :: Double
tolerance = 0.75

-- | delta, the probability that a frame shows something else in a cell, or in an overlap, than all
-- others do there. Assumption: it lies elsewhere, or has but the edge of a symbol, which was felt
-- otherwise than the relief supposes. If delta were 0 such a frame would go a whole cell away.
outlier :: Double
outlier = 1e-3

-- | Displacements and phases that are e^12 less likely by the frame alone are left out. It saves
-- time.
unlikely :: Double
unlikely = 12

-- | Displacements of a lower probability tell other frames nothing of the cells. It saves time.
heardOfCells :: Double
heardOfCells = 0.02

-- | The most sweeps of the mean field over cells. Most end after two.
mostSweeps :: Int
mostSweeps = 5

-- | The greatest displacement on the grid of pairs, taxels: three of the largest standard deviation
-- that an unknown position error has.
mostReach :: Int
mostReach = 12

-- | The most displacements and phases of two frames that are summed. It saves time.
mostCandidates :: Int
mostCandidates = 30000

-- | The least probability of another displacement that is told of a frame.
leastOther :: Double
leastOther = 0.001

-- | How many independent pairs of values a pixel counts for in a correlation: neighbouring pixels
-- of relief resemble each other. Measured: of pairs that are given at 99 % at least that much is
-- right (@bench/peers/stitching.py@).
independent :: Double
independent = 0.4

-- | What share of the log-likelihood of an overlap counts: coefficients are not quite independent.
-- Measured: of what is given at 99 % that much is right (@bench/peers/stitching.py@).
tempering :: Double
tempering = 0.8

-- | The variance of g, the logarithm of the ratio of two frames' gains. Assumption: 40 %.
gainVariance :: Double
gainVariance = 0.16

-- | The share of a coefficient's relief that frames have in common that feel it otherwise.
-- Assumption; without it overlaps of interpolated frames deny each other (8 x 8 frames of 3.175
-- mm).
alike :: Double
alike = 0.85

-- | The largest noise share that frames are found to have: rough relief looks like noise in each.
mostNoise :: Double
mostNoise = 5

-- | The share of relief's variance by which interpolated pixels of two frames differ. Assumption.
interpolated :: Double
interpolated = 0.05

-- | How many frequencies a side are looked at. It saves time.
highest :: Int
highest = 32

-- | The most frames that the process is found from. It saves time.
mostOfProcess :: Int
mostOfProcess = 64

-- | The most pixels of a frame for which the weights of its patches are kept. It saves memory.
keptPatches :: Int
keptPatches = 400

-- | The least share of a frame that a pair has in common: diagonal steps of half a frame leave
-- 0.25.
leastOverlap :: Double
leastOverlap = 0.2

-- | The most pairs that a frame chooses: as many as it has where steps are half a frame.
mostPairs :: Int
mostPairs = 8

-- | The most sweeps of the mean field over pairs.
pairSweeps :: Int
pairSweeps = 10

-- | Displacements of a lower probability tell the other frame of a pair nothing. It saves time.
heardOfPairs :: Double
heardOfPairs = 0.002

-- | How often least squares look at each frame.
mostSteps :: Int
mostSteps = 40

-- | A layout of a lower log-likelihood ratio is no hypothesis any more. It saves time.
refuted :: Double
refuted = -12

-- | Layouts of a lower log-likelihood ratio at a glance are not asked for F. It saves time.
hopeless :: Double
hopeless = -30

-- | The greatest log-likelihood ratio that is told, so that products are numbers.
mostLog :: Double
mostLog = 300

-- | The log-likelihood ratio from which on frames contradict their positions, whatever the array
-- says. Assumption.
decisive :: Double
decisive = 20

-- | sigma, taxels, from which on other scales are looked for. Assumption: robots are that exact.
largeError :: Double
largeError = 1.5

-- | The most scales that are asked for F. It saves time.
mostScales :: Int
mostScales = 4

-- | The most frames that are asked for a scale. It saves time.
scaleFrames :: Int
scaleFrames = 32

-- | The least distance of the outermost frames at a scale, taxels: half a frame.
leastExtent :: Double
leastExtent = 8

-- | The greatest distance of the outermost frames at a scale, taxels: 16 cells.
greatestExtent :: Double
greatestExtent = 256

-- | The most frames that are asked for F of a layout. It saves time.
framesOfLayout :: Int
framesOfLayout = 256

-- | The most pairs that are asked for the evidence of a layout. It saves time.
pairsOfLayout :: Int
pairsOfLayout = 16

-- | The most other places of single frames that are told.
mostElsewhere :: Int
mostElsewhere = 4

-- | The most frames of which groups are found that show the same symbols. It saves time.
mostTied :: Int
mostTied = 256

-- | Of slips, the prior of one group against that of a row or column. Assumption.
groupShare :: Double
groupShare = 0.5

-- | The most lines along an axis beyond which frames may have slipped. It saves time.
mostLines :: Int
mostLines = 8

-- | The most groups of which each may have slipped. It saves time.
mostGroups :: Int
mostGroups = 16

-- | How far apart two rows of frames are, taxels; nearer ones are one row.
leastGap :: Double
leastGap = 2
