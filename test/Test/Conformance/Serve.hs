{-# LANGUAGE OverloadedStrings #-}

-- | Tests the server: this library through the pipe, and its replies to malformed requests.
module Test.Conformance.Serve (spec) where

import Data.Aeson (Object, Value (..), decode, encode, object, (.=))
import qualified Data.Aeson.KeyMap as KeyMap
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.ByteString.Lazy.Char8 as Lazy.Char8
import Data.Char (isDigit)
import Data.Foldable (for_, toList)
import Data.Function (on)
import Data.List (isPrefixOf, mapAccumL, nubBy)
import Data.Maybe (listToMaybe)
import qualified Data.Text as Text
import Data.Traversable (for)
import Numeric.Natural (Natural)
import PraTactile.Conformance.Implementation (Implementation (implementationName))
import PraTactile.Conformance.Impostors
import PraTactile.Conformance.Impostors.Killers
import PraTactile.Conformance.Law (codeStages, lawId, objectStages, stageName, touchStages)
import PraTactile.Conformance.Laws (laws, lawsWithoutProfile, openingLaws)
import PraTactile.Conformance.Library (library)
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Profiles (defaultProfiles)
import PraTactile.Conformance.Question
import PraTactile.Conformance.Serve (replyOnce, serveOnce)
import PraTactile.Conformance.Wire.Line (longestLine)
import PraTactile.Format.Json (naturalValue)
import PraTactile.Format.Profile (encodeProfile, profileValue)
import PraTactile.Position (Position (..), Shape (..))
import PraTactile.Profile (ProfileChoice (..), canonicalProfile, chooseProfile, profileChoice)
import System.FilePath ((</>))
import System.IO (IOMode (..), withBinaryFile)
import Test.CommandLine.Run
import Test.Conformance.Process.Subjects
import Test.Effort
import Test.Hostile.Judgement (withinBounds)
import Test.Hspec
import Test.Support (inFolder)

spec :: Spec
spec = do
  it "the server holds the laws through the pipe" $
    inFolder $ \folder -> do
      -- A quick run tests the pipe: the protocol, and how questions of most operations and their
      -- answers are written. Its profile has packed windows that no double holds.
      let file = folder </> "long-windows.json"
          chosen =
            running ["protocol/*", "*-takes-either-form", "proof/prove-special-masks"]
              ++ ["--profile", file, "--cases", "2"]
          options = words "--limit 1200 --timeout 60 --json" ++ byEffort chosen ["--cases", "20"]
      for_
        (lookup "gf5-3x8-window-3x8-sheet" defaultProfiles)
        (Bytes.writeFile file . encodeProfile)
      (status, out, err) <- conform options served
      (status, err) `shouldBe` (0, "")
      [law | law@(_, outcome) <- outcomes out, outcome `notElem` ["held", "skipped"]]
        `shouldBe` []
      reported "certified" out `shouldBe` Just (Bool (effort == Full))
  it "the server holds the laws of touch through the pipe, without a profile, in both modes" $ do
    let options = words "--stage touch --cases 2 --timeout 60 --json --profile" ++ [paperFile]
        ofEach =
          ["register/blank", "stitch/truth-stays", "segment/blank", "network/outputs-of-each-taxel"]
        oneShot = "--one-shot" : byEffort (running ["register/blank"]) []
        session = (byEffort (running ofEach) [], [], True)
    -- A subject is certified if a law of each operation that it offers holds.
    for_ [session, (oneShot, ["--one-shot"], effort == Full)] $ \(how, server, certified) -> do
      (status, out, err) <- conform (options ++ how) (served ++ server)
      (status, err) `shouldBe` (0, "")
      [law | law@(_, outcome) <- outcomes out, outcome /= "held"] `shouldBe` []
      reported "certified" out `shouldBe` Just (Bool certified)
  it "the server says of a law of touch that it needs its stage" $ do
    (status, out, err) <- conform ["--profile", paperFile, "--run", "register/blank"] served
    (status, out) `shouldBe` (2, "")
    err `shouldContain` "--stage touch"
  it "serve --one-shot answers one request" $ do
    (_, profile, _) <- praAlone ["profile"]
    let asked keys = "{\"profile\": " ++ concat (lines profile) ++ keys ++ "}\n"
        once' keys = praAloneWith ["serve", "--one-shot"] (asked keys)
    once' (", \"sequence\": 7, " ++ operation "multiply" "{\"a\": 2, \"b\": 3}")
      `shouldReturn` (0, "{\"sequence\":7,\"result\":1}\n", "")
    once' "" `shouldReturn` (0, "{\"result\":true}\n", "")
    (_, unknown, _) <- once' (", " ++ operation "divide" "{}")
    unknown `shouldSatisfy` ("{\"skipped\":" `isPrefixOf`)
  it "the server states its name, its operations, and that it takes 64 requests at once" $ do
    (status, out, _) <- praAloneWith ["serve"] "{\"command\": \"start\", \"protocol\": 1}\n"
    (status, decode (Lazy.Char8.pack out))
      `shouldBe` ( 0,
                   Just
                     ( object
                         [ "protocol" .= (1 :: Int),
                           "name" .= implementationName library,
                           "operations" .= map nameOf allOperations,
                           "in_flight" .= (64 :: Int)
                         ]
                     )
                 )
  it "a process per request reads a line of up to a mebibyte, with or without its end" $
    for_ [(size, lineEnd) | size <- [-1, 0, 1], lineEnd <- ["", "\n"]] $ \(more, lineEnd) ->
      inFolder $ \folder -> do
        let request = encode (object ["profile" .= profileValue canonicalProfile])
            size = fromIntegral longestLine + more - Lazy.length request
            padded = request <> Lazy.replicate size 32 <> lineEnd
        Lazy.writeFile (folder </> "request") padded
        withBinaryFile (folder </> "request") ReadMode $ \input ->
          withBinaryFile (folder </> "reply") WriteMode (serveOnce library input)
        reply <- Lazy.readFile (folder </> "reply")
        -- A single read may hold the line's end beyond the limit.
        let late = more == 1 && lineEnd == ""
        (more, lineEnd, reply)
          `shouldBe` ( more,
                       lineEnd,
                       if late
                         then "{\"errored\":\"a line of more than 1 MiB\"}\n"
                         else "{\"result\":true}\n"
                     )
  describe "whatever number a request contains, the reply is one line and takes little memory" $
    for_ allOperations $ \some -> it (nameOf some) $
      for_ (byEffort (evenly 30) id (extremes (exampleOf some))) $ \question -> do
        reply <- withinBounds (replyTo question)
        (show question, (<= longestLine) . lineLength <$> reply)
          `shouldBe` (show question, Right True)
  it "a request for more terms than a line can hold is refused as too-long" $ do
    let most = (longestLine - lineLength "{\"result\":[]}" + 1) `div` 2
        terms count = replyTo (SomeQuestion (Terms :? (0, fromIntegral count)))
        tooLong = "{\"refused\":\"too-long\"}\n"
    full <- terms most
    lineLength full `shouldSatisfy` (`elem` [longestLine - 1, longestLine])
    terms (most + 1) `shouldReturn` tooLong
    for_ [question size | question <- growing, size <- sizes] $ \question ->
      withinBounds (replyTo question) `shouldReturn` Right tooLong
  it "an array in which no place can be found still has its cells and its windows" $ do
    -- x^34 + x^7 + x^6 + x^5 + x^2 + x + 1, and windows of 2 x 17
    under <- binary [0, 1, 2, 5, 6, 7, 34] (Shape 3 5726623061) (Shape 2 17)
    let nowhere = "{\"refused\":\"table-too-large\"}\n"
    for_
      [ (SomeQuestion (Cell :? Position 0 33), "{\"result\":1}\n"),
        (SomeQuestion (Locate :? replicate 2 (replicate 17 (Just 1))), nowhere),
        (SomeQuestion (Nearest :? (Nothing, [[Just 1]])), nowhere)
      ]
      $ \(question, reply) -> replyOnce library (requestOf under question) `shouldReturn` reply
  it "all 2^20 probabilities of an array are too long for a line; the nonzero ones fit" $ do
    -- x^20 + x^3 + 1
    under <- binary [0, 3, 20] (Shape 1023 1025) (Shape 10 2)
    let asked = replyOnce library . requestOf under . SomeQuestion
        seen = read . filter isDigit . Lazy.Char8.unpack :: Lazy.ByteString -> Natural
    withinBounds (asked (Posterior :? [[Unfelt]]))
      `shouldReturn` Right "{\"refused\":\"too-long\"}\n"
    cells <- for [7 .. 16] $ \r -> for [5, 6] (fmap seen . asked . (Cell :?) . Position r)
    withinBounds (asked (Posterior :? map (map Certainly) cells))
      `shouldReturn` Right "{\"result\":[[7,5,1]]}\n"
  it "an undecided property of a polynomial is refused as not-factored, not denied" $ do
    let unknown = "{\"refused\":\"not-factored\"}\n"
        high lead = 1 : replicate 599 0 ++ [lead]
    -- Over GF(4) factors are sought up to degree 512.
    for_
      [ (FirstPrimitive :? 513, unknown),
        (FirstPrimitive :? 2000, unknown),
        (FirstPrimitive :? 0, "{\"refused\":\"invalid\"}\n")
      ]
      $ \(question, reply) -> replyTo (SomeQuestion question) `shouldReturn` reply
    for_ [(high 1, unknown), (high 2, "{\"result\":false}\n")] $ \(codes, reply) ->
      replyTo (SomeQuestion (Primitive :? codes)) `shouldReturn` reply
    under <- binary [0, 1, 1030] (Shape 1 (2 ^ (1030 :: Int) - 1)) (Shape 1 1030)
    replyOnce library (requestOf under (SomeQuestion (Term :? 0))) `shouldReturn` unknown
  it "a reply repeats the request's number if it is a whole number, and nothing else" $
    for_ [(Number 7, "{\"sequence\":7,\"result\":0}\n"), (longText, "{\"result\":0}\n")] $
      \(number, reply) ->
        replyOnce library (requestOf (KeyMap.singleton "sequence" number) (exampleOf (SomeOp Add)))
          `shouldReturn` reply
  for_ strange $ \(what, requests, replies) -> it what $ do
    (status, out, err) <- praAloneWith ["serve"] (unlines requests)
    (status, err) `shouldBe` (0, "")
    zipWith isPrefixOf replies (lines out) `shouldBe` map (const True) replies
    length (lines out) `shouldBe` length replies
  describe "an impostor is found through the pipe, by the first law listed for it" $
    parallel $
      for_ (byEffort [] oneALaw ++ oneAStage) $ \one -> it (impostorName one) $ do
        law <- maybe (fail "no law finds it") pure (firstKiller one)
        (status, out, err) <-
          conform
            (["--run", law, "--fail-fast", "--json"] ++ words (stageFor one))
            (served ++ ["--impostor", impostorName one])
        (status, err, (law, "failed") `elem` outcomes out) `shouldBe` (1, "", True)
  it "each listed impostor has its mistake and existing laws" $ do
    (status, out, _) <- praAlone ["serve", "--impostors"]
    status `shouldBe` 0
    length (lines out) `shouldBe` 2 * length impostors
    let ids = map lawId laws ++ map lawId openingLaws ++ map lawId lawsWithoutProfile
    filter (`notElem` ids) (concatMap (killersOf . impostorName) impostors) `shouldBe` []
  where
    replyTo = replyOnce library . requestOf mempty
    growing = [SomeQuestion . (Terms :?) . (,) 0, SomeQuestion . (FirstPrimitive :?)]
    -- The profile of an array over GF(2), given the coefficients that are 1.
    binary :: [Int] -> Shape -> Shape -> IO Object
    binary taps shape window = do
      let coefficients = [if i `elem` taps then 1 else 0 | i <- [0 .. maximum taps]]
          choice = (profileChoice 2 coefficients shape) {chosenWindow = Just window}
      Right made <- pure (chooseProfile choice)
      pure (KeyMap.singleton "profile" (profileValue made))
    longText = String (Text.replicate 170000 "<")
    served = ["pra-tactile", "serve"]
    running names = concat [["--run", name] | name <- names]
    -- Some of many, from the first on.
    evenly count items =
      let apart = max 1 (length items `div` count)
       in [item | (i, item) <- zip [0 ..] items, i `mod` apart == (0 :: Int)]
    ofTheCode one = any (`elem` codeStages) (impostorTouches one)
    stageFor one
      | ofTheCode one = ""
      | otherwise =
        unwords ["--stage " ++ stageName stage | stage <- impostorTouches one]
          ++ (" --profile " ++ paperFile ++ " --cases " ++ byEffort "4" "20")
    -- All impostors are found in this process. Of those that one law finds first, only the first is
    -- tried here.
    oneALaw = nubBy ((==) `on` firstKiller) (filter ofTheCode impostors)
    firstKiller = listToMaybe . killersOfProcess . impostorName
    oneAStage =
      concat
        [ take 1 (filter ((== [stage]) . impostorTouches) soonFound)
          | stage <-
              touchStages
                ++ objectStages
        ]
    -- Making a case of stitching smaller takes seconds.
    soonFound =
      filter
        ((`notElem` byEffort ["stitches-nothing", "stretches-the-robot"] []) . impostorName)
        impostors

-- | Numbers of terms that no line can hold.
sizes :: [Natural]
sizes = [3000000, 10 ^ (9 :: Int), 10 ^ (30 :: Int)]

-- | A question, and the same question with one of its numbers changed.
extremes :: SomeQuestion -> [SomeQuestion]
extremes question@(SomeQuestion typed) =
  question :
    [ SomeQuestion (Raw (operationOf typed) input)
      | size <- sizes,
        input <- others (naturalValue size) (questionInput typed)
    ]
  where
    others size value = case value of
      Number _ -> [size]
      Array items -> Array <$> one (others size) items
      Object fields -> Object <$> one (others size) fields
      _ -> []
    one :: Traversable t => (a -> [a]) -> t a -> [t a]
    one change items =
      [ snd (mapAccumL (\k old -> (k + 1, if k == i then new else old)) 0 items)
        | (i, item) <- zip [0 :: Int ..] (toList items),
          new <- change item
      ]

-- | A request with one question and further keys.
requestOf :: Object -> SomeQuestion -> ByteString
requestOf keys (SomeQuestion question) =
  Lazy.toStrict . encode . Object $
    keys
      <> KeyMap.fromList
        [ "profile" .= profileValue canonicalProfile,
          "operation" .= nameOf (operationOf question),
          "input" .= questionInput question
        ]

-- | The number of bytes of a line without its end.
lineLength :: Lazy.ByteString -> Int
lineLength = fromIntegral . Lazy.length . Lazy.Char8.takeWhile (/= '\n')

operation :: String -> String -> String
operation name input = "\"operation\": \"" ++ name ++ "\", \"input\": " ++ input

-- | Requests, and how their replies begin.
strange :: [(String, [String], [String])]
strange =
  [ ( "a line that is not JSON is errored, and the next one answered",
      ["{", start],
      [err, "{\"prot"]
    ),
    ("another protocol is errored", ["{\"command\": \"start\", \"protocol\": 2}"], [err]),
    ( "a list, an empty line and an unknown command are errored",
      ["[]", "", unknown],
      [err, err, err]
    ),
    ( "a run without a profile is errored, with its number",
      ["{\"command\": \"run\", \"sequence\": 5, " ++ operation "negate" "{\"a\": 1}" ++ "}"],
      ["{\"sequence\":5,\"errored\":"]
    ),
    ( "an invalid profile is refused",
      ["{\"command\": \"profile\"}"],
      ["{\"refused\":\"invalid\"}"]
    ),
    ("stop has no reply, nor has anything after it", [start, stop, start], ["{\"prot"]),
    ( "a line of more than a mebibyte is errored, and the next one answered",
      [replicate 1100000 ' ' ++ start, start],
      [err, "{\"prot"]
    ),
    ( "a reply of more than a mebibyte is refused in every case, and the next one sent",
      ["{\"command\": \"run\", \"sequence\": 5, " ++ long ++ "}", start],
      ["{\"sequence\":5,\"refused\":\"too-long\"}", "{\"prot"]
    )
  ]
  where
    start = "{\"command\": \"start\", \"protocol\": 1}"
    stop = "{\"command\": \"stop\"}"
    unknown = "{\"command\": \"wait\"}"
    long = "\"operation\": \"" ++ replicate 1048520 'x' ++ "\""
    err = "{\"errored\":"
