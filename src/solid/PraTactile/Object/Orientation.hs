-- | Turns faces so that all are counter-clockwise as seen from outside.
--
-- Two faces agree if one walks their common edge from p to q and the other from q to p. So all
-- faces that are connected by edges of exactly two faces follow from one of them, unless the
-- surface is one-sided. The sign of the volume tells which orientation is outward (the divergence
-- theorem). A piece inside an odd number of others is the wall of a hollow and must be inward.
module PraTactile.Object.Orientation
  ( oriented,
  )
where

import qualified Data.IntMap.Strict as IntMap
import qualified Data.IntSet as IntSet
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust, mapMaybe)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Defect
import PraTactile.Object.Mesh
import PraTactile.Object.Surface
import PraTactile.Object.Validity
import PraTactile.Object.Vector

-- | The polyhedron with faces turned, and the indices of the turned faces, ascending. A closed
-- piece is turned outward, or inward if it is inside an odd number of others. In a piece with a rim
-- the fewer faces are turned. One-sided pieces are not turned. If pieces cross each other, so that
-- none is inside another, pieces whose faces agree stay unchanged. O(n log n).
oriented :: Mesh -> (Mesh, [Int])
oriented it
  | not (V.all (ofVertices it) (meshWalks it)) = (it, [])
  | length bodies < 2 = turned (IntSet.unions (rims ++ bodies))
  | known = turned (IntSet.unions (rims ++ zipWith nested pieces bodies))
  | otherwise = turned (IntSet.unions (rims ++ zipWith cautious pieces bodies))
  where
    pieces = filter closed (piecesOf sides (V.length (meshWalks it)))
    (rims, bodies) = (map fewer open', map outward pieces)
    open' = filter (not . closed) (piecesOf sides (V.length (meshWalks it)))
    sides = surface (meshWalks it)
    closed piece =
      all (all (isJust . mateOf sides) . sidesOfFace sides) (IntMap.keys (pieceFaces piece))
    -- For each piece the faces to turn.
    fewer piece
      | not (pieceTwoSided piece) = IntSet.empty
      | IntSet.size (against piece) * 2 <= IntMap.size (pieceFaces piece) = against piece
      | otherwise = with piece
    outward piece
      | not (pieceTwoSided piece) = IntSet.empty
      | volume piece < 0 = with piece
      | otherwise = against piece
    against = IntMap.keysSet . IntMap.filter not . pieceFaces
    with = IntMap.keysSet . IntMap.filter id . pieceFaces
    volume piece =
      sum
        [ (if as then 1 else -1) * dot (doubleArea corners) (firstOf corners)
          | (f, as) <- IntMap.toList (pieceFaces piece),
            let corners = cornersOf it (meshWalks it V.! f)
        ]
    -- The pieces inside an odd number of others, once all are outward.
    (asOutward, _) = turned (IntSet.unions (rims ++ bodies))
    report = examine asOutward
    known = all (isJust . componentInside) (reportComponents report)
    inward =
      IntSet.fromList
        ( mapMaybe
            (`Map.lookup` places)
            [face | Defect InsideOut [face] _ _ <- reportDefects report]
        )
    places = Map.fromList [(faceAt asOutward f, f) | f <- [0 .. V.length (meshWalks it) - 1]]
    nested piece own
      | any (`IntSet.member` inward) (IntMap.keys (pieceFaces piece)) =
        IntMap.keysSet (pieceFaces piece) `IntSet.difference` own
      | otherwise = own
    cautious piece own = if IntSet.null (against piece) then IntSet.empty else own
    turned faces =
      ( withShape
          (meshNames it)
          (meshDenominator it)
          (meshPoints it)
          (V.imap (\f walk -> if IntSet.member f faces then back walk else walk) (meshWalks it))
          it,
        IntSet.toAscList faces
      )
    -- The walk in the other direction, from the same vertex.
    back walk = U.take 1 walk U.++ U.reverse (U.drop 1 walk)

-- | Faces that are connected by edges of exactly two faces.
data Piece = Piece
  { -- | its faces, and whether each is oriented as the first one is
    pieceFaces :: IntMap.IntMap Bool,
    -- | whether the orientation is consistent
    pieceTwoSided :: Bool
  }

-- | The pieces of this number of faces, by their first ones.
piecesOf :: FaceSides -> Int -> [Piece]
piecesOf sides count = go IntSet.empty [0 .. count - 1]
  where
    go _ [] = []
    go seen (f : others)
      | IntSet.member f seen = go seen others
      | otherwise =
        let piece = flooded (Piece IntMap.empty True) [(f, True)]
         in piece : go (seen `IntSet.union` IntMap.keysSet (pieceFaces piece)) others
    flooded piece [] = piece
    flooded piece ((f, as) : waiting) = case IntMap.lookup f (pieceFaces piece) of
      Just as'
        | as == as' -> flooded piece waiting
        | otherwise -> flooded piece {pieceTwoSided = False} waiting
      Nothing ->
        flooded piece {pieceFaces = IntMap.insert f as (pieceFaces piece)} (across f as ++ waiting)
    across f as =
      [ (sideFace sides t, if sideStart sides s /= sideStart sides t then as else not as)
        | s <- sidesOfFace sides f,
          Just t <- [mateOf sides s]
      ]
