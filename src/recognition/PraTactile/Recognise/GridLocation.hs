{-# OPTIONS_HADDOCK hide #-}

-- | From the symbols on a grid to the place of the grid's upper left cell in the array.
--
-- Each step is a module: the array is asked ("PraTactile.Recognise.Likeliest"), the grid is laid on
-- the face the likeliest way up, the certain symbols are its witnesses
-- ("PraTactile.Recognise.Witnesses"), and what they and the probabilities say decides the outcome
-- ("PraTactile.Recognise.GridOutcome", "PraTactile.Recognise.Support").
--
-- A sensor touches one face, and beyond its edge lies nothing of the array's, as
-- "PraTactile.Recognise.OneFace" has it.
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

-- | Where a grid is.
data GridLocation = GridLocation
  { locationOrientation :: Symmetry,
    -- | the grid as it lies on the face
    locationCells :: Cells,
    -- | for the likeliest position, accepted or not
    locationSupport :: Maybe Support,
    locationLikeliest :: Maybe Likeliest,
    locationOutcome :: GridOutcome
  }

-- | Locates a grid of symbols of one axis. The dissenters are symbols of the other axis that the
-- network knows all the same.
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

-- | Lays a grid on the face the way up of the likeliest candidate, or this way where no candidate
-- is possible. Cells that lie beyond the edge of the candidate's face keep their place in the grid
-- and lose their symbols.
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
    silent = maybe [] (beforehandSilent . beforehandOf reader (gridCells grid)) likeliest'
    heard cell here = if offsetOf cell `elem` silent then [] else here

-- | The way up that cells show by themselves, where no position is possible.
wayUpAlone :: [Belief k] -> Symmetry
wayUpAlone cells = maximumBy (comparing shown) (reverse waysUp)
  where
    shown way = sum (map (log . symmetryChance way) cells)
