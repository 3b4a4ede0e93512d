{-# LANGUAGE OverloadedStrings #-}

-- | Compares an embossed surface in a file with the same surface at the origin. A motion changes no
-- triangle and no volume, but coordinates far away keep fewer digits after the point.
module Test.Recognition.Object.RoundedSurfaces (spec) where

import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import Data.Ratio ((%))
import qualified Data.Vector as V
import PraTactile.Array (Shape (..))
import PraTactile.Conformance.Laws.Solids (moved)
import PraTactile.Emboss
import PraTactile.Emboss.Rounding
import PraTactile.Format.Solid
import PraTactile.Object.Cells (Grid (..), bestGrid)
import PraTactile.Object.Mesh hiding (named)
import PraTactile.Object.Named
import PraTactile.Object.Placement
import PraTactile.Object.Validity
import PraTactile.Object.Vector
import PraTactile.Object.WingedEdge
import PraTactile.Profile
import Test.Effort
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck
import Test.Recognition.Object.Support (layingFor)
import Test.Support
import Test.Touch.Paper (paperAlphabet)

spec :: Spec
spec = do
  -- A rotated block 10^12 mm away along one axis was written as a plane figure of volume 0: no two
  -- points became one, and no triangle turned over.
  withCases 25 100 . prop "a solid far away is written as the same solid, or refused" $
    forAll (elements [minBound ..]) $ \body ->
      forAll (elements [Binary32, Decimals]) $ \precision ->
        forAll (elements [1, 1e-6, 1e-30, 1e-41]) $ \size ->
          forAll (choose (0, 16)) $ \far ->
            forAll (vectorOf 3 (elements [-1, 0, 1]) `suchThat` any (/= 0)) $ \ways ->
              ioProperty $ do
                let given = scaledBody size (described body)
                    way = map (size * 10 ^ (far :: Int) *) ways
                (_, here) <- embossedOn size given
                (whole, away) <- embossedOn size (movedBy way given)
                near <- right (rounded Decimals here)
                let least = if precision == Binary32 then 3 else 11
                pure . classify (far > least) "far" $ case written precision whole away of
                  Left why -> counterexample (show why) (size < 1e-6 || far > least)
                  Right found -> sameSolid near found (embossedVolume away)
  describe "a lens thinner than the steps between numbers of 32 bits is refused" $ do
    it "if its two sides cut each other" $
      lens 120 `refusedAs` \why -> why == Cut
    it "if little of it is left" $
      lens 1200 `refusedAs` \why -> case why of
        Deflated _ _ -> True
        _ -> False
  it "OBJ has every coordinate and triangle of the exact surface" $ do
    (_, made) <- embossedOn 1 (described Upright)
    exact <- right (rounded Fractions made)
    it' <- right (rounded Decimals made)
    roundedMost it' `shouldBe` 0
    readBack <- readAgain it'
    places readBack `shouldBe` places (roundedMesh exact)
    meshWalks readBack `shouldBe` meshWalks (roundedMesh exact)
  it "OBJ has a slanted face to the precision of numbers of 64 bits" $ do
    (_, made) <- embossedOn 1 (described Slanted)
    readBack <- right (rounded Decimals made) >>= readAgain
    reportDefects (examine readBack) `shouldBe` []
    abs (fromRational (enclosedBy readBack) / nearestVolume (embossedVolume made) - 1)
      `shouldSatisfy` (< 1e-14)
  where
    written precision whole made = do
      it' <- rounded precision made
      it' <$ uncut whole made it'
    refusedAs body why = do
      (whole, made) <- embossedOn 1 body
      either why (const False) (written Binary32 whole made) `shouldBe` True
      either (const False) (const True) (written Decimals whole made) `shouldBe` True
    readAgain it' =
      either (fail . show) (pure . contentsMesh) . readSolid Obj "again" . Lazy.toStrict $
        Builder.toLazyByteString (writtenBytes (writeSolid Obj (roundedMesh it')))
    places one = V.generate (V.length (meshPoints one)) (pointAt one)

-- | Whether a rounded surface is that of a solid, and no further from the surface near the origin
-- than rounding allows. With S the surface and m the largest move of a coordinate, its volume is
-- within sqrt 3 m S, times the growth of the triangles.
sameSolid :: Rounded -> Rounded -> Volume -> Property
sameSolid near it' told =
  conjoin
    [ reportDefects (examine (roundedMesh it')) === [],
      meshWalks (roundedMesh near) === meshWalks (roundedMesh it'),
      conjoin (zipWith alike (areas near) (areas it')),
      counterexample (show (found, told)) $
        abs (found - nearestVolume told)
          <= 1.5 * sqrt 3 * roundedMost it' * surface + 1e-12 * nearestVolume told
    ]
  where
    found = fromRational (enclosedBy (roundedMesh it')) :: Double
    surface = sum (map size (areas near))
    alike a b =
      counterexample (show (a, b)) $
        size b > 0.49 * size a && size b < 1.51 * size a && along a b > 0.8 * size a * size b
    areas one =
      [ let V3 x y z = doubleArea (cornersOf (roundedMesh one) walk)
            part k = fromRational (k % (2 * meshDenominator (roundedMesh one) ^ (2 :: Int)))
         in (part x, part y, part z)
        | walk <- V.toList (meshWalks (roundedMesh one))
      ] ::
        [(Double, Double, Double)]
    along (a, b, c) (d, e, f) = a * d + b * e + c * f
    size a = sqrt (along a a)

-- | Solids to be moved.
data Body = Upright | Tilted | Slanted
  deriving stock (Eq, Show, Enum, Bounded)

described :: Body -> Description
described body = case body of
  Upright -> block
  Slanted -> namedDescription (Tetrahedron 150)
  Tilted -> moved tilted block
  where
    block = namedDescription (Box 110 110 110)
    -- The rotation of the quaternion (7, 1, 2, 1), whose matrix has fractions over 55.
    tilted (Point x y z) =
      Point
        ((45 * x - 10 * y + 30 * z) / 55)
        ((18 * x + 51 * y - 10 * z) / 55)
        ((-26 * x + 18 * y + 45 * z) / 55)

-- | A square of this width, 10 m up, with a point 0.0001 mm above it and one as far below.
lens :: Rational -> Description
lens wide =
  Description
    { describedName = "lens",
      describedVertices =
        zip
          (map (VertexName . pure) "abcdtu")
          ( [Point x y 10000 | (x, y) <- [(0, 0), (wide, 0), (wide, wide), (0, wide)]]
              ++ [Point (wide / 2) (wide / 2) (10000 + 1e-4)]
              ++ [Point (wide / 2 + 1) (wide / 2) (10000 - 1e-4)]
          ),
      describedFaces =
        [readFaceName (unwords [p, q, "t"]) | (p, q) <- sides]
          ++ [readFaceName (unwords [q, p, "u"]) | (p, q) <- sides]
    }
  where
    sides = [("a", "b"), ("b", "c"), ("c", "d"), ("d", "a")]

movedBy :: [Rational] -> Description -> Description
movedBy way = moved $ \(Point x y z) -> case zipWith (+) way [x, y, z] of
  [x', y', z'] -> Point x' y' z'
  _ -> Point x y z

scaledBody :: Rational -> Description -> Description
scaledBody k = moved (\(Point x y z) -> Point (k * x) (k * y) (k * z))

-- | A solid with one symbol on its first face, larger than the paper's by this factor.
embossedOn :: Rational -> Description -> IO (Solid, Embossed)
embossedOn larger body = do
  whole <- right (solid body)
  given <- right paperAlphabet
  let walk = V.head (meshWalks (solidMesh whole))
      between = Pitch (larger * 127 / 5) (larger * 127 / 4)
      grid = bestGrid (solidMesh whole) (larger * 127 / 5, larger * 127 / 4) walk
      laying = layingFor whole grid (take 1 (gridCells grid))
  layout <- right (placement (Shape 15 17) between [whole] [laying])
  made <-
    right
      =<< right
        ( withProfile canonicalProfile $ \array _ ->
            embossed given array layout (WholeObject (solidName whole))
        )
  pure (whole, made)
