{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The laws of locating from probabilities, by Bayes' rule.
module PraTactile.Conformance.Laws.Chances
  ( chanceLaws,
  )
where

import Control.Monad (replicateM)
import Data.Aeson (Value (Null), toJSON)
import Data.List (sort)
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..), Surface (..), area, naturalsBelow)
import PraTactile.Conformance.Definition (ProfileFacts, knownProfile)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Draw
import PraTactile.Conformance.Laws.Forms
import PraTactile.Conformance.Laws.Judge
import PraTactile.Conformance.Laws.Locate
import PraTactile.Conformance.Laws.Malformed
import PraTactile.Conformance.Laws.Order
import PraTactile.Conformance.Operations (smallerQuestions)
import PraTactile.Conformance.Question
import PraTactile.Profile (Profile (..))
import Test.QuickCheck

-- | The laws of the probabilities of positions.
chanceLaws :: [Law ProfileFacts]
chanceLaws =
  map ofFew $
    systematicLaws ++ drawnLaws
      ++ [orderLaw OnChances [SomeOp Locate, SomeOp Posterior]]
      ++ formLaws OnChances [SomeOp Posterior]
      ++ [invalidLaw]
  where
    -- The probabilities of very many positions do not fit into a line.
    ofFew one =
      one
        { lawCases = \known ->
            if isVast (knownProfile known)
              then Cases questionForm (Every []) (asDefined known)
              else lawCases one known
        }

bayes :: String -> String -> (ProfileFacts -> Domain SomeQuestion) -> Law ProfileFacts
bayes what sentence =
  defined
    OnChances
    what
    Posterior
    sentence
    "Bayes' theorem for independent cells and equally probable positions; the protocol, \
    \posterior"

asked :: Chances -> SomeQuestion
asked = SomeQuestion . (Posterior :?)

certain :: Patch -> Chances
certain = map (map (maybe Unfelt Certainly))

systematicLaws :: [Law ProfileFacts]
systematicLaws =
  [ bayes "certain-cells" "for certain symbols all positions that agree are equally likely" $
      \known -> Every (asked . certain <$> smallPatches 70 (knownProfile known)),
    bayes "certain-as-probabilities" "a code means probability 1 for it" $ \known ->
      Every
        [ asked [[Probably (sure (knownProfile known) code)]]
          | code <- elementsOf (knownProfile known)
        ],
    bayes "doubtful-cells" "patches with a cell in which two symbols are equally likely" $ \known ->
      Every
        [ asked [[Probably (halves (knownProfile known) a b), cell]]
          | a <- take 4 (elementsOf (knownProfile known)),
            b <- take 4 (elementsOf (knownProfile known)),
            a /= b,
            cell <- [Unfelt, Certainly 1]
        ],
    bayes "nothing-known" "if no cell is known, all positions are equally likely" $ \known ->
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
            | factor <- [1.0005, 0.9995, 1.0009, 0.9991, 1.00099, 0.99901]
          ],
    bayes "unlikely-cells" "unlikely positions are possible, however small the product is" $
      \known -> Every (asked <$> ofVast 2 (knownProfile known) (unlikely known)),
    bayes "many-cells" "positions whose probability is a product of a thousand factors" $ \known ->
      Every (asked <$> manyCells known)
  ]

-- | A certain window within a larger patch, whose other cells most probably have another symbol
-- than the array's.
unlikely :: ProfileFacts -> [Chances]
unlikely known =
  [ [ [ if i < h && j < w then Certainly code else Probably (scarcely share code)
        | (j, code) <- zip [0 ..] line
      ]
      | (i, line) <- zip [0 ..] (seenAt known (Shape high wide) place)
    ]
    | share <- [0.3, 1e-7, 1e-60, 5e-324],
      Shape high wide <- [Shape (h + 1) w, Shape h (w + 1), Shape (h + 3) (w + 3)],
      place <- take 2 (places p (Shape high wide)),
      area (Shape high wide) <= 128,
      area (profileShape p) <= 1024
  ]
  where
    p = knownProfile known
    Shape h w = profileWindow p
    scarcely share code =
      [ if c == code then share else if c == (code + 1) `mod` profileOrder p then 1 - share else 0
        | c <- elementsOf p
      ]

-- | A thousand cells of a small array. Each most probably has the array's symbol, but with
-- probability below 1/2 if there are more than two symbols.
manyCells :: ProfileFacts -> [Chances]
manyCells known =
  [ map (map (Probably . likely)) (seenAt known (Shape (side n1) (side n2)) (Position 0 0))
    | area (profileShape p) <= 128,
      profileOrder p <= 9
  ]
  where
    p = knownProfile known
    Shape n1 n2 = profileShape p
    side n = if profileSurface p == Sheet then min 32 n else 32
    others = profileOrder p - 1
    share = fromIntegral (32 `div` others) :: Double
    likely code =
      [ (if c == code then 64 - share * fromIntegral others else share) / 64
        | c <- elementsOf p
      ]

sure :: Profile -> Code -> [Double]
sure p code = [if c == code then 1 else 0 | c <- elementsOf p]

halves :: Profile -> Code -> Code -> [Double]
halves p a b = [if c == a || c == b then 0.5 else 0 | c <- elementsOf p]

-- | 1/2, 1/4, ..., with the last one twice.
uneven :: Profile -> [Double]
uneven p = take n (iterate (/ 2) 0.5) ++ [0.5 ^^ n]
  where
    n = fromIntegral (profileOrder p) - 1 :: Int

drawnLaws :: [Law ProfileFacts]
drawnLaws =
  [ bayes
      "bayes"
      "the probability of a position is the product of the probabilities of its symbols, \
      \divided by \
      \the sum over all positions"
      (\known -> Some (asked <$> genChances (knownProfile known)) smallerQuestions),
    bayes "contradictions" "a patch that fits no position is refused: contradiction" $ \known ->
      Some (asked . certain <$> genDamaged known (Damage 10 30)) smallerQuestions,
    bayes "likely-patches" "patches of the array, each cell a little doubtful" $ \known ->
      Some
        ( genDamaged known (Damage 20 5)
            >>= fmap asked
              . traverse
                (traverse (doubtful (knownProfile known)))
        )
        smallerQuestions
  ]

-- | Patches of probabilities in 64ths, which doubles hold exactly. Small patches sometimes have
-- other probabilities, some of them tiny.
genChances :: Profile -> Gen Chances
genChances p = do
  shape <- elements (shapesAround p)
  cell <-
    if area shape <= 6 && area (profileShape p) <= 1024
      then frequency [(2, pure chances), (1, pure uneven')]
      else pure chances
  of' shape (frequency [(1, pure Unfelt), (4, cell)])
  where
    of' (Shape h w) = replicateM (fromIntegral h) . replicateM (fromIntegral w)
    uneven' = do
      weights <- vectorOf (fromIntegral (profileOrder p)) weight
      let whole = sum weights
      pure (Probably (if whole > 0 then map (/ whole) weights else sure p 0))
    weight = frequency [(1, pure 0), (3, choose (0, 1)), (1, (10 **) <$> choose (-12, -3))]
    chances = do
      cuts <- vectorOf (fromIntegral (profileOrder p) - 1) (chooseInteger (0, 64))
      let ends = sort cuts
      Probably . map ((/ 64) . fromInteger) <$> shuffle (zipWith (-) (ends ++ [64]) (0 : ends))

-- | Mostly the true symbol; the remaining probability goes to another one.
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

invalidLaw :: Law ProfileFacts
invalidLaw =
  invalid OnChances "posterior-refuses-what-is-invalid" Posterior $ \known ->
    let p = knownProfile known
        q = fromIntegral (profileOrder p) :: Int
        certainly = map toJSON (drop 1 (sure p 0))
        uniform n = replicate n (1 / fromIntegral n :: Double)
        lists =
          [uniform (q + 1), replicate q 0, []]
            ++ [1 + less : -less : replicate (q - 2) 0 | less <- [1, 0.25, 0.0005, 1e-9]]
            ++ [map (* factor) (uneven p) | factor <- [1.0011, 0.9989, 1.002, 0.998, 0.5, 2]]
            ++ [uniform (q - 1) | q > 1]
     in [asked [[Probably chances]] | chances <- lists]
          ++ [asked [[Unfelt, Probably chances], [Certainly 0, Unfelt]] | chances <- lists]
          ++ [ asked [[Certainly code]]
               | code <-
                   naturalsBelow 3 >>= \i ->
                     [profileOrder p + i :: Natural]
             ]
          ++ [ rawWith (Posterior :? [[Unfelt]]) "patch" (toJSON [[wrong : certainly]])
               | wrong <- [toJSON True, toJSON ("1" :: String), Null, toJSON [1 :: Int]]
             ]
          ++ illFormedPatches
            (Posterior :? [[Certainly 1, Unfelt], [Certainly 0, Certainly 1]])
            known
