module Test.House (spec) where

import Data.Foldable (for_)
import Data.List (isPrefixOf, (\\))
import qualified Data.Map.Strict as Map
import Test.Hspec

import House.Cabal
import House.Graph
import House.Source

spec :: Spec
spec = describe "the house" $ do
  describe "as it stands" $ beforeAll (readHouse ".") $ do
    it "has modules in both wings and in the hall" $ \house ->
      [wing | wing <- [Common, Code, Touch, Recognition, Files, Formats, Store, App], all ((/= wing) . sourceWing) house] `shouldBe` []
    it "neither wing reaches the other, nor any part one that it must not know" $ \house ->
      wingBreaches house `shouldBe` []
    it "nothing pure reaches the world" $ \house ->
      purityBreaches house `shouldBe` []
    it "the definition of fields and the factorisation of integers import base only" $ \house ->
      [ (sourceName one, name)
      | one <- house, sourceName one == "PraTactile.Field.Definition" || ofFactorisation (sourceName one)
      , name <- sourceImports one, any (`isPrefixOf` name) beyondBase, not (ofFactorisation name) ] `shouldBe` []
    it "of the code, the objects see positions and shapes only" $ \house ->
      [ (sourceName one, name)
      | one <- house, "PraTactile.Object" `isPrefixOf` sourceName one
      , name <- sourceImports one, Just Code == Map.lookup name (wingsOf house), name /= "PraTactile.Array" ] `shouldBe` []

  describe "as the package describes it" $ beforeAll described $ do
    it "has every component that has rules" $ \(_, package) ->
      map fst allowances \\ map componentName package `shouldBe` []
    for_ allowances $ \(name, packages) ->
      it (name ++ " depends only on what it is allowed") $ \(_, package) ->
        concat [dependencies one \\ packages | one <- package, componentName one == name] `shouldBe` []
    it "every module belongs to its wing's component" $ \(house, package) -> do
      let owned wing = concatMap componentModules (filter ((== componentOf wing) . componentName) package)
      [ (componentOf (sourceWing one), sourceName one)
        | one <- house, sourceName one /= "program.Main", sourceName one `notElem` owned (sourceWing one) ] `shouldBe` []

  describe "its inspectors" $ do
    it "see imports of every form, and none in comments and strings" $
      importsIn (tokens (unlines
        [ "-- import Not.This", "{- import Nor.This {- nor -} import Nor.That -}", "module M (f) where"
        , "import A.B", "import qualified C as D", "import E qualified as F (g')", "import safe G"
        , "import \"package\" H (i)", "import {-# SOURCE #-} J", "import", "  K"
        , "f' = \"import Nor.Here\" ++ ['\"', '\\''] -- import Nor.Now" , "x --> y = 'i'", "import L" ]))
        `shouldBe` ["A.B", "C", "E", "G", "H", "J", "K", "L"]
    it "find a wing that knows the other, through others too" $
      wingBreaches
        [ source Code "A" "import B", source Code "B" "import C"
        , source Recognition "C" "import D", source Touch "D" "" ]
        `shouldBe`
        [ Breach ["A", "B", "C"] "code must not know recognition", Breach ["A", "B", "C", "D"] "code must not know touch"
        , Breach ["B", "C"] "code must not know recognition", Breach ["B", "C", "D"] "code must not know touch" ]
    it "find what is not pure, through others too" $
      map breachPath (purityBreaches
        [ source Touch "A" "import B", source Touch "B" "import System.IO.Unsafe (unsafePerformIO)"
        , source Store "C" "import System.IO", source Recognition "D" "f :: Prelude.IO ()"
        , source Code "E" "f = errors {- error -} \"undefined\"" ])
        `shouldBe`
        [ ["A", "B", "System.IO.Unsafe"], ["A", "B", "unsafePerformIO"], ["B", "System.IO.Unsafe"]
        , ["B", "unsafePerformIO"], ["D", "IO"] ]
    it "go round rings of imports once" $
      map (Map.keys . reaches ring) ring `shouldBe` [["A", "B"], ["A", "B"]]
    it "read dependencies from common stanzas and conditions" $
      components (unlines
        [ "name: p", "common shared", "  build-depends: base >=4 && <5", "-- a comment", "library code"
        , "  import: shared", "  build-depends:", "      a >=1 && <2", "    , p:q", "  exposed-modules:", "    M.N", "    O"
        , "  if flag(x)", "    build-depends: hspec ^>=2", "test-suite t", "  main-is: T.hs" ])
        `shouldBe`
        [Component "library code" ["a", "p:q", "hspec", "base"] ["M.N", "O"], Component "test-suite t" [] ["T.hs"]]
    it "draw each module in its wing and each import as an arrow" $ do
      let drawn = lines (dot
            [source Code "PraTactile.A" "import PraTactile.B", source Code "PraTactile.B" "import Data.List"])
      filter (elem '>') drawn `shouldBe` ["  \"PraTactile.A\" -> \"PraTactile.B\";"]
      filter ("  subgraph" `isPrefixOf`) drawn `shouldBe` ["  subgraph \"cluster_code\" {"]
  where
    described = (,) <$> readHouse "." <*> (components <$> readText "pra-tactile.cabal")
    ring = [source Code "A" "import B", source Code "B" "import A"]
    ofFactorisation = isPrefixOf "PraTactile.Factorisation"
    wingsOf house = Map.fromList [(sourceName one, sourceWing one) | one <- house]

-- What the code wing may use beside base, which is all it could import from elsewhere.
beyondBase :: [String]
beyondBase =
  [ "PraTactile", "Data.Vector", "Data.Map", "Data.IntMap", "Data.Set", "Data.IntSet", "Data.Sequence", "Data.Tree"
  , "Data.Graph", "Data.Containers", "Data.Reflection" ]

componentOf :: Wing -> String
componentOf wing = case wing of
  Recognition -> "library"
  App -> "library command-line"
  _ -> "library " ++ wingName wing

-- The packages that each library may depend on.
allowances :: [(String, [String])]
allowances =
  [ ("library common", ["base", "random", "vector"])
  , ("library code", ["base", "containers", "pra-tactile:common", "reflection", "vector"])
  , ("library touch"
    , ["base", "bytestring", "cassava", "containers", "file-embed", "hmatrix", "JuicyPixels", "pra-tactile:common", "random", "text"
      , "vector"])
  , ("library"
    , ["base", "bytestring", "containers", "filepath", "random", "vector", "pra-tactile:code", "pra-tactile:touch"])
  , ("library files", ["base", "bytestring", "containers", "directory", "filepath", "pra-tactile"])
  , ("library formats", ["base", "aeson", "bytestring", "containers", "scientific", "text", "pra-tactile"])
  , ("library store"
    , [ "base", "containers", "directory", "filepath", "monad-logger", "mtl", "persistent", "persistent-sqlite"
      , "resourcet", "text", "transformers", "unix", "pra-tactile", "pra-tactile:code" ])
  , ("library conformance"
    , ["base", "containers", "QuickCheck", "transformers", "vector", "pra-tactile", "pra-tactile:code", "pra-tactile:touch"])
  ]
