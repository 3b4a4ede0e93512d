{-# LANGUAGE OverloadedStrings #-}

-- | Segmentation: symbols that were drawn come out where they were drawn, along their own axes, and
-- nothing else does.
module PraTactile.Conformance.Laws.Segment
  ( segmentLaws,
  )
where

import Data.List (transpose)
import Data.Maybe (isNothing)
import Numeric.Natural (Natural)
import PraTactile.Conformance.Ask
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Judge
import PraTactile.Conformance.Laws.Malformed
import PraTactile.Conformance.Laws.Relief
import PraTactile.Conformance.Question
import PraTactile.Conformance.Question.Touch
import PraTactile.Format.Json.Codec
  ( Codec,
    bool,
    int,
    integer,
    key,
    listOf,
    nullable,
    object,
    pairOf,
  )
import PraTactile.Shape (bitmapRows, paperAlphabet, shapes)
import PraTactile.Symmetry (degreesClockwise, onPixel, onRows, turned)
import Test.QuickCheck
  ( Gen,
    arbitrary,
    chooseInt,
    chooseInteger,
    frequency,
    shrinkIntegral,
    suchThat,
    vectorOf,
  )

-- | A composite on which symbols are drawn.
data Drawing = Drawing
  { -- | The classes on a lattice of 16 x 20 taxels, row by row, with gaps.
    drawingClasses :: [[Maybe Int]],
    -- | Where the lattice's first symbol has its upper left taxel.
    drawingOrigin :: WholeTaxels,
    -- | Whether the sensor blurs it.
    drawingBlurred :: Bool,
    -- | A number that says how it is changed.
    drawingChange :: Int
  }

drawingForm :: Codec Drawing
drawingForm =
  object $
    Drawing
      <$> key "classes" (listOf (listOf (nullable int))) drawingClasses
      <*> key "origin" (pairOf integer) drawingOrigin
      <*> key "blurred" bool drawingBlurred
      <*> key "change" int drawingChange

genDrawing :: Gen Drawing
genDrawing = do
  columns <- chooseInt (1, 3)
  rows <- chooseInt (1, 2)
  Drawing
    <$> (vectorOf rows (vectorOf columns symbol) `suchThat` any (not . all isNothing))
    <*> ((,) <$> chooseInteger (2, 10) <*> chooseInteger (2, 10))
    <*> arbitrary
    <*> chooseInt (0, 999)
  where
    symbol = frequency [(1, pure Nothing), (6, Just <$> chooseInt (0, 3))]

-- | Fewer symbols, nearer to the corner, sharp, and less of a change.
smallerDrawing :: Drawing -> [Drawing]
smallerDrawing drawing =
  [drawing {drawingClasses = less} | less <- fewer, any (not . all isNothing) less]
    ++ [drawing {drawingOrigin = o} | o <- smallerWhole (drawingOrigin drawing), least o]
    ++ [drawing {drawingBlurred = False} | drawingBlurred drawing]
    ++ [drawing {drawingChange = c} | c <- shrinkIntegral (drawingChange drawing), c >= 0]
  where
    classes = drawingClasses drawing
    fewer =
      [drop 1 classes, take (length classes - 1) classes]
        ++ map transpose [drop 1 (transpose classes), take (columns - 1) (transpose classes)]
    columns = length (transpose classes)
    least (x, y) = x >= 2 && y >= 2

-- | The symbols of a drawing, each with its class and its upper left taxel, displaced from the
-- lattice by what a function says of its column and row.
symbolsOf :: (Int -> Int -> WholeTaxels) -> Drawing -> [(Int, WholeTaxels)]
symbolsOf displaced drawing =
  [ (k, (x + 16 * toInteger c + i, y + 20 * toInteger r + j))
    | (r, line) <- zip [0 ..] (drawingClasses drawing),
      (c, Just k) <- zip [0 ..] line,
      let (i, j) = displaced c r
  ]
  where
    (x, y) = drawingOrigin drawing

-- | The composite with these symbols on it, 4 taxels of margin to the right and below, and their
-- centres.
drawn :: Drawing -> [(Int, WholeTaxels)] -> (Rows, [Taxels])
drawn drawing symbols =
  ( [[8000 + 750 * weight i j | i <- [0 .. width - 1]] | j <- [0 .. height - 1]],
    [(fromInteger x + 3.5, fromInteger y + 5.5) | (_, (x, y)) <- symbols]
  )
  where
    (x0, y0) = drawingOrigin drawing
    width = x0 + 16 * toInteger (length (transpose (drawingClasses drawing))) + 4
    height = y0 + 20 * toInteger (length (drawingClasses drawing)) + 4
    weight :: Integer -> Integer -> Natural
    weight i j
      | drawingBlurred drawing =
        sum
          [ (2 - fromInteger (abs a)) * (2 - fromInteger (abs b))
            | a <- [-1, 0, 1],
              b <- [-1, 0, 1],
              embossed (i + a) (j + b)
          ]
      | otherwise = if embossed i j then 16 else 0
    embossed i j = or [marked k (i - x) (j - y) | (k, (x, y)) <- symbols]

-- | Whether a class of the shipped alphabet is embossed there in its box of 8 x 12 taxels.
marked :: Int -> Integer -> Integer -> Bool
marked k i j
  | i < 0 || j < 0 || i >= 8 || j >= 12 = False
  | otherwise = or (take 1 (drop (fromInteger i) (concat (take 1 (drop (fromInteger j) rows)))))
  where
    rows = concat (take 1 (drop k alphabetRows))

alphabetRows :: [[[Bool]]]
alphabetRows = either (const []) (map bitmapRows . shapes) paperAlphabet

-- | The laws of segmentation.
segmentLaws :: [Law ()]
segmentLaws =
  [ comesOut
      "drawn-symbols"
      "symbols that are drawn come out, and nothing else does: the centres to half a pixel, the \
      \axes to 5 degrees"
      "they were drawn there"
      upright,
    comesOut
      "off-the-lattice"
      "symbols that do not stand on a lattice come out where they stand"
      "they were drawn there"
      ( \drawing ->
          let n = drawingChange drawing
              by c r =
                let k = toInteger (n * 7 + c * 5 + r * 11) in (k `mod` 3, k `div` 3 `mod` 3)
              (rows, centres) = drawn drawing (symbolsOf by drawing)
           in (rows, [Symbol centre 0 | centre <- centres])
      ),
    comesOut
      "turned"
      "on a composite turned by quarter turns, symbols and axes are turned by as much"
      "they are those of the scene, however it is seen"
      ( \drawing ->
          let (rows, symbols) = upright drawing
              symmetry = turned (1 + drawingChange drawing `mod` 3)
              size = (fromIntegral (length (concat (take 1 rows))), fromIntegral (length rows))
           in ( onRows symmetry rows,
                [ Symbol (onPixel symmetry size place) (degrees + degreesClockwise symmetry)
                  | Symbol place degrees <- symbols
                ]
              )
      ),
    comesOut
      "gain-and-offset"
      "a gain and an offset of all grey values change nothing"
      "what is affine in the grey values is no relief"
      ( \drawing ->
          let (rows, symbols) = upright drawing
              n = drawingChange drawing
              change = Affine (fromIntegral (1 + n `mod` 3)) (fromIntegral (n * 5))
           in (affinely change rows, symbols)
      ),
    comesOut
      "blank"
      "where nothing is drawn, nothing comes out"
      "a composite of one grey value shows nothing"
      ( \drawing ->
          let (rows, _) = upright drawing
           in (map (map (const (fromIntegral (60 * drawingChange drawing)))) rows, [])
      ),
    comesOut
      "cut-off"
      "symbols that the composite's edge cuts off do not come out, and the others do"
      "three of their columns or more were not touched"
      ( \drawing ->
          let (rows, symbols) = upright drawing
              less = fst (drawingOrigin drawing) + 3 + toInteger (drawingChange drawing `mod` 3)
           in ( map (drop (fromInteger less)) rows,
                [ Symbol (x - fromInteger less, y) degrees
                  | Symbol (x, y) degrees <- symbols,
                    x - 3.5 >= fromInteger less
                ]
              )
      ),
    invalidLaw
  ]

-- | The composite with its symbols upright, on the lattice.
upright :: Drawing -> (Rows, [Symbol])
upright drawing = (rows, [Symbol centre 0 | centre <- centres])
  where
    (rows, centres) = drawn drawing (symbolsOf (\_ _ -> (0, 0)) drawing)

-- | A law that of a drawing's composite these symbols come out.
comesOut :: String -> String -> String -> (Drawing -> (Rows, [Symbol])) -> Law ()
comesOut what sentence reason scene =
  law OnSegment what [OfSegment] sentence "how it was drawn; the protocol, segment" $ \() ->
    Cases drawingForm (Some genDrawing smallerDrawing) $ \drawing ->
      let (rows, wanted) = scene drawing
          question = Segment rows
          fits came = length came == length wanted && all (\one -> any (same one) came) wanted
       in judge question (Right wanted) fits "the scene" reason <$> ask question
  where
    same (Symbol (x, y) a) (Symbol (x', y') a') =
      max (abs (x - x')) (abs (y - y')) <= 0.5 && apart a a' <= 5
    -- Axes are up to half turns.
    apart a a' =
      let difference = abs (a - a')
          turns = fromIntegral (floor (difference / 180) :: Integer)
          d = difference - 180 * turns
       in min d (180 - d)

invalidLaw :: Law ()
invalidLaw =
  invalid OnSegment "refuses-what-is-invalid" OfSegment $ \() ->
    [ SomeQuestion (Segment rows)
      | rows <-
          [ [],
            [[]],
            replicate 20 (replicate 20 0) ++ [[0]],
            replicate 20 (replicate 20 (fullScale + 1))
          ]
    ]
      ++ malformed (Segment (replicate 20 (replicate 20 1)))
