{-# LANGUAGE RankNTypes #-}

-- | Profiles and the door from them to typed arrays.
module Test.Code.Profile.DoorToArrays (spec) where

import Control.Monad (forM_)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Polynomial
import PraTactile.Profile
import PraTactile.Sequence
import PraTactile.Window
import PraTactile.Window.Proof
import Test.Hspec

spec :: Spec
spec = do
  describe "the canonical profile" $ do
    it "is what choosing its array gives" $
      chooseProfile
        (profileChoice 4 [3, 2, 1, 0, 1] (Shape 15 17))
          { chosenModulus = Just [1, 1, 1],
            chosenWindow = Just (Shape 2 2),
            chosenState = Just [0, 0, 0, 1]
          }
        `shouldBe` Right canonicalProfile
    it "is also given if everything optional is left out" $
      chooseProfile (profileChoice 4 [3, 2, 1, 0, 1] (Shape 15 17))
        `shouldBe` Right canonicalProfile
    it "gives the paper's array, with the worked example at (6, 5)" $
      withProfile
        canonicalProfile
        (\array m -> map showElement <$> windowAt (ArrayOn Torus array) m (Position 6 5))
        `shouldBe` Right (Just ["A^2", "A", "A^2", "1"])
    it "has the first primitive quartic of its field" $
      withProfile canonicalProfile (\array _ -> firstPrimitive 4 == Right (arrayPrimitive array))
        `shouldBe` Right True
  describe "the inferred window" $ do
    it "is k1 x k2 where n1 = q^k1 - 1 and n = k1 k2" $ do
      inferWindow 4 4 (Shape 15 17) `shouldBe` Just (Shape 2 2)
      inferWindow 4 6 (Shape 63 65) `shouldBe` Just (Shape 3 2)
      inferWindow 4 6 (Shape 15 273) `shouldBe` Just (Shape 2 3)
      inferWindow 2 5 (Shape 1 31) `shouldBe` Just (Shape 1 5)
      inferWindow 2 5 (Shape 31 1) `shouldBe` Just (Shape 5 1)
    it "is absent otherwise" $
      forM_
        [ (4, 4, Shape 17 15),
          (4, 4, Shape 51 5),
          (4, 6, Shape 255 16),
          (4, 0, Shape 3 5),
          (1, 4, Shape 0 3),
          (0, 4, Shape 15 17)
        ]
        $ \(q, n, shape) ->
          inferWindow q n shape `shouldBe` Nothing
    it "must then be given" $
      chooseProfile (profileChoice 4 [3, 2, 1, 0, 1] (Shape 17 15))
        `shouldBe` Left (WindowNotInferred 17 4)
  describe "other choices" $ do
    it "15 x 273 has no diagonal fold" $
      (chooseProfile (profileChoice 4 [2, 1, 1, 0, 0, 0, 1] (Shape 15 273)) >>= opened)
        `shouldBe` Left (ProfileFold (NotCoprime 15 273 3))
    it "63 x 65 has a diagonal fold, and its 3 x 2 windows are distinct" $
      ( chooseProfile (profileChoice 4 [2, 1, 1, 0, 0, 0, 1] (Shape 63 65)) >>= \p ->
          withProfile p (\array m -> fmap (proved . fst) (prove (ArrayOn Torus array) m))
      )
        `shouldBe` Right (Right True)
    it "the reciprocal reading makes the monic reciprocal the characteristic polynomial" $ do
      let reversed' = canonicalProfile {profileReading = Reciprocal}
          characteristic array =
            map toCode (coefficients (primitivePolynomial (arrayPrimitive array)))
      -- x^4 h(1/x) = A^2 x^4 + A x^3 + x^2 + 1, divided by A^2 = 1 / A.
      withProfile reversed' (\array _ -> characteristic array) `shouldBe` Right [2, 0, 2, 3, 1]
    it "a modulus other than the default one is used" $
      -- GF(8) with A^3 = A^2 + 1 instead of A + 1.
      withProfile
        canonicalProfile
          { profileOrder = 8,
            profileModulus = [1, 0, 1, 1],
            profilePolynomial = [2, 1],
            profileState = [1],
            profileShape = Shape 7 1,
            profileWindow = Shape 1 1
          }
        (\array _ -> [toCode (cellAt array (Position i 0)) | i <- [0 .. 3]])
        `shouldBe` Right [1, 2, 4, 5]
  describe "impossible choices" $ do
    let refusedBy change reason = opened (change canonicalProfile) `shouldBe` Left reason
    it "an order that is not a prime power, or too large" $ do
      (\p -> p {profileOrder = 6}) `refusedBy` ProfileField (NotAPrimePower 6)
      (\p -> p {profileOrder = 512}) `refusedBy` ProfileField (FieldTooLarge 512 1)
      chooseProfile (profileChoice 6 [1, 1] (Shape 1 5))
        `shouldBe` Left (ProfileField (NotAPrimePower 6))
    it "a modulus of another degree, or reducible" $ do
      (\p -> p {profileModulus = [1, 1, 0, 1]}) `refusedBy` ModulusDegree 3 2
      (\p -> p {profileModulus = []}) `refusedBy` ModulusDegree 0 2
      -- Ten coefficients are looked at, one more than any field of this kind has.
      (\p -> p {profileModulus = repeat 1}) `refusedBy` ModulusDegree 9 2
      (\p -> p {profileModulus = [1, 0, 1]}) `refusedBy` ProfileField (ModulusReducible 2 [1, 0, 1])
    it "a polynomial with foreign codes, not monic, or not primitive" $ do
      (\p -> p {profilePolynomial = [3, 2, 4, 0, 1]}) `refusedBy` ProfileField (CodeOutOfRange 4 4)
      (\p -> p {profilePolynomial = [3, 2, 1, 0, 2]})
        `refusedBy` ProfilePolynomial (PolynomialNotMonic 2)
      (\p -> p {profilePolynomial = [1, 0, 0, 0, 1]})
        `refusedBy` ProfilePolynomial PolynomialReducible
      (\p -> p {profilePolynomial = []}) `refusedBy` ProfileFold (WrongArea (Shape 15 17) 0)
    it "a polynomial of far too large a degree, refused at once" $
      (\p -> p {profilePolynomial = replicate 3000 1})
        `refusedBy` ProfileFold (WrongArea (Shape 15 17) (4 ^ (2999 :: Int) - 1))
    it "a state of another length, of zeros, or with foreign codes" $ do
      (\p -> p {profileState = [0, 1]}) `refusedBy` ProfileState (StateLength 2 4)
      (\p -> p {profileState = [0, 0, 0, 0]}) `refusedBy` ProfileState StateZero
      (\p -> p {profileState = [0, 0, 0, 7]}) `refusedBy` ProfileField (CodeOutOfRange 7 4)
    it "a shape whose area is not q^n - 1" $
      (\p -> p {profileShape = Shape 15 16}) `refusedBy` ProfileFold (WrongArea (Shape 15 16) 255)
    it "a window without cells, or with too many" $ do
      (\p -> p {profileWindow = Shape 0 2}) `refusedBy` ProfileWindow WindowEmpty
      (\p -> p {profileWindow = Shape 1000 1000}) `refusedBy` ProfileWindow (WindowTooLarge 1000000)

opened :: Profile -> Either ProfileError Natural
opened profile = withProfile profile (\array _ -> area (arrayShape array))
