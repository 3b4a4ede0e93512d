-- | Unfolds solids: cuts a solid along edges and lays its faces flat in one piece. An unfolding is
-- a net if no two faces overlap. Solids may have handles and faces that are not convex.
--
-- An unfolding is a spanning tree of the graph that has the faces for nodes and the edges for arcs
-- ("PraTactile.Object.Net.Trees"). Coordinates are rational but for roots of whole numbers, so that
-- it is decided exactly whether faces touch or overlap ("PraTactile.Object.Net.Template",
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
    Part (..),
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
