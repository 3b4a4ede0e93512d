-- | Tests a rule that neither the compiler nor cabal enforces: the conformance definitions do not
-- import what they are compared with.
module Test.House (spec) where

import Data.Char (isUpper)
import Data.Foldable (for_)
import Data.List (isInfixOf, isPrefixOf)
import Documents.Transcript (readText)
import System.Process (readProcess)
import Test.Hspec

spec :: Spec
spec = do
  for_ ofThePackage $ \(name, known) ->
    it (name ++ " imports from this package " ++ nothingBut known) $ do
      found <- importsUnder name
      filter (not . among known) (filter (among ["PraTactile"]) (map fst found)) `shouldBe` []
  it "the conformance definitions import only types from the library" $ do
    found <- importsUnder "PraTactile.Conformance.Definition"
    filter beyondTypes found `shouldBe` []
  where
    beyondTypes (one, listed) =
      one `under` "PraTactile"
        && (one `under` "PraTactile.Conformance.Library" || not (one `under` conformance))
        && (null listed || any (not . isUpper) (concatMap (take 1) listed))
    conformance = "PraTactile.Conformance"
    among folders one = any (one `under`) folders
    nothingBut known = if null known then "nothing" else "nothing but " ++ unwords known
    one `under` folder = one == folder || (folder ++ ".") `isPrefixOf` one

-- | Modules, by their name or their folder's, and what they may import of this package.
ofThePackage :: [(String, [String])]
ofThePackage =
  [ ("PraTactile.Field.Definition", []),
    ("PraTactile.Factorisation", ["PraTactile.Factorisation"]),
    ("PraTactile.LinearCode", ["PraTactile.Field", "PraTactile.LinearCode"])
  ]

-- | The imports of the modules of this name, or of its folder.
importsUnder :: String -> IO [(String, [String])]
importsUnder name = do
  files <- lines <$> readProcess "find" ["src", "-name", "*.hs"] ""
  let path = '/' : map (\letter -> if letter == '.' then '/' else letter) name
  let under' file = any (`isInfixOf` file) [path ++ ".hs", path ++ "/"]
  own <- traverse readText (filter under' files)
  own `shouldSatisfy` (not . null)
  pure (concatMap importsOf own)

-- | The imports of a module, each with the names that it lists.
importsOf :: String -> [(String, [String])]
importsOf text = case break ("import " `isPrefixOf`) (lines text) of
  (_, []) -> []
  (_, line : others) ->
    let (more, rest) = span (" " `isPrefixOf`) others
     in imported (filter (/= "..") (words (map spaced (unwords (line : more))))) :
        importsOf (unlines rest)
  where
    imported parts = case parts of
      "import" : "qualified" : name : _ -> (name, [])
      "import" : name : listed -> (name, listed)
      _ -> ("", [])
    spaced letter = if letter `elem` "()," then ' ' else letter
