{-# LANGUAGE GADTs #-}
{-# LANGUAGE OverloadedStrings #-}

-- | Tests the shipped test vectors: the program makes the same ones, and those called exhaustive
-- are exhaustive.
module Test.Conformance.Vectors (spec) where

import Control.Monad (forM, forM_, replicateM)
import Data.Aeson (Key, Value (..), object, (.=))
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Bits (testBit)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Bytes8
import qualified Data.ByteString.Lazy as Lazy
import Data.List (isInfixOf, minimumBy, sortOn)
import Data.Maybe (mapMaybe)
import Data.Ord (comparing)
import qualified Data.Set as Set
import Numeric.Natural (Natural)
import PraTactile.Array (Shape (..), area, naturalsBelow)
import PraTactile.Conformance.Operations (codeOperations, definedOperations, nameOf)
import PraTactile.Conformance.Question (Op (..), SomeOp (..))
import PraTactile.Conformance.Vectors
import qualified PraTactile.Conformance.Vectors.Draw as Draw
import PraTactile.Conformance.Vectors.Text
import PraTactile.Format.Profile (encodeProfile)
import PraTactile.Profile
import System.Directory (createDirectory, listDirectory, renameDirectory)
import System.FilePath ((<.>), (</>))
import Test.CommandLine.Run
import Test.Conformance.Process.Subjects (paperFile)
import Test.Effort
import Test.Hspec
import Test.Schemas (spoilt, validated)
import Test.Support

spec :: Spec
spec = do
  shippedSpec
  commandSpec
  it "drawn numbers are below a bound of any size, with every bit drawn" $
    forM_ [1, 31, 32, 33, 63, 64, 65, 100, 128, 200] $ \bits -> do
      let found = Draw.drawn 1 (replicateM 200 (Draw.below (2 ^ (bits :: Int))))
          -- The count of each set bit is within six standard errors of a half.
          often = [length (filter (`testBit` i) found) | i <- [0 .. bits - 1]]
      (bits, maximum found < 2 ^ bits, [i | (i, n) <- zip [0 :: Int ..] often, n < 57 || n > 143])
        `shouldBe` (bits, True, [])

shippedSpec :: Spec
shippedSpec = describe "the shipped vectors" $ do
  it "are made again to the byte, and there are no others" $ do
    forM_ triedProfiles $ \(name, profile) -> do
      prepared <- prepare profile >>= right
      forM_ codeOperations $ \operation -> do
        made <- makeVectors 1 prepared operation >>= right
        bytes <- Lazy.readFile (shipped operation name)
        (name, operation, bytes == vectorsText made) `shouldBe` (name, operation, True)
    forM_ definedOperations $ \operation -> do
      made <- makeVectors 1 withoutAProfile operation >>= right
      bytes <- Lazy.readFile (shipped operation "exact")
      (operation, bytes == vectorsText made) `shouldBe` (operation, True)
    there <- listDirectory folder >>= fmap concat . traverse (listDirectory . (folder </>))
    length there `shouldBe` length everyFile
  it "obey their schema, and spoilt ones do not" $ do
    -- The shortest file of each operation; a quick run takes only short ones.
    texts <- forM codeOperations $ \operation -> do
      files <- forM vectorProfiles (Bytes.readFile . shipped operation . fst)
      pure (map unbroken (Bytes8.unpack (minimumBy (comparing Bytes.length) files)))
    others <-
      forM
        definedOperations
        (fmap (map unbroken . Bytes8.unpack) . Bytes.readFile . (`shipped` "exact"))
    let isShort text = null (drop (byEffort 20000 maxBound) text)
        lines' = map ((,) "vectors") (filter isShort (texts ++ others))
    validated lines' >>= mapM_ (`shouldSatisfy` all ((== "good") . snd))
    spoilt (take 1 lines') >>= mapM_ (`shouldSatisfy` all ((== "good") . snd))
  it "take less than 10 MB" $ do
    sizes <- forM everyFile (fmap Bytes.length . Bytes.readFile)
    sum sizes `shouldSatisfy` (< 10 * 1000 * 1000)
  it "hold each input of the whole domain once, where they are called exhaustive" $
    forM_ triedProfiles $ \(name, profile) -> forM_ codeOperations $ \operation -> do
      tests <- testsIn (shipped operation name)
      let whole = mapMaybe exhaustive tests
      if null whole
        then pure ()
        else
          (name, operation, inOrder whole)
            `shouldBe` (name, operation, inOrder (domain profile operation))
  it "hold whole tables of small fields, and the SHA-256 of larger ones" $
    forM_ [(one, op) | one <- triedProfiles, op <- [SomeOp Add, SomeOp Multiply]] $ \it' -> do
      let ((name, profile), op) = it'
      tests <- testsIn (shipped op name)
      text <- Bytes.readFile (shipped op name)
      let q = profileOrder profile
          whole = fromIntegral (length (mapMaybe exhaustive tests))
      (name, whole, "\"digest\":{" `Bytes.isInfixOf` text)
        `shouldBe` if q <= 16 then (name, q * q, False) else (name, 0, True)
  it "each have their own id, which other programs can compute" $ do
    ids <- concat <$> forM (filesUnder triedProfiles) (fmap (mapMaybe (at ["id"])) . testsIn)
    Set.size (Set.fromList (map show ids)) `shouldBe` length ids
    -- In Python: json.dumps with sort_keys and the separators (',', ':'), then hashlib.sha256.
    powers <- testsIn (shipped (SomeOp Power) "paper")
    let squared = object ["a" .= (2 :: Int), "exponent" .= (-2 :: Int)]
    [at ["id"] test | test <- powers, at ["input"] test == Just squared]
      `shouldBe` [Just "3714fc324e04"]
  where
    -- A quick run takes the vectors of a prime field, in two rows, and of an odd power, on a sheet.
    triedProfiles =
      byEffort (filter ((`elem` ["gf3-2x13", "gf49-16x3-sheet"]) . fst)) id vectorProfiles
    everyFile = filesUnder vectorProfiles
    filesUnder profiles =
      [shipped operation name | (name, _) <- profiles, operation <- codeOperations]
        ++ [shipped operation "exact" | operation <- definedOperations]
    exhaustive test
      | at ["proof", "kind"] test == Just "exhaustive" = at ["input"] test
      | otherwise = Nothing
    inOrder = sortOn show
    unbroken c = if c == '\n' then ' ' else c

commandSpec :: Spec
commandSpec = describe "vectors" $ do
  it "--check reports success, or the id of the first test that differs" $
    inFolder $ \place -> do
      pra (underPaper ["--output", place </> "v", "--operation", "add"])
        >>= (`shouldSatisfy` answered)
      let file = place </> "v" </> "add" </> "paper.json"
      good <- pra ["vectors", "--check", place </> "v"]
      good `shouldSatisfy` \(status, out, err) -> (status, take 9 out, err) == (0, "good: all", "")
      text <- Bytes.readFile file
      let (front, back) = Bytes.breakSubstring "\"result\":3" text
      Bytes.writeFile file (front <> "\"result\":2" <> Bytes.drop 10 back)
      let stated = Bytes8.unpack (Bytes.take 12 (Bytes.drop 7 (last' (Bytes8.lines front))))
      (status, out, _) <- pra ["vectors", "--check", place </> "v"]
      (status, ("test " ++ stated ++ ": result is 2, made again 3") `isInfixOf` out)
        `shouldBe` (1, True)
      let others = filter (not . Bytes.isInfixOf (Bytes8.pack stated)) (Bytes8.lines text)
      Bytes.writeFile file (Bytes8.unlines others)
      (status', out', _) <- pra ["vectors", "--check", place </> "v"]
      (status', "belongs" `isInfixOf` out') `shouldBe` (1, True)
  it "--check rejects a file in the folder of another operation, whatever it contains" $
    inFolder $ \place -> do
      pra (underPaper ["--output", place, "--operation", "negate"])
        >>= (`shouldSatisfy` answered)
      renameDirectory (place </> "negate") (place </> "add")
      (status, out, _) <- pra ["vectors", "--check", place]
      (status, "it has tests of negate, whose folder is another one" `isInfixOf` out)
        `shouldBe` (1, True)
  it "--profile and --seed make vectors of a given profile, named by its file, with other inputs" $
    inFolder $ \place -> do
      let arguments seed to =
            words "vectors --operation power --profile"
              ++ [place </> "mine.json", "--seed", seed, "--output", place </> to]
          written to = Bytes.readFile (place </> to </> "power" </> "mine.json")
      Bytes.writeFile (place </> "mine.json") (encodeProfile mine)
      forM_ [("7", "a"), ("7", "b"), ("8", "c")] $ \(seed, to) ->
        pra (arguments seed to) >>= (`shouldSatisfy` answered)
      [a, b, c] <- traverse written ["a", "b", "c"]
      (a == b, a == c) `shouldBe` (True, False)
      pra ["vectors", "--check", place </> "c"] >>= (`shouldSatisfy` answered)
  it "files and folders without vectors are refused" $
    inFolder $ \place -> do
      ["vectors", "--check", place] `complains` "there are no vectors in"
      ["vectors", "--check", place </> "none"] `complains` "cannot read"
      createDirectory (place </> "add")
      writeFile (place </> "add" </> "x.json") "{\"schema\": \"pra-tactile/vectors/1\"}"
      ["vectors", "--check", place] `complains` "operation"
      writeFile (place </> "file") ""
      ["vectors", "--output", place </> "file", "--operation", "add"] `complains` "file"
      (status, out, err) <- pra ["vectors", "--output", place, "--operation", "divide"]
      (status, out, "\"divide\" is no operation" `isInfixOf` err) `shouldBe` (2, "", True)
  where
    underPaper options = ["vectors", "--profile", paperFile] ++ options
    answered (status, _, err) = (status, err) == (0, "")
    last' = foldl (const id) ""

-- | GF(2), x^2 + x + 1, one row of three cells.
mine :: Profile
mine =
  canonicalProfile
    { profileOrder = 2,
      profileModulus = [1, 1],
      profilePolynomial = [1, 1, 1],
      profileState = [0, 1],
      profileShape = Shape 1 3,
      profileWindow = Shape 1 2
    }

folder :: FilePath
folder = "data/vectors"

shipped :: SomeOp -> String -> FilePath
shipped operation name = folder </> nameOf operation </> name <.> "json"

testsIn :: FilePath -> IO [Value]
testsIn file = statedTests <$> (Bytes.readFile file >>= right . readVectors)

-- | The value at a path of keys.
at :: [Key] -> Value -> Maybe Value
at path value = case (path, value) of
  ([], _) -> Just value
  (name : names, Object fields) -> KeyMap.lookup name fields >>= at names
  _ -> Nothing

-- | All inputs of an operation that has finitely many under a profile. Where there is no end of
-- them: a period of the sequence, and the array's own cells.
domain :: Profile -> SomeOp -> [Value]
domain profile (SomeOp operation) = case operation of
  Add -> pairs "a" codes "b" codes
  Multiply -> pairs "a" codes "b" codes
  Negate -> singles "a" codes
  Inverse -> singles "a" codes
  Logarithm -> singles "a" codes
  Trace -> singles "a" codes
  Term -> singles "index" (naturalsBelow (n1 * n2))
  Cell -> pairs "row" (naturalsBelow n1) "column" (naturalsBelow n2)
  Unpack -> singles "packed" (naturalsBelow (q ^ cells))
  Pack -> [object ["cells" .= content] | content <- traverse (const codes) [1 .. cells]]
  _ -> []
  where
    q = profileOrder profile
    codes = naturalsBelow q
    cells = area (profileWindow profile)
    Shape n1 n2 = profileShape profile
    singles :: Key -> [Natural] -> [Value]
    singles name values = [object [name .= value] | value <- values]
    pairs :: Key -> [Natural] -> Key -> [Natural] -> [Value]
    pairs name as other bs = [object [name .= a, other .= b] | a <- as, b <- bs]
