{-# LANGUAGE GADTs #-}
{-# LANGUAGE RankNTypes #-}

-- | What impostors say of probabilities.
module Test.Conformance.Sentences.Chances (spec, names) where

import Data.List (genericLength)
import PraTactile.Array (Position (..))
import PraTactile.Conformance
import PraTactile.Conformance.Definition
import PraTactile.Conformance.Question
import PraTactile.Profile
import Test.Conformance.Sentences.Patches
import Test.Conformance.Sentences.Said
import Test.Hspec
import Test.QuickCheck (chooseInt, elements, frequency, vectorOf)
import Test.QuickCheck.Gen (unGen)
import Test.QuickCheck.Random (mkQCGen)

spec :: Spec
spec = describe "of probabilities" $ sentencesHold smallArrays chanceQuestions ofChances

-- | The impostors of which something is said here.
names :: [String]
names = map fst ofChances

-- | Probabilities of all kinds: in favour of what is there, of any symbols, sums that are not quite
-- 1, rows of which nothing is known, cells that contradict; and what is none.
chanceQuestions :: Known -> [SomeQuestion]
chanceQuestions about =
  map (SomeQuestion . Posterior) (drawn ++ special)
    ++ [SomeQuestion (Locate [[Just 1, Nothing]])]
    ++ [SomeQuestion (Nearest Nothing [[Just 1, Just 0]])]
  where
    q = profileOrder (knownProfile about)
    drawn = unGen (vectorOf 24 (drawnPatch about >>= traverse (traverse chance))) (mkQCGen 11) 30
    chance cell' = case cell' of
      Nothing -> pure Unfelt
      Just a ->
        frequency [(1, pure (Certainly a)), (3, Probably <$> likely a), (2, Probably <$> any')]
    likely a = do
      rest <- elements [0, 0.02, 0.25]
      total <- elements [1, 1, 1.0009, 0.9992]
      pure [total * (if b == a then 1 - rest else rest / fromIntegral (q - 1)) | b <- [0 .. q - 1]]
    any' = do
      weights <- vectorOf (fromIntegral q) (chooseInt (0, 9))
      let total = max 1 (sum weights)
          first = if sum weights == 0 then 1 else 0
      pure (zipWith (+) (first : repeat 0) [fromIntegral x / fromIntegral total | x <- weights])
    others = replicate (fromIntegral q - 2) 0
    special =
      [ [],
        [[]],
        [[Unfelt], []],
        [[Certainly q]],
        [[Probably (1 : 0 : 0 : others)]],
        [[Probably (0.5 : 0.4 : others)]],
        [[Probably (1.25 : -0.25 : others)]],
        [[Probably (0 : 0 : others)]],
        [[Probably (3 : 1 : others), Certainly 1]],
        [[Unfelt, Unfelt], [Certainly 1, Unfelt]],
        [[Certainly 0, Certainly 0], [Certainly 0, Certainly 0], [Certainly 0, Certainly 0]],
        replicate 3 (replicate 5 (Probably (0.5 : 0.5 : others)))
      ]

-- | How probabilities are taken, what becomes of those of a place's cells, and how the places are
-- told.
data Weighing = Weighing
  { believed :: [Double] -> [Double],
    joined :: [Double] -> Double,
    listed :: [(Position, Double)] -> [(Position, Double)]
  }

rightlyWeighed :: Weighing
rightlyWeighed =
  Weighing
    { believed = \numbers -> map (/ sum numbers) numbers,
      joined = product,
      listed = \places -> [(at, x / sum (map snd places)) | (at, x) <- places]
    }

-- | By the rule of Bayes.
weighed :: String -> Weighing -> Sentence
weighed name how =
  ( name,
    \about ->
      let surface = surfaceOf about
       in Says $ \question -> case question of
            Posterior chances
              -- What is no probabilities is refused.
              | right about (Posterior chances) == invalid -> invalid
              | otherwise -> posteriorBy about surface how chances
            _ -> right about question
  )

posteriorBy :: Known -> Surface' -> Weighing -> Chances -> Either Refusal [(Position, Double)]
posteriorBy about surface how chances
  | null possible = refused "contradiction"
  | otherwise = Right (listed how possible)
  where
    p = knownProfile about
    known' =
      [ ((i, j), believed how numbers)
        | (i, line) <- zip [0 ..] chances,
          (j, chance) <- zip [0 ..] line,
          Just numbers <- [numbersOf chance]
      ]
    numbersOf chance = case chance of
      Unfelt -> Nothing
      Certainly a -> Just [if a == b then 1 else 0 | b <- [0 .. profileOrder p - 1]]
      Probably numbers -> Just numbers
    possible =
      [ (Position (fromInteger r) (fromInteger c), likelihood)
        | (r, c) <- everywhere p,
          Just there <- [traverse (\((i, j), _) -> surface (r + i, c + j)) known'],
          let likelihood =
                joined how [numbers !! fromIntegral a | ((_, numbers), a) <- zip known' there],
          likelihood > 0
      ]

ofChances :: [Sentence]
ofChances =
  [ weighed "hears-the-likeliest-symbol" $
      rightlyWeighed {believed = \xs -> [if x == maximum xs then 1 else 0 | x <- xs]},
    weighed "multiplies-numbers-as-they-come" rightlyWeighed {believed = id, listed = id},
    weighed "adds-probabilities" $
      rightlyWeighed {joined = \xs -> if null xs then 1 else sum xs},
    weighed "averages-the-cells" $
      rightlyWeighed
        { joined = \xs -> if null xs then 1 else product xs ** (1 / genericLength xs)
        },
    weighed "tells-likelihoods" rightlyWeighed {listed = id},
    weighed "tells-the-likeliest-place" $
      rightlyWeighed
        { listed = \places ->
            take 1 (reverse [one | one <- listed rightlyWeighed places, isMost places one])
        },
    weighed "divides-by-the-largest" $
      rightlyWeighed
        { listed = \places -> [(at, x / maximum (map snd places)) | (at, x) <- places]
        },
    weighed "smooths" $
      rightlyWeighed
        { believed = \xs -> [(x + 0.001) / sum (map (+ 0.001) xs) | x <- xs]
        },
    instead "takes-the-unknown-for-zeros" $ \_ -> map (map zero),
    instead "takes-any-numbers-for-probabilities" $ \_ -> map (map divided),
    instead "takes-the-unknown-for-any" $ \_ chances ->
      let known' = filter (any (/= Unfelt)) chances in if null known' then chances else known'
  ]
  where
    -- Of several equally likely ones the last.
    isMost places (at, _) = lookup at places == Just (maximum (map snd places))
    zero chance = if chance == Unfelt then Certainly 0 else chance
    divided chance = case chance of
      Probably xs
        | sum (map (max 0) xs) > 0 -> Probably [max 0 x / sum (map (max 0) xs) | x <- xs]
      _ -> chance
    instead :: String -> (Known -> Chances -> Chances) -> Sentence
    instead name change = saying name $ \about question -> case question of
      Posterior chances -> right about (Posterior (change about chances))
      _ -> right about question
