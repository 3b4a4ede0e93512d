-- | Tests the conformance laws: the library and the definition satisfy them, and each law finds an
-- impostor.
module Test.Conformance.Laws (spec, lawsFailing, lawsFailingOf) where

import Data.Aeson (encode, toJSON)
import Data.Foldable (for_)
import Data.List (nub, sortOn, (\\))
import qualified Data.Set as Set
import Data.Traversable (for)
import PraTactile.Array (area)
import PraTactile.Conformance
import PraTactile.Conformance.Impostors
import PraTactile.Conformance.Impostors.Killers
import PraTactile.Conformance.Impostors.Score
import PraTactile.Conformance.InProcess (inProcess)
import PraTactile.Conformance.Law
  ( Cases (..),
    Domain (..),
    Stage (OnRegister),
    objectStages,
    touchStages,
  )
import PraTactile.Conformance.Report
import PraTactile.Conformance.Report.Words (valueText)
import PraTactile.Conformance.Run
import PraTactile.Conformance.Suite (noSuiteText, standardSuite)
import PraTactile.Format.Json.Codec (writeValue)
import PraTactile.Profile (Profile (..))
import Test.Effort
import Test.Hspec

spec :: Spec
spec = do
  describe "all laws hold" $ do
    for_ (byEffort (named varied ++ named ["gf4-63x65"]) defaultProfiles) $ \under ->
      it ("of this library: " ++ fst under) $
        lawsFailingWith (briefly under) [under] library `shouldReturn` []
    for_ (byEffort (drop 1 (named varied)) small) $ \under ->
      it ("of the definition: " ++ fst under) (failing [under] definition)
    it "of this library's stages of touch" $
      failingWith
        patient
          { settingStages = touchStages,
            settingCases = byEffort 1 12,
            settingSkip = byEffort stitchedAlike []
          }
        library
    it "of this library's objects" $
      failingWith patient {settingStages = objectStages, settingCases = byEffort 5 100} library
    whenFull . it "of this library's reports on solids, with a hundred examples of each defect" $
      failingWith
        patient
          { settingStages = objectStages,
            settingRun = ["objects/solid-as-defined"],
            settingCases = 1900
          }
        library
  it "no two laws have the same id" $ do
    let ids = map lawId openingLaws ++ map lawId laws ++ map lawId lawsWithoutProfile
    ids \\ nub ids `shouldBe` []
  it "a run without a touch stage tries no law of touch and counts no operation of touch" $ do
    suite <- either (fail . noSuiteText) pure (standardSuite (take 1 defaultProfiles))
    subject <- inProcess library
    let first' = standardSettings {settingRun = ["field/addition-commutes", "register/"]}
    report <- runSuite first' suite (const (pure ())) [subject]
    map lawReportStage (reportLaws report) `shouldSatisfy` notElem OnRegister
    length (reportAsks report) `shouldBe` 19
    reportOffers report `shouldBe` reportAsks report
  it "a law that exhausts its domain asks no question twice under the paper's profile" $ do
    Just (Right about) <- pure (known <$> lookup "paper" defaultProfiles)
    let repeats (Cases form domain _) = case domain of
          Every cases ->
            length cases /= Set.size (Set.fromList (map (encode . writeValue form) cases))
          Some _ _ -> False
    [lawId law | law <- laws, repeats (lawCases law about)] `shouldBe` byTwoRoads
  it "a value of more than 200 characters is shown by its first 160 and its last 30" $
    for_ ([0 .. 20] ++ [190 .. 260] ++ [1000]) $ \count -> do
      let written = '"' : take count (cycle ['a' .. 'z']) ++ "\""
          long = length written
          ending = reverse (take 30 (reverse written)) ++ " (" ++ show long ++ " characters)"
      valueText (toJSON (drop 1 (init' written)))
        `shouldBe` if long <= 200 then written else take 160 written ++ " ... " ++ ending
  it "each impostor has its own name and its own mistake" $ do
    map impostorName impostors \\ nub (map impostorName impostors) `shouldBe` []
    map impostorMistake impostors \\ nub (map impostorMistake impostors) `shouldBe` []
  describe ("each law finds " ++ byEffort "the first" "every" ++ " impostor listed for it") $
    for_ (map lawId openingLaws ++ map lawId laws ++ map lawId lawsWithoutProfile) killing
  where
    init' text = take (length text - 1) text
    -- Laws that reach the same question in two ways.
    byTwoRoads =
      [ "locate/across-the-edges",
        "damage/zeros",
        "damage/across-the-edges",
        "damage/nearest-refuses-what-is-invalid",
        "chances/doubtful-cells"
      ]
    -- The paper's profile; two rows over a prime field; row by row on the twisted torus; an odd
    -- power, read and packed the other way, on a sheet.
    varied = ["paper", "gf3-2x13", "gf2-3x5-row-major", "gf49-16x3-sheet"]
    named names = [(name, p) | name <- names, Just p <- [lookup name defaultProfiles]]
    -- Laws of pairs of frames cover the same in less time.
    stitchedAlike = map ("stitch/" ++) ["order", "moved", "gain-and-offset", "turned-and-mirrored"]
    isSmall = (<= 1024) . area . profileShape . snd
    small = filter isSmall defaultProfiles
    -- Definitions take time that grows faster than the array. For a large array a quick run tries
    -- only where its cells are and what is found there.
    briefly under
      | isSmall under = patient
      | otherwise =
        patient
          { settingCases = byEffort 2 100,
            settingRun =
              byEffort ["sequence/term*", "array/*", "window/*", "locate/drawn-patches"] []
          }

-- | Expects that no law fails.
failing :: [(String, Profile)] -> Implementation -> Expectation
failing profiles implementation = lawsFailing profiles implementation `shouldReturn` []

failingWith :: Settings -> Implementation -> Expectation
failingWith settings implementation = lawsFailingWith settings [] implementation `shouldReturn` []

-- | The laws of the code that an implementation violates under these profiles.
lawsFailing :: [(String, Profile)] -> Implementation -> IO [String]
lawsFailing = lawsFailingWith patient

-- | The laws whose ids contain one of these texts and that an implementation violates.
lawsFailingOf :: [String] -> [(String, Profile)] -> Implementation -> IO [String]
lawsFailingOf ids = lawsFailingWith patient {settingRun = ids}

-- | Settings without a limit of time, because the machine may be busy.
patient :: Settings
patient = standardSettings {settingLimit = 1 / 0, settingCases = byEffort 10 100}

lawsFailingWith :: Settings -> [(String, Profile)] -> Implementation -> IO [String]
lawsFailingWith settings profiles implementation = do
  suite <- either (fail . noSuiteText) pure (standardSuite profiles)
  subject <- inProcess implementation
  report <- runSuite settings suite (const (pure ())) [subject]
  pure [lawReportId one | one <- reportLaws report, lawReportOutcome one `notElem` [Held, Skipped]]

-- | Expects that a law finds the impostors listed for it, trying the smallest profiles and few
-- seeds first. @make mutants@ shows which other impostors it finds.
killing :: String -> Spec
killing law = it law $ do
  let listed = filter ((law `elem`) . killersOf . impostorName) impostors
  map impostorName listed `shouldNotBe` []
  found <- for (byEffort (take 1) id listed) $ \one ->
    (,) (impostorName one) <$> firstJust [killBy seed bySize one law | seed <- [1 .. 6]]
  [name | (name, Nothing) <- found] `shouldBe` []
  where
    bySize = sortOn (\(_, p, _) -> area (profileShape p)) comparedProfiles
