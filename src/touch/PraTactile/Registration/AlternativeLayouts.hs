{-# OPTIONS_HADDOCK hide #-}

-- | Alternative layouts of frames, with their likelihood ratios to the layout in use: other axes,
-- other scales, slips by a cell, frames that lie anywhere, or one frame elsewhere.
module PraTactile.Registration.AlternativeLayouts
  ( alternativesOnLattice,
    alternativesByPairs,
  )
where

import PraTactile.Composite (AlternativeLayout (..), LayoutCause (..))
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
import PraTactile.Registration.Overlap (ReliefModel)
import PraTactile.Registration.Scale (likelyScales)
import PraTactile.Registration.Settings (Registration)

-- | Alternative layouts that frames on a lattice do not refute. Given are the fits, the origin of
-- the frames' places in the robot's coordinates, the frames, and their registration.
alternativesOnLattice ::
  Registration -> Fits -> Taxels -> [(Taxels, Touched)] -> Joint -> [AlternativeLayout]
alternativesOnLattice settings fits robot touched found =
  [AlternativeLayout OneFrame 1 odds (Just lattice) | (odds, lattice) <- oneElsewhere found]
    ++ [ AlternativeLayout
           (layoutCause layout)
           (layoutShare layout)
           (exp (min mostLog likelier))
           lattice
         | layout <- layouts scales (tiedGroups found) (map (plus robot . fst) touched),
           let (likelier, lattice) = weighed layout,
           likelier > refuted
       ]
  where
    weighed layout = case layoutCause layout of
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
        byPhase = jointQuickLog there - jointQuickLog here
        there = registered (spacedOut framesOfLayout lying)
    scales
      | maybe False (> largeError) (jointSigma found) =
        likelyScales
          (jointQuickLog . registered . spacedOut scaleFrames . lyingAt)
          (map fst touched)
      | otherwise = []
    registered lying =
      registerJointly settings fits {fitsFrames = map snd lying} (map fst lying)
    lyingAt places = zip (zip places (map snd touched)) (fitsFrames fits)
    -- Of very many frames, some stand for all.
    few = length touched <= framesOfLayout
    here = if few then found else registered (spacedOut framesOfLayout (lyingAt (map fst touched)))

-- | Alternative layouts that the overlaps of frames do not refute. Without a lattice, what the
-- frames would show there is unknown.
alternativesByPairs ::
  Registration ->
  ReliefModel ->
  Taxels ->
  [(Taxels, Raster)] ->
  [AlternativeLayout]
alternativesByPairs settings relief robot frames =
  [ AlternativeLayout (layoutCause layout) (layoutShare layout) (exp likelier) Nothing
    | layout <- layouts [] (map (const 0) frames) (map (plus robot . fst) frames),
      layoutCause layout /= Slip,
      let likelier = min (most (layoutCause layout)) (evidence layout - asTold),
      likelier > refuted
  ]
  where
    -- A scale changes which frames overlap, and smooth relief fits any other, so overlaps cannot
    -- favour one.
    most cause = case cause of
      OtherScale _ _ -> 0
      _ -> mostLog
    asTold = told (map fst frames)
    evidence layout
      | layoutCause layout == Anywhere = 0
      | otherwise = told (map (`minus` robot) (layoutPlaces layout))
    told = pairsEvidence settings relief . (`zip` map snd frames)
