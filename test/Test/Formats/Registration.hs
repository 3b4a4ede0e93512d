{-# LANGUAGE OverloadedStrings #-}

-- | The JSON of registrations of pairs, of answers made by hand.
module Test.Formats.Registration (spec) where

import Data.Aeson (Value, decodeStrict, object, (.=))
import Data.Foldable (for_)
import PraTactile.Format.Registration
import PraTactile.Stitch.Pair
import Test.Hspec

spec :: Spec
spec = do
  it "a pair: the shift where it is given, the reason where it is refused, the best always" $
    for_ ((Nothing, Nothing) : [(Just r, Just name) | (r, name) <- reasons]) $ \(refusal, name) ->
      decodeStrict (encodeMatch (match refusal (True, True)))
        `shouldBe` Just (expected name ["x", "y"])
  it "a pair: which axes are fixed" $
    for_
      [ ((False, False), []),
        ((True, False), ["x"]),
        ((False, True), ["y"]),
        ((True, True), ["x", "y"])
      ]
      $ \(fixed, axes) ->
        decodeStrict (encodeMatch (match (Just OneAxis) fixed))
          `shouldBe` Just (expected (Just "one-axis") axes)
  it "groups of frames, by their indices, each ascending" $ do
    groupsOf [] `shouldBe` []
    groupsOf [0, 0, 1, 0, 2, 1] `shouldBe` [[0, 1, 3], [2, 5], [4]]
    groupsOf [1, 0] `shouldBe` [[1], [0]]

reasons :: [(Refusal, String)]
reasons =
  [(Blank, "blank"), (OneAxis, "one-axis"), (Ambiguous, "ambiguous"), (NoOverlap, "no-overlap")]

match :: Maybe Refusal -> (Bool, Bool) -> Match
match refusal fixed =
  Match
    { matchRefusal = refusal,
      matchBest = Hypothesis (7.5, -0.25) 0.875,
      matchDeviations = (0.5, 0.125),
      matchFixed = fixed,
      matchMethod = Lattice,
      matchHypotheses = [Hypothesis (7.5, -0.25) 0.875, Hypothesis (1, 2) 0.125]
    }

expected :: Maybe String -> [String] -> Value
expected reason axes =
  object
    [ "schema" .= text "pra-tactile/register/1",
      "outcome" .= text (maybe "registered" (const "refused") reason),
      "reason" .= reason,
      "shift" .= maybe (Just best) (const Nothing) reason,
      "best" .= best,
      "probability" .= (0.875 :: Double),
      "sd" .= [0.5, 0.125 :: Double],
      "axes" .= axes,
      "rotation_deg" .= (Nothing :: Maybe Double),
      "method" .= text "lattice",
      "hypotheses"
        .= [ object ["shift" .= best, "probability" .= (0.875 :: Double)],
             object ["shift" .= [1, 2 :: Double], "probability" .= (0.125 :: Double)]
           ]
    ]
  where
    text = id :: String -> String
    best = [7.5, -0.25] :: [Double]
