{-# OPTIONS_HADDOCK hide #-}

-- | What composites show if their frames do not lie where the robot has them, and what that takes
-- from an answer: hypotheses beside the one that was put together, each with its probability
-- beforehand, its likelihood by overlaps and lattice, and by what the array makes of it.
--
-- If the robot is wrong as a whole, whole frames lie elsewhere, and the symbols that were read with
-- them. So each layout is weighed by the same symbols, with the same probabilities, in other cells:
-- none is likelier because more symbols can be read in it.
module PraTactile.Recognise.Elsewhere
  ( Elsewhere (..),
    putOtherwise,
    laidOtherwise,
    layoutDoubts,
    likelierByFrames,
  )
where

import Data.List (find, inits, minimumBy, sortOn, tails)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Ord (comparing)
import PraTactile.Composite (asTaken, contradictionBy)
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Field (KnownField)
import PraTactile.Geometry (columnPitch, rotated, rowPitch, taxelPitch)
import PraTactile.Image (rasterHeight, rasterSize, rasterWidth)
import PraTactile.Recognise.FaceGrid (Cells, fromZero)
import PraTactile.Recognise.GridLocation
import PraTactile.Recognise.Reading
import PraTactile.Recognise.Recogniser (Recogniser)
import PraTactile.Recognise.Recognition
import PraTactile.Recognise.SymbolBelief (axisOf)
import PraTactile.Registration
  ( Composite (..),
    Contradiction,
    Fault (..),
    Otherwise (..),
    PutFrame (..),
    compositePosition,
  )
import PraTactile.Registration.Layout (cellsAround, faultAt)
import PraTactile.Segmentation (SymbolImage (..))
import PraTactile.Sensor.Manifest (standardTaking)
import PraTactile.Symmetry

-- | Composites put together otherwise.
data Elsewhere = Elsewhere
  { elsewhereFault :: !Fault,
    -- | The probability of 'OneFrame'; the odds of any other fault against what was put together,
    -- before the array is asked.
    elsewhereOdds :: !Double,
    elsewhereComposites :: [Composite]
  }

-- | How probable faults of a kind are together beforehand, where axes were stated or not.
faultPrior :: Tolerance -> Bool -> Fault -> Double
faultPrior tolerance stated fault = case fault of
  OneFrame -> 1
  OtherAxes _ -> fromMaybe (if stated then 0.0025 else 0.01) (axesPrior tolerance)
  OtherScale _ _ -> 0.004
  Slip -> slipPrior tolerance
  Anywhere -> 0.002

-- | The composites of one face put together otherwise, given by how many degrees the symbols are
-- turned in them: one of them with one frame elsewhere or with a slip in it; one of them but the
-- first a whole cell away from where the robot has it; or all of them along other axes, or at
-- another scale.
putOtherwise :: Tolerance -> Double -> [Composite] -> [Elsewhere]
putOtherwise tolerance angle composites =
  [ elsewhereBy other (before ++ otherwiseComposite other : after)
    | (before, composite, after) <- each,
      other <- compositeOthers composite,
      ofOne other
  ]
    ++ [ Elsewhere Slip (slipPrior tolerance / 4) (before ++ moved cell composite : after)
         | (before@(_ : _), composite, after) <- each,
           cell <- cellsAround angle
       ]
    ++ [ elsewhereBy other {otherwiseLikelier = product likelier} there
         | other <- ofAll,
           Just (likelier, there) <- [unzip <$> traverse (under (otherwiseFault other)) composites]
       ]
  where
    each =
      [ (before, one, after)
        | (before, one : after) <- zip (inits composites) (tails composites)
      ]
    elsewhereBy (Otherwise fault share likelier _) =
      Elsewhere fault (faultPrior tolerance stated fault * share * likelier)
    stated = any compositeAxesStated composites
    ofOne other = otherwiseFault other `elem` [OneFrame, Slip, Anywhere]
    -- As the first composite of several frames has them: one image alone would show the same.
    ofAll =
      concat . take 1 . filter (not . null) $
        map (filter (not . ofOne) . compositeOthers) composites
    moved (i, j) = movedBy (taxelPitch * i, taxelPitch * j)
    under fault composite
      | length (compositeDisplacements composite) < 2 = Just (1, displaced fault composite)
      | otherwise =
        (\other -> (otherwiseLikelier other, otherwiseComposite other))
          <$> find ((== fault) . otherwiseFault) (compositeOthers composite)

-- | One image, whose centre lies elsewhere by a fault.
displaced :: Fault -> Composite -> Composite
displaced fault composite = movedBy (x' - left - halfWidth, y' - top - halfHeight) composite
  where
    (left, top) = compositeOrigin composite
    (w, h) = rasterSize (compositeImage composite)
    (halfWidth, halfHeight) = (half w, half h)
    half side = taxelPitch * fromIntegral (side - 1) / 2
    (x', y') = faultAt fault (left + halfWidth, top + halfHeight)

-- | A composite and its frames that many millimetres right and down.
movedBy :: (Double, Double) -> Composite -> Composite
movedBy (dx, dy) composite =
  composite
    { compositeOrigin = moved (compositeOrigin composite),
      compositeFrames = [f {putAt = moved (putAt f)} | f <- compositeFrames composite]
    }
  where
    moved (x, y) = (x + dx, y + dy)

-- | The cells of the symbols that were read in composites, if these lie as in others: each moves
-- with the frame that felt most of it. Given is by how many degrees the symbols are turned.
laidOtherwise :: Double -> [Composite] -> [Composite] -> Cells -> Cells
laidOtherwise angle composites others cells =
  fromZero . Map.fromListWith (flip (++)) $
    [(moved cell (moveOf s), [s]) | (cell, here) <- Map.toList cells, s <- here]
  where
    pairs = zip composites others
    moveOf s = case drop (readSource s) pairs of
      (own, other) : _ -> moveIn own other s
      [] -> (0, 0)
    -- From the first symbol, by whole cells, as the lattice has it.
    (baseX, baseY) = maybe (0, 0) moveOf (listToMaybe (concat (Map.elems cells)))
    moved (i, j) (x, y) = (i + cellsIn rowPitch down, j + cellsIn columnPitch across)
      where
        (across, down) =
          onOffset (invert (axisOf cells)) (rotated (negate angle) (x - baseX, y - baseY))
    cellsIn pitch t = round (t / pitch)

-- | By how much a symbol of a composite lies further right and down in another one, taxels.
moveIn :: Composite -> Composite -> ReadSymbol -> Taxels
moveIn own other s = case zip (compositeFrames own) (compositeFrames other) of
  [] -> apart (compositeOrigin own) (compositeOrigin other)
  both -> let (a, b) = minimumBy (comparing (off . fst)) both in apart (liesAt a) (liesAt b)
  where
    apart (x, y) (x', y') = ((x' - x) / taxelPitch, (y' - y) / taxelPitch)
    (atX, atY) = compositePosition own (symbolCentre (readImage s))
    liesAt (PutFrame (x, y) (dx, dy) _ _) = (x + taxelPitch * dx, y + taxelPitch * dy)
    -- How far the symbol's centre is from the frame, and then from the frame's centre by its sides.
    off frame =
      let (x, y) = liesAt frame
          (beyondX, fromX) = along atX x (rasterWidth (putImage frame))
          (beyondY, fromY) = along atY y (rasterHeight (putImage frame))
       in (beyondX * beyondX + beyondY * beyondY, max fromX fromY)
    along :: Double -> Double -> Int -> (Double, Double)
    along at from side =
      let t = abs ((at - from) / taxelPitch - fromIntegral (side - 1) / 2)
       in (max 0 (t - fromIntegral side / 2), t / fromIntegral side)

-- | What layouts leave of an answer, given how likely it is that one frame lies elsewhere, and by
-- how many degrees the symbols are turned.
layoutDoubts ::
  KnownField k =>
  Recogniser k ->
  Tolerance ->
  [Composite] ->
  Recognition ->
  Double ->
  [Elsewhere] ->
  Misplaced
layoutDoubts reader tolerance composites shown oneFrame others =
  Misplaced oneFrame (share (/= Slip)) (share (== Slip)) likelier
  where
    likelier = likeliestFault composites [(fault, odds) | (fault, odds, _) <- weighed]
    cells = recognisedCells shown
    given = recognisedLikeliest shown
    weighed =
      [ (elsewhereFault other, odds, differ)
        | other <- others,
          let (odds, differ) = weigh other
      ]
    share kind = sum [odds | (fault, odds, True) <- weighed, kind fault] / total
    -- That what was put together is right has odds of 1.
    total = 1 + sum [odds | (_, odds, _) <- weighed]
    weigh other
      -- Frames that lie anywhere show nothing together.
      | elsewhereFault other == Anywhere = (elsewhereOdds other, True)
      | relaid == cellsOf cells = (elsewhereOdds other, False)
      | otherwise = (elsewhereOdds other * exp (max (-30) (min 30 likelierThere)), different)
      where
        laid = laidOtherwise (recognisedTilt shown) composites (elsewhereComposites other) cells
        relaid = cellsOf laid
        there = likeliestElsewhere reader tolerance laid
        likelierThere =
          maybe 0 likeliestEvidence there - maybe 0 likeliestEvidence given
            + max 0 (prior there - prior given)
        -- That the other place is likelier beforehand speaks for its layout; that the answer's is
        -- does not speak for the answer.
        prior = maybe 0 likeliestPrior
        (these, those) = (places given, places there)
        same = Map.filter id (Map.intersectionWith (==) these those)
        -- Three quarters of the symbols at their places are the same answer.
        different = 4 * Map.size same < 3 * Map.size these
    places = maybe Map.empty likeliestPlaces
    cellsOf = Map.map (map readNumber)

-- | The layout of all frames that they make more probable than the robot's, whatever the array
-- makes of it; given by how many degrees the symbols are turned.
likelierByFrames :: Tolerance -> Double -> [Composite] -> Maybe Contradiction
likelierByFrames tolerance angle composites =
  likeliestFault
    composites
    [(elsewhereFault e, elsewhereOdds e) | e <- putOtherwise tolerance angle composites]

-- | The likeliest of some faults, by their odds against the robot's layout, if it is more probable
-- than that. One that is not far more probable than the robot's and all others says only that the
-- frames lie anywhere.
likeliestFault :: [Composite] -> [(Fault, Double)] -> Maybe Contradiction
likeliestFault composites weighed = case sortOn (negate . snd) (filter ofAll weighed) of
  (fault, odds) : rest
    | odds > 1 -> asTaken taking Nothing <$> contradictionBy places named
    where
      named = if all ((odds >) . (farMore *)) (1 : map snd rest) then fault else Anywhere
  _ -> Nothing
  where
    farMore = 1e4
    places = map putAt (concatMap compositeFrames composites)
    ofAll (fault, _) = fault `notElem` [OneFrame, Slip]
    taking = maybe standardTaking compositeTaking (listToMaybe composites)
