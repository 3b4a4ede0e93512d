{-# OPTIONS_HADDOCK hide #-}

-- | The likeliest places of cells in the array, by the probabilities of their symbols.
module PraTactile.Recognise.Likeliest
  ( -- * Asking the array
    Asked (..),
    ask,

    -- * The likeliest place
    Likeliest (..),
    likeliestFrom,
    likeliestAt,
    likeliestElsewhere,

    -- * All likely places
    likelyCells,
  )
where

import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import PraTactile.Array
import PraTactile.Field
import PraTactile.Locate
import PraTactile.Recognise.FaceGrid
import PraTactile.Recognise.OneFace
import PraTactile.Recognise.Reading
import PraTactile.Recognise.Recogniser
import PraTactile.Recognise.SymbolBelief
import PraTactile.Recognise.Tolerance
import PraTactile.Segmentation.Lattice (ClusterCell)
import PraTactile.Symmetry

-- | The cells as a patch, and the decoder's answer for it.
data Asked k = Asked
  { askedPatch :: Patch (Belief k),
    askedAnswer :: Either LocatorError Answer
  }

-- | Locates the symbols in the cells of a grid in the array. 'Nothing' if there are no cells.
ask :: KnownField k => Recogniser k -> Tolerance -> Cells -> Maybe (Asked k)
ask reader tolerance cells = do
  shown <- patchOf cells
  pure (Asked shown (locate (recogniserLocator reader) (query reader tolerance cells shown)))

-- | The decoder's answer for cells, with the prior that they are certainly the array's. 'Nothing'
-- if there are no cells or the decoder refuses them.
askAsOurs :: KnownField k => Recogniser k -> Tolerance -> Cells -> Maybe Answer
askAsOurs reader tolerance cells = do
  question <- query reader tolerance cells <$> patchOf cells
  rightOnly (locate (recogniserLocator reader) question {queryForeign = Nothing})

-- | The beliefs about each cell as a patch. 'Nothing' if there are no cells.
patchOf :: KnownField k => Cells -> Maybe (Patch (Belief k))
patchOf cells = rightOnly (patch (map (map (>>= beliefAlong (axisOf cells))) (gridRows cells)))

-- | The query for cells with these beliefs. The log-likelihood ratio of a symbol being foreign is
-- clipped to between -6 and 4, so that one spoilt symbol, such as one at an edge, does not outweigh
-- many others.
query :: Recogniser k -> Tolerance -> Cells -> Patch (Belief k) -> Query k
query reader tolerance cells shown =
  (onePatch (Probabilities <$> shown))
    { querySymmetries = waysUp,
      queryDoubt = toleratedDoubt tolerance,
      queryForeign = Just (foreignPrior tolerance),
      queryForeignShape =
        sum [max (-6) (min 4 (readForeignShape s)) | here <- Map.elems cells, s <- here],
      queryPrior = Just (priorOf reader cells)
    }

-- | The likeliest place of cells, whether or not it is likely enough for an answer.
data Likeliest = Likeliest
  { -- | the log-likelihood ratio of the cells being the array's to their being random
    likeliestEvidence :: Double,
    -- | the logarithm of the place's prior, at most 0
    likeliestPrior :: Double,
    -- | the orientation in which the face is seen
    likeliestOrientation :: Symmetry,
    -- | the position in the array of the upper left cell as the grid lies on the face
    likeliestFirst :: Position,
    -- | the greatest row and column of the cells, along the symbols' axes
    likeliestEnd :: ClusterCell
  }
  deriving stock (Eq, Show)

-- | The likeliest place according to a decoder's answer. 'Nothing' if no place is possible.
likeliestFrom :: Recogniser k -> Cells -> Answer -> Maybe Likeliest
likeliestFrom reader cells answer = do
  candidate <- answerPosterior answer >>= posteriorBest
  evidence <- answerEvidence answer
  pure
    Likeliest
      { likeliestEvidence = evidence,
        likeliestPrior = candidateLogPrior (priorOf reader cells candidate),
        likeliestOrientation = axisOf cells <> candidateSymmetry candidate,
        likeliestFirst = candidatePosition candidate,
        likeliestEnd = (end fst, end snd)
      }
  where
    end part = maximum (0 : map part (Map.keys cells))

-- | The position in the array of a cell of the grid, whether or not it was seen, if the place is
-- right. 'Nothing' beyond the sheet.
likeliestAt :: KnownField k => Recogniser k -> Likeliest -> ClusterCell -> Maybe Position
likeliestAt reader found (i, j) = fst <$> cellFrom reader (likeliestFirst found) onFace
  where
    (lastRow, lastColumn) = likeliestEnd found
    onFace
      | quarterTurns (likeliestOrientation found) >= 2 = (lastRow - i, lastColumn - j)
      | otherwise = (i, j)

-- | The likeliest place of the cells of an alternative layout. 'Nothing' if no place is possible.
-- In a large array only 2^10 words are searched, because most alternatives fit no place. Likely
-- places are among the first, and the rest counts as doubt.
likeliestElsewhere :: KnownField k => Recogniser k -> Tolerance -> Cells -> Maybe Likeliest
likeliestElsewhere reader tolerance cells =
  askAsOurs briefly tolerance cells >>= likeliestFrom reader cells
  where
    briefly = reader {recogniserLocator = withListing 1024 (recogniserLocator reader)}

-- | The positions in the array that the cells cover in any of their likely places, of which at most
-- the first thousand are used. Cells are assumed not to be foreign, which does not change these
-- places.
likelyCells :: KnownField k => Recogniser k -> Tolerance -> Cells -> [Position]
likelyCells reader tolerance cells =
  Set.toAscList . Set.fromList $
    [ position
      | Just answer <- [askAsOurs reader tolerance cells],
        Just posterior <- [answerPosterior answer],
        (Candidate way first, _) <- fst (weighable (posteriorRanking posterior)),
        cell <- Map.keys (seenOnFace (axisOf cells <> way) cells),
        Just (position, _) <- [cellFrom reader first cell]
    ]

-- | The result, if there is no refusal.
rightOnly :: Either e a -> Maybe a
rightOnly = either (const Nothing) Just
