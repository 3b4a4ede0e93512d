-- | The version of the suite itself, whatever the version of the program that has it. A law added
-- raises the second number; a law that is gone or changed, or what it expects, the first; words,
-- the third. @data/suite.json@ lists the laws, and the ids of laws that are gone, which are never
-- used again.
module PraTactile.Conformance.Version
  ( suiteVersion,
    vectorsVersion,
  )
where

-- | The version that reports and lists of laws state.
suiteVersion :: String
suiteVersion = "3.0.0"

-- | The version of the suite that last changed a test vector, which files of vectors state.
vectorsVersion :: String
vectorsVersion = "2.0.0"
