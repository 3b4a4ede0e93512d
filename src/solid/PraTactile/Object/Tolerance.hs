-- | Undoes the effects of rounding on a polyhedron, where possible: vertices that are close
-- together become one, and faces become exactly flat again.
--
-- A face with more than three corners gets the plane n . x = n . m, where n is its area vector and
-- m the mean of its corners; both are rational. A vertex v on up to three such planes goes to the
-- nearest point common to them. That is v - sum l_i n_i, where the l_i solve sum_j (n_i . n_j) l_j
-- = n_i . (v - m_i), without dependent planes. It stays if there is no such point, or the point is
-- too far away. Triangles stay flat however their corners move.
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

-- | The result of a repair.
data Settled = Settled
  { settledMesh :: Mesh,
    -- | the number of vertices that moved, including those joined with a vertex at another place
    settledMoved :: Int,
    -- | the largest distance moved, in millimetres
    settledMost :: Double,
    -- | the number of faces left out, because they lost their area
    settledLeftOut :: Int
  }

-- | Repairs a polyhedron with a tolerance in millimetres. Vertices within the tolerance are joined,
-- each at the first of them in the file's order. Faces within the tolerance of a line are left out
-- ("PraTactile.Object.Sliver"). Other vertices move by at most the tolerance so that faces become
-- flat. With 'True', faces count as one face if they share sides and lie within the tolerance of
-- the largest one's plane, as if an exporter had cut it into triangles. Faces with fewer than three
-- vertices are left out. Refuses if the new points have a common denominator that is too large to
-- compute with.
settled :: Rational -> Bool -> Mesh -> Either TooFine Settled
settled mm together it = joined mm it >>= levelled mm together

-- | The first half of 'settled': joins vertices and leaves out faces on a line.
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

-- | The second half of 'settled': moves vertices so that faces become flat.
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

-- | The coordinates of flat faces would need this number of binary digits over their common
-- denominator; the limit is 2^28.
newtype TooFine = TooFine Integer
  deriving stock (Eq, Show)

-- | A tolerance, in millimetres, with which faces that are not flat become flat: the largest
-- distance that a vertex must move, rounded up to three digits. 'Nothing' if no tolerance suffices.
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

-- | Joins vertices that are near each other. Also returns the distance that each moved.
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
    -- The tolerance in units of coordinates, and in those of boxes.
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

-- | A plane: its normal, and the scalar product of the normal with its points.
data Plane = Plane V3 Rational

-- | Moves vertices, by at most this many millimetres, so that faces become flat. Also returns the
-- distance that each moved.
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

-- | Moves vertices to other places, in units of the polyhedron's coordinates. Also returns the
-- distance that each moved, in millimetres.
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

-- | The most binary digits of all coordinates together.
mostBits :: Integer
mostBits = 2 ^ (28 :: Int)

norm :: Q3 -> Rational
norm p = inner p p

-- | The point nearest to a given one that all planes have in common, if any.
common :: Q3 -> [Plane] -> Maybe Q3
common p = go p []
  where
    -- Each plane is reached by a step along the part of its normal that is orthogonal to the
    -- earlier ones (Gram and Schmidt). So the point stays on those.
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

-- | For each face the number of its plane, approximately. From the largest face on, faces across
-- sides join it if all their corners are within this many millimetres of its plane and they face
-- the same way.
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
