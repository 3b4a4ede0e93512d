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
-- The stages of touch, registration, stitching and segmentation, have laws of their own,
-- 'runTouchLaws' and 'touchProperties'. The project's own test suite runs all of them on this
-- library.
module PraTactile.Conformance
  ( -- * Implementations under test
    module PraTactile.Conformance.Implementation,
    module PraTactile.Conformance.Question.Touch,
    library,

    -- * Running all laws
    runLaws,
    runTouchLaws,
    lawProperties,
    lawProperty,
    openingProperty,
    touchProperties,

    -- * Laws
    Law (..),
    laws,
    openingLaws,
    touchLaws,

    -- * Profiles
    defaultProfiles,
    Known,
    known,
  )
where

import PraTactile.Conformance.Definition (Known, known)
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Law (Law (..))
import PraTactile.Conformance.Laws (laws, openingLaws, touchLaws)
import PraTactile.Conformance.Library (library)
import PraTactile.Conformance.Profiles (defaultProfiles)
import PraTactile.Conformance.Properties
import PraTactile.Conformance.Question.Touch
