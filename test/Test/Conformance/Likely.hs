{-# LANGUAGE GADTs #-}
{-# LANGUAGE RankNTypes #-}

-- | The likely cause of a failure: whoever errs as an impostor does is told so, and whoever errs
-- otherwise is told nothing.
module Test.Conformance.Likely (spec) where

import Data.Foldable (for_)
import Data.Maybe (mapMaybe)
import qualified Data.Set as Set
import PraTactile.Array (Position (..))
import PraTactile.Conformance
import PraTactile.Conformance.Impostors
import PraTactile.Conformance.InProcess (inProcess)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Likely (likely)
import PraTactile.Conformance.Report
import PraTactile.Conformance.Run
import PraTactile.Conformance.Suite (noSuiteText, standardSuite)
import PraTactile.Conformance.Wire (answerValue, questionInput)
import PraTactile.Profile (Profile)
import Test.Hspec

spec :: Spec
spec = do
  for_ named $ \(name, law) -> it ("of an impostor it is that one: " ++ name) $ do
    Just one <- pure (impostorNamed name)
    causes [law] (impostorMade one) `shouldReturn` [name]
  for_ strangers $ \(name, laws', wrong) ->
    it ("of what errs as no impostor there is none: " ++ name) $
      causes laws' wrong `shouldReturn` []
  for_ [(1e-13 :: Double, ["leaves-out-biases"]), (1e-6, [])] $ \(by, cause) ->
    it ("of answers that part from an impostor's by " ++ show by ++ " it is " ++ show cause) $ do
      Just one <- pure (impostorNamed "leaves-out-biases")
      let right :: Question a -> Wire a
          right = answerTo (withoutProfile (impostorMade one))
          off :: Question a -> Wire a
          off question = case question of
            Outputs _ _ -> map (+ by) <$> right question
            _ -> right question
      causes ["network/outputs-as-defined"] (impostorMade one) {withoutProfile = answering off}
        `shouldReturn` cause
  it "is told of three failing cases that agree, not of two, and not if one differs" $ do
    let (first', second, third) = (agreeing 2, agreeing 3, agreeing 4)
        agreeing rows' =
          exchanged (replicate rows' (replicate 4 0)) [Symbol (0, fromIntegral rows' / 2) 0]
        differing = exchanged (replicate 5 (replicate 4 0)) [Symbol (1, 1) 0]
    likely Nothing [first', second, third] `shouldReturn` Just "sees-a-symbol-in-nothing"
    likely Nothing [first', second] `shouldReturn` Nothing
    likely Nothing [first', second, second] `shouldReturn` Nothing
    likely Nothing [first', second, third, differing] `shouldReturn` Nothing
  it "is none on arrays of more than 300 cells, or over fields of more than 100 elements" $ do
    Just one <- pure (impostorNamed "keeps-the-second-summand")
    causesUnder "gf9-80x1" one >>= (`shouldSatisfy` not . null)
    for_ ["gf4-63x65", "gf243-2x121"] $ \profile -> causesUnder profile one `shouldReturn` []
  where
    exchanged rows' symbols =
      [ Exchange
          (Just OfSegment)
          (questionInput (Segment rows'))
          (Result (answerValue (Segment rows') symbols))
      ]
    causesUnder profile one =
      causesIn
        [under' | under'@(name, _) <- defaultProfiles, name == profile]
        ["field/addition-as-defined"]
        (impostorMade one)

-- | Impostors, and a law that finds each.
named :: [(String, String)]
named =
  [ ("keeps-the-second-summand", "field/addition-as-defined"),
    ("adds-modulo-q", "field/addition-as-defined"),
    ("transposes-the-fold", "array/cell-as-defined"),
    ("packs-in-the-other-order", "window/pack-as-defined"),
    ("counts-places-from-one", "locate/every-window"),
    ("takes-no-radius-for-none", "damage/guaranteed-radius"),
    ("reads-images-by-columns", "network/outputs-as-defined"),
    ("reads-weights-by-columns", "network/outputs-as-defined"),
    ("takes-the-bias-first", "network/outputs-as-defined"),
    ("takes-tanh-for-the-logistic", "network/outputs-as-defined")
  ]

-- | Implementations that are wrong in another way than each impostor, and laws that find them.
strangers :: [(String, [String], Implementation)]
strangers =
  [ ( "one too many of each sum",
      ["field/"],
      wrongly $ \right question -> case question of
        Add a b -> right (Add a b) >>= \c -> right (Add c 1)
        _ -> right question
    ),
    ( "the element for its inverse",
      ["field/"],
      wrongly $ \right question -> case question of
        Inverse a -> right (Inverse a) >> pure a
        _ -> right question
    ),
    ( "a power too many",
      ["field/"],
      wrongly $ \right question -> case question of
        Power a i -> right (Power a (i + 1))
        _ -> right question
    ),
    ( "terms that begin with s(2)",
      ["sequence/"],
      wrongly $ \right question -> case question of
        Term i -> right (Term (i + 2))
        Terms i count -> right (Terms (i + 2) count)
        _ -> right question
    ),
    ( "the next cell",
      ["array/"],
      wrongly $ \right question -> case question of
        Cell r c -> right (Cell r (c + 1))
        _ -> right question
    ),
    ( "packed without the last cell",
      ["window/"],
      wrongly $ \right question -> case question of
        Pack codes -> right (Pack (take (length codes - 1) codes ++ [0]))
        _ -> right question
    ),
    ( "a window too many",
      ["proof/"],
      wrongly $ \right question -> case question of
        Prove mask -> do
          proof <- right (Prove mask)
          pure proof {proofWindows = proofWindows proof + 1}
        _ -> right question
    ),
    ( "rows for columns",
      ["locate/", "damage/"],
      wrongly $ \right question -> case question of
        Locate patch -> exchange <$> right (Locate patch)
        Nearest radius patch -> exchange <$> right (Nearest radius patch)
        _ -> right question
    ),
    ( "half of each probability",
      ["chances/"],
      wrongly $ \right question -> case question of
        Posterior cells -> map (fmap (/ 2)) <$> right (Posterior cells)
        _ -> right question
    )
  ]
  where
    exchange place = case place of
      At (Position r c) -> At (Position c r)
      OneOf several -> OneOf [Position c r | Position r c <- several]
      Coset count dimension -> Coset count dimension

-- | The library with some answers otherwise.
wrongly ::
  (forall a. (forall b. Question b -> Wire b) -> Question a -> Wire a) -> Implementation
wrongly edit = library {open = fmap edited . open library}
  where
    edited right = answering (edit (answerTo right))

-- | What is named as a cause where the laws of these names fail, which some do.
causes :: [String] -> Implementation -> IO [String]
causes = causesIn [under' | under'@(name, _) <- defaultProfiles, name `elem` ["paper", "gf3-2x13"]]

causesIn :: [(String, Profile)] -> [String] -> Implementation -> IO [String]
causesIn profiles names wrong = do
  suite <- either (fail . noSuiteText) pure (standardSuite profiles)
  subject <- inProcess wrong
  let settings = standardSettings {settingStages = [minBound ..], settingRun = names}
  report <- runSuite settings suite (const (pure ())) [subject]
  let failed = [one | one <- reportLaws report, lawReportOutcome one == Failed]
  failed `shouldSatisfy` not . null
  pure (Set.toList (Set.fromList (mapMaybe lawReportLikely failed)))
