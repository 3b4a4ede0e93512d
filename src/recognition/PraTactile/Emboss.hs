{-# OPTIONS_HADDOCK hide #-}

-- | Embossed objects as closed surfaces of triangles with exact points: a solid, or one of its
-- faces as a plate, with its symbols raised (the paper's section II.B, figure 9).
--
-- A symbol lies in the middle of its cell, and the cell lies on the face, so symbols touch neither
-- the rim nor each other. A solid with Euler characteristic x, v vertices and k outline corners
-- thus becomes a surface of v + 2 k points and 2 (v + 2 k - x) triangles. Each raised taxel of side
-- t and height h adds t^2 h to the volume.
module PraTactile.Emboss
  ( -- * Making
    EmbossSubject (..),
    subjectName,
    Embossed (..),
    Volume (..),
    volume,
    nearestVolume,
    enclosedBy,
    embossed,
    embossedPlate,
    usualThickness,
    symbolsOn,
    mostSymbols,

    -- * What is refused
    EmbossError (..),
  )
where

import Control.Monad (when)
import Data.Bifunctor (first)
import Data.Containers.ListUtils (nubOrdOn)
import qualified Data.IntMap.Strict as IntMap
import Data.List (mapAccumL)
import Data.Maybe (fromMaybe)
import Data.Ratio ((%))
import qualified Data.Set as Set
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import Numeric.Natural (Natural)
import PraTactile.Array (Position, PseudorandomArray, Shape (..), area)
import PraTactile.Emboss.Face
import PraTactile.Field (KnownField, fieldOrder)
import PraTactile.Geometry (columnPitch, rowPitch, symbolThickness, taxelPitch)
import PraTactile.Object.Chart
import PraTactile.Object.Description (cyclicPairs)
import PraTactile.Object.Mesh hiding (named)
import PraTactile.Object.Placement
import PraTactile.Object.Radicals (fraction)
import PraTactile.Object.Rims
import PraTactile.Object.Triangles (triangles)
import PraTactile.Object.Vector (cross, dot, exactRoot, squareRoot)
import PraTactile.Object.WingedEdge
import PraTactile.Relief (ReliefError (..), classOn, symbolScale)
import PraTactile.Shape (Alphabet, shapeName, shapeOf)
import PraTactile.Shape.Outline (Contact (..), Corner)

-- | What is embossed.
data EmbossSubject
  = -- | the object with this name
    WholeObject ObjectName
  | -- | the face with this name, begun at any vertex, as a plate; its thickness in millimetres, or
    -- 'usualThickness'
    PlateOf ObjectName FaceName (Maybe Rational)
  deriving stock (Eq, Show)

-- | The name of the object, or of the object whose face becomes a plate.
subjectName :: EmbossSubject -> ObjectName
subjectName subject = case subject of
  WholeObject object -> object
  PlateOf object _ _ -> object

-- | Why nothing is embossed.
data EmbossError
  = -- | There is no such object or face, or the face has no cells.
    NotThere PlacementError
  | -- | No face of the object is laid on the array.
    NothingRaised ObjectName
  | -- | The array has an element without a shape, or the pitch is not the paper's times one factor.
    NotEmbossed ReliefError
  | -- | In the shape with this name, two taxels meet only at this corner. Four walls would meet
    -- along one line.
    CornerContact String Corner
  | -- | More than 'mostSymbols' would be raised.
    TooManySymbols Natural
  | -- | Symbols of the first height are not lower than the plate's thickness, in millimetres.
    TooThin Rational Rational
  deriving stock (Eq, Show)

-- | The volume r + sqrt s, as r and s, in cubic millimetres.
data Volume = Volume !Rational !Rational
  deriving stock (Eq, Show)

-- | The volume r + sqrt s. If the root is rational it is added to r, and s becomes 0.
volume :: Rational -> Rational -> Volume
volume r s = maybe (Volume r s) (\root -> Volume (r + root) 0) (exactRoot s)

-- | The volume as a 'Double', exact to a few units in the last place.
nearestVolume :: Volume -> Double
nearestVolume (Volume r s) = fromRational r + squareRoot s

-- | An embossed surface.
data Embossed = Embossed
  { embossedSubject :: EmbossSubject,
    -- | for a plate, its face as it is laid
    embossedFace :: Maybe FaceName,
    -- | the names of the object's vertices, which are the first points
    embossedNames :: V.Vector VertexName,
    embossedPoints :: V.Vector ExactPoint,
    -- | by the indices of points, counter-clockwise as seen from outside
    embossedTriangles :: V.Vector (Int, Int, Int),
    embossedVolume :: Volume,
    -- | the number of raised taxels
    embossedTaxels :: Int,
    -- | the smallest width of a raised stroke along a row or a column, in millimetres
    embossedStroke :: Rational,
    -- | the height of the relief, in millimetres
    embossedHeight :: Rational
  }

-- | The default thickness of a plate, as a multiple of the symbols' height: 2.
usualThickness :: Rational
usualThickness = 2

-- | The most symbols that are embossed at once. They take about half a minute and two gigabytes.
mostSymbols :: Natural
mostSymbols = 16384

-- | Embosses an object, or one face as a plate. Symbols of faces that look at each other may run
-- into one another; this is not checked here. O(n log n) in the corners of each face.
embossed ::
  KnownField k =>
  Alphabet ->
  PseudorandomArray k ->
  Placement ->
  EmbossSubject ->
  Either EmbossError Embossed
embossed alphabet array layout subject = do
  object <- first NotThere (findObject layout named)
  laid <- case subject of
    WholeObject _ -> Right [one | one <- laidFaces layout, faceObject (laidFace one) == named]
    PlateOf _ asked _ -> (: []) <$> first NotThere (findFace layout named asked)
  (scale, symbols) <- symbolsOn alphabet array layout laid
  case (subject, laid) of
    (PlateOf _ _ thick, one : _) -> embossedPlate scale thick object one (symbols one)
    (_, []) -> Left (NothingRaised named)
    (_, _) ->
      Right
        ( made
            subject
            Nothing
            scale
            (concatMap (map snd . symbols) laid)
            (whole (scale * taxelPitch) (scale * symbolThickness) symbols layout object)
            (Volume (enclosedBy (solidMesh object)) 0)
        )
  where
    named = subjectName subject

-- | A laid face of an object as a plate. Arguments: the symbols' size relative to the paper's; the
-- thickness, or 'usualThickness'; the object; the face; its symbols and their cells. Refuses a
-- plate that is not thicker than the symbols are high, and a face that is not the object's.
embossedPlate ::
  Rational ->
  Maybe Rational ->
  Solid ->
  LaidFace ->
  [(Position, Stamp)] ->
  Either EmbossError Embossed
embossedPlate scale thick object laid symbols = do
  when (thickness <= height) (Left (TooThin height thickness))
  walk <- maybe (Left (NotThere (UnknownFace (laidFace laid)))) Right (walkNamed object face)
  chart <- maybe (Left (NothingRaised named)) Right (chartOfLaid taxel laid object walk)
  pure
    ( made
        (PlateOf named face thick)
        (Just face)
        scale
        (map snd symbols)
        (plate height thickness symbols object walk chart)
        (plateVolume thickness object walk)
    )
  where
    Face named face = laidFace laid
    (taxel, height) = (scale * taxelPitch, scale * symbolThickness)
    thickness = fromMaybe (usualThickness * height) thick

-- | Assembles the result from the symbols' size relative to the paper's, the symbols, the surface,
-- and the volume of the body without symbols.
made :: EmbossSubject -> Maybe FaceName -> Rational -> [Stamp] -> Parts -> Volume -> Embossed
made subject face scale symbols (names, points, cut) (Volume r s) =
  Embossed
    { embossedSubject = subject,
      embossedFace = face,
      embossedNames = names,
      embossedPoints = points,
      embossedTriangles = V.fromList cut,
      embossedVolume = Volume (r + fromIntegral taxels * taxel * taxel * height) s,
      embossedTaxels = taxels,
      embossedStroke = taxel * fromIntegral (minimum (map stampStroke symbols)),
      embossedHeight = height
    }
  where
    taxels = sum (map stampArea symbols)
    (taxel, height) = (scale * taxelPitch, scale * symbolThickness)

-- | The symbols' size relative to the paper's, and a function that gives the symbols of each of
-- these faces with their cells, by row and column of the face's block.
symbolsOn ::
  KnownField k =>
  Alphabet ->
  PseudorandomArray k ->
  Placement ->
  [LaidFace] ->
  Either EmbossError (Rational, LaidFace -> [(Position, Stamp)])
symbolsOn alphabet array layout laidAll = do
  when (count > mostSymbols) (Left (TooManySymbols count))
  scale <- maybe (Left (NotEmbossed (PitchNotFelt pitch))) Right (symbolScale pitch)
  stamps <- V.fromList <$> traverse stamped [0 .. fieldOrder array - 1]
  pure
    ( scale,
      \laid -> [(cell, stamps V.! classOn array laid cell) | cell <- blockCells (laidBlock laid)]
    )
  where
    pitch = placementPitch layout
    count = sum (map (cellCount . laidBlock) laidAll)
    cellCount (Block shape listed) = maybe (area shape) (fromIntegral . Set.size) listed
    stamped k = do
      bitmap <- first (NotEmbossed . NoShape) (shapeOf alphabet k)
      first (\(Contact at) -> CornerContact (shapeName alphabet k) at) (stampOf bitmap)

-- | The names of the vertices, all points, and the triangles.
type Parts = (V.Vector VertexName, V.Vector ExactPoint, [(Int, Int, Int)])

-- | A solid with these symbols on its laid faces. The first two numbers are the side and the height
-- of a taxel in millimetres.
whole ::
  Rational -> Rational -> (LaidFace -> [(Position, Stamp)]) -> Placement -> Solid -> Parts
whole taxel height symbols layout object =
  ( V.take count (meshNames it),
    V.map fixed (V.generate count (pointAt it))
      V.++ V.concat (map (V.fromList . surfacePoints) faces),
    concatMap surfaceTriangles faces
  )
  where
    it = solidMesh object
    count = V.length (meshPoints it)
    faces = snd (mapAccumL face count [0 .. V.length (meshWalks it) - 1])
    face from f =
      let one = faceOf from f
       in (from + length (surfacePoints one), one)
    faceOf from f = case placementLaid layout (Face (solidName object) (faceAt it f)) of
      Just laid
        | Just walk <- walkNamed object (faceName (laidFace laid)),
          Just chart <- chartOfLaid taxel laid object walk ->
          raisedFace height chart walk from (symbols laid)
      _ -> bare (meshWalks it V.! f)
    bare walk =
      maybe
        (RaisedMesh [] (triangles it walk))
        (\chart -> raisedFace 0 chart walk 0 [])
        (chartOf it walk 1 (1, 1) Centred (0, 0))

-- | The chart of a laid face: its lattice of taxels, from the block's upper left corner.
chartOfLaid :: Rational -> LaidFace -> Solid -> Walk -> Maybe Chart
chartOfLaid taxel laid object walk =
  chartOf
    (solidMesh object)
    walk
    taxel
    (columnPitch, rowPitch)
    (laidAnchor laid)
    (toInteger (rows grid), toInteger (columns grid))
  where
    grid = laidGrid laid

-- | A face as a plate: its corners, the corners below them, and its symbols. The first two numbers
-- are the height of the symbols and the thickness, in millimetres.
plate :: Rational -> Rational -> [(Position, Stamp)] -> Solid -> Walk -> Chart -> Parts
plate height thickness symbols object walk chart =
  ( V.map (meshNames it V.!) (V.fromList corners),
    V.fromList
      ( [pointOn chart z (Corner k) | z <- [0, negate thickness], k <- places]
          ++ surfacePoints above
      ),
    surfaceTriangles above
      ++ [(count + a, count + c, count + b) | (a, b, c) <- below]
      ++ concat
        [ [(count + a, count + b, b), (count + a, b, a)]
          | (a, b) <- concatMap cyclicPairs loops
        ]
  )
  where
    it = solidMesh object
    -- Each vertex once, at the first place where the walk reaches it.
    (corners, places) =
      unzip (nubOrdOn fst (zip (U.toList walk) [0 ..]))
    count = length corners
    numbers = IntMap.fromList (zip corners [0 ..])
    loops = map (map (numbers IntMap.!)) (rims (U.toList walk))
    above = raisedFace height chart (U.map (numbers IntMap.!) walk) (2 * count) symbols
    below = region chart (map Corner places) loops

-- | An exact point for a vertex of the object.
fixed :: Point -> ExactPoint
fixed (Point x y z) = ExactPoint (fraction x) (fraction y) (fraction z)

-- | The volume that a closed surface encloses, in cubic millimetres: a sixth of the sum of its
-- triangles' determinants with the origin.
enclosedBy :: Mesh -> Rational
enclosedBy it = sixfold % (6 * meshDenominator it ^ (3 :: Int))
  where
    sixfold = sum (map (fan . V.toList . cornersOf it) (V.toList (meshWalks it)))
    fan corners = case corners of
      o : others -> sum (zipWith (\p q -> dot o (cross p q)) others (drop 1 others))
      [] -> 0

-- | The volume of a plate: half the length of the face's normal, times the thickness.
plateVolume :: Rational -> Solid -> Walk -> Volume
plateVolume thickness object walk =
  volume 0 (thickness * thickness * (dot n n % (4 * d ^ (4 :: Int))))
  where
    it = solidMesh object
    d = meshDenominator it
    n = doubleArea (cornersOf it walk)
