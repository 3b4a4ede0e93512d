{-# LANGUAGE GADTs #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Impostors of the sequence, the array, packed windows, and proofs about masks.
module PraTactile.Conformance.Impostors.Arrays
  ( sequenceImpostors,
    arrayImpostors,
    windowImpostors,
    proofImpostors,
  )
where

import Control.Monad.Trans.Except (except)
import qualified Data.Vector.Unboxed as Vector
import Numeric.Natural (Natural)
import PraTactile.Array
  ( Folding (..),
    Position (..),
    Shape (..),
    Surface (..),
    area,
    naturalSurface,
  )
import PraTactile.Conformance.Definition (expected)
import PraTactile.Conformance.Definition.Array
import PraTactile.Conformance.Definition.Field (negation)
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Impostors.Impostor
import PraTactile.Conformance.Question
import PraTactile.Profile (Profile (..), Reading (..))
import PraTactile.Window (Packing (..))

-- | Mistakes in the sequence.
sequenceImpostors :: [Impostor]
sequenceImpostors =
  [ knowing "forgets-to-negate-the-taps" "takes the sum of the terms, not its negative" $ \k ->
      let (taps, state) = recurrence k
          f = knownField k
       in withTerms (sequenceOf f (map (negation f) taps) state) k,
    under
      "reads-every-polynomial-as-characteristic"
      "takes the reciprocal polynomial for the characteristic one"
      $ \p -> p {profileReading = Characteristic},
    under "reverses-the-state" "begins with the profile's state backwards" $ \p ->
      p {profileState = reverse (profileState p)},
    indexed "has-a-period-of-q-to-the-n" "takes indices modulo q^n, not q^n - 1" $ \p i ->
      i `mod` (profileOrder p ^ (length (profilePolynomial p) - 1)),
    indexed "takes-indices-in-64-bits" "reads indices in 64 bits, cut off" $ \_ i ->
      i `mod` 2 ^ (64 :: Int),
    answeringOtherwise
      "counts-a-run-to-its-end"
      "takes the length of a run for the index of its last term"
      $ \_ right question -> case question of
        Terms :? (from, count) -> right (Terms :? (from, if count > from then count - from else 0))
        _ -> right question
  ]
  where
    indexed :: String -> String -> (Profile -> Natural -> Natural) -> Impostor
    indexed name mistake change =
      answeringOtherwise name mistake $ \k right question ->
        let index = change (knownProfile k)
         in case question of
              Term :? i -> right (Term :? index i)
              Terms :? (from, count) -> right (Terms :? (index from, count))
              Cell :? Position r c -> right (Cell :? Position (index r) (index c))
              _ -> right question

-- | Mistakes in the array.
arrayImpostors :: [Impostor]
arrayImpostors =
  [ knowing
      "transposes-the-fold"
      "counts rows by the number of columns, and columns by that of rows"
      $ \k ->
        let (n1, n2) = knownSize k
            index r c =
              sum (take 1 [i | i <- [r `mod` n2, r `mod` n2 + n2 ..], (i - c) `mod` n1 == 0])
            transposed = Vector.fromList [knownTerms k Vector.! index r c | (r, c) <- positions k]
         in if profileFolding (knownProfile k) == Diagonal then k {knownCells = transposed} else k,
    answeringOtherwise "ends-at-the-edges" "refuses cells beyond the edges" $
      \k right question -> case question of
        Cell :? Position r c
          | Shape n1 n2 <- profileShape (knownProfile k),
            r >= n1 || c >= n2 ->
            refuse "off-sheet"
        _ -> right question,
    answeringOtherwise
      "goes-on-as-the-profiles-surface"
      "continues cells on the profile's surface, not on the folding's own"
      $ \k right question -> case question of
        Cell :? Position r c -> right (Cell :? uncurry Position (on (knownProfile k) (r, c)))
        _ -> right question,
    answeringOtherwise "counts-cells-from-one" "counts rows and columns from 1" $
      \k right question -> case question of
        Cell :? Position r c ->
          let Shape n1 n2 = profileShape (knownProfile k)
           in right (Cell :? Position (r + n1 - 1) (c + n2 - 1))
        _ -> right question,
    under "takes-the-sheet-for-the-torus" "looks on where the sheet ends" $ \p ->
      p {profileSurface = if profileSurface p == Sheet then Torus else profileSurface p}
  ]
  where
    on p (r, c) = case profileSurface p of
      TwistedTorus -> ((r + c `div` n2) `mod` n1, c `mod` n2)
      _ -> (r `mod` n1, c `mod` n2)
      where
        Shape n1 n2 = profileShape p

-- | Mistakes in packing windows.
windowImpostors :: [Impostor]
windowImpostors =
  [ under "packs-in-the-other-order" "has the first cell at the other end of the number" $ \p ->
      p
        { profilePacking = case profilePacking p of
            MostSignificantFirst -> LeastSignificantFirst
            LeastSignificantFirst -> MostSignificantFirst
        },
    answeringOtherwise "drops-leading-zeros" "unpacks as many cells as the number has digits" $
      \_ right question -> case question of
        Unpack :? n -> dropWhile (== 0) <$> right (Unpack :? n)
        _ -> right question,
    answeringOtherwise "unpacks-modulo" "unpacks any number by its lowest digits" $
      \k right question -> case question of
        Unpack :? n ->
          let p = knownProfile k
           in right (Unpack :? n `mod` profileOrder p ^ area (profileWindow p))
        _ -> right question
  ]

-- | Mistakes in proofs and distances.
proofImpostors :: [Impostor]
proofImpostors =
  [ answeringOtherwise
      "counts-windows-without-zeros"
      "leaves the window of zeros out of the count"
      $ \k right question -> case question of
        Prove :? mask -> do
          proof <- right (Prove :? mask)
          let zeros = if proofRank proof == Just (degree k) then 0 else 1
          pure proof {proofWindows = proofWindows proof - zeros}
        _ -> right question,
    answeringOtherwise
      "proves-on-the-torus"
      "counts the windows on the folding's own surface, whatever the profile's"
      $ \k right question -> case question of
        Prove :? _ -> do
          let p = knownProfile k
          own <- knownUnder p {profileSurface = naturalSurface (profileFolding p)}
          except (expected own question)
        _ -> right question,
    answeringOtherwise "fills-the-mask" "takes the rectangle around a mask for the mask" $
      \_ right question ->
        let filled = map (map (\mark -> if mark == '.' then '#' else mark))
         in case question of
              Prove :? mask -> right (Prove :? filled mask)
              Distance :? mask -> right (Distance :? filled mask)
              _ -> right question,
    answeringOtherwise
      "looks-at-different-windows-only"
      "takes the least distance above 0, also where two windows are the same"
      $ \_ right question -> case question of
        Distance :? mask -> max 1 <$> right (Distance :? mask)
        _ -> right question
  ]
  where
    degree k = fromIntegral (length (profilePolynomial (knownProfile k))) - 1
