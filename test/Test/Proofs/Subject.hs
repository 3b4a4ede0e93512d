{-# LANGUAGE GADTs #-}

-- | The definitions that Coq extracted under the conformance laws, by those operations that they
-- answer.
module Test.Proofs.Subject (spec) where

import Data.Foldable (for_)
import qualified Extracted as Coq
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..), Surface (Sheet), area)
import PraTactile.Conformance
import PraTactile.Profile (Profile (..))
import PraTactile.Window (Packing (..))
import Test.Conformance.Laws (lawsFailingOf)
import Test.Effort
import Test.Hspec
import Test.Proofs.Extraction

spec :: Spec
spec =
  for_ (byEffort quick small) $ \under ->
    it ("all laws of what they answer hold of them: " ++ fst under) $
      lawsFailingOf answered [under] extracted `shouldReturn` []
  where
    answered = ["field/", "sequence/", "array/", "window/", "locate/", "proof/"]
    -- A cell is looked for among all, so that the time grows with the square of the array.
    small = [one | one@(_, p) <- defaultProfiles, area (profileShape p) <= 128]
    quick = [one | one@(name, _) <- small, name `elem` ["gf2-3x5-row-major", "gf9-5x16"]]

-- | The definitions as an implementation. What the protocol asks and they have no word for is
-- written here: codes of q or more are invalid, drawings of no mask too, and numbers are packed in
-- the order of the profile.
extracted :: Implementation
extracted =
  Implementation
    { implementationName = "proofs",
      offered =
        [SomeOp Add, SomeOp Multiply, SomeOp Negate, SomeOp Inverse, SomeOp Term, SomeOp Terms]
          ++ [SomeOp Cell, SomeOp Pack, SomeOp Unpack, SomeOp Locate, SomeOp Prove]
          ++ [SomeOp Distance],
      open = \p -> pure (answering (answersUnder p)),
      withoutProfile = answering (const notOffered)
    }

answersUnder :: Profile -> Question a -> Wire a
answersUnder p = answer
  where
    answer :: Question a -> Wire a
    answer question = case question of
      Add :? (a, b) -> number <$> (Coq.add0 k <$> code a <*> code b)
      Multiply :? (a, b) -> number <$> (Coq.mul0 k <$> code a <*> code b)
      Negate :? a -> number . Coq.neg k <$> code a
      Inverse :? a ->
        code a >>= maybe (refuse "division-by-zero") (pure . number) . Coq.inverseIn q k
      Term :? i -> pure (term i)
      Terms :? (from, count) -> pure (map term (takeWhile (< from + count) [from ..]))
      Cell :? Position r c ->
        maybe (refuse "no-cell") (pure . number) $
          Coq.symbol profile own array (toInteger r, toInteger c)
      Pack :? content -> do
        codes <- traverse code content
        if length codes == cells
          then pure (number (Coq.packed q (ordered codes)))
          else refuse "invalid"
      Unpack :? w
        | toInteger w >= q ^ cells -> refuse "out-of-range"
        | otherwise ->
          pure (map number (ordered (Coq.unpacked q (toInteger cells) (toInteger w))))
      Locate :? patch -> do
        observed <- observedIn patch
        located observed
      Prove :? drawing -> do
        offsets <- mask drawing
        case windowsOn surface offsets of
          [] -> refuse "off-sheet"
          contents ->
            let distinct = Coq.different contents
                rank = Coq.rank q k (toInteger (length offsets)) (windowsOn own offsets)
             in pure
                  ( Proof
                      (distinct == toInteger (length contents))
                      (if known' then Just (number rank) else Nothing)
                      (number distinct)
                  )
      Distance :? drawing -> do
        offsets <- mask drawing
        pure (number (Coq.distanceOf (toInteger (length offsets)) (windowsOn own offsets)))
      _ -> notOffered
    observedIn :: Patch -> Wire [((Integer, Integer), Integer)]
    observedIn patch
      | width == 0 || any ((/= width) . length) patch = refuse "invalid"
      | otherwise =
        sequenceA
          [ (,) (i, j) <$> code a
            | (i, line) <- zip [0 ..] patch,
              (j, Just a) <- zip [0 ..] line
          ]
      where
        width = sum (map length (take 1 patch))
    -- By search: where the cells that were observed hold what was observed. Only the reasons of a
    -- refusal ask about complete windows.
    located :: [((Integer, Integer), Integer)] -> Wire Location
    located observed
      | null observed = refuse "too-few-cells"
      | null complete = refuse "no-complete-window"
      | otherwise = case map position found of
        [at] -> pure (At at)
        _ : _ -> pure (OneOf (map position found))
        []
          | all null standing ->
            refuse (if all (all (== 0) . snd) complete then "zero-window" else "not-in-array")
          | any partly (foldr1' (filter . flip elem) (filter (not . null) standing)) ->
            refuse "off-sheet"
          | otherwise -> refuse "contradiction"
      where
        found =
          Coq.locate
            (map snd observed)
            (Coq.windows profile surface array (map fst observed))
        complete =
          [ ((i, j), content)
            | ((i, j), _) <- observed,
              Just content <- [traverse (\(a, b) -> lookup (i + a, j + b) observed) shape]
          ]
        standing =
          [ [(r - i, c - j) | (r, c) <- Coq.locate content table]
            | ((i, j), content) <- complete
          ]
        -- On the sheet the cells that lie on it agree, and others lie beside it.
        partly (r, c) =
          profileSurface p == Sheet
            && and
              [ maybe True (== a) (Coq.symbol profile surface array (r + i, c + j))
                | ((i, j), a) <- observed,
                  r + i >= 0,
                  c + j >= 0
              ]
    table = Coq.windows profile surface array shape
    shape =
      Coq.rectangle
        (toInteger (rows (profileWindow p)))
        (toInteger (columns (profileWindow p)))
    position (r, c) = Position (fromInteger r) (fromInteger c)
    foldr1' _ [] = []
    foldr1' f (a : others) = foldr f a others
    profile = profileInCoq p {profilePolynomial = dropZeros (profilePolynomial p)}
    k = Coq.field profile
    q = toInteger (profileOrder p)
    own = Coq.ownSurface profile
    surface = Coq.profileSurface profile
    array = Coq.folded profile
    windowsOn on offsets = map snd (Coq.windows profile on array offsets)
    known' = profileSurface p == Sheet || sameSurface own surface
    sameSurface a b = case (a, b) of
      (Coq.Torus, Coq.Torus) -> True
      (Coq.TwistedTorus, Coq.TwistedTorus) -> True
      _ -> False
    -- The sequence has period q^n - 1.
    term :: Natural -> Natural
    term i = number (Coq.term profile (toInteger i `mod` Coq.period profile))
    code :: Code -> Wire Integer
    code a = if a < profileOrder p then pure (toInteger a) else refuse "invalid"
    cells = fromIntegral (area (profileWindow p)) :: Int
    ordered :: [b] -> [b]
    ordered = case profilePacking p of MostSignificantFirst -> id; LeastSignificantFirst -> reverse
    number :: Integer -> Natural
    number = fromInteger
    dropZeros = reverse . dropWhile (== 0) . reverse

-- | The offsets of a drawing's cells, row by row.
mask :: MaskRows -> Wire [(Integer, Integer)]
mask drawing
  | any (any (`notElem` "#.")) drawing || any ((/= width) . length) drawing = refuse "invalid"
  | null offsets || length offsets > 4096 = refuse "invalid"
  | otherwise = pure offsets
  where
    width = sum (map length (take 1 drawing))
    offsets = [(i, j) | (i, line) <- zip [0 ..] drawing, (j, '#') <- zip [0 ..] line]
