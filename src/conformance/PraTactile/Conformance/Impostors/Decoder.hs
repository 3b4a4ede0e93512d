-- | The decoder written from the documentation, as an implementation under test.
module PraTactile.Conformance.Impostors.Decoder
  ( decoder,
    session,
  )
where

import Data.List (elemIndex)
import qualified Data.Set as Set
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Surface (..), naturalSurface)
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Impostors.Made
import PraTactile.Conformance.Impostors.Searching
import PraTactile.Conformance.Impostors.Ways
import PraTactile.Profile (Profile (..))

-- | An implementation that works by these ways; whether a profile is possible, and which
-- polynomials are primitive, it leaves to the one given.
decoder :: Ways -> Searching -> Implementation -> Implementation
decoder ways how base = base {open = \p -> session ways how p <$> open base p}

-- | The operations by these ways, and the others as in the session given.
session :: Ways -> Searching -> Profile -> Session -> Session
session ways how p s =
  (fields this s)
    { term = pure . natural . termOf this . toInteger,
      terms = \from count ->
        pure [natural (termOf this (toInteger from + i)) | i <- [0 .. toInteger count - 1]],
      cell = \(Position r c) ->
        maybe
          (refuse "out-of-range")
          (pure . natural . cellOf this)
          (goesOn ways p (toInteger r, toInteger c)),
      pack = packBy this,
      unpack = unpackBy this,
      locate = locateBy how this,
      nearest = nearestBy how this,
      posterior = posteriorBy how this,
      prove = \mask -> offsetsOf mask >>= proveBy this,
      distance = fmap (distanceOf this) . offsetsOf
    }
  where
    this = made ways p

natural :: Int -> Natural
natural = fromIntegral

-- | Sums, products, and what is made of them.
fields :: Made -> Session -> Session
fields this s =
  s
    { add = \a b -> natural <$> (madeSum this <$> code a <*> code b),
      multiply = \a b -> natural <$> (by <$> code a <*> code b),
      negation = fmap (natural . minus (madeWays this) p) . code,
      inverse = \a -> code a >>= inverted,
      power = \a i -> do
        x <- code a
        if i < 0
          then inverted x >>= \y -> pure (natural (raised (-i) (fromIntegral y)))
          else pure (natural (raised i x)),
      logarithm = \a ->
        code a >>= \x -> case elemIndex x (powersOf base) of
          Just i -> pure (fromIntegral i)
          Nothing -> refuse "out-of-range",
      trace = fmap (natural . traced) . code
    }
  where
    p = madeProfile this
    q = fromIntegral (profileOrder p) :: Int
    by = madeProduct this
    code a = if a < profileOrder p then pure (fromIntegral a) else refuse "invalid"
    inverted a = case [b | b <- [1 .. q - 1], by a b == 1] of
      b : _ -> pure (natural b)
      [] -> refuse "division-by-zero"
    raised :: Integer -> Int -> Int
    raised i a
      | i == 0 = 1
      | even i = raised (i `div` 2) (by a a)
      | otherwise = by a (raised (i - 1) a)
    powersOf a = take (q - 1) (iterate (by a) 1)
    base = case [a | a <- [1 .. q - 1], Set.size (Set.fromList (powersOf a)) == q - 1] of
      a : _ -> a
      [] -> 1
    traced a =
      foldr
        (madeSum this . (\i -> raised (toInteger (characteristic p) ^ i) a))
        0
        (conjugates q)
    conjugates n =
      [ 0
        .. length
          ( takeWhile
              (> characteristic p)
              (iterate (`div` characteristic p) n)
          )
      ] ::
        [Int]

packBy :: Made -> [Code] -> Wire Natural
packBy this codes
  | length codes /= length (window p) || any (>= q) codes = refuse "invalid"
  | otherwise =
    pure
      ( foldl
          (\n code -> n * q + natural code)
          0
          (packed (madeWays this) p (map fromIntegral codes))
      )
  where
    p = madeProfile this
    q = profileOrder p

unpackBy :: Made -> Natural -> Wire [Code]
unpackBy this n
  | n >= q ^ size = refuse "out-of-range"
  | otherwise = pure (map natural (packed (madeWays this) p (digits size n [])))
  where
    p = madeProfile this
    q = profileOrder p
    size = length (window p)
    digits k m found
      | k == 0 = found
      | otherwise = digits (k - 1) (m `div` q) (fromIntegral (m `mod` q) : found)

-- | The offsets of a mask's cells.
offsetsOf :: MaskRows -> Wire [Cell]
offsetsOf mask
  | null offsets || any ((/= width) . length) mask || any (`notElem` "#.") (concat mask) =
    refuse
      "invalid"
  | otherwise = pure offsets
  where
    width = length (concat (take 1 mask))
    offsets = [(i, j) | (i, line) <- zip [0 ..] mask, (j, '#') <- zip [0 ..] line]

-- | By counting the different contents; those on the folding's own surface are q^rank, or one less
-- where that of zeros is missing.
proveBy :: Made -> [Cell] -> Wire Proof
proveBy this offsets
  | null contents = refuse "off-sheet"
  | otherwise = pure (Proof (different == length contents) rank (fromIntegral different))
  where
    p = madeProfile this
    contents = [content | place <- everywhere this, Just content <- [contentAt this offsets place]]
    different = Set.size (Set.fromList contents)
    own = fromIntegral (Set.size (Set.fromList (ownContents this offsets))) :: Natural
    rank
      | profileSurface p `elem` [Sheet, naturalSurface (profileFolding p)] =
        Just (fromIntegral (length (takeWhile (< own) (iterate (* profileOrder p) 1))))
      | otherwise = Nothing
