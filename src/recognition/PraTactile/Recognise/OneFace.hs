{-# OPTIONS_HADDOCK hide #-}

-- | What the placement says of where a grid of symbols may lie, before the array is asked.
--
-- A sensor touches one face. So the symbols that the network knows are cells of one face; and what
-- is seen beyond that face's edge, where nothing of the array's lies, is a smear: other cells there
-- say nothing. Something that carries the array otherwise, a plate or a face that the placement
-- does not have, is touched now and then: then the array goes on in every direction.
-- docs/explanation/locating.md has the formulas.
module PraTactile.Recognise.OneFace
  ( beforehandOf,
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

-- | What the placement says of a candidate for cells, whose offsets are rows and columns from 0 on.
beforehandOf :: Recogniser k -> Cells -> Candidate -> Beforehand
beforehandOf reader cells = case known of
  anchor : others
    | not (null (laidFaces (recogniserPlacement reader))) -> \candidate ->
      let upright = onPosition (invert (candidateSymmetry candidate)) shape
       in case faceFrom (candidatePosition candidate) upright anchor of
            Just has | all has others -> Beforehand 0 (filter (not . has) unsure)
            _ -> Beforehand (log otherwiseCarried) []
  _ -> const nothingBeforehand
  where
    (known, unsure) = both (map (offsetOf . fst)) (partition (isKnown . snd) (Map.toList cells))
    isKnown = any (isJust . readClass)
    -- The face that has the cell at an offset: which of the others it has as well.
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

-- | How probable it is beforehand, as many times as that it is one face of the placement, that what
-- carries the array is something else (assumption): one of 200 things that are touched.
otherwiseCarried :: Double
otherwiseCarried = 0.005
