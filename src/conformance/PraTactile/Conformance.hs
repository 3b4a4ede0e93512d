-- | The conformance suite: what every implementation of the code must do, as data. A law has an id
-- and cases; what it expects is what the definition says under the profile. To put your own
-- implementation under it, fill in the record 'Implementation' with functions that call it,
-- beginning with 'noOperations' where it lacks some, and run
--
-- > runLaws yours >>= exitWith
--
-- or, in a test suite, 'lawProperties', each of them a property of QuickCheck:
--
-- > for_ (lawProperties yours) (\(name, property) -> prop name property)
--
-- The project's own test suite runs all of them on this library.
module PraTactile.Conformance
  ( -- * Implementations under test
    module PraTactile.Conformance.Implementation,
    library,

    -- * Running all laws
    runLaws,
    lawProperties,
    lawProperty,
    openingProperty,

    -- * Laws
    Law (..),
    laws,
    openingLaws,

    -- * Profiles
    defaultProfiles,
    Known,
    known,
  )
where

import PraTactile.Conformance.Definition (Known, known)
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Law (Law (..))
import PraTactile.Conformance.Laws (laws, openingLaws)
import PraTactile.Conformance.Library (library)
import PraTactile.Conformance.Profiles (defaultProfiles)
import PraTactile.Conformance.Properties
