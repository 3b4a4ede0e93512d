{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The laws of locating by the memory table: every complete window of the patch is looked up, and
-- every observed cell must agree.
module PraTactile.Conformance.Laws.Locate
  ( locateLaws,
    zeroPatches,
    unobserved,
    acrossEdges,
    noSymbols,
    illFormedPatches,
  )
where

import Data.Aeson (toJSON)
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..), naturalsBelow)
import PraTactile.Conformance.Definition (ProfileFacts, knownProfile)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Draw
import PraTactile.Conformance.Laws.Forms
import PraTactile.Conformance.Laws.Judge
import PraTactile.Conformance.Laws.Malformed
import PraTactile.Conformance.Laws.Order
import PraTactile.Conformance.Operations (smallerQuestions)
import PraTactile.Conformance.Operations.Conventions (lessNatural)
import PraTactile.Conformance.Question
import PraTactile.Format.Json.Codec (position)
import PraTactile.Profile (Profile (..))
import Test.QuickCheck

-- | The laws of locating by the table.
locateLaws :: [Law ProfileFacts]
locateLaws =
  systematicLaws ++ drawnLaws ++ [inverseOfLooking]
    ++ [orderLaw OnLocate [SomeOp Locate]]
    ++ formLaws OnLocate [SomeOp Locate]
    ++ [invalidLaw]

ofTable :: String -> String -> (ProfileFacts -> Domain SomeQuestion) -> Law ProfileFacts
ofTable what sentence = defined OnLocate what Locate sentence table

table :: String
table = "the memory table of Petriu and others (2004), section II; the protocol, locate"

asked :: Patch -> SomeQuestion
asked = SomeQuestion . (Locate :?)

systematicLaws :: [Law ProfileFacts]
systematicLaws =
  [ ofTable "every-window" "the window at every position is located there" $ \known ->
      let p = knownProfile known
       in Every
            [ asked (map (map Just) (seenAt known (profileWindow p) place))
              | place <- ofVast 40 p (places p (profileWindow p))
            ],
    ofTable "small-patches" "all patches of a few cells, observed or not" $ \known ->
      Every (asked <$> smallPatches 700 (knownProfile known)),
    ofTable "zeros" "zeros of all shapes: zero-window, unless a window of zeros occurs" $ \known ->
      Every (asked <$> ofVast 9 (knownProfile known) (zeroPatches (knownProfile known))),
    ofTable "nothing-observed" "a patch without an observed cell is refused: too-few-cells" $
      \known -> Every (asked <$> unobserved (knownProfile known)),
    ofTable "across-the-edges" acrossSentence $ \known -> Every (asked <$> acrossEdges known)
  ]
  where
    acrossSentence =
      "a patch across the edges is located where the surface continues, and refused as off-sheet \
      \where it ends"

drawnLaws :: [Law ProfileFacts]
drawnLaws =
  [ ofTable
      "larger-patches"
      "a patch larger than a window is located where every cell of it agrees"
      (drawing (Damage 0 0)),
    ofTable "cells-not-felt" "unobserved cells have no influence" (drawing (Damage 25 0)),
    ofTable
      "contradictions"
      "a patch with a wrong cell is refused as contradiction if one of its windows occurs, unless \
      \all its cells agree elsewhere"
      (drawing (Damage 0 12)),
    ofTable "damaged-patches" "patches with unobserved and wrong cells" (drawing (Damage 15 8)),
    ofTable "drawn-patches" "patches of any cells" $ \known ->
      Some (asked <$> anyPatch (knownProfile known)) smallerQuestions
  ]
  where
    drawing damage known = Some (asked <$> genDamaged known damage) smallerQuestions
    anyPatch p = do
      Shape h w <- elements (shapesAround p)
      vectorOf
        (fromIntegral h)
        ( vectorOf
            (fromIntegral w)
            (frequency [(1, pure Nothing), (6, Just <$> upTo (profileOrder p - 1))])
        )

-- | Patches of zeros, complete and with a missing cell.
zeroPatches :: Profile -> [Patch]
zeroPatches p =
  [zeros shape | shape <- shapesAround p]
    ++ [[drop 1 (map Just line) ++ [Nothing] | line <- constant 0 shape] | shape <- shapesAround p]
  where
    zeros = map (map Just) . constant 0

constant :: a -> Shape -> [[a]]
constant value (Shape h w) = replicate (fromIntegral h) (replicate (fromIntegral w) value)

-- | Patches without an observed cell.
unobserved :: Profile -> [Patch]
unobserved p = map (constant Nothing) (shapesAround p)

-- | Windows, and patches one row and column larger, at and beyond the edges, continued on the
-- profile's surface; a sheet is continued like a torus. Then the same with the cells beyond the
-- edges not observed, or with the cells before them not observed. In these only the upper left
-- cell, or its row or column, is beyond the upper and left edges. Also two cells that are further
-- apart than the sheet is long.
acrossEdges :: ProfileFacts -> [Patch]
acrossEdges known =
  ofVast 30 p $
    [ kept (\r c -> r `elem` [0, n1] && c `elem` [0, n2]) shape (Position 0 0)
      | shape <- [Shape (n1 + 1) 1, Shape 1 (n2 + 1)]
    ]
      -- A window in a corner of a patch of very many unobserved cells.
      ++ [ [take 190 (line ++ repeat Nothing) | line <- take 190 (window ++ repeat [])]
           | n1 * n2 <= 100,
             window <- [kept (\_ _ -> True) (profileWindow p) (Position 0 0)]
         ]
      ++ [ map (map Just) (seenAt known shape place)
           | shape <- shapes,
             place <- edges shape
         ]
      ++ [kept (\r c -> r < n1 && c < n2) shape place | shape <- shapes, place <- edges shape]
      ++ [ kept (\r c -> (r >= n1) == beyondRows && (c >= n2) == beyondColumns) shape place
           | shape@(Shape h' w') <- shapes,
             h' > h || w' > w,
             place@(Position r0 c0) <- take 6 (edges shape),
             let beyondRows = r0 + h' > n1,
             let beyondColumns = c0 + w' > n2
         ]
  where
    p = knownProfile known
    Shape n1 n2 = profileShape p
    Shape h w = profileWindow p
    shapes = [Shape h' w' | h' <- [h, h + 1], w' <- [w, w + 1], h' <= n1, w' <= n2]
    edges (Shape h' w') =
      take
        24
        [ Position r c
          | Position r c <- corner ++ sides,
            r + h' > n1 || c + w' > n2
        ]
    corner = [Position (n1 - 1) (n2 - 1), Position 0 (n2 - 1), Position (n1 - 1) 0]
    sides = concat [[Position i (n2 - 1), Position (n1 - 1) i] | i <- [1 .. 9], i < n1, i < n2]
    kept :: (Natural -> Natural -> Bool) -> Shape -> Position -> Patch
    kept felt shape (Position r c) =
      [ [if felt (r + i) (c + j) then Just code else Nothing | (j, code) <- zip [0 ..] line]
        | (i, line) <- zip [0 ..] (seenAt known shape (Position r c))
      ]

inverseOfLooking :: Law ProfileFacts
inverseOfLooking =
  law
    OnLocate
    "inverse-of-looking"
    [SomeOp Cell, SomeOp Locate]
    "a patch of the implementation's own cells is located at their position, or at several that \
    \include it"
    table
    ( \known ->
        Cases
          position
          (Some (genPlace (knownProfile known) (profileWindow (knownProfile known))) nearer)
          $ \place -> trial (looked known place)
    )
  where
    nearer (Position r c) =
      [Position r' c | r' <- lessNatural r] ++ [Position r c' | c' <- lessNatural c]

looked :: ProfileFacts -> Position -> Trial ()
looked known place@(Position r c) = do
  cells <- traverse (traverse (fmap Just . answer known . (Cell :?) . cellAt p)) offsets
  found <- answer known (Locate :? cells)
  demand
    (Because "the window was read there" "each cell of the patch is the implementation's own")
    (Locate :? cells)
    (At place)
    ( case found of
        At place' -> place == place'
        OneOf several -> place `elem` several
        Coset _ _ -> True
    )
  where
    p = knownProfile known
    Shape h w = profileWindow p
    offsets = [[Position (r + i) (c + j) | j <- naturalsBelow w] | i <- naturalsBelow h]

invalidLaw :: Law ProfileFacts
invalidLaw =
  invalid OnLocate "locate-refuses-what-is-invalid" Locate $ \known ->
    noSymbols (Locate :? [[Just 1]]) known :
    illFormedPatches (Locate :? [[Just 1, Nothing], [Just 0, Just 1]]) known

-- | The given question with probabilities in place of its patch's codes, which is refused.
noSymbols :: Question a -> ProfileFacts -> SomeQuestion
noSymbols question known = rawWith question "patch" (toJSON [[replicate q (1 / real :: Double)]])
  where
    q = fromIntegral (profileOrder (knownProfile known))
    real = fromIntegral q

-- | The given question with invalid patches (without cells, with rows of different lengths, with
-- numbers that are not codes), and with malformed inputs.
illFormedPatches :: Question a -> ProfileFacts -> [SomeQuestion]
illFormedPatches question known =
  map (rawWith question "patch") patches ++ malformed question
  where
    q = profileOrder (knownProfile known)
    Shape h w = profileWindow (knownProfile known)
    patches =
      [toJSON ([] :: [Int]), toJSON [[] :: [Int]], toJSON [[], [] :: [Int]]]
        ++ [toJSON [[0, 1], [1 :: Int]], toJSON [[1], [0, 1 :: Int]], toJSON [[0, 1], [] :: [Int]]]
        ++ [ toJSON [[-1 :: Int]],
             toJSON [[Just True]],
             toJSON [[Just (1.5 :: Double)]],
             toJSON
               [[["0" :: String]]]
           ]
        ++ [toJSON (replicate (fromIntegral h) (replicate (fromIntegral w) (toInteger q)))]
        ++ [toJSON [[0, toInteger q + 1]], toJSON [[Nothing, Just (toInteger q)]]]
