{-# OPTIONS_HADDOCK hide #-}

-- | How two faces lie in the plane, once they are unfolded.
--
-- They overlap if they have an inner point in common. They are cut into convex parts, and two
-- convex polygons have no inner point in common if and only if a side of one of them has all of the
-- other on its outer side or on its line. That takes the signs of
--
-- > (b - a) x (c - a)
--
-- for the sides a b of one part and the corners c of the other. A corner with which the side begins
-- or ends, since both faces are glued there, is on its line. Another sign is told by machine
-- numbers, where they are far enough from 0; else exactly, where the coordinates have few enough
-- terms; else by enclosures of more and more places, until they tell the sign or that the corner is
-- less than 10^-30 mm from the line. Such a one is open: it is taken to be on the line, so that the
-- faces touch.
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

-- | 'Apart' if two faces have no inner point in common, 'Open' if they have none unless something
-- is off by less than 10^-30 mm.
data Meeting = Apart | Open | Overlapping
  deriving stock (Eq, Ord, Show)

-- | The worst of these, of which none is looked at once two faces overlap.
worstOf :: [Meeting] -> Meeting
worstOf found
  | Overlapping `elem` found = Overlapping
  | otherwise = foldl' max Apart found

-- | How the plane of a face comes to that of the first one.
data Lying = Lying
  { lyingExactly :: Similarity (Maybe Radicals),
    lyingRungs :: NonEmpty (Similarity Enclosure)
  }

-- | How the first face lies.
lyingStill :: Lying
lyingStill =
  Lying
    (identity (Just . fraction))
    (NonEmpty.map (\digits -> identity (\q -> enclosed digits q 1)) rungPlaces)
  where
    identity make = Similarity (Planar (make 1) (make 0)) (Planar (make 0) (make 0))

-- | How the face across a side lies in the plane of the side's own face.
lyingAcross :: Unfolder -> Int -> Lying
lyingAcross it s =
  Lying
    (rungAcross (unfolderExactly it) V.! s)
    (NonEmpty.map (\rung -> rungAcross rung V.! s) (unfolderRungs it))

-- | How a face lies that lies as the second says in the plane of one that lies as the first says.
lyingOn :: Lying -> Lying -> Lying
lyingOn (Lying far fars) (Lying near nears) =
  Lying (far `after` near) (NonEmpty.zipWith after fars nears)

-- | A corner of a face that lies somewhere.
data Corner = Corner
  { cornerVertex :: Int,
    -- | the number of its point: corners of two faces that are glued there have the same one
    cornerPoint :: Int,
    -- | its place, rounded, in units of the first face's template; errors are below 10^-14 and what
    -- machine numbers round
    cornerNearly :: (Double, Double),
    cornerExactly :: Planar (Maybe Radicals),
    cornerRungs :: NonEmpty (Planar Enclosure)
  }

-- | The corners of a face in the order of its walk, given the numbers of the points in which its
-- sides begin, and how it lies.
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

-- | A point as machine numbers, given as enclosures of more and more places.
nearly :: NonEmpty (Planar Enclosure) -> (Double, Double)
nearly rungs = case NonEmpty.dropWhile rough rungs of
  Planar x y : _ -> (fromRational (middle x), fromRational (middle y))
  [] -> (0, 0)
  where
    rough (Planar x y) = radius x > tiny || radius y > tiny
    tiny = 1 / 10 ^ (14 :: Int)

-- | How two faces lie, by their parts and corners in the plane of the first face.
meetingOf :: Unfolder -> ([Part], V.Vector Corner) -> ([Part], V.Vector Corner) -> Meeting
meetingOf it (as, a) (bs, b) =
  worstOf [convexMeeting tell (of' a one) (of' b other) | one <- as, other <- bs]
  where
    of' corners = V.map (corners V.!)
    tell = sideOf it

-- | On which side of a line a corner is: 'Apart' if on its outer side or on it.
data SideOf = SideOf
  { -- | where machine numbers tell it
    atOnce :: (Corner, Corner) -> Corner -> Maybe Meeting,
    -- | by all means there are
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
        (\(a, b) z -> turned a b z)
        (NonEmpty.zip (cornerRungs p) (cornerRungs q))
        (cornerRungs c)
    turning place (p, q) c = turned (place p) (place q) (place c)
    -- Of the enclosures of (b - a) x (c - a) the first that tells the sign; none where one of those
    -- before it has the corner less than 10^-30 mm from the line.
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

-- | (b - a) x (c - a).
turned :: Number n => Planar n -> Planar n -> Planar n -> n
turned a b c = imaginary
  where
    Planar _ imaginary = multiplied (conjugate (b `subtracted` a)) (c `subtracted` a)

-- | How two convex polygons lie.
convexMeeting :: SideOf -> V.Vector Corner -> V.Vector Corner -> Meeting
convexMeeting tell a b
  | any (all (== Just Apart)) quick = Apart
  | otherwise = foldl' min Overlapping careful
  where
    quick = [map (atOnce tell line) corners | (line, corners) <- lines']
    -- A side is as good as the worst of the other's corners, and the best side is what counts.
    careful =
      [ foldl' max Apart (map (atLength tell line) corners)
        | ((line, corners), told) <- zip lines' quick,
          Just Overlapping `notElem` told
      ]
    lines' =
      [(line, V.toList b) | line <- cyclicPairs (V.toList a)]
        ++ [(line, V.toList a) | line <- cyclicPairs (V.toList b)]
