-- | Implementations that are wrong, each in one way in which a decoder may be wrong.
module PraTactile.Conformance.Impostors.Impostor
  ( Impostor (..),
    mistaken,
    mistouched,
    misstepped,
    missearching,
    elsewhereIn,
  )
where

import Control.Monad.IO.Class (liftIO)
import Control.Monad.Trans.Except (runExceptT)
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Impostors.Decoder
import PraTactile.Conformance.Impostors.Searching
import PraTactile.Conformance.Impostors.Ways
import PraTactile.Conformance.Law (Stage)
import PraTactile.Profile (Profile)

-- | An implementation with a mistake in it.
data Impostor = Impostor
  { impostorName :: String,
    -- | What it does instead of what it should, as a sentence without its subject.
    impostorMistake :: String,
    -- | The stages whose laws are there to find it.
    impostorTouches :: [Stage],
    -- | Put the mistake into a right implementation.
    impostorMake :: Implementation -> Implementation
  }

-- | With some operations of the session otherwise.
mistaken :: String -> String -> (Session -> Session) -> Impostor
mistaken name mistake change =
  Impostor name mistake [] (\base -> base {open = fmap change . open base})

-- | With the stages of touch otherwise.
mistouched :: String -> String -> (Touch -> Touch) -> Impostor
mistouched name mistake change =
  Impostor name mistake [] (\base -> base {touch = change (touch base)})

-- | The decoder written from the documentation, with a wrong step on its way to the array.
misstepped :: String -> String -> (Ways -> Ways) -> Impostor
misstepped name mistake change =
  Impostor
    name
    mistake
    []
    (decoder (change rightWays) rightSearching)

-- | The decoder written from the documentation, with a wrong step in its search for places.
missearching :: String -> String -> (Searching -> Searching) -> Impostor
missearching name mistake change =
  Impostor
    name
    mistake
    []
    (decoder rightWays (change rightSearching))

-- | In some operations as the same implementation would answer under another profile, where that is
-- possible: given the session under the other profile, and the right one.
elsewhereIn ::
  String -> String -> (Profile -> Profile) -> (Session -> Session -> Session) -> Impostor
elsewhereIn name mistake change join =
  Impostor name mistake [] $ \base ->
    base
      { open = \p -> do
          right <- open base p
          other <- liftIO (runExceptT (open base (change p)))
          pure (either (const right) (`join` right) other) {profile = p}
      }
