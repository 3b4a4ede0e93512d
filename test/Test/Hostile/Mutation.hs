{-# LANGUAGE OverloadedStrings #-}

-- | Inputs that mean ill: a valid specimen with a few mutations, or none of it. What is drawn is
-- the list of mutations, so that a failure shrinks to the one that matters.
module Test.Hostile.Mutation
  ( Hostile (..),
    hostile,
    lessHostile,
    specimenOf,
    Mutation (..),
    mutated,

    -- * What stands where a number should
    hostileNumbers,
    hostileWords,
    longest,
  )
where

import Data.Bits (xor)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Bytes8
import Data.Char (isAlphaNum, isDigit)
import Data.Word (Word8)
import Test.Hostile.Structure
import Test.QuickCheck

-- | An input, by how it is made.
data Hostile
  = Garbage ByteString
  | -- | of the specimen with this index, one after the other
    Mutated Int [Mutation]
  deriving stock (Eq, Show)

-- | A change of bytes. Places are taken modulo what there is.
data Mutation
  = -- | bits of the byte there
    Flip Int Word8
  | Insert Int ByteString
  | -- | this many bytes from there
    Delete Int Int
  | CutOff Int
  | -- | this many bytes from there, this often again
    Repeat Int Int Int
  | SwapTokens Int Int
  | -- | a run of letters and digits
    ReplaceToken Int ByteString
  | -- | a run of digits
    ReplaceNumber Int ByteString
  | -- | LF becomes CR LF
    LineEnds
  | -- | of JSON
    Structural Int Change
  deriving stock (Eq, Show)

-- | Mutations of this many specimens, mostly a few; one in ten is garbage.
hostile :: Int -> Gen Hostile
hostile specimens =
  frequency
    [ (1, Garbage <$> garbage),
      (9, Mutated <$> choose (0, specimens - 1) <*> (several >>= \n -> vectorOf n mutation))
    ]
  where
    several = frequency [(1, pure 0), (6, pure 1), (6, choose (2, 4)), (1, choose (5, 12))]

garbage :: Gen ByteString
garbage =
  oneof
    [ Bytes.pack <$> listOf arbitrary,
      Bytes8.pack <$> listOf (elements "0123456789.,:;/-+eE \n\r\t\"[]{}?AxP#\\\0"),
      Bytes.concat <$> listOf (elements (hostileNumbers ++ hostileWords ++ [",", " ", "\n"]))
    ]

mutation :: Gen Mutation
mutation =
  frequency
    [ (3, Flip <$> place <*> arbitrary),
      (3, Insert <$> place <*> elements hostileWords),
      (2, Delete <$> place <*> short),
      (1, CutOff <$> place),
      (1, Repeat <$> place <*> short <*> frequency [(8, choose (1, 3)), (1, choose (4, 2000))]),
      (2, SwapTokens <$> place <*> place),
      (4, ReplaceToken <$> place <*> elements (hostileNumbers ++ hostileWords)),
      (5, ReplaceNumber <$> place <*> elements hostileNumbers),
      (1, pure LineEnds),
      (6, Structural <$> place <*> change (hostileNumbers ++ hostileWords))
    ]
  where
    place = choose (0, 65535)
    short = frequency [(6, choose (1, 4)), (2, choose (5, 80)), (1, choose (81, 4000))]

-- | Fewer mutations, and gentler ones.
lessHostile :: Hostile -> [Hostile]
lessHostile given = case given of
  Garbage bytes -> Garbage . Bytes.pack <$> shrink (Bytes.unpack bytes)
  Mutated i mutations -> Mutated i <$> shrinkList gentler mutations
  where
    gentler m = case m of
      Repeat at count times ->
        [Repeat at count' times | count' <- shrink count]
          ++ [Repeat at count times' | times' <- shrink times]
      Delete at count -> [Delete at count' | count' <- shrink count]
      Structural at (Lengthened j count) ->
        [Structural at (Lengthened j count') | count' <- shrink count]
      _ -> []

-- | The bytes of an input that is made of these specimens.
specimenOf :: [ByteString] -> Hostile -> ByteString
specimenOf specimens given = case given of
  Garbage bytes -> bytes
  Mutated i mutations -> foldl (flip mutated) (Bytes.concat (take 1 (drop i specimens))) mutations

-- | No input that is made here has more bytes, but for JSON that was lengthened ('largest').
longest :: Int
longest = 65536

-- | The bytes with a mutation.
mutated :: Mutation -> ByteString -> ByteString
mutated how bytes = Bytes.take bound $ case how of
  Flip i mask -> replaced i 1 (Bytes.map (xor mask) (Bytes.take 1 (after i)))
  Insert i given -> replaced i 0 given
  Delete i count -> replaced i count ""
  CutOff i -> before i
  Repeat i count times ->
    replaced
      i
      0
      ( Bytes.concat
          (replicate (min times (longest `div` max 1 count)) (Bytes.take count (after i)))
      )
  SwapTokens i j -> swapped i j (Bytes8.groupBy together bytes)
  ReplaceToken i given ->
    Bytes.concat (substituted i (isAlphaNum . firstOf) given (Bytes8.groupBy together bytes))
  ReplaceNumber i given ->
    Bytes.concat
      ( substituted
          i
          (isDigit . firstOf)
          given
          (Bytes8.groupBy (\a b -> isDigit a && isDigit b) bytes)
      )
  LineEnds -> Bytes.intercalate "\r\n" (Bytes8.split '\n' bytes)
  Structural i how' -> restructured i how' bytes
  where
    bound = case how of
      Structural _ (Lengthened _ _) -> largest
      _ -> max longest size
    size = Bytes.length bytes
    at i = i `mod` (size + 1)
    before i = Bytes.take (at i) bytes
    after i = Bytes.drop (at i) bytes
    replaced i count given = before i <> given <> Bytes.drop count (after i)
    together a b = isAlphaNum a && isAlphaNum b
    firstOf part = maybe ' ' fst (Bytes8.uncons part)
    swapped i j parts =
      let n = max 1 (length parts)
          pick k = Bytes.concat (take 1 (drop (k `mod` n) parts))
          other k part
            | k == i `mod` n = pick j
            | k == j `mod` n = pick i
            | otherwise = part
       in Bytes.concat (zipWith other [0 ..] parts)

-- | The list with one of its items that are so replaced.
substituted :: Int -> (a -> Bool) -> a -> [a] -> [a]
substituted i such given items = go (i `mod` max 1 (length (filter such items))) items
  where
    go _ [] = []
    go k (item : others)
      | such item = if k == 0 then given : others else item : go (k - 1) others
      | otherwise = item : go k others

-- | What is not the number wanted: at the edges of machine words, of any size, in forms of other
-- languages, none at all.
hostileNumbers :: [ByteString]
hostileNumbers =
  [ "0",
    "-1",
    "1",
    "2",
    "3",
    "4",
    "9",
    "16",
    "64",
    "255",
    "256",
    "65535",
    "65536",
    "16777217",
    "2147483647",
    "2147483648",
    "4294967296",
    "9007199254740993",
    "9223372036854775807",
    "9223372036854775808",
    "-9223372036854775809",
    "18446744073709551616",
    "1" <> Bytes8.replicate 400 '0',
    Bytes8.replicate 20000 '9',
    "00000000000000000000000000000001",
    "0.1",
    "0.5",
    "1.0",
    "-0",
    "-0.0",
    "1e5",
    "1e308",
    "1e309",
    "1e400",
    "1e-400",
    "1e1000000000",
    "1e-1000000000",
    "1e999999999",
    "1E99999999999999999999",
    "0.",
    ".5",
    "1e",
    "+1",
    " 1",
    "1 ",
    "1_000",
    "0x10",
    "0b1",
    "0o7",
    "1f",
    "(1)",
    "1,0",
    "\xd9\xa3",
    "",
    "NaN",
    "nan",
    "Infinity",
    "-inf"
  ]

-- | Words of other formats, brackets left open, and bytes that are no text.
hostileWords :: [ByteString]
hostileWords =
  [ "A",
    "A^2",
    "A^-1",
    "A^99999999999999999999",
    "?",
    "null",
    "true",
    "\"",
    "\"\"",
    "\"1\"",
    "[",
    "]",
    "[]",
    "{",
    "}",
    "{}",
    "[[",
    ":",
    ";",
    ",",
    "/",
    "//",
    "#",
    "# comment\n",
    ".",
    "-",
    "\\",
    "\\u0000",
    "\\ud800",
    "x",
    "15x17",
    "2x2",
    "torus",
    "yes",
    "P2",
    "P5",
    "P6",
    "\n",
    "\r\n",
    "\r",
    "\n\n",
    "\t",
    " ",
    "\0",
    "\xef\xbb\xbf",
    "\xff\xfe",
    "\xff",
    "\xc0\x80",
    "\xed\xa0\x80",
    "\xe2\x80\xa8",
    "\x1b[31m",
    "=1+1",
    "%s%n",
    "$(id)",
    "--",
    "<?xml?>",
    Bytes8.replicate 3000 '[',
    Bytes8.replicate 3000 '{',
    Bytes8.replicate 5000 'x',
    Bytes8.replicate 2000 '/',
    Bytes.concat (replicate 1000 "{\"a\":")
  ]
