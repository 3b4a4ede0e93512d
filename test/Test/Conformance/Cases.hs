-- | What laws of conformance ask where they exhaust what they are about: exactly what they say.
module Test.Conformance.Cases
  ( spec,
    over37,
  )
where

import Data.Aeson (Value, encode)
import Data.Foldable (for_)
import Data.List (isSuffixOf, sort)
import PraTactile.Array (Shape (..))
import PraTactile.Conformance
import PraTactile.Conformance.Law (Cases (..), Domain (..))
import PraTactile.Conformance.Question (Question (..))
import PraTactile.Format.Json.Codec (writeValue)
import PraTactile.Format.Profile (profileValue)
import PraTactile.Profile
import Test.Conformance.Cases.Domains
import Test.Conformance.Cases.Impossible
import Test.Conformance.Cases.Spoilt
import Test.Hspec

spec :: Spec
spec = do
  for_ under $ \(name, p) ->
    it ("is all that there is, where a law says so: " ++ name) $ do
      Right about <- pure (known p)
      everyCase (filter (not . ofInvalid) laws) about `isExactly` domains p
  for_ under $ \(name, p) ->
    it ("is of what is no input all that is wrong in one place: " ++ name) $ do
      Right about <- pure (known p)
      everyCase (filter ofInvalid laws) about `isExactly` spoilt p
  it "is of profiles each of them, and each with every change that leaves no array" $
    everyCase openingLaws (map snd defaultProfiles)
      `isExactly` [ (law, map profileValue cases)
                    | (law, cases) <-
                        ("profile/possible-ones-are-opened", map snd defaultProfiles) : impossible
                  ]
  it "is of the powers over a large field those of 32 elements, to the exponents 32 and -32" $ do
    Right about <- pure (known over37)
    [found | ("field/power-as-defined", found) <- everyCase laws about]
      `shouldSatisfy` \given -> case given of
        [found] ->
          sort (map encode found)
            == sort [encode (question (Power a i)) | i <- [-32 .. 32], a <- [0 .. 31]]
        _ -> False
  it "smaller patches and polynomials come before larger ones" $
    for_ under $ \(_, p) -> do
      Right about <- pure (known p)
      for_ ["locate/small-patches", "damage/small-patches", "chances/certain-cells"] $ \law ->
        for_ [found | one <- laws, lawId one == law, Just found <- [every (lawCases one about)]] $
          \found -> map cellsIn found `shouldBe` sort (map cellsIn found)
  where
    under =
      [ one
        | one@(name, _) <- defaultProfiles,
          name
            `elem` ["gf2-3x5", "gf2-3x5-row-major", "gf3-2x13", "gf9-5x16", "paper", "paper-sheet"]
      ]
    ofInvalid law = "-refuses-what-is-invalid" `isSuffixOf` lawId law
    cellsIn value = length [() | c <- show (encode value), c == ',']

-- | The cases of the laws that exhaust them, by the laws' ids.
everyCase :: [Law known] -> known -> [(String, [Value])]
everyCase those about =
  [(lawId law, found) | law <- those, Just found <- [every (lawCases law about)]]

-- | The same laws, each with the same cases, in any order.
isExactly :: [(String, [Value])] -> [(String, [Value])] -> Expectation
asked `isExactly` wanted = do
  sort (map fst asked) `shouldBe` sort (map fst wanted)
  for_ wanted $ \(law, cases) ->
    (law, sorted <$> lookup law asked) `shouldBe` (law, Just (sorted cases))
  where
    sorted = sort . map encode

every :: Cases -> Maybe [Value]
every (Cases form domain _) = case domain of
  Every cases -> Just (map (writeValue form) cases)
  Some _ _ -> Nothing

-- | A profile over a large field: 37 is prime, and x + 35 has the root 2, which is primitive modulo
-- 37.
over37 :: Profile
over37 =
  canonicalProfile
    { profileOrder = 37,
      profileModulus = [35, 1],
      profilePolynomial = [5, 1, 1],
      profileState = [0, 1],
      profileShape = Shape 8 171,
      profileWindow = Shape 1 2
    }
