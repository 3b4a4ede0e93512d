-- | The share of all contents that is located, against enumerating them.
module Test.Code.LocateChance (spec) where

import Control.Monad (forM_)
import Data.Maybe (isNothing)
import Data.Proxy (Proxy (..))
import Data.Ratio ((%))
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Locate
import PraTactile.Locate.Chance
import PraTactile.Locate.Decision
import PraTactile.Locate.Decoder.Algebra
import PraTactile.Symmetry
import PraTactile.Window
import Test.Code.Decided
import Test.Code.Generators
import Test.Hspec
import Test.QuickCheck hiding (elements)
import qualified Test.QuickCheck as QuickCheck

spec :: Spec
spec = do
  it "a sphere holds the words that differ in at most r symbols, all counted" $
    forM_
      [ (q, m, r)
        | (q, longest) <- [(2, 8), (3, 5), (4, 4), (7, 3)],
          m <- [0 .. longest],
          r <- [0 .. m + 1]
      ]
      $ \(q, m, r) ->
        (q, m, r, sphereVolume q m r)
          `shouldBe` ( q,
                       m,
                       r,
                       fromIntegral
                         ( length
                             [ ()
                               | w <-
                                   mapM (const [0 .. q - 1]) (take (fromIntegral m) [0 :: Int ..]),
                                 fromIntegral (length (filter (/= 0) w)) <= r
                             ]
                         )
                     )
  it
    "of more cells than are counted in whole numbers the share is the same to nine digits, for an \
    \array of any size"
    $ forM_
      [ (q, m, n, r)
        | (q, m) <- [(2, 4200), (3, 4100), (256, 5000)],
          n <- [1, 4 ^ (30 :: Int) - 1, 2 ^ (1500 :: Int)],
          r <- [0, 1, m `div` 4, m `div` 3, m `div` 2, 2 * m `div` 3, m]
      ]
      $ \(q, m, n, r) -> do
        let Chance share exact = chance (Spheres q m n r 0)
            volume =
              sum
                (scanl (\t i -> t * (m - i) * (q - 1) `div` (i + 1)) 1 (takeWhile (< r) [0 ..])) ::
                Natural
            true = fromRational (min 1 (toInteger (n * volume) % toInteger (q ^ m))) :: Double
        ((q, m, r), exact) `shouldBe` ((q, m, r), False)
        abs (share - true) `shouldSatisfy` (<= 1e-9 * true)
  it "no cell, no share; a patch that is larger than the sheet is nowhere" $ do
    array <- right paperPrimitive >>= right . folded Diagonal (Shape 15 17)
    spheres Torus array [identity] (Shape 2 2) [] `shouldSatisfy` isNothing
    fmap sphereCentres (spheres Sheet array rotations (Shape 16 16) [Position 0 0, Position 15 15])
      `shouldBe` Just 0
    fmap sphereCentres (spheres Sheet array symmetries (Shape 16 2) [Position 0 0, Position 15 1])
      `shouldBe` Just (4 * 14 * 2)
  it
    "decoding by information sets: of all contents the share is exact while 2 r < d, and never \
    \exceeded"
    $ forM_ arrays $ \(q, n, folding, shape, window) ->
      forM_ (lookup q everyField) $ \(SomeField (k :: Proxy k)) -> do
        array <- firstOver k n >>= right . folded folding shape
        m <- right (rectangle window)
        forM_ [naturalSurface folding, Sheet] $ \surface -> do
          algebra <- right (prepareAlgebra surface array m)
          holds 12 $
            forAllShrink (genCells q) (filter (not . null) . shrinkList (const [])) $ \offsets ->
              forAll (QuickCheck.elements [Guaranteed, UpTo 0, UpTo 1, UpTo 2]) $ \radius ->
                forAll (QuickCheck.elements [[identity], rotations]) $ \possible ->
                  let (high, wide) =
                        (1 + maximum (map row offsets), 1 + maximum (map column offsets))
                      seen content =
                        either
                          (const Nothing)
                          Just
                          ( patch
                              [ [ lookup (Position i j) (zip offsets content)
                                  | j <- takeWhile (< wide) [0 ..]
                                ]
                                | i <- takeWhile (< high) [0 ..]
                              ]
                          )
                      answers =
                        [ either (const Nothing) Just . boundedIn algebra possible radius
                            =<< seen content
                          | content <- mapM (const elements) offsets
                        ]
                      located =
                        length
                          [() | Just decision <- answers, Unique _ _ <- [decisionOutcome decision]]
                      share = fromRational (toInteger located % toInteger (length answers))
                      promised =
                        [ chance (correcting (decisionDistance one') (decisionRadius one') about)
                          | Just one' <- take 1 answers,
                            Just about <- [spheres surface array possible (Shape high wide) offsets]
                        ]
                   in counterexample (show (surface, located, length answers, promised)) $
                        not (null promised)
                          ==> conjoin
                            [ if chanceExact told
                                then chanceShare told === share
                                else property (chanceShare told >= share)
                              | told <- promised
                            ]
  where
    arrays =
      [ (2, 4, Diagonal, Shape 3 5, Shape 2 2),
        (2, 6, RowMajor, Shape 9 7, Shape 2 3),
        (4, 2, Diagonal, Shape 3 5, Shape 1 2),
        (3, 3, Diagonal, Shape 2 13, Shape 1 3)
      ]

-- | Cells of a rectangle of at most 3 x 3, so few that all contents can be gone through.
genCells :: Int -> Gen [Position]
genCells q = do
  count <- choose (1, if q == 2 then 8 else 4)
  fmap (map snd . filter ((< count) . fst) . flip zip cells) (shuffle [0 :: Int .. 8])
  where
    cells = [Position i j | i <- [0 .. 2], j <- [0 .. 2]]
