{-# LANGUAGE GADTs #-}

-- | Many trials at once: the next question of each is asked together with those of the others, so
-- that another process always has something to do; what is found is the same as if they were tried
-- one after the other.
module PraTactile.Conformance.Run.Trials
  ( search,
    Search (..),
    Window (..),
    fewOf,
    itemsOf,
    Trouble (..),
    Asked (..),
  )
where

import Control.Concurrent (forkIO)
import Control.Exception (SomeException, catch, evaluate)
import Control.Monad (void)
import Data.Aeson (Value (..), encode)
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.IntSet as IntSet
import Data.List (sortOn)
import PraTactile.Conformance.Ask
import PraTactile.Conformance.Law
import PraTactile.Conformance.Process.Reply (excerpt)
import PraTactile.Conformance.Question
import PraTactile.Conformance.Subject
import PraTactile.Conformance.Wire
import PraTactile.Format.Profile (profileValue)
import PraTactile.Profile (Profile)

-- | What is wrong with a case.
data Trouble
  = Wrong Violation
  | -- | After these exchanges this was asked, and that came, which is no answer.
    Broke [Exchange] Asked (Either Fault Response)
  deriving stock (Show)

-- | What was asked.
data Asked
  = AskedQuestion SomeQuestion
  | AskedProfile Profile
  deriving stock (Show)

-- | What came of trials.
data Search = Search
  { -- | How many were judged, to the first in trouble; those of which the law says nothing do not
    -- count.
    searchCases :: Int,
    -- | The first one in trouble, by its index.
    searchTrouble :: Maybe (Int, Trouble),
    -- | What was asked in those that violate the law, as far as they were tried.
    searchWrong :: [[Exchange]]
  }

-- | Of how many trials that violate a law what was asked is kept at most.
mostWrong :: Int
mostWrong = 256

-- | A trial that goes on: what was asked in it, the last first, and what it asks next.
data Active = Active Int [Exchange] (Ask Verdict)

-- | As many of them as are kept: no more than 'mostWrong', and together of no more than 20 000
-- values, because one with a long answer needs no others beside it to be told apart.
fewOf :: (a -> [Exchange]) -> [a] -> [a]
fewOf askedIn some =
  map fst . takeWhile ((<= 20000) . snd) . take mostWrong $ zip some (scanl1 (+) (map size some))
  where
    size = sum . map inOne . askedIn
    inOne one = itemsOf (exchangeInput one) + replyItems (exchangeReply one)
    replyItems reply = case reply of
      Result value -> itemsOf value
      RefusedFor _ -> 1

-- | How many values a value has in it.
itemsOf :: Value -> Int
itemsOf value = case value of
  Array items -> 1 + sum (fmap itemsOf items)
  Object fields -> 1 + sum (fmap itemsOf fields)
  _ -> 1

data State = State
  { judged :: IntSet.IntSet,
    trouble :: Maybe (Int, Trouble),
    violations :: [(Int, [Exchange])],
    active :: [Active],
    waiting :: [Active]
  }

-- | How many trials go on at once: so many at first, and at most; twice as many each time that
-- they go on, but where it is one, only once that is judged.
data Window = Window
  { windowFirst :: Int,
    windowMost :: Int
  }

-- | Try these, so many at once, to the first one in order that is in trouble.
search :: Subject -> Window -> [Ask Verdict] -> IO Search
search subject (Window first most) trials =
  go first (State IntSet.empty Nothing [] [] (zipWith (`Active` []) [0 ..] trials)) []
  where
    -- What came last is judged while the next questions are asked, but for trials that have the
    -- subject for themselves.
    go window before judging
      | null (active state) && null judging = pure (found state)
      | null (active state) || window == 1 && not (null judging) =
        let settled = foldr settle before judging
         in go (if IntSet.null (judged settled) then window else doubled) settled []
      | otherwise = do
        replies <- asked subject (active state)
        let fates = zipWith fed (active state) replies
            -- Those after a fault are not needed any more; others wait for their turn.
            rest = drop (length replies) (active state)
        judgedBeside fates
        -- A first one is judged before others are asked.
        go (if window == 1 then 1 else doubled) (foldr settle state {active = rest} judging) fates
      where
        state = refilled window before
        doubled = min most (2 * window)

-- | Have these judged by another thread, to the first one that is violated: those after it are
-- hardly needed any more.
judgedBeside :: [Either (Int, Trouble) Active] -> IO ()
judgedBeside fates = void (forkIO (judge fates `catch` ignored))
  where
    judge some = case some of
      Right (Active _ _ (Done verdict)) : others ->
        evaluate verdict >>= \came -> case came of
          Violated _ -> pure ()
          _ -> judge others
      Right _ : others -> judge others
      _ -> pure ()
    -- Whoever uses the verdict meets it again.
    ignored :: SomeException -> IO ()
    ignored _ = pure ()

found :: State -> Search
found state =
  Search
    { searchCases = IntSet.size (fst (IntSet.split (bound state) (judged state))),
      searchTrouble = trouble state,
      searchWrong = map snd (violations state)
    }

-- | One more than the index of the first trial in trouble.
bound :: State -> Int
bound = maybe maxBound ((+ 1) . fst) . trouble

-- | With as many trials that ask as may be, those that ask nothing being settled. They ask in
-- order: the first one at fault is then known at once, where each may cost a process.
refilled :: Int -> State -> State
refilled window before
  | null new = state {active = sortOn (\(Active i _ _) -> i) (active state)}
  | otherwise = refilled window (foldr (settle . Right) state {waiting = later} new)
  where
    state = before {active = filter inTime (active before)}
    inTime (Active i _ _) = i < bound before
    (new, later) =
      splitAt (window - length (active state)) (takeWhile inTime (waiting state))

-- | A trial that goes on or is judged, or the one that is in trouble.
settle :: Either (Int, Trouble) Active -> State -> State
settle fate state = case fate of
  Left (i, why) -> blamed i why
  Right (Active i _ (Done verdict)) -> case verdict of
    Inapplicable -> state
    Holds -> counted i state
    Violated violation ->
      (counted i (blamed i (Wrong violation)))
        { violations = fewOf snd ((i, violationAsked violation) : violations state)
        }
  Right going -> state {active = going : active state}
  where
    counted i s = s {judged = IntSet.insert i (judged s)}
    blamed i why
      | i < bound state = counted i state {trouble = Just (i, why)}
      | otherwise = state

-- | What the first trials ask next, asked; the replies up to the first fault.
asked :: Subject -> [Active] -> IO [Either Fault Response]
asked subject trials = case trials of
  Active _ _ (Opening profile _) : _ -> (: []) <$> subjectProfile subject profile
  _ -> subjectAsk subject (questions trials)
  where
    questions some = case some of
      Active _ _ (Asking question _) : others -> SomeQuestion question : questions others
      _ -> []

-- | A trial with the reply to what it asked.
fed :: Active -> Either Fault Response -> Either (Int, Trouble) Active
fed (Active i before trial) reply = case trial of
  Done _ -> Right (Active i before trial)
  Opening profile continue -> case reply of
    Right (ResponseResult (Bool True)) ->
      on Nothing (profileValue profile) (Result (Bool True)) (continue (Right ()))
    Right (ResponseRefused why) ->
      on Nothing (profileValue profile) (RefusedFor why) (continue (Left (Refusal why)))
    Right (ResponseResult value) -> broken (AskedProfile profile) (Left (wrongType value))
    _ -> broken (AskedProfile profile) reply
  Asking question continue -> case reply of
    Right (ResponseResult value) -> case readAnswer question value of
      Just answer -> onward question (Result value) (continue (Right answer))
      Nothing -> broken (AskedQuestion (SomeQuestion question)) (Left (wrongType value))
    Right (ResponseRefused why) -> onward question (RefusedFor why) (continue (Left (Refusal why)))
    _ -> broken (AskedQuestion (SomeQuestion question)) reply
  where
    broken what got = Left (i, Broke (reverse before) what got)
    onward :: Question b -> Reply -> Ask Verdict -> Either (Int, Trouble) Active
    onward question = on (Just (operationOf question)) (questionInput question)
    on operation input got next = Right (Active i (Exchange operation input got : before) next)

wrongType :: Value -> Fault
wrongType value =
  Fault WrongType ("a result of another type: " ++ excerpt (Lazy.toStrict (encode value)))
