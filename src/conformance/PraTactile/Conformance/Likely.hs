-- | The likely cause of a failure: the one shipped impostor that errs exactly alike.
module PraTactile.Conformance.Likely
  ( likely,
  )
where

import Control.Monad (filterM)
import Control.Monad.Trans.Except (runExceptT)
import PraTactile.Array (area)
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Impostors
import PraTactile.Conformance.Law
import PraTactile.Conformance.Library (library)
import PraTactile.Conformance.Question
import PraTactile.Profile (Profile (..))

-- | The name of the impostor that gives every one of these answers under the profile, if one alone
-- does. None is looked for on arrays of more than 300 cells, where to make all of them takes long.
likely :: Profile -> [[Exchange]] -> IO (Maybe String)
likely p failures
  | area (profileShape p) > 300 || null exchanges = pure Nothing
  | otherwise = do
    alike <- filterM (errsAlike p exchanges) impostors
    pure $ case alike of
      [one] -> Just (impostorName one)
      _ -> Nothing
  where
    exchanges = concat failures

-- | Whether it answers all of them so.
errsAlike :: Profile -> [Exchange] -> Impostor -> IO Bool
errsAlike p exchanges impostor = do
  opened <- runExceptT (open (impostorMake impostor library) p)
  either (const (pure False)) (`allAlike` exchanges) opened

allAlike :: Session -> [Exchange] -> IO Bool
allAlike s exchanges = case exchanges of
  [] -> pure True
  Exchange (Just operation) input wanted : rest -> do
    came <- runExceptT (answerOf s (Raw operation input))
    if either (RefusedFor . refusalReason) Result came == wanted
      then allAlike s rest
      else pure False
  Exchange Nothing _ _ : rest -> allAlike s rest
