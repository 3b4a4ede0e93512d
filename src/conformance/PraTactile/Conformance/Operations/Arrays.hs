{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The operations of the sequence, the array, its windows and masks.
module PraTactile.Conformance.Operations.Arrays
  ( term,
    terms,
    cell,
    pack,
    unpack,
    prove,
    distance,
    everyContent,
    notOfVast,
  )
where

import Control.Monad (replicateM)
import Data.Aeson ((.=))
import Data.List (intercalate)
import qualified Data.Text as Text
import qualified Data.Vector.Primitive as Vector
import Numeric.Natural (Natural)
import PraTactile.Array
  ( ArrayOn (..),
    Position (..),
    Shape (..),
    area,
    arrayPrimitive,
    cellAt,
    naturalsBelow,
  )
import PraTactile.Conformance.Answer
import PraTactile.Conformance.Definition.Array (ProfileFacts (..), cellOf, termOf)
import qualified PraTactile.Conformance.Definition.Windows as Windows
import PraTactile.Conformance.Forms
import PraTactile.Conformance.Laws.Draw (isVast)
import PraTactile.Conformance.Library.Prepared
import PraTactile.Conformance.Operation
import PraTactile.Conformance.Operations.Conventions
import PraTactile.Conformance.Profiles (apartMask)
import PraTactile.Conformance.Question
import PraTactile.Conformance.Stage
import PraTactile.Conformance.Vectors.Draw
import PraTactile.Conformance.Vectors.Flag
import PraTactile.Conformance.Vectors.Patches
import PraTactile.Field (KnownField, fieldOrder, toCode)
import PraTactile.Format.Json.Codec hiding (integer, natural, refuse)
import qualified PraTactile.Format.Json.Schema as Schema
import PraTactile.Polynomial (primitiveDegree)
import PraTactile.Profile (Profile (..))
import PraTactile.Sequence (initialState, sequenceVector)
import PraTactile.Window (Mask, maskFromRows, maskSize)
import qualified PraTactile.Window as Window
import qualified PraTactile.Window.Distance as Distance
import qualified PraTactile.Window.Proof as Proof

term :: Operation Natural Code
term =
  Operation
    { operationName = "term",
      operationStage = OnSequence,
      operationSays = "s(index)",
      operationInput = alone "index" natural,
      operationOutput = natural,
      operationReasons = [],
      operationLeast = const 1,
      operationWays =
        UnderProfile
          (meaning (\k i -> Right (fromIntegral (termOf k i))) (of' sequenceRule) byJumps (const 1))
            { typical = const largeNumbers,
              smaller = lessNatural,
              asked = \k ->
                ofCode
                  ( if fewCases (period k)
                      then Just ("A period of the sequence.", naturalsBelow (period k))
                      else Nothing
                  )
                  (replicateM 128 (below (period k)))
                  (indexEdges k),
              tabled = \k ->
                if fewCases (period k)
                  then Nothing
                  else Just ("terms of a period", naturalsBelow (period k), id),
              flags = indexFlags
            }
          (\it i -> pure (fromElement (preparedTerm it i)))
    }

-- | The ways to a term.
byJumps :: (String, String)
byJumps = ("jump by powers of x", "the recurrence")

-- | q^n - 1.
period :: ProfileFacts -> Natural
period = area . profileShape . knownProfile

-- | Indices about the end of the period, and large ones.
indexEdges :: ProfileFacts -> [Natural]
indexEdges k =
  [period k - 1, period k, period k + 1, 2 ^ (53 :: Int) - 1, 2 ^ (53 :: Int), 10 ^ (40 :: Int)]

terms :: Operation (Natural, Natural) [Code]
terms =
  Operation
    { operationName = "terms",
      operationStage = OnSequence,
      operationSays = "`length` terms from s(from) on",
      operationInput = object ((,) <$> key "from" natural fst <*> key "length" natural snd),
      operationOutput = listOf natural,
      operationReasons = [tooLong],
      operationLeast = leastOfList . snd,
      operationWays =
        UnderProfile
          (meaning byDefinition (of' sequenceRule) byJumps (const (1, 1)))
            { typical = const [(i, 3) | i <- largeNumbers],
              smaller = pairsLess,
              asked = \k ->
                ofCode
                  Nothing
                  (replicateM 16 ((,) <$> below (period k) <*> below 20))
                  ([(0, 0), (0, 1), (period k - 1, 3)] ++ zip (indexEdges k) [0 .. 8]),
              flags = \p (from, count) -> indexFlags p from ++ [NoTerms | count == 0]
            }
          ( \it (from, count) -> do
              let h = arrayPrimitive (preparedArray it)
                  state = map (preparedTerm it) (take (primitiveDegree h) [from ..])
              start <- orRefuse "invalid" (initialState h state)
              pure (map fromElement (Vector.toList (sequenceVector h start (fromIntegral count))))
          )
    }
  where
    byDefinition k (from, count) =
      Right (map (fromIntegral . termOf k) (takeWhile (< from + count) [from ..]))

cell :: Operation Position Code
cell =
  Operation
    { operationName = "cell",
      operationStage = OnArray,
      operationSays = "a code",
      operationInput = object (Position <$> key "row" natural row <*> key "column" natural column),
      operationOutput = natural,
      operationReasons = [],
      operationLeast = const 1,
      operationWays =
        UnderProfile
          (meaning byDefinition (of' foldingRule) ways (const (Position 1 1)))
            { typical = const [Position i j | i <- largeNumbers, j <- take 2 largeNumbers],
              smaller = \(Position r c) -> [Position r' c' | (r', c') <- pairsLess (r, c)],
              asked = \k ->
                let Shape n1 n2 = profileShape (knownProfile k)
                 in ofCode
                      (if fewCases (n1 * n2) then Just ("All cells.", allCells k) else Nothing)
                      (replicateM 128 (Position <$> below n1 <*> below n2))
                      [ Position r c
                        | r <- [0, n1, 2 ^ (53 :: Int)],
                          c <- [n2 - 1, n2, 3 * n2 + 1, 10 ^ (30 :: Int)]
                      ],
              tabled = \k ->
                if fewCases (period k) then Nothing else Just ("cells, row by row", allCells k, id),
              flags = \p (Position r c) ->
                let Shape n1 n2 = profileShape p
                 in [BeyondEdge | r >= n1 || c >= n2] ++ [LargeNumber | isLarge (max r c)]
            }
          (\it at -> pure (fromElement (cellAt (preparedArray it) at)))
    }
  where
    byDefinition k (Position r c) = Right (fromIntegral (cellOf k r c))
    ways = ("Chinese remainder of row and column", "folding the sequence")
    allCells k =
      let Shape n1 n2 = profileShape (knownProfile k)
       in [Position r c | r <- naturalsBelow n1, c <- naturalsBelow n2]

pack :: Operation [Code] Natural
pack =
  Operation
    { operationName = "pack",
      operationStage = OnWindow,
      operationSays = "the window's number; `cells` are row by row",
      operationInput = alone "cells" (listOf natural),
      operationOutput = natural,
      operationReasons = [],
      operationLeast = const 1,
      operationWays =
        UnderProfile
          (meaning byDefinition (of' packingRule) ways windowOf)
            { typical = \k -> [map (const (orderIn k - 1)) [1 .. windowArea (knownProfile k)]],
              refused = const [[]],
              smaller = oneLess lessNatural,
              asked = \k ->
                let size = fromIntegral (windowArea (knownProfile k))
                    ones n = replicate n 1
                 in ofCode
                      (fmap ((,) "All contents of a window.") (everyContent k))
                      (replicateM 64 (replicateM size (below (orderIn k))))
                      [[], ones (size - 1), ones (size + 1), orderIn k : ones (size - 1)],
              flags = \p cells ->
                [NotACode | any (>= profileOrder p) cells]
                  ++ [OtherLength | fromIntegral (length cells) /= windowArea p]
            }
          ( \it codes -> do
              cells <- traverse (element it) codes
              if length cells == maskSize (preparedWindow it)
                then pure (Window.pack (packing it) (fieldOrder it) (map toCode cells))
                else refuse "invalid"
          )
    }
  where
    byDefinition k codes = do
      cells <- traverse (codeIn k) codes
      if length cells == length (Windows.windowOffsets k)
        then Right (Windows.pack k cells)
        else refuseFor "invalid"
    ways = ("Horner's rule in the library", "Horner's rule in the definition")
    windowOf k =
      concatMap (concatMap (foldMap pure)) (patchAt k 1 1 (profileWindow (knownProfile k)))

-- | The contents that a window may have, where they are few.
everyContent :: ProfileFacts -> Maybe [[Code]]
everyContent k
  | fewCases (orderIn k ^ size) = Just (traverse (const (naturalsBelow (orderIn k))) [1 .. size])
  | otherwise = Nothing
  where
    size = windowArea (knownProfile k)

windowArea :: Profile -> Natural
windowArea = area . profileWindow

packing :: Prepared k -> Window.Packing
packing = profilePacking . preparedProfile

unpack :: Operation Natural [Code]
unpack =
  Operation
    { operationName = "unpack",
      operationStage = OnWindow,
      operationSays = "the window's cells, row by row",
      operationInput = alone "packed" natural,
      operationOutput = listOf natural,
      operationReasons = [("out-of-range", "the number is q^(k1 k2) or more")],
      operationLeast = const 1,
      operationWays =
        UnderProfile
          (meaning byDefinition (of' packingRule) ways (const 1))
            { typical = \k -> map (`mod` contents (knownProfile k)) largeNumbers,
              refused = \k -> [contents (knownProfile k)],
              smaller = lessNatural,
              asked = \k ->
                let most = contents (knownProfile k)
                 in ofCode
                      ( if fewCases most
                          then Just ("All numbers below q^cells.", naturalsBelow most)
                          else Nothing
                      )
                      (replicateM 64 (below most))
                      [most - 1, most, most + 1, 10 ^ (30 :: Int)],
              flags = \p n -> [NotPacked | n >= contents p] ++ [LargeNumber | isLarge n]
            }
          ( \it n ->
              map fromIntegral
                <$> orRefuse
                  "out-of-range"
                  (Window.unpack (packing it) (fieldOrder it) (maskSize (preparedWindow it)) n)
          )
    }
  where
    contents p = profileOrder p ^ windowArea p
    byDefinition k n
      | n >= contents (knownProfile k) = refuseFor "out-of-range"
      | otherwise = Right (map fromIntegral (Windows.unpack k n))
    ways = ("repeated division in the library", "digits in the definition")

prove :: Operation MaskRows Proof
prove =
  Operation
    { operationName = "prove",
      operationStage = OnProof,
      operationSays = "`proved`, `rank`, `windows`",
      operationInput = maskInput,
      operationOutput =
        object
          ( Proof
              <$> key "proved" bool proofHolds
              <*> key "rank" (nullable natural) proofRank
              <*> key "windows" natural proofWindows
          ),
      operationReasons = [("off-sheet", "no window of the mask lies on the sheet"), tooManyWindows],
      operationLeast = const 1,
      operationWays =
        UnderProfile
          (ofMasks (\k mask -> orRefusal "off-sheet" (Windows.prove k mask)) (of' why) ways)
          (\it drawing -> mask' drawing >>= proofOf it)
    }
  where
    why p =
      "the rank is that on the folding's own surface; all windows are compared on the "
        ++ surfaceText p
    ways = ("visit and rank of powers of alpha", "counting contents, elimination of windows")
    proofOf :: KnownField k => Prepared k -> Mask -> Wire Proof
    proofOf it mask = case Proof.prove (ArrayOn (surface it) (preparedArray it)) mask of
      Left Proof.NoWindowOnSheet -> refuse "off-sheet"
      Left _ -> refuse "too-many-windows"
      Right (verdict, _) -> do
        windows <- maybe (refuse "too-many-windows") pure (Proof.distinctWindows verdict)
        pure (Proof (Proof.proved verdict) (Proof.rank verdict) windows)
    surface it = profileSurface (preparedProfile it)

distance :: Operation MaskRows Natural
distance =
  Operation
    { operationName = "distance",
      operationStage = OnProof,
      operationSays = "the least number of cells in which two windows differ; 0 if two are equal",
      operationInput = maskInput,
      operationOutput = natural,
      operationReasons = [tooManyWindows],
      operationLeast = const 1,
      operationWays =
        UnderProfile
          (ofMasks (\k mask -> Right (Windows.distance k mask)) (const why) ways)
          ( \it drawing -> do
              cells <- mask' drawing
              found <-
                orRefuse "too-many-windows" (Distance.minimumDistance (preparedArray it) cells)
              pure (Distance.distance found)
          )
    }
  where
    why = "the least number of cells in which two windows differ on the folding's own surface"
    ways = ("search among information sets", "the lightest of all windows")

tooManyWindows :: (String, String)
tooManyWindows = ("too-many-windows", "more windows than this decoder compares")

mask' :: MaskRows -> Wire Mask
mask' = orRefuse "invalid" . maskFromRows

-- | A mask as one text, its rows with a slash between.
maskInput :: Codec MaskRows
maskInput =
  alone "mask" . withSchema (const schema) $
    via (intercalate "/") (Right . map Text.unpack . Text.splitOn "/" . Text.pack) text
  where
    schema =
      Schema.Described "The rows of a mask, separated by slashes; # marks its cells." $
        Schema.Text ["pattern" .= ("^[#.]+(/[#.]+)*$" :: Text.Text)]

-- | The meaning of an operation on masks.
ofMasks ::
  (ProfileFacts -> [Windows.Offset] -> Either Refusal o) ->
  (ProfileFacts -> String) ->
  (String, String) ->
  Meaning ProfileFacts MaskRows o
ofMasks defined why ways =
  (meaning byDefinition why ways (const ["#"]))
    { typical = const [["#"], ["##"], ["#", "#"], ["#.#", "..#"]],
      refused = \k ->
        let Shape n1 n2 = profileShape (knownProfile k)
         in -- No window of the second one lies on the sheet.
            [] : [replicate (fromIntegral n1 + 1) "#" | n1 < 128, n2 < 128],
      smaller = filter (any (elem '#')) . lessPatch (\mark -> ['.' | mark == '#']),
      asked = \k ->
        notOfVast k (ofCode Nothing (replicateM 24 drawn') (maskEdges (knownProfile k))),
      flags = const maskFlags
    }
  where
    byDefinition k mask = orRefusal "invalid" (Windows.maskOf mask) >>= defined k
    drawn' = do
      high <- (+ 1) <$> below 3
      wide <- (+ 1) <$> below 4
      drawing <- replicateM (fromIntegral high) (replicateM (fromIntegral wide) (chosen '#' "#."))
      -- A cell at least.
      pure (case drawing of (_ : line) : others -> ('#' : line) : others; _ -> drawing)

-- | No inputs where an array has so many positions that comparing or listing all takes long.
notOfVast :: ProfileFacts -> [Group i] -> [Group i]
notOfVast k groups = if isVast (knownProfile k) then [] else groups

-- | The window, single cells, a mask of rank 3 of which all windows on the paper's sheet differ,
-- masks that wrap onto themselves, blank edges, and drawings of no mask.
maskEdges :: Profile -> [MaskRows]
maskEdges profile =
  [ replicate (fromIntegral high) (replicate (fromIntegral wide) '#'),
    replicate (fromIntegral high + 1) (replicate (fromIntegral wide + 1) '#'),
    ["#"],
    [".#"],
    ["#."],
    ["#", "."],
    ["##", ".."],
    ["#.#"],
    apartMask,
    apartMask ++ [replicate 10 '.'],
    replicate (fromIntegral (n1 + 1)) "#",
    [""],
    ["."],
    ["##", "#"],
    ["#x"]
  ]
  where
    Shape high wide = profileWindow profile
    Shape n1 _ = profileShape profile
