-- | Decoding by information sets: on small arrays what comparing with every position says, on large
-- ones the position that the patch was taken from.
module Test.Code.LocateBounded (spec) where

import Control.Monad (forM_)
import Data.List (sort)
import Data.Proxy (Proxy (..))
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Locate
import PraTactile.Locate.Decision
import PraTactile.Locate.Decoder.Algebra
import PraTactile.Locate.Decoder.Codebook
import PraTactile.Locate.Decoder.InformationSet
import PraTactile.Locate.Decoder.Nearest
import PraTactile.Window
import PraTactile.Window.Distance
import PraTactile.Window.Rank
import Test.Code.Decided
import Test.Code.Generators
import Test.Hspec
import Test.QuickCheck hiding (elements)
import qualified Test.QuickCheck as QuickCheck

spec :: Spec
spec = do
  it "on the paper's array, every pattern of errors within the guaranteed radius leads back" $ do
    array <- right paperPrimitive >>= right . folded Diagonal (Shape 15 17)
    window <- right (rectangle (Shape 2 2))
    algebra <- right (prepareAlgebra Torus array window)
    -- The code is linear, so that patterns at a few positions stand for those at all, and one of
    -- each pattern's multiples for the others.
    forM_
      [ (Shape 2 3, 0, 255),
        (Shape 3 2, 0, 255),
        (Shape 3 3, 1, 20),
        (Shape 3 4, 2, 2),
        (Shape 4 4, 3, 1)
      ]
      $ \(size, t, places) -> do
        m <- right (rectangle size)
        d <- right (minimumDistance array m)
        guaranteedRadius (distance d) `shouldSatisfy` (>= fromIntegral t)
        ready <- right (decoder standardEffort algebra (maskOffsets m))
        decoderDistance ready `shouldBe` Exactly (distance d)
        let wronged =
              [ (place, wrong, decoded)
                | i <- take places [5, 42 ..],
                  let place = Position (i `mod` 15) (i `mod` 17),
                  (wrong, word) <-
                    patterns t (zip (maskOffsets m) (content array place (maskOffsets m))),
                  let decoded =
                        patch (rowsOf (columns size) (map Just word))
                          `orElse` decodeWith ready Guaranteed
              ]
        length wronged `shouldSatisfy` (>= places)
        take
          3
          [ bad
            | bad@(place, wrong, decoded) <- wronged,
              fmap (\x -> (placeOf (decisionOutcome x), decisionWrong x)) decoded
                /= Right (Just place, wrong)
          ]
          `shouldBe` []
  describe
    "any patch with holes and errors is decoded as the comparison with every position says"
    $ do
      forM_ [(Diagonal, Torus), (Diagonal, Sheet)] $ \(folding, surface) ->
        it ("of the paper's array: " ++ show surface) $ do
          array <- right paperPrimitive >>= right . folded folding (Shape 15 17)
          asNearest 700 surface array (Shape 2 2)
      forM_ fields $ \(q, n, folding, shape, window) ->
        it ("over GF(" ++ show q ++ "), n = " ++ show n ++ ", " ++ show folding) $
          forM_ (lookup q everyField) $ \(SomeField (k :: Proxy k)) -> do
            array <- firstOver k n >>= right . folded folding shape
            forM_ [naturalSurface folding, Sheet] $ \surface -> asNearest 120 surface array window
  describe "on large arrays the position is the one that the patch was taken from" $ do
    it "GF(4), 2^60 cells: 8x8 cells, 4 missing" $
      large
        (Proxy :: Proxy GF4)
        30
        (Shape (4 ^ (15 :: Int) - 1) (4 ^ (15 :: Int) + 1))
        (Shape 15 2)
        (Shape 8 8)
        4
        7
        5
    it "GF(2), 2^64 cells: 12x12 cells, 10 missing" $
      large
        (Proxy :: Proxy GF2)
        64
        (Shape (2 ^ (32 :: Int) - 1) (2 ^ (32 :: Int) + 1))
        (Shape 32 2)
        (Shape 12 12)
        10
        3
        3
    it "GF(3), 3^25 cells: 7x7 cells, 3 missing" $
      large
        (Proxy :: Proxy GF3)
        25
        (Shape (3 ^ (5 :: Int) - 1) ((3 ^ (25 :: Int) - 1) `div` (3 ^ (5 :: Int) - 1)))
        (Shape 5 5)
        (Shape 7 7)
        3
        3
        4
  it "what is beyond the radius is refused, or is a position that is not farther" $ do
    (algebra, _) <-
      paperSized
        (Proxy :: Proxy GF4)
        30
        (Shape (4 ^ (15 :: Int) - 1) (4 ^ (15 :: Int) + 1))
        (Shape 15 2)
    m <- right (rectangle (Shape 8 8))
    ready <- right (decoder (Effort (2 ^ (17 :: Int)) (2 ^ (22 :: Int))) algebra (maskOffsets m))
    holds 20 $
      forAll (vectorOf 64 genElement) $ \word ->
        (patch (rowsOf 8 (map Just word)) `orElse` decodeWith ready Guaranteed)
          `isRight'` \decoded -> case decisionOutcome decoded of
            Refused BeyondRadius -> knownNearest decoded === AtLeast (decisionRadius decoded + 1)
            Unique place _ ->
              let wrong =
                    [ offset
                      | (offset, a, b) <-
                          zip3
                            (maskOffsets m)
                            word
                            (content (algebraArray algebra) place (maskOffsets m)),
                        a /= b
                    ]
               in conjoin
                    [ decisionWrong decoded === wrong,
                      property (fromIntegral (length wrong) <= decisionRadius decoded)
                    ]
            other -> counterexample (show other) False
  it "cells that do not tell positions apart leave a coset, whose size is told" $ do
    (algebra, array) <-
      paperSized
        (Proxy :: Proxy GF4)
        30
        (Shape (4 ^ (15 :: Int) - 1) (4 ^ (15 :: Int) + 1))
        (Shape 15 2)
    p <- right (patch [map Just (content array (Position 77 99) [Position 0 j | j <- [0 .. 9]])])
    decoded <- right (decodePatch algebra Guaranteed p)
    decisionOutcome decoded `shouldBe` AmbiguousMany (4 ^ (20 :: Int)) (Just 20)
    (knownDistance decoded, decisionRadius decoded, knownNearest decoded)
      `shouldBe` (Exactly 0, 0, Exactly 0)
  it
    "cells that depend on each other without telling positions apart: a coset if none is wrong, \
    \too many to tell if one is"
    $ do
      -- The 20 rows of a column are a subfield; each of the next 2 follows from them.
      (algebra, array) <-
        paperSized
          (Proxy :: Proxy GF2)
          40
          (Shape (2 ^ (20 :: Int) - 1) (2 ^ (20 :: Int) + 1))
          (Shape 20 2)
      let column' wrong =
            patch
              [ [Just (if i == wrong then a + 1 else a)]
                | i <- [0 .. 21],
                  let a = cellFrom array (Position 123 456) (Position i 0)
              ]
      windowRank array <$> rectangle (Shape 22 1) `shouldBe` Right 20
      exact <- right (column' 99)
      (decisionOutcome <$> decodePatch algebra Guaranteed exact)
        `shouldBe` Right (AmbiguousMany (2 ^ (20 :: Int)) (Just 20))
      wrong <- right (column' 7)
      (decisionOutcome <$> decodePatch algebra Guaranteed wrong)
        `shouldBe` Right (Refused Contradiction)
      decodePatch algebra (UpTo 1) wrong `shouldBe` Left (DecodingTooMany 1)
  it
    "a distance that was not searched to its end is told as what is proved, and its radius holds"
    $ do
      array <- right paperPrimitive >>= right . folded Diagonal (Shape 15 17)
      window <- right (rectangle (Shape 2 2))
      algebra <- right (prepareAlgebra Torus array window)
      forM_ [0, 5, 20, 100, 10000] $ \effort -> do
        offsets <- maskOffsets <$> right (rectangle (Shape 5 5))
        ready <- right (decoder (Effort effort (2 ^ (20 :: Int))) algebra offsets)
        decoderDistance ready `shouldSatisfy` \known -> case known of
          Exactly d -> d == 16
          AtLeast d -> d >= 6 && d <= 16
        let radius = guaranteedRadius (atLeast (decoderDistance ready))
        holds 40 $
          forAll (wronging (fromIntegral radius) (content array (Position 3 4) offsets)) $ \word ->
            (patch (rowsOf 5 (map Just word)) `orElse` decodeWith ready Guaranteed)
              `isRight'` \decoded ->
                placeOf (decisionOutcome decoded) === Just (Position 3 4)
  it "a search that would be too long is refused, and other cells than those prepared for" $ do
    (algebra, array) <-
      paperSized
        (Proxy :: Proxy GF4)
        30
        (Shape (4 ^ (15 :: Int) - 1) (4 ^ (15 :: Int) + 1))
        (Shape 15 2)
    m <- right (rectangle (Shape 8 8))
    ready <- right (decoder (Effort 0 100) algebra (maskOffsets m))
    let word = content array (Position 1 2) (maskOffsets m)
    exact <- right (patch (rowsOf 8 (map Just word)))
    (placeOf . decisionOutcome <$> decodeWith ready (UpTo 9) exact)
      `shouldBe` Right (Just (Position 1 2))
    wrong <-
      right
        ( patch
            ( rowsOf
                8
                ( zipWith
                    (\i a -> Just (if i `elem` [0, 9 .. 63 :: Int] then a + 1 else a))
                    [0 ..]
                    word
                )
            )
        )
    case decodeWith ready (UpTo 9) wrong of
      Left (DecodingTooLong cleared _ limit) -> (limit, cleared <= 8) `shouldBe` (100, True)
      other -> expectationFailure (show other)
    (() <$ (patch [[Just one, Just zero]] `orElse` decodeWith ready Guaranteed))
      `shouldBe` Left (Just DecodingOtherCells)
  where
    fields =
      [ (2, 6, Diagonal, Shape 7 9, Shape 3 2),
        (2, 6, RowMajor, Shape 9 7, Shape 2 3),
        (3, 3, Diagonal, Shape 2 13, Shape 1 3),
        (5, 3, Diagonal, Shape 4 31, Shape 1 3),
        (9, 2, Diagonal, Shape 5 16, Shape 1 2),
        (16, 2, Diagonal, Shape 15 17, Shape 1 2),
        (17, 2, RowMajor, Shape 9 32, Shape 1 2)
      ]

-- | The first array of this kind, prepared.
paperSized ::
  KnownField k =>
  Proxy k ->
  Natural ->
  Shape ->
  Shape ->
  IO (Algebra k, PseudorandomArray k)
paperSized k n shape window = do
  array <- firstOver k n >>= right . folded Diagonal shape
  m <- right (rectangle window)
  algebra <- right (prepareAlgebra Torus array m)
  pure (algebra, array)

-- | Random positions with so many missing cells, and as many wrong ones as the distance that is
-- proved guarantees, which is at least the first number, or else as many as the second, are found.
large ::
  KnownField k =>
  Proxy k ->
  Natural ->
  Shape ->
  Shape ->
  Shape ->
  Int ->
  Natural ->
  Int ->
  Expectation
large k n shape window size missing least errors = do
  (algebra, array) <- paperSized k n shape window
  m <- right (rectangle size)
  holds 3 $
    forAll
      ( (,)
          <$> (Position <$> below (rows shape) <*> below (columns shape))
          <*> shuffle (maskOffsets m)
      )
      $ \(place, shuffled) ->
        let offsets = sort (drop missing shuffled)
            told = (windowRank array <$> maskFrom offsets) == Right n
            sent = content array place offsets
            damaged wrong = zipWith (\at a -> if at `elem` wrong then a + 1 else a) offsets sent
            decodedFrom ready radius wrong =
              let seen = zip offsets (damaged wrong)
               in patch
                    [ [lookup (Position i j) seen | j <- [0 .. columns size - 1]]
                      | i <- [0 .. rows size - 1]
                    ]
                    `orElse` decodeWith ready radius
         in told
              ==> decoder (Effort (2 ^ (22 :: Int)) (2 ^ (24 :: Int))) algebra offsets
                `isRight'` \ready ->
                  let d = atLeast (decoderDistance ready)
                      certain =
                        sort (take (fromIntegral (guaranteedRadius d)) (drop missing shuffled))
                      more = sort (take errors (drop missing shuffled))
                      found radius wrong =
                        decodedFrom ready radius wrong `isRight'` \decoded ->
                          counterexample (show decoded) $
                            conjoin
                              [ placeOf (decisionOutcome decoded) === Just place,
                                decisionWrong decoded === wrong,
                                knownNearest decoded === Exactly (fromIntegral (length wrong))
                              ]
                      -- Beyond what is guaranteed another position may be as near, and must then be
                      -- told, too.
                      nearby wrong =
                        decodedFrom ready (UpTo (fromIntegral errors)) wrong `isRight'` \decoded ->
                          counterexample (show decoded) $ case decisionOutcome decoded of
                            Unique at _
                              | at == place -> decisionWrong decoded === wrong
                              | otherwise ->
                                property
                                  ( length
                                      ( filter
                                          id
                                          (zipWith (/=) (damaged wrong) (content array at offsets))
                                      )
                                      < length wrong
                                  )
                            Ambiguous places _ ->
                              property
                                ( place `elem` places
                                    || knownNearest decoded /= Exactly (fromIntegral (length wrong))
                                )
                            _ -> property False
                   in conjoin [property (d >= least), found Guaranteed certain, nearby more]
  where
    below side = fromInteger <$> choose (0, toInteger side - 1)

cellFrom :: KnownField k => PseudorandomArray k -> Position -> Position -> GF k
cellFrom array (Position r c) (Position i j) = cellAt array (Position (r + i) (c + j))

content :: KnownField k => PseudorandomArray k -> Position -> [Position] -> [GF k]
content array place = map (cellFrom array place)

-- | The comparison with every position and decoding say the same of random patches.
asNearest :: KnownField k => Int -> Surface -> PseudorandomArray k -> Shape -> Expectation
asNearest count surface array window = do
  m <- right (rectangle window)
  shelf <- right (buildCodebook surface array m)
  algebra <- right (prepareAlgebra surface array m)
  holds count $
    forAll
      ((,) <$> genDamaged array <*> oneof [pure Guaranteed, UpTo <$> QuickCheck.elements [0 .. 4]])
      $ \(cells, radius) ->
        case patch cells of
          Left e -> counterexample (show e) False
          Right p ->
            let decision = nearest shelf radius p
             in case decodePatch algebra radius p of
                  Left e -> counterexample (show e) False
                  Right decoded ->
                    counterexample (show (decision, decoded)) $
                      conjoin
                        [ decisionOutcome decoded === decisionOutcome decision,
                          decisionWrong decoded === decisionWrong decision,
                          decisionRadius decoded === decisionRadius decision,
                          if all (all (== Nothing)) cells
                            then property True
                            else knownDistance decoded === Exactly (decisionDistance decision),
                          property
                            ( maybe
                                True
                                (holdsOf (knownNearest decoded))
                                (decisionNearest decision)
                            ),
                          property
                            ( maybe
                                True
                                (\e -> maybe True (`holdsOf` e) (knownRunnerUp decoded))
                                (decisionRunnerUp decision)
                            )
                        ]
  where
    holdsOf known e = case known of
      Exactly n -> n == e
      AtLeast n -> n <= e

genDamaged :: KnownField k => PseudorandomArray k -> Gen [[Maybe (GF k)]]
genDamaged array = do
  h <- choose (1, 4)
  w <- choose (1, 4)
  r <- choose (0, 16)
  c <- choose (0, 31)
  errors <- QuickCheck.elements [0, 10, 25]
  gone <- QuickCheck.elements [0, 10, 30]
  let damage a = do
        fate <- choose (0, 99 :: Int)
        b <- genElement
        pure (if fate < gone then Nothing else if fate < gone + errors then Just b else Just a)
  mapM
    (mapM damage)
    [ [ cellFrom array (Position (fromInteger r) (fromInteger c)) (Position i j)
        | j <- take w [0 ..]
      ]
      | i <- take h [0 ..]
    ]

-- | All ways to have at most so many wrong symbols, the first of which is 1 more than it should be.
patterns :: KnownField k => Int -> [(Position, GF k)] -> [([Position], [GF k])]
patterns most cells' = concatMap (\k -> go True k cells') [0 .. most]
  where
    go :: KnownField k => Bool -> Int -> [(Position, GF k)] -> [([Position], [GF k])]
    go _ 0 cells = [([], map snd cells)]
    go _ _ [] = []
    go first k ((i, a) : rest) =
      [(wrong, a : word) | (wrong, word) <- go first k rest]
        ++ [ (i : wrong, b : word)
             | b <- if first then [a + 1] else elements,
               b /= a,
               (wrong, word) <- go False (k - 1) rest
           ]

-- | So many symbols wrong.
wronging :: KnownField k => Int -> [GF k] -> Gen [GF k]
wronging count word = do
  wrong <- take count <$> shuffle (zipWith const [0 :: Int ..] word)
  mapM
    (\(i, a) -> if i `elem` wrong then genElement `suchThat` (/= a) else pure a)
    (zip [0 ..] word)

placeOf :: Outcome Position -> Maybe Position
placeOf outcome = case outcome of
  Unique place _ -> Just place
  _ -> Nothing

orElse :: Either e a -> (a -> Either f b) -> Either (Maybe f) b
orElse given f = either (const (Left Nothing)) (either (Left . Just) Right . f) given

isRight' :: Show e => Either e a -> (a -> Property) -> Property
isRight' given f = either (\e -> counterexample (show e) False) f given

rowsOf :: Natural -> [a] -> [[a]]
rowsOf w cells = case splitAt (fromIntegral w) cells of
  ([], _) -> []
  (r, rest) -> r : rowsOf w rest
