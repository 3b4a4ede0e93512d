{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RankNTypes #-}

-- | Sequences, distant terms and shortest recurrences as another program computes them; the file
-- says which.
module Test.Code.Sequence.FactsFromElsewhere (spec) where

import Control.Monad (forM_)
import Data.Aeson
import Data.Aeson.Types (Parser, parseEither)
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Field
import PraTactile.Field.Named (conwayModulus)
import PraTactile.Polynomial
import PraTactile.Sequence
import PraTactile.Sequence.Galois
import PraTactile.Sequence.Synthesis
import Test.Code.Generators
import Test.Hspec

spec :: Spec
spec = beforeAll (eitherDecodeFileStrict "test/data/sequences.json" >>= either fail pure) $ do
  it "terms from a given state" $ \facts -> do
    given <-
      records facts "sequences" (\o -> (,,) <$> o .: "polynomial" <*> o .: "state" <*> o .: "terms")
    length given `shouldSatisfy` (> 20)
    forM_ given $ \(Fact q modulus (polynomialCodes, stateCodes, terms)) ->
      over q modulus $ \read' -> do
        h <- read' polynomialCodes >>= right . checkPrimitive . polynomial
        state <- read' stateCodes >>= right . initialState h
        let count = length (terms :: [Natural])
            codesOf = map (fromIntegral . toCode)
        codesOf (take count (mSequence h state)) `shouldBe` terms
        codesOf (Primitive.toList (sequenceVector h state count)) `shouldBe` terms
        codesOf (take count (galoisSequence h (toGalois h state))) `shouldBe` terms
  it "terms far away, from the canonical state" $ \facts -> do
    given <-
      records
        facts
        "distant_terms"
        (\o -> (,,) <$> o .: "polynomial" <*> (read <$> o .: "from") <*> o .: "terms")
    length given `shouldSatisfy` (> 10)
    forM_ given $ \(Fact q modulus (polynomialCodes, from, terms)) -> over q modulus $ \read' -> do
      h <- read' polynomialCodes >>= right . checkPrimitive . polynomial
      let count = length (terms :: [Natural])
          codesOf = map (fromIntegral . toCode)
      codesOf (map (termAt h (canonicalState h)) (take count [from ..])) `shouldBe` terms
      codesOf (take count (mSequence h (stateAt h (canonicalState h) (toInteger from))))
        `shouldBe` terms
  it "shortest recurrences" $ \facts -> do
    given <- records facts "recurrences" (\o -> (,) <$> o .: "terms" <*> o .: "shortest")
    length given `shouldSatisfy` (> 20)
    forM_ given $ \(Fact q modulus (terms, shortest)) -> over q modulus $ \read' -> do
      result <- synthesise <$> read' terms
      map (fromIntegral . toCode) (coefficients (synthesisPolynomial result))
        `shouldBe` (shortest :: [Natural])

-- | A record with the field that it is over.
data Fact a = Fact Natural [Natural] a

records :: Value -> Key -> (Object -> Parser a) -> IO [Fact a]
records facts name parser =
  either fail pure (parseEither (withObject "facts" (\o -> o .: name >>= traverse fact)) facts)
  where
    fact = withObject "fact" (\o -> Fact <$> o .: "q" <*> o .: "modulus" <*> parser o)

-- | In the field of this order and modulus, with a reader of codes.
over ::
  Natural ->
  [Natural] ->
  (forall k. KnownField k => ([Natural] -> IO [GF k]) -> Expectation) ->
  Expectation
over q modulus check = do
  (p, _) <- right (conwayModulus q)
  checked <-
    right
      ( withField
          p
          modulus
          (\k -> check (\codes -> right (elementsFromCodes codes) >>= pure . inField k))
      )
  checked
  where
    inField :: proxy k -> [GF k] -> [GF k]
    inField _ = id
