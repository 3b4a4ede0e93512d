{-# LANGUAGE RankNTypes #-}

-- | A progress bar on the standard error, where that is a terminal; nothing anywhere else.
--
-- Its line is drawn again as time goes by, so that it lives during a long step too. It says how
-- long the rest takes only where all steps take about as long as each other.
module Progress
  ( -- * Work
    Work,
    evenly,
    unevenly,
    openly,
    doneBefore,

    -- * Looking on
    Bar (..),
    withProgress,
    follow,
    followWhile,
    whileWorking,
    tellingAsRead,
    Meanwhile (..),
    besideOutput,

    -- * The line
    lineAt,
  )
where

import Control.Concurrent
import Control.Exception (bracket, evaluate)
import Control.Monad (forever)
import qualified Data.ByteString.Lazy as Lazy
import GHC.Clock (getMonotonicTime)
import PraTactile.Steps (Steps (..))
import System.IO (hFlush, hIsTerminalDevice, hPutStr, stderr, stdout)
import System.IO.Unsafe (unsafeInterleaveIO)

-- | Work in steps, and how it is shown.
data Work
  = -- | how many steps were done before this run, and what is drawn
    Work Integer Drawn

data Drawn
  = -- | the number of steps, and their name in the plural
    Counted Pace Integer String
  | -- | nobody knows how many; what is said of each
    Open (Integer -> String)

-- | Whether steps take about as long as each other.
data Pace = Even | Uneven
  deriving stock (Eq)

-- | Work of n steps that take about as long as each other, with their name in the plural.
evenly :: Integral n => n -> String -> Work
evenly total = Work 0 . Counted Even (toInteger total)

-- | Work of n steps, some of which may take much longer than others.
unevenly :: Integral n => n -> String -> Work
unevenly total = Work 0 . Counted Uneven (toInteger total)

-- | Work with an unknown number of steps, given the text that is shown at each.
openly :: (Integer -> String) -> Work
openly = Work 0 . Open

-- | Work of which the first n steps were done before.
doneBefore :: Integer -> Work -> Work
doneBefore before (Work _ drawn) = Work before drawn

-- | A bar in use.
data Bar = Bar
  { -- | report the number of steps done
    tell :: Integer -> IO (),
    -- | print something else to the terminal, without the bar
    aside :: forall a. IO a -> IO a
  }

-- | Run an action beside a bar that shows its work.
withProgress :: Work -> (Bar -> IO a) -> IO a
withProgress work@(Work before drawn) action = do
  shown <- hIsTerminalDevice stderr
  if shown then beside else action (Bar (const (pure ())) id)
  where
    beside = do
      start <- getMonotonicTime
      state <- newMVar before
      let draw done = do
            now <- getMonotonicTime
            put (lineAt work done (now - start))
          put line = hPutStr stderr ('\r' : line ++ "\ESC[K") >> hFlush stderr
          bar =
            Bar
              { tell = \done -> modifyMVar_ state (\_ -> pure $! done),
                aside = \other -> withMVar state (\done -> put "" *> other <* draw done)
              }
          -- Five times a second is often enough for an eye.
          redrawn = forever (threadDelay 200000 >> withMVar state draw)
          over thread = killThread thread >> edge state draw >> put ""
      edge state draw
      bracket (forkIO redrawn) over (\_ -> action bar)
    -- How work begins and ends is shown where it is counted; where it is not, it may be short.
    edge state draw = case drawn of
      Counted {} -> readMVar state >>= draw
      Open _ -> pure ()

-- | Whether lines go to the standard output at the same time.
data Meanwhile = Printing | NotPrinting
  deriving stock (Eq)

-- | 'withProgress', but without a bar where lines are printed to a terminal one after the other.
besideOutput :: Meanwhile -> Work -> (Bar -> IO a) -> IO a
besideOutput meanwhile work action = do
  mixed <- (meanwhile == Printing &&) <$> hIsTerminalDevice stdout
  if mixed then action (Bar (const (pure ())) id) else withProgress work action

-- | Pieces of output joined lazily; each reports its progress when it is written.
tellingAsRead :: Bar -> [(Integer, Lazy.ByteString)] -> IO Lazy.ByteString
tellingAsRead bar = fmap Lazy.concat . go
  where
    go pieces = case pieces of
      [] -> pure []
      (done, bytes) : more -> unsafeInterleaveIO (tell bar done >> (bytes :) <$> go more)

-- | The result of a computation in steps, each of which is the progress so far.
follow :: Integral n => Bar -> Steps n a -> IO a
follow bar steps = case steps of
  Step done more -> tell bar (toInteger done) >> follow bar more
  Done a -> pure a

-- | The rest of a computation after its first steps, as long as the function gives their progress.
followWhile :: (s -> Maybe Integer) -> Bar -> Steps s a -> IO (Steps s a)
followWhile part bar steps = case steps of
  Step s more | Just done <- part s -> tell bar done >> followWhile part bar more
  _ -> pure steps

-- | Evaluate a value to weak head normal form, while the progress line shows this text.
whileWorking :: String -> a -> IO a
whileWorking what a = withProgress (openly (const what)) (\_ -> evaluate a)

-- | The progress line after n steps and a time in seconds: less than 80 characters.
lineAt :: Work -> Integer -> Double -> String
lineAt (Work before drawn) done seconds = take 79 $ case drawn of
  Open say -> say done ++ soFar
  Counted pace total what ->
    let full = fromInteger (30 * max 0 (min total done) `div` max 1 total)
     in concat
          [ '[' : replicate full '#',
            replicate (30 - full) '.' ++ "] ",
            show done ++ "/" ++ show total ++ ' ' : what,
            rest pace total
          ]
  where
    fresh = done - before
    soFar = if seconds < 1 then "" else ", " ++ duration (floor seconds) ++ " so far"
    rest pace total
      | done >= total = ""
      | pace == Uneven = soFar
      -- One step tells little: it may hold what comes before the first one.
      | fresh < 2 || seconds < 1 = ""
      | otherwise =
        ", "
          ++ duration (round (seconds * fromInteger (total - done) / fromInteger fresh))
          ++ " left"

-- | Hours, minutes and seconds: 1:02:03.
duration :: Integer -> String
duration seconds
  | seconds >= 3600 =
    show (seconds `div` 3600)
      ++ ":"
      ++ two (seconds `div` 60 `mod` 60)
      ++ ":"
      ++ two (seconds `mod` 60)
  | otherwise = show (seconds `div` 60) ++ ":" ++ two (seconds `mod` 60)
  where
    two n = if n < 10 then '0' : show n else show n
