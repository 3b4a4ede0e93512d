-- | Many frames registered to one lattice of cells: where the lattice lies is found from all of
-- them, each frame's displacement from the lattice and from the symbols that the other frames saw
-- in the cells that it sees. The array is not known here.
--
-- The cost is linear in the frames: the lattice's phase is found from at most @phaseFrames@ of
-- them, and of each frame only the displacements that may matter are kept.
module PraTactile.Registration.Joint
  ( Located (..),
    registerJointly,
  )
where

import Data.List (sortOn)
import PraTactile.Composite.Blend (Place)
import PraTactile.Composite.Spaced (spacedOut)
import PraTactile.Image (Raster, rasterSize, rasterValues)
import PraTactile.Registration.Joint.Consensus (swept)
import PraTactile.Registration.Joint.Grid (gridOf)
import PraTactile.Registration.Joint.Located
import PraTactile.Registration.Joint.Option (Option (..), optionsOf)
import PraTactile.Registration.Joint.Phase (commonPhase)
import PraTactile.Registration.Lattice.Evidence
import PraTactile.Registration.Lattice.Held (Held (..))
import PraTactile.Registration.Lattice.Layout
import PraTactile.Registration.Lattice.Template
import PraTactile.Registration.Posterior (Hypothesis (..))
import PraTactile.Registration.Search (Registration (..))

-- | The most frames that the lattice's phase is found from.
phaseFrames :: Int
phaseFrames = 64

-- | Where each frame is, from the nominal places (taxels) of their upper left pixels, and what they
-- tell at the lattice's angle. The displacements have mean 0, since a shift common to all cannot be
-- seen. The order of the frames changes nothing.
registerJointly :: Registration -> Held -> [(Place, Raster)] -> [Located]
registerJointly settings against frames = map snd (sortOn fst (zip order centred))
  where
    angle = heldAngle against
    (order, ordered) =
      unzip
        ( sortOn
            (\(_, ((x, y), image, _)) -> (y, x, rasterValues image))
            [ (k, (firstPlace (tablesOf image) (turnedBy (negate angle) place), image, told))
              | (k, (place, image), told) <- zip3 [0 :: Int ..] frames (heldFrames against)
            ]
        )
    grid = gridOf settings
    -- What few frames tell is kept; of many it would take too much memory.
    kept = [(place, sightEvidence told) | (place, _, told) <- ordered]
    again
      | length ordered <= phaseFrames = kept
      | otherwise = [(place, evidence (tablesOf image) image) | (place, image, _) <- ordered]
    tablesOf image = heldTables against (rasterSize image)
    (orientation, phase) = commonPhase grid (spacedOut phaseFrames kept)
    options = [optionsOf grid orientation phase frame | frame <- again]
    settled = swept options
    located =
      [ turnedTo angle (locatedAt place (shifts weights))
        | ((place, _, _), weights) <- zip ordered settled
      ]
    shifts weights = [(optionShift o, p) | (o, p) <- weights]
    n = fromIntegral (max 1 (length located))
    mean part = eighth (sum (map (part . locatedShift) located) / n)
    centred =
      [ l {locatedShift = less (locatedShift l), locatedOthers = map lessen (locatedOthers l)}
        | l <- located
      ]
    less (x, y) = (x - mean fst, y - mean snd)
    lessen h = h {hypothesisShift = less (hypothesisShift h)}

-- | What was found along the lattice's axes, which are turned by that many degrees, along the
-- frames'.
turnedTo :: Double -> Located -> Located
turnedTo 0 l = l
turnedTo angle l =
  l
    { locatedShift = turnedBy angle (locatedShift l),
      locatedDeviation = (along c s, along s c),
      locatedOthers =
        [h {hypothesisShift = turnedBy angle (hypothesisShift h)} | h <- locatedOthers l]
    }
  where
    (c, s) = turnedBy angle (1, 0)
    (sx, sy) = locatedDeviation l
    along i j = sqrt (i * i * sx * sx + j * j * sy * sy)

-- | Where the first of a frame's places lies, from where its upper left pixel does.
firstPlace :: Templates -> Place -> Place
firstPlace tables (x, y) = (x + fromIntegral i, y + fromIntegral j)
  where
    (i, j) = layoutFirst (templateLayout tables)
