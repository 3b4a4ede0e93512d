{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The laws of the array and its windows: the array is the folded sequence and continues beyond
-- its edges; windows are packed as the profile states.
module PraTactile.Conformance.Laws.Array
  ( arrayLaws,
    windowLaws,
  )
where

import Control.Monad (replicateM)
import Data.Aeson (Value (..), toJSON)
import Data.List (nub)
import Numeric.Natural (Natural)
import PraTactile.Array (Folding (..), Position (..), Shape (..), area, naturalsBelow, shapeCells)
import PraTactile.Conformance.Definition (ProfileFacts, knownProfile)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Draw
import PraTactile.Conformance.Laws.Forms
import PraTactile.Conformance.Laws.Judge
import PraTactile.Conformance.Laws.Malformed
import PraTactile.Conformance.Laws.Order
import PraTactile.Conformance.Operations (operationsIn, smallerQuestions)
import PraTactile.Conformance.Operations.Conventions (lessList, lessNatural)
import PraTactile.Conformance.Question
import PraTactile.Format.Json.Codec (listOf, natural)
import PraTactile.Profile (Profile (..))
import Test.QuickCheck hiding (listOf)

-- | The laws of the array's cells.
arrayLaws :: [Law ProfileFacts]
arrayLaws = cellLaws ++ formLaws OnArray [SomeOp Cell]

cellLaws :: [Law ProfileFacts]
cellLaws =
  [ defined OnArray "cell-as-defined" Cell "every cell of the array" folding $ \known ->
      let shape@(Shape n1 n2) = profileShape (knownProfile known)
       in if isVast (knownProfile known)
            then
              Some
                (SomeQuestion . (Cell :?) <$> (Position <$> upTo (n1 - 1) <*> upTo (n2 - 1)))
                smallerQuestions
            else Every [SomeQuestion (Cell :? Position r c) | Position r c <- shapeCells shape],
    defined OnArray "cell-at-the-edges" Cell beyond folding $ \known ->
      Every
        [ SomeQuestion (Cell :? Position r c)
          | (r, c) <-
              aroundTheEdges
                (profileShape (knownProfile known))
        ],
    defined OnArray "cell-far-beyond-the-edges" Cell beyond folding $ \_ ->
      Some (SomeQuestion . (Cell :?) <$> (Position <$> anyNatural <*> anyNatural)) smallerQuestions,
    law
      OnArray
      "cells-are-terms"
      [SomeOp Cell, SomeOp Term]
      "a[i mod n1][i mod n2] = s(i) for the diagonal fold, a[i div n2][i mod n2] = s(i) for the \
      \row-major one"
      folding
      ( \known ->
          Cases
            natural
            (Some (upTo (periodOf (knownProfile known) - 1)) lessNatural)
            (trial . folded known)
      ),
    invalid OnArray "cell-refuses-what-is-invalid" Cell $ \_ ->
      [rawWith (Cell :? Position 0 0) name (Number (-1)) | name <- ["row", "column"]]
        ++ malformed (Cell :? Position 1 1)
  ]

folding :: String
folding = "MacWilliams and Sloane (1976), section III; the profile's folding and shape"

beyond :: String
beyond =
  "beyond the edges the array continues on the folding's own surface, whatever the profile's \
  \surface: the torus for the diagonal folding, the twisted torus for the row-major one"

-- | Rows and columns around the edges, once and twice around, and with only one of them beyond.
aroundTheEdges :: Shape -> [(Natural, Natural)]
aroundTheEdges (Shape n1 n2) =
  [ (r, c)
    | r <- around n1,
      c <- around n2,
      r >= n1 || c >= n2
  ]
  where
    around n = [0, 1] ++ [n - 1, n, n + 1, 2 * n - 1, 2 * n, 3 * n + 1]

folded :: ProfileFacts -> Natural -> Trial ()
folded known i = do
  wanted <- answer known (Term :? i)
  got <- answer known question
  demand
    ( Because
        "the folding, with the other answer of the same implementation"
        "the cell is that term"
    )
    question
    wanted
    (wanted == got)
  where
    p = knownProfile known
    Shape n1 n2 = profileShape p
    question = case profileFolding p of
      Diagonal -> Cell :? Position (i `mod` n1) (i `mod` n2)
      RowMajor -> Cell :? Position ((i `div` n2) `mod` n1) (i `mod` n2)

-- | The laws of packing.
windowLaws :: [Law ProfileFacts]
windowLaws =
  packingLaws
    ++ [orderLaw OnWindow (operationsIn OnWindow)]
    ++ formLaws OnWindow (operationsIn OnWindow)

packingLaws :: [Law ProfileFacts]
packingLaws =
  [ defined
      OnWindow
      "pack-as-defined"
      Pack
      "a window is packed as the base-q number of its cells"
      packing
      (contents (SomeQuestion . (Pack :?))),
    defined
      OnWindow
      "unpack-as-defined"
      Unpack
      "a number below q^cells is unpacked to the window"
      packing
      numbers,
    defined
      OnWindow
      "unpack-refuses-what-packs-no-window"
      Unpack
      "a number of q^cells or more is refused: out-of-range"
      packing
      ( \known ->
          let most = profileOrder (knownProfile known) ^ cellsOf known
           in Every
                [ SomeQuestion (Unpack :? n)
                  | n <- nub ([most, most + 1, 2 * most] ++ filter (>= most) bigNaturals)
                ]
      ),
    law
      OnWindow
      "unpack-inverts-pack"
      [SomeOp Pack, SomeOp Unpack]
      "unpacking a packed window gives its cells again"
      packing
      ( \known ->
          let lower codes =
                filter
                  ((== cellsOf known) . fromIntegral . length)
                  (lessList lessNatural codes)
           in Cases (listOf natural) (Some (genContent known) lower) (trial . unpacked known)
      ),
    invalid OnWindow "pack-refuses-what-is-invalid" Pack $ \known ->
      let k = fromIntegral (cellsOf known)
          q = profileOrder (knownProfile known)
          zeros n = replicate n 0
       in [SomeQuestion (Pack :? zeros n) | n <- [0, k - 1, k + 1, 2 * k], n /= k]
            ++ [SomeQuestion (Pack :? take k (a : zeros k)) | a <- noCodes (knownProfile known)]
            ++ [SomeQuestion (Pack :? zeros (k - 1) ++ [q])]
            ++ [rawWith (Pack :? [0]) "cells" (toJSON (replicate k (-1 :: Int)))]
            ++ malformed (Pack :? zeros k),
    invalid OnWindow "unpack-refuses-what-is-invalid" Unpack $ \_ ->
      rawWith (Unpack :? 0) "packed" (Number (-1)) : malformed (Unpack :? 1)
  ]

packing :: String
packing = "the profile's packing and window"

cellsOf :: ProfileFacts -> Natural
cellsOf = area . profileWindow . knownProfile

-- | All contents of a window, or drawn ones if there are more than 1024.
contents :: ([Code] -> SomeQuestion) -> ProfileFacts -> Domain SomeQuestion
contents asked known
  | profileOrder p ^ cellsOf known <= 1024 =
    Every (asked <$> replicateM (fromIntegral (cellsOf known)) (elementsOf p))
  | otherwise = Some (asked <$> genContent known) smallerQuestions
  where
    p = knownProfile known

genContent :: ProfileFacts -> Gen [Code]
genContent known =
  vectorOf (fromIntegral (cellsOf known)) (upTo (profileOrder (knownProfile known) - 1))

numbers :: ProfileFacts -> Domain SomeQuestion
numbers known
  | most <= 1024 = Every (SomeQuestion . (Unpack :?) <$> naturalsBelow most)
  | otherwise = Some (SomeQuestion . (Unpack :?) <$> upTo (most - 1)) smallerQuestions
  where
    most = profileOrder (knownProfile known) ^ cellsOf known

unpacked :: ProfileFacts -> [Code] -> Trial ()
unpacked known codes = do
  number <- answer known (Pack :? codes)
  got <- answer known (Unpack :? number)
  demand
    (Because "the other answer of the same implementation" "it was packed so")
    (Unpack :? number)
    codes
    (codes == got)
