-- | Which regions are of a symbol's size, which are none of a symbol, and where they are straight:
-- each against its definition.
module Test.Touch.SegmentForeign (spec) where

import Data.List (nub, sort)
import qualified Data.Vector.Storable as V
import PraTactile.Image (constant)
import PraTactile.Segment.Foreign
import PraTactile.Segment.Region
import PraTactile.Stitch.Composite (compositeOf)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck

spec :: Spec
spec = do
  modifyMaxSuccess (const 100) sizeSpec
  straightSpec

wide, high :: Int
(wide, high) = (34, 30)

-- | A field all of which was touched.
field :: Field
field = fieldOf 0.5 (compositeOf (constant wide high 0))

-- | Pixels' centres, as far as they are on the field, as a region.
regionOf :: ((Double, Double) -> Bool) -> Region
regionOf holds =
  [ y * wide + x
    | y <- [0 .. high - 1],
      x <- [0 .. wide - 1],
      holds (fromIntegral x, fromIntegral y)
  ]

-- | A bar of that length and width around a place, turned clockwise by so many degrees.
bar :: (Double, Double) -> Double -> (Double, Double) -> (Double, Double) -> Bool
bar (cx, cy) angle (long, short) (x, y) = abs u <= long / 2 && abs v <= short / 2
  where
    (c, s) = (cos (angle * pi / 180), sin (angle * pi / 180))
    (u, v) = (c * (x - cx) + s * (y - cy), c * (y - cy) - s * (x - cx))

-- | How far a region extends at an angle, its pixels being one wide.
extent :: Region -> Double -> Double
extent region angle = maximum along - minimum along + 1
  where
    along =
      [ cos (angle * pi / 180) * fromIntegral (p `mod` wide)
          + sin (angle * pi / 180) * fromIntegral (p `div` wide)
        | p <- region
      ]

sizeSpec :: Spec
sizeSpec = do
  it "a region is too long if it extends over more than 18 pixels in one of eight directions" $
    forAll genBar $ \region ->
      let longest = maximum (map (extent region . (22.5 *)) [0 .. 7])
       in collect (longest > 18) (tooLong field region === (longest > 18))
  it "it is of a symbol's size if it is 12 by 8 pixels, 1.8 more or less, at one of 36 angles" $
    forAll genBar $ \region ->
      let fits angle =
            let (long, short) = (extent region angle, extent region (angle + 90))
             in abs (long - 12) <= 1.8 && abs (short - 8) <= 1.8 && long - short >= 2
          wanted = length region `elem` [24 .. 110] && any (fits . (5 *)) [0 .. 35]
       in collect wanted (symbolSized field region === wanted)
  it "it is unlike symbols if it is too long, or whole, of 36 pixels or more and not of that size" $
    forAll genBar $ \region ->
      let inside p = p `mod` wide `elem` [1 .. wide - 2] && p `div` wide `elem` [1 .. high - 2]
          wanted =
            tooLong field region
              || length region >= 36
              && all inside region
              && not (symbolSized field region)
       in collect wanted (unlikeSymbols field region === wanted)
  it "what lies at what was not touched is not whole" $
    -- A square of 6 x 6 with an untouched pixel beside it.
    forAll (elements [(9, 10), (16, 10), (12, 8), (12, 15)]) $ \(x, y) ->
      let region = regionOf (\(u, v) -> u >= 10 && u <= 15 && v >= 9 && v <= 14)
          hole = y * wide + x
          holed = field {fieldTouched = V.imap (\p _ -> p /= hole) (fieldTouched field)}
       in (unlikeSymbols field region, unlikeSymbols holed region) === (True, False)
  where
    genBar = do
      centre <- (,) <$> choose (8, 25) <*> choose (8, 21)
      angle <- choose (0, 180)
      size <-
        oneof
          [ (,) <$> choose (9, 15) <*> choose (6, 10),
            (,) <$> choose (2, 30) <*> choose (1, 12)
          ]
      let region = regionOf (bar centre angle size)
      pure (if null region then [0] else region)

straightSpec :: Spec
straightSpec = do
  modifyMaxSuccess (const 60)
    . it "straight is what lies on lines of 17 pixels of which 16 are in the region, at 16 angles"
    $ forAll genThing $
      \region ->
        let onLines =
              [ place
                | p <- region,
                  k <- [0 .. 15],
                  let line =
                        [ (x, y)
                          | t <- [0 .. 16],
                            let along part = round (t * part (radians k)) :: Int,
                            let (x, y) = (p `mod` wide + along cos, p `div` wide + along sin),
                            x `elem` [0 .. wide - 1],
                            y `elem` [0 .. high - 1]
                        ],
                  length (filter (`elem` places) line) >= 16,
                  place <- line
              ]
            places = [(p `mod` wide, p `div` wide) | p <- region]
         in sort (concat (straight field region))
              === sort (nub [y * wide + x | (x, y) <- onLines])
  it "a line of 16 pixels is straight, of 15 is not, one may be missing; of 12 on a diagonal" $
    [ null (straight field region)
      | region <-
          [ row [4 .. 19],
            row [4 .. 18],
            row ([4 .. 10] ++ [12 .. 20]),
            row ([4 .. 10] ++ [13 .. 21]),
            [y * wide + 7 | y <- [3 .. 18]],
            [y * wide + y | y <- [3 .. 14]],
            [y * wide + y | y <- [3 .. 13]]
          ]
    ]
      `shouldBe` [False, True, False, True, False, False, True]
  where
    radians k = 11.25 * k * pi / 180 :: Double
    row xs = [10 * wide + x | x <- xs]
    genThing = do
      angle <- choose (0, 180)
      long <- choose (12, 30)
      short <- choose (1, 4)
      at <- (,) <$> choose (8, 25) <*> choose (8, 21)
      let one = bar (16, 15) angle (long, short)
          other = bar at (angle + 90) (8, 12)
      pure (regionOf (\p -> one p || other p))
