{-# OPTIONS_HADDOCK hide #-}

-- | The prior of where a grid of symbols lies, from the placement of the faces.
--
-- A sensor touches one face. So the symbols that the network knows are cells of one face, and
-- anything seen beyond that face's edge is a smear, whose cells are ignored. Occasionally something
-- else carries the array: a plate, or a face that the placement does not have. Then the array goes
-- on in every direction. docs/explanation/locating.md has the formulas.
module PraTactile.Recognise.OneFace
  ( priorOf,
  )
where

import Data.List (partition)
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Grid (displaced)
import PraTactile.Locate hiding (Cell)
import PraTactile.Object.Placement
import PraTactile.Recognise.FaceGrid
import PraTactile.Recognise.Reading
import PraTactile.Recognise.Recogniser
import PraTactile.Symmetry

-- | The prior of a candidate, and the cells that are silent if it is right. The cells of the grid
-- are given by rows and columns from 0, and so are the silent ones.
priorOf :: Recogniser k -> Cells -> Candidate -> CandidatePrior
priorOf reader cells = case known of
  anchor : others
    | not (null (laidFaces (recogniserPlacement reader))) -> \candidate ->
      let upright = onPosition (invert (candidateSymmetry candidate)) shape
       in case faceFrom (candidatePosition candidate) upright anchor of
            Just has | all has others -> CandidatePrior 0 (filter (not . has) unsure)
            _ -> CandidatePrior (log priorOddsElsewhere) []
  _ -> const uniformPrior
  where
    (known, unsure) = both (map (offsetOf . fst)) (partition (isKnown . snd) (Map.toList cells))
    isKnown = any (isJust . readClass)
    -- For the face that has the cell at this offset: which other cells it has.
    faceFrom begin upright anchor = do
      at <- displaced surface (arrayShape array) begin (upright anchor)
      (laid, here) <- laidOver (recogniserPlacement reader) at
      let beside part offset =
            natural (int part here + int part (upright offset) - int part (upright anchor))
      pure $ \offset ->
        maybe
          False
          (hasCell (laidBlock laid))
          (Position <$> beside row offset <*> beside column offset)
    int :: (Position -> Natural) -> Position -> Integer
    int part = toInteger . part
    natural :: Integer -> Maybe Natural
    natural n = if n < 0 then Nothing else Just (fromInteger n)
    shape = Shape (extent fst) (extent snd)
    extent part = fromIntegral (1 + maximum (-1 : map part (Map.keys cells)))
    ArrayOn surface array = locatorArray (recogniserLocator reader)
    both f (x, y) = (f x, f y)

-- | The prior odds that something else than a face of the placement carries the array: one in 200
-- things touched (assumption).
priorOddsElsewhere :: Double
priorOddsElsewhere = 0.005
