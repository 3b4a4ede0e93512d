{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The mean field of "PraTactile.Registration.Model" over pairs of frames that overlap.
--
-- > q_f(d) ~ prior(d) * product over pairs of f of (1 + sum over d' of q_g(d') exp L_fg(d' - d))
--
-- A shift common to all frames is free, so squares are taken about the mean of the other frames.
-- The mean of m frames is known to a variance of sigma^2 / m. A frame's own square therefore counts
-- m / (m + 1) times.
--
-- Frames are placed one after the other. The first stays at its nominal place for good. Next comes
-- the frame whose pairs with those placed have the highest L. Then all others update each frame.
module PraTactile.Registration.Field.Pairs
  ( Masses,
    pairwiseField,
    onPoints,
    likeliest,

    -- * Moments
    ShiftMoments (..),
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

-- | Sums over frames: their number, the expected displacements along both axes (taxels), and the
-- expected squares.
data ShiftMoments = ShiftMoments !Double !Double !Double !Double

instance Semigroup ShiftMoments where
  ShiftMoments n x y s <> ShiftMoments n' x' y' s' =
    ShiftMoments
      (n + n')
      (x + x')
      (y + y')
      (s + s')

instance Monoid ShiftMoments where
  mempty = ShiftMoments 0 0 0 0

without :: ShiftMoments -> ShiftMoments -> ShiftMoments
without (ShiftMoments n x y s) (ShiftMoments n' x' y' s') =
  ShiftMoments (n - n') (x - x') (y - y') (s - s')

-- | The moments of a frame, given its nominal place's offset from the grid point.
momentsOf :: Grid -> Taxels -> Masses -> ShiftMoments
momentsOf grid beyond = V.ifoldl' with (ShiftMoments 1 0 0 0)
  where
    with (ShiftMoments n x y s) i m =
      let (px, py) = fromNominal grid beyond i
       in ShiftMoments n (x + m * px) (y + m * py) (s + m * (px * px + py * py))

-- | The displacement from the nominal place, by index on the grid.
fromNominal :: Grid -> Taxels -> Int -> Taxels
fromNominal grid (rx, ry) i = (fromIntegral x - rx, fromIntegral y - ry)
  where
    (x, y) = shiftAt grid i
{-# INLINE fromNominal #-}

-- | The displacement from the grid point nearest to the nominal place, by index on the grid.
shiftAt :: Grid -> Int -> (Int, Int)
shiftAt grid i = let (y, x) = i `quotRem` (2 * reach + 1) in (x - reach, y - reach)
  where
    reach = gridReach grid
{-# INLINE shiftAt #-}

-- | Displacements on the grid with their probabilities, without those below 1e-9.
onPoints :: Grid -> Masses -> [((Int, Int), Double)]
onPoints grid masses = [(shiftAt grid i, m) | (i, m) <- zip [0 ..] (V.toList masses), m > 1e-9]

-- | The statistics of sigma, with squares about the mean, which is free.
squaresAbout :: ShiftMoments -> Squares
squaresAbout (ShiftMoments n x y s)
  | n < 1 = mempty
  | otherwise = Squares (n - 1) (max 0 (s - (x * x + y * y) / n))

-- | The log prior of a displacement from the nominal place, given the other frames' moments.
priorLog :: Grid -> ShiftMoments -> Taxels -> Double
priorLog grid others@(ShiftMoments m sx sy _) = \(x, y) ->
  prior (counting * (squared (x - mx) + squared (y - my)))
  where
    prior = displacementLog grid (squaresAbout others)
    (mx, my) = if m > 0 then (sx / m, sy / m) else (0, 0)
    counting = if m > 0 then m / (m + 1) else 1
    squared t = t * t

-- | q of each frame. Given are each nominal place's offset from its grid point, the reach of the
-- pairs' displacements (taxels), and the pairs. In each connected group the first frame stays at
-- its nominal place, since a common shift is unobservable.
pairwiseField :: Grid -> [Taxels] -> Int -> [Pair] -> [Masses]
pairwiseField grid rests wide pairs =
  IntMap.elems (settled pairSweeps (IntMap.map V.maxIndex) sweep IntMap.empty)
  where
    side = 2 * gridReach grid + 1
    -- By frame: the partner, the sign of its own displacement in the pair, and the pair.
    around =
      byFrame (length rests) $
        concat [[(k, (l, -1, pair)), (l, (k, 1, pair))] | pair@(Pair k l _ _) <- pairs]
    beyond = Boxed.fromList rests
    moments k = momentsOf grid (beyond Boxed.! k)
    sweep now = fst (foldl' update (now, IntMap.foldMapWithKey moments now) order)
    order = growing (length rests) pairs
    -- The first frames of connected groups: they come before all their partners.
    roots = fst (foldl' rooted (IntSet.empty, IntSet.empty) order)
    rooted (found, before) k =
      (if starts then IntSet.insert k found else found, IntSet.insert k before)
      where
        others = [g | (g, _, _) <- around Boxed.! k]
        starts = not (null others) && all (`IntSet.notMember` before) others
    update :: (IntMap Masses, ShiftMoments) -> Int -> (IntMap Masses, ShiftMoments)
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
    -- The log message of a pair to each displacement of a frame: the mean over its partner's
    -- displacements, without improbable ones.
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

-- | The order in which frames are placed, given their number. Next is the frame with the highest
-- sum of L to those placed; ties go to the highest sum over all its pairs.
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

{- Note [Bounds of what is heard] x and y are points of the field within the pairs' reach of the
   other frame's point. Their difference is therefore one of the pair's displacements, for either of
   its frames. -}

-- | The likeliest displacement from the nominal place.
likeliest :: Grid -> Taxels -> Masses -> Taxels
likeliest grid beyond masses = fromNominal grid beyond (V.maxIndex masses)
