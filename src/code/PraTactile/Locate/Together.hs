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
  , exactTogether

    -- * Probabilities
  , posteriorTogether
  , posteriorTogetherOriented
  ) where

import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Grid (canonicalPosition)
import PraTactile.Locate.Book
import PraTactile.Locate.Nearest
import PraTactile.Locate.Orientation
import PraTactile.Locate.Oriented
import PraTactile.Locate.Outcome
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
  -- or nowhere. If all together are not located: those without which the others are, and that do not belong where these
  -- are; of two patches alone, which cannot tell which of them it is, perhaps both.
  }
  deriving stock (Eq, Show)

-- | Upright patches of symbols.
type Together = TogetherAs Decision

-- | Locate patches together, each given with its displacement. Refuses no patches
-- ('PatchEmpty'), and a rectangle around them of more cells than a book has ('PatchTooLarge').
nearestTogether :: KnownField k => Book k -> Radius -> [((Integer, Integer), Patch k)] -> Either LocateError Together
nearestTogether shelf radius =
  symbolsTogether (bookSurface shelf) (bookArray shelf) (ownRadius shelf) (nearest shelf radius) $ \decision ->
    case decisionOutcome decision of
      Located place _ -> Just (Candidate upright place)
      _ -> Nothing

-- | The same, in any one of these orientations.
nearestTogetherOriented
  :: KnownField k
  => Book k -> [Orientation] -> Radius -> [((Integer, Integer), Patch k)] -> Either LocateError (TogetherAs OrientedDecision)
nearestTogetherOriented shelf possible radius =
  symbolsTogether (bookSurface shelf) (bookArray shelf) (ownRadius shelf) (nearestOriented shelf possible radius) (onlyCandidate . orientedOutcome)

-- | Half of the distance of cells, by their offsets.
ownRadius :: Book k -> [Position] -> Natural
ownRadius shelf = guaranteedRadius . observedDistance shelf

-- | The same by another road, which answers exact agreement only, and so at once whether a patch belongs: if none of its cells is wrong.
exactTogether
  :: KnownField k
  => Surface -> PseudorandomArray k -> (Patch k -> OrientedOutcome) -> [((Integer, Integer), Patch k)] -> Either LocateError (TogetherAs OrientedOutcome)
exactTogether surface array road = symbolsTogether surface array (const 0) road onlyCandidate

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
  -> [((Integer, Integer), Patch k)]
  -> Either LocateError (TogetherAs decision)
symbolsTogether surface array ownRadiusOf locate located given =
  joined
    Joining
      { agreed = \looks -> case looks of
          a : others | all (== a) others -> Just a
          _ -> Nothing
      , whole = patch
      , wrongAt = \candidate shape cells -> map fst (filter (differs candidate shape) cells)
      , belongs = \candidate shape cells ->
          let laid = [seenAt (undone (candidateOrientation candidate)) shape offset | (offset, _) <- cells]
           in fromIntegral (length (filter (differs candidate shape) cells)) <= ownRadiusOf laid
      }
    locate
    located
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
    Located place _ -> Just (Candidate upright place)
    _ -> Nothing

-- | The same, in any one of these orientations.
posteriorTogetherOriented
  :: KnownField k
  => Book k -> [Orientation] -> Double -> [((Integer, Integer), SoftPatch k)] -> Either LocateError (TogetherAs (PosteriorOver Candidate))
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
    [(at, softRows p) | (at, p) <- given]
 where
  symbolOf = symbolAt (bookSurface shelf) (bookArray shelf)
  alone candidate shape cells = decideAmong tolerated (ranked (comparedPosition compared) (comparedTotals compared))
   where
    compared = likelihoods shelf [(seenAt (undone (candidateOrientation candidate)) shape offset, b) | (offset, b) <- cells]

-- | The array's symbol in a cell of a patch of this shape, as it is seen, if the candidate is right; 'Nothing' beyond the sheet.
symbolAt :: KnownField k => Surface -> PseudorandomArray k -> Candidate -> Shape -> Position -> Maybe (GF k)
symbolAt surface array (Candidate orientation (Position r c)) shape offset =
  cellAt array <$> canonicalPosition surface (arrayShape array) (toInteger (r + i)) (toInteger (c + j))
 where
  Position i j = seenAt (undone orientation) shape offset

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
  -> [((Integer, Integer), [[Maybe cell]])]
  -> Either LocateError (TogetherAs decision)
joined joining locate located given
  | spanned > largestSearchedArray = Left (PatchTooLarge spanned largestSearchedArray)
  | otherwise = do
      decision <- locate <$> whole joining (rowsWith given)
      let place = located decision
          wrong = maybe Set.empty (\candidate -> Set.fromList (wrongAt joining candidate shape (Map.toList (known given)))) place
      pure
        Together
          { togetherDecision = decision
          , togetherOffsets = [placed at | (at, _) <- given]
          , togetherDisputed = [at | (at, Nothing) <- Map.toList (looks given)]
          , togetherWrong = [length (filter ((`Set.member` wrong) . fst) (cellsOf g)) | g <- given]
          , togetherInconsistent = case place of
              Just candidate -> [i | (i, g) <- indexed, not (belongs joining candidate shape (cellsOf g))]
              Nothing ->
                [ i
                | (i, g) <- indexed
                , Right others <- [whole joining (rowsWith [other | (j, other) <- indexed, j /= i])]
                , Just candidate <- [located (locate others)]
                , not (belongs joining candidate shape (cellsOf g))
                ]
          }
 where
  indexed = zip [0 ..] given
  spanned = fromInteger ((bottom - top + 1) * (right - left + 1)) :: Natural
  shape = Shape (fromInteger (bottom - top + 1)) (fromInteger (right - left + 1))
  rowsWith some = let cells = known some in [[Map.lookup (placed (i, j)) cells | j <- [left .. right]] | i <- [top .. bottom]]
  known = Map.mapMaybe id . looks
  looks some = agreed joining <$> Map.fromListWith (flip (++)) [(at, [a]) | g <- some, (at, a) <- cellsOf g]
  cellsOf ((r, c), cells) = [(placed (r + i, c + j), a) | (i, line) <- zip [0 ..] cells, (j, Just a) <- zip [0 ..] line]
  placed (r, c) = Position (fromInteger (r - top)) (fromInteger (c - left))
  top = minimum' [r | ((r, _), _) <- given]
  left = minimum' [c | ((_, c), _) <- given]
  bottom = maximum' [r + toInteger (length cells) - 1 | ((r, _), cells) <- given]
  right = maximum' [c + toInteger (length (concat (take 1 cells))) - 1 | ((_, c), cells) <- given]
  minimum' xs = if null xs then 0 else minimum xs
  maximum' xs = if null xs then -1 else maximum xs
