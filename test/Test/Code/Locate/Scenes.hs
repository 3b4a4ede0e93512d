-- | What the decoders are asked: patches of what an array has, damaged.
module Test.Code.Locate.Scenes
  ( genScene,
    genSymbol,
    genLook,
    genQuestion,
    genRadius,
    genWithin,
    genWide,
    genPosition,
    errorPatterns,
  )
where

import qualified Data.Map.Strict as Map
import qualified Data.Vector.Primitive as Primitive
import PraTactile.Array
import PraTactile.Field
import PraTactile.Locate
import PraTactile.Locate.Patch (patchOf)
import PraTactile.Locate.Separation
import PraTactile.Symmetry
import Test.Code.Generators
import Test.Paper (look)
import Test.QuickCheck hiding (elements)
import qualified Test.QuickCheck as QuickCheck

-- | A surface on which a decoder answers, some symmetries, and a radius.
genQuestion ::
  PseudorandomArray k -> Maybe DecoderName -> Gen (Surface, [Symmetry], Radius)
genQuestion array decoder =
  (,,)
    <$> QuickCheck.elements
      (if algebraic then [naturalSurface (arrayFolding array), Sheet] else [minBound ..])
    <*> QuickCheck.elements
      [[identity], [identity], rotations, symmetries, [turned 1], [mirror, turned 3]]
    <*> genRadius decoder
  where
    algebraic = decoder `elem` map Just [AlgebraDecoder, InformationSetDecoder, ListDecoder]

genRadius :: Maybe DecoderName -> Gen Radius
genRadius decoder =
  QuickCheck.elements
    ( if decoder `elem` map Just [TableDecoder, AlgebraDecoder, SearchDecoder]
        then [Guaranteed]
        else [Guaranteed, Guaranteed, UpTo 0, UpTo 1, UpTo 2, UpTo 4]
    )

-- | One to three patches of what is seen of the array somewhere in some symmetry.
genScene ::
  KnownField k =>
  PseudorandomArray k ->
  (GF k -> Gen (Maybe a)) ->
  Gen [((Integer, Integer), Patch a)]
genScene array observe = do
  o <- QuickCheck.elements symmetries
  place <- genPosition (arrayShape array)
  let scene = onRows o (look array (Shape 7 7) place)
  count <- QuickCheck.elements [1, 1, 2, 3 :: Int]
  vectorOf count $ do
    (h, w) <- (,) <$> choose (1, if count == 1 then 4 else 2) <*> choose (1, 4)
    (i, j) <- (,) <$> choose (0, 3) <*> choose (0, 3)
    cells <-
      mapM
        (mapM (maybe (pure Nothing) observe) . take w . drop j)
        (take h (drop i scene))
    either (error . show) (\p -> pure ((toInteger i - 1, toInteger j - 2), p)) (patch cells)

genPosition :: Shape -> Gen Position
genPosition (Shape h w) = Position <$> upTo h <*> upTo w
  where
    upTo side = fromInteger <$> choose (0, toInteger side - 1)

-- | Sometimes not observed, sometimes another one.
genSymbol :: KnownField k => GF k -> Gen (Maybe (GF k))
genSymbol a = do
  fate <- choose (0, 99 :: Int)
  b <- genElement
  pure (if fate < 15 then Nothing else if fate < 25 then Just b else Just a)

-- | Probabilities, which sometimes show how the cell lies if they may.
genLook :: KnownField k => Bool -> GF k -> Gen (Maybe (Belief k))
genLook mayShow a = if mayShow then oneof [genBelief a, genOriented a] else genBelief a

-- | As 'genBelief', and how the cell lies: one symmetry is likelier than others that are possible.
genOriented :: KnownField k => GF k -> Gen (Maybe (Belief k))
genOriented a = do
  alike <- genBelief a
  several <- QuickCheck.elements [rotations, [identity, turned 2], [turned 1, mirror, turned 3]]
  possible <- shuffle several
  let shares = [1 / 2, 1 / 4, 1 / 8, 1 / 8]
      joint b =
        [ (o, map (share *) (Primitive.toList (probabilities b)))
          | (o, share) <- zip possible (if length possible == 2 then [3 / 4, 1 / 4] else whole)
        ]
      whole = if length possible == 3 then [3 / 4, 1 / 4, 0] else shares
  pure (alike >>= either (const Nothing) Just . oriented . joint)

-- | In 64ths, so that products are exact fractions: mostly the symbol itself, sometimes certain,
-- sometimes another one.
genBelief :: KnownField k => GF k -> Gen (Maybe (Belief k))
genBelief a = do
  fate <- choose (0, 99 :: Int)
  b <- genElement
  rest <- QuickCheck.elements [0, 1, 2, 6]
  let likely = if fate < 25 then b else a
      others = fieldOrder likely - 1
      share = if others == 0 then 0 else min rest (63 `div` others) :: Int
      numbers =
        [ fromIntegral (if code == toCode likely then 64 - share * others else share) / 64
          | code <- [0 .. others]
        ]
  pure (if fate < 15 then Nothing else either (const Nothing) Just (belief numbers))

-- | A patch with holes and as many wrong cells as are promised to be corrected: the surface, the
-- symmetries, where and how it is seen, its wrong cells, and the patch.
genWithin ::
  KnownField k =>
  PseudorandomArray k ->
  Gen (Surface, [Symmetry], Candidate, [Position], Patch (GF k))
genWithin array = do
  (possible, least) <- QuickCheck.elements [([identity], 2), ([identity], 2), (rotations, 4)]
  size <- Shape <$> side least high <*> side least wide
  surface <- QuickCheck.elements [naturalSurface (arrayFolding array), Sheet]
  place <-
    genPosition $
      if surface == Sheet then Shape (high - rows size + 1) (wide - columns size + 1) else shape
  o <- QuickCheck.elements possible
  let cells = onRows o (look array size place)
      around = onShape o size
  observed <- sublistOf (cellsOf around)
  count <-
    choose (0, guaranteed (candidateDistance (ArrayOn surface array) possible around observed))
  wrong <- take count <$> shuffle observed
  by <- genElement `suchThat` (/= zero)
  let known =
        [ (at, if at `elem` wrong then a + by else a)
          | (at, Just a) <- zip (cellsOf around) (concat cells),
            at `elem` observed
        ]
  pure (surface, possible, Candidate o place, wrong, patchOf around known)
  where
    shape@(Shape high wide) = arrayShape array
    side least most = fromInteger <$> choose (min least (toInteger most), min 5 (toInteger most))
    guaranteed = fromIntegral . guaranteedRadius

-- | A few cells at random in a patch from a cell to as large as the array, a tenth of them or half
-- wrong or none; it goes on as the torus does.
genWide :: KnownField k => PseudorandomArray k -> Gen (Patch (GF k))
genWide array = do
  high <- upToSide (rows shape)
  wide <- upToSide (columns shape)
  count <- QuickCheck.elements [0, 0, 1, 2, 8, 15]
  offsets <- vectorOf count (genPosition (Shape high wide))
  Position r c <- genPosition shape
  wrong <- QuickCheck.elements [0, 10, 50 :: Int]
  let seen offset@(Position i j) = do
        fate <- choose (0, 99)
        let a = cellAt array (Position (r + i) (c + j))
        pure (offset, if fate < wrong then a + one else a)
  known <- mapM seen (Position (high - 1) (wide - 1) : offsets)
  pure (patchOf (Shape high wide) (Map.toAscList (Map.fromList known)))
  where
    shape = arrayShape array
    upToSide side = QuickCheck.elements [1, 2, 3, 40, side - 1, side]

-- | All ways to have exactly this many wrong symbols: where, and the word. If the first wrong one
-- is 1 more than it should be, a pattern stands for its multiples.
errorPatterns :: KnownField k => Bool -> Int -> [(Position, GF k)] -> [([Position], [GF k])]
errorPatterns _ 0 cells = [([], map snd cells)]
errorPatterns _ _ [] = []
errorPatterns upToFactor k ((at, a) : rest) =
  [(wrong, a : word) | (wrong, word) <- errorPatterns upToFactor k rest]
    ++ [ (at : wrong, b : word)
         | b <- if upToFactor then [a + 1] else elements,
           b /= a,
           (wrong, word) <- errorPatterns False (k - 1) rest
       ]
