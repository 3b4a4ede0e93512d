-- | Which decoder answers a question, and what each one that is asked for refuses.
module Test.Code.Locate.WhichDecoder (spec) where

import Control.Monad (forM_)
import Data.Either (isRight)
import Data.Maybe (fromMaybe)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.DiscreteLog (LogarithmError (..))
import PraTactile.Field
import PraTactile.Field.Named (GF4)
import PraTactile.Locate
import PraTactile.Locate.Decision
import PraTactile.Locate.Decoder.Algebra
import PraTactile.Locate.Decoder.InformationSet (decodePatch)
import PraTactile.Locate.Decoder.List (listPatch, standardListing)
import PraTactile.Locate.Definition (searchPatch)
import PraTactile.Symmetry
import PraTactile.Window
import Test.Code.Generators
import Test.Code.Locate.Asking
import Test.Hspec
import Test.Paper

spec :: Spec
spec = do
  it "each decoder answers the questions it supports, and refuses the others" $ do
    array <- paperArray
    window <- paperWindow
    let asking = asked Torus array window
    forM_ (Nothing : map Just [minBound .. maxBound]) $ \choice -> do
      let exact = choice `elem` map Just [TableDecoder, AlgebraDecoder, SearchDecoder]
          soft = choice `elem` [Nothing, Just PosteriorDecoder, Just ListDecoder]
          -- Of a decoder of probabilities symbols are probabilities.
          answering instead = Right (fromMaybe instead choice)
      forM_ [Guaranteed, UpTo 0] $ \radius ->
        (choice, asking choice radius Symbol) `shouldBe` (choice, answering NearestDecoder)
      (choice, asking choice (UpTo 1) Symbol)
        `shouldBe` ( choice,
                     if exact
                       then Left (NothingCorrected (chosen choice))
                       else answering NearestDecoder
                   )
      (choice, asking choice Guaranteed unsure)
        `shouldBe` ( choice,
                     if soft
                       then answering PosteriorDecoder
                       else Left (ProbabilitiesRefused (chosen choice))
                   )
  it "on 2^60 cells, decoders that compare with all positions refuse" $ do
    array <- vastArray
    window <- right (rectangle (Shape 15 2))
    let tooMany = Left (LocatorPatch (TooManyPlaces (area (arrayShape array)) (2 ^ (20 :: Int))))
        tooLarge = Left (LocatorPatch (TableTooLarge (4 ^ (30 :: Int)) (2 ^ (26 :: Int))))
    [asked Torus array window choice Guaranteed Symbol | choice <- everyChoice]
      `shouldBe` [ Right InformationSetDecoder,
                   tooLarge,
                   Right AlgebraDecoder,
                   tooMany,
                   tooMany,
                   tooMany,
                   Right InformationSetDecoder,
                   Right ListDecoder
                 ]
    map
      (\choice -> asked Torus array window choice Guaranteed unsure)
      [Nothing, Just PosteriorDecoder, Just ListDecoder]
      `shouldBe` [Right ListDecoder, tooMany, Right ListDecoder]
  it "each reason has its name in the protocol" $
    [(r, reasonName r) | r <- reasons]
      `shouldBe` [ (ZeroWindow, "zero-window"),
                   (TooFewCells, "too-few-cells"),
                   (NoCompleteWindow, "no-complete-window"),
                   (NotInArray, "not-in-array"),
                   (Contradiction, "contradiction"),
                   (OffSheet, "off-sheet"),
                   (BeyondRadius, "beyond-radius"),
                   (BelowThreshold, "below-threshold")
                 ]
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
  it "on a surface that is not the array's own, decoders by the sequence refuse" $ do
    array <- paperArray
    window <- paperWindow
    let foreign' = Left (LocatorAlgebra (SurfaceForeign TwistedTorus Torus))
    [asked TwistedTorus array window choice Guaranteed Symbol | choice <- everyChoice]
      `shouldBe` [ Right NearestDecoder,
                   Right TableDecoder,
                   foreign',
                   Right SearchDecoder,
                   Right NearestDecoder,
                   Right PosteriorDecoder,
                   foreign',
                   foreign'
                 ]
  it "without codebook and logarithm the table answers" $ do
    array <- arrayOver gf2 21 Diagonal (Shape 127 16513)
    window <- right (rectangle (Shape 7 3))
    decoderFor
      (locator Nothing MostSignificantFirst (ArrayOn TwistedTorus array) window)
      Guaranteed
      `shouldBe` Right TableDecoder
  it "without a table as well, no decoder answers, and both reasons are given" $ do
    let prime = 2 ^ (61 :: Int) - 1 :: Natural
    array <- arrayOver gf2 61 Diagonal (Shape 1 prime)
    window <- right (rectangle (Shape 1 61))
    let infeasible = AlgebraLogarithm (LogarithmInfeasible prime (2 ^ (40 :: Int)))
        tooMany = Left (LocatorPatch (TooManyPlaces prime (2 ^ (20 :: Int))))
    asked Torus array window Nothing Guaranteed Symbol
      `shouldBe` Left
        (LocatorImpossible infeasible (TableTooLarge (2 ^ (61 :: Int)) (2 ^ (26 :: Int))))
    asked Torus array window Nothing Guaranteed unsure `shouldBe` tooMany
    forM_ [AlgebraDecoder, InformationSetDecoder, ListDecoder] $ \name ->
      asked Torus array window (Just name) Guaranteed Symbol
        `shouldBe` Left (LocatorAlgebra infeasible)
  it "with more cells than a window may have, decoders by equations refuse" $ do
    array <- paperArray
    window <- paperWindow
    let tooMany = AlgebraCells (WindowTooLarge 4097)
        about cells choice = do
          seen <-
            either (Left . LocatorPatch) Right . patch $
              [take cells (cycle [Just (Symbol one), Just (Symbol zero)])]
          answerDecoder
            <$> ask choice (Torus, array, window) [identity] Guaranteed 0.01 (alone seen)
    map (about 4097) everyChoice
      `shouldBe` [ Right NearestDecoder,
                   Right TableDecoder,
                   Left (LocatorAlgebra tooMany),
                   Right SearchDecoder,
                   Right NearestDecoder,
                   Right PosteriorDecoder,
                   Left (LocatorDecoding (DecodingAlgebra tooMany)),
                   Left (LocatorAlgebra tooMany)
                 ]
    map (about 4096 . Just) [AlgebraDecoder, NearestDecoder]
      `shouldBe` [Right AlgebraDecoder, Right NearestDecoder]
  it "without observed cells every decoder says so, in every symmetry" $ do
    array <- paperArray
    window <- paperWindow
    algebra <- paperAlgebra Torus
    nothing <- right (patch [[Nothing, Nothing :: Maybe (GF GF4)]])
    unknown <- right (patch [[Nothing :: Maybe (Belief GF4)]])
    algebraPatch algebra nothing `shouldBe` Right (Refused TooFewCells)
    searchPatch (ArrayOn Torus array) window nothing `shouldBe` Right (Refused TooFewCells)
    forM_ [(Guaranteed, 0), (UpTo 3, 3)] $ \(radius, e) ->
      decodePatch algebra radius nothing
        `shouldBe` Right
          (Decision (Refused TooFewCells) (Distances [] Nothing Nothing (Exactly 0) e))
    let many possible =
          posteriorMany <$> listPatch standardListing 0.001 algebra possible unknown
    many [identity] `shouldBe` Right (Just (255, Just 4))
    many rotations `shouldBe` Right (Just (4 * 255, Nothing))
    many symmetries `shouldBe` Right (Just (8 * 255, Nothing))
  it "positions listed in one symmetry and only counted in another are added up" $ do
    let decision outcome = Decision outcome (Distances [] (Just (Exactly 1)) Nothing (Exactly 3) 1)
        over outcomes =
          decisionOutcome . overSymmetries (Exactly 3) 1 $
            [(o, Shape 2 2, decision outcome) | (o, outcome) <- zip rotations outcomes]
        at = Position 3 4
    over [Unique at [], AmbiguousMany 5000 (Just 6)] `shouldBe` AmbiguousMany 5001 Nothing
    over [Ambiguous [at, Position 0 1] [], AmbiguousMany 5000 (Just 6), AmbiguousMany 7 Nothing]
      `shouldBe` AmbiguousMany 5009 Nothing
    over [Refused NotInArray, AmbiguousMany 5000 (Just 6)] `shouldBe` AmbiguousMany 5000 (Just 6)
    over [Refused NotInArray, Unique at []] `shouldBe` Unique (Candidate (rotations !! 1) at) []
    -- What came farthest.
    over [Refused ZeroWindow, Refused BeyondRadius] `shouldBe` Refused BeyondRadius
    over [Refused ZeroWindow, Refused NotInArray, Refused OffSheet] `shouldBe` Refused OffSheet
    over [Refused TooFewCells] `shouldBe` Refused TooFewCells
  it "a question without symmetries is refused, and one without cells has no answer" $ do
    array <- paperArray
    window <- paperWindow
    seen <- right (patch [[Nothing, Nothing]])
    forM_ everyChoice $ \choice -> do
      let answered possible =
            ask choice (Torus, array, window) possible Guaranteed 0.01 (alone seen)
      (() <$ answered []) `shouldBe` Left NoSymmetry
      (choice, fmap answerOutcome (answered [identity]))
        `shouldSatisfy` (isRight . snd)
  where
    everyChoice = Nothing : map Just [minBound .. maxBound]
    chosen = fromMaybe (error "none is chosen")

-- | Which decoder answered about three rows of three cells of an array, each as it was seen.
asked ::
  KnownField k =>
  Surface ->
  PseudorandomArray k ->
  Mask ->
  Maybe DecoderName ->
  Radius ->
  (GF k -> Cell k) ->
  Either LocatorError DecoderName
asked surface array window choice radius seenAs = do
  seen <- either (Left . LocatorPatch) Right (patch (map (map (fmap seenAs)) cells))
  answerDecoder <$> ask choice (surface, array, window) [identity] radius 0.01 (alone seen)
  where
    cells = look array (Shape 1 9) (Position 0 5)

-- | A symbol of which another is a little likely.
unsure :: KnownField k => GF k -> Cell k
unsure a =
  either (error . show) Probabilities $
    belief [if b == a then 0.9 else others | b <- elements `asTypeOf` [a]]
  where
    others = 0.1 / fromIntegral (fieldOrder a - 1)
