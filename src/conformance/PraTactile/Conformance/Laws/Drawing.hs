{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Composites with drawn symbols, for which the right segmentation is known.
module PraTactile.Conformance.Laws.Drawing
  ( Drawing (..),
    drawingForm,

    -- * Generation
    genDrawing,
    smallerDrawing,
    genBlock,
    smallerBlock,

    -- * The composite
    symbolsOf,
    drawn,
    upright,
    atAngle,
  )
where

import Data.List (transpose)
import Data.Maybe (isNothing)
import qualified Data.Vector.Unboxed as Vector
import PraTactile.Conformance.Laws.Relief
import PraTactile.Conformance.Question
import PraTactile.Conformance.Shapes (agreedAlphabet)
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
import PraTactile.Shape (bitmapRows, shapes)
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

-- | A composite with drawn symbols.
data Drawing = Drawing
  { -- | The classes of the symbols on a lattice of 16 x 20 taxels, row by row, with gaps.
    drawingClasses :: [[Maybe Int]],
    -- | The upper left taxel of the lattice's first symbol.
    drawingOrigin :: WholeTaxels,
    -- | Whether the image is blurred.
    drawingBlurred :: Bool,
    -- | A number that selects how a law changes it.
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

-- | A drawing with enough adjacent symbols that their angle is certain.
genBlock :: Gen Drawing
genBlock = do
  columns <- chooseInt (2, 3)
  classes <- vectorOf 2 (vectorOf columns (Just <$> chooseInt (0, 3)))
  (\drawing -> drawing {drawingClasses = classes}) <$> genDrawing

-- | 'smallerDrawing' for drawings of at least two by two symbols.
smallerBlock :: Drawing -> [Drawing]
smallerBlock = filter (enough . drawingClasses) . smallerDrawing
  where
    enough classes = length classes >= 2 && length (transpose classes) >= 2

-- | Drawings with fewer symbols, nearer to the corner, sharp, or with less of a change.
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

-- | The symbols of a drawing, each with its class and its upper left taxel. The function gives a
-- displacement from the lattice by column and row.
symbolsOf :: (Int -> Int -> WholeTaxels) -> Drawing -> [(Int, WholeTaxels)]
symbolsOf displaced drawing =
  [ (k, (x + 16 * toInteger c + i, y + 20 * toInteger r + j))
    | (r, line) <- zip [0 ..] (drawingClasses drawing),
      (c, Just k) <- zip [0 ..] line,
      let (i, j) = displaced c r
  ]
  where
    (x, y) = drawingOrigin drawing

-- | The composite with these symbols, with a margin of 4 taxels to the right and below, and the
-- symbols' centres.
drawn :: Drawing -> [(Int, WholeTaxels)] -> (Rows, [Taxels])
drawn drawing symbols =
  ( map (map (\weight -> 8000 + 750 * weight)) (felt drawing raised),
    [(fromInteger x + 3.5, fromInteger y + 5.5) | (_, (x, y)) <- symbols]
  )
  where
    (x0, y0) = drawingOrigin drawing
    width = x0 + 16 * toInteger (length (transpose (drawingClasses drawing))) + 4
    height = y0 + 20 * toInteger (length (drawingClasses drawing)) + 4
    raised =
      [[if embossed i j then 1 else 0 | i <- [0 .. width - 1]] | j <- [0 .. height - 1]]
    embossed i j = or [marked k (i - x) (j - y) | (k, (x, y)) <- symbols]

-- | Sixteen times the image of a relief: blurred by the weights 1, 2, 1 along both axes, or
-- unchanged. The relief ends at the edge.
felt :: Num a => Drawing -> [[a]] -> [[a]]
felt drawing
  | drawingBlurred drawing = transpose . map binomial . transpose . map binomial
  | otherwise = map (map (16 *))
  where
    binomial line = zipWith3 (\a b c -> a + 2 * b + c) (0 : line) line (drop 1 line ++ [0])

-- | Whether a class of the shipped alphabet is embossed at a taxel of its box of 8 x 12.
marked :: Int -> Integer -> Integer -> Bool
marked k i j
  | i < 0 || j < 0 || i >= 8 || j >= 12 = False
  | otherwise = or (take 1 (drop (fromInteger i) (concat (take 1 (drop (fromInteger j) rows)))))
  where
    rows = concat (take 1 (drop k alphabetRows))

alphabetRows :: [[[Bool]]]
alphabetRows = either (const []) (map bitmapRows . shapes) agreedAlphabet

-- | The composite with its symbols upright on the lattice.
upright :: Drawing -> (Rows, [Symbol])
upright drawing = (rows, [Symbol centre 0 | centre <- centres])
  where
    (rows, centres) = drawn drawing (symbolsOf (\_ _ -> (0, 0)) drawing)

-- | A composite of 64 x 64 pixels around the middle of a face with the symbols. The face is
-- rotated clockwise by half a degree more than the change's number of degrees. A pixel's value is
-- the embossed share of 16 sample points.
atAngle :: Drawing -> (Rows, [Symbol])
atAngle drawing =
  ( [[8000 + fromIntegral (12000 * w `div` 256) | w <- line] | line <- felt drawing raised],
    [ Symbol (mx + c * u - s * v, my + s * u + c * v) degrees
      | (_, (x, y)) <- symbols,
        let (u, v) = (fromInteger x + 4 - half wide, fromInteger y + 6 - half high)
    ]
  )
  where
    degrees = fromIntegral (drawingChange drawing `mod` 360) + 0.5 :: Double
    (c, s) = (cos (degrees * pi / 180), sin (degrees * pi / 180))
    classes = drawingClasses drawing
    symbols = symbolsOf (\_ _ -> (0, 0)) drawing {drawingOrigin = (0, 0)}
    (wide, high) = (16 * length (transpose classes) - 8, 20 * length classes - 8)
    half side = fromIntegral side / 2 :: Double
    -- The middle of the face.
    (mx, my) = (middle (fst (drawingOrigin drawing)), middle (snd (drawingOrigin drawing)))
    middle o = 31.5 + fromInteger (o - 6) / 4 :: Double
    -- The number of embossed sample points, of 16.
    raised =
      [ [ length [() | y <- sixteenths j, x <- sixteenths i, embossed (x - mx) (y - my)]
          | i <- [0 .. 63 :: Int]
        ]
        | j <- [0 .. 63 :: Int]
      ]
    sixteenths i = [fromIntegral i + k / 8 | k <- [-3, -1, 1, 3]]
    embossed x y = onFace (floor (c * x + s * y + half wide)) (floor (c * y - s * x + half high))
    onFace x y = x >= 0 && y >= 0 && x < wide && y < high && face Vector.! (y * wide + x)
    -- The face's taxels, row by row.
    face = Vector.fromList [shown x y | y <- places high, x <- places wide]
    places side = [0 .. toInteger side - 1]
    shown x y = or [marked k (x - i) (y - j) | (k, (i, j)) <- symbols]
