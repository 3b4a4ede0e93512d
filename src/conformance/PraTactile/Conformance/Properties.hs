-- | Laws for tests in Haskell: all laws in one call that prints a report, or each law as a
-- QuickCheck property.
module PraTactile.Conformance.Properties
  ( runLaws,
    runLawsUnder,
    runLawsWithoutProfile,
    lawsReported,
    lawProperties,
    lawProperty,
    openingProperty,
    propertiesWithoutProfile,
  )
where

import Control.Monad.Trans.Except (runExceptT)
import PraTactile.Conformance.Definition (known)
import PraTactile.Conformance.Direct
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.InProcess (inProcess)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws (laws, lawsWithoutProfile, openingLaws)
import PraTactile.Conformance.Operations (nameOf)
import PraTactile.Conformance.Profiles (defaultProfiles)
import PraTactile.Conformance.Question
import PraTactile.Conformance.Report (certified)
import PraTactile.Conformance.Report.Words (reportText, responseText, valueText)
import PraTactile.Conformance.Run (Settings (..), runSuite, standardSettings)
import PraTactile.Conformance.Subject (responseOf)
import PraTactile.Conformance.Suite (noSuiteText, standardSuite)
import PraTactile.Format.Json.Codec (writeValue)
import PraTactile.Profile (Profile)
import System.Exit (ExitCode (..))
import Test.QuickCheck

-- | Tries all laws of the code, of opening and of sessions under the default profiles, and prints
-- the report. It has names and counts, and for each failed law the smallest case with your answer
-- and the definition's. The exit status is 0 if the implementation is certified, otherwise 1.
runLaws :: Implementation -> IO ExitCode
runLaws = runLawsUnder defaultProfiles

-- | 'runLaws' under other profiles, given by name. The exit status is 2 for a profile that
-- describes no array or one too large for the definition.
runLawsUnder :: [(String, Profile)] -> Implementation -> IO ExitCode
runLawsUnder = runStages codeStages

-- | 'runLaws' for some of the stages of touch and of objects, which need no profile.
runLawsWithoutProfile :: [Stage] -> Implementation -> IO ExitCode
runLawsWithoutProfile stages = runStages stages []

runStages :: [Stage] -> [(String, Profile)] -> Implementation -> IO ExitCode
runStages stages profiles implementation = do
  (status, said) <- lawsReported stages profiles implementation
  status <$ putStr said

-- | The exit status and the printed report of the laws of these stages.
lawsReported :: [Stage] -> [(String, Profile)] -> Implementation -> IO (ExitCode, String)
lawsReported stages profiles implementation = case standardSuite profiles of
  Left why -> pure (ExitFailure 2, noSuiteText why ++ "\n")
  Right suite -> do
    subject <- inProcess implementation
    report <-
      runSuite standardSettings {settingStages = stages} suite (const (pure ())) [subject]
    pure
      ( if certified report then ExitSuccess else ExitFailure 1,
        reportText (const "runLaws") report
      )

-- | The laws of the code whose operations an implementation offers, under the default profiles, as
-- properties. Each is named by its id and the profile's name.
lawProperties :: Implementation -> [(String, Property)]
lawProperties implementation =
  [ (lawId law, openingProperty (map snd defaultProfiles) law implementation)
    | law <- openingLaws,
      all (`elem` offered implementation) (lawNeeds law)
  ]
    ++ [ (lawId law ++ ", " ++ name, underProfile about p law)
         | (name, p) <- defaultProfiles,
           Right about <- [known p],
           law <- laws,
           all (`elem` offered implementation) (lawNeeds law)
       ]
  where
    underProfile about p law = idempotentIOProperty $ do
      opened <- runExceptT (open implementation p)
      pure $ case opened of
        Left why -> counterexample ("the profile was refused: " ++ refusalReason why) False
        Right session -> lawProperty law about session

-- | The laws of touch and of objects whose operations an implementation offers, as properties
-- named by their ids.
propertiesWithoutProfile :: Implementation -> [(String, Property)]
propertiesWithoutProfile implementation =
  [ (lawId law, lawProperty law () (withoutProfile implementation))
    | law <- lawsWithoutProfile,
      all (`elem` offered implementation) (lawNeeds law)
  ]

-- | A law as a property of a session. The law's subject is the session's profile, or @()@.
lawProperty :: Law about -> about -> Session -> Property
lawProperty law about opened = casesProperty (sessionRespondent opened) (lawCases law about)

-- | A law of opening, with these profiles, as a property of an implementation.
openingProperty :: [Profile] -> Law [Profile] -> Implementation -> Property
openingProperty profiles law implementation =
  idempotentIOProperty $
    (`casesProperty` lawCases law profiles) <$> openingRespondent implementation

casesProperty :: Respondent -> Cases -> Property
casesProperty answers (Cases form domain trial) = case domain of
  Every cases ->
    once . idempotentIOProperty $
      maybe (property True) (judged . Violated . snd)
        <$> firstViolated answers maxBound (map trial cases)
  Some draw smaller ->
    forAllShrinkShow
      draw
      smaller
      (valueText . writeValue form)
      (idempotentIOProperty . fmap judged . verdictBy answers . trial)

-- | A case to which the law does not apply counts as held.
judged :: Verdict -> Property
judged got = case got of
  Holds -> property True
  Inapplicable -> property True
  Violated violation -> counterexample (inWords violation) False

-- | The questions and answers, and the expected answer.
inWords :: Violation -> String
inWords violation =
  unlines $
    concat
      [ [asked exchange, "yours           " ++ replied (exchangeReply exchange)]
        | exchange <- violationAsked violation
      ]
      ++ ["expected        " ++ replied (violationExpected violation)]
      ++ ["by              " ++ violationRoad violation]
      ++ ["because         " ++ violationReason violation]
  where
    asked (Exchange operation input _) =
      "asked           " ++ maybe "profile" nameOf operation ++ " " ++ valueText input
    replied = responseText . responseOf
