{-# OPTIONS_GHC -O1 #-}

-- | The memory table: which positions it holds, and that in bulk it answers as one by one. What it
-- answers about patches is held by "Test.Code.Locate.EveryDecoderAsDefined".
module Test.Code.Locate.MemoryTable (spec) where

import Control.Monad (forM_)
import Data.Int (Int32)
import Data.List (nub, sort)
import qualified Data.Map.Strict as Map
import Data.Proxy (Proxy (..))
import qualified Data.Vector.Primitive as Primitive
import Data.Word (Word32)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Locate
import PraTactile.Locate.Bulk
import PraTactile.Window
import Test.Code.Generators
import Test.Code.Locate.EveryDecoderAsDefined (smallArrays)
import Test.Effort
import Test.Hspec
import Test.Paper
import Test.QuickCheck (conjoin, forAll, forAllShrink, ioProperty, withMaxSuccess, (===))
import qualified Test.QuickCheck as QuickCheck

spec :: Spec
spec = do
  it "patches without cells or with ragged rows are refused" $ do
    let none cells = () <$ patch (cells :: Cells)
    none [] `shouldBe` Left PatchEmpty
    none [[], []] `shouldBe` Left PatchEmpty
    none [[Just 1, Nothing], [Just 1]] `shouldBe` Left (PatchRagged 1 1 2)
  it "tables of more than 2^26 entries are refused" $ do
    array <- paperArray
    m <- right (rectangle (Shape 2 7))
    (() <$ buildTable MostSignificantFirst (ArrayOn Torus array) m)
      `shouldBe` Left (TableTooLarge (4 ^ (14 :: Int)) largestTable)
    large <- arrayOver gf4 14 RowMajor (Shape 5 (4 ^ (14 :: Int) `div` 5))
    small <- paperWindow
    (() <$ buildTable MostSignificantFirst (ArrayOn Torus large) small)
      `shouldBe` Left (TableTooLarge (4 ^ (14 :: Int) - 1) largestTable)
  it "a packed window is found, under either packing" $
    forM_ [minBound ..] $ \packing -> do
      array <- paperArray
      m <- paperWindow
      table <- right (buildTable packing (ArrayOn Torus array) m)
      forM_ everywhere $ \p -> do
        Just content <- pure (windowAt (ArrayOn Torus array) m p)
        tableLookup table (pack packing 4 (map toCode content)) `shouldBe` [p]
  it "the table has every position once, each in the entry of its window" $
    do
      array <- paperArray
      m <- right (mask [(0, 0), (2, 3)])
      table <- right (buildTable MostSignificantFirst (ArrayOn Torus array) m)
      sort (concatMap snd (tableEntries table)) `shouldBe` everywhere
      forM_ (tableEntries table) $ \(packed, there) -> forM_ there $ \p ->
        fmap (pack MostSignificantFirst 4 . map toCode) (windowAt (ArrayOn Torus array) m p)
          `shouldBe` Just packed
      tableLookup table 16 `shouldBe` []
      tableSize table `shouldBe` 16
  it "the packed form agrees with the table, for every small array, surface and packing" $
    forM_ smallArrays $ \(q, n, shape, window) ->
      overField q $ \k -> do
        h <- firstOver k n
        m <- right (rectangle window)
        forM_
          [ (folding, surface, packing)
            | folding <- [Diagonal, RowMajor],
              surface <- [minBound .. maxBound],
              packing <- [minBound .. maxBound]
          ]
          $ \(folding, surface, packing) ->
            forM_ (either (const []) pure (folded folding shape h)) $ \array -> do
              table <- right (buildTable packing (ArrayOn surface array) m)
              let all' = everyWindow (tableSize table)
                  found = locateWindows (memoryOf table) all'
                  expected packed = case tableLookup table (fromIntegral packed) of
                    [] -> notOccurring
                    [place] -> linear shape place
                    _ -> notUnique
              memorySize (memoryOf table) `shouldBe` fromIntegral q ^ maskSize m
              Primitive.length found `shouldBe` Primitive.length all'
              let failing =
                    [ packed
                      | (packed, place) <- zip (Primitive.toList all') (Primitive.toList found),
                        place /= expected packed
                    ]
              failing `shouldBe` []
  it "every window of 63 x 65 cells is found at its position, over GF(4) and GF(2)" $ do
    foundWhereItStands gf4 6 (Shape 63 65) (Shape 3 2)
    foundWhereItStands gf2 12 (Shape 63 65) (Shape 6 2)
  beforeAll (firstOver gf4 7)
    . it "every window of 3 x 5461 cells is found at its position, for any mask and surface"
    $ \h ->
      withMaxSuccess (byEffort 2 7)
        . forAllShrink genMask (filter (not . null) . QuickCheck.shrinkList (const []))
        $ \offsets ->
          conjoin
            [ ioProperty $ do
                m <- right (mask offsets)
                array <- right (folded folding (Shape 3 5461) h)
                table <- right (buildTable LeastSignificantFirst (ArrayOn surface array) m)
                let standing =
                      [ (pack LeastSignificantFirst 4 (map toCode content), p)
                        | p <- places (Shape 3 5461),
                          Just content <- [windowAt (ArrayOn surface array) m p]
                      ]
                pure
                  ( Map.fromListWith (flip (++)) [(w, [p]) | (w, p) <- standing]
                      === Map.fromList (tableEntries table)
                  )
              | (folding, surface) <-
                  [(Diagonal, Torus), (RowMajor, TwistedTorus), (Diagonal, Sheet)]
            ]
  it "numbers from q^cells up are packed windows of no position" $ do
    memory <- paperMemory
    let beyond =
          [ 256,
            257,
            511,
            512,
            65535,
            65536,
            2 ^ (26 :: Int),
            2 ^ (31 :: Int) - 1,
            2 ^ (31 :: Int),
            2 ^ (31 :: Int) + 78,
            maxBound - 1,
            maxBound
          ]
    Primitive.toList (locateWindows memory (Primitive.fromList beyond))
      `shouldBe` map (const notOccurring) beyond
  beforeAll (paperTable Sheet)
    . it "any list of numbers gets one answer for each, in order"
    $ \table ->
      withMaxSuccess 300
        . forAll
          (QuickCheck.listOf (QuickCheck.oneof [QuickCheck.choose (0, 300), QuickCheck.arbitrary]))
        $ \numbers ->
          Primitive.toList (locateWindows (memoryOf table) (Primitive.fromList numbers))
            === [ case tableLookup table (fromIntegral w) of
                    [place] -> linear (Shape 15 17) place
                    _ -> notOccurring
                  | w <- numbers
                ]
  it "the worked example: 3 2 / 3 1 packs to 237, and its position (6, 5) to 107" $ do
    memory <- paperMemory
    a <- right (traverse fromCode [3, 2, 3, 1])
    packWindow memory a `shouldBe` Just 237
    locateOne memory 237 `shouldBe` 107
    unpackPosition memory 107 `shouldBe` Just (Position 6 5)
    packPosition memory (Position 6 5) `shouldBe` Just 107
    locateOne memory 0 `shouldBe` notOccurring
  it "values outside the range are neither packed nor unpacked" $ do
    memory <- paperMemory
    map (unpackPosition memory) [notOccurring, notUnique, minBound, -3, 255, maxBound]
      `shouldBe` replicate 6 Nothing
    [unpackPosition memory p | p <- [0 .. 254]]
      `shouldBe` [Just (Position r c) | r <- [0 .. 14], c <- [0 .. 16]]
    map (packPosition memory) [Position 15 0, Position 0 17, Position (2 ^ (32 :: Int)) 0]
      `shouldBe` [Nothing, Nothing, Nothing]
    map (packWindow memory . map (const 1)) [[], [1, 2, 3 :: Int], [1, 2, 3, 4], [1 .. 5], [1 ..]]
      `shouldBe` [Nothing, Nothing, Just 85, Nothing, Nothing]

paperMemory :: IO (Memory GF4)
paperMemory = memoryOf <$> paperTable Torus

-- | One to ten offsets, some beyond the edges, some such that windows cross the edge near column
-- 4096.
genMask :: QuickCheck.Gen [(Natural, Natural)]
genMask =
  nub
    <$> QuickCheck.resize
      10
      ( QuickCheck.listOf1
          ((,) <$> upTo 9 <*> QuickCheck.oneof [upTo 4, upTo 5000, (1363 +) <$> upTo 4])
      )
  where
    upTo n = fromInteger <$> QuickCheck.choose (0, n - 1)

everyWindow :: Natural -> Primitive.Vector Word32
everyWindow size = Primitive.enumFromN 0 (fromIntegral size)

locateOne :: Memory k -> Word32 -> Int32
locateOne memory = Primitive.head . locateWindows memory . Primitive.singleton

linear :: Shape -> Position -> Int32
linear shape (Position r c) = fromIntegral (r * columns shape + c)

foundWhereItStands :: forall k. KnownField k => Proxy k -> Natural -> Shape -> Shape -> Expectation
foundWhereItStands k n shape window = do
  h <- firstOver k n
  array <- right (folded Diagonal shape h)
  m <- right (rectangle window)
  memory <- memoryOf <$> right (buildTable MostSignificantFirst (ArrayOn Torus array) m)
  let packed =
        [ w
          | p <- places shape,
            Just content <- [windowAt (ArrayOn Torus array) m p],
            Just w <- [packWindow memory content]
        ]
  map (unpackPosition memory) (Primitive.toList (locateWindows memory (Primitive.fromList packed)))
    `shouldBe` map Just (places shape)

places :: Shape -> [Position]
places shape = [Position r c | r <- [0 .. rows shape - 1], c <- [0 .. columns shape - 1]]
