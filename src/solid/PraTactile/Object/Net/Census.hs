-- | All unfoldings of a solid, counted.
module PraTactile.Object.Net.Census
  ( mostTrees,
    Census (..),
    census,
    congruent,
  )
where

import Data.List (foldl', sortOn)
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import Numeric.Natural (Natural)
import PraTactile.Object.Net.Meeting
import PraTactile.Object.Net.Outline
import PraTactile.Object.Net.Search
import PraTactile.Object.Net.Unfolder
import PraTactile.Object.Net.Unfolding
import PraTactile.Object.WingedEdge

-- | Of more unfoldings than this a 'census' takes long.
mostTrees :: Natural
mostTrees = 10 ^ (5 :: Int)

-- | All unfoldings of a solid, counted.
data Census = Census
  { -- | how many there are
    censusTrees :: !Natural,
    -- | how many have two faces with an inner point in common
    censusOverlapping :: !Natural,
    -- | how many of the others might overlap by less than 10^-30 mm, and are taken to touch
    censusUndecided :: !Natural,
    -- | one of each kind of those that do not overlap, where those are of a kind whose outlines are
    -- congruent, the one turned over or not
    censusNets :: [Unfolding],
    -- | how many kinds there are where none may be turned over
    censusUpToRotation :: !Natural
  }

-- | All unfoldings of a solid, one by one, in the time and for the memory that takes.
census :: Solid -> Census
census whole =
  Census
    { censusTrees = spanningTrees whole,
      censusOverlapping = spanningTrees whole - tried,
      censusUndecided = open,
      censusNets = map snd (sortOn fst (Map.elems kinds)),
      censusUpToRotation = fromIntegral (Set.size rotated)
    }
  where
    it = unfolder whole
    words' = outliner it
    Tally tried open _ rotated kinds =
      foldl' count (Tally 0 0 (sideLengths words') Set.empty Map.empty) (netsOf it)
    count (Tally n m lengths seen known) (tree, meeting) =
      Tally
        (n + 1)
        (if meeting == Open then m + 1 else m)
        lengths'
        (Set.insert one seen)
        (if Map.member least known then known else Map.insert least (n, tree) known)
      where
        (lengths', rim) = outline words' lengths (gluedSides it tree)
        one = fromLeast rim
        least = min one (fromLeast (turnedOver rim))

data Tally
  = Tally
      !Natural
      !Natural
      !Lengths
      !(Set.Set Outline)
      !(Map.Map Outline (Natural, Unfolding))

-- | Whether the outlines of two unfoldings of a solid are congruent, in that order: as they lie,
-- and where one may be turned over.
congruent :: Solid -> Unfolding -> Unfolding -> (Bool, Bool)
congruent whole a b = (one == other, one == other || one == fromLeast (turnedOver rim'))
  where
    it = unfolder whole
    words' = outliner it
    (lengths, rim) = outline words' (sideLengths words') (gluedSides it a)
    (_, rim') = outline words' lengths (gluedSides it b)
    (one, other) = (fromLeast rim, fromLeast rim')
