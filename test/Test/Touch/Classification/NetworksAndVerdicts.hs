{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_GHC -O1 #-}

-- | Tests networks, their verdicts and files, and the shipped network's verdicts on images. The
-- conformance laws of networks define its outputs.
module Test.Touch.Classification.NetworksAndVerdicts (spec) where

import Control.Monad (forM_, replicateM)
import Data.Either (isRight)
import Data.List (elemIndex, transpose, unfoldr)
import qualified Data.Text as T
import qualified Data.Text.IO as T
import qualified Data.Vector.Storable as V
import Numeric.LinearAlgebra (fromColumns, fromLists, toLists)
import PraTactile.Classification.Calibration (standardCalibration)
import PraTactile.Classification.Estimate (estimate)
import PraTactile.Classification.Network
import PraTactile.Classification.Network.File
import PraTactile.Classification.Samples (withNoise)
import PraTactile.Classification.Specimens
import PraTactile.Classification.Templates (templates)
import PraTactile.Image
  ( Raster,
    constant,
    generate,
    onRaster,
    rasterValues,
  )
import PraTactile.Shape
import PraTactile.Symmetry
import System.Random (StdGen, mkStdGen)
import Test.Effort (byEffort, withCases)
import Test.Hspec
import Test.QuickCheck hiding (classify, generate)
import Test.Support
import Test.Touch.Paper (paperAlphabet, paperNetwork)

spec :: Spec
spec = do
  describe "A network" $ do
    it "has h x 97 hidden and q x (h + 1) output weights, and refuses other sizes" $ do
      let units r c = fromLists (replicate r (replicate c 0.5))
      let found =
            [ (r1, c1, r2, c2)
              | r1 <- [1, 2],
                c1 <- [96, 97, 98],
                r2 <- [1, 4],
                c2 <- [1 .. 4],
                isRight (network (units r1 c1) (units r2 c2))
            ]
      found `shouldBe` [(1, 97, 1, 2), (1, 97, 4, 2), (2, 97, 1, 3), (2, 97, 4, 3)]
    it "has only finite weights" $
      [ network (fromLists [replicate 96 0 ++ [w]]) (fromLists [[0, 0]])
        | w <- [1 / 0, -1 / 0, 0 / 0]
      ]
        `shouldBe` replicate 3 (Left NotFinite)
    it "outputs many images as it outputs each alone" $
      property $
        forAll ((,) <$> networkGen <*> listOf1 imageGen) $ \(n, drawn) ->
          whenRight (traverse (outputs n) drawn) $ \each ->
            let found = toLists (outputsOfAll n (fromColumns (map rasterValues drawn)))
             in length found === outputCount n
                  .&&. conjoin
                    [ counterexample (show (a, b)) (abs (a - b) < 1e-12)
                      | (as, bs) <- zip (transpose found) each,
                        (a, b) <- zip as bs
                    ]
                  .&&. map length found === replicate (outputCount n) (length drawn)
    it "refuses images that are not 8 x 12, or hold values that are not numbers" $
      property $
        forAll networkGen $ \n ->
          map (outputs n) [constant 12 8 0, constant 8 11 0, constant 0 0 0, constant 8 12 (0 / 0)]
            === [ Left (WrongImageSize 12 8),
                  Left (WrongImageSize 8 11),
                  Left (WrongImageSize 0 0),
                  Left NotFinite
                ]
    withCases 25 100 . it "sigmoid x = 1 / (1 + e^-x)" $
      property $
        -- Also where the powers of two end between which e^x is a series.
        forAll (oneof [choose (-40, 40), besidePowers]) $ \x ->
          let wanted = 1 / (1 + toThe (negate (toRational x)))
           in abs (toRational (sigmoid x) / wanted - 1) < 3e-16
    it "sigmoid is constant from -700 down" $ do
      map sigmoid [-700.001, -1e4, -1 / 0] `shouldBe` replicate 3 (sigmoid (-700))
      sigmoid (-700) `shouldSatisfy` (\y -> abs (y / exp (-700) - 1) < 1e-14)
    it "sigmoid rises from about 0 to 1, however far from 0 its argument" $ do
      let ys = map sigmoid [-1 / 0, -1e308, -1000, -1, 0, 1, 1000, 1e308, 1 / 0]
      ys `shouldSatisfy` \_ -> and (zipWith (<=) ys (drop 1 ys)) && all (\y -> y >= 0 && y <= 1) ys
      take 1 ys `shouldSatisfy` all (< 1e-300)
      drop 8 ys `shouldBe` [1]
    it "sigmoid x + sigmoid (-x) = 1" $
      property $ \x -> abs (sigmoid x + sigmoid (-x) - 1) < 1e-15

  describe "A verdict" $ do
    it "is the class k exactly if output k is high enough and leads all others by enough" $
      sequence_
        [ (high, lead, decide (Thresholds high lead) values) `shouldSatisfy` \(_, _, v) ->
            let winners = winnersBy high lead values
             in case v of
                  Recognised k best -> winners == [k] && Just best == lookup k (zip [0 ..] values)
                  NoSymbol best -> null winners && best < high && best == maximum values
                  Undecided (k, best) (j, next) ->
                    null winners
                      && best >= high
                      && best - next < lead
                      && k /= j
                      && best == maximum values
                      && lookup j (zip [0 ..] values) == Just next
          | values <- replicateM 3 quarters,
            high <- quarters,
            lead <- drop 1 quarters
        ]
    it "on no outputs is no symbol" $
      decide standardThresholds [] `shouldBe` NoSymbol 0
    it "on NaN outputs recognises nothing" $
      [ v
        | i <- [0 .. 2 :: Int],
          let v = decide standardThresholds [if i == j then 0 / 0 else 0.1 | j <- [0 .. 2]],
          Recognised _ _ <- [v]
      ]
        `shouldBe` []

  describe "A network file" $ do
    it "that is read is the network it was written from, to the bit" $
      property $ forAll networkGen $ \n -> parseNetwork (renderNetwork n) === Right n
    it "is refused at its first fault, with the line" $ do
      let good =
            "pra-tactile network 1\ninputs 96 hidden 1 outputs 1\n"
              <> T.unwords (replicate 97 "0.5")
              <> "\n1.0 2.0\n"
      isRight (parseNetwork good) `shouldBe` True
      map
        (either Just (const Nothing) . parseNetwork)
        [ "",
          "P5\n",
          "pra-tactile network 1\n",
          "pra-tactile network 1\ninputs 95 hidden 1 outputs 1\n",
          "pra-tactile network 1\ninputs 96 hidden 0 outputs 1\n",
          "pra-tactile network 1\ninputs 96 hidden 9999999 outputs 1\n",
          T.replace "0.5 0.5" "0.5" good,
          T.replace "2.0" "NaN" good,
          T.replace "2.0" "Infinity" good,
          T.replace "2.0" "1-2" good,
          T.replace "1.0 2.0\n" "" good,
          good <> "1.0 2.0\n",
          -- Some digits of a last number may be cut off.
          T.dropEnd 1 good,
          T.dropEnd 3 good
        ]
        `shouldBe` map
          Just
          [ NetworkFileEnds "pra-tactile network 1",
            UnexpectedNetworkLine 1 "pra-tactile network 1" "P5",
            NetworkFileEnds sizes,
            UnexpectedNetworkLine 2 sizes "inputs 95 hidden 1 outputs 1",
            UnexpectedNetworkLine 2 sizes "inputs 96 hidden 0 outputs 1",
            UnexpectedNetworkLine 2 sizes "inputs 96 hidden 9999999 outputs 1",
            UnexpectedNetworkLine
              3
              "96 weights and a bias"
              (T.take 60 (T.unwords (replicate 49 "0.5"))),
            UnexpectedNetworkLine 4 "1 weights and a bias" "1.0 NaN",
            UnexpectedNetworkLine 4 "1 weights and a bias" "1.0 Infinity",
            UnexpectedNetworkLine 4 "1 weights and a bias" "1.0 1-2",
            NetworkFileEnds "1 weights and a bias",
            UnexpectedNetworkLine 5 "the end of the file" "1.0 2.0",
            NetworkFileEnds "an end of line",
            NetworkFileEnds "an end of line"
          ]
    it "has numbers of at most 1000 characters" $ do
      let with number =
            parseNetwork
              ( "pra-tactile network 1\ninputs 96 hidden 1 outputs 1\n"
                  <> T.unwords (replicate 97 number)
                  <> "\n1.0 2.0\n"
              )
          digits n = "0." <> T.replicate (n - 2) "5"
      forM_ [3, 402, 1000, 1001] $ \n ->
        (n, isRight (with (digits n))) `shouldBe` (n, n <= 1000)
    it "with numbers too large for a Double is refused with their line" $
      fmap
        (const ())
        ( parseNetwork
            ( "pra-tactile network 1\ninputs 96 hidden 1 outputs 1\n"
                <> T.unwords (replicate 97 "0.5")
                <> "\n1.0 1e999\n"
            )
        )
        `shouldBe` Left (UnexpectedNetworkLine 4 "1 weights and a bias" "1.0 1e999")

  describe "The shipped network" $ do
    it "is read, has 8 hidden and 4 output units, and is written as it was" $ do
      file <- T.readFile "data/network.txt"
      fmap (\n -> (hiddenCount n, outputCount n, renderNetwork n)) paperNetwork
        `shouldBe` Right (8, 4, file)
    it "recognises each clean shape" $
      onShipped $ \n a ->
        [classify standardThresholds n (toRaster b) | b <- shapes a]
          `shouldSatisfy` \vs -> [k | Right (Recognised k _) <- vs] == [0 .. 3]
    it "refuses each clean shape turned by 180 degrees or mirrored, the blank and the full window" $
      onShipped $ \n a ->
        [ classify standardThresholds n image
          | image <-
              constant 8 12 0 :
              constant 8 12 1 :
                [ onRaster g (toRaster b)
                  | b <- shapes a,
                    g <- [turned 2, mirror, turned 2 <> mirror]
                ]
        ]
          `shouldSatisfy` all (either (const False) refused)
    it "misreads fewer than 0.6 % at noise up to 0.5 (the paper's figure), and answers none wrong" $
      onShipped $ \n a ->
        [ (deviation, tallied n (Just k) images (withNoise deviation (toRaster shape)) (1 + k))
          | deviation <- [0, 0.05 .. 0.5],
            (k, shape) <- zip [0 ..] (shapes a)
        ]
          `shouldSatisfy` all (\(_, t) -> tallyWrong t == 0 && 1000 * tallyOutvoted t < 6 * images)
    it "answers no image wrong that is displaced by up to 0.7 taxel, blurred, torn: 0.3 % refused" $
      onShipped $ \n a ->
        specimens n a Upright 2
          `shouldSatisfy` all (\t -> tallyWrong t == 0 && 1000 * tallyRefused t < 3 * images)
    it "answers no such image wrong that is incomplete: fewer than 6 % refused" $
      onShipped $ \n a ->
        specimens n a Curtailed 3
          `shouldSatisfy` all (\t -> tallyWrong t == 0 && 100 * tallyRefused t < 6 * images)
    it "takes no image of a class turned by 180 degrees for an upright symbol" $
      onShipped $ \n a ->
        specimens n a UpsideDown 4 `shouldSatisfy` all ((== images) . tallyRefused)
    it "takes fewer than 0.2 % of all other impostors for a symbol" $
      onShipped $ \n a ->
        [ (kind, sum (map (\t -> images - tallyRefused t) tallies), length tallies)
          | kind <- impostors,
            let tallies = specimens n a kind 5
        ]
          `shouldSatisfy` all (\(_, taken, drawn) -> 500 * taken < drawn * images)
    it "gives no estimate if it has another number of classes than the alphabet" $
      onShipped $ \_ a -> do
        single <- right (network (fromLists [replicate 97 0]) (fromLists [[0, 0]]))
        (() <$ estimate (standardCalibration 4) (templates a) single (constant 8 12 0))
          `shouldBe` Left (WrongOutputCount 1 4)

-- | The verdicts on a number of images.
data Tally = Tally
  { -- | recognised as another class
    tallyWrong :: Int,
    tallyRefused :: Int,
    -- | another class's output is the greatest, whatever the verdict: the paper's error, which has
    -- no refusal
    tallyOutvoted :: Int
  }
  deriving stock (Show)

-- | The verdicts on this many images of a class, or of none, drawn one after the other from a seed.
tallied :: Network -> Maybe Int -> Int -> (StdGen -> (Raster, StdGen)) -> Int -> Tally
tallied n class' count draw seed =
  Tally
    (length [k | Right (Recognised k _) <- verdicts, Just k /= class'])
    (length [v | Right v <- verdicts, refused v])
    (length [values | Right values <- map (outputs n) drawn, greatest values /= class'])
  where
    verdicts = map (classify standardThresholds n) drawn
    drawn = take count (unfoldr (Just . draw) (mkStdGen seed))
    greatest values = elemIndex (maximum values) values

-- | The number of images of each kind and class.
images :: Int
images = byEffort 350 1100

-- | Specimens of a kind at noise 0.1, of each class's shape.
specimens :: Network -> Alphabet -> SpecimenKind -> Int -> [Tally]
specimens n a kind seed =
  [ tallied n (if genuine kind then Just k else Nothing) images (drawn shape) (seed + k)
    | (k, shape) <- zip [0 ..] (shapes a)
  ]
  where
    drawn shape g = let (image, g') = specimen a kind shape g in withNoise 0.1 image g'

-- | Numbers near an odd number of halves of ln 2.
besidePowers :: Gen Double
besidePowers = do
  k <- choose (-58, 58)
  off <- choose (0, 0.03)
  side <- elements [-1, 1]
  pure ((fromIntegral (k :: Int) + 0.5) * log 2 + side * off)

-- | e to the power of a number of at most 41 in size, exact to far more than a Double's digits.
toThe :: Rational -> Rational
toThe x = sum (take 200 (scanl (\term k -> term * x / k) 1 (iterate (+ 1) 1)))

sizes :: T.Text
sizes = "inputs 96 hidden H outputs Q"

refused :: Verdict -> Bool
refused (Recognised _ _) = False
refused _ = True

quarters :: [Double]
quarters = [0, 0.25, 0.5, 0.75, 1]

-- | The classes whose outputs are this high and lead all others by this much.
winnersBy :: Double -> Double -> [Double] -> [Int]
winnersBy high lead values =
  [ k
    | (k, v) <- zip [0 ..] values,
      v >= high,
      and [v - w >= lead | (j, w) <- zip [0 ..] values, j /= k]
  ]

onShipped :: (Network -> Alphabet -> Expectation) -> Expectation
onShipped check = case (paperNetwork, paperAlphabet) of
  (Right n, Right a) -> check n a
  refusals -> expectationFailure (show refusals)

networkGen :: Gen Network
networkGen = do
  h <- choose (1, 9)
  q <- choose (1, 5)
  let weight =
        frequency [(8, choose (-3, 3)), (1, elements [0, -0.0, 5.0e-324, 1.0e-300, 0.1, 1 / 3])]
  suchThatMap
    ( network
        <$> (fromLists <$> vectorOf h (vectorOf 97 weight))
        <*> (fromLists <$> vectorOf q (vectorOf (h + 1) weight))
    )
    (either (const Nothing) Just)

imageGen :: Gen Raster
imageGen = do
  values <- V.fromList <$> vectorOf 96 (choose (-0.5, 1.5))
  pure (generate 8 12 (\x y -> values V.! (8 * y + x)))
