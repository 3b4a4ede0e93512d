-- | The conformance suite: the laws that every implementation of the code must obey. A law has an
-- id and cases; the expected answers come from the definition under a profile. To test your own
-- implementation, write one function from every 'Question' to its answer ('notOffered' for
-- operations that you lack), and list the operations that you offer:
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
-- or use 'lawProperties' in a test suite; each is a QuickCheck property:
--
-- > for_ (lawProperties yours) (\(name, property) -> prop name property)
--
-- The stages of touch (from registration to the network) and of objects need no profile; use
-- 'runLawsWithoutProfile' and 'propertiesWithoutProfile'. The project's own test suite runs all
-- laws on this library.
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
    ProfileFacts,
    known,
  )
where

import PraTactile.Conformance.Definition (ProfileFacts, known)
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Law (Law (..))
import PraTactile.Conformance.Laws (laws, lawsWithoutProfile, openingLaws)
import PraTactile.Conformance.Library (library)
import PraTactile.Conformance.Operations (allOperations, nameOf, operationOf)
import PraTactile.Conformance.Profiles (defaultProfiles)
import PraTactile.Conformance.Properties
import PraTactile.Conformance.Question
