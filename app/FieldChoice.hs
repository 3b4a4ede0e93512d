{-# LANGUAGE RankNTypes #-}

-- | The options that choose a field, the same in all commands about fields: @--q@, and @--modulus@
-- for another than the default modulus.
module FieldChoice
  ( FieldChoice,
    fieldChoice,
    withChosenField,
    inConwayField,
  )
where

import Data.Maybe (fromMaybe)
import Data.Proxy (Proxy)
import ExitStatus
import Message (fieldMessage, profileMessage)
import Numeric.Natural (Natural)
import Options
import PraTactile.Field
import PraTactile.Field.Named (conwayModulus, modulusDegrees)
import PraTactile.Profile (ProfileError (ModulusDegree))

-- | q and the modulus.
data FieldChoice = FieldChoice Natural (Maybe [Natural])

-- | The options; the modulus is optional.
fieldChoice :: Parser FieldChoice
fieldChoice = FieldChoice <$> orderOption <*> modulusOption

-- | A computation in the field of this order with its default modulus, for any result.
inConwayField :: Natural -> (forall k. KnownField k => Proxy k -> a) -> IO a
inConwayField q use = do
  (p, conway) <- orUnusable fieldMessage (conwayModulus q)
  orUnusable fieldMessage (withField p conway use)

-- | Continue in the chosen field; leaves with status 2 and the reason if there is none.
withChosenField ::
  FieldChoice -> (forall k. KnownField k => Proxy k -> IO ExitStatus) -> IO ExitStatus
withChosenField (FieldChoice q given) use = do
  (_, conway) <- orUnusable fieldMessage (conwayModulus q)
  let modulus = fromMaybe conway given
  (p, degree, needed) <- orUnusable fieldMessage (modulusDegrees q modulus)
  if degree /= needed
    then unusable (profileMessage (ModulusDegree degree needed))
    else either (unusable . fieldMessage) id (withField p modulus use)
