-- | Tests symbols arranged in clusters against the condition for an arrangement: if chains of
-- neighbours lead each symbol to one cell of its own, it is in that cell; if not, the contradiction
-- is a real one.
module Test.Touch.Segmentation.ClustersOfNeighbours (spec) where

import Data.List (minimumBy, nub, sort)
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust)
import Data.Ord (comparing)
import PraTactile.Image (constant)
import PraTactile.Segmentation (SymbolImage (..))
import PraTactile.Segmentation.Lattice
import Test.Effort (withCases)
import Test.Hspec
import Test.QuickCheck

spec :: Spec
spec =
  withCases 50 400
    . it "are what chains of neighbours connect, by the shortest chains, or state the contradiction"
    $ forAllShrink (oneof [genSymbols, genRoads]) (shrinkList (const [])) $
      \symbols ->
        let numbered = zip [0 ..] symbols
            found = arrange (image . snd) numbered
         in counterexample (show found) $
              label (unwords (nub (map kind found))) (lawful numbered found)
  where
    kind cluster = case cluster of
      Cluster _ -> "cluster"
      Contradiction (TwoCells {}) _ -> "two-cells"
      Contradiction (SharedCell {}) _ -> "shared"

-- | A symbol's place and the angle of its axis.
type Symbol = ((Double, Double), Double)

image :: Symbol -> SymbolImage
image (place, angle) = SymbolImage place (constant 8 12 0) angle (8, 12)

-- | Symbols on a lattice, each moved by up to the tolerance, some of them beside it.
genSymbols :: Gen [Symbol]
genSymbols = do
  off <- elements [0, 2, 4]
  skew <- elements [0, 0, 30]
  count <- choose (0, 14)
  vectorOf count $ do
    (i, j) <- (,) <$> choose (0, 3 :: Int) <*> choose (0, 3 :: Int)
    (dx, dy) <- (,) <$> choose (negate off, off) <*> choose (negate off, off)
    -- Including exactly the tolerance.
    edge <- elements [0, 0, 0, 4, -4]
    let (x, y) = (16 * fromIntegral j + dx + edge, 20 * fromIntegral i + dy)
        (c, s) = (cos (skew * pi / 180), sin (skew * pi / 180))
    pure ((c * x - s * y, s * x + c * y), skew)

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

-- | A symbol with its number among those given.
type Numbered = (Int, Symbol)

-- | The condition for the clusters of some symbols.
lawful :: [Numbered] -> [Cluster Numbered] -> Property
lawful symbols found =
  conjoin
    [ counterexample "each symbol is in one cluster" $
        sort (concatMap members found) === sort symbols,
      counterexample "clusters are what chains of neighbours connect, and nothing else is" $
        sort (map (sort . members) found) === sort (map sort (chains symbols)),
      counterexample "clusters are in the order of their first symbols, row by row" $
        let firsts = map (minimum . map inOrder . members) found in firsts === sort firsts,
      conjoin (map agrees found)
    ]
  where
    members cluster = case cluster of
      Cluster cells -> Map.elems cells
      Contradiction _ those -> those
    inOrder (n, ((x, y), _)) = (y, x, n)
    chains [] = []
    chains (s : rest) =
      let own = grown [s] rest in own : chains [t | t <- rest, t `notElem` own]
    grown own rest = case [t | t <- rest, any (isJust . stepTo t) own] of
      [] -> own
      new -> grown (own ++ new) [t | t <- rest, t `notElem` new]
    stepTo t s = neighbour (image (snd s)) (image (snd t))
    -- The cells to which chains of this many steps lead from the first symbol.
    byLengthOf those =
      let start = minimumBy (comparing inOrder) those
          further reached =
            nub
              [ (t, (i + di, j + dj))
                | (s, (i, j)) <- reached,
                  t <- those,
                  Just (di, dj) <- [stepTo t s]
              ]
       in take (length those + 1) (iterate further [(start, (0, 0))])
    agrees cluster =
      let those = members cluster
          byLength = byLengthOf those
          reached = nub (concat byLength)
          twice = [s | s <- those, length [() | (t, _) <- reached, t == s] > 1]
          shared = [c | (s, c) <- reached, (t, c') <- reached, s < t, c == c']
          -- The cells of the shortest chains to a symbol.
          shortest s = take 1 (filter (not . null) [[c | (t, c) <- r, t == s] | r <- byLength])
       in case cluster of
            Cluster cells ->
              counterexample "no chains contradict, and each symbol is where they lead" $
                null twice && null shared
                  .&&. sort [(s, c) | (c, s) <- Map.toList cells]
                  === sort [(s, (i - least fst, j - least snd)) | (s, (i, j)) <- reached]
              where
                least part = minimum (map (part . snd) reached)
            Contradiction (TwoCells s a b) _ ->
              counterexample "two chains lead to two cells, the shorter to the first" $
                a /= b && (s, b) `elem` reached && any (a `elem`) (shortest s)
            Contradiction (SharedCell c s t) _ ->
              counterexample "no chains contradict, and two symbols are in one cell" $
                null twice && inOrder s < inOrder t && all (`elem` reached) [(s, c), (t, c)]
