-- | The work of a run: the chosen laws of a suite, each under each profile.
module PraTactile.Conformance.Run.Work
  ( -- * Suites
    Suite (..),

    -- * Choosing
    Settings (..),
    standardSettings,
    mustFail,
    choosesAll,
    stagesTried,
    idsOf,

    -- * Work
    Work (..),
    workOf,
    workFor,
  )
where

import Control.Applicative ((<|>))
import PraTactile.Conformance.Law
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Question
import PraTactile.Conformance.Run.Pattern
import PraTactile.Conformance.Run.Token
import PraTactile.Profile (Profile)

-- | The laws and profiles of a suite, and the subjects of the laws.
data Suite about = Suite
  { -- | The profiles, by name.
    suiteProfiles :: [(String, Profile)],
    -- | The subject of a profile's laws; 'Nothing' for a profile that describes no array.
    suiteAbout :: Profile -> Maybe about,
    suiteLaws :: [Law about],
    suiteOpenings :: [Law [Profile]],
    -- | The laws of touch and of objects, which need no profile.
    suiteWithoutProfile :: [Law ()],
    -- | The answer by the definition.
    suiteAnswer :: about -> SomeQuestion -> Reply
  }

-- | Which laws are tried, and how.
data Settings = Settings
  { settingSeed :: Int,
    -- | The number of drawn cases, for a law that does not exhaust its domain.
    settingCases :: Int,
    -- | The time limit of the whole run, in seconds.
    settingLimit :: Double,
    -- | Whether to stop at the first law that fails or errs.
    settingFailFast :: Bool,
    -- | The stages to try; if empty, all stages of the code.
    settingStages :: [Stage],
    -- | The patterns of laws to try; if empty, all.
    settingRun :: [String],
    -- | The patterns of laws to skip.
    settingSkip :: [String],
    -- | Whether the skipped laws are tried after all, and must fail.
    settingSkipMustFail :: Bool,
    -- | The patterns of laws that are known to fail.
    settingKnown :: [String]
  }

-- | All laws of the code, 100 drawn cases each, 300 seconds.
standardSettings :: Settings
standardSettings =
  Settings
    { settingSeed = 1,
      settingCases = 100,
      settingLimit = 300,
      settingFailFast = False,
      settingStages = [],
      settingRun = [],
      settingSkip = [],
      settingSkipMustFail = False,
      settingKnown = []
    }

-- | The patterns of laws that must fail.
mustFail :: Settings -> [String]
mustFail settings =
  settingKnown settings ++ (if settingSkipMustFail settings then settingSkip settings else [])

-- | Whether all laws of the tried sets of stages are chosen.
choosesAll :: Settings -> Bool
choosesAll settings =
  all whole (codeStages : [stages | (_, stages) <- stagesApart]) && null (settingRun settings)
    && null (settingSkip settings)
  where
    whole stages =
      all (`elem` stagesTried settings) stages || not (any (`elem` stagesTried settings) stages)

-- | The stages that are tried.
stagesTried :: Settings -> [Stage]
stagesTried settings = if null (settingStages settings) then codeStages else settingStages settings

-- | A law to try: under a profile, about opening profiles, or without a profile.
data Work = Work
  { workId :: String,
    workStage :: Stage,
    workNeeds :: [SomeOp],
    workSentence :: String,
    workSource :: String,
    -- | The profile that must be in force, with its name.
    workProfile :: Maybe (String, Profile),
    workCases :: Cases,
    workAnswer :: SomeQuestion -> Maybe Reply,
    -- | The reason for not trying it.
    workLeftOut :: Maybe String
  }

-- | The ids of a suite's laws of these stages.
idsOf :: [Stage] -> Suite about -> [String]
idsOf stages suite =
  own (suiteOpenings suite) ++ own (suiteLaws suite)
    ++ own
      (suiteWithoutProfile suite)
  where
    own :: [Law a] -> [String]
    own some = [lawId law | law <- some, lawStage law `elem` stages]

-- | The chosen work, in the order of trying, given the offered operations.
workOf :: Settings -> [SomeOp] -> Suite about -> [Work]
workOf settings offers suite =
  filter (chosen settings) . map restricted $
    map (opening suite) (suiteOpenings suite)
      ++ [ under suite profile about law
           | profile <- suiteProfiles suite,
             Just about <- [suiteAbout suite (snd profile)],
             law <- suiteLaws suite
         ]
      ++ map (`plain` ()) (suiteWithoutProfile suite)
  where
    restricted work = work {workLeftOut = reason work}
    reason work
      | not (settingSkipMustFail settings),
        any (`matches` workId work) (settingSkip settings) =
        Just "left out"
      | missing@(_ : _) <- filter (`notElem` offers) (workNeeds work) =
        Just ("not offered: " ++ unwords (map nameOf missing))
      | otherwise = Nothing

chosen :: Settings -> Work -> Bool
chosen settings work =
  workStage work `elem` stagesTried settings
    && (null (settingRun settings) || any (`matches` workId work) (settingRun settings))

-- | The work that a token names; 'Nothing' if its law is unknown.
workFor :: Suite about -> Token -> Maybe Work
workFor suite token = case tokenProfile token of
  Nothing ->
    found (opening suite) (suiteOpenings suite)
      <|> found
        (`plain` ())
        (suiteWithoutProfile suite)
  Just profile -> do
    about <- suiteAbout suite profile
    found (under suite (named profile, profile) about) (suiteLaws suite)
  where
    found :: (Law a -> Work) -> [Law a] -> Maybe Work
    found work some = case filter ((== tokenLaw token) . lawId) some of
      law : _ -> Just (work law)
      [] -> Nothing
    named profile = case filter ((== profile) . snd) (suiteProfiles suite) of
      (name, _) : _ -> name
      [] -> "the token's"

opening :: Suite about -> Law [Profile] -> Work
opening suite law = (plain law (map snd (suiteProfiles suite))) {workProfile = Nothing}

under :: Suite about -> (String, Profile) -> about -> Law about -> Work
under suite profile about law =
  (plain law about)
    { workProfile = Just profile,
      workAnswer = Just . suiteAnswer suite about
    }

plain :: Law a -> a -> Work
plain law about =
  Work
    { workId = lawId law,
      workStage = lawStage law,
      workNeeds = lawNeeds law,
      workSentence = lawSentence law,
      workSource = lawSource law,
      workProfile = Nothing,
      workCases = lawCases law about,
      workAnswer = const Nothing,
      workLeftOut = Nothing
    }
