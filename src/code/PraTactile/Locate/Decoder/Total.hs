{-# LANGUAGE BangPatterns #-}

-- | The likelihoods of all positions of many grids, added up, where those of each one are not asked
-- for. Cells next to each other in a row are looked up together, by the number that their codes are
-- the digits of.
module PraTactile.Locate.Decoder.Total
  ( totalLikelihood,
  )
where

import Data.Bifunctor (first)
import Data.List (foldl', genericLength, sortOn)
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Ord (Down (..))
import Data.Vector.Primitive (Vector)
import qualified Data.Vector.Primitive as Primitive
import Data.Word (Word16)
import PraTactile.Grid

-- | The logarithm of the sum of likelihoods over these ways of seeing some cells, these grids, all
-- of one shape and alphabet, and all positions on the surface. A way has the cells by their
-- offsets, each with how likely every symbol makes what is seen there; the likelihood of a position
-- is the product over its cells. Likelihoods below 10^-308 of the largest that is conceivable count
-- as 0. O(m) for m cells for each term.
totalLikelihood :: Surface -> [Grid] -> [[(Position, Vector Double)]] -> Double
totalLikelihood surface grids ways = maybe (-1 / 0) total $ do
  grid <- listToMaybe grids
  let -- However far apart cells are, on a torus none is further than all around.
      around at = fromMaybe at (displaced surface (gridShape grid) (Position 0 0) at)
      near = map (map (first around)) ways
      plate = plateOf surface grid (extentOf (map fst (concat near)))
      seen = sortOn (Down . wayMost) (filter possible (map (wayOn plate) near))
  likeliest <- listToMaybe seen
  pure (plate, seen, wayMost likeliest)
  where
    possible way = places way > 0 && not (isInfinite (wayMost way))
    places = fromIntegral . area . wayPlaces :: Way -> Double
    total (plate, seen, unit) = unit + log (foldl' addGrid 0 grids)
      where
        addGrid sofar grid = foldl' (addWay (numbersOn plate grid)) sofar seen
        addWay numbers sofar way
          -- All its terms in all grids would not show.
          | most * genericLength grids * places way <= sofar * 2 ** (-53) = sofar
          | otherwise = sofar + most * overPlaces plate numbers way
          where
            most = exp (wayMost way - unit)

-- | How grids of one shape and alphabet are looked at.
data Plate = Plate
  { plateSurface :: !Surface,
    -- | the shape of a grid
    plateShape :: !Shape,
    -- | the size of the alphabet
    plateAlphabet :: !Int,
    -- | how many cells are looked up together
    plateRun :: !Int,
    plateColumns :: !Int,
    -- | its cells row by row, by those of a grid; 'Nothing' where it has the same
    plateCells :: !(Maybe (Vector Int))
  }

-- | A torus goes on beyond its edges as far as cells reach: so it is a sheet with as many
-- positions.
plateOf :: Surface -> Grid -> Shape -> Plate
plateOf surface grid extent = case surface of
  Sheet -> Plate surface shape q run (gridWidth grid) Nothing
  _ -> Plate surface shape q run (fromIntegral across) (Just (Primitive.fromList continued))
  where
    shape = gridShape grid
    q = gridAlphabet grid
    -- At most so many that a table of what they can be stays at hand.
    run = length (takeWhile (<= 1024) (iterate (* q) q))
    across = columns shape + columns extent - 1
    continued =
      [ fromIntegral (i * columns shape + j)
        | Position r c <- shapeCells (Shape (rows shape + rows extent - 1) across),
          Just (Position i j) <- [canonicalPosition surface shape (toInteger r) (toInteger c)]
      ]

-- | At each cell of the plate the number of the run that begins there, its first digit the least.
numbersOn :: Plate -> Grid -> Vector Word16
numbersOn plate grid = foldl' longer digits [2 .. plateRun plate]
  where
    q = fromIntegral (plateAlphabet plate)
    cells = maybe id (flip Primitive.backpermute) (plateCells plate) (gridCells grid)
    -- What follows the last cell counts as 0.
    !digits = Primitive.map fromIntegral cells <> Primitive.replicate (plateRun plate - 1) 0
    longer known _ =
      Primitive.generate (Primitive.length known - 1) $ \at ->
        Primitive.unsafeIndex digits at + q * Primitive.unsafeIndex known (at + 1)

-- | A way of seeing cells on a plate.
data Way = Way
  { -- | the logarithm of the largest likelihood that is conceivable
    wayMost :: !Double,
    -- | the positions
    wayPlaces :: !Shape,
    -- | runs, by how far from a position they begin, each with the likelihood of every number
    -- relative to the most
    wayRuns :: [(Int, Vector Double)]
  }

wayOn :: Plate -> [(Position, Vector Double)] -> Way
wayOn plate cells =
  Way
    { wayMost = sum (map (log . Primitive.maximum . snd) cells),
      wayPlaces = admissible (plateSurface plate) (plateShape plate) (extentOf (map fst cells)),
      wayRuns = runsOf (sortOn fst [(offset at, relative given) | (at, given) <- cells])
    }
  where
    q = plateAlphabet plate
    run = plateRun plate
    offset (Position i j) = fromIntegral i * plateColumns plate + fromIntegral j
    relative given = Primitive.map (/ Primitive.maximum given) given
    runsOf known = case known of
      [] -> []
      (from, _) : _ ->
        let (these, others) = span ((< from + run) . fst) known
         in (from, table [(q ^ (at - from), given) | (at, given) <- these]) : runsOf others
    table these =
      Primitive.generate (q ^ run) $ \number ->
        product [given Primitive.! (number `div` unit `mod` q) | (unit, given) <- these]

-- | The sum of the likelihoods of all positions, at least one, relative to the most.
overPlaces :: Plate -> Vector Word16 -> Way -> Double
overPlaces plate numbers way =
  sum [Primitive.sum (Primitive.slice (i * across) wide likely) | i <- [0 .. high - 1]]
  where
    across = plateColumns plate
    high = fromIntegral (rows (wayPlaces way))
    wide = fromIntegral (columns (wayPlaces way))
    -- From the first position to the last, whatever lies between.
    likely = times (wayRuns way) (Primitive.replicate ((high - 1) * across + wide) 1)
    -- Two runs at a time, so that products are read and written half as often. All runs of a
    -- position lie on the plate, and their numbers in their tables.
    times runs !known = case runs of
      [] -> known
      [(from, f)] -> Primitive.imap (\at x -> x * value f (from + at)) known
      (from, f) : (from', f') : others ->
        times others $
          Primitive.imap (\at x -> x * (value f (from + at) * value f' (from' + at))) known
    value f at = Primitive.unsafeIndex f (fromIntegral (Primitive.unsafeIndex numbers at))
