{-# LANGUAGE OverloadedStrings #-}

-- | Two roads to every answer: the definition of the conformance suite, and the library, which
-- shares none of its code. All that is cheap to exhaust is asked of both, and much that is drawn.
module Test.Conformance.Definition (spec) where

import Control.Monad (filterM)
import Control.Monad.Trans.Except (runExceptT)
import Data.Aeson (decode)
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (for_)
import Data.List (sort, tails)
import Data.Maybe (mapMaybe)
import Numeric.Natural (Natural)
import PraTactile.Array (Position (Position), Shape (..), Surface (..), area, naturalsBelow)
import PraTactile.Conformance.Definition
import PraTactile.Conformance.Implementation (Implementation (..), Session, answerTo)
import PraTactile.Conformance.Library (library)
import PraTactile.Conformance.Profiles
import PraTactile.Conformance.Question
import PraTactile.Profile
import Test.Hspec
import Test.QuickCheck (Gen, chooseInt, elements, frequency, shuffle, vectorOf)
import Test.QuickCheck.Gen (unGen)
import Test.QuickCheck.Random (mkQCGen)

spec :: Spec
spec = describe "the definition and the library agree" $ do
  for_ defaultProfiles $ \(name, profile) ->
    it name (disagreements profile `shouldReturn` [])
  for_ ["gf2-3x5", "gf3-2x13", "gf9-5x16"] $ \name ->
    it (name ++ ", folded either way on every surface") $
      traverse disagreements (variants name) `shouldReturn` map (const []) (variants name)
  it "the distance is the least of all pairs" $
    for_ ["paper", "gf2-3x5-row-major", "gf3-2x13", "gf9-5x16"] $ \name ->
      for_ (underName name) $ \k ->
        for_ [["##", "##"], ["###"], ["#.#", ".#."], ["##", "##", "##"], ["#", "#", "#"]] $ \mask ->
          expected k (Distance mask) `shouldBe` Right (leastOfPairs k mask)
  it "the probabilities of a patch as large as the array are numbers that add up to 1" $
    for_ (underName "paper") $ \k -> do
      -- The products of 255 of these, in 64ths, are beyond all doubles.
      let felt r c =
            Probably
              [ if Right code == expected k (Cell r c) then 61 / 64 else 1 / 64
                | code <- [0 .. 3]
              ]
          array = [[felt r c | c <- [0 .. 16]] | r <- [0 .. 14]]
      case expected k (Posterior array) of
        Left refusal -> expectationFailure (show refusal)
        Right chances -> do
          abs (sum (map snd chances) - 1) `shouldSatisfy` (< 1e-12)
          [p | (Position 0 0, p) <- chances] `shouldSatisfy` all (> 0.999999)
          length [() | (Position 0 0, _) <- chances] `shouldBe` 1
  it "an array of a polynomial of degree 1, whose windows are single cells" $ do
    -- x + 3 has the root 2, of which the powers modulo 5 are 1, 2, 4, 3.
    let powers =
          canonicalProfile
            { profileOrder = 5,
              profileModulus = [0, 1],
              profilePolynomial = [3, 1],
              profileState = [1],
              profileShape = Shape 1 4,
              profileWindow = Shape 1 1
            }
    fmap (\k -> traverse (expected k . Cell 0) [0 .. 3]) (known powers)
      `shouldBe` Right (Right [1, 2, 4, 3])
    disagreements powers `shouldReturn` []
  it "which profiles are possible" (openedOtherwise `shouldReturn` [])

underName :: String -> [Known]
underName name =
  [k | (given, profile) <- defaultProfiles, given == name, Right k <- [known profile]]

-- | In how many cells two windows on the folding's own surface differ, of all pairs the least.
leastOfPairs :: Known -> [String] -> Natural
leastOfPairs k mask =
  minimum
    [ fromIntegral (length (filter id (zipWith (/=) a b)))
      | a : others <- tails (map window places),
        b <- others
    ]
  where
    Shape n1 n2 = profileShape (knownProfile k)
    places = [(r, c) | r <- naturalsBelow n1, c <- naturalsBelow n2]
    window (r, c) =
      [ expected k (Cell (r + i) (c + j))
        | (i, line) <- zip [0 ..] mask,
          (j, '#') <- zip [0 ..] line
      ]

-- | A default profile with each folding on each surface.
variants :: String -> [Profile]
variants name =
  [ profile {profileFolding = folding, profileSurface = surface}
    | (given, profile) <- defaultProfiles,
      given == name,
      folding <- [minBound .. maxBound],
      surface <- [Torus, TwistedTorus, Sheet]
  ]

-- | The profiles that the library opens and the definition refuses, or the other way round.
openedOtherwise :: IO [Profile]
openedOtherwise = filterM (fmap not . alike) oddProfiles
  where
    alike profile = do
      opened <- runExceptT (() <$ open library profile)
      pure $ case (opened, known profile) of
        (Right (), Right _) -> True
        (Left (Refusal why), Left NoArray) -> why == "impossible-profile"
        _ -> False

-- | The paper's profile with one convention or two changed, to possible ones and others.
oddProfiles :: [Profile]
oddProfiles =
  concat
    [ [paper {profileOrder = q} | q <- [0, 1, 2, 3, 5, 6, 12, 257, 512]],
      [ paper {profileModulus = modulus}
        | modulus <- words' "1,1,1 1,0,1 1,1,2 3,1,1 1,1,1,0 1,1,0,1 1,1 1 0,0,1 1,0,0 1,1,0"
      ],
      [paper {profileModulus = []}, paper {profilePolynomial = []}, paper {profileState = []}],
      [ paper {profilePolynomial = h, profileReading = reading}
        | h <-
            words'
              "3,2,1,0,1 0,2,1,0,1 3,2,1,0,2 1,0,0,0,1 1,1,1,1,1 3,2,1,0,4 1,1 1 3,2,1,0,1,1 \
              \1,2,3,2,1 2,1,0,0,1 2,0,1,1,1 3,0,1,1,1",
          reading <- [minBound .. maxBound]
      ],
      [ paper {profileState = state}
        | state <- words' "0,0,0,0 0,0,1 0,0,0,0,1 0,0,0,4 3,3,3,3 0,0,0,0,0"
      ],
      [ paper {profileShape = shape, profileFolding = folding, profileSurface = surface}
        | (n1, n2) <- [(0, 0), (15, 16), (17, 15), (5, 51), (3, 85), (85, 3), (255, 1), (0, 255)],
          let shape = Shape n1 n2,
          folding <- [minBound .. maxBound],
          surface <- [Torus, Sheet]
      ],
      [ paper {profileWindow = window, profileSurface = surface}
        | window <- [Shape 0 2, Shape 2 0, Shape 65 64, Shape 16 1, Shape 1 18, Shape 1 1],
          surface <- [Torus, TwistedTorus, Sheet]
      ],
      [ (snd (head' gf9)) {profileModulus = modulus}
        | modulus <- words' "2,2,1 1,0,1 2,1,1 0,0,1 1,1,1 2,0,1"
      ]
    ]
  where
    paper = canonicalProfile
    gf9 = filter ((== "gf9-80x1") . fst) defaultProfiles
    words' = map (map read . words . map (\c -> if c == ',' then ' ' else c)) . words
    head' = foldr const ("", paper)

-- | What the library answers otherwise than the definition, with both answers.
disagreements :: Profile -> IO [String]
disagreements profile = case known profile of
  Left refusal -> pure ["the definition refuses the profile: " ++ show refusal]
  Right k ->
    runExceptT (open library profile) >>= \opened -> case opened of
      Left refusal -> pure ["the library refuses the profile: " ++ show refusal]
      Right session -> map shown <$> filterM (fmap not . agreed session k) (askedUnder k)
  where
    shown (SomeQuestion question) = show question

-- | Whether both answer alike, or refuse for the same reason.
agreed :: Session -> Known -> SomeQuestion -> IO Bool
agreed session k (SomeQuestion question) = do
  came <- runExceptT (answerTo session question)
  pure $ case (expected k question, came) of
    (Right wanted, Right given) -> agrees k question wanted given
    (Left wanted, Left given) -> wanted == given
    _ -> False

-- | All that is asked under a profile.
askedUnder :: Known -> [SomeQuestion]
askedUnder k =
  concat
    [ fieldQuestions profile,
      polynomialQuestions profile,
      few (arrayQuestions profile),
      few (windowQuestions k),
      illFormed profile,
      concatMap drawnQuestions [1 .. draws]
    ]
  where
    profile = knownProfile k
    cells = area (profileShape profile)
    draws
      | cells > 8192 = 2
      | cells > 1024 = 20
      | otherwise = 150
    -- Where there are very many cells, some of them.
    few questions
      | cells > 8192 = [one | (i, one) <- zip [0 :: Int ..] questions, i `mod` 997 == 0]
      | otherwise = questions
    drawnQuestions seed = unGen (drawn k) (mkQCGen seed) 30

-- | All elements, and codes that are none.
fieldQuestions :: Profile -> [SomeQuestion]
fieldQuestions profile =
  concat
    [ [SomeQuestion (operation a b) | operation <- [Add, Multiply], a <- codes, b <- codes],
      [SomeQuestion (operation a) | operation <- [Negate, Inverse, Trace], a <- codes],
      [SomeQuestion (Logarithm a) | a <- codes],
      [SomeQuestion (Power a i) | a <- codes, i <- [-20 .. 20] ++ [-huge, huge]]
    ]
  where
    codes = [0 .. profileOrder profile + 1]
    huge = 10 ^ (20 :: Int)

-- | All polynomials of low degree, monic or not, with zeros at their ends and without.
polynomialQuestions :: Profile -> [SomeQuestion]
polynomialQuestions profile =
  [ SomeQuestion (Primitive codes)
    | n <- [0 .. longest],
      codes <- traverse (const [0 .. q - 1]) [1 .. n]
  ]
    ++ [SomeQuestion (Primitive h) | h <- [[q, 1], profilePolynomial profile, [1, 0, 1, 1, 0]]]
    ++ [SomeQuestion (FirstPrimitive n) | n <- [0 .. 4] ++ [high]]
    -- Of a degree from which on orders are not walked.
    ++ [ SomeQuestion (Primitive (c : zeros (i - 1) ++ b : zeros (degree - i - 1) ++ [1]))
         | i <- [1 .. degree - 1],
           (c, b) <- [(1, 1), (q - 1, 1), (1, q - 1), (q - 1, q - 1)]
       ]
  where
    q = profileOrder profile
    zeros n = replicate n 0
    high = fromIntegral degree
    degree = length (takeWhile (<= 2 ^ (16 :: Int)) (iterate (* q) 1))
    longest = length (takeWhile (<= 1000) (iterate (* q) 1)) - 1

-- | All terms and cells twice over, and some far away.
arrayQuestions :: Profile -> [SomeQuestion]
arrayQuestions profile =
  concat
    [ [SomeQuestion (Term i) | i <- [0 .. 2 * n1 * n2] ++ far],
      [SomeQuestion (Terms from count) | from <- [0, 1, n1 * n2 - 2] ++ far, count <- [0, 1, 7]],
      [SomeQuestion (Cell r c) | r <- [0 .. 2 * n1] ++ far, c <- [0 .. 2 * n2] ++ far]
    ]
  where
    Shape n1 n2 = profileShape profile
    far = [2 ^ (53 :: Int) - 1, 2 ^ (64 :: Int), 10 ^ (100 :: Int) + 7]

-- | The window of every position, packed, unpacked and located, cells not on the sheet being not
-- observed; packed numbers that are none; masks of at most three rows and columns.
windowQuestions :: Known -> [SomeQuestion]
windowQuestions k =
  concat
    [ [SomeQuestion (Locate window) | window <- everywhere],
      [SomeQuestion (Pack (concatMap (concatMap (foldMap pure)) window)) | window <- everywhere],
      [SomeQuestion (Unpack n) | n <- [0 .. 20] ++ [span' - 1, span', span' + 1, 10 ^ (30 :: Int)]],
      [SomeQuestion (Pack codes) | codes <- [[], [0], replicate 20 1, replicate 21 1, [q]]],
      [ SomeQuestion (operation mask)
        | operation <- [Distance],
          mask <- masks
      ],
      [SomeQuestion (Prove mask) | mask <- masks]
    ]
  where
    profile = knownProfile k
    q = profileOrder profile
    Shape high wide = profileWindow profile
    Shape n1 n2 = profileShape profile
    span' = q ^ (high * wide)
    everywhere = [patchAt k (r, c) (high, wide) | r <- naturalsBelow n1, c <- naturalsBelow n2]
    masks = someMasks ++ [apartMask, apartMask ++ [".........."], replicate 16 "#"]
    someMasks = if n1 * n2 > 300 then take 60 drawings else drawings
    drawings =
      [ drawing
        | (i, j) <- [(1, 1), (1, 2), (2, 1), (2, 2), (1, 3), (3, 1), (2, 3), (3, 2)],
          drawing <- traverse (const (traverse (const "#.") [1 .. j :: Int])) [1 .. i :: Int]
      ]

-- | Patches, probabilities and masks that are none, and inputs of the wrong type.
illFormed :: Profile -> [SomeQuestion]
illFormed profile =
  concat
    [ concat
        [ [SomeQuestion (Locate patch), SomeQuestion (Nearest Nothing patch)]
          | patch <-
              [[], [[]], [[], []], [[Just 0], []], [[Nothing], [Just 0, Nothing]], [[Just q]]]
        ],
      [ SomeQuestion (Posterior patch)
        | patch <- [[], [[]], [[Unfelt], []], [[Certainly q]], [[Unfelt, Unfelt], [Unfelt, Unfelt]]]
      ],
      [SomeQuestion (Posterior [[Probably numbers]]) | numbers <- chances],
      [ SomeQuestion (operation mask)
        | operation <- [Distance],
          mask <- masks
      ],
      [SomeQuestion (Prove mask) | mask <- masks],
      [SomeQuestion (Raw operation input) | operation <- codeOperations, input <- inputs]
    ]
  where
    q = profileOrder profile
    others = replicate (fromIntegral q - 2) 0
    chances =
      [ [],
        replicate (fromIntegral q + 1) 0,
        0.5 : 0.4 : others,
        0.5 : 0.5005 : others,
        1.5 : -0.5 : others,
        0.4996 : 0.5 : others,
        0 : 0 : others
      ]
    masks = map (splitAt' '/') ["", "/#", "#/", "##/#", "#x", "..", "#.", ".#", "#/."]
    splitAt' c text = case break (== c) text of
      (row, _ : more) -> row : splitAt' c more
      (row, []) -> [row]
    inputs = mapMaybe decode inputTexts

-- | Inputs of which some are of the right form for some operations.
inputTexts :: [Lazy.ByteString]
inputTexts =
  [ "{}",
    "null",
    "[1, 1]",
    "{\"a\": 1, \"b\": true}",
    "{\"a\": 1, \"b\": 1.0}",
    "{\"a\": 1, \"b\": -1}",
    "{\"a\": \"1\", \"b\": 0, \"c\": null}",
    "{\"a\": 1, \"exponent\": \"-99999999999999999999\"}",
    "{\"a\": 1, \"exponent\": 0.5}",
    "{\"polynomial\": [1, 1.0]}",
    "{\"polynomial\": 1}",
    "{\"polynomial\": [1, \"1\"]}",
    "{\"degree\": -1}",
    "{\"degree\": 0}",
    "{\"index\": \"9007199254740993\"}",
    "{\"index\": 9007199254740993}",
    "{\"from\": 3, \"length\": -1}",
    "{\"from\": 3, \"length\": 0}",
    "{\"row\": 1, \"column\": null}",
    "{\"row\": \"99999999999999999999\", \"column\": 1}",
    "{\"cells\": [0, null]}",
    "{\"packed\": \"1x\"}",
    "{\"packed\": \"1\"}",
    "{\"patch\": [[0, null], [null, 1]]}",
    "{\"patch\": [[0, 1.0]], \"radius\": null}",
    "{\"patch\": [[0, 1]], \"radius\": -1}",
    "{\"patch\": [[0, 1]], \"radius\": 1}",
    "{\"patch\": [0, 1], \"radius\": 1}",
    "{\"patch\": [[[\"1\"]]]}",
    "{\"patch\": [[[1e400]]]}",
    "{\"mask\": [\"##\"]}",
    "{\"mask\": \"##/.#\"}"
  ]

-- | What the array has in a rectangle at a position, on the profile's own surface.
patchAt :: Known -> (Natural, Natural) -> (Natural, Natural) -> Patch
patchAt k (r, c) (high, wide) =
  [ [ either (const Nothing) Just (expected k (Cell (r + i) (c + j)))
      | j <- naturalsBelow wide
    ]
    | i <- naturalsBelow high
  ]

-- | Questions of one patch with cells missing and wrong.
drawn :: Known -> Gen [SomeQuestion]
drawn k = do
  place <- (,) <$> below (2 * n1) <*> below (2 * n2)
  shape <- (,) <$> sides high <*> sides wide
  missing <- elements [0, 0, 10, 30, 80]
  wrong <- elements [0, 0, 5, 20]
  zeros <- frequency [(6, pure False), (1, pure True)]
  patch <- traverse (traverse (damaged missing wrong zeros)) (patchAt k place shape)
  chances <- traverse (traverse chance) patch
  radius <- elements [0 .. 4]
  pure
    [ SomeQuestion (Locate patch),
      SomeQuestion (Nearest Nothing patch),
      SomeQuestion (Nearest (Just radius) patch),
      SomeQuestion (Posterior chances)
    ]
  where
    profile = knownProfile k
    q = profileOrder profile
    Shape high wide = profileWindow profile
    Shape n1 n2 = profileShape profile
    below n = fromIntegral <$> chooseInt (0, fromIntegral n - 1)
    sides n = elements (filter (> 0) [n, n, n + 1, n + 1, n + 2, if n > 1 then n - 1 else n])
    percent n a b = frequency [(n, a), (100 - n, b)]
    damaged missing wrong zeros cell' =
      percent missing (pure Nothing) $
        percent wrong (Just <$> below q) (pure (if zeros then Just 0 else cell'))
    chance cell' = case cell' of
      Nothing -> pure Unfelt
      Just a ->
        frequency [(1, pure (Certainly a)), (2, Probably <$> likely a), (2, Probably <$> any')]
    likely a = do
      rest <- elements [0, 0.01, 0.3]
      let others = rest / fromIntegral (q - 1)
      pure [if b == a then 1 - rest else others | b <- [0 .. q - 1]]
    any' = do
      cuts <- sort <$> vectorOf (fromIntegral q - 1) (chooseInt (0, 64))
      shuffle (map ((/ 64) . fromIntegral) (zipWith (-) (cuts ++ [64]) (0 : cuts)))
