{-# LANGUAGE GADTs #-}
{-# LANGUAGE OverloadedStrings #-}

-- | What test vectors ask: of each operation its whole domain where that is small, and otherwise
-- chosen and drawn inputs; and inputs that are refused.
module PraTactile.Conformance.Vectors.Inputs
  ( Group (..),
    Kind (..),
    groupsOf,
    wholeDomain,
  )
where

import Control.Monad (replicateM)
import Data.Aeson (Value (..), toJSON)
import qualified Data.Aeson.KeyMap as KeyMap
import Data.List (sort)
import Data.Scientific (scientific)
import PraTactile.Array (Shape (..), area, naturalsBelow)
import PraTactile.Conformance.Definition
import PraTactile.Conformance.Laws.Draw (isVast)
import PraTactile.Conformance.Profiles (apartMask)
import PraTactile.Conformance.Question
import PraTactile.Conformance.Vectors.Draw
import PraTactile.Conformance.Vectors.Patches
import PraTactile.Conformance.Wire (questionInput)
import PraTactile.Profile (Profile (..))

-- | Questions with where they are from.
data Group = Group
  { groupSource :: String,
    groupKind :: Kind,
    groupQuestions :: [SomeQuestion]
  }

-- | How the questions of a group came about.
data Kind
  = -- | They are the whole domain.
    WholeDomain
  | -- | They were chosen.
    Chosen
  | -- | They were drawn from the seed.
    Drawn
  deriving stock (Eq, Show)

-- | What is asked of an operation under a profile, given the seed. Where an array has very many
-- positions, what compares or lists all of them is asked for nothing but refusals.
groupsOf :: Int -> Known -> Operation -> [Group]
groupsOf seed k operation
  | isVast (knownProfile k) && operation > OfLocate = [refusals]
  | otherwise = filter (not . null . groupQuestions) (answered ++ [refusals])
  where
    refusals = Group "Inputs of the wrong form, or nearly so." Chosen (malformed k operation)
    answered =
      concat
        [ [Group source WholeDomain whole | Just (source, whole) <- [wholeDomain k operation]],
          [Group "Every content of a window." Chosen (everyWindow k) | operation == OfLocate],
          [Group "Drawn from the seed." Drawn (drawn seed (someOf k operation))],
          [Group "Edges of the domain, and beyond." Chosen (edges k operation)]
        ]

-- | All inputs that an operation has in a profile's field or array, if they are few: at most 1024,
-- or of a field of up to 16 elements. Exponents, indices and positions have no end; of the
-- sequence a period is meant, and of the array its own cells.
wholeDomain :: Known -> Operation -> Maybe (String, [SomeQuestion])
wholeDomain k operation = case operation of
  OfAdd | q <= 16 -> Just ("All pairs of elements.", pairs Add)
  OfMultiply | q <= 16 -> Just ("All pairs of elements.", pairs Multiply)
  OfNegate -> elements Negate
  OfInverse -> elements Inverse
  OfLogarithm -> elements Logarithm
  OfTrace -> elements Trace
  OfTerm
    | few cells ->
      Just ("A period of the sequence.", map (SomeQuestion . Term) (naturalsBelow cells))
  OfCell
    | few cells ->
      Just ("All cells.", [SomeQuestion (Cell r c) | r <- naturalsBelow n1, c <- naturalsBelow n2])
  OfPack | few contents -> Just ("All contents of a window.", map (SomeQuestion . Pack) allWindows)
  OfUnpack
    | few contents ->
      Just ("All numbers below q^cells.", map (SomeQuestion . Unpack) (naturalsBelow contents))
  _ -> Nothing
  where
    profile = knownProfile k
    q = profileOrder profile
    Shape n1 n2 = profileShape profile
    cells = n1 * n2
    contents = q ^ area (profileWindow profile)
    few n = n <= 1024
    codes = naturalsBelow q
    pairs operation' = [SomeQuestion (operation' a b) | a <- codes, b <- codes]
    elements :: (Code -> Question a) -> Maybe (String, [SomeQuestion])
    elements operation' = Just ("All elements.", map (SomeQuestion . operation') codes)
    allWindows = traverse (const codes) [1 .. area (profileWindow profile)]

-- | The windows that there can be, if they are few.
everyWindow :: Known -> [SomeQuestion]
everyWindow k =
  [ SomeQuestion (Locate (rowsOf (map Just cells)))
    | Just (_, questions) <- [wholeDomain k OfPack],
      SomeQuestion (Pack cells) <- questions
  ]
  where
    wide = fromIntegral (columns (profileWindow (knownProfile k)))
    rowsOf :: [a] -> [[a]]
    rowsOf cells = case splitAt wide cells of
      (line, []) -> [line]
      (line, others) -> line : rowsOf others

-- | What is drawn, where the whole domain is not listed.
someOf :: Known -> Operation -> Draw [SomeQuestion]
someOf k operation = case (wholeDomain k operation, operation) of
  (Just _, _) -> pure []
  (_, OfAdd) -> replicateM 128 (SomeQuestion <$> (Add <$> code <*> code))
  (_, OfMultiply) -> replicateM 128 (SomeQuestion <$> (Multiply <$> code <*> code))
  (_, OfPower) -> replicateM 64 (SomeQuestion <$> (Power <$> code <*> exponent'))
  (_, OfPrimitive) -> replicateM 64 (SomeQuestion . Primitive <$> polynomial)
  (_, OfTerm) -> replicateM 128 (SomeQuestion . Term <$> below (n1 * n2))
  (_, OfTerms) -> replicateM 16 (SomeQuestion <$> (Terms <$> below (n1 * n2) <*> below 20))
  (_, OfCell) -> replicateM 128 (SomeQuestion <$> (Cell <$> below n1 <*> below n2))
  (_, OfPack) -> replicateM 64 (SomeQuestion . Pack <$> replicateM size code)
  (_, OfUnpack) -> replicateM 64 (SomeQuestion . Unpack <$> below (q ^ size))
  (_, OfLocate) -> replicateM 96 (SomeQuestion . Locate <$> somePatch k)
  (_, OfNearest) ->
    replicateM 96 $ do
      radius <- chosen Nothing [Nothing, Just 0, Just 1, Just 2]
      SomeQuestion . Nearest radius <$> somePatch k
  (_, OfPosterior) -> replicateM 8 (somePatch k >>= fmap (SomeQuestion . Posterior) . someChances k)
  (_, OfProve) -> replicateM 24 (SomeQuestion . Prove <$> mask)
  (_, OfDistance) -> replicateM 24 (SomeQuestion . Distance <$> mask)
  _ -> pure []
  where
    profile = knownProfile k
    q = profileOrder profile
    Shape n1 n2 = profileShape profile
    size = fromIntegral (area (profileWindow profile)) :: Int
    code = below q
    exponent' = (\n m -> toInteger n - toInteger m) <$> below (4 * q) <*> below (2 * q)
    polynomial = do
      n <- below 4
      (++ [1]) <$> replicateM (fromIntegral n + 1) code
    mask = do
      high <- (+ 1) <$> below 3
      wide <- (+ 1) <$> below 4
      lines' <- replicateM (fromIntegral high) (replicateM (fromIntegral wide) (chosen '#' "#."))
      -- A cell at least.
      pure (case lines' of (_ : line) : others -> ('#' : line) : others; _ -> lines')

-- | Inputs chosen for what is special about them.
edges :: Known -> Operation -> [SomeQuestion]
edges k operation = case operation of
  OfAdd -> pairs Add
  OfMultiply -> pairs Multiply
  OfNegate -> outside Negate
  OfInverse -> outside Inverse
  OfPower ->
    [SomeQuestion (Power a i) | a <- take 16 (naturalsBelow q), i <- [-2 .. 3] ++ around]
      ++ [SomeQuestion (Power a i) | a <- [0, q - 1], i <- [huge, -huge]]
      ++ [SomeQuestion (Power q 1)]
  OfLogarithm -> outside Logarithm
  OfTrace -> outside Trace
  OfPrimitive -> map (SomeQuestion . Primitive) (polynomialEdges profile)
  OfFirstPrimitive -> map (SomeQuestion . FirstPrimitive) [0 .. if q > 16 then 2 else 4]
  OfTerm -> [SomeQuestion (Term i) | i <- indices]
  OfTerms ->
    [ SomeQuestion (Terms i n)
      | (i, n) <- [(0, 0), (0, 1), (period - 1, 3)] ++ zip indices [0 .. 8]
    ]
  OfCell ->
    [ SomeQuestion (Cell r c)
      | r <- [0, n1, 2 ^ (53 :: Int)],
        c <- [n2 - 1, n2, 3 * n2 + 1, 10 ^ (30 :: Int)]
    ]
  OfPack ->
    [ SomeQuestion (Pack codes)
      | codes <- [[], ones (size - 1), ones (size + 1), q : ones (size - 1)]
    ]
  OfUnpack ->
    [SomeQuestion (Unpack n) | n <- [contents - 1, contents, contents + 1, 10 ^ (30 :: Int)]]
  OfLocate -> map (SomeQuestion . Locate) (patchEdges k)
  OfNearest ->
    [ SomeQuestion (Nearest radius patch)
      | patch <- patchEdges k,
        radius <- [Nothing, Just 0, Just 1]
    ]
  OfPosterior -> map (SomeQuestion . Posterior) (chanceEdges k)
  OfProve -> map (SomeQuestion . Prove) masks
  OfDistance -> map (SomeQuestion . Distance) masks
  _ -> []
  where
    profile = knownProfile k
    q = profileOrder profile
    Shape n1 n2 = profileShape profile
    period = n1 * n2
    size = fromIntegral (area (profileWindow profile)) :: Int
    contents = q ^ size
    huge = 10 ^ (20 :: Int)
    around = [toInteger q - 1, toInteger q]
    ones n = replicate n 1
    large = 2 ^ (53 :: Int)
    indices = [period - 1, period, period + 1, large - 1, large, 10 ^ (40 :: Int)]
    outside :: (Code -> Question a) -> [SomeQuestion]
    outside operation' = [SomeQuestion (operation' a) | a <- [q, 2 ^ (64 :: Int)]]
    pairs operation' =
      [SomeQuestion (operation' a b) | (a, b) <- [(q, 0), (0, q), (2 ^ (64 :: Int), 1)]]
    masks = maskEdges profile

-- | Polynomials that are primitive, and that are not for each reason.
polynomialEdges :: Profile -> [[Code]]
polynomialEdges profile =
  [h, reverse h, lower, 0 : drop 1 h, lower ++ [q - 1], h ++ [1], [], [0], [1], [0, 1]]
    ++ [[1, 1], [q - 1, 1], [q, 1], map (const 1) h, 1 : map (const 0) (drop 2 h) ++ [1]]
  where
    h = profilePolynomial profile
    lower = take (length h - 1) h
    q = profileOrder profile

-- | The window at corners of the array, larger patches across the edges, patches of zeros, nothing
-- observed, cells that contradict each other, and what is no patch.
patchEdges :: Known -> [Patch]
patchEdges k =
  [patchAt k r c shape | r <- [0, n1 - 1], c <- [0, n2 - 1], shape <- [window, larger]]
    ++ [ map (map (const (Just 0))) (patchAt k 0 0 window),
         map (map (const (Just 0))) (patchAt k 0 0 larger),
         map (map (const Nothing)) (patchAt k 0 0 window),
         changed (patchAt k 0 0 larger),
         changed (patchAt k 1 0 window),
         -- The upper left is beyond the edge, or not observed.
         unseen (patchAt k (n1 - 1) (n2 - 1) larger),
         unseen (patchAt k 1 1 larger),
         [],
         [[]],
         [[Just 0, Nothing], [Just 0]],
         [[Just q]]
       ]
    -- Of larger arrays such lists of places are long.
    ++ [[[Just a]] | area (profileShape profile) <= 1024, a <- [0, q - 1]]
  where
    profile = knownProfile k
    q = profileOrder profile
    Shape n1 n2 = profileShape profile
    window = profileWindow profile
    larger = Shape (rows' + 1) (columns' + 1)
    Shape rows' columns' = window
    -- The last cell is another one.
    changed = map reverse . reverse . onFirst (fmap (\a -> (a + 1) `mod` q)) . reverse . map reverse
    unseen = onFirst (const Nothing)
    onFirst f patch = case patch of
      (cell : line) : others -> (f cell : line) : others
      _ -> patch

-- | Certainty, no knowledge, a contradiction, sums at some distance from 1, and what is no patch.
chanceEdges :: Known -> [Chances]
chanceEdges k =
  [ certain (patchAt k 1 1 (profileWindow profile)),
    certain (patchAt k (n1 - 1) (n2 - 1) (profileWindow profile)),
    certain [[Just 0 | _ <- [0 .. n2]] | _ <- [0 .. n1]],
    [[Probably (0.5 : 0.4 : rest)]],
    [[Probably (0.5 : 0.4995 : rest)]],
    [[Probably (1.5 : -0.5 : rest)]],
    [[Probably (0 : 0 : rest)]],
    [[Probably (1 : rest)]],
    [[Certainly q]],
    [],
    [[]],
    [[Unfelt], [Unfelt, Unfelt]]
  ]
    ++ [[[Unfelt, Unfelt]] | area (profileShape profile) <= 300]
  where
    profile = knownProfile k
    q = profileOrder profile
    Shape n1 n2 = profileShape profile
    rest = replicate (fromIntegral q - 2) 0
    certain = map (map (maybe Unfelt Certainly))

-- | The window, single cells, a mask of rank 3 of which all windows on the paper's sheet differ,
-- masks that wrap onto themselves, blank edges, and what is no mask.
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

-- | Inputs of an operation's form with each key left out, or with a value of another type.
malformed :: Known -> Operation -> [SomeQuestion]
malformed k operation =
  map (SomeQuestion . Raw operation) $
    Null :
    Object KeyMap.empty :
      [ Object (maybe (KeyMap.delete name) (KeyMap.insert name) wrong form)
        | SomeQuestion question <- take 1 (typical k operation),
          Object form <- [questionInput question],
          name <- sort (KeyMap.keys form),
          wrong <- Nothing : map Just wrongs,
          operation /= OfPower || name /= "exponent" || wrong /= Just (Number (-1))
      ]
  where
    wrongs =
      [Bool True, real, Number (-1), String "x", toJSON [real], toJSON [[real]], toJSON [[True]]]
    -- 1.0, not 1.
    real = Number (scientific 10 (-1))

-- | An input of each operation that is none of its edges.
typical :: Known -> Operation -> [SomeQuestion]
typical k operation = case operation of
  OfPower -> [SomeQuestion (Power 1 1)]
  OfPrimitive -> [SomeQuestion (Primitive [1, 1])]
  OfFirstPrimitive -> [SomeQuestion (FirstPrimitive 1)]
  OfTerms -> [SomeQuestion (Terms 1 1)]
  OfNearest -> [SomeQuestion (Nearest Nothing window)]
  OfLocate -> [SomeQuestion (Locate window)]
  OfPosterior -> [SomeQuestion (Posterior (map (map (maybe Unfelt Certainly)) window))]
  OfPack -> [SomeQuestion (Pack (concatMap (concatMap (foldMap pure)) window))]
  OfUnpack -> [SomeQuestion (Unpack 1)]
  OfTerm -> [SomeQuestion (Term 1)]
  OfCell -> [SomeQuestion (Cell 1 1)]
  OfProve -> [SomeQuestion (Prove ["#"])]
  OfDistance -> [SomeQuestion (Distance ["#"])]
  OfAdd -> [SomeQuestion (Add 1 1)]
  OfMultiply -> [SomeQuestion (Multiply 1 1)]
  OfNegate -> [SomeQuestion (Negate 1)]
  OfInverse -> [SomeQuestion (Inverse 1)]
  OfLogarithm -> [SomeQuestion (Logarithm 1)]
  OfTrace -> [SomeQuestion (Trace 1)]
  _ -> []
  where
    window = patchAt k 1 1 (profileWindow (knownProfile k))
