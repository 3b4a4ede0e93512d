{-# LANGUAGE DeriveTraversable #-}
{-# LANGUAGE DerivingStrategies #-}

-- |
-- Several patches of one face at known displacements from each other: their cells together tell the
-- position better than each alone, and patches that do not belong are named. All are seen in the same orientation; displacements are
-- rows down and columns to the right, as seen, from a common point.
module PraTactile.Locate.Together
  ( -- * Answers
    TogetherAs (..)
  , Together

    -- * Symbols
  , nearestTogether
  , nearestTogetherOriented
  , togetherBy
  , joinPatches

    -- * Probabilities
  , posteriorTogether
  , posteriorTogetherOriented
  , joinSoftPatches
  ) where

import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Grid (canonicalPosition)
import PraTactile.Locate.Book
import PraTactile.Locate.Nearest
import PraTactile.Locate.Separation
import PraTactile.Symmetry
import PraTactile.Locate.Oriented
import PraTactile.Locate.Answer
import PraTactile.Locate.Patch
import PraTactile.Locate.Search (largestSearchedArray)
import PraTactile.Locate.Soft

-- | Where patches are together, and what each is worth. Cells are offsets in the rectangle around all patches.
data TogetherAs decision = Together
  { togetherDecision :: decision
  -- ^ Of all cells in one patch, the rectangle around all patches; its upper left cell is the position.
  , togetherOffsets :: [Position]
  -- ^ Where in it the upper left cell of each patch is, in the order given.
  , togetherDisputed :: [Position]
  -- ^ The cells, which count as not observed, that patches saw differently; of probabilities those whose product is
  -- zero for every symbol.
  , togetherWrong :: [Int]
  -- ^ How many cells of each patch are wrong, disputed ones left out, if the patches are where they were located; of probabilities those
  -- whose likeliest symbol is. 0 if they were not located.
  , togetherInconsistent :: [Int]
  -- ^ The patches, by their indices from 0, that do not belong where all are located: of each more cells are wrong there, disputed
  -- ones among them, than it could have wrong for certain if it were alone ('guaranteedRadius'), so that alone it would be located elsewhere
  -- or nowhere. If all together are not located, the place is that to which most patches belong, of all places of single patches and of
  -- all patches but one; if those are several, as with two patches, it cannot be told which is right, and whatever does not belong to all of them is named.
  }
  deriving stock (Eq, Show, Functor, Foldable, Traversable)

-- | Upright patches of symbols.
type Together = TogetherAs Decision

-- | Locate patches together, each given with its displacement. Refuses no patches
-- ('PatchEmpty'), and a rectangle around them of more cells than a book has ('PatchTooLarge').
nearestTogether :: KnownField k => Book k -> Radius -> [((Integer, Integer), Patch k)] -> Either LocateError Together
nearestTogether shelf radius = symbolsTogether (bookSurface shelf) (bookArray shelf) (ownRadius shelf) (nearest shelf radius) located (promised located decisionNearest decisionDistance)
 where
  located decision = case decisionOutcome decision of
    Located place _ -> Just (Candidate identity place)
    _ -> Nothing

-- | The same, in any one of these orientations.
nearestTogetherOriented
  :: KnownField k
  => Book k -> [Symmetry] -> Radius -> [((Integer, Integer), Patch k)] -> Either LocateError (TogetherAs OrientedDecision)
nearestTogetherOriented shelf possible radius =
  symbolsTogether (bookSurface shelf) (bookArray shelf) (ownRadius shelf) (nearestOriented shelf possible radius) located (promised located orientedNearest orientedMinimum)
 where
  located = onlyCandidate . orientedOutcome

-- | Only what is within the guaranteed radius.
promised :: (decision -> Maybe Candidate) -> (decision -> Maybe Natural) -> (decision -> Natural) -> decision -> Maybe Candidate
promised located nearestOf distanceOf decision
  | maybe False (<= guaranteedRadius (distanceOf decision)) (nearestOf decision) = located decision
  | otherwise = Nothing

-- | Half of the distance of cells, by their offsets.
ownRadius :: Book k -> [Position] -> Natural
ownRadius shelf = guaranteedRadius . observedDistance shelf

-- | The same by another road, on an array of any size. Whether a patch belongs is told by half of its 'candidateDistance'.
togetherBy
  :: KnownField k
  => Surface
  -> PseudorandomArray k
  -> (Patch k -> decision)
  -> (decision -> Maybe Candidate)
  -> [((Integer, Integer), Patch k)]
  -> Either LocateError (TogetherAs decision)
togetherBy surface array road located =
  symbolsTogether surface array (guaranteedRadius . candidateDistance surface array [identity] (Shape 1 1)) road located located

-- | All patches in one, without the cells in dispute. Refuses as 'nearestTogether' does.
joinPatches :: [((Integer, Integer), Patch k)] -> Either LocateError (Patch k)
joinPatches given = do
  frame <- frameAround displaced
  patch (rowsIn frame (knownIn sameSymbol frame displaced))
 where
  displaced = [(at, patchRows p) | (at, p) <- given]

-- | The same of patches of probabilities, those of the same cell multiplied.
joinSoftPatches :: [((Integer, Integer), SoftPatch k)] -> Either LocateError (SoftPatch k)
joinSoftPatches given = do
  frame <- frameAround displaced
  softPatch (rowsIn frame (knownIn combined frame displaced))
 where
  displaced = [(at, softRows p) | (at, p) <- given]

onlyCandidate :: OrientedOutcome -> Maybe Candidate
onlyCandidate outcome = case outcome of
  OrientedAt candidate _ -> Just candidate
  _ -> Nothing

symbolsTogether
  :: KnownField k
  => Surface
  -> PseudorandomArray k
  -> ([Position] -> Natural)
  -> (Patch k -> decision)
  -> (decision -> Maybe Candidate)
  -> (decision -> Maybe Candidate)
  -> [((Integer, Integer), Patch k)]
  -> Either LocateError (TogetherAs decision)
symbolsTogether surface array ownRadiusOf locate located credible given =
  joined
    Joining
      { agreed = sameSymbol
      , whole = patch
      , wrongAt = \candidate shape cells -> map fst (filter (differs candidate shape) cells)
      , belongs = \candidate shape cells ->
          let laid = [onPosition (invert (candidateSymmetry candidate)) shape offset | (offset, _) <- cells]
           in fromIntegral (length (filter (differs candidate shape) cells)) <= ownRadiusOf laid
      }
    locate
    located
    credible
    [(at, patchRows p) | (at, p) <- given]
 where
  differs candidate shape (offset, a) = symbolAt surface array candidate shape offset /= Just a

-- | Locate patches of probabilities together: those of the same cell are multiplied and made to add up to 1, as independent looks at it. A patch is
-- inconsistent if its own probabilities make its place impossible, or tell another with a doubt that is tolerated. Refuses as
-- 'nearestTogether' does.
posteriorTogether
  :: KnownField k => Book k -> Double -> [((Integer, Integer), SoftPatch k)] -> Either LocateError (TogetherAs Posterior)
posteriorTogether shelf tolerated = chancesTogether shelf tolerated (posterior shelf) $ \found ->
  case decide tolerated found of
    Located place _ -> Just (Candidate identity place)
    _ -> Nothing

-- | The same, in any one of these orientations.
posteriorTogetherOriented
  :: KnownField k
  => Book k -> [Symmetry] -> Double -> [((Integer, Integer), SoftPatch k)] -> Either LocateError (TogetherAs (PosteriorOver Candidate))
posteriorTogetherOriented shelf possible tolerated =
  chancesTogether shelf tolerated (posteriorOriented shelf possible) (onlyCandidate . decideOriented tolerated)

chancesTogether
  :: KnownField k
  => Book k
  -> Double
  -> (SoftPatch k -> decision)
  -> (decision -> Maybe Candidate)
  -> [((Integer, Integer), SoftPatch k)]
  -> Either LocateError (TogetherAs decision)
chancesTogether shelf tolerated locate located given =
  joined
    Joining
      { agreed = combined
      , whole = softPatch
      , wrongAt = \candidate shape cells -> [offset | (offset, b) <- cells, symbolOf candidate shape offset /= Just (likeliest b)]
      , belongs = \candidate shape cells ->
          all (\(offset, b) -> maybe False (`possibleIn` b) (symbolOf candidate shape offset)) cells
            && either (const True) (candidatePosition candidate `elem`) (alone candidate shape cells)
      }
    locate
    located
    located
    [(at, softRows p) | (at, p) <- given]
 where
  symbolOf = symbolAt (bookSurface shelf) (bookArray shelf)
  alone candidate shape cells = decideAmong tolerated (ranked (comparedPosition compared) (comparedTotals compared))
   where
    compared = likelihoods shelf [(onPosition (invert (candidateSymmetry candidate)) shape offset, b) | (offset, b) <- cells]

-- | The array's symbol in a cell of a patch of this shape, as it is seen, if the candidate is right; 'Nothing' beyond the sheet.
symbolAt :: KnownField k => Surface -> PseudorandomArray k -> Candidate -> Shape -> Position -> Maybe (GF k)
symbolAt surface array (Candidate orientation (Position r c)) shape offset =
  cellAt array <$> canonicalPosition surface (arrayShape array) (toInteger (r + i)) (toInteger (c + j))
 where
  Position i j = onPosition (invert orientation) shape offset

-- | What there is to know of cells, to join patches of them.
data Joining cell patch = Joining
  { agreed :: [cell] -> Maybe cell
  -- ^ What several looks at a cell say together; 'Nothing' if they are in dispute.
  , whole :: [[Maybe cell]] -> Either LocateError patch
  -- ^ The patch with these rows.
  , wrongAt :: Candidate -> Shape -> [(Position, cell)] -> [Position]
  -- ^ Which of these cells are wrong there, of a patch with this shape.
  , belongs :: Candidate -> Shape -> [(Position, cell)] -> Bool
  -- ^ Whether these cells, taken alone, may be there.
  }

joined
  :: Joining cell patch
  -> (patch -> decision)
  -> (decision -> Maybe Candidate)
  -> (decision -> Maybe Candidate)
  -> [((Integer, Integer), [[Maybe cell]])]
  -> Either LocateError (TogetherAs decision)
joined joining locate located credible given = do
  frame <- frameAround given
  let shape = frameShape frame
      rowsWith = rowsIn frame . knownIn (agreed joining) frame
      cellsOf = cellsIn frame
  decision <- locate <$> whole joining (rowsWith given)
  let place = located decision
      known = Map.toList (knownIn (agreed joining) frame given)
      wrong = maybe Set.empty (\candidate -> Set.fromList (wrongAt joining candidate shape known)) place
  pure
    Together
      { togetherDecision = decision
      , togetherOffsets = [framed frame at | (at, _) <- given]
      , togetherDisputed = [at | (at, Nothing) <- Map.toList (looksIn (agreed joining) frame given)]
      , togetherWrong = [length (filter ((`Set.member` wrong) . fst) (cellsOf g)) | g <- given]
      , togetherInconsistent = case place of
          Just candidate -> [i | (i, g) <- indexed, not (belongs joining candidate shape (cellsOf g))]
          Nothing ->
            let subsets = [[g] | g <- given] ++ [[other | (j, other) <- indexed, j /= i] | (i, _) <- indexed]
                places = Set.fromList [candidate | some <- subsets, Right p <- [whole joining (rowsWith some)], Just candidate <- [credible (locate p)]]
                strays candidate = Set.fromList [i | (i, g) <- indexed, not (belongs joining candidate shape (cellsOf g))]
             in case Set.toList (Set.map (\strayed -> (Set.size strayed, strayed)) (Set.map strays places)) of
                  fewest@((count, _) : _) -> Set.toAscList (Set.unions (map snd (takeWhile ((== count) . fst) fewest)))
                  [] -> []
      }
 where
  indexed = zip [0 ..] given

-- | The rectangle around patches: its first row and column, counted from the common point, and its shape.
data Frame = Frame (Integer, Integer) Shape

frameShape :: Frame -> Shape
frameShape (Frame _ shape) = shape

-- | Refuses no cells ('PatchEmpty'), and more of them than a book has ('PatchTooLarge').
frameAround :: [((Integer, Integer), [[cell]])] -> Either LocateError Frame
frameAround given
  | null given = Left PatchEmpty
  | area shape > largestSearchedArray = Left (PatchTooLarge (area shape) largestSearchedArray)
  | otherwise = Right (Frame (top, left) shape)
 where
  shape = Shape (side top [r + toInteger (length cells) | ((r, _), cells) <- given]) (side left [c + toInteger (length (concat (take 1 cells))) | ((_, c), cells) <- given])
  top = foldr1' min [r | ((r, _), _) <- given]
  left = foldr1' min [c | ((_, c), _) <- given]
  side from ends = fromInteger (foldr1' max ends - from)
  foldr1' f xs = case xs of
    [] -> 0
    x : others -> foldr f x others

-- | Where in the frame a cell is, given from the common point.
framed :: Frame -> (Integer, Integer) -> Position
framed (Frame (top, left) _) (r, c) = Position (fromInteger (r - top)) (fromInteger (c - left))

-- | The observed cells of a patch.
cellsIn :: Frame -> ((Integer, Integer), [[Maybe cell]]) -> [(Position, cell)]
cellsIn frame ((r, c), cells) = [(framed frame (r + i, c + j), a) | (i, line) <- zip [0 ..] cells, (j, Just a) <- zip [0 ..] line]

-- | What all looks at each cell say together.
looksIn :: ([cell] -> Maybe cell) -> Frame -> [((Integer, Integer), [[Maybe cell]])] -> Map Position (Maybe cell)
looksIn agreeing frame given = agreeing <$> Map.fromListWith (flip (++)) [(at, [a]) | g <- given, (at, a) <- cellsIn frame g]

-- | The same without the cells in dispute.
knownIn :: ([cell] -> Maybe cell) -> Frame -> [((Integer, Integer), [[Maybe cell]])] -> Map Position cell
knownIn agreeing frame = Map.mapMaybe id . looksIn agreeing frame

-- | The rows of the frame with these cells.
rowsIn :: Frame -> Map Position cell -> [[Maybe cell]]
rowsIn frame known = [[Map.lookup (Position i j) known | j <- below (columns (frameShape frame))] | i <- below (rows (frameShape frame))]
 where
  below n = takeWhile (< n) [0 ..]

-- | The symbol, if all looks saw the same one.
sameSymbol :: Eq a => [a] -> Maybe a
sameSymbol looks = case looks of
  a : others | all (== a) others -> Just a
  _ -> Nothing
