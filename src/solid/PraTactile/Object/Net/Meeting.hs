-- | How two faces lie in the plane, once they are unfolded.
--
-- They overlap if they have an inner point in common. They are cut into convex parts, and two
-- convex polygons have no inner point in common if and only if a side of one of them has all of the
-- other on its outer side or on its line. That takes the signs of
--
-- > (b - a) x (c - a)
--
-- for the sides a b of one part and the corners c of the other. A corner with which the side begins
-- or ends, since both faces are glued there, is on its line. Another sign is told by enclosures of
-- 64 binary places, where 0 is not among them; else exactly, where the coordinates have few enough
-- terms; else by enclosures of more and more places, until they tell the sign or that the corner is
-- less than 10^-30 mm from the line. Such a one is open: it is taken to be on the line, so that the
-- faces touch.
module PraTactile.Object.Net.Meeting
  ( Meeting (..),
    Lying (..),
    lyingAcross,
    lyingOn,
    Part,
    convexParts,
    Corner,
    cornersLying,
    meetingOf,
  )
where

import Data.List (foldl')
import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.List.NonEmpty as NonEmpty
import Data.Maybe (fromMaybe, isJust)
import Data.Ratio ((%))
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Description (cyclicPairs)
import PraTactile.Object.Enclosure
import PraTactile.Object.Mesh
import PraTactile.Object.Net.Template
import PraTactile.Object.Net.Unfolder
import PraTactile.Object.Number
import PraTactile.Object.Polygon
import PraTactile.Object.Radicals
import PraTactile.Object.Triangles
import PraTactile.Object.Vector (dot)
import qualified PraTactile.Object.Vector as Space

-- | 'Apart' if two faces have no inner point in common, 'Open' if they have none unless something
-- is off by less than 10^-30 mm.
data Meeting = Apart | Open | Overlapping
  deriving stock (Eq, Ord, Show)

-- | How the plane of a face comes to that of another one.
data Lying = Lying
  { lyingExactly :: Similarity (Maybe Radicals),
    lyingRungs :: NonEmpty (Similarity Enclosure)
  }

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

-- | A convex part of a face: its corners by their places on the face's walk.
type Part = V.Vector Int

-- | A face as convex parts, which have no corners but its own.
convexParts :: Mesh -> Int -> [Part]
convexParts it f
  | and [turn (at i) (at (i + 1)) (at (i + 2)) >= 0 | i <- [0 .. count - 1]] =
    [V.enumFromN 0 count]
  | otherwise = [V.fromList (map place [i, j, k]) | (i, j, k) <- triangles it walk]
  where
    walk = meshWalks it V.! f
    points = cornersOf it walk
    seen = V.map (flat (doubleArea points)) points
    count = V.length seen
    at i = seen V.! (i `mod` count)
    place v = fromMaybe 0 (U.elemIndex v walk)

-- | A corner of a face that lies somewhere.
data Corner = Corner
  { cornerVertex :: Int,
    -- | what equals that of another face's corner where they are one because of what is glued
    cornerGlued :: Maybe Int,
    cornerExactly :: Planar (Maybe Radicals),
    cornerRungs :: NonEmpty (Planar Enclosure)
  }

-- | The corners of a face in the order of its walk, given what its vertices have for 'cornerGlued',
-- and how it lies.
cornersLying :: Unfolder -> (Int -> Maybe Int) -> Maybe Lying -> Int -> V.Vector Corner
cornersLying it glued lying f = V.imap corner (V.convert (meshWalks (unfolderMesh it) V.! f))
  where
    corner i v =
      Corner
        { cornerVertex = v,
          cornerGlued = glued v,
          cornerExactly = maybe id (onPoint . lyingExactly) lying (own (unfolderExactly it)),
          cornerRungs = case lying of
            Nothing -> NonEmpty.map own (unfolderRungs it)
            Just given ->
              NonEmpty.zipWith
                (\to rung -> onPoint to (own rung))
                (lyingRungs given)
                (unfolderRungs it)
        }
      where
        own :: Rung n -> Planar n
        own rung = rungCorners rung V.! f V.! i

-- | How two faces lie, by their parts and corners in the plane of the face that is named.
meetingOf ::
  Unfolder -> Int -> ([Part], V.Vector Corner) -> ([Part], V.Vector Corner) -> Meeting
meetingOf it f (as, a) (bs, b)
  | Overlapping `elem` found = Overlapping
  | otherwise = foldl' max Apart found
  where
    found = [convexMeeting tell (of' a one) (of' b other) | one <- as, other <- bs]
    of' corners = V.map (corners V.!)
    tell = sideOf it f

-- | On which side of a line a corner is: 'Apart' if on its outer side or on it.
data SideOf = SideOf
  { -- | where enclosures of 64 places tell it
    atOnce :: (Corner, Corner) -> Corner -> Maybe Meeting,
    -- | by all means there are
    atLength :: (Corner, Corner) -> Corner -> Meeting
  }

sideOf :: Unfolder -> Int -> SideOf
sideOf it f = SideOf quick careful
  where
    quick line c
      | onEnd line c = Just Apart
      | first :| _ <- turnings line c = verdict <$> signKnown first
    careful line c
      | Just told <- quick line c = told
      | otherwise = case turning cornerExactly line c of
        Just sums -> verdict (nearest (truncate . signum) sums)
        Nothing -> maybe Open verdict (refined line (NonEmpty.toList (turnings line c)))
    verdict :: Int -> Meeting
    verdict sign = if sign > 0 then Overlapping else Apart
    onEnd (p, q) c = isJust (cornerGlued c) && cornerGlued c `elem` map cornerGlued [p, q]
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
        | Just sign <- signKnown value -> Just sign
        | radius value * radius value <= fine line -> Nothing
        | otherwise -> refined line finer
      [] -> Nothing
    fine (p, q) = lengthSquared / (unit * unit) / 10 ^ (60 :: Int)
      where
        unit = templateUnit (unfolderTemplates it V.! f)
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
