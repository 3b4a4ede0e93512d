-- | The conformance suite: what every implementation of the code must do, as data. A law is a name
-- and a property over a session with the implementation under test; it needs QuickCheck and no test
-- framework:
--
-- > mapM_ (\law -> quickCheck (lawProperty law session)) laws
--
-- The project's own test suite runs all of them on this library; a user runs them on theirs.
module PraTactile.Conformance
  ( -- * Implementations under test
    module PraTactile.Conformance.Implementation,
    library,

    -- * Laws
    Law (..),
    laws,
    damageLaws,
    chanceLaws,
    openingLaws,
  )
where

import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Law (Law (..))
import PraTactile.Conformance.Laws.Array (arrayLaws)
import PraTactile.Conformance.Laws.Chances (chanceLaws)
import PraTactile.Conformance.Laws.Damage (damageLaws)
import PraTactile.Conformance.Laws.Field (fieldLaws)
import PraTactile.Conformance.Laws.Locate (locateLaws)
import PraTactile.Conformance.Laws.Opening (openingLaws)
import PraTactile.Conformance.Laws.Sequence (sequenceLaws)
import PraTactile.Conformance.Library (library)

-- | All laws of a session.
laws :: [Law Session]
laws = concat [fieldLaws, sequenceLaws, arrayLaws, locateLaws, damageLaws, chanceLaws]
