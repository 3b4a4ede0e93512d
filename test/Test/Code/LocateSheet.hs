-- | On the sheet there are only the positions at which the cells lie on it: not one of the others
-- is told, nor told the distance of.
module Test.Code.LocateSheet (spec) where

import Data.List (sort)
import Data.Proxy (Proxy (..))
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Grid
import PraTactile.Locate
import PraTactile.Locate.Decision
import PraTactile.Locate.Decoder.Algebra
import PraTactile.Locate.Decoder.Codebook
import PraTactile.Locate.Decoder.InformationSet
import PraTactile.Locate.Decoder.Nearest
import PraTactile.Locate.Patch (uprightAs)
import PraTactile.Symmetry
import PraTactile.Window
import Test.Code.Decided
import Test.Code.Generators
import Test.Hspec
import Test.QuickCheck hiding (elements)
import qualified Test.QuickCheck as QuickCheck

spec :: Spec
spec = do
  it "the nearest position and the next one, compared with all" $ do
    (array, grid, window) <- binary
    shelf <- right (buildCodebook Sheet array window)
    holds 150 $
      forAll genRadius $ \radius -> forPatches grid $ \p ->
        let decision = nearest shelf radius p
            all' = byDefinition grid p
         in counterexample (show decision) $
              conjoin
                [ (decisionNearest decision, decisionRunnerUp decision) === firstTwo all',
                  agrees all' (decisionRadius decision) (decisionOutcome decision)
                ]
  it "in unknown orientation, too" $ do
    (array, grid, window) <- binary
    shelf <- right (buildCodebook Sheet array window)
    holds 60 $
      forAll genRadius $ \radius -> forPatches grid $ \p ->
        let decision = nearestIn shelf rotations radius p
            all' = concat [byDefinition grid (uprightAs o p) | o <- rotations]
         in counterexample
              (show decision)
              ((decisionNearest decision, decisionRunnerUp decision) === firstTwo all')
  it "by information sets: what is told of both is so, or is as much as is known" $ do
    (array, grid, window) <- binary
    algebra <- right (prepareAlgebra Sheet array window)
    holds 300 $
      forAll genRadius $ \radius -> forPatches grid $ \p ->
        let all' = byDefinition grid p
            (least, next) = firstTwo all'
         in case decodePatch algebra radius p of
              Left (DecodingTooMany _) -> property True
              Left e -> counterexample (show e) False
              Right decoded ->
                counterexample (show (decoded, least, next)) $
                  conjoin
                    [ case knownNearest decoded of
                        Exactly e -> least === Just e
                        AtLeast e -> property (maybe True (>= e) least),
                      case knownRunnerUp decoded of
                        Just (Exactly e) -> next === Just e
                        Just (AtLeast e) -> property (maybe False (>= e) next)
                        Nothing ->
                          property
                            ( next == Nothing
                                || knownNearest decoded == AtLeast (decisionRadius decoded + 1)
                            ),
                      agrees all' (decisionRadius decoded) (decisionOutcome decoded)
                    ]
  it "by algebra: several positions are told only where several agree" $ do
    (array, grid, window) <- binary
    algebra <- right (prepareAlgebra Sheet array window)
    holds 300 $
      forPatches grid $ \p -> case algebraPatch algebra p of
        Left e -> counterexample (show e) False
        Right outcome -> counterexample (show outcome) (agrees (byDefinition grid p) 0 outcome)
  it "the far corner of the sheet has one position, however many of the torus agree" $ do
    (array, grid, window) <- binary
    algebra <- right (prepareAlgebra Sheet array window)
    let corner =
          [ [if (i, j) == (62, 64) then symbolOf grid (Position i j) else Nothing | j <- [0 .. 64]]
            | i <- [0 .. 62]
          ]
    p <- right (patch corner)
    algebraPatch algebra p `shouldBe` Right (Unique (Position 0 0) [])
    decoded <- right (decodePatch algebra Guaranteed p)
    (decisionOutcome decoded, knownNearest decoded, knownRunnerUp decoded)
      `shouldBe` (Unique (Position 0 0) [], Exactly 0, Nothing)

-- | The first array of 63 x 65 cells over GF(2): one cell leaves 2048 positions of the torus, more
-- than are listed.
binary :: IO (PseudorandomArray GF2, Grid, Mask)
binary = do
  array <- firstOver (Proxy :: Proxy GF2) 12 >>= right . folded Diagonal (Shape 63 65)
  (,,) array <$> right (toGrid array) <*> right (rectangle (Shape 6 2))

symbolOf :: KnownField k => Grid -> Position -> Maybe (GF k)
symbolOf grid at = codeAt grid at >>= either (const Nothing) Just . fromCode

-- | Every position of the sheet at which all observed cells lie on it, with the number of them that
-- differ.
byDefinition :: KnownField k => Grid -> Patch (GF k) -> [(Natural, Position)]
byDefinition grid p =
  [ (fromIntegral (length (filter id differing)), Position r c)
    | r <- below (rows (gridShape grid)),
      c <- below (columns (gridShape grid)),
      Just differing <-
        [ traverse
            (\(Position i j, a) -> (/= a) <$> symbolOf grid (Position (r + i) (c + j)))
            (observedCells p)
        ]
  ]

below :: Natural -> [Natural]
below n = takeWhile (< n) [0 ..]

firstTwo :: [(Natural, a)] -> (Maybe Natural, Maybe Natural)
firstTwo found = case sort (map fst found) of
  a : b : _ -> (Just a, Just b)
  [a] -> (Just a, Nothing)
  [] -> (Nothing, Nothing)

-- | The outcome is that of the nearest of these positions within the radius.
agrees :: [(Natural, Position)] -> Natural -> Outcome Position -> Property
agrees all' radius outcome = case ( [place | (e, place) <- all', Just e == least, e <= radius],
                                    outcome
                                  ) of
  ([only], Unique place _) -> place === only
  (several@(_ : _ : _), Ambiguous places _) -> places === several
  (_ : _ : _, AmbiguousMany count _) -> property (count > 1024)
  (near, Refused _) -> near === []
  _ -> property False
  where
    least = fst (firstTwo all')

-- | Of any patch of few cells, right or wrong, as small as a cell or as large as the sheet.
forPatches :: Grid -> (Patch (GF GF2) -> Property) -> Property
forPatches grid law =
  forAllShrink (genWide grid) (filter (not . null) . shrinkList (const [])) $ \cells ->
    let (high, wide) = (1 + maximum (map (row . fst) cells), 1 + maximum (map (column . fst) cells))
     in either
          (\e -> counterexample (show e) False)
          law
          (patch [[lookup (Position i j) cells | j <- below wide] | i <- below high])

genRadius :: Gen Radius
genRadius = QuickCheck.elements [Guaranteed, UpTo 0, UpTo 1, UpTo 2]

genWide :: Grid -> Gen [(Position, GF GF2)]
genWide grid = do
  high <- QuickCheck.elements [1, 2, 3, 40, 62, 63]
  wide <- QuickCheck.elements [1, 2, 3, 40, 64, 65]
  count <- QuickCheck.elements [0, 0, 1, 2, 8, 15]
  offsets <- vectorOf count (Position <$> upTo high <*> upTo wide)
  Position r c <- Position <$> upTo 63 <*> upTo 65
  wrong <- QuickCheck.elements [0, 10, 50 :: Int]
  let seen offset@(Position i j) = do
        fate <- choose (0, 99)
        -- As the torus goes on.
        pure
          [ (offset, if fate < wrong then a + one else a)
            | Just a <- [symbolOf grid (Position ((r + i) `mod` 63) ((c + j) `mod` 65))]
          ]
  concat <$> mapM seen (Position (high - 1) (wide - 1) : offsets)
  where
    upTo side = fromInteger <$> choose (0, toInteger (side :: Natural) - 1)
