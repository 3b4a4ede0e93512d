-- | What a subject left without a reply in a run. Every such request costs the time to wait for it,
-- or a new process, and is a failure that has to be mended first; so what depends on it is not
-- asked again.
module PraTactile.Conformance.Run.Unanswered
  ( Unanswered,
    nothingUnanswered,
    noted,
    whyNotAsked,
  )
where

import Data.Aeson (Value (..))
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Maybe (mapMaybe)
import qualified Data.Text as Text
import PraTactile.Conformance.Question
import PraTactile.Conformance.Report
import PraTactile.Conformance.Subject

-- | Each with what came instead; a profile once, for it is not put in force anew for each law.
newtype Unanswered = Unanswered [(Requested, FaultKind)]

-- | What a request asks for.
data Requested = RequestedProfile Value | RequestedOperation String
  deriving stock (Eq)

nothingUnanswered :: Unanswered
nothingUnanswered = Unanswered []

-- | With the request that this law ended at, if there was no reply to it.
noted :: LawReport -> Unanswered -> Unanswered
noted report before@(Unanswered some) = case lawReportCounterexample report of
  Just one
    | Left fault <- counterGot one,
      faultKind fault /= WrongType,
      what : _ <- mapMaybe requested (reverse (counterRequests one)),
      isOperation what || what `notElem` map fst some ->
      Unanswered ((what, faultKind fault) : some)
  _ -> before

isOperation :: Requested -> Bool
isOperation what = case what of
  RequestedOperation _ -> True
  RequestedProfile _ -> False

requested :: Value -> Maybe Requested
requested request = case request of
  Object keys
    | Just (String name) <- there "operation" keys -> Just (RequestedOperation (Text.unpack name))
    | Just profile <- there "profile" keys -> Just (RequestedProfile profile)
  _ -> Nothing
  where
    there = KeyMap.lookup . Key.fromString

-- | Why what needs these operations is not asked, if it is not: there was no reply to one of them,
-- or so many requests took all of the time for a reply that this is all there is to tell.
whyNotAsked :: Unanswered -> [Operation] -> Maybe String
whyNotAsked (Unanswered some) needs
  | length (filter (takesItsTime . snd) some) >= mostWaited =
    Just "not asked: the time for a reply was over three times before"
  | name : _ <- filter ((`elem` map fst some) . RequestedOperation) (map operationName needs) =
    Just ("not asked: there was no reply to " ++ name ++ " before")
  | otherwise = Nothing

-- | How often the whole time for a reply is waited.
mostWaited :: Int
mostWaited = 3
