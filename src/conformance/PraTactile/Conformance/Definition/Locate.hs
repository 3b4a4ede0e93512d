{-# OPTIONS_HADDOCK hide #-}

-- | Locating by definition: every position is compared with the observed cells.
module PraTactile.Conformance.Definition.Locate
  ( locate,
    nearest,
    posterior,
    guaranteedRadius,
    position,
  )
where

import Data.List (foldl')
import Data.Maybe (fromMaybe)
import Data.Ratio (denominator, numerator, (%))
import qualified Data.Set as Set
import qualified Data.Vector as Vector
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Surface (..))
import PraTactile.Conformance.Definition.Array
import PraTactile.Conformance.Definition.Field (fieldOrder)
import PraTactile.Conformance.Definition.Windows
import PraTactile.Conformance.Question
import PraTactile.Profile (Profile (..))

-- | An observed cell with its offset.
type Observed a = (Offset, a)

-- | The observed cells of a patch, converted by the function. Refuses as @invalid@ an empty patch,
-- rows of different lengths, and cells for which the function gives 'Nothing'.
observedIn :: (a -> Maybe b) -> [[Maybe a]] -> Either Refusal [Observed b]
observedIn reader patch
  | width == 0 || any ((/= width) . length) patch = invalid
  | otherwise =
    maybe invalid Right $
      sequence
        [ (,) (i, j) <$> reader a
          | (i, line) <- zip [0 ..] patch,
            (j, Just a) <- zip [0 ..] line
        ]
  where
    width = sum (map length (take 1 patch))
    invalid = Left (Refusal "invalid")

codeIn :: ProfileFacts -> Code -> Maybe Int
codeIn k code
  | code < profileOrder (knownProfile k) = Just (fromIntegral code)
  | otherwise = Nothing

-- | The location of a patch by the table of all windows.
locate :: ProfileFacts -> Patch -> Either Refusal Location
locate k patch = do
  cells <- observedIn (codeIn k) patch
  byWindows k cells

-- | The candidate positions are those that every complete, occurring window of the patch allows.
-- Of these, the positions remain at which all observed cells agree.
byWindows :: ProfileFacts -> [Observed Int] -> Either Refusal Location
byWindows k cells
  | null cells = refused "too-few-cells"
  | null windows = refused "no-complete-window"
  | null occurring =
    refused (if all (all (== 0) . snd) windows then "zero-window" else "not-in-array")
  | otherwise = case filter fits places of
    [] -> refused (if any sticksOut places then "off-sheet" else "contradiction")
    agreeing -> Right (locationOf agreeing)
  where
    surface = profileSurface (knownProfile k)
    windows = completeWindows k cells
    occurring = filter (not . Set.null) (map standing windows)
    -- The positions of the patch's upper left cell at which this window occurs.
    standing ((i, j), content) =
      Set.fromList
        [ canonical k surface (r - i, c - j)
          | (r, c) <- agreeingAt k (zip (windowOffsets k) content)
        ]
    places = Set.toAscList (foldl' Set.intersection (Set.unions occurring) occurring)
    fits place = agrees place && onSheet place && all (onSheet . below place . fst) cells
    sticksOut place = agrees place && not (fits place)
    -- Only cells on the surface are compared.
    agrees place =
      and [at == a || at < 0 | (offset, a) <- cells, let at = cellAt (below place offset)]
    below (r, c) (i, j) = (r + i, c + j)
    onSheet place = cellAt place >= 0
    cellAt = uncurry (onSurface k surface)

-- | The completely observed windows of a patch, with their offsets.
completeWindows :: ProfileFacts -> [Observed Int] -> [(Offset, [Int])]
completeWindows k cells =
  [ ((i, j), content)
    | (i, j) <- map fst cells,
      Just content <- [traverse (\(a, b) -> lookup (i + a, j + b) cells) (windowOffsets k)]
  ]

-- | The positions at which these cells equal the array's and all lie on the surface.
agreeingAt :: ProfileFacts -> [Observed Int] -> [(Int, Int)]
agreeingAt k cells = filter agreeing (positions k)
  where
    at = onSurface k (profileSurface (knownProfile k))
    agreeing (r, c) = all (\((i, j), a) -> at (r + i) (c + j) == a) cells

-- | The number of these cells that differ, at each position. On the sheet only positions at which
-- all cells lie on it count.
differences :: ProfileFacts -> [Observed Int] -> [((Int, Int), Int)]
differences k cells = [(place, e) | place <- positions k, let e = differing place 0 cells, e >= 0]
  where
    at = onSurface k (profileSurface (knownProfile k))
    differing _ e [] = e :: Int
    differing place@(r, c) e (((i, j), a) : others) = case at (r + i) (c + j) of
      b
        | b < 0 -> -1
        | b == a -> differing place e others
        | otherwise -> differing place (e + 1) others

-- | The nearest positions, if they are within the radius (the guaranteed one, unless it is given).
nearest :: ProfileFacts -> Maybe Natural -> Patch -> Either Refusal Location
nearest k stated patch = do
  cells <- observedIn (codeIn k) patch
  if null cells then refused "too-few-cells" else nearestOf k stated cells

nearestOf :: ProfileFacts -> Maybe Natural -> [Observed Int] -> Either Refusal Location
nearestOf k stated cells
  | Just (least, places) <- fewest,
    fromIntegral least <= radius =
    Right (locationOf (reverse places))
  | radius == 0 && not (null (completeWindows k cells)) = byWindows k cells
  | radius == 0 = refused (if weight == 0 then "zero-window" else "contradiction")
  | weight <= radius = refused "zero-window"
  | otherwise = refused "beyond-radius"
  where
    -- The least number of differences with its positions, last one first.
    fewest = foldl' better Nothing (differences k cells)
    better Nothing (place, e) = Just (e, [place])
    better (Just (e, places)) (place, e') = Just $ case compare e' e of
      LT -> (e', [place])
      EQ -> (e, place : places)
      GT -> (e, places)
    weight = fromIntegral (length (filter ((/= 0) . snd) cells))
    radius = fromMaybe (guaranteedRadius promised) stated
    -- The distance of windows is known only on the folding's own surface, and on the sheet cut from
    -- it.
    promised
      | profileSurface (knownProfile k) `elem` [ownSurface k, Sheet] = distance k (map fst cells)
      | otherwise = 0

-- | The largest e with 2 e < d; 0 for 0.
guaranteedRadius :: Natural -> Natural
guaranteedRadius d = if d == 0 then 0 else (d - 1) `div` 2

locationOf :: [(Int, Int)] -> Location
locationOf places = case map position places of
  [only] -> At only
  several -> OneOf several

position :: (Int, Int) -> Position
position (r, c) = Position (fromIntegral r) (fromIntegral c)

-- | The positions with a posterior probability above 0, by Bayes' theorem with a uniform prior:
-- the probability is proportional to the product of the cells' probabilities. It is exact up to the
-- last division. Cells are not normalised, because that would scale every product equally.
posterior :: ProfileFacts -> Chances -> Either Refusal [(Position, Double)]
posterior k patch = do
  cells <- observedIn (fmap Vector.fromList . weights k) (map (map felt) patch)
  let products = [(place, w) | place <- positions k, let w = likelihood place 1 cells, w > 0]
      total = sum (map snd products)
  if null products
    then refused "contradiction"
    else Right [(position place, w `over` total) | (place, w) <- products]
  where
    felt Unfelt = Nothing
    felt chance = Just chance
    at = onSurface k (profileSurface (knownProfile k))
    likelihood _ w [] = w :: Integer
    likelihood place@(r, c) w (((i, j), chances) : others) = case at (r + i) (c + j) of
      b
        | b < 0 || chances Vector.! b == 0 -> 0
        | otherwise -> likelihood place (w * chances Vector.! b) others

-- | The quotient of two integers, rounded once. Doubles hold integers up to 2^53 exactly.
over :: Integer -> Integer -> Double
over a b
  | max a b <= 2 ^ (53 :: Int) = fromInteger a / fromInteger b
  | otherwise = fromRational (a % b)

-- | Integers in the proportion of a cell's probabilities. 'Nothing' unless they are q non-negative
-- numbers that add up to 1 within 0.001, or a valid code.
weights :: ProfileFacts -> Chance -> Maybe [Integer]
weights k chance = case chance of
  Unfelt -> Nothing
  Certainly code -> (\c -> [if a == c then 1 else 0 | a <- codes]) <$> codeIn k code
  Probably numbers
    | length numbers /= length codes || any unreal numbers || any (< 0) exact -> Nothing
    | abs (sum exact - 1) > 1 % 1000 -> Nothing
    | otherwise -> Just (map (numerator . (* common)) exact)
    where
      exact = map toRational numbers
      common = fromInteger (foldl' lcm 1 (map denominator exact))
  where
    codes = [0 .. fieldOrder (knownField k) - 1]
    unreal x = isNaN x || isInfinite x

refused :: String -> Either Refusal a
refused = Left . Refusal
