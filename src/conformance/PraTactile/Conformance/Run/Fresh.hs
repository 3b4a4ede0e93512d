-- | Does a failure come again in a process that was asked nothing else? Where it does not, what was
-- asked before is looked for that makes it come, as little of it as suffices.
module PraTactile.Conformance.Run.Fresh
  ( -- * What was asked
    Past,
    remembering,
    Asked (..),

    -- * Trying again
    Dependence (..),
    dependence,
  )
where

import Control.Applicative ((<|>))
import Data.Either (rights)
import Data.Foldable (toList)
import Data.IORef
import Data.Sequence (Seq, (|>))
import qualified Data.Sequence as Seq
import PraTactile.Conformance.Run.Trials (Asked (..), itemsOf)
import PraTactile.Conformance.Subject
import PraTactile.Profile (Profile)

-- | What a process was asked since it was started, as far back as is remembered.
data Past = Past
  { pastAsked :: !(Seq Asked),
    -- | It has ended by a fault, so that what is asked next is asked of another one.
    pastEnded :: !Bool
  }

-- | How many values a reply has that is called long: each such takes its time.
longReply :: Int
longReply = 2000

-- | How many requests are remembered.
mostRemembered :: Int
mostRemembered = 1000

-- | The same subject, how to ask what it was asked, how many questions it has replied to, and how
-- many of these replies were long.
remembering :: Subject -> IO (Subject, IO [Asked], IO Int, IO Int)
remembering subject = do
  held <- newIORef (Past Seq.empty False)
  replied <- newIORef 0
  long <- newIORef 0
  let noted asked got = do
        modifyIORef' held (\past -> Past (added past asked) (any faulty got))
        modifyIORef' long (+ length [() | Right (ResponseResult value) <- got, isLong value])
        pure got
      isLong value = itemsOf value > longReply
      added past asked =
        kept (foldl (|>) (if pastEnded past then Seq.empty else pastAsked past) asked)
      kept asked = Seq.drop (Seq.length asked - mostRemembered) asked
      faulty = either (const True) (const False)
  pure
    ( subject
        { subjectProfile = \profile -> do
            got <- subjectProfile subject profile
            got <$ noted [AskedProfile profile] [got],
          subjectAsk = \questions -> do
            got <- subjectAsk subject questions
            modifyIORef' replied (+ length (rights got))
            noted (map AskedQuestion questions) got,
          subjectFresh = (>> writeIORef held (Past Seq.empty False)) <$> subjectFresh subject
        },
      toList . pastAsked <$> readIORef held,
      readIORef replied,
      readIORef long
    )

-- | What a failure depends on.
data Dependence
  = -- | On nothing else: it comes again, or that cannot be tried.
    OnItself
  | -- | On these requests before it, none of which can be left out.
    OnEarlier [Asked]
  | -- | On what was asked before, but not on that alone which is remembered.
    OnUnknown
  deriving stock (Show)

-- | What it depends on, given the profile that it is about, what was asked before, and whether the
-- failure comes again now. So many requests may be asked for that, which become fewer; a fresh
-- process counts as 'startCosts' of them.
dependence :: IORef Int -> Subject -> Maybe Profile -> [Asked] -> IO Bool -> IO Dependence
dependence left subject about before again = case subjectFresh subject of
  Nothing -> pure OnItself
  Just fresh -> do
    let within :: Int -> IO Bool -> IO Bool
        within cost act = do
          modifyIORef' left (subtract cost)
          enough <- (>= 0) <$> readIORef left
          if enough then act else pure False
        comesAfter :: [Asked] -> IO Bool
        comesAfter some = within (startCosts + length some) $ do
          fresh
          let there = inForceAfter some
          mapM_ put (if null there then about else Nothing)
          mapM_ repeated some
          mapM_ put (if null there || there == about then Nothing else about)
          again
        -- Each of them, and after each whether it comes: what is seen once only has no ending.
        oneByOne some = do
          fresh
          mapM_ put about
          firstThat (\one -> within 2 (repeated one >> again)) some
        sameProfile = [one | one@(AskedQuestion _) <- drop (lastProfile before) before]
    alone <- comesAfter []
    if alone
      then pure OnItself
      else do
        found <- firstThat comesAfter (endings before)
        case found of
          Just some -> OnEarlier <$> fewest comesAfter 2 some
          Nothing -> do
            one <- oneByOne sameProfile
            held <- maybe (pure False) (\some -> comesAfter [some]) one
            pure (if held then maybe OnUnknown (\some -> OnEarlier [some]) one else OnUnknown)
  where
    put profile = () <$ subjectProfile subject profile
    repeated asked = case asked of
      AskedProfile profile -> put profile
      AskedQuestion question -> () <$ subjectAsk subject [question]
    inForceAfter some = foldl (\last' one -> profileOf one <|> last') Nothing some
    profileOf asked = case asked of
      AskedProfile profile -> Just profile
      AskedQuestion _ -> Nothing
    lastProfile some = sum (take 1 [i | (i, AskedProfile _) <- reverse (zip [0 ..] some)])

-- | How many requests a fresh process costs: it takes about as long to start.
startCosts :: Int
startCosts = 50

-- | The last one, the last two, the last four, and so on.
endings :: [a] -> [[a]]
endings before =
  [drop (count - size) before | size <- takeWhile (< count) (iterate (* 2) 1)]
    ++ [before | count > 0]
  where
    count = length before

firstThat :: (a -> IO Bool) -> [a] -> IO (Maybe a)
firstThat holds some = case some of
  [] -> pure Nothing
  one : others -> do
    found <- holds one
    if found then pure (Just one) else firstThat holds others

-- | As few of them as it still holds for: parts are left out, first halves, then smaller ones, down
-- to single ones (Zeller and Hildebrandt, Simplifying and isolating failure-inducing input, 2002).
fewest :: ([a] -> IO Bool) -> Int -> [a] -> IO [a]
fewest holds parts some
  | null some = pure some
  | otherwise = do
    found <- firstThat holds [concat (without i) | i <- [0 .. length pieces - 1]]
    case found of
      Just less -> fewest holds (max 2 (length pieces - 1)) less
      Nothing
        | size <= 1 -> pure some
        | otherwise -> fewest holds (2 * parts) some
  where
    size = max 1 ((length some + parts - 1) `div` parts)
    pieces = inPieces some
    without i = take i pieces ++ drop (i + 1) pieces
    inPieces left = case splitAt size left of
      ([], _) -> []
      (piece, more) -> piece : inPieces more
