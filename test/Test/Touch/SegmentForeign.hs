-- | Which regions are of a symbol's size, which are none of a symbol, and where they are straight;
-- how high symbols stand, and what is foreign beside them: each against its definition.
module Test.Touch.SegmentForeign (spec) where

import Data.List (nub, sort, sortOn)
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as V
import PraTactile.Composite (Composite (..), compositeOf)
import PraTactile.Composite.Level (Levels (..), levels)
import PraTactile.Image hiding (mean)
import PraTactile.Segmentation.Foreign
import PraTactile.Segmentation.Foreign.Extent
import PraTactile.Segmentation.Foreign.Height
import PraTactile.Segmentation.Masked
import PraTactile.Segmentation.Region
import PraTactile.Segmentation.Symbol (Cause (..), Reject (..))
import Test.Hspec hiding (around)
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (generate)

spec :: Spec
spec = do
  modifyMaxSuccess (const 100) sizeSpec
  straightSpec
  modifyMaxSuccess (const 40) heightSpec
  modifyMaxSuccess (const 60) foreignSpec
  modifyMaxSuccess (const 50) removedSpec

wide, high :: Int
(wide, high) = (34, 30)

-- | A field all of which was touched.
field :: Masked
field = masked (compositeOf (constant wide high 0))

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
          holed = field {maskedTouched = V.imap (\p _ -> p /= hole) (maskedTouched field)}
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

-- | What was felt, and where, of such a composite.
genScene :: Gen Masked
genScene = smoothed . masked <$> genComposite

-- | Bars of several heights on a slope, with some noise, of which not all was touched.
genComposite :: Gen Composite
genComposite = do
  count <- choose (0, 5)
  bars <- vectorOf count $ do
    centre <- (,) <$> choose (4, 29) <*> choose (4, 25)
    angle <- choose (0, 180)
    size <-
      frequency
        [ (4, (,) <$> choose (11, 13) <*> choose (7, 9)),
          (1, (,) <$> choose (15, 34) <*> choose (2, 4)),
          (1, (,) <$> choose (3, 9) <*> choose (3, 9))
        ]
    height <- frequency [(4, choose (0.4, 0.6)), (2, choose (0.15, 1)), (1, choose (-0.5, 0))]
    pure (bar centre angle size, height)
  slope <- elements [0, 0, 0.004]
  rough <- elements [0, 0.02, 0.1]
  noise <- vectorOf (wide * high) (choose (negate rough, rough))
  untouched <- elements [0, 0, 60, 200]
  touched <- (++ repeat True) . map (> (1 :: Int)) <$> vectorOf untouched (choose (0, 9))
  let value x y =
        0.3 + slope * fromIntegral x + noise !! (y * wide + x)
          + sum [h | (holds, h) <- take 3 bars, holds (fromIntegral x, fromIntegral y)]
          -- The last one stands by itself, at its own height.
          + maximum (0 : [h | (holds, h) <- drop 3 bars, holds (fromIntegral x, fromIntegral y)])
      coverage x y = if touched !! (y * wide + x) then 1 else 0
  pure (compositeOf (generate wide high value)) {compositeCoverage = generate wide high coverage}

-- | The element of a rank, from 0 to 1, of some; 0 of none.
rankOf :: Double -> [Double] -> Double
rankOf rank values = case drop (floor (rank * fromIntegral (length values))) (sort values) of
  v : _ -> v
  [] -> 0

-- | Of some pixels those that are none of others.
without :: Masked -> [Int] -> [Int] -> [Int]
without scene others = filter (not . (around scene 0 others V.!))

-- | The field with these values, and nothing else touched.
showing :: [(Int, Double)] -> Masked
showing pixels =
  field
    { maskedTouched = V.generate (wide * high) (`elem` map fst pixels),
      maskedValues = V.generate (wide * high) (\p -> sum [v | (p', v) <- pixels, p' == p])
    }

heightSpec :: Spec
heightSpec = do
  it "the highest of 23 cuts counts: a symbol beside a hole ten times as deep as it is high" $
    let symbol = regionOf (bar (15.5, 14.5) 0 (12, 8))
        rest = without field symbol [1 .. wide * high - 1]
        found = symbolLevels (showing ((0, -10) : [(p, 0) | p <- rest] ++ [(p, 1) | p <- symbol])) 0
     in fmap (length . snd) found `shouldBe` Just 1
  it "of what lies three pixels from a symbol twelve must be touched" $
    [ snd <$> symbolLevels (showing ([(p, 1) | p <- symbol] ++ [(p, 0) | p <- take n ring])) 0
      | let symbol = regionOf (bar (15.5, 14.5) 0 (12, 8)),
        let ring = without field (grown field 2 symbol) (grown field 3 symbol),
        n <- [11, 12]
    ]
      `shouldSatisfy` \found -> map (fmap length) found == [Nothing, Just 1]
  it "symbols stand as high as the middle of what is of their size where it is cut at half height" $
    forAllBlind genScene $ \scene -> forAll (elements [0, 0.01, 0.05]) $ \noise ->
      let wanted = defined scene noise
          found = symbolLevels scene noise
          numbers (Levels a b, symbols) = (a, b, map sort symbols)
       in label (maybe "none" (show . length . snd) wanted) $
            fmap numbers found === fmap numbers wanted
  where
    defined scene noise
      | null found = Nothing
      | otherwise = Just (Levels low (low + usual), [region | (_, (region, _, _)) <- alike])
      where
        found = apart (sortOn fst (concatMap cut [1 .. 23]))
        touched = V.toList (V.ifilter (\p _ -> maskedTouched scene V.! p) (maskedValues scene))
        cut :: Int -> [(Double, (Region, Double, Double))]
        cut k =
          let (bottom, top) = (minimum touched, maximum touched)
              height = bottom + (top - bottom) * fromIntegral k / 24
           in [ (misfit, (region, floor', up))
                | not (null touched),
                  gap <- [0, 2],
                  region <- components scene gap (touchedWhere (>= height) scene),
                  symbolSized scene region,
                  -- What lies three pixels from it, and is no nearer.
                  let ring = without scene (grown scene 2 region) (grown scene 3 region),
                  let beyond = [maskedValues scene V.! p | p <- ring, maskedTouched scene V.! p],
                  length beyond >= 12,
                  let floor' = rankOf 0.5 beyond,
                  let up = rankOf 0.7 (map (maskedValues scene V.!) region),
                  up - floor' >= max (2 / 255) (4 * noise),
                  let misfit = abs (height - (floor' + up) / 2) / (up - floor'),
                  misfit < 0.2
              ]
        -- Of those that share pixels the one that is cut nearest to half its height.
        apart [] = []
        apart (c@(_, (region, _, _)) : rest) =
          c : apart [d | d@(_, (other, _, _)) <- rest, not (any (`elem` region) other)]
        usual = rankOf 0.5 [up - low' | (_, (_, low', up)) <- found]
        alike =
          [ c
            | c@(_, (_, low', up)) <- found,
              let ratio = (up - low') / usual,
              ratio > 0.5,
              ratio < 1.6
          ]
        low = rankOf 0.5 [low' | (_, (_, low', _)) <- alike]

foreignSpec :: Spec
foreignSpec = do
  it "of sunken pixels twelve are foreign, eleven are noise" $
    [ length (foreignIn (showing [(p, -1) | p <- take n [9 * wide + 3 ..]]) (Levels 0 1) [])
      | n <- [11, 12]
    ]
      `shouldBe` [0, 1]
  it "foreign is what is too long and too high, what is straight and long, and what is sunk" $
    forAllBlind genScene $ \scene -> forAll (choose (0.05, 0.5)) $ \contrast' ->
      forAll (listOf (elements [0 .. wide * high - 1])) $ \pixels ->
        let -- The levels of symbols, and where these are.
            (low, symbols) = (0.3, [take 60 (grown scene 3 [p]) | p <- take 2 pixels])
            found = foreignIn scene (Levels low (low + contrast')) symbols
            kept = grown scene 1 (concat symbols)
            free holds share =
              [ p
                | p <- [0 .. wide * high - 1],
                  maskedTouched scene V.! p,
                  holds (maskedValues scene V.! p) (low + share * contrast')
              ]
            parts = components scene 0 . without scene kept
            rim by region = without scene kept (grown scene by region)
            tall = map (rim 2) (filter (tooLong scene) (parts (free (>=) 1.5)))
            level = without scene (concat tall) (free (>=) 0.35)
            raised = concatMap (straight scene) (filter (tooLong scene) (parts level))
            sunk = filter ((>= 12) . length) (parts (free (<=) (-0.35)))
            wanted =
              [(sort r, TooLarge, True) | r <- tall]
                ++ [(sort (rim 1 r), TooLarge, False) | r <- raised]
                ++ [(sort (rim 2 r), Hollow, True) | r <- sunk]
         in collect (map length [tall, raised, sunk]) $
              [(sort (strangePixels s), strangeCause s, strangeHeight s) | s <- found] === wanted

removedSpec :: Spec
removedSpec =
  it "what is foreign is taken out where there is something unlike symbols, beside symbols" $
    forAllBlind (oneof [genComposite, genHole]) $ \composite ->
      let scene = smoothed (masked composite)
          noise = 6 / 16 * pixelNoise (masked composite)
          found = do
            Levels low high' <- levels noise (touchedValues scene)
            let at share = low + share * (high' - low)
                those holds share = components scene 0 (touchedWhere (`holds` at share) scene)
                strange =
                  any (unlikeSymbols scene) (those (>=) 0.5)
                    || any ((>= 12) . length) (those (<=) (-0.35))
            (own, symbols) <- symbolLevels scene noise
            if strange then Just (foreignIn scene own symbols) else Nothing
          wanted = case found of
            Just strange@(_ : _) ->
              Cleaned
                (blanked composite (concatMap strangePixels strange))
                (Just (blanked composite (concatMap strangePixels (filter strangeHeight strange))))
                [Reject (regionBox scene (strangePixels s)) (strangeCause s) | s <- strange]
            _ -> Cleaned composite Nothing []
       in label (maybe "none" (show . length) found) (cleaned composite === wanted)
  where
    -- A symbol, and a hole of about as many pixels as count.
    genHole = do
      (w, h) <- (,) <$> choose (1, 6) <*> choose (1, 3)
      depth <- elements [0.5, 0.7, 1, 3]
      let symbol = bar (16, 12) 0 (12, 8)
          value x y
            | symbol (fromIntegral x, fromIntegral y) = 1
            | x >= 4 && x < 4 + w && y >= 24 && y < 24 + h = negate depth
            | otherwise = 0
      pure (compositeOf (generate wide high value))
    blanked composite pixels =
      composite
        { compositeImage = blank (compositeImage composite),
          compositeCoverage = blank (compositeCoverage composite)
        }
      where
        blank image =
          generate wide high $ \x y ->
            if y * wide + x `elem` pixels then 0 else fromMaybe 0 (index image x y)
