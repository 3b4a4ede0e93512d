-- | The conformance suite: what every implementation of the code must do, as data. A law has an id
-- and cases; what it expects is what the definition says under the profile. To put your own
-- implementation under it, write one function from every 'Question' to its answer, 'notOffered' for
-- those that it lacks, and say what it offers:
--
-- > yours :: Implementation
-- > yours =
-- >   Implementation
-- >     { implementationName = "yours",
-- >       offered = [SomeOp Add, SomeOp Cell],
-- >       open = \profile -> pure (answering (answers profile)),
-- >       withoutProfile = answering (const notOffered)
-- >     }
-- >
-- > answers :: Profile -> Question a -> Wire a
-- > answers profile question = case question of
-- >   Add :? (a, b) -> pure (yourSum a b)
-- >   Cell :? Position row column -> pure (yourCell profile row column)
-- >   _ -> notOffered
--
-- Then run
--
-- > runLaws yours >>= exitWith
--
-- or, in a test suite, 'lawProperties', each of them a property of QuickCheck:
--
-- > for_ (lawProperties yours) (\(name, property) -> prop name property)
--
-- The stages of touch, registration to the network, and of objects have laws of their own,
-- 'runLawsWithoutProfile' and 'propertiesWithoutProfile'. The project's own test suite runs all of
-- them on this library.
module PraTactile.Conformance
  ( -- * Implementations under test
    module PraTactile.Conformance.Implementation,
    module PraTactile.Conformance.Question,
    allOperations,
    nameOf,
    operationOf,
    library,

    -- * Running all laws
    runLaws,
    runLawsWithoutProfile,
    lawProperties,
    lawProperty,
    openingProperty,
    propertiesWithoutProfile,

    -- * Laws
    Law (..),
    laws,
    openingLaws,
    lawsWithoutProfile,

    -- * Profiles
    defaultProfiles,
    Known,
    known,
  )
where

import PraTactile.Conformance.Definition (Known, known)
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Law (Law (..))
import PraTactile.Conformance.Laws (laws, lawsWithoutProfile, openingLaws)
import PraTactile.Conformance.Library (library)
import PraTactile.Conformance.Operations (allOperations, nameOf, operationOf)
import PraTactile.Conformance.Profiles (defaultProfiles)
import PraTactile.Conformance.Properties
import PraTactile.Conformance.Question
