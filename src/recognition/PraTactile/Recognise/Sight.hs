{-# LANGUAGE MultiWayIf #-}
{-# OPTIONS_HADDOCK hide #-}

-- | What composites of one face show before the array and the objects are asked: symbols, and parts
-- of symbols beside them, on one grid.
module PraTactile.Recognise.Sight
  ( Sight (..),
    Reading (..),
    Look (..),
    sight,
    bySegmentation,
  )
where

import Data.List (partition)
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust, isNothing)
import PraTactile.Classification.Network (NetworkError)
import PraTactile.Classification.Reader (Reader)
import PraTactile.Composite.Lattice (Lattice)
import PraTactile.Composite.Tilt (leastTilt, setUpright, tilt)
import PraTactile.Recognise.FaceGrid
import PraTactile.Recognise.LatticeReading
import PraTactile.Recognise.Parts
import PraTactile.Recognise.Reading
import PraTactile.Recognise.Recognition
import PraTactile.Registration (Composite (..))
import PraTactile.Segmentation (Cleaned (..), Reject, Segmentation (..), cleaned)
import PraTactile.Sensor.Manifest (Remedy (..), remedies, straight)
import PraTactile.Symmetry

-- | What composites of one face show, before the array and the objects are asked.
data Sight = Sight
  { -- | what in the composites is none of the symbols'
    sightForeign :: [Reject],
    -- | the composites as they are
    sightAsGiven :: Reading,
    -- | where the symbols are not nearly upright by their 'tilt': that angle, where places of the
    -- composites set upright by it are on those given, and the composites so set upright
    sightUpright :: Maybe (Double, [(Double, Double) -> (Double, Double)], Reading)
  }

-- | Composites read along the axis of most symbols.
data Reading = Reading
  { -- | what is no complete symbol, in the composites' pixels
    readingRejects :: [Reject],
    -- | the symbols, or why they are not located
    readingLook :: Either Recognition Look
  }

-- | Symbols and parts on one grid.
data Look = Look
  { lookSymbols :: [ReadSymbol],
    -- | those of the other axis that the network knows all the same
    lookDissenters :: [ReadSymbol],
    lookParts :: [ReadSymbol],
    -- | with the parts in it
    lookGrid :: FaceGrid,
    lookTilt :: Double
  }

-- | Read the symbols of composites of one face: in the cells of the lattices that registration
-- found under all of them, else as the paper does, by segmentation. Refuses only what the network
-- refuses.
sight :: Reader -> [Composite] -> Either NetworkError Sight
sight reader given = case traverse compositeLattice given of
  Just lattices@(_ : _) -> inLattices reader (zip given lattices)
  _ -> bySegmentation reader given

-- | Composites read by segmentation.
bySegmentation :: Reader -> [Composite] -> Either NetworkError Sight
bySegmentation reader given = case tilt (map cleanedComposite composites) of
  Just angle
    | abs angle > leastTilt -> do
      asGiven <- lookUpright reader Nothing composites
      let (upright, places) = unzip (map (cleanedUpright angle) composites)
      turnedBack <- lookUpright reader (Just 0) upright
      pure (Sight foreignThings asGiven (Just (angle, places, turnedBack)))
  shown -> (\asGiven -> Sight foreignThings asGiven Nothing) <$> lookUpright reader shown composites
  where
    composites = map cleaned given
    foreignThings = concatMap cleanedRejects composites

-- | 'setUpright' of a composite without what is foreign.
cleanedUpright :: Double -> Cleaned -> (Cleaned, (Double, Double) -> (Double, Double))
cleanedUpright angle (Cleaned composite forParts foreignThings) =
  (Cleaned upright (fst . setUpright angle <$> forParts) foreignThings, back)
  where
    (upright, back) = setUpright angle composite

-- | Composites read in the cells of their lattices.
inLattices :: Reader -> [(Composite, Lattice)] -> Either NetworkError Sight
inLattices reader given = do
  found <-
    sequence
      [ readCells reader (composite, clean) lattice cells
        | ((composite, lattice), clean, cells) <- zip3 given composites (latticesRead given)
      ]
  let numberedCells = numberCells found
      (own, others) = partition ((== axis) . cellsAxis) numberedCells
      symbols = concatMap wholeIn numberedCells
      look =
        case faceGrid (map (cellsGroup angle) own) of
          Just grid ->
            Right
              Look
                { lookSymbols = symbols,
                  lookDissenters = known (concatMap wholeIn others),
                  lookParts = concatMap (filter ((< 1) . readSeen) . Map.elems . cellsSymbols) own,
                  lookGrid = grid,
                  lookTilt = tilted
                }
          Nothing -> Left (unanswered symbols GridContradicts)
  isMirrored <- if null (known symbols) then cellsMirrored reader symbols else pure False
  pure . (\shown -> Sight foreignThings (Reading [] shown) Nothing) $
    if
        | isMirrored -> Left (unanswered symbols (Mirrored (unmirroring composites)))
        | null symbols -> Left (unanswered symbols NoSymbols)
        | null (known symbols) -> Left (unanswered symbols SymbolsUnclear)
        | otherwise -> look
  where
    composites = map (cleaned . fst) given
    foreignThings = concatMap cleanedRejects composites
    (axis, tilted) = axisOfAll (map snd given)
    angle = degreesClockwise axis + tilted
    known = filter (isJust . readClass)
    wholeIn = filter ((>= 1) . readSeen) . Map.elems . cellsSymbols

-- | What composites show whose symbols' axes are nearly theirs: turned from them by the angle, in
-- degrees clockwise, as far as the images show it.
lookUpright :: Reader -> Maybe Double -> [Cleaned] -> Either NetworkError Reading
lookUpright reader angle composites = do
  upright <- readSymbols reader identity 0 composites
  -- A composite whose upright symbols are known has no others, and one that is flat has none.
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
  pure . Reading (concatMap viewRejects views) $
    if isMirrored
      then Left (unanswered (concatMap viewSymbols views ++ known others) (Mirrored remedy))
      else onOneGrid reader angle views (known others)
  where
    remedy = unmirroring composites
    known = filter (isJust . readClass) . concatMap viewSymbols

-- | The symbols of one axis, with parts beside them, on one grid; and what the network knows of the
-- other axis.
onOneGrid :: Reader -> Maybe Double -> [View] -> [ReadSymbol] -> Either Recognition Look
onOneGrid reader angle views dissenters
  | null symbols = Left (unanswered everything NoSymbols)
  | all (isNothing . readClass) symbols = Left (unanswered everything SymbolsUnclear)
  | otherwise = maybe (Left (unanswered everything GridContradicts)) Right look
  where
    symbols = concatMap viewSymbols views
    everything = symbols ++ dissenters
    next = 1 + maximum (-1 : map readNumber everything)
    look = do
      grid <- faceGrid (groups symbols)
      let (whole, parts) = withParts reader views next grid
      pure (Look everything dissenters parts whole (gridTilt angle grid))

-- | What undoes the mirroring of composites.
unmirroring :: [Cleaned] -> [Remedy]
unmirroring composites = case map cleanedComposite composites of
  composite : _
    | null (compositeFrames composite) -> [remedy {remedyPositions = Nothing} | remedy <- found]
    | otherwise -> found
    where
      found = remedies (compositeTaking composite) straight (Just True)
  [] -> []
