-- | The share of all contents that is located, against enumerating them.
module Test.Code.Locate.ChanceByEnumeration (spec) where

import Control.Monad (forM_)
import Data.List (sort, sortOn)
import Data.Maybe (isNothing)
import Data.Ratio ((%))
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Locate
import PraTactile.Locate.Chance
import PraTactile.Locate.Patch (patchOf)
import PraTactile.Symmetry
import Test.Code.Generators
import Test.Code.Locate.Asking
import Test.Code.Locate.Scenes (genRadius)
import Test.Effort
import Test.Hspec
import Test.Paper
import Test.QuickCheck hiding (elements)
import qualified Test.QuickCheck as QuickCheck

spec :: Spec
spec = do
  it "the volume of a sphere is the number of words that differ in at most r symbols" $
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
  it "with very many cells the share has nine correct digits, for arrays of any size" $
    forM_
      [ (q, m, n, r)
        | (q, m) <- [(4, 4096), (4, 4097), (2, 4200), (256, 5000)],
          n <- [1, 4 ^ (30 :: Int) - 1, 2 ^ (1500 :: Int)],
          r <- [0, 1, m `div` 4, m `div` 3, m `div` 2, 2 * m `div` 3, m]
      ]
      $ \(q, m, n, r) -> do
        let Chance share exact = chance (Spheres q m n r 0)
            volume =
              sum
                (scanl (\t i -> t * (m - i) * (q - 1) `div` (i + 1)) 1 (below r)) ::
                Natural
            true = fromRational (min 1 (toInteger (n * volume) % toInteger (q ^ m))) :: Double
        ((q, m, r), exact) `shouldBe` ((q, m, r), False)
        abs (share - true) `shouldSatisfy` (<= 1e-9 * true)
  it "without cells there is no share; a patch larger than the sheet has no position" $ do
    array <- paperArray
    let sheet = ArrayOn Sheet array
    spheres (ArrayOn Torus array) [identity] (Shape 2 2) [] `shouldSatisfy` isNothing
    fmap sphereCentres (spheres sheet rotations (Shape 16 16) [Position 0 0, Position 15 15])
      `shouldBe` Just 0
    fmap sphereCentres (spheres sheet symmetries (Shape 16 2) [Position 0 0, Position 15 1])
      `shouldBe` Just (4 * 14 * 2)
  describe "the share of all contents of the observed cells that is located" sharesSpec

sharesSpec :: Spec
sharesSpec = do
  it "is 255 in 256 for 2 x 2 cells of the paper's array, and 255 in 4096 for 2 x 3" $ do
    array <- paperArray
    m <- paperWindow
    let every = [Nothing, Just TableDecoder, Just AlgebraDecoder, Just SearchDecoder]
    forM_
      [ (Shape 2 2, 255 % 256, every),
        (Shape 2 3, 255 % 4096, byEffort (take 1) id every)
      ]
      $ \(shape, share, decoders) -> forM_ decoders $ \decoder ->
        shareIs share (upright decoder Torus array m) (cellsOf shape)
  it "is 15 spheres of 10 contents if one cell of 3 x 3 is corrected on 3 x 5" $
    onArray (2, 4, Diagonal, Shape 3 5, Shape 2 2) $ \array m ->
      shareIs (150 % 512) (upright Nothing Torus array m) (cellsOf (Shape 3 3))
  forM_ settings $ \setting@(q, _, _, _, _) ->
    it ("is right for every decoder, surface and orientation: " ++ show setting) $
      withMaxSuccess 60 $
        ofArray setting $ \array m ->
          forAllShrink (genCells q) (filter (not . null) . shrinkList (const [])) $ \offsets ->
            forAll genCall $ \(decoder, radius, turning, surface) ->
              enumerated decoder $
                everyContent (ask decoder (surface, array, m) turning radius 0.001) offsets
  forM_ (take 2 settings) $ \setting ->
    it ("is right for several patches together: " ++ show setting) $
      withMaxSuccess 20 $
        ofArray setting $ \array m ->
          forAll (choose (-2, 4)) $ \down ->
            forAll (choose (2, 5)) $ \along ->
              forAll genCall $ \(decoder, radius, turning, surface) ->
                let asked = ask decoder (surface, array, m) turning radius 0.001
                 in enumerated
                      decoder
                      [ asked [((0, 0), square upper), ((down, along), line lower)]
                        | content <- mapM (const elements) [1 .. 6 :: Int],
                          let (upper, lower) = splitAt 4 content
                      ]
  it "with probabilities is at most that of the certain cells" $ do
    array <- paperArray
    m <- paperWindow
    unsure <- right (belief [0.1, 0.9, 0, 0])
    forM_ [(turning, surface) | turning <- turnings, surface <- [Torus, Sheet]] $
      \(turning, surface) -> do
        let asked = ask Nothing (surface, array, m) turning Guaranteed 0.2
            answers =
              [ asked (alone (Probabilities <$> patchOf (Shape 2 3) cells))
                | content <- mapM (const elements) [1 .. 5 :: Int],
                  let (upper, lower) = splitAt 3 (map certainly content)
                      cells = zip (cellsOf (Shape 2 3)) (upper ++ unsure : lower)
              ]
            places = case (length turning, surface) of
              (1, Sheet) -> 14 * 15
              (1, _) -> 255
              -- A patch of 2 x 3 upright is 3 x 2 when turned.
              (several, Sheet) -> fromIntegral several `div` 2 * (14 * 15 + 13 * 16)
              (several, _) -> fromIntegral several * 255
        notSo answers `shouldBe` []
        traverse (fmap answerChance) (take 1 answers)
          `shouldBe` Right [Just (Chance (min 1 (fromInteger places / 4 ^ (5 :: Int))) False)]
  where
    settings =
      [ (2, 4, Diagonal, Shape 3 5, Shape 2 2),
        (2, 6, RowMajor, Shape 9 7, Shape 2 3),
        (4, 2, Diagonal, Shape 3 5, Shape 1 2),
        (3, 3, Diagonal, Shape 2 13, Shape 1 3)
      ]
    upright decoder on array m = ask decoder (on, array, m) [identity] Guaranteed 0.001
    square = patchOf (Shape 2 2) . zip (cellsOf (Shape 2 2)) . map Symbol
    line = patchOf (Shape 1 2) . zip (cellsOf (Shape 1 2)) . map Symbol

-- | The answers about all contents of these cells.
everyContent ::
  KnownField k =>
  (Patches (Cell k) -> answer) ->
  [Position] ->
  [answer]
everyContent asked offsets =
  [ asked (alone (patchOf extent (sortOn fst (zip offsets (map Symbol content)))))
    | content <- mapM (const elements) offsets
  ]
  where
    extent = Shape (1 + maximum (map row offsets)) (1 + maximum (map column offsets))

-- | Of all contents of these cells this share is located, and that is what the first answer says.
shareIs ::
  KnownField k =>
  Rational ->
  (Patches (Cell k) -> Either LocatorError Answer) ->
  [Position] ->
  Expectation
shareIs share asked offsets = do
  answers <- right (sequence (everyContent asked offsets))
  toInteger (length (filter isLocated answers)) % toInteger (length answers) `shouldBe` share
  map answerChance (take 1 answers) `shouldBe` [Just (Chance (fromRational share) True)]

isLocated :: Answer -> Bool
isLocated answer = case answerOutcome answer of
  Unique _ _ -> True
  _ -> False

-- | What the first answer says is so of them all; where there is none, on a surface on which the
-- algebra does not go on.
enumerated :: Maybe DecoderName -> [Either LocatorError Answer] -> Property
enumerated decoder answers = case answers of
  Left (LocatorAlgebra (SurfaceForeign _ _)) : _ ->
    property (decoder `elem` [Just AlgebraDecoder, Just InformationSetDecoder])
  _ -> notSo answers === []

-- | How many are located, of how many, and what is said of it, where it is not so.
notSo :: [Either LocatorError Answer] -> [(Int, Int, Maybe Chance)]
notSo answers = case [answer | Right answer <- take 1 answers] of
  answer : _
    | Just (Chance said exact) <- answerChance answer,
      if exact then said == share else said >= share ->
      []
    | otherwise -> [(located, length answers, answerChance answer)]
  [] -> [(0, length answers, Nothing)]
  where
    located = length [() | Right answer <- answers, isLocated answer]
    share = fromRational (toInteger located % toInteger (length answers))

turnings :: [[Symmetry]]
turnings = [[identity], rotations, symmetries]

genCall :: Gen (Maybe DecoderName, Radius, [Symmetry], Surface)
genCall = do
  decoder <-
    QuickCheck.elements
      (Nothing : map Just [InformationSetDecoder, TableDecoder, AlgebraDecoder, SearchDecoder])
  (,,,) decoder <$> genRadius decoder <*> QuickCheck.elements turnings
    <*> QuickCheck.elements [minBound ..]

-- | Cells of a rectangle of at most 3 x 3, so few that all contents can be gone through.
genCells :: Int -> Gen [Position]
genCells q = do
  count <- choose (1, if q == 2 then 8 else 4)
  sort . take count <$> shuffle (cellsOf (Shape 3 3))
