{-# LANGUAGE RankNTypes #-}

-- | Which laws find an impostor, under which profile first, and in how many cases.
module PraTactile.Conformance.Impostors.Score
  ( Kill (..),
    kills,
    killBy,
    killsBy,
    findsAt,
  )
where

import Control.Monad.Trans.Except (runExceptT)
import Data.Maybe (catMaybes)
import PraTactile.Conformance.Ask
import PraTactile.Conformance.Definition (Known)
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Impostors.Impostor
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws (laws, openingLaws)
import PraTactile.Conformance.Library (library)
import PraTactile.Conformance.Question
import PraTactile.Profile (Profile)
import Test.QuickCheck.Gen (unGen)
import Test.QuickCheck.Random (mkQCGen)

-- | That a law finds an impostor.
data Kill = Kill
  { killLaw :: String,
    -- | The first profile under which it does; empty for a law of opening.
    killProfile :: String,
    -- | How many cases were tried there, the failing one the last.
    killCases :: Int
  }
  deriving stock (Eq, Show)

-- | The laws of the impostor's stages that find it, with a seed, each under the first of the
-- profiles that shows it.
kills :: Int -> [(String, Profile, Known)] -> Impostor -> IO [Kill]
kills seed profiles impostor =
  catMaybes <$> traverse (killBy seed profiles impostor) (chosen openingLaws ++ chosen laws)
  where
    chosen :: [Law about] -> [String]
    chosen these = [lawId law | law <- these, lawStage law `elem` impostorTouches impostor]

-- | How the law of this id finds the impostor, under the first of the profiles that shows it.
killBy :: Int -> [(String, Profile, Known)] -> Impostor -> String -> IO (Maybe Kill)
killBy seed profiles impostor law = go (if any ((== law) . lawId) openingLaws then [""] else names)
  where
    names = [name | (name, _, _) <- profiles]
    go left = case left of
      [] -> pure Nothing
      name : rest ->
        findsAt seed profiles impostor (Kill law name 0)
          >>= maybe (go rest) (pure . Just . Kill law name)

-- | Of these laws, under these profiles, whether one finds the impostor; those named by the kills.
killsBy :: Int -> [(String, Profile, Known)] -> Impostor -> [Kill] -> IO [Kill]
killsBy seed profiles impostor known' = concat <$> traverse again known'
  where
    again kill = maybe [] (\n -> [kill {killCases = n}]) <$> findsAt seed profiles impostor kill

-- | In how many cases the law of a kill finds the impostor under the kill's profile; 'Nothing' if
-- it does not, or if there are no such law and profile.
findsAt :: Int -> [(String, Profile, Known)] -> Impostor -> Kill -> IO (Maybe Int)
findsAt seed profiles impostor kill
  | law : _ <- [law | law <- openingLaws, lawId law == killLaw kill] =
    findsOpening seed [p | (_, p, _) <- profiles] law impostor
  | law : _ <- [law | law <- laws, lawId law == killLaw kill],
    (p, about) : _ <- [(p, about) | (name, p, about) <- profiles, name == killProfile kill] =
    findsUnder seed p about law impostor
  | otherwise = pure Nothing

findsOpening :: Int -> [Profile] -> Law [Profile] -> Impostor -> IO (Maybe Int)
findsOpening seed profiles law impostor =
  firstViolated
    (Asked (\p -> (() <$) <$> runExceptT (open (impostorMake impostor library) p)) none)
    (casesWith seed (lawCases law profiles))

findsUnder :: Int -> Profile -> Known -> Law Known -> Impostor -> IO (Maybe Int)
findsUnder seed p about law impostor = do
  opened <- runExceptT (open (impostorMake impostor library) p)
  case opened of
    Left _ -> pure Nothing
    Right session ->
      firstViolated
        (Asked (const (pure (Left (Refusal "not-offered")))) (runExceptT . answerOf session))
        (casesWith seed (lawCases law about))

none :: Question b -> IO (Either Refusal b)
none = const (pure (Left (Refusal "not-offered")))

data Asked
  = Asked (Profile -> IO (Either Refusal ())) (forall b. Question b -> IO (Either Refusal b))

-- | All cases, or a hundred drawn ones.
casesWith :: Int -> Cases -> [Ask Verdict]
casesWith seed (Cases _ domain trial) = map trial $ case domain of
  Every cases -> cases
  Some draw _ -> [unGen draw (mkQCGen (1000 * seed + i)) 30 | i <- [1 .. 100]]

firstViolated :: Asked -> [Ask Verdict] -> IO (Maybe Int)
firstViolated (Asked opens answers) = go 1
  where
    go n trials = case trials of
      [] -> pure Nothing
      one : rest ->
        answerAll opens answers one >>= \came -> case came of
          Violated _ -> pure (Just n)
          _ -> go (n + 1 :: Int) rest
