-- | The numbers, patches and masks that laws ask about: systematic ones in an order from small to
-- large, and drawn ones.
module PraTactile.Conformance.Laws.Draw
  ( -- * Numbers
    degreeOf,
    periodOf,
    characteristicOf,
    elementsOf,
    upTo,
    bigNatural,
    bigNaturals,

    -- * Patches
    surfaceCell,
    seenAt,
    places,
    shapesAround,
    smallPatches,
    Damage (..),
    damaged,
    genDamaged,
    genPlace,

    -- * Masks
    smallMasks,
    genMask,
  )
where

import Control.Monad (replicateM)
import Data.List (sortOn)
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..), Surface (..), area, naturalsBelow, shapeCells)
import PraTactile.Conformance.Definition (Known, expected, knownProfile)
import PraTactile.Conformance.Question
import PraTactile.Profile (Profile (..))
import Test.QuickCheck

-- | n, the degree of the profile's polynomial.
degreeOf :: Profile -> Natural
degreeOf p = fromIntegral (max 1 (length (profilePolynomial p))) - 1

-- | q^n - 1.
periodOf :: Profile -> Natural
periodOf p = profileOrder p ^ degreeOf p - 1

-- | The prime that q is a power of.
characteristicOf :: Profile -> Natural
characteristicOf p = case [i | i <- [2 .. q], q `mod` i == 0] of
  least : _ -> least
  [] -> q
  where
    q = profileOrder p

-- | All codes.
elementsOf :: Profile -> [Code]
elementsOf = naturalsBelow . profileOrder

-- | 0 to this number.
upTo :: Natural -> Gen Natural
upTo n = fromInteger <$> chooseInteger (0, toInteger n)

-- | Of any size: as many digits as drawn, up to 30.
bigNatural :: Gen Natural
bigNatural = do
  digits <- choose (1, 30 :: Int)
  upTo (10 ^ digits)

-- | Numbers at which machine words and floating point end.
bigNaturals :: [Natural]
bigNaturals =
  [2 ^ (31 :: Int), 2 ^ (32 :: Int), 2 ^ (53 :: Int) - 1, 2 ^ (53 :: Int), 2 ^ (53 :: Int) + 1]
    ++ [2 ^ (63 :: Int), 2 ^ (64 :: Int) - 1, 2 ^ (64 :: Int), 10 ^ (30 :: Int)]

-- | The cell at a place that may lie beyond the edges, where the profile's surface continues; a
-- sheet as the torus.
surfaceCell :: Known -> Position -> Code
surfaceCell known (Position r c) = either (const 0) id (expected known (Cell r' c'))
  where
    Shape n1 n2 = profileShape (knownProfile known)
    (r', c') = case profileSurface (knownProfile known) of
      TwistedTorus -> ((r + c `div` n2) `mod` n1, c `mod` n2)
      _ -> (r `mod` n1, c `mod` n2)

-- | What is seen of this shape at a place.
seenAt :: Known -> Shape -> Position -> [[Code]]
seenAt known (Shape high wide) (Position r c) =
  [ [surfaceCell known (Position (r + i) (c + j)) | j <- naturalsBelow wide]
    | i <- naturalsBelow high
  ]

-- | All places at which a patch of this shape lies on the profile's surface, row by row.
places :: Profile -> Shape -> [Position]
places p (Shape high wide) = case profileSurface p of
  Sheet
    | high > n1 || wide > n2 -> []
    | otherwise -> shapeCells (Shape (n1 - high + 1) (n2 - wide + 1))
  _ -> shapeCells (profileShape p)
  where
    Shape n1 n2 = profileShape p

-- | Shapes from a single cell to two rows and columns more than the window, of at most 24 cells,
-- that fit into the array; small ones first.
shapesAround :: Profile -> [Shape]
shapesAround p =
  sortOn
    area
    [ Shape h' w'
      | h' <- [1 .. min n1 (h + 2)],
        w' <- [1 .. min n2 (w + 2)],
        h' * w' <= 24
    ]
  where
    Shape h w = profileWindow p
    Shape n1 n2 = profileShape p

-- | All patches, with cells not observed too, of all shapes of which there are at most so many;
-- small ones first.
smallPatches :: Natural -> Profile -> [Patch]
smallPatches most p =
  [ rowsOf w cells
    | Shape h w <- sortOn area [Shape h w | h <- [1 .. 4], w <- [1 .. 4]],
      (profileOrder p + 1) ^ (h * w) <= most,
      cells <- replicateM (fromIntegral (h * w)) (Nothing : map Just (elementsOf p))
  ]

rowsOf :: Natural -> [a] -> [[a]]
rowsOf wide cells = case splitAt (fromIntegral wide) cells of
  (line, []) -> [line]
  (line, rest) -> line : rowsOf wide rest

-- | How many per cent of the cells are not observed, and how many per cent of the others wrong.
data Damage = Damage Int Int

-- | What is left of cells that were seen.
damaged :: Profile -> Damage -> [[Code]] -> Gen Patch
damaged p (Damage erased wrong) = traverse (traverse fate)
  where
    q = profileOrder p
    fate code = do
      a <- choose (1, 100)
      b <- choose (1, 100)
      by <- if q > 2 then upTo (q - 2) else pure 0
      pure $
        if a <= erased
          then Nothing
          else Just (if b <= wrong then (code + 1 + by) `mod` q else code)

-- | A patch of a shape around the window, seen somewhere on the profile's surface, and damaged.
genDamaged :: Known -> Damage -> Gen Patch
genDamaged known damage = do
  shape <- elements (shapesAround p)
  place <- genPlace p shape
  damaged p damage (seenAt known shape place)
  where
    p = knownProfile known

-- | One of the places of a shape.
genPlace :: Profile -> Shape -> Gen Position
genPlace p shape = case places p shape of
  [] -> pure (Position 0 0)
  some -> elements some

-- | All masks within 2 x 3 and 3 x 2 cells, and rows and columns of up to five, that have their
-- first and last rows and columns; small ones first, each once.
smallMasks :: [MaskRows]
smallMasks =
  sortOn
    (length . filter (== '#') . concat)
    [ mask
      | Shape h w <- shapes,
        marks <- replicateM (fromIntegral (h * w)) "#.",
        let mask = rowsOf w marks,
        all (elem '#') [take 1 mask >>= id, last' mask, map head' mask, map last'' mask]
    ]
  where
    shapes = [Shape h w | h <- [1 .. 3], w <- [1 .. 3], h * w <= 6] ++ [Shape 1 4, Shape 4 1]
    last' = concat . take 1 . reverse
    head' line = case line of
      mark : _ -> mark
      [] -> '.'
    last'' = head' . reverse

-- | A mask within so many rows and columns, with a cell at least.
genMask :: Natural -> Natural -> Gen MaskRows
genMask high wide = do
  h <- chooseInteger (1, toInteger high)
  w <- chooseInteger (1, toInteger wide)
  mask <- vectorOf (fromInteger h) (vectorOf (fromInteger w) (elements "##."))
  pure (if any (elem '#') mask then mask else ["#"])
