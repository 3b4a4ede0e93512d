-- | Tests the definition of the conformance suite where no law compares it with the library:
-- against slower definitions, under combinations of folding and surface that no profile of the
-- suite has, and on which profiles are possible.
module Test.Conformance.Definition (spec) where

import Control.Monad (filterM)
import Control.Monad.Trans.Except (runExceptT)
import Data.Foldable (for_)
import Data.List (tails)
import Numeric.Natural (Natural)
import PraTactile.Array (Position (Position), Shape (..), Surface (..), naturalsBelow)
import PraTactile.Conformance.Definition
import PraTactile.Conformance.Implementation (Implementation (..))
import PraTactile.Conformance.Library (library)
import PraTactile.Conformance.Profiles
import PraTactile.Conformance.Question
import PraTactile.Profile
import Test.Conformance.Laws (lawsFailing)
import Test.Effort (byEffort)
import Test.Hspec

spec :: Spec
spec = do
  for_ (byEffort [] ["gf2-3x5"] ++ ["gf3-2x13", "gf9-5x16"]) $ \name ->
    it ("the library holds all laws under " ++ name ++ ", with every folding on every surface") $
      lawsFailing [(name, p) | p <- variants name] library `shouldReturn` []
  it "the distance is the least distance between any two windows" $
    for_ ["paper", "gf2-3x5-row-major", "gf3-2x13", "gf9-5x16"] $ \name ->
      for_ (underName name) $ \k ->
        for_ [["##", "##"], ["###"], ["#.#", ".#."], ["##", "##", "##"], ["#", "#", "#"]] $ \mask ->
          expected k (Distance :? mask) `shouldBe` Right (leastOfPairs k mask)
  it "the probabilities of a patch as large as the array are numbers that add up to 1" $
    for_ (underName "paper") $ \k -> do
      -- A product of 255 of these, in 64ths, exceeds the range of a double.
      let felt r c =
            Probably
              [ if Right code == expected k (Cell :? Position r c) then 61 / 64 else 1 / 64
                | code <- [0 .. 3]
              ]
          array = [[felt r c | c <- [0 .. 16]] | r <- [0 .. 14]]
      case expected k (Posterior :? array) of
        Left refusal -> expectationFailure (show refusal)
        Right chances -> do
          abs (sum (map snd chances) - 1) `shouldSatisfy` (< 1e-12)
          [p | (Position 0 0, p) <- chances] `shouldSatisfy` all (> 0.999999)
          length [() | (Position 0 0, _) <- chances] `shouldBe` 1
  it "an array of a polynomial of degree 1 has windows of a single cell" $ do
    -- x + 3 has the root 2, whose powers modulo 5 are 1, 2, 4, 3.
    let powers =
          canonicalProfile
            { profileOrder = 5,
              profileModulus = [0, 1],
              profilePolynomial = [3, 1],
              profileState = [1],
              profileShape = Shape 1 4,
              profileWindow = Shape 1 1
            }
    fmap (\k -> traverse (expected k . (Cell :?) . Position 0) [0 .. 3]) (known powers)
      `shouldBe` Right (Right [1, 2, 4, 3])
    lawsFailing [("powers", powers)] library `shouldReturn` []
  it "the library and the definition open the same profiles" (openedOtherwise `shouldReturn` [])

underName :: String -> [ProfileFacts]
underName name =
  [k | (given, profile) <- defaultProfiles, given == name, Right k <- [known profile]]

-- | The least number of cells in which two windows differ on the folding's own surface.
leastOfPairs :: ProfileFacts -> [String] -> Natural
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
      [ expected k (Cell :? Position (r + i) (c + j))
        | (i, line) <- zip [0 ..] mask,
          (j, '#') <- zip [0 ..] line
      ]

-- | A default profile with each folding on each surface. A quick run takes each folding and each
-- surface, but not every pair.
variants :: String -> [Profile]
variants name =
  [ profile {profileFolding = folding, profileSurface = surface}
    | (given, profile) <- defaultProfiles,
      given == name,
      (folding, surface) <- byEffort (zip (cycle foldings) surfaces) ((,) <$> foldings <*> surfaces)
  ]
  where
    foldings = [minBound .. maxBound]
    surfaces = [Torus, TwistedTorus, Sheet]

-- | The profiles that exactly one of the library and the definition opens.
openedOtherwise :: IO [Profile]
openedOtherwise = filterM (fmap not . alike) oddProfiles
  where
    alike profile = do
      opened <- runExceptT (() <$ open library profile)
      pure $ case (opened, known profile) of
        (Right (), Right _) -> True
        (Left (Refusal reason), Left NoArray) -> reason == "impossible-profile"
        _ -> False

-- | The paper's profile with one or two conventions changed; some of the results are impossible.
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
