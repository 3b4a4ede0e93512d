-- | An implementation in this process as a subject. It is asked in the JSON of the protocol as
-- well, so that offers, refusals and answers are judged in the same way.
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

-- | A new state with no profile in force.
noForce :: IO Force
noForce = newIORef Nothing

-- | An implementation as a subject. An exception counts as a crash.
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

-- | Puts a profile in force. After a refusal no profile is in force.
putInForce :: Implementation -> Force -> Profile -> IO Response
putInForce implementation force profile' = do
  writeIORef force Nothing
  opened <- runExceptT (open implementation profile')
  case opened of
    Left why -> pure (ResponseRefused (refusalReason why))
    Right made -> ResponseResult (Bool True) <$ writeIORef force (Just made)

-- | The answer of the session in force, or of the implementation to a question that needs no
-- profile. It is @errored@ if a profile is needed and none is in force.
answerIn :: Implementation -> Force -> Question a -> IO Response
answerIn implementation force question
  | operationOf question `notElem` codeOperations = answered (withoutProfile implementation)
  | otherwise = readIORef force >>= maybe none answered
  where
    none = pure (ResponseErrored "no profile is in force")
    answered session =
      either (ResponseRefused . refusalReason) (ResponseResult . answerValue question)
        <$> runExceptT (answerTo session question)

-- | Evaluates a response completely, or up to the length of a protocol line; a longer one is
-- refused.
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
