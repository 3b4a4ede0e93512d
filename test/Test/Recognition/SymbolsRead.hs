-- | Tests the reading of symbols, and of parts of symbols beside them, on drawn composites.
module Test.Recognition.SymbolsRead (spec) where

import Data.List (sort, sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as V
import PraTactile.Classification.Estimate
import PraTactile.Classification.Part
import PraTactile.Classification.Reader
import PraTactile.Classification.Templates
import PraTactile.Image hiding (mean)
import PraTactile.Recognise.FaceGrid
import PraTactile.Recognise.Parts
import PraTactile.Recognise.Reading
import PraTactile.Registration (Composite (..), compositeOf)
import PraTactile.Segmentation
import PraTactile.Sensor.Frame (taxelPitch)
import PraTactile.Shape
import PraTactile.Symmetry
import Test.Effort (withCases)
import Test.Hspec
import Test.QuickCheck hiding (generate, sample)
import Test.Recognition.Setting
import Test.Recognition.Symbols

spec :: Spec
spec = do
  let known = readerAlphabet paperReader
  withCases 2 10 (symbolSpec known paperReader)
  withCases 2 20 (placeSpec known paperReader)
  knownSpec known paperReader
  withCases 2 20 (partSpec known (templates known) paperReader)

-- | A drawn symbol: its cell, its class, and its orientation.
type Placed = ((Int, Int), Int, Symmetry)

-- | An image of this many rows and columns of cells of 16 x 20 (on their side, 20 x 16), with
-- symbols in the middle of theirs.
picture :: Alphabet -> Bool -> (Int, Int) -> [Placed] -> Raster
picture known sideways size drawn' =
  inCells
    known
    (if sideways then (20, 16) else (16, 20))
    size
    [(cell, c, onRaster symmetry) | (cell, c, symmetry) <- drawn']

-- | The middle of a cell's symbol, in pixels.
middle :: Bool -> (Int, Int) -> (Double, Double)
middle sideways (i, j)
  | sideways = (20 * fromIntegral j + 9.5, 16 * fromIntegral i + 7.5)
  | otherwise = (16 * fromIntegral j + 7.5, 20 * fromIntegral i + 9.5)

cleanly :: Composite -> ForeignMasked
cleanly composite = ForeignMasked composite Nothing []

genDrawn :: Bool -> (Int, Int) -> Gen [Placed]
genDrawn sideways (high, wide) = do
  cells <- sublistOf [(i, j) | i <- [0 .. high - 1], j <- [0 .. wide - 1]]
  traverse one (if null cells then [(0, 0)] else cells)
  where
    one cell =
      (,,) cell
        <$> choose (0, 3)
        <*> elements (if sideways then [turned 1, turned 3] else [identity, turned 2])

symbolSpec :: Alphabet -> Reader -> Spec
symbolSpec known reader =
  it "each symbol of an axis is read at its place on the first composite's grid, as what it is" $
    forAll arbitrary $ \sideways ->
      forAll (choose (1, 3) >>= (`vectorOf` genDrawn sideways (2, 3))) $ \drawn ->
        forAll (vectorOf 3 ((,) <$> choose (-60, 60) <*> choose (-60, 60))) $ \origins ->
          forAll (choose (0, 9)) $ \from ->
            let composites =
                  [ (compositeOf (picture known sideways (2, 3) those))
                      { compositeOrigin = (taxelPitch * x, taxelPitch * y)
                      }
                    | (those, (x, y)) <- zip drawn origins
                  ]
                axis = if sideways then turned 1 else identity
                other = if sideways then identity else turned 1
                asked along = readSymbols reader along from (map cleanly composites)
                wanted =
                  [ ((source, nearest at'), (symmetry, c))
                    | (source, those, (x, y)) <- zip3 [0 ..] drawn origins,
                      (cell, c, symmetry) <- those,
                      let (u, v) = middle sideways cell,
                      let at' = (u + x - firstX, v + y - firstY)
                  ]
                (firstX, firstY) = foldr const (0, 0) origins
                nearest (x, y) = (round (x / 2), round (y / 2)) :: (Int, Int)
                told s = ((readSource s, nearest (readAt s)), readLikeliest s)
             in case (asked axis, asked other) of
                  (Right views, Right none) ->
                    let found = concatMap viewSymbols views
                     in conjoin
                          [ close (sortOn fst (map told found)) (sortOn fst wanted),
                            map readNumber found === take (length found) [from ..],
                            map viewSource views === take (length drawn) [0 ..],
                            map viewAxis views === map (const axis) drawn,
                            conjoin [readClass s === Just (readLikeliest s) | s <- found],
                            conjoin [readSeen s === 1 | s <- found],
                            conjoin
                              [ (symbolAxis (readImage s) - 90 * fromIntegral (quarterTurns axis))
                                  === 0
                                | s <- found
                              ],
                            conjoin (map (probable axis) found),
                            sum (map (length . viewSymbols) none) === 0
                          ]
                  _ -> counterexample "refused" False
  where
    -- Places to two pixels; a place near a border may fall on either side.
    close found wanted =
      counterexample (show (found, wanted)) $
        length found == length wanted
          && and
            [ any (\((source', q), what') -> source == source' && what == what' && beside p q) found
              | ((source, p), what) <- wanted
            ]
    beside (a, b) (c, d) = abs (a - c) <= 1 && abs (b - d) <= 1
    -- The probabilities cover both orientations along the axis, and add up to 1.
    probable axis s =
      let chances = readChances s
       in length chances === 8
            .&&. property (all ((`elem` [axis, axis <> turned 2]) . fst . fst) chances)
            .&&. property (abs (sum (map snd chances) - 1) < 1e-9)

placeSpec :: Alphabet -> Reader -> Spec
placeSpec known reader =
  it "a view shows at a place of the first composite's grid what is there, turned" $
    forAll (elements [identity, turned 1]) $ \axis ->
      forAll (genDrawn False (2, 2)) $ \drawn ->
        forAll ((,) <$> choose (-9, 9) <*> choose (-9, 9)) $ \(x, y) ->
          let image = picture known False (2, 2) drawn
              moved =
                (compositeOf image)
                  { compositeOrigin = (taxelPitch * fromIntegral x, taxelPitch * fromIntegral y)
                  }
           in case readSymbols reader axis 0 (map cleanly [compositeOf image, moved]) of
                Right [first, second] ->
                  conjoin
                    [ conjoin
                        [ near (shown first (fromIntegral u, fromIntegral v)) there,
                          near (shown second (fromIntegral (u + x), fromIntegral (v + y))) there
                        ]
                      | u <- [0, 5, 9, 20, 31],
                        v <- [0, 7, 21, 39],
                        let there = fromMaybe (-1) (index image u v)
                    ]
                _ -> counterexample "not two views" False
  where
    shown view place = uncurry (sample (compositeImage (viewComposite view))) (onView view place)
    near a b = counterexample (show (a, b)) (abs (a - b) < 1e-6)

knownSpec :: Alphabet -> Reader -> Spec
knownSpec known reader = do
  it "mostKnown = at least three symbols are known, and more than half" $
    forAll ((,) <$> choose (0, 6) <*> choose (0, 6)) $ \(those, others) ->
      case readSymbols reader identity 0 [cleanly (compositeOf (picture known False (1, 1) []))] of
        Right [view] ->
          let symbols =
                replicate those (symbolOf 0 (0, 0) (identity, 0))
                  ++ replicate others (symbolOf 0 (0, 0) (identity, 0)) {readClass = Nothing}
              (one, two) = splitAt 2 symbols
           in mostKnown [view {viewSymbols = one}, view {viewSymbols = two}]
                === (those >= 3 && those > others)
        _ -> counterexample "no view" False
  it "composites are mirrored if most symbols are known in the mirror, whichever way up" $ do
    let drawn = [((0, 0), 0, identity), ((0, 1), 1, identity), ((1, 0), 2, identity)]
        whole = drawn ++ [((1, 1), 3, identity)]
        asked those symmetry =
          readMirrored
            reader
            [cleanly (compositeOf (onRaster symmetry (picture known False (2, 2) those)))]
    map (asked whole . (<> mirror)) rotations `shouldBe` replicate 4 (Right True)
    map (asked whole) rotations `shouldBe` replicate 4 (Right False)
    map (\those -> asked those mirror) [drawn, take 2 drawn]
      `shouldBe` [Right True, Right False]

partSpec :: Alphabet -> Templates -> Reader -> Spec
partSpec known seen reader =
  it "each composite has the parts that are likelier one class than all others together" $
    forAll (elements [identity, turned 1]) $ \axis ->
      forAll (genDrawn False (3, 3)) $ \drawn ->
        forAll (vectorOf 2 ((,) <$> choose (0, 14) <*> choose (0, 16))) $ \corners ->
          forAll (elements [0, 1.5]) $ \sigma ->
            let whole = picture known False (3, 3) drawn
                composites = map (cleanly . cut sigma axis whole) corners
             in case readSymbols reader axis 0 composites of
                  Right views
                    | Just grid <- faceGrid (groups (concatMap viewSymbols views)) ->
                      let (more, parts) = withParts reader views 50 grid
                          wanted = concatMap (partsIn seen sigma grid) views
                       in label (show (length parts)) $
                            conjoin
                              [ map readNumber parts === take (length wanted) [50 ..],
                                length parts === length wanted,
                                conjoin (zipWith alike parts (map snd wanted)),
                                Map.map (sort . map readNumber) (gridCells more)
                                  === joined (gridCells grid) wanted parts
                              ]
                  _ -> property True
  where
    -- The part of an image right of and below a place, turned about the robot's origin.
    cut sigma axis whole (left, top) =
      let (w, h) = (48 - left, 60 - top)
          part = generate w h (\x y -> fromMaybe 0 (index whole (x + left) (y + top)))
          (x0, y0)
            | axis == identity = (left, top)
            | otherwise = (negate (top + h - 1), left)
       in (compositeOf (onRaster axis part))
            { compositeOrigin = (taxelPitch * fromIntegral x0, taxelPitch * fromIntegral y0),
              compositeUnregisteredError = sigma
            }
    alike a b =
      counterexample (show (a, b)) $
        readLikeliest a == readLikeliest b
          && map fst (readChances a) == map fst (readChances b)
          && (readSource a, readClass a) == (readSource b, readClass b)
          && nearly (readAt a) (readAt b)
          && nearly (symbolCentre (readImage a)) (symbolCentre (readImage b))
          && symbolAxis (readImage a) == symbolAxis (readImage b)
          && symbolSize (readImage a) == symbolSize (readImage b)
          && symbolPixels (readImage a) `same` symbolPixels (readImage b)
          && near (readSeen a) (readSeen b)
          && and (zipWith near (map snd (readChances a)) (map snd (readChances b)))
    same a b = V.and (V.zipWith near (rasterValues a) (rasterValues b))
    nearly (x, y) (x', y') = near x x' && near y y'
    near p q = abs (p - q) < 1e-6
    joined cells wanted parts =
      let all' =
            Map.unionWith
              (++)
              (Map.map (map readNumber) cells)
              ( Map.fromListWith
                  (flip (++))
                  [(cell, [readNumber p]) | ((cell, _), p) <- zip wanted parts]
              )
          low part = minimum (0 : map part (Map.keys all'))
          ordered = Map.map sort all'
       in Map.mapKeys (\(i, j) -> (i - low fst, j - low snd)) ordered

-- | The content of each free cell around a composite's symbols, at the mean place that they give to
-- its middle.
partsIn :: Templates -> Double -> FaceGrid -> SymbolView -> [((Int, Int), ReadSymbol)]
partsIn seen sigma grid view =
  [ (cell, found)
    | cell@(i, j) <- Map.keys (Map.fromList [(c, ()) | c <- free]),
      let (x, y) =
            middleOf
              [ (u + dx, v + dy)
                | ((i', j'), s) <- own,
                  abs (i' - i) <= 1,
                  abs (j' - j) <= 1,
                  let (u, v) = readAt s,
                  let (dx, dy) =
                        onOffset
                          (viewAxis view)
                          (16 * fromIntegral (j - j'), 20 * fromIntegral (i - i'))
              ],
      Just part <- [partAt (viewComposite view) levels 0 (onView view (x, y))],
      let estimated = estimatePart seen sigma part,
      estimateDoubt estimated < 0.5,
      let along (c, way) = (viewAxis view <> way, c),
      let (shiftX, shiftY) = viewShift view,
      let found =
            (symbolOf 0 (x, y) (along (estimateLikeliest estimated)))
              { readSource = viewSource view,
                readImage =
                  SymbolImage
                    (x - shiftX, y - shiftY)
                    (partPixels part)
                    (90 * fromIntegral (quarterTurns (viewAxis view)))
                    (8, 12),
                readClass = Nothing,
                readSeen = V.sum (rasterValues (partSeen part)) / 96,
                readChances = [(along w, p) | (w, p) <- estimateChances estimated]
              }
  ]
  where
    levels = (segmentedBackground there, segmentedContrast there)
    there = viewSegmentation view
    own =
      [ (cell, s)
        | (cell, here) <- Map.toList (gridCells grid),
          s <- here,
          readSource s == viewSource view
      ]
    free =
      [ (i + di, j + dj)
        | ((i, j), _) <- own,
          di <- [-1, 0, 1],
          dj <- [-1, 0, 1],
          (i + di, j + dj) `notElem` map fst own
      ]
    middleOf places =
      let n = fromIntegral (length places)
       in (sum (map fst places) / n, sum (map snd places) / n)
