{-# LANGUAGE OverloadedStrings #-}

-- | Hostile inputs of any format: garbage, or a valid specimen with a few mutations of its bytes,
-- its words or its JSON. The list of mutations is drawn, so that a failure shrinks to the mutation
-- that matters.
module Test.Hostile.Mutation
  ( Hostile,
    hostile,
    lessHostile,
    specimenOf,

    -- * Replacements
    hostileNumbers,
    hostileWords,
  )
where

import Data.Aeson (Value (..), decodeStrict', encode)
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Bytes8
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (isAlphaNum)
import Data.Foldable (toList)
import Data.List (mapAccumL)
import Test.QuickCheck

-- | An input, described by how it is made.
data Hostile
  = Garbage ByteString
  | -- | the specimen with this index, with these mutations one after the other
    Mutated Int [Mutation]
  deriving stock (Eq, Show)

-- | A change. Places and indexes are taken modulo the number available.
data Mutation
  = -- | a number of bytes from a place become these
    Splice Int Int ByteString
  | -- | a number of bytes from a place stand there a number of times more
    Repeat Int Int Int
  | -- | one of the runs of letters and digits becomes this
    Token Int ByteString
  | -- | one of the nodes of JSON, counted from the outermost, is changed
    Node Int Change
  deriving stock (Eq, Show)

-- | A change of a node of JSON.
data Change
  = Become ByteString
  | -- | in a number of lists
    Nested Int
  | -- | without one of its children
    Without Int
  | -- | with one of its children twice, under the same key
    Twice Int
  | -- | with one of its children repeated, under keys of their own; a text or a number with its
    -- characters repeated
    Again Int Int
  | -- | with another key for one of its children
    Rekeyed Int ByteString
  | -- | without children
    Emptied
  deriving stock (Eq, Show)

-- | A few mutations of one of these specimens; one input in ten is garbage.
hostile :: Int -> Gen Hostile
hostile specimens =
  frequency
    [ (1, Garbage <$> garbage),
      (9, Mutated <$> choose (0, specimens - 1) <*> (several >>= \n -> vectorOf n mutation))
    ]
  where
    several = frequency [(1, pure 0), (6, pure 1), (6, choose (2, 4)), (1, choose (5, 12))]
    garbage =
      oneof
        [ Bytes.pack <$> listOf arbitrary,
          Bytes.concat <$> listOf (elements (hostileNumbers ++ hostileWords ++ [",", " ", "\n"]))
        ]

mutation :: Gen Mutation
mutation =
  frequency
    [ (3, Splice <$> place <*> short <*> (Bytes.singleton <$> arbitrary)),
      (4, Splice <$> place <*> elements [0, 0, 1, 4] <*> texts),
      (1, Splice <$> place <*> pure maxBound <*> pure ""),
      (1, Repeat <$> place <*> short <*> frequency [(8, choose (1, 3)), (1, choose (4, 2000))]),
      (8, Token <$> place <*> texts),
      (6, Node <$> place <*> change)
    ]
  where
    place = choose (0, 65535)
    short = frequency [(6, choose (0, 4)), (2, choose (5, 80)), (1, choose (81, 4000))]
    texts = elements (hostileNumbers ++ hostileWords)
    child = choose (0, 63)
    change =
      frequency
        [ ( 4,
            Become
              <$> elements (hostileNumbers ++ hostileWords ++ ["[0]", "{\"a\":0}", "\"0\""])
          ),
          (1, Nested <$> frequency [(4, choose (1, 3)), (1, choose (50, 5000))]),
          (3, Without <$> child),
          (2, Twice <$> child),
          -- Long repetitions now and then show costs that are out of proportion.
          (2, Again <$> child <*> frequency [(30, choose (1, 40)), (1, choose (20000, 200000))]),
          (1, Rekeyed <$> child <*> elements ["", "q", "at", "schema", "\\u0000", "a.b[0]"]),
          (2, pure Emptied)
        ]

-- | Fewer mutations, and gentler ones.
lessHostile :: Hostile -> [Hostile]
lessHostile given = case given of
  Garbage bytes -> Garbage . Bytes.pack <$> shrink (Bytes.unpack bytes)
  Mutated i mutations -> Mutated i <$> shrinkList gentler mutations
  where
    gentler m = case m of
      Splice at count text -> [Splice at count' text | count' <- shrink count]
      Repeat at count times -> [Repeat at count' times' | (count', times') <- shrink (count, times)]
      Node at (Again j count) -> [Node at (Again j count') | count' <- shrink count]
      _ -> []

-- | The bytes of an input that is made of these specimens.
specimenOf :: [ByteString] -> Hostile -> ByteString
specimenOf specimens given = case given of
  Garbage bytes -> bytes
  Mutated i mutations -> foldl (flip mutated) (Bytes.concat (take 1 (drop i specimens))) mutations

mutated :: Mutation -> ByteString -> ByteString
mutated how bytes = case how of
  Splice i count given ->
    let (before, after) = Bytes.splitAt (i `mod` (size + 1)) bytes
     in before <> given <> Bytes.drop count after
  Repeat i count times ->
    let (before, after) = Bytes.splitAt (i `mod` (size + 1)) bytes
        part = Bytes.take count after
     in before <> Bytes.concat (replicate (often 65536 times part) part) <> after
  Token i given ->
    let parts = Bytes8.groupBy (\a b -> isAlphaNum a && isAlphaNum b) bytes
        isToken = maybe False (isAlphaNum . fst) . Bytes8.uncons
        count = length (filter isToken parts)
        exchanged k part
          | isToken part = (k + 1, if k == i `mod` count then given else part)
          | otherwise = (k, part)
     in Bytes.concat (snd (mapAccumL exchanged 0 parts))
  Node i change -> maybe bytes (rendered . changedAt i change . treeOf) (decodeStrict' bytes)
  where
    size = Bytes.length bytes

-- | The number of repetitions, lowered so that the result has at most the first number of bytes.
often :: Int -> Int -> ByteString -> Int
often largest times part = min times (largest `div` (Bytes.length part + 1))

-- | JSON as text, in which a key may occur twice and a number need not be one: leaves, lists, and
-- objects with their keys.
data Tree = Leaf ByteString | Items [Tree] | Entries [(ByteString, Tree)]

treeOf :: Value -> Tree
treeOf value = case value of
  Array items -> Items (map treeOf (toList items))
  Object fields ->
    Entries [(asText (String (Key.toText key)), treeOf item) | (key, item) <- KeyMap.toList fields]
  other -> Leaf (asText other)
  where
    asText = Lazy.toStrict . encode

rendered :: Tree -> ByteString
rendered tree = case tree of
  Leaf text -> text
  Items items -> "[" <> Bytes.intercalate "," (map rendered items) <> "]"
  Entries fields ->
    "{" <> Bytes.intercalate "," [key <> ":" <> rendered item | (key, item) <- fields] <> "}"

-- | The tree with one of its nodes changed.
changedAt :: Int -> Change -> Tree -> Tree
changedAt i change tree = snd (visited (0 :: Int) tree)
  where
    (count, _) = go (\k node -> (k + 1, node)) 0 tree
    visited = go (\k node -> (k + 1, if k == i `mod` count then changed change node else node))
    -- Children first, so that a changed node is not visited.
    go act k node = case node of
      Leaf _ -> act k node
      Items items -> let (k', items') = mapAccumL (go act) k items in act k' (Items items')
      Entries fields ->
        let (k', fields') = mapAccumL (\n (key, item) -> (,) key <$> go act n item) k fields
         in act k' (Entries fields')

changed :: Change -> Tree -> Tree
changed change tree = case (change, tree) of
  (Become text, _) -> Leaf text
  (Nested depth, _) ->
    Leaf (Bytes8.replicate depth '[' <> rendered tree <> Bytes8.replicate depth ']')
  (Again _ times, Leaf text)
    | Just inner <- Bytes.stripPrefix "\"" text >>= Bytes.stripSuffix "\"" ->
      Leaf ("\"" <> Bytes.concat (replicate (often mebibyte times text) inner) <> "\"")
    | otherwise -> Leaf (Bytes.concat (replicate (often mebibyte times text) text))
  (_, Leaf _) -> Leaf "{}"
  (_, Items items) -> Items (map snd (amongChildren change [("", item) | item <- items]))
  (_, Entries fields) -> Entries (amongChildren change fields)

mebibyte :: Int
mebibyte = 1048576

amongChildren :: Change -> [(ByteString, Tree)] -> [(ByteString, Tree)]
amongChildren change children = case (change, drop (index change) children) of
  (Without _, _ : after) -> before ++ after
  (Twice _, one : _) -> children ++ [one]
  (Again _ times, (_, item) : _) ->
    children
      ++ [ (Bytes8.pack (show (show k)), item)
           | k <- [1 .. often mebibyte times (rendered item)]
         ]
  (Rekeyed _ key, (_, item) : after) -> before ++ ("\"" <> key <> "\"", item) : after
  (Emptied, _) -> []
  _ -> children
  where
    before = take (index change) children
    index how = case how of
      Without j -> wrapped j
      Twice j -> wrapped j
      Again j _ -> wrapped j
      Rekeyed j _ -> wrapped j
      _ -> 0
    wrapped j = j `mod` max 1 (length children)

-- | Replacements for a number: at the edges of machine words, of any size, in forms of other
-- languages, and texts that are no number.
hostileNumbers :: [ByteString]
hostileNumbers =
  Bytes8.words
    "0 -1 1 2 3 4 9 16 64 255 256 65535 65536 16777217 2147483647 2147483648 4294967296 \
    \9007199254740993 9223372036854775807 9223372036854775808 -9223372036854775809 \
    \18446744073709551616 00000000000000000000000000000001 0.1 0.5 1.0 -0 -0.0 1e5 1e308 1e309 \
    \1e-400 1e1000000000 1e-1000000000 1E99999999999999999999 0. .5 1e +1 1_000 0x10 0b1 1f (1) \
    \1,0 \xd9\xa3 NaN nan Infinity -inf"
    ++ ["", " 1", "1 ", "1" <> Bytes8.replicate 400 '0', Bytes8.replicate 20000 '9']

-- | Words of other formats, brackets left open, and bytes that are no text.
hostileWords :: [ByteString]
hostileWords =
  Bytes8.words
    "A A^2 A^-1 A^99999999999999999999 ? null true \" \"\" \"1\" [ ] [] { } {} [[ : ; , / // # . - \
    \\\ \\u0000 \\ud800 x 15x17 2x2 torus yes P2 P5 P6 =1+1 %s%n $(id) -- <?xml?>"
    ++ ["# comment\n", "\n", "\r\n", "\r", "\n\n", "\t", " ", "\0"]
    ++ ["\xef\xbb\xbf", "\xff\xfe", "\xff"]
    ++ ["\xc0\x80", "\xed\xa0\x80", "\xe2\x80\xa8", "\x1b[31m"]
    ++ [Bytes8.replicate 3000 '[', Bytes8.replicate 3000 '{', Bytes8.replicate 5000 'x']
    ++ [Bytes8.replicate 2000 '/', Bytes.concat (replicate 1000 "{\"a\":")]
