{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The mean field of "PraTactile.Registration.Model" over pairs of frames that overlap.
--
-- > q_f(d) ~ prior(d) * product over the pairs of f of (1 + sum over d' of q_g(d') exp L_fg(d' - d))
--
-- A shift common to all frames is free. The mean of m other frames tells it to sigma^2 / m, so that
-- squares are taken about that mean, and a frame's own by m / (m + 1).
--
-- Frames are placed one after the other: the first where the robot has it, for good; next the one
-- whose pairs with those placed have the highest L. Then each is found anew by all others.
module PraTactile.Registration.Field.Pairs
  ( Masses,
    pairwiseField,
    onPoints,
    likeliest,

    -- * Moments
    Moments (..),
    momentsOf,
    squaresAbout,
  )
where

import Control.Monad (forM_)
import Data.IntMap.Strict (IntMap)
import qualified Data.IntMap.Strict as IntMap
import qualified Data.IntSet as IntSet
import Data.List (foldl')
import Data.Maybe (fromMaybe)
import Data.Ord (Down (..))
import qualified Data.Set as Set
import qualified Data.Vector as Boxed
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import qualified Data.Vector.Storable.Mutable as M
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Registration.AllPairs.Pair
import PraTactile.Registration.Field
import PraTactile.Registration.Numbers (heardOfPairs, pairSweeps)

-- | The probabilities of a frame's displacements on the grid, row by row.
type Masses = Vector Double

-- | Displacements (taxels) of frames together: their number, the sums of what is expected of each
-- along both axes, and of its square.
data Moments = Moments !Double !Double !Double !Double

instance Semigroup Moments where
  Moments n x y s <> Moments n' x' y' s' = Moments (n + n') (x + x') (y + y') (s + s')

instance Monoid Moments where
  mempty = Moments 0 0 0 0

without :: Moments -> Moments -> Moments
without (Moments n x y s) (Moments n' x' y' s') = Moments (n - n') (x - x') (y - y') (s - s')

-- | The moments of a frame, given how far its nominal place lies beyond its grid point.
momentsOf :: Grid -> Taxels -> Masses -> Moments
momentsOf grid beyond = V.ifoldl' with (Moments 1 0 0 0)
  where
    with (Moments n x y s) i m =
      let (px, py) = fromNominal grid beyond i
       in Moments n (x + m * px) (y + m * py) (s + m * (px * px + py * py))

-- | The displacement from the nominal place at that point of the grid.
fromNominal :: Grid -> Taxels -> Int -> Taxels
fromNominal grid (rx, ry) i = (fromIntegral x - rx, fromIntegral y - ry)
  where
    (x, y) = shiftAt grid i
{-# INLINE fromNominal #-}

-- | The displacement from the grid point nearest to the nominal place.
shiftAt :: Grid -> Int -> (Int, Int)
shiftAt grid i = let (y, x) = i `quotRem` (2 * reach + 1) in (x - reach, y - reach)
  where
    reach = gridReach grid
{-# INLINE shiftAt #-}

-- | Displacements on the grid with their probabilities, those of next to none left out.
onPoints :: Grid -> Masses -> [((Int, Int), Double)]
onPoints grid masses = [(shiftAt grid i, m) | (i, m) <- zip [0 ..] (V.toList masses), m > 1e-9]

-- | The squares of displacements about their mean, which is free.
squaresAbout :: Moments -> Squares
squaresAbout (Moments n x y s)
  | n < 1 = mempty
  | otherwise = Squares (n - 1) (max 0 (s - (x * x + y * y) / n))

-- | The log prior of a displacement from the nominal place, given the other frames.
priorLog :: Grid -> Moments -> Taxels -> Double
priorLog grid others@(Moments m sx sy _) = \(x, y) ->
  prior (counting * (squared (x - mx) + squared (y - my)))
  where
    prior = displacementLog grid (squaresAbout others)
    (mx, my) = if m > 0 then (sx / m, sy / m) else (0, 0)
    counting = if m > 0 then m / (m + 1) else 1
    squared t = t * t

-- | q of each frame, given how far each nominal place lies beyond its grid point, how far from each
-- other the frames of a pair are compared (taxels), and the pairs. Of frames that hang together the
-- first stays where the robot has it, since what is common to all cannot be seen.
pairwiseField :: Grid -> [Taxels] -> Int -> [Pair] -> [Masses]
pairwiseField grid rests wide pairs =
  IntMap.elems (settled pairSweeps (IntMap.map V.maxIndex) sweep IntMap.empty)
  where
    side = 2 * gridReach grid + 1
    -- By frame: the other one of a pair, and the sign of its own displacement in it.
    around =
      byFrame (length rests) $
        concat [[(k, (l, -1, pair)), (l, (k, 1, pair))] | pair@(Pair k l _ _) <- pairs]
    beyond = Boxed.fromList rests
    moments k = momentsOf grid (beyond Boxed.! k)
    sweep now = fst (foldl' update (now, IntMap.foldMapWithKey moments now) order)
    order = growing (length rests) pairs
    -- The first of those that hang together: no pair of its own has a frame before it.
    roots = fst (foldl' rooted (IntSet.empty, IntSet.empty) order)
    rooted (found, before) k =
      (if starts then IntSet.insert k found else found, IntSet.insert k before)
      where
        others = [g | (g, _, _) <- around Boxed.! k]
        starts = not (null others) && all (`IntSet.notMember` before) others
    update :: (IntMap Masses, Moments) -> Int -> (IntMap Masses, Moments)
    update (now, total) k = (IntMap.insert k field now, others <> moments k field)
      where
        old = IntMap.lookup k now
        others = maybe total (without total . moments k) old
        told =
          [ (sign, pair, there)
            | (g, sign, pair) <- around Boxed.! k,
              Just there <- [IntMap.lookup g now]
          ]
        field
          | k `IntSet.member` roots = fromMaybe (certainly (fieldBy mempty k [])) old
          | otherwise = fieldBy others k told
    certainly masses = V.imap (\i _ -> if i == V.maxIndex masses then 1 else 0) masses
    fieldBy others k told = V.map (/ V.sum masses) masses
      where
        masses = V.map (exp . subtract (V.maximum logs)) logs
        logs = foldl' (V.zipWith (+)) priors [heard sign pair there | (sign, pair, there) <- told]
        prior = priorLog grid others
        priors = V.generate (side * side) (prior . fromNominal grid (beyond Boxed.! k))
    -- The log of what a pair makes of each displacement of a frame, in the mean over those of the
    -- other one; improbable ones of these tell nothing.
    heard :: Int -> Pair -> Masses -> Vector Double
    heard sign (Pair _ _ most shares) there = V.map (\t -> most + log t) $
      V.create $ do
        here <- M.replicate (side * side) (max 1e-300 (exp (negate most)))
        forM_ [(i, m) | (i, m) <- zip [0 ..] (V.toList there), m > heardOfPairs] $ \(j, m) -> do
          let (jy, jx) = j `quotRem` side
              lastX = min (side - 1) (jx + wide)
              column !start !from !x
                | x > lastX = pure ()
                | otherwise = do
                  -- Note [Bounds of what is heard]
                  let share = V.unsafeIndex shares (from + sign * (x - jx))
                  M.unsafeModify here (+ m * realToFrac share) (start + x)
                  column start from (x + 1)
          forM_ [max 0 (jy - wide) .. min (side - 1) (jy + wide)] $ \y ->
            column (y * side) (centre + sign * (y - jy) * width) (max 0 (jx - wide))
        pure here
    width = 2 * wide + 1
    centre = wide * width + wide

-- | The order in which frames are placed: next the one that pairs with those placed tell most of,
-- of equals the one that all pairs do.
growing :: Int -> [Pair] -> [Int]
growing count pairs =
  go (IntMap.fromList (zip numbers (repeat 0))) (Set.fromList (map (rank 0) numbers))
  where
    numbers = [0 .. count - 1]
    around = byFrame count (concat [[(k, (l, told)), (l, (k, told))] | Pair k l told _ <- pairs])
    rank gained k = (Down (gained :: Double, sum (map snd (around Boxed.! k))), k)
    go gains waiting = case Set.minView waiting of
      Nothing -> []
      Just ((_, k), left) ->
        k : uncurry go (foldl' gain (IntMap.delete k gains, left) (around Boxed.! k))
    gain (gains, waiting) (l, told) = case IntMap.lookup l gains of
      Nothing -> (gains, waiting)
      Just gained ->
        ( IntMap.insert l (gained + told) gains,
          Set.insert (rank (gained + told) l) (Set.delete (rank gained l) waiting)
        )

{- Note [Bounds of what is heard] x and y are points of the field, no further than the pairs' reach
   from those of the other frame, so that their difference is one of the pair's displacements,
   whichever of its frames is meant. -}

-- | The likeliest displacement from the nominal place.
likeliest :: Grid -> Taxels -> Masses -> Taxels
likeliest grid beyond masses = fromNominal grid beyond (V.maxIndex masses)
