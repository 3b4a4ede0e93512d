-- | What is seen of a solid, convex or not: the parts of its faces in an order in which each may be
-- painted over those before it, and the vertices that nothing hides.
--
-- A face whose outer side is turned away is hidden by others. The rest are convex parts of faces,
-- put in order by a binary partition of space (Fuchs, Kedem and Naylor 1980): the plane of one of
-- them parts the others, which are cut where they cross it; nothing behind that plane hides what is
-- before it, and the eye is before it, since the face is seen. Which side a corner is on is decided
-- exactly, by machine numbers where those are far from 0, and else by fractions, which corners made
-- by cuts are, too. The directions that one looks in are rounded to millionths before.
module PraTactile.Object.View
  ( -- * Looking
    View (..),
    viewFrom,
    viewAlong,
    Camera,
    camera,
    onPicture,

    -- * What is seen
    Patch (..),
    Side (..),
    patches,
    SeenVertex (..),
    seenVertices,
  )
where

import PraTactile.Object.View.Camera
import PraTactile.Object.View.Patches
import PraTactile.Object.View.Vertices
