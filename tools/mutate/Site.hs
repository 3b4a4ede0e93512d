{-# LANGUAGE OverloadedStrings #-}

-- | Sites and mutants as @plant@ lists them, and what became of a mutant.
module Site
  ( Site (..),
    Mutant (..),
    readMutants,
    mutantName,
    mutantsOf,
    Outcome (..),
    noticedIn,
    noticedBy,
    Result (..),
    resultName,
    resultSite,
  )
where

import Data.Aeson hiding (Result)
import qualified Data.ByteString.Char8 as Bytes
import Data.Maybe (mapMaybe)

-- | A place in the sources where mistakes are planted.
data Site = Site
  { -- | Made of the module's and the site's name, so that it stays while others change.
    siteNumber :: Int,
    siteModule :: String,
    siteFile :: FilePath,
    siteLine :: Int,
    siteColumn :: Int,
    siteKind :: String,
    -- | The definition it is in, the kind, and which site of that kind it is there.
    siteName :: String,
    siteVariants :: [String],
    -- | A digest of the file.
    siteSource :: String
  }

instance FromJSON Site where
  parseJSON = withObject "site" $ \o ->
    Site
      <$> o .: "site"
      <*> o .: "module"
      <*> o .: "file"
      <*> o .: "line"
      <*> o .: "column"
      <*> o .: "kind"
      <*> o .: "name"
      <*> o .: "variants"
      <*> o .: "source"

-- | A mistake: a site, and which of its variants, from 1.
data Mutant = Mutant
  { mutantSite :: Site,
    mutantVariant :: Int,
    -- | Whether it is of the sample, and not of a module that is tried as a whole.
    mutantDrawn :: Bool
  }

instance ToJSON Mutant where
  toJSON = Object . mutantKeys

mutantKeys :: Mutant -> Object
mutantKeys (Mutant site variant drawn) =
  "site" .= siteNumber site
    <> "module" .= siteModule site
    <> "file" .= siteFile site
    <> "line" .= siteLine site
    <> "column" .= siteColumn site
    <> "kind" .= siteKind site
    <> "name" .= siteName site
    <> "variants" .= siteVariants site
    <> "source" .= siteSource site
    <> "variant" .= variant
    <> "drawn" .= drawn

instance FromJSON Mutant where
  parseJSON = withObject "mutant" $ \o ->
    Mutant <$> parseJSON (Object o) <*> o .: "variant" <*> o .:? "drawn" .!= True

-- | The mutants of a file, one JSON object a line.
readMutants :: FilePath -> IO [Mutant]
readMutants file = mapMaybe decodeStrict . Bytes.lines <$> Bytes.readFile file

-- | A name that stays while other definitions change.
mutantName :: Mutant -> String
mutantName (Mutant site variant _) =
  unwords [siteModule site, siteName site ++ ":", siteVariants site !! (variant - 1)]

mutantsOf :: Site -> [Mutant]
mutantsOf site = [Mutant site i True | i <- [1 .. length (siteVariants site)]]

-- | What became of a mutant.
data Outcome
  = -- | An example failed, or the tests crashed: the example's path.
    Killed String
  | -- | The tests took too long: those of this group.
    TimedOut String
  | Survived
  | -- | No test comes to the site.
    Unreached
  | -- | Where tests come to the site the value is always the same as without the mistake.
    Unfelt
  | -- | Not noticed by what was tried, and not all was.
    Open
  deriving stock (Eq, Show)

-- | The example that failed, or the group that took too long.
noticedIn :: Outcome -> [String]
noticedIn outcome = case outcome of
  Killed example -> [example]
  TimedOut group -> [group]
  Survived -> []
  Unreached -> []
  Unfelt -> []
  Open -> []

noticedBy :: Outcome -> Bool
noticedBy = not . null . noticedIn

-- | A mutant, and what became of it.
data Result = Result
  { resultMutant :: Mutant,
    resultOutcome :: Outcome,
    -- | The groups of examples that did not notice it, by their keys.
    resultTried :: [String],
    -- | Seconds of processor time that these take without a mistake.
    resultSpent :: Double,
    -- | A digest of the names of all examples that there were.
    resultSuite :: String,
    -- | Seconds by the clock.
    resultTook :: Double
  }

-- | The name of the mutant, by which a result is found again.
resultName :: Result -> String
resultName = mutantName . resultMutant

resultSite :: Result -> Site
resultSite = mutantSite . resultMutant

instance ToJSON Result where
  toJSON r =
    Object $
      mutantKeys (resultMutant r)
        <> "mutant" .= resultName r
        <> "tried" .= resultTried r
        <> "spent" .= resultSpent r
        <> "suite" .= resultSuite r
        <> "outcome" .= (name :: String)
        <> "by" .= by
        <> "seconds" .= resultTook r
    where
      (name, by) = case resultOutcome r of
        Killed example -> ("killed", Just example)
        TimedOut group -> ("timeout", Just group)
        Survived -> ("survived", Nothing)
        Unreached -> ("unreached", Nothing)
        Unfelt -> ("unfelt", Nothing)
        Open -> ("open", Nothing)

instance FromJSON Result where
  parseJSON value = flip (withObject "result") value $ \o -> do
    name <- o .: "outcome"
    by <- o .: "by"
    outcome <- case (name :: String, by) of
      ("killed", Just example) -> pure (Killed example)
      ("timeout", Just group) -> pure (TimedOut group)
      ("survived", Nothing) -> pure Survived
      ("unreached", Nothing) -> pure Unreached
      ("unfelt", Nothing) -> pure Unfelt
      ("open", Nothing) -> pure Open
      _ -> fail "no such outcome"
    Result
      <$> parseJSON value
      <*> pure outcome
      <*> o .:? "tried" .!= []
      <*> o .:? "spent" .!= 0
      <*> o .:? "suite" .!= ""
      <*> o .: "seconds"
