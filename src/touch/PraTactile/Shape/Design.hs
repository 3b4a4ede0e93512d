{-# LANGUAGE OverloadedStrings #-}

-- | The search that designed the shipped shapes. It visits every shape that meets the constraints
-- and leaves out no alphabet of them, so the separation that it reaches is the greatest there is.
--
-- Let S be the shapes that meet the constraints, one per 'family'. Let D(a, b) be the least
-- 'distance' of two shapes under the eight symmetries (of a shape and itself: under the seven
-- others). Consider the graph of the shapes a with D(a, a) >= d, where a and b are joined if D(a,
-- b) >= d. An alphabet of q shapes at least d apart is a clique of q vertices in it. d decreases
-- from the greatest conceivable value until there is a clique. For every greater d an exact search
-- proves that there is none.
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

-- | The constraints on the shapes. Shapes are drawn on a grid of 4 x 6 blocks of 2 x 2 taxels, so
-- that wherever the sensor's taxels fall, every embossed block wholly covers at least one.
data Parameters = Parameters
  { -- | The names of the classes. The number of shapes is the number of names.
    designNames :: [Text],
    -- | The least number of embossed blocks of a shape, of 24.
    leastBlocks :: Int,
    -- | The greatest number of embossed blocks, so that no class is much fainter than another.
    mostBlocks :: Int,
    -- | The least number of embossed blocks along each of the four sides of the box, so that the
    -- box can be found from the image.
    leastContact :: Int
  }
  deriving stock (Eq, Show)

-- | The parameters of the shipped shapes for GF(4): 0, 1, A, A^2.
paperParameters :: Parameters
paperParameters = parametersFor ["0", "1", "A", "A^2"]

-- | The parameters of the shipped shapes, with the given class names: 12 to 14 blocks, 2 blocks on
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

-- | The results of a search.
data Report = Report
  { -- | The seed of the search.
    reportSeed :: Int,
    -- | The number of shapes that meet the constraints.
    reportAdmissible :: Int,
    -- | The number of these that differ by more than a half turn and mirrors.
    reportFamilies :: Int,
    -- | The separation of the alphabet, which is the greatest possible.
    reportSeparation :: Int,
    -- | The number of alphabets with this separation, up to the order of the classes and to half
    -- turns and mirrors of each shape; 'Nothing' if they were not all listed, for more than
    -- 'mostListed' shapes.
    reportAlphabets :: Maybe Int
  }
  deriving stock (Eq, Show)

-- | The greatest number of shapes for which all alphabets with the greatest separation are listed.
mostListed :: Int
mostListed = 4

-- | Designs an alphabet with the greatest separation, from a seed. For up to 'mostListed' shapes,
-- it is the one whose shapes are least like ordinary features. More shapes have too many alphabets
-- to list, so it is the first one found. Neither criterion changes when a shape is turned by 180
-- degrees or mirrored, or when classes are exchanged; the seed decides these. Refuses
-- ('NoAlphabet') parameters that no alphabet meets. The paper's alphabet takes some seconds, nine
-- shapes some minutes. A proof that many shapes cannot be far apart may take very long.
design :: Int -> Parameters -> Either ShapeError (Alphabet, Report)
design seed parameters = result (designSteps seed parameters)

-- | The result of one step of the search.
data Searched
  = -- | measured the shapes among this many of the 'drawings'
    Measured !Int
  | -- | began to search for an alphabet at least this many taxels apart
    Trying !Int
  deriving stock (Eq, Show)

-- | 'design' as steps that can be observed.
designSteps :: Int -> Parameters -> Steps Searched (Either ShapeError (Alphabet, Report))
designSteps seed parameters = foldr measure (try (symbolWidth * symbolHeight)) measured
  where
    measured = [(i, candidate b) | (i, b) <- numberedShapes parameters]
    candidate b =
      if Set.lookupMin (family b) == Just b
        then Just (ShapeCandidate b (selfDistance b) (prepared b) (fst (greatestLikeness b)))
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
    -- The number of alphabets, where it is known, and the alphabets to choose from.
    alphabetsApart d apart
      | count <= mostListed = let found = cliques count far apart in (Just (length found), found)
      | otherwise = (Nothing, maybe [] pure (clique count far (shuffled seed apart)))
      where
        far a b = farApart d (candidatePrepared a) (candidatePrepared b)
    featureLikeness = maximum . (0 :) . map candidateLikeness

-- | A candidate shape. Costly fields are computed on first use.
data ShapeCandidate = ShapeCandidate
  { candidateShape :: Bitmap,
    candidateSelf :: Int,
    candidatePrepared :: Prepared,
    -- | the greatest likeness to an ordinary feature
    candidateLikeness :: Double
  }

-- | A shape, its half turn and its two mirror images.
family :: Bitmap -> Set.Set Bitmap
family b = Set.fromList [b, halfTurned b, mirroredColumns b, mirroredRows b]

-- | Shapes by the shipped rules that do not belong to an alphabet. The arguments are the seed, the
-- least distance in taxels from each of the alphabet's shapes under every symmetry, the number of
-- shapes, and the alphabet. Refuses ('NoAlphabet') if there are not enough. Takes some seconds.
foreignShapes :: Int -> Int -> Int -> Alphabet -> Either ShapeError Alphabet
foreignShapes seed least count known
  | length found < count = Left NoAlphabet
  | otherwise = alphabet (zip (map (Text.pack . show) [1 .. count]) found)
  where
    found = take count (filter foreign' (shuffled seed (admissible (parametersFor []))))
    foreign' b = all (farApart least (prepared b)) ours
    ours = map prepared (shapes known)

-- | A list in random order, from a seed.
shuffled :: Int -> [a] -> [a]
shuffled seed list = map snd (sortOn fst (zip (unfoldr (Just . uniform) (mkStdGen seed)) list))

-- | The shapes in random order, from a seed, each replaced by a random member of its family.
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

-- | All shapes that meet the constraints, of the 2^24 drawings on the grid. They emboss an allowed
-- number of blocks, touch every side enough, are connected by sides of blocks, and enclose nothing.
-- No two blocks, embossed or flat, meet only at a corner: such a contact comes and goes with the
-- phase of the taxels.
admissible :: Parameters -> [Bitmap]
admissible = map snd . numberedShapes

-- | The shapes of 'admissible', each with its number among all stacks of rows, from 1.
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

-- | All stacks of the given number of rows in which each row shares a block with the next
-- (otherwise the shape would fall apart) and no two blocks meet only at a corner.
stacks :: Int -> [[Int]]
stacks 1 = map pure rowsOfBlocks
stacks n =
  [row : rest | n > 1, rest@(next : _) <- stacks (n - 1), row <- rowsOfBlocks, mayLieOn row next]

-- | Whether a row may lie on another.
mayLieOn :: Int -> Int -> Bool
mayLieOn row next = row .&. next /= 0 && not (or [cornersOnly x | x <- [0 .. gridWidth - 2]])
  where
    cornersOnly x =
      testBit row x /= testBit row (x + 1)
        && testBit next x /= testBit next (x + 1)
        && testBit row x /= testBit next x

-- | The number of drawings that the search visits: stacks of @gridHeight@ rows, counted by their
-- topmost row without generating them.
drawings :: Int
drawings = sum (map snd (iterate upwards [(row, 1) | row <- rowsOfBlocks] `at` (gridHeight - 1)))
  where
    upwards counts = [(row, sum [n | (next, n) <- counts, mayLieOn row next]) | row <- rowsOfBlocks]
    at list n = concat (take 1 (drop n list))

-- | Every row with a block in it; bit x is the block of column x.
rowsOfBlocks :: [Int]
rowsOfBlocks = [1 .. 2 ^ gridWidth - 1]

-- | The grid: 4 blocks wide, 6 tall, blocks of 2 x 2 taxels. A set of blocks is a number whose bit
-- 4 y + x is the block in column x, row y.
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

-- | The blocks of the first set that are connected to the second set through sides of blocks.
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

-- | The shape that embosses the given blocks.
fromBlocks :: Int -> Bitmap
fromBlocks blocks =
  bitmapWhere (\x y -> testBit blocks ((y `div` blockSide) * gridWidth + x `div` blockSide))
