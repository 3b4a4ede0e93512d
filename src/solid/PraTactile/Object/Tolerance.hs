-- | What rounding did to a polyhedron, undone where it can be: vertices that lie close together are
-- one, and faces are flat again, exactly.
--
-- A face of more than three corners gets the plane n . x = n . m of its area vector n and the mean
-- m of its corners, which are rational. A vertex v that is on up to three such planes goes to the
-- nearest point that is common to them, v - sum l_i n_i, where the l_i solve
-- sum_j (n_i . n_j) l_j = n_i . (v - m_i), planes that follow from others left out; if there is
-- such a point, and it is near enough. Triangles are flat however they are moved.
module PraTactile.Object.Tolerance
  ( settled,
    joined,
    levelled,
    Settled (..),
    TooFine (..),
    sufficient,
  )
where

import qualified Data.IntMap.Strict as IntMap
import qualified Data.IntSet as IntSet
import Data.List (foldl', sortOn)
import Data.Maybe (fromMaybe)
import Data.Ord (Down (..))
import Data.Ratio (denominator, numerator, (%))
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Math.NumberTheory.Logarithms (integerLog2)
import PraTactile.Object.Boxes
import PraTactile.Object.Mesh
import PraTactile.Object.Sliver
import PraTactile.Object.Surface
import PraTactile.Object.Vector
import PraTactile.Object.VectorQ

-- | What came of it.
data Settled = Settled
  { settledMesh :: Mesh,
    -- | how many vertices were moved, those put together with another place among them
    settledMoved :: Int,
    -- | how far at most, in millimetres
    settledMost :: Double,
    -- | how many faces were left out, since nothing is left of their area
    settledLeftOut :: Int
  }

-- | Vertices no further apart than so many millimetres are put together, each at the first of them
-- in the file's order; faces that lie no further from a line are left out
-- ("PraTactile.Object.Sliver"); and other vertices are moved no further so that faces are flat. If
-- asked for, faces that share sides and lie as near to the plane of the largest of them count as
-- one face, for an exporter cut it into triangles. Faces with fewer than three vertices left are
-- left out. Refuses where the new points have no common denominator that one can compute with.
settled :: Rational -> Bool -> Mesh -> Either TooFine Settled
settled mm together it = joined mm it >>= levelled mm together

-- | The first half of 'settled': vertices put together, and faces on a line left out.
joined :: Rational -> Mesh -> Either TooFine Settled
joined mm it
  | not (V.all (ofVertices it) (meshWalks it)) = Right (Settled it 0 0 0)
  | otherwise = do
    (joint, unsliveredBy) <- relocated moved (withWalks walks together)
    let moves = weldedBy ++ unsliveredBy
        left = V.length (meshWalks it) - length walks
    Right (Settled joint (length moves) (maximum (0 : moves)) left)
  where
    (together, weldedBy) = welded mm it
    Unslivered walks moved = withoutSlivers mm together
    withWalks given old =
      withShape (meshNames old) (meshDenominator old) (meshPoints old) (V.fromList given) old

-- | The second half: vertices moved so that faces are flat.
levelled :: Rational -> Bool -> Settled -> Either TooFine Settled
levelled mm together before
  | not (V.all (ofVertices it) (meshWalks it)) = Right before
  | otherwise = do
    (flat, moves) <- flattened (Just mm) together it
    Right
      before
        { settledMesh = flat,
          settledMoved = settledMoved before + length moves,
          settledMost = maximum (settledMost before : moves)
        }
  where
    it = settledMesh before

-- | The coordinates of flat faces would have so many binary digits over their common denominator,
-- and more than 2^28 are not made.
newtype TooFine = TooFine Integer
  deriving stock (Eq, Show)

-- | A tolerance, in millimetres, with which faces that are not flat will be: three digits of what
-- has to be moved, rounded up. Nothing, where none will do.
sufficient :: Mesh -> Maybe Rational
sufficient it
  | not (V.all (ofVertices it) (meshWalks it)) = Nothing
  | Right (flat, moves@(_ : _)) <- flattened Nothing False it,
    not (any (bent flat) (V.toList (meshWalks flat))) =
    Just (up (maximum moves))
  | otherwise = Nothing
  where
    bent flat walk =
      let corners = cornersOf flat walk in not (flatAlong (doubleArea corners) corners)
    up far =
      let digit = 10 ^^ (floor (logBase 10 far) - 2 :: Int) :: Rational
       in fromInteger (ceiling (toRational far / digit * (1 + 1e-12))) * digit

-- | Vertices that are near each other put together, with how far each was moved.
welded :: Rational -> Mesh -> (Mesh, [Double])
welded mm it =
  ( withShape
      (V.map (meshNames it V.!) (V.convert kept))
      (meshDenominator it)
      (V.map (points V.!) (V.convert kept))
      ( V.filter
          ((>= 3) . U.length)
          (V.map (tidy . U.map (\i -> places U.! (firsts U.! i))) (meshWalks it))
      )
      it,
    [ far
      | i <- [0 .. count - 1],
        let j = firsts U.! i,
        i /= j,
        let far = distance it (points V.! i) (points V.! j),
        far > 0
    ]
  )
  where
    points = meshPoints it
    count = V.length points
    rounding = roundingOf points
    -- In the units of coordinates, and in those of boxes.
    reach = mm * fromInteger (meshDenominator it)
    square = reach * reach
    tree = boxes (V.map (boxOf rounding) points)
    firsts =
      classes
        count
        [ (i, j)
          | i <- [0 .. count - 1],
            j <- meeting tree (grown (points V.! i)),
            i < j,
            let d = (points V.! i) `minus` (points V.! j),
            fromInteger (dot d d) <= square
        ]
    grown p = boxOf rounding (p `minus` wide) `around` boxOf rounding (p `plus` wide)
    wide = let r = ceiling reach in V3 r r r
    kept = U.ifilter (==) firsts
    places = U.replicate count 0 U.// zip (U.toList kept) [0 ..]
    tidy walk
      | U.length kept == count = walk
      | otherwise = U.fromList (tidied (U.toList walk))

distance :: Mesh -> V3 -> V3 -> Double
distance it p q = squareRoot (dot d d % meshDenominator it ^ (2 :: Int))
  where
    d = p `minus` q

-- | A plane: the normal, and what the normal makes of its points.
data Plane = Plane V3 Rational

-- | Vertices moved so that faces are flat, no further than so many millimetres, with how far each
-- was.
flattened :: Maybe Rational -> Bool -> Mesh -> Either TooFine (Mesh, [Double])
flattened most together it = relocated moves it
  where
    points = meshPoints it
    groups =
      if together
        then nearlyFlat (fromMaybe 0 most) it
        else U.enumFromN 0 (V.length (meshWalks it))
    members =
      IntMap.fromListWith (++) [(g, [meshWalks it V.! f]) | (f, g) <- U.toList (U.indexed groups)]
    planes =
      [ (corners, Plane n (fromInteger (dot n total) / fromIntegral (length corners)))
        | walks <- IntMap.elems members,
          let corners = IntSet.toList (IntSet.fromList (concatMap U.toList walks)),
          length corners > 3,
          let n = foldl' plus zero (map (doubleArea . cornersOf it) walks)
              total = foldl' plus zero (map (points V.!) corners),
          n /= zero
      ]
    planesAt = IntMap.fromListWith (++) [(v, [plane]) | (corners, plane) <- planes, v <- corners]
    moves = IntMap.mapMaybeWithKey move planesAt
    move v given
      | length given > 3 = Nothing
      | otherwise = case common (exactly (points V.! v)) given of
        Just p
          | let d = norm (p `less` exactly (points V.! v)),
            d > 0,
            maybe True (\mm -> d <= (mm * fromInteger (meshDenominator it)) ^ (2 :: Int)) most ->
            Just p
        _ -> Nothing

-- | Vertices at other places, in units of the polyhedron's coordinates, with how far each was
-- moved, in millimetres.
relocated :: IntMap.IntMap Q3 -> Mesh -> Either TooFine (Mesh, [Double])
relocated moves it
  | IntMap.null moves = Right (it, [])
  | bits > mostBits = Left (TooFine bits)
  | otherwise =
    Right
      ( withShape (meshNames it) (meshDenominator it * over) moved (meshWalks it) it,
        [ squareRoot (norm d / fromInteger (meshDenominator it) ^ (2 :: Int))
          | (i, p) <- IntMap.toList moves,
            let d = p `less` exactly (points V.! i)
        ]
      )
  where
    points = meshPoints it
    bits = toInteger (integerLog2 over) * toInteger (V.length points)
    over = foldl' lcm 1 [denominator c | (x, y, z) <- IntMap.elems moves, c <- [x, y, z]]
    moved = V.imap (\i p -> maybe (scaled over p) whole (IntMap.lookup i moves)) points
    whole (x, y, z) = V3 (times x) (times y) (times z)
    times c = numerator c * (over `quot` denominator c)

-- | No more binary digits are made, of all coordinates together.
mostBits :: Integer
mostBits = 2 ^ (28 :: Int)

norm :: Q3 -> Rational
norm p = inner p p

-- | The point common to the planes that is nearest to a point.
common :: Q3 -> [Plane] -> Maybe Q3
common p = go p []
  where
    -- Each plane is met by a step along what its normal has at right angles to those before
    -- (Gram and Schmidt), which leaves the point on them.
    go q _ [] = Just q
    go q before (Plane n d : others)
      | norm off > 0 =
        go (q `plusTimes` (missing / inner off normal, off)) (off : before) others
      | missing == 0 = go q before others
      | otherwise = Nothing
      where
        normal = exactly n
        off = foldl' (\u v -> u `plusTimes` (negate (inner normal v / norm v), v)) normal before
        missing = d - inner normal q

-- | For each face a number that it has in common with those that belong to the same plane, nearly:
-- from the largest face on, faces across sides join that have all their corners within so many
-- millimetres of its plane, and look to the same side.
nearlyFlat :: Rational -> Mesh -> U.Vector Int
nearlyFlat mm it = U.generate (V.length walks) (\f -> IntMap.findWithDefault f f chosen)
  where
    walks = meshWalks it
    sides = surface walks
    points = meshPoints it
    areas = V.map (doubleArea . cornersOf it) walks
    chosen =
      foldl'
        seeded
        IntMap.empty
        (sortOn (\f -> Down (dot (areas V.! f) (areas V.! f))) [0 .. V.length walks - 1])
    seeded taken f
      | IntMap.member f taken || areas V.! f == zero = taken
      | otherwise = spread f taken [f]
    spread _ taken [] = taken
    spread seed taken (f : waiting)
      | IntMap.member f taken || not (fits seed f) = spread seed taken waiting
      | otherwise =
        spread
          seed
          (IntMap.insert f seed taken)
          ([sideFace sides t | s <- sidesOfFace sides f, Just t <- [mateOf sides s]] ++ waiting)
    fits seed f =
      dot n (areas V.! f) > 0 && U.all near (walks V.! f)
      where
        n = areas V.! seed
        o = points V.! (walks V.! seed U.! 0)
        reach = (mm * fromInteger (meshDenominator it)) ^ (2 :: Int) * fromInteger (dot n n)
        near v = fromInteger (dot n ((points V.! v) `minus` o)) ^ (2 :: Int) <= reach
