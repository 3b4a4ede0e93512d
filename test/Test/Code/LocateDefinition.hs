-- | Every decoder against the definition, on every combination: symbols or probabilities, one patch
-- or several, in any symmetries, on every surface; the decoders for large arrays on small ones.
module Test.Code.LocateDefinition (spec) where

import Control.Monad (forM_)
import Data.List (sort, sortOn, transpose)
import Data.Maybe (fromMaybe)
import Data.Ord (Down (..))
import Data.Proxy (Proxy (..))
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Locate
import PraTactile.Locate.Definition
import PraTactile.Locate.Patch (completeWindows, uprightAs)
import PraTactile.Symmetry
import PraTactile.Window
import Test.Code.Decided (ask)
import Test.Code.Generators
import Test.Hspec
import Test.QuickCheck hiding (elements)
import qualified Test.QuickCheck as QuickCheck

spec :: Spec
spec = forM_ arrays $ \(q, n, folding, shape, window) ->
  describe ("over GF(" ++ show q ++ "), " ++ show folding) $ do
    forM_
      [ Nothing,
        Just TableDecoder,
        Just AlgebraDecoder,
        Just SearchDecoder,
        Just NearestDecoder,
        Just InformationSetDecoder
      ]
      $ \decoder ->
        it ("symbols: " ++ maybe "the decoder that is chosen" decoderText decoder) $
          forM_ (lookup q everyField) $ \(SomeField (k :: Proxy k)) -> do
            array <- firstOver k n >>= right . folded folding shape
            m <- right (rectangle window)
            holds 120 $
              forAll (genScene array genSymbol) $ \given ->
                forAll (genQuestion folding decoder) $ \(surface, possible, radius) ->
                  asDefined decoder (surface, array, m) possible radius given
    forM_ [Nothing, Just PosteriorDecoder, Just ListDecoder] $ \decoder ->
      it ("probabilities: " ++ maybe "the decoder that is chosen" decoderText decoder) $
        forM_ (lookup q everyField) $ \(SomeField (k :: Proxy k)) -> do
          array <- firstOver k n >>= right . folded folding shape
          m <- right (rectangle window)
          holds 80 $
            forAll (genScene array genBelief) $ \given ->
              forAll (genQuestion folding decoder) $ \(surface, possible, _) ->
                forAll (QuickCheck.elements [0, 0.001, 0.1]) $ \tolerated ->
                  asBayes decoder (surface, array, m) possible tolerated given
  where
    arrays =
      [ (4, 4, Diagonal, Shape 15 17, Shape 2 2),
        (2, 6, RowMajor, Shape 9 7, Shape 2 3),
        (3, 3, Diagonal, Shape 2 13, Shape 1 3),
        (9, 2, Diagonal, Shape 5 16, Shape 1 2)
      ]

-- | All that an answer says of symbols holds of the comparison with all candidates.
asDefined ::
  KnownField k =>
  Maybe DecoderName ->
  (Surface, PseudorandomArray k, Mask) ->
  [Symmetry] ->
  Radius ->
  [((Integer, Integer), Patch (GF k))] ->
  Property
asDefined decoder on@(surface, array, window) asked radius given = case ask
  decoder
  on
  asked
  radius
  0
  (map (fmap (fmap Symbol)) given) of
  Left (LocatorDecoding (DecodingTooMany _)) -> property True
  Left e -> counterexample (show e) False
  Right answer -> counterexample (show answer) $ case answerDistances answer of
    Nothing -> property False
    Just distances ->
      conjoin
        [ answerDisputed answer === [at | (at, several) <- looks, not (agreeing' several)],
          property
            ( radius /= Guaranteed
                || correctionRadius distances <= guaranteedRadius (atLeast (codeDistance distances))
            ),
          if null known
            then answerOutcome answer === Refused TooFewCells
            else outcome distances (answerOutcome answer),
          map patchWrong (answerPatches answer)
            === [(`wrongIn` cells) <$> only (answerOutcome answer) | cells <- partsOf given]
        ]
  where
    (shape, looks) = looksByDefinition given
    agreeing' several = and (zipWith (==) several (drop 1 several))
    known = [(at, a) | (at, several@(a : _)) <- looks, agreeing' several]
    joined =
      either
        (const Nothing)
        Just
        ( patch
            [ [lookup (Position i j) known | j <- [0 .. columns shape - 1]]
              | i <- [0 .. rows shape - 1]
            ]
        )
    every = maybe [] (differencesByDefinition surface array possible) joined
    -- The table knows complete windows only, and so the symmetries in which a window is complete.
    possible =
      [ o
        | o <- asked,
          decoder /= Just TableDecoder
            || maybe False (not . null . completeWindows window . uprightAs o) joined
      ]
    counted =
      sortOn
        fst
        [(fromIntegral (length differing) :: Natural, candidate) | (candidate, differing) <- every]
    least = fst <$> take 1 counted
    next = fst <$> take 1 (drop 1 counted)
    best = [candidate | (candidate, differing) <- every, [fromIntegral (length differing)] == least]
    reached distances = any (<= correctionRadius distances) least
    wrongIn candidate cells =
      length [() | at <- fromMaybe [] (lookup candidate every), at `elem` cells]
    only found = case found of
      Unique candidate _ -> Just candidate
      _ -> Nothing
    outcome distances found =
      conjoin
        [ case found of
            Unique candidate _ ->
              conjoin
                [ property (reached distances),
                  best === [candidate],
                  Just (corrected distances) === fmap sort (lookup candidate every)
                ]
            Ambiguous candidates _ ->
              conjoin [property (reached distances && length best > 1), candidates === best]
            AmbiguousMany count _ ->
              property (reached distances && length best > 1 && fromIntegral (length best) <= count)
            Refused NoCompleteWindow ->
              property (decoder == Just TableDecoder && not (reached distances))
            Refused _ -> property (not (reached distances)),
          holdsOf least (nearestDistance distances),
          holdsOf next (runnerUpDistance distances)
        ]
    -- What is told of a number is so, or is as much as is known.
    holdsOf true told = case told of
      Just (Exactly e) -> true === [e]
      Just (AtLeast e) -> property (all (>= e) true)
      Nothing -> property True

-- | The observed cells of each patch in the rectangle around all.
partsOf :: [((Integer, Integer), Patch a)] -> [[Position]]
partsOf given =
  [ [ Position (i + fromInteger (r - top)) (j + fromInteger (c - left))
      | (Position i j, _) <- observedCells p
    ]
    | ((r, c), p) <- given
  ]
  where
    top = minimum [r | ((r, _), _) <- given]
    left = minimum [c | ((_, c), _) <- given]

-- | And of probabilities, of Bayes' theorem.
asBayes ::
  KnownField k =>
  Maybe DecoderName ->
  (Surface, PseudorandomArray k, Mask) ->
  [Symmetry] ->
  Double ->
  [((Integer, Integer), Patch (Belief k))] ->
  Property
asBayes decoder on@(surface, array, _) possible tolerated given = case ask
  decoder
  on
  possible
  Guaranteed
  tolerated
  (map (fmap (fmap Probabilities)) given) of
  Left e -> counterexample (show e) False
  Right answer ->
    counterexample (show answer {answerPosterior = Nothing}) $ case answerPosterior answer of
      -- Where nothing was observed, nothing says that it would have been probabilities.
      Nothing ->
        answerOutcome answer === if null looks then Refused TooFewCells else Refused Contradiction
      Just found ->
        counterexample (show found {posteriorRanking = take 9 (posteriorRanking found)}) $
          conjoin
            [ answerDisputed answer === [at | (at, several) <- looks, disputed several],
              if null known
                then answerOutcome answer === Refused TooFewCells
                else conjoin (told found : outcome (answerOutcome answer))
            ]
  where
    (shape, looks) = looksByDefinition given
    disputed several =
      all ((== 0) . product) (transpose (map (Primitive.toList . probabilities) several))
    known = [(at, b) | (at, several) <- looks, not (disputed several), b <- several]
    exact = posteriorByDefinition surface array possible shape known
    of' candidate = fromRational (fromMaybe 0 (lookup candidate exact)) :: Double
    highest = maximum (0 : map snd exact)
    told found = case posteriorUnlisted found of
      Nothing ->
        conjoin
          [ length (posteriorRanking found) === length exact,
            property (and [near p (of' candidate) | (candidate, p) <- posteriorRanking found]),
            property
              ( maybe
                  (null exact)
                  ( \best ->
                      near (of' best) (fromRational highest)
                        && near (posteriorDoubt found) (1 - of' best)
                  )
                  (posteriorBest found)
              ),
            property
              ( and
                  ( zipWith
                      (\(_, p) (_, p') -> near p (fromRational p'))
                      (posteriorRanking found)
                      (sortOn (Down . snd) exact)
                  )
              )
          ]
      Just unlisted ->
        conjoin
          [ property
              (null exact || unlisted >= 1 - sum (map (of' . fst) (posteriorRanking found)) - 1e-9),
            property (and [p <= of' candidate + 1e-9 | (candidate, p) <- posteriorRanking found]),
            property
              ( maybe
                  True
                  (\best -> posteriorDoubt found >= 1 - of' best - 1e-9)
                  (posteriorBest found)
              ),
            property
              ( null (posteriorEqual found)
                  || posteriorEqualDoubt found >= 1 - sum (map of' (posteriorEqual found)) - 1e-9
              ),
            property
              ( and
                  [ near (of' a) (of' b)
                    | (a, b) <- zip (posteriorEqual found) (drop 1 (posteriorEqual found))
                  ]
              )
          ]
    outcome found =
      [ case found of
          Unique candidate _ ->
            property
              (near (of' candidate) (fromRational highest) && 1 - of' candidate <= tolerated + 1e-9)
          Ambiguous candidates _ ->
            property (length candidates > 1 && 1 - sum (map of' candidates) <= tolerated + 1e-9)
          AmbiguousMany count _ ->
            property (fromIntegral (length (filter ((== highest) . snd) exact)) <= count)
          Refused Contradiction -> property (null exact)
          Refused why ->
            conjoin
              [ why === BelowThreshold,
                property
                  (decoder == Just ListDecoder || 1 - fromRational highest > tolerated - 1e-9)
              ]
      ]
    near a b = abs (a - b) < 1e-9

-- | The surfaces on which a decoder answers, some symmetries, and a radius.
genQuestion :: Folding -> Maybe DecoderName -> Gen (Surface, [Symmetry], Radius)
genQuestion folding decoder =
  (,,)
    <$> QuickCheck.elements (if algebraic then [naturalSurface folding, Sheet] else [minBound ..])
    <*> QuickCheck.elements [[identity], rotations, symmetries, [turned 1], [mirror, turned 3]]
    <*> QuickCheck.elements
      (if exact then [Guaranteed] else [Guaranteed, Guaranteed, UpTo 0, UpTo 1, UpTo 2])
  where
    algebraic = decoder `elem` [Just AlgebraDecoder, Just InformationSetDecoder, Just ListDecoder]
    exact = decoder `elem` [Just TableDecoder, Just AlgebraDecoder, Just SearchDecoder]

-- | One to three patches of what is seen of the array somewhere in some symmetry.
genScene ::
  KnownField k =>
  PseudorandomArray k ->
  (GF k -> Gen (Maybe a)) ->
  Gen [((Integer, Integer), Patch a)]
genScene array observe = do
  o <- QuickCheck.elements symmetries
  Position r c <- Position <$> upTo (rows (arrayShape array)) <*> upTo (columns (arrayShape array))
  let scene = onRows o [[cellAt array (Position (r + i) (c + j)) | j <- [0 .. 6]] | i <- [0 .. 6]]
  count <- QuickCheck.elements [1, 1, 2, 3 :: Int]
  vectorOf count $ do
    (h, w) <- (,) <$> choose (1, if count == 1 then 4 else 2) <*> choose (1, 4)
    (i, j) <- (,) <$> choose (0, 3) <*> choose (0, 3)
    cells <- mapM (mapM observe) [take w (drop j line) | line <- take h (drop i scene)]
    either
      (const (genScene array observe >>= firstOf))
      (\p -> pure ((toInteger i - 1, toInteger j - 2), p))
      (patch cells)
  where
    upTo side = fromInteger <$> choose (0, toInteger side - 1)
    firstOf given = case given of
      one' : _ -> pure one'
      [] -> genScene array observe >>= firstOf

genSymbol :: KnownField k => GF k -> Gen (Maybe (GF k))
genSymbol a = do
  fate <- choose (0, 99 :: Int)
  b <- genElement
  pure (if fate < 15 then Nothing else if fate < 25 then Just b else Just a)

-- | In 64ths, so that products are exact fractions: mostly the symbol itself, sometimes certain,
-- sometimes another one.
genBelief :: KnownField k => GF k -> Gen (Maybe (Belief k))
genBelief a = do
  fate <- choose (0, 99 :: Int)
  b <- genElement
  let likely = if fate < 25 then b else a
      others = length (filter (/= likely) elements')
      elements' = elementsOf a
  rest <- QuickCheck.elements [0, 1, 2, 6]
  let share = if others == 0 then 0 else min rest (63 `div` others) :: Int
      numbers =
        [ fromIntegral (if e == likely then 64 - share * others else share) / 64
          | e <- elements'
        ] ::
          [Double]
  pure (if fate < 15 then Nothing else either (const Nothing) Just (belief numbers))
  where
    elementsOf :: KnownField k => GF k -> [GF k]
    elementsOf _ = elements
