{-# LANGUAGE GADTs #-}
{-# LANGUAGE RankNTypes #-}

-- | What laws ask: those that draw draw what matters about as often as is said here, and those that
-- exhaust a domain ask as many different questions as it has.
module Test.Conformance.Laws.Coverage (spec) where

import Data.Aeson (encode)
import Data.Foldable (for_)
import qualified Data.Set as Set
import Numeric.Natural (Natural)
import PraTactile.Array (area)
import PraTactile.Conformance
import PraTactile.Conformance.Definition (expected)
import PraTactile.Conformance.Law (Cases (..), Domain (..))
import PraTactile.Format.Json.Codec (writeValue)
import PraTactile.Format.Profile (profileValue)
import PraTactile.Profile
import Test.Conformance.Laws.Trials
import Test.Hspec
import Test.QuickCheck

spec :: Spec
spec = do
  describe "drawn" $
    for_ drawings $ \(name, wanted) -> it name $ do
      (paper, about) <- underPaper
      [cases] <- pure [lawCases law about | law <- laws, lawId law == name]
      succeeds (covering paper about cases wanted)
  it "drawn scenes of touch tell their truth in a tenth of the cases, mostly in far more" $
    for_ lawsWithoutProfile $ \law -> case lawCases law () of
      Cases _ (Every _) _ -> pure ()
      Cases form (Some gen _) trial ->
        succeeds . checkCoverage . forAllShow gen (show . encode . writeValue form) $ \one ->
          cover 10 (not (null (snd (askedBy (const unanswered) (trial one))))) "" True
  it "all of a domain, each question once" $ do
    (paper, about) <- underPaper
    for_ (sizes paper) $ \(name, size) -> do
      [cases] <- pure [lawCases law about | law <- laws, lawId law == name]
      (name, different cases) `shouldBe` (name, Just size)
  it "of each default profile, that it is opened" $ do
    [cases] <- pure [lawCases law (map snd defaultProfiles) | law <- take 1 openingLaws]
    let asked = case cases of
          Cases form (Every every) _ -> map (writeValue form) every
          _ -> []
    filter (`notElem` asked) (map (profileValue . snd) defaultProfiles) `shouldBe` []
  where
    underPaper = do
      Just paper <- pure (lookup "paper" defaultProfiles)
      Right about <- pure (known paper)
      pure (paper, about)
    succeeds :: Testable p => p -> Expectation
    succeeds law = quickCheckWithResult stdArgs {chatty = False} law >>= (`shouldSatisfy` isSuccess)
    unanswered = Left (Refusal "none")

-- | How many different cases there are, of a law that exhausts them.
different :: Cases -> Maybe Int
different (Cases form domain _) = case domain of
  Every cases
    | length cases == Set.size (Set.fromList (written cases)) -> Just (length cases)
    | otherwise -> Nothing
  Some _ _ -> Nothing
  where
    written = map (encode . writeValue form)

-- | How many elements, indices, cells and contents of a window there are.
sizes :: Profile -> [(String, Int)]
sizes p =
  [("field/" ++ name ++ "-as-defined", q) | name <- ["negation", "inverse", "logarithm", "trace"]]
    ++ [("field/" ++ name ++ "-as-defined", q * q) | name <- ["addition", "multiplication"]]
    ++ [("field/power-as-defined", q * (2 * q + 1))]
    ++ [("field/addition-associates", q ^ three), ("field/multiplication-distributes", q ^ three)]
    ++ [ ("sequence/term-as-defined", period),
         ("array/cell-as-defined", period),
         ("window/pack-as-defined", contents),
         ("window/unpack-as-defined", contents),
         ("locate/every-window", period),
         -- Shapes of at most 700 patches of five cells to choose from: one to four in a line, or
         -- two by two.
         ("locate/small-patches", 5 + 2 * 25 + 2 * 125 + 3 * 625)
       ]
  where
    q = fromIntegral (profileOrder p) :: Int
    period = q ^ (length (profilePolynomial p) - 1) - 1
    contents = q ^ (fromIntegral (area (profileWindow p)) :: Int)
    three = 3 :: Int

-- | Something that a question may be, or its right answer, and of how many per cent it is at least.
data Label = Label Double String (forall a. Profile -> Question a -> Either Refusal a -> Bool)

-- | Every label as often as it says, of the last question of each case.
covering :: Profile -> Known -> Cases -> [Label] -> Property
covering p about (Cases form domain trial) wanted = case domain of
  Every _ -> counterexample "nothing is drawn" False
  Some gen _ ->
    checkCoverage . forAllShow gen (show . encode . writeValue form) $ \one ->
      let questions = snd (askedBy (expected about) (trial one))
       in foldr (labelled questions) (property (not (null questions))) wanted
  where
    labelled questions (Label percent name holds) =
      let right = or [holds p one (expected about one) | SomeQuestion one <- take 1 questions]
       in cover percent right name

-- | What is drawn, by the laws' ids.
drawings :: [(String, [Label])]
drawings =
  [ ( "sequence/term-of-any-index",
      [ Label 20 "about the end of a period" (\p one _ -> near (periodOf p) 20 (indexOf one)),
        Label 5 "beyond 2^64" (\_ one _ -> indexOf one > 2 ^ (64 :: Int)),
        -- One of thirteen, each of which a third of half of all are about.
        Label 0.5 "about 2^53" (\_ one _ -> near (2 ^ (53 :: Int)) 300 (indexOf one)),
        Label 8 "about the end of a word" $ \_ one _ ->
          let words' = [15, 16, 31, 32, 53, 63, 64, 127, 128, 256] :: [Int]
           in or [near (2 ^ bits) 300 (indexOf one) | bits <- words']
      ]
    ),
    ( "array/cell-far-beyond-the-edges",
      [ Label 5 "a row beyond 2^64" (\_ one _ -> rowOf one > 2 ^ (64 :: Int)),
        Label 5 "a row below 10^9" (\_ one _ -> rowOf one < 10 ^ (9 :: Int))
      ]
    ),
    ( "field/power-of-any-exponent",
      [ Label 25 "a positive exponent" (\_ one _ -> exponentOf one > 0),
        Label 25 "a negative exponent" (\_ one _ -> exponentOf one < 0),
        Label 10 "beyond 2^64" (\_ one _ -> abs (exponentOf one) > 2 ^ (64 :: Int)),
        Label 5 "division by zero" (\_ _ came -> reasonIs "division-by-zero" came)
      ]
    ),
    ( "polynomial/primitive-of-drawn-ones",
      [ Label 5 "a primitive one" (\_ one came -> primitiveIs True one came),
        Label 30 "one that is not" (\_ one came -> primitiveIs False one came)
      ]
    ),
    ("proof/prove-drawn-masks", ofMasks),
    ("proof/distance-drawn-masks", ofMasks),
    ("locate/larger-patches", found : felt),
    ("locate/cells-not-felt", [found, unfelt, refused 5 "no-complete-window"]),
    ("locate/contradictions", refused 20 "contradiction" : felt),
    ("locate/damaged-patches", [unfelt, found, refused 5 "contradiction"]),
    ("damage/guaranteed-radius", [unfelt, found, refused 5 "beyond-radius"]),
    ("damage/stated-radius", [unfelt, found, several, refused 3 "beyond-radius"]),
    ("damage/few-cells", [unfelt, several]),
    ( "chances/bayes",
      [ Label 50 "more than one position" (\_ one came -> positionsOf one came > 1)
      ]
    ),
    ( "chances/contradictions",
      [ refused 10 "contradiction",
        Label 10 "a posterior" (\_ one came -> positionsOf one came > 0)
      ]
    )
  ]
  where
    ofMasks =
      [ Label 20 "more than one row" (\_ one _ -> length (maskOf one) > 1),
        Label 20 "more than one column" (\_ one _ -> any ((> 1) . length) (maskOf one)),
        Label 30 "a blank cell" (\_ one _ -> any (elem '.') (maskOf one)),
        Label 30 "more cells than the degree" $ \p one _ ->
          length (filter (== '#') (concat (maskOf one))) >= length (profilePolynomial p)
      ]
    found = Label 5 "one position" (\_ one came -> positionsOf one came == 1)
    several = Label 3 "several positions" (\_ one came -> positionsOf one came > 1)
    -- A tenth are wide, and of these not every cell is felt.
    felt =
      [ Label 80 "every cell felt" (\_ one _ -> Nothing `notElem` concat (patchOf one)),
        Label 3 "more than ten columns" (\_ one _ -> any ((> 10) . length) (patchOf one))
      ]
    unfelt = Label 20 "a cell not felt" (\_ one _ -> Nothing `elem` concat (patchOf one))
    refused percent name = Label percent name (\_ _ came -> reasonIs name came)
    reasonIs :: String -> Either Refusal a -> Bool
    reasonIs name = either ((== name) . refusalReason) (const False)
    near middle by i = i + by >= middle && i <= middle + by
    periodOf p = profileOrder p ^ length (profileState p) - 1

indexOf :: Question a -> Natural
indexOf question = case question of
  Term i -> i
  _ -> 0

rowOf :: Question a -> Natural
rowOf question = case question of
  Cell r _ -> r
  _ -> 0

exponentOf :: Question a -> Integer
exponentOf question = case question of
  Power _ i -> i
  _ -> 0

primitiveIs :: Bool -> Question a -> Either Refusal a -> Bool
primitiveIs yes question came = case question of
  Primitive _ -> came == Right yes
  _ -> False

maskOf :: Question a -> MaskRows
maskOf question = case question of
  Prove mask -> mask
  Distance mask -> mask
  _ -> []

patchOf :: Question a -> Patch
patchOf question = case question of
  Locate patch -> patch
  Nearest _ patch -> patch
  _ -> []

positionsOf :: Question a -> Either Refusal a -> Int
positionsOf question came = case (question, came) of
  (Locate _, Right place) -> count place
  (Nearest _ _, Right place) -> count place
  (Posterior _, Right positions) -> length positions
  _ -> 0
  where
    count place = case place of
      At _ -> 1
      OneOf places -> length places
      Coset _ _ -> 0
