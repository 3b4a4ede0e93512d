{-# LANGUAGE GADTs #-}
{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The laws of the nearest position, for patches with missing and wrong cells.
module PraTactile.Conformance.Laws.Damage
  ( damageLaws,
  )
where

import Data.Aeson (Value (..), toJSON)
import Data.Scientific (scientific)
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Surface (..), area, naturalSurface)
import PraTactile.Conformance.Definition (ProfileFacts, expected, knownProfile)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Draw
import PraTactile.Conformance.Laws.Forms
import PraTactile.Conformance.Laws.Judge
import PraTactile.Conformance.Laws.Locate
import PraTactile.Conformance.Laws.Malformed
import PraTactile.Conformance.Laws.Order
import PraTactile.Conformance.Operations (smallerQuestions)
import PraTactile.Conformance.Question
import PraTactile.Format.Json.Codec (Codec, key, listOf, natural, nullable, object, position)
import PraTactile.Profile (Profile (..))
import Test.QuickCheck hiding (listOf)

-- | The laws of the nearest position.
damageLaws :: [Law ProfileFacts]
damageLaws =
  correctionLaws ++ systematicLaws ++ drawnLaws
    ++ [orderLaw OnDamage [SomeOp Locate, SomeOp Nearest]]
    ++ formLaws OnDamage [SomeOp Nearest]
    ++ [invalidLaw]

source :: String
source =
  "MacWilliams and Sloane, The Theory of Error-Correcting Codes, chapter 1; the \
  \protocol, nearest"

comparing :: String -> String -> (ProfileFacts -> Domain SomeQuestion) -> Law ProfileFacts
comparing what sentence = defined OnDamage what Nearest sentence source

-- | A patch with its position and its true cells.
data Seen = Seen
  { seenPlace :: Position,
    seenTrue :: [[Code]],
    seenPatch :: Patch
  }

seenForm :: Codec Seen
seenForm =
  object
    ( Seen <$> key "place" position seenPlace
        <*> key "true" (listOf (listOf natural)) seenTrue
        <*> key "patch" (listOf (listOf (nullable natural))) seenPatch
    )

-- | The patches with one damage removed.
lessDamaged :: Seen -> [Seen]
lessDamaged seen =
  [ seen {seenPatch = mended}
    | (i, line) <- zip [0 ..] (seenPatch seen),
      (j, cell) <- zip [0 ..] line,
      Just right <- [Just <$> at i j (seenTrue seen)],
      cell /= right,
      let mended = put i (put j right line) (seenPatch seen)
  ]
  where
    at :: Int -> Int -> [[a]] -> Maybe a
    at i j rows = case drop i rows of
      line : _ | x : _ <- drop j line -> Just x
      _ -> Nothing
    put :: Int -> a -> [a] -> [a]
    put i x xs = take i xs ++ x : drop (i + 1) xs

-- | The laws of guaranteed correction.
correctionLaws :: [Law ProfileFacts]
correctionLaws =
  [ law
      OnDamage
      "corrects-within-the-guaranteed-radius"
      [SomeOp Nearest]
      "e wrong cells are corrected if 2 e < d, where d is the least number of cells in which two \
      \contents of the observed cells differ on the folding's own surface"
      source
      ( \known ->
          Cases
            seenForm
            (Some (genWithin known) lessDamaged)
            (trial . corrected known Nothing)
      ),
    law
      OnDamage
      "corrects-as-far-as-it-is-told"
      [SomeOp Nearest]
      "e wrong cells are corrected if 2 e < d, also with the radius e stated"
      source
      ( \known ->
          Cases seenForm (Some (genWithin known) lessDamaged) $ \seen ->
            trial (corrected known (Just (wrongCells seen)) seen)
      )
  ]

wrongCells :: Seen -> Natural
wrongCells seen =
  fromIntegral
    ( length
        [ ()
          | (true, Just cell) <-
              zip (concat (seenTrue seen)) (concat (seenPatch seen)),
            true /= cell
        ]
    )

corrected :: ProfileFacts -> Maybe Natural -> Seen -> Trial ()
corrected known radius seen
  | profileSurface p `notElem` [Sheet, naturalSurface (profileFolding p)] = inapplicable
  | 2 * wrongCells seen < observedDistance known (seenPatch seen) = do
    got <- answer known question
    demand
      (Because "a theorem on codes" "fewer than half the distance are wrong")
      question
      (At (seenPlace seen))
      (got == At (seenPlace seen))
  | otherwise = inapplicable
  where
    p = knownProfile known
    question = Nearest :? (radius, seenPatch seen)

-- | The distance of the observed cells on the folding's own surface; 0 if no cell was observed.
observedDistance :: ProfileFacts -> Patch -> Natural
observedDistance known rows =
  either (const 0) id (expected known (Distance :? map (map drawn) rows))
  where
    drawn = maybe '.' (const '#')

-- | A patch with as many missing and wrong cells as the distance of its shape can correct. On a
-- surface that is neither the folding's own nor the sheet, no correction is guaranteed.
genWithin :: ProfileFacts -> Gen Seen
genWithin known = do
  shape <- elements (shapesAround p)
  place <- genPlace p shape
  let true = seenAt known shape place
      d = observedDistance known (map (map Just) true)
      cells = area shape
  missing <- if d == 0 then pure 0 else upTo (min (d - 1) (cells - 1))
  e <- if d == 0 then pure 0 else upTo ((d - 1 - missing) `div` 2)
  fates <-
    shuffle
      ( replicate (fromIntegral missing) Gone ++ replicate (fromIntegral e) Wrong
          ++ replicate
            (fromIntegral (cells - missing - e))
            Kept
      )
  bys <- vectorOf (fromIntegral cells) (upTo (profileOrder p - 2))
  pure (Seen place true (damagedBy true (zip fates bys)))
  where
    p = knownProfile known
    damagedBy rows fates = case rows of
      [] -> []
      line : rest ->
        let (now, later) = splitAt (length line) fates
         in zipWith suffer line now : damagedBy rest later
    suffer code (fate, by) = case fate of
      Kept -> Just code
      Gone -> Nothing
      Wrong -> Just ((code + 1 + by) `mod` profileOrder p)

data Fate = Kept | Gone | Wrong

systematicLaws :: [Law ProfileFacts]
systematicLaws =
  [ comparing "small-patches" (asCompared ++ ", within the guaranteed radius") $ \known ->
      Every (asked Nothing <$> smallPatches 300 (knownProfile known)),
    comparing "small-patches-within-a-radius" (asCompared ++ ", within radii 0 to 2") $ \known ->
      Every [asked (Just e) rows | rows <- smallPatches 100 (knownProfile known), e <- [0, 1, 2]],
    comparing "zeros" "zeros, also with a few correctable cells, are refused: zero-window" $
      \known ->
        Every . ofVast 5 (knownProfile known) $
          [ asked radius rows
            | zeros <- zeroPatches (knownProfile known),
              radius <- [Nothing, Just 0, Just 1],
              rows <- [zeros, onePlaced zeros]
          ],
    comparing "nothing-observed" "a patch without an observed cell is refused: too-few-cells" $
      \known ->
        Every
          [ asked radius rows
            | rows <- unobserved (knownProfile known),
              radius <- [Nothing, Just 0, Just 3]
          ],
    comparing
      "across-the-edges"
      "across the edges a patch is compared where the surface continues; there is no position \
      \where it ends"
      ( \known ->
          Every
            ( ofVast
                10
                (knownProfile known)
                [asked radius rows | rows <- acrossEdges known, radius <- [Nothing, Just 1]]
            )
      )
  ]

-- | The patch with 1 in its first cell.
onePlaced :: Patch -> Patch
onePlaced rows = case rows of
  (_ : line) : rest -> (Just 1 : line) : rest
  _ -> rows

asCompared :: String
asCompared =
  "a patch is located, ambiguous or refused by comparing its observed cells with all positions"

asked :: Maybe Natural -> Patch -> SomeQuestion
asked radius = SomeQuestion . (Nearest :?) . (,) radius

drawnLaws :: [Law ProfileFacts]
drawnLaws =
  [ comparing "guaranteed-radius" (asCompared ++ ", within the guaranteed radius") $ \known ->
      Some (asked Nothing <$> genDamaged known (Damage 15 15)) smallerQuestions,
    comparing "cells-observed-decide" "the observed cells decide the guaranteed radius" $ \known ->
      Some (asked Nothing <$> genDamaged known (Damage 35 6)) smallerQuestions,
    comparing "stated-radius" (asCompared ++ ", within a stated radius") $ \known ->
      Some
        ( do
            radius <- upTo 5
            wrong <- elements [5, 15, 30, 60]
            asked (Just radius) <$> genDamaged known (Damage 15 wrong)
        )
        smallerQuestions,
    comparing "large-radius" "a radius of the number of cells, or more, is accepted" $
      \known ->
        Some
          ( do
              rows <- genDamaged known (Damage 10 20)
              radius <- elements (fromIntegral (length (concat rows)) : bigNaturals)
              pure (asked (Just radius) rows)
          )
          smallerQuestions,
    comparing "few-cells" "too few cells are answered with all positions that agree" $
      \known ->
        Some (asked Nothing <$> genDamaged known (Damage 75 0)) smallerQuestions
  ]

invalidLaw :: Law ProfileFacts
invalidLaw =
  invalid OnDamage "nearest-refuses-what-is-invalid" Nearest $ \known ->
    [ rawWith (Nearest :? (Nothing, [[Just 1]])) "radius" radius
      | radius <- [Number (-1), Number (scientific 10 (-1)), toJSON True, toJSON ([] :: [Int])]
    ]
      ++ [noSymbols (Nearest :? (radius, [[Just 1]])) known | radius <- [Nothing, Just 1]]
      ++ concat
        [ illFormedPatches (Nearest :? (radius, [[Just 1, Nothing], [Just 0, Just 1]])) known
          | radius <- [Nothing, Just 1]
        ]
