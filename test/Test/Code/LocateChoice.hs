-- | Which decoder answers a question, and what each one that is asked for refuses.
module Test.Code.LocateChoice (spec) where

import Control.Monad (forM_)
import Data.Either (isRight)
import Data.Maybe (fromMaybe)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.DiscreteLog (LogarithmError (..))
import PraTactile.Field
import PraTactile.Locate
import PraTactile.Locate.Decoder.Algebra (AlgebraError (..))
import PraTactile.Symmetry
import PraTactile.Window
import Test.Code.Generators
import Test.Hspec
import Test.Paper

spec :: Spec
spec = do
  it "each decoder answers what it can, and refuses wrong cells or probabilities if it takes none" $ do
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
                     if exact then Left (NothingCorrected (chosen choice)) else answering NearestDecoder
                   )
      (choice, asking choice Guaranteed unsure)
        `shouldBe` ( choice,
                     if soft
                       then answering PosteriorDecoder
                       else Left (ProbabilitiesRefused (chosen choice))
                   )
  it "on 2^60 cells, those that compare with all positions refuse" $ do
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
  it "on a surface that is not the array's own, those that go by the sequence refuse" $ do
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
  it "where there is neither a codebook nor a logarithm, the table answers" $ do
    array <- arrayOver gf2 21 Diagonal (Shape 127 16513)
    window <- right (rectangle (Shape 7 3))
    decoderFor (locator Nothing MostSignificantFirst array window) TwistedTorus Guaranteed
      `shouldBe` Right TableDecoder
  it "and where there is no table either, none does, for both reasons" $ do
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
  it "in no symmetry there is no question, and of no cells no answer" $ do
    array <- paperArray
    window <- paperWindow
    seen <- right (patch [[Nothing, Nothing]])
    forM_ everyChoice $ \choice -> do
      let made = locator choice MostSignificantFirst array window
          question possible = Query [((0, 0), seen)] possible Torus Guaranteed 0.01 Nothing
      (() <$ locate made (question [])) `shouldBe` Left NoSymmetry
      (choice, fmap answerOutcome (locate made (question [identity])))
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
  answerDecoder
    <$> locate
      (locator choice MostSignificantFirst array window)
      (Query [((0, 0), seen)] [identity] surface radius 0.01 Nothing)
  where
    cells = look array (Shape 1 9) (Position 0 5)

-- | A symbol of which another is a little likely.
unsure :: KnownField k => GF k -> Cell k
unsure a =
  either (error . show) Probabilities $
    belief [if b == a then 0.9 else 0.1 / fromIntegral (fieldOrder a - 1) | b <- elements `asTypeOf` [a]]
