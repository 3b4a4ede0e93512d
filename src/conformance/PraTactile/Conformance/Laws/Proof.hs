{-# LANGUAGE GADTs #-}
{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The laws of proofs about masks and of the distances of their windows.
module PraTactile.Conformance.Laws.Proof
  ( proofLaws,
  )
where

import Data.Aeson (toJSON)
import Data.List (intercalate)
import Numeric.Natural (Natural)
import PraTactile.Array (Shape (..), area, naturalSurface)
import PraTactile.Conformance.Definition (ProfileFacts, knownProfile)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Draw
import PraTactile.Conformance.Laws.Judge
import PraTactile.Conformance.Laws.Malformed
import PraTactile.Conformance.Laws.Order
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Question
import PraTactile.Profile (Profile (..))
import Test.QuickCheck (Gen, frequency, listOf1)

-- | The laws of proofs and distances.
proofLaws :: [Law ProfileFacts]
proofLaws =
  concat
    [ ofMasks Prove proves ", and a mask without a window on the sheet is refused: off-sheet",
      ofMasks Distance differs "",
      relationLaws,
      [orderLaw OnProof (operationsIn OnProof)],
      invalidLaws
    ]
  where
    proves =
      "a mask is proved if all its windows on the profile's surface differ; the rank is that of \
      \the mask on the folding's own surface, or null where the profile's surface is neither that \
      \nor the sheet"
    differs =
      "the distance of a mask is the least number of cells in which two of its windows on the \
      \folding's own surface differ"

-- | The laws that hold for both operations on masks, given the operation's sentence, and what it
-- refuses of special masks.
ofMasks :: Op MaskRows o -> String -> String -> [Law ProfileFacts]
ofMasks operation sentence refused =
  [ defined OnProof (name ++ "-small-masks") operation sentence source $ \known ->
      let p = knownProfile known
       in Every (map asked (ofVast 2 p (filter (affordable p) smallMasks))),
    defined OnProof (name ++ "-special-masks") operation (sentence ++ special) source $ \known ->
      Every (map asked (ofVast 6 (knownProfile known) (specialMasks (knownProfile known)))),
    defined OnProof (name ++ "-drawn-masks") operation sentence source $ \known ->
      let Shape n1 n2 = profileShape (knownProfile known)
          within high wide = asked <$> genMask (min n1 high) (min n2 wide)
          large = area (profileShape (knownProfile known)) > 1024
       in Some
            ( if large
                then within 2 2
                else frequency [(14, within 5 5), (1, within 20 20), (1, asked <$> farMask n1 n2)]
            )
            smallerQuestions
  ]
  where
    name = nameOf (SomeOp operation)
    asked = SomeQuestion . (operation :?)
    special = "; blank rows and columns at a mask's end are ignored" ++ refused
    -- For long sequences, only masks with few cells.
    affordable p mask = area (profileShape p) <= 1024 || length (concat mask) <= 4

source :: String
source =
  "the rank of alpha^e(i,j) over GF(q), e(i,j) being the index folded to (i,j); counting \
  \windows"

-- | Special masks: windows that differ only on the sheet, blank rows and columns at the ends, and
-- masks as large as the array or larger.
specialMasks :: Profile -> [MaskRows]
specialMasks p =
  [full (profileWindow p)]
    ++ [["##."], ["##", ".."], [".#"], ["..", ".#"], ["#.", ".."], ["##.", "...", "..."]]
    ++ [['#' : blank n2], ['#' : '#' : blank n2], "#" : replicate (fromIntegral n1) "."]
    ++ [far 11 8 | n1 > 11 && n2 > 9]
    ++ [one 0 (n2 - 1), one (n1 - 1) 0, one (n1 - 1) (n2 - 1), one 0 n2, one n1 0, one n1 n2]
    ++ [one 0 (n2 + 1), one (n1 + 1) 0]
    -- The greatest number of cells of a mask.
    ++ [full (Shape 64 64) | n1 * n2 <= 16]
  where
    Shape n1 n2 = profileShape p
    full (Shape h w) = replicate (fromIntegral h) (replicate (fromIntegral w) '#')
    far :: Natural -> Natural -> MaskRows
    far r c = drawn (r + 1) 10 [(0, 0), (0, 9), (r, c)]
    blank :: Natural -> String
    blank n = replicate (fromIntegral n) '.'
    one :: Natural -> Natural -> MaskRows
    one r c = drawn (r + 1) (c + 1) [(0, 0), (r, c)]
    drawn :: Natural -> Natural -> [(Natural, Natural)] -> MaskRows
    drawn h w cells =
      [[if (i, j) `elem` cells then '#' else '.' | j <- [0 .. w - 1]] | i <- [0 .. h - 1]]

-- | A mask with a few cells far apart, some of them perhaps further than the array's size.
farMask :: Natural -> Natural -> Gen MaskRows
farMask n1 n2 = do
  (h, w) <- (,) <$> upTo (n1 + 2) <*> upTo (n2 + 2)
  cells <- listOf1 ((,) <$> upTo h <*> upTo w)
  pure [[if (r, c) `elem` take 8 cells then '#' else '.' | c <- [0 .. w]] | r <- [0 .. h]]

relationLaws :: [Law ProfileFacts]
relationLaws =
  [ law
      OnProof
      "rank-counts-windows"
      [SomeOp Prove]
      "on the folding's own surface a mask of rank r has q^r different windows, but q^n - 1 if r \
      \is the degree n; it is proved only then"
      source
      ( \known ->
          Cases
            questionForm
            (Some (SomeQuestion . (Prove :?) <$> genMask 3 3) smallerQuestions)
            (\question -> trial (onMask question (counted known)))
      ),
    law
      OnProof
      "distance-is-0-where-the-rank-is-less"
      [SomeOp Prove, SomeOp Distance]
      "two windows of a mask are equal exactly if its rank is less than the degree"
      source
      ( \known ->
          Cases
            questionForm
            (Some (SomeQuestion . (Prove :?) <$> genMask 3 3) smallerQuestions)
            (\question -> trial (onMask question (apart known)))
      )
  ]
  where
    onMask question held = maybe inapplicable held (reProve question)

-- | The mask of a question about a proof.
reProve :: SomeQuestion -> Maybe MaskRows
reProve question = case question of
  SomeQuestion (Prove :? mask) -> Just mask
  _ -> Nothing

counted :: ProfileFacts -> MaskRows -> Trial ()
counted known mask
  | profileSurface p /= naturalSurface (profileFolding p) = inapplicable
  | otherwise = do
    proof <- answer known (Prove :? mask)
    case proofRank proof of
      Just r ->
        demand
          (Because "a theorem on linear codes" "the windows are the codewords of the mask")
          (Prove :? mask)
          (Proof (r == n) (Just r) (windows r))
          (proofHolds proof == (r == n) && proofWindows proof == windows r)
      Nothing ->
        demand
          (Because "the protocol" "the rank is known on this surface")
          (Prove :? mask)
          proof
          False
  where
    p = knownProfile known
    n = degreeOf p
    windows r = if r == n then profileOrder p ^ n - 1 else profileOrder p ^ r

apart :: ProfileFacts -> MaskRows -> Trial ()
apart known mask = do
  proof <- answer known (Prove :? mask)
  d <- answer known (Distance :? mask)
  case proofRank proof of
    Just r ->
      demand
        (Because "a theorem on linear codes" "the rank determines whether windows are equal")
        (Distance :? mask)
        (if r < degreeOf (knownProfile known) then 0 else max 1 d)
        ((d == 0) == (r < degreeOf (knownProfile known)))
    Nothing -> inapplicable

invalidLaws :: [Law ProfileFacts]
invalidLaws =
  [ invalid OnProof "prove-refuses-what-is-invalid" Prove (const (illFormed (Prove :? ["#"]))),
    invalid
      OnProof
      "distance-refuses-what-is-invalid"
      Distance
      (const (illFormed (Distance :? ["#"])))
  ]

illFormed :: Question a -> [SomeQuestion]
illFormed question =
  [ rawWith question "mask" (toJSON drawing)
    | drawing <-
        [ "" :: String,
          "/",
          "#/",
          "/#",
          "##/#",
          "#/##",
          "#x",
          "# #",
          "01",
          "#\n#",
          "##//##",
          ".",
          "../..",
          -- More than 4096 cells.
          replicate 4097 '#',
          intercalate "/" (replicate 65 (replicate 64 '#'))
        ]
  ]
    ++ malformed question
