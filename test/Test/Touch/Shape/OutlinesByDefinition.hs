-- | Tests outlines of shapes by what they enclose.
module Test.Touch.Shape.OutlinesByDefinition (spec) where

import Data.List (nub, sort)
import PraTactile.Shape hiding (alphabet)
import PraTactile.Shape.Outline
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck
import Test.Touch.Paper (paperAlphabet)

spec :: Spec
spec = do
  prop "outlines wind once round each embossed taxel and round no other" $
    forAllBlind genBitmap $ \shape -> case outlines shape of
      Left _ -> label "two taxels meet at a corner only" True
      Right loops ->
        conjoin
          [ counterexample (show ((x, y), shape)) $
              sum (map (winding x y) loops) === if on then 1 else 0
            | y <- [-1 .. symbolHeight],
              x <- [-1 .. symbolWidth],
              let on = embossedAt shape x y
          ]
  prop "outlines turn at each of their corners, and no two meet" $
    forAllBlind genBitmap $ \shape -> case outlines shape of
      Left _ -> property True
      Right loops ->
        conjoin
          [ counterexample (show loops) (sort (nub (concat loops)) === sort (concat loops)),
            conjoin
              [ counterexample (show loop) ((fst a == fst b) /= (fst b == fst c))
                | loop <- loops,
                  (a, b, c) <- zip3 loop (rotated 1 loop) (rotated 2 loop)
              ]
          ]
  prop "a shape is refused if and only if two of its taxels meet only at a corner" $
    forAllBlind genBitmap $ \shape ->
      let crossed =
            [ (x, y)
              | x <- [0 .. symbolWidth],
                y <- [0 .. symbolHeight],
                let four = [embossedAt shape (x - i) (y - j) | j <- [1, 0], i <- [1, 0]],
                four `elem` [[True, False, False, True], [False, True, True, False]]
            ]
       in either (\(Contact at) -> at `elem` crossed) (const (null crossed)) (outlines shape)
            === True
  it "the shipped shapes have one outline each, and strokes of two taxels" $
    case paperAlphabet of
      Left why -> expectationFailure (show why)
      Right alphabet -> do
        map (fmap length . outlines) (shapes alphabet) `shouldBe` replicate 4 (Right 1)
        map finestStroke (shapes alphabet) `shouldBe` replicate 4 2
  where
    rotated n loop = drop n loop ++ take n loop

-- | The number of times a loop goes counter-clockwise round the middle of a taxel, by its sides
-- that run down and up to the left of it.
winding :: Int -> Int -> [Corner] -> Int
winding x y loop =
  sum
    [ signum (v' - v)
      | ((u, v), (u', v')) <- zip loop (drop 1 loop ++ take 1 loop),
        u == u',
        u <= x,
        min v v' <= y,
        y < max v v'
    ]

-- | Some rectangles of taxels, added and removed.
genBitmap :: Gen Bitmap
genBitmap = do
  parts <- listOf1 ((,) <$> frequency [(3, pure True), (1, pure False)] <*> genBox)
  pure (bitmapWhere (\x y -> foldl (drawn x y) False parts))
  where
    drawn x y on (put, box) = if inBox box x y then put else on
    genBox = do
      (x, y) <- (,) <$> choose (0, symbolWidth - 1) <*> choose (0, symbolHeight - 1)
      (w, h) <- (,) <$> choose (1, 4) <*> choose (1, 6)
      pure (x, y, x + w, y + h)
    inBox (x0, y0, x1, y1) x y = x0 <= x && x < x1 && y0 <= y && y < y1
