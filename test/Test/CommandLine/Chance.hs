{-# LANGUAGE OverloadedStrings #-}

-- | What @locate@ and @decode@ tell of their answers' worth: by every road against going through
-- all contents, and on the command line as scripts see it.
module Test.CommandLine.Chance (spec) where

import Control.Monad (forM_)
import Data.Aeson
import Data.List (isInfixOf)
import Data.Proxy (Proxy (..))
import Data.Ratio ((%))
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named (GF2)
import PraTactile.Locate
import PraTactile.Symmetry
import PraTactile.Window
import Test.Code.Decided (ask)
import Test.Code.Generators
import Test.CommandLine.Run
import Test.Hspec
import Test.QuickCheck hiding (elements)
import qualified Test.QuickCheck as QuickCheck

spec :: Spec
spec = do
  describe "of all contents of the observed cells, the share that is located" $ do
    it
      "on the paper's array: of 2 x 2 cells 255 in 256, and 255 in 4096 of 2 x 3, by every road"
      $ do
        array <- right paperPrimitive >>= right . folded Diagonal (Shape 15 17)
        window <- right (rectangle (Shape 2 2))
        forM_ [(Shape 2 2, 255 % 256), (Shape 2 3, 255 % 4096)] $ \(shape, share) ->
          forM_ [Nothing, Just TableDecoder, Just AlgebraDecoder, Just SearchDecoder] $ \road -> do
            answers <-
              right
                ( traverse
                    (ask road (Torus, array, window) [identity] Guaranteed 0.001)
                    [ [((0, 0), Symbol <$> p)]
                      | Right p <-
                          map
                            (patch . rowsOf (columns shape) . map Just)
                            (mapM (const elements) [1 .. area shape])
                    ]
                )
            ( fromIntegral (length (filter isLocated answers)) % toInteger (length answers),
              take 1 (map worth answers)
              )
              `shouldBe` (share, [Just (Chance (fromRational share) True)])
    it
      "where one cell of nine is corrected, of 3 x 3 cells of 15: 15 spheres of 10 contents each"
      $ do
        array <- firstOver (Proxy :: Proxy GF2) 4 >>= right . folded Diagonal (Shape 3 5)
        window <- right (rectangle (Shape 2 2))
        answers <-
          right
            ( traverse
                (ask Nothing (Torus, array, window) [identity] Guaranteed 0.001)
                [ [((0, 0), Symbol <$> p)]
                  | Right p <-
                      map (patch . rowsOf 3 . map Just) (mapM (const elements) [1 .. 9 :: Int])
                ]
            )
        ( fromIntegral (length (filter isLocated answers)) % toInteger (length answers),
          take 1 (map worth answers)
          )
          `shouldBe` (150 % 512, [Just (Chance (150 / 512) True)])
    it "by every road, on every surface, in every orientation: exactly, or at most" $
      forM_ arrays $ \(q, n, folding, shape, window) ->
        forM_ (lookup q everyField) $ \(SomeField (k :: Proxy k)) -> do
          array <- firstOver k n >>= right . folded folding shape
          m <- right (rectangle window)
          holds 40 $
            forAllShrink (genCells q) (filter (not . null) . shrinkList (const [])) $ \offsets ->
              forAll genCall $ \(road, radius, turning, surface) ->
                enumerated
                  road
                  [ ask road (surface, array, m) turning radius 0.001 [((0, 0), Symbol <$> p)]
                    | Right p <- map (patch . laid offsets) (mapM (const elements) offsets)
                  ]
    it "of several patches together" $
      forM_ (take 2 arrays) $ \(q, n, folding, shape, window) ->
        forM_ (lookup q everyField) $ \(SomeField (k :: Proxy k)) -> do
          array <- firstOver k n >>= right . folded folding shape
          m <- right (rectangle window)
          holds 20 $
            forAll (choose (-2, 4)) $ \down ->
              forAll (choose (2, 5)) $ \along ->
                forAll genCall $ \(road, radius, turning, surface) ->
                  enumerated
                    road
                    [ ask
                        road
                        (surface, array, m)
                        turning
                        radius
                        0.001
                        [((0, 0), Symbol <$> one'), ((down, along), Symbol <$> other)]
                      | content <- mapM (const elements) [1 .. 6 :: Int],
                        Right one' <- [patch (rowsOf 2 (map Just (take 4 content)))],
                        Right other <- [patch [map Just (drop 4 content)]]
                    ]
    it "from probabilities: of the cells that leave no doubt, at most" $ do
      array <- right paperPrimitive >>= right . folded Diagonal (Shape 15 17)
      window <- right (rectangle (Shape 2 2))
      forM_
        [(turning, surface) | turning <- turnings, surface <- [Torus, Sheet]]
        $ \(turning, surface) -> do
          unsure <- right (belief [0.1, 0.9, 0, 0])
          let answers =
                [ ask
                    Nothing
                    (surface, array, window)
                    turning
                    Guaranteed
                    0.2
                    [((0, 0), Probabilities <$> p)]
                  | content <- mapM (const elements) [1 .. 5 :: Int],
                    Right p <-
                      [ patch
                          [ map (Just . certainly) (take 3 content),
                            Just unsure : map (Just . certainly) (drop 3 content)
                          ]
                      ]
                ]
              places = if surface == Sheet then 14 * 15 else 255 :: Double
          enumerated' answers `shouldBe` []
          fmap worth (sequence answers >>= maybe (Left NoSymmetry) Right . firstOf . take 1)
            `shouldBe` Right
              ( Just
                  ( Chance
                      ( min
                          1
                          ( case length turning of
                              1 ->
                                places
                              4 -> inTurns surface
                              _ -> 2 * inTurns surface
                              / 4
                              ^ (5 :: Int)
                          )
                      )
                      False
                  )
              )
  describe "as it is told" $ do
    it
      "locate --json: exact for 4, 6, 9 and 12 cells, at most where the radius is larger or the \
      \orientation unknown, null of no cells"
      $ do
        let told options text = do
              (_, out, _) <- pra (["locate", "--json"] ++ options ++ [text])
              pure (key ["chance"] out, key ["chance_is"] out)
            number share = Just (toJSON (fromRational share :: Double))
            zeros h w = unwords (drop 1 (concat (replicate h ("/" : replicate w "0"))))
        forM_
          [ (2, 2, 255 % 4 ^ (4 :: Int)),
            (2, 3, 255 % 4 ^ (6 :: Int)),
            (3, 3, 255 * 28 % 4 ^ (9 :: Int)),
            (3, 4, 255 * (1 + 36 + 594) % 4 ^ (12 :: Int))
          ]
          $ \(h, w, share) ->
            told [] (zeros h w) `shouldReturn` (number share, Just "exact")
        told ["--surface", "sheet"] "3 2 / 3 1" `shouldReturn` (number (224 % 256), Just "exact")
        told ["--radius", "1"] "3 2 / 3 1" `shouldReturn` (number 1, Just "at-most")
        told ["--radius", "2"] (zeros 3 3)
          `shouldReturn` (number (255 * (1 + 27 + 324) % 4 ^ (9 :: Int)), Just "at-most")
        told ["--orientation", "turned"] (zeros 2 3)
          `shouldReturn` (number (4 * 255 % 4096), Just "at-most")
        told [] "3 2" `shouldReturn` (number 1, Just "at-most")
        told [] "[[[0,0,0.1,0.9],2],[3,1]]" `shouldReturn` (number 1, Just "at-most")
        told [] "? ? / ? ?" `shouldReturn` (Just Null, Just Null)
        (_, batch, _) <- praWith ["locate", "--batch"] "3 2 / 3 1\n3 2 /\n"
        map (\line -> (key ["chance"] line, key ["chance_is"] line)) (lines batch)
          `shouldBe` [(number (255 % 256), Just "exact"), (Just Null, Just Null)]
    it "locate --json: on 2^60 cells, 8 x 8 of them" $ do
      (_, first', _) <- pra ["polynomials", "--q", "4", "--degree", "30", "--first"]
      (_, out, _) <-
        pra
          [ "locate",
            "--json",
            "--q",
            "4",
            "--polynomial",
            concat (take 1 (lines first')),
            "--shape",
            "1073741823x1073741825",
            "--window",
            "15x2",
            "--road",
            "algebra",
            unwords (drop 1 (concat (replicate 8 ("/" : replicate 8 "1"))))
          ]
      (key ["chance"] out, key ["chance_is"] out)
        `shouldBe` ( Just
                       (toJSON (fromRational ((4 ^ (30 :: Int) - 1) % 4 ^ (64 :: Int)) :: Double)),
                     Just "exact"
                   )
    it
      "locate warns on the standard error where more than one random patch in a hundred would be \
      \located, and there only"
      $ do
        forM_
          [ ("3 2 / 3 1", "of random symbols 99.6 % would be located"),
            ("3 2 0 / 3 1 2", "of random symbols 6.2 %")
          ]
          $ \(text, about) -> do
            (status, out, err) <- pra ["locate", text]
            (status, length (lines out), length (lines err)) `shouldBe` (0, 1, 1)
            err
              `shouldSatisfy` \warned ->
                "pra-tactile: warning: " `isInfixOf` warned && about `isInfixOf` warned
        (_, _, silent) <- pra ["locate", "--json", "3 2 / 3 1"]
        silent `shouldBe` ""
        (refused, _, none) <- pra ["locate", "0 0 / 0 0"]
        (refused, none) `shouldBe` (1, "")
        (sure, _, quiet) <- pra ["locate", "3 2 0 1 / 3 0 2 1 / 0 1 3 ? / 1 3 2 2"]
        (sure, quiet) `shouldBe` (0, "")
    it "decode tells it of the certain symbols and parts, at most" $ do
      (status, out, _) <- pra ["decode", "--json", "data/worked-example/composite.pgm"]
      -- Eight, of which one may be wrong.
      (status, key ["agreeing"] out, key ["radius"] out)
        `shouldBe` (0, Just (Number 8), Just (Number 1))
      (key ["chance"] out, key ["chance_is"] out)
        `shouldBe` (Just (toJSON (255 * 25 / 4 ^ (8 :: Int) :: Double)), Just "at-most")
      (_, text, _) <- pra ["decode", "data/worked-example/composite.pgm"]
      lines text `shouldContain` ["chance    of random symbols at most 9.7 % would be located"]
  where
    arrays =
      [ (2, 4, Diagonal, Shape 3 5, Shape 2 2),
        (2, 6, RowMajor, Shape 9 7, Shape 2 3),
        (4, 2, Diagonal, Shape 3 5, Shape 1 2),
        (3, 3, Diagonal, Shape 2 13, Shape 1 3)
      ]
    -- A patch of 2 x 3 upright is 3 x 2 when turned.
    inTurns surface = if surface == Sheet then 2 * (14 * 15) + 2 * (13 * 16) else 4 * 255
    firstOf list' = case list' of
      x : _ -> Just x
      [] -> Nothing

worth :: Answer -> Maybe Chance
worth = answerChance

isLocated :: Answer -> Bool
isLocated answer = case answerOutcome answer of
  Unique _ _ -> True
  _ -> False

-- | What is told of the first is so of them all; where there is none, on a surface on which the
-- algebra does not go on.
enumerated :: Maybe DecoderName -> [Either LocatorError Answer] -> Property
enumerated road answers
  | Left (LocatorAlgebra (SurfaceForeign _ _)) : _ <-
      answers =
    property (road == Just AlgebraDecoder)
  | otherwise = counterexample (show (enumerated' answers)) (null (enumerated' answers))

-- | How many are located, of how many, and what is told, where it is not so.
enumerated' :: [Either LocatorError Answer] -> [(Int, Int, Maybe Chance)]
enumerated' answers = case [report | Right report <- take 1 answers] of
  report : _
    | Just (Chance told exact) <- worth report, if exact then told == share else told >= share -> []
    | otherwise -> [(located, length answers, worth report)]
  [] -> [(0, length answers, Nothing)]
  where
    located = length [() | Right report <- answers, isLocated report]
    share = fromRational (toInteger located % toInteger (length answers))

turnings :: [[Symmetry]]
turnings = [[identity], rotations, symmetries]

genCall :: Gen (Maybe DecoderName, Radius, [Symmetry], Surface)
genCall = do
  road <-
    QuickCheck.elements
      [Nothing, Nothing, Just TableDecoder, Just AlgebraDecoder, Just SearchDecoder]
  radius <-
    if road == Nothing
      then QuickCheck.elements [Guaranteed, UpTo 0, UpTo 1, UpTo 2]
      else pure Guaranteed
  (,,,) road radius <$> QuickCheck.elements turnings <*> QuickCheck.elements [minBound ..]

-- | Cells of a rectangle of at most 3 x 3, so few that all contents can be gone through.
genCells :: Int -> Gen [Position]
genCells q = do
  count <- choose (1, if q == 2 then 8 else 4)
  fmap
    (map snd . filter ((< count) . fst) . flip zip [Position i j | i <- [0 .. 2], j <- [0 .. 2]])
    (shuffle [0 :: Int .. 8])

-- | The rows with these cells.
laid :: [Position] -> [GF k] -> [[Maybe (GF k)]]
laid offsets content =
  [[lookup (Position i j) (zip offsets content) | j <- to column] | i <- to row]
  where
    to side = [0 .. maximum (map side offsets)]

rowsOf :: Natural -> [a] -> [[a]]
rowsOf w cells = case splitAt (fromIntegral w) cells of
  ([], _) -> []
  (r, rest) -> r : rowsOf w rest
