{-# LANGUAGE OverloadedStrings #-}

-- | Locating from probabilities: the rule of Bayes.
module PraTactile.Conformance.Laws.Chances
  ( chanceLaws,
  )
where

import Control.Monad (replicateM)
import Data.Aeson (toJSON)
import Data.List (sort)
import Numeric.Natural (Natural)
import PraTactile.Array (Shape (..), naturalsBelow)
import PraTactile.Conformance.Definition (Known, knownProfile)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Draw
import PraTactile.Conformance.Laws.Judge
import PraTactile.Conformance.Laws.Locate
import PraTactile.Conformance.Laws.Malformed
import PraTactile.Conformance.Laws.Smaller
import PraTactile.Conformance.Question
import PraTactile.Profile (Profile (..))
import Test.QuickCheck

-- | The laws of the probabilities of positions.
chanceLaws :: [Law Known]
chanceLaws = systematicLaws ++ drawnLaws ++ [invalidLaw]

bayes :: String -> String -> (Known -> Domain SomeQuestion) -> Law Known
bayes what sentence =
  defined
    OnChances
    what
    OfPosterior
    sentence
    "Bayes, cells being independent and positions equally likely beforehand; the \
    \protocol, posterior"

asked :: Chances -> SomeQuestion
asked = SomeQuestion . Posterior

certain :: Patch -> Chances
certain = map (map (maybe Unfelt Certainly))

systematicLaws :: [Law Known]
systematicLaws =
  [ bayes "certain-cells" "of symbols beyond doubt all positions that agree are equally likely" $
      \known -> Every (asked . certain <$> smallPatches 70 (knownProfile known)),
    bayes "certain-as-probabilities" "a code is as good as probability 1 of it" $ \known ->
      Every
        [ asked [[Probably (sure (knownProfile known) code)]]
          | code <- elementsOf (knownProfile known)
        ],
    bayes "doubtful-cells" "a cell in which two symbols are equally likely" $ \known ->
      Every
        [ asked [[Probably (halves (knownProfile known) a b), cell]]
          | a <- take 4 (elementsOf (knownProfile known)),
            b <- take 4 (elementsOf (knownProfile known)),
            a /= b,
            cell <- [Unfelt, Certainly 1]
        ],
    bayes "nothing-known" "if nothing is known all positions are equally likely" $ \known ->
      Every (asked . certain <$> unobserved (knownProfile known)),
    bayes
      "across-the-edges"
      "across the edges only positions at which all observed cells lie \
      \count"
      $ \known -> Every (asked . certain <$> take 24 (acrossEdges known)),
    bayes "sums-are-divided-by" "numbers that add up to 1 within 0.001 are divided by their sum" $
      \known ->
        Every
          [ asked [[Probably (map (* factor) (uneven (knownProfile known)))], [Unfelt]]
            | factor <- [1.0005, 0.9995, 1.0009, 0.9991]
          ]
  ]

sure :: Profile -> Code -> [Double]
sure p code = [if c == code then 1 else 0 | c <- elementsOf p]

halves :: Profile -> Code -> Code -> [Double]
halves p a b = [if c == a || c == b then 0.5 else 0 | c <- elementsOf p]

-- | 1/2, 1/4, ..., the last one twice.
uneven :: Profile -> [Double]
uneven p = take n (iterate (/ 2) 0.5) ++ [0.5 ^^ n]
  where
    n = fromIntegral (profileOrder p) - 1 :: Int

drawnLaws :: [Law Known]
drawnLaws =
  [ bayes
      "bayes"
      "the probability of a position is the product of the probabilities of its symbols, \
      \divided by \
      \the sum over all positions"
      (\known -> Some (asked <$> genChances (knownProfile known)) smaller),
    bayes "contradictions" "what fits no position is refused: contradiction" $ \known ->
      Some (asked . certain <$> genDamaged known (Damage 10 30)) smaller,
    bayes "likely-patches" "a patch that was seen, each cell a little doubtful" $ \known ->
      Some
        ( genDamaged known (Damage 20 5)
            >>= fmap asked
              . traverse
                (traverse (doubtful (knownProfile known)))
        )
        smaller
  ]

-- | In each cell, probabilities in 64ths, which doubles have exactly.
genChances :: Profile -> Gen Chances
genChances p = do
  Shape h w <- elements (shapesAround p)
  replicateM
    (fromIntegral h)
    (replicateM (fromIntegral w) (frequency [(1, pure Unfelt), (4, chances)]))
  where
    chances = do
      cuts <- vectorOf (fromIntegral (profileOrder p) - 1) (chooseInteger (0, 64))
      let ends = sort cuts
      Probably . map ((/ 64) . fromInteger) <$> shuffle (zipWith (-) (ends ++ [64]) (0 : ends))

-- | Mostly what it is, and the rest for another one.
doubtful :: Profile -> Maybe Code -> Gen Chance
doubtful p cell = case cell of
  Nothing -> pure Unfelt
  Just code -> do
    other <- upTo (profileOrder p - 1)
    share <- chooseInteger (1, 31)
    pure (Probably (zipWith (+) (scaled (64 - share) code) (scaled share other)))
  where
    scaled :: Integer -> Code -> [Double]
    scaled share code = map (* (fromInteger share / 64)) (sure p code)

invalidLaw :: Law Known
invalidLaw =
  invalid OnChances "posterior-refuses-what-is-invalid" OfPosterior $ \known ->
    let p = knownProfile known
        q = fromIntegral (profileOrder p) :: Int
        uniform n = replicate n (1 / fromIntegral n :: Double)
        lists =
          [uniform (q + 1), replicate q 0, 2 : -1 : replicate (q - 2) 0, map (* 1.002) (uneven p)]
            ++ [map (* 0.998) (uneven p), map (* 2) (uneven p), []]
            ++ [uniform (q - 1) | q > 1]
     in [asked [[Probably chances]] | chances <- lists]
          ++ [asked [[Unfelt, Probably chances], [Certainly 0, Unfelt]] | chances <- lists]
          ++ [ asked [[Certainly code]]
               | code <-
                   naturalsBelow 3 >>= \i ->
                     [profileOrder p + i :: Natural]
             ]
          ++ [rawWith (Posterior [[Unfelt]]) "patch" (toJSON [[[toJSON True, toJSON (0 :: Int)]]])]
          ++ illFormedPatches (Posterior [[Certainly 1, Unfelt], [Certainly 0, Certainly 1]]) known
