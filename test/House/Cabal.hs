{-# LANGUAGE DerivingStrategies #-}

-- | What the package's description says of its components: the packages each depends on and the modules each has. It reads
-- no more of the format than it needs: sections, their fields, and the fields' lists, common stanzas and conditions
-- included.
module House.Cabal
  ( Component (..)
  , components
  ) where

import Data.Char (isAlphaNum, isSpace, toLower)
import Data.List (isPrefixOf)
import qualified Data.Map.Strict as Map

-- | A component, by the words of its section's head, such as @library code@.
data Component = Component
  { componentName :: String
  , dependencies :: [String]
    -- ^ packages, and of this one's libraries @pra-tactile:code@ and so on
  , componentModules :: [String]
  }
  deriving stock (Eq, Show)

-- | The components of a package's description.
components :: String -> [Component]
components text =
  [ Component name
      (concatMap dependency (concatMap (splitOn ',') (field "build-depends" fields)))
      (words (map (\letter -> if letter == ',' then ' ' else letter)
        (unwords (concatMap (`field` fields) ["exposed-modules", "other-modules", "main-is"]))))
  | (name, own) <- sections, not ("common" `isPrefixOf` name), let fields = inherited own ]
  where
    sections = sectionsOf (filter (not . all isSpace) (filter (not . comment) (lines text)))
    comment line = "--" `isPrefixOf` dropWhile isSpace line
    commons = Map.fromList
      [(unwords (drop 1 (words name)), fields) | (name, fields) <- sections, "common" `isPrefixOf` name]
    inherited own = own ++ concat
      [ inherited fields
      | value <- field "import" own, name <- splitOn ',' value, Just fields <- [Map.lookup (strip name) commons] ]

type Field = (String, String)

field :: String -> [Field] -> [String]
field name fields = [value | (key, value) <- fields, key == name]

-- A section begins at the left margin and is no field; within it, what is indented deeper than a field's name belongs to
-- the field. Conditions are transparent: what they guard counts.
sectionsOf :: [String] -> [(String, [Field])]
sectionsOf given = case given of
  [] -> []
  line : others
    | indent line == 0, Nothing <- fieldOf line ->
        let (body, more) = span ((> 0) . indent) others
        in (unwords (words line), fieldsOf body) : sectionsOf more
    | otherwise -> sectionsOf others

fieldsOf :: [String] -> [Field]
fieldsOf given = case given of
  [] -> []
  line : others -> case fieldOf line of
    Just (name, value) ->
      let (deeper, more) = span ((> indent line) . indent) others
      in (name, unwords (value : map strip deeper)) : fieldsOf more
    Nothing -> fieldsOf others

fieldOf :: String -> Maybe Field
fieldOf line = case span (\letter -> isAlphaNum letter || letter == '-') (strip line) of
  (name, ':' : value) | not (null name) -> Just (map toLower name, strip value)
  _ -> Nothing

indent :: String -> Int
indent = length . takeWhile isSpace

strip :: String -> String
strip = dropWhile isSpace . reverse . dropWhile isSpace . reverse

-- @pra-tactile:{code, touch}@ would be split by its comma; the description spells such names out.
dependency :: String -> [String]
dependency entry = take 1 (words (takeWhile (`notElem` "<>=^&|()") (strip entry)))

splitOn :: Char -> String -> [String]
splitOn mark text = case break (== mark) text of
  (part, _ : more) -> part : splitOn mark more
  (part, []) -> [part]
