-- | All decoders on every content of small windows; and the two that need no table, on patches in
-- which no window is complete and on large arrays.
module Test.Code.Locate.EveryContent
  ( spec,
    smallArrays,
    toPatch,
  )
where

import Control.Monad (forM_)
import Data.List (nub, sortOn)
import qualified Data.Map.Strict as Map
import Data.Proxy (Proxy)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Locate
import PraTactile.Locate.Decision
import PraTactile.Locate.Decoder.Algebra
import PraTactile.Locate.Decoder.Codebook
import PraTactile.Locate.Decoder.Nearest
import PraTactile.Locate.Definition
import PraTactile.Locate.Patch (patchOf)
import PraTactile.Polynomial
import PraTactile.Window
import Test.Code.Generators
import Test.Effort
import Test.Hspec
import Test.Paper

spec :: Spec
spec = do
  it "every content of a window of every small array has one outcome by all decoders" $
    forM_ smallArrays $ \(q, n, shape, window) ->
      overField q $ \k -> do
        h <- firstOver k n
        everyContent (const True) h shape [cellsOf window]
  it "so has every other content of masks of any shape, of arrays up to some hundred cells" $
    forM_ (byEffort (filter cheap everyArray) everyArray) $ \(q, n, polynomials) ->
      overField q $ \(_ :: Proxy k) -> do
        found <- take polynomials <$> right (primitivePolynomials n) :: IO [Primitive k]
        -- Every content for the first polynomial; for the others all that occur and as many that
        -- may not.
        forM_ (zip [0 :: Int ..] found) $ \(number, h) ->
          forM_ (shapesOf (fromIntegral q ^ n - 1)) $ \shape ->
            everyContent
              (\size -> number == 0 && size <= 512)
              h
              shape
              (masksFor (fromIntegral n) shape)
  it "where no window is complete, search still answers: all positions that agree" $ do
    array <- paperArray
    m <- paperWindow
    let observed =
          zipWith
            (zipWith (\here a -> if here then a else Nothing))
            [[True, False, True], [False, True, True]]
            (look array (Shape 2 3) (Position 6 5))
    p <- right (patch observed)
    searchPatch (ArrayOn Torus array) m p `shouldBe` Right (Unique (Position 6 5) [])
    few <- right (patch (take 1 observed))
    case searchPatch (ArrayOn Torus array) m few of
      Right (Ambiguous places []) -> length places `shouldBe` 4 ^ (4 - 2 :: Int)
      other -> expectationFailure (show other)
  it "the algebra needs no table, on 2^60 cells: a 15 x 2 window, or any 30 independent cells" $ do
    array <- vastArray
    algebra <- vastAlgebra
    forM_
      [ Position 0 0,
        Position 123456789 987654321,
        Position (4 ^ (15 :: Int) - 2) (4 ^ (15 :: Int))
      ]
      $ \place -> do
        let located cells = right (patch cells) >>= right . algebraPatch algebra
            seven = look array (Shape 7 7) place
            changed f = zipWith (\i -> zipWith (f i) [0 ..]) [0 :: Int ..] seven
        located (look array (Shape 15 2) place) `shouldReturn` Unique place [Position 0 0]
        located (changed (\i j a -> if (i * 7 + j * 3) `mod` 4 == 0 then Nothing else a))
          `shouldReturn` Unique place []
        located (changed (\i j a -> if (i, j) == (3, 4 :: Int) then (+ 1) <$> a else a))
          `shouldReturn` Refused Contradiction
        located (look array (Shape 1 10) place)
          `shouldReturn` AmbiguousMany (4 ^ (20 :: Int)) (Just 20)
  it "the algebra refuses a surface on which the sequence does not go on" $ do
    array <- paperArray
    m <- paperWindow
    (() <$ prepareAlgebra (ArrayOn TwistedTorus array) m)
      `shouldBe` Left (SurfaceForeign TwistedTorus Torus)
  it "an array beyond 2^20 cells is not searched" $ do
    array <- arrayOver gf2 21 RowMajor (Shape 1 (2 ^ (21 :: Int) - 1))
    m <- right (rectangle (Shape 1 21))
    p <- right (patch [replicate 21 (Just 1)])
    searchPatch (ArrayOn TwistedTorus array) m p
      `shouldBe` Left (TooManyPlaces (2 ^ (21 :: Int) - 1) (2 ^ (20 :: Int)))
    (() <$ buildCodebook (ArrayOn TwistedTorus array) m)
      `shouldBe` Left (TooManyPlaces (2 ^ (21 :: Int) - 1) (2 ^ (20 :: Int)))

-- | The field's order, the degree, a shape of q^n - 1 cells, and a window: with the window
-- property, with windows that repeat, and with more cells than are needed.
smallArrays :: [(Int, Natural, Shape, Shape)]
smallArrays =
  [ (2, 4, Shape 3 5, Shape 2 2),
    (2, 6, Shape 7 9, Shape 3 2),
    (2, 6, Shape 7 9, Shape 2 2),
    (2, 4, Shape 3 5, Shape 3 3),
    (3, 3, Shape 2 13, Shape 1 3),
    (3, 3, Shape 2 13, Shape 2 3),
    (4, 2, Shape 3 5, Shape 2 2),
    (4, 4, Shape 15 17, Shape 2 2),
    (4, 4, Shape 15 17, Shape 1 3),
    (5, 3, Shape 4 31, Shape 1 3),
    (9, 2, Shape 8 10, Shape 1 2),
    (9, 2, Shape 5 16, Shape 1 2),
    (16, 1, Shape 3 5, Shape 1 2)
  ]

-- | The field's order, the degree, and how many of the primitive polynomials are taken, in order.
everyArray :: [(Int, Natural, Int)]
everyArray =
  [(2, n, 8) | n <- [1 .. 5]] ++ [(2, 6, 2), (2, 7, 1)]
    ++ [(3, n, 8) | n <- [1 .. 3]]
    ++ [(3, 4, 1)]
    ++ [ (4, 1, 2),
         (4, 2, 4),
         (4, 3, 1),
         (5, 1, 2),
         (5, 2, 4),
         (5, 3, 1),
         (7, 1, 2),
         (7, 2, 1),
         (8, 1, 6),
         (8, 2, 1),
         (9, 1, 4),
         (9, 2, 1),
         (16, 1, 2)
       ]

-- | Of up to fifty cells.
cheap :: (Int, Natural, Int) -> Bool
cheap (q, n, _) = q ^ n <= 50

-- | Of this many cells in all.
shapesOf :: Natural -> [Shape]
shapesOf cells = [Shape r (cells `div` r) | r <- takeWhile (<= cells) [1 ..], cells `mod` r == 0]

-- | Masks for degree n: a rectangle, a crooked line, a rectangle with a hole and without its own
-- upper left cell, one cell less than tells a position, one more.
masksFor :: Int -> Shape -> [[Position]]
masksFor n (Shape high wide) =
  filter (not . null) . nub $
    [ take
        n
        [Position i j | i <- below high, j <- below (if wide >= 2 && high >= 2 then 2 else wide)],
      take
        n
        ( nub
            [Position (i `div` 2 `mod` high) ((i + 1) `div` 2 `mod` wide) | i <- [0 .. high + wide]]
        ),
      take
        n
        ( drop
            1
            [Position i j | i <- below (min 3 high), j <- below (max 3 wide), (i, j) /= (1, 1)]
        ),
      take (max 1 (n - 1)) [Position i j | j <- below wide, i <- below high],
      take (n + 1) [Position i j | i <- below high, j <- below wide]
    ]

-- | On every surface, all contents of cells with these offsets, or all that occur and as many that
-- may not: which are all, is said of their number.
everyContent ::
  KnownField k => (Natural -> Bool) -> Primitive k -> Shape -> [[Position]] -> Expectation
everyContent allOf h shape masks =
  forM_ [(Diagonal, Torus), (Diagonal, Sheet), (RowMajor, TwistedTorus), (RowMajor, Sheet)] $
    \(folding, surface) ->
      forM_ (either (const []) pure (folded folding shape h)) $ \array ->
        forM_ masks $ \offsets -> do
          m <- right (maskFrom offsets)
          table <- right (buildTable MostSignificantFirst (ArrayOn surface array) m)
          codebook <- right (buildCodebook (ArrayOn surface array) m)
          algebra <- right (prepareAlgebra (ArrayOn surface array) m)
          let occurring = map fst (tableEntries table)
              contents
                | allOf (tableSize table) = [0 .. tableSize table - 1]
                | otherwise = occurring ++ map (\w -> (w + 1) `mod` tableSize table) occurring
              -- Where each content stands, by looking at all windows.
              standing =
                Map.fromListWith
                  (flip (++))
                  [ (map toCode content, [p])
                    | p <- cellsOf shape,
                      Just content <- [windowAt (ArrayOn surface array) m p]
                  ]
              failing =
                [ (codes, arrayPrimitive array, shape, folding, surface, offsets)
                  | packed <- contents,
                    Right codes <-
                      [unpack MostSignificantFirst (fieldOrder array) (maskSize m) packed],
                    Right content <- [traverse fromCode codes],
                    not
                      ( alike
                          (searchPatch (ArrayOn surface array) m)
                          table
                          codebook
                          algebra
                          (patchOf (maskExtent m) (sortOn fst (zip offsets content)))
                          (Map.findWithDefault [] codes standing)
                      )
                ]
          failing `shouldBe` []

-- | All decoders have the same outcome, and it has these positions.
alike ::
  KnownField k =>
  (Patch (GF k) -> Either LocateError (Outcome Position)) ->
  Table k ->
  Codebook k ->
  Algebra k ->
  Patch (GF k) ->
  [Position] ->
  Bool
alike search table codebook algebra p places =
  search p == Right byTable
    && algebraPatch algebra p == Right byTable
    && decisionOutcome (nearest codebook (UpTo 0) p) == byTable
    && positions byTable == places
  where
    byTable = locatePatch table p
    positions outcome = case outcome of
      Unique place _ -> [place]
      Ambiguous several _ -> several
      _ -> []

toPatch :: KnownField k => Shape -> [Int] -> [[[Maybe (GF k)]]]
toPatch window codes =
  [rowsOf (columns window) (map Just cells) | Right cells <- [traverse fromCode codes]]
