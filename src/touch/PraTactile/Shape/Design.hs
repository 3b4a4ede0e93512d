{-# LANGUAGE OverloadedStrings #-}

-- | The search that designed the shipped shapes, so that it can be run again. It visits every shape
-- that meets the constraints and leaves no alphabet of them out, so the separation it reaches is
-- the greatest there is, not merely the best found.
--
-- With S the shapes that meet the constraints, one of each 'family', and D(a, b) the least
-- 'distance' of two under the eight symmetries (of a shape and itself: under the seven others), an
-- alphabet of q shapes at least d apart is a clique of q vertices in the graph of the a with D(a,
-- a) >= d, joined where D(a, b) >= d. d goes down from the greatest conceivable one until there is
-- a clique; that there is none is proved by exact search at every d above.
module PraTactile.Shape.Design
  ( -- * Designing
    Parameters (..),
    parametersFor,
    paperParameters,
    paperSeed,
    design,
    Report (..),
    Searched (..),
    designSteps,
    drawings,
    foreignShapes,

    -- * The steps
    admissible,
    family,
  )
where

import Data.Bits (popCount, setBit, shiftL, shiftR, testBit, (.&.), (.|.))
import Data.List (foldl', minimumBy, sortOn, unfoldr)
import Data.Maybe (mapMaybe)
import Data.Ord (comparing)
import qualified Data.Set as Set
import Data.Text (Text)
import qualified Data.Text as Text
import PraTactile.Random (uniform)
import PraTactile.Shape
import PraTactile.Shape.Clique
import PraTactile.Shape.Distance
import PraTactile.Steps
import System.Random (StdGen, mkStdGen)

-- | What the shapes must be like. They are drawn on a grid of 4 x 6 blocks of 2 x 2 taxels, so that
-- wherever the taxels of the sensor fall, every embossed block wholly covers at least one of them.
data Parameters = Parameters
  { -- | The names of the classes; as many shapes are sought.
    designNames :: [Text],
    -- | Every shape embosses at least this many of the 24 blocks,
    leastBlocks :: Int,
    -- | and at most this many, so that no class is much fainter than another.
    mostBlocks :: Int,
    -- | At least this many blocks are embossed along each of the four sides of the box, so that the
    -- box can be found from the image.
    leastContact :: Int
  }
  deriving stock (Eq, Show)

-- | The parameters of the shipped shapes for GF(4): 0, 1, A, A^2.
paperParameters :: Parameters
paperParameters = parametersFor ["0", "1", "A", "A^2"]

-- | The parameters of all shipped shapes, for classes of these names: 12 to 14 blocks; 2 blocks on
-- each side.
parametersFor :: [Text] -> Parameters
parametersFor names =
  Parameters
    { designNames = names,
      leastBlocks = 12,
      mostBlocks = 14,
      leastContact = 2
    }

-- | The seed of the shipped shapes.
paperSeed :: Int
paperSeed = 2004

-- | What the search visited and found.
data Report = Report
  { -- | The seed it was given.
    reportSeed :: Int,
    -- | How many shapes meet the constraints.
    reportAdmissible :: Int,
    -- | How many of them are different up to a half turn and mirrors.
    reportFamilies :: Int,
    -- | The separation of the alphabet, and the greatest that an alphabet of such shapes can have.
    reportSeparation :: Int,
    -- | How many alphabets have it, up to the order of the classes and to half turns and mirrors of
    -- each shape; 'Nothing' where they were not all listed, of more than 'mostListed' shapes.
    reportAlphabets :: Maybe Int
  }
  deriving stock (Eq, Show)

-- | The most shapes of which all alphabets with the greatest separation are listed.
mostListed :: Int
mostListed = 4

-- | Designs an alphabet with the greatest separation: of up to 'mostListed' shapes, the one whose
-- shapes are least like ordinary features; of more, of which there are too many to list, the first
-- that is found from the seed. Neither number changes when a shape is turned by 180 degrees or
-- mirrored, nor when classes are exchanged: these the seed chooses. Refuses ('NoAlphabet')
-- parameters that no alphabet meets. The paper's takes some seconds, nine shapes some minutes;
-- where there is no alphabet of many shapes at great distances, to prove that may take very long.
design :: Int -> Parameters -> Either ShapeError (Alphabet, Report)
design seed parameters = result (designSteps seed parameters)

-- | What a step of the search did.
data Searched
  = -- | measured the shapes among so many of the 'drawings'
    Measured !Int
  | -- | began to look for an alphabet at least so many taxels apart
    Trying !Int
  deriving stock (Eq, Show)

-- | The steps of 'design', to look on at.
designSteps :: Int -> Parameters -> Steps Searched (Either ShapeError (Alphabet, Report))
designSteps seed parameters = foldr measure (try (symbolWidth * symbolHeight)) measured
  where
    measured = [(i, candidate b) | (i, b) <- numberedShapes parameters]
    candidate b =
      if Set.lookupMin (family b) == Just b
        then Just (Candidate b (selfDistance b) (prepared b) (fst (greatestLikeness b)))
        else Nothing
    candidates = mapMaybe snd measured
    measure (i, shape) rest = maybe 0 candidateSelf shape `seq` Step (Measured i) rest
    count = length (designNames parameters)
    try d
      | d < 1 = Done (Left NoAlphabet)
      | otherwise =
        Step (Trying d) $ case alphabetsApart d [c | c <- candidates, candidateSelf c >= d] of
          (_, []) -> try (d - 1)
          (listed, found) -> Done (chosen d listed (minimumBy (comparing featureLikeness) found))
    chosen d listed best = do
      a <- alphabet (zip (designNames parameters) (arranged seed (map candidateShape best)))
      Right (a, Report seed (length measured) (length candidates) d listed)
    -- How many there are, where that is known, and those that are chosen from.
    alphabetsApart d apart
      | count <= mostListed = let found = cliques count far apart in (Just (length found), found)
      | otherwise = (Nothing, maybe [] pure (clique count far (shuffled seed apart)))
      where
        far a b = farApart d (candidatePrepared a) (candidatePrepared b)
    featureLikeness = maximum . (0 :) . map candidateLikeness

-- | A shape that may be one of an alphabet; what is costly to know of it is made when it is first
-- asked for.
data Candidate = Candidate
  { candidateShape :: Bitmap,
    candidateSelf :: Int,
    candidatePrepared :: Prepared,
    -- | the greatest to an ordinary feature
    candidateLikeness :: Double
  }

-- | A shape, its half turn and its two mirror images.
family :: Bitmap -> Set.Set Bitmap
family b = Set.fromList [b, halfTurned b, mirroredColumns b, mirroredRows b]

-- | Shapes by the rules of the shipped ones that are none of an alphabet's: from a seed, at least
-- so many taxels from each of its shapes, whichever way they are turned or mirrored; and so many of
-- them. Refuses ('NoAlphabet') where there are not as many. Some seconds.
foreignShapes :: Int -> Int -> Int -> Alphabet -> Either ShapeError Alphabet
foreignShapes seed least count known
  | length found < count = Left NoAlphabet
  | otherwise = alphabet (zip (map (Text.pack . show) [1 .. count]) found)
  where
    found = take count (filter foreign' (shuffled seed (admissible (parametersFor []))))
    foreign' b = all (farApart least (prepared b)) ours
    ours = map prepared (shapes known)

-- | A list in a random order.
shuffled :: Int -> [a] -> [a]
shuffled seed list = map snd (sortOn fst (zip (unfoldr (Just . uniform) (mkStdGen seed)) list))

-- | The shapes in a random order, each replaced by a random member of its family.
arranged :: Int -> [Bitmap] -> [Bitmap]
arranged seed = go (mkStdGen seed)
  where
    go :: StdGen -> [Bitmap] -> [Bitmap]
    go g rest = case splitAt i rest of
      (before, b : after) -> case drop j (Set.toAscList (family b)) of
        chosen : _ -> chosen : go g'' (before ++ after)
        [] -> b : go g'' (before ++ after)
      (_, []) -> []
      where
        (i, g') = below (length rest) g
        (j, g'') = below 4 g'
    below n g = let (u, g') = uniform g in (floor (u * fromIntegral (n :: Int)) :: Int, g')

-- | All shapes that meet the constraints: of the 2^24 drawings on the grid those that emboss an
-- allowed number of blocks, touch every side enough, hang together by whole sides of blocks, have
-- no two blocks that meet at a corner only (neither embossed nor flat: such a contact comes and
-- goes with the phase of the taxels), and enclose nothing.
admissible :: Parameters -> [Bitmap]
admissible = map snd . numberedShapes

-- | The same, each with its number among all stacks of rows, from 1.
numberedShapes :: Parameters -> [(Int, Bitmap)]
numberedShapes parameters =
  [ (i, fromBlocks raised)
    | (i, raised) <- zip [1 ..] (map stacked (stacks gridHeight)),
      popCount raised >= leastBlocks parameters && popCount raised <= mostBlocks parameters,
      all (\side -> popCount (raised .&. side) >= leastContact parameters) sides,
      flooded raised (raised .&. negate raised) == raised,
      let flat = wholeGrid - raised,
      flooded flat (flat .&. foldr (.|.) 0 sides) == flat
  ]
  where
    stacked = foldl' (\below row -> shiftL below gridWidth + row) 0

-- | All stacks of this many rows of blocks in which each row shares a block with the next (or
-- the shape would fall apart) and no two blocks meet at a corner only.
stacks :: Int -> [[Int]]
stacks 1 = map pure rowsOfBlocks
stacks n =
  [row : rest | n > 1, rest@(next : _) <- stacks (n - 1), row <- rowsOfBlocks, mayLieOn row next]

-- | Whether a row may lie on a row.
mayLieOn :: Int -> Int -> Bool
mayLieOn row next = row .&. next /= 0 && not (or [cornersOnly x | x <- [0 .. gridWidth - 2]])
  where
    cornersOnly x =
      testBit row x /= testBit row (x + 1)
        && testBit next x /= testBit next (x + 1)
        && testBit row x /= testBit next x

-- | How many drawings the search goes through: stacks of @gridHeight@ rows, counted by their
-- uppermost row without making them.
drawings :: Int
drawings = sum (map snd (iterate upwards [(row, 1) | row <- rowsOfBlocks] `at` (gridHeight - 1)))
  where
    upwards counts = [(row, sum [n | (next, n) <- counts, mayLieOn row next]) | row <- rowsOfBlocks]
    at list n = concat (take 1 (drop n list))

-- | Every row with a block in it; bit x is the block of column x.
rowsOfBlocks :: [Int]
rowsOfBlocks = [1 .. 2 ^ gridWidth - 1]

-- | The grid: 4 blocks wide, 6 tall, a block 2 taxels. A set of its blocks is a number whose bit 4
-- y + x is the block of column x, row y.
gridWidth, gridHeight, blockSide :: Int
gridWidth = 4
gridHeight = 6
blockSide = 2

blocksWhere :: (Int -> Int -> Bool) -> Int
blocksWhere included =
  foldl'
    setBit
    0
    [y * gridWidth + x | y <- [0 .. gridHeight - 1], x <- [0 .. gridWidth - 1], included x y]

wholeGrid :: Int
wholeGrid = blocksWhere (\_ _ -> True)

-- | The blocks along the left, the right, the upper and the lower side.
sides :: [Int]
sides =
  [westSide, eastSide, blocksWhere (\_ y -> y == 0), blocksWhere (\_ y -> y == gridHeight - 1)]

westSide, eastSide :: Int
westSide = blocksWhere (\x _ -> x == 0)
eastSide = blocksWhere (\x _ -> x == gridWidth - 1)

-- | The blocks of the first set that are reached from the second through sides of blocks.
flooded :: Int -> Int -> Int
flooded allowed reached
  | next == reached = reached
  | otherwise = flooded allowed next
  where
    next =
      allowed
        .&. ( reached
                .|. shiftL (reached .&. notAt eastSide) 1
                .|. shiftR (reached .&. notAt westSide) 1
                .|. shiftL reached gridWidth
                .|. shiftR reached gridWidth
            )
    notAt side = wholeGrid - side

-- | The shape that embosses these blocks.
fromBlocks :: Int -> Bitmap
fromBlocks blocks =
  bitmapWhere (\x y -> testBit blocks ((y `div` blockSide) * gridWidth + x `div` blockSide))
