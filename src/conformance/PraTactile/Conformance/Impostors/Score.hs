-- | Which laws find an impostor, under which profile first, and in how many cases.
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
import PraTactile.Conformance.Definition (Known, known)
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
    -- | The first profile under which it does; empty for a law without a profile.
    killProfile :: String,
    -- | The number of cases tried there; the last one failed.
    killCases :: Int
  }
  deriving stock (Eq, Show)

-- | The laws that find an impostor, of the impostor's stages, with the given seed. Each comes with
-- the first profile that shows it.
kills :: Int -> [(String, Profile, Known)] -> Impostor -> IO [Kill]
kills seed profiles impostor =
  catMaybes
    <$> traverse
      (killBy seed profiles impostor)
      (chosen openingLaws ++ chosen laws ++ chosen lawsWithoutProfile)
  where
    chosen :: [Law about] -> [String]
    chosen these = [lawId law | law <- these, lawStage law `elem` impostorTouches impostor]

-- | How the law with this id finds the impostor, under the first profile that shows it.
killBy :: Int -> [(String, Profile, Known)] -> Impostor -> String -> IO (Maybe Kill)
killBy seed profiles impostor law =
  firstJust [fmap (Kill law name) <$> findsBy name | name <- names]
  where
    findsBy name = findsAt seed profiles impostor (Kill law name 0)
    names
      | law `elem` map lawId openingLaws ++ map lawId lawsWithoutProfile = [""]
      | otherwise = [name | (name, _, _) <- profiles]

-- | The number of cases in which a kill's law finds the impostor under the kill's profile;
-- 'Nothing' if it does not, or if the law or the profile is unknown.
findsAt :: Int -> [(String, Profile, Known)] -> Impostor -> Kill -> IO (Maybe Int)
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

findsOpening :: Int -> [Profile] -> Law [Profile] -> Impostor -> IO (Maybe Int)
findsOpening seed profiles law impostor =
  openingRespondent (impostorMade impostor) >>= finds usualCases seed law profiles

findsUnder :: Int -> Profile -> Known -> Law Known -> Impostor -> IO (Maybe Int)
findsUnder seed p about law impostor =
  runExceptT (open (impostorMade impostor) p)
    >>= either (const (pure Nothing)) (finds usualCases seed law about . sessionRespondent)

-- | The number of cases in which a law finds the respondent wrong. The arguments are the greatest
-- number of cases, the seed, the law, its subject, and the respondent.
finds :: Int -> Int -> Law about -> about -> Respondent -> IO (Maybe Int)
finds most' seed law about answers = fmap fst <$> firstViolated answers most trials
  where
    (trials, most) = trialsOf plan (lawId law) (lawCases law about)
    plan = Plan {planSeed = seed, planCases = most', planBatch = 1, planShrinks = False}

-- | The number of drawn cases in a run of the suite.
usualCases :: Int
usualCases = settingCases standardSettings

-- | The number of drawn scenes: fewer, because each is slow. They are the first ones of a run.
sceneCases :: Int
sceneCases = 12

-- | The default profiles with at most 1024 cells. Mistakes found under all profiles are found
-- under these.
comparedProfiles :: [(String, Profile, Known)]
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
