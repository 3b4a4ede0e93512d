-- | The one way from a question to its answer: patches are joined, their cells laid upright in each
-- symmetry in which they may be seen, decoded, and what that comes to made one. Patches and
-- symmetries are handled here alone, the same for all decoders.
module PraTactile.Locate.Locator
  ( Locator,
    locator,
    locate,
    decoderFor,
    agreedSymbols,
    LocatorError (..),
  )
where

import Data.Bifunctor (first)
import Data.List (nub)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Grid (canonicalPosition)
import PraTactile.Locate.Answer
import PraTactile.Locate.Belief
import PraTactile.Locate.Chance
import PraTactile.Locate.Decision
import PraTactile.Locate.Decoders
import PraTactile.Locate.Joint
import PraTactile.Locate.Patch
import PraTactile.Locate.Query
import PraTactile.Locate.Soft
import PraTactile.Symmetry

-- | Where the patches of a question are. If any cell has probabilities, all cells are taken as
-- probabilities. Refuses what the decoder that is asked for cannot do, and where there is none.
locate :: KnownField k => Locator k -> Query k -> Either LocatorError Answer
locate made query = case nub (querySymmetries query) of
  [] -> Left NoSymmetry
  possible -> case traverse (traverse (traverse symbolOf)) (queryPatches query) of
    Just given | not (decodesProbabilities made) -> locateSymbols made query possible given
    _ -> locateBeliefs made query possible (map (fmap (fmap cellBelief)) (queryPatches query))

-- | The symbol of a cell, if it is known.
symbolOf :: Cell k -> Maybe (GF k)
symbolOf cell = case cell of
  Symbol a -> Just a
  Probabilities _ -> Nothing

-- | Which decoder answers questions about symbols on a surface with this radius; refused where none
-- does.
decoderFor :: KnownField k => Locator k -> Surface -> Radius -> Either LocatorError DecoderName
decoderFor made surface stated = symbolName <$> symbolDecoder made surface stated

-- | The observed symbols of a question in the rectangle around its patches, without those in
-- dispute; of probabilities none.
agreedSymbols :: Query k -> Either LocatorError (Patch (GF k))
agreedSymbols query =
  first
    LocatorPatch
    (jointPatch <$> joint agreedSymbol [(at, symbols p) | (at, p) <- queryPatches query])
  where
    symbols p =
      patchOf
        (patchShape p)
        [(offset, a) | (offset, cell) <- observedCells p, Just a <- [symbolOf cell]]

locateSymbols ::
  KnownField k =>
  Locator k ->
  Query k ->
  [Symmetry] ->
  [((Integer, Integer), Patch (GF k))] ->
  Either LocatorError Answer
locateSymbols made query possible given = do
  joined <- first LocatorPatch (joint agreedSymbol given)
  decoder <- symbolDecoder made surface (queryRadius query)
  let seen = jointPatch joined
      decide' = decideIn decoder possible (queryRadius query)
      around = spheres surface array possible (patchShape seen) (map fst (observedCells seen))
      differs shape candidate (offset, a) = symbolAt surface array candidate shape offset /= Just a
  decision <- decide' seen
  let distances = decisionDistances decision
      worth = chance . correcting (atLeast (codeDistance distances)) (correctionRadius distances)
  pure
    Answer
      { answerOutcome = decisionOutcome decision,
        answerDecoder = symbolName decoder,
        answerDistances = Just distances,
        answerPosterior = Nothing,
        answerChance = (if windowless decoder seen then atMost else id) . worth <$> around,
        answerPatches =
          patchVerdicts
            Belonging
              { wrongAt = differs (patchShape seen),
                belongsAt = \candidate cells ->
                  fromIntegral (length (filter (differs (patchShape seen) candidate) cells))
                    <= symbolOwnRadius
                      decoder
                      (map (uprightOffset candidate (patchShape seen) . fst) cells),
                credible = either (const Nothing) promised . decide'
              }
            joined
            (located (decisionOutcome decision)),
        answerDisputed = jointDisputed joined
      }
  where
    surface = querySurface query
    array = locatorArray made
    -- The table knows complete windows only.
    windowless decoder seen =
      symbolName decoder == TableDecoder
        && or [null (completeWindows (locatorMask made) (uprightAs o seen)) | o <- possible]

-- | Decode a patch in each of these symmetries. 'Guaranteed' is half of the least distance between
-- any two candidates, which several symmetries make smaller, often 0: then only exact agreement is
-- answered.
decideIn ::
  SymbolDecoder k ->
  [Symmetry] ->
  Radius ->
  Patch (GF k) ->
  Either LocatorError (Decision Candidate)
decideIn decoder possible stated seen
  | null (observedCells seen) = Right (nowhereDecision (radiusFor stated 0))
  | otherwise = case symbolDistance decoder possible seen of
    Just d ->
      let radius =
            radiusFor stated (atLeast d)
       in overSymmetries d radius <$> each (UpTo radius)
    Nothing -> do
      found <- each stated
      -- One symmetry, which knows its own distance.
      let own = [decisionDistances decision | (_, _, decision) <- take 1 found]
      pure
        ( overSymmetries
            (foldr (const . codeDistance) (Exactly 0) own)
            (sum (map correctionRadius own))
            found
        )
  where
    each radius = traverse (laid radius) possible
    laid radius o =
      let upright = uprightAs o seen
       in (,,) o (patchShape upright) <$> symbolDecide decoder radius upright

-- | The candidate, if there is only one.
located :: Outcome place -> Maybe place
located outcome = case outcome of
  Unique place _ -> Just place
  _ -> Nothing

-- | Only what is within the guaranteed radius.
promised :: Decision place -> Maybe place
promised decision
  | maybe False ((<= guaranteed) . atLeast) (nearestDistance distances) =
    located (decisionOutcome decision)
  | otherwise = Nothing
  where
    distances = decisionDistances decision
    guaranteed = guaranteedRadius (atLeast (codeDistance distances)) :: Natural

-- | Patches of probabilities: those of the same cell are multiplied and made to add up to 1, as
-- independent looks at it.
locateBeliefs ::
  KnownField k =>
  Locator k ->
  Query k ->
  [Symmetry] ->
  [((Integer, Integer), Patch (Belief k))] ->
  Either LocatorError Answer
locateBeliefs made query possible given = do
  joined <- first LocatorPatch (joint combined given)
  decoder <- beliefDecoder made surface tolerated
  let seen = jointPatch joined
      shape = patchShape seen
      certain = fromIntegral (length (filter (isCertain . snd) (observedCells seen)))
      symbolIn candidate offset = symbolAt surface array candidate shape offset
      outcomeOf p found =
        if null (observedCells p) then Refused TooFewCells else decide tolerated found
      alone candidate cells =
        let own =
              patchOf shape cells
         in outcomeOf own <$> beliefPosterior decoder [candidateSymmetry candidate] own
  found <- beliefPosterior decoder possible seen
  pure
    Answer
      { answerOutcome = outcomeOf seen found,
        answerDecoder = beliefName decoder,
        answerDistances = Nothing,
        answerPosterior = Just found,
        -- Only a cell that leaves no doubt keeps out a position.
        answerChance =
          chance . amongCells certain
            <$> spheres surface array possible shape (map fst (observedCells seen)),
        answerPatches =
          patchVerdicts
            Belonging
              { wrongAt = \candidate (offset, b) -> symbolIn candidate offset /= Just (likeliest b),
                belongsAt = \candidate cells ->
                  and
                    [ maybe False (`possibleIn` b) (symbolIn candidate offset)
                      | (offset, b) <- cells
                    ]
                    && either (const True) (allows candidate) (alone candidate cells),
                credible =
                  \p ->
                    either
                      (const Nothing)
                      (located . outcomeOf p)
                      (beliefPosterior decoder possible p)
              }
            joined
            (located (outcomeOf seen found)),
        answerDisputed = jointDisputed joined
      }
  where
    surface = querySurface query
    array = locatorArray made
    tolerated = queryDoubt query

-- | Whether an outcome leaves a candidate possible.
allows :: Candidate -> Outcome Candidate -> Bool
allows candidate outcome = case outcome of
  Unique place _ -> place == candidate
  Ambiguous places _ -> candidate `elem` places
  _ -> True

-- | Where a cell of a patch of this shape is in the upright patch, if the candidate is right.
uprightOffset :: Candidate -> Shape -> Position -> Position
uprightOffset candidate = onPosition (invert (candidateSymmetry candidate))

-- | The array's symbol in a cell of a patch of this shape, as it is seen, if the candidate is
-- right; 'Nothing' beyond the sheet.
symbolAt ::
  KnownField k =>
  Surface ->
  PseudorandomArray k ->
  Candidate ->
  Shape ->
  Position ->
  Maybe (GF k)
symbolAt surface array candidate shape offset =
  cellAt array
    <$> canonicalPosition surface (arrayShape array) (toInteger (r + i)) (toInteger (c + j))
  where
    Position r c = candidatePosition candidate
    Position i j = uprightOffset candidate shape offset
