-- | An implementation in this process as a subject: it is asked in the forms of the protocol as
-- well, so that what is offered, refused and answered is judged alike.
module PraTactile.Conformance.InProcess
  ( inProcess,
    Force,
    noForce,
    putInForce,
    answerIn,
  )
where

import Control.Exception
import Control.Monad.Trans.Except (runExceptT)
import Data.Aeson (Value (Bool), encode)
import Data.IORef
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Question
import PraTactile.Conformance.Subject
import PraTactile.Conformance.Wire.Line (lineHolds)
import PraTactile.Profile (Profile)

-- | The session of the profile in force, if one is.
type Force = IORef (Maybe Session)

noForce :: IO Force
noForce = newIORef Nothing

-- | An implementation as a subject. An exception of it is a crash.
inProcess :: Implementation -> IO Subject
inProcess implementation = do
  force <- noForce
  pure
    Subject
      { subjectName = implementationName implementation,
        subjectOffers = offered implementation,
        subjectProfile = guarded . putInForce implementation force,
        subjectAsk =
          upToFault
            . map
              ( \(SomeQuestion asked) ->
                  guarded (answerIn implementation force asked >>= computed)
              ),
        subjectFresh = Nothing,
        subjectBatch = 64,
        subjectUnknown = [],
        subjectChecks = []
      }

-- | Put a profile in force; after a refusal none is.
putInForce :: Implementation -> Force -> Profile -> IO Response
putInForce implementation force profile' = do
  writeIORef force Nothing
  opened <- runExceptT (open implementation profile')
  case opened of
    Left why -> pure (ResponseRefused (refusalReason why))
    Right made -> ResponseResult (Bool True) <$ writeIORef force (Just made)

-- | The answer of the session in force, or, to a question that needs none, that of the
-- implementation.
answerIn :: Implementation -> Force -> Question a -> IO Response
answerIn implementation force question
  | operationOf question `notElem` codeOperations = answered (withoutProfile implementation)
  | otherwise = readIORef force >>= maybe none answered
  where
    none = pure (ResponseErrored "no profile is in force")
    answered session =
      either (ResponseRefused . refusalReason) (ResponseResult . answerValue question)
        <$> runExceptT (answerTo session question)

-- | A response that is computed to its end; or as far as a line of the protocol goes, if that has
-- no room for it and it is refused.
computed :: Response -> IO Response
computed response = do
  fits <- evaluate (lineHolds (encode (snd (responseItem response))))
  pure (if fits then response else ResponseRefused "too-long")

guarded :: IO a -> IO (Either Fault a)
guarded action = (Right <$> action) `catches` [Handler asynchronous, Handler (pure . Left . crash)]
  where
    asynchronous :: SomeAsyncException -> IO a
    asynchronous = throwIO
    crash :: SomeException -> Fault
    crash problem = Fault Crashed (displayException problem)
