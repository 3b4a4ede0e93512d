-- | Work done side by side.
module Workers (sideBySide) where

import Control.Concurrent
import Control.Exception (throwIO)
import Control.Monad (forM)
import Data.List (sortOn)

-- | Each piece of work is done by whichever of the workers is free next; what came of the pieces
-- stands in their order. Throws what a piece throws, when the other workers have ended.
sideBySide :: [worker] -> (worker -> a -> IO b) -> [a] -> IO [b]
sideBySide workers act pieces = do
  queue <- newMVar (zip [0 :: Int ..] pieces)
  results <- newMVar []
  ended <- forM workers $ \worker -> do
    end <- newEmptyMVar
    let work = do
          next <- modifyMVar queue $ \waiting -> pure $ case waiting of
            [] -> ([], Nothing)
            piece : more -> (more, Just piece)
          case next of
            Nothing -> pure ()
            Just (number, piece) -> do
              result <- act worker piece
              modifyMVar_ results (pure . ((number, result) :))
              work
    end <$ forkFinally work (putMVar end)
  mapM takeMVar ended >>= mapM_ (either throwIO pure)
  map snd . sortOn fst <$> readMVar results
