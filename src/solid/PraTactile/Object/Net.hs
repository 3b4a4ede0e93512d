-- | Unfolds solids: cuts a solid along edges and lays its faces flat in one piece. An unfolding is
-- a net if no two faces overlap. Solids may have handles, and faces may be non-convex.
--
-- An unfolding is a spanning tree of the graph with the faces as nodes and the edges as arcs
-- ("PraTactile.Object.Net.Trees"). Coordinates are rational except for roots of integers. So it is
-- decided exactly whether faces touch or overlap ("PraTactile.Object.Net.Template",
-- "PraTactile.Object.Net.Meeting").
module PraTactile.Object.Net
  ( -- * Counting
    spanningTrees,

    -- * Finding a net
    Unfolding,
    foldedEdges,
    NoNet (..),
    mostTried,
    pickNet,
    pickCut,

    -- * Laying it out
    Net (..),
    NetFace (..),
    onFace,
    Fold (..),
    Bend (..),
    layOut,
    NetPart (..),
    Rim (..),
    wholePart,
    partsFor,
  )
where

import PraTactile.Object.Net.Layout
import PraTactile.Object.Net.Parts
import PraTactile.Object.Net.Pick
import PraTactile.Object.Net.Trees
import PraTactile.Object.Net.Unfolding
