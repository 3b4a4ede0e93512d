{-# OPTIONS_HADDOCK hide #-}

-- | Several patches of one face at known displacements from each other, decoded jointly: all their
-- cells determine the position better than those of one patch, and patches that do not belong are
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

-- | Patches in the rectangle around all of them.
data Joint a = Joint
  { -- | All cells in one patch, without those in dispute.
    jointPatch :: Patch a,
    -- | The cells that patches saw differently, which count as not observed.
    jointDisputed :: [Position],
    -- | Where in the rectangle the upper left cell of each patch is, in the order given.
    jointOffsets :: [Position],
    -- | The cells of each patch.
    jointParts :: [[(Position, a)]],
    -- | What several looks at a cell come to; 'Nothing' if they are in dispute.
    jointAgreed :: [a] -> Maybe a
  }

-- | Join patches, each given with its displacement, rows down and columns to the right, from a
-- common point; by what several looks at a cell come to, 'Nothing' if they are in dispute. Refuses
-- no patches ('PatchEmpty'), more than 'mostPatches' ('PatchesTooMany'), and a rectangle around
-- several of more than 'largestSearchedArray' cells ('PatchTooLarge').
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

-- | How many patches are located jointly: 100. Which of them do not belong is found by leaving each
-- out, so that the time grows with the square of their number.
mostPatches :: Natural
mostPatches = 100

-- | What all looks at each cell come to.
looks :: ([a] -> Maybe a) -> [[(Position, a)]] -> Map Position (Maybe a)
looks agreed parts =
  agreed . reverse <$> Map.fromListWith (++) [(at, [a]) | part <- parts, (at, a) <- part]

-- | The cells of some patches as one of this shape, without those in dispute.
inFrame :: ([a] -> Maybe a) -> Shape -> [[(Position, a)]] -> Patch a
inFrame agreed shape parts = patchOf shape (Map.toAscList (Map.mapMaybe id (looks agreed parts)))

-- | The symbol, if all looks saw the same one.
agreedSymbol :: Eq a => [a] -> Maybe a
agreedSymbol seen = case seen of
  a : others | all (== a) others -> Just a
  _ -> Nothing

-- | What decides whether cells belong where all are located.
data Belonging a = Belonging
  { -- | Whether a cell is wrong there.
    wrongAt :: Candidate -> (Position, a) -> Bool,
    -- | Whether cells, taken alone, may be there.
    belongsAt :: Candidate -> [(Position, a)] -> Bool,
    -- | Where some of the patches would be located with certainty.
    credible :: Patch a -> Maybe Candidate
  }

-- | What is said of each patch, given where all are located, if they are.
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
    -- Of the places of single patches and of all patches but one, those to which most patches
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
