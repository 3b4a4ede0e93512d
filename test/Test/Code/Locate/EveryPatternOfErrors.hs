-- | Locating with errors and erasures, against every position and every pattern of errors.
module Test.Code.Locate.EveryPatternOfErrors (spec) where

import Control.Monad (forM_)
import Data.Bits (popCount, shiftL, shiftR, xor, (.&.), (.|.))
import Data.List (foldl', nub, sort)
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Locate
import PraTactile.Locate.Decision
import PraTactile.Locate.Decoder.Codebook
import PraTactile.Locate.Decoder.Nearest
import PraTactile.Locate.Patch (patchOf)
import PraTactile.Window
import PraTactile.Window.Distance
import Test.Code.Generators
import Test.Code.Locate.Scenes
import Test.Effort
import Test.Hspec
import Test.Paper
import Test.QuickCheck hiding (elements, (.&.))
import qualified Test.QuickCheck as QuickCheck

spec :: Spec
spec = do
  describe "every pattern of errors within the guaranteed radius and just beyond it" $ do
    -- The code is linear: adding a codeword moves the received word and every codeword alike, so
    -- that the patterns around one position stand for those around all; only the place that the
    -- zero word would have moves. Likewise the multiples of a pattern stand for each other, so
    -- that at one position only those are tried whose first error adds 1. The smaller windows are
    -- exhausted at all 255 positions none the less.
    forM_
      ( [(2, 3, 0, 255), (3, 2, 0, 255), (3, 3, 1, byEffort 20 255)]
          ++ byEffort [(3, 4, 2, 1)] [(3, 4, 2, 5), (4, 4, 4, 1)]
      )
      $ \(h, w, t, places) ->
        it
          ( show (h, w) ++ " cells, " ++ show t
              ++ " errors corrected, more refused or decoded as "
              ++ ("the comparison says, at " ++ show places ++ " positions")
          )
          $ do
            codebook <- paperCodebook Torus
            m <- right (rectangle (Shape h w))
            d <- right (minimumDistance (codebookArray codebook) m)
            guaranteedRadius (distance d) `shouldBe` fromIntegral t
            sums <-
              mapM
                (patterns codebook (Shape h w) t (t + 1) (places == 1))
                (take places (everyPosition 7))
            [bad | bad : _ <- sums] `shouldBe` []
    let (many, few) = byEffort (25, 3) (255, 30)
    it ("3x4: every pattern of at most 2 errors is corrected at " ++ show many ++ " positions") $ do
      codebook <- paperCodebook Torus
      sums <- mapM (patterns codebook (Shape 3 4) 2 2 False) (take many (everyPosition 0))
      [bad | bad : _ <- sums] `shouldBe` []
    it ("4x4: every pattern of at most 2 errors is corrected at " ++ show few ++ " positions") $ do
      codebook <- paperCodebook Torus
      sums <- mapM (patterns codebook (Shape 4 4) 4 2 False) (take few (everyPosition 3))
      [bad | bad : _ <- sums] `shouldBe` []
  describe "the linearity that lets one position stand for all" $ do
    it "neighbours (word + codeword) = neighbours word + codeword" $ do
      codebook <- paperCodebook Torus
      holds 2000 $
        forAll
          ((,,) <$> genOffsets <*> genPlaces <*> vectorOf 16 (genElement :: Gen (GF GF4)))
          $ \(offsets, (p, p'), noise) ->
            let led = neighbours codebook offsets (zipWith (+) noise (contentAt codebook offsets p))
                led' =
                  neighbours codebook offsets (zipWith (+) noise (contentAt codebook offsets p'))
                relative place (e, found) =
                  (e, sort (map (map toCode . (`minus` contentAt codebook offsets place)) found))
             in relative p led === relative p' led'
    it "neighbours (a word) = a (neighbours word)" $ do
      codebook <- paperCodebook Torus
      holds 2000 $
        forAll
          ((,,) <$> genOffsets <*> vectorOf 16 (genElement :: Gen (GF GF4)) <*> genElement)
          $ \(offsets, drawn, a) ->
            let received = zipWith const drawn offsets
                scaled (e, found) = (e, sort (map (map (toCode . (a *))) found))
                plain (e, found) = (e, sort (map (map toCode) found))
             in a /= 0
                  ==> plain (neighbours codebook offsets (map (a *) received))
                    === scaled (neighbours codebook offsets received)
  it "the distance of the observed cells is that of the mask" $ do
    codebook <- paperCodebook Torus
    holds 300 $
      forAll genOffsets $ \offsets ->
        whenRight (maskFrom offsets) $ \m ->
          fmap distance (minimumDistance (codebookArray codebook) m)
            === Right (observedDistance codebook offsets)
  it "the zero word is refused: zero-window" $ do
    codebook <- paperCodebook Torus
    p <- right (patch (map (map Just) [[0, 0, 0], [0, 1, 0], [0, 0, 0]]))
    decisionOutcome (nearest codebook Guaranteed p) `shouldBe` Refused ZeroWindow
    none <- right (patch [[Nothing, Nothing]])
    decisionOutcome (nearest codebook Guaranteed none) `shouldBe` Refused TooFewCells
  it "where the surface is not the array's own, no distance is promised and nothing corrected" $ do
    codebook <- paperCodebook TwistedTorus
    observedDistance codebook (maskOffsets (codebookMask codebook)) `shouldBe` 0
    p <- right (patch (map (map Just) [[0, 1, 2, 3], [0, 1, 2, 2], [0, 1, 2, 3], [0, 1, 2, 3]]))
    correctionRadius (decisionDistances (nearest codebook Guaranteed p)) `shouldBe` 0

-- | All positions of the paper's array, in a scattered order.
everyPosition :: Natural -> [Position]
everyPosition start =
  [Position (i `mod` 15) (i `mod` 17) | k <- [0 .. 254], let i = start + 37 * k]

-- | The patterns of at most this many errors, the second number, around a window whose radius is
-- the first: those whose decision is not what it should be. What it should be is found by other
-- means: two bits a cell, and counting the cells in which two windows differ by bit operations.
patterns ::
  Codebook GF4 ->
  Shape ->
  Int ->
  Int ->
  Bool ->
  Position ->
  IO [([Position], Decision Position)]
patterns codebook size t most upToFactor place = do
  m <- right (rectangle size)
  let offsets = maskOffsets m
      count = length offsets
      content = contentAt codebook offsets
      packed = foldl' (\n a -> n `shiftL` 2 .|. toCode a) (0 :: Int) :: [GF GF4] -> Int
      book' = Primitive.fromList (map (packed . content) everywhere)
      differ a b =
        let x = a `xor` b in popCount ((x .|. (x `shiftR` 1)) .&. (0x5555555555555555 :: Int))
      sent = content place
      errors k = errorPatterns upToFactor k (zip offsets sent)
      check (wrong, received) =
        let word = packed received
            near = Primitive.map (differ word) book'
            least = Primitive.minimum near
            spots = [i | (i, n) <- zip [0 ..] (Primitive.toList near), n == least]
            expected
              | length wrong <= t = Unique place []
              | least <= t, [i] <- spots = Unique (everywhere !! i) []
              | differ word 0 <= t = Refused ZeroWindow
              | t == 0 = Refused Contradiction
              | otherwise = Refused BeyondRadius
            decision = nearest codebook Guaranteed (patchOf size (zip offsets received))
            distances = decisionDistances decision
            outcome = case decisionOutcome decision of
              Unique found _ -> Unique found []
              Refused NotInArray -> Refused Contradiction
              other -> other
         in [ (wrong, decision)
              | outcome /= expected
                  || nearestDistance distances /= Just (Exactly (fromIntegral least))
                  || (length wrong <= t && corrected distances /= wrong)
            ]
  pure (concatMap check (concat [errors k | k <- [0 .. min count most]]))

-- | The least distance of a word from the contents of these cells, and the contents that have it,
-- each once: zero, which stands nowhere, among them, so that they are a linear code.
neighbours :: Codebook GF4 -> [Position] -> [GF GF4] -> (Natural, [[GF GF4]])
neighbours codebook offsets received =
  case atLeast <$> nearestDistance (decisionDistances decision) of
    Just e
      | weight < e -> (weight, [zeros])
      | weight == e -> (e, nub (zeros : found))
      | otherwise -> (e, found)
    Nothing -> (weight, [zeros])
  where
    decision = nearest codebook (UpTo 16) (patchOf (Shape 4 4) (zip offsets received))
    places = case decisionOutcome decision of
      Unique place _ -> [place]
      Ambiguous several _ -> several
      _ -> []
    found = nub (map (contentAt codebook offsets) places)
    weight = fromIntegral (length (filter (/= 0) received))
    zeros = map (const 0) offsets

contentAt :: Codebook GF4 -> [Position] -> Position -> [GF GF4]
contentAt codebook offsets (Position r c) =
  [cellAt (codebookArray codebook) (Position (r + i) (c + j)) | Position i j <- offsets]

minus :: [GF GF4] -> [GF GF4] -> [GF GF4]
minus = zipWith (-)

-- | Two positions of the paper's array.
genPlaces :: Gen (Position, Position)
genPlaces = (,) <$> QuickCheck.elements everywhere <*> QuickCheck.elements everywhere

genOffsets :: Gen [Position]
genOffsets = sublistOf (cellsOf (Shape 4 4)) `suchThat` (not . null)
