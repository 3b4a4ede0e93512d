{-# LANGUAGE GADTs #-}
{-# LANGUAGE OverloadedStrings #-}

-- | What the laws of segmentation show: of each drawing, what is asked is what the law's sentence
-- says, and exactly the answers within its tolerance pass.
module Test.Conformance.Drawings (spec) where

import Data.Aeson (Value (..))
import Data.Complex (Complex (..), cis, imagPart, realPart)
import Data.Foldable (for_)
import Data.List (nub, sort)
import Data.Maybe (fromMaybe, isJust, listToMaybe)
import qualified Data.Set as Set
import Numeric.Natural (Natural)
import PraTactile.Conformance
import PraTactile.Conformance.Ask
import PraTactile.Conformance.Law (Verdict (..))
import PraTactile.Conformance.Question
import PraTactile.Shape (bitmapRows, paperAlphabet, shapes)
import PraTactile.Symmetry
import Test.Conformance.Asking
import Test.Hspec

spec :: Spec
spec = do
  for_ ways $ \(name, way) ->
    it (name ++ ": the drawing that it says; to half a pixel and 5 degrees") $ do
      cases <- drawn 30 ("segment/" ++ name)
      for_ cases $ \(value, trial) ->
        case rowsIn trial of
          [rows] -> case way (drawing value) rows of
            wanted : _ -> do
              let verdict answers = passes (segmenting answers) trial
                  first change = case wanted of
                    one : rest -> [change one : rest]
                    [] -> []
                  byPlace d one = one {symbolPlace = symbolPlace one `plus` d}
                  byAngle d one = one {symbolDegrees = symbolDegrees one + d}
              verdict wanted `shouldBe` True
              verdict (reverse wanted) `shouldBe` True
              map verdict (within 0.49 >>= first . byPlace) `shouldSatisfy` and
              map verdict (within 0.51 >>= first . byPlace) `shouldSatisfy` not . or
              map verdict ([4.9, -4.9, 180, -184.9, 364.9] >>= first . byAngle)
                `shouldSatisfy` and
              map verdict ([5.1, -5.1, 90, 174.9, -185.1] >>= first . byAngle)
                `shouldSatisfy` not . or
              map verdict ((Symbol (1, 1) 0 : wanted) : [drop 1 wanted | not (null wanted)])
                `shouldSatisfy` not . or
            [] -> expectationFailure (name ++ ": another drawing for " ++ show value)
          several -> expectationFailure (show (length several) ++ " questions")
  it "symbols are of all classes and stand alone or side by side, sharp or blurred" $ do
    cases <- drawn 200 "segment/drawn-symbols"
    let classes = [under "classes" value | (value, _) <- cases] :: [[[Maybe Int]]]
        origins = [under "origin" value | (value, _) <- cases] :: [(Integer, Integer)]
    nub (sort (concatMap concat classes)) `shouldBe` Nothing : map Just [0 .. 3]
    nub (sort (map (\rows -> (length rows, length (concat (take 1 rows)))) classes))
      `shouldBe` [(a, b) | a <- [1, 2], b <- [1 .. 3]]
    filter (not . any isJust . concat) classes `shouldBe` []
    nub (sort (map fst origins)) `shouldBe` [2 .. 10]
    nub (sort (map snd origins)) `shouldBe` [2 .. 10]
    sort (nub [under "blurred" value | (value, _) <- cases]) `shouldBe` [False, True]
  where
    ways =
      [ ("drawn-symbols", \d rows -> [symbols d | rows == upright d]),
        ( "off-the-lattice",
          \d rows ->
            [ [Symbol (centre place) 0 | (_, place) <- places]
              | places <- displaced d rows
            ]
        ),
        ( "turned",
          \d rows ->
            [ [ Symbol (onPixel s (size d) place) (degreesClockwise s)
                | Symbol place _ <- symbols d
              ]
              | s <- drop 1 rotations,
                rows == onRows s (upright d)
            ]
        ),
        ( "turned-by-degrees",
          \d rows ->
            [ found
              | length (drawingClasses d) == 2,
                all ((`elem` [2, 3]) . length) (drawingClasses d),
                all (all isJust) (drawingClasses d),
                let (rows', found) = turnedBy (fromIntegral (drawingChange d) + 0.5) d,
                rows == rows'
            ]
        ),
        ( "gain-and-offset",
          \d rows -> [symbols d | isJust (affineOf (upright d) rows)]
        ),
        ( "blank",
          \d rows ->
            [ []
              | length (nub (concat rows)) == 1,
                map length rows == map length (upright d)
            ]
        ),
        ( "cut-off",
          \d rows ->
            [ [ Symbol (x - less, y) 0
                | Symbol (x, y) _ <- symbols d,
                  x - 3.5 >= less
              ]
              | columns <- [3 .. 5],
                let less = fromInteger (fst (drawingOrigin d) + columns),
                rows == map (drop (round less)) (upright d)
            ]
        )
      ]
    symbols d = [Symbol (centre place) 0 | (_, place) <- symbolsOf d]
    centre (x, y) = (fromInteger x + 3.5, fromInteger y + 5.5)
    upright d = composite d (symbolsOf d)
    size d = (genericLength' (concat (take 1 (upright d))), genericLength' (upright d))
    genericLength' = fromIntegral . length
    -- Each of the symbols up to two taxels to the right and below.
    displaced d rows =
      [ places
        | places <- foldr step [[]] (symbolsOf d),
          rows == composite d places
      ]
      where
        step (k, place) more =
          [ (k, moved) : rest
            | i <- [0 .. 2],
              j <- [0 .. 2],
              let moved = place `plus` (i, j),
              shownAt k moved,
              rest <- more
          ]
        -- What stands there in the rows is what this symbol would be.
        shownAt k (x, y) =
          let alone = composite d [(k, (x, y))]
              box = crop (x + 1, y + 1) (6, 10)
           in box alone == box rows
        crop (x, y) (w, h) =
          map (take w . drop (fromInteger x)) . take h . drop (fromInteger y)

rowsIn :: Ask Verdict -> [Rows]
rowsIn trial = [rows | Question' (Segment rows) <- snd (asked (segmenting []) trial)]

segmenting :: [Symbol] -> Question b -> b
segmenting answer question = case question of
  Segment _ -> answer
  _ -> error "another question"

data Drawing = Drawing
  { drawingClasses :: [[Maybe Int]],
    drawingOrigin :: WholeTaxels,
    drawingBlurred :: Bool,
    drawingChange :: Int
  }

drawing :: Value -> Drawing
drawing value =
  Drawing
    (under "classes" value)
    (under "origin" value)
    (under "blurred" value)
    (under "change" value)

-- | The symbols, each with its upper left taxel, on a lattice of 16 x 20 taxels.
symbolsOf :: Drawing -> [(Int, WholeTaxels)]
symbolsOf d =
  [ (k, drawingOrigin d `plus` (16 * c, 20 * r))
    | (r, line) <- zip [0 ..] (drawingClasses d),
      (c, Just k) <- zip [0 ..] line
  ]

-- | The composite with these symbols: 8000 the background, 20000 what is embossed; blurred with the
-- weights 1 2 1 along both axes; 4 taxels more to the right and below than cells of the lattice.
composite :: Drawing -> [(Int, WholeTaxels)] -> Rows
composite d symbols =
  [[8000 + 750 * weight x y | x <- [0 .. w - 1]] | y <- [0 .. h - 1]]
  where
    (x0, y0) = drawingOrigin d
    w = x0 + 16 * maximum (0 : map count (drawingClasses d)) + 4
    h = y0 + 20 * count (drawingClasses d) + 4
    count list = fromIntegral (length list) :: Integer
    weight x y = if drawingBlurred d then blurred x y else 16 * embossed x y
    blurred x y =
      sum
        [ k * k' * embossed (x + i) (y + j)
          | (i, k) <- zip [-1, 0, 1] [1, 2, 1],
            (j, k') <- zip [-1, 0, 1] [1, 2, 1]
        ]
    embossed x y =
      if or [isMarked k (x - left) (y - top) | (k, (left, top)) <- symbols] then 1 else 0 :: Natural

-- | A composite of 64 x 64, of the face with these symbols turned by so many degrees clockwise, and
-- its symbols. The middle of the face is that of the composite, moved by a quarter of a taxel for
-- each taxel of the origin beyond 6. The plane is that of the complex numbers.
turnedBy :: Double -> Drawing -> (Rows, [Symbol])
turnedBy degrees d =
  ( [[8000 + 12000 * weight x y `div` 256 | x <- [0 .. 63]] | y <- [0 .. 63]],
    [ Symbol (realPart at', imagPart at') degrees
      | (_, (x, y)) <- symbols,
        let at' = middle + turn * (((fromInteger x + 4) :+ (fromInteger y + 6)) - faceMiddle)
    ]
  )
  where
    turn = cis (degrees * pi / 180)
    symbols = symbolsOf d {drawingOrigin = (0, 0)}
    quarters t = 31.5 + 0.25 * fromInteger (t - 6) :: Double
    middle = let (x, y) = drawingOrigin d in quarters x :+ quarters y
    faceMiddle =
      let edges = ([x + 8 | (_, (x, _)) <- symbols], [y + 12 | (_, (_, y)) <- symbols])
       in fromInteger (maximum (fst edges)) / 2 :+ fromInteger (maximum (snd edges)) / 2
    raised =
      Set.fromList
        [ (x + i, y + j)
          | (k, (x, y)) <- symbols,
            i <- [0 .. 7],
            j <- [0 .. 11],
            isMarked k i j
        ]
    isRaised place =
      let u :+ v = (place - middle) / turn + faceMiddle in Set.member (floor u, floor v) raised
    count x y =
      fromIntegral . length . filter isRaised $
        [ (x + (2 * i - 3) / 8) :+ (y + (2 * j - 3) / 8)
          | i <- [0 .. 3],
            j <- [0 .. 3]
        ] ::
        Natural
    counts = [[count x y | x <- [0 .. 63]] | y <- [0 .. 63]]
    weight x y
      | drawingBlurred d =
        sum
          [ k * k' * counted (x + i) (y + j)
            | (i, k) <- zip [-1, 0, 1] [1, 2, 1],
              (j, k') <- zip [-1, 0, 1] [1, 2, 1]
          ]
      | otherwise = 16 * counted x y
    counted x y = fromMaybe 0 (nth x =<< nth y counts)

-- | Whether a class is embossed there in its box.
isMarked :: Int -> Integer -> Integer -> Bool
isMarked k i j = fromMaybe False (nth i =<< nth j =<< nth (toInteger k) alphabet)
  where
    alphabet = either (const []) (map bitmapRows . shapes) paperAlphabet

nth :: Integer -> [a] -> Maybe a
nth i list = if i < 0 then Nothing else listToMaybe (drop (fromInteger i) list)
