-- | The version of the suite, independent of the program's. A new law raises the second number; a
-- law that is removed, or whose expectation changes, raises the first; a change of words raises the
-- third. @data/suite.json@ lists the laws, and the ids of removed laws, which are never reused.
module PraTactile.Conformance.Version
  ( suiteVersion,
    vectorsVersion,
  )
where

-- | The version that reports and lists of laws state.
suiteVersion :: String
suiteVersion = "3.0.0"

-- | The suite's version that last changed a test vector; files of vectors state it.
vectorsVersion :: String
vectorsVersion = "2.0.0"
