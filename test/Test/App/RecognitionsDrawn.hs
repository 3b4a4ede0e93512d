{-# LANGUAGE OverloadedStrings #-}

-- | Pictures of recognitions: where things are drawn, from the geometry of faces, regions and
-- composites.
module Test.App.RecognitionsDrawn (spec) where

import qualified Data.ByteString.Lazy.Char8 as Lazy8
import Data.Foldable (for_)
import Data.List (isInfixOf, tails)
import Data.Maybe (mapMaybe)
import Data.Text (Text)
import Drawing
import Drawing.Svg
import Picture
import PraTactile.Array (ArrayOn (..), PseudorandomArray, Surface (..))
import PraTactile.Classification.Network (Network)
import PraTactile.Classification.Reader (readerOf)
import PraTactile.Evaluate (Trial (..), exploration, trial)
import PraTactile.Explore
import PraTactile.Field (KnownField)
import PraTactile.Geometry (symbolThickness)
import PraTactile.Image
import PraTactile.Object.Canonical (canonicalPlacement)
import PraTactile.Object.Placement
import PraTactile.Object.Radicals
import PraTactile.Object.WingedEdge (FaceName (..), VertexName (..))
import PraTactile.Pose (faceFrameOf)
import PraTactile.Profile
import PraTactile.Recognise
import PraTactile.Recognise.Recognition (unanswered)
import PraTactile.Recognise.Summary (shownSkew)
import PraTactile.Registration hiding (stitch)
import PraTactile.Relief
import PraTactile.Segmentation (SymbolImage (..))
import PraTactile.Sensor (HeightMap (..), standardSensor)
import PraTactile.Sensor.Frame (taxelPitch)
import PraTactile.Shape (Alphabet)
import PraTactile.Symmetry
import PraTactile.Truth
import System.Random (mkStdGen)
import Test.Effort
import Test.Hspec hiding (around)
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck hiding (generate, within)
import Test.Touch.Paper (paperAlphabet, paperNetwork, stitch)

spec :: Spec
spec = do
  drawingSpec
  case (,,) <$> shown canonicalPlacement <*> shown paperNetwork <*> shown paperAlphabet of
    Left problem -> it "the shipped parts fit together" (expectationFailure problem)
    Right parts@(layout, network, alphabet) ->
      either (\e -> it "the canonical profile has an array" (expectationFailure (show e))) id $
        withProfile canonicalProfile $ \array mask -> case recogniser
          (ArrayOn Torus array)
          mask
          layout
          (readerOf alphabet network) of
          Left e -> it "the canonical array has a recogniser" (expectationFailure (show e))
          Right reader -> pictureSpec parts array reader
  where
    shown :: Show e => Either e a -> Either String a
    shown = either (Left . show) Right

drawingSpec :: Spec
drawingSpec = describe "drawings" $ do
  prop "drawings side by side do not touch, and their tops are level" $
    \a
     b
     (NonNegative gap) ->
        let (first, second) = (boxes a, beside gap (boxes a) (boxes b))
         in leftEdge (extentOf second) ~= (rightEdge (extentOf first) + gap)
              .&&. topEdge (extentOf second) ~= topEdge (extentOf first)
  prop "drawings one above the other keep their order and their distance, flush left" $
    \a
     b
     (NonNegative gap) ->
        let whole = extentOf (above gap [boxes a, [], boxes b])
            (first, second) = (extentOf (boxes a), extentOf (boxes b))
         in height whole ~= (height first + gap + height second)
              .&&. width whole ~= max (width first) (width second)
  prop "flowing drawings are all present, in rows that fit the width" $
    \(widths :: [Positive Double])
     (Positive room) ->
        let items =
              [ [Mark "item" (Rectangle (filled "black" 1) (Extent 0 0 w 10))]
                | Positive w <- widths
              ]
            placed = flowing 5 room items
         in length placed === length widths .&&. disjoint (mapMaybe markExtent placed)
              .&&. property
                ( null widths
                    || width (extentOf placed) <= max room (maximum (map getPositive widths)) + 1e-6
                )
  prop "wrapped text has the same words, and no line with two words is too long" $
    \(ws :: [NonEmptyList Letter])
     (Positive room) ->
        let content = unwords (map (map letter . getNonEmpty) ws)
            font = Font 12 Regular "black"
            found = wrapped room font content
         in words (unwords found) === words content
              .&&. counterexample
                (show found)
                (and [textWidth font line <= room | line <- found, length (words line) > 1])
  it "text is escaped" $ do
    let file =
          Lazy8.unpack
            ( svgFile
                0
                "a < b"
                [Mark "text" (Words FromLeft (Font 12 Regular "black") (0, 0) "<script>&")]
            )
    file `shouldSatisfy` ("&lt;script&gt;&amp;" `isInfixOf`)
    file `shouldSatisfy` (not . ("<script" `isInfixOf`))
    file `shouldSatisfy` ("a &lt; b" `isInfixOf`)
  where
    boxes :: NonEmptyList (Double, Double, Positive Double, Positive Double) -> Drawing
    boxes (NonEmpty list) =
      [ Mark "box" (Rectangle (outlined "black" 2) (Extent x y (x + w) (y + h)))
        | (x, y, Positive w, Positive h) <- list
      ]
    a ~= b = counterexample (show (a, b)) (abs (a - b) <= 1e-6 * (1 + abs a + abs b))

-- | A letter of a word, markup's own among them.
newtype Letter = Letter {letter :: Char}
  deriving stock (Show)

instance Arbitrary Letter where
  arbitrary = Letter <$> elements "abW<&>\"^"
  shrink (Letter c) = [Letter 'a' | c /= 'a']

pictureSpec ::
  KnownField k =>
  (Placement, Network, Alphabet) ->
  PseudorandomArray k ->
  Recogniser k ->
  Spec
pictureSpec (layout, _, alphabet) array reader = describe "pictures of recognitions" $ do
  withCases 8 30 $
    prop "composite, face, answer and legend keep apart, and so does all text" $ \seed ->
      forAll (elements (laidFaces layout)) $ \face ->
        forAll (elements [(40, 52), (24, 36), (16, 16), (52, 40)]) $ \size ->
          explored size seed face $ \_ composite recognition ->
            let page = pageOf composite recognition
             in apart page .&&. disjoint (mapMaybe markExtent (filter isText (pageDrawing page)))
  prop "symbols and parts anywhere: their boxes stay out of all text and of the rest" $
    \(Positive w) (Positive h) ->
      forAllShrink (listOf (symbolWithin (w, h))) (shrinkList (const [])) $ \symbols ->
        forAllShrink (listOf (symbolWithin (w, h))) (shrinkList (const [])) $ \others ->
          let numbered = zipWith (\n s -> s {readNumber = n}) [0 ..]
              page =
                pageOf
                  (compositeOf (constant w h 0.2))
                  (unanswered (numbered symbols) SymbolsUnclear)
                    { recognisedParts = numbered others
                    }
           in length (named "symbol" (pageComposite page)) === length symbols + length others
                .&&. apart page
  withCases 6 20 $
    prop "the window that gives the answer is framed on both sides, its place in the middle" $
      \seed ->
        forAll (elements (laidFaces layout)) $ \face ->
          forAll (elements [(40, 52), (60, 56)]) $ \size ->
            explored size seed face $
              \_
               composite
               recognition -> case (recognisedAnswer recognition, pageOf composite recognition) of
                  (Right (Found found), page)
                    | OnFace place <- windowWhereabouts (foundWindow found),
                      placeFace place == laidFace face ->
                      let onComposite' =
                            within
                              (only "composite" (pageComposite page))
                              (fromIntegral (rasterWidth (compositeImage composite)))
                          onItsFace =
                            within
                              (only "face" (pageFace page))
                              (nearestDouble (spotRight (laidExtent face)))
                          sideways = exchangesAxes (foundOrientation found)
                          (x, y) = windowSeenAt (foundWindow found)
                          -- The frame lies as the face does.
                          turn = abs (shownSkew recognition) * pi / 180
                          box (w, h) = (w * cos turn + h * sin turn, w * sin turn + h * cos turn)
                       in counterexample
                            "on the composite"
                            ( close
                                0.01
                                (onComposite' (only "window" (pageComposite page)))
                                ( around
                                    (box (if sideways then (40, 32) else (32, 40)))
                                    (x + 0.5, y + 0.5)
                                )
                            )
                            .&&. counterexample
                              "on the face"
                              ( close
                                  0.01
                                  (onItsFace (only "window" (pageFace page)))
                                  (around (50.8, 63.5) (spotMillimetres (placeCentre place)))
                              )
                            .&&. counterexample
                              "the cross"
                              ( close
                                  0.01
                                  (onItsFace (middle (extentOf (named "place" (pageFace page)))))
                                  (around (0, 0) (spotMillimetres (placeCentre place)))
                              )
                  (Right _, _) -> counterexample "another face" False
                  (Left _, page) -> pageFace page === []
  withCases 6 20 $
    -- The faces lie upright: a skew that is found is an error, which moves the corners.
    prop "the outline on the face is where the composite was, to two taxels and by its skew" $
      \seed -> forAll (elements (laidFaces layout)) $ \face ->
        explored standardRegionSize seed face $ \known composite recognition -> case named
          "outline"
          (pageFace (pageOf composite recognition)) of
          Mark _ (Outline _ points) : _ ->
            let page = pageOf composite recognition
                onItsFace (x, y) =
                  leftTop
                    ( within
                        (only "face" (pageFace page))
                        (nearestDouble (spotRight (laidExtent face)))
                        (Extent x y x y)
                    )
                (w, h) =
                  ( fromIntegral (rasterWidth (compositeImage composite)) - 0.5,
                    fromIntegral (rasterHeight (compositeImage composite)) - 0.5
                  )
                truth = Truth (laidFace face) (trialRegion known) (0, 0) Nothing
                skewed = recognisedSkew recognition * pi / 180
                most = taxelPitch * (2 + abs skewed * sqrt (w * w + h * h) / 2)
                corners =
                  map
                    (truePlace truth . compositePosition composite)
                    [(-0.5, -0.5), (w, -0.5), (w, h), (-0.5, h)]
             in conjoin
                  [ counterexample
                      (show (a, b, skewed))
                      (abs (fst a - fst b) < most && abs (snd a - snd b) < most)
                    | (a, b) <- zip (map onItsFace points) corners
                  ]
                  .&&. length points
                  === 4
          _ -> property True
  it "each face is drawn with its symbols, taxel by taxel, and its four vertices" $
    once . conjoin
      . ( <$>
            [ (face, heights)
              | face <- byEffort firstAndLast id (laidFaces layout),
                Right heights <- [reliefHeights <$> relief array layout alphabet face]
            ]
        )
      $ \(face, heights) -> ioProperty $ do
        let margin side = round (nearestDouble (side (laidMargin face)) / taxelPitch) :: Int
            image =
              generate
                32
                40
                ( \i j ->
                    maybe
                      0
                      (/ symbolThickness)
                      (index (heightValues heights) (margin spotRight + i) (margin spotDown + j))
                )
        recognition <- either (fail . show) pure (recognise reader (compositeOf image))
        let drawn = pageFace (pageOf (compositeOf image) recognition)
            taxels =
              [ within (only "face" drawn) (fromIntegral (rasterWidth (heightValues heights))) patch
                | Mark _ (Patches _ patches) <- named "embossed" drawn,
                  patch <- patches
              ]
            covered i j =
              or
                [ leftEdge e < x && x < rightEdge e && topEdge e < y && y < bottomEdge e
                  | e <- taxels
                ]
              where
                (x, y) = (fromIntegral i + 0.5, fromIntegral j + 0.5)
        generate
          (rasterWidth (heightValues heights))
          (rasterHeight (heightValues heights))
          (\i j -> if covered (i :: Int) (j :: Int) then symbolThickness else 0)
          `shouldBe` heightValues heights
        length (named "vertex" drawn) `shouldBe` 4
        -- The object, lying with this face upright before the sensor.
        let Face object name = laidFace face
            posed = do
              solid <- placementObject layout object
              (,) object <$> faceFrameOf solid name
            page = pageWith posed (compositeOf image) recognition
            lying = pageObject page
            Extent x y _ _ = middle (extentOf (named "place" lying))
        [() | Mark "face" (Outline _ corners) <- lying, encloses corners (x, y)] `shouldBe` [()]
        [vertexText v | v <- faceVertices name]
          `shouldSatisfy` all (`elem` [v | Mark "vertex" (Words _ _ _ v) <- lying])
        length (named "embossed" lying) `shouldBe` 3
        pure (apart page)
  -- A region of half the size was drawn with the sizes of the paper's symbols.
  it "of symbols of half the size, or of three times, the composite is as much smaller or larger" $
    for_ [1 / 2, 1, 3] $ \size -> do
      let page =
            recognitionPage
              alphabet
              show
              (scaledPlacement size layout)
              (classOn array)
              Nothing
              (compositeOf (constant 40 52 0))
              (unanswered [] NoSymbols)
          bar = take 1 (named "scale" (pageComposite page))
          unit = width (extentOf (named "composite-edge" (pageComposite page))) / 40
      [content | Mark "note" (Words _ _ _ content) <- pageComposite page]
        `shouldBe` [ case size of
                       1 -> "40 x 52 taxels, 63.5 x 82.55 mm"
                       3 -> "40 x 52 taxels, 190.5 x 247.65 mm"
                       _ -> "40 x 52 taxels, 31.75 x 41.28 mm"
                   ]
      -- A bar of 20 mm.
      abs (width (extentOf bar) - unit * 20 / (fromRational size * 1.5875))
        `shouldSatisfy` (< 3)
  it "without an answer no face is drawn, and the reason is printed" $ do
    let page =
          pageOf
            (compositeOf (constant 40 52 0))
            (unanswered [] NoSymbols)
    pageFace page `shouldBe` []
    concat [content | Mark _ (Words _ _ _ content) <- pageAnswer page]
      `shouldSatisfy` ("no complete symbol" `isInfixOf`)
  where
    -- One of each of the paper's solids.
    firstAndLast faces = take 1 faces ++ take 1 (reverse faces)
    pageOf = pageWith Nothing
    pageWith = recognitionPage alphabet show layout (classOn array)
    encloses corners (u, v) =
      odd . length $
        [ ()
          | ((x1, y1), (x2, y2)) <- zip corners (drop 1 corners ++ take 1 corners),
            (y1 > v) /= (y2 > v),
            u < x1 + (v - y1) * (x2 - x1) / (y2 - y1)
        ]
    -- The parts of the page, and what is drawn on the composite from the words above and below
    -- it.
    apart page =
      disjoint
        ( map
            extentOf
            ( filter
                (not . null)
                (map ($ page) [pageComposite, pageFace, pageObject, pageAnswer, pageLegend])
            )
        )
        .&&. disjoint
          ( map
              extentOf
              ( filter
                  (not . null)
                  [ concatMap (`named` pageComposite page) names
                    | names <-
                        [ ["heading"],
                          ["note"],
                          ["composite", "symbol", "element", "window"],
                          ["scale"]
                        ]
                  ]
              )
          )
    explored ::
      (Int, Int) ->
      Int ->
      LaidFace ->
      (Trial -> Composite -> Recognition -> Property) ->
      Property
    explored size seed face check = case relief array layout alphabet face of
      Right heights
        | Just known <- trial (exploring size) (face, heights) (mkStdGen seed),
          Right composite <- stitch standardRegistration (trialFrames known),
          Right recognition <- recognise reader composite ->
          check known composite recognition
      _ -> counterexample "not explored" False
    exploring = exploration standardSensor (AmongTurns rotations)

-- | A symbol of any class somewhere on a composite of this size, in pixels.
symbolWithin :: (Int, Int) -> Gen ReadSymbol
symbolWithin (w, h) = do
  centre <- (,) <$> choose (-0.5, fromIntegral w - 0.5) <*> choose (-0.5, fromIntegral h - 0.5)
  what <- (,) <$> elements rotations <*> choose (0, 3)
  known <- arbitrary
  pure
    ReadSymbol
      { readNumber = 0,
        readSource = 0,
        readImage = SymbolImage centre (constant 8 12 0) 0 (8, 12),
        readAt = centre,
        readClass = if known then Just what else Nothing,
        readSeen = 1,
        readLikeliest = what,
        readChances = [(what, 1)],
        readForeignShape = -10
      }

named :: Text -> Drawing -> Drawing
named name = filter ((== name) . markClass)

-- | What the one mark of this name takes up, its stroke left out; a point if there is none, and a
-- hull if there are several.
only :: Text -> Drawing -> Extent
only name drawing = extentOf [Mark name (unstroked form) | Mark _ form <- named name drawing]
  where
    unstroked form = case form of
      Rectangle paint e -> Rectangle paint {strokeWidth = 0} e
      other -> other

-- | In units of which the reference is this many wide, from its upper left corner.
within :: Extent -> Double -> Extent -> Extent
within reference size (Extent l t r b) = Extent (across l) (down t) (across r) (down b)
  where
    unit = width reference / size
    across x = (x - leftEdge reference) / unit
    down y = (y - topEdge reference) / unit

leftTop :: Extent -> (Double, Double)
leftTop e = (leftEdge e, topEdge e)

middle :: Extent -> Extent
middle (Extent l t r b) = around (0, 0) ((l + r) / 2, (t + b) / 2)

close :: Double -> Extent -> Extent -> Property
close apart a b =
  counterexample
    (show (a, b))
    (and [abs (side a - side b) <= apart | side <- [leftEdge, topEdge, rightEdge, bottomEdge]])

isText :: Mark -> Bool
isText (Mark _ form) = case form of
  Words {} -> True
  _ -> False

-- | No two have more than an edge in common.
disjoint :: [Extent] -> Property
disjoint extents =
  conjoin
    [ counterexample
        (show (a, b))
        ( or
            [ ends rightEdge leftEdge c d || ends bottomEdge topEdge c d
              | (c, d) <- [(a, b), (b, a)]
            ]
        )
      | a : others <- tails extents,
        b <- others
    ]
  where
    ends end begin a b = end a <= begin b + 1e-6
