-- | The version of the suite itself, whatever the version of the program that has it. A law added
-- raises the second number; a law or what it expects changed, the first; words, the third. What the
-- laws are in it stands in @data/suite.json@; the id of a law that is gone is never used again.
module PraTactile.Conformance.Version
  ( suiteVersion,
  )
where

-- | As reports, vectors and lists of laws tell it.
suiteVersion :: String
suiteVersion = "2.0.0"
