{-# OPTIONS_HADDOCK hide #-}

-- | The numbers, patches and masks of laws: systematic ones from small to large, and drawn ones.
module PraTactile.Conformance.Laws.Draw
  ( -- * Numbers
    degreeOf,
    periodOf,
    characteristicOf,
    elementsOf,
    upTo,
    anyNatural,
    bigNaturals,
    noCodes,
    isVast,
    ofVast,

    -- * Patches
    surfaceCell,
    cellAt,
    seenAt,
    places,
    shapesAround,
    rowsOf,
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
import PraTactile.Conformance.Definition.Array (ProfileFacts, cellOf, knownProfile)
import PraTactile.Conformance.Question
import PraTactile.Profile (Profile (..))
import Test.QuickCheck

-- | n, the degree of the profile's polynomial.
degreeOf :: Profile -> Natural
degreeOf p = fromIntegral (max 1 (length (profilePolynomial p))) - 1

-- | q^n - 1.
periodOf :: Profile -> Natural
periodOf p = profileOrder p ^ degreeOf p - 1

-- | The prime of which q is a power.
characteristicOf :: Profile -> Natural
characteristicOf p = case [i | i <- [2 .. q], q `mod` i == 0] of
  least : _ -> least
  [] -> q
  where
    q = profileOrder p

-- | All codes of the field.
elementsOf :: Profile -> [Code]
elementsOf = naturalsBelow . profileOrder

-- | A number from 0 to the given one.
upTo :: Natural -> Gen Natural
upTo n = fromInteger <$> chooseInteger (0, toInteger n)

-- | The limits of number types: bytes and machine words, integers that a double holds exactly, two
-- and four words, and a hundred digits.
widths :: [Natural]
widths =
  map (2 ^) [8, 15, 16, 31, 32, 53, 63, 64, 127, 128, 256 :: Int] ++ map (10 ^) [30, 110 :: Int]

-- | Numbers on both sides of every limit. Truncation to the type would change them, often to a
-- small number.
bigNaturals :: [Natural]
bigNaturals = widths >>= \width -> [width - 1, width, width + 1]

-- | Numbers that are not codes: those just above, and those that truncation to a type would make
-- codes.
noCodes :: Profile -> [Natural]
noCodes p = q : q + 1 : filter (> q + 1) bigNaturals
  where
    q = profileOrder p

-- | A number of any size: small, near a limit, or with up to 130 digits.
anyNatural :: Gen Natural
anyNatural =
  oneof
    [ upTo 1000,
      (\width by -> width - min 100 (width `div` 2) + by) <$> elements widths <*> upTo 300,
      choose (1, 130 :: Int) >>= upTo . (10 ^)
    ]

-- | Whether an array has so many cells that only few of them are asked about.
isVast :: Profile -> Bool
isVast p = area (profileShape p) > 8192

-- | All cases, or only a few of them in the same order if the array is vast.
ofVast :: Int -> Profile -> [a] -> [a]
ofVast few p cases
  | isVast p = [a | (i, a) <- zip [0 ..] cases, i `mod` step == 0]
  | otherwise = cases
  where
    step = max 1 (length cases `div` few)

-- | The cell at a position that may lie beyond the edges, continued on the profile's surface; a
-- sheet is continued like a torus.
surfaceCell :: ProfileFacts -> Position -> Code
surfaceCell known at =
  let Position r c = cellAt (knownProfile known) at in fromIntegral (cellOf known r c)

-- | The position within the array of a position that may lie beyond the edges.
cellAt :: Profile -> Position -> Position
cellAt p (Position r c) = case profileSurface p of
  TwistedTorus -> Position ((r + c `div` n2) `mod` n1) (c `mod` n2)
  _ -> Position (r `mod` n1) (c `mod` n2)
  where
    Shape n1 n2 = profileShape p

-- | The cells in a rectangle of the given shape at a position.
seenAt :: ProfileFacts -> Shape -> Position -> [[Code]]
seenAt known (Shape high wide) (Position r c) =
  [ [surfaceCell known (Position (r + i) (c + j)) | j <- naturalsBelow wide]
    | i <- naturalsBelow high
  ]

-- | All positions at which a patch of this shape lies on the profile's surface, row by row.
places :: Profile -> Shape -> [Position]
places p (Shape high wide) = case profileSurface p of
  Sheet
    | high > n1 || wide > n2 -> []
    | otherwise -> shapeCells (Shape (n1 - high + 1) (n2 - wide + 1))
  _ -> shapeCells (profileShape p)
  where
    Shape n1 n2 = profileShape p

-- | The shapes from a single cell to two rows and columns more than the window, with at most 24
-- cells, that fit into the array; small ones first.
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

-- | All patches, also with unobserved cells, of the shapes with at most the given number of
-- patches; small ones first.
smallPatches :: Natural -> Profile -> [Patch]
smallPatches most p =
  ofVast
    2
    p
    [ rowsOf w cells
      | Shape h w <- sortOn area [Shape h w | h <- [1 .. 4], w <- [1 .. 4]],
        (profileOrder p + 1) ^ (h * w) <= most,
        cells <- replicateM (fromIntegral (h * w)) (Nothing : map Just (elementsOf p))
    ]

-- | A list in rows of the given length.
rowsOf :: Natural -> [a] -> [[a]]
rowsOf wide cells = case splitAt (fromIntegral wide) cells of
  (line, []) -> [line]
  (line, rest) -> line : rowsOf wide rest

-- | The percentages of unobserved cells, and of wrong cells among the others.
data Damage = Damage Int Int

-- | Cells after random damage.
damaged :: Profile -> Damage -> [[Code]] -> Gen Patch
damaged p damage = traverse (traverse (suffered p damage))

suffered :: Profile -> Damage -> Code -> Gen (Maybe Code)
suffered p (Damage erased wrong) = fate
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

-- | A damaged patch from somewhere on the profile's surface: mostly of a shape near the window's,
-- sometimes a wide one.
genDamaged :: ProfileFacts -> Damage -> Gen Patch
genDamaged known damage = frequency [(9, around), (1, wide)]
  where
    p = knownProfile known
    around = do
      shape <- elements (shapesAround p)
      place <- genPlace p shape
      damaged p damage (seenAt known shape place)
    wide = genWide known >>= traverse (traverse (maybe (pure Nothing) (suffered p damage)))

-- | A patch of up to 30 rows and 40 columns with a mostly complete window and other cells. It may
-- be larger than the array, but only slightly on the sheet.
genWide :: ProfileFacts -> Gen Patch
genWide known = do
  Shape high wide <- Shape <$> side 30 n1 h <*> side 40 n2 w
  place <- genPlace p (Shape high wide)
  (i, j) <- (,) <$> upTo (high - h) <*> upTo (wide - w)
  others <- choose (0, 60)
  far <- vectorOf others ((,) <$> upTo (high - 1) <*> upTo (wide - 1))
  let felt = far ++ [(i + a, j + b) | a <- naturalsBelow h, b <- naturalsBelow w]
      corner = (high - 1, wide - 1)
  pure
    [ [ if (r, c) `elem` (corner : felt) then Just (at place r c) else Nothing
        | c <- naturalsBelow wide
      ]
      | r <- naturalsBelow high
    ]
  where
    p = knownProfile known
    Shape n1 n2 = profileShape p
    Shape h w = profileWindow p
    side most n k = (+ k) <$> upTo (if profileSurface p == Sheet then n - min n k else most)
    at (Position r c) i j = surfaceCell known (Position (r + i) (c + j))

-- | A position for a shape.
genPlace :: Profile -> Shape -> Gen Position
genPlace p shape = case places p shape of
  [] -> pure (Position 0 0)
  some -> elements some

-- | All masks within 2 x 3 and 3 x 2 cells, and rows and columns of up to five, that use their
-- outermost rows and columns; small ones first, without repetition.
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

-- | A mask within the given numbers of rows and columns, with at least one cell.
genMask :: Natural -> Natural -> Gen MaskRows
genMask high wide = do
  h <- chooseInteger (1, toInteger high)
  w <- chooseInteger (1, toInteger wide)
  mask <- vectorOf (fromInteger h) (vectorOf (fromInteger w) (elements "##."))
  pure (if any (elem '#') mask then mask else ["#"])
