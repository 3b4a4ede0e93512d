-- | The outline of an unfolded solid as a word, so that unfoldings are told to be congruent without
-- a coordinate.
--
-- Faces glued along a spanning tree are a disc. A walk round it, the disc on the left, meets the
-- edges that are cut, each twice. At the end of a side the corners of some faces, which follow each
-- other round a vertex, lie inside; their angles add up to alpha, and
--
-- > exp (2 i alpha) = product of w_k^2 / |w_k|^2        w = d + i k sqrt N
--
-- where d is the scalar product of the ways from a corner to the one before and the one after, and
-- k the multiple that their vector product is of the face's normal, which is as long as the root of
-- N. All of that is rational but for the roots, so that exp (2 i alpha) is exact; it tells alpha
-- but for half turns, and how many those are a machine number tells. Where alpha is a half turn the
-- outline goes straight on, and two sides are one. The word is what is left: lengths and angles in
-- turn. Two outlines are congruent if and only if the word of the one is a rotation of that of the
-- other, or, where one may be turned over, of the other's backwards.
--
-- Where a product would have too many terms, two sums of angles are taken for equal if they are of
-- the same angles, or less than 10^-30 apart.
module PraTactile.Object.Net.Outline
  ( Outliner,
    outliner,
    Lengths,
    sideLengths,
    Outline,
    outline,
    turnedOver,
    fromLeast,
  )
where

import Data.Bits (shiftL, shiftR, (.&.), (.|.))
import qualified Data.IntSet as IntSet
import Data.List (foldl', mapAccumL, sort, sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (isNothing)
import Data.Ratio ((%))
import qualified Data.Set as Set
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Enclosure
import PraTactile.Object.Mesh
import PraTactile.Object.Net.Template
import PraTactile.Object.Net.Unfolder
import PraTactile.Object.Number
import PraTactile.Object.Radicals
import PraTactile.Object.Surface
import PraTactile.Object.Vector (cross, dot, squareRoot)
import qualified PraTactile.Object.Vector as Space

-- | The lengths and the angles that outlines of a solid are made of.
data Outliner = Outliner
  { outlinerSides :: Surface,
    outlinerLengths :: V.Vector Radicals,
    -- | the numbers of these lengths
    outlinerNumbers :: U.Vector Int,
    -- | of each side the angles of 1, 2, .. corners from its end on, equal ones by one number; a
    -- half turn is 0
    outlinerAngles :: V.Vector (U.Vector Int)
  }

-- | The numbers that lengths have; sides that are one because they go straight on may have new
-- ones.
type Lengths = Map.Map [(Rational, Integer)] Int

-- | The sides of an outline in their order, the inside on their left: the length of each and the
-- angle at its end, both by their numbers, in one.
type Outline = U.Vector Int

-- | What outlines of this solid are made of.
outliner :: Unfolder -> Outliner
outliner it =
  Outliner
    { outlinerSides = sides,
      outlinerLengths = lengths,
      outlinerNumbers =
        U.convert (V.map (\one -> Map.findWithDefault 0 (terms one) numbers) lengths),
      outlinerAngles = angleNumbers it
    }
  where
    sides = unfolderSides it
    squares = V.generate (sideCount sides) (\s -> let v = alongSide it s in dot v v)
    base = coprimeBase (V.toList squares)
    lengths = V.generate (sideCount sides) side
    numbers = lengthNumbers lengths
    side s = let (before, under) = rootIn base (squares V.! s) in radical before under

-- | The lengths of all sides, numbered.
sideLengths :: Outliner -> Lengths
sideLengths = lengthNumbers . outlinerLengths

lengthNumbers :: V.Vector Radicals -> Lengths
lengthNumbers lengths =
  Map.fromList (zip (Set.toList (Set.fromList (map terms (V.toList lengths)))) [0 ..])

-- | From the begin of a side to its end.
alongSide :: Unfolder -> Int -> Space.V3
alongSide it s = point (sideEnd sides s) `Space.minus` point (sideStart sides s)
  where
    sides = unfolderSides it
    point = (meshPoints (unfolderMesh it) V.!)

-- | A sum of angles: a machine number, which corners it is the sum of, and exp (2 i alpha) in both
-- ways.
data Angle = Angle
  { angleAbout :: !Double,
    angleOf :: [(Rational, Rational, Integer)],
    angleExactly :: Planar (Maybe Radicals),
    angleEnclosed :: Planar Enclosure
  }

-- | The angle of the corner at the end of a side.
cornerAngle :: Unfolder -> Int -> Angle
cornerAngle it s =
  Angle
    { angleAbout = about,
      angleOf = [(real, imaginary, n)],
      angleExactly =
        let (before, under) = unfolderRoot it n
         in Planar (Just (fraction real)) (Just (radical (imaginary * before) under)),
      angleEnclosed = Planar (enclosed 256 real 1) (enclosed 256 imaginary n)
    }
  where
    sides = unfolderSides it
    out = alongSide it (nextSide sides s)
    back = Space.minus Space.zero (alongSide it s)
    normal = templateNormal (unfolderTemplates it V.! sideFace sides s)
    n = dot normal normal
    d = dot out back
    k = dot (cross out back) normal `quot` n
    squared = dot out out * dot back back
    real = (d * d - k * k * n) % squared
    imaginary = 2 * d * k % squared
    doubled = atan2 (fromRational imaginary * squareRoot (fromInteger n)) (fromRational real) / 2
    withinHalf = if doubled < 0 then doubled + pi else doubled
    about = case signum k of
      1 -> withinHalf
      0 -> pi
      _ -> withinHalf + pi

-- | A half turn.
halfTurn :: Angle
halfTurn = Angle pi [] (Planar (Just (fraction 1)) (Just (fraction 0))) (Planar (one 1) (one 0))
  where
    one q = enclosed 256 q 1

-- | The angles of corners that follow each other, by the side at whose end the first of them is,
-- and by their number less one.
angleNumbers :: Unfolder -> V.Vector (U.Vector Int)
angleNumbers it = V.map (U.map (\i -> Map.findWithDefault 0 i numbers)) indices
  where
    sides = unfolderSides it
    corner = V.generate (sideCount sides) (cornerAngle it)
    runs = map (scanl1 joined . map (corner V.!) . around) [0 .. sideCount sides - 1]
    -- The sides that end at the vertex where this one does, as one crosses the faces round it.
    around s = s : takeWhile (/= s) (drop 1 (iterate (gluedTo sides . nextSide sides) s))
    joined (Angle a as x x') (Angle b bs y y') =
      Angle (a + b) (as ++ bs) (multiplied x y) (multiplied x' y')
    indices =
      V.fromList (map U.fromList (snd (mapAccumL (mapAccumL (\i _ -> (i + 1, i))) 1 runs)))
    numbers = sameNumbers (zip [0 ..] (halfTurn : concat runs))

-- | For each of these angles the first in the list that equals it.
sameNumbers :: [(Int, Angle)] -> Map.Map Int Int
sameNumbers angles = Map.fromList (concatMap (told []) near)
  where
    -- Angles further apart than machine numbers are inexact are none of one kind.
    near = grouped (sortOn (angleAbout . snd) angles)
    grouped list = case list of
      [] -> []
      first : rest -> go [first] (angleAbout (snd first)) rest
      where
        go kind _ [] = [sortOn fst kind]
        go kind last' (next : rest)
          | angleAbout (snd next) - last' < 1e-9 = go (next : kind) (angleAbout (snd next)) rest
          | otherwise = sortOn fst kind : go [next] (angleAbout (snd next)) rest
    told _ [] = []
    told kinds ((i, angle) : rest) = case [j | (j, kind) <- kinds, sameAngle kind angle] of
      j : _ -> (i, j) : told kinds rest
      [] -> (i, i) : told (kinds ++ [(i, angle)]) rest

-- | Whether two angles are equal that differ by less than a half turn.
sameAngle :: Angle -> Angle -> Bool
sameAngle a b = case (exact a, exact b) of
  (Just known, Just known') -> known == known'
  _ -> sort (angleOf a) == sort (angleOf b) || isNothing (signKnown between)
  where
    exact angle = let Planar x y = angleExactly angle in (,) <$> fmap terms x <*> fmap terms y
    Planar _ between = multiplied (angleEnclosed a) (conjugate (angleEnclosed b))

-- | The outline of an unfolding, given both sides of each edge that is glued, and the numbers of
-- lengths, which come back with those that are new. Sides of one straight line are one side.
outline :: Outliner -> Lengths -> IntSet.IntSet -> (Lengths, Outline)
outline it known glued = U.fromList <$> mapAccumL number known (joined (rotated (walk begin)))
  where
    sides = outlinerSides it
    isGlued s = s `IntSet.member` glued
    begin = until (not . isGlued) (+ 1) 0
    -- Each side that is cut, with the angle at its end.
    walk s = (s, angle) : if next == begin then [] else walk next
      where
        (next, corners) = turnAt 0 (nextSide sides s)
        angle = outlinerAngles it V.! s U.! corners
    -- The next side that is cut, and how many corners lie between, less one.
    turnAt :: Int -> Int -> (Int, Int)
    turnAt n s
      | isGlued s = turnAt (n + 1) (nextSide sides (gluedTo sides s))
      | otherwise = (s, n)
    -- So that a side ends where its straight line does.
    rotated given = case break ((/= 0) . snd) given of
      (front, corner : rest) -> rest ++ front ++ [corner]
      _ -> given
    joined given = case span ((== 0) . snd) given of
      (front, (s, angle) : rest) -> (map fst front ++ [s], angle) : joined rest
      _ -> []
    number lengths (one, angle) = case one of
      [s] -> (lengths, packed (outlinerNumbers it U.! s) angle)
      _ -> case Map.lookup long lengths of
        Just n -> (lengths, packed n angle)
        Nothing -> (Map.insert long (Map.size lengths) lengths, packed (Map.size lengths) angle)
        where
          long = terms (foldl' plus (fraction 0) [outlinerLengths it V.! s | s <- one])

-- | A length and an angle in one number.
packed :: Int -> Int -> Int
packed long angle = (long `shiftL` 32) .|. angle

-- | The outline turned over.
turnedOver :: Outline -> Outline
turnedOver it = U.zipWith packed lengths (U.drop 1 angles U.++ U.take 1 angles)
  where
    lengths = U.map (`shiftR` 32) backwards
    angles = U.map (.&. 0xffffffff) backwards
    backwards = U.reverse it

-- | The same outline from where it is least, of all places where it may begin.
fromLeast :: Outline -> Outline
fromLeast it = from (foldl' better 0 [1 .. count - 1])
  where
    count = U.length it
    from i = U.drop i it U.++ U.take i it
    better best i = if less 0 best i then i else best
    less k best i
      | k == count = False
      | a == b = less (k + 1) best i
      | otherwise = b < a
      where
        a = it `U.unsafeIndex` ((best + k) `mod` count)
        b = it `U.unsafeIndex` ((i + k) `mod` count)
