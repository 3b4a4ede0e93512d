{-# LANGUAGE OverloadedStrings #-}

-- | Tests hostile inputs. Whatever is put in, there is an answer or a refusal in words, soon and in
-- little memory; and accepted inputs obey the laws. One in a hundred inputs is a run of the
-- program.
module Test.Hostile (spec) where

import Control.Monad (forM_)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Bytes8
import qualified Data.Text as Text
import Data.Text.Encoding (decodeUtf8, encodeUtf8)
import Test.Hostile.Arguments
import Test.Hostile.Judgement
import Test.Hostile.Mutation
import Test.Hostile.Parsers
import Test.Hostile.Processes
import Test.Hostile.Runs
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSize)
import Test.QuickCheck

spec :: Spec
spec = modifyMaxSize (const 60) $ do
  describe "in process" $ do
    forM_ kinds $ \kind -> beforeAll (kindSpecimens kind) $ do
      it (kindName kind ++ ": the specimens are accepted") $ \specimens ->
        once $
          conjoin
            [ counterexample (show bytes) (judgedIn answer .&&. ioProperty (accepted <$> answer))
              | bytes <- specimens,
                let answer = kindJudged kind bytes
            ]
            .&&. not (null specimens)
      it
        ( kindName kind
            ++ ": every input is answered or refused, in words, soon and in little \
               \memory"
        )
        $ \specimens -> withMaxSuccess (shareOf (kindShare kind)) $
          forAllShrinkShow (hostile (length specimens)) lessHostile (shownOf specimens) $
            -- The bytes are made first, so that making them is not measured.
            \given ->
              let bytes = specimenOf specimens given
               in bytes `seq` judgedIn (kindJudged kind bytes)
    it "the help names the commands and their options" $ do
      length commandsOfHelp `shouldSatisfy` (>= 22)
      let seen =
            [ option
              | command <-
                  commandsOfHelp,
                commandName command == "locate",
                option <- commandOptions command,
                optionName option `elem` ["--json", "--q"]
            ]
      seen `shouldMatchList` [Option "--json" Nothing, Option "--q" (Just "Q")]
      let results =
            [ commandArguments command
              | command <- commandsOfHelp,
                commandName command `elem` ["check", "locate"]
            ]
      results `shouldMatchList` [["FILE"], ["PATCH"]]
    it "every argument list is understood or refused in words, soon and in little memory" $
      withMaxSuccess (shareOf 150) $
        forAllShrink
          (argumentList valueFor commandsOfHelp)
          (shrinkList (const []))
          (judgedBy . judgedArguments)
    foundSpec
  describe "as processes" $
    beforeAll readExample $ do
      let runs share drawn =
            withMaxSuccess (max 1 (shareOf share `div` 100)) . forAllBlind drawn $ \run ->
              counterexample (show run) (judgedRun run)
          ending =
            ": the program ends with an answer or a refusal, in words, soon and in little memory"
      forM_ (filter (not . null . kindRuns) kinds) $ \kind ->
        beforeAllWith (\shown -> (,) shown <$> kindSpecimens kind) $
          it (kindName kind ++ ending) (runs (kindShare kind) . uncurry (hostileRun kind))
      it ("arguments" ++ ending) (runs 180 . harmlessRun)
  where
    shownOf specimens given = show given ++ "\n" ++ show (specimenOf specimens given)
    accepted answer = counterexample (show answer) $ case answer of
      Accepted _ _ -> True
      Refused _ -> False

-- | Defects that hostile inputs have found, each with its story.
foundSpec :: Spec
foundSpec = describe "found by hostile inputs" $ do
  it "a wrong argument of 130 000 letters: its neighbours were sought for 18 seconds" $
    once $
      conjoin (map (judgedBy . judgedArguments) [[longWord], ["locate", "--" ++ longWord]])
  it "a certificate whose modulus is empty: the order was compared with p^-1" $
    once $
      conjoin
        [ ioProperty (conjoin . map (judgedIn . kindJudged kind . emptied) <$> kindSpecimens kind)
          | kind <- kinds,
            kindName kind == "certificates"
        ]
  it "two patches far apart: the rectangle around them was built cell by cell and took 340 MB" $
    once $
      conjoin
        [ judgedIn (kindJudged kind text)
          | kind <- kinds,
            kindName kind `elem` ["patches", "patches in unknown orientation"],
            text <-
              [ "3 2 / 3 1 ; 1000,1000: 1 1 / 1 1",
                "3 2 / 3 1 ; 0,500000: 1 1 / 1 1",
                "{\"patches\":[{\"cells\":[[[0,0,0.1,0.9],2],[3,1]]},\
                \{\"at\":[0,500000],\"cells\":[[1,1]]}]}"
              ]
        ]
  it "very many patches: finding those that do not belong took the cube of their number" $
    once $
      conjoin
        [ judgedIn (kindJudged kind (Bytes.intercalate " ; " (replicate count "0,3: 1 1 / 1 1")))
          | kind <- kinds,
            kindName kind `elem` ["patches", "patches in unknown orientation"],
            count <- [100, 101, 2000, 20000]
        ]
  it "a number of a million digits: aeson and cassava took 40 seconds to read it" $
    once $
      conjoin
        [ judgedIn (kindJudged kind (Bytes.concat [front, Bytes8.replicate 1000000 '9', rest]))
          | (name, front, rest) <-
              [ ("profiles", "[0.", "]"),
                ("certificates", "{\"windows\":1", "}"),
                ("patches", "[[[0.", ",0,0,1]]]"),
                ("manifests", "file,x_mm,y_mm,rotation_deg,force_n\na.pgm,0.", ",0,0,1\n")
              ],
            kind <- kinds,
            kindName kind == name
        ]
  it "ten million brackets: each took memory a hundred times its size" $
    once $
      conjoin
        [ judgedIn (kindJudged kind (Bytes8.replicate 10000000 '['))
          | kind <- kinds,
            kindName kind `elem` ["profiles", "certificates"]
        ]
  it "+RTS is an argument like any other, and its error is in our own words" $ do
    found <- ran (Run ["array", "+RTS", "-p"] "" [])
    (ranStatus found, ranOutput found) `shouldBe` (Just 2, "")
    Bytes8.lines (ranError found) `shouldSatisfy` all ("pra-tactile: " `Bytes.isPrefixOf`)
  it "JSON of the wrong form is refused with its place, not in the words of a library" $
    sequence
      [ kindJudged kind text
        | kind <- kinds,
          kindName kind == "profiles",
          text <-
            [ "",
              "[1]",
              "{}",
              "{\"schema\":1}",
              "{\"schema\":\"pra-tactile/profile/1\",\"q\":4,\"modulus\":[1,-1,1]}",
              "{",
              "\xff"
            ]
      ]
      `shouldReturn` map
        (Refused . ("it is not a profile: " ++))
        [ "it is empty",
          "an object is needed",
          "the key \"schema\" is missing",
          "schema: a text is needed",
          "modulus[1]: a number 0, 1, 2, ... is needed",
          "it is not JSON",
          "it is not UTF-8 text"
        ]
  where
    longWord = replicate 130000 '9'
    emptied =
      encodeUtf8 . Text.replace "\"modulus\":[0,1]" "\"modulus\":[]" . decodeUtf8
