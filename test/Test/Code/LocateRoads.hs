-- | The roads from observed cells to position agree.
module Test.Code.LocateRoads
  ( spec,
    smallArrays,
    toPatch,
  )
where

import Control.Monad (forM_)
import Data.List (nub)
import qualified Data.Map.Strict as Map
import Data.Proxy (Proxy (..))
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Locate
import PraTactile.Locate.Decision
import PraTactile.Locate.Decoder.Algebra
import PraTactile.Locate.Decoder.Codebook
import PraTactile.Locate.Decoder.Nearest
import PraTactile.Locate.Definition
import PraTactile.Polynomial
import PraTactile.Window
import Test.Code.Generators
import Test.Hspec
import Test.QuickCheck hiding (elements)
import qualified Test.QuickCheck as QuickCheck

spec :: Spec
spec = do
  it "every window of every small array, and every content, has the same outcome by all roads" $
    forM_ smallArrays $ \(q, n, shape, window) ->
      forM_ (lookup q everyField) $ \(SomeField (k :: Proxy k)) -> do
        h <- firstOver k n
        forM_
          [(Diagonal, Torus), (Diagonal, Sheet), (RowMajor, TwistedTorus), (RowMajor, Sheet)]
          $ \(folding, surface) ->
            forM_ (either (const []) pure (folded folding shape h)) $ \array -> do
              m <- right (rectangle window)
              table <- right (buildTable MostSignificantFirst surface array m)
              shelf <- right (buildCodebook surface array m)
              algebra <- right (prepareAlgebra surface array m)
              let contents =
                    [ grid
                      | packed <- [0 .. tableSize table - 1],
                        Right codes <- [unpack MostSignificantFirst q (maskSize m) packed],
                        grid <- toPatch window codes
                    ]
              [cells | cells <- contents, not (agree surface array m table shelf algebra cells)]
                `shouldBe` []
  it
    "every window and every other content, of masks of any shape, on every surface, of arrays of \
    \every size up to some hundred cells, has the same outcome by all roads"
    $ forM_ everyArray $ \(q, n, polynomials) ->
      forM_ (lookup q everyField) $ \(SomeField (_ :: Proxy k)) -> do
        found <- take polynomials <$> right (primitivePolynomials n) :: IO [Primitive k]
        forM_ (zip [0 :: Int ..] found) $ \(number, h) ->
          forM_ (shapesOf (fromIntegral q ^ n - 1)) $ \shape ->
            forM_
              [(Diagonal, Torus), (Diagonal, Sheet), (RowMajor, TwistedTorus), (RowMajor, Sheet)]
              $ \(folding, surface) ->
                forM_ (either (const []) pure (folded folding shape h)) $ \array ->
                  forM_ (masksFor (fromIntegral n) shape) $ \offsets -> do
                    m <- right (maskFrom offsets)
                    table <- right (buildTable MostSignificantFirst surface array m)
                    shelf <- right (buildCodebook surface array m)
                    algebra <- right (prepareAlgebra surface array m)
                    -- Every content for the first polynomial; for the others all that occur
                    -- and as many that may not.
                    let contents
                          | number == 0 && tableSize table <= 512 = [0 .. tableSize table - 1]
                          | otherwise =
                            let windows =
                                  map fst (tableEntries table)
                             in windows
                                  ++ map (\packed -> (packed + 1) `mod` tableSize table) windows
                        patches =
                          [ (cells, codes)
                            | packed <- contents,
                              Right codes <- [unpack MostSignificantFirst q (maskSize m) packed],
                              Right content <- [traverse fromCode codes],
                              let cells = drawn offsets content
                          ]
                        -- Where each content stands, by looking at all windows.
                        standing =
                          Map.fromListWith
                            (flip (++))
                            [ (map toCode content, [p])
                              | r <- below (rows shape),
                                c <- below (columns shape),
                                let p = Position r c,
                                Just content <- [windowAt surface array m p]
                            ]
                    let failing =
                          [ (cells, array')
                            | (cells, codes) <- patches,
                              not
                                ( alike
                                    surface
                                    array
                                    m
                                    table
                                    shelf
                                    algebra
                                    cells
                                    (Map.findWithDefault [] codes standing)
                                ),
                              let array' = (q, n, number, shape, folding, surface, offsets)
                          ]
                    failing `shouldBe` []
  it
    "patches of the paper's array with holes and errors have the same outcome where a window is \
    \complete"
    $ do
      array <- right paperPrimitive >>= right . folded Diagonal (Shape 15 17)
      m <- right (rectangle (Shape 2 2))
      forM_ [Torus, Sheet] $ \surface -> do
        table <- right (buildTable MostSignificantFirst surface array m)
        shelf <- right (buildCodebook surface array m)
        algebra <- right (prepareAlgebra surface array m)
        holds 1500 $
          forAll (genPatch array) $ \cells -> agree surface array m table shelf algebra cells
  it
    "where no window is complete, search and the nearest position still answer: all positions \
    \that agree"
    $ do
      array <- right paperPrimitive >>= right . folded Diagonal (Shape 15 17)
      m <- right (rectangle (Shape 2 2))
      let observed =
            [ [Just (cellAt array (Position 6 5)), Nothing, Just (cellAt array (Position 6 7))],
              [Nothing, Just (cellAt array (Position 7 6)), Just (cellAt array (Position 7 7))]
            ]
      p <- right (patch observed)
      searchPatch Torus array m p `shouldBe` Right (Unique (Position 6 5) [])
      few <- right (patch (take 1 observed))
      case searchPatch Torus array m few of
        Right (Ambiguous places []) -> length places `shouldBe` 4 ^ (4 - 2 :: Int)
        other -> expectationFailure (show other)
  it
    "the algebra does without a table, on 2^60 cells over GF(4): from a 15x2 window, or any 30 \
    \independent cells"
    $ do
      h <- firstOver (Proxy :: Proxy GF4) 30
      array <- right (folded Diagonal (Shape (4 ^ (15 :: Int) - 1) (4 ^ (15 :: Int) + 1)) h)
      m <- right (rectangle (Shape 15 2))
      algebra <- right (prepareAlgebra Torus array m)
      forM_
        [ Position 0 0,
          Position 123456789 987654321,
          Position (4 ^ (15 :: Int) - 2) (4 ^ (15 :: Int))
        ]
        $ \place@(Position r c) -> do
          let seen i j = Just (cellAt array (Position (r + i) (c + j)))
          window <- right (patch [[seen i j | j <- [0, 1]] | i <- [0 .. 14]])
          algebraPatch algebra window `shouldBe` Right (Unique place [Position 0 0])
          scattered <-
            right
              ( patch
                  [ [if (i * 7 + j * 3) `mod` 4 == 0 then Nothing else seen i j | j <- [0 .. 6]]
                    | i <- [0 .. 6]
                  ]
              )
          algebraPatch algebra scattered `shouldBe` Right (Unique place [])
          wrong <-
            right
              ( patch
                  [ [if (i, j) == (3, 4) then (+ 1) <$> seen i j else seen i j | j <- [0 .. 6]]
                    | i <- [0 .. 6]
                  ]
              )
          algebraPatch algebra wrong `shouldBe` Right (Refused Contradiction)
          few <- right (patch [[seen 0 j | j <- [0 .. 9]]])
          algebraPatch algebra few `shouldBe` Right (AmbiguousMany (4 ^ (20 :: Int)) (Just 20))
  it "the algebra refuses a surface on which the sequence does not go on" $ do
    array <- right paperPrimitive >>= right . folded Diagonal (Shape 15 17)
    m <- right (rectangle (Shape 2 2))
    (() <$ prepareAlgebra TwistedTorus array m) `shouldBe` Left (SurfaceForeign TwistedTorus Torus)
  it "an array beyond 2^20 cells is not searched" $ do
    h <- firstOver (Proxy :: Proxy GF2) 21
    array <- right (folded RowMajor (Shape 1 (2 ^ (21 :: Int) - 1)) h)
    m <- right (rectangle (Shape 1 21))
    p <- right (patch [replicate 21 (Just 1)])
    searchPatch TwistedTorus array m p
      `shouldBe` Left (TooManyPlaces (2 ^ (21 :: Int) - 1) (2 ^ (20 :: Int)))
    (() <$ buildCodebook TwistedTorus array m)
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

-- | The patch that a window with these codes is, in reading order.
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

-- | Of so many cells in all.
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

-- | The patch of these cells, unobserved elsewhere.
drawn :: [Position] -> [a] -> [[Maybe a]]
drawn offsets content =
  [ [lookup (Position i j) observed | j <- [0 .. maximum (map column offsets)]]
    | i <- [0 .. maximum (map row offsets)]
  ]
  where
    observed = zip offsets content

below :: Natural -> [Natural]
below k = takeWhile (< k) [0 ..]

-- | All roads have the same outcome, and it has these positions.
alike ::
  KnownField k =>
  Surface ->
  PseudorandomArray k ->
  Mask ->
  Table k ->
  Codebook k ->
  Algebra k ->
  [[Maybe (GF k)]] ->
  [Position] ->
  Bool
alike surface array m table shelf algebra cells places = case patch cells of
  Left _ -> False
  Right p ->
    let byTable = locatePatch table p
     in searchPatch surface array m p == Right byTable
          && algebraPatch algebra p == Right byTable
          && decisionOutcome (nearest shelf (UpTo 0) p) == byTable
          && positions byTable == places
  where
    positions outcome = case outcome of
      Unique place _ -> [place]
      Ambiguous several _ -> several
      _ -> []

toPatch :: KnownField k => Shape -> [Int] -> [[[Maybe (GF k)]]]
toPatch window codes = [rowsOf (map Just cells) | Right cells <- [traverse fromCode codes]]
  where
    rowsOf cells = case splitAt (fromIntegral (columns window)) cells of
      ([], _) -> []
      (r, rest) -> r : rowsOf rest

-- | The search agrees with the table wherever that uses the patch, and the nearest position,
-- without a correction, and the algebra with the search always.
agree ::
  KnownField k =>
  Surface ->
  PseudorandomArray k ->
  Mask ->
  Table k ->
  Codebook k ->
  Algebra k ->
  [[Maybe (GF k)]] ->
  Bool
agree surface array m table shelf algebra cells = case patch cells of
  Left _ -> False
  Right p ->
    let byTable = locatePatch table p
        bySearch = searchPatch surface array m p
     in (byTable == Refused NoCompleteWindow || bySearch == Right byTable)
          && algebraPatch algebra p == Right (either (const (Refused TooFewCells)) id bySearch)
          && Right (decisionOutcome (nearest shelf (UpTo 0) p)) == bySearch

-- | A patch of the array with unobserved cells, sometimes with an error, sometimes across the
-- edges.
genPatch :: KnownField k => PseudorandomArray k -> Gen [[Maybe (GF k)]]
genPatch array = do
  h <- choose (1, 4)
  w <- choose (1, 4)
  r <- choose (0, 14)
  c <- choose (0, 16)
  errors <- QuickCheck.elements [0, 0, 8, 60 :: Int]
  unobserved <- QuickCheck.elements [0, 10, 30, 60 :: Int]
  let observe a = do
        wrong <- (< errors) <$> choose (0, 99)
        gone <- (< unobserved) <$> choose (0, 99)
        b <- if wrong then genElement else pure a
        pure (if gone then Nothing else Just b)
  mapM
    (mapM observe)
    [ [cellAt array (Position (fromInteger (r + i)) (fromInteger (c + j))) | j <- [0 .. w - 1]]
      | i <- [0 .. h - 1]
    ]
