{-# OPTIONS_HADDOCK hide #-}

-- | The numbers, patches and masks that laws ask about: systematic ones in an order from small to
-- large, and drawn ones.
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
import PraTactile.Conformance.Definition.Array (Known, cellOf, knownProfile)
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

-- | Numbers that have no room in some width: of bytes and machine words, of what a double has
-- exactly, of two and four words, and of a hundred digits.
widths :: [Natural]
widths =
  map (2 ^) [8, 15, 16, 31, 32, 53, 63, 64, 127, 128, 256 :: Int] ++ map (10 ^) [30, 110 :: Int]

-- | Numbers on both sides of every width: what is cut to it is another one, and often a small one.
bigNaturals :: [Natural]
bigNaturals = widths >>= \width -> [width - 1, width, width + 1]

-- | Numbers that are no codes: the next ones, and what would be a code if it were cut to a width.
noCodes :: Profile -> [Natural]
noCodes p = q : q + 1 : filter (> q + 1) bigNaturals
  where
    q = profileOrder p

-- | Of any size: small, about a width, or of as many digits as drawn, up to 130.
anyNatural :: Gen Natural
anyNatural =
  oneof
    [ upTo 1000,
      (\width by -> width - min 100 (width `div` 2) + by) <$> elements widths <*> upTo 300,
      choose (1, 130 :: Int) >>= upTo . (10 ^)
    ]

-- | Whether an array has so many cells that it is asked about at few of them.
isVast :: Profile -> Bool
isVast p = area (profileShape p) > 8192

-- | All of these, or a few of them, in the same order, where the array is vast.
ofVast :: Int -> Profile -> [a] -> [a]
ofVast few p cases
  | isVast p = [a | (i, a) <- zip [0 ..] cases, i `mod` step == 0]
  | otherwise = cases
  where
    step = max 1 (length cases `div` few)

-- | The cell at a place that may lie beyond the edges, where the profile's surface continues; a
-- sheet as the torus.
surfaceCell :: Known -> Position -> Code
surfaceCell known at =
  let Position r c = cellAt (knownProfile known) at in fromIntegral (cellOf known r c)

-- | The cell of the array that is there.
cellAt :: Profile -> Position -> Position
cellAt p (Position r c) = case profileSurface p of
  TwistedTorus -> Position ((r + c `div` n2) `mod` n1) (c `mod` n2)
  _ -> Position (r `mod` n1) (c `mod` n2)
  where
    Shape n1 n2 = profileShape p

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
  ofVast
    2
    p
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

-- | A patch seen somewhere on the profile's surface, and damaged: mostly of a shape around the
-- window, and now and then a wide one.
genDamaged :: Known -> Damage -> Gen Patch
genDamaged known damage = frequency [(9, around), (1, wide)]
  where
    p = knownProfile known
    around = do
      shape <- elements (shapesAround p)
      place <- genPlace p shape
      damaged p damage (seenAt known shape place)
    wide = genWide known >>= traverse (traverse (maybe (pure Nothing) (suffered p damage)))

-- | Of up to 30 rows and 40 columns a window somewhere, mostly whole, and other cells anywhere; it
-- may be larger than the array, but on the sheet hardly.
genWide :: Known -> Gen Patch
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
