{-# OPTIONS_HADDOCK hide #-}

-- | Locates a grid of symbols in the array.
--
-- Each step is a module. "PraTactile.Recognise.Likeliest" finds the likeliest position. Here the
-- grid is laid on the face the way up of that position. "PraTactile.Recognise.Witnesses" collects
-- the certain symbols. "PraTactile.Recognise.GridOutcome" decides between answer and refusal, and
-- "PraTactile.Recognise.Support" says what the decision rests on.
--
-- A sensor touches one face, and beyond the face's edge there is nothing of the array
-- ("PraTactile.Recognise.OneFace").
module PraTactile.Recognise.GridLocation
  ( GridLocation (..),
    locateGrid,
  )
where

import Data.List (maximumBy)
import qualified Data.Map.Strict as Map
import Data.Ord (comparing)
import PraTactile.Field
import PraTactile.Locate
import PraTactile.Recognise.FaceGrid
import PraTactile.Recognise.GridOutcome
import PraTactile.Recognise.Likeliest
import PraTactile.Recognise.OneFace
import PraTactile.Recognise.Reading
import PraTactile.Recognise.Recogniser
import PraTactile.Recognise.Support
import PraTactile.Recognise.SymbolBelief
import PraTactile.Recognise.Tolerance
import PraTactile.Recognise.Witnesses
import PraTactile.Symmetry

-- | The location of a grid, or why it has none.
data GridLocation = GridLocation
  { -- | the orientation in which the face is seen
    locationOrientation :: Symmetry,
    -- | the symbols of the grid by cells of the face, set upright
    locationCells :: Cells,
    -- | the support of the likeliest position, whether it was accepted or not
    locationSupport :: Maybe Support,
    locationLikeliest :: Maybe Likeliest,
    locationOutcome :: GridOutcome
  }

-- | Locates a grid of symbols along one axis. The third argument lists symbols along the other axis
-- that the network knows.
locateGrid ::
  KnownField k => Recogniser k -> Tolerance -> [ReadSymbol] -> FaceGrid -> GridLocation
locateGrid reader tolerance dissenters grid =
  GridLocation
    { locationOrientation = onFaceOrientation face,
      locationCells = onFaceCells face,
      locationSupport = asked >>= supportFrom reader witnesses,
      locationLikeliest = answer >>= likeliestFrom reader (gridCells grid),
      locationOutcome = gridOutcome reader tolerance face witnesses (askedAnswer <$> asked)
    }
  where
    asked = ask reader tolerance (gridCells grid)
    answer = asked >>= either (const Nothing) Just . askedAnswer
    face = layOnFace reader dissenters grid way (answer >>= answerPosterior >>= posteriorBest)
    way = wayUpAlone (foldMap (map snd . observedCells . askedPatch) asked)
    witnesses = witnessesOf reader tolerance face

-- | Lays a grid on the face. Arguments: the recogniser; symbols along the other axis; the grid; the
-- way up without a candidate; the candidate, which otherwise decides the way up. Cells beyond the
-- edge of the candidate's face stay in the grid and lose their symbols.
layOnFace ::
  Recogniser k -> [ReadSymbol] -> FaceGrid -> Symmetry -> Maybe Candidate -> GridOnFace
layOnFace reader dissenters grid way likeliest' =
  GridOnFace
    { onFaceOrientation = orientation,
      onFaceCells = seenOnFace orientation (Map.mapWithKey heard (gridCells grid)),
      onFaceGroups = gridGroups grid,
      onFaceSideways = dissenters,
      onFaceStrays = gridStrays grid
    }
  where
    orientation = axisOf (gridCells grid) <> maybe way candidateSymmetry likeliest'
    silent = maybe [] (candidateSilent . priorOf reader (gridCells grid)) likeliest'
    heard cell here = if offsetOf cell `elem` silent then [] else here

-- | The likeliest way up of the cells alone, for grids without a possible position.
wayUpAlone :: [Belief k] -> Symmetry
wayUpAlone cells = maximumBy (comparing shown) (reverse waysUp)
  where
    shown way = sum (map (log . symmetryChance way) cells)
