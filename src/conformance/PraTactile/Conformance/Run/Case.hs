-- | A law tried on a subject under a profile: all its cases in their order, or drawn ones, of which
-- one in trouble is made as small as it becomes.
module PraTactile.Conformance.Run.Case
  ( Plan (..),
    Share (..),
    Tried (..),
    Failure (..),
    tryLaw,
    tryCase,
    trialsOf,
    fewestAlike,
  )
where

import Data.Aeson (Value)
import Data.Bifunctor (first)
import Data.Bits (xor)
import Data.Char (ord)
import Data.List (foldl', nub, (\\))
import PraTactile.Conformance.Ask
import PraTactile.Conformance.Law
import PraTactile.Conformance.Run.Trials
import PraTactile.Conformance.Subject
import PraTactile.Format.Error (FormatError)
import PraTactile.Format.Json.Codec (readValue, writeValue)
import Test.QuickCheck (Gen, resize)
import Test.QuickCheck.Gen (unGen)
import Test.QuickCheck.Random (mkQCGen)

-- | How laws are tried.
data Plan = Plan
  { planSeed :: Int,
    -- | How many cases are drawn of a law that does not exhaust its domain.
    planCases :: Int,
    -- | How many trials go on at once.
    planWindow :: Int,
    -- | Whether a failing case is left as it is, and no others like it are looked for.
    planBrief :: Bool,
    -- | Which of the cases.
    planShare :: Share
  }

-- | Which of a law's cases are tried. A law at which a glance was taken is tried whole by trying
-- the others, so that a glance costs nothing.
data Share
  = -- | About a tenth of them, from all over the domain, or of all sizes: at least one, and no more
    -- of a whole domain than of one from which cases are drawn.
    AtAGlance
  | -- | All but these.
    TheOthers
  | Whole
  deriving stock (Eq)

-- | What came of a law.
data Tried = Tried
  { -- | How many cases were judged; where one failed, to that one.
    triedCases :: Int,
    triedExhaustive :: Bool,
    triedFailure :: Maybe Failure
  }

-- | A case in trouble.
data Failure = Failure
  { failureTrouble :: Trouble,
    -- | In the form of the law's cases.
    failureCase :: Value,
    -- | How often it was made smaller.
    failureShrinks :: Int,
    -- | What was asked in the cases that violate the law, as far as they were tried.
    failureWrong :: [[Exchange]]
  }

-- | How many failing cases a cause must agree with at least to be called likely.
fewestAlike :: Int
fewestAlike = 3

-- | Try the cases of a law, drawn ones from the plan's seed and the law's own name.
tryLaw :: Plan -> Subject -> String -> Cases -> IO Tried
tryLaw plan subject name (Cases form domain trial) = case domain of
  Every whole -> do
    let indices = indicesOf plan whole
    searched <- search' (map trial (chosen indices whole))
    let seen = first (indices !!) <$> searchTrouble searched
    -- The first failing case in order is told, and not the first that was seen.
    earlier <- case seen of
      Just (i, why)
        | planShare plan /= Whole,
          not (planBrief plan || timedOut why) ->
          Just <$> search' (map trial (take i whole))
      _ -> pure Nothing
    let (trouble, wrong) = case earlier of
          Just again | Just found <- searchTrouble again -> (Just found, searchWrong again)
          _ -> (seen, searchWrong searched)
        failure (i, why) =
          Failure why (writeValue form (whole !! i)) 0 <$> further why wrong (drop (i + 1) whole)
    Tried (searchCases searched) (planShare plan /= AtAGlance) <$> traverse failure trouble
  Some gen smaller -> do
    let draws = drawn plan name gen
    (cases, searched) <- drawing 0 draws
    failure <- traverse (uncurry (shrunk smaller 0)) searched
    Tried cases False <$> traverse (furtherDrawn draws) failure
  where
    -- Where a failing case is left as it is, the first one is judged before others are asked.
    search' = search subject (Window (if planBrief plan then 1 else most) most)
    most = planWindow plan
    furtherDrawn draws failure = do
      wrong <- further (failureTrouble failure) (failureWrong failure) (reverse draws)
      pure failure {failureWrong = wrong}
    -- A cause can be told by several cases only: more are tried, if a law is violated, until there
    -- are three, or another sixty have been tried.
    further why wrong = case why of
      _ | planBrief plan -> const (pure wrong)
      -- Long answers are few that are kept, and each takes its time.
      Wrong violation
        | length (fewOf id (replicate 8 (violationAsked violation))) < 8 -> const (pure wrong)
      Wrong _ -> goOn (60 :: Int) wrong
      Broke {} -> const (pure wrong)
    goOn left wrong later
      | length (nub wrong) >= fewestAlike || left <= 0 || null later = pure wrong
      | otherwise = do
        searched <- search' (map trial (take left later))
        case searchTrouble searched of
          Just (i, Wrong _) ->
            let others = nub (searchWrong searched) \\ wrong
             in goOn (left - i - 1) (fewOf id (others ++ wrong)) (drop (i + 1) later)
          _ -> pure wrong
    -- Draws of which the law says nothing are made good by others, up to ten for each case.
    drawing count draws
      | null now = pure (count, Nothing)
      | otherwise = do
        searched <- search' (map trial now)
        let count' = count + searchCases searched
        case searchTrouble searched of
          Just (i, why) -> pure (count', Just (now !! i, (why, searchWrong searched)))
          Nothing
            | searchCases searched == 0 && null later -> pure (count', Nothing)
            | otherwise -> drawing count' later
      where
        (now, later) = splitAt (planned plan - count) draws
    shrunk smaller steps a (why, wrong)
      | planBrief plan || timedOut why = pure (failed a)
      | otherwise = do
        -- A few at once: of what is smaller the first ones are mostly in trouble too.
        searched <- search subject (atOnce (min 8 (planWindow plan))) (map trial candidates)
        case searchTrouble searched of
          Just (i, why') ->
            let wrong' = fewOf id (wrong ++ searchWrong searched)
             in shrunk smaller (steps + 1) (candidates !! i) (why', wrong')
          Nothing -> pure (failed a)
      where
        candidates = smaller a
        failed one = Failure why (writeValue form one) steps wrong

-- | The trials of a law in the order in which they are made, and how many of them are judged at
-- most: draws of which the law says nothing are made good by others.
trialsOf :: Plan -> String -> Cases -> ([Ask Verdict], Int)
trialsOf plan name (Cases _ domain trial) = case domain of
  Every every -> (map trial every, maxBound)
  Some gen _ -> (map trial (drawn plan name gen), planned plan)

-- | Whether each smaller case would cost as long again as this one.
timedOut :: Trouble -> Bool
timedOut trouble = case trouble of
  Broke _ _ (Left fault) -> takesItsTime (faultKind fault)
  _ -> False

-- | So many from the first on.
atOnce :: Int -> Window
atOnce window = Window window window

-- | How many cases of a law are drawn that are judged.
planned :: Plan -> Int
planned plan = case planShare plan of
  AtAGlance -> glances plan
  TheOthers -> planCases plan - glances plan
  Whole -> planCases plan

-- | A tenth of the cases, one at least.
glances :: Plan -> Int
glances plan = max 1 (planCases plan `div` 10)

-- | Those with these indices, which ascend.
chosen :: [Int] -> [a] -> [a]
chosen = go 0
  where
    go i (next : others) some
      | one : rest <- drop (next - i) some = one : go (next + 1) others rest
    go _ _ _ = []

-- | Whether a case, of so many by its index, is of the plan's share: at a glance about as far apart
-- as they can be.
isShared :: Plan -> Int -> Int -> Bool
isShared plan count i = case planShare plan of
  Whole -> True
  AtAGlance -> seen
  TheOthers -> not seen
  where
    seen = i * glances plan `mod` max 1 count < glances plan

-- | Where in a domain, in order, the cases of the plan's share are.
indicesOf :: Plan -> [a] -> [Int]
indicesOf plan whole = filter (isShared plan count) [0 .. count - 1]
  where
    count = length whole

-- | Ten times as many as are needed, growing, of the plan's share.
drawn :: Plan -> String -> Gen a -> [a]
drawn plan name gen =
  [a | (i, a) <- zip [0 ..] draws, isShared plan most (i `mod` max 1 most)]
  where
    most = planCases plan
    draws = unGen (traverse sized [0 .. 10 * most - 1]) source 0
    sized i = resize (i * 100 `div` max 1 most `mod` 101) gen
    source = mkQCGen (foldl' mixed (planSeed plan) name)
    mixed h c = (h `xor` ord c) * 16777619

-- | Try one case, given in the form of the law's cases.
tryCase :: Plan -> Subject -> Cases -> Value -> Either FormatError (IO Tried)
tryCase plan subject (Cases form domain trial) value = tried <$> readValue form value
  where
    tried a = do
      searched <- search subject (atOnce (planWindow plan)) [trial a]
      let failure (_, why) = Failure why value 0 (searchWrong searched)
      pure (Tried (searchCases searched) (exhausts domain) (failure <$> searchTrouble searched))
    exhausts (Every _) = True
    exhausts (Some _ _) = False
