{-# OPTIONS_HADDOCK hide #-}

-- | The alternative layouts of the frames of composites, and the doubt that they add to an answer.
--
-- A layout w has a prior P(w), a likelihood by the frames ('compositeAlternatives'), and a lattice
-- of cells. The array adds an evidence A(w): the likelihood ratio of these cells being the array's
-- to their being random. The layout in use is w = 0; the answer comes from its lattice.
--
-- > odds(w) = P(w) / P(0) * likelihood(w) / likelihood(0) * A(w) / A(0)
-- > doubt = sum of odds(w) over w that show another place / sum of odds(w) over all w
--
-- The prior of an alternative's place counts for the alternative when it is the greater one. The
-- prior of the answer's place does not count for the answer. A layout without a lattice gets no
-- evidence from the array and counts as showing another place.
module PraTactile.Recognise.Layouts
  ( layoutDoubts,
    likelierByFrames,
  )
where

import Data.List (find, inits, tails)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, listToMaybe)
import PraTactile.Array (Position)
import PraTactile.Composite (asTaken, compositeFrom, likeliestCause)
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
  ( AlternativeLayout (..),
    Composite (..),
    CompositeFrame (..),
    Contradiction,
    LayoutCause (..),
  )
import PraTactile.Segmentation.Lattice (ClusterCell)
import PraTactile.Sensor.Manifest (standardConventions)
import PraTactile.Symmetry

-- | An alternative layout of the composites of one face.
data WeighedLayout = WeighedLayout
  { weighedCause :: !LayoutCause,
    -- | its odds relative to the layout in use, before the array's evidence
    weighedOdds :: !Double,
    -- | the cells that the frames then show; 'Nothing' if they have no lattice
    weighedShown :: Maybe Laid
  }

-- | The cells that a layout shows.
data Laid = Laid
  { laidCells :: Cells,
    -- | points fixed to frames or symbols, in rows and columns from cell (0, 0)
    laidPoints :: [(Double, Double)]
  }

-- | The prior odds of all faults of one kind together. The second argument says whether the axes
-- were stated. A single misplaced frame has odds 1, because its likelihood includes the prior.
causePrior :: Tolerance -> Bool -> LayoutCause -> Double
causePrior tolerance stated cause = case cause of
  OneFrame -> 1
  OtherAxes _ -> fromMaybe (if stated then 0.0025 else 0.01) (axesPrior tolerance)
  OtherScale _ _ -> 0.004
  Slip -> slipPrior tolerance
  Anywhere -> 0.002

-- | The alternatives that the frames suggest: of one composite alone, or of all composites by one
-- fault. Each has its fault, its odds, and the lattices of all composites if all have one.
alternatives :: Tolerance -> [Composite] -> [(LayoutCause, Double, Maybe [Lattice])]
alternatives tolerance composites =
  [ (alternativeCause other, oddsOf other, sequence (before ++ alternativeLattice other : after))
    | (before, (composite, _), after) <- each,
      other <- compositeAlternatives composite,
      ofOne other
  ]
    ++ [ (cause, oddsOf other * product likelier / alternativeRatio other, sequence lattices)
         | other <- ofAll,
           let cause = alternativeCause other,
           Just (likelier, lattices) <- [unzip <$> traverse (under cause) composites]
       ]
  where
    each =
      [ (map snd before, one, map snd after)
        | (before, one : after) <- splits [(c, compositeLattice c) | c <- composites]
      ]
    oddsOf other =
      causePrior tolerance stated (alternativeCause other)
        * alternativeShare other
        * alternativeRatio other
    stated = any compositeAxesStated composites
    ofOne other = alternativeCause other `elem` [OneFrame, Slip, Anywhere]
    -- Taken from the first composite that has several frames: one image alone shows no fault.
    ofAll =
      concat . take 1 . filter (not . null) $
        map (filter (not . ofOne) . compositeAlternatives) composites
    under cause composite
      | length (compositeFrames composite) < 2 = Just (1, Nothing)
      | otherwise =
        (\other -> (alternativeRatio other, alternativeLattice other))
          <$> find ((== cause) . alternativeCause) (compositeAlternatives composite)

-- | The cells of the layout in use and the alternatives. Where all composites have lattices, an
-- alternative has other lattices, and its fixed points are the frames. Otherwise the fixed points
-- are the symbols, which move with the composite that they were cut out of.
laidOut :: Tolerance -> [Composite] -> Recognition -> (Laid, [WeighedLayout])
laidOut tolerance composites shown = case traverse compositeLattice composites of
  Just lattices@(_ : _) ->
    ( (laidBy lattices) {laidPoints = framesFrom (recognisedAnchor shown) lattices},
      [WeighedLayout cause odds (laidBy <$> others) | (cause, odds, others) <- ofFrames]
        ++ [ slip (before ++ movedLattice (latticeStep lattice step) lattice : after)
             | (before@(_ : _), lattice : after) <- splits lattices,
               step <- cellSteps
           ]
    )
  _ ->
    ( onSymbols (recognisedCells shown),
      [WeighedLayout cause odds Nothing | (cause, odds, _) <- ofFrames]
        ++ [ WeighedLayout Slip slipOdds (Just (onSymbols (sourceMoved source step cells)))
             | (source, _) <- drop 1 (zip [0 ..] composites),
               step <- cellSteps
           ]
    )
  where
    cells = recognisedCells shown
    ofFrames = alternatives tolerance composites
    slipOdds = slipPrior tolerance / 4
    slip = WeighedLayout Slip slipOdds . Just . laidBy
    laidBy lattices =
      let grid = latticesGrid composites shown lattices
       in Laid (gridCells grid) (framesFrom (gridAnchor grid) lattices)
    framesFrom anchor lattices =
      [ (y / rowPitch, x / columnPitch)
        | place <- concatMap latticeFrames lattices,
          let (x, y) = rotated (negate (gridAngle shown)) (place `minus` base) `minus` anchor
      ]
    base = maybe (0, 0) compositeFrom (listToMaybe composites)

-- | The angle of the rows of the recognised cells, in degrees clockwise.
gridAngle :: Recognition -> Double
gridAngle shown = degreesClockwise (axisOf (recognisedCells shown)) + recognisedSkew shown

-- | The grid of the lattices' cells along the axis of the recognised ones.
latticesGrid :: [Composite] -> Recognition -> [Lattice] -> FaceGrid
latticesGrid composites shown lattices =
  fromMaybe (FaceGrid Map.empty [] [] (0, 0)) $
    faceGrid
      [ cellsGroup (gridAngle shown) cells
        | cells <- numberCells (latticesRead (zip composites lattices)),
          cellsAxis cells == axisOf (recognisedCells shown)
      ]

-- | Cells, with a point in each symbol in the order of their numbers.
onSymbols :: Cells -> Laid
onSymbols cells =
  Laid cells . Map.elems . Map.fromList $
    [ (readNumber s, (fromIntegral i, fromIntegral j))
      | ((i, j), here) <- Map.toList cells,
        s <- here
    ]

-- | The cells after the symbols of one composite are moved by this many rows and columns.
sourceMoved :: Int -> ClusterCell -> Cells -> Cells
sourceMoved source (di, dj) cells =
  fromZero . Map.fromListWith (flip (++)) $
    [ (if readSource s == source then (i + di, j + dj) else (i, j), [s])
      | ((i, j), here) <- Map.toList cells,
        s <- here
    ]

-- | All ways to split a list in two: the part before, and the rest.
splits :: [a] -> [([a], [a])]
splits xs = zip (inits xs) (tails xs)

-- | The doubt that alternative layouts add to an answer, by kind of fault.
layoutDoubts ::
  KnownField k => Recogniser k -> Tolerance -> [Composite] -> Recognition -> LayoutDoubts
layoutDoubts reader tolerance composites shown =
  LayoutDoubts
    { layoutDoubtOfFrame = share (== OneFrame),
      layoutDoubtOfAxes = share (`notElem` [OneFrame, Slip]),
      layoutDoubtOfSlip = share (== Slip),
      likelierLayout = named composites [(cause, odds) | (cause, odds, _) <- weighed]
    }
  where
    (used, others) = laidOut tolerance composites shown
    locatedIn = likeliestElsewhere reader tolerance . laidCells
    given = locatedIn used
    weighed = [(weighedCause a, odds, differ) | a <- others, let (odds, differ) = weigh a]
    share kind = sum [odds | (cause, odds, True) <- weighed, kind cause] / total
    -- The layout in use has odds of 1.
    total = 1 + sum [odds | (_, odds, _) <- weighed]
    weigh alternative = case weighedShown alternative of
      Nothing -> (weighedOdds alternative, True)
      Just laid
        | likeliestIn laid == likeliestIn used -> (weighedOdds alternative, False)
        | otherwise ->
          ( weighedOdds alternative * exp (max (-30) (min 30 likelier)),
            different laid there
          )
        where
          there = locatedIn laid
          likelier =
            maybe 0 likeliestEvidence there - maybe 0 likeliestEvidence given
              + max 0 (maybe 0 likeliestPrior there - maybe 0 likeliestPrior given)
    likeliestIn = Map.map (map readLikeliest) . laidCells
    -- Layouts give the same answer if three quarters of the points stay at their places.
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
    placeOf :: Likeliest -> ClusterCell -> Maybe Position
    placeOf = likeliestAt reader
    rounded :: Taxels -> ClusterCell
    rounded (i, j) = (round i, round j)
    exactly (i, j) = (fromIntegral i, fromIntegral j)

-- | The layout of all frames that is more probable than the robot's by the frames alone. 'Nothing'
-- if there is none.
likelierByFrames :: Tolerance -> [Composite] -> Maybe Contradiction
likelierByFrames tolerance composites =
  named composites [(cause, odds) | (cause, odds, _) <- alternatives tolerance composites]

-- | The likeliest of some faults by their odds, if it is more probable than the robot's layout.
named :: [Composite] -> [(LayoutCause, Double)] -> Maybe Contradiction
named composites weighed = asTaken taking Nothing <$> likeliestCause 1 places weighed
  where
    places = map compositeFrameAt (concatMap compositeFrames composites)
    taking = maybe standardConventions compositeConventions (listToMaybe composites)
