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
import PraTactile.Registration.Agreement (evidenceAt)
import PraTactile.Registration.Alternatives
import PraTactile.Registration.Joint
import PraTactile.Registration.Lattice.Fit (Fits (..), Touched)
import PraTactile.Registration.Layout
import PraTactile.Registration.Scale (likelyScales)
import PraTactile.Registration.Search (Registration)

-- | The alternative layouts that frames on a lattice do not refute, given where the places of the
-- frames count from in the robot's coordinates, and how the frames were found.
othersOnLattice ::
  Registration -> Fits -> Taxels -> [(Taxels, Touched)] -> Joint -> [Otherwise]
othersOnLattice settings fits robot touched found =
  [Otherwise OneFrame 1 odds (Just lattice) | (odds, lattice) <- oneElsewhere found]
    ++ [ Otherwise (layoutFault layout) (layoutShare layout) (exp (min certain likelier)) lattice
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
        there = registered (spacedOut mostOfLayout lying)
    scales
      | maybe False (> largeError) (jointSigma found) =
        likelyScales (jointGlimpse . registered . spacedOut scaleFrames . lyingAt) (map fst touched)
      | otherwise = []
    registered lying =
      registerJointly settings fits {fitsFrames = map snd lying} (map fst lying)
    lyingAt places = zip (zip places (map snd touched)) (fitsFrames fits)
    -- By some of the frames, where there are very many.
    few = length touched <= mostOfLayout
    here = if few then found else registered (spacedOut mostOfLayout (lyingAt (map fst touched)))

-- | The alternative layouts that the overlaps of frames do not refute. Where there is no lattice it
-- is not known what the frames then show.
othersByPairs :: Registration -> Taxels -> [(Taxels, Raster)] -> [Otherwise]
othersByPairs settings robot frames =
  [ Otherwise (layoutFault layout) (layoutShare layout) (exp likelier) Nothing
    | (layout, likelier) <- zip known (evidenceAt settings frames (map placesOf known)),
      likelier > refuted
  ]
  where
    known =
      [ layout
        | layout <- layouts [] (map (const 0) frames) (map (plus robot . fst) frames),
          layoutFault layout /= Slip
      ]
    placesOf = map (`minus` robot) . layoutPlaces

-- | So that products of likelihood ratios are numbers.
certain :: Double
certain = 300

-- | The most frames that are asked where all may lie instead.
mostOfLayout :: Int
mostOfLayout = 256

-- | The position error, taxels, beyond which the frames are asked for another scale.
largeError :: Double
largeError = 1.5

-- | The most frames that are asked for a scale.
scaleFrames :: Int
scaleFrames = 32

-- | A layout whose lattice is less likely by this log ratio is not asked for the symbols.
hopeless :: Double
hopeless = -30
