-- | Tests the parts of segmentation, each against its definition: connected regions, sides, levels,
-- noise, and the steps of the lattice.
module Test.Touch.Segmentation.PartsByDefinition (spec) where

import Data.Bifunctor (bimap)
import Data.List (sort)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as V
import PraTactile.Composite (leastCoverage)
import PraTactile.Composite.Level
import PraTactile.Geometry (columnPitch, rowPitch)
import PraTactile.Image
import PraTactile.Registration (Composite (..), compositeOf)
import PraTactile.Segmentation (Part (..), Segmentation (..), SymbolImage (..), leastSeen, partAt)
import PraTactile.Segmentation.Box
import PraTactile.Segmentation.Lattice
import PraTactile.Segmentation.Masked
import PraTactile.Segmentation.Region
import Test.Effort (withCases)
import Test.Hspec hiding (around)
import Test.QuickCheck hiding (generate)
import Test.Touch.Image.RastersAndCorrelation (genRasterOf)

spec :: Spec
spec = do
  describe "Regions" regionSpec
  describe "Sides" sideSpec
  describe "Levels" levelSpec
  describe "Noise" noiseSpec
  describe "Steps" stepSpec
  describe "Parts" partSpec

-- | A field of this size with these pixels marked.
newtype Marked = Marked (Int, Int, [Bool])
  deriving stock (Show)

instance Arbitrary Marked where
  arbitrary = do
    w <- choose (1, 9)
    h <- choose (1, 9)
    often <- choose (1, 4)
    Marked . (,,) w h <$> vectorOf (w * h) (frequency [(1, pure True), (often, pure False)])

regionSpec :: Spec
regionSpec = withCases 25 200 $ do
  it "are connected by chains of near pixels, and contain each pixel once" $
    property $ \(Marked (w, h, marks)) -> forAll (choose (0, 2)) $ \gap ->
      let pixels = [p | (p, True) <- zip [0 ..] marks]
          near p p' = distance w p p' <= gap + 1
       in sort (map sort (components (plain w h) gap pixels))
            === sort (map sort (connected near pixels))
  it "grow by all pixels within a distance" $
    property $ \(Marked (w, h, marks)) -> forAll (choose (0, 3)) $ \far ->
      let pixels = [p | (p, True) <- zip [0 ..] marks]
          wanted = [p | p <- [0 .. w * h - 1], any ((<= far) . distance w p) pixels]
       in around (plain w h) far pixels === wanted
  it "have as neighbours the adjacent pixels within the field" $
    property $ \(Marked (w, h, _)) -> forAll ((,) <$> choose (-4, 4) <*> choose (-4, 4)) $
      \(i, j) ->
        [beside (plain w h) p (i, j) | p <- [0 .. w * h - 1]]
          === [ if x + i `elem` [0 .. w - 1] && y + j `elem` [0 .. h - 1]
                  then Just ((y + j) * w + x + i)
                  else Nothing
                | y <- [0 .. h - 1],
                  x <- [0 .. w - 1]
              ]
          .&&. map (placeOf (plain w h)) [0 .. w * h - 1]
          === [(x, y) | y <- [0 .. h - 1], x <- [0 .. w - 1]]
  it "extend from the first to the last of their pixels, each of which is one wide" $
    property $ \(Marked (w, h, marks)) -> forAll (choose (-180, 180)) $ \angle ->
      let pixels = [p | (p, True) <- zip [0 ..] marks]
          places = map (bimap fromIntegral fromIntegral . placeOf (plain w h)) pixels
          along = [x * cosine angle + y * sine angle | (x, y) <- places]
          (xs, ys) = unzip places :: ([Double], [Double])
          box = (minimum xs - 0.5, minimum ys - 0.5, maximum xs + 0.5, maximum ys + 0.5)
       in if null pixels
            then
              extentAlong (plain w h) [] angle === 0
                .&&. regionBox (plain w h) [] === (0, 0, 0, 0)
            else
              near' (maximum along - minimum along + 1) (extentAlong (plain w h) pixels angle)
                .&&. regionBox (plain w h) pixels === box
  it "are smoothed to means of the touched pixels around each, near ones with more weight" $
    forAll (genComposite (0, 6)) $ \composite ->
      let (w, h) = sizeOf composite
          touched x y = maybe False (>= leastCoverage) (index (compositeCoverage composite) x y)
          value x y =
            let parts =
                  [ (k, k * v)
                    | i <- [-1, 0, 1],
                      j <- [-1, 0, 1],
                      touched (x + i) (y + j),
                      Just v <- [index (compositeImage composite) (x + i) (y + j)],
                      let k = (2 - abs (fromIntegral i)) * (2 - abs (fromIntegral j))
                  ]
             in if null parts then 0 else sum (map snd parts) / sum (map fst parts)
          pixels = smoothed (masked composite)
          places = [(x, y) | y <- [0 .. h - 1], x <- [0 .. w - 1]]
       in (maskedWidth pixels, maskedHeight pixels) === (w, h)
            .&&. map (isTouched pixels) [0 .. w * h - 1] === map (uncurry touched) places
            .&&. conjoin
              [ maybe (property False) (near' (value x y)) (valueAt pixels (x, y))
                | (x, y) <- places,
                  touched x y
              ]
  where
    distance w p p' =
      max (abs (p `mod` w - p' `mod` w)) (abs (p `div` w - p' `div` w))
    cosine angle = cos (angle * pi / 180)
    sine angle = sin (angle * pi / 180)

-- | The classes connected by chains of pairs.
connected :: (a -> a -> Bool) -> [a] -> [[a]]
connected near = foldr add []
  where
    add p others =
      let joined = filter (any (near p)) others
       in (p : concat joined) : filter (not . any (near p)) others

plain :: Int -> Int -> Masked
plain w h = masked (compositeOf (constant w h 0))

near' :: Double -> Double -> Property
near' wanted came = counterexample (show (wanted, came)) (abs (wanted - came) < 1e-9)

genComposite :: (Int, Int) -> Gen Composite
genComposite range = do
  w <- choose range
  h <- choose range
  image <- genRasterOf w h
  coverage <- genRasterOf w h
  pure (composed image coverage)

composed :: Raster -> Raster -> Composite
composed image coverage = (compositeOf image) {compositeCoverage = coverage}

sizeOf :: Composite -> (Int, Int)
sizeOf composite =
  (rasterWidth (compositeImage composite), rasterHeight (compositeImage composite))

-- | A box of embossing whose sides lie at fractions of pixels, on a touched field.
sideSpec :: Spec
sideSpec = do
  it "lie where the intensity passes the threshold" $
    forAll ((,) <$> choose (0, 0.49) <*> choose (0, 0.49)) $ \(a, b) ->
      -- The pixel before the box has the share a of the embossing, the one behind the share b.
      let at (x, y)
            | y < 0 || y > 20 = 0
            | x == 9 = a
            | x == 18 = b
            | x >= 10 && x <= 17 = 1
            | otherwise = 0
          pixels = masked (compositeOf (generate 30 30 (curry at)))
          region = [30 * y + x | x <- [10 .. 17], y <- [5 .. 15]]
          from = 9 + (0.5 - a) / (1 - a)
          to = 18 - (0.5 - b) / (1 - b)
       in case horizontalExtent pixels 0.5 region of
            Just (Extent left right) ->
              near' from (sidePlace left)
                .&&. near' to (sidePlace right)
                .&&. (sideOpen left, sideOpen right) === (False, False)
            Nothing -> property False
  it "are open if the pixel beyond one of the symbol's was not touched" $
    forAll ((,) <$> choose (8, 20) <*> choose (4, 16)) $ \(x0, y0) ->
      let inBox x y = x `elem` [10 .. 17] && y `elem` [5 .. 14]
          embossed = generate 30 30 (\x y -> if inBox x y then 1 else 0)
          felt = generate 30 30 (\x y -> if (x, y) == (x0, y0) then 0 else 1)
          pixels = masked (composed embossed felt)
          places = [(x, y) | x <- [10 .. 17], y <- [5 .. 14]]
          region = [30 * y + x | (x, y) <- places]
          opens extent = [(sideOpen a, sideOpen b) | Just (Extent a b) <- [extent]]
          beyond (x, y) = (x0, y0) == (x, y)
          besides i j = any (\(x, y) -> beyond (x + i, y + j)) places
       in opens (horizontalExtent pixels 0.5 region) === [(besides (-1) 0, besides 1 0)]
            .&&. opens (verticalExtent pixels 0.5 region) === [(besides 0 (-1), besides 0 1)]
  it "of a transposed image are those of the other direction" $
    forAll (vectorOf 40 ((,) <$> choose (0, 8) <*> choose (0, 8))) $ \places ->
      forAll (genRasterOf 9 9) $ \image ->
        let over = generate 9 9 (\x y -> fromMaybe 0 (index image y x))
            extentOf measured picture = measured (masked (compositeOf picture)) 0.5
         in extentOf verticalExtent image [9 * y + x | (x, y) <- places]
              === extentOf horizontalExtent over [9 * x + y | (x, y) <- places]
  it "do not exist without pixels" $
    (horizontalExtent (plain 9 9) 0.5 [], verticalExtent (plain 9 9) 0.5 [])
      `shouldBe` (Nothing, Nothing)

-- | For whole numbers from 0 to 511 and one 512, each has its own bin except for the last two.
levelSpec :: Spec
levelSpec = do
  withCases 40 100 . it "are the medians on both sides of Otsu's threshold" $
    forAll genGrey $ \grey ->
      let found = levels 0 (V.fromList (map fromIntegral grey))
          binned = Map.fromListWith (+) [(min 511 g, 1) | g <- grey]
          bins = [Map.findWithDefault 0 i binned | i <- [0 .. 511]] :: [Int]
          weighed = zipWith (*) bins [0 ..]
          (everything, moment) = (count bins, count weighed)
          -- The variance between the parts, times the square of all.
          splits =
            [ (n * n' * (m / n - m' / n') * (m / n - m' / n'), i)
              | (i, n, m) <- drop 1 (zip3 [0 .. 511] (sums bins) (sums weighed)),
                let (n', m') = (everything - n, moment - m),
                n > 0 && n' > 0
            ]
          best = maximum (map fst splits)
          candidates =
            [ (medianOf 0 below, medianOf (fromIntegral i) above)
              | (variance, i) <- splits,
                variance >= best * (1 - 1e-12),
                let (below, above) = splitAt i bins
            ]
          close (a, b) (Levels low high) = abs (a - low) < 1e-9 && abs (b - high) < 1e-9
          medians = maybe False (\l -> any (`close` l) candidates) found
       in counterexample (show (candidates, found)) medians
  it "do not exist for equal or no values, or with too little contrast for noise or 8 bits" $ do
    let two noise high =
          levels
            (leastContrast (1 / 255) noise)
            (V.fromList (replicate 10 0 ++ replicate 30 high))
        -- Half a bin from the ends.
        apart high = high * 511 / 512
    levels 0 V.empty `shouldBe` Nothing
    levels 0 (V.replicate 9 0.5) `shouldBe` Nothing
    two 0 1 `shouldBe` Just (Levels (1 / 1024) (1023 / 1024))
    two (apart 1 / 4 - 1e-9) 1 `shouldBe` two 0 1
    two (apart 1 / 4 + 1e-9) 1 `shouldBe` Nothing
    two 0 ((2 / 255 - 1e-9) * 512 / 511) `shouldBe` Nothing
    (contrast <$> two 0 ((2 / 255 + 1e-9) * 512 / 511)) `shouldSatisfy` (/= Nothing)
  it "have the threshold in the middle" $
    property $ \low high -> do
      near' ((low + high) / 2) (threshold (Levels low high))
        .&&. near' (high - low) (contrast (Levels low high))
  where
    genGrey :: Gen [Int]
    genGrey = do
      middle <- choose (100, 400)
      dark <- listOf1 (choose (0, middle - 50))
      light <- listOf1 (choose (middle + 50, 512))
      pure (0 : 512 : dark ++ light)
    count = fromIntegral . sum :: [Int] -> Double
    -- Of the first ones, from none on.
    sums = map fromIntegral . scanl (+) 0 :: [Int] -> [Double]
    -- The place with half of a part below, as if the part were spread evenly within its bin.
    medianOf from part =
      head'
        [ from + i + (count part / 2 - below) / fromIntegral c
          | (i, c, below) <- zip3 [0 ..] part (scanl (+) 0 (map fromIntegral part)),
            c > 0,
            below + fromIntegral c >= count part / 2
        ]
    head' = foldr const 0 :: [Double] -> Double

noiseSpec :: Spec
noiseSpec = do
  it "is the median size over 0.6745 and the root of 6, to a 512th of the largest" $
    forAll (listOf1 (choose (-1, 1))) $ \some ->
      let sizes = sort (map abs some)
          largest = maximum sizes
          lower = sizes !! ((length sizes - 1) `div` 2)
          upper = sizes !! (length sizes `div` 2)
          found = medianSize (V.fromList some)
       in counterexample (show (lower, found, upper)) $
            found >= lower - largest / 512 && found <= upper + largest / 512
              && abs (noiseFrom (V.fromList some) * 0.6745 * sqrt 6 - found) < 1e-9
  it "is 0 without values" $ (medianSize V.empty, noiseFrom V.empty) `shouldBe` (0, 0)
  it "is the larger one of rows and columns, where all three pixels were touched" $
    forAll ((,) <$> choose (0, 0.01) <*> choose (0, 0.01)) $ \(a, b) ->
      -- Second differences of 2 a along the rows and of 2 b along the columns.
      let value x y = a * fromIntegral (x * x) + b * fromIntegral (y * y)
          image = generate 9 8 value
          whole = masked (composed image (constant 9 8 1))
          -- Untouched pixels are ignored, whatever their values.
          untouched x y = (x, y) `elem` [(4, 4), (0, 7), (8, 0)]
          spoilt = generate 9 8 (\x y -> if untouched x y then 100 else value x y)
          coverage = generate 9 8 (\x y -> if untouched x y then 0 else 1)
          part = masked (composed spoilt coverage)
          wanted = 2 * max a b / (0.6745 * sqrt 6)
          close came =
            counterexample (show (wanted, came)) (abs (came - wanted) <= wanted / 500 + 1e-9)
       in close (pixelNoise whole) .&&. close (pixelNoise part)
  it "is reduced by a weighted mean to the root of the sum of its squared weights" $ do
    let weights = [k * k' / 16 | k <- [1, 2, 1], k' <- [1, 2, 1]]
    smoothing `shouldBe` sqrt (sum (map (^ (2 :: Int)) weights))

-- | A symbol at this place and with this axis.
symbolAt :: (Double, Double) -> Double -> SymbolImage
symbolAt place axis =
  SymbolImage
    { symbolCentre = place,
      symbolAxis = axis,
      symbolPixels = constant 8 12 0,
      symbolSize = (8, 12)
    }

stepSpec :: Spec
stepSpec = do
  it "lead to the cell one pitch away, to four taxels along each axis" $
    forAll (elements [(0, 1), (0, -1), (1, 0), (-1, 0)]) $ \cell@(i, j) ->
      forAll (choose (-180, 180)) $ \axis -> forAll (off <$> choose (-6, 6)) $ \along ->
        forAll (off <$> choose (-6, 6)) $ \across ->
          let (x, y) =
                ( columnPitch * fromIntegral (j :: Int) + along,
                  rowPitch * fromIntegral (i :: Int) + across
                )
              (c, s) = (cos (axis * pi / 180), sin (axis * pi / 180))
              there = (100 + c * x - s * y, 50 + s * x + c * y)
              lies = max (abs along) (abs across) <= 4
           in neighbour (symbolAt (100, 50) axis) (symbolAt there axis)
                === (if lies then Just cell else Nothing)
  it "do not exist if they fail along one symbol's axis" $
    forAll (choose (-90, 90)) $ \axis ->
      neighbour (symbolAt (0, 0) 0) (symbolAt (columnPitch, 0) axis)
        === (if columnPitch * abs (sin (axis * pi / 180)) <= 4 then Just (0, 1) else Nothing)
  it "are counted from the other end upside down" $
    property $ \cells ->
      let there :: Map.Map ClusterCell Int
          there = Map.fromList [((abs i, abs j), k) | ((i, j), k) <- cells]
          (bottom, right') = (most (map fst (Map.keys there)), most (map snd (Map.keys there)))
       in halfTurned there
            === Map.fromList [((bottom - i, right' - j), k) | ((i, j), k) <- Map.toList there]
  where
    -- Not at the limit itself, which rounding decides.
    off d = if abs (abs d - 4) < 1e-6 then 0 else d :: Double
    most = foldr max 0

-- | Around a place from which a symbol's box lies on pixels.
partSpec :: Spec
partSpec =
  withCases 25 200
    . it "are the touched pixels of the box, as shares of the contrast"
    $ forAll ((,) <$> genRasterOf 14 17 <*> genRasterOf 14 17) $ \(image, dice) ->
      forAll ((,) <$> choose (-7, 13) <*> choose (-11, 16)) $ \(left, top) ->
        let touched = mapRaster (\v -> if v < 0.5 then 1 else 0) dice
            composite = (compositeOf image) {compositeCoverage = touched}
            found = Segmentation [] [] 0.2 0.6
            at = (fromIntegral left + 3.5, fromIntegral top + 5.5)
            box pick = generate 8 12 (\x y -> fromMaybe 0 (pick (left + x) (top + y)))
            seen = box (index touched)
            pixels = box $ \x y -> do
              there <- index touched x y
              value <- index image x y
              pure (if there > 0 then (value - 0.2) / 0.6 else 0)
            enough = V.sum (rasterValues seen) >= fromIntegral leastSeen
            close a b = V.and (V.zipWith (\u v -> abs (u - v) < 1e-9) a b)
            seenThere = partAt composite (segmentedBackground found, segmentedContrast found) 0 at
         in counterexample (show (seenThere, seen, pixels)) $
              partAt composite (segmentedBackground found, 0) 0 at === Nothing
                .&&. case seenThere of
                  Nothing -> property (not enough)
                  Just part ->
                    enough
                      .&&. partSeen part === seen
                      .&&. close (rasterValues (partPixels part)) (rasterValues pixels)
