{-# LANGUAGE OverloadedStrings #-}

-- | Tests what is reported of implementations that fail as properties, that throw, or that start
-- wrongly; and which answers in another form are equal.
module Test.Conformance.Properties (spec) where

import Control.Exception (AsyncException (..), throwIO)
import Control.Monad.IO.Class (liftIO)
import Control.Monad.Trans.Except (runExceptT)
import Data.Aeson (encode, object, (.=))
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.Foldable (for_)
import Data.List (isPrefixOf)
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Conformance
import PraTactile.Conformance.Definition
import PraTactile.Conformance.Impostors
import PraTactile.Conformance.InProcess (inProcess)
import PraTactile.Conformance.Law (codeStages, touchStages)
import PraTactile.Conformance.Process.Reply
import PraTactile.Conformance.Properties (lawsReported)
import PraTactile.Conformance.Report
import PraTactile.Conformance.Run
import PraTactile.Conformance.Suite (noSuiteText, standardSuite)
import PraTactile.Profile (Profile (..))
import System.Exit (ExitCode (..))
import Test.Hspec
import Test.QuickCheck
import qualified Test.QuickCheck as QuickCheck
import Test.QuickCheck.Random (mkQCGen)

spec :: Spec
spec = do
  it "a property that fails shows what was asked, answered and expected, and why" $ do
    [one] <- pure [one | one <- impostors, impostorName one == "keeps-the-second-summand"]
    -- The first profile only: the definition takes time to prepare them all.
    law : _ <- pure [p | (name, p) <- lawProperties (impostorMade one), ofAddition name]
    came <- quickCheckWithResult sameCases law
    let said = lines (output came)
        beginnings =
          ["asked           add {", "yours           ", "expected        ", "by              "]
            ++ ["because         "]
    [length (filter (beginning `isPrefixOf`) said) | beginning <- beginnings]
      `shouldBe` [1, 1, 1, 1, 1]
    right : _ <- pure [p | (name, p) <- lawProperties library, ofAddition name]
    held <- quickCheckWithResult sameCases right
    isSuccess held `shouldBe` True
  it "an exception of an implementation is its fault; one thrown at it from outside is not" $ do
    suite <- either (fail . noSuiteText) pure (standardSuite (take 1 defaultProfiles))
    let throwing problem = library {open = \_ -> liftIO (throwIO problem)}
        settings = standardSettings {settingRun = ["field/addition-commutes"]}
        run implementation = do
          subject <- inProcess implementation
          report <- runSuite settings suite (const (pure ())) [subject]
          pure [lawReportOutcome one | one <- reportLaws report, lawReportOutcome one /= Skipped]
    run (throwing (userError "broken")) `shouldReturn` [Errored]
    run (library {open = \_ -> liftIO (throwIO UserInterrupt)}) `shouldThrow` (== UserInterrupt)
  it "a process may ask at its start for 1 to 4096 requests at once" $
    map started [0, -3, 1, 64, 4096, 4097]
      `shouldBe` [Nothing, Nothing, Just 1, Just 64, Just 4096, Just 4096]
  it "frames are registered even if they are not square or larger than usual" $
    for_ [(40, 33), (33, 40), (20, 12), (12, 20)] $ \(w, h) -> do
      let relief x y = sin (x * x / 40 + y / 3) + cos (y * y / 37 - x / 2) :: Double
          grey x y = round (30000 + 12000 * relief (fromInteger x) (fromInteger y))
          frame (dx, dy) = [[grey (x + dx) (y + dy) | x <- [1 .. w]] | y <- [1 .. h]]
      let asked = Register :? (Nothing, Pair (frame (0, 0)) (frame (5, 1)) (4, 0) 3)
      found <- runExceptT (answerTo (withoutProfile library) asked)
      let near (x, y) = max (abs (x - 5)) (abs (y - 1)) <= 0.5
      ((w, h), near . registeredBest <$> either (const Nothing) Just found)
        `shouldBe` ((w, h), Just True)
  it "a number of places with its dimension equals the list of these places" $
    for_ [about | (name, p) <- take 1 defaultProfiles, Right about <- [known p], name == "paper"] $
      \about -> do
        -- The rank of a cell is 1, and the degree 4.
        let several = OneOf [Position 0 0, Position 1 2, Position 3 4]
            same = agrees about (Locate :? [[Just 1]])
        map (same several) [several, Coset 3 3, Coset 2 3, Coset 4 3, Coset 3 2]
          `shouldBe` [True, True, False, False, False]
        map (same several) [OneOf [Position 0 0], At (Position 0 0)] `shouldBe` [False, False]
        same (Coset 3 3) (Coset 3 3) `shouldBe` True
  it "probabilities agree within 10^-9, left out means 0; positions are distinct and in the array" $
    for_ [about | (_, p) <- take 1 defaultProfiles, Right about <- [known p]] $ \about -> do
      let Shape n1 n2 = profileShape (knownProfile about)
          wanted = [(Position 0 0, 0.75), (Position (n1 - 1) (n2 - 1), 0.25)]
          same = agrees about (Posterior :? [[Unfelt]])
      for_ [0, 1e-10, 1e-9, 1.0001e-9, 1e-8] $ \d -> do
        let near = d <= (1e-9 :: Double)
        (d, same wanted ((Position 1 1, d) : wanted)) `shouldBe` (d, near)
        (d, same ((Position 1 1, d) : wanted) wanted) `shouldBe` (d, near)
      map (\d -> same wanted [(at, x + d) | (at, x) <- wanted]) [5e-10, -5e-10, 2e-9, -2e-9]
        `shouldBe` [True, True, False, False]
      same wanted (reverse wanted) `shouldBe` True
      -- A repeated position and one outside the array, whatever their probability.
      same wanted ((Position 0 0, 0.75) : wanted) `shouldBe` False
      for_ [Position n1 0, Position 0 n2, Position n1 n2, Position (n1 + 1) 0] $ \beyond ->
        same wanted ((beyond, 0) : wanted) `shouldBe` False
      for_ [Position (n1 - 1) 0, Position 0 (n2 - 1)] $ \inside ->
        same wanted ((inside, 0) : wanted) `shouldBe` True
  it "one call runs all laws; its status is 0 if certified, 1 if not, 2 without an array" $ do
    let one = [under | under@(name, _) <- defaultProfiles, name == "gf2-3x5"]
        spoilt = [("spoilt", p {profileOrder = 6}) | (_, p) <- one]
        adding = library {offered = [SomeOp Add]}
        status stages profiles = fmap fst . lawsReported stages profiles
    status codeStages one adding `shouldReturn` ExitSuccess
    [wrong] <- pure [i | i <- impostors, impostorName i == "keeps-the-second-summand"]
    status codeStages one (impostorMade wrong) {offered = [SomeOp Add]} `shouldReturn` ExitFailure 1
    status codeStages one (library {offered = []}) `shouldReturn` ExitFailure 1
    status touchStages [] adding `shouldReturn` ExitFailure 1
    lawsReported codeStages (one ++ spoilt) adding
      `shouldReturn` (ExitFailure 2, "spoilt: this profile describes no array\n")
    (_, said) <- lawsReported codeStages one adding
    said `shouldContain` "1 operation of 19 offered, 1 profile, seed 1"
    said `shouldContain` "certified: "
  where
    sameCases = stdArgs {chatty = False, QuickCheck.replay = Just (mkQCGen 1, 0)}
    ofAddition = (== "field/addition-as-defined, paper")
    line = Lazy.toStrict . encode
    started :: Integer -> Maybe Int
    started given =
      either (const Nothing) (Just . startedInFlight) . readStarted . line $
        object
          [ "protocol" .= (1 :: Int),
            "name" .= ("one" :: String),
            "operations" .= (["add"] :: [String]),
            "in_flight" .= given
          ]
