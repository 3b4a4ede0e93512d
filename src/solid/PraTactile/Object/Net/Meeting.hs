{-# OPTIONS_HADDOCK hide #-}

-- | Decides whether two unfolded faces overlap in the plane.
--
-- Faces overlap if they have an interior point in common. They are cut into convex parts. Two
-- convex polygons have no common interior point if and only if one of them has a side whose line
-- has all of the other on it or on its outer side. That requires the signs of
--
-- > (b - a) x (c - a)
--
-- for the sides a b of one part and the corners c of the other. A corner that coincides with an end
-- of the side, because the faces are glued there, is on the line. Otherwise the sign is decided by
-- machine numbers if the value is far enough from 0. Else it is decided exactly if the coordinates
-- have few enough terms. Else intervals with increasing precision are used, until they determine
-- the sign or show that the corner is less than 10^-30 mm from the line. Such a corner is open: it
-- is assumed to be on the line, so the faces touch.
module PraTactile.Object.Net.Meeting
  ( Meeting (..),
    worstOf,
    Lying (..),
    lyingStill,
    lyingAcross,
    lyingOn,
    Corner (..),
    cornersLying,
    meetingOf,
  )
where

import Data.List (foldl')
import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.List.NonEmpty as NonEmpty
import Data.Ratio ((%))
import qualified Data.Vector as V
import PraTactile.Object.Description (cyclicPairs)
import PraTactile.Object.Enclosure
import PraTactile.Object.Mesh
import PraTactile.Object.Net.Template
import PraTactile.Object.Net.Unfolder
import PraTactile.Object.Number
import PraTactile.Object.Radicals
import PraTactile.Object.Surface
import PraTactile.Object.Vector (dot)
import qualified PraTactile.Object.Vector as Space

-- | The result: 'Apart' if two faces have no common interior point; 'Open' if they have none,
-- provided that an open corner is on its line.
data Meeting = Apart | Open | Overlapping
  deriving stock (Eq, Ord, Show)

-- | The worst of these results. Evaluation stops at the first overlap.
worstOf :: [Meeting] -> Meeting
worstOf found
  | Overlapping `elem` found = Overlapping
  | otherwise = foldl' max Apart found

-- | The map from a face's plane to the first face's plane.
data Lying = Lying
  { lyingExactly :: Similarity (Maybe Radicals),
    lyingRungs :: NonEmpty (Similarity Enclosure)
  }

-- | The map for the first face itself, the identity.
lyingStill :: Lying
lyingStill =
  Lying
    (identity (Just . fraction))
    (NonEmpty.map (\digits -> identity (\q -> enclosed digits q 1)) rungPlaces)
  where
    identity make = Similarity (Planar (make 1) (make 0)) (Planar (make 0) (make 0))

-- | The map from the plane of the face across a side to the plane of the side's own face.
lyingAcross :: Unfolder -> Int -> Lying
lyingAcross it s =
  Lying
    (rungAcross (unfolderExactly it) V.! s)
    (NonEmpty.map (\rung -> rungAcross rung V.! s) (unfolderRungs it))

-- | Composes maps: the first argument's plane is that to which the second one leads.
lyingOn :: Lying -> Lying -> Lying
lyingOn (Lying far fars) (Lying near nears) =
  Lying (far `after` near) (NonEmpty.zipWith after fars nears)

-- | A corner of a face in the first face's plane.
data Corner = Corner
  { cornerVertex :: Int,
    -- | the number of its point; corners of two faces that are glued have the same number
    cornerPoint :: Int,
    -- | its approximate place, in units of the first face's template. Errors are at most 10^-14 and
    -- the rounding of machine numbers.
    cornerNearly :: (Double, Double),
    cornerExactly :: Planar (Maybe Radicals),
    cornerRungs :: NonEmpty (Planar Enclosure)
  }

-- | The corners of a face in the order of its walk. Arguments: the solid; the numbers of the points
-- where sides begin; the map of the face; the face.
cornersLying :: Unfolder -> (Int -> Int) -> Lying -> Int -> V.Vector Corner
cornersLying it point lying f = V.fromList (zipWith corner [0 ..] (sidesOfFace sides f))
  where
    sides = unfolderSides it
    corner i s =
      Corner
        { cornerVertex = sideStart sides s,
          cornerPoint = point s,
          cornerNearly = nearly rungs,
          cornerExactly = onPoint (lyingExactly lying) (own (unfolderExactly it)),
          cornerRungs = rungs
        }
      where
        rungs =
          NonEmpty.zipWith (\to rung -> onPoint to (own rung)) (lyingRungs lying) (unfolderRungs it)
        own :: Rung n -> Planar n
        own rung = rungCorners rung V.! f V.! i

-- | A point as machine numbers, from intervals of increasing precision.
nearly :: NonEmpty (Planar Enclosure) -> (Double, Double)
nearly rungs = case NonEmpty.dropWhile rough rungs of
  Planar x y : _ -> (fromRational (middle x), fromRational (middle y))
  [] -> (0, 0)
  where
    rough (Planar x y) = radius x > tiny || radius y > tiny
    tiny = 1 / 10 ^ (14 :: Int)

-- | How two faces meet, given their convex parts and their corners in the first face's plane.
meetingOf ::
  Unfolder ->
  ([ConvexPart], V.Vector Corner) ->
  ([ConvexPart], V.Vector Corner) ->
  Meeting
meetingOf it (as, a) (bs, b) =
  worstOf [convexMeeting tell (of' a one) (of' b other) | one <- as, other <- bs]
  where
    of' corners = V.map (corners V.!)
    tell = sideOf it

-- | Tests on which side of a line a corner is. 'Apart' means on the outer side or on the line.
data SideOf = SideOf
  { -- | by machine numbers; 'Nothing' if they do not decide
    atOnce :: (Corner, Corner) -> Corner -> Maybe Meeting,
    -- | by all methods
    atLength :: (Corner, Corner) -> Corner -> Meeting
  }

sideOf :: Unfolder -> SideOf
sideOf it = SideOf quick careful
  where
    quick (p, q) c
      | cornerPoint c `elem` map cornerPoint [p, q] = Just Apart
      | abs z > 1e-12 * (1 + far) * (1 + far) = Just (if z > 0 then Overlapping else Apart)
      | otherwise = Nothing
      where
        z = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        far = maximum (map abs [ax, ay, bx, by, cx, cy])
        ((ax, ay), (bx, by), (cx, cy)) = (cornerNearly p, cornerNearly q, cornerNearly c)
    careful line c
      | Just told <- quick line c = told
      | otherwise = case turning cornerExactly line c of
        Just sums -> verdict (sign sums)
        Nothing -> maybe Open verdict (refined line (NonEmpty.toList (turnings line c)))
    verdict :: Int -> Meeting
    verdict told = if told > 0 then Overlapping else Apart
    turnings (p, q) c =
      NonEmpty.zipWith
        (\(a, b) z -> crossProduct a b z)
        (NonEmpty.zip (cornerRungs p) (cornerRungs q))
        (cornerRungs c)
    turning place (p, q) c = crossProduct (place p) (place q) (place c)
    -- The first interval of (b - a) x (c - a) that decides the sign. None if an earlier one shows
    -- that the corner is less than 10^-30 mm from the line.
    refined line found = case found of
      value : finer
        | Just told <- signKnown value -> Just told
        | radius value * radius value <= fine line -> Nothing
        | otherwise -> refined line finer
      [] -> Nothing
    fine (p, q) = lengthSquared / (unit * unit) / 10 ^ (60 :: Int)
      where
        unit = templateUnit (unfolderTemplates it V.! 0)
        lengthSquared = dot across across % (meshDenominator solid * meshDenominator solid)
        across = place q `Space.minus` place p
        place corner = meshPoints solid V.! cornerVertex corner
        solid = unfolderMesh it

-- | The cross product (b - a) x (c - a).
crossProduct :: Number n => Planar n -> Planar n -> Planar n -> n
crossProduct a b c = imaginary
  where
    Planar _ imaginary = multiplied (conjugate (b `subtracted` a)) (c `subtracted` a)

-- | How two convex polygons meet.
convexMeeting :: SideOf -> V.Vector Corner -> V.Vector Corner -> Meeting
convexMeeting tell a b
  | any (all (== Just Apart)) quick = Apart
  | otherwise = foldl' min Overlapping careful
  where
    quick = [map (atOnce tell line) corners | (line, corners) <- lines']
    -- A side counts as its worst corner of the other polygon; the best side decides.
    careful =
      [ foldl' max Apart (map (atLength tell line) corners)
        | ((line, corners), told) <- zip lines' quick,
          Just Overlapping `notElem` told
      ]
    lines' =
      [(line, V.toList b) | line <- cyclicPairs (V.toList a)]
        ++ [(line, V.toList a) | line <- cyclicPairs (V.toList b)]
