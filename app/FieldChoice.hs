{-# LANGUAGE RankNTypes #-}
-- | Choosing a field, alike in the commands about fields: @--q@ and, if it is not to be the default one, @--modulus@.
module FieldChoice
  ( FieldChoice
  , fieldChoice
  , withChosenField
  ) where

import Data.Maybe (fromMaybe)
import Data.Proxy (Proxy)
import Numeric.Natural (Natural)
import Options.Applicative

import ArrayChoice (modulusOption, orderOption)
import Ending
import Message (fieldMessage, profileMessage)
import PraTactile.Field
import PraTactile.Field.Named (conwayModulus)
import PraTactile.Profile (ProfileError (ModulusDegree))

-- | q and the modulus.
data FieldChoice = FieldChoice Natural (Maybe [Natural])

-- | The options; the modulus is optional.
fieldChoice :: Parser FieldChoice
fieldChoice = FieldChoice <$> orderOption <*> optional modulusOption

-- | Go on in the chosen field; leaves with status 2 and the reason where there is none.
withChosenField :: FieldChoice -> (forall k. KnownField k => Proxy k -> IO Ending) -> IO Ending
withChosenField (FieldChoice q chosen) use = do
  (p, conway) <- orUnusable fieldMessage (conwayModulus q)
  let modulus = fromMaybe conway chosen
      degree coefficients = fromIntegral (max 1 (length coefficients) - 1) :: Natural
  if degree modulus /= degree conway
    then unusable (profileMessage (ModulusDegree (degree modulus) (degree conway)))
    else either (unusable . fieldMessage) id (withField p modulus use)
