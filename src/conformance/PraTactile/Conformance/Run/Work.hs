-- | What there is to try: the laws of a suite that were chosen, each under each profile.
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

-- | Laws and profiles, with what they are about.
data Suite about = Suite
  { -- | By their names.
    suiteProfiles :: [(String, Profile)],
    -- | What laws of a profile are about; 'Nothing' for one that describes no array.
    suiteAbout :: Profile -> Maybe about,
    suiteLaws :: [Law about],
    suiteOpenings :: [Law [Profile]],
    -- | Those of touch and of objects, which know no profile.
    suiteWithoutProfile :: [Law ()],
    -- | What the definition answers.
    suiteAnswer :: about -> SomeQuestion -> Reply
  }

-- | Which laws are tried, and how.
data Settings = Settings
  { settingSeed :: Int,
    -- | How many cases are drawn of a law that does not exhaust its domain.
    settingCases :: Int,
    -- | For all of it, seconds.
    settingLimit :: Double,
    -- | End at the first law that fails or errs.
    settingFailFast :: Bool,
    -- | The stages to try; all those of the code, if none is named.
    settingStages :: [Stage],
    -- | The laws to try; all, if none is named.
    settingRun :: [String],
    -- | The laws to leave out.
    settingSkip :: [String],
    -- | Those are tried all the same and must fail.
    settingSkipMustFail :: Bool,
    -- | The laws that are known to fail.
    settingKnown :: [String]
  }

-- | All laws of the code, 100 cases of each that draws them, 300 seconds.
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

-- | Whether no law is left out of the sets of stages that are tried.
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

-- | A law under a profile, of profiles, or without one.
data Work = Work
  { workId :: String,
    workStage :: Stage,
    workNeeds :: [SomeOp],
    workSentence :: String,
    workSource :: String,
    -- | Its name and the profile that must be in force.
    workProfile :: Maybe (String, Profile),
    workCases :: Cases,
    workAnswer :: SomeQuestion -> Maybe Reply,
    -- | Why it is not tried.
    workLeftOut :: Maybe String
  }

-- | The ids of the laws of a suite that are of these stages.
idsOf :: [Stage] -> Suite about -> [String]
idsOf stages suite =
  own (suiteOpenings suite) ++ own (suiteLaws suite)
    ++ own
      (suiteWithoutProfile suite)
  where
    own :: [Law a] -> [String]
    own some = [lawId law | law <- some, lawStage law `elem` stages]

-- | All that was chosen, in the order in which it is tried; given what is offered.
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

-- | The work that a token names; 'Nothing' where there is no such law.
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
