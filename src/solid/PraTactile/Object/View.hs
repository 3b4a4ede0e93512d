-- | The view of a solid, convex or not: the visible parts of its faces, in an order in which each
-- may be painted over those before it, and the vertices that nothing hides.
--
-- Faces whose outer side is turned away are hidden. The others are cut into convex parts, which are
-- sorted by a binary space partition (Fuchs, Kedem and Naylor 1980). The plane of one part divides
-- the others, which are cut where they cross it. Nothing behind that plane hides what is before it,
-- and the eye is before it, since the face is visible. The side on which a corner is is decided
-- exactly: by machine numbers if they are far from 0, else by fractions. Corners made by cuts are
-- fractions too. View directions are first rounded to millionths.
module PraTactile.Object.View
  ( -- * Looking
    View (..),
    viewFrom,
    viewAlong,
    Camera,
    camera,
    onPicture,

    -- * What is seen
    VisiblePart (..),
    Side (..),
    patches,
    SeenVertex (..),
    seenVertices,
  )
where

import PraTactile.Object.View.Camera
import PraTactile.Object.View.Patches
import PraTactile.Object.View.Vertices
