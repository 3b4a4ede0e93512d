{-# OPTIONS_HADDOCK hide #-}

-- | Joins several patches of one face, at known displacements, for joint decoding. Their cells
-- together determine the position better than those of one patch. Patches that do not belong are
-- named.
module PraTactile.Locate.Joint
  ( -- * Joining
    Joint (..),
    joint,
    mostPatches,
    agreedSymbol,

    -- * What is said of each patch
    Belonging (..),
    patchVerdicts,
  )
where

import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import Numeric.Natural (Natural)
import PraTactile.Locate.Answer (Candidate, PatchVerdict (..))
import PraTactile.Locate.Definition (largestSearchedArray)
import PraTactile.Locate.Patch
import PraTactile.Position

-- | Patches joined in the rectangle around them.
data Joint a = Joint
  { -- | All cells in one patch, without disputed ones.
    jointPatch :: Patch a,
    -- | The cells in which patches contradict each other; they count as not observed.
    jointDisputed :: [Position],
    -- | The offset of each patch's upper left cell in the rectangle, in the given order.
    jointOffsets :: [Position],
    -- | The cells of each patch.
    jointParts :: [[(Position, a)]],
    -- | Combines several observations of a cell; 'Nothing' if they contradict each other.
    jointAgreed :: [a] -> Maybe a
  }

-- | Joins patches, each with the displacement of its upper left cell from a common point, in rows
-- down and columns to the right. The function combines several observations of a cell, and gives
-- 'Nothing' if they contradict each other. Refuses an empty list ('PatchEmpty'), more than
-- 'mostPatches' patches ('PatchesTooMany'), and several patches in a rectangle of more than
-- 'largestSearchedArray' cells ('PatchTooLarge').
joint :: ([a] -> Maybe a) -> [((Integer, Integer), Patch a)] -> Either LocateError (Joint a)
joint agreed given = case given of
  [] -> Left PatchEmpty
  [(_, single)] -> Right (Joint single [] [Position 0 0] [observedCells single] agreed)
  several
    | count > mostPatches -> Left (PatchesTooMany count mostPatches)
    | area shape > largestSearchedArray -> Left (PatchTooLarge (area shape) largestSearchedArray)
    | otherwise -> Right (Joint (inFrame agreed shape parts) disputed offsets parts agreed)
    where
      count = fromIntegral (length several)
      top = minimum [r | ((r, _), _) <- several]
      left = minimum [c | ((_, c), _) <- several]
      shape =
        Shape
          (side top [r + toInteger (rows (patchShape p)) | ((r, _), p) <- several])
          (side left [c + toInteger (columns (patchShape p)) | ((_, c), p) <- several])
      side from ends = fromInteger (maximum ends - from)
      offsets = [Position (fromInteger (r - top)) (fromInteger (c - left)) | ((r, c), _) <- several]
      parts =
        [ [(Position (r + i) (c + j), a) | (Position i j, a) <- observedCells p]
          | (Position r c, (_, p)) <- zip offsets several
        ]
      disputed = [at | (at, Nothing) <- Map.toList (looks agreed parts)]

-- | The most patches that are located jointly: 100. Each is left out in turn to find those that do
-- not belong, so the time grows with the square of their number.
mostPatches :: Natural
mostPatches = 100

-- | The combined observation of each cell.
looks :: ([a] -> Maybe a) -> [[(Position, a)]] -> Map Position (Maybe a)
looks agreed parts =
  agreed . reverse <$> Map.fromListWith (++) [(at, [a]) | part <- parts, (at, a) <- part]

-- | The cells of some patches as one patch of this shape, without disputed ones.
inFrame :: ([a] -> Maybe a) -> Shape -> [[(Position, a)]] -> Patch a
inFrame agreed shape parts = patchOf shape (Map.toAscList (Map.mapMaybe id (looks agreed parts)))

-- | The symbol, if all observations agree.
agreedSymbol :: Eq a => [a] -> Maybe a
agreedSymbol seen = case seen of
  a : others | all (== a) others -> Just a
  _ -> Nothing

-- | How to decide whether cells belong to the place of all patches.
data Belonging a = Belonging
  { -- | Whether a cell is wrong at a candidate.
    wrongAt :: Candidate -> (Position, a) -> Bool,
    -- | Whether a candidate is possible for these cells alone.
    belongsAt :: Candidate -> [(Position, a)] -> Bool,
    -- | The candidate at which a patch would be located with certainty.
    credible :: Patch a -> Maybe Candidate
  }

-- | The verdict on each patch, given the common place, if there is one.
patchVerdicts :: Belonging a -> Joint a -> Maybe Candidate -> [PatchVerdict]
patchVerdicts belonging joined place =
  [ PatchVerdict offset (wrongOf part <$ place) (i `elem` inconsistent)
    | (i, offset, part) <- zip3 [0 ..] (jointOffsets joined) parts
  ]
  where
    parts = jointParts joined
    indexed = zip [0 :: Int ..] parts
    wrong = case place of
      Just candidate ->
        Set.fromList
          [at | cell@(at, _) <- observedCells (jointPatch joined), wrongAt belonging candidate cell]
      Nothing -> Set.empty
    wrongOf = length . filter ((`Set.member` wrong) . fst)
    strays candidate = [i | (i, part) <- indexed, not (belongsAt belonging candidate part)]
    inconsistent = maybe leastStrays strays place
    -- Among the places of single patches and of all patches but one, those to which most patches
    -- belong.
    leastStrays =
      let subsets = map pure parts ++ [[part | (j, part) <- indexed, j /= i] | (i, _) <- indexed]
          shape = patchShape (jointPatch joined)
          places =
            Set.fromList
              [ candidate
                | some <- subsets,
                  Just candidate <- [credible belonging (inFrame (jointAgreed joined) shape some)]
              ]
          counted =
            Set.toAscList
              (Set.map (\candidate -> let named = strays candidate in (length named, named)) places)
       in case counted of
            (fewest, _) : _ ->
              Set.toAscList (Set.fromList (concatMap snd (takeWhile ((== fewest) . fst) counted)))
            [] -> []
