{-# LANGUAGE MultiWayIf #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Reads composites of one face before the array is asked: symbols, and parts of symbols beside
-- them, on one grid.
module PraTactile.Recognise.FaceReading
  ( FaceReading (..),
    AxisReading (..),
    GridReading (..),
    readFace,
    bySegmentation,
  )
where

import Data.List (partition)
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust, isNothing)
import PraTactile.Classification.Network (NetworkError)
import PraTactile.Classification.Reader (Reader)
import PraTactile.Composite.Lattice (Lattice)
import PraTactile.Composite.Skew (leastSkew, setUpright, skew)
import PraTactile.Recognise.FaceGrid
import PraTactile.Recognise.LatticeReading
import PraTactile.Recognise.Parts
import PraTactile.Recognise.Reading
import PraTactile.Recognise.Recognition
import PraTactile.Registration (Composite (..))
import PraTactile.Segmentation (ForeignMasked (..), Reject, Segmentation (..), maskForeign)
import PraTactile.Sensor.Manifest (Remedy (..), remedies, straight)
import PraTactile.Symmetry

-- | The reading of composites of one face.
data FaceReading = FaceReading
  { -- | regions of the composites that are not symbols
    faceForeign :: [Reject],
    -- | the reading of the composites as given
    faceAsGiven :: AxisReading,
    -- | if the symbols are not nearly upright by their 'skew': that angle, the maps from places of
    -- the upright composites to the given ones, and the reading of the upright composites
    faceUpright :: Maybe (Double, [(Double, Double) -> (Double, Double)], AxisReading)
  }

-- | Composites read along the axis of most symbols.
data AxisReading = AxisReading
  { -- | regions that are not complete symbols, in the composites' pixels
    readingRejects :: [Reject],
    -- | the symbols, or a recognition with the reason why they cannot be located
    readingOnGrid :: Either Recognition GridReading
  }

-- | Symbols and parts on one grid.
data GridReading = GridReading
  { gridReadingSymbols :: [ReadSymbol],
    -- | symbols along the other axis that the network knows nevertheless
    gridReadingDissenters :: [ReadSymbol],
    gridReadingParts :: [ReadSymbol],
    -- | the grid, including the parts
    gridReadingCells :: FaceGrid,
    gridReadingSkew :: Double
  }

-- | Reads the symbols of composites of one face. If registration found lattices under all of them,
-- their cells are read; else the symbols are found by segmentation, as in the paper. Refuses only
-- what the network refuses.
readFace :: Reader -> [Composite] -> Either NetworkError FaceReading
readFace reader given = case traverse compositeLattice given of
  Just lattices@(_ : _) -> inLattices reader (zip given lattices)
  _ -> bySegmentation reader given

-- | Reads composites by segmentation.
bySegmentation :: Reader -> [Composite] -> Either NetworkError FaceReading
bySegmentation reader given = case skew (map maskedComposite composites) of
  Just angle
    | abs angle > leastSkew -> do
      asGiven <- readUpright reader Nothing composites
      let (upright, places) = unzip (map (maskedUpright angle) composites)
      turnedBack <- readUpright reader (Just 0) upright
      pure (FaceReading foreignThings asGiven (Just (angle, places, turnedBack)))
  shown ->
    (\asGiven -> FaceReading foreignThings asGiven Nothing)
      <$> readUpright reader shown composites
  where
    composites = map maskForeign given
    foreignThings = concatMap maskedRejects composites

-- | 'setUpright' for a composite whose foreign regions are masked.
maskedUpright :: Double -> ForeignMasked -> (ForeignMasked, (Double, Double) -> (Double, Double))
maskedUpright angle (ForeignMasked composite byHeight foreignThings) =
  (ForeignMasked upright (fst . setUpright angle <$> byHeight) foreignThings, back)
  where
    (upright, back) = setUpright angle composite

-- | Reads composites in the cells of their lattices.
inLattices :: Reader -> [(Composite, Lattice)] -> Either NetworkError FaceReading
inLattices reader given = do
  found <-
    sequence
      [ readCells reader (composite, clean) lattice cells
        | ((composite, lattice), clean, cells) <- zip3 given composites (latticesRead given)
      ]
  let numberedCells = numberCells found
      (own, others) = partition ((== axis) . cellsAxis) numberedCells
      symbols = concatMap wholeIn numberedCells
      onGrid =
        case faceGrid (map (cellsGroup angle) own) of
          Just grid ->
            Right
              GridReading
                { gridReadingSymbols = symbols,
                  gridReadingDissenters = known (concatMap wholeIn others),
                  gridReadingParts =
                    concatMap (filter ((< 1) . readSeen) . Map.elems . cellsSymbols) own,
                  gridReadingCells = grid,
                  gridReadingSkew = skewed
                }
          Nothing -> Left (unanswered symbols GridContradicts)
  isMirrored <- if null (known symbols) then cellsMirrored reader symbols else pure False
  pure . (\shown -> FaceReading foreignThings (AxisReading [] shown) Nothing) $
    if
        | isMirrored -> Left (unanswered symbols (Mirrored (unmirroring composites)))
        | null symbols -> Left (unanswered symbols NoSymbols)
        | null (known symbols) -> Left (unanswered symbols SymbolsUnclear)
        | otherwise -> onGrid
  where
    composites = map (maskForeign . fst) given
    foreignThings = concatMap maskedRejects composites
    (axis, skewed) = axisOfAll (map snd given)
    angle = degreesClockwise axis + skewed
    known = filter (isJust . readClass)
    wholeIn = filter ((>= 1) . readSeen) . Map.elems . cellsSymbols

-- | Reads composites whose symbols' axes are nearly the composites' own. The angle between them, in
-- degrees clockwise, is given if the images show it.
readUpright :: Reader -> Maybe Double -> [ForeignMasked] -> Either NetworkError AxisReading
readUpright reader angle composites = do
  upright <- readSymbols reader identity 0 composites
  -- If the upright symbols are known there are no others; a flat composite has none.
  let flat = all ((<= 0) . segmentedContrast . viewSegmentation) upright
      next = length (concatMap viewSymbols upright)
  sideways <-
    if flat || mostKnown upright
      then pure []
      else readSymbols reader (turned 1) next composites
  let (views, others)
        | length (known sideways) > length (known upright) = (sideways, upright)
        | otherwise = (upright, sideways)
  isMirrored <-
    if null (known views) && not flat then readMirrored reader composites else pure False
  pure . AxisReading (concatMap viewRejects views) $
    if isMirrored
      then Left (unanswered (concatMap viewSymbols views ++ known others) (Mirrored remedy))
      else onOneGrid reader angle views (known others)
  where
    remedy = unmirroring composites
    known = filter (isJust . readClass) . concatMap viewSymbols

-- | Puts the symbols along one axis, and parts beside them, on one grid. The last argument is the
-- known symbols along the other axis.
onOneGrid ::
  Reader ->
  Maybe Double ->
  [SymbolView] ->
  [ReadSymbol] ->
  Either Recognition GridReading
onOneGrid reader angle views dissenters
  | null symbols = Left (unanswered everything NoSymbols)
  | all (isNothing . readClass) symbols = Left (unanswered everything SymbolsUnclear)
  | otherwise = maybe (Left (unanswered everything GridContradicts)) Right onGrid
  where
    symbols = concatMap viewSymbols views
    everything = symbols ++ dissenters
    next = 1 + maximum (-1 : map readNumber everything)
    onGrid = do
      grid <- faceGrid (groups symbols)
      let (whole, parts) = withParts reader views next grid
      pure (GridReading everything dissenters parts whole (gridSkew angle grid))

-- | The settings that undo the mirroring of composites.
unmirroring :: [ForeignMasked] -> [Remedy]
unmirroring composites = case map maskedComposite composites of
  composite : _
    | null (compositeFrames composite) -> [remedy {remedyPositions = Nothing} | remedy <- found]
    | otherwise -> found
    where
      found = remedies (compositeConventions composite) straight (Just True)
  [] -> []
