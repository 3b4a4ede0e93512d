{-# LANGUAGE OverloadedStrings #-}

-- | What is said and done of implementations that fail: by properties, where they throw, where they
-- start wrongly; and which answers of another form are the same.
module Test.Conformance.Failures (spec) where

import Control.Exception (AsyncException (..), throwIO)
import Control.Monad.IO.Class (liftIO)
import Control.Monad.Trans.Except (runExceptT)
import Data.Aeson (encode, object, (.=))
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.Foldable (for_)
import Data.List (isPrefixOf)
import PraTactile.Array (Position (..))
import PraTactile.Conformance
import PraTactile.Conformance.Definition
import PraTactile.Conformance.Impostors
import PraTactile.Conformance.InProcess (inProcess)
import PraTactile.Conformance.Process.Reply
import PraTactile.Conformance.Question
import PraTactile.Conformance.Report
import PraTactile.Conformance.Run
import PraTactile.Conformance.Suite (standardSuite)
import Test.Hspec
import Test.QuickCheck

spec :: Spec
spec = do
  it "a property that fails says what was asked and answered, what should have been, and why" $ do
    [one] <- pure [one | one <- impostors, impostorName one == "keeps-the-second-summand"]
    [law] <- pure [p | (name, p) <- lawProperties (impostorMake one library), ofAddition name]
    came <- quickCheckWithResult stdArgs {chatty = False} law
    let said = lines (output came)
        beginnings =
          ["asked           add {", "yours           ", "expected        ", "by              "]
            ++ ["because         "]
    [length (filter (beginning `isPrefixOf`) said) | beginning <- beginnings]
      `shouldBe` [1, 1, 1, 1, 1]
    [right] <- pure [p | (name, p) <- lawProperties library, ofAddition name]
    held <- quickCheckWithResult stdArgs {chatty = False} right
    isSuccess held `shouldBe` True
  it "what an implementation throws is its fault, and what others throw at it is not" $ do
    suite <- either fail pure (standardSuite (take 1 defaultProfiles))
    let throwing problem = library {open = \_ -> liftIO (throwIO problem)}
        settings = standardSettings {settingRun = ["field/addition-commutes"]}
        run implementation = do
          subject <- inProcess implementation
          report <- runSuite settings suite (const (pure ())) [subject]
          pure [lawReportOutcome one | one <- reportLaws report, lawReportOutcome one /= Skipped]
    run (throwing (userError "broken")) `shouldReturn` [Errored]
    run (library {open = \_ -> liftIO (throwIO UserInterrupt)}) `shouldThrow` (== UserInterrupt)
  it "to start, a process may be asked 1 to 4096 things at once" $
    map started [0, -3, 1, 64, 4096, 4097]
      `shouldBe` [Nothing, Nothing, Just 1, Just 64, Just 4096, Just 4096]
  it "frames that are not square are registered, those larger than usual too" $
    for_ [(40, 33), (33, 40), (20, 12), (12, 20)] $ \(w, h) -> do
      let relief x y = sin (x * x / 40 + y / 3) + cos (y * y / 37 - x / 2) :: Double
          grey x y = round (30000 + 12000 * relief (fromInteger x) (fromInteger y))
          frame (dx, dy) = [[grey (x + dx) (y + dy) | x <- [1 .. w]] | y <- [1 .. h]]
      found <- runExceptT (register (touch library) (Pair (frame (0, 0)) (frame (5, 1)) (4, 0) 3))
      let near (x, y) = max (abs (x - 5)) (abs (y - 1)) <= 0.5
      ((w, h), near . registeredBest <$> either (const Nothing) Just found)
        `shouldBe` ((w, h), Just True)
  it "several places told by their number and dimension are the same places" $
    for_ [about | (name, p) <- take 1 defaultProfiles, Right about <- [known p], name == "paper"] $
      \about -> do
        let several = OneOf [Position 0 0, Position 1 2, Position 3 4]
            same = agrees about (Locate [[Nothing]]) several
        map same [several, Coset 3 1, Coset 2 1, Coset 4 1] `shouldBe` [True, True, False, False]
        map same [OneOf [Position 0 0], At (Position 0 0)] `shouldBe` [False, False]
        agrees about (Locate [[Nothing]]) (Coset 3 1) (Coset 3 1) `shouldBe` True
  where
    ofAddition = (== "field/addition-as-defined, gf3-2x13")
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
