{-# LANGUAGE OverloadedStrings #-}

-- | The commands that prove, certify and check, as scripts use them; and the checker in Python.
module Test.CommandLine.Proof (spec) where

import Control.Monad (forM_, void)
import Data.Aeson
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import qualified Data.ByteString.Char8 as Bytes8
import qualified Data.ByteString.Lazy.Char8 as Lazy8
import Data.Foldable (toList)
import Data.List (intercalate, isInfixOf, isPrefixOf, sort, sortOn)
import qualified Data.Vector as Vector
import PraTactile.Certificate.Digest (sha256OfText)
import System.Directory (findExecutable)
import System.Exit (ExitCode (..))
import System.FilePath ((</>))
import System.Process (readProcessWithExitCode)
import Test.Code.Certificate.CheckerInPython
import Test.CommandLine.Run
import Test.Effort
import Test.Hspec
import Test.Support

spec :: Spec
spec = do
  proveSpec
  certificateSpec

proveSpec :: Spec
proveSpec = describe "prove" $ do
  it "--mask: any set of cells, by both roads" $ do
    (status, out, _) <- pra (words "prove --json --mask ##./.##")
    ( status,
      map
        (\name -> key [name] out)
        ["mask", "proved", "enumeration", "rank_road", "rank", "windows"]
      )
      `shouldBe` (0, map Just ["##./.##", Bool True, Bool True, Bool True, Number 4, Number 255])
    let awkward =
          [ "prove",
            "--json",
            "--mask",
            intercalate "/" (["#........#"] ++ replicate 10 ".........." ++ ["........#."])
          ]
    (refuted, _, _) <- pra awkward
    (proved, out', _) <- pra (awkward ++ ["--surface", "sheet"])
    (refuted, proved, key ["windows"] out', key ["rank_road"] out')
      `shouldBe` (1, 0, Just (Number 32), Just Null)
  it "tells how far the windows lie apart, and a smallest set of cells without which it fails" $ do
    (_, out, _) <- pra (words "prove --json --mask ###/###")
    (key ["distance"] out, fmap cells (key ["failing_erasure"] out))
      `shouldBe` (Just (Number 2), Just (Just 2))
    (_, out', _) <- pra (words "prove --json --surface sheet")
    (key ["distance"] out', key ["failing_erasure"] out') `shouldBe` (Just Null, Just Null)
    (_, text, _) <- pra ["prove", "--mask", "###/###/###"]
    text
      `shouldSatisfy` ( "minimum distance:         4: forgives up to 3 missing cells, or up to 1 \
                        \wrong ones"
                          `isInfixOf`
                      )
  it "FILE: the array itself, and what it says of one that somebody else made" $
    inFolder $ \folder -> do
      (_, csv, _) <- pra ["array", "--format", "csv"]
      let file = folder </> "array.csv"
      writeFile file csv
      (status, out, _) <- pra ["prove", "--json", "--window", "2x2", file]
      ( status,
        map
          (\name -> key [name] out)
          ( ["profile", "q", "proved", "enumeration", "rank_road"]
              ++ ["rank", "needed", "windows", "surface", "collision"]
          )
        )
        `shouldBe` ( 0,
                     map
                       Just
                       [ Null,
                         Number 4,
                         Bool True,
                         Bool True,
                         Null,
                         Null,
                         Null,
                         Number 255,
                         "torus",
                         Null
                       ]
                   )
      writeFile file "0, 1, 0\r\n1, 1, 1\r\n0, 1, 0\r\n\r\n"
      (refuted, out', _) <- pra (words "prove --json --mask ## --surface sheet" ++ [file])
      -- 01 10 / 11 11 / 01 10
      (refuted, map (\name -> key [name] out') ["q", "windows", "collision"])
        `shouldBe` (1, [Just (Number 2), Just (Number 3), Just (toJSON [[1, 0], [1, 1 :: Int]])])
  it "FILE: --q is the alphabet's size; the largest code and one more without it" $
    inFolder $ \folder -> do
      let file = folder </> "a.csv"
      writeFile file "0,2\n1,2\n"
      (_, out, _) <- pra ["prove", "--json", "--window", "1x1", file]
      (_, out', _) <- pra (words "prove --json --window 1x1 --q 5" ++ [file])
      (key ["q"] out, key ["q"] out') `shouldBe` (Just (Number 3), Just (Number 5))
      complains (words "prove --window 1x1 --q 2" ++ [file]) "not below q"
      complains (words "prove --window 1x1 --q 257" ++ [file]) "257"
  it "FILE: ragged rows, invalid codes and empty files are status 2, with the line" $
    inFolder $ \folder -> do
      let file = folder </> "bad.csv"
      forM_
        [ ("0,1\n0\n", "line 2 has 1 cells"),
          ("0,1\n\n0,1\n", "line 2 is empty"),
          ("", "no cells"),
          ("\n\n", "no cells"),
          ("0,1\n0,x\n", "line 2"),
          ("0,,1\n", "line 1"),
          ("0,1,\n", "line 1"),
          ("0,256\n", "255"),
          ("0,-1\n", "line 1"),
          ("0 1\n", "line 1"),
          ("0,1\n0,1,0", "line 2 has 3 cells")
        ]
        $ \(text, about) -> do
          writeFile file text
          complains ["prove", "--window", "1x1", file] about
      complains ["prove", "--window", "1x1", folder </> "none.csv"] "none.csv"
      writeFile file "0,1\n"
      complains ["prove", file] "--window"
      complains (words "prove --window 2x1 --surface sheet" ++ [file]) "no window"
      complains (words "prove --window 1x1 --polynomial 1,1" ++ [file]) "FILE"
  it "an invalid mask, or a mask beside --window, is status 2" $ do
    forM_ ["", "..", "##/#", "#?"] $ \drawing ->
      void
        (pra ["prove", "--mask", drawing] >>= \(status, out, _) -> (status, out) `shouldBe` (2, ""))
    complains
      (words "prove --mask ## --window 1x2 --q 2 --polynomial 1,1,0,0,1 --shape 3x5")
      "--window"

cells :: Value -> Maybe Int
cells value = case value of
  Array listed -> Just (length listed)
  _ -> Nothing

certificateSpec :: Spec
certificateSpec = describe "certificate and check" $ do
  it "what is certified is found good, by this program and in Python" $
    inFolder $ \folder ->
      forM_
        ( [ ("sheet", words "--surface sheet --mask ##./.##"),
            ("odd", words "--q 3 --polynomial 1,2,0,1 --shape 2x13 --window 1x3"),
            ("gf9", words "--q 9 --polynomial 3,1,1 --shape 1x80 --window 1x2 --enumeration")
          ]
            ++ byEffort
              []
              [ ("rank", []),
                ("enumeration", ["--enumeration"]),
                ("packed", words "--q 2 --polynomial 1,1,0,0,1 --shape 3x5")
              ]
        )
        $ \(name, options) -> do
          let file = folder </> name
          certified <- pra (["certificate", "--output", file] ++ options)
          certified
            `shouldSatisfy` \(status, out, err) ->
              status == 0 && "wrote" `isPrefixOf` out && null err
          (status, out, _) <- pra ["check", "--json", file]
          (status, key ["good"] out, key ["reason"] out) `shouldBe` (0, Just (Bool True), Just Null)
          python <- findExecutable "python3"
          forM_ python $ \executable ->
            readProcessWithExitCode executable [checker, file] ""
              `shouldReturn` (ExitSuccess, "good\n", "")
  it "without --output on the standard output; refuted is status 1, impossible 2" $ do
    (status, out, _) <- pra ["certificate"]
    (status, key ["schema"] out) `shouldBe` (0, Just "pra-tactile/certificate/1")
    forM_
      [ ["--mask", "##"],
        words "--mask ## --surface sheet",
        ["--rank", "--surface", "twisted-torus"]
      ]
      $ \options -> do
        (refuted, nothing, err) <- pra ("certificate" : options)
        (refuted, nothing, length (lines err)) `shouldBe` (1, "", 1)
    complains
      (words "certificate --q 4 --polynomial 1,0,0,0,1 --shape 15x17")
      "not primitive"
  it "every command of proofs shows an example with --help" $
    forM_ (words "prove certificate check census merge") $ \name -> do
      (status, out, _) <- pra [name, "--help"]
      (status, "Example" `isInfixOf` out) `shouldBe` (0, True)
  it "check: a file that is not a certificate is status 2" $
    inFolder $ \folder -> do
      complains ["check", folder </> "none.json"] "none.json"
      forM_ ["", "{}", "[1]", "{\"schema\": \"pra-tactile/certificate/2\"}"] $ \text -> do
        writeFile (folder </> "no.json") text
        complains ["check", folder </> "no.json"] "not a certificate"
  forM_ [("rank", []), ("enumeration", ["--enumeration"])] $ \(road, options) -> do
    it ("any number, name or list that is changed breaks the seal: by " ++ road) $
      inFolder $ \folder -> do
        changes <- tamperings <$> certificateOf options
        verdicts <- inPython (map (Bytes8.pack . canonical . snd) changes)
        verdicts `shouldBe` map (const False) changes
        -- This program reads each file in a process of its own: a sample is enough.
        forM_
          [change | (i, change) <- zip [0 :: Int ..] changes, i `mod` 5 == 0]
          $ \(path, value) ->
            fmap ((,) path) (isGood folder value) `shouldReturn` (path, False)
    it
      ( "with a new seal, both checkers still agree, and find good what is true: another initial \
        \state, by "
          ++ road
      )
      $ inFolder $ \folder -> do
        changes <- map (fmap sealed) . tamperings <$> certificateOf options
        python <- inPython (map (Bytes8.pack . canonical . snd) changes)
        ours <- mapM (isGood folder . snd) changes
        zip (map fst changes) ours `shouldBe` zip (map fst changes) python
        let stated =
              if road == "rank" then [["profile", "state", show i] | i <- [0 .. 3 :: Int]] else []
        [path | ((path, _), True) <- zip changes ours, take 1 path /= ["seal"]] `shouldBe` stated

-- | The certificate of the paper's array.
certificateOf :: [String] -> IO Value
certificateOf options = do
  (_, out, _) <- pra ("certificate" : options)
  maybe (fail "this is no JSON") pure (decode (Lazy8.pack out))

-- | All values in which one number, name or list is another, with the path to it.
tamperings :: Value -> [([String], Value)]
tamperings value = case value of
  Object fields ->
    [ (Key.toString k : path, Object (KeyMap.insert k v' fields))
      | (k, v) <- sortOn (Key.toString . fst) (KeyMap.toList fields),
        (path, v') <- tamperings v
    ]
  Array values ->
    [([], Array (Vector.init values)) | not (null values)]
      ++ [ (show i : path, Array (values Vector.// [(i, v')]))
           | (i, v) <- zip [0 ..] (toList values),
             (path, v') <- tamperings v
         ]
  Number n -> [([], Number (n + 1))]
  String s -> [([], String (s <> "0"))]
  _ -> []

-- | Keys sorted, no spaces.
canonical :: Value -> String
canonical value = case value of
  Object fields ->
    "{"
      ++ intercalate
        ","
        (sort [show (Key.toString k) ++ ":" ++ canonical v | (k, v) <- KeyMap.toList fields])
      ++ "}"
  Array values -> "[" ++ intercalate "," (map canonical (toList values)) ++ "]"
  other -> Lazy8.unpack (encode other)

-- | With the seal that belongs to the rest.
sealed :: Value -> Value
sealed value = case value of
  Object fields ->
    Object
      ( KeyMap.insert
          "seal"
          (toJSON (sha256OfText (canonical (Object (KeyMap.delete "seal" fields)))))
          fields
      )
  other -> other

isGood :: FilePath -> Value -> IO Bool
isGood folder value = do
  writeFile (folder </> "changed.json") (canonical value)
  (status, _, _) <- pra ["check", folder </> "changed.json"]
  pure (status == 0)

checker :: FilePath
checker = "data/check_certificate.py"
