{-# LANGUAGE OverloadedStrings #-}

-- | Mutations of JSON as a tree: what is still JSON, but not what is expected. Keys may occur
-- twice, and numbers may be written as no library would write them.
module Test.Hostile.Structure
  ( Change (..),
    change,
    restructured,
    largest,
  )
where

import Data.Aeson (Value (..), decodeStrict', encode)
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Bytes8
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (toList)
import Data.List (mapAccumL)
import Test.QuickCheck

-- | What becomes of a node.
data Change
  = -- | this text
    Become ByteString
  | -- | without one of its children
    Without Int
  | -- | with one of its children twice, under the same key
    Twice Int
  | -- | with two of its children exchanged
    Twisted Int Int
  | -- | with another key for one of its children
    Renamed Int ByteString
  | -- | in this many lists
    Nested Int
  | -- | with one of its children this often again, under keys of their own; a text or a number with
    -- all that it is this often
    Lengthened Int Int
  | -- | its first child alone
    Bare
  | -- | a list without any of its items
    Emptied
  deriving stock (Eq, Show)

-- | A change in which these texts may be used.
change :: [ByteString] -> Gen Change
change texts =
  frequency
    [ (4, Become <$> elements (texts ++ values)),
      (3, Without <$> child),
      (2, Twice <$> child),
      (2, Twisted <$> child <*> child),
      (1, Renamed <$> child <*> elements ["", "q", "at", "Q", "schema", "\\u0000", "a.b[0]"]),
      (1, Nested <$> frequency [(4, choose (1, 3)), (1, choose (50, 5000))]),
      (2, Lengthened <$> child <*> sizes),
      (1, pure Bare),
      (2, pure Emptied)
    ]
  where
    child = choose (0, 63)
    -- Long ones now and then: what is not in proportion shows there.
    sizes = frequency [(30, choose (2, 40)), (6, choose (100, 2000)), (1, choose (20000, 200000))]
    values =
      [ "null",
        "true",
        "[]",
        "{}",
        "[0]",
        "{\"a\":0}",
        "\"\"",
        "\"0\"",
        "\"18446744073709551616\"",
        "-5",
        "2.5"
      ]

-- | No text has more bytes that is lengthened here, but for those that it had.
largest :: Int
largest = 1048576

-- | JSON without its meaning.
data Tree = Leaf ByteString | Items [Tree] | Entries [(ByteString, Tree)]

-- | The JSON with a change of one of its nodes that can be changed so, counted from the outermost;
-- without such a node, or if it is no JSON, it stays as it is.
restructured :: Int -> Change -> ByteString -> ByteString
restructured i how bytes = maybe bytes (spoilt . treeOf) (decodeStrict' bytes)
  where
    spoilt tree = case sizeOf how tree of
      0 -> bytes
      nodes -> rendered (changedAt (i `mod` nodes) how tree)

treeOf :: Value -> Tree
treeOf value = case value of
  Array items -> Items (map treeOf (toList items))
  Object fields ->
    Entries
      [(Lazy.toStrict (encode (Key.toText key)), treeOf item) | (key, item) <- KeyMap.toList fields]
  other -> Leaf (Lazy.toStrict (encode other))

rendered :: Tree -> ByteString
rendered tree = case tree of
  Leaf text -> text
  Items items -> "[" <> Bytes.intercalate "," (map rendered items) <> "]"
  Entries fields ->
    "{" <> Bytes.intercalate "," [key <> ":" <> rendered item | (key, item) <- fields] <> "}"

-- | How many of the nodes can be changed so: any, but only lists can be emptied.
sizeOf :: Change -> Tree -> Int
sizeOf how tree =
  own how tree + case tree of
    Leaf _ -> 0
    Items items -> sum (map (sizeOf how) items)
    Entries fields -> sum (map (sizeOf how . snd) fields)

own :: Change -> Tree -> Int
own Emptied tree = case tree of
  Items _ -> 1
  _ -> 0
own _ _ = 1

-- | The tree with its node of that index changed.
changedAt :: Int -> Change -> Tree -> Tree
changedAt i how = snd . go i
  where
    -- The index that is left beside the tree: below 0 once the node was met.
    go k tree
      | k == 0 && own how tree == 1 = (-1, changed how tree)
      | k < 0 = (k, tree)
      | otherwise = case tree of
        Leaf _ -> (left, tree)
        Items items -> Items <$> mapAccumL go left items
        Entries fields ->
          Entries <$> mapAccumL (\k' (key, item) -> (,) key <$> go k' item) left fields
      where
        left = k - own how tree

changed :: Change -> Tree -> Tree
changed how tree = case (how, tree) of
  (Become text, _) -> Leaf text
  (Emptied, _) -> Items []
  (Nested depth, _) ->
    Leaf (Bytes.replicate depth 0x5B <> rendered tree <> Bytes.replicate depth 0x5D)
  (Lengthened _ count, Leaf text)
    | Just inner <- Bytes.stripPrefix "\"" text >>= Bytes.stripSuffix "\"" ->
      Leaf ("\"" <> Bytes.concat (replicate (often count text) inner) <> "\"")
    | otherwise -> Leaf (Bytes.concat (replicate (often count text) text))
  (_, Leaf _) -> Leaf "{}"
  (Lengthened j count, Items items)
    | item : _ <- rotated j items -> Items (items ++ replicate (often count (rendered item)) item)
  (Lengthened j count, Entries fields)
    | (_, item) : _ <- rotated j fields ->
      Entries
        ( fields
            ++ [ ("\"" <> Bytes8.pack (show k) <> "\"", item)
                 | k <- [1 .. often count (rendered item)]
               ]
        )
  (_, Items items) -> maybe tree Items (onList items)
  (Renamed j key, Entries fields) ->
    Entries
      [ (if k == j `mod` length fields then "\"" <> key <> "\"" else old, item)
        | (k, (old, item)) <- zip [0 ..] fields
      ]
  (Bare, Entries ((_, item) : _)) -> item
  (_, Entries fields) -> maybe tree Entries (onList fields)
  where
    rotated j items = drop (j `mod` max 1 (length items)) items
    often count text = min count (largest `div` (Bytes.length text + 1))
    onList items = case (how, length items) of
      (_, 0) -> Nothing
      (Without j, n) -> Just (take (j `mod` n) items ++ drop (j `mod` n + 1) items)
      (Twice j, n) -> Just (items ++ take 1 (drop (j `mod` n) items))
      (Twisted j k, n) ->
        Just
          (concat [take 1 (drop (exchanged (j `mod` n) (k `mod` n) l) items) | l <- [0 .. n - 1]])
      (Bare, _) -> Just (take 1 items)
      _ -> Nothing
    exchanged j k l
      | l == j = k
      | l == k = j
      | otherwise = l
