-- | Which laws find an impostor, an implementation with a planted mistake: a law finds it if the
-- impostor's answers violate a case of the law. Also the first profile under which that happens,
-- and the number of cases tried until then.
module PraTactile.Conformance.Impostors.Score
  ( Kill (..),
    kills,
    killBy,
    findsAt,
    comparedProfiles,
    firstJust,
  )
where

import Control.Monad.Trans.Except (runExceptT)
import Data.Maybe (catMaybes)
import PraTactile.Array (area)
import PraTactile.Conformance.Definition (ProfileFacts, known)
import PraTactile.Conformance.Direct
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Impostors.Impostor
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws (laws, lawsWithoutProfile, openingLaws)
import PraTactile.Conformance.Profiles (defaultProfiles)
import PraTactile.Conformance.Run.Case (Plan (..), trialsOf)
import PraTactile.Conformance.Run.Work (Settings (..), standardSettings)
import PraTactile.Profile (Profile (..))

-- | A law that finds an impostor.
data Kill = Kill
  { killLaw :: String,
    -- | The name of the first profile under which it does. Empty for a law without a profile, and
    -- for a law that opens all profiles itself.
    killProfile :: String,
    -- | The number of cases judged, up to and including the violated one.
    killCases :: Int
  }
  deriving stock (Eq, Show)

-- | The laws of the impostor's stages that find it. Arguments: the seed of drawn cases; the
-- profiles in order, each with its name and what is known of it by definition; the impostor.
kills :: Int -> [(String, Profile, ProfileFacts)] -> Impostor -> IO [Kill]
kills seed profiles impostor =
  catMaybes
    <$> traverse
      (killBy seed profiles impostor)
      (chosen openingLaws ++ chosen laws ++ chosen lawsWithoutProfile)
  where
    chosen :: [Law about] -> [String]
    chosen these = [lawId law | law <- these, lawStage law `elem` impostorTouches impostor]

-- | How the law with this id finds the impostor, under the first profile in which it does;
-- 'Nothing' if it does not. The other arguments are those of 'kills'.
killBy :: Int -> [(String, Profile, ProfileFacts)] -> Impostor -> String -> IO (Maybe Kill)
killBy seed profiles impostor law =
  firstJust [fmap (Kill law name) <$> findsBy name | name <- names]
  where
    findsBy name = findsAt seed profiles impostor (Kill law name 0)
    names
      | law `elem` map lawId openingLaws ++ map lawId lawsWithoutProfile = [""]
      | otherwise = [name | (name, _, _) <- profiles]

-- | The number of cases that the law of a 'Kill' judges under its profile, up to and including the
-- first one that the impostor violates. The 'killCases' are not used. 'Nothing' if the impostor
-- violates none or refuses the profile, and if the law or the profile is unknown. The other
-- arguments are those of 'kills'.
findsAt :: Int -> [(String, Profile, ProfileFacts)] -> Impostor -> Kill -> IO (Maybe Int)
findsAt seed profiles impostor kill
  | law : _ <- [law | law <- openingLaws, lawId law == killLaw kill] =
    findsOpening seed [p | (_, p, _) <- profiles] law impostor
  | law : _ <- [law | law <- lawsWithoutProfile, lawId law == killLaw kill] =
    finds
      (if lawStage law `elem` touchStages then sceneCases else usualCases)
      seed
      law
      ()
      (sessionRespondent (withoutProfile (impostorMade impostor)))
  | law : _ <- [law | law <- laws, lawId law == killLaw kill],
    (p, about) : _ <- [(p, about) | (name, p, about) <- profiles, name == killProfile kill] =
    findsUnder seed p about law impostor
  | otherwise = pure Nothing

-- | 'finds' for a law that opens these profiles itself.
findsOpening :: Int -> [Profile] -> Law [Profile] -> Impostor -> IO (Maybe Int)
findsOpening seed profiles law impostor =
  openingRespondent (impostorMade impostor) >>= finds usualCases seed law profiles

-- | 'finds' for a law under a profile; 'Nothing' if the impostor refuses it.
findsUnder :: Int -> Profile -> ProfileFacts -> Law ProfileFacts -> Impostor -> IO (Maybe Int)
findsUnder seed p about law impostor =
  runExceptT (open (impostorMade impostor) p)
    >>= either (const (pure Nothing)) (finds usualCases seed law about . sessionRespondent)

-- | The number of cases judged, up to and including the first one that the respondent violates;
-- 'Nothing' if it violates none. Arguments: the greatest number of drawn cases; the seed; the law;
-- its subject; the respondent.
finds :: Int -> Int -> Law about -> about -> Respondent -> IO (Maybe Int)
finds most' seed law about answers = fmap fst <$> firstViolated answers most trials
  where
    (trials, most) = trialsOf plan (lawId law) (lawCases law about)
    plan = Plan {planSeed = seed, planCases = most', planBatch = 1, planShrinks = False}

-- | The greatest number of drawn cases of a law, as in a run of the suite.
usualCases :: Int
usualCases = settingCases standardSettings

-- | The greatest number of drawn scenes of a law of touch: fewer than in a run of the suite,
-- because each is slow.
sceneCases :: Int
sceneCases = 12

-- | The default profiles with at most 1024 cells, each with its name and what is known of it by
-- definition. An impostor that is found under some default profile is found under one of these.
comparedProfiles :: [(String, Profile, ProfileFacts)]
comparedProfiles =
  [ (name, p, about)
    | (name, p) <- defaultProfiles,
      area (profileShape p) <= 1024,
      Right about <- [known p]
  ]

-- | The first action's result that is not 'Nothing'.
firstJust :: Monad m => [m (Maybe a)] -> m (Maybe a)
firstJust actions = case actions of
  [] -> pure Nothing
  action : more -> action >>= maybe (firstJust more) (pure . Just)
