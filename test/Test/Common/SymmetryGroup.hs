-- | The symmetries of the square: a group, and its actions. All elements, not samples.
module Test.Common.SymmetryGroup (spec) where

import Control.Monad (forM_)
import Data.List (nub)
import PraTactile.Position
import PraTactile.Symmetry
import Test.Hspec

spec :: Spec
spec = do
  describe "the group" $ do
    it "has eight elements, which are seen differently" $ do
      length (nub symmetries) `shouldBe` 8
      length (nub [onRows g ["ab", "cd"] | g <- symmetries]) `shouldBe` 8
    it "g <> h is one of them" $
      [(g, h) | g <- symmetries, h <- symmetries, g <> h `notElem` symmetries] `shouldBe` []
    it "identity <> g = g = g <> identity" $
      [g | g <- symmetries, identity <> g /= g || g <> identity /= g || mempty <> g /= g]
        `shouldBe` []
    it "(f <> g) <> h = f <> (g <> h)" $
      [ (f, g, h)
        | f <- symmetries,
          g <- symmetries,
          h <- symmetries,
          (f <> g) <> h /= f <> (g <> h)
      ]
        `shouldBe` []
    it "invert g <> g = identity = g <> invert g" $
      [g | g <- symmetries, invert g <> g /= identity || g <> invert g /= identity] `shouldBe` []
    it "turned m <> turned n = turned (m + n), and turned 4 = identity" $ do
      [(m, n) | m <- [-5 .. 5], n <- [-5 .. 5], turned m <> turned n /= turned (m + n)]
        `shouldBe` []
      turned 4 `shouldBe` identity
    it "mirror <> mirror = identity, and mirror <> turned n = turned (-n) <> mirror" $ do
      mirror <> mirror `shouldBe` identity
      [n | n <- [0 .. 3], mirror <> turned n /= turned (negate n) <> mirror] `shouldBe` []
    it "consists of the rotations and those of the mirror image, each by what it is called" $ do
      [(mirrored g, quarterTurns g) | g <- symmetries]
        `shouldBe` [(m, n) | m <- [False, True], n <- [0 .. 3]]
      symmetries `shouldBe` rotations ++ [g <> mirror | g <- rotations]
  describe "its actions" $ do
    it "rows: turned 1 is a quarter turn clockwise, mirror exchanges left and right" $ do
      onRows (turned 1) ["abc", "def"] `shouldBe` ["da", "eb", "fc"]
      onRows mirror ["abc", "def"] `shouldBe` ["cba", "fed"]
    it "onRows identity = id, and onRows (g <> h) = onRows g . onRows h" $ do
      onRows identity scene `shouldBe` scene
      forM_ symmetries $ \g ->
        forM_ symmetries $ \h -> onRows (g <> h) scene `shouldBe` onRows g (onRows h scene)
    it "onShape (g <> h) = onShape g . onShape h, the shape of the rows" $
      forM_ shapes $ \shape -> forM_ symmetries $ \g -> do
        let seen = onRows g (cellsOf shape)
        onShape g shape `shouldBe` Shape (count seen) (maximum (map count seen))
        forM_ symmetries $ \h -> onShape (g <> h) shape `shouldBe` onShape g (onShape h shape)
    it "onPosition tells where the rows have a cell" $
      forM_ shapes $ \shape -> forM_ symmetries $ \g -> do
        let seen =
              [ (cell, Position i j)
                | (i, line) <- zip [0 ..] (onRows g (cellsOf shape)),
                  (j, cell) <- zip [0 ..] line
              ]
        [(cell, onPosition g shape cell) | (cell, _) <- seen] `shouldBe` seen
    it "onPosition (g <> h) shape = onPosition g (onShape h shape) . onPosition h shape" $
      forM_ shapes $ \shape ->
        forM_ symmetries $ \g -> forM_ symmetries $ \h -> forM_ (concat (cellsOf shape)) $ \cell ->
          onPosition (g <> h) shape cell
            `shouldBe` onPosition g (onShape h shape) (onPosition h shape cell)
    it "onPixel is onPosition, columns before rows" $
      forM_ shapes $ \shape@(Shape h w) -> forM_ symmetries $ \g ->
        forM_ (concat (cellsOf shape)) $ \cell@(Position i j) -> do
          let Position i' j' = onPosition g shape cell
              whole n = toInteger n
          onPixel g (whole w, whole h) (whole j, whole i) `shouldBe` (whole j', whole i')
    it "onOffset is the difference of places" $
      forM_ symmetries $ \g -> forM_ [(x, y) | x <- [-2 .. 2], y <- [-2 .. 2]] $ \(x, y) -> do
        let (x0, y0) = onPixel g (3, 4) (0, 0)
            (x1, y1) = onPixel g (3, 4) (x, y)
        onOffset g (x, y) `shouldBe` (x1 - x0, y1 - y0 :: Int)
    it "turnedByDegrees is the inverse of degreesClockwise, modulo 360" $ do
      [turnedByDegrees (360 * n + degreesClockwise g) | n <- [-2 .. 2], g <- rotations]
        `shouldBe` [Just g | _ <- [-2 .. 2 :: Int], g <- rotations]
      map turnedByDegrees [1, 89.9, -45, 1 / 0, 0 / 0] `shouldBe` replicate 5 Nothing
  where
    scene = ["abc", "def"]
    shapes = [Shape h w | h <- [1 .. 3], w <- [1 .. 4]]
    cellsOf (Shape h w) = [[Position i j | j <- [0 .. w - 1]] | i <- [0 .. h - 1]]
    count xs = fromIntegral (length xs)
