-- | Unfolding solids: every way to cut a solid along edges and to lay its faces flat in one piece,
-- and which of these are nets, that is, overlap nowhere. Handles and faces that are not convex are
-- no exception.
--
-- An unfolding is a spanning tree of the graph that has the faces for nodes and the edges for arcs
-- ("PraTactile.Object.Net.Trees"). Coordinates are rational but for roots of whole numbers, so that
-- what touches and what overlaps is decided ("PraTactile.Object.Net.Template",
-- "PraTactile.Object.Net.Meeting"), and so is which outlines are congruent
-- ("PraTactile.Object.Net.Outline").
module PraTactile.Object.Net
  ( -- * Counting
    spanningTrees,
    mostTrees,
    Census (..),
    census,

    -- * Unfoldings
    Unfolding,
    unfoldings,
    foldedEdges,
    Meeting (..),
    meetingIn,
    congruent,

    -- * A net for the hand
    NoNet (..),
    pickNet,
    pickCut,
    Net (..),
    NetFace (..),
    onFace,
    Fold (..),
    Bend (..),
    layOut,
    Part (..),
    Rim (..),
    wholePart,
    partsFor,
  )
where

import PraTactile.Object.Net.Census
import PraTactile.Object.Net.Layout
import PraTactile.Object.Net.Meeting (Meeting (..))
import PraTactile.Object.Net.Parts
import PraTactile.Object.Net.Pick
import PraTactile.Object.Net.Search
import PraTactile.Object.Net.Unfolder
import PraTactile.Object.Net.Unfolding
import PraTactile.Object.WingedEdge

-- | The worst that two faces of an unfolding do, from where all of them lie, without a thought of
-- other unfoldings.
meetingIn :: Solid -> Unfolding -> Meeting
meetingIn whole = worstMeeting (unfolder whole)
