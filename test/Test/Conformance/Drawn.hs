{-# LANGUAGE OverloadedStrings #-}

-- | What laws of conformance draw: nothing but what they say, and all of it where that is little.
module Test.Conformance.Drawn (spec) where

import Data.Aeson (FromJSON, Value (..), parseJSON)
import Data.Aeson.Key (Key)
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Aeson.Types (parseMaybe)
import Data.Foldable (for_, toList)
import Data.List (find, nub, sort)
import qualified Data.Map.Strict as Map
import Data.Maybe (isNothing, mapMaybe)
import qualified Data.Set as Set
import qualified Data.Text as Text
import Numeric.Natural (Natural)
import PraTactile.Array (Shape (..), area)
import PraTactile.Conformance
import PraTactile.Conformance.Definition (expected)
import PraTactile.Conformance.Law (Cases (..), Domain (..))
import PraTactile.Conformance.Question (Question (Cell))
import PraTactile.Format.Json.Codec (writeValue)
import PraTactile.Profile
import Test.Hspec
import Test.QuickCheck (vectorOf)
import Test.QuickCheck.Gen (unGen)
import Test.QuickCheck.Random (mkQCGen)
import Text.Read (readMaybe)

spec :: Spec
spec = do
  it "masks: of arrays of more than 1024 cells up to 2 rows and columns" $
    for_ [p | ("gf4-63x65", p) <- defaultProfiles] $ \p ->
      for_ ["proof/prove-drawn-masks", "proof/distance-drawn-masks"] $ \law -> do
        masks <- drawn p law "mask"
        (masks :: [String])
          `are` ( ["#", "##", "#.", ".#", "#/#", "#/.", "./#"]
                    ++ drop 1 [[a, b, '/', c, d] | a <- ".#", b <- ".#", c <- ".#", d <- ".#"]
                )
  ofProfiles

ofProfiles :: Spec
ofProfiles = for_ under $ \(name, p) -> describe name $ do
  let q = profileOrder p
      period = q ^ length (profileState p) - 1
      codes = [0 .. q - 1]
      k = fromIntegral (area (profileWindow p)) :: Int
  it "indices: around the end of a period, from the ends of machine words on, and any" $ do
    single <- drawn p "sequence/term-of-any-index" "index" >>= wholes
    runs <- drawn p "sequence/terms-of-any-index" "from" >>= wholes
    let near = take 41 [period - min period 20 ..]
    for_ [single, runs] $ \indices -> do
      filter (> most + 300) indices `shouldBe` []
      filter (`notElem` indices) near `shouldBe` []
      [end | end <- ends, not (any (from end) indices)] `shouldBe` []
      filter (\i -> i > maximum near && not (any (`from` i) ends)) indices
        `shouldSatisfy` (not . null)
    drawn p "sequence/terms-of-any-index" "length" >>= (`are` [0 .. 40 :: Natural])
    for_ ["row", "column"] $ \side -> do
      cells <- drawn p "array/cell-far-beyond-the-edges" side >>= wholes
      filter (> most + 300) cells `shouldBe` []
      [end | end <- ends, not (any (from end) cells)] `shouldBe` []
      maximum (filter (< 2147483648) cells) `shouldSatisfy` (>= 1000)
    cases p "array/cells-are-terms" >>= (`are` [0 .. period - 1]) . mapMaybe value
  it "exponents: of both signs and all sizes, of every element" $ do
    drawn p "field/power-of-any-exponent" "a" >>= (`are` codes)
    exponents <- drawn p "field/power-of-any-exponent" "exponent" >>= wholes
    for_ [exponents, map negate exponents] $ \those -> do
      filter (> toInteger most) those `shouldBe` []
      maximum those `shouldSatisfy` (> 10 ^ (27 :: Int))
      filter (\i -> i > 0 && i < 10) those `shouldSatisfy` (not . null)
  it "polynomials: monic ones of all degrees of which there are at most 5000" $
    do
      asked <- drawn p "polynomial/primitive-of-drawn-ones" "polynomial"
      alike <- mapMaybe value <$> cases p "polynomial/reciprocals-are-primitive-alike"
      for_ [asked, alike] $ \those -> do
        map (subtract 1 . length) those
          `are` takeWhile (\d -> q ^ d <= 5000) [1 .. 12]
        map (take 1 . reverse) those `are` [[1 :: Natural]]
        concatMap (drop 1 . reverse) those `are` codes
  it "windows: all contents of their cells" $ do
    contents <- mapMaybe value <$> cases p "window/unpack-inverts-pack"
    map length contents `are` [k]
    concat contents `are` codes
  it "masks: of up to 5 rows and columns, or 3, as far as the array has them, and never blank" $ do
    let Shape n1 n2 = profileShape p
    for_
      [ ("proof/prove-drawn-masks", min n1 5, min n2 5),
        ("proof/distance-drawn-masks", min n1 5, min n2 5),
        ("proof/rank-counts-windows", 3, 3),
        ("proof/distance-is-0-where-the-rank-is-less", 3, 3)
      ]
      $ \(law, high, wide) -> do
        masks <- map splitted <$> drawn p law "mask"
        map sides masks
          `are` [(a, b) | a <- [1 .. high], b <- [1 .. wide]]
        filter (notElem '#' . concat) masks `shouldBe` []
        concatMap concat masks `are` "#."
  it "patches: of all shapes around the window, of at most 24 cells" $ do
    for_ [law | (law, _, _) <- patchLaws] $ \law -> do
      patches <- drawn p law "patch" :: IO [[[Value]]]
      map sides patches `are` shapesAround p
  it "patches: with cells not felt, and cells wrong, where a law says so" $
    for_ patchLaws $ \(law, unfelt, wrong) -> do
      patches <- drawn p law "patch" :: IO [[[Value]]]
      (law, any (elem Null . concat) patches) `shouldBe` (law, unfelt)
      (law, any (isNothing . foundIn p (arrayOf p)) (take 500 patches)) `shouldBe` (law, wrong)
  it "radii: 0 to 5; as many as there are cells, and more than any machine word has" $ do
    drawn p "damage/stated-radius" "radius" >>= (`are` [0 .. 5 :: Natural])
    radii <- drawn p "damage/large-radius" "radius" >>= wholes
    sizes <- map (length . concat) <$> (drawn p "damage/large-radius" "patch" :: IO [[[Value]]])
    [r | (r, size) <- zip radii sizes, r /= fromIntegral size] `are` ends
    [() | (r, size) <- zip radii sizes, r == fromIntegral size] `shouldSatisfy` (not . null)
  it "probabilities: in 64ths, of all symbols; one symbol mostly, and another" $ do
    any' <- concatMap concat <$> (drawn p "chances/bayes" "patch" :: IO [[[Value]]])
    nub (filter (not . isList) any') `shouldBe` [Null]
    let shares = Set.fromList (concat (mapMaybe doubles any'))
    shares `shouldSatisfy` (`Set.isSubsetOf` Set.fromList [i / 64 | i <- [0 .. 64]])
    Set.size shares `shouldSatisfy` (> 60)
    map sum (mapMaybe doubles any') `are` [1 :: Double]
    doubted <- concatMap concat <$> (drawn p "chances/likely-patches" "patch" :: IO [[[Value]]])
    nub (filter (not . isList) doubted) `shouldBe` [Null]
    map (sort . filter (> 0)) (mapMaybe doubles doubted)
      `are` ([1] : [[fromInteger i / 64, fromInteger (64 - i) / 64] | i <- [1 .. 31 :: Integer]])
  where
    under = [one | one@(name, _) <- defaultProfiles, name `elem` ["gf2-3x5", "paper"]]
    from end i = i >= end && i <= end + 300
    sides lines' = (fromIntegral (length lines'), fromIntegral (length (concat (take 1 lines'))))
    wholes those = traverse (maybe (fail "no whole number") pure . whole) (those :: [Value])
    doubles = value :: Value -> Maybe [Double]
    isList v = case v of
      Array _ -> True
      _ -> False
    splitted text = case break (== '/') text of
      (row, '/' : more) -> row : splitted more
      (row, _) -> [row]

-- | The laws of drawn patches: whether some cell is not felt, and whether some patch is nowhere.
patchLaws :: [(String, Bool, Bool)]
patchLaws =
  [ ("locate/larger-patches", False, False),
    ("locate/cells-not-felt", True, False),
    ("locate/contradictions", False, True),
    ("locate/damaged-patches", True, True),
    ("locate/drawn-patches", True, True),
    ("damage/guaranteed-radius", True, True),
    ("damage/cells-observed-decide", True, True),
    ("damage/stated-radius", True, True),
    ("damage/large-radius", True, True),
    ("damage/few-cells", True, False),
    ("chances/contradictions", True, True)
  ]

-- | 10^30, which is beyond all machine words.
most :: Natural
most = 10 ^ (30 :: Int)

-- | Where words of 32 and 64 bits and the whole numbers of doubles end; and beyond all of them.
ends :: [Natural]
ends =
  [2147483648, 4294967296]
    ++ [9007199254740991, 9007199254740992, 9007199254740993]
    ++ [9223372036854775808, 18446744073709551615, 18446744073709551616]
    ++ [most]

-- | Where a patch agrees with the array on the profile's surface, a torus in these profiles.
foundIn :: Profile -> Map.Map (Natural, Natural) Natural -> [[Value]] -> Maybe (Natural, Natural)
foundIn p array patch = find agreesAt [(r, c) | r <- [0 .. n1 - 1], c <- [0 .. n2 - 1]]
  where
    Shape n1 n2 = profileShape p
    agreesAt (r, c) =
      and
        [ Map.lookup ((r + i) `mod` n1, (c + j) `mod` n2) array == Just code
          | (i, row) <- zip [0 ..] patch,
            (j, Just code) <- zip [0 ..] (map value row)
        ]

-- | The cells of the array, by definition.
arrayOf :: Profile -> Map.Map (Natural, Natural) Natural
arrayOf p =
  Map.fromList
    [ ((r, c), code)
      | Right about <- [known p],
        r <- [0 .. rows (profileShape p) - 1],
        c <- [0 .. columns (profileShape p) - 1],
        Right code <- [expected about (Cell r c)]
    ]

-- | The shapes from a cell to two rows and columns more than the window has, of at most 24 cells.
shapesAround :: Profile -> [(Natural, Natural)]
shapesAround p =
  [ (a, b)
    | a <- [1 .. min n1 (h + 2)],
      b <- [1 .. min n2 (w + 2)],
      a * b <= 24
  ]
  where
    Shape n1 n2 = profileShape p
    Shape h w = profileWindow p

-- | Exactly these occur.
are :: (HasCallStack, Ord a, Show a) => [a] -> [a] -> Expectation
are found wanted = Set.toList (Set.fromList found) `shouldBe` Set.toList (Set.fromList wanted)

-- | What 2000 draws of a law have under a key of their questions.
drawn :: FromJSON a => Profile -> String -> Key -> IO [a]
drawn p law name = mapMaybe under <$> cases p law
  where
    under one = case one of
      Array parts | [_, Object fields] <- toList parts -> KeyMap.lookup name fields >>= value
      _ -> Nothing

-- | 2000 draws of a law, in the form of its cases.
cases :: Profile -> String -> IO [Value]
cases p law = do
  Right about <- pure (known p)
  [those] <- pure [lawCases one about | one <- laws, lawId one == law]
  case those of
    Cases form (Some gen _) _ ->
      pure (map (writeValue form) (unGen (vectorOf 2000 gen) (mkQCGen 1) 50))
    Cases _ (Every _) _ -> fail (law ++ " draws nothing")

-- | A whole number, of which large ones are texts.
whole :: (Integral a, Read a) => Value -> Maybe a
whole one = case one of
  String digits -> readMaybe (Text.unpack digits)
  _ -> fromInteger <$> value one

value :: FromJSON a => Value -> Maybe a
value = parseMaybe parseJSON
