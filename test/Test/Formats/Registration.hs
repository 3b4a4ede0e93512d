{-# LANGUAGE OverloadedStrings #-}

-- | Tests the JSON of registrations of pairs and of segmentations, on answers made by hand.
module Test.Formats.Registration (spec) where

import Data.Aeson (Value, decodeStrict, object, (.=))
import Data.Foldable (for_)
import PraTactile.Format.Registration
import PraTactile.Format.Segmentation
import PraTactile.Recognise.Features
import PraTactile.Registration.Pair
import PraTactile.Segmentation.Symbol
import Test.Hspec

spec :: Spec
spec = do
  it "a pair has its shift if registered, the reason if refused, and always its best shift" $
    for_ ((Nothing, Nothing) : [(Just r, Just name) | (r, name) <- reasons]) $ \(refusal, name) ->
      decodeStrict (encodeMatch (match refusal (True, True)))
        `shouldBe` Just (expected name ["x", "y"])
  it "a pair states which axes are fixed" $
    for_
      [ ((False, False), []),
        ((True, False), ["x"]),
        ((False, True), ["y"]),
        ((True, True), ["x", "y"])
      ]
      $ \(fixed, axes) ->
        decodeStrict (encodeMatch (match (Just OneAxis) fixed))
          `shouldBe` Just (expected (Just "one-axis") axes)
  it "groups list the indices of their frames in ascending order" $ do
    groupsOf [] `shouldBe` []
    groupsOf [0, 0, 1, 0, 2, 1] `shouldBe` [[0, 1, 3], [2, 5], [4]]
    groupsOf [1, 0] `shouldBe` [[1], [0]]

  it "a segmentation has symbols with axes and neighbours, parts, and rejects with reasons" $
    decodeStrict
      ( encodeSegmentation
          "f.pgm"
          ( Features
              [Featured (1.5, 2) 30 (Neighbours (Just (1, 0)) Nothing (Just (0, -2)) (Just (3, 4)))]
              [Incomplete (5, 6.5) 0.25]
              [Reject (1, 2, 3, 4) CutOff]
          )
      )
      `shouldBe` Just
        ( object
            [ "schema" .= ("pra-tactile/segment/1" :: String),
              "source" .= ("f.pgm" :: String),
              "symbols"
                .= [ object
                       [ "x" .= (1.5 :: Double),
                         "y" .= (2 :: Double),
                         "axis_deg" .= (30 :: Double),
                         "neighbours"
                           .= object
                             [ "right" .= [1, 0 :: Double],
                               "left" .= (Nothing :: Maybe [Double]),
                               "up" .= [0, -2 :: Double],
                               "down" .= [3, 4 :: Double]
                             ]
                       ]
                   ],
              "parts"
                .= [ object
                       ["x" .= (5 :: Double), "y" .= (6.5 :: Double), "seen" .= (0.25 :: Double)]
                   ],
              "rejects"
                .= [ object
                       ["box" .= [1, 2, 3, 4 :: Double], "reason" .= causeName CutOff]
                   ]
            ]
        )

reasons :: [(PairRefusal, String)]
reasons =
  [(Blank, "blank"), (OneAxis, "one-axis"), (Ambiguous, "ambiguous"), (NoOverlap, "no-overlap")]

match :: Maybe PairRefusal -> (Bool, Bool) -> Match
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
      "method" .= text "lattice",
      "hypotheses"
        .= [ object ["shift" .= best, "probability" .= (0.875 :: Double)],
             object ["shift" .= [1, 2 :: Double], "probability" .= (0.125 :: Double)]
           ]
    ]
  where
    text = id :: String -> String
    best = [7.5, -0.25] :: [Double]
