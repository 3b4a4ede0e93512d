{-# OPTIONS_HADDOCK hide #-}

-- | The alternative layouts of frames, with their likelihood ratios to the layout that is used:
-- other axes, other scales, slips by a cell, frames that lie anywhere, or one frame elsewhere.
module PraTactile.Registration.Others
  ( othersOnLattice,
    othersByPairs,
  )
where

import PraTactile.Composite (Fault (..), Otherwise (..))
import PraTactile.Composite.Blend (Taxels, minus, plus)
import PraTactile.Composite.Noise (spacedOut)
import PraTactile.Image (Raster)
import PraTactile.Registration.AllPairs (pairsEvidence)
import PraTactile.Registration.Alternatives
import PraTactile.Registration.Joint
import PraTactile.Registration.Lattice.Fit (Fits (..), Touched)
import PraTactile.Registration.Layout
import PraTactile.Registration.Numbers
  ( framesOfLayout,
    hopeless,
    largeError,
    mostLog,
    refuted,
    scaleFrames,
  )
import PraTactile.Registration.Overlap (Relief)
import PraTactile.Registration.Scale (likelyScales)
import PraTactile.Registration.Settings (Registration)

-- | The alternative layouts that frames on a lattice do not refute, given where the places of the
-- frames count from in the robot's coordinates, and how the frames were found.
othersOnLattice ::
  Registration -> Fits -> Taxels -> [(Taxels, Touched)] -> Joint -> [Otherwise]
othersOnLattice settings fits robot touched found =
  [Otherwise OneFrame 1 odds (Just lattice) | (odds, lattice) <- oneElsewhere found]
    ++ [ Otherwise (layoutFault layout) (layoutShare layout) (exp (min mostLog likelier)) lattice
         | layout <- layouts scales (tiedGroups found) (map (plus robot . fst) touched),
           let (likelier, lattice) = weighed layout,
           likelier > refuted
       ]
  where
    weighed layout = case layoutFault layout of
      Anywhere -> (jointAnywhere here - jointEvidence here, Nothing)
      Slip -> Just <$> slipped found (layoutSteps layout)
      _ -> laid (lyingAt (map (`minus` robot) (layoutPlaces layout)))
    laid lying
      | byPhase < hopeless = (byPhase, Nothing)
      | otherwise =
        ( jointBound there - jointBound here,
          Just (jointLattice (if few then there else registered lying))
        )
      where
        byPhase = jointGlimpse there - jointGlimpse here
        there = registered (spacedOut framesOfLayout lying)
    scales
      | maybe False (> largeError) (jointSigma found) =
        likelyScales (jointGlimpse . registered . spacedOut scaleFrames . lyingAt) (map fst touched)
      | otherwise = []
    registered lying =
      registerJointly settings fits {fitsFrames = map snd lying} (map fst lying)
    lyingAt places = zip (zip places (map snd touched)) (fitsFrames fits)
    -- By some of the frames, where there are very many.
    few = length touched <= framesOfLayout
    here = if few then found else registered (spacedOut framesOfLayout (lyingAt (map fst touched)))

-- | The alternative layouts that the overlaps of frames do not refute. Where there is no lattice it
-- is not known what the frames then show.
othersByPairs :: Registration -> Relief -> Taxels -> [(Taxels, Raster)] -> [Otherwise]
othersByPairs settings relief robot frames =
  [ Otherwise (layoutFault layout) (layoutShare layout) (exp likelier) Nothing
    | layout <- layouts [] (map (const 0) frames) (map (plus robot . fst) frames),
      layoutFault layout /= Slip,
      let likelier = min (most (layoutFault layout)) (evidence layout - asTold),
      likelier > refuted
  ]
  where
    -- A scale changes how many frames overlap, and smooth relief agrees with any other.
    most fault = case fault of
      OtherScale _ _ -> 0
      _ -> mostLog
    asTold = told (map fst frames)
    evidence layout
      | layoutFault layout == Anywhere = 0
      | otherwise = told (map (`minus` robot) (layoutPlaces layout))
    told = pairsEvidence settings relief . (`zip` map snd frames)
