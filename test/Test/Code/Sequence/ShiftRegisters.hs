{-# LANGUAGE RankNTypes #-}

-- | The two forms of the shift register, and which register produced some symbols. The properties
-- of m-sequences are laws of the conformance suite.
module Test.Code.Sequence.ShiftRegisters (spec) where

import Control.Monad (forM_)
import Data.List (inits)
import Data.Proxy (Proxy)
import Numeric.Natural (Natural)
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Polynomial
import PraTactile.Sequence
import PraTactile.Sequence.Galois
import PraTactile.Sequence.Synthesis
import Test.Code.Generators
import Test.Hspec
import Test.Paper
import Test.QuickCheck hiding (elements)

spec :: Spec
spec = do
  it "over GF(3), x^2 + x + 2 gives 0 1 2 2 0 2 1 1" $ do
    -- By hand: s(i+2) = - (2 s(i) + s(i+1)) = s(i) + 2 s(i+1).
    h <- right (polynomialFromCodes [2, 1, 1])
    p <- right (checkPrimitive (h :: Polynomial GF3))
    map toCode (take 9 (mSequence p (canonicalState p))) `shouldBe` [0, 1, 2, 2, 0, 2, 1, 1, 0]
  it "a state has n elements, and they are not all zero" $ do
    h <- paperPrimitive
    initialState h [0, 0, 0, 0] `shouldBe` Left StateZero
    initialState h [0, 0, 1] `shouldBe` Left (StateLength 3 4)
    initialState h [0, 0, 0, 1, 1] `shouldBe` Left (StateLength 5 4)
    initialState h (repeat 1) `shouldBe` Left (StateLength 5 4)
  describe "stepping" $ do
    it "forward and back again, and back and forward again, changes no state, in both forms" $
      forRegisters $ \h -> forM_ (states h) $ \s -> do
        previous h (next h s) `shouldBe` s
        next h (previous h s) `shouldBe` s
        let g = toGalois h s
        galoisPrevious h (galoisNext h g) `shouldBe` g
        galoisNext h (galoisPrevious h g) `shouldBe` g
    it "q^n - 1 times returns to the state, and fewer steps do not" $
      forRegisters $ \h -> do
        let s = canonicalState h
            walk = take (fromIntegral (period h) + 1) (iterate (next h) s)
        [i | (i, t) <- zip [0 :: Natural ..] walk, t == s] `shouldBe` [0, period h]
    it "t times is stateAt t, for negative, small and large t" $
      forRegisters $ \h -> do
        let s = canonicalState h
            terms = toInteger (period h)
        forM_ [0 .. min 40 terms] $ \t -> do
          stateAt h s t `shouldBe` iterate (next h) s !! fromInteger t
          stateAt h s (-t) `shouldBe` iterate (previous h) s !! fromInteger t
          stateAt h s (t + 10 ^ (20 :: Int) * terms) `shouldBe` stateAt h s t
    it "backward gives the sequence of the reciprocal polynomial" $
      forRegisters $ \h -> forM_ (take 5 (states h)) $ \s -> do
        let backward =
              take 60 (concatMap (take 1 . reverse . stateElements) (iterate (previous h) s))
            g = reciprocal h
        start <- right (initialState g (take (primitiveDegree h) backward))
        take 60 (mSequence g start) `shouldBe` backward
        reciprocal g `shouldBe` h
  describe "the Galois register" $ do
    it "has the output of the Fibonacci register whose state toGalois maps to its own" $
      forRegisters $ \h -> forM_ (states h) $ \s ->
        take 40 (galoisSequence h (toGalois h s)) `shouldBe` take 40 (mSequence h s)
    it "toFibonacci undoes toGalois, and steps map to steps" $
      forRegisters $ \h -> forM_ (states h) $ \s -> do
        toFibonacci h (toGalois h s) `shouldBe` Right s
        toGalois h (next h s) `shouldBe` galoisNext h (toGalois h s)
    it "steps by multiplication by x modulo h" $
      forRegisters $ \h -> forM_ (states h) $ \s -> do
        let residue = polynomial (stateElements s)
        fmap galoisElements (galoisNext h <$> galoisState h (stateElements s))
          `shouldBe` Right
            ( padded
                h
                ( maybe
                    []
                    (coefficients . snd)
                    (quotientRemainder (variable * residue) (primitivePolynomial h))
                )
            )
    it "over GF(3), x^2 + x + 2: from 1 + 0 x it runs 1, x, 2 x + 1, ..." $ do
      -- x^2 = - x - 2 = 2 x + 1.
      h <- right (polynomialFromCodes [2, 1, 1])
      p <- right (checkPrimitive (h :: Polynomial GF3))
      start <- right (galoisState p [1, 0])
      map (map toCode . galoisElements) (take 3 (iterate (galoisNext p) start))
        `shouldBe` [[1, 0], [0, 1], [1, 2]]
    it "refuses a state of zeros or of another length" $ do
      h <- paperPrimitive
      galoisState h [0, 0, 0, 0] `shouldBe` Left StateZero
      galoisState h [1] `shouldBe` Left (StateLength 1 4)
  describe "synthesis" $ do
    it "recovers every primitive polynomial with q^n <= 4096 from 2 n terms, from any start" $
      forM_ everyField $ \(q, SomeField k) ->
        forM_ (takeWhile (\n -> q ^ n <= 4096) [1 ..]) $ \n -> do
          found <- right (primitivePolynomials (fromIntegral n))
          forM_ (zip [1 ..] found) $ \(i, h) -> do
            let s = mSequence h (stateAt (h `over` k) (canonicalState h) (i * i * 2654435761))
                result = synthesise (take (2 * n) s)
            if synthesisPolynomial result == primitivePolynomial h
              && synthesisLength result == n
              && synthesisDetermined result
              then pure ()
              else
                expectationFailure
                  (show (q, h, synthesisLength result, synthesisPolynomial result))
    it "finds a shortest register, and whether it is unique, for all short sequences" $ do
      sequencesUpTo 7 $ \s -> judged (s :: [GF GF2])
      sequencesUpTo 5 $ \s -> judged (s :: [GF GF3])
    it "needs k + 1 stages for a 1 after k zeros" $
      forM_ [0 .. 20] $ \k ->
        synthesisLength (synthesise (replicate k 0 ++ [1 :: GF GF4])) `shouldBe` k + 1
    it "needs no stages for zeros, or for no terms" $ do
      synthesisLength (synthesise (replicate 9 (0 :: GF GF9))) `shouldBe` 0
      synthesisLength (synthesise ([] :: [GF GF9])) `shouldBe` 0
      synthesisPolynomial (synthesise ([] :: [GF GF9])) `shouldBe` 1
    it "finds a register with these terms; if 2 L < N, one term less suffices" $
      conjoin
        [ counterexample (show q) (putsOut k)
          | (q, SomeField k) <- [f | f <- everyField, fst f `elem` [2, 3, 4, 5, 8, 9, 251, 256]]
        ]
  where
    padded h cs = take (primitiveDegree h) (cs ++ repeat zero)
    over :: Primitive k -> Proxy k -> Primitive k
    over h _ = h

-- | For the first three primitive polynomials of many small sizes.
forRegisters :: (forall k. KnownField k => Primitive k -> Expectation) -> Expectation
forRegisters check =
  forM_
    [ (2, 1),
      (2, 2),
      (2, 5),
      (2, 8),
      (3, 1),
      (3, 2),
      (3, 4),
      (4, 1),
      (4, 3),
      (5, 2),
      (7, 2),
      (8, 2),
      (9, 1),
      (9, 2),
      (16, 2),
      (25, 1),
      (256, 1),
      (251, 1)
    ]
    $ \(q, n) ->
      overField q $ \(_ :: Proxy k) -> do
        found <- right (primitivePolynomials n)
        forM_ (take 3 (found :: [Primitive k])) check

-- | Some states, all of them for small sizes.
states :: KnownField k => Primitive k -> [State k]
states h =
  [s | Right s <- map (initialState h) (take 40 (mapM (const elements) [1 .. primitiveDegree h]))]

sequencesUpTo :: KnownField k => Int -> ([GF k] -> Expectation) -> Expectation
sequencesUpTo n check = forM_ [0 .. n] $ \size -> forM_ (mapM (const elements) [1 .. size]) check

-- | Compare with all registers, shortest first: those of L stages are the L coefficients of
-- s(i) = a1 s(i-1) + ... + aL s(i-L), which must hold for L <= i < N.
judged :: KnownField k => [GF k] -> Expectation
judged s = do
  let result = synthesise s
      registers l = mapM (const elements) [1 .. l]
      fits a =
        and
          [ x == sum (zipWith (*) a earlier)
            | (earlier, x) <- drop (length a) (zip (map reverse (inits s)) s)
          ]
      shortest =
        take 1 [(l, good) | l <- [0 ..], let good = filter fits (registers l), not (null good)]
      ours = map negate (drop 1 (reverse (coefficients (synthesisPolynomial result))))
  [l | (l, _) <- shortest] `shouldBe` [synthesisLength result]
  concatMap snd shortest `shouldContain` [ours]
  synthesisDetermined result `shouldBe` (map (length . snd) shortest == [1])

putsOut :: KnownField k => Proxy k -> Property
putsOut k =
  forAllShrink (choose (0, 30) >>= genElementsOf k) shrinkElements $ \s ->
    let result = synthesise s
        n = synthesisLength result
        a = map negate (drop 1 (reverse (coefficients (synthesisPolynomial result))))
     in and
          [ x == sum (zipWith (*) a earlier)
            | (earlier, x) <- drop n (zip (map reverse (inits s)) s)
          ]
          .&&. length (coefficients (synthesisPolynomial result)) === n + 1
          .&&. ( 2 * n > length s - 1
                   || synthesisPolynomial (synthesise (take (length s - 1) s))
                     == synthesisPolynomial result
                   || null s
               )
  where
    genElementsOf :: KnownField k => Proxy k -> Int -> Gen [GF k]
    genElementsOf _ = genElements
