{-# LANGUAGE OverloadedStrings #-}

-- | Poses as scripts use them: where the robot's frame lies in the world, and symbols of other
-- sizes.
module Test.CommandLine.Pose (spec) where

import Data.Aeson
import Data.Foldable (for_)
import Test.CommandLine.Run
import Test.Hspec
import Test.Support

spec :: Spec
spec = do
  describe "an invalid plane is refused" $
    for_
      [ ("a rotation that is not orthogonal", plane "[[1,0.1,0],[0,1,0],[0,0,1]]", "rotation"),
        ("one that mirrors", plane "[[1,0,0],[0,1,0],[0,0,-1]]", "rotation"),
        ("one that stretches", plane "[[2,0,0],[0,1,0],[0,0,0.5]]", "rotation"),
        ("no numbers", plane "[[NaN,0,0],[0,1,0],[0,0,1]]", "JSON"),
        ("too large a number", plane "[[1e999,0,0],[0,1,0],[0,0,1]]", "rotation"),
        ("two rows", plane "[[1,0,0],[0,1,0]]", "rotation"),
        ("another schema", as "truth" unturned ",\"translation_mm\":[0,0,0]}", "truth/1"),
        ("no translation", as "plane" unturned "}", "translation_mm")
      ]
      $ \(name, text, about) ->
        it name . inFolder $ \folder -> do
          writeFile (folder ++ "/plane.json") text
          outcome <-
            pra
              [ "decode",
                "--json",
                "--plane",
                folder ++ "/plane.json",
                "data/worked-example/frames"
              ]
          outcome `refuses` about
  it "compare brings the truth to the world in which the answer is" $
    inFolder $ \folder -> do
      writeFile (folder ++ "/plane.json") (plane "[[0,0.6,0.8],[-1,0,0],[0,-0.8,0.6]]")
      (status, out, err) <-
        scripted
          folder
          "pra probe --object cube --seed 7 --turn 20 --output f --truth t > log; \
          \pra decode --json f > a; pra decode --json --plane plane.json f > b; \
          \pra compare a t --json; pra compare b t --json >&2"
      status `shouldBe` 0
      for_ ["pose_mm", "pose_deg"] $ \of' -> do
        robot <- number (key [of'] out)
        world <- number (key [of'] err)
        abs (robot - world) `shouldSatisfy` (< 1e-6)
        robot `shouldSatisfy` (> 0)
  -- A face had no pose where it is begun at another vertex than in the object's own list.
  it "of faces begun at any vertex decode has the pose, and it is the one that was pressed" $
    inFolder $ \folder -> do
      (status, out, _) <-
        scripted
          folder
          "pra place box:60x80x50 prism:6,40,60 --symbols 1/2 --face 'box:V7 V3 V2 V6' \
          \--face 'prism:V10 V11 V5 V4' --upright --output p.json > log; \
          \for f in 'box V3 V2 V6 V7' 'prism V4 V10 V11 V5'; do \
          \pra probe --placement p.json --object ${f%% *} --face \"${f#* }\" --taxel 0.79375 \
          \--sensor ideal --seed 5 --upright --output f --truth t > log; \
          \pra decode --placement p.json --json f > a; \
          \pra compare --placement p.json a t --json; rm -r f; done"
      status `shouldBe` 0
      length (lines out) `shouldBe` 2
      for_ (lines out) $ \line -> do
        far <- number (key ["pose_mm"] line)
        degrees <- number (key ["pose_deg"] line)
        (far, degrees) `shouldSatisfy` \(a, b) -> a < 0.05 && b < 0.05
  for_ [("1/2", 0.5, "box:90x90x90"), ("2", 2, "box:400x400x60")] $ \(size, larger, object') ->
    it ("of symbols " ++ size ++ " times as large it is as exact, for their size") $
      inFolder $ \folder -> do
        (status, out, _) <-
          scripted folder $
            "pra place b=" ++ object' ++ " --symbols " ++ size ++ " --output p.json > log; "
              ++ "pra probe --placement p.json --object b --face 'V1 V2 V3 V4' --taxel "
              ++ show (1.5875 * larger :: Double)
              ++ " --sensor ideal --seed 3 --turn 33 --origin 70,-20 --output f --truth t > log; "
              ++ "pra decode --placement p.json --json f > a; "
              ++ "pra compare --placement p.json a t --json"
        status `shouldBe` 0
        far <- number (key ["pose_mm"] out)
        degrees <- number (key ["pose_deg"] out)
        (far / larger, degrees) `shouldSatisfy` \(a, b) -> a < 0.05 && b < 0.05
  where
    unturned = "[[1,0,0],[0,1,0],[0,0,1]]"
    plane rotation = as "plane" rotation ",\"translation_mm\":[400,250,75]}"
    as form rotation rest =
      "{\"schema\":\"pra-tactile/" ++ form ++ "/1\",\"rotation\":" ++ rotation ++ rest
    number value = case value of
      Just (Number n) -> pure (realToFrac n :: Double)
      other -> fail (show other)
