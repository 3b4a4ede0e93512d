-- | Tries a law on a subject under a profile: all its cases in order, or drawn ones, with
-- shrinking of a failing case.
module PraTactile.Conformance.Run.Case
  ( Plan (..),
    Tried (..),
    Failure (..),
    tryLaw,
    tryCase,
    trialsOf,
  )
where

import Data.Aeson (Value)
import Data.Bits (xor)
import Data.Char (ord)
import Data.List (foldl')
import PraTactile.Conformance.Ask
import PraTactile.Conformance.Law
import PraTactile.Conformance.Run.Trials
import PraTactile.Conformance.Subject
import PraTactile.Format.Error (FormatError)
import PraTactile.Format.Json.Codec (Codec, readValue, writeValue)
import Test.QuickCheck (Gen, resize)
import Test.QuickCheck.Gen (unGen)
import Test.QuickCheck.Random (mkQCGen)

-- | The settings for trying laws.
data Plan = Plan
  { planSeed :: Int,
    -- | The number of drawn cases, for a law that does not exhaust its domain.
    planCases :: Int,
    -- | The number of trials in progress at once.
    planBatch :: Int,
    -- | Whether a failing case is made smaller.
    planShrinks :: Bool
  }

-- | The result of trying a law.
data Tried = Tried
  { -- | The number of judged cases, including the failing one.
    triedCases :: Int,
    triedExhaustive :: Bool,
    triedFailure :: Maybe Failure
  }

-- | A failing case.
data Failure = Failure
  { failureTrouble :: Trouble,
    -- | The case in JSON.
    failureCase :: Value,
    -- | The number of times that it was made smaller.
    failureShrinks :: Int
  }

-- | Tries the cases of a law. Cases are drawn from the plan's seed and the law's name.
tryLaw :: Plan -> Subject -> String -> Cases -> IO Tried
tryLaw plan subject name (Cases form domain trial) = case domain of
  Every whole -> do
    Search cases trouble <- search' (map trial whole)
    pure (Tried cases True ((\(i, why) -> failureOf form 0 (whole !! i, why)) <$> trouble))
  Some gen smaller -> do
    (cases, found) <- drawing 0 (drawn plan name gen)
    Tried cases False <$> traverse (shrunk smaller 0) found
  where
    search' = search subject (planBatch plan)
    -- Draws to which the law does not apply are replaced by others, up to ten per case.
    drawing count draws
      | null now = pure (count, Nothing)
      | otherwise = do
        Search cases trouble <- search' (map trial now)
        case trouble of
          Just (i, why) -> pure (count + cases, Just (now !! i, why))
          Nothing
            | cases == 0 && null later -> pure (count, Nothing)
            | otherwise -> drawing (count + cases) later
      where
        (now, later) = splitAt (planCases plan - count) draws
    shrunk smaller steps (a, why)
      | not (planShrinks plan) || timedOut why = pure failure
      | otherwise = do
        Search _ trouble <- search subject (min 8 (planBatch plan)) (map trial candidates)
        maybe
          (pure failure)
          (\(i, why') -> shrunk smaller (steps + 1) (candidates !! i, why'))
          trouble
      where
        candidates = smaller a
        failure = failureOf form steps (a, why)

failureOf :: Codec a -> Int -> (a, Trouble) -> Failure
failureOf form steps (a, why) = Failure why (writeValue form a) steps

-- | Whether each smaller case would take as long again as this one.
timedOut :: Trouble -> Bool
timedOut trouble = case trouble of
  Broke _ _ (Left fault) -> takesItsTime (faultKind fault)
  _ -> False

-- | The trials of a law in order, and the greatest number of them that is judged.
trialsOf :: Plan -> String -> Cases -> ([Ask Verdict], Int)
trialsOf plan name (Cases _ domain trial) = case domain of
  Every every -> (map trial every, maxBound)
  Some gen _ -> (map trial (drawn plan name gen), planCases plan)

-- | Ten times the needed number of cases, of growing size.
drawn :: Plan -> String -> Gen a -> [a]
drawn plan name gen = unGen (traverse sized [0 .. 10 * most - 1]) source 0
  where
    most = planCases plan
    sized i = resize (i * 100 `div` max 1 most `mod` 101) gen
    source = mkQCGen (foldl' mixed (planSeed plan) name)
    mixed h c = (h `xor` ord c) * 16777619

-- | Tries one case, given as JSON.
tryCase :: Plan -> Subject -> Cases -> Value -> Either FormatError (IO Tried)
tryCase plan subject (Cases form domain trial) value = tried <$> readValue form value
  where
    tried a = do
      Search cases trouble <- search subject (planBatch plan) [trial a]
      pure (Tried cases (exhausts domain) ((\(_, why) -> failureOf form 0 (a, why)) <$> trouble))
    exhausts (Every _) = True
    exhausts (Some _ _) = False
