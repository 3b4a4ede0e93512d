{-# OPTIONS_HADDOCK hide #-}

-- | The alternative layouts of the frames of composites, and what they take from an answer.
--
-- A layout w has a prior P(w), a likelihood by what the frames show ('compositeOthers'), and a
-- lattice with what the frames tell of its cells. The array weighs it once more: A(w) is how many
-- times as probable these cells are if they are the array's as by chance. With w = 0 for the layout
-- that is used, whose lattice the answer is of,
--
-- > odds(w) = P(w) / P(0) * likelihood(w) / likelihood(0) * A(w) / A(0)
-- > doubt = sum of odds(w) over w that show another place / sum of odds(w) over all w
--
-- That a layout's place is likelier beforehand speaks for the layout; that the answer's is does not
-- speak for the answer. A layout without a lattice shows nothing, and is asked no array.
module PraTactile.Recognise.Layouts
  ( layoutDoubts,
    likelierByFrames,
  )
where

import Data.List (find, inits, tails)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, listToMaybe)
import PraTactile.Array (Position)
import PraTactile.Composite (asTaken, compositeFrom, likeliestFault)
import PraTactile.Composite.Blend (Taxels, minus)
import PraTactile.Composite.Lattice
import PraTactile.Field (KnownField)
import PraTactile.Geometry (columnPitch, rotated, rowPitch)
import PraTactile.Recognise.FaceGrid
import PraTactile.Recognise.LatticeReading
import PraTactile.Recognise.Likeliest
import PraTactile.Recognise.Reading
import PraTactile.Recognise.Recogniser (Recogniser)
import PraTactile.Recognise.Recognition
import PraTactile.Recognise.SymbolBelief (axisOf)
import PraTactile.Recognise.Tolerance
import PraTactile.Registration
  ( Composite (..),
    Contradiction,
    Fault (..),
    Otherwise (..),
    PutFrame (..),
  )
import PraTactile.Segmentation.Lattice (Cell)
import PraTactile.Sensor.Manifest (standardTaking)
import PraTactile.Symmetry

-- | An alternative layout of composites of one face.
data Alternative = Alternative
  { alternativeFault :: !Fault,
    -- | its odds to the layout that is used, before the array is asked
    alternativeOdds :: !Double,
    -- | what the frames then show; 'Nothing' where they show nothing in common
    alternativeShown :: Maybe Laid
  }

-- | What symbols show in the cells of a layout.
data Laid = Laid
  { laidCells :: Cells,
    -- | rows and columns, from cell (0, 0), of points that are fixed to frames or to symbols
    laidPoints :: [(Double, Double)]
  }

-- | The prior odds of all faults of a kind together, where axes were stated or not. Of one frame
-- the frames tell all.
faultPrior :: Tolerance -> Bool -> Fault -> Double
faultPrior tolerance stated fault = case fault of
  OneFrame -> 1
  OtherAxes _ -> fromMaybe (if stated then 0.0025 else 0.01) (axesPrior tolerance)
  OtherScale _ _ -> 0.004
  Slip -> slipPrior tolerance
  Anywhere -> 0.002

-- | The alternatives of frames: of one composite by itself, or of all of them by one fault, with
-- the lattice of each composite where all have one.
alternatives :: Tolerance -> [Composite] -> [(Fault, Double, Maybe [Lattice])]
alternatives tolerance composites =
  [ (otherwiseFault other, oddsOf other, sequence (before ++ otherwiseLattice other : after))
    | (before, (composite, _), after) <- each,
      other <- compositeOthers composite,
      ofOne other
  ]
    ++ [ (fault, oddsOf other * product likelier / otherwiseLikelier other, sequence lattices)
         | other <- ofAll,
           let fault = otherwiseFault other,
           Just (likelier, lattices) <- [unzip <$> traverse (under fault) composites]
       ]
  where
    each =
      [ (map snd before, one, map snd after)
        | (before, one : after) <- splits [(c, compositeLattice c) | c <- composites]
      ]
    oddsOf other =
      faultPrior tolerance stated (otherwiseFault other)
        * otherwiseShare other
        * otherwiseLikelier other
    stated = any compositeAxesStated composites
    ofOne other = otherwiseFault other `elem` [OneFrame, Slip, Anywhere]
    -- As the first composite of several frames has them: one image alone would show the same.
    ofAll =
      concat . take 1 . filter (not . null) $
        map (filter (not . ofOne) . compositeOthers) composites
    under fault composite
      | length (compositeFrames composite) < 2 = Just (1, Nothing)
      | otherwise =
        (\other -> (otherwiseLikelier other, otherwiseLattice other))
          <$> find ((== fault) . otherwiseFault) (compositeOthers composite)

-- | What the layout that is used shows, as recognised, and the alternatives. Where composites have
-- lattices each alternative has another one, on which the frames are fixed points. Else symbols
-- are, which move with the composite that they were cut out of.
laidOut :: Tolerance -> [Composite] -> Recognition -> (Laid, [Alternative])
laidOut tolerance composites shown = case traverse compositeLattice composites of
  Just lattices@(_ : _) ->
    ( (laidBy lattices) {laidPoints = framesFrom (recognisedAnchor shown) lattices},
      [Alternative fault odds (laidBy <$> others) | (fault, odds, others) <- ofFrames]
        ++ [ slip (before ++ movedLattice (latticeStep lattice step) lattice : after)
             | (before@(_ : _), lattice : after) <- splits lattices,
               step <- cellSteps
           ]
    )
  _ ->
    ( onSymbols (recognisedCells shown),
      [Alternative fault odds Nothing | (fault, odds, _) <- ofFrames]
        ++ [ Alternative Slip slipOdds (Just (onSymbols (sourceMoved source step cells)))
             | (source, _) <- drop 1 (zip [0 ..] composites),
               step <- cellSteps
           ]
    )
  where
    cells = recognisedCells shown
    ofFrames = alternatives tolerance composites
    slipOdds = slipPrior tolerance / 4
    slip = Alternative Slip slipOdds . Just . laidBy
    laidBy lattices =
      let grid = latticesGrid composites shown lattices
       in Laid (gridCells grid) (framesFrom (gridAnchor grid) lattices)
    framesFrom anchor lattices =
      [ (y / rowPitch, x / columnPitch)
        | place <- concatMap latticeFrames lattices,
          let (x, y) = rotated (negate (gridAngle shown)) (place `minus` base) `minus` anchor
      ]
    base = maybe (0, 0) compositeFrom (listToMaybe composites)

-- | By how many degrees, clockwise, the rows of the recognised cells are turned.
gridAngle :: Recognition -> Double
gridAngle shown = degreesClockwise (axisOf (recognisedCells shown)) + recognisedTilt shown

-- | The cells of lattices under composites, of the axis of the recognised ones.
latticesGrid :: [Composite] -> Recognition -> [Lattice] -> FaceGrid
latticesGrid composites shown lattices =
  fromMaybe (FaceGrid Map.empty [] [] (0, 0)) $
    faceGrid
      [ cellsGroup (gridAngle shown) cells
        | cells <- numberCells (latticesRead (zip composites lattices)),
          cellsAxis cells == axisOf (recognisedCells shown)
      ]

-- | Cells with a point in each symbol, in the order of their numbers.
onSymbols :: Cells -> Laid
onSymbols cells =
  Laid cells . Map.elems . Map.fromList $
    [ (readNumber s, (fromIntegral i, fromIntegral j))
      | ((i, j), here) <- Map.toList cells,
        s <- here
    ]

-- | The cells where the symbols of one composite lie so many rows and columns further.
sourceMoved :: Int -> Cell -> Cells -> Cells
sourceMoved source (di, dj) cells =
  fromZero . Map.fromListWith (flip (++)) $
    [ (if readSource s == source then (i + di, j + dj) else (i, j), [s])
      | ((i, j), here) <- Map.toList cells,
        s <- here
    ]

-- | A list before and from each of its places on.
splits :: [a] -> [([a], [a])]
splits xs = zip (inits xs) (tails xs)

-- | What alternative layouts leave of an answer.
layoutDoubts ::
  KnownField k => Recogniser k -> Tolerance -> [Composite] -> Recognition -> Misplaced
layoutDoubts reader tolerance composites shown =
  Misplaced
    { oneMisplaced = share (== OneFrame),
      axesMisplaced = share (`notElem` [OneFrame, Slip]),
      slipped = share (== Slip),
      likelierLayout = named composites [(fault, odds) | (fault, odds, _) <- weighed]
    }
  where
    (used, others) = laidOut tolerance composites shown
    locatedIn = likeliestElsewhere reader tolerance . laidCells
    given = locatedIn used
    weighed = [(alternativeFault a, odds, differ) | a <- others, let (odds, differ) = weigh a]
    share kind = sum [odds | (fault, odds, True) <- weighed, kind fault] / total
    -- The layout that is used has odds of 1.
    total = 1 + sum [odds | (_, odds, _) <- weighed]
    weigh alternative = case alternativeShown alternative of
      Nothing -> (alternativeOdds alternative, True)
      Just laid
        | likeliestIn laid == likeliestIn used -> (alternativeOdds alternative, False)
        | otherwise ->
          ( alternativeOdds alternative * exp (max (-30) (min 30 likelier)),
            different laid there
          )
        where
          there = locatedIn laid
          likelier =
            maybe 0 likeliestEvidence there - maybe 0 likeliestEvidence given
              + max 0 (maybe 0 likeliestPrior there - maybe 0 likeliestPrior given)
    likeliestIn = Map.map (map readLikeliest) . laidCells
    -- Three quarters of the points at their places are the same answer.
    different laid there = case (recognisedLikeliest shown, there) of
      (Just this, Just that) ->
        4 * length (filter id (zipWith (samePlace this that) (laidPoints used) (laidPoints laid)))
          < 3 * length (laidPoints used)
      _ -> False
    samePlace this that point there =
      likeliestOrientation this == likeliestOrientation that
        && placeOf this cell == placeOf that (rounded (there `minus` (point `minus` exactly cell)))
      where
        cell = rounded point
    placeOf :: Likeliest -> Cell -> Maybe Position
    placeOf = likeliestAt reader
    rounded :: Taxels -> Cell
    rounded (i, j) = (round i, round j)
    exactly (i, j) = (fromIntegral i, fromIntegral j)

-- | The layout of all frames that they make more probable than the robot's, whatever the array
-- makes of it.
likelierByFrames :: Tolerance -> [Composite] -> Maybe Contradiction
likelierByFrames tolerance composites =
  named composites [(fault, odds) | (fault, odds, _) <- alternatives tolerance composites]

-- | The likeliest of some faults by their odds, if it is more probable than the robot's layout.
named :: [Composite] -> [(Fault, Double)] -> Maybe Contradiction
named composites weighed = asTaken taking Nothing <$> likeliestFault 1 places weighed
  where
    places = map putAt (concatMap compositeFrames composites)
    taking = maybe standardTaking compositeTaking (listToMaybe composites)
