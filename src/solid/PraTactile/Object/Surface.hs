-- | The sides of a polyhedron's faces, and which of them belong to one edge: the half-edge form of
-- a winged-edge model (section II.B of the paper; Ballard and Brown, Computer Vision, ch. 9).
module PraTactile.Object.Surface
  ( FaceSides,
    surface,

    -- * Sides
    sideCount,
    sideStart,
    sideEnd,
    sideFace,
    sidesOfFace,
    nextSide,
    previousSide,
    placeOnWalk,

    -- * Edges
    edgeCount,
    edgeSides,
    mateOf,

    -- * Classes
    classes,
  )
where

import Control.Monad (forM_, when)
import Control.Monad.ST (ST, runST)
import Data.Bits (shiftL, (.|.))
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as M
import PraTactile.Object.Boxes (sortedPairs)
import PraTactile.Object.Mesh (Walk)

-- | All sides of some walks, in order.
data FaceSides = FaceSides
  { starts :: !(U.Vector Int),
    faces :: !(U.Vector Int),
    -- | the index of the first side of each face, then the number of sides
    offsets :: !(U.Vector Int),
    -- | the sides sorted by edge
    grouped :: !(U.Vector Int),
    -- | the index in 'grouped' of the first side of each edge, then the number of sides
    groups :: !(U.Vector Int),
    mates :: !(U.Vector Int)
  }

-- | The sides of these walks. O(n log n).
surface :: V.Vector Walk -> FaceSides
surface walks =
  FaceSides
    { starts = begun,
      faces =
        U.concat (V.toList (V.imap (\f walk -> U.replicate (U.length walk) f) walks)),
      offsets = from,
      grouped = sides,
      groups = bounds,
      mates =
        U.replicate (U.length begun) (-1)
          U.// concat
            [ [(s, t), (t, s)]
              | (i, j) <- zip (U.toList bounds) (drop 1 (U.toList bounds)),
                j - i == 2,
                let s = sides U.! i
                    t = sides U.! (i + 1)
            ]
    }
  where
    begun = U.concat (V.toList walks)
    from = U.fromList (scanl (+) 0 (map U.length (V.toList walks)))
    ends = U.concat (V.toList (V.map (\walk -> U.drop 1 walk U.++ U.take 1 walk) walks))
    keyed = sortedPairs (U.imap (\s a -> (key a (ends U.! s), s)) begun)
    key a b = (min a b `shiftL` 32) .|. max a b
    sides = U.map snd keyed
    bounds =
      U.filter (\i -> i == 0 || i == total || fst (keyed U.! i) /= fst (keyed U.! (i - 1))) places
    places = if total == 0 then U.singleton 0 else U.enumFromN 0 (total + 1)
    total = U.length begun

-- | The number of sides.
sideCount :: FaceSides -> Int
sideCount = U.length . starts

-- | The vertex at which a side begins on its walk.
sideStart :: FaceSides -> Int -> Int
sideStart it s = starts it U.! s

-- | The vertex at which a side ends.
sideEnd :: FaceSides -> Int -> Int
sideEnd it = sideStart it . nextSide it

-- | The walk to which a side belongs.
sideFace :: FaceSides -> Int -> Int
sideFace it s = faces it U.! s

-- | The sides of a walk, in their order.
sidesOfFace :: FaceSides -> Int -> [Int]
sidesOfFace it f = [offsets it U.! f .. offsets it U.! (f + 1) - 1]

-- | The side after this one, on the same walk.
nextSide :: FaceSides -> Int -> Int
nextSide it s = if s + 1 == offsets it U.! (f + 1) then offsets it U.! f else s + 1
  where
    f = sideFace it s

-- | The side before this one, on the same walk.
previousSide :: FaceSides -> Int -> Int
previousSide it s = if s == offsets it U.! f then offsets it U.! (f + 1) - 1 else s - 1
  where
    f = sideFace it s

-- | The index of a side's start on its walk, from 0.
placeOnWalk :: FaceSides -> Int -> Int
placeOnWalk it s = s - offsets it U.! sideFace it s

-- | The number of edges.
edgeCount :: FaceSides -> Int
edgeCount it = U.length (groups it) - 1

-- | The sides of an edge, ascending.
edgeSides :: FaceSides -> Int -> [Int]
edgeSides it e = [grouped it U.! i | i <- [groups it U.! e .. groups it U.! (e + 1) - 1]]

-- | The other side of the edge; 'Nothing' unless the edge has two sides.
mateOf :: FaceSides -> Int -> Maybe Int
mateOf it s = if mate < 0 then Nothing else Just mate
  where
    mate = mates it U.! s

-- | For each of this number of elements, the first element that is connected to it by pairs
-- (disjoint sets; Tarjan 1975).
classes :: Int -> [(Int, Int)] -> U.Vector Int
classes count pairs = runST $ do
  parents <- U.thaw (U.enumFromN 0 count)
  forM_ pairs $ \(a, b) -> do
    a' <- root parents a
    b' <- root parents b
    when (a' /= b') (M.write parents (max a' b') (min a' b'))
  forM_ [0 .. count - 1] (root parents)
  U.unsafeFreeze parents
  where
    root :: M.MVector s Int -> Int -> ST s Int
    root parents a = do
      parent <- M.read parents a
      if parent == a
        then pure a
        else do
          top <- root parents parent
          M.write parents a top
          pure top
