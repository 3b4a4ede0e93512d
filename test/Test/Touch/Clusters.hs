-- | Symbols arranged in clusters, stated once more from what the lattice is: each symbol in the
-- cell that the shortest way from neighbour to neighbour leads to, and what contradicts that.
module Test.Touch.Clusters (spec) where

import Data.List (nub, sortOn)
import qualified Data.Map.Strict as Map
import PraTactile.Image (constant)
import PraTactile.Segmentation (SymbolImage (..))
import PraTactile.Segmentation.Lattice
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck

spec :: Spec
spec =
  modifyMaxSuccess (const 400)
    . it "are what chains of neighbours connect, by the shortest chains, or how these contradict"
    $ forAllShrink (oneof [genSymbols, genRoads]) (shrinkList (const [])) $
      \symbols ->
        let found = arrange image symbols
         in label (unwords (nub (map kind found))) (found === defined symbols)
  where
    kind cluster = case cluster of
      Cluster _ -> "cluster"
      Contradiction (TwoCells {}) _ -> "two-cells"
      Contradiction (SharedCell {}) _ -> "shared"

-- | A symbol's place and the angle of its axis.
type Symbol = ((Double, Double), Double)

image :: Symbol -> SymbolImage
image (place, angle) = SymbolImage place (constant 8 12 0) angle (8, 12)

-- | Symbols on a lattice, each moved by as much as may be, some of them beside it.
genSymbols :: Gen [Symbol]
genSymbols = do
  off <- elements [0, 2, 4]
  tilt <- elements [0, 0, 30]
  count <- choose (0, 14)
  vectorOf count $ do
    (i, j) <- (,) <$> choose (0, 3 :: Int) <*> choose (0, 3 :: Int)
    (dx, dy) <- (,) <$> choose (negate off, off) <*> choose (negate off, off)
    -- Exactly as far off as is tolerated, too.
    edge <- elements [0, 0, 0, 4, -4]
    let (x, y) = (16 * fromIntegral j + dx + edge, 20 * fromIntegral i + dy)
        (c, s) = (cos (tilt * pi / 180), sin (tilt * pi / 180))
    pure ((c * x - s * y, s * x + c * y), tilt)

-- | Symbols along two roads that meet, in more and in fewer steps, with some others or without one.
genRoads :: Gen [Symbol]
genRoads = do
  (long, short) <-
    elements
      [ ([(12, 4), (24, 8), (36, 8), (48, 4), (60, 0)], [(20, -4), (40, -4)]),
        ([(4, 16), (4, 32), (0, 48)], [(-4, 24)])
      ]
  gone <- elements [0, 0, 0, 1, 2]
  others <- choose (0, 3) >>= (`vectorOf` ((,) <$> choose (-40, 90) <*> choose (-40, 90)))
  (right', down) <- (,) <$> elements [1, -1] <*> elements [1, -1]
  places <- shuffle ((0, 0) : long ++ short ++ others)
  pure [((right' * x, down * y), 0) | (x, y) <- drop gone places]

defined :: [Symbol] -> [Cluster Symbol]
defined symbols = clusters (zip [0 :: Int ..] (sortOn (\((x, y), _) -> (y, x)) symbols))
  where
    clusters [] = []
    clusters (start : others) =
      let (members, conflict) = reached [start] [(start, (0, 0))] Nothing
          rest = [s | s <- others, fst s `notElem` map (fst . fst) members]
          inOrder = map snd (sortOn fst (map fst members))
       in cluster members inOrder conflict : clusters rest
      where
        -- Those whose neighbours were not looked at yet, the cells so far, and what contradicts.
        reached [] members conflict = (members, conflict)
        reached (here : queue) members conflict =
          let cell = head' [c | (s, c) <- members, fst s == fst here]
              beside =
                [ (s, (fst cell + di, snd cell + dj))
                  | s <- start : others,
                    Just (di, dj) <- [neighbour (image (snd here)) (image (snd s))]
                ]
              new = [b | b@(s, _) <- beside, fst s `notElem` map (fst . fst) members]
              twice =
                [ TwoCells (snd s) c c'
                  | (s, c') <- beside,
                    (s', c) <- members,
                    fst s == fst s',
                    c /= c'
                ]
           in reached (queue ++ map fst new) (members ++ new) (conflict `orFirst` twice)
        orFirst Nothing (c : _) = Just c
        orFirst c _ = c
    cluster members inOrder conflict = case (conflict, shared) of
      (Just c, _) -> Contradiction c inOrder
      (Nothing, c : _) -> Contradiction c inOrder
      (Nothing, []) ->
        Cluster
          ( Map.fromList
              [((i - least fst, j - least snd), snd s) | (s, (i, j)) <- members]
          )
      where
        least part = minimum (map (part . snd) members)
        shared =
          [ SharedCell c a b
            | c <- Map.keys (Map.fromList [(c, ()) | (_, c) <- members]),
              a : b : _ <- [map snd (sortOn fst [s | (s, c') <- members, c' == c])]
          ]
    head' = foldr const (0, 0)
